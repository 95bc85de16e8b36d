"""The files that ConanCenter, vcpkg and OpenUPM take by a pull request: a recipe of a version, by GitHub's archive of its tag."""

from __future__ import annotations

import hashlib
import json
import re
import tarfile
from pathlib import Path

from base.tree import ROOT, address, version
from ship.packing import Refused
from ship.recipes import RECIPES

PACKAGES = ROOT / "packages"
OF_CONAN = ("conanfile.py", *(f"test_package/{name}" for name in ("CMakeLists.txt", "conanfile.py", "main.cpp")))
OF_A_COPY = "(?s)    # begin: of a copy\n.*?    # end: of a copy\n"
SOURCE = """    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)
"""
FROM_GITHUB = """vcpkg_from_github(
    OUT_SOURCE_PATH SOURCE_PATH
    REPO {repository}
    REF "v${{VERSION}}"
    SHA512 {sum}
    HEAD_REF main
)
"""


def replaced(text: str, pattern: str, by: str) -> str:
    """The text with something else at the one place that the pattern finds."""
    made, count = re.subn(pattern, lambda _: by, text)
    if count != 1:
        raise LookupError(f"{pattern} is there {count} times, and must be there once")
    return made


def archive_address() -> str:
    return f"{address()}/archive/refs/tags/v{version()}.tar.gz"


def of_conan(archive: bytes) -> dict[str, str]:
    """A folder of recipes/ in conan-center-index."""
    found = {f"all/{name}": (PACKAGES / "conan" / name).read_text(encoding="utf-8") for name in OF_CONAN}
    for pattern, by in ((OF_A_COPY, SOURCE), (r'(?s)\A""".*?"""\n\n', ""), ("import re\n", ""), ("import copy, load,", "import get,"),
                        (r"(?:    url = .*\n    homepage = .*\n)?    topics",
                         f'    url = "https://github.com/conan-io/conan-center-index"\n    homepage = "{address()}"\n    topics')):
        found["all/conanfile.py"] = replaced(found["all/conanfile.py"], pattern, by)
    found["all/conandata.yml"] = (f'sources:\n  "{version()}":\n    url: "{archive_address()}"\n'
                                  f'    sha256: "{hashlib.sha256(archive).hexdigest()}"\n')
    found["config.yml"] = f'versions:\n  "{version()}":\n    folder: all\n'
    return {f"conan-center-index/recipes/hashnoise/{name}": text for name, text in found.items()}


def of_vcpkg(archive: bytes, repository: str) -> dict[str, str]:
    """A folder of ports/ in vcpkg."""
    found = {name: (PACKAGES / "vcpkg" / "hashnoise" / name).read_text(encoding="utf-8")
             for name in ("portfile.cmake", "usage", "vcpkg.json")}
    found["portfile.cmake"] = replaced(found["portfile.cmake"], r"\A#.*\ncmake_path\(.*\n", FROM_GITHUB.format(
        repository=repository, sum=hashlib.sha512(archive).hexdigest()))
    return {f"vcpkg/ports/hashnoise/{name}": text for name, text in found.items()}


def of_openupm(repository: str, seconds: int) -> dict[str, str]:
    """The file of a package, by which OpenUPM finds a .tgz in each release on GitHub. JSON's values are YAML's, too."""
    name = RECIPES["unity"].name
    manifest = json.loads((PACKAGES / "unity" / "package.json").read_text(encoding="utf-8"))
    fields = {"name": name, "aliases": [], "displayName": manifest["displayName"], "description": manifest["description"],
              "repoUrl": address(), "parentRepoUrl": None, "licenseSpdxId": manifest["license"], "licenseName": "MIT License",
              "topics": ["procedural-generation", "terrain"], "hunter": repository.partition("/")[0], "gitTagPrefix": "v",
              "gitTagIgnore": "", "minVersion": version(), "trackingMode": "githubRelease",
              "githubReleaseAssetName": f"{name}-", "image": "", "readme": "main:packages/unity/README.md",
              "createdAt": 1000 * seconds}
    return {f"openupm/data/packages/{name}.yml": "".join(f"{key}: {json.dumps(value)}\n" for key, value in fields.items())}


def checked(archive: str | None) -> tuple[bytes, int]:
    """The bytes of the archive, and the time of its commit."""
    if archive is None:
        raise Refused(f"--archive FILE is missing; this command gets the file: curl -LO {archive_address()}")
    try:
        with tarfile.open(archive, "r:gz") as packed:
            config = next((one for one in packed if re.fullmatch("[^/]+/glsl/hashnoise/config.glsl", one.name)), None)
            text = packed.extractfile(config).read().decode("ascii") if config else ""
        found = ".".join(re.findall(r"(?m)^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text))
        if found != version():
            raise Refused(f"--archive {archive} has version {found or 'nothing'} of hashnoise, and this is {version()}")
        return Path(archive).read_bytes(), int(config.mtime)
    except (OSError, tarfile.TarError) as error:
        raise Refused(f"--archive {archive}: {getattr(error, 'strerror', None) or 'it is no .tar.gz file'}") from error


def package(archive: str | None = None) -> dict[str, str]:
    """All files, by their paths."""
    repository = re.fullmatch(r"https://github\.com/([\w-]+/[\w.-]+)", address())
    if not repository:
        raise Refused(f"conformance/web/address.js has {address() or 'no address'}, and must have https://github.com/OWNER/NAME; "
                      "docs/develop/publishing.md states what to do the first time")
    content, seconds = checked(archive)
    made = {}
    if (PACKAGES / "conan").is_dir():
        made |= of_conan(content)
    if (PACKAGES / "vcpkg").is_dir():
        made |= of_vcpkg(content, repository[1])
    if "unity" in RECIPES:
        made |= of_openupm(repository[1], seconds)
    return made
