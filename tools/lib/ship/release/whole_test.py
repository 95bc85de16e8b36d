"""tools/pack release makes the same bytes in two folders, of all parts but the page that the suite's program makes. tools.ship.release has the parts that take seconds; this takes minutes.

Exit status: as of the tests; 77 this is no git repository, which a release needs.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from base.debian import SKIPPED
from base.testing import Case
from base.tree import ROOT
from ship.packing_support import lost_links
from ship.recipes import RECIPES
from ship.release.files import PARTS


def differences(one: Path, other: Path) -> list[str]:
    names = [{path.name for path in folder.iterdir()} for folder in (one, other)]
    return [f"{name} is in one folder" for name in sorted(names[0] ^ names[1])] + [
        name for name in sorted(names[0] & names[1]) if (one / name).read_bytes() != (other / name).read_bytes()]


def packages(folder: Path) -> list[Path]:
    return sorted([*folder.glob("*.zip"), *folder.glob("*.tgz")])


class Whole(Case):
    def test_two_folders_make_the_same_bytes(self) -> None:
        made = []
        for place in ("one", "another/with a longer name"):
            clone, out = self.folder / place, self.folder / f"made {len(made)}"
            subprocess.run(["git", "clone", "--quiet", ROOT, clone], check=True)
            done = subprocess.run([clone / "tools" / "pack", "release", "--trial", "--without", "check", out],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            made.append(out)
        self.assertGreater(len(list(made[0].iterdir())), len(PARTS) - 1)
        self.assertEqual(differences(*made), [])
        self.assertEqual([link for path in packages(made[0]) for link in self.lost_links(path)], [])
        self.assertGreater(len(packages(made[0])), len(RECIPES) - 3)  # release and registries are none

    def lost_links(self, path: Path) -> list[str]:
        folder = self.folder / f"unpacked {path.name}"
        shutil.unpack_archive(path, folder)
        files = {file.relative_to(folder).as_posix(): file for file in folder.rglob("*") if file.is_file()}
        pages = {name: file.read_text(encoding="utf-8") for name, file in files.items() if name.endswith(".md")}
        return [f"{path.name}: {link}" for link in lost_links(pages, files)]

    def test_a_link_that_is_lost_is_told(self) -> None:
        (self.folder / "package").mkdir()
        (self.folder / "package" / "README.md").write_text("[It](it.md) is [there](README.md).\n", encoding="utf-8")
        shutil.make_archive(str(self.folder / "name-1.2.3"), "zip", self.folder, "package")
        path, = packages(self.folder)
        self.assertEqual(self.lost_links(path), ["name-1.2.3.zip: package/README.md: it.md"])

    def test_what_differs_is_told(self) -> None:
        for name in ("one", "other"):
            (self.folder / name).mkdir()
            (self.folder / name / "same").write_bytes(b"1")
            (self.folder / name / "changed").write_bytes(name.encode())
            (self.folder / name / f"only {name}").touch()
        self.assertEqual(differences(self.folder / "one", self.folder / "other"),
                         ["only one is in one folder", "only other is in one folder", "changed"])


if __name__ == "__main__":
    if not (ROOT / ".git").exists():
        print(f"skipped: {ROOT} is no git repository")
        sys.exit(SKIPPED)
    unittest.main()
