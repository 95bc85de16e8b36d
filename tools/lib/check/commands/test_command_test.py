"""Tests of tools/test: which tests it runs, and how it reports them.

The tests that ctest runs here are scripts in a build folder that CMake has configured; scripts stand in for cmake, so
that nothing is built.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.tree import TOOLS
from base.versions import folders

TESTS = """add_test(quick "sh" "-c" "echo quick >> {ran}")
add_test([=[name+with.signs/0  # GetParam() = 4-byte <02-00 00-00>]=] "sh" "-c" "echo signs >> {ran}")
add_test(sometimes "sh" "-c" "echo sometimes >> {ran}; test -e {root}/well")
add_test(skipped "sh" "-c" "echo some output; echo 'skipped: there is no such program'; exit 77")
set_tests_properties(skipped PROPERTIES SKIP_RETURN_CODE 77)
if(CTEST_CONFIGURATION_TYPE MATCHES "^([Tt][Hh][Oo][Rr][Oo][Uu][Gg][Hh])$")
  add_test(long "sh" "-c" "echo long >> {ran}")
endif()
"""


class Test(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        tools = self.root / "tools"
        (tools / "lib" / "base").mkdir(parents=True)
        for name in ("test", "lib/base/setup.sh", "lib/base/progress.sh", "lib/base/node", "lib/base/skipped.py"):
            shutil.copy(TOOLS / name, tools / name)
        self.ran = self.root / "build" / "ran"
        self.ran.parent.mkdir()
        (self.root / "build" / "CTestTestfile.cmake").write_text(TESTS.format(ran=self.ran, root=self.root))
        (self.root / "well").touch()
        self.programs = self.root / "build" / "programs"
        self.programs.mkdir()
        for name, text in (("cmake", "exit 0"), ("ninja", "echo 'ninja: no work to do.'"), ("npm", "exit 0"), ("node", 'echo "$PATH"'),
                           ("dpkg-query", 'shift 3; for package; do echo "$package installed"; done')):
            self.program(self.programs / name, text)
        self.environment = {**os.environ, "HOME": "/nowhere", "PATH": f"{self.programs}:{os.environ['PATH']}"}

    def program(self, path: Path, text: str) -> None:
        path.parent.mkdir(exist_ok=True)
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)

    def call(self, *arguments: str) -> tuple[int, str, list[str]]:
        """The status, the output, and which tests ran."""
        self.ran.write_text("")
        done = subprocess.run([self.root / "tools" / "test", *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False, env=self.environment)
        return done.returncode, done.stdout, sorted(self.ran.read_text().split())

    def test_a_default_run_says_how_many_tests_it_leaves_out(self) -> None:
        status, text, ran = self.call()
        self.assertEqual((status, ran), (0, ["quick", "signs", "sometimes"]), text)
        self.assertRegex(text, r"100% tests passed, 0 tests failed out of 4\n")
        self.assertTrue(text.endswith("\n1 more tests run with --thorough only.\n"), text)

    def test_what_takes_long_by_the_table_begins_first(self) -> None:
        (self.root / "tools" / "costs.csv").write_text("kind,name,value,before\ntest,sometimes,3,\n")
        _, text, _ = self.call()
        self.assertRegex(text.split("Start", 2)[1], r"^ +3: sometimes\n")

    def test_a_whole_run_is_measured(self) -> None:
        measured = self.root / "build" / "measured.csv"
        self.call("-R", "quick")
        self.assertFalse(measured.exists())
        self.call()
        self.assertRegex(measured.read_text(), r"^run,test,\d+,0\.\d+\n$")

    def test_what_was_skipped_is_listed_with_its_reason(self) -> None:
        _, text, _ = self.call()
        self.assertIn("\nSkipped, in whole or in part:\n  skipped: there is no such program\n1 more tests run", text)
        _, text, _ = self.call("-R", "quick")
        self.assertNotIn("Skipped", text)

    def test_what_cannot_be_listed_leaves_the_status_alone(self) -> None:
        (self.root / "tools" / "lib" / "base" / "skipped.py").write_text("raise SystemExit(1)\n")
        status, text, _ = self.call("-R", "quick")
        self.assertEqual(status, 0, text)
        self.assertIn("tools/test: the skipped tests could not be read from", text)

    def test_cases_that_a_test_skips_are_listed_too(self) -> None:
        """As unittest and GoogleTest print them; not those that take long, or that another test runs."""
        (self.root / "build" / "parts.py").write_text("""import unittest
class Parts(unittest.TestCase):
    def test_one(self):
        "It has a sentence."
        self.skipTest("there is no one")
    @unittest.skip("takes long: tools/test --thorough")
    def test_two(self): pass
    @unittest.skip("the test parts.whole has it")
    def test_three(self): pass
unittest.main()
""")
        (self.root / "build" / "CTestTestfile.cmake").write_text(f"""
add_test(parts "python3" "{self.root}/build/parts.py" "-v")
add_test(silent "python3" "{self.root}/build/parts.py")
add_test(google "printf" "/a/b.cpp:20: Skipped\\nno device is here\\n[  SKIPPED ] Some.Thing (0 ms)\\n")
""")
        status, text, _ = self.call()
        self.assertEqual(status, 0, text)
        self.assertIn("  parts: there is no one\n", text)
        self.assertIn("  silent: its cases print no reason: unittest wants -v\n", text)
        self.assertIn("  google: no device is here\n", text)
        self.assertIn("1 cases of other tests take long: tools/test --thorough runs them.\n", text)

    def test_programs_of_debian_come_before_the_owners(self) -> None:
        own = self.root / "home" / "bin"
        own.mkdir(parents=True)
        self.program(own / "tool", "echo version 2.10.0")
        self.program(self.programs / "tool", "echo version 2.9.1")
        (self.root / "build" / "CTestTestfile.cmake").write_text(f'add_test(tool "sh" "-c" "tool >>{self.ran}")\n')
        self.environment |= {"HOME": str(own.parent), "PATH": f"{own}:{self.environment['PATH']}"}
        first = "2.9.1" if Path("/etc/debian_version").exists() else "2.10.0"
        self.assertEqual(self.call()[2], sorted(["version", first]))
        with mock.patch.dict(os.environ, self.environment):
            self.assertEqual(folders("tool"), [str(self.programs), str(own)])

    def test_options_of_ctest_choose_tests(self) -> None:
        status, text, ran = self.call("-R", "quick|long")
        self.assertEqual((status, ran), (0, ["quick"]), text)
        self.assertTrue(text.endswith("\n1 more tests run with --thorough only.\n"), text)
        self.assertEqual(self.call("--thorough", "-R", "quick|long")[2], ["long", "quick"])

    def test_a_failure_is_one(self) -> None:
        (self.root / "well").unlink()
        status, text, _ = self.call()
        self.assertEqual(status, 8)
        self.assertRegex(text, r"sometimes \(Failed\)")

    def test_a_thorough_run_is_resumed(self) -> None:
        (self.root / "well").unlink()
        status, text, ran = self.call("--thorough")
        self.assertEqual((status, ran), (8, ["long", "quick", "signs", "sometimes"]), text)
        # The tree has not changed; failed and skipped tests are run again. The failed test passes by something
        # outside of the tree: build/ is not a part of it, and neither is the file that it reads now.
        tests = self.root / "build" / "CTestTestfile.cmake"
        tests.write_text(tests.read_text().replace(f"test -e {self.root}/well", "true"))
        status, text, ran = self.call("--thorough", "--resume")
        self.assertEqual((status, ran), (0, ["sometimes"]), text)
        self.assertTrue(text.endswith("\n3 tests had passed on this tree before, and were left out.\n"), text)
        self.assertEqual(self.call("--thorough", "--resume")[2], [])
        # Another run that is not resumed begins anew.
        self.assertEqual(len(self.call("--thorough")[2]), 4)

    def test_a_run_that_was_cut_off_is_resumed(self) -> None:
        """Tests run in the order of their numbers here; the third ends the run, as a signal would."""
        tests = self.root / "build" / "CTestTestfile.cmake"
        text = tests.read_text()
        tests.write_text(text.replace(f"test -e {self.root}/well", "kill -9 $(ps -o ppid= $PPID) $PPID"))
        status, _, ran = self.call("--thorough", "-j", "1")
        self.assertNotEqual(status, 0)
        self.assertNotIn("long", ran)
        tests.write_text(text)
        status, said, ran = self.call("--thorough", "--resume")
        self.assertEqual((status, ran), (0, ["long", "sometimes"]), said)

    def test_a_tree_that_has_changed_is_tested_anew(self) -> None:
        self.assertEqual(self.call("--thorough")[0], 0)
        (self.root / "source.cpp").write_text("int main() {}\n")
        status, text, ran = self.call("--thorough", "--resume")
        self.assertEqual((status, len(ran)), (0, 4), text)
        self.assertIn("There is no thorough run of this tree to go on with.", text)

    def test_a_run_that_is_not_thorough_has_nothing_to_resume(self) -> None:
        status, text, ran = self.call("--resume")
        self.assertEqual((status, ran), (2, []))
        self.assertIn("--resume goes with --thorough", text)

    def test_what_is_running_is_said_when_nothing_else_is(self) -> None:
        tests = self.root / "build" / "CTestTestfile.cmake"
        tests.write_text('add_test(slow "sleep" "3")\n')
        self.environment["HN_PROGRESS_SECONDS"] = "0.5"
        status, text, _ = self.call()
        self.assertEqual(status, 0, text)
        self.assertRegex(text, r"(?m)^ +\(\d+:\d\d: slow\)$")


if __name__ == "__main__":
    unittest.main()
