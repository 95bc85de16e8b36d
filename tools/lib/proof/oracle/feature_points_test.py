"""Tests of feature_points.py: roots, where points are and how far, and that a search leaves none out."""

from __future__ import annotations

import math
import unittest
from collections.abc import Sequence
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, INT_MIN
from proof.oracle import feature_points, nearest, noises
from proof.oracle.feature_points import (
    CHEBYSHEV,
    HYBRID,
    MANHATTAN,
    SQUARED,
    BlockTooSmall,
    fixed_root,
    root,
)
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT
from proof.oracle.lattice import EUCLIDEAN, Choice
from proof.oracle.testing import METRICS

LATTICE = Knobs("lattice")
EIGHTH = Fraction(1, 8)


class Roots(unittest.TestCase):
    """A root that is less exact than doubles need."""

    def test_of_squares(self) -> None:
        for x in (Fraction(0), Fraction(9, 16), Fraction(1, 2**298), Fraction((2**200 + 1)**2, 2**80)):
            self.assertEqual(root(x)**2, x)

    def test_right_beside_the_middle_of_two_doubles(self) -> None:
        # The middle is a tie, which goes to the even one, 1; all above go to the odd one.
        middle, odd = 1 + Fraction(1, 2**53), 1 + 2.0**-52
        self.assertEqual(float(root(middle**2)), 1)
        for bits in (100, 300, 600):
            self.assertEqual(float(root(middle**2 + Fraction(1, 2**bits))), odd)
            self.assertEqual(float(root(middle**2 - Fraction(1, 2**bits))), 1)

    def test_of_fixed_arithmetic(self) -> None:
        # Of 1, 1/4 and 2, in units of 2^-28.
        self.assertEqual([fixed_root(n) for n in (0, 1, 2**28, 2**26, 2**29)], [0, 16, 2**18, 2**17, 370727])


class Points(unittest.TestCase):
    """A point in another direction or farther away than a search expects, or a distance by another metric."""

    def test_fixed_points_are_rounded_down(self) -> None:
        fixed = feature_points.Fixed(UNIT, 3)
        self.assertEqual((fixed.moved((511, 1, -1, -511)), fixed.reach), ((1, 0, -1, -2), 2))

    def test_in_every_metric_by_hand(self) -> None:
        # Without a jitter points are in the middle of cells. From (1/8, 3/8) the nearest are at (3/8, 1/8), in its own
        # cell, and at (-5/8, 1/8).
        squares = (Fraction(10, 64), Fraction(26, 64))
        expected = {EUCLIDEAN: tuple(map(root, squares)), SQUARED: squares, MANHATTAN: (4 * EIGHTH, 6 * EIGHTH),
                    CHEBYSHEV: (3 * EIGHTH, 5 * EIGHTH),
                    HYBRID: (4 * EIGHTH + squares[0], 6 * EIGHTH + squares[1])}
        self.assertEqual({*expected}, {*METRICS})
        for metric in (0, len(METRICS) + 1, -3, INT_MIN, INT_MAX):
            expected[metric] = expected[EUCLIDEAN]
        for metric, distances in expected.items():
            noise = noises.find("cellular").chosen(Choice(0.0, metric))
            self.assertEqual(noise.exact(LATTICE, (4.125, -0.625), 5), distances, metric)
            for fixed, exact in zip(noise.fixed(LATTICE, (4.125, -0.625), 5), distances):
                self.assertEqual(fixed, Fraction(math.floor(exact * 2**18), 2**18))


class Searches(unittest.TestCase):
    """A search that leaves a point out, and the order and the names of points."""

    def test_a_block_that_is_too_small_is_found(self) -> None:
        for name, around in (("cellular", 0), ("cellular_three", 1), ("cellular_smooth", 0), ("cell_border", 1)):
            for of in (noises.find(name).exact, noises.find(name).fixed):
                with mock.patch.object(feature_points, "AROUND", around), self.assertRaises(BlockTooSmall, msg=name):
                    for seed in range(100):
                        of(LATTICE, (0.0, 0.25), seed)

    def cells(self, p: Sequence[float], periods: Sequence[int] = (), metric: int = EUCLIDEAN) -> list[tuple[int, ...]]:
        """The nearest cell without a jitter, exactly and in fixed arithmetic."""
        noise = nearest.NEAREST.chosen(Choice(0.0, metric))
        return [noise.exact(LATTICE, p, 0, periods), noise.fixed(LATTICE, p, 0, periods)]

    def test_of_equal_distances_that_with_the_smallest_z_then_y_then_x_counts(self) -> None:
        for metric in METRICS:
            self.assertEqual(self.cells((4.0, -6.0), (), metric), [(3, -7)] * 2)
            self.assertEqual(self.cells((4.0, -5.75, 8.0), (), metric), [(3, -6, 7)] * 2)
        # At the same distance: the points above, below and in the middle, by y first; by x where y is the same.
        points = [feature_points.Point(7, cell, (0,) * 3, True) for cell in
                  ((1, 0, 0), (0, 1, 0), (0, 0, 1), (2, -1, 0), (5, 5, -1))]
        self.assertEqual([point.cell for point in sorted(points, key=lambda point: point.order)],
                         [(5, 5, -1), (2, -1, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])

    def test_of_equal_distances_those_of_the_cell_and_its_neighbours_count(self) -> None:
        far, beside = feature_points.Point(7, (-2, -2), (0, 0), False), feature_points.Point(7, (1, 1), (0, 0), True)
        nearer = feature_points.Point(6, (3, 3), (0, 0), False)
        self.assertEqual(sorted([far, beside, nearer], key=lambda point: point.order), [nearer, beside, far])
        manhattan = nearest.NEAREST.chosen(Choice(1.0, 3))
        self.assertEqual(manhattan.fixed(LATTICE, (0.75, -0.0), 171, (2, 48)), (0, 47))

    def test_the_order_is_that_before_a_period(self) -> None:
        # Of the cells -1 and 0 the first counts, though it is called 2.
        self.assertEqual(self.cells((0.0, 0.5), (3, 0)), [(2, 0)] * 2)

    def test_names_at_the_ends_of_int(self) -> None:
        noise = nearest.NEAREST.chosen(Choice(0.0))
        for of in (noise.exact_cell, noise.fixed_cell):
            for cell, f, periods, name in (((INT_MIN, 0), (0.0, 0.5), (), (INT_MAX, 0)),
                                           ((INT_MIN, 0), (0.0, 0.5), (7, 0), ((-2**31 - 1) % 7, 0)),
                                           ((INT_MAX, INT_MIN), (0.75, 0.25), (), (INT_MAX, INT_MIN))):
                self.assertEqual(of(LATTICE, cell, f, 0, periods), name)
