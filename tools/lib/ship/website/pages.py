"""The pages of the site, in the form that Sphinx needs: a copy in which every link leads somewhere."""

from __future__ import annotations

import os
import posixpath
import re
import shutil
from collections.abc import Iterable
from pathlib import Path

from base.pieces import is_deleted, was_deleted
from base.tree import ROOT, address, files, version
from ship.page import relinked
from ship.website import live

# The parts of the site beside its pages, in the order in which a reader needs them. A page of docs/ is in one group.
GROUPS = {
    "Guide": ["guide/tutorial", "guide/gallery/README", "guide/languages", "guide/moving", "guide/cellular",
              "guide/random", "guide/uniform", "guide/hex-tiling", "guide/same-bits"],
    "Where you are": ["guide/playground", "guide/bake", "guide/build-systems", "guide/javascript", "guide/python",
                      "guide/notebook", "guide/dask", "guide/cpu", "guide/gpu-computing", "guide/engines", "guide/godot",
                      "guide/conformance"],
    "Reference": ["reference/noises", "reference/fractals", "reference/knobs", "reference/snippets/README",
                  "reference/contract", "reference/frozen", "reference/formats", "reference/checks",
                  "reference/glossary"],
    "Measured": ["measured/measuring", "measured/gpu-operations", "measured/silicon", "measured/accuracy", "measured/quality",
                 "measured/hashes", "measured/default-hash", "measured/judge", "measured/faults", "measured/proof",
                 "measured/results/README"],
    "Work on hashnoise": ["develop/internals", "develop/one-noise", "develop/adding", "develop/suite",
                          "develop/porting", "develop/release", "develop/publishing"],
}
GROUPS = {group: [page for page in those if not was_deleted(f"docs/{page}.md")] for group, those in GROUPS.items()}
TOP = ("docs/README", "CHANGELOG", "CONTRIBUTING", "CODE_OF_CONDUCT", "SECURITY", "conformance/run/expect/README")
# The page of a package that a command makes; pages of docs/ lead there.
PACKAGE = re.compile(r"packages/[\w-]+/README\.md")
# The words by which somebody looks for a section, where its heading has another: the page, the heading, the words. The
# search of the site puts the section first.
WORDS = {
    "docs/reference/noises.md": {"Frequency, persistence and other names": ("frequency", "scale", "zoom", "wavelength"),
                                 "Tiles": ("seamless", "tileable", "tile", "period", "wrap"),
                                 "Stripes": ("Gabor noise", "phasor"),
                                 "Derivatives": ("gradient", "normal", "normals", "slope"),
                                 "Loops: gradients that rotate": ("loop", "animation", "flow noise")},
    "docs/reference/fractals.md": {"Fractals and warps: terrain, clouds, ridges, wood":
                                   ("fractal", "fbm", "fractional Brownian motion", "octave", "octaves", "octave sums",
                                    "persistence", "gain", "lacunarity", "turbulence", "ridged multifractal", "ridged"),
                                   "Warps": ("domain warp", "domain warping", "domain distortion"),
                                   "Gullies": ("erosion",)},
    "docs/guide/cellular.md": {"Cellular noise: distances, cells and borders": ("Worley", "Worley noise", "Voronoi", "cells")},
    "docs/guide/gpu-computing.md": {"Noise on GPUs: CUDA, OpenCL, PyTorch, JAX": ("CUDA", "NVIDIA", "GPU", "HIP", "ROCm", "tensors")},
    "docs/guide/same-bits.md": {"The same bits on server and client": ("deterministic", "determinism", "multiplayer"),
                                "A server": ("server", "Go", "golang", "Rust", "Java", "C#")},
}
# Pages that are not searched, since the page of their folder is: text to paste in all languages, and rows of measurements.
NOT_SEARCHED = re.compile(r"docs/(?:reference/snippets/hn_\w+|measured/results/.+/\w+)\.md")
# A page as the site has it.
CHANGED = {"docs/guide/tutorial.md": live.with_pictures}
PLAYGROUND = "`playground.html` of a release"  # in pages; the site has it, and a link in its place


def pages(root: Path) -> list[str]:
    """The pages of a site: the README, what lies in docs/, and a few others."""
    return [name for name in files(root) if name.endswith(".md") and
            (name.startswith("docs/") or PACKAGE.fullmatch(name) or name.removesuffix(".md") in ("README", *TOP))]


def ungrouped(names: Iterable[str]) -> list[str]:
    """The pages of docs/ that no group has; those in its folders are found by their README."""
    grouped = {f"docs/{name}.md" for those in GROUPS.values() for name in those}
    return [name for name in names if name.count("/") == 2 and name.startswith("docs/") and name not in grouped]


def index(root: Path = ROOT) -> str:
    """A line for each group, with its pages."""
    if left := ungrouped(pages(root)):
        raise ValueError(f"{', '.join(left)}: no group of tools/lib/ship/website/pages.py has it")
    titles = {name: (root / f"docs/{name}.md").read_text(encoding="utf-8").partition("\n")[0].removeprefix("# ").partition(":")[0]
              for those in GROUPS.values() for name in those}
    return "".join(f"- **{group}**: {' · '.join(f'[{titles[name]}]({name}.md)' for name in those)}\n"
                   for group, those in GROUPS.items())


def table_of_contents(names: Iterable[str]) -> str:
    """The contents of the first page, for the side of each page."""
    def tree(caption: str, entries: Iterable[str]) -> str:
        lines = ["```{toctree}", ":hidden:", f":caption: {caption}", *entries, "```"]
        return "\n" + "".join(f"{line}\n" for line in lines)

    deep = [name.removesuffix(".md") for name in names
            if name.count("/") > 1 and (name.startswith("docs/") or PACKAGE.fullmatch(name))]
    grouped = {f"docs/{name}" for those in GROUPS.values() for name in those}
    text = "".join(tree(caption, [f"docs/{name}" for name in those]) for caption, those in GROUPS.items())
    return text + tree("More", [*TOP, *(name for name in deep if name not in grouped)])


def listing(folder: str, files: Iterable[str]) -> str:
    """A page in place of a folder that a page links to."""
    return f"---\norphan: true\n---\n\n# {folder}\n\n" + "".join(f"- [{name}]({name})\n" for name in files)


def torn_rows(text: str) -> list[str]:
    """Rows of tables with more or fewer cells than their head, such as by a | in code."""
    torn, head = [], 0
    for line in text.splitlines():
        cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else 0
        head = (head or cells) if cells else 0
        if cells != head:
            torn.append(line)
    return torn


def searched(name: str, text: str) -> str:
    """A page with the words by which the search finds its sections, or with a mark that it is not searched."""
    if NOT_SEARCHED.fullmatch(name):
        return f"---\nnosearch: true\n---\n\n{text}"
    for heading, words in WORDS.get(name, {}).items():
        entries = "\n```{index} " + ", ".join(f"! {word}" for word in words) + "\n```\n"  # main ones, which come first
        text, found = re.subn(rf"^#+ {re.escape(heading)}\n", lambda line, of=entries: line[0] + of, text, count=1, flags=re.MULTILINE)
        if not found:
            raise ValueError(f"{name}: no heading {heading!r}, which the search names: change WORDS in pages.py")
    return text


class Copy:
    """Pages, and the files that they link to, in a folder for Sphinx."""

    def __init__(self, root: Path, folder: Path) -> None:
        self.root, self.folder = root, folder

    def keep(self, name: str) -> None:
        """A file as it is, unless it is there."""
        if not (self.folder / name).exists():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.root / name, self.folder / name)

    def target(self, page: str, link: str) -> str:
        """A page's link as it is in the copy."""
        name = posixpath.normpath(posixpath.join(posixpath.dirname(page), link))
        if name == "README.md":
            return posixpath.relpath("index.md", posixpath.dirname(page) or ".")
        if self.root == ROOT and was_deleted(name):
            return f"{address()}/blob/v{version()}/{name}" if address() else ""
        if name.startswith("..") or not (self.root / name).exists() or name.endswith(".md"):
            return link  # Sphinx reports a missing one
        if (self.root / name).is_file():
            self.keep(name)
            return link
        if not (self.root / name / "README.md").exists():
            self.list_folder(name)
        return posixpath.join(link, "README.md")

    def list_folder(self, name: str) -> None:
        inside = [file.removeprefix(f"{name}/") for file in files(self.root) if file.startswith(f"{name}/")]
        for file in inside:
            self.keep(f"{name}/{file}")
        (self.folder / name / "README.md").write_text(listing(name, inside), encoding="utf-8")

    def page(self, name: str, more: str = "") -> None:
        text = (self.root / name).read_text(encoding="utf-8")
        text = searched(name, CHANGED.get(name, str)(text))
        to_playground = posixpath.relpath("playground.html", posixpath.dirname(name) or ".")
        if not is_deleted("playground"):
            text = text.replace(PLAYGROUND, f'<a href="{to_playground}">playground.html</a>')
        text = relinked(text, lambda link: self.target(name, link)) + more
        copied = self.folder / ("index.md" if name == "README.md" else name)
        copied.parent.mkdir(parents=True, exist_ok=True)
        copied.write_text(text, encoding="utf-8")


def write(root: Path, folder: Path, more: str) -> None:
    """All pages, with more at the end of the first one."""
    names = pages(root)
    copy = Copy(root, folder)
    for name in names:
        copy.page(name, more + table_of_contents(names) if name == "README.md" else "")
    for images in (root / "docs").rglob("*.png"):
        copy.keep(os.path.relpath(images, root))
