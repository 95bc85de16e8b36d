"""Tests of tools/measure rust, with scripts in place of tools/pack and cargo."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.tree import version
from measure import stamps
from measure.rust import command

LINES = "Perlin 2D,hashnoise,2.0,1.0,2.0\\nPerlin 2D,hashnoise fixed,4.0,3.0,4.0\\nPerlin 2D,noiz,6.0,6.0,6.0\\n"


class Command(unittest.TestCase):
    def call(self, cargo: str, *arguments: str, pack: str = "echo build/crate") -> tuple[int, str, Path]:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        for name, script in (("cargo", cargo), ("pack", pack), ("rustc", "echo rustc 1.63")):
            (folder / name).write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
            (folder / name).chmod(0o755)
        output = io.StringIO()
        with mock.patch.multiple(command, TOOLS=folder, FOLDER=folder), contextlib.redirect_stderr(output), \
                mock.patch.dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}"), contextlib.redirect_stdout(output):
            try:
                status = command.main(["--out", str(folder), *arguments])
            except SystemExit as end:
                status = end.code
        return status, output.getvalue(), folder

    def test_each_crate_is_compared_with_ours_on_each_target(self):
        status, output, folder = self.call(f'printf "{LINES}"; test "$7" = 3', "--rounds", "3")
        self.assertEqual((status, output.strip()), (0, str(folder / "rust.csv")))
        found = stamps.read(folder / "rust.csv")
        self.assertEqual((found.facts["by"], stamps.stale(folder / "rust.csv")), ("rustc 1.63", []))
        ours = version()
        self.assertEqual([",".join(list(row.values())[:-1]) for row in found.rows], [
            f"{target},Perlin 2D,{package}" for target in command.TARGETS
            for package in (f"hashnoise,{ours},1,1,0", f"hashnoise fixed,{ours},3,2,0.5", "noiz,0.6.0,6,3,1.5")])
        self.assertIn('noiz = { version = "=0.6.0"', (folder / "Cargo.toml").read_text(encoding="utf-8"))

    def test_what_cannot_be_built_or_packed(self):
        self.assertEqual(self.call("exit 101")[0], 1)
        self.assertEqual(self.call("exit 0", pack="exit 4")[0], 4)
        self.assertEqual(self.call("exit 0", "--rounds", "2")[0], 2)


if __name__ == "__main__":
    unittest.main()
