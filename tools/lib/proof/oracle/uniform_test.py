"""Tests of uniform.py: against the page, what it promises, and each other."""

from __future__ import annotations

import itertools
import math
import re
import unittest
from collections.abc import Sequence
from fractions import Fraction

from base.tree import ROOT
from proof.golden.generator import Generator, generator_of, to_f32
from proof.oracle import uniform

CONTRACT = (ROOT / "docs" / "reference" / "contract.md").read_text(encoding="utf-8")
PAGE = CONTRACT.partition("\n## 21. ")[2].partition("\n## ")[0]
PLAIN = uniform.spread(uniform.PERLIN2)
# In order, at the ends, and out of order or of range.
SPREADS = (PLAIN, uniform.spread(12), (1.0, 0.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0), (0.3, 0.0, 0.0, 1.0),
           (3.0, 0.0, 1.0, 1.0), (0.0625, 0.25, 0.5, 0.75), (0.01, 0.9, 0.5, 0.1), (5.0, -1.0, 2.0, 0.5))
COUNT = 60
# How far fixed arithmetic is off: a value, a slope times the reach, a reach, and another number.
VALUE, SLOPE, REACH, COEFFICIENT = 2.0**-15, 2.0**-12, 2.0**-13, 2.0**-15
BOTH = (uniform.uniform_d, uniform.fixed_uniform_d)


def some_spread(draws: Generator) -> tuple[float, ...]:
    if draws.integer(0, 1):
        return draws.pick(SPREADS)
    return (draws.uniform(0.07, 2.9), *sorted(draws.uniform(0, 1) for _ in range(3)))


def some_sum(draws: Generator) -> tuple[float, ...]:
    octaves = draws.pick((1.0, 2.0, 32.0, draws.uniform(1, 2), draws.uniform(1, 32)))
    gain = draws.pick((0.0, 0.5, 1.0, draws.uniform(0, 1), draws.uniform(0.95, 1)))
    return *some_spread(draws), octaves, gain


def value_of(value: Fraction, *spread: float) -> Fraction:
    return uniform.uniform_d(value, *spread)[0]


def values(reach: float) -> list[Fraction]:
    """From beyond one end to beyond the other."""
    reach = uniform.clamped(reach, uniform.LEAST_REACH, uniform.LARGEST_REACH)
    return [reach * i / 32 for i in range(-34, 35)]


def integral(reach: Fraction, *coefficients: Fraction) -> Fraction:
    """The variance of values with such a spread: reach^2 times the integral of 2 s T by s."""
    numbers, found = (Fraction(0), *coefficients, Fraction(1)), Fraction(0)
    for k, number in enumerate(numbers):  # of the weight of each in powers of y = w^2, and s is 1 - w
        for j in range(5 - k):
            power = 2 * (k + j)
            weight = math.comb(4, k) * math.comb(4 - k, j) * (-1)**j
            found += 2 * number * weight * (Fraction(1, power + 1) - Fraction(1, power + 2))
    return reach**2 * found


class Page(unittest.TestCase):
    """A constant that is not the contract's."""

    def test_table(self) -> None:
        rows = re.findall(r"^\| `hn_.*\| (\d+) \| `HN_DISTRIBUTION_(\w+)` \| (\d+) \| (\d+) \| (\d+) \| (\d+) \|$", PAGE,
                          re.MULTILINE)
        self.assertEqual([int(row[0]) for row in rows], list(range(1, len(uniform.TABLE) + 1)))
        self.assertEqual([tuple(map(int, row[2:])) for row in rows], list(uniform.TABLE))
        self.assertEqual([int(number) for number, name, *_ in rows if name == "PERLIN2"], [uniform.PERLIN2])

    def test_constants(self) -> None:
        def listed(numbers: Sequence[int]) -> str:
            return f"({', '.join(map(str, numbers))}) / {uniform.PARTS}"

        v = "{} a + {} b + {} c + {}".format(*uniform.VARIANCE)
        for text in (f"`B` is `{listed(uniform.BELL)}`", f"`H` is `{listed(uniform.WAY)}`", f"V(a, b, c) = {v}\n",
                     f"to [1, {uniform.MOST_OCTAVES}]", f"[1/16, {uniform.LARGEST_REACH}]",
                     f"{uniform.TABLE_UNIT} times their distributions"):
            self.assertIn(text, PAGE)

    def test_spreads_by_number(self) -> None:
        for noise, row in enumerate(uniform.TABLE, 1):
            self.assertEqual(uniform.spread(noise), tuple(x / 4096 for x in row))
        for other in (0, -1, len(uniform.TABLE) + 1, 2**31 - 1, -2**31):
            self.assertEqual(uniform.spread(other), PLAIN)


class Values(unittest.TestCase):
    """A tail that is another polynomial, falls, jumps or has another slope, or a number that is cut in another way."""

    def test_ends(self) -> None:
        for spread, of in itertools.product(SPREADS, BOTH):
            reach = uniform.clamped(spread[0], uniform.LEAST_REACH, uniform.LARGEST_REACH)
            for far in (reach, reach * 2, 3, 2**100):
                # A reach of 0 is at the end, too.
                self.assertEqual(of(far, *spread), (1, 0), spread)
                self.assertEqual(of(-far, *spread), (0, 0), spread)
            for zero in (0, -0.0):
                self.assertEqual(of(zero, *spread)[0], Fraction(1, 2), spread)

    def test_order(self) -> None:
        for spread, of in itertools.product(SPREADS, BOTH):
            found = [of(value, *spread) for value in values(spread[0])]
            self.assertEqual([value for value, _ in found], sorted(value for value, _ in found))
            self.assertTrue(all(0 <= value <= 1 and slope >= 0 for value, slope in found))
            # Symmetrical: what is in the middle has a sign of its own.
            for (value, slope), (other, other_slope) in zip(found, reversed(found)):
                self.assertTrue(value == other == Fraction(1, 2) or value == 1 - other)
                self.assertEqual(slope, other_slope)

    def test_slope(self) -> None:
        """Between two places the mean slope is that in the middle, but for the third derivative."""
        step = Fraction(1, 2**60)
        for spread in SPREADS:
            for value in values(spread[0]):
                value += Fraction(spread[0]) / 100
                mean = (value_of(value + step, *spread) - value_of(value - step, *spread)) / (2 * step)
                self.assertAlmostEqual(float(mean), float(uniform.uniform_d(value, *spread)[1]), delta=2.0**-80)

    def test_steps(self) -> None:
        """From a number of fixed arithmetic to the next it never falls, either."""
        draws = generator_of("uniform_test.next")
        for spread in SPREADS:
            reach = min(max(spread[0], 0.0625), 3.0)
            for start in (-reach, -0.0, reach * draws.uniform(-1, 1)):
                first = math.floor(start * uniform.UNIT) - COUNT // 2
                found = [uniform.fixed_uniform_d(Fraction(i, uniform.UNIT), *spread)[0]
                         for i in range(first, first + COUNT)]
                self.assertEqual(found, sorted(found), spread)

    def test_a_straight_line_of_tails(self) -> None:
        """With numbers at 1/4, 1/2 and 3/4 the tail is y; with all at 0 or 1 it is one of two powers."""
        for spread, tail in (((1, 0.25, 0.5, 0.75), lambda y: y), ((1, 0, 0, 0), lambda y: y**4),
                             ((1, 1, 1, 1), lambda y: 1 - (1 - y)**4)):
            for value in values(1)[2:-2]:
                y = (1 - abs(value))**2
                found = value_of(value, *spread)
                self.assertEqual(2 * (1 - found if value >= 0 else found), tail(y))
                fixed = uniform.fixed_uniform_d(value, *spread)[0]
                self.assertLess(abs(fixed - found), VALUE)

    def test_a_spread_out_of_its_range_is_taken_into_it(self) -> None:
        for out, inside in (((9.0, -1.0, 2.0, 0.5), (3.0, 0.0, 1.0, 1.0)),
                            ((-1.0, 0.9, 0.5, 0.1), (0.0625, 0.9, 0.9, 0.9)),
                            ((1.0, 2.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0)),
                            ((1.0, 0.5, 0.1, 0.7), (1.0, 0.5, 0.5, 0.7))):
            for value in (0.03, -0.5, 2.0):
                for of in (uniform.uniform_d, uniform.fixed_uniform_d):
                    self.assertEqual(of(value, *out), of(value, *inside))
            for of in (uniform.spread_fbm, uniform.fixed_spread_fbm):
                self.assertEqual(of(*out, 3.5, 0.5), of(*inside, 3.5, 0.5))

    def test_fixed_is_near(self) -> None:
        draws, errors = generator_of("uniform_test.fixed"), [0.0, 0.0]
        for _ in range(8 * COUNT):
            spread = some_spread(draws)
            reach = uniform.in_range(*spread)[0]
            value = to_f32(float(reach) * draws.uniform(-1.01, 1.01))
            exact, fixed = uniform.uniform_d(value, *spread), uniform.fixed_uniform_d(value, *spread)
            errors[0] = max(errors[0], float(abs(exact[0] - fixed[0])))
            errors[1] = max(errors[1], float(abs(exact[1] - fixed[1]) * reach))
        self.assertTrue(VALUE / 8 < errors[0] < VALUE and SLOPE / 8 < errors[1] < SLOPE, errors)


class Sums(unittest.TestCase):
    """A spread of a sum that has another variance, or differs in the two arithmetics."""

    def test_one(self) -> None:
        """A single octave has the spread of the noise itself."""
        for spread in SPREADS:
            inside = uniform.in_range(*spread)
            for octaves, gain in ((1.0, 0.5), (0.0, 1.0), (-3.0, 0.7), (32.0, 0.0), (7.5, -1.0)):
                self.assertEqual(uniform.spread_fbm(*spread, octaves, gain), inside)
                for x, fixed in zip(inside, uniform.fixed_spread_fbm(*spread, octaves, gain)):
                    self.assertEqual(fixed, Fraction(math.trunc(x * 2**18), 2**18))

    def test_variance(self) -> None:
        """A sum has the variance of a noise times the sum of the squares of the weights, divided by their total's."""
        draws = generator_of("uniform_test.variance")
        for _ in range(COUNT):
            *spread, octaves, gain = some_sum(draws)
            found = uniform.weights(octaves, gain)
            of_sum = integral(*uniform.spread_fbm(*spread, octaves, gain))
            right = integral(*uniform.in_range(*spread)) * sum(a**2 for a in found) / sum(found)**2
            self.assertLess(abs(of_sum - right), right * 2 * uniform.ROOT_ERROR)

    def test_two_equal_octaves(self) -> None:
        """By hand: S_n is 2, so that rho_4 is 1/2 and rho_8 is 1/8. c is 1/32 above the bell's."""
        found = uniform.spread_fbm(1.0, 0.125, 0.375, 0.75, 2.0, 1.0)
        d = Fraction(32, 1024)
        for i, (x, bell, way) in enumerate(((128, 103, 592), (384, 381, 1958), (768, 736, 452)), 1):
            self.assertEqual(1024 * found[i], bell + way * d / 2 + (x - bell - way * d) / 8)

    def test_a_rational_root_is_exact(self) -> None:
        for x in (Fraction(9, 4), Fraction(1, 3)**2, Fraction(0)):
            self.assertEqual(uniform.root(x)**2, x)
        x = Fraction(2, 7)
        self.assertTrue(x * (1 - uniform.ROOT_ERROR) < uniform.root(x)**2 < x)

    def test_fixed_is_near(self) -> None:
        draws, errors = generator_of("uniform_test.fixed_sums"), [0.0, 0.0]
        for _ in range(5 * COUNT):
            arguments = some_sum(draws)
            pairs = zip(uniform.spread_fbm(*arguments), uniform.fixed_spread_fbm(*arguments), strict=True)
            first, *others = [float(abs(exact - fixed)) for exact, fixed in pairs]
            errors = [max(errors[0], first), max(errors[1], *others)]
        self.assertTrue(REACH / 8 < errors[0] < REACH and COEFFICIENT / 8 < errors[1] < COEFFICIENT, errors)
