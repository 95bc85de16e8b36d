"""Tests of what is proven of the steps of fixed arithmetic, that nothing wraps, and of its octave sums. They are
simulated from docs/contract.md."""

import math
import unittest
from unittest import mock

import numpy as np

from bounds import command, integers, noises, sine, sums
from bounds import exact_model as exact
from bounds import fixed_model as fixed
from bounds.adverse import adverse_words, changes, random_fractions, random_positions
from bounds.boxes import Boxes, corners
from bounds.fixed_model import ONE
from bounds.gradients import OCTAHEDRAL
from bounds.noises import value as value_noise
from bounds.noises.perlin import fixed as perlin
from bounds.table import bounds_of

CASES = tuple((dims, kind) for dims, kind in noises.find("perlin").CASES if dims in sums.SHIFT_MAX)  # of octave sums
DIMS = (1, 2, 3, 4)


def proven(kind, dims):
    """What bounds.inc has of hn_perlin."""
    return bounds_of("perlin", dims, kind.name)


class Integers(unittest.TestCase):
    def test_fade_and_slope(self):
        f = np.arange(ONE + 1, dtype=np.int64)
        self.assertTrue(np.array_equal(fixed.fade(f), integers.fades()))
        self.assertTrue(np.array_equal(fixed.slope(f), integers.slopes()))
        self.assertEqual([fixed.fade(f)[i] for i in (0, 2**19, ONE)], [0, 2**17 - 4, 2**18])
        self.assertEqual([fixed.slope(f)[i] for i in (0, ONE)], [0, 0])

    def test_halves_are_mirrored(self):
        """Half of the cell is enough for FADE."""
        errors = np.delete(integers.fade_errors() + integers.fade_errors()[::-1], ONE // 2)
        self.assertLess(abs(errors).max(), 1e-15)
        self.assertTrue(np.array_equal(integers.slopes(), integers.slopes()[::-1]))

    def test_lerp_roundings(self):
        rng = np.random.default_rng(7)
        a, b = rng.integers(-2**29, 2**29, (2, 300_000))
        f = rng.integers(0, ONE + 1, 300_000)
        t = fixed.fade(f)
        error = a + (b - a) * t / 2**18 - fixed.lerp(a, b, t)
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
        for key in command.keys():
            for name, value in noises.find(key[0]).largest_intermediates(*key[1:]).items():
                self.assertLess(value, 2**31, (key, name))
        for dims, kind in CASES:
            for name, value in sums.largest_octave_intermediates(proven(kind, dims).fixed_limit).items():
                self.assertLess(value, 2**31, (kind.name, dims, name))
        largest = perlin.largest_slope_intermediates(3)
        self.assertGreater(largest["derivative's lerp"], 0.9 * 2**31)  # not absurdly far

    def test_wrapping_is_noticed(self):
        with self.assertRaises(OverflowError):
            integers.signed(np.array([2**31]))
        with self.assertRaises(OverflowError):
            integers.word(np.array([-1]))
        with mock.patch.dict(perlin.RAMP_ONE, {OCTAHEDRAL: {2: 2**30, 3: 2**30}}):
            self.assertGreater(perlin.largest_intermediates(2, OCTAHEDRAL)["difference"], 2**31)
            self.assertGreater(perlin.largest_slope_intermediates(3)["derivative's difference"], 2**31)
        with mock.patch.object(value_noise, "NUMBER_ONE", 2**31):
            self.assertGreater(value_noise.largest_intermediates(2, None)["difference"], 2**31)

    def test_the_model_does_not_wrap(self):
        """A signed step of the model that wrapped would be far off; here each is compared with its own wide integer."""
        rng, largest = np.random.default_rng(12), [0]

        def recorded(x):
            largest[0] = max(largest[0], int(np.abs(x).max()))
            return exact.s32(x)
        with mock.patch.object(fixed, "s32", recorded):
            for dims in DIMS:
                fractions = random_fractions(rng, dims, 10_000)
                steep = adverse_words(rng, OCTAHEDRAL, fractions,
                                      lambda corner, d: [(1 - 2 * (sum(corner) % 2)) * x for x in d])
                fixed.perlin(OCTAHEDRAL, steep, fractions, derivatives=True)
                ends = {corner: rng.choice((0, 2**32 - 1), 10_000) for corner in corners(dims)}
                fixed.value(ends.__getitem__, fractions)
        self.assertTrue(2**30 < largest[0] < 2**31)

    def test_ramps_reach_their_bound(self):
        big, none = np.array([ONE]), np.array([0])

        def word(a, b=0, bits=9):
            """Of the fields a, and b in space."""
            return np.array([(a + 511) // 2 << 22 if bits == 9 else (a + 255) // 2 << 23 | (b + 255) // 2 << 15])
        self.assertEqual(fixed.ramp(OCTAHEDRAL, word(511), [big]), 511 * 2**20)
        middle = fixed.ramp(OCTAHEDRAL, word(257), [big, big])
        self.assertTrue(1.497 * 2**29 < middle <= 1.5 * 2**29)
        third = fixed.ramp(OCTAHEDRAL, word(171, 1, 8), [big, big, big])
        self.assertTrue(1.66 * 2**29 < third <= 5 / 3 * 2**29)
        self.assertEqual(fixed.ramp(OCTAHEDRAL, np.array([0]), [big, big, none, none]), 2 * 2**28)

    def test_sine(self):
        w = np.random.default_rng(8).integers(0, 2**32, 1_000_000)
        value = fixed.sine(w) / 2**16
        error = abs(value - np.sin(exact.sine_argument(w).astype(float))).max()
        self.assertTrue(0.9 * sine.fixed_sine_error() < error < sine.fixed_sine_error())
        self.assertLessEqual(abs(value).max(), sine.fixed_sine_largest())

    def test_clouds(self):
        v = np.arange(-2**21, 2**21 + 1)
        t = np.clip(2 * v / 2**21 + 0.25, 0, 1)
        error = abs(fixed.clouds(v) / 2**21 - t * t * (3 - 2 * t)).max()
        self.assertTrue(0.9 * sums.cloud_error() < error < sums.cloud_error())
        self.assertEqual((fixed.clouds(v).min(), fixed.clouds(v).max()), (0, 2**21))


class Octaves(unittest.TestCase):
    def check(self, parameters, count=2000, seed=9):
        """The largest ratio of an error to its tolerance, which it must not exceed."""
        rng, worst = np.random.default_rng(seed), 0.0
        for dims, kind in CASES:
            for name in ("fbm", "turbulence", "clouds"):
                octaves, lacunarity, gain, reach, known = parameters()
                p = random_positions(rng, dims, count, reach)
                if known:
                    p = [np.round(x * 2**9) / 2**9 for x in p]
                value = fixed.octaves(kind, name, p, octaves, lacunarity, gain) / 2**21
                error = abs(value - exact.octaves(kind, name, p, octaves, lacunarity, gain)).max()
                tolerance = sums.fixed_octave_tolerance(name, proven(kind, dims), reach, octaves, lacunarity, gain,
                                                        known)
                self.assertLess(error, tolerance)
                worst = max(worst, error / tolerance)
                self.assertLessEqual(abs(value).max(), proven(kind, dims).fixed_limit)
                self.assertTrue(name == "fbm" or value.min() >= 0)
        return worst

    def test_simulated(self):
        rng = np.random.default_rng(9)

        def parameters():
            return (int(rng.integers(1, 9)), float(np.float32(rng.uniform(0, 4))), float(np.float32(rng.random())),
                    2.0 ** rng.integers(2, 8), False)
        self.assertGreater(max(self.check(parameters, seed=seed) for seed in range(3)), 1 / 5)

    def test_far_out(self):
        """Where floats have lost the fraction: the last octave at 2^18, with a lacunarity that is no float near it."""
        self.check(lambda: (9, float(np.float32(2.1)), 0.5, 1024.0, False))

    def test_exact_positions(self):
        self.check(lambda: (8, 2.0, 0.5, 16.0, True))

    def test_cut_arguments(self):
        for arguments in ((2, 256.0, 0.5), (2, -1.0, 0.5), (2, 2.0, 1.5), (33, 2.0, 0.5)):
            tolerance = sums.fixed_octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, *arguments, False)
            self.assertEqual(tolerance, math.inf)
        self.assertEqual(sums.fixed_octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, 0, 2.0, 0.5, False), 0)
        with self.assertRaises(ValueError):
            sums.fixed_octave_tolerance("fog", proven(OCTAHEDRAL, 2), 1.0, 1, 2.0, 0.5, False)

    def test_weights(self):
        for gain in (0.0, 0.3, 0.5, 0.999, 1.0):
            self.assertEqual(fixed.octave_weights(32, gain), sums.fixed_weights(32, gain))
