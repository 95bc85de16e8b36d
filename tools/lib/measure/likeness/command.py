"""Finds the scale and the factor with which a call of ours looks like one of another library.

    tools/measure likeness FILE THEIRS OURS [--axes N]

    tools/measure likeness noise2D.glsl 'snoise(p)' 'hn_simplex(p, 7u)'

THEIRS is a float of a position p, by the GLSL in FILE and in the files that it includes; OURS is one by this library. A
size is the distance, in cells, at which the correlation of two values has fallen to 1/2. The command prints the call that
has the size, the deviation and the mean of theirs. It needs Debian's libegl1 and libgl1. docs/guide/moving.md has such calls of several
libraries, and docs/measured/results/llvmpipe/likeness.csv the numbers of its rows.

Exit status: 0 they look alike, 1 they do not even so, 2 bad usage.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from base.renderer import NotCompiled
from base.usage import Parser
from catalog.tables.glsl import files_of
from measure.noise.noise import Sampler, Subject, read
from translate.single_file.files import text

LIMIT = 0.06  # so far may the deviation and the size be from theirs: the rounding of numbers, and 1% for the places
# Places lie in a cube of this size, in cells: many features, and less than the 289 after which webgl-noise repeats.
CELLS = 250
FIRST = 0.8  # cells; this distance is doubled until the correlation is less than 1/2
NEAR = 0.002  # so well is a size known


class Look(NamedTuple):
    mean: float
    deviation: float
    size: float


def our_library(calls: str, axes: int) -> str:
    """The files of the calls, as all files take a second to compile."""
    files = [file for name in re.findall(r"\bhn_\w+", calls) for file in files_of(name) if file.endswith(f"{axes}d.glsl")]
    return text(list(dict.fromkeys(files)), strip=True)


def look(source: str, expression: str, axes: int) -> Look:
    """The look of an expression of p in the source."""
    sampler = Sampler(Subject(expression, source, expression, axes))
    here = sampler.random(0.0, CELLS, 0)[0].astype(float)

    def correlation(distance: float) -> float:
        there = sampler.random(0.0, CELLS, 0, away=distance)[0].astype(float)
        with np.errstate(invalid="ignore"):
            return float(np.corrcoef(here, there)[0, 1])

    return Look(float(here.mean()), float(here.std()), half(correlation))


def half(correlation: Callable[[float], float]) -> float:
    """The distance where the correlation is 1/2."""
    far = FIRST
    while not (at := correlation(far)) <= 0.5:
        if np.isnan(at) or far > 1000.0:
            raise ValueError("it does not vary, or is no number somewhere")
        far *= 2.0
    return brentq(lambda distance: correlation(distance) - 0.5 if distance else 0.5, 0.0, far, xtol=NEAR)


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
    axes, library = options.axes, our_library(options.ours, options.axes)
    try:
        theirs = look(read(options.file), options.theirs, axes)
        ours = look(library, options.ours, axes)
        scale, factor = ours.size / theirs.size, theirs.deviation / ours.deviation
        port = ported(options.ours, scale, factor, theirs.mean - factor * ours.mean)
        found = look(library, port, axes)
    except (NotCompiled, OSError, ValueError) as error:
        parser.error(str(error))
    for name, one in (("theirs", theirs), ("ours", ours), (port, found)):
        print(f"{name}: mean {one.mean:.3f}, deviation {one.deviation:.3f}, size {one.size:.3f}")
    return int(not all(abs(now / then - 1.0) <= LIMIT for now, then in zip(found[1:], theirs[1:])))


if __name__ == "__main__":
    sys.exit(main())
