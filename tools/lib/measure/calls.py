"""Calls of packages of PyPI that compute noise on the plane, ours among them, and how long they take.

python.py runs this file by a Python that has the packages; packages that it lacks are left out. Each line of the output
is a call: the noise, the package, its version, and nanoseconds per point in each round. All use one thread. A package
without arrays is called once per point, in a loop of Python. The last lines are of the memory that calls need, in MiB.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import operator
import os
import re
import sys
import time
from ctypes import CDLL
from pathlib import Path

OURS = "hashnoise"
WAYS = {"hashnoise.arrays by jax.jit": "jax", "hashnoise.arrays by torch.compile": "torch"}
SUM = "six octaves of Perlin 2D"
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


# hashnoise.arrays, and beside it Perlin noise as it is usually written for PyTorch: a table of gradients, gathered by a
# table of permuted numbers at the corners of the cells.


def gathered(xp, whole, x, y, table, gradients):
    whole_x, whole_y = xp.floor(x), xp.floor(y)
    cell_x, cell_y, x, y = whole(whole_x), whole(whole_y), x - whole_x, y - whole_y
    ramps = []
    for dx, dy in ((0, 0), (1, 0), (0, 1), (1, 1)):
        g = gradients[table[(table[(cell_x + dx) % 256] + cell_y + dy) % 256] % 8]
        ramps.append(g[..., 0] * (x - dx) + g[..., 1] * (y - dy))
    u, v = (t * t * t * (t * (t * 6 - 15) + 10) for t in (x, y))
    left, right = ramps[0] + u * (ramps[1] - ramps[0]), ramps[2] + u * (ramps[3] - ramps[2])
    return left + v * (right - left)


def _over_arrays(is_ours, arithmetic="fast"):
    def make(module):
        import numpy
        table = numpy.random.default_rng(7).permutation(256)
        angles = numpy.arange(8, dtype=numpy.float32) * numpy.float32(numpy.pi / 4)
        gradients = numpy.stack([numpy.cos(angles), numpy.sin(angles)], axis=-1)
        at = numpy.arange(SIDE, dtype=numpy.float32) * numpy.float32(STEP)
        if module.__name__ == "jax":
            xp, array, compiled, done = module.numpy, module.numpy.asarray, module.jit, module.block_until_ready
            whole = operator.methodcaller("astype", int)
        else:
            module.set_num_threads(1)
            xp, array, compiled, done = module, module.from_numpy, module.compile, lambda array: array
            whole = module.Tensor.long
        x, y, table, gradients = map(array, (at, at[:, None], table, gradients))

        def octaves(x, y):
            if is_ours:
                from hashnoise import arrays
                return arrays.fbm(x, y, octaves=6, seed=7, arithmetic=arithmetic)
            return sum(gathered(xp, whole, x * 2**i, y * 2**i, table, gradients) / 2**i for i in range(6)) / 2
        run = compiled(octaves)

        def call():
            return done(run(x, y))

        if module.__name__ == "jax":  # which keeps memory that it has had
            call.plan = run.lower(x, y).compile().memory_analysis()
        return call, SIDE * SIDE
    return make


MODULES = {**WAYS, "hashnoise.arrays fixed by jax.jit": "jax",
           **{way.replace("hashnoise.arrays", "gathered"): library for way, library in WAYS.items()},
           "pyfastnoiselite": "pyfastnoiselite.pyfastnoiselite", "perlin-numpy": "perlin_numpy"}  # of packages
CALLS = {
    "Perlin 2D": {OURS: _ours("perlin"), "pyfastnoiselite": _fast_noise_lite(1), "noise": _noise(1), "vnoise": _vnoise(1),
                  "perlin-numpy": _perlin_numpy},
    "simplex 2D": {OURS: _ours("simplex"), "pyfastnoiselite": _fast_noise_lite(1, "OpenSimplex2"),
                   "noise": _noise(1, "snoise2"), "opensimplex": _open_simplex},
    SUM: {OURS: _ours("fbm", noise="perlin", octaves=6), "pyfastnoiselite": _fast_noise_lite(6),
          "noise": _noise(6), "vnoise": _vnoise(6), "perlin-numpy": _perlin_numpy_sum,
          **{name: _over_arrays("gathered" not in name, "fixed" if "fixed" in name else "fast") for name in MODULES
             if " by " in name}}}


def memory(run):
    """The most that a call has beside what there was before it, in MiB."""
    if plan := getattr(run, "plan", None):
        return (plan.temp_size_in_bytes + plan.output_size_in_bytes) / 2**20
    CDLL(None).mallopt(-3, 1 << 20)  # large arrays are given back when they are free
    CDLL(None).malloc_trim(0)
    Path("/proc/self/clear_refs").write_text("5")
    before = _status("VmRSS")
    result = run()
    del result
    return (_status("VmHWM") - before) / 1024


def _status(name):
    return int(re.search(rf"{name}:\s*(\d+) kB", Path("/proc/self/status").read_text())[1])


def main(rounds):
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})  # libraries that compile have threads of their own
    calls = []
    for noise, package, make in ((noise, *one) for noise, some in CALLS.items() for one in some.items()):
        try:
            run, points = make(importlib.import_module(MODULES.get(package, package)))
        except ModuleNotFoundError as missing:
            if package == OURS:
                sys.exit(f"{sys.executable} has no package {OURS}")
            if missing.name != MODULES.get(package, package).partition(".")[0]:
                raise  # a package that is here needs another
            continue
        run()  # compilations and imports are not measured
        calls.append(([noise, package, importlib.metadata.version(
            MODULES[package] if " by " in package else package)], run, points))
    for _ in range(rounds):
        for line, run, points in calls:
            run()  # memory that the call before gave back, such as torch's 196 MiB, comes slowly at first
            start = time.perf_counter()
            run()
            line.append(f"{(time.perf_counter() - start) / points * 1e9:.6g}")
    for line, run, _ in calls:
        print(*line, sep=",")
        if line[0] == SUM and (line[1] == OURS or " by " in line[1]):
            print(f"{SUM} in MiB", *line[1:3], *[f"{memory(run):.3g}"] * 3, sep=",")


if __name__ == "__main__":
    main(int(sys.argv[1]))
