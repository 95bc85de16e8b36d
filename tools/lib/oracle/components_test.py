"""Tests of components.py: what holds for every vector of noises from one hash."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Iterator
from fractions import Fraction
from unittest import mock

from golden.generator import INT_MAX, generator_of
from oracle import noises, words
from oracle.components import vector
from oracle.gradients import Knobs
from oracle.integers import UNIT
from oracle.lattice import Lattice
from oracle.noises import Noise

NAMES = ("value", "perlin")
ARITHMETICS = ("exact", "fixed")


def of(name: str) -> tuple[Noise, Noise]:
    """The noise, and the vector of it."""
    return noises.find(name), noises.find(f"{name}_vector")


def places(name: str, count: int = 12) -> Iterator[tuple[list[Fraction], int, tuple[int, ...]]]:
    """Positions that fixed arithmetic does not cut, seeds, and none or some periods."""
    numbers = generator_of(name)
    for n, periodic, _ in itertools.product((2, 3), (False, True), range(count // 2)):
        p = [Fraction(numbers.integer(-2**24, 2**24), UNIT) for _ in range(n)]
        yield p, numbers.word(), (48, 5, 0)[:n] if periodic else ()


class Components(unittest.TestCase):
    def test_the_first_is_the_noise(self) -> None:
        for name, knobs, arithmetic in itertools.product(NAMES, map(Knobs, ("lattice", "pcg")), ARITHMETICS):
            noise, of_noise = (getattr(found, arithmetic) for found in of(name))
            for p, seed, periods in places("first"):
                self.assertEqual(of_noise(knobs, p, seed, periods)[:1], noise(knobs, p, seed, periods))

    def test_the_others_are_the_noise_of_other_words(self) -> None:
        def other(lattice: Lattice, corner: list[int]) -> int:
            return (words.point_word("lattice", lattice.point(corner), lattice.seed) // 256 * factor) % 2**32

        for name, arithmetic in itertools.product(NAMES, ARITHMETICS):
            noise, of_noise = (getattr(found, arithmetic) for found in of(name))
            for p, seed, periods in places("others"):
                found = of_noise(Knobs("lattice"), p, seed, periods)
                self.assertEqual(len(found), len(p))
                for value, factor in zip(found[1:], (0xEB1831, 0x84A5E5)):
                    with mock.patch.object(Lattice, "word", other):
                        self.assertEqual((value,), noise(Knobs("lattice"), p, seed, periods))

    def test_they_are_not_alike(self) -> None:
        # Of 200 independent values the correlation is about 0.07.
        for name, n in itertools.product(NAMES, (2, 3)):
            numbers, found = generator_of(f"alike{n}"), []
            for _ in range(200):
                p = [numbers.uniform(-100, 100) for _ in range(n)]
                found.append(list(map(float, of(name)[1].fixed(Knobs("lattice"), p, 3))))
            for a, b in itertools.combinations(zip(*found), 2):
                product = sum(x * y for x, y in zip(a, b))
                self.assertLess(product**2, 0.09 * sum(x * x for x in a) * sum(y * y for y in b))

    def test_cells_meet(self) -> None:
        # f = 1 in one cell is f = 0 in the next: at the seam of a period, and where cells wrap without one.
        for name, n in itertools.product(NAMES, (2, 3)):
            for cell, following, period in ((4, 0, 5), (INT_MAX, -2**31, 0), (0, 0, 1)):
                ends = [of(name)[1].exact_cell(Knobs("lattice"), (c, 3, 3)[:n], (f, 0.25, 0.75)[:n], 9, (period,) * n)
                        for c, f in ((cell, 1.0), (following, 0.0))]
                self.assertEqual(*ends)

    def test_only_in_two_and_three_dimensions(self) -> None:
        for name, n, arithmetic in itertools.product(NAMES, (1, 4), ARITHMETICS):
            with self.assertRaisesRegex(ValueError, "two and three"):
                getattr(of(name)[1], arithmetic)(Knobs("lattice"), (0.5,) * n)

    def test_of_a_noise_with_more_numbers_there_is_none(self) -> None:
        with self.assertRaises(ValueError):
            vector(lambda *_: (1, 2))(Lattice(Knobs("lattice")), (0, 0), (0, 0))


if __name__ == "__main__":
    unittest.main()
