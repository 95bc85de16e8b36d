"""Tests of tools/pack python: its output before it builds anything. The test python.wheel builds a wheel."""

from __future__ import annotations

import sys
import unittest

from check.commands.pack_machine import PackMachine


class Wheel(PackMachine):
    name = "python"

    def test_help(self):
        for arguments in (("--help",), ("-h",), ("help",), ("--python", "no-such", "--help")):
            with self.subTest(arguments):
                done = self.call(*arguments)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("tools/pack python [-h] [--python PYTHON] [--manylinux] [--library FILE] [FOLDER]", done.stdout)
                self.assertIn("Exit status: 0 done", done.stdout)
                self.assertNotIn("#", done.stdout)
                self.assertFalse((self.root / "build").exists())

    def test_bad_usage(self):
        (self.root / "file").touch()
        old = self.write_program("old-python", "exit 1")
        for arguments, said in ((("one", "two"), "two is one word too many"),
                                (("",), "the folder has no name"),
                                (("file",), "file is a file; it must be a folder, or a name for a new one"),
                                (("file/folder",), "the folder file/folder cannot be made"),
                                (("--no-such",), "there is no option --no-such"),
                                (("--library",), "argument --library: expected one argument"),
                                (("--library", "no-such.a"), "there is no library no-such.a"),
                                (("--library=no-such.a",), "there is no library no-such.a"),
                                (("--python",), "argument --python: expected one argument"),
                                (("--python", "no-such"), "there is no program no-such"),
                                (("--python=no-such",), "there is no program no-such"),
                                (("--python", str(old)), f"{old} is no Python 3.10 or later")):
            with self.subTest(arguments):
                done = self.call(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(f"tools/pack python: {said}", done.stderr)
                self.assertIn("see tools/pack python --help\n", done.stderr)
                self.assertFalse((self.root / "build").exists())

    def test_what_cannot_be_built(self):
        """Here is nothing to build: the end of pip's output is printed, and the rest is in the log."""
        (self.root / "tools" / "make").write_text("#!/bin/sh\n")  # of the vectors
        (self.root / "tools" / "make").chmod(0o755)
        done = self.call("--python", sys.executable)
        self.assertEqual((done.returncode, done.stdout), (4, ""))
        self.assertIn("The wheel could not be built; all of the output is in", done.stderr)
        self.assertIn(str(self.root), (self.root / "build" / "setup.log").read_text(encoding="utf-8"))
        self.assertEqual(list((self.root / "build" / "wheels").iterdir()), [])


if __name__ == "__main__":
    unittest.main()
