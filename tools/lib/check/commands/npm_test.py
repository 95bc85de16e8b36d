"""Tests of tools/pack npm: its output before it makes anything. The test npm.package makes a package."""

from __future__ import annotations

import unittest

from check.commands.pack_machine import PackMachine


class Npm(PackMachine):
    name = "npm"

    def test_help(self):
        for arguments in (("--help",), ("-h",), ("help",)):
            with self.subTest(arguments):
                done = self.call(*arguments)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("tools/pack npm [-h] [FOLDER]", done.stdout)
                self.assertIn("Exit status: 0 done", done.stdout)
                self.assertFalse((self.root / "build").exists())

    def test_bad_usage(self):
        (self.root / "file").touch()
        for arguments, said in ((("one", "two"), "two is one word too many"),
                                (("",), "the folder has no name"),
                                (("file",), "file is a file; it must be a folder, or a name for a new one"),
                                (("file/folder",), "the folder file/folder cannot be made"),
                                (("--no-such",), "there is no option --no-such")):
            with self.subTest(arguments):
                done = self.call(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(f"tools/pack npm: {said}", done.stderr)
                self.assertIn("see tools/pack npm --help\n", done.stderr)
                self.assertFalse((self.root / "build").exists())

    def test_what_cannot_be_made(self):
        """Here is nothing to make a package of."""
        done = self.call()
        self.assertEqual((done.returncode, done.stdout), (4, ""))
        self.assertIn("The files of the package could not be made; all of the output is in", done.stderr)
        self.assertFalse((self.root / "build" / "npm").exists())


if __name__ == "__main__":
    unittest.main()
