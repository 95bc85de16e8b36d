"""Tests of components.py, perlin_vector.py and value_vector.py: vectors of noises of one hash, by the noise of other
words, and by hand."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction
from unittest import mock

from catalog.tables.functions import read_functions
from proof.golden.generator import generator_of
from proof.oracle import gradients, noises, words
from proof.oracle.components import component, vector
from proof.oracle.functions import evaluator
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT, lerp
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise
from proof.oracle.testing import FORMS, KNOBS, places

NAMES = ("value", "perlin")
VALUES, PERLIN = map(noises.find, ("value_vector", "perlin_vector"))
SCALES = {2: Fraction(1831, 1024), 3: Fraction(985, 1024)}  # of Perlin noise
FACTORS = (1, 0xEB1831, 0x84A5E5)
PCG = Knobs("pcg")


def word_of(word: int, i: int) -> int:
    return word // 256 * FACTORS[i] % 2**32 if i else word


def words_of(point: tuple[int, ...], seed: int) -> list[int]:
    """Of the components."""
    return [word_of(words.point_word("pcg", point, seed), i) for i in range(len(point))]


class Components(unittest.TestCase):
    def check_words(self, of: Noise, noise: Noise, n: int, i: int) -> None:
        """Component i is the noise of the words that it has."""
        def word(lattice: Lattice, corner: list[int]) -> int:
            return word_of(words.point_word("lattice", lattice.point(corner), lattice.seed), i)

        for (p, seed), periods, form in itertools.product(places("words", n, 4, 16), ((), (48, 5, 0)[:n]), FORMS):
            found = getattr(of, form)(KNOBS, p, seed, periods)
            with mock.patch.object(Lattice, "word", word):
                right = getattr(noise, form)(KNOBS, p, seed, periods)
            self.assertEqual(found[i:i + 1] if of.outputs == noises.VECTOR else found, right)

    def test_each_is_the_noise_of_words_of_its_own(self) -> None:
        for name, n in itertools.product(NAMES, (2, 3)):
            for i in range(n):
                self.check_words(noises.find(f"{name}_vector"), noises.find(name), n, i)
                slopes = noises.find(f"{name}_d")
                self.check_words(component(slopes, i), slopes, n, i)
            self.assertEqual(len(noises.find(f"{name}_vector").fixed(KNOBS, (0.3,) * n)), n)

    def test_another_component_is_noticed(self) -> None:
        slopes = noises.find("value_d")
        for of, noise, i in ((VALUES, noises.find("perlin"), 0), (component(slopes, 1), slopes, 2)):
            with self.assertRaises(AssertionError):
                self.check_words(of, noise, 3, i)
        with mock.patch.object(words, "COMPONENT_FACTORS", FACTORS[2:0:-1]), self.assertRaises(AssertionError):
            self.check_words(VALUES, noises.find("value"), 3, 1)

    def test_they_are_not_alike(self) -> None:
        # Of 200 independent values the correlation is about 0.07.
        for name, n in itertools.product(NAMES, (2, 3)):
            numbers, found = generator_of(f"alike{n}"), []
            for _ in range(200):
                p = [numbers.uniform(-100, 100) for _ in range(n)]
                found.append(list(map(float, noises.find(f"{name}_vector").fixed(KNOBS, p, 3))))
            for a, b in itertools.combinations(zip(*found), 2):
                product = sum(x * y for x, y in zip(a, b))
                self.assertLess(product**2, 0.09 * sum(x * x for x in a) * sum(y * y for y in b))

    def test_only_in_two_and_three_dimensions(self) -> None:
        for name, n, form in itertools.product(NAMES, (1, 4), FORMS):
            with self.assertRaisesRegex(ValueError, "two and three"):
                getattr(noises.find(f"{name}_vector"), form)(KNOBS, (0.5,) * n)
        for n, i in ((1, 0), (2, 2), (4, 1)):
            with self.assertRaisesRegex(ValueError, f"in {n}D has no component {i}"):
                component(noises.find("value_d"), i).exact(KNOBS, (0.5,) * n)

    def test_of_a_noise_with_more_numbers_there_is_none(self) -> None:
        with self.assertRaises(ValueError):
            vector(lambda *_: (1, 2))(Lattice(KNOBS), (0, 0), (0, 0))

    def test_rows_are_of_the_component_that_they_name(self) -> None:
        numbers = generator_of("component rows")
        found = [function for function in read_functions() if function.component is not None]
        self.assertEqual(len(found), 10)
        for function, fixed in itertools.product(found, (False, True)):
            n, noise = function.axes, component(noises.find(function.bound), function.component)
            p, periods = [numbers.uniform(-8, 8) for _ in range(n)], (3, 0, 5)[:n] * function.has_period
            place = tuple(p)
            if function.has_cell:
                cell = list(map(math.floor, p))
                place = (*cell, *(x - c for x, c in zip(p, cell)), *periods)
            right = (noise.fixed if fixed else noise.exact)(KNOBS, p, 5, periods)
            self.assertEqual(evaluator(function, fixed)(KNOBS, (*place, 5)), right, function.id)
            self.assertEqual(function.component, "xyz".index(function.id[-1]))


class ByHand(unittest.TestCase):
    # The hash of a lattice point, and the numbers of the vector there, times 2^22: the low 23 bits of the hashes, less
    # 2^22. 0xEB1831 is 15407153, which loses the bit of 2^23, and 0x84A5E5 is 8693221. All high bits are a factor of
    # -1, but for bits beyond the lowest 24.
    NUMBERS = {0: (-2**22,) * 3, 255: (255 - 2**22, -2**22, -2**22),
               256: (256 - 2**22, 15407153 - 2**23 - 2**22, 8693221 - 2**23 - 2**22),
               0x80000200: (512 - 2**22, 2 * 15407153 - 3 * 2**23 - 2**22, 2 * 8693221 - 2 * 2**23 - 2**22),
               words.MASK: (2**22 - 1, 2 * 2**23 - 15407153 - 2**22, 2 * 2**23 - 8693221 - 2**22)}

    def test_numbers_of_value_noise(self) -> None:
        for (word, expected), n, form in itertools.product(self.NUMBERS.items(), (2, 3), FORMS):
            with mock.patch("proof.oracle.lattice.point_word", return_value=word):
                for p in ((7.0, -5.0, 3.0), (0.5, 0.25, -0.375)):  # all points are alike
                    for a, b in zip(getattr(VALUES, form)(KNOBS, p[:n]), expected[:n], strict=True):
                        self.assertLessEqual(abs(a - Fraction(b, 2**22)), Fraction(form == "fixed", 2**22), hex(word))

    def test_on_an_edge(self) -> None:
        """At 1/4 between two points the weights are 918 and 106 of 1024, and the fade is 27136 in units of 2^-18. Of
        Perlin noise the offsets are (1/4, 0) and (-3/4, 0)."""
        for n in (2, 3):
            p, ends = (-2.75, 5.0, -8.0)[:n], [words_of((x, 5, -8)[:n], 7) for x in (-3, -2)]
            for value, perlin, a, b in zip(VALUES.exact(PCG, p, 7), PERLIN.exact(PCG, p, 7), *ends, strict=True):
                self.assertEqual(value, Fraction(a % 2**23 * 918 + b % 2**23 * 106, 1024 * 2**22) - 1)
                near, far = (Fraction(gradients.OCTAHEDRAL[n](h)[0]) for h in (a, b))
                self.assertEqual(perlin, SCALES[n] * (918 * near - 3 * 106 * far) / 4096)

    def test_on_an_edge_in_fixed_arithmetic(self) -> None:
        def ramp(h: int, d: int) -> int:
            return 128 * (2 * (h >> 21 & 3) - 3) * d

        p, ends = (-2.75, 5.0), [words_of((x, 5), 7) for x in (-3, -2)]
        for value, perlin, a, b in zip(VALUES.fixed(PCG, p, 7), PERLIN.fixed(PCG, p, 7), *ends, strict=True):
            n = lerp(a % 2**23 * 128 - 2**29, b % 2**23 * 128 - 2**29, 27136)
            self.assertEqual(value, Fraction(n + 128 >> 8, 2**21))
            n = lerp(ramp(a, UNIT // 4), ramp(b, UNIT // 4 - UNIT), 27136)
            self.assertEqual(perlin, Fraction(((n + 256 >> 9) * 1831 + 256) >> 9, 2**21))
