"""Tests of perlin_vector.py: by hand near a lattice point and between two, and by its gradients."""

from __future__ import annotations

import itertools
import unittest
from fractions import Fraction
from unittest import mock

from proof.oracle import gradients, noises, words
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT, lerp

VECTOR = noises.find("perlin_vector")
SCALES = {2: Fraction(1831, 1024), 3: Fraction(985, 1024)}
FACTORS = (0xEB1831, 0x84A5E5)


def words_of(point: tuple[int, ...], seed: int) -> list[int]:
    """Of the components."""
    word = words.point_word("pcg", point, seed)
    return [word, *(word // 256 * factor % 2**32 for factor in FACTORS)][:len(point)]


class Perlin(unittest.TestCase):
    def test_at_lattice_points_it_is_0(self) -> None:
        for of, p in itertools.product((VECTOR.exact, VECTOR.fixed), ((3.0, -4.0), (0.0, 7.0, -2.0))):
            self.assertEqual(of(Knobs("pcg"), p, 7), (0,) * len(p))

    def test_on_an_edge_by_hand(self) -> None:
        # At 1/4 between two points the offsets are (1/4, 0) and (-3/4, 0), and the weights 918 and 106 of 1024.
        for n in (2, 3):
            points = [(x, 5, -8)[:n] for x in (-3, -2)]
            found = VECTOR.exact(Knobs("pcg"), (-2.75, 5.0, -8.0)[:n], 7)
            for value, a, b in zip(found, *(words_of(point, 7) for point in points), strict=True):
                near, far = (Fraction(gradients.OCTAHEDRAL[n](h)[0]) for h in (a, b))
                self.assertEqual(value, SCALES[n] * (918 * near - 3 * 106 * far) / 4096)

    def test_fixed_on_an_edge_by_hand(self) -> None:
        # The fade is 27136.
        def ramp(h: int, d: int) -> int:
            return 128 * (2 * (h >> 21 & 3) - 3) * d

        found = VECTOR.fixed(Knobs("pcg"), (-2.75, 5.0), 7)
        for value, a, b in zip(found, *(words_of((x, 5), 7) for x in (-3, -2)), strict=True):
            n = lerp(ramp(a, UNIT // 4), ramp(b, UNIT // 4 - UNIT), 27136)
            self.assertEqual(value, Fraction(((n + 256 >> 9) * 1831 + 256) >> 9, 2**21))

    def test_beside_a_point_its_gradients_count(self) -> None:
        step = Fraction(1, 2**20)
        for n, axis in ((2, 0), (2, 1), (3, 0), (3, 2)):
            point = (5, -6, 7)[:n]
            found = VECTOR.exact(Knobs("pcg"), [x + step * (i == axis) for i, x in enumerate(point)], 9)
            for value, h in zip(found, words_of(point, 9), strict=True):
                slope = SCALES[n] * Fraction(gradients.OCTAHEDRAL[n](h)[axis])
                self.assertLess(abs(value / step - slope), 64 * step**2)

    def test_words_by_hand(self) -> None:
        # All points have the word 0x200, and 0x1D63062 for y. Their bits 22 and 21 are 0 and 2.
        with mock.patch("proof.oracle.lattice.point_word", return_value=0x200):
            x, y = VECTOR.exact(Knobs("lattice"), (0.5, 0.0))
            # In the middle of an edge both ramps are alike, but for the sign.
            self.assertEqual((x, y), (0, 0))
            # On the edge at 1/4 the ramps sum to 918 a / 4 - 106 * 3 a / 4, of 1024.
            found = VECTOR.exact(Knobs("lattice"), (0.25, 0.0, 0.0)[:2])
        for value, a in zip(found, (Fraction(-3, 4), Fraction(1, 4)), strict=True):
            self.assertEqual(value, SCALES[2] * a * (918 - 3 * 106) / 4096)

    def test_with_the_sine_gradient_there_is_none(self) -> None:
        for of in (VECTOR.exact, VECTOR.fixed):
            with self.assertRaisesRegex(ValueError, "no hn_perlin_vector"):
                of(Knobs("lattice", sine=True), (0.5, 0.25))


if __name__ == "__main__":
    unittest.main()
