"""Tests of what is proven of fixed arithmetic: it is simulated from docs/contract.md, and stays within the bounds. Here
are the noises; bounds_integers_test.py has what they are made of, and the octave sums."""

import unittest
from unittest import mock

import numpy as np

from base.thorough import in_thorough_runs
from proof.bounds import exact_model as exact
from proof.bounds import fixed_model as fixed
from proof.bounds import integers, noises, smoothness
from proof.bounds.adverse import adverse_words, changes, random_fractions, random_positions
from proof.bounds.boxes import corners
from proof.bounds.fixed_model import ONE
from proof.bounds.gradients import OCTAHEDRAL, SINE
from proof.bounds.noises.perlin import fixed as perlin
from proof.bounds.noises.perlin.exact import range_bound
from proof.bounds.table import bounds_of, slope_bounds_of

CASES = noises.find("perlin").CASES
DIMS = (1, 2, 3, 4)
COUNT = {1: 100_000, 2: 100_000, 3: 50_000, 4: 25_000}


def proven(kind, dims):
    """What bounds.inc has of hn_perlin."""
    return bounds_of("perlin", dims, kind.name)


class Noise(unittest.TestCase):
    """hn_perlin."""

    def largest_error(self, kind, dims, count, seed):
        """From random positions, with random gradients."""
        p = random_positions(np.random.default_rng(seed), dims, count)
        value = fixed.perlin_at(kind, p) / 2**21
        return abs(value - exact.perlin_at(kind, p)[0]).max(), abs(value).max()

    def test_random_points(self):
        """Their gradients hardly ever conspire: they see 0.2 (sine, 3D) to 0.5 (1D and 2D) of the bound."""
        for dims, kind in CASES:
            seen, largest = self.largest_error(kind, dims, COUNT[dims], 1)
            self.assertLessEqual(largest, proven(kind, dims).fixed_limit)
            self.assertTrue(proven(kind, dims).fixed_error / 8 < seen < proven(kind, dims).fixed_error, (dims, seen))

    def adverse(self, kind, dims, wanted, seed=2, count=10_000):
        """(value, exact value) with adverse gradients; `wanted` maps the fractions to what adverse_words takes."""
        rng = np.random.default_rng(seed)
        fractions = random_fractions(rng, dims, count)
        words_of = adverse_words(rng, kind, fractions, wanted(fractions))
        return (fixed.perlin(kind, words_of, fractions) / 2**21,
                exact.perlin(kind, words_of, [f / ONE for f in fractions])[0])

    @in_thorough_runs
    def test_adverse_gradients(self):
        """They make the error of the fade as negative as it can be, as LERP is. There is no cut here, and of the sine
        no error that adds up."""
        def wanted(fractions):
            change = changes(fractions)
            return lambda corner, offsets: [-change(corner)[0] * d for d in offsets]
        for dims, kind in CASES:
            value, expected = self.adverse(kind, dims, wanted)
            bound = perlin.fixed_error(dims, kind) - perlin.error_parts(dims, kind)["gradient"]
            seen = abs(value - expected).max()
            self.assertTrue(0.4 * bound < seen < bound, (dims, kind.name, seen, bound))

    def test_range(self):
        for dims, kind in CASES:
            value, _ = self.adverse(kind, dims, lambda _: lambda corner, offsets: [-d for d in offsets], 4)
            self.assertLessEqual(abs(value).max(), proven(kind, dims).fixed_limit)
            # On the plane the scale leaves room for gradients that turn.
            self.assertGreater(abs(value).max(), 0.93 * range_bound(dims, kind))

    def test_the_cut(self):
        """A fraction just below the next step."""
        for dims, kind in CASES:
            rng = np.random.default_rng(3)
            fractions = list(rng.integers(0, ONE, (dims, 50_000)))
            words_of = exact.words_at(kind, list(rng.integers(-ONE, ONE, (dims, 50_000))))
            value = fixed.perlin(kind, words_of, fractions) / 2**21
            expected = exact.perlin(kind, words_of, [(f + 1 - 2**-10) / ONE for f in fractions])[0]
            self.assertLess(abs(value - expected).max(), proven(kind, dims).fixed_error)

    def test_range_is_proven(self):
        for dims in DIMS:
            room = 1 - range_bound(dims, OCTAHEDRAL) - perlin.range_loss(dims, OCTAHEDRAL)
            self.assertGreater(room, 32 * 2 * integers.UNIT)  # also that of octave sums
            self.assertEqual(proven(OCTAHEDRAL, dims).fixed_limit, 1)
        for dims in (2, 3):
            limit = range_bound(dims, SINE) + perlin.range_loss(dims, SINE)
            self.assertTrue(limit <= proven(SINE, dims).fixed_limit < limit + 1e-5)

    def test_fails_with_another_fade(self):
        """Must-fail checks: one of fewer bits, one of another polynomial."""
        fade = fixed.fade
        for dims, kind in CASES:
            for other in (lambda f: fade(f & ~1023), lambda f: fade(f) & ~255,
                          lambda f: fade(f) + ((f * (ONE - f)) >> 30)):
                with mock.patch.object(fixed, "fade", other):
                    seen, _ = self.largest_error(kind, dims, 20_000, 5)
                self.assertGreater(seen, 1.05 * proven(kind, dims).fixed_error, (dims, kind.name))

    def test_lattice_points_are_zero(self):
        for dims, kind in CASES:
            cells = list(np.random.default_rng(6).integers(-2**31, 2**31, (dims, 1000)))
            self.assertFalse(fixed.perlin(kind, exact.words_at(kind, cells), [np.zeros(1000, np.int64)] * dims).any())


class Steps(unittest.TestCase):
    """How smooth slopes are, which is measured."""

    def test_coarser_steps_are_measured(self):
        differences, returned = smoothness.measure("perlin", 2, 250)
        fade, slope = fixed.fade, fixed.slope
        with mock.patch.object(fixed, "fade", lambda f: fade(f & ~63)), \
                mock.patch.object(fixed, "slope", lambda f: slope(f & ~63)):
            coarser, coarse = smoothness.measure("perlin", 2, 250)
        self.assertTrue(3 < coarser.rms / differences.rms < 12, (differences, coarser))
        self.assertGreater(coarse.rms, 2 * returned.rms)
        self.assertEqual(coarser.own, differences.own)

    def test_differences_step_by_more_the_nearer_the_pixels_are(self):
        far, near = (smoothness.measure("value", 3, pitch) for pitch in (60, 1000))
        self.assertTrue(14 < near[0].rms / far[0].rms < 18 and 0.8 < near[1].rms / far[1].rms < 1.25, (far, near))


class Derivatives(unittest.TestCase):
    """hn_perlin_d and hn_value_d, whose values are also compared."""

    def largest_error(self, dims, words_of, fractions):
        """Of the derivatives of hn_perlin_d."""
        value, derivatives = fixed.perlin(OCTAHEDRAL, words_of, fractions, derivatives=True)
        self.assertTrue((value == fixed.perlin(OCTAHEDRAL, words_of, fractions)).all())
        _, expected = exact.perlin(OCTAHEDRAL, words_of, [f / ONE for f in fractions])
        self.assertLessEqual(abs(np.array(derivatives)).max() / 2**19, slope_bounds_of("perlin_d", dims).fixed_limit)
        return max(abs(d / 2**19 - e).max() for d, e in zip(derivatives, expected))

    def random_error(self, dims, count):
        rng = np.random.default_rng(7)
        words = {corner: rng.integers(0, 2**32, count) for corner in corners(dims)}
        return self.largest_error(dims, words.__getitem__, random_fractions(rng, dims, count))

    def test_random_gradients(self):
        for dims in DIMS:
            self.assertLess(self.random_error(dims, COUNT[dims] // 4), slope_bounds_of("perlin_d", dims).fixed_error)

    def test_adverse_gradients(self):
        """They make what the fade and its slope change as large as it can be, or the derivative itself."""
        def error(change, corner, d):
            weight, climb = change(corner)
            return [-climb * x - (weight if axis == 0 else 0) for axis, x in enumerate(d)]
        for dims in DIMS:
            rng = np.random.default_rng(8)
            fractions = random_fractions(rng, dims, 10_000)
            change = changes(fractions)
            words_of = adverse_words(rng, OCTAHEDRAL, fractions, lambda corner, d: error(change, corner, d))
            bound = slope_bounds_of("perlin_d", dims).fixed_error
            seen = self.largest_error(dims, words_of, fractions)
            self.assertTrue(0.35 * bound < seen < bound, (dims, seen, bound))

    def test_of_value_noise(self):
        """With numbers at the ends of their range, of signs that make the errors add up, or random ones."""
        for dims in DIMS:
            rng = np.random.default_rng(9)
            fractions = random_fractions(rng, dims, 50_000)
            change = changes(fractions)
            for pick in (0, 1, None):
                words = {corner: rng.integers(0, 2**32, 50_000) if pick is None
                         else np.where(change(corner)[pick] > 0, 0, 2**32 - 1)
                         for corner in corners(dims)}
                value, derivatives = fixed.value(words.__getitem__, fractions)
                expected, slopes = exact.value(words.__getitem__, [f / ONE for f in fractions])
                row, slope_row = bounds_of("value", dims, "none"), slope_bounds_of("value_d", dims)
                errors = abs(value / 2**21 - expected).max(), abs(derivatives[0] / 2**19 - slopes[0]).max()
                self.assertLess(errors[0], row.fixed_error)
                for d, e in zip(derivatives, slopes):
                    self.assertLess(abs(d / 2**19 - e).max(), slope_row.fixed_error)
                self.assertLessEqual(abs(value).max() / 2**21, row.fixed_limit)
                self.assertLessEqual(abs(np.array(derivatives)).max() / 2**19, slope_row.fixed_limit)
                if pick is not None:
                    self.assertGreater(errors[pick], 0.4 * (row, slope_row)[pick].fixed_error, (dims, pick))

    def test_fails_with_another_slope(self):
        """A must-fail check: one of fewer bits."""
        slope = fixed.slope
        with mock.patch.object(fixed, "slope", lambda f: slope(f) & ~511):
            for dims in DIMS:
                self.assertGreater(self.random_error(dims, 20_000), slope_bounds_of("perlin_d", dims).fixed_error)


class Cubic(unittest.TestCase):
    def error(self, dims, count=20_000):
        rng, worst = np.random.default_rng(10), 0.0
        for extreme in (False, True):
            fractions = random_fractions(rng, dims, count)
            words = {}

            def words_of(point):
                return words.setdefault(point, rng.integers(0, 2**32, count) if not extreme
                                        else rng.choice((0, 2**32 - 1), count))
            value = fixed.value_cubic(words_of, fractions)
            expected = exact.value_cubic(words_of, [f / ONE for f in fractions])
            self.assertLessEqual(abs(value).max() / 2**21, bounds_of("value_cubic", dims, "none").fixed_limit)
            worst = max(worst, abs(value / 2**21 - expected).max())
        return worst

    def test_random_points(self):
        for dims in DIMS[:3]:
            bound = bounds_of("value_cubic", dims, "none").fixed_error
            self.assertTrue(bound / 8 < self.error(dims) < bound, (dims, self.error(dims), bound))

    def test_weights(self):
        f = np.arange(ONE + 1, dtype=np.int64)
        self.assertTrue(np.array_equal(np.array(fixed.spline(f)), integers.splines()))
        error = sum(abs(b / 2**18 - e) for b, e in zip(fixed.spline(f), exact.spline((f + 16 >> 5) / 2**15)))
        self.assertTrue(error.max() <= integers.spline_weight_error() < error.max() + 1e-12)

    def test_fails_with_another_spline(self):
        spline = fixed.spline
        with mock.patch.object(fixed, "spline", lambda f: spline(f & ~2047)):
            for dims in DIMS[:3]:
                self.assertGreater(self.error(dims), bounds_of("value_cubic", dims, "none").fixed_error)
