"""The README's picture: a tile for each line of the code below it."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from tree import ROOT
from twin import compile_program

PICTURE = ROOT / "docs" / "images" / "noise.png"
BELOW_THE_PICTURE = re.compile(r"^!\[[^\]]*\]\(docs/images/noise\.png\)\n\n(?:\S.*\n)*\n((?:    \S.*\n)+)", re.MULTILINE)
FLOAT = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.])")  # without a suffix it is a float in GLSL, and a double in C++


def tiles(readme: str) -> list[str]:
    """The code below the picture, an expression for each tile from the left; a comment may follow it."""
    found = BELOW_THE_PICTURE.search(readme)
    if found is None:
        raise ValueError("README.md has no code below its picture: write a line for each tile, indented by 4 spaces")
    return [line.partition("//")[0].strip() for line in found[1].splitlines()]


def draw(expressions: Sequence[str], path: Path = PICTURE, check: bool = False) -> int:
    """Draws the tiles into a PNG file, or checks that this is what it shows; the exit status of picture.cpp."""
    lines = [f"TILE({FLOAT.sub(lambda number: f'{number[0]}f', code)})\n" for code in expressions]
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "tiles.inc").write_text("".join(lines), encoding="utf-8")
        compile_program("the code below the README's picture", Path(__file__).with_name("picture.cpp"),
                        folder / "picture", "-I", name, "-lpng")
        return subprocess.run([folder / "picture", *(["--check"] if check else []), path], check=False).returncode
