"""The cells of docs/guide/notebook.md, as Jupyter runs them, and their pictures.

    environment.py call --with notebook.txt FOLDER notebook      writes the pictures that the page shows
"""

from __future__ import annotations

import base64
import io
import re
import sys

import golden
import nbclient
import nbformat
from PIL import Image

PAGE = golden.ROOT / "docs" / "guide" / "notebook.md"
CELL = re.compile(r"^```python\n(.*?)^```$", re.M | re.S)
SHOWN = re.compile(r"^!\[[^\]]+\]\((\.\./images/\S+\.png)\)$", re.M)
COLOURS = 48  # more of them make files of noise large


def pictures(*cells: str) -> list[list[bytes]]:
    """The PNGs that each of the cells shows."""
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code) for code in cells])
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    return [[base64.b64decode(output.data["image/png"]) for output in cell.outputs
             if "image/png" in output.get("data", {})] for cell in notebook.cells]


def small(png: bytes) -> Image.Image:
    """As the page shows it: on white, in few colours."""
    whole = Image.open(io.BytesIO(png)).convert("RGBA")
    white = Image.new("RGBA", whole.size, "white")
    return Image.alpha_composite(white, whole).convert("RGB").quantize(COLOURS, Image.Quantize.MAXCOVERAGE, kmeans=3,
                                                                      dither=Image.Dither.NONE)


def made() -> dict[str, Image.Image]:
    """The pictures of the page, by the names of their files."""
    text = PAGE.read_text(encoding="utf-8")
    names = SHOWN.findall(text)
    shown = pictures(*CELL.findall(text))
    if [len(those) for those in shown] != [1] * len(names):
        raise ValueError(f"{PAGE}: each cell shows one picture, which stands below it; here they show "
                         f"{[*map(len, shown)]}, and below stand {len(names)}")
    return {name: small(those[0]) for name, those in zip(names, shown)}


def main() -> int:
    for name, picture in made().items():
        picture.save(PAGE.parent / name, optimize=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
