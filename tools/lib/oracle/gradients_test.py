"""Tests of gradients.py: values by hand, and the properties that the contract promises."""

from __future__ import annotations

import itertools
import math
import unittest
from collections import Counter
from fractions import Fraction

from golden import rows
from golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from oracle import gradients, words
from oracle.gradients import Knobs

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


class Floats(unittest.TestCase):
    WORDS = [word for word, in rows.gradient_rows(generator_of("gradients"))]
    # A word of each gradient in the plane: its field and its sign.
    ALL_IN_THE_PLANE = [sign << 31 | field << 14 for sign in (0, 1) for field in range(512)]

    def test_directions_by_hand(self) -> None:
        # Of 512 intervals in the plane, 256 along p and q in space; e is half an interval.
        e = 1 / 512
        self.assertEqual(gradients.direction2(0x00000000), (-1 + e, e))
        self.assertEqual(gradients.direction2(0x7F803FFF), (-1 + e, e))  # all other bits but the sign
        self.assertEqual(gradients.direction2(0x80004000), (-1 + 3 * e, -3 * e))
        self.assertEqual(gradients.direction2(0x003FC000), (-e, 1 - e))
        self.assertEqual(gradients.direction2(0x80400000), (e, -1 + e))
        self.assertEqual(gradients.direction2(0x7FFFFFFF), (1 - e, e))
        e = 1 / 256
        self.assertEqual(gradients.direction3(0x00000000), (-1 + e, 0, e))
        self.assertEqual(gradients.direction3(0x00007FFF), (-1 + e, 0, e))
        self.assertEqual(gradients.direction3(0x00008000), (-1 + 2 * e, -e, e))
        self.assertEqual(gradients.direction3(0x80800000), (-1 + 2 * e, e, -e))
        self.assertEqual(gradients.direction3(0x7F800000), (0, 1 - e, e))
        self.assertEqual(gradients.direction3(0xC03F8000), (0, e, -1 + e))  # p = e, q = -e
        self.assertEqual(gradients.direction3(0x40408000), (2 * e, -e, 1 - 3 * e))  # p = e, q = 3 e

    def test_gradients_by_hand(self) -> None:
        e = 1 / 512
        self.assertEqual([gradients.gradient1(h) for h in (0, 0xFF803FFF, 0x80400000, 0x7FFFFFFF)],
                         [(-1 + e,), (-1 + e,), (e,), (1 - e,)])
        self.assertEqual(gradients.gradient2(0x80004000), ((-1 + 3 * e) * (1 + 3 * e), -3 * e * (1 + 3 * e)))
        self.assertEqual(gradients.gradient2(0x00600000), ((1 / 2 + e) * (3 / 2 - e), (1 / 2 - e) * (3 / 2 - e)))
        e = 1 / 256
        self.assertEqual(gradients.gradient3(0x00008000), ((-1 + 2 * e) * (1 + 2 * e), -e * (1 + 2 * e),
                                                           e * (1 + 2 * e)))
        self.assertEqual(gradients.gradient3(0x40408000), (2 * e * (1 + 3 * e), -e * (1 + 3 * e),
                                                           (1 - 3 * e) * (1 + 3 * e)))

    def test_corners_of_the_24_cell_by_hand(self) -> None:
        # The axes that get a component, by the third of the words and by bit 20; bits 19 and 18 are their signs.
        table = {0x00000000: (1, 1, 0, 0), 0x00100000: (0, 0, 1, 1), 0x00080000: (-1, 1, 0, 0),
                 0x00040000: (1, -1, 0, 0), 0x001C0000: (0, 0, -1, -1), 0x55455554: (1, -1, 0, 0),
                 0x55555554: (0, 0, 1, -1), 0x55555555: (0, 1, 0, -1), 0x55400000: (1, 1, 0, 0),
                 0x55600000: (1, 0, 1, 0), 0xAAAAAAA9: (-1, 0, 1, 0), 0xAAAAAAAA: (-1, 0, 0, 1),
                 0xFFFFFFFF: (0, -1, -1, 0), 0xFFF00000: (0, 1, 1, 0), 0xFFE40000: (1, 0, 0, -1)}
        for h, expected in table.items():
            self.assertEqual(gradients.gradient4(h), expected, hex(h))
        self.assertEqual(len({gradients.gradient4(word) for word in self.WORDS}), 24)

    def test_directions_lie_on_the_surface(self) -> None:
        for word in self.WORDS:
            self.assertEqual(sum(map(abs, gradients.direction2(word))), 1)
            self.assertEqual(sum(map(abs, gradients.direction3(word))), 1)

    def test_gradients_are_nearly_as_long_as_each_other(self) -> None:
        # In space the shortest has the direction (1/2, 1/4, 1/4) and the length sqrt(6) / 4 * 3 / 2.
        for least, gradients_there in ((0.98, map(gradients.gradient2, self.ALL_IN_THE_PLANE)),
                                       (0.918, (gradients.gradient3(field << 15) for field in range(0, 2**17, 3)))):
            lengths = [math.hypot(*g) for g in gradients_there]
            self.assertTrue(least < min(lengths) < least + 0.01 and 1.05 < max(lengths) < 1.07)

    def test_gradients_are_exact(self) -> None:
        for word in self.WORDS:
            for of_word, bits in ((gradients.gradient1, 9), (gradients.gradient2, 18), (gradients.gradient3, 16)):
                for component in of_word(word):
                    self.assertEqual(to_f32(component), component)
                    self.assertTrue((component * 2**bits).is_integer())

    def test_gradients_have_no_zero_but_a_positive_one(self) -> None:
        for word in self.WORDS:
            for of_word in gradients.OCTAHEDRAL.values():
                for component in of_word(word):
                    self.assertTrue(component != 0 or math.copysign(1, component) == 1)

    def test_as_many_gradients_as_the_contract_says(self) -> None:
        self.assertEqual(len(set(map(gradients.gradient2, self.ALL_IN_THE_PLANE))), 1024)
        self.assertEqual(len({gradients.gradient3(field << 15) for field in range(2**17)}), 131072)

    def test_gradients_are_uniform(self) -> None:
        # As many in each quadrant, in each octant (its border, where x or y is 0, apart), and in each half by height.
        quadrants = Counter(tuple(x > 0 for x in gradients.gradient2(h)) for h in self.ALL_IN_THE_PLANE)
        self.assertEqual(set(quadrants.values()), {256})
        in_space = [gradients.gradient3(field << 15) for field in range(2**17)]
        octants = Counter(tuple(x > 0 for x in g) for g in in_space if g[0] and g[1])
        self.assertEqual(len(octants), 8)
        self.assertEqual(len(set(octants.values())), 1)
        # Above half the height lies a quarter of the octahedron's faces.
        self.assertEqual(sum(abs(gradients.direction3(field << 15)[2]) > 0.5 for field in range(2**17)), 2**15)

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

    def test_is_that_of_the_c_library(self) -> None:
        # Which reduces exactly, and is off by less than one unit in the last place.
        for n in self.arcs(300):
            expected = math.sin(n)
            self.assertLessEqual(abs(float(gradients.sine(n)) - expected), math.ulp(expected), n)

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

    def test_ties_away_from_zero_would_show(self) -> None:
        for n, away in {2**24 + 1: 2**24 + 2, 2**30 + 64: 2**30 + 128, 2**31 - 192: 2**31 - 128}.items():
            for sign in (1, -1):
                of_word = gradients.sine_of_word(sign * n & words.MASK)
                self.assertGreater(abs(of_word - gradients.sine(sign * away)), 2**-5)

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
