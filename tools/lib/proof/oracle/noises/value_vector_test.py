"""Tests of value_vector.py: its numbers by hand, and interpolated."""

from __future__ import annotations

import itertools
import unittest
from fractions import Fraction
from unittest import mock

from proof.oracle import noises, words
from proof.oracle.gradients import Knobs
from proof.oracle.integers import lerp

VECTOR = noises.find("value_vector")


class Numbers(unittest.TestCase):
    # The word of a lattice point, and the numbers of the vector there, times 2^22: what is left of the low 23 bits of
    # the words, less 2^22. 0xEB1831 is 15407153, of which the bit of 2^23 is lost, and 0x84A5E5 is 8693221. All high
    # bits are a factor of -1, but for bits beyond the lowest 24.
    WORDS = {0: (-2**22,) * 3, 255: (255 - 2**22, -2**22, -2**22),
             256: (256 - 2**22, 15407153 - 2**23 - 2**22, 8693221 - 2**23 - 2**22),
             0x80000200: (512 - 2**22, 2 * 15407153 - 3 * 2**23 - 2**22, 2 * 8693221 - 2 * 2**23 - 2**22),
             words.MASK: (2**22 - 1, 2 * 2**23 - 15407153 - 2**22, 2 * 2**23 - 8693221 - 2**22)}

    def test_by_hand(self) -> None:
        for word, expected in self.WORDS.items():
            numbers = tuple(Fraction(x, 2**22) for x in expected)
            with mock.patch("proof.oracle.lattice.point_word", return_value=word):
                for n, of in itertools.product((2, 3), (VECTOR.exact, VECTOR.fixed)):
                    for p in ((7.0, -5.0, 3.0), (0.5, 0.25, -0.375)):  # all points are alike
                        found = of(Knobs("lattice"), p[:n])
                        for a, b in zip(found, numbers[:n], strict=True):
                            self.assertLessEqual(abs(a - b), Fraction(1, 2**22) if of == VECTOR.fixed else 0, hex(word))

    def test_along_a_line_by_hand(self) -> None:
        # s(1/4) is 106 / 1024, and its fade 27136 in units of 2^-18.
        a, b = (words.point_word("pcg", (c, 5), 7) for c in (-3, -2))
        exact, fixed = VECTOR.exact(Knobs("pcg"), (-2.75, 5.0), 7), VECTOR.fixed(Knobs("pcg"), (-2.75, 5.0), 7)
        for i, (x, y) in enumerate(((a, b), (a // 256 * 0xEB1831, b // 256 * 0xEB1831))):
            x, y = x % 2**23, y % 2**23
            self.assertEqual(exact[i], Fraction(x * 918 + y * 106, 1024 * 2**22) - 1)
            self.assertEqual(fixed[i], Fraction(lerp(x * 128 - 2**29, y * 128 - 2**29, 27136) + 128 >> 8, 2**21))

    def test_gradients_do_not_matter(self) -> None:
        for of in (VECTOR.exact, VECTOR.fixed):
            self.assertEqual(*(of(Knobs("lattice", sine), (0.3, 0.7, 0.9), 5) for sine in (False, True)))


if __name__ == "__main__":
    unittest.main()
