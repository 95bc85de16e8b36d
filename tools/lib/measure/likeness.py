"""Finds the scale and the factor with which a call of ours looks like one of another library.

    tools/measure likeness FILE THEIRS OURS [--axes N]

    tools/measure likeness noise2D.glsl 'snoise(p)' 'hn_simplex(p, 7u)'

THEIRS is a float of a position p, by the GLSL in FILE and in the files that it includes; OURS is one by this library. A
size is the distance, in cells, at which the correlation of two values has fallen to 1/2. The command prints the call that
has the size, the deviation and the mean of theirs. It needs libOSMesa. docs/guide/moving.md has such calls of several
libraries, and docs/measured/results/llvmpipe/likeness.csv the numbers of its rows.

Exit status: 0 they look alike, 1 they do not even so, 2 bad usage.
"""

from __future__ import annotations

import hashlib
import math
import re
import subprocess
from array import array
from collections.abc import Callable, Sequence
from operator import mul
from pathlib import Path
from typing import NamedTuple

from base.renderer import NotCompiled, Renderer
from base.usage import Parser
from catalog.tables.glsl import files_of
from translate.single_file.files import text

LIMIT = 0.06  # so far may the deviation and the size be from theirs: the rounding of numbers, and 1% for the places
# Places lie in a cube of this size, in cells: many features, and less than the 289 after which webgl-noise repeats.
CELLS = 250
# In which the size is looked for, in cells. It is doubled until the correlation is less than 1/2.
FIRST = 0.8
ROUNDS = 3  # of dividing by four: the size is then known to 1/64 of 0.4, and within that by a straight line
INCLUDE = re.compile(r'^\s*#include "(.*)"')

SHADER = """#version 450
SOURCE
uniform vec4 likeness_lags;  // three distances, and how many values are wanted: four
out vec4 likeness_values;

float likeness_subject(VECTOR p) { return EXPRESSION; }

float likeness_random(inout uint state) {  // O'Neill's PCG
  state = state * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (float((word >> 22) ^ word) + 0.5) / 4294967296.0;
}

void main() {
  uint state = uint(gl_FragCoord.y) * 65536u + uint(gl_FragCoord.x);
  likeness_random(state);
  VECTOR p, direction;
  for (int i = 0; i < AXES; ++i) {
    p[i] = CELLS.0 * likeness_random(state);
    // Normal numbers have no preferred direction, in any number of dimensions.
    float radius = sqrt(-2.0 * log(likeness_random(state)));
    direction[i] = radius * cos(6.2831853 * likeness_random(state));
  }
  direction = normalize(direction);
  // A loop that no compiler unrolls, since four copies of a noise take four times as long to compile.
  for (int i = 0; i < int(likeness_lags.w); ++i) {
    float lag = i == 0 ? 0.0 : likeness_lags[i - 1];
    likeness_values[i] = likeness_subject(p + lag * direction);
  }
}
"""


class Look(NamedTuple):
    mean: float
    deviation: float
    size: float


def source(path: Path) -> str:
    """GLSL without #version lines, and with the files that it includes."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if included := INCLUDE.match(line):
            lines.append(source(path.parent / included[1]))
        elif not line.lstrip().startswith("#version"):
            lines.append(line)
    return "\n".join(lines)


def version(path: Path) -> str:
    """The commit of a file in a repository of git, or the name that git would give to its content."""
    printed = subprocess.run(["git", "-C", path.parent, "log", "-1", "--format=%h of %cs", "HEAD"],
                             capture_output=True, text=True, check=False)
    if printed.returncode == 0:
        return printed.stdout.strip()
    content = path.read_bytes()
    return f"blob {hashlib.sha1(b'blob %d%c' % (len(content), 0) + content).hexdigest()[:10]}"


def our_library(calls: str, axes: int) -> str:
    """The files of the calls, as all files take a second to compile."""
    files = [file for name in re.findall(r"\bhn_\w+", calls) for file in files_of(name) if file.endswith(f"{axes}d.glsl")]
    return text(list(dict.fromkeys(files)), strip=True)


def look(renderer: Renderer, source_: str, expression: str, axes: int) -> Look:
    """The look of an expression of p in the source."""
    words = {"SOURCE": source_, "EXPRESSION": expression, "VECTOR": f"vec{axes}" if axes > 1 else "float",
             "AXES": str(axes), "CELLS": str(CELLS)}
    program = renderer.program(re.sub("|".join(words), lambda word: words[word[0]], SHADER))
    first: list[tuple[float, float]] = []

    def correlations(*lags: float) -> list[float]:
        pixels = renderer.draw(program, likeness_lags=(*lags, 4.0))
        here, *there = (pixels[i::4] for i in range(4))
        mean, deviation = moments(here)
        if not first:
            first.append((mean, deviation))
        found = []
        for values in there:
            other_mean, other_deviation = moments(values)
            product = sum(map(mul, here, values)) / len(here)
            found.append((product - mean * other_mean) / (deviation * other_deviation))
        return found

    size = half(correlations)
    return Look(*first[0], size)


def moments(values: array[float]) -> tuple[float, float]:
    mean = sum(values) / len(values)
    return mean, math.sqrt(max(sum(map(mul, values, values)) / len(values) - mean * mean, 1e-30))


def half(correlations: Callable[..., list[float]]) -> float:
    """Where the correlation is 1/2, of a function that has it at three distances."""
    low, high, at_low, at_high = 0.0, FIRST, 1.0, correlations(FIRST, FIRST, FIRST)[0]
    while not at_high <= 0.5:
        if not high <= 1000.0 or math.isnan(at_high):
            raise ValueError("it does not vary, or is no number somewhere")
        low, high, at_low = high, 2.0 * high, at_high
        at_high = correlations(high, high, high)[0]
    for _ in range(ROUNDS):
        lags = [low + (high - low) * i / 4.0 for i in range(5)]
        values = [at_low, *correlations(*lags[1:4]), at_high]
        end = next(i for i in range(1, 5) if values[i] <= 0.5)
        low, high, at_low, at_high = lags[end - 1], lags[end], values[end - 1], values[end]
    return low + (high - low) * (at_low - 0.5) / (at_low - at_high)


def ported(ours: str, scale: float, factor: float, offset: float) -> str:
    call = re.sub(r"\bp\b", f"({scale:.2f} * p)", ours)
    return f"{offset:.2f} + " * (abs(offset) >= 0.005) + f"{factor:.2f} * {call}"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure likeness", __doc__)
    parser.add_argument("file", type=Path, metavar="FILE")
    parser.add_argument("theirs", metavar="THEIRS")
    parser.add_argument("ours", metavar="OURS")
    parser.add_argument("--axes", type=int, choices=range(1, 5), default=2, metavar="N", help="of p (%(default)s)")
    options = parser.parse_args(arguments)
    renderer, axes = Renderer(), options.axes
    library = our_library(options.ours, axes)
    try:
        theirs = look(renderer, source(options.file), options.theirs, axes)
        ours = look(renderer, library, options.ours, axes)
        scale, factor = ours.size / theirs.size, theirs.deviation / ours.deviation
        port = ported(options.ours, scale, factor, theirs.mean - factor * ours.mean)
        found = look(renderer, library, port, axes)
    except (NotCompiled, OSError, ValueError) as error:
        parser.error(str(error))
    for name, one in (("theirs", theirs), ("ours", ours), (port, found)):
        print(f"{name}: mean {one.mean:.3f}, deviation {one.deviation:.3f}, size {one.size:.3f}")
    return int(not all(abs(now / then - 1.0) <= LIMIT for now, then in zip(found[1:], theirs[1:])))
