"""Tests of --help of the commands that build: it is there before anything is built."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from tree import TOOLS

CONFORM = "conformance/hn-conform"
# The program behind each, in build/, and what it is asked.
COMMANDS = {"bake": ("src/bake/hn-bake", "--help"), "bench": (CONFORM, "bench --help"),
            "bench-cpu": ("bench-cpu-g++/src/bench_cpu/hn-bench-cpu", "--help"),
            "conform": (CONFORM, "run --help"), "paper": (CONFORM, "paper --help")}


class Help(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        tools = self.root / "tools"
        tools.mkdir()
        for name in ("setup.sh", "progress.sh", "test", *COMMANDS):
            shutil.copy(TOOLS / name, tools)
        # Whoever builds or installs something is noticed.
        self.programs = self.root / "programs"
        for name in ("cmake", "dpkg-query", "apt-get", "sudo"):
            self.write_program(self.programs / name, f"touch {self.root}/{name}.called; exit 1")

    def write_program(self, path: Path, command: str) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{command}\n")
        path.chmod(0o755)

    def call(self, name: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([self.root / "tools" / name, *arguments], capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": f"{self.programs}:{os.environ['PATH']}"})

    def assert_helped(self, done: subprocess.CompletedProcess[str]) -> None:
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Exit status:", done.stdout)
        self.assertIn("4 it could not be built", done.stdout)
        self.assertEqual(list(self.root.glob("*.called")), [])

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
            self.write_program(self.root / "build" / program, 'echo "told: $*"')
        self.write_program(self.programs / "ctest", 'echo "told: $*"')
        for name, (_, told) in {**COMMANDS, "test": ("ctest", "--help")}.items():
            with self.subTest(name=name):
                done = self.call(name, "--help")
                self.assert_helped(done)
                self.assertIn(f"told: {told}\n", done.stdout)

    def test_whoever_asks_for_none_is_not_helped(self):
        self.assertEqual(self.call("conform", "--filter", "*help*").returncode, 4)
        self.assertNotEqual(list(self.root.glob("*.called")), [])


if __name__ == "__main__":
    unittest.main()
