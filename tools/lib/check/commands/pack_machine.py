"""A copy of tools/pack on a machine where whoever installs something is noticed, for the tests of its commands."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from base.tree import TOOLS


class PackMachine(unittest.TestCase):
    name: str  # of the package

    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        shutil.copytree(TOOLS / "lib", self.root / "tools" / "lib", ignore=shutil.ignore_patterns("*_test.py"))
        shutil.copy(TOOLS / "pack", self.root / "tools")
        self.programs = self.root / "programs"
        self.programs.mkdir()
        for name, command in (("apt-get", f"touch {self.root}/installed; exit 1"),
                              ("dpkg-query", 'shift 3; for package; do echo "$package installed"; done')):
            self.write_program(name, command)

    def write_program(self, name: str, command: str) -> Path:
        path = self.programs / name
        path.write_text(f"#!/bin/sh\n{command}\n", encoding="ascii")
        path.chmod(0o755)
        return path

    def call(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        done = subprocess.run([self.root / "tools" / "pack", self.name, *arguments], cwd=self.root,
                              capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": f"{self.programs}:{os.environ['PATH']}"})
        self.assertFalse((self.root / "installed").exists())
        return done
