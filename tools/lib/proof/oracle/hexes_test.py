"""Tests of hexes.py: weights place a position between the corners, and do not jump."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN, generator_of
from proof.oracle import hexes, words
from proof.oracle.gradients import Knobs
from proof.oracle.hexes import CORNERS, HEXES, OUTPUTS
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Lattice
from proof.oracle.testing import FaultChecks

KNOBS = Knobs("lattice")
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


# From a program in C, which was written from the contract: the hash, the cell, the fraction in units of 2^-20, the
# periods and the seed; weights, hashes, and vectors.
VECTORS = (
    ("lattice", (-1, INT_MAX), (300000, 700001), (3, 0), 7, (697150, 100001, 251425),
     (650519684, 634511032, 176299772), (37856, 300000, -224288), (175713, -348575, -348575)),
    ("pcg", (INT_MAX, INT_MIN), (1048576, 1048575), (0, 2), words.MASK, (1, 1, 1048574),
     (732427539, 1955019951, 1794445887), (262144, -262144, 0), (524287, 524287, -1)),
    ("lattice", (5, -4), (262144, 524288), (0, 0), 0, (1048576, 0, 0), (2157002028, 900733929, 2673117092),
     (0, 262144, -262144), (0, -524288, -524288)),
    ("lattice", (4, -3), (12345, 1040000), (5, INT_MAX), 9, (17152, 1015310, 16114),
     (1007049054, 1156330565, 2083469562), (-249799, 12345, -511943), (515712, -8576, -8576)))


RIGHT = hexes.triangle


def exchanged(place):
    """The second corner is that along the other axis."""
    (a, b, c), weights = RIGHT(place)
    (i, j), (k, _) = a.skewed, b.skewed
    return [a, hexes.Corner((i + (k == i), j + (k != i))), c], weights


def in_another_order(place):
    (a, b, c), weights = RIGHT(place)
    return [b, a, c], [weights[1], weights[0], weights[2]]


def steeper(place):
    corners, (a, b, c) = RIGHT(place)
    return corners, [a, b / 2, c + b / 2]


class Hexes(FaultChecks, unittest.TestCase):
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

    def check_program(self) -> None:
        for hash_, cell, fraction, periods, seed, *expected in VECTORS:
            found = HEXES.fixed_cell(Knobs(hash_), cell, [Fraction(x, UNIT) for x in fraction], seed, periods)
            self.assertEqual(tuple(x * unit for x, unit in zip(found, hexes.UNITS)), tuple(itertools.chain(*expected)))

    CHECKS = ("weights", "corners", "hexagons", "program")
    FAULTS = (
        (hexes, "triangle", exchanged, ("weights", "hexagons")), (hexes, "triangle", in_another_order, ("corners",)),
        (hexes, "triangle", steeper, ("weights", "hexagons")),
        (hexes.Corner, "point", property(lambda corner: corner.skewed), ("weights", "corners", "program")),
        (Lattice, "of_triangles", property(lambda lattice: lattice), ("corners", "program")),
        (Lattice, "of_triangles", property(lambda lattice: replace(lattice, periods=())), ("corners",)),
        (Lattice, "of_triangles", property(lambda lattice: replace(lattice, seed=0)), ("corners",)))

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
