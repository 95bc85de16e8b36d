"""Tests of components.py: what holds for every vector of noises from one hash."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from catalog.tables.functions import read_functions
from proof.golden.generator import INT_MAX, generator_of
from proof.oracle import components, noises, words
from proof.oracle.components import component, vector
from proof.oracle.functions import evaluator
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise

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

    def check_derivatives(self) -> None:
        """Of each component, beside differences of the exact vector."""
        step = Fraction(1, 2**40)
        for name in NAMES:
            _, of_noise = of(name)
            for p, seed, periods in places("derivatives", 8):
                for i in range(len(p)):
                    value, *slopes = component(noises.find(f"{name}_d"), i).exact(Knobs("lattice"), p, seed, periods)
                    self.assertEqual(value, of_noise.exact(Knobs("lattice"), p, seed, periods)[i])
                    for axis, slope in enumerate(slopes):
                        low, high = (of_noise.exact(Knobs("lattice"), [x + side * step * (j == axis)
                                                                      for j, x in enumerate(p)], seed, periods)[i]
                                     for side in (-1, 1))
                        self.assertLess(abs((high - low) / (2 * step) - slope), 2**-32)

    def check_fixed_derivatives(self) -> None:
        """With the bits of the vector, and near the exact ones."""
        for name in NAMES:
            for p, seed, periods in places("fixed derivatives", 8):
                found = of(name)[1].fixed(Knobs("lattice"), p, seed, periods)
                for i in range(len(p)):
                    noise = component(noises.find(f"{name}_d"), i)
                    value, *slopes = noise.fixed(Knobs("lattice"), p, seed, periods)
                    self.assertEqual(value, found[i])
                    for a, b in zip(slopes, noise.exact(Knobs("lattice"), p, seed, periods)[1:], strict=True):
                        self.assertLess(abs(a - b), 2**-11)

    def test_derivatives(self) -> None:
        self.check_derivatives()
        self.check_fixed_derivatives()

    def test_derivatives_of_another_component_are_noticed(self) -> None:
        for factors in ((1, 0x84A5E5, 0xEB1831), (1, 0xEB1833, 0x84A5E7)):
            right = Lattice.word

            def other(lattice: Lattice, corner: list[int]) -> int:
                if lattice.component == 0:
                    return right(lattice, corner)
                word = words.point_word("lattice", lattice.point(corner), lattice.seed)
                return word // 256 * factors[lattice.component] % 2**32

            def of_noise(noise: Noise, i: int) -> Noise:
                def patched(in_cell: Callable) -> Callable:
                    def found(*rest: object) -> tuple:
                        with mock.patch.object(Lattice, "word", other):
                            return in_cell(*rest)
                    return found

                found = components.component(noise, i)
                return replace(found, exact_in_cell=patched(found.exact_in_cell),
                               fixed_in_cell=patched(found.fixed_in_cell))

            for check in (self.check_derivatives, self.check_fixed_derivatives):
                with mock.patch.dict(globals(), component=of_noise), self.assertRaises(AssertionError):
                    check()

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
            right = (noise.fixed if fixed else noise.exact)(Knobs("lattice"), p, 5, periods)
            self.assertEqual(evaluator(function, fixed)(Knobs("lattice"), (*place, 5)), right, function.id)
            self.assertEqual(function.component, "xyz".index(function.id[-1]))

    def test_components_that_are_not_there(self) -> None:
        for n, i in ((1, 0), (2, 2), (4, 1)):
            with self.assertRaisesRegex(ValueError, f"in {n}D has no component {i}"):
                component(noises.find("value_d"), i).exact(Knobs("lattice"), (0.5,) * n)

    def test_of_a_noise_with_more_numbers_there_is_none(self) -> None:
        with self.assertRaises(ValueError):
            vector(lambda *_: (1, 2))(Lattice(Knobs("lattice")), (0, 0), (0, 0))


if __name__ == "__main__":
    unittest.main()
