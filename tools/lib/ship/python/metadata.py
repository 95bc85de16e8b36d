"""The metadata of the Python package that pyproject.toml cannot have. scikit-build-core calls this where it builds, in a
clone and in a source distribution."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from base.tree import ROOT, TOOLS, VECTORS
from ship.page import of_package

PAGE = ROOT / "docs" / "guide" / "python.md"
# Texts of others are not copied into the repository: they are those of the nanobind that is compiled in. They go
# through this folder, since a path among license-files is one below the root.
LICENSES = ROOT / "build" / "licenses"
ARRAYS = ROOT / "build" / "arrays"
HEADER = "nanobind/ext/robin_map/include/tsl/robin_map.h"


class NoLicense(Exception):
    """The wheel would lack a license that it has to have."""


def of_nanobind() -> dict[str, str]:
    """The license of nanobind, and that of the table which it has inside, by the names of files. The table has none but
    the comment that its header begins with."""
    try:
        found = distribution("nanobind")
        own = found.read_text("licenses/LICENSE")
        header = Path(found.locate_file(HEADER)).read_text(encoding="utf-8")
    except (PackageNotFoundError, FileNotFoundError) as error:
        raise NoLicense(f"the licenses of nanobind are not where they are expected: {error}") from error
    notice = re.match(r"/\*\*\n((?: \*.*\n)+?) \*/\n", header)
    if not own or not notice:
        raise NoLicense(f"there is no license of nanobind {found.version}, or none at the top of {HEADER}")
    return {"nanobind.txt": own, "robin_map.txt": re.sub(r"^ \* ?", "", notice[1], flags=re.MULTILINE)}


def take_along(is_source: bool) -> None:
    """Makes what pyproject.toml and CMake take along, unless it is there. A source distribution has it in folders of its
    own, and no tools that make it."""
    for folder in (VECTORS, ARRAYS):
        if (ROOT / folder.name).is_dir():
            shutil.copytree(ROOT / folder.name, folder, dirs_exist_ok=True)
    if is_source and not VECTORS.is_dir():
        subprocess.run([sys.executable, TOOLS / "make", "vectors"], stdout=subprocess.DEVNULL, check=True)
    if not (ROOT / ARRAYS.name).is_dir():
        subprocess.run([sys.executable, "-B", "-m", "ship.python.arrays"], cwd=TOOLS / "lib", check=True)


class Provider:
    """The interface of dynamic-metadata 0.3."""

    is_source = False

    def build_state(self, state: str) -> None:
        self.is_source = state == "sdist"

    def dynamic_metadata(self, settings: dict[str, object], project: dict[str, object]) -> dict[str, object]:
        names = ["LICENSE"]
        take_along(self.is_source)
        for name, text in {} if self.is_source else of_nanobind().items():
            LICENSES.mkdir(parents=True, exist_ok=True)
            (LICENSES / name).write_text(text, encoding="utf-8")
            names.append((LICENSES / name).relative_to(ROOT).as_posix())
        return {"license-files": names, "readme": {"text": of_package(PAGE), "content-type": "text/markdown"}}

    def dynamic_wheel(self, settings: dict[str, object]) -> dict[str, bool]:
        """A source distribution has nothing of others, and a wheel that is built from it has."""
        return {"license-files": True}
