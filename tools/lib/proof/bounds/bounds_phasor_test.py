"""Tests of the proofs for phasor noise: the text of the library stays within the bounds, and reaches a part of them.
A wrong constant is noticed."""

import functools
import itertools
import unittest
from dataclasses import replace
from unittest import mock

import numpy as np

from proof.bounds import kernel_model
from proof.bounds.boxes import Boxes
from proof.bounds.floats import Approx
from proof.bounds.kernels import Offsets
from proof.bounds.noises import phasor
from proof.bounds.noises.phasor import KERNELS, WAVES
from proof.bounds.rounded import FIXED, Body, Rounding, Text, along_axes, roundings
from proof.bounds.sine import fixed_sines
from proof.bounds.table import bounds_of

AXES = {2: "xy", 3: "xyz"}
MIDDLE = {2: (0.25, 0.0), 3: (0.25, 0.25, 0.25)}  # of two lattice points, in cells: where the weights sum to most


def random_case(seed, dims, count):
    """Cells, fractions, waves and phases: floats. Half of the components of waves are as large as counts; some are
    larger. A third of the places is near lattice points or in the middle of two, where the waves weigh most."""
    rng = np.random.default_rng(seed)
    cells = list(rng.integers(-2**31, 2**31, (dims, count)))
    near = rng.integers(0, 2, (1, count)) / 2 + np.array(MIDDLE[dims])[:, None] * rng.integers(0, 2, (1, count))
    near = near + abs(rng.normal(0, 2.0**-rng.integers(1, 12, count), (dims, count)))
    f = np.where(rng.random(count) < 1 / 3, np.minimum(near, 1), rng.random((dims, count)))
    wave = np.where(rng.random((dims, count)) < 0.5, rng.choice([-WAVES, WAVES, 2 * WAVES], (dims, count)),
                    rng.uniform(-WAVES, WAVES, (dims, count)))
    f, wave, phase = (x.astype(np.float32).astype(float) for x in (f, wave, rng.uniform(-2, 2, count)))
    return cells, f, wave, phase


def below_zero(dims, f):
    """Positions whose fractions round: those near 0, and as many near the middle of two lattice points."""
    rng = np.random.default_rng(9)
    middle = np.array(MIDDLE[dims])[:, None] * rng.integers(0, 2, f.shape[1])
    return -abs(middle - f / 2**rng.integers(1, 20, f.shape[1])).astype(np.float32).astype(float)


def agreeing_words(kernel, wave, angle=0):
    """From a point to its word, with which the angle at MIDDLE is that, whatever the wave: all waves agree there."""
    def words(halves):
        d = np.array(MIDDLE[kernel.dims]) - np.array(halves) / 2 / kernel.steps
        return np.int64(angle - np.round(np.dot(wave, d) * 2**32)) & 0xFFFFFFFF
    return words


def numbers(n):
    """The value and the quadrature of the exact noise."""
    return np.array([n.real, n.imag])


def exactly(dims, cells, f, wave, phase):
    kernel = KERNELS[dims]
    return numbers(kernel_model.phasor(kernel, kernel_model.words_at(kernel, cells), f, wave, phase))


# --- The text of the library ------------------------------------------------------------------------------------------

def body(dims, from_cell, what):
    """From a position, or a cell and a fraction; then the wave and the phase. It calls hn_phasor, or with `what` a part
    of hn_phasor_d."""
    axes = AXES[dims]
    inputs = [f"c{axis}:i32" for axis in axes * from_cell] + [f"{'f' * from_cell}{axis}:f32" for axis in axes]
    inputs += [f"k{axis}:f32" for axis in axes] + ["phase:f32"]
    words = iter([f"{vector}.{axis}" for vector in "abc" for axis in "xyzw"])

    def taken(kind, convert, count=dims):
        return f"{kind}{count}({', '.join(f'{convert}({next(words)})' for _ in range(count))})"
    place = (f"hn_place({taken('ivec', 'int')}, {taken('vec', 'float_of')})" if from_cell else taken("vec", "float_of"))
    arguments = f"{place}, {taken('vec', 'float_of')}, float_of({next(words)}), 0u"
    called = f"hn_phasor_d({arguments}).{what}" if what else f"hn_phasor({arguments})"
    return Body.of(" ".join(inputs), "value:f32 quadrature:f32",
                f"hn_vec2 n = {called}; return uvec4(bits_of(n.x), bits_of(n.y), 0u, 0u);")


@functools.cache
def text(*macros):
    """With the derivatives, for bounds_phasor_d_test.py: reading the library is half of a text's cost."""
    forms = [(dims, form, what) for dims in KERNELS for form in ("cell", "position")
             for what in ("", "value", *(f"d{axis}" for axis in AXES[dims]))]
    weights = {name: Body.of("t:i32 m:i32", "n:i32", f"return uvec4(uint({step}), 0u, 0u, 0u);") for name, step in (
        ("weight", "hn_i_weight_wave(int(a.x))"), ("fall", "hn_i_d_weight_wave(int(a.x), int(a.y))")) if macros}
    return Text([], *macros, **weights,
                **{f"{form}{dims}{what}": body(dims, form == "cell", what) for dims, form, what in forms})


def from_cell(dims, rounding, cells, f, wave, phase, *macros):
    columns = along_axes("c", cells) | along_axes("f", f) | along_axes("k", wave)
    return np.array(text(*macros)(f"cell{dims}", rounding, **columns, phase=phase))


class Exact(unittest.TestCase):
    def test_model_is_what_is_bounded(self):
        """With words that make all waves agree, the value is the sum of the weights, and in the middle of two lattice
        points it is the largest."""
        rng = np.random.default_rng(1)
        for dims, kernel in KERNELS.items():
            f = rng.uniform(0, 0.5, (dims, 3000)) / kernel.steps
            f[:, 0] = MIDDLE[dims]
            still = np.zeros((dims, 3000))
            value = kernel_model.phasor(kernel, lambda _: np.zeros(1), f, still, still[0])
            sums = kernel.scale / 1024 * phasor.attained(kernel, (0.0,) * dims, 1.0, f * kernel.steps)
            self.assertLess(abs(value - sums).max(), 1e-12)
            self.assertTrue(0.99999 * phasor.range_of(kernel) < value.real.max() <= phasor.range_of(kernel))

    def test_scales_leave_little_room(self):
        for dims, kernel in KERNELS.items():
            self.assertTrue(0.9985 < phasor.length(dims) < 1)
            self.assertGreater(phasor.range_of(kernel) * (kernel.scale + 1) / kernel.scale, 1)
            self.assertEqual((bounds_of("phasor", dims, "none").limit, bounds_of("phasor", dims, "none").fixed_limit),
                             (1, 1))

    def test_slopes(self):
        """The steepest waves, where they agree and weigh most, nearly reach the constant; elsewhere none exceeds it."""
        rng, step = np.random.default_rng(2), 1e-7
        for dims, kernel in KERNELS.items():
            words = {point: rng.integers(0, 2**32, 2000) for point in
                     [tuple(kernel_model.halves(point)) for point in kernel_model.points(kernel)]}
            f, wave = rng.random((dims, 2000)), rng.choice([-WAVES, WAVES], (dims, 2000))
            f[:, 0] = MIDDLE[dims]
            for point, of_point in words.items():
                of_point[0] = agreeing_words(kernel, wave[:, 0], 2**30)(point)
            ends = [numbers(kernel_model.phasor(kernel, lambda point: words[tuple(point)],
                                                f + sign * step * np.sign(wave), wave, np.zeros(2000)))
                    for sign in (1, -1)]
            slopes = abs(ends[0] - ends[1]) / (2 * step)
            bound = phasor.lipschitz_of(kernel)
            self.assertTrue(0.9997 * bound < slopes.max() < bound, (slopes.max(), bound))

    def test_shorter_waves(self):
        """The claim of docs/measured/accuracy.md on a quarter of the longest."""
        for kernel in KERNELS.values():
            slower = replace(kernel, waves=WAVES / 4)
            self.assertTrue(0.999 < 4 * phasor.lipschitz_of(slower) / phasor.lipschitz_of(kernel) < 1.004)
            self.assertTrue(0.3 < phasor.error_bound(slower) / phasor.error_bound(kernel) < 0.5)

    def test_weight_by_its_slope(self):
        """The slope is the weight's, and both are within the ends for each range of t."""
        rng, step, weight = np.random.default_rng(11), 1e-6, KERNELS[3].weight
        low, high = np.sort(rng.uniform(0, 1, (2, 4000)), axis=0)
        between = low + (high - low) * np.linspace(0, 1, 65)[:, None]
        (w, slope), (after, _), (before, _) = (kernel_model.weight(KERNELS[3], between + move)
                                               for move in (0, step, -step))
        self.assertLess(abs((after - before) / (2 * step) - slope).max(), 1e-8)
        for order, values in enumerate((w, slope)):
            self.assertLess(abs(weight.derivative(order, between) - values).max(), 1e-13)
            least, largest = weight.ends(order, low, high)
            self.assertTrue((values > least - 1e-13).all() and (values < largest + 1e-13).all())
            self.assertLess(np.mean(largest - least) / np.mean(values.max(axis=0) - values.min(axis=0)), 1.001)

    def test_second_derivatives(self):
        """Waves at random angles, in small boxes, are within the assumptions."""
        rng, step = np.random.default_rng(3), 1e-4
        for dims, kernel in KERNELS.items():
            boxes, angle = Boxes(5, rng.integers(0, 16, (dims, 200))), rng.uniform(0, 2 * np.pi, 200)
            u, rate = (1.0,) * dims, phasor.rate_along(kernel, dims)
            for point in kernel.points:
                def rise(d):
                    t = np.maximum(kernel.radius - kernel.fall * (d * d).sum(axis=0), 0)
                    w, dw = kernel_model.weight(kernel, t)
                    return np.cos(angle) * 2 * kernel.fall * dw * d.sum(axis=0) + np.sin(angle) * rate * w
                middle, offsets = (boxes.lo + boxes.hi) / 2 - np.array(point)[:, None], Offsets.of(kernel, boxes, point)
                for axis, unit in enumerate(np.eye(dims)):
                    moved = step * unit[:, None]
                    second = (rise(middle + moved) + rise(middle - moved) - 2 * rise(middle)) / step**2
                    bound = phasor.second_derivative(kernel, u, rate, offsets, axis)
                    self.assertLess((abs(second) - bound).max(), 1e-3)


def rounded(x, rng, fuse=False):
    """To one of the two floats around it; or not at all, as where a product is fused with a sum."""
    near = x.astype(np.float32)
    others = np.nextafter(near, np.where(x > near, np.inf, -np.inf).astype(np.float32))
    found = np.where((rng.random(x.shape) < 0.5) & (near != x), others, near).astype(float)
    return x if fuse else found


class Weights(unittest.TestCase):
    """The bounds of the steps from t to a weight and its fall: t is off, and steps round."""
    OFF = 2.0**-20  # by so much t is off: far more than in floats, and less than in integers

    def float_errors(self, kernel, rng, exactly, off, fuse):
        """By how much t is off, and then the weight and its fall."""
        t = abs(exactly + off * rng.uniform(-1, 1, exactly.shape)).astype(np.float32).astype(float)
        q = rounded(t * t, rng)
        g = rounded(t - rounded(t * t, rng, True), rng) if fuse else rounded(t - q, rng)
        w = rounded(rounded(rounded(rounded(g * g, rng) * 15, rng, fuse) + q, rng) * t, rng)
        h = rounded(4 * t - rounded(5 * q, rng, fuse), rng)
        fall = rounded(rounded(h * h, rng) * 6 * kernel.fall, rng)
        exact_w, exact_slope = kernel_model.weight(kernel, exactly)
        return abs(t - exactly), abs(w - exact_w), abs(fall - 2 * kernel.fall * exact_slope)

    def float_ratios(self, off, lost=1.0):
        """The largest of errors over the proven ones, of both. With `lost` above 1 the bounds are for finer floats."""
        rng, worst = np.random.default_rng(12), np.zeros(2)
        for kernel, fuse in itertools.product(KERNELS.values(), (False, True)):
            exactly = rng.uniform(0, kernel.radius, 200_000)
            by, *errors = self.float_errors(kernel, rng, exactly, off, fuse)
            t = Approx(exactly, exactly, by, 1.0 / lost)
            proven = kernel.weight.floats(t).err, kernel.weight.float_fall(t, kernel.fall).err
            worst = np.maximum(worst, [(error / bound).max() for error, bound in zip(errors, proven)])
        return worst

    def test_floats(self):
        for off in (0.0, self.OFF):
            worst = self.float_ratios(off)
            self.assertTrue((worst > 1 / 3).all() and (worst < 1).all(), (off, worst))

    def test_fewer_bits_are_noticed(self):
        """A must-fail check: bounds for a float with two bits more."""
        self.assertTrue((self.float_ratios(0.0, 4.0) > 1).all())

    def test_integers(self):
        """Every t, which may be off by a half of its unit: on the way to the weight all are words."""
        t = np.arange(2**16)
        for kernel in KERNELS.values():
            w, fall = (text(FIXED).words(name, Rounding("nearest"), t=t, m=kernel.fall)[0].astype(np.int64)
                       for name in ("weight", "fall"))
            for move in (-0.5, -0.25, 0.0, 0.25, 0.5):
                exactly = np.maximum(t + move, 0) / 2**16
                exact_w, exact_slope = kernel_model.weight(kernel, exactly)
                off = abs(move) / 2**16
                ratios = [(abs(w / 2**18 - exact_w) / kernel.weight.fixed(exactly, exactly, off)).max(),
                          (abs(fall / 2**18 - kernel.fall / 4 * exact_slope)
                           / kernel.weight.fixed_fall(exactly, exactly, off, kernel.fall)).max()]
                self.assertTrue(0.5 < min(ratios) and max(ratios) < 1, (kernel.dims, move, ratios))
        words = phasor.largest_words()
        self.assertTrue(0.99 * 2**32 < max(words.values()) < 2**32)
        self.assertEqual(words["of H"], 65530**2 + 2**15)


class Fixed(unittest.TestCase):
    COUNT = 8000

    def errors(self, dims):
        case = random_case(4, dims, self.COUNT)
        found = from_cell(dims, Rounding("nearest"), *case, FIXED)
        self.assertLessEqual(np.hypot(*found).max(), 1)
        return abs(found - exactly(dims, *case)).max()

    def test_random_points(self):
        for dims in KERNELS:
            bound = bounds_of("phasor", dims, "none").fixed_error
            seen = self.errors(dims)
            self.assertTrue(bound / 3 < seen < bound, (dims, seen, bound))

    def test_fails_with_fewer_bits(self):
        """Must-fail checks: exact waves, phases and weights that are a little other ones."""
        phasor_of, weight = kernel_model.phasor, kernel_model.weight
        for name, other in (("phasor", lambda kernel, words, f, wave, phase: phasor_of(
                                kernel, words, f, np.floor(np.clip(wave, -WAVES, WAVES) * 2**11) / 2**11, phase)),
                            ("phasor", lambda *others: phasor_of(*others[:-1], others[-1] + 2**-13)),
                            ("weight", lambda kernel, t: [(1 + 2**-9) * n for n in weight(kernel, t)])):
            with mock.patch.object(kernel_model, name, other):
                for dims in KERNELS:
                    self.assertGreater(self.errors(dims), bounds_of("phasor", dims, "none").fixed_error, (dims, name))

    def test_no_product_overflows(self):
        """The largest wave, the ends of offsets and all sines reach the sizes that are proven."""
        k, d = int(WAVES * 2**16), np.array([-2**20, -1, 2**20 - 1, 2**20])
        ramp = fixed_sines().max() * 2**13
        for dims in KERNELS:
            largest = phasor.largest_intermediates(dims, None)
            self.assertLess(max(largest.values()), 2**31)
            reached = [abs(k * (d >> 10)).max(), abs(k * (d & 1023)).max(), ramp]
            self.assertEqual(reached, [largest[name] for name in (
                "wave times the high bits", "wave times the low bits", "ramp")])


class Floats(unittest.TestCase):
    """The text of the library over floats of any rounding mode."""

    def test_from_a_cell(self):
        for dims in KERNELS:
            case, bound = random_case(6, dims, 3000), bounds_of("phasor", dims, "none")
            expected = exactly(dims, *case)
            found = [from_cell(dims, rounding, *case) for rounding in roundings(7)]
            seen = max(abs(n - expected).max() for n in found)
            self.assertTrue(bound.cell_error / 8 < seen < bound.cell_error, (dims, seen, bound.cell_error))
            self.assertLessEqual(max(np.hypot(*n).max() for n in found), 1)

    def test_from_a_position(self):
        """Below 0, where the fraction rounds most, and where the noise is steepest."""
        for dims in KERNELS:
            bound, (_, f, wave, phase) = bounds_of("phasor", dims, "none"), random_case(8, dims, 3000)
            p = below_zero(dims, f)
            expected = exactly(dims, [np.full(3000, -1)] * dims, 1 + p, wave, phase)
            columns = along_axes("", p) | along_axes("k", wave) | {"phase": phase}
            seen = max(abs(np.array(text()(f"position{dims}", rounding, **columns)) - expected).max()
                       for rounding in roundings(10))
            self.assertTrue(bound.cell_error / 3 < seen < bound.error, (dims, seen, bound.error))

    def test_fails_with_fewer_bits(self):
        """A must-fail check: a mantissa without 4 of its bits."""
        for dims in KERNELS:
            case = random_case(6, dims, 3000)
            found = from_cell(dims, Rounding("nearest", lost_bits=4), *case)
            self.assertGreater(abs(found - exactly(dims, *case)).max(), bounds_of("phasor", dims, "none").cell_error)


if __name__ == "__main__":
    unittest.main()
