"""Tests of the proofs for fixed arithmetic: the text of the library in integers stays within the bounds, and reaches
a part of them. Here are the noises and the octave sums; bounds_integers_test.py has the steps."""

import functools
import unittest
from unittest import mock

import numpy as np

from base.thorough import in_thorough_runs
from proof.bounds import bounds_float_test as floats
from proof.bounds import exact_model as exact
from proof.bounds import integers, smoothness, sums
from proof.bounds.bounds_float_test import CASES, DIMS, proven
from proof.bounds.floats import to_float
from proof.bounds.gradients import OCTAHEDRAL, SINE
from proof.bounds.noises.perlin import fixed as perlin
from proof.bounds.noises.perlin.exact import range_bound
from proof.bounds.rounded import FIXED, Rounding
from proof.bounds.table import bounds_of, slope_bounds_of

NEAREST = Rounding("nearest")


def every_noise():
    """The arguments of Errors.largest, and the bounds of the value and of the derivatives."""
    for dims, kind in CASES:
        yield (("perlin", dims, kind, functools.partial(exact.perlin, kind)), proven(kind, dims),
               slope_bounds_of("perlin_d", dims) if kind is OCTAHEDRAL else None)
    for dims in DIMS:
        yield (("value", dims, OCTAHEDRAL, exact.value), bounds_of("value", dims, "none"),
               slope_bounds_of("value_d", dims))
    for dims in DIMS[:3]:
        yield (("value_cubic", dims, OCTAHEDRAL, lambda words_of, f: (exact.value_cubic(words_of, f), [])),
               bounds_of("value_cubic", dims, "none"), None)


class Noises(floats.Errors, unittest.TestCase):
    MACROS = (FIXED,)

    def test_random_points(self):
        """Their gradients hardly ever conspire."""
        for noise, *bounds in every_noise():
            for seen, bound in zip(self.largest(*noise, 1, [NEAREST]), bounds):
                if bound:
                    self.assertTrue(bound.fixed_error / 15 < seen < bound.fixed_error, (noise, seen, bound))

    def test_fails_with_another_fade(self):
        """Must-fail checks: another polynomial, and another slope of it."""
        fade, slope, spline = exact.fade, exact.slope, exact.spline
        with mock.patch.object(exact, "fade", lambda f: fade(f) + f * (1 - f) / 256), \
                mock.patch.object(exact, "slope", lambda f: slope(f) + 1 / 256), \
                mock.patch.object(exact, "spline", lambda f: [b + 2**-10 for b in spline(f)]):
            for noise, *bounds in every_noise():
                for seen, bound in zip(self.largest(*noise, 2, [NEAREST]), bounds):
                    if bound:
                        self.assertGreater(seen, 1.05 * bound.fixed_error, noise)

    def values(self, name, dims, kind, cells, f):
        value, slopes = self.computed(name, dims, kind, NEAREST, cells, f)
        return np.array([value, *slopes] if not name.endswith("_d") else slopes)

    def test_limits(self):
        rng = np.random.default_rng(4)
        for dims in DIMS:
            f, cells = floats.random_fractions(rng, dims, 20_000), list(rng.integers(-2**31, 2**31, (dims, 20_000)))
            for (name, of, kind, _), value, slope in every_noise():
                if of == dims:
                    self.assertLessEqual(abs(self.values(name, dims, kind, cells, f)).max(), value.fixed_limit)
                    if slope:
                        found = self.values(f"{name}_d", dims, kind, cells, f)
                        self.assertLessEqual(abs(found).max(), slope.fixed_limit)

    def test_where_a_difference_of_ramps_wraps(self):
        """In space, at corners without a weight, of 1 in 144 cells: its value then does not matter."""
        rng, count = np.random.default_rng(5), 20_000
        cells, f = list(rng.integers(-2**31, 2**31, (3, count))), [np.full(count, x) for x in (0.25, 1.0, 1.0)]
        value, slopes = exact.perlin(OCTAHEDRAL, exact.words_at(OCTAHEDRAL, cells), f)
        found, _ = self.computed("perlin", 3, OCTAHEDRAL, NEAREST, cells, f)
        _, found_slopes = self.computed("perlin_d", 3, OCTAHEDRAL, NEAREST, cells, f)
        self.assertLess(abs(found - value).max(), proven(OCTAHEDRAL, 3).fixed_error)
        self.assertLess(abs(np.array(found_slopes) - slopes).max(), slope_bounds_of("perlin_d", 3).fixed_error)

    def test_lattice_points_are_zero(self):
        for dims, kind in CASES:
            cells = list(np.random.default_rng(6).integers(-2**31, 2**31, (dims, 1000)))
            self.assertFalse(self.values("perlin", dims, kind, cells, [np.zeros(1000)] * dims)[0].any())

    def test_range_is_proven(self):
        for dims in DIMS:
            room = 1 - range_bound(dims, OCTAHEDRAL) - perlin.range_loss(dims, OCTAHEDRAL)
            self.assertGreater(room, 32 * 2 * integers.UNIT)  # also the room of octave sums
            self.assertEqual(proven(OCTAHEDRAL, dims).fixed_limit, 1)
        for dims in (2, 3):
            limit = range_bound(dims, SINE) + perlin.range_loss(dims, SINE)
            self.assertTrue(limit <= proven(SINE, dims).fixed_limit < limit + 1e-5)


class Steps(unittest.TestCase):
    """How smooth slopes are, which is measured."""

    def test_differences_step_by_more_the_nearer_the_pixels_are(self):
        far, near = (smoothness.measure("value", 3, pitch) for pitch in (60, 1000))
        self.assertTrue(14 < near[0].rms / far[0].rms < 18 and 0.8 < near[1].rms / far[1].rms < 1.25, (far, near))


class Octaves(floats.OctaveErrors, unittest.TestCase):
    MACROS = (FIXED,)
    tolerance = staticmethod(sums.fixed_octave_tolerance)

    def check(self, arguments, kinds=sums.KINDS, spread=None, seed=9, simulated=None):
        return super().check(arguments, kinds, spread, seed, simulated or [NEAREST])

    def computed(self, rounding, kind, s, p):
        value = super().computed(rounding, kind, s, p)
        self.assertLessEqual(abs(value).max(), proven(kind, len(p)).fixed_limit)
        self.assertTrue(s.kind not in ("turbulence", "clouds", "ridged") or value.min() >= 0)
        return value

    def random_sum(self, rng, name, **others):
        return super().random_sum(rng, name, **({"lacunarity": to_float(rng.uniform(0, 4)), "p_max": 4.0 ** rng.integers(1, 5),
                                                 "gain": to_float(rng.random())} | others))

    @in_thorough_runs
    def test_random_sums(self):
        for seed in range(10):
            self.check(self.random_sum, seed=seed)

    @in_thorough_runs
    def test_far_out(self):
        """Where floats have lost the fraction: the last octave at 2^18, with a lacunarity that is no float near it."""
        self.check(lambda rng, name: self.random_sum(rng, name, octaves=9, lacunarity=to_float(2.1), gain=0.5,
                                                     p_max=1024.0))

    def test_from_a_cell(self):
        self.check(lambda rng, name: self.random_sum(rng, name, from_cell=True))

    @in_thorough_runs
    def test_with_a_period(self):
        def exactly(rng, dims, s):
            return list(rng.integers(-s.p_max * 256, s.p_max * 256, (dims, 200)) / 256)

        def arguments(rng, name, **others):
            return self.random_sum(rng, name, rotates=False, from_cell=True, lacunarity=float(rng.integers(0, 4)),
                                   **others)
        self.check(arguments)
        self.check(lambda rng, name: arguments(rng, name, p_max=16, exact_positions=True), spread=exactly)

    def test_details_and_footprints(self):
        def details(rng, name):
            near = rng.integers(1, 9) + rng.choice((0.0, 2.0**-19, 0.5, rng.random()))
            return self.random_sum(rng, name, octaves=to_float(near))

        def footprints(rng, name):
            return self.random_sum(rng, name, footprint=to_float(rng.random() * 2.0 ** -rng.integers(-1, 8)))
        for arguments in (details, footprints):
            for seed in range(3):
                self.check(arguments, ("fbm",), seed=seed)

    def test_what_is_left_out_is_noticed(self):
        """A must-fail check: positions that are cut, promised exact."""
        with self.assertRaises(AssertionError):
            self.check(lambda rng, name: self.random_sum(rng, name, octaves=9, lacunarity=to_float(3.99), gain=1.0,
                                                         strength=64.0, exact_positions=True), ("fbm", "ping_pong"))


if __name__ == "__main__":
    unittest.main()
