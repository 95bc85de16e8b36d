"""Tests of perlin_worley.py, by hand."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Sequence
from fractions import Fraction

from proof.oracle import perlin_worley, sums
from proof.oracle.gradients import Knobs, Real
from proof.oracle.sums import Options
from proof.oracle.testing import KNOBS


def exact(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> Fraction:
    return perlin_worley.exact(KNOBS, sums.at_position(p), options, seed, periods)[0]


def fixed(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> Fraction:
    return perlin_worley.fixed(KNOBS, sums.fixed_at_position(p), options, seed, periods)[0]


class PerlinWorley(unittest.TestCase):
    """Octaves of cells with other seeds or weights, or more of them, or a product that is cut in another place."""

    def test_where_no_point_is_near(self) -> None:
        """All points are farther than 1 from this place, where Perlin noise is 0."""
        for of, options in itertools.product((exact, fixed), (Options(1, 2.0, 0.5), Options(3, 2.0, 0.0))):
            self.assertEqual(of((2, -3, 1), options, 4833969), Fraction(1, 2))

    def test_without_octaves(self) -> None:
        for of, octaves in itertools.product((exact, fixed), (0, -1, -2**31)):
            self.assertEqual(of((0.3, 0.4, 0.5), Options(octaves, 2.0, 0.5)), Fraction(3, 4))

    def test_with_the_sine_gradient_there_is_none(self) -> None:
        for of, place in ((perlin_worley.exact, [Fraction(0)] * 3), (perlin_worley.fixed, [(0, 0)] * 3)):
            with self.assertRaisesRegex(ValueError, "no hn_perlin_worley"):
                of(Knobs("lattice", sine=True), place, Options(1, 2.0, 0.5))
