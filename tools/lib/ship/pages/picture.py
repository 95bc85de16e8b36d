"""The pictures of pages: a tile for each line of the code below a picture."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from base.tree import ROOT
from base.twin import SOON, compile_program

PICTURES = {  # the page that shows each
    "noise.png": "docs/reference/noises.md",
    "lattice.png": "docs/reference/noises.md",
    "slopes.png": "docs/reference/noises.md",
    "tiles.png": "docs/reference/noises.md",
    "simplex.png": "docs/reference/noises.md",
    "phase.png": "docs/reference/noises.md",
    "curl.png": "docs/reference/noises.md",
    "phasor.png": "docs/reference/noises.md",
    "gabor.png": "docs/reference/noises.md",
    "vectors.png": "docs/reference/noises.md",
    "cellular.png": "docs/guide/cellular.md",
    "jitter.png": "docs/guide/cellular.md",
    "metrics.png": "docs/guide/cellular.md",
    "cellular-phase.png": "docs/guide/cellular.md",
    "cellular-tiles.png": "docs/guide/cellular.md",
    "sums.png": "docs/reference/fractals.md",
    "gullies.png": "docs/reference/fractals.md",
    "erosion.png": "docs/reference/fractals.md",
    "footprint.png": "docs/reference/fractals.md",
}
BELOW_A_PICTURE = r"^!\[[^\]]*\]\((?:docs/|\.\./)images/{}\)\n\n(?:\S.*\n)*\n((?:    \S.*\n)+)"
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


def in_cpp(code: str) -> str:
    return FLOAT.sub(lambda number: f"{number[0]}f", code)


@dataclass(frozen=True)
class Sheet:
    """A file, and the expressions whose tiles it shows, so many in a row."""
    path: Path
    expressions: Sequence[str]
    columns: int = 100
    side: int = 256  # pixels of a tile


def draw(sheets: Sequence[Sheet], check: bool = False, functions: str = "") -> int:
    """Draws files, or checks that they are these; the exit status of picture.cpp. The functions are GLSL that the
    expressions call."""
    # A tile that several files show is compiled once.
    numbers = {code: number for number, code in enumerate(dict.fromkeys(
        code for sheet in sheets for code in sheet.expressions))}
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "functions.inc").write_text(functions, encoding="utf-8")
        (folder / "tiles.inc").write_text("".join(f"TILE({in_cpp(code)})\n" for code in numbers), encoding="utf-8")
        (folder / "sheets.inc").write_text("".join(
            f'{{{json.dumps(str(sheet.path))}, {sheet.side}, {sheet.columns}, '
            f'{{{", ".join(f"kTiles[{numbers[code]}]" for code in sheet.expressions)}}}}},\n' for sheet in sheets), encoding="utf-8")
        compile_program("the code of the pictures", Path(__file__).with_name("picture.cpp"), folder / "picture", *SOON,
                        "-I", name, "-lpng")
        return subprocess.run([folder / "picture", *(["--check"] if check else [])], check=False).returncode


def of_pages() -> list[Sheet]:
    return [Sheet(path_of(name), tiles((ROOT / page).read_text(encoding="utf-8"), name))
            for name, page in PICTURES.items()]
