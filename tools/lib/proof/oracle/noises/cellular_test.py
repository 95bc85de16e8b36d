"""Tests of cellular.py and cell_border.py, and of points that move, by hand."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Sequence
from fractions import Fraction
from unittest import mock

from proof.golden.generator import to_f32
from proof.oracle import feature_points, moving_points, noises
from proof.oracle.feature_points import BlockTooSmall
from proof.oracle.lattice import Choice
from proof.oracle.nearest import NEAREST
from proof.oracle.noises import Noise, cellular
from proof.oracle.testing import FORMS, KNOBS, PHASES

SLOPES, SMOOTH, BORDER, MOVING = map(noises.find, ("cellular_d", "cellular_smooth", "cell_border", "cellular_phase"))
GRID = Choice(0.0)  # points are in the middle of cells
# With these phases sines and cosines in units of 2^-16 are 65536, and -65536.
LARGEST = tuple(quarter / 4 + beside for quarter in range(-2, 3) for beside in (-2.0**-17, 2.0**-17))


def both(noise: Noise, p: Sequence[float]) -> list[tuple[Fraction, ...]]:
    return [noise.exact(KNOBS, p), noise.fixed(KNOBS, p)]


class ByHand(unittest.TestCase):
    """A direction, a weight or a border that is cut in another place, or counts another point or a metric."""

    def test_derivatives(self) -> None:
        # From (1/2, 1/2), and on a wall, where the point with the smaller y counts.
        for y, up in ((0.0, 1), (0.001, -1)):
            for found in both(SLOPES.chosen(GRID), (0.875, y)):
                for a, b in zip(found, (Fraction(5, 8), Fraction(3, 5), up * Fraction(4, 5)), strict=True):
                    self.assertLess(abs(a - b), 2**-10)
        for n in (2, 3):  # at a point
            self.assertEqual(both(SLOPES.chosen(GRID), (-7.5,) * n), [(0,) * (n + 1)] * 2)

    def test_enlarging_by_hand(self) -> None:
        for m, k in ((1, 131072), (3, 131072), (4, 32768), (31, 32768), (32, 4096), (127, 4096), (128, 1024),
                     (1023, 1024), (1024, 128), (4095, 128), (4096, 32), (32767, 32), (32768, 4), (131071, 4),
                     (131072, 1), (2**20, 1)):
            self.assertEqual(cellular.enlarged((m // 2, -m)), (k * (m // 2), -k * m))

    def test_a_border_knows_no_metric(self) -> None:
        # Nor do derivatives and the smooth one: they have none to choose. Points that move have the Euclidean one.
        for of, form in itertools.product((SLOPES, SMOOTH, BORDER, MOVING, NEAREST.rotated(0.3)), FORMS):
            self.assertEqual(len({getattr(of.chosen(Choice(0.75, metric)), form)(KNOBS, (0.3, 0.9), 5)
                                  for metric in (1, 2, 3, 4, 5)}), 1)


def at(noise: Noise, phase: float, jitter: float = 1.0) -> Noise:
    return noise.chosen(Choice(jitter)).rotated(phase)


class Moving(unittest.TestCase):
    """A step of fixed arithmetic that is cut or rounded in another place."""

    def test_rotations_by_hand(self) -> None:
        # 46341 is the root of 1/2; 23170 * 46341 is 32767.1 times 2^15, and with 1/2 32767.6. Of 3/8 the cosine is
        # negative: -23171 * -46341 is 32768.5, and with 1/2 32769.02. S comes first in SC. A product of ones is 2^31
        # before it is divided.
        c = 46341
        for phase, expected in ((0.125, ((c, c, 0), (-32767, 32767, c), (32767, -32767, c))),
                                (0.375, ((-c, c, 0), (32767, 32769, c), (32767, 32767, -c))),
                                (2.0**-17, ((65536, 3, 0), (-2, 65536, 3), (0, -2, 65536)))):
            self.assertEqual(moving_points.backwards(3, phase), expected)

    def test_ties_are_those_of_the_contract(self) -> None:
        # At a corner, without a jitter, points are equally far: that of the cell with the smallest z, y, x counts. In
        # space the rounded B makes some axes longer than others, unless it turns by whole quarters.
        for phase in (*PHASES, *LARGEST, to_f32(0.3)):
            for p, cell in (((4.0, -6.0), (3, -7)), ((4.0, -6.0, 8.0), (3, -7, 7))):
                self.assertEqual(at(NEAREST, phase, 0.0).exact(KNOBS, p), cell, phase)
                if len(p) == 2 or phase * 4 % 1 == 0:
                    self.assertEqual(at(NEAREST, phase, 0.0).fixed(KNOBS, p), cell, phase)

    def test_a_block_that_is_too_small_is_found(self) -> None:
        for form in FORMS:
            with mock.patch.object(feature_points, "AROUND", 0), self.assertRaises(BlockTooSmall):
                getattr(at(MOVING, 0.3), form)(KNOBS, (0.0, 0.25), 1)
