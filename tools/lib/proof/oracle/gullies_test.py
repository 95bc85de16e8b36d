"""Tests of gullies.py: by hand, and beside a program in C."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN, to_f32
from proof.oracle import gullies, sums
from proof.oracle.gradients import Real
from proof.oracle.hashes import MASK
from proof.oracle.sums import Options
from proof.oracle.testing import KNOBS

DEFAULT = Options(3, 2.0, 0.5, depth=0.1, ex=0.6, ey=-0.3)


def exact(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    return gullies.exact(KNOBS, sums.at_position(p), options, seed, periods)


def fixed(p: Sequence[Real], options: Options, seed: int = 7, periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    return gullies.fixed(KNOBS, sums.fixed_at_position(p), options, seed, periods)


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


class Gullies(unittest.TestCase):
    """A wave in another direction, an octave of another share or seed, or a step that is cut in another place."""

    def test_beside_a_program(self) -> None:
        for cell, r, periods, (octaves, lacunarity, gain, depth, ex, ey, footprint), seed, expected in VECTORS:
            options = Options(octaves, *map(to_f32, (lacunarity, gain)), footprint=to_f32(footprint),
                              depth=to_f32(depth), ex=to_f32(ex), ey=to_f32(ey))
            found = gullies.fixed(KNOBS, list(zip(cell, r)), options, seed, periods)
            self.assertEqual(tuple(x * unit for x, unit in zip(found, gullies.UNITS)), expected)

    def test_clamps(self) -> None:
        """Slopes beyond 8 and depths outside [0, 8] count as the nearer end."""
        for of in (exact, fixed):
            for beyond, end in (({"ex": 9.0}, {"ex": 8.0}), ({"ey": -3e38}, {"ey": -8.0}),
                                ({"depth": 8.5}, {"depth": 8.0}), ({"depth": -1.0}, {"depth": 0.0}),
                                ({"lacunarity": 300.0}, {"lacunarity": 255.5}),
                                ({"lacunarity": -1.5}, {"lacunarity": 0.9})):
                a, b = (of((0.3, 0.7), replace(DEFAULT, octaves=2, **of_these)) for of_these in (beyond, end))
                self.assertEqual(a, b)
            # After an octave that is deep the slope is at its end.
            _, dx, dy = of((0.3, 0.7), replace(DEFAULT, octaves=1, depth=8.0, ex=1.0, ey=1.0))
            self.assertTrue({dx, dy} & {7, -9}, (dx, dy))

    def test_units_of_fixed_arithmetic(self) -> None:
        # 5 units of length and what a slope of (3, 4) leaves of a wave: 3/5 and 4/5 of 40/41.
        u, length = gullies.fixed_unit([3 * 2**16, -4 * 2**16])
        self.assertEqual((u, length), ([2**21 * 24 // 41, -(2**21 * 32 // 41)], (2**21 * 40 // 41) >> 3))
        self.assertEqual(gullies.fixed_unit([0, 0]), ([0, 0], 0))
        # Less than 2^-10 of a slope has no length.
        self.assertEqual(gullies.fixed_unit([63, -1]), ([63 * 2**8, -2**8], 0))
        d = 2**11 + 16
        self.assertEqual(gullies.fixed_unit([64, 0]), ([2**25 // d, 0], (2**25 // d) >> 3))

    def test_growths_of_fixed_arithmetic(self) -> None:
        def growths(count: int, lacunarity: float, gain: float, depth: float) -> list[int]:
            options = gullies.whole(Options(count, lacunarity, gain, depth=depth))
            return list(itertools.islice(gullies.fixed_growths(options), count))

        self.assertEqual(growths(4, 3.9, 0.5, 0.75), [3 * 2**16 * 3**i // 2**i for i in range(4)])
        self.assertEqual(growths(14, 2.0, 1.0, 2.0**-9)[-2:], [2**21, 2**22])
        # They wrap far beyond the domain.
        self.assertEqual(growths(14, 2.0, 1.0, 1.0)[-1], -2**31)
