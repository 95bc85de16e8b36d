"""Tests of scatter.py, beside a program in C."""

from __future__ import annotations

import unittest

from proof.golden.generator import INT_MAX, INT_MIN, to_f32
from proof.oracle import hashes, scatter
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice
from proof.oracle.scatter import UNIT

# From a program in C, which was written from the contract: the hash, the cell, the periods, the radius and the seed;
# whether the candidate stands, and where it is.
VECTORS = (
    ("lattice", (12, 6), (0, 0), 0.650634765625, 0, 1, (19220, 23490)),
    ("lattice", (12, 6), (0, 0), 0.6506652832, 0, 0, (19220, 23490)),
    ("lattice", (-1, INT_MAX), (3, INT_MAX), 1.0, 5, 1, (25669, 32428)),
    ("pcg", (INT_MIN, 7), (0, 2), 0.75, hashes.MASK, 0, (28520, 2249)),
    ("lattice", (526, -22, 3), (0, 0, 0), 0.7105407714, 0, 1, (19032, 5663, 4664)),
    ("pcg", (-1, 5, INT_MAX), (2, 0, 3), 0.9, 7, 0, (22364, 27775, 9057)),
    ("lattice", (INT_MAX, INT_MIN, 0), (0, 0, 0), 0.5, 1, 1, (814, 31207, 8393)))


class Scattered(unittest.TestCase):
    """A candidate at another place, a neighbour that is left out, or a radius that is cut in another way."""

    def test_beside_a_program(self) -> None:
        for hash_, cell, periods, radius, seed, stands, place in VECTORS:
            lattice = Lattice(Knobs(hash_), seed, periods)
            self.assertEqual(scatter.point(lattice, cell), tuple(x / UNIT for x in place))
            word = scatter.scattered(lattice, cell, to_f32(radius))
            h = (lattice.hash(cell) + 5 * 0x9E3779B9) % 2**32
            self.assertEqual(word, hashes.mix(h) | 1 if stands else 0)

    def test_the_radius(self) -> None:
        for radius, units in ((-1.0, 0), (2.0**-16, 0), (2.0**-15, 1), (1 - 2.0**-24, UNIT - 1), (1.0, UNIT),
                              (3e38, UNIT), (to_f32(0.7), 22937)):
            self.assertEqual(scatter.reach(radius), units)
        # The nearest rival is 21320 units away: a candidate at the radius stands.
        for radius, stands in ((21320, True), (21321, False)):
            self.assertEqual(scatter.stands(Lattice(Knobs("lattice")), (12, 6), radius / UNIT), stands)
