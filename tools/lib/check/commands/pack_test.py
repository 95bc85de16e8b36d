"""tools/pack npm and python: what they refuse, and how they fail. npm.package and python.wheel make packages."""

from __future__ import annotations

import os
import shutil
import subprocess
import unittest

from base.pieces import is_deleted
from base.testing import Case
from base.tree import TOOLS

# Tests of both packages, and of the wheel; ship.packing_test has what every package refuses. Where these are tried there is a
# file named file, and old-python fails.
BAD_USAGE = ((("file",), "file is a file; it must be a folder, or a name for a new one"),
             (("file/folder",), "the folder file/folder cannot be made"))
OF_WHEEL = ((("--library",), "argument --library: expected one argument"),
            (("--sdist", "--library=no-such.a"), "argument --library: not allowed with argument --sdist"),
            (("--library=no-such.a",), "there is no library no-such.a"),
            (("--python", "no-such"), "there is no program no-such"),
            (("--python", "old-python"), "old-python is no Python 3.10 or later"))


class Pack(Case):
    """On a machine where whoever installs something is noticed."""

    def setUp(self) -> None:
        self.root = self.folder
        shutil.copytree(TOOLS / "lib", self.root / "tools" / "lib", ignore=shutil.ignore_patterns("*_test.py"))
        shutil.copy(TOOLS / "pack", self.root / "tools")
        for name, command in (("apt-get", f"touch {self.root}/installed; exit 1"), ("old-python", "exit 1"),
                              ("dpkg-query", 'shift 3; for package; do echo "$package installed"; done')):
            self.script(f"programs/{name}", command)

    def call(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        done = subprocess.run([self.root / "tools" / "pack", *arguments], cwd=self.root, capture_output=True, text=True,
                              check=False, env={**os.environ, "PATH": f"{self.root / 'programs'}:{os.environ['PATH']}"})
        self.assertFalse((self.root / "installed").exists())
        return done

    def test_bad_usage(self) -> None:
        (self.root / "file").touch()
        for name, cases in (("npm", BAD_USAGE), ("python", BAD_USAGE + OF_WHEEL)):
            if is_deleted(name):
                continue
            for arguments, said in cases:
                with self.subTest(name, arguments=arguments):
                    done = self.call(name, *arguments)
                    self.assertEqual((done.returncode, done.stdout), (2, ""))
                    self.assertRegex(done.stderr, rf"tools/pack {name}: (.*/)?{said}.*; see tools/pack {name} --help\n")
        self.assertFalse((self.root / "build").exists())

    @unittest.skipIf(is_deleted("npm"), "npm was deleted")
    def test_what_cannot_be_made(self) -> None:
        """Here is nothing to make a package of."""
        done = self.call("npm")
        self.assertEqual((done.returncode, done.stdout), (4, ""))
        self.assertIn("The files of the package could not be made; all of the output is in", done.stderr)
        self.assertFalse((self.root / "build" / "npm").exists())
