"""tools/lib/base/node: which Node.js it runs."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from base.tree import TOOLS

NODE = shutil.which("node")


class Node(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        (self.root / "tools" / "lib" / "base").mkdir(parents=True)
        for name in ("setup.sh", "progress.sh", "node"):
            shutil.copy(TOOLS / "lib" / "base" / name, self.root / "tools" / "lib" / "base")
        self.programs = self.root / "programs"
        self.programs.mkdir()

    def write_program(self, name: str, command: str) -> None:
        (self.programs / name).write_text(f"#!/bin/sh\n{command}\n", encoding="ascii")
        (self.programs / name).chmod(0o755)

    def call(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        path = f"{self.programs}{os.pathsep}{os.environ['PATH']}"
        return subprocess.run([self.root / "tools" / "lib" / "base" / "node", *arguments], capture_output=True, text=True, check=False,
                              env=os.environ | {"PATH": path})

    def test_another_program_is_bad_usage(self):
        for arguments, said in (((), "a program is missing"), (("yarn",), "there is no program yarn")):
            with self.subTest(arguments=arguments):
                done = self.call(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(said, done.stderr)

    def test_the_help_is_the_comment_at_the_top(self):
        done = self.call("--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("tools/lib/base/node node FILE", done.stdout)

    @unittest.skipUnless(NODE, "there is no node in PATH")
    def test_one_of_the_path_is_taken_if_it_is_new_enough(self):
        self.write_program("npm", "exit 0")
        self.write_program("python3", "exit 1")  # so there is no other
        self.write_program("node", f'exec {NODE} --require {self.root}/version.cjs "$@"')
        for version, status in (("18.20.4", 4), ("20.18.3", 4), ("20.19.0", 0), ("21.9.0", 4), ("22.11.0", 4),
                                ("22.12.0", 0), ("24.1.0", 0)):
            with self.subTest(version=version):
                (self.root / "version.cjs").write_text(
                    f"Object.defineProperty(process, 'versions', {{value: {{node: '{version}'}}}});", encoding="ascii")
                done = self.call("node", "-p", "process.versions.node")
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertEqual(done.stdout, f"{version}\n" if status == 0 else "")


if __name__ == "__main__":
    unittest.main()
