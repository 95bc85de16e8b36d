"""tools/pack registries: its files, and refusals. build_systems.conan and build_systems.vcpkg build by them."""

from __future__ import annotations

import hashlib
import io
import tarfile
import unittest
from pathlib import Path
from unittest import mock

from base.testing import Case
from base.tree import GLSL, version
from ship.packing import Refused
from ship.recipes import RECIPES
from ship.registries import files

TOP = "https://github.com/someone/noise"
SECONDS = 1796000000


def archive(path: Path, of: str = version()) -> Path:
    """An archive of a tag, as far as it is read here."""
    text = (GLSL / "config.glsl").read_text(encoding="ascii")
    major, minor, patch = of.split(".")
    for name, number in (("MAJOR", major), ("MINOR", minor), ("PATCH", patch)):
        text = files.replaced(text, rf"(?<=#define HN_VERSION_{name} )\d+", number)
    entry = tarfile.TarInfo(f"hashnoise-{of}/glsl/hashnoise/config.glsl")
    entry.size, entry.mtime = len(text), SECONDS
    with tarfile.open(path, "w:gz") as packed:
        packed.addfile(entry, io.BytesIO(text.encode("ascii")))
    return path


@mock.patch.object(files, "address", return_value=TOP)
class Registries(Case):
    def test_each_has_the_sum_and_the_place_of_the_archive(self, _: mock.Mock) -> None:
        path = archive(self.folder / "v.tar.gz")
        made = files.package(str(path))
        self.assertEqual({name.partition("/")[0] for name in made}, {
            *["conan-center-index"] * (files.PACKAGES / "conan").is_dir(), *["vcpkg"] * (files.PACKAGES / "vcpkg").is_dir(),
            *["openupm"] * ("unity" in RECIPES)})
        for name, parts in {
                "conan-center-index/recipes/hashnoise/all/conandata.yml": (
                    f'url: "{TOP}/archive/refs/tags/v{version()}.tar.gz"', hashlib.sha256(path.read_bytes()).hexdigest()),
                "conan-center-index/recipes/hashnoise/all/conanfile.py": (
                    'url = "https://github.com/conan-io/conan-center-index"\n', "import get, ", "def source(self)"),
                "conan-center-index/recipes/hashnoise/config.yml": (f'"{version()}":\n    folder: all\n',),
                "vcpkg/ports/hashnoise/portfile.cmake": (
                    "REPO someone/noise\n", f"SHA512 {hashlib.sha512(path.read_bytes()).hexdigest()}\n"),
                "openupm/data/packages/com.hashnoise.noise.yml": (
                    f'repoUrl: "{TOP}"\n', 'hunter: "someone"\n', f'minVersion: "{version()}"\n', f"createdAt: {SECONDS}000\n")}.items():
            if name in made:
                for part in parts:
                    self.assertIn(part, made[name])
        for text in made.values():
            self.assertNotIn("of a copy", text)

    def test_other_archives_are_refused(self, _: mock.Mock) -> None:
        (self.folder / "text").write_text("no archive")
        for given, said in ((archive(self.folder / "old.tar.gz", "0.1.2"), f"old.tar.gz has version 0.1.2 of hashnoise, and this is {version()}"),
                            (self.folder / "text", "text: it is no .tar.gz file"), (self.folder / "no", "no: No such file"),
                            (None, f"this command gets the file: curl -LO {TOP}/archive/")):
            with self.assertRaisesRegex(Refused, said):
                files.package(given and str(given))

    def test_a_project_elsewhere_is_refused(self, address: mock.Mock) -> None:
        address.return_value = "https://example.com/noise"
        with self.assertRaisesRegex(Refused, "must have https://github.com/OWNER/NAME; docs/develop/publishing.md"):
            files.package(str(archive(self.folder / "v.tar.gz")))

    def test_a_recipe_of_another_form_is_noticed(self, _: mock.Mock) -> None:
        with self.assertRaisesRegex(LookupError, "is there 2 times, and must be there once"):
            files.replaced("import re\nimport re\n", "import re\n", "")


if __name__ == "__main__":
    unittest.main()
