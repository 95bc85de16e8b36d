"""Where things are. A file that moves is named anew here."""

import os
import posixpath
import re
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
TOOLS = ROOT / "tools"
GLSL = ROOT / "glsl" / "hashnoise"
CONFORMANCE = ROOT / "conformance"
BOUNDS = CONFORMANCE / "expected" / "bounds.inc"
HN_CONFORM = ROOT / "build" / "conformance" / "hn-conform"  # where tools/measure clock builds it
GOLDEN = CONFORMANCE / "expected" / "golden"
FROZEN = GOLDEN.parent / "frozen.csv"
INTERFACE = GOLDEN.parent / "interface.csv"
VECTORS = ROOT / "build" / "vectors"  # proof.vectors makes them


def files(root: Path = ROOT) -> list[str]:
    """The names of the files of a repository. In an archive of it, which git does not know, they are all but what the
    build and Python make."""
    if (root / ".git").exists() and shutil.which("git"):
        done = subprocess.run(["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                              stdout=subprocess.PIPE, text=True, check=False)
        if done.returncode == 0:
            return sorted(name for name in done.stdout.split("\0") if (root / name).is_file())
    found = []
    for folder, folders, names in os.walk(root):
        place = os.path.relpath(folder, root)
        folders[:] = [name for name in folders if name not in (".git", "__pycache__") and
                      not (place == "." and (name == "out" or name.startswith("build")))]
        found += [posixpath.normpath(posixpath.join(place.replace(os.sep, "/"), name)) for name in names]
    return sorted(found)


def glsl_files(library: Path = GLSL) -> dict[str, Path]:
    """The files of the library by their names: what users include, and its parts in detail/."""
    return {path.relative_to(library).as_posix(): path for path in sorted(library.rglob("*.glsl"))}


def included_from(name: str, include: str) -> str:
    """The name of what a file of the library includes, as it is written there."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(name), include))


def hn_conform() -> str:
    """The program of the suite: that on the PATH, or the one built here; empty if there is none."""
    return shutil.which("hn-conform") or shutil.which(str(HN_CONFORM)) or ""


def version() -> str:
    """Of the library. It stands once, in the file that every shader includes."""
    text = (GLSL / "config.glsl").read_text(encoding="ascii")
    return ".".join(re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text, re.MULTILINE))


def address() -> str:
    """Of the project, or nothing while it has no public place. It stands once in code, where the page that checks a browser
    reads it, and in pages for users."""
    text = (CONFORMANCE / "web" / "address.js").read_text(encoding="utf-8")
    return re.search(r'^export const kAddress = "([^"]*)";$', text, re.MULTILINE)[1]


def site(of: str) -> str:
    """Of the site of a project at this address: the pages of a repository on GitHub, where .github/workflows/pages.yml puts
    it, with the playground."""
    found = re.fullmatch(r"https://github\.com/([\w-]+)/([\w.-]+)", of)
    return f"https://{found[1].lower()}.github.io/{found[2]}" if found else of
