"""Tests of tools/pack npm: what it prints before it makes anything. The test npm.package makes a package."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from base.tree import ROOT, TOOLS


class Npm(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        shutil.copytree(TOOLS / "lib", self.root / "tools" / "lib", ignore=shutil.ignore_patterns("*_test.py"))
        shutil.copytree(ROOT / "catalog", self.root / "catalog")
        shutil.copy(TOOLS / "pack", self.root / "tools")
        # Whoever installs something is noticed, and has everything.
        self.programs = self.root / "programs"
        self.programs.mkdir()
        for name, command in (("apt-get", f"touch {self.root}/installed; exit 1"),
                              ("dpkg-query", 'shift 3; for package; do echo "$package installed"; done')):
            path = self.programs / name
            path.write_text(f"#!/bin/sh\n{command}\n", encoding="ascii")
            path.chmod(0o755)

    def call(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        done = subprocess.run([self.root / "tools" / "pack", "npm", *arguments], cwd=self.root,
                              capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": f"{self.programs}:{os.environ['PATH']}"})
        self.assertFalse((self.root / "installed").exists())
        return done

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
                self.assertIn("tools/pack npm --help tells more\n", done.stderr)
                self.assertFalse((self.root / "build").exists())

    def test_what_cannot_be_made(self):
        """Here is nothing to make a package of."""
        done = self.call()
        self.assertEqual((done.returncode, done.stdout), (4, ""))
        self.assertIn("The files of the package could not be made; all of the output is in", done.stderr)
        self.assertFalse((self.root / "build" / "npm").exists())


if __name__ == "__main__":
    unittest.main()
