"""An archive of the repository, which has no history: what reads the files of the tree reads the same there. And Windows
can have all its names."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from base.tree import ROOT, files

# Names of devices, characters and endings that git refuses on Windows: no file of such a commit is checked out there.
REFUSED = re.compile(r'(^|/)(con|prn|aux|nul|com\d|lpt\d)(\.[^/]*)?(/|$)|[<>:"\\|?*\x00-\x1f]|[. ](/|$)', re.IGNORECASE)


def refused(names: list[str]) -> list[str]:
    """The names that Windows cannot have, and those that differ from another by their case alone."""
    seen = [name.lower() for name in names]
    return [name for i, name in enumerate(names) if REFUSED.search(name) or seen.index(name.lower()) < i]


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


class Names(unittest.TestCase):
    def test_windows_can_have_all(self) -> None:
        self.assertEqual(refused(files()), [])

    def test_others_are_named(self) -> None:
        wrong = ["a/nul", "Aux.h", "com1/b", "a:b", "a/what?", "end.", "end /b"]
        self.assertEqual(refused(["null", ".github/a", "A", *wrong, "a"]), [*wrong, "a"])
