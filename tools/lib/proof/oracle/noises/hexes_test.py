"""Tests of hexes.py: beside a program in C, and on a seam of triangles by hand."""

from __future__ import annotations

import itertools
import unittest
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN
from proof.oracle import hashes
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT
from proof.oracle.noises import hexes

HEXES, = hexes.NOISES

# From a program in C, which was written from the contract: the hash, the cell, the fraction in units of 2^-20, the
# periods and the seed; weights, hashes, and vectors.
VECTORS = (
    ("lattice", (-1, INT_MAX), (300000, 700001), (3, 0), 7, (697150, 100001, 251425),
     (650519684, 634511032, 176299772), (37856, 300000, -224288), (175713, -348575, -348575)),
    ("pcg", (INT_MAX, INT_MIN), (1048576, 1048575), (0, 2), hashes.MASK, (1, 1, 1048574),
     (732427539, 1955019951, 1794445887), (262144, -262144, 0), (524287, 524287, -1)),
    ("lattice", (5, -4), (262144, 524288), (0, 0), 0, (1048576, 0, 0), (2157002028, 900733929, 2673117092),
     (0, 262144, -262144), (0, -524288, -524288)),
    ("lattice", (4, -3), (12345, 1040000), (5, INT_MAX), 9, (17152, 1015310, 16114),
     (1007049054, 1156330565, 2083469562), (-249799, 12345, -511943), (515712, -8576, -8576)))


class Hexes(unittest.TestCase):
    """A corner that is none of the triangle, in another order, or with another weight or word."""

    def test_beside_a_program(self) -> None:
        for hash_, cell, fraction, periods, seed, *expected in VECTORS:
            arguments = Knobs(hash_), cell, [Fraction(x, UNIT) for x in fraction], seed, periods
            found = HEXES.fixed_cell(*arguments)
            self.assertEqual(tuple(x * unit for x, unit in zip(found, hexes.UNITS)), tuple(itertools.chain(*expected)))
            self.assertEqual(found, HEXES.exact_cell(*arguments))

    def test_on_a_seam(self) -> None:
        # u = v = 1/2; the corner between is then the one along Y, whose weight is 0.
        half, eighth = Fraction(1, 2), Fraction(1, 8)
        found = HEXES.exact_cell(Knobs("lattice"), (0, 0), (eighth, 2 * eighth), 7)
        self.assertEqual(found[:3], (half, 0, half))
        self.assertEqual(found[6:], (eighth, 3 * eighth, -eighth, 2 * eighth, -2 * eighth, -2 * eighth))
