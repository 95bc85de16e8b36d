"""The pictures of pages: a tile for each line of the code below a picture."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from tree import ROOT
from twin import compile_program

PICTURES = {  # the page that shows each
    "noise.png": "README.md",
    "lattice.png": "docs/noises.md",
    "slopes.png": "docs/noises.md",
    "tiles.png": "docs/noises.md",
    "simplex.png": "docs/noises.md",
    "phase.png": "docs/noises.md",
    "curl.png": "docs/noises.md",
    "cellular.png": "docs/cellular.md",
    "jitter.png": "docs/cellular.md",
    "metrics.png": "docs/cellular.md",
    "cellular-tiles.png": "docs/cellular.md",
    "sums.png": "docs/sums.md",
    "footprint.png": "docs/sums.md",
}
BELOW_A_PICTURE = r"^!\[[^\]]*\]\((?:docs/)?images/{}\)\n\n(?:\S.*\n)*\n((?:    \S.*\n)+)"
FLOAT = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.])")  # without a suffix it is a float in GLSL, and a double in C++


def path_of(name: str) -> Path:
    return ROOT / "docs" / "images" / name


def tiles(page: str, name: str) -> list[str]:
    """The code below a picture, an expression for each tile from the left; a comment may follow it."""
    found = re.search(BELOW_A_PICTURE.format(re.escape(name)), page, re.MULTILINE)
    if found is None:
        raise ValueError(f"{PICTURES[name]} has no code below its picture {name}: write a line for each tile, indented "
                         "by 4 spaces")
    return [line.partition("//")[0].strip() for line in found[1].splitlines()]


def draw(expressions: Sequence[str], path: Path, check: bool = False) -> int:
    """Draws the tiles into a PNG file, or checks that this is what it shows; the exit status of picture.cpp."""
    lines = [f"TILE({FLOAT.sub(lambda number: f'{number[0]}f', code)})\n" for code in expressions]
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "tiles.inc").write_text("".join(lines), encoding="utf-8")
        compile_program(f"the code below the picture {path.name}", Path(__file__).with_name("picture.cpp"),
                        folder / "picture", "-I", name, "-lpng")
        return subprocess.run([folder / "picture", *(["--check"] if check else []), path], check=False).returncode
