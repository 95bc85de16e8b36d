#!/usr/bin/env python3
"""The commands of docs/guide/bake.md work as they stand there. Usage: bake_page_test.py PATH-OF-HN-BAKE"""

from __future__ import annotations

import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "guide" / "bake.md"


class Page(unittest.TestCase):
    def test_its_commands_write_what_they_name(self) -> None:
        calls = [shlex.split(line) for line in PAGE.read_text().splitlines() if line.startswith("    tools/bake ")]
        self.assertGreaterEqual(len(calls), 5)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            source, text = re.search(r"`(\w+\.glsl)`:\n\n```glsl\n(.*?)```", PAGE.read_text(), re.DOTALL).groups()
            (folder / source).write_text(text)
            for call in calls:
                with self.subTest(call=call):
                    done = subprocess.run([PROGRAM, *call[1:]], cwd=folder, capture_output=True, text=True, check=False)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    out = pathlib.Path(call[call.index("-o") + 1])
                    self.assertTrue(list(folder.glob(f"{out.stem}*{out.suffix}")))
            self.assertEqual(len(list(folder.glob("cells.*.png"))), 64)

    def test_options_that_it_names_exist(self) -> None:
        help = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
        known = set(re.findall(r"(--[\w-]+)", help))
        named = set(re.findall(r"`(--[\w-]+)", PAGE.read_text()))
        self.assertGreater(len(named), 10)
        self.assertEqual(named - known, set())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
