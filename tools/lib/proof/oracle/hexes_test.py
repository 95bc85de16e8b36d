"""Tests of hexes.py: weights place a position between the corners, and do not jump."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from catalog.tables.functions import Function
from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import functions, hexes, words
from proof.oracle.checked import Checked
from proof.oracle.gradients import Knobs
from proof.oracle.hexes import CORNERS, HEXES, OUTPUTS
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Lattice

KNOBS = Knobs("lattice")
LIMIT_OF_SLOPE = 5  # the square of the largest slope of a weight
CELLS = ((0, 0), (-1, -1), (3, -2), (-6, 5), (INT_MAX, INT_MIN), (INT_MIN, INT_MAX))
TILES = ((), (0, 0), (1, 1), (2, 3), (3, 1), (7, 0), (INT_MAX, 2), (-4, 5))

Found = dict[str, Fraction | int]


def at(cell: Sequence[int], f: Sequence[Fraction | float], seed: int = 7, periods: Sequence[int] = (),
       fixed: bool = False) -> Found:
    function = HEXES.fixed_cell if fixed else HEXES.exact_cell
    return dict(zip(OUTPUTS, function(KNOBS, cell, f, seed, periods), strict=True))


def fractions(name: str, count: int) -> Iterator[tuple[Fraction, Fraction]]:
    """Of all kinds: on each seam of triangles, at corners, and anywhere; fixed arithmetic does not cut them."""
    draws = generator_of(name)
    for i in range(count):
        x, y = (Fraction(draws.integer(0, UNIT), UNIT) for _ in range(2))
        half = Fraction(draws.integer(0, 2), 2)
        eighth = Fraction(UNIT // 8 * draws.integer(0, 8), UNIT)
        yield ((x, y), (x, half), ((half - eighth / 2) % 1, eighth), ((half + eighth / 2) % 1, eighth),
               (half / 2, half), (Fraction(1), y), (x, Fraction(1)))[i % 7]


def weights_of(found: Found) -> list[Fraction]:
    return [Fraction(found[f"w{corner}"]) for corner in CORNERS]


def by_word(found: Found) -> dict[int, Fraction]:
    """Whose weight is not 0; in small tiles corners may have the same word."""
    total: dict[int, Fraction] = {}
    for corner, weight in zip(CORNERS, weights_of(found)):
        if weight:
            total[found[corner]] = total.get(found[corner], 0) + weight
    return total


class Hexes(Checked, unittest.TestCase):
    def places(self, name: str, count: int = 84) -> Iterator[tuple[Sequence[int], Sequence[Fraction], Sequence[int]]]:
        tried = itertools.cycle(itertools.product(CELLS, TILES))
        for (cell, periods), f in zip(tried, fractions(name, count)):
            yield cell, f, periods

    def check_weights(self) -> None:
        """They are not negative, sum to 1, and the mean of the corners with them is the position itself: of three
        points that are no line there is one such choice."""
        for cell, f, periods in self.places("weights"):
            for fixed in (False, True):
                found = at(cell, f, 7, periods, fixed)
                weights = weights_of(found)
                self.assertEqual(sum(weights), 1)
                self.assertGreaterEqual(min(weights), 0)
                for axis in "xy":
                    self.assertEqual(sum(w * found[f"{axis}{corner}"] for w, corner in zip(weights, CORNERS)), 0)

    def check_corners(self) -> None:
        """The corners are points of the lattice, in the order of the contract, and their words are those of hn_lattice
        with their numbers."""
        for cell, f, periods in self.places("corners"):
            found = at(cell, f, 7, periods)
            place = [c + x for c, x in zip(cell, f)]
            corners = [(place[0] - found[f"x{corner}"], place[1] - found[f"y{corner}"]) for corner in CORNERS]
            (ax, ay), (bx, by), (cx, cy) = corners
            self.assertEqual((cx - ax, cy - ay), (Fraction(1, 4), Fraction(1, 2)))
            self.assertIn((bx - ax, by - ay), ((Fraction(1, 2), 0), (Fraction(-1, 4), Fraction(1, 2))))
            for (x, y), corner in zip(corners, CORNERS):
                i, j = 2 * x - y % 1, 2 * y
                numbers = [int(n % (2 * period) if period > 0 else n) for n, period in zip((i, j), periods or (0, 0))]
                self.assertEqual((i, j), (int(i), int(j)))
                self.assertEqual(found[corner], words.lattice("lattice", numbers, 7))

    def check_hexagons(self) -> None:
        """A weight follows from the place of its corner: it falls from 1 to 0 at the sides of the hexagon."""
        for cell, f, _ in self.places("hexagons"):
            found = at(cell, f)
            for corner in CORNERS:
                x, y = (abs(found[f"{axis}{corner}"]) for axis in "xy")
                # Of the three pairs of sides two lean, and one lies at half a cell above and below.
                self.assertEqual(found[f"w{corner}"], 1 - max(2 * y, 2 * x + y))

    def moves(self, name: str) -> Iterator[tuple[Found, Found, Fraction]]:
        """Two places near each other, mostly on two sides of something, and the square of how far apart they are."""
        draws = generator_of(name)
        for cell, f, periods in self.places(name, 168):
            size = draws.pick((1, 2**10, 2**16))
            move = [Fraction(draws.integer(-size, size), 2**21) for _ in range(2)]
            ends = [[x + sign * m for x, m in zip(f, move)] for sign in (1, -1)]
            # Of a fraction below 0 or above 1 the cell is the next one, which may lie at the other end of int.
            found = [at([words.signed(c + math.floor(x)) for c, x in zip(cell, end)], [x % 1 for x in end], 7, periods)
                     for end in ends if self.keeps(cell, end, periods)]
            if len(found) == 2:
                yield *found, 4 * sum(m * m for m in move)

    @staticmethod
    def keeps(cell: Sequence[int], f: Sequence[Fraction], periods: Sequence[int]) -> bool:
        """Whether the cell beside it is one of the field: over the end of int no tile goes on."""
        return all(INT_MIN <= c + math.floor(x) <= INT_MAX or not (periods and periods[axis] > 0)
                   for axis, (c, x) in enumerate(zip(cell, f)))

    def check_continuity(self) -> None:
        crossed = 0
        for before, after, square in self.moves("moves"):
            before, after = by_word(before), by_word(after)
            crossed += before.keys() != after.keys()
            count = 3  # corners that have the same word, in the smallest tiles
            for word in before.keys() | after.keys():
                self.assertLessEqual((before.get(word, 0) - after.get(word, 0))**2, count**2 * LIMIT_OF_SLOPE * square)
        self.assertGreater(crossed, 20)

    def check_slopes(self) -> None:
        """Where no corner is another one's twin, by sqrt(5) at most, and by that somewhere."""
        largest = Fraction(0)
        for cell, f in itertools.product(CELLS[:4], fractions("slopes", 21)):
            for move in ((2, 1), (2, -1), (1, 0), (0, 1)):
                other = [x + Fraction(m, 2**12) for x, m in zip(f, move)]
                before = by_word(at(cell, f))
                after = by_word(at([c + math.floor(x) for c, x in zip(cell, other)], [x % 1 for x in other]))
                for word in before.keys() | after.keys():
                    change = (before.get(word, 0) - after.get(word, 0))**2 * 2**24
                    largest = max(largest, change / sum(m * m for m in move))
        self.assertEqual(largest, LIMIT_OF_SLOPE)

    def check_tiles(self) -> None:
        """After a period everything comes again, and no sooner."""
        draws = generator_of("tiles")
        for cell, f, periods in self.places("tiles"):
            if max(map(abs, cell)) > 2**30:
                continue
            for axis, period in enumerate(periods):
                if 0 < period < 100:
                    moved = [c + period * draws.integer(-3, 3) * (i == axis) for i, c in enumerate(cell)]
                    self.assertEqual(at(cell, f, 7, periods), at(moved, f, 7, periods))
                    if period > 1 and f[axis] < 1:
                        moved = [c + (i == axis) for i, c in enumerate(cell)]
                        self.assertNotEqual(by_word(at(cell, f, 7, periods)), by_word(at(moved, f, 7, periods)))

    CHECKS = ("weights", "corners", "hexagons", "continuity", "slopes", "tiles")

    def test_faults_are_found(self) -> None:
        right = hexes.triangle

        def exchanged(place):
            """The second corner is that along the other axis."""
            (a, b, c), weights = right(place)
            (i, j), (k, _) = a.skewed, b.skewed
            return [a, hexes.Corner((i + (k == i), j + (k != i))), c], weights

        def in_another_order(place):
            (a, b, c), weights = right(place)
            return [b, a, c], [weights[1], weights[0], weights[2]]

        def steeper(place):
            corners, (a, b, c) = right(place)
            return corners, [a, b / 2, c + b / 2]

        for fault, noticing in ((exchanged, ("weights", "hexagons", "continuity")), (in_another_order, ("corners",)),
                                (steeper, ("weights", "hexagons", "continuity", "slopes"))):
            with mock.patch.object(hexes, "triangle", fault):
                self.assert_noticed(*noticing)
        with mock.patch.object(hexes.Corner, "point", property(lambda corner: corner.skewed)):
            self.assert_noticed("weights", "corners", "tiles")
        for change in ({"periods": ()}, {"seed": 0}):
            with mock.patch.object(Lattice, "of_triangles", property(lambda lattice: replace(lattice, **change))):
                self.assert_noticed("corners", *(("tiles",) if "periods" in change else ()))
        with mock.patch.object(Lattice, "of_triangles", property(lambda lattice: lattice)):
            self.assert_noticed("corners")

    def test_on_a_seam_by_hand(self) -> None:
        # u = v = 1/2, and at whole numbers; the corner between is then the one along Y, whose weight is 0.
        half, quarter = Fraction(1, 2), Fraction(1, 4)
        found = at((0, 0), (Fraction(1, 8), quarter))
        self.assertEqual(weights_of(found), [half, 0, half])
        self.assertEqual([(found[f"x{corner}"], found[f"y{corner}"]) for corner in CORNERS],
                         [(Fraction(1, 8), quarter), (Fraction(3, 8), -quarter), (Fraction(-1, 8), -quarter)])
        found = at((5, -4), (quarter, half))
        self.assertEqual(weights_of(found), [1, 0, 0])
        self.assertEqual((found["xa"], found["ya"]), (0, 0))
        # Point i = 10 of row -7, which is shifted by a quarter of a cell.
        self.assertEqual(found["a"], words.lattice("lattice", (10, -7), 7))

    def test_fixed_cuts_the_fraction(self) -> None:
        for f, same in (((0.3, 0.7), (Fraction(314572, UNIT), Fraction(734003, UNIT))), ((-0.5, 1.5), (0, 1)),
                        ((1 - 2.0**-24, 2.0**-21), (1 - Fraction(1, UNIT), 0))):
            self.assertEqual(at((3, -4), f, 5, (7, 2), True), at((3, -4), same, 5, (7, 2)))
            if 0 <= f[0] <= 1:
                self.assertNotEqual(at((3, -4), f, 5, (7, 2)), at((3, -4), same, 5, (7, 2)))

    def test_fixed_at_a_position(self) -> None:
        draws = generator_of("hex positions")
        for _ in range(20):
            p = [draws.integer(-2**26, 2**26) / 2**20 for _ in range(2)]
            self.assertEqual(HEXES.fixed(KNOBS, p, 3), HEXES.exact(KNOBS, p, 3))
        # Towards 0, so that a place just below a whole number lies in the next cell.
        self.assertEqual(HEXES.fixed(KNOBS, (-2.0**-21, 3 - 2.0**-22), 3),
                         HEXES.exact(KNOBS, (0.0, 3 - 2.0**-20), 3))


# What a program in C makes of it, which was written from the contract: the hash, the cell, the fraction in units of
# 2^-20, the periods and the seed; weights, words, and vectors.
VECTORS = (
    ("lattice", (-1, INT_MAX), (300000, 700001), (3, 0), 7, (697150, 100001, 251425),
     (650519684, 634511032, 176299772), (37856, 300000, -224288), (175713, -348575, -348575)),
    ("pcg", (INT_MAX, INT_MIN), (1048576, 1048575), (0, 2), words.MASK, (1, 1, 1048574),
     (732427539, 1955019951, 1794445887), (262144, -262144, 0), (524287, 524287, -1)),
    ("lattice", (5, -4), (262144, 524288), (0, 0), 0, (1048576, 0, 0), (2157002028, 900733929, 2673117092),
     (0, 262144, -262144), (0, -524288, -524288)),
    ("lattice", (4, -3), (12345, 1040000), (5, INT_MAX), 9, (17152, 1015310, 16114),
     (1007049054, 1156330565, 2083469562), (-249799, 12345, -511943), (515712, -8576, -8576)))


class Rows(unittest.TestCase):
    def test_evaluation(self) -> None:
        kinds = {"w": "f64", "": "u32", "x": "f64", "y": "f64"}
        for hash_, cell, fraction, periods, seed, *expected in VECTORS:
            for fixed, ((prefix, kind), numbers) in itertools.product((False, True), zip(kinds.items(), expected)):
                function = Function("noise2d.hex_any", "utility", HEXES.name, ("cell", "period"),
                                    tuple(f"{prefix}{corner}" for corner in CORNERS), kind, 2)
                f = [to_f32(x / UNIT) for x in fraction]
                found = functions.evaluator(function, fixed)(Knobs(hash_), (*cell, *f, *periods, seed))
                self.assertEqual(found, tuple(n if kind == "u32" else Fraction(n, UNIT) for n in numbers))
