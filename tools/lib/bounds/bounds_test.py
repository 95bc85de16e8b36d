"""Tests perlin.py, and that documents and sources state the numbers that tools/bounds derives."""

import itertools
import math
import random
import unittest

import numpy as np

from bounds import fixed as bounds_fixed
from bounds import floats as bounds_float
from bounds import perlin as bounds
from bounds.reference import contract_gradient, exact_noise, exact_noise_at
from tree import ROOT

DIMS = (2, 3)
NOISES = tuple(itertools.product(bounds.GRADIENTS, DIMS))


class Range(unittest.TestCase):
    def test_below_one_even_with_the_float_error(self):
        for dims in DIMS:
            largest = bounds.range_bound(dims, bounds.SCALE[dims]) + bounds.OCTAHEDRAL.error[dims]
            self.assertLess(largest, bounds.OCTAHEDRAL.limit[dims])
            self.assertEqual(bounds.OCTAHEDRAL.limit[dims], 1)

    def test_limit_of_the_sine_gradient(self):
        for dims in DIMS:
            largest, limit = bounds.sine_range(dims) + bounds.SINE.error[dims], bounds.SINE.limit[dims]
            self.assertTrue(largest <= limit < largest + 1e-5)
            self.assertEqual(limit, round(limit, 5))

    def test_sine_range_is_that_of_the_sum(self):
        """Attained in the middle of the cell, and nowhere more."""
        def supremum(f):
            weights = {corner: math.prod(bounds.fade(t) if o else 1 - bounds.fade(t) for t, o in zip(f, corner))
                       for corner in bounds.corners(len(f))}
            return sum(w * sum(abs(t - o) for t, o in zip(f, corner)) for corner, w in weights.items())
        rng = random.Random(13)
        for dims in DIMS:
            self.assertEqual(supremum((0.5,) * dims), bounds.sine_range(dims))
            for _ in range(5000):
                total = supremum([0.5 + rng.uniform(-0.5, 0.5) ** rng.choice((1, 3, 9)) for _ in range(dims)])
                self.assertLess(total, bounds.sine_range(dims) + 1e-12)

    def test_attained(self):
        for dims in DIMS:
            value, point, gradients = bounds.range_witness(dims)
            self.assertEqual(point, tuple(map(bounds_float.to_float, point)))
            self.assertAlmostEqual(float(value), exact_noise(point, gradients.__getitem__), delta=1e-14)
            bound = bounds.library_range(dims)
            self.assertTrue(bound - 1e-5 < value < bound < bounds.range_bound(dims, bounds.SCALE[dims]) - 4e-4)

    def test_known_suprema(self):
        self.assertAlmostEqual(bounds.range_bound(2, 1), 0.5352764390514959, delta=2e-9)
        self.assertAlmostEqual(bounds.range_bound(3, 1), 0.5629016051291905, delta=2e-9)

    def test_fails_with_a_larger_scale(self):
        for dims in DIMS:
            self.assertGreater(bounds.range_bound(dims, 1.02 * bounds.SCALE[dims]), 1)
            self.assertGreater(1.02 * bounds.range_witness(dims)[0], 1)

    def test_unfolded_sum_stays_below(self):
        """The sum over the corners as it stands, over the whole cube: the folding and nesting lose nothing."""
        rng = random.Random(1)
        for dims in DIMS:
            bound = bounds.range_bound(dims, 1)
            for _ in range(5000):
                f = [rng.random() for _ in range(dims)]
                total = sum(math.prod(bounds.fade(t) if o else 1 - bounds.fade(t) for t, o in zip(f, corner))
                            * max(abs(t - o) for t, o in zip(f, corner)) for corner in bounds.corners(dims))
                self.assertLessEqual(total, bound)

    @staticmethod
    def library_gradients(dims):
        """All of them: the sign and 9 bits in 2D, twice 8 bits in 3D."""
        words = (word << (22 if dims == 2 else 15) for word in range(2 ** (10 if dims == 2 else 17)))
        return np.array([contract_gradient(dims, word) for word in words])

    def test_library_support_is_that_of_all_gradients(self):
        rng = np.random.default_rng(17)
        for dims in DIMS:
            gradients = self.library_gradients(dims)
            self.assertEqual(len(np.unique(gradients, axis=0)), {2: 1024, 3: 131072}[dims])
            for gradient in bounds.steepest_gradients(dims):
                self.assertIn(tuple(map(float, gradient)), set(map(tuple, gradients.tolist())))
            for offset in rng.uniform(-1, 1, (50, dims)):
                self.assertAlmostEqual((gradients @ offset).max(), bounds.library_support(offset), delta=1e-14)


class Lipschitz(unittest.TestCase):
    def test_constant_is_the_derived_bound(self):
        for kind, dims in NOISES:
            derived, constant = bounds.lipschitz_bound(dims, kind), kind.lipschitz[dims]
            self.assertTrue(derived <= constant <= 1.01 * derived)
            self.assertEqual(constant, float(f"{constant:.2e}"))
            self.assertLessEqual(bounds.lipschitz_witness(dims, kind), derived)

    def test_random_differences(self):
        rng = random.Random(2)
        for kind, dims in NOISES:
            for _ in range(5000):
                p = [rng.uniform(-4, 4) for _ in range(dims)]
                reach = 10 ** rng.uniform(-5, 0)
                q = [x + rng.choice((rng.uniform(-1, 1), -1, 1)) * reach for x in p]
                distance = max(abs(a - b) for a, b in zip(p, q))
                rise = abs(exact_noise_at(p, 0, kind) - exact_noise_at(q, 0, kind))
                self.assertLessEqual(rise, kind.lipschitz[dims] * distance)

    def steepest_rise(self, kind, dims, step):
        """Over 2 * step along the diagonal at the witness, with the steepest gradient at each corner."""
        ends = [[t + sign * step for t in bounds.SLOPE_WITNESS[kind][dims]] for sign in (1, -1)]
        zero = (0.0,) * dims

        def rise(corner, gradient):
            high, low = (exact_noise(f, lambda o: gradient if o == corner else zero, kind) for f in ends)
            return high - low
        vertices = itertools.product((-1.0, 1.0), repeat=dims)
        gradients = vertices if kind is bounds.SINE else bounds.steepest_gradients(dims)
        gradients = [tuple(map(float, g)) for g in gradients]
        return sum(max(rise(corner, g) for g in gradients) for corner in bounds.corners(dims))

    def test_nearly_attained_by_differences(self):
        """Also a must-fail check: a constant 1% smaller would be refuted."""
        step = 1e-4
        for kind, dims in NOISES:
            slope = self.steepest_rise(kind, dims, step) / (2 * step)
            self.assertLess(slope, kind.lipschitz[dims])
            self.assertGreater(slope, 0.99 * kind.lipschitz[dims])


class Transcription(unittest.TestCase):
    """The places outside of these tools that state their numbers."""

    def assert_states(self, path, *numbers):
        text = (ROOT / path).read_text()
        for number in numbers:
            self.assertTrue(number in text, f"{path} does not state {number}")

    @staticmethod
    def rounded_up(value, digits):
        """To a number of significant digits, as the documents write it."""
        step = 10.0 ** (math.floor(math.log10(value)) + 1 - digits)
        return f"{math.ceil(value / step - 1e-9) * step:.{digits - 1}e}".replace("e-0", "e-")

    @staticmethod
    def as_written(value):
        """To 3 significant digits, as the documents write it."""
        return f"{value:.2e}".replace("e-0", "e-")

    def test_the_suite_uses_these_bounds(self):
        for kind, dims in NOISES:
            numbers = (self.rounded_up(bounds_float.error_bound(dims, kind), 3), self.as_written(kind.error[dims]),
                       str(kind.lipschitz[dims]), str(kind.limit[dims]))
            self.assert_states("conformance/tolerance.cpp", f"NoiseBounds{{{', '.join(numbers)}}}")

    def test_the_sources_state_the_bounds_of_the_octahedral_gradient(self):
        for dims in DIMS:
            kind, range_bound = bounds.OCTAHEDRAL, {2: "0.999985", 3: "0.99992"}[dims]
            position, cell = self.as_written(kind.error[dims]), self.rounded_up(bounds_float.error_bound(dims, kind), 2)
            fixed = self.as_written(kind.fixed_error[dims])
            self.assertLess(bounds.range_bound(dims, bounds.SCALE[dims]), float(range_bound))
            self.assert_states("README.md", position, fixed, range_bound)
            self.assert_states(f"glsl/noise{dims}d.glsl", position, cell, fixed, range_bound)

    def test_the_page_states_these_bounds(self):
        def of_noise(number):
            return " | ".join(number(kind, dims) for kind, dims in NOISES)

        rows = (of_noise(lambda kind, dims: str(kind.lipschitz[dims])),
                of_noise(lambda kind, dims: self.rounded_up(bounds_float.error_bound(dims, kind), 3)),
                of_noise(lambda kind, dims: self.as_written(kind.error[dims])),
                of_noise(lambda kind, dims: self.as_written(kind.fixed_error[dims])),
                of_noise(lambda kind, dims: f"{kind.fixed_limit[dims]:g}"))
        self.assert_states("docs/accuracy.md", *(f"| {row} |" for row in rows))
        self.assertEqual([bounds.sine_range(dims) for dims in DIMS], [1, 3 / 2])
        self.assert_states("docs/accuracy.md", "| 0.999985 | 0.99992 | 1 | 3/2 |", "| 0.99944 | 0.99885 | | |",
                           *(str(bounds.SINE.limit[dims]) for dims in DIMS))
        for dims, library, witness in ((2, 0.99944, 0.99943), (3, 0.99885, 0.99884)):
            self.assertTrue(witness < bounds.range_witness(dims)[0] < bounds.library_range(dims) < library)

    def test_the_page_states_the_bounds_of_octave_sums(self):
        def row(*arguments):
            values = [of(*arguments, kind) for kind in bounds.GRADIENTS
                      for of in (bounds_float.octave_tolerance, bounds_fixed.fixed_octave_tolerance)]
            return f"| {' | '.join(self.rounded_up(value, 2) for value in values)} |"
        rows = [row(name, dims, 16.0, 5, 2.0, 0.5, exact)
                for name, dims, exact in (("fbm", 2, True), ("fbm", 2, False), ("fbm", 3, False), ("clouds", 2, False))]
        self.assert_states("docs/accuracy.md", *rows, row("fbm", 3, 1024.0, 8, 2.0, 0.5, False))

    def test_the_page_states_the_parts_of_the_fixed_bounds(self):
        for kind, dims in NOISES:
            parts = [value for value in bounds_fixed.error_parts(dims, kind).values() if value]
            cells = [f"{math.ceil(value * 1e7 - 1e-6) / 10:.1f}" for value in parts]
            self.assert_states("docs/accuracy.md", f"| {kind.name}, {dims}D | {' | '.join(cells)} |")
        low, high = bounds_fixed.fade_errors().min(), bounds_fixed.fade_errors().max()
        self.assert_states("docs/accuracy.md", f"{self.rounded_up(-low, 3)} too small",
                           f"{self.rounded_up(high, 3)} too large")

    def test_the_page_states_the_bounds_of_the_sine(self):
        polynomial = (f"{c:.8f}" for c in bounds_float.SINE_DECIMALS)
        self.assert_states("docs/accuracy.md", *polynomial, f"{round(bounds_float.SINE_ARGUMENT_ERROR * 2**30)} / 2^30")
        self.assert_states("docs/accuracy.md", *(self.rounded_up(value, 3) for value in (
            bounds_float.sine_truncation_bound(), math.pi / 2 * bounds_float.SINE_ARGUMENT_ERROR,
            bounds_float.sine_bound(), bounds.SINE.component_error, bounds_fixed.fixed_sine_error(),
            bounds_fixed.cloud_error())))
        below = math.floor((1 - bounds_float.sine_largest()) * 1e9) / 1e9
        self.assert_states("docs/accuracy.md", self.as_written(below))
