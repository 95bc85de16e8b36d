"""Hashes of shaders that are not ours, judged in windows: rendered from their GLSL by Mesa's llvmpipe.

A hash is an expression of `c`, the cell as integers, or of `p`, the same as floats. A uint counts as a word. Of a
float, which should be in [0, 1), the ten highest bits count, since shaders use a float as a direction or a colour.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from base.renderer import NotCompiled, Renderer
from measure.hashes import gate, windows
from measure.hashes.judgement import Finding
from measure.noise.noise import read

SIDE = 1024  # of what is rendered at once
# Around the origin; as far as scenes go; where a float has an eighth of a cell left; and far out.
ORIGINS = {2: ((-512, -512), (10000, 20000), (1000000, -2000000), (8000000, 7000000)),
           3: ((-64, -64, -64), (10000, 20000, 5000), (1000000, -2000000, 500000), (8000000, 7000000, 6000000))}
# How a value becomes a word, and the bits of it that are judged.
KINDS = {"uint": ("value", windows.BITS),
         "float": ("uint(clamp(value, 0.0, 0.99999994) * 1024.0) << 22u", windows.BITS[:10])}

# The pixel's cell: along x its column; the rows count the other axes.
FRAGMENT = """
uniform vec4 origin;
uniform vec4 side;
out vec4 halves;
void main() {{
  int row = int(gl_FragCoord.y) + int(side.y);
  ivec{n} c = ivec3(int(origin.x) + int(gl_FragCoord.x) % int(side.x), int(origin.y) + {row},
                    int(origin.z) + {slice}){part};
  vec{n} p = vec{n}(c);
  {kind} value = {expression};
  uint word = {word};
  halves = vec4(float(word >> 16u), float(word & 65535u), 0.0, 0.0);
}}
"""


class BadExpression(ValueError):
    pass


@dataclass(frozen=True)
class Other:
    """A hash of somebody else's: NAME=FILE:EXPRESSION, or NAME/2=... if it is for the plane alone."""
    name: str
    file: Path
    expression: str
    dimensions: tuple[int, ...] = (2, 3)

    @staticmethod
    def parse(text: str) -> Other:
        head, equals, rest = text.partition("=")
        name, slash, only = head.partition("/")
        file, colon, expression = rest.partition(":")
        if not (name and equals and file and colon and expression.strip()) or (slash and only not in ("2", "3")):
            raise argparse.ArgumentTypeError(f"{text} is not NAME=FILE:EXPRESSION, as in sine=random.glsl:random(p)")
        if not Path(file).is_file():
            raise argparse.ArgumentTypeError(f"there is no file {file}")
        return Other(name, Path(file), expression, (int(only),) if slash else (2, 3))


def shader(text: str, expression: str, n: int, kind: str) -> str:
    slices = n == 3
    return "#version 450\n" + text + FRAGMENT.format(
        n=n, part="" if slices else ".xy", kind=kind, expression=expression, word=KINDS[kind][0],
        row="row % int(side.x)" if slices else "row",
        slice="row / int(side.x) * (1024 / int(side.x)) + int(gl_FragCoord.x) / int(side.x)" if slices else "0")


def compiled(renderer: Renderer, other: Other, n: int) -> tuple[int, str]:
    """The program, and whether the expression is a uint or a float."""
    text, logs = read(other.file), []
    for kind in KINDS:
        try:
            return renderer.program(shader(text, other.expression, n, kind)), kind
        except NotCompiled as error:
            logs.append(str(error).strip())
    raise BadExpression(f"{other.name} in {n}D: {other.file} with {other.expression} is neither a uint nor a float of "
                        f"c and p: {logs[-1]}")


def words_of(renderer: Renderer, program: int, origin: tuple[int, ...]) -> np.ndarray:
    """The words of the window at that origin: axis 0 is x."""
    n = len(origin)
    side = gate.SIDES[n]
    rows = side ** n // SIDE
    found = []
    for first in range(0, rows, SIDE):
        pixels = np.array(renderer.draw(program, origin=(*map(float, origin), *(0.0,) * (4 - n)),
                                        side=(float(side), float(first), 0.0, 0.0)), np.float32)
        halves = pixels.reshape(SIDE, SIDE, 4)[..., :2].astype(np.uint32)
        found.append(halves[..., 0] << np.uint32(16) | halves[..., 1])
    words = np.concatenate(found)
    if n == 3:  # rows of a slice, and slices side by side
        beside = SIDE // side
        words = words.reshape(side // beside, side, beside, side).transpose(0, 2, 1, 3).reshape(side, side, side)
    return np.ascontiguousarray(words.transpose())


def judge(other: Other, renderer: Renderer) -> Iterator[tuple[int, str, list[Finding]]]:
    """The findings of every window, with the dimensions and the origin."""
    for n in other.dimensions:
        program, kind = compiled(renderer, other, n)
        for origin in ORIGINS[n]:
            window = windows.Window(words_of(renderer, program, origin), "", KINDS[kind][1])
            yield n, ", ".join(map(str, origin)), windows.judge(window)
