"""Tests of uniform.py: against the page, and what it promises."""

from __future__ import annotations

import itertools
import math
import re
import unittest
from collections.abc import Sequence
from fractions import Fraction

from base.tree import ROOT
from proof.golden.generator import generator_of
from proof.oracle import uniform

CONTRACT = (ROOT / "docs" / "reference" / "contract.md").read_text(encoding="utf-8")
PAGE = CONTRACT.partition("\n## 21. ")[2].partition("\n## ")[0]
PLAIN = uniform.spread(uniform.PERLIN2)
# In order, at the ends, and out of order or of range.
SPREADS = (PLAIN, uniform.spread(12), (1.0, 0.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0), (0.3, 0.0, 0.0, 1.0),
           (3.0, 0.0, 1.0, 1.0), (0.0625, 0.25, 0.5, 0.75), (0.01, 0.9, 0.5, 0.1), (5.0, -1.0, 2.0, 0.5))
COUNT = 60
BOTH = (uniform.uniform_d, uniform.fixed_uniform_d)


def values(reach: float) -> list[Fraction]:
    """From beyond one end to beyond the other."""
    reach = uniform.clamped(reach, uniform.LEAST_REACH, uniform.LARGEST_REACH)
    return [reach * i / 32 for i in range(-34, 35)]


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
    """A tail that falls, or jumps at its ends, or a number that is taken into another range."""

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


class Sums(unittest.TestCase):
    """A spread of a sum that differs in the two arithmetics where both are known."""

    def test_one(self) -> None:
        """A single octave has the spread of the noise itself."""
        for spread in SPREADS:
            inside = uniform.in_range(*spread)
            for octaves, gain in ((1.0, 0.5), (0.0, 1.0), (-3.0, 0.7), (32.0, 0.0), (7.5, -1.0)):
                self.assertEqual(uniform.spread_fbm(*spread, octaves, gain), inside)
                for x, fixed in zip(inside, uniform.fixed_spread_fbm(*spread, octaves, gain)):
                    self.assertEqual(fixed, Fraction(math.trunc(x * 2**18), 2**18))

    def test_two_equal_octaves(self) -> None:
        """By hand: S_n is 2, so that rho_4 is 1/2 and rho_8 is 1/8. c is 1/32 above the bell's."""
        found = uniform.spread_fbm(1.0, 0.125, 0.375, 0.75, 2.0, 1.0)
        d = Fraction(32, 1024)
        for i, (x, bell, way) in enumerate(((128, 103, 592), (384, 381, 1958), (768, 736, 452)), 1):
            self.assertEqual(1024 * found[i], bell + way * d / 2 + (x - bell - way * d) / 8)
