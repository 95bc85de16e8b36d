"""The text of the library stays within the bounds of each noise, and reaches a part of them: over floats that round in
any direction and over integers, beside the same text over doubles. A noise of the catalog is tested as soon as it has
bounds."""

import functools
import unittest
import zlib
from dataclasses import replace

import numpy as np

from base.thorough import THOROUGH, some
from proof.bounds import kernels, noises, suprema
from proof.bounds import text as proofs
from proof.bounds.features import METRICS
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, SINE
from proof.bounds.noises import phasor
from proof.bounds.noises.perlin import SCALE
from proof.bounds.prover import usual_argument
from proof.bounds.rounded import EXACT, FIXED, NEAREST, SINES, Text, along_axes, roundings
from proof.bounds.table import bounds_of, slope_bounds_of
from proof.bounds.text import rows as every_row

COUNT = {1: 4000, 2: 3000, 3: 2000, 4: 1000}
OF_GRADIENT = {OCTAHEDRAL: (), SINE: (SINES,)}  # macros
CLEAR = 2.0**-10  # how much farther the second point is than the first, where these do not change places
# Which part of a bound random points reach, in floats and in integers, where it is less than usual: a noise that jumps
# has errors at few places, a border one of points that nearly touch, and errors of large numbers seldom add up.
USUAL = (1 / 40, 1 / 15)
PART = {"random": (0, 0), "cell_border": (1 / 40_000, 1 / 20_000), "curl_phase": (1 / 60, 1 / 20)}


# --- Functions and their arguments ------------------------------------------------------------------------------------

@functools.cache
def rows():
    return {key: function for key, function in every_row().items() if function.bound == key[0] in noises.names()}


@functools.cache
def text(gradient, *macros):
    ids = [function.id for function in rows().values() if has(function, gradient)]
    return Text(ids, *OF_GRADIENT[gradient], *macros, optimized=True)


def has(function, gradient):
    return gradient is OCTAHEDRAL or (function.bound, function.axes) in (("perlin", 2), ("perlin", 3))


def cases():
    """With the kind of gradient, and a number."""
    return [(turn, function, gradient) for gradient in OF_GRADIENT for turn, function in enumerate(rows().values())
            if has(function, gradient)]


def near(rng, count, ends, reach=0.5):
    """Those, or numbers beside them."""
    return rng.choice(ends, count) + rng.uniform(-reach, reach, count) * 2.0**-rng.integers(0, 26, count)


ARGUMENTS = {  # by the names of columns
    "c": lambda rng, count: rng.integers(-2**31, 2**31, count),
    "f": lambda rng, count: np.where(rng.random(count) < 0.5, rng.random(count),
                                     near(rng, count, (0.0, 0.5, 1.0))).clip(0, 1),
    "p": lambda rng, count: np.zeros(count),
    "position": lambda rng, count: near(rng, count, (0.0, 0.0, 0.5, -7.0)) * 2.0**rng.integers(-20, 12, count),
    "k": lambda rng, count: np.where(rng.random(count) < 0.5, rng.choice((-16, 16, 32), count),
                                     rng.uniform(-16, 16, count)),
    "phase": lambda rng, count: near(rng, count, np.arange(-8, 9) / 8),
    "jitter": lambda rng, count: np.where(rng.random(count) < 0.3, rng.random(count), 1.0),
    "metric": lambda rng, count: rng.integers(1, 1 + len(METRICS), count),
    "seed": lambda rng, count: rng.integers(0, 2**32, count)}


def columns_of(function):
    rng, columns = np.random.default_rng(zlib.crc32(function.id.encode())), {}
    for one in function.inputs:
        kind = one.name if one.name in ARGUMENTS else one.name[0] if len(one.name) == 2 else "position"
        column = ARGUMENTS[kind](rng, COUNT[function.axes])
        columns[one.name] = column.astype(np.float32).astype(float) if one.type == "f32" else column
    return columns


# --- Errors -----------------------------------------------------------------------------------------------------------

def distances(function, columns):
    """Of the nearest two points, if there are any."""
    base = "cellular_phase" if function.has_phase else "cellular"
    of = rows()[base, function.axes, function.form, "s"]
    usual = {"jitter": 1.0, "metric": 1} | dict.fromkeys(("px", "py", "pz"), 0)
    return text(OCTAHEDRAL)(of.id, EXACT, **{one.name: columns.get(one.name, usual.get(one.name)) for one in of.inputs})


def weights_of(function, columns, kind):
    """By which errors of a result of that kind count: 0 where it jumps nearby."""
    if function.bound == "hex_tiling":
        x, y = ((columns[f"f{axis}"] if function.has_cell else columns[axis] % 1) for axis in "xy")
        return np.min([abs(at - np.rint(at)) for at in (2 * x + y, 2 * y, 2 * x - y)], axis=0) > 2.0**-18
    if function.bound.startswith("cell") and kind in "od":
        first, second = distances(function, columns)
        # of a derivative, times the distance
        return np.where(second - first > CLEAR, first if kind == "d" else 1.0, 0.0)
    return 1.0


def proven(function, name, gradient, fixed):
    """The bound of a result's error, and the limit of its size."""
    if name[0] in "oxy":  # of a vector to a point
        return noises.find(function.bound).offset_error(function.axes, fixed), np.inf
    is_slope = name[0] == "d" and len(name) == 2
    row = slope_bounds_of(function.bound, function.axes) if is_slope else bounds_of(
        function.bound, function.axes, gradient.name)
    if fixed:
        return row.fixed_error, row.fixed_limit
    return row.cell_error if function.has_cell else row.error, row.limit


def ratios(function, gradient, simulated, *macros, columns=None):
    """The largest error of each result over its bound, and the largest size over its limit."""
    columns = columns or columns_of(function)
    exact, found = text(gradient)(function.id, EXACT, **columns), []
    for rounding in simulated:
        results = text(gradient, *macros)(function.id, rounding, **columns)
        for result, (one, right) in enumerate(zip(results, exact)):
            name = function.outputs[result].name
            error, limit = proven(function, name, gradient, FIXED in macros)
            seen = (abs(one - right) * weights_of(function, columns, name[0])).max()
            found.append((seen / error if error else float(seen > 0), abs(one).max() / limit))
    return np.max(found, axis=0)


class Noises(unittest.TestCase):
    def within(self, function, gradient, simulated, *macros):
        with self.subTest(function.id, gradient=gradient.name):
            error, size = ratios(function, gradient, simulated, *macros)
            self.assertTrue(PART.get(function.bound, USUAL)[FIXED in macros] <= error < 1, error)
            self.assertLessEqual(size, 1)

    def test_floats(self):
        for turn, function, gradient in cases():
            self.within(function, gradient, some(roundings(turn), turn, 3))

    def test_integers(self):
        for _, function, gradient in cases():
            self.within(function, gradient, [NEAREST], FIXED)

    def test_every_noise_is_tested(self):
        tested = {(function.bound, function.axes) for function in rows().values() if function.has_cell}
        self.assertEqual({(name, dims) for name in noises.names() for dims, _ in noises.find(name).cases
                          if not name.endswith("_vector_d")}, tested)

    def test_where_a_difference_of_ramps_wraps(self):
        """In space, at corners without a weight, of 1 in 144 cells: its value then does not matter."""
        for noise, result in (("perlin", "v"), ("perlin_d", "d")):
            function = rows()[noise, 3, "cell", result]
            columns = columns_of(function) | {"fx": 0.25, "fy": 1.0, "fz": 1.0}
            self.assertLess(ratios(function, OCTAHEDRAL, [NEAREST], FIXED, columns=columns)[0], 1)

    def test_differences(self):
        """No noise changes faster than is proven, but for those that jump."""
        for _, function, gradient in cases():
            jumps = function.bound in ("random", "hex_tiling") or function.sets == "offset"
            if function.form != "position" or jumps:
                continue
            rng, axes, columns = np.random.default_rng(2), "xyzw"[:function.axes], columns_of(function)
            count = len(columns["x"])
            p = rng.uniform(-4, 4, (function.axes, count))
            q = p + rng.choice((-1, 1), p.shape) * 10**rng.uniform(-5, -2, count)
            both = [columns | dict(zip(axes, at)) for at in (p, q)]
            a, b = (text(gradient)(function.id, EXACT, **of) for of in both)
            for one, other, column in zip(a, b, function.outputs):
                if column.name[0] == "d" and function.bound == "cellular_d":
                    continue  # it jumps
                row = bounds_of(function.bound, function.axes, gradient.name)
                if column.name[0] == "d":
                    row = slope_bounds_of(function.bound, function.axes)
                fastest = (abs(one - other) / abs(p - q).max(axis=0)).max() / row.lipschitz
                with self.subTest(function.id, column=column.name, gradient=gradient.name):
                    self.assertTrue(0.2 < fastest < 1, fastest)


class Boxes(unittest.TestCase):
    """The bound that the text proves for a small box, beside runs in there, from places where they err much to worse
    ones."""

    def ratio(self, case, prover, rng):
        function = next(one for one in rows().values() if one.id == case.job.function)
        gradient, arguments, columns = case.line.gradient or OCTAHEDRAL, dict(case.job.arguments), columns_of(function)
        ends, count = {}, 400

        def placed(at, low, high):
            """Floats; the bound of integers is without the cut of places to a grid."""
            at = np.clip(at, low, high).astype(np.float32)
            return np.floor(at * 2.0**case.job.bits) / 2.0**case.job.bits if case.line.fixed else at

        for column in function.inputs:
            kind, *at = arguments.get(column.name, usual_argument(column)).split(":")
            columns[column.name] = columns[column.name][:count] if kind == "any" else np.full(count, float(at[0]))
            if kind == "box":
                side = 2.0**-rng.integers(1, case.job.bits)
                low = float(at[0]) + rng.integers((float(at[1]) - float(at[0])) / side) * side
                ends[column.name] = low, low + side
                arguments[column.name] = f"box:{low!r}:{low + side!r}"
                columns[column.name] = placed(rng.uniform(low, low + side, count), low, low + side)
        bound = prover.prove([replace(case.job, arguments=arguments, most=1)])[0].bound
        bound += proofs.left_out(*case.key[:2], case.line, case.kind)
        at, worst = [i for i, one in enumerate(function.outputs) if one.name in case.job.outputs], 0.0
        for _ in range(10):
            exact = text(gradient)(function.id, EXACT, **columns)
            runs = [text(gradient, *[FIXED] * case.line.fixed)(function.id, rounding, **columns)
                    for rounding in roundings(int(rng.integers(100)))[5:]]
            counts = weights_of(function, columns, case.job.outputs[0][0])
            off = np.max([abs(run[i] - exact[i]) * counts for run in runs for i in at], axis=0)
            worst, best = max(worst, off.max()), np.argsort(-off)[:count // 8].repeat(8)
            columns = {name: column[best] for name, column in columns.items()}
            for name, (low, high) in ends.items():
                moved = columns[name] + rng.normal(size=count) * (high - low) * 2.0**-rng.integers(1, 12, count)
                columns[name] = placed(moved, low, high)
        return worst / bound

    def test_no_run_leaves_one(self):
        of_all = list(proofs.cases(proofs.usual_lines()))
        provers, rng = proofs.provers_of(of_all), np.random.default_rng(90)
        found = [(self.ratio(case, provers[case.line.macros], rng), case.job) for case in of_all
                 for _ in range(20 if THOROUGH else 2)]
        self.assertEqual([], [each for each in found if not each[0] <= 1])
        self.assertGreater(max(ratio for ratio, _ in found), 0.9)


def of_lattice(dims, gradient, slope, place):
    """How large Perlin or value noise can be, or its derivatives."""
    scale = SCALE[gradient][dims] if gradient else 1
    return scale * suprema.steepest(suprema.SLOPE if slope else suprema.VALUE, gradient, place)


def of_kernel(kernel, gradient, slope, place):
    quantity = kernels.Quantity(((1.0,) + (0.0,) * (kernel.dims - 1),)) if slope else kernels.VALUE
    attained = kernels.attained(kernel, quantity, gradient.support, place * kernel.steps)
    return kernel.scale / 1024 * kernel.steps**slope * attained


def of_waves(kernel, slope, place):
    along = (float(slope), *(0.0,) * (kernel.dims - 1))
    rate = phasor.rate_along(kernel, 1) if slope else 1.0
    return kernel.scale / 1024 * kernel.steps**slope * phasor.attained(kernel, along, rate, place * kernel.steps)


FORMULAS = {  # by which suprema are found
    "perlin": (OCTAHEDRAL, of_lattice), "perlin_phase": (ROTATED, of_lattice), "value": (None, of_lattice),
    "simplex": (OCTAHEDRAL, kernels.SIMPLEX), "simplex_smooth": (OCTAHEDRAL, kernels.SMOOTH),
    "simplex_phase": (ROTATED, kernels.ROTATING), "phasor": (None, phasor.KERNELS)}


class Formulas(unittest.TestCase):
    def test_they_are_those_of_the_text(self):
        """At some places of half a cell, of many: no value and no derivative along x is larger, and some are nearly as
        large."""
        rng = np.random.default_rng(3)
        for (noise, dims, form, result), function in rows().items():
            name = noise.replace("_d", "")
            if form != "cell" or result not in "vqd" or name not in FORMULAS:
                continue
            gradient, of = FORMULAS[name]
            columns, reached, slope = columns_of(function), [], result == "d"
            for place in rng.uniform(0, 0.5 if dims > 2 or of is of_lattice else 0.25, (8, dims, 1)):
                most = (of_lattice(dims, gradient, slope, place) if of is of_lattice
                        else of_waves(of[dims], slope, place)
                        if noise.startswith("phasor") else of_kernel(of[dims], gradient, slope, place))
                waves = dict.fromkeys((name for name in columns if name[0] == "k"), 16.0)
                found = text(OCTAHEDRAL)(function.id, EXACT, **columns | waves | along_axes("f", place))
                seen = found[[one.name for one in function.outputs].index("dx" if slope else function.outputs[0].name)]
                reached.append(abs(seen).max() / most[0])
            with self.subTest(function.id):
                self.assertTrue({1: 0.95, 2: 0.9, 3: 0.5, 4: 0.3}[dims] < max(reached) < 1 + 1e-7, max(reached))
