"""hn-conform as the tests beside this file start it, and what it leaves behind.

Usage of each of them: NAME_cli_test.py PATH-OF-HN-CONFORM
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
PROGRAM = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CHEAP = "bugs.abs_of_int.any.exact.fragment.gl330.defined"  # draws, and needs no list of the cases of all functions


def instructions_of(path):
    """The instructions of a module of SPIR-V, as bench counts them: in functions, without labels and parameters."""
    listing = subprocess.run(["spirv-dis", "--raw-id", path], capture_output=True, text=True, check=True).stdout
    count, inside = 0, False
    for operation in re.findall(r"^\s*(?:%\S+ = )?(Op\w+)", listing, re.MULTILINE):
        inside = inside and operation != "OpFunctionEnd"
        count += inside and operation not in ("OpLabel", "OpFunctionParameter")
        inside = inside or operation == "OpFunction"
    return count


class ProgramTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def call(self, *arguments, environment=None):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=300,
                              env={**os.environ, **(environment or {})})

    def listed(self, *arguments):
        done = ProgramTest.call(self, "list", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.split()

    def results(self):
        return json.loads((self.out / "results.json").read_text())

    def assert_refused(self, done, *parts):
        """Bad usage, with these words."""
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for part in parts:
            self.assertIn(str(part), done.stderr + done.stdout)
