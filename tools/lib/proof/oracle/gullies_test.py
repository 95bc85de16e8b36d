"""Tests of gullies.py: by hand, beside floats and a program in C, and by differences of the exact value."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import gullies, jacobians, noises, sums
from proof.oracle.gradients import Real
from proof.oracle.noises.phasor_test import naive
from proof.oracle.sums import Options
from proof.oracle.testing import KNOBS, FaultChecks
from proof.oracle.words import MASK, SEED_STEP

DEFAULT = Options(3, 2.0, 0.5, depth=0.1, ex=0.6, ey=-0.3)
# How far fixed arithmetic may be off with up to three octaves of the depths of `places`: in the height, and in a slope.
# The worst of 960 were 2^-8.8 and 2^-6.4: an octave where there is hardly a slope runs anywhere.
ERROR, SLOPE_ERROR = 2**-8, 2**-6


def exact(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    return gullies.exact(KNOBS, sums.at_position(p), options, seed, periods)


def fixed(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    return gullies.fixed(KNOBS, sums.fixed_at_position(p), options, seed, periods)


def in_floats(p: Sequence[Real], options: Options, seed: int, periods: Sequence[int]) -> tuple[float, ...]:
    """From the contract, with the naive sum of waves and differences of it for their derivatives."""
    whole = math.floor(min(max(options.lacunarity, 0), 255))
    q, tile = list(map(float, p)), list(periods) or [0, 0]
    start = [min(max(float(x), -8.0), 8.0) for x in (options.ex, options.ey)]
    height, e, step = 0.0, start, 1e-5
    for i in range(options.octaves):
        x, y = (component / (math.hypot(*e) + 0.125) for component in e)
        cell = list(map(math.floor, q))

        def at(dx: float, dy: float) -> float:
            return naive(cell, [q[0] - cell[0] + dx, q[1] - cell[1] + dy], (-1.5 * y, 1.5 * x), 0, seed, tile)[0]

        a = options.gain**i * math.hypot(x, y)
        a *= min(max(1.5 - 2 * options.footprint * max(whole, 1)**i, 0), 1)
        height += a * at(0, 0)
        slopes = ((at(step, 0) - at(-step, 0)) / (2 * step), (at(0, step) - at(0, -step)) / (2 * step))
        e = [min(max(c + options.depth * whole**i * a * g, -8.0), 8.0) for c, g in zip(e, slopes)]
        q = [c * whole + shift for c, shift in zip(q, (11 / 32, 19 / 32))]
        tile, seed = [period * whole for period in tile], (seed + SEED_STEP) & MASK
    return options.depth * height, e[0] - start[0], e[1] - start[1]


Place = tuple[list[Fraction], Options, int, tuple[int, ...]]


def places(name: str, count: int = 16) -> Iterator[Place]:
    """Positions and slopes that fixed arithmetic does not cut."""
    numbers = generator_of(f"gullies {name}")
    for index in range(count):
        p = [Fraction(numbers.integer(-2**23, 2**23), 2**20) for _ in range(2)]
        most = (2**13, 2**16, 2**20, 2**6)[index % 4]
        ex, ey = (Fraction(numbers.integer(-most, most), 2**16) for _ in range(2))
        octaves, lacunarity, gain = numbers.pick(((1, 2.0, 0.5), (2, 2.5, 0.5), (3, 2.0, 0.25), (2, 0.5, 1.0)))
        depth = numbers.pick((0.0625, 0.125, 0.03125))
        options = Options(octaves, lacunarity, gain, depth=depth, ex=ex, ey=ey,
                          footprint=numbers.pick((0, 0, Fraction(3, 16), Fraction(5, 8))))
        yield p, options, numbers.word(), ((), (), (3, 0), (7, 1000003))[numbers.integer(0, 3)]


# From a program in C, with its words of 32 bits, which was written from the contract: the cell, the fraction in units
# of 2^-24, the periods, the settings and the seed; the height and both slopes.
VECTORS = (
    ((0, 0), (0, 0), (0, 0), (1, 2.0, 0.5, 0.1, 0.6, -0.3, 0.0), 0,
     (-100452, 4330, 8660)),
    ((-3, 7), (5000000, 11000001), (0, 0), (3, 2.0, 0.5, 0.1, -0.25, 0.7, 0.0), 9,
     (51030, -23058, -12608)),
    ((4, -3), (2**24, 12345), (5, 3), (3, 2.75, 0.5, 0.2, 0.01, -0.004, 0.1), MASK,
     (-15425, -1743, 5412)),
    ((INT_MAX, INT_MIN), (2**24, 8388608), (0, INT_MAX), (4, 2.0, 0.7, 0.3, 9.5, -3e38, 0.05), 5,
     (65044, 0, 473612)),
    ((1000, -77), (16777215, 1), (48, 1000003), (33, 2.0, 0.5, 8.0, -8.0, 0.5, 0.0), 77,
     (-6382600, 0, 491520)),
    ((6, 6), (4194304, 4194305), (7, 7), (2, 255.0, 0.2, 0.25, 1.0, 1e-40, 1 / 7), 3,
     (-99715, 18910, -38643)),
    ((-1, -1), (1, 2), (2, 2), (6, 300.0, 0.0, 1 / 3, 0.3, 0.3, 0.3), 4,
     (-219639, 31976, -31976)),
    ((12, 5), (6291456, 0), (0, -4), (32, 1.0, 1.0, 8.0, 2.0, -0.125, 0.0), 123,
     (21839232, 393216, 532480)),
    ((3, 3), (9999999, 7777777), (0, 0), (5, 0.5, 1.5, 0.05, -1 / 3, 1 / 7, -1.0), 1,
     (91897, -10664, -1829)))


# The parts of faults.
UNIT_OF, FIXED_UNIT, GROWTHS = gullies.unit_of, gullies.fixed_unit, gullies.fixed_growths
AT = gullies.PHASOR.exact_in_cell


def phasor(at: Callable) -> noises.Noise:
    return replace(gullies.PHASOR, exact_in_cell=at)


class Gullies(FaultChecks, unittest.TestCase):
    def check_floats(self) -> None:
        for p, options, *others in places("floats"):
            for a, b in zip(exact(p, options, *others), in_floats(p, options, *others), strict=True):
                self.assertAlmostEqual(float(a), b, 5)

    def check_fixed(self) -> None:
        for p, options, *others in places("fixed"):
            found = zip(exact(p, options, *others), fixed(p, options, *others), (ERROR, SLOPE_ERROR, SLOPE_ERROR))
            for a, b, most in found:
                self.assertLessEqual(abs(a - b), most, (p, options, others))

    def check_program(self) -> None:
        for cell, r, periods, (octaves, lacunarity, gain, depth, ex, ey, footprint), seed, expected in VECTORS:
            options = Options(octaves, *map(to_f32, (lacunarity, gain)), footprint=to_f32(footprint),
                              depth=to_f32(depth), ex=to_f32(ex), ey=to_f32(ey))
            found = gullies.fixed(KNOBS, list(zip(cell, r)), options, seed, periods)
            self.assertEqual(tuple(x * unit for x, unit in zip(found, gullies.UNITS)), expected)

    def check_differences(self) -> None:
        """The waves of the first octave do not rotate with the place: there slopes are what a height rises by."""
        step = Fraction(1, 2**24)
        for p, options, *others in places("differences", 12):
            options = replace(options, octaves=1, ex=options.ex / 4, ey=options.ey / 4)  # they stay within 8
            _, *slopes = exact(p, options, *others)
            for axis, slope in enumerate(slopes):
                low, high = (exact([x + side * step * (i == axis) for i, x in enumerate(p)], options, *others)[0]
                             for side in (-1, 1))
                self.assertLess(abs((high - low) / (2 * step) - slope), 2**10 * step**2)

    def check_clamps(self) -> None:
        """Slopes beyond 8 and depths outside [0, 8] count as the nearer end."""
        for of in (exact, fixed):
            for beyond, end in (({"ex": 9.0}, {"ex": 8.0}), ({"ey": -3e38}, {"ey": -8.0}),
                                ({"depth": 8.5}, {"depth": 8.0}), ({"depth": -1.0}, {"depth": 0.0}),
                                ({"lacunarity": 300.0}, {"lacunarity": 255.5}),
                                ({"lacunarity": -1.5}, {"lacunarity": 0.9})):
                a, b = (of((0.3, 0.7), replace(DEFAULT, octaves=2, **of_these)) for of_these in (beyond, end))
                self.assertEqual(a, b)
            for within, end in (({"ex": 7.5}, {"ex": 8.0}), ({"depth": 7.5}, {"depth": 8.0})):
                self.assertNotEqual(*(of((0.3, 0.7), replace(DEFAULT, octaves=1, **of_these))
                                      for of_these in (within, end)))
            # After an octave that is deep the slope is at its end.
            _, dx, dy = of((0.3, 0.7), replace(DEFAULT, octaves=1, depth=8.0, ex=1.0, ey=1.0))
            self.assertTrue({dx, dy} & {7, -9}, (dx, dy))

    CHECKS = ("floats", "fixed", "program", "differences", "clamps")
    FAULTS = (
        (gullies, "LARGEST_SLOPE", 9, ("clamps",)), (gullies, "LARGEST_FIXED_SLOPE", 9 * 2**16, ("clamps",)),
        (gullies, "LARGEST_DEPTH", 9, ("clamps",)), (gullies, "NOTHING", (), ("floats",)),
        (gullies, "wave_of", lambda u: (-u[1], u[0]), ("floats", "program")),
        (gullies, "wave_of", lambda u: (Fraction(3, 2) * u[1], Fraction(-3, 2) * u[0]), ("floats", "program")),
        (gullies, "unit_of", lambda e: (UNIT_OF(e)[0], 1), ("floats", "fixed")),
        (gullies, "fixed_unit", lambda e: (FIXED_UNIT(e)[0], 2**18), ("fixed", "program")),
        (gullies, "fixed_growths", lambda options: itertools.repeat(next(GROWTHS(options))), ("program",)),
        (gullies, "coarse", lambda v: v, ("program",)),
        (gullies, "PHASOR", phasor(lambda lattice, *rest: AT(replace(lattice, seed=0), *rest)), ("floats", "fixed")),
        (gullies, "PHASOR", phasor(lambda *rest: (2 * AT(*rest)[0], *AT(*rest)[1:])), ("differences",)),
        (sums, "visible", lambda options, i: Fraction(1), ("floats", "fixed")),
        (sums, "fixed_visible", lambda options: itertools.repeat(2**18), ("fixed", "program")))


class ByHand(unittest.TestCase):
    def test_of_no_slope_octaves_or_depth_there_is_nothing(self) -> None:
        for of in (exact, fixed):
            for octaves, depth, ex in itertools.chain(itertools.product((1, 4, 33), (0.1, 8.0), (0.0,)),
                                                      ((-3, 0.1, 0.6), (0, 0.1, 0.6), (3, 0.0, 0.6))):
                self.assertEqual(of((0.3, 0.7), Options(octaves, 2.0, 0.5, depth=depth, ex=ex)), (0, 0, 0))

    def test_a_position_is_in_a_tile_without_periods(self) -> None:
        for of in (exact, fixed):
            self.assertEqual(of((5.3, -7.7), DEFAULT), of((5.3, -7.7), DEFAULT, 7, (0, -5)))
            self.assertNotEqual(of((5.3, -7.7), DEFAULT), of((5.3, -7.7), DEFAULT, 7, (3, 0)))
            for p, period in (((0.3, -7.7), (3, 0)), ((1.25, 4.5), (0, 2))):
                moved = [x + period_ for x, period_ in zip(map(Fraction, p), period)]
                self.assertEqual(of(moved, DEFAULT, 7, period), of(list(map(Fraction, p)), DEFAULT, 7, period))

    def test_units_of_fixed_arithmetic(self) -> None:
        # 5 units of length and what a slope of (3, 4) leaves of a wave: 3/5 and 4/5 of 40/41.
        u, length = gullies.fixed_unit([3 * 2**16, -4 * 2**16])
        self.assertEqual((u, length), ([2**21 * 24 // 41, -(2**21 * 32 // 41)], (2**21 * 40 // 41) >> 3))
        self.assertEqual(gullies.fixed_unit([0, 0]), ([0, 0], 0))
        # Less than 2^-10 of a slope has no length.
        self.assertEqual(gullies.fixed_unit([63, -1]), ([63 * 2**8, -2**8], 0))
        d = 2**11 + 16
        self.assertEqual(gullies.fixed_unit([64, 0]), ([2**25 // d, 0], (2**25 // d) >> 3))

    def test_ranges_of_fixed_arithmetic(self) -> None:
        """The contract's claims on floats, and on the bits of integers."""
        end = 2**19
        for e in ((end, end), (end, 0), (-end, end), (end, 1), (end - 1, -end)):
            u, length = gullies.fixed_unit(e)
            self.assertTrue(max(map(abs, u)) < 2**21 and length < 2**18)
            self.assertTrue(all(to_f32(float(3 * x / 2**22)) == Fraction(3 * x, 2**22) for x in u))
        self.assertEqual(max(map(abs, (gullies.fixed_unit((end, end))[0]))), 2**38 // (185363 + 2**11))

    def test_growths_of_fixed_arithmetic(self) -> None:
        def growths(count: int, lacunarity: float, gain: float, depth: float) -> list[int]:
            options = gullies.whole(Options(count, lacunarity, gain, depth=depth))
            return list(itertools.islice(gullies.fixed_growths(options), count))

        self.assertEqual(growths(4, 3.9, 0.5, 0.75), [3 * 2**16 * 3**i // 2**i for i in range(4)])
        self.assertEqual(growths(14, 2.0, 1.0, 2.0**-9)[-2:], [2**21, 2**22])
        # They wrap far beyond the domain.
        self.assertEqual(growths(14, 2.0, 1.0, 1.0)[-1], -2**31)
        with mock.patch.object(jacobians, "wrapped", lambda n: n):
            self.assertEqual(growths(14, 2.0, 1.0, 1.0)[-1], 2**31)
