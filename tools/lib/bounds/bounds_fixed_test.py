"""Tests of what is proven of fixed arithmetic: it is simulated from docs/contract.md, and stays within the bounds."""

import math
import unittest
from unittest import mock

import numpy as np

from bounds import command, integers, noises, sine, sums
from bounds import fixed_model as bounds_fixed_model
from bounds.fixed_model import (exact_at, exact_gradient, exact_noise, exact_noise_at, exact_octaves, fixed_clouds,
                                fixed_fade, fixed_lerp, fixed_noise, fixed_noise_at, fixed_noise_at_cell, fixed_octaves,
                                fixed_ramp, fixed_sine, moved, sine_argument, weights)
from bounds.gradients import GRADIENTS, OCTAHEDRAL, SINE
from bounds.noises.perlin import fixed as perlin
from bounds.noises.perlin.exact import library_range, sine_range
from bounds.table import bounds_of

DIMS = (2, 3)
NOISES = tuple((kind, dims) for kind in GRADIENTS for dims in DIMS)


def proven(kind, dims):
    """What bounds.inc has of hn_perlin."""
    return bounds_of("perlin", dims, kind.name)


# --- Points -----------------------------------------------------------------------------------------------------------

def random_positions(rng, dims, count, reach=64.0):
    """Floats, many of them near lattice lines and on both sides of 0."""
    p = rng.uniform(-reach, reach, (dims, count))
    near = rng.random((dims, count)) < 0.3
    p = np.where(near, np.round(p) + rng.uniform(-0.06, 0.06, (dims, count)), p)
    return list(p.astype(np.float32).astype(float))


def steep_parts(dims, axis, sign, last_sign):
    """The gradient of the library nearest to sign * e_axis; `last_sign` is that of the last offset."""
    if dims == 2:
        return [np.where(axis == 0, 511 * sign, 1), np.where(axis == 0, last_sign, 511 * sign)]
    return [np.where(axis == 2, 1, 255 * sign), np.where(axis == 2, 1, np.where(axis == 0, 255 * sign, -255 * sign)),
            np.where(axis == 2, 255 * sign, last_sign)]


def adverse_parts(kind, fractions, wanted):
    """For each corner the gradient that makes the error of the fade as negative as it can be: `wanted` is the sign of
    the corner's g.d, or a function of the corner and what the fade changes its weight by."""
    exact = [f / 2**20 for f in fractions]
    s = [f**3 * (f * (f * 6 - 15) + 10) for f in exact]
    t = [fixed_fade(f) / 2**18 for f in fractions]

    def parts(corner):
        change = (math.prod(x if o else 1 - x for x, o in zip(t, corner))
                  - math.prod(x if o else 1 - x for x, o in zip(s, corner)))
        offsets = np.array([f - o for f, o in zip(exact, corner)])
        sign = wanted(change)
        if kind is SINE:
            return [np.where(offset * sign < 0, -2**16, 2**16) for offset in offsets]
        axis = abs(offsets).argmax(axis=0)
        along = np.take_along_axis(offsets, axis[None], 0)[0]
        direction = np.where(along * sign < 0, -1, 1)
        return steep_parts(len(fractions), axis, direction, np.where(offsets[-1] * sign < 0, -1, 1))
    return parts


class Noise(unittest.TestCase):
    RANDOM = {2: 800_000, 3: 400_000}

    def largest_error(self, kind, dims, count, seed, fade=fixed_fade):
        """From random positions, with random gradients."""
        rng, largest = np.random.default_rng(seed), 0.0
        for _ in range(count // 100_000):
            p = random_positions(rng, dims, 100_000)
            with mock.patch.object(bounds_fixed_model, "fixed_fade", fade):
                value = fixed_noise_at(kind, p) / 2**21
            self.assertLessEqual(abs(value).max(), proven(kind, dims).fixed_limit)
            largest = max(largest, abs(value - exact_noise_at(kind, p)).max())
        return largest

    def adverse(self, kind, dims, wanted, seed, count=200_000):
        """(value, exact) with adverse gradients, of which half have fractions near a corner of the cell."""
        rng = np.random.default_rng(seed)
        fractions = rng.integers(0, 2**20 + 1, (dims, count))
        near = rng.integers(0, 2**16, (dims, count // 2))
        fractions[:, ::2] = np.where(rng.random(near.shape) < 0.5, near, 2**20 - near)
        parts = adverse_parts(kind, list(fractions), wanted)
        value = fixed_noise(kind, parts, list(fractions)) / 2**21
        scale = 2**16 if kind is SINE else 1
        exact = exact_noise(kind, lambda corner: ([part / scale for part in parts(corner)] if kind is SINE
                                                  else exact_gradient(kind, parts(corner))),
                            [f / 2**20 for f in fractions])
        return value, exact

    def test_random_points(self):
        """Their gradients hardly ever conspire: they see 0.21 (sine, 3D) to 0.53 (octahedral, 2D) of the bound."""
        for kind, dims in NOISES:
            seen = self.largest_error(kind, dims, self.RANDOM[dims], 1)
            self.assertLess(seen, proven(kind, dims).fixed_error)
            self.assertGreater(seen, proven(kind, dims).fixed_error / 6)

    def test_adverse_gradients(self):
        """They reach 0.51 to 0.69 of the bound without the error of the sine; there is no cut here, either."""
        for kind, dims in NOISES:
            value, exact = self.adverse(kind, dims, lambda change: np.where(change > 0, -1, 1), 2)
            parts = perlin.error_parts(dims, kind)
            bound = perlin.fixed_error(dims, kind) - parts["gradient"]
            seen = abs(value - exact).max()
            self.assertLess(seen, bound)
            self.assertGreater(seen, 0.5 * bound)

    def test_the_cut(self):
        """A fraction just below the next step."""
        for kind, dims in NOISES:
            rng = np.random.default_rng(3)
            fractions = rng.integers(0, 2**20, (dims, 100_000))
            cells = list(rng.integers(-2**20, 2**20, (dims, 100_000)))
            value = fixed_noise_at_cell(kind, cells, list(fractions)) / 2**21
            exact = exact_noise(kind, lambda corner: exact_at(kind, moved(cells, corner), np.int64(0)),
                                [(f + 1 - 2**-10) / 2**20 for f in fractions])
            self.assertLess(abs(value - exact).max(), proven(kind, dims).fixed_error)

    def test_range(self):
        for kind, dims in NOISES:
            value, _ = self.adverse(kind, dims, lambda change: -1, 4)
            self.assertLessEqual(abs(value).max(), proven(kind, dims).fixed_limit)
            self.assertGreater(abs(value).max(), 0.98 * proven(kind, dims).fixed_limit)

    def test_range_is_proven(self):
        for dims in DIMS:
            room = 1 - library_range(dims) - perlin.range_loss(dims, OCTAHEDRAL)
            self.assertGreater(room, 32 * 2 * integers.UNIT)  # also that of octave sums
            self.assertEqual(proven(OCTAHEDRAL, dims).fixed_limit, 1)
            limit = sine_range(dims) + perlin.range_loss(dims, SINE)
            self.assertTrue(limit <= proven(SINE, dims).fixed_limit < limit + 1e-5)

    def test_fails_with_another_fade(self):
        """Must-fail checks: one of fewer bits, one of another polynomial."""
        for kind, dims in NOISES:
            for fade in (lambda f: fixed_fade(f & ~1023), lambda f: fixed_fade(f) & ~255,
                         lambda f: fixed_fade(f) + ((f * (2**20 - f)) >> 30)):
                seen = self.largest_error(kind, dims, 100_000, 5, fade)
                self.assertGreater(seen, 1.05 * proven(kind, dims).fixed_error)

    def test_lattice_points_are_zero(self):
        for kind, dims in NOISES:
            cells = list(np.random.default_rng(6).integers(-2**31, 2**31, (dims, 1000)))
            self.assertFalse(fixed_noise_at_cell(kind, cells, [np.zeros(1000, np.int64)] * dims).any())


class Integers(unittest.TestCase):
    def test_fade(self):
        f = np.arange(2**20 + 1, dtype=np.int64)
        self.assertTrue(np.array_equal(fixed_fade(f), integers.fades()))
        self.assertEqual([fixed_fade(f)[i] for i in (0, 2**19, 2**20)], [0, 2**17 - 4, 2**18])

    def test_lerp_roundings(self):
        rng = np.random.default_rng(7)
        a, b = rng.integers(-2**29, 2**29, (2, 300_000))
        f = rng.integers(0, 2**20 + 1, 300_000)
        t = fixed_fade(f)
        exact = a + (b - a) * t / 2**18
        error = exact - fixed_lerp(a, b, t)
        allowed = integers.lerp_roundings()[f]
        self.assertTrue((error <= allowed + 1e-6).all() and (error >= -1e-6 - (t < 0) * allowed).all())
        self.assertGreater((error / np.maximum(allowed, 1)).max(), 0.95)

    def test_nothing_wraps(self):
        for key in command.keys():
            for name, value in noises.find(key[0]).largest_intermediates(*key[1:]).items():
                self.assertLess(value, 2**31, (key, name))
        for kind, dims in NOISES:
            for name, value in sums.largest_octave_intermediates(proven(kind, dims).fixed_limit).items():
                self.assertLess(value, 2**31, (kind.name, dims, name))
        self.assertGreater(perlin.largest_intermediates(2, OCTAHEDRAL)["scaled"], 2**30)  # not absurdly far

    def test_wrapping_is_noticed(self):
        with self.assertRaises(OverflowError):
            integers.signed(np.array([2**31]))
        with self.assertRaises(OverflowError):
            integers.word(np.array([-1]))
        with mock.patch.dict(perlin.RAMP_ONE, {OCTAHEDRAL: 2**31}):
            self.assertGreater(perlin.largest_intermediates(2, OCTAHEDRAL)["difference"], 2**31)

    def test_ramps_reach_their_bound(self):
        big, step = 2**20, np.arange(2)
        self.assertEqual(fixed_ramp(OCTAHEDRAL, [511, 1], [big, big]), 2**29)
        self.assertEqual(fixed_ramp(OCTAHEDRAL, [255, 255, 1], [big, 0 * big, big]), 2**29)
        self.assertTrue((fixed_ramp(SINE, [2**16 + 0 * step] * 3, [big] * 3) == 3 * 2**28).all())

    def test_sine(self):
        w = np.random.default_rng(8).integers(0, 2**32, 1_000_000)
        exact = np.sin(sine_argument(w).astype(float))
        value = fixed_sine(w) / 2**16
        self.assertTrue(0.9 * sine.fixed_sine_error() < abs(value - exact).max() < sine.fixed_sine_error())
        self.assertLessEqual(abs(value).max(), sine.fixed_sine_largest())

    def test_clouds(self):
        v = np.arange(-2**21, 2**21 + 1)
        t = np.clip(2 * v / 2**21 + 0.25, 0, 1)
        error = abs(fixed_clouds(v) / 2**21 - t * t * (3 - 2 * t)).max()
        self.assertTrue(0.9 * sums.cloud_error() < error < sums.cloud_error())
        self.assertEqual((fixed_clouds(v).min(), fixed_clouds(v).max()), (0, 2**21))


class Octaves(unittest.TestCase):
    def check(self, rng, parameters, count=2000):
        """The largest ratio of an error to its tolerance, which it must not exceed."""
        worst = 0.0
        for kind, dims in NOISES:
            for name in ("fbm", "turbulence", "clouds"):
                octaves, lacunarity, gain, reach, exact = parameters()
                p = random_positions(rng, dims, count, reach)
                if exact:
                    p = [np.round(x * 2**9) / 2**9 for x in p]
                value = fixed_octaves(kind, name, p, octaves, lacunarity, gain) / 2**21
                error = abs(value - exact_octaves(kind, name, p, octaves, lacunarity, gain)).max()
                tolerance = sums.fixed_octave_tolerance(name, proven(kind, dims), reach, octaves, lacunarity, gain,
                                                        exact)
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
        self.assertGreater(max(self.check(rng, parameters) for _ in range(3)), 1 / 5)

    def test_far_out(self):
        """Where floats have lost the fraction: the last octave at 2^18, with a lacunarity that is no float near it."""
        rng = np.random.default_rng(10)
        self.check(rng, lambda: (9, float(np.float32(2.1)), 0.5, 1024.0, False))

    def test_exact_positions(self):
        self.check(np.random.default_rng(11), lambda: (8, 2.0, 0.5, 16.0, True))

    def test_cut_arguments(self):
        for arguments in ((2, 256.0, 0.5), (2, -1.0, 0.5), (2, 2.0, 1.5), (33, 2.0, 0.5)):
            tolerance = sums.fixed_octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, *arguments, False)
            self.assertEqual(tolerance, math.inf)
        self.assertEqual(sums.fixed_octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, 0, 2.0, 0.5, False), 0)
        with self.assertRaises(ValueError):
            sums.fixed_octave_tolerance("fog", proven(OCTAHEDRAL, 2), 1.0, 1, 2.0, 0.5, False)

    def test_weights(self):
        for gain in (0.0, 0.3, 0.5, 0.999, 1.0):
            self.assertEqual(weights(32, gain), sums.fixed_weights(32, gain))
