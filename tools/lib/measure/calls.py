"""Calls of packages of PyPI that compute noise on the plane, ours among them, and how long they take.

python.py runs this file by a Python that has the packages; packages that it lacks are left out. Each line of the output
is a call: the noise, the package, its version, and nanoseconds per point in each round. All use one thread. A package
without arrays is called once per point, in a loop of Python.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import sys
import time

OURS = "hashnoise"
SIDE, CELLS = 1024, 16  # pixels and cells along a side
STEP = CELLS / SIDE
FEW = 128  # pixels along a side, for calls point by point

# The makers return a call of a module, and how many points it computes.


def _ours(function, **settings):
    return lambda hashnoise: (
        lambda: hashnoise.grid(function, (SIDE, SIDE), step=STEP, seed=7, threads=1, **settings), SIDE * SIDE)


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
        field, at = module.Noise(7), numpy.arange(SIDE) * STEP
        return (lambda: field.noise2(at, at, grid_mode=True, octaves=octaves)), SIDE * SIDE
    return make


def _perlin_numpy(module):
    return (lambda: module.generate_perlin_noise_2d((SIDE, SIDE), (CELLS, CELLS))), SIDE * SIDE


def _perlin_numpy_sum(module):
    return (lambda: module.generate_fractal_noise_2d((SIDE, SIDE), (CELLS, CELLS), 6)), SIDE * SIDE


def _open_simplex(module):
    import numpy
    at = numpy.arange(FEW) * STEP
    return (lambda: module.noise2array(at, at)), FEW * FEW


MODULES = {"pyfastnoiselite": "pyfastnoiselite.pyfastnoiselite", "perlin-numpy": "perlin_numpy"}  # of packages
CALLS = {
    "Perlin 2D": {OURS: _ours("perlin"), "pyfastnoiselite": _fast_noise_lite(1), "noise": _noise(1), "vnoise": _vnoise(1),
                  "perlin-numpy": _perlin_numpy},
    "simplex 2D": {OURS: _ours("simplex"), "pyfastnoiselite": _fast_noise_lite(1, "OpenSimplex2"),
                   "noise": _noise(1, "snoise2"), "opensimplex": _open_simplex},
    "six octaves of Perlin 2D": {OURS: _ours("fbm", noise="perlin", octaves=6), "pyfastnoiselite": _fast_noise_lite(6),
                                 "noise": _noise(6), "vnoise": _vnoise(6), "perlin-numpy": _perlin_numpy_sum}}


def main(rounds):
    calls = []
    for noise, package, make in ((noise, *one) for noise, some in CALLS.items() for one in some.items()):
        try:
            run, points = make(importlib.import_module(MODULES.get(package, package)))
        except ImportError:
            if package == OURS:
                sys.exit(f"{sys.executable} has no package {OURS}")
            continue
        run()  # compilations and imports are not measured
        calls.append(([noise, package, importlib.metadata.version(package)], run, points))
    for _ in range(rounds):
        for line, run, points in calls:
            start = time.perf_counter()
            run()
            line.append(f"{(time.perf_counter() - start) / points * 1e9:.6g}")
    for line, _, _ in calls:
        print(*line, sep=",")


if __name__ == "__main__":
    main(int(sys.argv[1]))
