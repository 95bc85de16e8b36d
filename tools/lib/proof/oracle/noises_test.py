"""What holds for every noise of the oracle, in each number of dimensions and with each gradient that bounds.inc has.

A noise that is added needs no test here. Each check must find the fault that is planted for it.
"""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from base.thorough import THOROUGH
from proof.bounds import table
from proof.bounds.table import Bounds
from proof.golden.generator import Generator, generator_of
from proof.oracle import noises
from proof.oracle.components import component
from proof.oracle.curl import CURL
from proof.oracle.gradients import Knobs
from proof.oracle.hexes import HEXES
from proof.oracle.integers import NOISE_UNIT, UNIT
from proof.oracle.lattice import Choice, Lattice
from proof.oracle.noises import Noise

PERIOD = 48
POINTS = 24
PHASE = 0.3  # of noises that turn
WAVE = (2.25, -1.5, 0.7)  # of phasor noise
# How much of their range values use at least. The factors of a product, as a curl in space is, are seldom large
# together, and nearly all positions are far nearer to points of cells, and to borders, than the farthest one.
USED, SELDOM_USED = 0.5, 0.25


# What has bounds and a place as noises have, and is none. Of a vector with derivatives the second component stands for
# all.
NO_NOISES = {of.name: of for of in (CURL, HEXES)} | {
    f"{of}_vector_d": component(noises.find(f"{of}_d"), 1) for of in ("perlin", "value")}


def settings(bounds: Bounds) -> list[Knobs]:
    sine = bounds.gradient == "sine"
    return [Knobs("lattice", sine), Knobs("fnv1", sine)]


def tried_settings(bounds: Bounds) -> list[Knobs]:
    """A noise sees a hash through the lattice alone, so one of them stands for both."""
    return settings(bounds) if THOROUGH else settings(bounds)[:1]


def noise_of(bounds: Bounds) -> Noise:
    """With its gradients turned, if they turn."""
    noise = NO_NOISES.get(bounds.noise) or noises.find(bounds.noise)
    if bounds.noise in ("phasor", "phasor_d"):
        noise = noise.chosen(Choice(wave=WAVE[:bounds.dimensions]))
    return noise if noise.phase is None else noise.turned(PHASE)


def is_cellular(noise: Noise) -> bool:
    """Whether it returns distances, with a metric."""
    return noise.outputs[0] == "first"


def with_each_metric(noise: Noise) -> list[Noise]:
    """Its bounds are those of all metrics; points that move have one."""
    has_metrics = is_cellular(noise) and noise.phase is None
    return [noise.chosen(Choice(metric=metric)) for metric in (1, 2, 3, 4, 5)] if has_metrics else [noise]


def values_of(noise: Noise, numbers: Sequence[Fraction]) -> Sequence[Fraction]:
    """The value, each distance, or each component, without derivatives."""
    return numbers if is_cellular(noise) or noise.outputs == noises.VECTOR else numbers[:1]


def points(bounds: Bounds, numbers: Generator, count: int = POINTS) -> Iterator[tuple[list[Fraction], int]]:
    """Positions that fixed arithmetic does not cut, and seeds."""
    for _ in range(count):
        yield [Fraction(numbers.integer(-2**26, 2**26), UNIT) for _ in range(bounds.dimensions)], numbers.word()


class EveryNoise(unittest.TestCase):
    def check_position(self, noise: Noise, bounds: Bounds) -> None:
        """A position is a cell and a fraction, down to the smallest cell."""
        smallest = [Fraction(-2**31)] + [Fraction(1, 4)] * (bounds.dimensions - 1)
        for knobs, period in itertools.product(tried_settings(bounds), (0, PERIOD)):
            for p, seed in [*points(bounds, generator_of("position"), 8), (smallest, 3)]:
                cell = [math.floor(x) for x in p]
                f = [x - c for x, c in zip(p, cell)]
                arguments = (seed, (period,) * bounds.dimensions)
                self.assertEqual(noise.exact(knobs, p, *arguments), noise.exact_cell(knobs, cell, f, *arguments))
                self.assertEqual(noise.fixed(knobs, p, *arguments), noise.fixed_cell(knobs, cell, f, *arguments))

    def check_fixed(self, noise: Noise, bounds: Bounds) -> None:
        """Fixed arithmetic is within its bound, and gives floats."""
        for knobs, of in itertools.product(tried_settings(bounds), with_each_metric(noise)):
            for p, seed in points(bounds, generator_of("fixed")):
                for fixed, exact, unit in zip(values_of(of, of.fixed(knobs, p, seed)), of.exact(knobs, p, seed), of.units):
                    self.assertLessEqual(abs(fixed - exact), bounds.fixed_error)
                    self.assertEqual((fixed * unit).denominator, 1)

    def check_range(self, noise: Noise, bounds: Bounds) -> None:
        """Values are in their range, and use it."""
        for knobs in tried_settings(bounds):
            sample = list(itertools.product(with_each_metric(noise), points(bounds, generator_of("range"), 2 * POINTS)))
            exact = [value for of, (p, seed) in sample for value in values_of(of, of.exact(knobs, p, seed))]
            fixed = [value for of, (p, seed) in sample for value in values_of(of, of.fixed(knobs, p, seed))]
            for values, limit in ((exact, bounds.limit), (fixed, bounds.fixed_limit)):
                self.assertLessEqual(max(map(abs, values)), limit)
                seldom = noise.name in (CURL.name, "cell_border") or is_cellular(noise)
                self.assertGreater(max(values) - min(values), (SELDOM_USED if seldom else USED) * limit)

    def check_period(self, noise: Noise, bounds: Bounds) -> None:
        """Along the axis that has a period a noise repeats, along the others it does not."""
        for knobs, with_period in itertools.product(tried_settings(bounds), range(bounds.dimensions)):
            periods = [PERIOD if i == with_period else -PERIOD for i in range(bounds.dimensions)]
            for axis in range(bounds.dimensions):
                for p, seed in points(bounds, generator_of("period"), 2):
                    moved = [x + PERIOD * (i == axis) for i, x in enumerate(p)]
                    for of in (noise.exact, noise.fixed):
                        same = of(knobs, p, seed, periods) == of(knobs, moved, seed, periods)
                        self.assertEqual(same, axis == with_period, knobs)

    def check_no_period(self, noise: Noise, bounds: Bounds) -> None:
        """Where no point is moved, a period changes nothing."""
        for knobs, (p, seed) in itertools.product(tried_settings(bounds), points(bounds, generator_of("no period"), 4)):
            inside = [abs(x) % 8 + 1 for x in p]
            for of, period in itertools.product((noise.exact, noise.fixed), (0, -1, 2**31 - 1, 11)):
                self.assertEqual(of(knobs, inside, seed), of(knobs, inside, seed, (period,) * bounds.dimensions))

    def check_seeds(self, noise: Noise, bounds: Bounds) -> None:
        """Every seed gives another field."""
        for knobs in tried_settings(bounds):
            # At two places: some two of 32 seeds may well give the nearest cell the same of 1024 points.
            two = [p for p, _ in points(bounds, generator_of("seeds"), 2)]
            for of in (noise.exact, noise.fixed):
                self.assertEqual(len({tuple(of(knobs, p, seed) for p in two) for seed in range(32)}), 32)

    def check_hashes(self, noise: Noise, bounds: Bounds) -> None:
        """So does every hash."""
        lattice, fnv1 = settings(bounds)
        for p, seed in points(bounds, generator_of("hashes"), 4):
            for of in (noise.exact, noise.fixed):
                self.assertNotEqual(of(lattice, p, seed), of(fnv1, p, seed))

    def on_every_noise(self, check: Callable[[Noise, Bounds], None]) -> None:
        for bounds in table.read():
            with self.subTest(noise=bounds.noise, dimensions=bounds.dimensions, gradient=bounds.gradient):
                check(noise_of(bounds), bounds)

    def test_every_noise_has_bounds(self) -> None:
        self.assertEqual(sorted({bounds.noise for bounds in table.read()}), sorted([*noises.names(), *NO_NOISES]))

    def test_a_position_is_a_cell_and_a_fraction(self) -> None:
        self.on_every_noise(self.check_position)

    def test_fixed_arithmetic_is_within_its_bound(self) -> None:
        self.on_every_noise(self.check_fixed)

    def test_values_are_in_their_range(self) -> None:
        self.on_every_noise(self.check_range)

    def test_a_period_takes_effect(self) -> None:
        self.on_every_noise(self.check_period)

    def test_a_period_changes_nothing_else(self) -> None:
        self.on_every_noise(self.check_no_period)

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
            def exact(self, knobs, p, seed=0, periods=()):
                cell = [round(x) for x in p]
                return self.exact_cell(knobs, cell, [abs(x - c) for x, c in zip(p, cell)], seed, periods)

        def on_lattice(change: Callable[[Lattice], dict]) -> list[Noise]:
            """One on another lattice, in exact and in fixed arithmetic."""
            def ignoring(of: Callable) -> Callable:
                return lambda lattice, *args: of(replace(lattice, **change(lattice)), *args)
            return [replace(perlin, exact_in_cell=ignoring(exact)), replace(perlin, fixed_in_cell=ignoring(fixed))]

        for check, faults in (
                (self.check_position, [Rounding("rounding", exact, fixed)]),
                (self.check_fixed, [replace(perlin, fixed_in_cell=lambda *args: (fixed(*args)[0] + two_bounds,))]),
                (self.check_range, [replace(perlin, exact_in_cell=lambda *args: (3 * exact(*args)[0],)),
                                    replace(perlin, fixed_in_cell=lambda *args: (3 * fixed(*args)[0],)),
                                    replace(perlin, exact_in_cell=lambda *args: (exact(*args)[0] / 4,))]),
                (self.check_period, [*on_lattice(lambda lattice: {"periods": ()}),
                                     *on_lattice(lambda lattice: {"periods": (PERIOD, PERIOD)})]),
                (self.check_no_period, on_lattice(lambda lattice: {"periods": tuple(p - 7 for p in lattice.periods)})),
                (self.check_seeds, on_lattice(lambda lattice: {"seed": 0})),
                (self.check_hashes, on_lattice(lambda lattice: {"knobs": Knobs("pcg")}))):
            for fault in faults:
                with self.assertRaises(AssertionError, msg=check.__doc__):
                    check(fault, bounds)

    def test_a_fault_of_one_metric_or_of_one_distance_is_found(self) -> None:
        cellular, bounds = noises.find("cellular"), table.bounds_of("cellular", 2, "none")
        exact, fixed = cellular.exact_in_cell, cellular.fixed_in_cell

        def faulty(of: Callable, error: float, output: int, metric: int) -> Callable:
            def found(lattice: Lattice, *args) -> tuple:
                return tuple(value + error * (i == output and lattice.choice.metric == metric)
                             for i, value in enumerate(of(lattice, *args)))
            return found

        two_bounds = math.ceil(2 * bounds.fixed_error * UNIT)
        for output, metric in itertools.product((0, 1), (1, 2, 3, 4, 5)):
            with self.assertRaises(AssertionError):
                self.check_fixed(replace(cellular, fixed_in_cell=faulty(fixed, two_bounds, output, metric)), bounds)
            with self.assertRaises(AssertionError):
                self.check_range(replace(cellular, exact_in_cell=faulty(exact, 4, output, metric)), bounds)


class Finding(unittest.TestCase):
    def test_a_noise_that_is_not_there(self) -> None:
        with self.assertRaisesRegex(LookupError, "write tools/lib/proof/oracle/noises/merlin.py from docs/contract.md"):
            noises.find("merlin")
