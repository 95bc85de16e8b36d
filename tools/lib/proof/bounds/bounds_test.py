"""Tests of the proofs for the exact noise and its derivatives: how large they can be."""

import functools
import itertools
import unittest

import numpy as np

from base.thorough import in_thorough_runs
from proof.bounds import noises, suprema
from proof.bounds.boxes import Boxes, cell, corners, fade_derivative, largest_derivative, supremum
from proof.bounds.gradients import LENGTH, OCTAHEDRAL, ROTATED, SINE, octahedral_support
from proof.bounds.noises import perlin
from proof.bounds.noises.perlin import SCALE
from proof.bounds.table import bounds_of
from proof.oracle import gradients as oracle
from proof.oracle.noises import perlin as oracle_perlin

CASES = noises.find("perlin").cases
DIMS = (1, 2, 3, 4)
QUANTITIES = (suprema.VALUE, suprema.SLOPE)


def proven(kind, dims):
    """The bounds of hn_perlin in bounds.inc."""
    return bounds_of("perlin", dims, kind.name)


@functools.cache
def gradients(dims):
    """All that the contract has: axes by gradients."""
    words = range(0, 2**32, 2**18) if dims > 1 else range(0, 2**23, 2**14)
    return np.array(sorted({oracle.OCTAHEDRAL[dims](word) for word in words})).T


def searched(function, dims, count=4000, rounds=30):
    """Nearly the largest value of a function of points, by random search near the best, and where that is."""
    rng = np.random.default_rng(dims)
    best, reach = np.full(dims, 0.5), 0.5
    for _ in range(rounds):
        points = np.clip(best[:, None] + rng.uniform(-reach, reach, (dims, count)), 0, 1)
        points[:, 0] = best
        best, reach = points[:, function(points).argmax()], reach * 0.75
    return float(function(best[:, None])[0]), best


class Supports(unittest.TestCase):
    """h against all gradients of the library."""

    def test_gradients_of_the_contract_reach_it(self):
        rng = np.random.default_rng(17)
        for dims, count in ((1, 512), (2, 8), (3, 12), (4, 24)):
            every = gradients(dims)
            self.assertEqual(every.shape, (dims, count))
            self.assertEqual(abs(every).max(), OCTAHEDRAL.component(dims))
            self.assertAlmostEqual(np.sqrt((every**2).sum(axis=0)).max(), LENGTH[dims])
            edges = np.eye(dims), np.ones((dims, 1)), np.zeros((dims, 1))
            v = np.concatenate([rng.uniform(-1, 1, (dims, 1000)), *edges], axis=1)
            self.assertLess(abs((every.T @ v).max(axis=0) - octahedral_support(v)).max(), 1e-14)


class Search(unittest.TestCase):
    def test_derivatives_of_the_fade_in_boxes(self):
        rng = np.random.default_rng(19)
        for order in (1, 2, 3):
            lo = rng.random(500)
            hi = np.minimum(lo + rng.random(500) ** 3, 1)
            inside = [abs(fade_derivative(order, lo + (hi - lo) * part)) for part in np.linspace(0, 1, 50)]
            self.assertLess((np.max(inside, axis=0) - largest_derivative(order, lo, hi)).max(), 1e-12)
            step = 1e-5
            rise = (fade_derivative(order - 1, lo + step) - fade_derivative(order - 1, lo - step)) / (2 * step)
            self.assertLess(abs(rise - fade_derivative(order, lo)).max(), 1e-4)

    def test_supremum(self):
        """A known supremum is found, and a must-fail check: a box that is left out is missed."""
        def bound(boxes: Boxes):
            upper = np.maximum(boxes.lo, boxes.hi).prod(axis=0)
            return upper, boxes.lo.prod(axis=0)
        found = supremum(bound, cell(2), 20, 1e-4)
        self.assertTrue(1 <= found < 1.0002)
        half = supremum(bound, cell(2, half=True), 20, 1e-4)
        self.assertTrue(0.25 <= half < 0.2501)

    @in_thorough_runs
    def test_bounds_are_attained(self):
        """Nearly, by a search, for each quantity; so a bound a little smaller would be refuted."""
        cases = [*CASES, (2, ROTATED), (3, ROTATED)]
        for (dims, kind), quantity in itertools.product(cases, QUANTITIES):
            seen, _ = searched(lambda points: suprema.steepest(quantity, kind, points), dims)
            bound = suprema.largest(quantity, dims, kind)
            self.assertTrue(0.9999 * bound < seen <= bound, (dims, kind, quantity, seen, bound))

    def test_curvature_bounds_differences(self):
        """The second differences of random choices of gradients."""
        rng, step = np.random.default_rng(20), 1e-3
        for dims, quantity in itertools.product(DIMS[1:], QUANTITIES):
            point = rng.uniform(0.05, 0.95, (dims, 1))
            boxes = Boxes(0, np.zeros((dims, 1), np.int64))
            limit = suprema.curvature(quantity, OCTAHEDRAL, boxes)[0]
            g = {corner: rng.choice(gradients(dims), 1, axis=1) for corner in corners(dims)}

            def total(f):
                return sum(float((g[corner] * suprema.vector(quantity, f, corner, of_corner)).sum())
                           for corner, of_corner in suprema.derivatives(f))
            steps = [step * axis[:, None] for axis in np.eye(dims)]
            second = sum(abs(total(point + s) + total(point - s) - 2 * total(point)) for s in steps) / step**2
            self.assertLess(second, limit)


class Range(unittest.TestCase):
    def test_below_one_even_with_the_float_error(self):
        for dims in DIMS:
            largest = perlin.range_bound(dims, OCTAHEDRAL) + proven(OCTAHEDRAL, dims).error
            self.assertLess(largest, proven(OCTAHEDRAL, dims).limit)
            self.assertEqual(proven(OCTAHEDRAL, dims).limit, 1)

    def test_limit_of_the_sine_gradient(self):
        for dims in (2, 3):
            largest, limit = perlin.range_bound(dims, SINE) + proven(SINE, dims).error, proven(SINE, dims).limit
            self.assertTrue(largest <= limit < largest + 1e-5)
            self.assertEqual(limit, round(limit, 5))

    def test_fixed_sums_have_room(self):
        """Rounding leaves room for 32 octaves. With the sine gradient it takes values beyond the range."""
        for dims in DIMS:
            room = 1 - perlin.range_bound(dims, OCTAHEDRAL) - proven(OCTAHEDRAL, dims).fixed_error
            self.assertGreater(room, 32 * 2 * 2.0**-21)
            self.assertEqual(proven(OCTAHEDRAL, dims).fixed_limit, 1)
        for dims in (2, 3):
            self.assertTrue(dims / 2 < proven(SINE, dims).fixed_limit < dims / 2 + 3e-5)

    def test_sine_range_is_that_of_the_sum(self):
        """Attained in the middle of the cell, and nowhere more."""
        for dims in (2, 3):
            self.assertEqual(suprema.steepest(suprema.VALUE, SINE, np.full((dims, 1), 0.5))[0], perlin.range_bound(dims, SINE))
            self.assertTrue(dims / 2 <= suprema.largest(suprema.VALUE, dims, SINE) < dims / 2 + 1e-4)

    def test_known_suprema(self):
        for dims, kind, known in ((1, OCTAHEDRAL, 511 / 1024), (2, OCTAHEDRAL, 0.508437), (2, ROTATED, 5**0.5 / 4),
                                  (3, OCTAHEDRAL, 1.036354), (3, ROTATED, 1.164193), (4, OCTAHEDRAL, 1.073454)):
            self.assertAlmostEqual(suprema.largest(suprema.VALUE, dims, kind), known, delta=2e-5)

    def test_fails_with_a_larger_scale(self):
        """The scales are the largest multiples of 1/1024, up to one, that leave room for the errors."""
        for dims, kind in ((2, ROTATED), (3, ROTATED), (4, OCTAHEDRAL)):
            attained, _ = searched(lambda points: suprema.steepest(suprema.VALUE, kind, points), dims)
            self.assertGreater((SCALE[kind][dims] + 1.5 / 1024) * attained, 1)

    def test_scales_are_the_contracts(self):
        self.assertEqual((SCALE[OCTAHEDRAL], SCALE[OCTAHEDRAL] | SCALE[ROTATED]),
                         (oracle_perlin.OCTAHEDRAL_SCALES, oracle_perlin.ROTATING_SCALES))
