"""What holds for every noise of the oracle, in each number of dimensions and with each gradient that bounds.inc has.

A noise that is added needs no test here. Each check must find the fault that is planted for it.
"""

from __future__ import annotations

import math
import unittest
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from bounds import table
from bounds.table import Bounds
from golden.rows import Generator, generator_of
from oracle import noises
from oracle.gradients import Knobs
from oracle.integers import NOISE_UNIT, UNIT
from oracle.noises import Noise

PERIOD = 48
POINTS = 24


def settings(bounds: Bounds) -> list[Knobs]:
    sine = bounds.gradient == "sine"
    return [Knobs("lattice", sine), Knobs("fnv1", sine), Knobs("lattice", sine, PERIOD)]


def points(bounds: Bounds, numbers: Generator, count: int = POINTS) -> Iterator[tuple[list[Fraction], int]]:
    """Positions that fixed arithmetic does not cut, and seeds."""
    for _ in range(count):
        yield [Fraction(numbers.integer(-2**26, 2**26), UNIT) for _ in range(bounds.dimensions)], numbers.word()


class EveryNoise(unittest.TestCase):
    def check_position(self, noise: Noise, bounds: Bounds) -> None:
        """A position is a cell and a fraction, down to the smallest cell."""
        smallest = [Fraction(-2**31)] + [Fraction(1, 4)] * (bounds.dimensions - 1)
        for knobs in settings(bounds):
            for p, seed in [*points(bounds, generator_of("position"), 8), (smallest, 3)]:
                cell = [math.floor(x) for x in p]
                f = [x - c for x, c in zip(p, cell)]
                self.assertEqual(noise.exact(knobs, p, seed), noise.exact_cell(knobs, cell, f, seed))
                self.assertEqual(noise.fixed(knobs, p, seed), noise.fixed_cell(knobs, cell, f, seed))

    def check_fixed(self, noise: Noise, bounds: Bounds) -> None:
        """Fixed arithmetic is within its bound, and gives floats."""
        for knobs in settings(bounds):
            for p, seed in points(bounds, generator_of("fixed")):
                value = noise.fixed(knobs, p, seed)
                self.assertLessEqual(abs(value - noise.exact(knobs, p, seed)), bounds.fixed_error)
                self.assertEqual((value * NOISE_UNIT).denominator, 1)

    def check_range(self, noise: Noise, bounds: Bounds) -> None:
        """Values are in their range, and use it."""
        for knobs in settings(bounds):
            sample = list(points(bounds, generator_of("range"), 2 * POINTS))
            exact = [noise.exact(knobs, p, seed) for p, seed in sample]
            fixed = [noise.fixed(knobs, p, seed) for p, seed in sample]
            for values, limit in ((exact, bounds.limit), (fixed, bounds.fixed_limit)):
                self.assertLessEqual(max(map(abs, values)), limit)
                self.assertGreater(max(values) - min(values), 0.5 * limit)

    def check_period(self, noise: Noise, bounds: Bounds) -> None:
        """With a period a noise repeats along each axis, without one it does not."""
        for knobs in settings(bounds):
            for axis in range(bounds.dimensions):
                repeated = []
                for p, seed in points(bounds, generator_of("period"), 4):
                    moved = [x + PERIOD * (i == axis) for i, x in enumerate(p)]
                    repeated += [of(knobs, p, seed) == of(knobs, moved, seed) for of in (noise.exact, noise.fixed)]
                self.assertEqual(all(repeated), knobs.period == PERIOD, knobs)

    def check_seeds(self, noise: Noise, bounds: Bounds) -> None:
        """Every seed gives another field."""
        for knobs in settings(bounds):
            (p, _), = points(bounds, generator_of("seeds"), 1)
            for of in (noise.exact, noise.fixed):
                self.assertEqual(len({of(knobs, p, seed) for seed in range(32)}), 32)

    def check_hashes(self, noise: Noise, bounds: Bounds) -> None:
        """So does every hash."""
        lattice, fnv1, _ = settings(bounds)
        for p, seed in points(bounds, generator_of("hashes"), 4):
            for of in (noise.exact, noise.fixed):
                self.assertNotEqual(of(lattice, p, seed), of(fnv1, p, seed))

    def on_every_noise(self, check: Callable[[Noise, Bounds], None]) -> None:
        for bounds in table.read():
            with self.subTest(noise=bounds.noise, dimensions=bounds.dimensions, gradient=bounds.gradient):
                check(noises.find(bounds.noise), bounds)

    def test_every_noise_has_bounds(self) -> None:
        self.assertEqual(sorted({bounds.noise for bounds in table.read()}), noises.names())

    def test_a_position_is_a_cell_and_a_fraction(self) -> None:
        self.on_every_noise(self.check_position)

    def test_fixed_arithmetic_is_within_its_bound(self) -> None:
        self.on_every_noise(self.check_fixed)

    def test_values_are_in_their_range(self) -> None:
        self.on_every_noise(self.check_range)

    def test_a_period_takes_effect(self) -> None:
        self.on_every_noise(self.check_period)

    def test_seeds_take_effect(self) -> None:
        self.on_every_noise(self.check_seeds)

    def test_hashes_take_effect(self) -> None:
        self.on_every_noise(self.check_hashes)

    def test_each_check_finds_its_fault(self) -> None:
        perlin, bounds = noises.find("perlin"), table.bounds_of("perlin", 2, "octahedral")
        exact, fixed = perlin.exact_in_cell, perlin.fixed_in_cell
        two_bounds = math.ceil(2 * bounds.fixed_error * NOISE_UNIT)

        class Rounding(Noise):
            """It takes the nearest cell."""
            def exact(self, knobs, p, seed=0):
                cell = [round(x) for x in p]
                return self.exact_in_cell(knobs, cell, [abs(x - c) for x, c in zip(p, cell)], seed)

        def with_knobs(**change) -> list[Noise]:
            """One that ignores a knob, in exact and in fixed arithmetic."""
            def ignoring(of: Callable) -> Callable:
                return lambda knobs, *args: of(replace(knobs, **change), *args)
            return [replace(perlin, exact_in_cell=ignoring(exact)), replace(perlin, fixed_in_cell=ignoring(fixed))]

        for check, faults in (
                (self.check_position, [Rounding("rounding", exact, fixed)]),
                (self.check_fixed, [replace(perlin, fixed_in_cell=lambda *args: fixed(*args) + two_bounds)]),
                (self.check_range, [replace(perlin, exact_in_cell=lambda *args: 3 * exact(*args)),
                                    replace(perlin, fixed_in_cell=lambda *args: 3 * fixed(*args)),
                                    replace(perlin, exact_in_cell=lambda *args: exact(*args) / 4)]),
                (self.check_period, [*with_knobs(period=0), replace(perlin, exact_in_cell=lambda *args: 0,
                                                                    fixed_in_cell=lambda *args: 0)]),
                (self.check_seeds, [replace(perlin, exact_in_cell=lambda *args: exact(*args[:-1], 0)),
                                    replace(perlin, fixed_in_cell=lambda *args: fixed(*args[:-1], 0))]),
                (self.check_hashes, with_knobs(hash="pcg"))):
            for fault in faults:
                with self.assertRaises(AssertionError, msg=check.__doc__):
                    check(fault, bounds)


class Finding(unittest.TestCase):
    def test_a_noise_that_is_not_there(self) -> None:
        with self.assertRaisesRegex(LookupError, "write tools/lib/oracle/noises/merlin.py from docs/contract.md"):
            noises.find("merlin")
