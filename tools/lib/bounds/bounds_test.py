"""Tests of what is proven of the exact noise: how large it can be, and how fast it can change."""

import itertools
import math
import random
import unittest

import numpy as np

from bounds.boxes import corners, fade
from bounds.floats import to_float
from bounds.gradients import GRADIENTS, OCTAHEDRAL, SINE
from bounds.noises.perlin import exact as perlin
from bounds.noises.perlin.exact import SCALE
from bounds.reference import contract_gradient, exact_noise, exact_noise_at
from bounds.table import bounds_of

DIMS = (2, 3)
NOISES = tuple(itertools.product(GRADIENTS, DIMS))


def proven(kind, dims):
    """What bounds.inc has of hn_perlin."""
    return bounds_of("perlin", dims, kind.name)


class Range(unittest.TestCase):
    def test_below_one_even_with_the_float_error(self):
        for dims in DIMS:
            largest = perlin.range_bound(dims, SCALE[OCTAHEDRAL][dims]) + proven(OCTAHEDRAL, dims).error
            self.assertLess(largest, proven(OCTAHEDRAL, dims).limit)
            self.assertEqual(proven(OCTAHEDRAL, dims).limit, 1)

    def test_limit_of_the_sine_gradient(self):
        for dims in DIMS:
            largest, limit = perlin.sine_range(dims) + proven(SINE, dims).error, proven(SINE, dims).limit
            self.assertTrue(largest <= limit < largest + 1e-5)
            self.assertEqual(limit, round(limit, 5))

    def test_sine_range_is_that_of_the_sum(self):
        """Attained in the middle of the cell, and nowhere more."""
        def supremum(f):
            weights = {corner: math.prod(fade(t) if o else 1 - fade(t) for t, o in zip(f, corner))
                       for corner in corners(len(f))}
            return sum(w * sum(abs(t - o) for t, o in zip(f, corner)) for corner, w in weights.items())
        rng = random.Random(13)
        for dims in DIMS:
            self.assertEqual(supremum((0.5,) * dims), perlin.sine_range(dims))
            for _ in range(5000):
                total = supremum([0.5 + rng.uniform(-0.5, 0.5) ** rng.choice((1, 3, 9)) for _ in range(dims)])
                self.assertLess(total, perlin.sine_range(dims) + 1e-12)

    def test_attained(self):
        for dims in DIMS:
            value, point, gradients = perlin.range_witness(dims)
            self.assertEqual(point, tuple(map(to_float, point)))
            self.assertAlmostEqual(float(value), exact_noise(point, gradients.__getitem__), delta=1e-14)
            bound = perlin.library_range(dims)
            self.assertTrue(bound - 1e-5 < value < bound < perlin.range_bound(dims, SCALE[OCTAHEDRAL][dims]) - 4e-4)

    def test_known_suprema(self):
        self.assertAlmostEqual(perlin.range_bound(2, 1), 0.5352764390514959, delta=2e-9)
        self.assertAlmostEqual(perlin.range_bound(3, 1), 0.5629016051291905, delta=2e-9)

    def test_fails_with_a_larger_scale(self):
        for dims in DIMS:
            self.assertGreater(perlin.range_bound(dims, 1.02 * SCALE[OCTAHEDRAL][dims]), 1)
            self.assertGreater(1.02 * perlin.range_witness(dims)[0], 1)

    def test_unfolded_sum_stays_below(self):
        """The sum over the corners as it stands, over the whole cube: the folding and nesting lose nothing."""
        rng = random.Random(1)
        for dims in DIMS:
            bound = perlin.range_bound(dims, 1)
            for _ in range(5000):
                f = [rng.random() for _ in range(dims)]
                total = sum(math.prod(fade(t) if o else 1 - fade(t) for t, o in zip(f, corner))
                            * max(abs(t - o) for t, o in zip(f, corner)) for corner in corners(dims))
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
            for gradient in perlin.steepest_gradients(dims):
                self.assertIn(tuple(map(float, gradient)), set(map(tuple, gradients.tolist())))
            for offset in rng.uniform(-1, 1, (50, dims)):
                self.assertAlmostEqual((gradients @ offset).max(), perlin.library_support(offset), delta=1e-14)


class Lipschitz(unittest.TestCase):
    def test_is_attained(self):
        for kind, dims in NOISES:
            derived, attained = perlin.lipschitz_bound(dims, kind), perlin.lipschitz_witness(dims, kind)
            self.assertTrue(0.9999 * derived < attained <= derived)

    def test_random_differences(self):
        rng = random.Random(2)
        for kind, dims in NOISES:
            for _ in range(5000):
                p = [rng.uniform(-4, 4) for _ in range(dims)]
                reach = 10 ** rng.uniform(-5, 0)
                q = [x + rng.choice((rng.uniform(-1, 1), -1, 1)) * reach for x in p]
                distance = max(abs(a - b) for a, b in zip(p, q))
                rise = abs(exact_noise_at(p, 0, kind) - exact_noise_at(q, 0, kind))
                self.assertLessEqual(rise, proven(kind, dims).lipschitz * distance)

    def steepest_rise(self, kind, dims, step):
        """Over 2 * step along the diagonal at the witness, with the steepest gradient at each corner."""
        ends = [[t + sign * step for t in perlin.SLOPE_WITNESS[kind][dims]] for sign in (1, -1)]
        zero = (0.0,) * dims

        def rise(corner, gradient):
            high, low = (exact_noise(f, lambda o: gradient if o == corner else zero, kind) for f in ends)
            return high - low
        vertices = itertools.product((-1.0, 1.0), repeat=dims)
        gradients = vertices if kind is SINE else perlin.steepest_gradients(dims)
        gradients = [tuple(map(float, g)) for g in gradients]
        return sum(max(rise(corner, g) for g in gradients) for corner in corners(dims))

    def test_nearly_attained_by_differences(self):
        """Also a must-fail check: a constant 1% smaller would be refuted."""
        step = 1e-4
        for kind, dims in NOISES:
            slope = self.steepest_rise(kind, dims, step) / (2 * step)
            self.assertLess(slope, proven(kind, dims).lipschitz)
            self.assertGreater(slope, 0.99 * proven(kind, dims).lipschitz)
