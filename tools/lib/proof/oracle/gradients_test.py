"""Tests of gradients.py: values by hand, and the properties that the contract promises."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import gradients, hashes
from proof.oracle.gradients import Knobs

CELLS = ((0, 1, -1), (47, -48, -49), (2**20, -2**20 - 1, 5), (INT_MIN, INT_MAX, INT_MIN + 1), (INT_MAX, -7, INT_MIN))


def unit_vector(n: int, bits: int) -> tuple[int, int]:
    """(cos n, sin n) in fixed point as a power of (cos 1, sin 1), without any pi; n >= 0."""
    one = 1 << bits
    inverse_factorials = [one]
    while inverse_factorials[-1]:
        inverse_factorials.append(inverse_factorials[-1] // len(inverse_factorials))
    x, y = (sum(inverse_factorials[i::4]) - sum(inverse_factorials[i + 2::4]) for i in (0, 1))
    c, s = one, 0
    while n:
        if n & 1:
            c, s = (c * x - s * y) >> bits, (c * y + s * x) >> bits
        x, y = (x * x - y * y) >> bits, x * y >> bits - 1
        n >>= 1
    return c, s


# By the number of dimensions: words, and 512, 4, 1 and 1 times their gradients.
BY_HAND = {
    1: {0: (-511,), 0xFF803FFF: (-511,), 0x80400000: (1,), 0x7FFFFFFF: (511,)},
    # Bits 21 and 22 count, and bit 31.
    2: {0x00000000: (-3, 1), 0x00200000: (-1, 3), 0x00400000: (1, 3), 0x00600000: (3, 1), 0x7F9FFFFF: (-3, 1),
        0x80000000: (-3, -1), 0x80200000: (-1, -3), 0x80400000: (1, -3), 0xFFFFFFFF: (3, -1), 0x7FFFFFFF: (3, 1),
        0xFF9FFFFF: (-3, -1)},
    # The axes, by the third of the words; bits 22 and 21 are their signs.
    3: {0x00000000: (1, 1, 0), 0x00200000: (1, -1, 0), 0x00400000: (-1, 1, 0), 0x00600000: (-1, -1, 0),
        0x559FFFFF: (1, 0, 1), 0x55555554: (-1, 1, 0), 0x55555555: (-1, 0, 1), 0xAABFFFFF: (0, 1, -1),
        0xAAAAAAA9: (1, 0, -1), 0xAAAAAAAA: (0, 1, -1), 0xFFFFFFFF: (0, -1, -1), 0xFF9FFFFF: (0, 1, 1)},
    # Bit 20 chooses one of the two pairs of axes.
    4: {0x00000000: (1, 1, 0, 0), 0x00100000: (0, 0, 1, 1), 0x00400000: (-1, 1, 0, 0), 0x00200000: (1, -1, 0, 0),
        0x00700000: (0, 0, -1, -1), 0x55455554: (-1, 1, 0, 0), 0x55555554: (0, 0, -1, 1), 0x55555555: (0, -1, 0, 1),
        0x55800000: (1, 0, 1, 0), 0x55C00000: (-1, 0, 1, 0), 0xAAAAAAA9: (1, 0, -1, 0), 0xAAAAAAAA: (1, 0, 0, -1),
        0xFFFFFFFF: (0, -1, -1, 0), 0xFF900000: (0, 1, 1, 0), 0xFF800000: (1, 0, 0, 1)}}


class Gradients(unittest.TestCase):
    """A number or a gradient of another bit of a word, or another sine."""

    def test_by_hand(self) -> None:
        for (n, table), unit in zip(BY_HAND.items(), (512, 4, 1, 1)):
            for h, expected in table.items():
                self.assertEqual(gradients.OCTAHEDRAL[n](h), tuple(x / unit for x in expected), hex(h))
        self.assertEqual((gradients.unorm(0), gradients.unorm(hashes.MASK)), (0, 1 - 2**-24))
        self.assertEqual((gradients.snorm(0), gradients.snorm(2**31), gradients.snorm(hashes.MASK)), (-1, 0, 1 - 2**-23))
        with self.assertRaises(ValueError):
            Knobs("fnv2")

    def test_the_sine_is_as_exact_as_it_says(self) -> None:
        numbers = generator_of("arcs")
        # The numerators of convergents of pi, up to the largest: the sine is as small as it gets.
        for n in [1, -1, INT_MIN, 2**31, 3, 22, 355, 245850922, 411557987, 1068966896, -1068966896,
                  *(numbers.integer(-2**bits, 2**bits) for bits in range(1, 32) for _ in range(3))]:
            _, s = unit_vector(abs(n), 320)
            self.assertLess(abs(gradients.sine(n) - math.copysign(1, n) * Fraction(s, 2**320)), gradients.SINE_ERROR, n)

    def test_arcs_have_24_bits(self) -> None:
        # Ties go to even.
        for n, even in ((2**24 + 1, 2**24), (2**24 + 3, 2**24 + 4), (2**30 + 64, 2**30), (2**30 + 192, 2**30 + 256),
                        (2**31 - 64, 2**31), (2**31 - 192, 2**31 - 256)):
            for sign in (1, -1):
                self.assertEqual(gradients.round24(sign * n), sign * even)
                self.assertEqual(gradients.sine_of_word(sign * n & hashes.MASK), gradients.sine(sign * even))

    def test_the_sine_gradient_is_the_papers(self) -> None:
        """The paper's listing with the C library's sine, and float(int) by the conversion to float32 of the machine. It
        has no seed, which joins the first word alone."""
        def component(word: int) -> float:
            word &= hashes.MASK
            return math.sin(to_f32(word - 2**32 if word >= 2**31 else word))

        for (hash_name, function), seed in itertools.product(hashes.WORD_HASHES.items(), (0, 0xDEADBEEF)):
            knobs = Knobs(hash_name, sine=True)
            for x, y, z in CELLS:
                hx = function(x & hashes.MASK) ^ hashes.mix(seed)
                hy = function(hx + y & hashes.MASK)
                hz = function(hy + z & hashes.MASK)
                found = (*gradients.gradient(knobs, (x, y), seed), *gradients.gradient(knobs, (x, y, z), seed))
                for value, word in zip(found, (hx + hy, hy + hy, hz + hx, hz + hy, hz + hz), strict=True):
                    self.assertAlmostEqual(float(value), component(word), delta=2**-53)
        # Values of a C program written from the contract.
        for word, value in ((0, 0x794D5FBB), (1, 0x1E97969F), (0x80000000, 0x69B8AF86), (hashes.MASK, 0x82DBF900)):
            self.assertEqual(hashes.hash_words("lattice", [word]), value)

    def test_the_sine_is_in_two_and_three_dimensions(self) -> None:
        for n in (1, 4):
            self.assertEqual(*(gradients.gradient(Knobs("pcg", sine), (5,) * n, 7) for sine in (False, True)))
