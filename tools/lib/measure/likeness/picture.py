"""Pictures of their noise and ours, side by side."""

from __future__ import annotations

import re
from pathlib import Path

from base.png import png
from base.renderer import Renderer
from measure.likeness.measure import Look, subject, vector
from measure.likeness.ports import Port, measured_call, source
from measure.likeness.table import Row

TILE = 256
CELLS = 8  # along a side of a tile
SQUARES = 8  # along a side of the last tile
# A slice of noise in space is tilted, as one across an axis has the contrast of its height.
PLACE = """
out vec4 likeness_values;
void main() {{
  vec2 uv = {cells} * gl_FragCoord.xy / {tile};
  vec4 place = vec4(uv, 0.4 + 0.37 * uv.x + 0.53 * uv.y, 0.6 + 0.29 * uv.x - 0.41 * uv.y);
  likeness_values = vec4(likeness_subject({vector}(place)));
}}
"""


def tile(renderer: Renderer, text: str, expression: str, axes: int, look: Look) -> bytes:
    """Greys: four deviations of the look to each side of its mean, so that tiles of one look can be compared."""
    place = PLACE.format(cells=f"{CELLS}.0", tile=f"{TILE}.0", vector=vector(axes))
    pixels = renderer.draw(renderer.program(subject(text, expression, axes) + place))[::4]
    greys = bytearray()
    for y in reversed(range(TILE)):
        for value in pixels[y * renderer.side:y * renderer.side + TILE]:
            greys.append(round(255.0 * min(max(0.5 + (value - look.mean) / (8.0 * look.deviation), 0.0), 1.0)))
    return bytes(greys)


def squares(first: bytes, second: bytes) -> bytes:
    """A board of both, by turns: where one cannot distinguish the squares, they look alike."""
    size = TILE // SQUARES
    return bytes((first if (i // TILE // size + i % TILE // size) % 2 == 0 else second)[i] for i in range(TILE * TILE))


def draw(renderer: Renderer, row: Row, found: Port, path: Path, ours: str, folder: Path) -> Path:
    """Theirs, ours as it is, ours as ported, and a board of the first and the last. ours: the source that it needs."""
    theirs = source(path / row.file if row.file else path)
    ported = measured_call(row, found.scale, found.factor, found.offset)
    tiles = [tile(renderer, text, expression, row.axes, found.theirs)
             for text, expression in ((theirs, row.expression), (ours, measured_call(row)), (ours, ported))]
    tiles.append(squares(tiles[0], tiles[2]))
    greys = b"".join(each[y * TILE:(y + 1) * TILE] for y in range(TILE) for each in tiles)
    file = folder / f"{re.sub('[^a-z0-9]+', '-', found.id.lower())}.png"
    file.write_bytes(png(len(tiles) * TILE, TILE, bytes(grey for grey in greys for _ in range(3))))
    return file
