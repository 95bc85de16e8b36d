"""Tests of scatter.py: points that stand keep their distance, and they are as many as theory predicts."""

from __future__ import annotations

import itertools
import math
import random
import unittest
from collections.abc import Callable, Iterable, Sequence
from unittest import mock

from base.thorough import some
from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import scatter, words
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice
from proof.oracle.scatter import UNIT
from proof.oracle.testing import LIMIT, equal_chances, unevenness

KNOBS = Knobs("lattice")
Cell = tuple[int, ...]
Stands = Callable[[Lattice, Sequence[int], float], bool]


def block(origin: Sequence[int], sizes: Sequence[int]) -> list[Cell]:
    return list(itertools.product(*(range(first, first + size) for first, size in zip(origin, sizes))))


def squared(a: Sequence[int], b: Sequence[int], periods: Sequence[int]) -> int:
    """Of the shortest way between two points, in units; 0 is no period."""
    total = 0
    for x, y, period in zip(a, b, periods):
        d = abs(x - y)
        if period:
            d = min(d % (period * UNIT), -d % (period * UNIT))
        total += d * d
    return total


class Field:
    """Some cells, which are all of a tile along each axis that has a period, with the places of their candidates."""

    def __init__(self, lattice: Lattice, origin: Sequence[int], sizes: Sequence[int]) -> None:
        self.lattice, self.cells = lattice, block(origin, sizes)
        # Beyond the range of int a tile without a period goes on with the least int.
        self.periods = lattice.periods or (2**32,) * len(origin)
        self.candidates = {cell: scatter.candidate(lattice, cell) for cell in self.cells}
        self.points = {cell: tuple(c * UNIT + x for c, x in zip(cell, candidate.place))
                       for cell, candidate in self.candidates.items()}
        ends = [(first, first + size - 1) for first, size in zip(origin, sizes)]
        self.inner = {cell for cell in self.cells
                      if all(period == size or c not in end
                             for c, end, period, size in zip(cell, ends, self.periods, sizes))}
        self.pairs = [(a, b, squared(self.points[a], self.points[b], self.periods))
                      for a, b in itertools.combinations(self.cells, 2)]

    def standing(self, radius: float, stands: Stands = scatter.stands) -> set[Cell]:
        return {cell for cell in self.cells if stands(self.lattice, cell, radius)}

    def expected(self, radius: float) -> set[Cell]:
        """The points that no other point with a larger hash is too near to; right for the inner cells."""
        fallen = set()
        for a, b, square in self.pairs:
            if math.sqrt(square) < math.floor(radius * UNIT):
                words_of = [self.candidates[cell].word for cell in (a, b)]
                fallen.add(a if words_of[0] < words_of[1] else b)
        return set(self.cells) - fallen


# In the plane and in space: in no tile, in one, in a tile of odd sizes, across the wrap at 2^32, and with one period.
FIELDS = [Field(Lattice(KNOBS, seed, periods), origin, sizes) for seed, periods, origin, sizes in (
    (3, (), (-9, -6), (13, 12)), (0, (10, 13), (-5, 100), (10, 13)), (5, (2, 7), (INT_MAX - 1, -3), (2, 7)),
    (1, (0, 3), (INT_MAX - 5, INT_MIN + 1), (12, 3)), (7, (3, 2**30), (-1, 2**30 - 7), (3, 14)),
    (2, (), (-3, 4, -4), (6, 6, 6)), (9, (5, 2, 4), (8, -1, 0), (5, 2, 4)),
    (4, (0, 3, 0), (INT_MAX - 2, 0, -2), (5, 3, 5)))]
RADII = (1.0, 0.8, 0.3)


def without(step: Cell) -> Stands:
    """As if a neighbour were not looked at."""
    def stands(lattice: Lattice, cell: Sequence[int], radius: float) -> bool:
        others = [o for o in scatter.steps(len(cell)) if o != step]
        with mock.patch.object(scatter, "steps", return_value=others):
            return scatter.stands(lattice, cell, radius)
    return stands


class Candidates(unittest.TestCase):
    def test_by_hand(self) -> None:
        for seed in (0, 1, words.MASK):
            for cell in ((3, -5), (INT_MIN, INT_MAX), (7, 0, -1)):
                h = words.lattice("lattice", cell, seed)
                first, second = (words.mix((h + k * 0x9E3779B9) % 2**32) for k in (1, 2))
                expected = (first // 2**17, first // 4 % 2**15, second // 2**17)[:len(cell)]
                found = scatter.candidate(Lattice(KNOBS, seed), cell)
                self.assertEqual((found.word, found.place), (h, expected))
                self.assertEqual(scatter.point(Lattice(KNOBS, seed), cell), tuple(x / 2**15 for x in expected))

    def test_a_period_replaces_the_cell(self) -> None:
        tile = Lattice(KNOBS, 7, (3, INT_MAX))
        for cell, same in (((-1, INT_MAX), (2, 0)), ((3, -1), (0, INT_MAX - 1)),
                           ((INT_MIN, INT_MIN), (1, INT_MAX - 1))):
            self.assertEqual(scatter.candidate(tile, cell), scatter.candidate(Lattice(KNOBS, 7), same))

    def unevenness_of(self, places: Iterable[Cell]) -> float:
        return unevenness((tuple(8 * x // UNIT for x in place) for place in places),
                          equal_chances(itertools.product(range(8), repeat=2)))

    def test_they_are_anywhere_in_their_cells(self) -> None:
        places = [scatter.candidate(Lattice(KNOBS, 1), cell).place for cell in block((0, 0), (64, 64))]
        self.assertLess(self.unevenness_of(places), LIMIT)
        self.assertGreater(self.unevenness_of((x, (x + y) // 2) for x, y in places), LIMIT)
        # In space, seen along each axis.
        places = [scatter.candidate(Lattice(KNOBS, 1), cell).place for cell in block((0, 0, 0), (16, 16, 16))]
        for axis in range(3):
            self.assertLess(self.unevenness_of(place[:axis] + place[axis + 1:] for place in places), LIMIT)


class Standing(unittest.TestCase):
    def check_distances(self, stands: Stands = scatter.stands) -> None:
        """No two are nearer than the radius, by the points of hn_scatter_point, in floats."""
        for field, radius in itertools.product(FIELDS, RADII):
            standing = field.standing(radius, stands)
            for a, b, square in field.pairs:
                if a in standing and b in standing:
                    self.assertGreaterEqual(math.sqrt(square), math.floor(radius * UNIT), (a, b))

    def check_who_stands(self, stands: Stands = scatter.stands) -> None:
        """Nothing else fells one."""
        for field, radius in itertools.product(FIELDS, RADII):
            self.assertEqual(field.standing(radius, stands) & field.inner, field.expected(radius) & field.inner)

    def test_they_keep_their_distance(self) -> None:
        self.check_distances()

    def test_they_stand_where_nothing_larger_is_near(self) -> None:
        self.check_who_stands()
        self.assertTrue(all(len(field.inner) > 10 for field in FIELDS))

    def test_faults_are_found(self) -> None:
        class NoTile(Lattice):
            def point(self, corner):
                return list(corner)

        def untiled(lattice: Lattice, cell: Sequence[int], radius: float) -> bool:
            return scatter.stands(NoTile(lattice.knobs, lattice.seed, lattice.periods), cell, radius)

        def wrapping(lattice: Lattice, cell: Sequence[int], radius: float) -> bool:
            """Squares of 32 bits."""
            limit = scatter.reach(radius)**2
            return all(square % 2**32 >= limit for _, square in scatter.rivals(lattice, cell))

        nearer = [lambda lattice, cell, radius: scatter.stands(lattice, cell, radius * 0.9)]
        # Across a corner in space few are nearer than 1.
        omitted = [without(step) for step in ((-1, -1), (0, -1), (1, 0), (0, 0, 1), (-1, 0, 1))]
        for fault in (*nearer, untiled, *some(omitted, 0, 3)):
            with self.assertRaises(AssertionError):
                self.check_distances(fault)
        for fault in (untiled, wrapping):
            with self.assertRaises(AssertionError):
                self.check_who_stands(fault)

    def test_the_radius(self) -> None:
        for radius, units in ((0.0, 0), (-0.0, 0), (-1.0, 0), (-3e38, 0), (1e-40, 0), (2.0**-16, 0), (2.0**-15, 1),
                              (1 - 2.0**-24, UNIT - 1), (1.0, UNIT), (1 + 2.0**-23, UNIT), (3e38, UNIT),
                              (to_f32(0.7), 22937)):
            self.assertEqual(scatter.reach(radius), units)

    def test_without_a_radius_all_stand_and_a_tile_of_one_cell_has_a_point(self) -> None:
        for cell in block((-3, 5), (8, 8)):
            self.assertTrue(scatter.stands(Lattice(KNOBS, 2), cell, 0.0))
            self.assertTrue(scatter.stands(Lattice(KNOBS, 2, (1, 1)), cell, 1.0))

    def test_a_candidate_at_the_radius_stands(self) -> None:
        # Their nearest rivals are 21320 and 23283 units away.
        for cell, away in (((12, 6), 21320), ((526, -22, 3), 23283)):
            for radius, stands in ((away, True), (away + 0.99, True), (away + 1, False)):
                self.assertEqual(scatter.stands(Lattice(KNOBS), cell, radius / UNIT), stands)

    def test_tiles_repeat(self) -> None:
        draws = generator_of("scatter tiles")
        for n in (2, 3):
            for _ in range(20):
                periods = tuple(draws.pick((1, 2, 3, 7)) for _ in range(n))
                lattice, cell = Lattice(KNOBS, draws.word(), periods), [draws.integer(-50, 50) for _ in range(n)]
                moved = [c + draws.integer(-9, 9) * period for c, period in zip(cell, periods)]
                self.assertEqual(scatter.point(lattice, cell), scatter.point(lattice, moved))
                self.assertEqual(scatter.stands(lattice, cell, 0.9), scatter.stands(lattice, moved, 0.9))


def share_by_chance(n: int, radius: float, fields: int = 3, size: int = 16) -> float:
    """The share that stands of candidates and words by Python's generator, in tiles: of a cell that has N others
    within the radius one in N + 1 is the largest, whichever the words are."""
    draws, total = random.Random(n), 0.0
    sizes = (size,) * n if n == 2 else (size // 2,) * n
    for _ in range(fields):
        points = {cell: [c + draws.random() for c in cell] for cell in block((0,) * n, sizes)}
        for cell, point in points.items():
            near = 0
            for o in scatter.steps(n):
                other = points[tuple((c + step) % of for c, step, of in zip(cell, o, sizes))]
                near += sum(((b - a + of / 2) % of - of / 2)**2 for a, b, of in zip(point, other, sizes)) < radius**2
            total += 1 / (1 + near)
    return total / (fields * math.prod(sizes))


class Share(unittest.TestCase):
    """How many stand. Of candidates that lie anywhere, one to a cell on average, Matern's second process keeps the
    share (1 - exp(-V)) / V with the volume V of a ball of the radius. Here each cell has exactly one, so that fewer are
    near: more stand, up to a fourth."""

    def share(self, n: int, radius: float, stands: Stands = scatter.stands) -> float:
        cells = block((-7,) * n, (32, 32) if n == 2 else (10, 10, 10))
        return sum(stands(Lattice(KNOBS, 11), cell, radius) for cell in cells) / len(cells)

    def check(self, stands: Stands = scatter.stands) -> None:
        for n, radius in ((2, 0.5), (2, 1.0), (3, 1.0)):
            volume = math.pi * radius**2 if n == 2 else math.pi * radius**3 * 4 / 3
            matern, share = (1 - math.exp(-volume)) / volume, self.share(n, radius, stands)
            self.assertTrue(matern < share < 1.25 * matern, (n, radius, share, matern))
            self.assertAlmostEqual(share, share_by_chance(n, radius), delta=0.03)

    def test_is_that_of_theory(self) -> None:
        self.check()

    def test_of_another_radius_is_not(self) -> None:
        with self.assertRaises(AssertionError):
            self.check(lambda lattice, cell, radius: scatter.stands(lattice, cell, 0.9 * radius))


# From a program in C, which was written from the contract: the hash, the cell, the periods, the radius and the seed;
# whether the candidate stands, and where it is.
VECTORS = (
    ("lattice", (12, 6), (0, 0), 0.650634765625, 0, 1, (19220, 23490)),
    ("lattice", (12, 6), (0, 0), 0.6506652832, 0, 0, (19220, 23490)),
    ("lattice", (-1, INT_MAX), (3, INT_MAX), 1.0, 5, 1, (25669, 32428)),
    ("pcg", (INT_MIN, 7), (0, 2), 0.75, words.MASK, 0, (28520, 2249)),
    ("lattice", (526, -22, 3), (0, 0, 0), 0.7105407714, 0, 1, (19032, 5663, 4664)),
    ("pcg", (-1, 5, INT_MAX), (2, 0, 3), 0.9, 7, 0, (22364, 27775, 9057)),
    ("lattice", (INT_MAX, INT_MIN, 0), (0, 0, 0), 0.5, 1, 1, (814, 31207, 8393)))


class Program(unittest.TestCase):
    def test_candidates_are_where_the_program_finds_them(self) -> None:
        for hash_, cell, periods, radius, seed, stands, place in VECTORS:
            lattice = Lattice(Knobs(hash_), seed, periods)
            self.assertEqual(scatter.point(lattice, cell), tuple(x / UNIT for x in place))
            word = scatter.scattered(lattice, cell, to_f32(radius))
            self.assertEqual((word > 0, word % 2), (stands, stands))
