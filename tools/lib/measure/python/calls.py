"""Calls of packages of PyPI that compute noise on the plane, ours among them, and how long they take.

command.py runs this file by a Python that has the packages; packages that it lacks are left out. Each line of the
output is a call: the noise, the package, its version, nanoseconds per point, the time in that of ours, and its spread.
All use one thread. A package without arrays is called once per point, in a loop of Python.
"""

from __future__ import annotations

import csv
import importlib
import importlib.metadata
import statistics
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

OURS = "hashnoise"
SIDE, CELLS = 1024, 16  # pixels and cells along a side
STEP = CELLS / SIDE
FEW = 128  # pixels along a side, for what is called point by point


class Call(NamedTuple):
    noise: str  # the row of the table
    package: str  # on PyPI
    module: str
    make: Callable[..., tuple[Callable[[], object], int]]  # from the module: what is measured, and how many points that is


def _ours(function, **settings):
    def make(hashnoise):
        return (lambda: hashnoise.grid(function, (SIDE, SIDE), step=STEP, seed=7, threads=1, **settings)), SIDE * SIDE
    return make


def _fast_noise_lite(octaves, noise="Perlin"):
    def make(module):
        import numpy
        field = module.FastNoiseLite(7)
        field.noise_type = getattr(module.NoiseType, f"NoiseType_{noise}")
        field.frequency = 1.0
        if octaves > 1:
            field.fractal_type = module.FractalType.FractalType_FBm
            field.fractal_octaves = octaves
        at = numpy.arange(SIDE, dtype=numpy.float32) * numpy.float32(STEP)
        points = numpy.stack(numpy.meshgrid(at, at)).reshape(2, -1)
        return (lambda: field.gen_from_coords(points)), SIDE * SIDE
    return make


def _noise(octaves, function="pnoise2"):
    def make(module):
        call = getattr(module, function)
        places = [(x * STEP, y * STEP) for y in range(FEW) for x in range(FEW)]
        return (lambda: [call(x, y, octaves) for x, y in places]), FEW * FEW
    return make


def _vnoise(octaves):
    def make(module):
        import numpy
        field = module.Noise(7)
        at = numpy.arange(SIDE) * STEP
        return (lambda: field.noise2(at, at, grid_mode=True, octaves=octaves)), SIDE * SIDE
    return make


def _perlin_numpy(octaves):
    def make(module):
        if octaves == 1:
            return (lambda: module.generate_perlin_noise_2d((SIDE, SIDE), (CELLS, CELLS))), SIDE * SIDE
        return (lambda: module.generate_fractal_noise_2d((SIDE, SIDE), (CELLS, CELLS), octaves)), SIDE * SIDE
    return make


def _open_simplex(module):
    import numpy
    at = numpy.arange(FEW) * STEP
    return (lambda: module.noise2array(at, at)), FEW * FEW


CALLS = (
    Call("Perlin 2D", "hashnoise", "hashnoise", _ours("perlin")),
    Call("Perlin 2D", "pyfastnoiselite", "pyfastnoiselite.pyfastnoiselite", _fast_noise_lite(1)),
    Call("Perlin 2D", "noise", "noise", _noise(1)),
    Call("Perlin 2D", "vnoise", "vnoise", _vnoise(1)),
    Call("Perlin 2D", "perlin-numpy", "perlin_numpy", _perlin_numpy(1)),
    Call("simplex 2D", "hashnoise", "hashnoise", _ours("simplex")),
    Call("simplex 2D", "pyfastnoiselite", "pyfastnoiselite.pyfastnoiselite", _fast_noise_lite(1, "OpenSimplex2")),
    Call("simplex 2D", "noise", "noise", _noise(1, "snoise2")),
    Call("simplex 2D", "opensimplex", "opensimplex", _open_simplex),
    Call("six octaves of Perlin 2D", "hashnoise", "hashnoise", _ours("fbm", noise="perlin", octaves=6)),
    Call("six octaves of Perlin 2D", "pyfastnoiselite", "pyfastnoiselite.pyfastnoiselite", _fast_noise_lite(6)),
    Call("six octaves of Perlin 2D", "noise", "noise", _noise(6)),
    Call("six octaves of Perlin 2D", "vnoise", "vnoise", _vnoise(6)),
    Call("six octaves of Perlin 2D", "perlin-numpy", "perlin_numpy", _perlin_numpy(6)),
)


def measured(rounds: int) -> dict[Call, list[float]]:
    """Each call of a package that is here, and its seconds per point in each round. All are called in turns."""
    calls = []
    for call in CALLS:
        try:
            run, points = call.make(importlib.import_module(call.module))
        except ImportError:
            continue
        run()  # what is compiled or imported at first is not measured
        calls.append((call, run, points))
    seconds: dict[Call, list[float]] = {call: [] for call, _, _ in calls}
    for _ in range(rounds):
        for call, run, points in calls:
            start = time.perf_counter()
            run()
            seconds[call].append((time.perf_counter() - start) / points)
    return seconds


def rows(found: Mapping[Call, Sequence[float]]) -> Iterator[list[str]]:
    for call, seconds in found.items():
        ours = next(times for other, times in found.items() if (other.noise, other.package) == (call.noise, OURS))
        ratios = [theirs / our for theirs, our in zip(seconds, ours)]
        low, _, high = statistics.quantiles(ratios)
        yield [call.noise, call.package, importlib.metadata.version(call.package),
               f"{statistics.median(seconds) * 1e9:.3g}", f"{statistics.median(ratios):.3g}", f"{(high - low) / 2:.2g}"]


if __name__ == "__main__":
    found = measured(int(sys.argv[1]))
    if not any(call.package == OURS for call in found):
        sys.exit(f"{sys.executable} has no package {OURS}")
    csv.writer(sys.stdout, lineterminator="\n").writerows(rows(found))
