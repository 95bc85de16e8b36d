"""The metadata of the Python package that pyproject.toml cannot have. scikit-build-core calls this where it builds, in a
clone and in a source distribution.

    python3 -B -m ship.python.metadata    prints the digest of the package's sources, for tools/bake
"""

from __future__ import annotations

import hashlib
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
# The package is made of these. CMake installs their digest, by which tools/bake knows a package of its own sources.
SOURCES = ("CMakeLists.txt", "glsl", "include", "packages/python", "pyproject.toml", "src/CMakeLists.txt", "src/grid")
DIGEST = ROOT / "build" / "sources.sha256"
OBJECTS = ROOT / "build" / "python"  # build-dir of pyproject.toml
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


def sources() -> list[Path]:
    """The files, without tests."""
    found = [file for name in SOURCES for file in (ROOT / name, *(ROOT / name).rglob("*")) if file.is_file()]
    return sorted(file for file in found if not {"tests", "__pycache__"} & {*file.relative_to(ROOT).parts})


def digest() -> str:
    """A source distribution keeps the digest of its clone."""
    of_all = hashlib.sha256()
    for file in sources():
        of_all.update(file.relative_to(ROOT).as_posix().encode() + hashlib.sha256(file.read_bytes()).digest())
    return of_all.hexdigest()


def note_digest() -> None:
    """Before a build. ninja compiles what is later than its object. A file that replaced another since the last build may
    have an earlier time, as one of an archive has; then no object is kept."""
    last = DIGEST.stat().st_mtime_ns if DIGEST.exists() else 0
    if any(status.st_mtime_ns < last <= status.st_ctime_ns for status in map(Path.stat, sources())):
        shutil.rmtree(OBJECTS, ignore_errors=True)
    DIGEST.parent.mkdir(exist_ok=True)
    DIGEST.write_text(digest(), encoding="ascii")


class Provider:
    """The interface of dynamic-metadata 0.3."""

    is_source = False

    def build_state(self, state: str) -> None:
        self.is_source = state == "sdist"

    def dynamic_metadata(self, settings: dict[str, object], project: dict[str, object]) -> dict[str, object]:
        names = ["LICENSE"]
        take_along(self.is_source)
        if not self.is_source:
            note_digest()
        for name, text in {} if self.is_source else of_nanobind().items():
            LICENSES.mkdir(parents=True, exist_ok=True)
            (LICENSES / name).write_text(text, encoding="utf-8")
            names.append((LICENSES / name).relative_to(ROOT).as_posix())
        return {"license-files": names, "readme": {"text": of_package(PAGE), "content-type": "text/markdown"}}

    def dynamic_wheel(self, settings: dict[str, object]) -> dict[str, bool]:
        """A source distribution has nothing of others, and a wheel that is built from it has."""
        return {"license-files": True}


if __name__ == "__main__":
    print(digest())
