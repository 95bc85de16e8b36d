"""Tests of gradients.py: values by hand, and the properties that the contract promises."""

from __future__ import annotations

import itertools
import math
import unittest
from collections import Counter
from fractions import Fraction

from proof.golden import rows
from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import gradients, words
from proof.oracle.gradients import Knobs

EDGE_CELLS = (0, 1, -1, 47, 48, -48, -49, 2**20, -2**20 - 1, 2**30, -2**30 + 1, INT_MIN, INT_MIN + 1, INT_MAX - 1,
              INT_MAX)


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


class Floats(unittest.TestCase):
    WORDS = [word for word, in rows.gradient_rows(generator_of("gradients"))]

    def test_by_hand(self) -> None:
        for (n, table), unit in zip(BY_HAND.items(), (512, 4, 1, 1)):
            for h, expected in table.items():
                self.assertEqual(gradients.OCTAHEDRAL[n](h), tuple(x / unit for x in expected), hex(h))

    def test_all_there_are(self) -> None:
        quarters = ((3, 1), (1, 3))
        self.assertEqual(set(map(gradients.gradient2, self.WORDS)),
                         {(x * a / 4, y * b / 4) for x, y in quarters for a in (1, -1) for b in (1, -1)})
        for n, of in ((3, gradients.gradient3), (4, gradients.gradient4)):
            self.assertEqual(set(map(of, self.WORDS)),
                             {g for g in itertools.product((-1, 0, 1), repeat=n) if sum(map(abs, g)) == 2})

    def test_no_axis_has_more_than_another(self) -> None:
        # The sum of the products of two components: those of each axis, and none of two.
        for n, expected in ((2, 2.5), (3, 8), (4, 12)):
            found = set(map(gradients.OCTAHEDRAL[n], self.WORDS))
            for i, j in itertools.product(range(n), repeat=2):
                self.assertEqual(sum(g[i] * g[j] for g in found), expected if i == j else 0)

    def test_gradients_have_no_zero_but_a_positive_one(self) -> None:
        for word in self.WORDS:
            for of_word in gradients.OCTAHEDRAL.values():
                for component in of_word(word):
                    self.assertTrue(component != 0 or math.copysign(1, component) == 1)

    def test_gradients_are_uniform(self) -> None:
        # Of words in steps of 2^16 + 1, which meet all fields.
        for n, count in ((2, 8), (3, 12), (4, 24)):
            found = Counter(gradients.OCTAHEDRAL[n](h) for h in range(0, 2**32, 2**16 + 1))
            self.assertEqual(len(found), count)
            self.assertTrue(all(abs(times / 2**16 * count - 1) < 0.02 for times in found.values()), found)

    def test_unit_ranges(self) -> None:
        self.assertEqual((gradients.unorm(0), gradients.unorm(words.MASK)), (0, 1 - 2**-24))
        self.assertEqual((gradients.snorm(0), gradients.snorm(2**31), gradients.snorm(words.MASK)), (-1, 0, 1 - 2**-23))


class Sine(unittest.TestCase):
    def arcs(self, count: int) -> list[int]:
        """Edge cases, and as many others of each size."""
        numbers = generator_of("arcs")
        random = [numbers.integer(-2**bits, 2**bits) for bits in range(1, 32) for _ in range(count)]
        # The numerators of convergents of pi, up to the largest: the sine is as small as it gets.
        near_multiples = [3, 22, 355, 245850922, 411557987, 1068966896, -1068966896]
        return [0, 1, -1, INT_MAX, INT_MIN, 2**31] + near_multiples + random

    def test_pi(self) -> None:
        self.assertEqual(float(Fraction(gradients.PI, 2**gradients.SINE_BITS)), math.pi)

    def test_is_as_exact_as_it_says(self) -> None:
        for n in self.arcs(10):
            _, s = unit_vector(abs(n), 320)
            self.assertLess(abs(gradients.sine(n) - math.copysign(1, n) * Fraction(s, 2**320)), gradients.SINE_ERROR, n)

    def test_the_nearest_double_is_certain(self) -> None:
        for n in self.arcs(100):
            value = gradients.sine(n)
            if n != 0:
                self.assertEqual(float(value - gradients.SINE_ERROR), float(value + gradients.SINE_ERROR), n)
        self.assertEqual(gradients.sine(0), 0)

    def test_rounds_as_float32_does(self) -> None:
        for n in self.arcs(300):
            self.assertEqual(gradients.round24(n), to_f32(n), n)

    def test_ties_go_to_even(self) -> None:
        ties = {2**24 + 1: 2**24, 2**24 + 3: 2**24 + 4, 2**30 + 64: 2**30, 2**30 + 192: 2**30 + 256,
                2**31 - 64: 2**31, 2**31 - 192: 2**31 - 256}
        for n, even in ties.items():
            for sign in (1, -1):
                self.assertEqual(gradients.round24(sign * n), sign * even)
                self.assertEqual(gradients.sine_of_word(sign * n & words.MASK), gradients.sine(sign * even))

    def test_words_are_signed(self) -> None:
        # INT_MAX rounds to 2^31.
        for word, opposite in ((0xFFFFFFFF, 1), (0x80000000, INT_MAX), (0x80000001, INT_MAX), (0xFF000001, 0xFFFFFF)):
            self.assertEqual(float(gradients.sine_of_word(word)), -float(gradients.sine_of_word(opposite)))


class Settings(unittest.TestCase):
    def test_others_than_those_of_the_library(self) -> None:
        for name in ("", "any", "fnv2"):
            with self.assertRaises(ValueError, msg=name):
                Knobs(name)


class Gradients(unittest.TestCase):
    def cells(self, n: int) -> list[tuple[int, ...]]:
        """Edge cases alone and with each other, and random ones."""
        numbers = generator_of("cells")
        mixed = [tuple(numbers.pick(EDGE_CELLS) for _ in range(n)) for _ in range(10)]
        return [(c,) * n for c in EDGE_CELLS] + mixed + [
            tuple(numbers.integer(INT_MIN, INT_MAX) for _ in range(n)) for _ in range(10)]

    def test_octahedral_is_that_of_the_word(self) -> None:
        for name in words.HASHES:
            for n, of_word in enumerate((gradients.gradient1, gradients.gradient2, gradients.gradient3,
                                         gradients.gradient4), 1):
                for cell in self.cells(n):
                    self.assertEqual(gradients.gradient(Knobs(name), cell, 7), of_word(words.point_word(name, cell, 7)))

    def test_the_sine_is_in_two_and_three_dimensions(self) -> None:
        for n, same in ((1, True), (2, False), (3, False), (4, True)):
            plain, sine = (gradients.gradient(Knobs("pcg", sine), (5,) * n, 7) for sine in (False, True))
            self.assertEqual(plain == sine, same, n)

    def test_sine_without_a_seed_is_the_papers(self) -> None:
        # The paper's listing with the C library's sine, and float(int) by the conversion to float32 of the machine.
        def component(word: int) -> float:
            word &= words.MASK
            return math.sin(to_f32(word - 2**32 if word >= 2**31 else word))

        for hash_name, function in words.WORD_HASHES.items():
            knobs = Knobs(hash_name, sine=True)
            for x, y, z in self.cells(3):
                hx = function(x & words.MASK)
                hy = function(hx + y & words.MASK)
                hz = function(hy + z & words.MASK)
                pairs = list(zip(gradients.gradient(knobs, (x, y)), (component(hx + hy), component(hy + hy))))
                pairs += zip(gradients.gradient(knobs, (x, y, z)),
                             (component(hz + hx), component(hz + hy), component(hz + hz)))
                for value, expected in pairs:
                    self.assertAlmostEqual(float(value), expected, delta=2**-53)

    def test_sine_words_are_chained_hashes(self) -> None:
        for name in words.HASHES:
            for x, y in self.cells(2):
                first = words.hash_words(name, [x & words.MASK])
                second = words.hash_words(name, [first + y & words.MASK])
                self.assertEqual(gradients.gradient(Knobs(name, sine=True), (x, y)),
                                 (gradients.sine_of_word(first + second), gradients.sine_of_word(2 * second)))

    def test_hash_of_one_word_under_lattice(self) -> None:
        # Values of a C program written from the contract.
        vectors = {0: 0x794D5FBB, 1: 0x1E97969F, 0x80000000: 0x69B8AF86, words.MASK: 0x82DBF900}
        for word, value in vectors.items():
            self.assertEqual(words.hash_words("lattice", [word]), value)

    def test_seed_joins_the_first_word_only(self) -> None:
        seed = 0xDEADBEEF
        first = words.pcg(5) ^ words.mix(seed)
        second = words.pcg(first - 6 & words.MASK)
        third = words.pcg(second + 7 & words.MASK)
        expected = tuple(gradients.sine_of_word(third + word) for word in (first, second, third))
        self.assertEqual(gradients.gradient(Knobs("pcg", sine=True), (5, -6, 7), seed), expected)
        self.assertNotEqual(gradients.gradient(Knobs("pcg", sine=True), (5, -6, 7)), expected)

    def test_beyond_the_largest_cell_lies_the_smallest(self) -> None:
        for knobs in (Knobs("lattice"), Knobs("fnv1", sine=True)):
            self.assertEqual(gradients.gradient(knobs, (2**31, 5)), gradients.gradient(knobs, (INT_MIN, 5)))
