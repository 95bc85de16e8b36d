"""Which Python the commands need: one that is too old gets one line."""

from __future__ import annotations

import ast
import functools
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from base.pieces import was_deleted
from base.tree import TOOLS

# They begin as Python, or the shell starts them by any Python.
STARTED = [*(path for path in sorted(TOOLS.iterdir())
             if path.is_file() and path.read_text(encoding="utf-8").startswith("#!/usr/bin/env python3")),
           *(path for path in (TOOLS / "lib/measure/command.py",) if not was_deleted("tools/lib/measure/command.py"))]
OLD = (3, 6)


@functools.cache
def pythons() -> dict[str, str]:
    """Older Pythons of this machine, by their versions: those on the PATH, and pyenv's."""
    found = {}
    folders = [Path(folder) for folder in os.environ["PATH"].split(os.pathsep)]
    folders += Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")).glob("versions/*/bin")
    for path in (path for folder in folders for path in sorted(folder.glob("python3.?*"))):
        if re.fullmatch(r"python3\.([6-9]|10)", path.name) and call(str(path), "-V").returncode == 0:
            found.setdefault(path.name.removeprefix("python"), str(path))
    return found


def call(python: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([python, "-B", *map(str, arguments)], capture_output=True, text=True, check=False)


class Needs(unittest.TestCase):
    def assert_told(self, done: subprocess.CompletedProcess[str], path: Path, there: str):
        shown, another = (("measure", r"The first python3 of the PATH is taken\.") if path.name == "command.py" else
                          (path.name, rf"Another one is taken like this: python3\.12 tools/{path.name}"))
        self.assertEqual((done.returncode, done.stdout), (4, ""), done.stderr)
        self.assertRegex(done.stderr, rf"\Atools/{shown} needs Python 3\.11 or later, and this is {there} \(.*\)\. "
                                      rf"{another}\n\Z")

    def test_a_command_is_read_by_a_python_that_is_too_old(self):
        for path in (*STARTED, TOOLS / "lib/base/ending.py", TOOLS / "lib/base/needs.py"):
            with self.subTest(path.name):
                text = path.read_text(encoding="utf-8")
                ast.parse(text, feature_version=OLD)
                self.assertNotIn("from __future__", text)

    def test_as_if_python_were_too_old(self):
        self.assertGreater(len(STARTED), 2)
        for path in STARTED:
            with self.subTest(path.name):
                code = (f"import runpy, sys; sys.argv = {[str(path), 'gpu']}; sys.version_info = {(*OLD, 1)}; "
                        "runpy.run_path(sys.argv[0], run_name='__main__')")
                self.assert_told(call(sys.executable, "-c", code), path, r"3\.6")

    @unittest.skipUnless(pythons(), "no Python 3.6 to 3.10 is here")
    def test_a_python_that_is_too_old(self):
        for version, python in pythons().items():
            for path in STARTED:
                with self.subTest(path.name, python=python):
                    self.assert_told(call(python, path, "--help"), path, re.escape(version))
