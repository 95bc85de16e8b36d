"""Tests of integers.py and slopes.py: numbers by hand, and how near they are to the exact ones."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction

from base.thorough import in_thorough_runs
from proof.golden.generator import generator_of
from proof.oracle import gradients, hashes, integers, slopes
from proof.oracle.gradients import Knobs

UNIT = 2**20


class Steps(unittest.TestCase):
    """A coordinate, a fade or an interpolation that is cut or rounded in another place."""

    def test_coordinates(self) -> None:
        table = {
            1.75: (1, 3 * 2**18), -1.75: (-2, 2**18), -1.0: (-1, 0), 2.0**-20: (0, 1), 2.0**-21: (0, 0),
            1 - 2.0**-24: (0, UNIT - 1),
            # Towards 0: what is nearer to 0 than the step of a fraction is 0.
            -2.0**-20: (-1, UNIT - 1), -2.0**-21: (0, 0), -1 - 2.0**-23: (-1, 0), -1 + 2.0**-24: (-1, 1),
            -2.0**31: (-2**31, 0), 2.0**31: (2147483520, 0), -3.4e38: (-2**31, 0)}
        for p, expected in table.items():
            self.assertEqual(integers.cell_and_fraction(p), expected, p)
        for f, expected in ((0.0, 0), (2.0**-19 - 2.0**-42, 1), (0.75, 3 * 2**18), (1 - 2.0**-24, UNIT - 1),
                            (1.0, UNIT), (1 + 2.0**-23, UNIT), (-2.0**-20, 0)):
            self.assertEqual(integers.fraction_of(f), expected, f)

    def test_fade_by_hand(self) -> None:
        # At 1/4: x = 2^15, s = 2^30, z = 2^14, R = 172032, Q = 16384 + 10752; s(1/4) is 27136 / 2^18, too. At 1/2 x is
        # 65535, since the square of 2^16 is not a word: z = 65534, R = 4, Q = 65535, t = 65535 * 65535 >> 15, cut.
        fractions = (0, 2**18, 2**19 - 1, 2**19, 2**19 + 1, 3 * 2**18, UNIT)
        self.assertEqual([integers.fade(f) for f in fractions],
                         [0, 27136, 2**17 - 4, 2**17 - 4, 2**17 + 4, 2**18 - 27136, 2**18])
        # Fractions are rounded to multiples of eight.
        around = [integers.fade(f) for f in range(2**18 - 12, 2**18 + 12)]
        self.assertEqual(around, [t for t in around[::8] for _ in range(8)])

    def test_slope_of_the_fade(self) -> None:
        # At 1/4: x = 2^15, q = 2^15 * 3 * 2^15 / 2^16 = 49152, q * q >> 4 = 150994944, slope = 276480 = 270/256 * 2^18.
        # At 1/2 x is 65535, and q too: (65535^2 >> 4) * 15 + 4096 >> 13 = 491505, 15 below 15/8 * 2^18.
        self.assertEqual([slopes.fade_slope(f) for f in (0, 2**18, 2**19, 3 * 2**18, UNIT)],
                         [0, 276480, 491505, 276480, 0])
        for f in range(0, UNIT + 1, 97):
            x = f / UNIT
            self.assertLess(abs(slopes.fade_slope(f) - 30 * (x * (1 - x))**2 * 2**18), 24, f)

    @in_thorough_runs
    def test_fade_of_all_fractions(self) -> None:
        values = [integers.fade(f) for f in range(UNIT + 1)]  # raises where an intermediate value does not fit
        # 2^100 (6 x^5 - 15 x^4 + 10 x^3) of x = f / 2^20.
        errors = [abs((t << 82) - f**3 * (6 * f * f - 15 * f * UNIT + 10 * UNIT * UNIT)) for f, t in enumerate(values)]
        self.assertEqual(max(errors), 4 * 2**82)  # units of 2^-18: 1.53e-5
        # It never falls, nor leaps, so that it stays within [0, 1].
        steps = [b - a for a, b in itertools.pairwise(values)]
        self.assertEqual((min(steps), max(steps)), (0, 8))

    def test_interpolation_by_hand(self) -> None:
        for d, t, expected in ((2**20, 2**17, 2**19), (2**20, 513, 2048 + 4), (-2**20, 513, -2048 - 4),
                               (-1, 3, -3),  # d >> 18 is -1, and t >> 9 is 0
                               (2**28, 491520, 15 * 2**25)):  # beyond 1: a slope
            self.assertEqual(integers.part(d, t), expected)
        self.assertEqual(integers.lerp(100, 100 + 2560, 2**17), 100 + 1280)
        self.assertEqual(integers.lerp(0, -1, 2**18), -512)  # every step rounds down
        # A difference wraps.
        self.assertEqual((integers.difference(-2**30, 2**30), integers.difference(-2**30, 2**30 - 1)),
                         (-2**31, 2**31 - 1))

    def test_numbers_that_do_not_fit(self) -> None:
        for check, fitting in ((integers.signed, (-2**31, 2**31 - 1)), (integers.word, (0, hashes.MASK))):
            for n, beyond in zip(fitting, (-1, 1)):
                self.assertEqual(check(n), n)
                with self.assertRaises(OverflowError):
                    check(n + beyond)


class Sine(unittest.TestCase):
    """An angle or a sine of fixed arithmetic that is not the exact one, but for its roundings."""

    def test_turns(self) -> None:
        turn, numbers = 2 * Fraction(gradients.PI, 2**gradients.SINE_BITS), generator_of("turns")
        for m in [0, 1, 2**16 - 1, 2**16, 2**31] + [numbers.integer(0, 2**31) for _ in range(200)]:
            error = (integers.turns_of(m) - m * 2**32 / turn) % 2**32
            self.assertLess(min(error, 2**32 - error), 2, m)

    def test_over_a_quarter(self) -> None:
        # The argument is rounded to x, and the last half of a step, where the sine is 1, goes to the last x.
        for x in (*range(0, 2**16, 61), 65535):
            first, last = max(x * 2**14 - 2**13, 0), 2**30 if x == 65535 else x * 2**14 + 2**13 - 1
            at = integers.sine_of_quarter(x * 2**14)
            for q in (first, last):
                self.assertEqual(integers.sine_of_quarter(q), at, x)
                self.assertLess(abs(at / 2**16 - math.sin(math.pi / 2 * q / 2**30)), 3.7e-5, x)
        self.assertEqual(integers.sine_of_quarter(2**30), 65535)

    def test_of_words(self) -> None:
        numbers = generator_of("sine")
        arguments = [0, 1, 2**24 + 1, 2**31 - 1, 2**31, 2**31 + 1, hashes.MASK] + [numbers.word() for _ in range(300)]
        for w in arguments:
            found = integers.sine_of_word(w)
            self.assertLess(abs(Fraction(found, 2**16) - gradients.sine_of_word(w)), 3.7e-5, w)

    def test_beside_a_program(self) -> None:
        for arguments, expected in ((((5, -6, 7), 9), [10340, 64489, 17322]), (((2**31 - 1, -6),), [27160, 55046])):
            found = integers.gradient(Knobs("lattice", sine=True), *arguments)
            self.assertEqual([g * 2**16 for g in found], expected)
