"""Tests of the proofs for the steps of fixed arithmetic, and that nothing wraps: the integers of the proofs are
those of the library's text."""

import functools
import math
import unittest
from unittest import mock

import numpy as np

from base.thorough import THOROUGH
from proof.bounds import command, integers, noises, sine, sums
from proof.bounds.boxes import Boxes, corners, fade, fade_derivative
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.noises import perlin, value_cubic
from proof.bounds.noises import value as value_noise
from proof.bounds.rounded import FIXED, Body, Rounding, Text
from proof.bounds.table import bounds_of

CASES = noises.find("perlin").cases
ONE = 2**20  # of fractions
# Steps of the library, by their arguments.
STEPS = {"fade": "hn_i_fade(int(a.x))", "slope": "hn_i_d_fade(int(a.x))", "sine": "hn_i_sine(a.x)",
         "lerp": "hn_i_lerp(int(a.x), int(a.y), int(a.z))",
         **{f"spline{axis}": f"hn_i_spline(int(a.x)).{axis}" for axis in "xyzw"}}


@functools.cache
def text():
    return Text([], FIXED, "HN_GRADIENT=HN_GRADIENT_SINE", optimized=True, **{
        name: Body.of("x:u32 y:u32 z:u32", "n:i32", f"return uvec4(uint({step}), 0u, 0u, 0u);")
        for name, step in STEPS.items()})


def step(name, x, y=0, z=0):
    found, = text().words(name, Rounding("nearest"), x=x, y=y, z=z)
    return found.view(np.int32).astype(np.int64)


def proven(kind, dims):
    """The bounds of hn_perlin in bounds.inc."""
    return bounds_of("perlin", dims, kind.name)


def changes(fractions):
    """From a corner to what the errors of the fades and of the first slope change its weight by, and the derivative of
    its weight along the first axis."""
    f = [x / ONE for x in fractions]
    t, slope = [integers.fades()[x] / 2**18 for x in fractions], integers.slopes()[fractions[0]] / 2**18

    def of_corner(corner):
        def weight(fades):
            return [x if o else 1 - x for x, o in zip(fades, corner)]
        off, exactly = weight(t), weight([fade(x) for x in f])
        sign = 2 * corner[0] - 1
        return (math.prod(off) - math.prod(exactly),
                sign * (slope * math.prod(off[1:]) - fade_derivative(1, f[0]) * math.prod(exactly[1:])))
    return of_corner


class Integers(unittest.TestCase):
    def test_fade_and_slope(self):
        f = np.arange(ONE + 1, dtype=np.int64)
        self.assertTrue(np.array_equal(step("fade", f), integers.fades()))
        self.assertTrue(np.array_equal(step("slope", f), integers.slopes()))
        self.assertEqual([integers.fades()[i] for i in (0, 2**19, ONE)], [0, 2**17 - 4, 2**18])
        self.assertEqual([integers.slopes()[i] for i in (0, ONE)], [0, 0])

    def test_splines(self):
        f = np.arange(ONE + 1, dtype=np.int64)
        self.assertTrue(np.array_equal([step(f"spline{axis}", f) for axis in "xyzw"], integers.splines()))
        error = sum(abs(b / 2**18 - e) for b, e in zip(integers.splines(), value_cubic.weights((f + 16 >> 5) / 2**15)))
        self.assertTrue(error.max() <= integers.spline_weight_error() < error.max() + 1e-12)

    def test_halves_are_mirrored(self):
        """Half of the cell is enough for FADE."""
        errors = np.delete(integers.fade_errors() + integers.fade_errors()[::-1], ONE // 2)
        self.assertLess(abs(errors).max(), 1e-15)
        self.assertTrue(np.array_equal(integers.slopes(), integers.slopes()[::-1]))

    def test_lerp_roundings(self):
        rng = np.random.default_rng(7)
        a, b = rng.integers(-2**29, 2**29, (2, 300_000))
        f = rng.integers(0, ONE + 1, 300_000)
        t = integers.fades()[f]
        error = a + (b - a) * t / 2**18 - step("lerp", a, b, t)
        allowed = integers.lerp_roundings()[f]
        self.assertTrue((error <= allowed + 1e-6).all() and (error >= -1e-6 - (t < 0) * allowed).all())
        self.assertGreater((error / np.maximum(allowed, 1)).max(), 0.95)

    def test_effects_hold_in_boxes(self):
        """FADE of random fractions with their errors, against the bounds of the boxes that they are in."""
        rng = np.random.default_rng(11)
        for dims, level in ((1, 6), (2, 5), (3, 4), (4, 4)):
            fractions = rng.integers(0, ONE // 2 + 1, (dims, 2000))
            boxes = Boxes(level, np.minimum(fractions >> (20 - level), 2 ** (level - 1) - 1))
            change = changes(list(fractions))
            offsets = {corner: fractions / ONE - np.array(corner)[:, None] for corner in corners(dims)}
            value = sum(abs(change(corner)[0]) * OCTAHEDRAL.support(d) for corner, d in offsets.items())
            first = np.eye(dims)[0][:, None]
            slope = sum(OCTAHEDRAL.support(change(corner)[1] * d + change(corner)[0] * first)
                        for corner, d in offsets.items())
            for seen, bound in ((value, integers.fade_effect(boxes, OCTAHEDRAL)),
                                (slope, integers.slope_fade_effect(boxes, OCTAHEDRAL))):
                self.assertLess((seen - bound).max(), 0)
                self.assertGreater((seen / bound).max(), 0.3)
            self.assertLess(value.max(), integers.largest_fade_effect(dims, OCTAHEDRAL))
            self.assertLess(slope.max(), integers.largest_slope_fade_effect(dims, OCTAHEDRAL))

    def test_nothing_wraps(self):
        """By default of two noises: docs/measured/accuracy.md quotes the largest of all noises, which tools/make bounds
        --check compares."""
        for key in command.keys() if THOROUGH else [("perlin_d", 3, OCTAHEDRAL), ("cellular", 3, None)]:
            for name, value in noises.find(key[0]).largest_intermediates(*key[1:]).items():
                self.assertLess(value, 2**31, (key, name))
        for dims, kind in CASES:
            for name, value in sums.largest_octave_intermediates(proven(kind, dims).fixed_limit).items():
                self.assertLess(value, 2**31, (kind.name, dims, name))
        largest = perlin.largest_slope_intermediates(3, 4.0)
        self.assertGreater(largest["derivative's lerp"], 0.9 * 2**31)  # not absurdly far

    def test_wrapping_is_noticed(self):
        with self.assertRaises(OverflowError):
            integers.signed(np.array([2**31]))
        with self.assertRaises(OverflowError):
            integers.word(np.array([-1]))
        with mock.patch.dict(integers.RAMP_ONE, {OCTAHEDRAL: {2: 2**31, 3: 2**30}}):
            self.assertGreater(perlin.largest_intermediates(2, OCTAHEDRAL)["difference"], 2**31)
            self.assertGreater(perlin.largest_slope_intermediates(3, 4.0)["derivative's difference"], 2**31)
        with mock.patch.object(value_noise, "NUMBER_ONE", 2**31):
            self.assertGreater(value_noise.largest_intermediates(2, None)["difference"], 2**31)

    def test_differences_reach_their_bound(self):
        """Ramps in space, and their interpolation along x, at places that are whole along z."""
        rng = np.random.default_rng(13)
        x, y = rng.random((2, 100_000))
        x[0], y[0] = 0.5, 0.0
        s, ones = fade(x), np.ones(len(x))

        def both(a):
            return OCTAHEDRAL.support([a, y, ones]) + OCTAHEDRAL.support([a, 1 - y, ones])
        for seen, bound in (((1 - s) * both(x) + s * both(1 - x), perlin.LARGEST_DIFFERENCE[3]),
                            (15 / 8 * (both(x) + both(1 - x)) + 2, perlin.LARGEST_DERIVATIVES_DIFFERENCE[3])):
            self.assertTrue(0.99 * bound < seen.max() <= bound + 1e-12, (seen.max(), bound))
        largest = perlin.largest_intermediates(3, OCTAHEDRAL)
        self.assertGreater(largest["difference"], perlin.LARGEST_DIFFERENCE[3] * 2**29)

    def test_sine(self):
        w = np.random.default_rng(8).integers(0, 2**32, 1_000_000)
        value = step("sine", w) / 2**16
        error = abs(value - np.sin(w.astype(np.int32).astype(np.float32).astype(float))).max()
        self.assertTrue(0.9 * sine.fixed_sine_error() < error < sine.fixed_sine_error())
        self.assertLessEqual(abs(value).max(), sine.fixed_sine_largest())
