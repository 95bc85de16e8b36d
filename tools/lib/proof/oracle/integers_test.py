"""Tests of integers.py: numbers by hand and of a C program written from the contract, and how near they are to the
exact ones."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction

from base.thorough import in_thorough_runs
from proof.golden.generator import generator_of
from proof.oracle import gradients, integers, noises, words
from proof.oracle.gradients import Knobs

PERLIN = noises.find("perlin")

UNIT = 2**20


class Coordinates(unittest.TestCase):
    def test_cell_and_fraction(self) -> None:
        table = {
            1.75: (1, 3 * 2**18), -1.75: (-2, 2**18), -1.0: (-1, 0), 0.0: (0, 0),
            2.0**-20: (0, 1), 2.0**-21: (0, 0), 2.0**-149: (0, 0), 1 - 2.0**-24: (0, UNIT - 1),
            # Towards 0: what is nearer to 0 than the step of a fraction is 0.
            -2.0**-20: (-1, UNIT - 1), -2.0**-21: (0, 0), -1e-40: (0, 0), -3 * 2.0**-21: (-1, UNIT - 1),
            -1 - 2.0**-23: (-1, 0), -1 + 2.0**-24: (-1, 1),
            2.0**23: (2**23, 0), -2.0**31: (-2**31, 0), 2.0**31: (2147483520, 0), 3e38: (2147483520, 0),
            -3.4e38: (-2**31, 0),
        }
        for p, expected in (*table.items(), (-0.0, (0, 0))):  # as a key it is 0.0
            self.assertEqual(integers.cell_and_fraction(p), expected, p)

    def test_fraction_of_the_caller(self) -> None:
        table = {0.0: 0, 2.0**-149: 0, 2.0**-20: 1, 2.0**-19 - 2.0**-42: 1, 0.75: 3 * 2**18,
                 1 - 2.0**-24: UNIT - 1, 1.0: UNIT, 1 + 2.0**-23: UNIT, 3e38: UNIT, -2.0**-20: 0, -0.5: 0, -3e38: 0}
        for f, expected in (*table.items(), (-0.0, 0)):
            self.assertEqual(integers.fraction_of(f), expected, f)
        self.assertEqual(PERLIN.fixed_cell(Knobs("lattice"), (5, -6), (1.5, -0.5), 7),
                         PERLIN.fixed_cell(Knobs("lattice"), (5, -6), (1.0, 0.0), 7))
        self.assertEqual(PERLIN.fixed_cell(Knobs("lattice"), (5, -6), (-0.5, 0.25), 7),
                         PERLIN.fixed_cell(Knobs("lattice"), (5, -6), (0.0, 0.25), 7))


class Fade(unittest.TestCase):
    def test_by_hand(self) -> None:
        # At 1/4: x = 2^15, s = 2^30, z = 2^14, R = 172032, Q = 16384 + 10752; s(1/4) is 27136 / 2^18, too. At 1/2 x is
        # 65535, since the square of 2^16 is not a word: z = 65534, R = 4, Q = 65535, t = 65535 * 65535 >> 15, cut.
        fractions = (0, 2**18, 2**19 - 1, 2**19, 2**19 + 1, 3 * 2**18, UNIT)
        self.assertEqual([integers.fade(f) for f in fractions],
                         [0, 27136, 2**17 - 4, 2**17 - 4, 2**17 + 4, 2**18 - 27136, 2**18])

    def test_fractions_are_rounded_to_multiples_of_eight(self) -> None:
        around = [integers.fade(f) for f in range(2**18 - 12, 2**18 + 12)]
        self.assertEqual(around, [t for t in around[::8] for _ in range(8)])
        self.assertLess(around[0], around[8])
        self.assertLess(around[8], around[16])

    @in_thorough_runs
    def test_all_fractions(self) -> None:
        values = [integers.fade(f) for f in range(UNIT + 1)]  # raises where an intermediate value does not fit
        self.assertEqual((values[0], values[UNIT]), (0, 2**18))
        # 2^100 (6 x^5 - 15 x^4 + 10 x^3) of x = f / 2^20.
        errors = [abs((t << 82) - f**3 * (6 * f * f - 15 * f * UNIT + 10 * UNIT * UNIT)) for f, t in enumerate(values)]
        self.assertEqual(max(errors), 4 * 2**82)  # units of 2^-18: 1.53e-5
        self.assertEqual(errors.index(max(errors)), UNIT // 2)
        near = UNIT // 16
        self.assertLess(max(errors[:near + 1] + errors[-near - 1:]), 2**82)
        # It never falls, nor leaps, so that it stays within [0, 1]; and the half above 1/2 mirrors that below.
        steps = [b - a for a, b in itertools.pairwise(values)]
        self.assertEqual((min(steps), max(steps)), (0, 8))
        self.assertEqual([f for f in range(UNIT // 2 + 1) if values[f] + values[UNIT - f] != 2**18], [UNIT // 2])


class Lerp(unittest.TestCase):
    def test_part_by_hand(self) -> None:
        self.assertEqual(integers.part(2**20, 2**17), 2**19)
        self.assertEqual(integers.part(2**20, 513), 2048 + 4 * 1)
        self.assertEqual(integers.part(-2**20, 513), -2048 - 4)
        self.assertEqual(integers.part(-1, 3), -3)  # d >> 18 is -1, and t >> 9 is 0
        self.assertEqual(integers.part(2**28, 491520), 15 * 2**25)  # beyond 1: a slope

    def test_by_hand(self) -> None:
        self.assertEqual(integers.lerp(100, 100 + 2560, 2**17), 100 + 1280)
        self.assertEqual(integers.lerp(-2**29, 2**29, 2**18), 2**29)
        self.assertEqual(integers.lerp(2**29, -2**29, 2**17), 0)
        self.assertEqual(integers.lerp(0, 2**20, 513), 2048 + 4 * 1)
        self.assertEqual(integers.lerp(0, -1, 2**18), -512)  # every step rounds down

    def test_is_below_the_exact_one_by_little(self) -> None:
        # d >> 9 loses up to 511/512 of its unit, t >> 9 times, and d >> 18 up to 1, t & 511 times.
        numbers = generator_of("lerp")
        for _ in range(2000):
            a, b = (numbers.integer(-2**29, 2**29) for _ in range(2))
            t = numbers.integer(0, 2**18)
            exact = a + Fraction((b - a) * t, 2**18)
            self.assertTrue(-1022 < integers.lerp(a, b, t) - exact <= 0, (a, b, t))


class Sine(unittest.TestCase):
    def test_turns(self) -> None:
        turn = 2 * Fraction(gradients.PI, 2**gradients.SINE_BITS)
        numbers = generator_of("turns")
        for m in [0, 1, 2**16 - 1, 2**16, 2**31] + [numbers.integer(0, 2**31) for _ in range(500)]:
            error = (integers.turns_of(m) - m * 2**32 / turn) % 2**32
            self.assertLess(min(error, 2**32 - error), 2, m)

    def test_of_every_part_of_a_quarter(self) -> None:
        # The argument q is rounded to x, and the last half of a step, where the sine is 1, goes to the last x: so the
        # error is largest at one end of the interval of an x.
        ends = [(max(x * 2**14 - 2**13, 0), x * 2**14 + 2**13 - 1) for x in range(2**16 - 1)]
        ends.append((65535 * 2**14 - 2**13, 2**30))
        values = []
        for x, (first, last) in enumerate(ends):
            values.append(integers.sine_of_quarter(x * 2**14))
            at_ends = (integers.sine_of_quarter(first), integers.sine_of_quarter(last))
            self.assertEqual(at_ends, (values[x], values[x]), x)
            for q in (first, last):
                self.assertLess(abs(values[x] / 2**16 - math.sin(math.pi / 2 * q / 2**30)), 3.7e-5, x)
        self.assertEqual((values[0], values[65535], min(values), max(values)), (0, 65535, 0, 2**16))

    def test_is_near_the_exact_sine(self) -> None:
        numbers = generator_of("sine")
        arguments = [0, 1, 2**31 - 1, 2**31, 2**31 + 1, words.MASK] + [numbers.word() for _ in range(1000)]
        arguments += [numbers.integer(-2**bits, 2**bits) & words.MASK for bits in range(1, 31) for _ in range(20)]
        for w in arguments:
            self.assertLess(abs(Fraction(integers.sine_of_word(w), 2**16) - gradients.sine_of_word(w)), 3.7e-5, w)

    def test_is_odd(self) -> None:
        numbers = generator_of("odd")
        for w in [1, 2**24 + 1] + [numbers.word() for _ in range(200)]:
            self.assertEqual(integers.sine_of_word(w), -integers.sine_of_word(-w & words.MASK))

    def test_gradients_of_a_c_program(self) -> None:
        self.assertEqual([g * 2**16 for g in integers.gradient(Knobs("lattice", sine=True), (5, -6, 7), 9)],
                         [10340, 64489, 17322])
        self.assertEqual([g * 2**16 for g in integers.gradient(Knobs("lattice", sine=True), (2**31 - 1, -6))],
                         [27160, 55046])
