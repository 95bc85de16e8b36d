"""Tests of the proof for the sine in floats: the text of the library stays within the bound. Another coefficient is
noticed."""

import functools
import unittest
from unittest import mock

import numpy as np

from proof.bounds import rotations, sine
from proof.bounds.gradients import SINE
from proof.bounds.rounded import MODES, Body, Rounding, Text, roundings


@functools.cache
def text():
    return Text([], optimized=True, quarter_sine=Body.of(
        "q:u32", "sine:f32", "return uvec4(bits_of(hn_i_quarter_sine(a.x)), 0u, 0u, 0u);"), rotation=Body.of(
        "phase:f32", "cosine:f32 sine:f32", "hn_vec2 r = hn_i_rotation(float_of(a.x));"
        "return uvec4(bits_of(r.x), bits_of(r.y), 0u, 0u);"))


class Sine(unittest.TestCase):
    def largest_error(self, rounding, count=20000):
        """Over arguments that the reduction and the shift have moved as far as they may."""
        rng = np.random.default_rng(14)
        near = rng.integers(0, 2**20, count)
        q = np.choose(rng.integers(0, 3, count), [rng.integers(0, 2**30 + 1, count), near, 2**30 - near])
        q = np.minimum(np.where(rng.random(count) < 0.5, q, q | 63), 2**30)
        value, = text()("quarter_sine", rounding, q=q)
        self.assertTrue((value >= 0).all() and (value <= 1).all())
        return abs(value - np.sin(np.pi / 2**31 * (q + rng.choice((-3, 0, 3), count)))).max()

    def test_within_the_contract(self):
        self.assertLess(sine.sine_bound(), 2**-19)
        self.assertEqual(SINE.component_error, 2**-19)
        self.assertLess(sine.sine_largest(), 1)

    def test_simulated(self):
        seen = max(self.largest_error(Rounding(mode, 15, fuse)) for mode in MODES for fuse in (0.0, 0.5))
        self.assertTrue(sine.sine_bound() / 2 < seen < sine.sine_bound())

    def test_polynomial(self):
        seen = sine.sine_truncation(np.linspace(0, 1, 20001)[None]).max()
        self.assertTrue(seen < sine.sine_truncation_bound() < 1.05 * seen)

    def test_fails_with_another_coefficient(self):
        """One that is off in its last digits is refused by the proof."""
        c1, *others = sine.SINE_COEFFICIENTS
        for offset, too_large in ((3e-6, True), (-3e-6, False)):
            with mock.patch.object(sine, "SINE_COEFFICIENTS", (c1 + offset, *others)):
                self.assertGreater(sine.sine_bound(), 2**-19)
                self.assertEqual(sine.sine_largest() > 1, too_large)

    def test_of_a_phase(self):
        angle = np.random.default_rng(16).integers(0, 2**24, 20_000) << 8  # a float has all its bits
        for rounding in roundings(17):
            _, found = text()("rotation", rounding, phase=angle / 2**32)
            self.assertLess(abs(found - np.sin(angle / 2**31 * np.pi)).max(), rotations.float_error())
