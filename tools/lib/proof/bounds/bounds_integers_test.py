"""Tests of the proofs for the steps of fixed arithmetic, and that nothing wraps: the integers of the proofs are
those of the library's text."""

import functools
import unittest
from unittest import mock

import numpy as np

from base.thorough import THOROUGH
from proof.bounds import command, integers, noises, sine
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.noises import perlin
from proof.bounds.rounded import FIXED, SINES, Body, Rounding, Text

ONE = 2**20  # of fractions
# Steps of the library, by their arguments.
STEPS = {"fade": "hn_i_fade(int(a.x))", "slope": "hn_i_d_fade(int(a.x))", "sine": "hn_i_sine(a.x)",
         "lerp": "hn_i_lerp(int(a.x), int(a.y), int(a.z))"}


@functools.cache
def text():
    return Text([], FIXED, SINES, optimized=True, **{
        name: Body.of("x:u32 y:u32 z:u32", "n:i32", f"return uvec4(uint({step}), 0u, 0u, 0u);")
        for name, step in STEPS.items()})


def step(name, x, y=0, z=0):
    found, = text().words(name, Rounding("nearest"), x=x, y=y, z=z)
    return found.view(np.int32).astype(np.int64)


class Integers(unittest.TestCase):
    def test_fade_and_slope(self):
        f = np.arange(ONE + 1, dtype=np.int64)
        self.assertTrue(np.array_equal(step("fade", f), integers.fades()))
        self.assertTrue(np.array_equal(step("slope", f), integers.slopes()))
        self.assertEqual([integers.fades()[i] for i in (0, 2**19, ONE)], [0, 2**17 - 4, 2**18])
        self.assertEqual([integers.slopes()[i] for i in (0, ONE)], [0, 0])

    def test_lerp_roundings(self):
        rng = np.random.default_rng(7)
        a, b = rng.integers(-2**29, 2**29, (2, 300_000))
        f = rng.integers(0, ONE + 1, 300_000)
        t = integers.fades()[f]
        error = a + (b - a) * t / 2**18 - step("lerp", a, b, t)
        allowed = integers.lerp_roundings()[f]
        self.assertTrue((error <= allowed + 1e-6).all() and (error >= -1e-6 - (t < 0) * allowed).all())
        self.assertGreater((error / np.maximum(allowed, 1)).max(), 0.95)

    def test_nothing_wraps(self):
        """By default of two noises: docs/measured/accuracy.md quotes the largest of all noises, which tools/make bounds
        --check compares."""
        for key in command.keys() if THOROUGH else [("perlin_d_phase", 3, OCTAHEDRAL), ("cellular", 3, None)]:
            for name, value in noises.find(key[0]).largest_intermediates(*key[1:]).items():
                self.assertLess(value, 2**31, (key, name))
        largest = perlin.largest_slope_intermediates(3, 4.0)
        self.assertGreater(largest["derivative's lerp"], 0.9 * 2**31)  # not absurdly far

    def test_wrapping_is_noticed(self):
        with self.assertRaises(OverflowError):
            integers.signed(np.array([2**31]))
        with self.assertRaises(OverflowError):
            integers.word(np.array([-1]))
        with mock.patch.dict(integers.RAMP_ONE, {4: 2**30}):
            self.assertGreater(perlin.largest_slope_intermediates(4, 4.0)["derivative's difference"], 2**31)

    def test_differences_reach_their_bound(self):
        """Ramps in space, and their interpolation along x, at places that are whole along z."""
        rng = np.random.default_rng(13)
        x, y = rng.random((2, 100_000))
        x[0], y[0] = 0.5, 0.0
        ones = np.ones(len(x))

        def both(a):
            return OCTAHEDRAL.support([a, y, ones]) + OCTAHEDRAL.support([a, 1 - y, ones])
        seen, bound = 15 / 8 * (both(x) + both(1 - x)) + 2, perlin.LARGEST_DERIVATIVES_DIFFERENCE[3]
        self.assertTrue(0.99 * bound < seen.max() <= bound + 1e-12, (seen.max(), bound))

    def test_sine(self):
        w = np.random.default_rng(8).integers(0, 2**32, 1_000_000)
        value = step("sine", w) / 2**16
        self.assertLessEqual(abs(value).max(), sine.fixed_sine_largest())
