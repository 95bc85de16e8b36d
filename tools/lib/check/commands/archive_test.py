"""An archive of the repository, which has no history: what reads the files of the tree reads the same there."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from base.tree import ROOT, files


class Archive(unittest.TestCase):
    def test_tests_that_read_the_tree_pass_in_an_archive(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            root, names = Path(folder), files()
            for name in names:
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, root / name)
            for name in ("build/vectors/index.json", "build-other/a.o", "out/index.html", "tools/__pycache__/tree.pyc"):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).touch()
            self.assertEqual(files(root), names)
            done = subprocess.run([sys.executable, "-B", "-m", "unittest", "check.words.words_test",
                                   "ship.website.website_test", "ship.release.release_test.Addresses"],
                                  cwd=root / "tools" / "lib", capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
