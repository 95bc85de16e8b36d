"""Tests of the answers of commands that build, before they install or build anything: --help, and wrong options."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from base.tree import ROOT, TOOLS

CONFORM = "conformance/hn-conform"
# The program behind each, in build/, and its arguments.
COMMANDS = {"bake": ("src/bake/hn-bake", "--help"), "conform": (CONFORM, "run --help"),
            "measure clock": (CONFORM, "bench --help"), "measure paper": (CONFORM, "paper --help")}
# By tools/lib/base/scientific-python, which finds no Python here that has their imports.
SCIENTIFIC = {"make bounds": "proof/bounds", "measure hashes": "measure/hashes", "measure noise": "measure/noise",
              "measure uniform": "measure/uniform"}
OF_MAKE = ("base/ending.py", "base/needs.py", "base/modules.py", "base/tree.py", "base/usage.py",
           "check/make/command.py",
           "check/make/graph.py", "check/make/parts.py", "catalog/copies.py")


class Machine(unittest.TestCase):
    """A copy of the commands, with nothing built."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        tools = self.root / "tools"
        tools.mkdir()
        for name in ("test", *{name.split()[0] for name in (*COMMANDS, *SCIENTIFIC)}):
            shutil.copy(TOOLS / name, tools)
        shutil.copytree(TOOLS / "lib" / "measure", tools / "lib" / "measure", ignore=shutil.ignore_patterns("*.py"))
        for name in ("base/setup.sh", "base/progress.sh", "base/scientific-python", *OF_MAKE):
            self.copy(f"tools/lib/{name}")
        # Whoever builds or installs something is noticed.
        self.programs = self.root / "programs"
        for name in ("cmake", "dpkg-query", "apt-get", "sudo"):
            self.write_program(self.programs / name, f"touch {self.root}/{name}.called; exit 1")

    def copy(self, file: str) -> None:
        (self.root / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / file, self.root / file)

    def write_program(self, path: Path, command: str) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{command}\n")
        path.chmod(0o755)

    def call(self, name: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        command, *part = name.split()
        started = [sys.executable, "-B"] if command == "make" else []  # python3 of the PATH is one that knows nothing
        return subprocess.run([*started, self.root / "tools" / command, *part, *arguments], capture_output=True, text=True,
                              check=False, env={**os.environ, "PATH": f"{self.programs}:{os.environ['PATH']}"})

    def called(self) -> list[Path]:
        return list(self.root.glob("*.called"))


class Help(Machine):
    def assert_helped(self, done: subprocess.CompletedProcess[str]) -> None:
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Exit status:", done.stdout)
        self.assertIn("4 it could not be built", done.stdout)
        self.assertEqual(self.called(), [])

    def test_before_the_program_is_built(self):
        for name in COMMANDS:
            for arguments in (("--help",), ("-h",), ("help",), ("--driver", "all", "--help")):
                with self.subTest(name=name, arguments=arguments):
                    done = self.call(name, *arguments)
                    self.assert_helped(done)
                    self.assertIn(f"tools/{name} [options of {COMMANDS[name][0].rpartition('/')[2]}", done.stdout)
                    self.assertIn("does not exist yet", done.stdout)
                    self.assertNotIn("#", done.stdout)
                    self.assertFalse((self.root / "build").exists())

    def test_the_program_tells_its_options(self):
        for program, _ in COMMANDS.values():
            self.write_program(self.root / "build" / program, 'echo "called with: $*"')
        self.write_program(self.programs / "ctest", 'echo "called with: $*"')
        for name, (_, called) in {**COMMANDS, "test": ("ctest", "--help")}.items():
            with self.subTest(name=name):
                done = self.call(name, "--help")
                self.assert_helped(done)
                self.assertIn(f"called with: {called}\n", done.stdout)

    def test_whoever_asks_for_none_is_not_helped(self):
        self.assertEqual(self.call("conform", "--filter", "*help*").returncode, 4)
        self.assertNotEqual(self.called(), [])


class WrongOptions(Machine):
    def setUp(self):
        super().setUp()
        for file in ("conformance/cli/options.cpp",
                     *(f"src/bake/{path.name}" for path in (ROOT / "src/bake").glob("*.cpp")),
                     *(f"tools/lib/{room}/command.py" for room in SCIENTIFIC.values())):
            self.copy(file)
        for name in ("python3", "g++", "ninja", "ctest"):
            self.write_program(self.programs / name, f"touch {self.root}/{name}.called; exit 1")

    def lose_pythons(self) -> None:
        """Debian's own Python is not on the PATH."""
        file = self.root / "tools" / "lib" / "base" / "scientific-python"
        file.write_text(file.read_text().replace("/usr/bin/python3", "no-other-python"))

    def assert_refused(self, done: subprocess.CompletedProcess[str], said: str) -> None:
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn(said, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertFalse((self.root / "build").exists())

    def test_nothing_is_installed_or_built_for_them(self):
        for name, arguments, said in (
                ("bake", ("fbm", "--octvaes", "3"), "no option --octvaes (did you mean --octaves?)"),
                ("measure clock", ("--baselien=x",), "no option --baselien (did you mean --baseline?)"),
                ("conform", ("--drivre", "all"), "no option --drivre (did you mean --driver?)"),
                ("conform", ("--no-such-thing",), "no option --no-such-thing; see tools/conform --help"),
                ("conform", ("--Driver", "all"), "no option --Driver (did you mean --driver?)"),
                ("measure paper", ("--out", "x", "--round=3"), "no option --round (did you mean --rounds?)")):
            with self.subTest(name=name, arguments=arguments):
                self.assert_refused(self.call(name, *arguments), f"tools/{name}: there is {said}")
                self.assertEqual(self.called(), [])

    def test_of_tests(self):
        """ctest takes any option, so that tools/test --thorogh would run the tests that are not thorough."""
        self.write_program(self.programs / "ctest", "echo '  -Q,--quiet  = Make ctest quiet.'")
        self.assert_refused(self.call("test", "--thorogh"), "no option --thorogh (did you mean --thorough?)")
        self.assert_refused(self.call("test", "--quite"), "no option --quite (did you mean --quiet?)")
        self.assertEqual(self.called(), [])
        self.assertEqual(self.call("test", "--thorough", "--quiet").returncode, 4)
        self.assertNotEqual(self.called(), [])
        self.write_program(self.programs / "ctest", "exit 1")  # it is not installed: nobody can know its options
        self.assertEqual(self.call("test", "--no-such-thing").returncode, 4)

    def test_of_what_needs_scientific_python(self):
        self.lose_pythons()
        for name in SCIENTIFIC:
            with self.subTest(name=name):
                self.assert_refused(self.call(name, "--noize"), f"tools/{name}: there is no option --noize")
        self.assertEqual([path.name for path in self.called()], ["python3.called"])  # for its version and modules

    def test_of_what_needs_scientific_python_beginnings_will_do(self):
        self.lose_pythons()
        done = self.call("measure hashes", "--dim", "2", "--jobs=5")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("dpkg-query.called", [path.name for path in self.called()])

    def test_options_of_built_programs_are_taken(self):
        """Options in --help of a program are among those in its sources, wherever they are."""
        tried = 0
        for name, (program, shown) in COMMANDS.items():
            path = ROOT / "build" / program
            if not path.exists():
                continue
            shown = subprocess.run([path, *shown.split()], capture_output=True, text=True, check=True).stdout
            options = {*re.findall(r"^ +(?:-\w,)?(--[a-z-]+)", shown, re.MULTILINE)} - {"--help"}
            with self.subTest(name=name):
                self.assertGreater(len(options), 3)
                done = self.call(name, *options)
                self.assertEqual(done.returncode, 4, done.stderr)
                self.assertNotEqual(self.called(), [])
            tried += 1
        if not tried:
            self.skipTest("no program is built")

    def test_what_is_no_option(self):
        for arguments in (("--filter", "*--x"), ("-x",), ("--", "--no-such-thing"), ("--out=--no-such-thing",)):
            with self.subTest(arguments=arguments):
                self.assertEqual(self.call("conform", *arguments).returncode, 4)

    def test_where_the_sources_are_not(self):
        (self.root / "conformance" / "cli" / "options.cpp").unlink()
        self.assertEqual(self.call("measure paper", "--agianst", "x").returncode, 4)


if __name__ == "__main__":
    unittest.main()
