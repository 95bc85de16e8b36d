"""Tests of perlin_worley.py: by hand and by its parts."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from proof.golden import perlin_worley_rows
from proof.golden.generator import generator_of
from proof.oracle import hashes, noises, perlin_worley, sums
from proof.oracle.gradients import Knobs, Real
from proof.oracle.integers import NOISE_UNIT
from proof.oracle.sums import Options
from proof.oracle.testing import KNOBS

STEP = 0x9E3779B9


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
    t, tile = hashes.mix(seed + STEP & hashes.MASK), list(periods)
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
        seed, t, tile = seed + STEP & hashes.MASK, t + STEP & hashes.MASK, [int(c * lacunarity) for c in tile]
    return 1 - (1 - perlin / weights) * (1 - min(max(cells / few, -1), 1)) / 4


class PerlinWorley(unittest.TestCase):
    """Octaves of cells with other seeds or weights, or more of them, or a product that is cut in another place."""

    def test_parts(self) -> None:
        for place in places("parts"):
            self.assertAlmostEqual(float(exact(*place)), by_parts(*place), 12)

    def test_integers(self) -> None:
        """The fixed value is made of the fBm and of the integers of cells."""
        for p, options, seed, periods in places("integers", 12):
            place, few = sums.fixed_at_position(p), min(options.octaves, 3)
            perlin = int(sums.fixed("fbm", noises.find("perlin"), KNOBS, place, options, seed, periods) * NOISE_UNIT)
            weights, found, t = [2**18], [], hashes.mix(seed + STEP & hashes.MASK)
            for at, tile, _ in sums.fixed_octaves_of(place, replace(options, octaves=few), seed, periods):
                distance, _ = noises.find("cellular").fixed_cell(
                    KNOBS, [c for c, _ in at], [Fraction(r, 2**24) for _, r in at], t, tile)
                found.append(2**21 - 2**22 * distance)
                weights.append(weights[-1] * math.floor(options.gain * 2**18) // 2**18)
                t = t + STEP & hashes.MASK
            total = sum(v * a // 2**18 for v, a in zip(map(int, found), weights))
            mean = math.trunc(Fraction(total * 2**18, sum(weights[:few])))
            lack = (2**21 - perlin) * (2**21 - min(max(mean, -2**21), 2**21)) // 2**18
            self.assertEqual(fixed(p, options, seed, periods) * NOISE_UNIT, 2**21 - (lack + 16) // 32)

    def test_where_no_point_is_near(self) -> None:
        """All points are farther than 1 from this place, where Perlin noise is 0."""
        for of, options in itertools.product((exact, fixed), (Options(1, 2.0, 0.5), Options(3, 2.0, 0.0))):
            self.assertEqual(of(perlin_worley_rows.FAR, options, perlin_worley_rows.FAR_SEED), Fraction(1, 2))

    def test_without_octaves(self) -> None:
        for of, octaves in itertools.product((exact, fixed), (0, -1, -2**31)):
            self.assertEqual(of((0.3, 0.4, 0.5), Options(octaves, 2.0, 0.5)), Fraction(3, 4))

    def test_with_the_sine_gradient_there_is_none(self) -> None:
        for of, place in ((perlin_worley.exact, [Fraction(0)] * 3), (perlin_worley.fixed, [(0, 0)] * 3)):
            with self.assertRaisesRegex(ValueError, "no hn_perlin_worley"):
                of(Knobs("lattice", sine=True), place, Options(1, 2.0, 0.5))
