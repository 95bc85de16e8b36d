"""Tests of perlin_worley.py: by hand, by its parts, and what rows of golden files see of it."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from catalog.tables.configurations import read_configurations
from catalog.tables.functions import read_functions
from proof.golden import perlin_worley_rows
from proof.golden.files import golden_files
from proof.golden.generator import Row, generator_of
from proof.oracle import functions, noises, perlin_worley, sums, words
from proof.oracle.gradients import Knobs, Real
from proof.oracle.integers import NOISE_UNIT
from proof.oracle.sums import Options
from proof.oracle.testing import KNOBS, FaultChecks

STEP = 0x9E3779B9
FUNCTIONS = [function for function in read_functions() if function.bound == perlin_worley_rows.BOUND]

# How far fixed arithmetic may be off; the worst of 1000 was 2^-18.03.
ERROR = 2**-17.5


def exact(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> Fraction:
    return perlin_worley.exact(KNOBS, sums.at_position(p), options, seed, periods)[0]


def fixed(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> Fraction:
    return perlin_worley.fixed(KNOBS, sums.fixed_at_position(p), options, seed, periods)[0]


def places(name: str, count: int = 16) -> Iterator[tuple[list[Fraction], Options, int, tuple[int, ...]]]:
    """Positions that fixed arithmetic does not cut."""
    numbers = generator_of(f"perlin_worley {name}")
    for index in range(count):
        p = [Fraction(numbers.integer(-2**23, 2**23), 2**20) for _ in range(3)]
        options = numbers.pick(((1, 2.0, 0.5), (3, 1.5, 0.5), (4, 2.0, 0.75), (5, 2.5, 1.0), (2, 2.0, 0.0)))
        yield p, Options(*options), numbers.word(), ((), (), (7, 5, 0), (1, 2, 1000003))[index % 4]


def by_parts(p: Sequence[Real], options: Options, seed: int, periods: Sequence[int]) -> float:
    """From the contract in floats, with the exact noises at places that are found anew."""
    perlin, cells, weights, few, q = 0.0, 0.0, 0.0, 0.0, list(map(Fraction, p))
    t, tile = words.mix(seed + STEP & words.MASK), list(periods)
    lacunarity = Fraction(math.floor(options.lacunarity) if periods else options.lacunarity)
    for i in range(options.octaves):
        weight = options.gain**i
        perlin += weight * float(noises.find("perlin").exact(KNOBS, q, seed, tile)[0])
        weights += weight
        if i < 3:
            cells += weight * (1 - 2 * float(noises.find("cellular").exact(KNOBS, q, t, tile)[0]))
            few += weight
        x, y, z = (c * lacunarity for c in q)
        if not periods:
            x, y = (25 * x - 20 * y) / 32, (20 * x + 25 * y) / 32
            y, z = (29 * y - 13 * z) / 32, (13 * y + 29 * z) / 32
        q = [x + Fraction(11, 32), y + Fraction(19, 32), z + Fraction(23, 32)]
        seed, t, tile = seed + STEP & words.MASK, t + STEP & words.MASK, [int(c * lacunarity) for c in tile]
    return 1 - (1 - perlin / weights) * (1 - min(max(cells / few, -1), 1)) / 4


class PerlinWorley(FaultChecks, unittest.TestCase):
    def check_parts(self) -> None:
        for place in places("parts"):
            self.assertAlmostEqual(float(exact(*place)), by_parts(*place), 12)

    def check_fixed(self) -> None:
        for place in places("fixed"):
            self.assertLessEqual(abs(exact(*place) - fixed(*place)), ERROR, place)
            self.assertEqual((fixed(*place) * NOISE_UNIT).denominator, 1)

    def check_integers(self) -> None:
        """The fixed value is made of the fBm and of the integers of cells."""
        for p, options, seed, periods in places("integers", 12):
            place, few = sums.fixed_at_position(p), min(options.octaves, 3)
            perlin = int(sums.fixed("fbm", noises.find("perlin"), KNOBS, place, options, seed, periods) * NOISE_UNIT)
            weights, found, t = [2**18], [], words.mix(seed + STEP & words.MASK)
            for at, tile, _ in sums.fixed_octaves_of(place, replace(options, octaves=few), seed, periods):
                distance, _ = noises.find("cellular").fixed_cell(
                    KNOBS, [c for c, _ in at], [Fraction(r, 2**24) for _, r in at], t, tile)
                found.append(2**21 - 2**22 * distance)
                weights.append(weights[-1] * math.floor(options.gain * 2**18) // 2**18)
                t = t + STEP & words.MASK
            total = sum(v * a // 2**18 for v, a in zip(map(int, found), weights))
            mean = math.trunc(Fraction(total * 2**18, sum(weights[:few])))
            lack = (2**21 - perlin) * (2**21 - min(max(mean, -2**21), 2**21)) // 2**18
            self.assertEqual(fixed(p, options, seed, periods) * NOISE_UNIT, 2**21 - (lack + 16) // 32)

    def check_far(self) -> None:
        """All points are farther than 1 from this place, where Perlin noise is 0."""
        for of, options in itertools.product((exact, fixed), (Options(1, 2.0, 0.5), Options(3, 2.0, 0.0))):
            self.assertEqual(of(perlin_worley_rows.FAR, options, perlin_worley_rows.FAR_SEED), Fraction(1, 2))

    def check_points(self) -> None:
        """At a point of a cell the value is 1, whatever Perlin noise is, and nowhere else."""
        numbers = generator_of("perlin_worley points")
        for cell in ((0, 0, 0), (-7, 3, 200), (5, -6, 1)):
            p, options, seed = None, Options(1, 2.0, 0.5), numbers.word()
            p = perlin_worley_rows.at_point(cell, seed)
            for of in (exact, fixed):
                self.assertEqual(of(p, options, seed), 1)
                beside = of((p[0] + 2.0**-6, *p[1:]), options, seed)
                self.assertTrue(1 - 2**-6 < beside < 1, beside)

    CHECKS = ("parts", "fixed", "integers", "far", "points")
    NOTICED = AssertionError, ValueError
    FAULTS = (
        (perlin_worley, "MOST", 4, ("parts", "integers")),
        (perlin_worley, "SEED_STEP", STEP + 2, ("parts", "integers")),
        (perlin_worley, "mix", lambda k: k, ("parts", "integers", "points")),
        (perlin_worley, "with_seeds", lambda octaves, seed: octaves, ("parts", "integers", "points")),
        (perlin_worley, "UNIT", 2**21, ("fixed", "integers", "far")),
        (perlin_worley, "prod", lambda a, b: a * b >> 19, ("fixed", "integers")),
        (perlin_worley, "clamped_to", lambda v, end: v, ("far",)),
        (perlin_worley, "clamped", lambda v, low, high: v, ("far",)))

    def test_range(self) -> None:
        """Its ends are those of both parts."""
        for perlin, cells in itertools.product((-1, 1), repeat=2):
            with mock.patch.object(perlin_worley, "fixed_cells", return_value=cells * NOISE_UNIT), \
                    mock.patch.object(sums, "fixed_fbm", return_value=perlin * NOISE_UNIT):
                self.assertEqual(fixed((0.5, 0.25, 0), Options(1, 2.0, 0.5)), 0 if perlin == cells == -1 else 1)

    def test_without_octaves(self) -> None:
        for of, octaves in itertools.product((exact, fixed), (0, -1, -2**31)):
            self.assertEqual(of((0.3, 0.4, 0.5), Options(octaves, 2.0, 0.5)), Fraction(3, 4))

    def test_with_the_sine_gradient_there_is_none(self) -> None:
        for of, place in ((perlin_worley.exact, [Fraction(0)] * 3), (perlin_worley.fixed, [(0, 0)] * 3)):
            with self.assertRaisesRegex(ValueError, "no hn_perlin_worley"):
                of(Knobs("lattice", sine=True), place, Options(1, 2.0, 0.5))


class Rows(unittest.TestCase):
    def test_of_settings_and_octaves(self) -> None:
        self.assertEqual(len(FUNCTIONS), 2)
        for file in golden_files(FUNCTIONS, read_configurations()):
            self.assertEqual([values.name for values in file.values], ["lattice", "lattice+fixed"])
            plain, _ = file.rows()
            self.assertLessEqual({-1, 0, 1, 2, 3, 4, 5, 6, 33}, {row[-4] for row in plain})

    def test_they_see_the_ends(self) -> None:
        """Rows at which cells are clamped, at points, and beside them."""
        for function in FUNCTIONS:
            rows = perlin_worley_rows.plain(function, generator_of(function.id))
            for is_fixed, name, other in ((False, "clamped", lambda v, low, high: v), (False, "MOST", 4),
                                          (True, "clamped_to", lambda v, end: v), (True, "MOST", 4)):
                evaluate = functions.evaluator(function, is_fixed)

                def sees(row: Row) -> bool:
                    right, = evaluate(KNOBS, row)
                    with mock.patch.object(perlin_worley, name, other):
                        found, = evaluate(KNOBS, row)
                    return abs(found - right) > 2**-9

                self.assertTrue(any(map(sees, rows[-3:] if name == "MOST" else rows[-37:])), (function.id, name))
            values = [functions.evaluator(function, True)(KNOBS, row)[0] for row in rows[-37:]]
            self.assertGreater(sum(value == 1 for value in values), 1)
