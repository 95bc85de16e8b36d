"""The wheel is one that PyPI would take, by the command of docs/develop/publishing.md: twine reads the wheel's
metadata, as PyPI does."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import golden

PAGE = (golden.ROOT / "docs" / "develop" / "publishing.md").read_text(encoding="utf-8")
WHEELS = Path(sys.prefix).parent / "wheels"  # beside the environment


class Registry(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "dist").mkdir()
        self.wheel, = WHEELS.glob("*.whl")

    def checked(self) -> subprocess.CompletedProcess[str]:
        program, *words = re.search(r"^\| PyPI \| `(twine check [^`]*)`", PAGE, re.MULTILINE)[1].split()
        files = [name for word in words for name in (map(str, self.folder.glob(word)) if "*" in word else [word])]
        self.assertTrue(files[-1].endswith(".whl"))
        return subprocess.run([sys.executable, "-m", program, *files], capture_output=True, text=True, check=False)

    def test_it_is_taken(self) -> None:
        shutil.copy(self.wheel, self.folder / "dist")
        done = self.checked()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("PASSED", done.stdout)

    def test_one_without_a_description_or_a_name_is_refused(self) -> None:
        for before, after in ((r"(?s)\n\n.*", "\n\n"), ("(?m)^Name: .*\n", "")):
            copy = self.folder / "dist" / self.wheel.name
            with zipfile.ZipFile(self.wheel) as right, zipfile.ZipFile(copy, "w") as wrong:
                for name in right.namelist():
                    data = right.read(name)
                    if name.endswith(".dist-info/METADATA"):
                        changed = re.sub(before, after, data.decode("utf-8"))
                        self.assertNotEqual(changed.encode("utf-8"), data)
                        data = changed.encode("utf-8")
                    wrong.writestr(name, data)
            with self.subTest(before):
                self.assertNotEqual(self.checked().returncode, 0)
