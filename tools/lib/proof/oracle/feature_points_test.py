"""Tests of feature_points.py: roots, where points are and how far, and that a search leaves none out."""

from __future__ import annotations

import itertools
import math
import unittest
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import feature_points, nearest, noises
from proof.oracle.feature_points import (
    CHEBYSHEV,
    HYBRID,
    MANHATTAN,
    SQUARED,
    BlockTooSmall,
    Field,
    direction2,
    direction3,
    fixed_root,
    root,
)
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT
from proof.oracle.lattice import EUCLIDEAN, Choice, Lattice

LATTICE = Knobs("lattice")
METRICS = (EUCLIDEAN, SQUARED, MANHATTAN, CHEBYSHEV, HYBRID)
EIGHTH = Fraction(1, 8)


class Roots(unittest.TestCase):
    def test_of_squares(self) -> None:
        for x in (Fraction(0), Fraction(1), Fraction(9, 16), Fraction(1, 2**298), Fraction((2**200 + 1)**2, 2**80)):
            self.assertEqual(root(x)**2, x)

    def test_are_as_near_as_they_should(self) -> None:
        numbers = generator_of("roots")
        for _ in range(200):
            x = Fraction(numbers.word() + 1, numbers.word() + 1) / 2**numbers.integer(0, 300)
            r = root(x)
            self.assertLess(abs(r * r - x), x / 2**250)
            self.assertEqual(float(r), float(root(x * 4**40) / 2**40))

    def test_what_is_right_beside_the_middle_of_two_doubles_is_rounded_correctly(self) -> None:
        # The middle is a tie, which goes to the even one, 1; all above go to the odd one.
        middle, odd = 1 + Fraction(1, 2**53), 1 + 2.0**-52
        self.assertEqual(float(root(middle**2)), 1)
        for bits in (100, 300, 600):
            self.assertEqual(float(root(middle**2 + Fraction(1, 2**bits))), odd)
            self.assertEqual(float(root(middle**2 - Fraction(1, 2**bits))), 1)

    def test_of_fixed_arithmetic(self) -> None:
        # Of 1, 1/4 and 2, in units of 2^-28.
        self.assertEqual([fixed_root(n) for n in (0, 1, 2**28, 2**26, 2**29)], [0, 16, 2**18, 2**17, 370727])
        for n in (3, 77, 2**28 - 1, 2**28 + 12345, 2**31):
            self.assertTrue(fixed_root(n)**2 <= 256 * n < (fixed_root(n) + 1)**2)


class Points(unittest.TestCase):
    def test_directions_by_hand(self) -> None:
        # Of 512 intervals in the plane, 256 along p and q in space; e is half an interval.
        e = 1 / 512
        for h, expected in ((0, (-1 + e, e)), (0x7F803FFF, (-1 + e, e)), (0x80004000, (-1 + 3 * e, -3 * e)),
                            (0x003FC000, (-e, 1 - e)), (0x80400000, (e, -1 + e)), (0x7FFFFFFF, (1 - e, e))):
            self.assertEqual(direction2(h), expected, hex(h))
        e = 1 / 256
        for h, expected in ((0, (-1 + e, 0, e)), (0x00007FFF, (-1 + e, 0, e)), (0x00008000, (-1 + 2 * e, -e, e)),
                            (0x80800000, (-1 + 2 * e, e, -e)), (0x7F800000, (0, 1 - e, e)),
                            (0xC03F8000, (0, e, -1 + e)), (0x40408000, (2 * e, -e, 1 - 3 * e))):
            self.assertEqual(direction3(h), expected, hex(h))

    def test_directions_are_uniform(self) -> None:
        # As many in each quadrant, and in each octant (its border, where x or y is 0, apart).
        quadrants = Counter(tuple(x > 0 for x in direction2(sign << 31 | field << 14))
                            for sign in (0, 1) for field in range(512))
        self.assertEqual(set(quadrants.values()), {256})
        in_space = [direction3(field << 15) for field in range(2**17)]
        self.assertEqual(len(set(in_space)), 2**17)
        octants = Counter(tuple(x > 0 for x in u) for u in in_space if u[0] and u[1])
        self.assertEqual((len(octants), len(set(octants.values()))), (8, 1))
        # Above half the height lies a quarter of the octahedron's faces.
        self.assertEqual(sum(abs(u[2]) > 0.5 for u in in_space), 2**15)

    def test_directions_in_whole_numbers(self) -> None:
        numbers = generator_of("directions")
        for _ in range(200):
            h = numbers.word()
            for n, of in ((2, direction2), (3, direction3)):
                u = feature_points.direction(h, n)
                self.assertEqual(tuple(Fraction(x, 512) for x in u), tuple(map(Fraction, of(h))))
                self.assertEqual(sum(map(abs, u)), 512)

    def test_by_hand(self) -> None:
        # The word of the cell (0, 0) is h: a = 2 * 300 - 511 = 89, in units of 1/512, and m = -(512 - 89).
        h = 1 << 31 | 300 << 14
        for jitter in (0.0, 0.5, 1.0):
            lattice = Lattice(LATTICE, choice=Choice(jitter))
            with mock.patch.object(Lattice, "word", return_value=h):
                point = Field.exact(lattice, (0, 0), (EIGHTH, 3 * EIGHTH), EUCLIDEAN).point((1, -2))
                fixed = Field.fixed(lattice, (0, 0), (UNIT // 8, 3 * UNIT // 8), EUCLIDEAN).point((1, -2))
            x, y = EIGHTH - Fraction(3, 2) - Fraction(jitter) * 89 / 1024, 3 * EIGHTH + Fraction(3, 2)
            y += Fraction(jitter) * (512 - 89) / 1024
            unit = feature_points.Exact.of(lattice, (EIGHTH, 3 * EIGHTH)).unit
            self.assertEqual(tuple(Fraction(d, unit) for d in point.offset), (x, y))
            self.assertEqual(tuple(Fraction(d, UNIT) for d in fixed.offset), (x, y))
            self.assertEqual((point.cell, fixed.cell), ((1, -2), (1, -2)))

    def test_fixed_points_are_rounded_down(self) -> None:
        fixed = feature_points.Fixed(UNIT, 3)
        self.assertEqual(fixed.moved((511, 1, -1, -511)), (1, 0, -1, -2))
        self.assertGreaterEqual(fixed.reach, 2)

    def test_no_point_moves_farther_than_it_can(self) -> None:
        # The least distances of a search hold only then.
        jitters = (0, 2.0**-149, 2.0**-20, to_f32(0.3), to_f32(1 - 2.0**-24), 1, 1.75, -0.5)
        for jitter, phase, n in itertools.product(jitters, (None, 0.0, 0.125, to_f32(0.3)), (2, 3)):
            lattice = Lattice(LATTICE, phase=phase, choice=Choice(jitter))
            for arithmetic in (feature_points.Exact.of(lattice, (EIGHTH,) * n), feature_points.Fixed.of(lattice, n)):
                for axis, u in itertools.product(range(n), (-512, -511, -1, 0, 1, 511, 512)):
                    corner = [u if i == axis else 0 for i in range(n)]
                    corner[axis - 1] = 512 - abs(u)
                    self.assertLessEqual(max(map(abs, arithmetic.moved(corner))), arithmetic.reach)
                self.assertLessEqual(arithmetic.reach, arithmetic.unit // 2)

    def test_jitter_is_clamped(self) -> None:
        noise = noises.find("cellular")
        for jitter, end in ((-0.5, 0), (1.75, 1), (-0.0, 0), (3e38, 1)):
            beyond, at_end = noise.chosen(Choice(jitter)), noise.chosen(Choice(end))
            self.assertEqual(beyond.exact(LATTICE, (0.25, 3.5), 7), at_end.exact(LATTICE, (0.25, 3.5), 7))
            self.assertEqual(beyond.fixed(LATTICE, (0.25, 3.5), 7), at_end.fixed(LATTICE, (0.25, 3.5), 7))


class Distances(unittest.TestCase):
    def test_in_every_metric_by_hand(self) -> None:
        # Without a jitter points are in the middle of cells. From (1/8, 3/8) the nearest are at (3/8, 1/8), in its own
        # cell, and at (-5/8, 1/8).
        squares = (Fraction(10, 64), Fraction(26, 64))
        expected = {EUCLIDEAN: tuple(map(root, squares)), SQUARED: squares, MANHATTAN: (4 * EIGHTH, 6 * EIGHTH),
                    CHEBYSHEV: (3 * EIGHTH, 5 * EIGHTH),
                    HYBRID: (4 * EIGHTH + squares[0], 6 * EIGHTH + squares[1])}
        for metric in (0, 6, -3, INT_MIN, INT_MAX):
            expected[metric] = expected[EUCLIDEAN]
        for metric, distances in expected.items():
            noise = noises.find("cellular").chosen(Choice(0.0, metric))
            self.assertEqual(noise.exact(LATTICE, (4.125, -0.625), 5), distances, metric)
            for fixed, exact in zip(noise.fixed(LATTICE, (4.125, -0.625), 5), distances):
                self.assertEqual(fixed, Fraction(math.floor(exact * 2**18), 2**18))

    def test_in_space_by_hand(self) -> None:
        # From the middle of a wall two points are at half a cell, and then there are eight at sqrt(5) / 2.
        for noise, of in itertools.product((noises.find("cellular_three").chosen(Choice(0.0, SQUARED)),),
                                           ("exact", "fixed")):
            self.assertEqual(getattr(noise, of)(LATTICE, (3.0, 2.5, -7.5)), (EIGHTH * 2, EIGHTH * 2, EIGHTH * 10))


class Searches(unittest.TestCase):
    def samples(self, n: int, count: int) -> list[tuple[list[float], int, float]]:
        numbers = generator_of(f"searches{n}")
        return [([numbers.uniform(-20, 20) for _ in range(n)], numbers.word(),
                 (1.0, 0.0, numbers.uniform(0, 1), 1.0)[index % 4]) for index in range(count)]

    def test_a_block_that_is_too_small_is_found(self) -> None:
        for name, around in (("cellular", 0), ("cellular_three", 1), ("cellular_smooth", 0), ("cell_border", 1)):
            for of in (noises.find(name).exact, noises.find(name).fixed):
                with mock.patch.object(feature_points, "AROUND", around), self.assertRaises(BlockTooSmall, msg=name):
                    for seed in range(100):
                        of(LATTICE, (0.0, 0.25), seed)

    def test_a_larger_block_changes_nothing(self) -> None:
        for name, (p, seed, jitter) in itertools.product(
                ("cellular_three", "cellular_smooth", "cell_border"), self.samples(2, 16) + self.samples(3, 4)):
            noise = noises.find(name).chosen(Choice(jitter))
            found = noise.exact(LATTICE, p, seed), noise.fixed(LATTICE, p, seed)
            with mock.patch.object(feature_points, "AROUND", 5):
                self.assertEqual((noise.exact(LATTICE, p, seed), noise.fixed(LATTICE, p, seed)), found)


class Nearest(unittest.TestCase):
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
        self.assertEqual(self.cells((0.0, 3.0), (3, 3)), [(2, 2)] * 2)
        self.assertEqual(self.cells((0.5, 0.5), (1, 1)), [(0, 0)] * 2)

    def test_names_at_the_ends_of_int(self) -> None:
        noise = nearest.NEAREST.chosen(Choice(0.0))
        for of in (noise.exact_cell, noise.fixed_cell):
            self.assertEqual(of(LATTICE, (INT_MIN, 0), (0.0, 0.5)), (INT_MAX, 0))
            self.assertEqual(of(LATTICE, (INT_MIN, 0), (0.0, 0.5), 0, (7, 0)), ((-2**31 - 1) % 7, 0))
            self.assertEqual(of(LATTICE, (INT_MIN, 0), (0.0, 0.5), 0, (INT_MAX, 0)), ((-2**31 - 1) % INT_MAX, 0))
            self.assertEqual(of(LATTICE, (INT_MAX, -1), (1.0, 1.0)), (INT_MAX, -1))
            self.assertEqual(of(LATTICE, (INT_MAX, INT_MIN), (0.75, 0.25)), (INT_MAX, INT_MIN))
            self.assertTrue(all(isinstance(c, int) for c in of(LATTICE, (0, 0), (0.0, 0.5))))

    def test_offset_leads_to_the_point_of_the_cell(self) -> None:
        numbers = generator_of("offset")
        for n, metric, jitter in itertools.product((2, 3), METRICS, (1.0, to_f32(0.7))):
            p, seed = [numbers.uniform(-9, 9) for _ in range(n)], numbers.word()
            choice = Choice(jitter, metric)
            cell = nearest.NEAREST.chosen(choice).exact(LATTICE, p, seed)
            offset = nearest.OFFSET.chosen(choice).exact(LATTICE, p, seed)
            h = Lattice(LATTICE, seed).word(cell)
            u = direction2(h) if n == 2 else direction3(h)
            self.assertEqual([Fraction(x) + d for x, d in zip(p, offset)],
                             [c + Fraction(1, 2) + Fraction(jitter) / 2 * Fraction(a) for c, a in zip(cell, u)])
            distance, _ = noises.find("cellular").chosen(replace(choice, metric=SQUARED)).exact(LATTICE, p, seed)
            if metric in (EUCLIDEAN, SQUARED):
                self.assertEqual(sum(d * d for d in offset), distance)
            fixed = nearest.OFFSET.chosen(choice).fixed(LATTICE, p, seed)
            self.assertLess(max(abs(a - b) for a, b in zip(fixed, offset)), 2**-18)
