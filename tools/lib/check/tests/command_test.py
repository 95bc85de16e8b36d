"""ctest runs scripts here, in a build folder that nothing built."""

from __future__ import annotations

from unittest import mock

from base.testing import Case, called
from check.tests import command

TESTS = """add_test(quick "sh" "-c" "echo quick >> {ran}")
add_test([=[name+with.signs/0  # GetParam() = 4-byte <02-00 00-00>]=] "sh" "-c" "echo signs >> {ran}")
add_test(sometimes "sh" "-c" "echo sometimes >> {ran}; test -e {well}")
add_test(skipped "sh" "-c" "echo some output; echo 'skipped: there is no such program'; exit 77")
set_tests_properties(skipped PROPERTIES SKIP_RETURN_CODE 77)
if(CTEST_CONFIGURATION_TYPE MATCHES "^([Tt][Hh][Oo][Rr][Oo][Uu][Gg][Hh])$")
  add_test(long "sh" "-c" "echo long >> {ran}")
endif()
"""


class Tests(Case):
    def setUp(self) -> None:
        self.ran, self.well = self.folder / "ran", self.folder / "well"
        self.well.touch()
        self.write(TESTS)
        self.tree = self.enterContext(mock.patch.object(command, "digest_of_tree", return_value="a tree"))

    def write(self, tests: str) -> None:
        (self.folder / "CTestTestfile.cmake").write_text(tests.format(ran=self.ran, well=self.well, build=self.folder))

    def call(self, *arguments: str) -> tuple[int, str, list[str]]:
        """The status, what is printed, and which tests ran."""
        self.ran.write_text("")
        status, text = called(command.main, self.folder, *arguments)
        return status, text, sorted(self.ran.read_text().split())

    def test_what_is_skipped_and_left_out_is_named(self) -> None:
        status, text, ran = self.call()
        self.assertEqual((status, ran), (0, ["quick", "signs", "sometimes"]), text)
        self.assertRegex(text, r"100% tests passed, 0 tests failed out of 4\n")
        self.assertTrue(text.endswith("\nSkipped, in whole or in part:\n  skipped: there is no such program\n"
                                      "1 more tests run with --thorough only.\n"), text)

    def test_cases_that_a_test_skips_are_named_too(self) -> None:
        """As unittest and GoogleTest print them; not those that take long, or that another test runs."""
        (self.folder / "parts.py").write_text("""import unittest
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
        self.write("""
add_test(parts "python3" "{build}/parts.py" "-v")
add_test(silent "python3" "{build}/parts.py")
add_test(google "printf" "/a/b.cpp:20: Skipped\\nno device is here\\n[  SKIPPED ] Some.Thing (0 ms)\\n")
""")
        status, text, _ = self.call()
        self.assertEqual(status, 0, text)
        for line in ("  parts: there is no one\n", "  silent: its cases print no reason: unittest wants -v\n",
                     "  google: no device is here\n",
                     "1 cases of other tests take long: tools/test --thorough runs them.\n"):
            self.assertIn(line, text)

    def test_options_of_ctest_choose_tests(self) -> None:
        self.assertEqual(self.call("-R", "quick|long")[2], ["quick"])
        self.assertEqual(self.call("--thorough", "-R", "quick|long")[2], ["long", "quick"])
        self.assertNotEqual(self.call("-R", "no such test")[0], 0)

    def test_a_failure_is_one(self) -> None:
        self.well.unlink()
        status, text, _ = self.call()
        self.assertEqual(status, 8)
        self.assertRegex(text, r"sometimes \(Failed\)")

    def test_a_thorough_run_is_resumed(self) -> None:
        self.well.unlink()
        status, text, ran = self.call("--thorough")
        self.assertEqual((status, ran), (8, ["long", "quick", "signs", "sometimes"]), text)
        self.well.touch()  # what failed and what was skipped is run again
        status, text, ran = self.call("--thorough", "--resume")
        self.assertEqual((status, ran), (0, ["sometimes"]), text)
        self.assertTrue(text.endswith("\n3 tests had passed on this tree before, and were left out.\n"), text)
        self.assertEqual(self.call("--thorough", "--resume")[2], [])
        self.well.unlink()
        self.assertEqual(self.call("--thorough", "-R", "quick|sometimes")[2], ["quick", "sometimes"])
        self.assertEqual(self.call("--thorough", "--resume", "-R", "quick|sometimes")[::2], (8, ["sometimes"]))
        self.well.touch()
        self.tree.return_value = "another tree"
        status, text, ran = self.call("--thorough", "--resume")
        self.assertEqual((status, len(ran)), (0, 4), text)
        self.assertIn("There is no thorough run of this tree to go on with.", text)
        self.assertEqual(len(self.call("--thorough")[2]), 4)  # without --resume a run begins anew

    def test_a_run_that_was_cut_off_is_resumed(self) -> None:
        """Tests run in the order of their numbers here; the third ends ctest, as a signal would."""
        self.write(TESTS.replace("test -e {well}", "kill -9 $PPID"))
        status, _, ran = self.call("--thorough", "-j", "1")
        self.assertNotEqual(status, 0)
        self.assertNotIn("long", ran)
        self.write(TESTS)
        status, text, ran = self.call("--thorough", "--resume")
        self.assertEqual((status, ran), (0, ["long", "sometimes"]), text)

    def test_a_line_shows_what_runs_and_since_when(self) -> None:
        self.write('add_test(slow "sleep" "1")\n')
        with mock.patch.object(command, "SILENCE", 0.3):
            status, text, _ = self.call()
        self.assertEqual(status, 0, text)
        self.assertRegex(text, r"(?m)^ +\(0:00: slow\)$")


class Digest(Case):
    def test_a_change_of_the_tree_is_another_digest(self) -> None:
        path = self.folder / "source.cpp"
        with mock.patch.multiple(command, ROOT=self.folder, files=lambda: ["source.cpp"]):
            path.write_text("one")
            before = command.digest_of_tree()
            self.assertEqual(command.digest_of_tree(), before)
            path.write_text("two")
            self.assertNotEqual(command.digest_of_tree(), before)
