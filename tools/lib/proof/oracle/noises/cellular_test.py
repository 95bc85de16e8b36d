"""Tests of cellular_d.py, cellular_smooth.py and cell_border.py: by hand, and by what they are."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Iterator, Sequence
from fractions import Fraction
from unittest import mock

from proof.golden.generator import generator_of
from proof.oracle import noises
from proof.oracle.feature_points import EUCLIDEAN, SQUARED, root
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Choice
from proof.oracle.noises import Noise, cell_border, cellular_d, cellular_smooth

LATTICE = Knobs("lattice")
SLOPES, SMOOTH, BORDER = map(noises.find, ("cellular_d", "cellular_smooth", "cell_border"))
GRID = Choice(0.0)  # points are in the middle of cells


def samples(name: str, n: int, count: int = 12) -> Iterator[tuple[list[Fraction], int, Choice]]:
    """Positions that fixed arithmetic does not cut, seeds and jitters."""
    numbers = generator_of(f"{name}{n}")
    for index in range(count):
        jitter = (1.0, numbers.integer(0, UNIT) / UNIT, 0.0)[index % 3]
        yield [Fraction(numbers.integer(-2**24, 2**24), UNIT) for _ in range(n)], numbers.word(), Choice(jitter)


def both(noise: Noise, p: Sequence[float]) -> list[tuple[Fraction, ...]]:
    return [noise.exact(LATTICE, p), noise.fixed(LATTICE, p)]


class Derivatives(unittest.TestCase):
    def test_by_hand(self) -> None:
        # From (1/2, 1/2), and on a wall, where the point with the smaller y counts.
        for y, up in ((0.0, 1), (0.001, -1)):
            for value, dx, dy in both(SLOPES.chosen(GRID), (0.875, y)):
                self.assertLess(abs(value - Fraction(5, 8)), 2**-10)
                self.assertLess(abs(dx - Fraction(3, 5)), 2**-10)
                self.assertLess(abs(dy - up * Fraction(4, 5)), 2**-10)
        self.assertEqual(SLOPES.chosen(GRID).exact(LATTICE, (0.875, 0.0)),
                         (Fraction(5, 8), Fraction(3, 5), Fraction(4, 5)))

    def test_at_a_point_they_are_0(self) -> None:
        for n in (2, 3):
            self.assertEqual(both(SLOPES.chosen(GRID), (-7.5,) * n), [(0,) * (n + 1)] * 2)

    def test_small_offsets_keep_their_direction(self) -> None:
        # As far as whole offsets have one: all of them that are small, and all ways to enlarge them.
        factors = set()
        for d in itertools.product((-3, -1, 0, 1, 2, 31, 32, 127, 128, 1023, 1024, 32768, 131072), repeat=2):
            large = cellular_d.enlarged(d)
            if any(d):
                factors.add(max(large, key=abs) // max(d, key=abs))
                # A root of 2^17 or more is off by 1, and its square by 2^12 of 2^34 or more.
                self.assertGreaterEqual(max(map(abs, large)), 2**17 - 2**12)
                length = math.hypot(*d)
                for slope, x in zip(cellular_d.fixed_slopes(d), d):
                    self.assertLess(abs(slope / 2**21 - x / length), 2**-15)
                    self.assertEqual((slope > 0) - (slope < 0), (x > 0) - (x < 0))
        self.assertEqual(factors, {1, 4, 32, 128, 1024, 4096, 32768, 131072} & factors)
        self.assertLess({1, 1024, 131072}, factors)

    def test_enlarging_by_hand(self) -> None:
        for m, k in ((1, 131072), (3, 131072), (4, 32768), (31, 32768), (32, 4096), (127, 4096), (128, 1024),
                     (1023, 1024), (1024, 128), (4095, 128), (4096, 32), (32767, 32), (32768, 4), (131071, 4),
                     (131072, 1), (2**20, 1)):
            self.assertEqual(cellular_d.enlarged((m // 2, -m)), (k * (m // 2), -k * m))


class Smooth(unittest.TestCase):
    def test_by_hand(self) -> None:
        # In the middle of a cell its own point counts alone: at 1 others count no more.
        for n in (2, 3):
            value, = SMOOTH.chosen(GRID).exact(LATTICE, (2.5,) * n)
            self.assertEqual(value, 1 - root(root(1 + Fraction(1, 4096))))
        # In the middle of a wall in the plane: two at 1/2.
        value, = SMOOTH.chosen(GRID).exact(LATTICE, (2.0, -0.5))
        self.assertEqual(value, 1 - root(root(Fraction(2, 16) + Fraction(1, 4096))))

    def test_where_no_point_is_near(self) -> None:
        # The summand keeps it below 1, and the value has no root of 0.
        with mock.patch.object(cellular_smooth, "near_points", return_value=()):
            self.assertEqual(both(SMOOTH, (0.0, 0.0)), [(Fraction(7, 8),)] * 2)

    def test_fixed_weights(self) -> None:
        for rank in (0, 1, 2**10, 2**20, 2**26, 2**27, 2**28 - 2**13, 2**28 - 1, 2**28, 2**30):
            exact = max(0.0, 1 - math.sqrt(rank) / 2**14)**4
            self.assertLess(abs(cellular_smooth.fixed_weight(rank) / 2**30 - exact), 2**-13, rank)
        self.assertEqual([cellular_smooth.fixed_weight(rank) for rank in (2**28, 2**30)], [0, 0])

    def test_no_crease_where_the_nearest_point_changes(self) -> None:
        step = Fraction(1, 2**20)
        below, at, above = (SMOOTH.chosen(GRID).exact(LATTICE, (i * step, Fraction(3, 8)))[0] for i in (-1, 0, 1))
        self.assertLess(abs((above - at) - (at - below)), 64 * step**2)


class Borders(unittest.TestCase):
    def test_by_hand(self) -> None:
        # Without a jitter borders are the walls.
        for p, distance in (((0.25, 0.5), 2), ((0.25, 0.875), 1), ((0.5, 0.5), 4), ((0.0, 0.5), 0), ((3.0, -2.0), 0),
                            ((-0.375, 7.375), 3), ((0.5, 0.625, 0.75), 2), ((0.5, 0.5, 0.5), 4)):
            self.assertEqual(both(BORDER.chosen(GRID), p), [(Fraction(distance, 8),)] * 2, p)

    def test_points_are_never_in_one_place(self) -> None:
        # The root of fixed arithmetic divides. The nearest two points of different cells face each other at a wall.
        for n, jitter in itertools.product((2, 3), (2**20, 2**20 - 1, 2**19, 1, 0)):
            largest = 511 if n == 2 else 510
            d = (2**20 - largest * jitter // 2**10 - -(-largest * jitter // 2**10),) + (0,) * (n - 1)
            self.assertGreater(cell_border.fixed_root(cell_border.fixed_square([x // 2 for x in d])), 0)


class ByMetric(unittest.TestCase):
    def test_a_border_knows_no_metric(self) -> None:
        # Nor do derivatives and the smooth one: they have none to choose.
        for noise in (SLOPES, SMOOTH, BORDER):
            for p, seed, choice in samples("metric", 2, 6):
                found = {noise.chosen(Choice(choice.jitter, metric)).exact(LATTICE, p, seed)
                         for metric in (EUCLIDEAN, SQUARED, 3, 4, 5)}
                self.assertEqual(len(found), 1)
