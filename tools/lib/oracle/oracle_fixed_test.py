"""Tests of fixed.py.

Numbers by hand and of a C program written from the contract, and how far fixed arithmetic is from the exact values.
"""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Sequence
from fractions import Fraction
from unittest import mock

from golden import rows as golden_rows
from oracle import exact as oracle
from oracle import fixed

UNIT = 2**20
NAMES = ("lattice+fixed", "fnv1+fixed", "lattice+period48+fixed", "lattice+sine+fixed")


def generator(name: str) -> golden_rows.Generator:
    """A generator of test inputs of its own for each test."""
    return golden_rows.Generator(golden_rows.fnv1a64(name.encode()))


def units(value: Fraction) -> int:
    """A noise in units of 2^-21."""
    assert (value * 2**21).denominator == 1
    return int(value * 2**21)


class Coordinates(unittest.TestCase):
    def test_cell_and_fraction(self) -> None:
        table = {
            1.75: (1, 3 * 2**18), -1.75: (-2, 2**18), -1.0: (-1, 0), 0.0: (0, 0), -0.0: (0, 0),
            2.0**-20: (0, 1), 2.0**-21: (0, 0), 2.0**-149: (0, 0), 1 - 2.0**-24: (0, UNIT - 1),
            # Towards 0: what is nearer to 0 than the step of a fraction is 0.
            -2.0**-20: (-1, UNIT - 1), -2.0**-21: (0, 0), -1e-40: (0, 0), -3 * 2.0**-21: (-1, UNIT - 1),
            -1 - 2.0**-23: (-1, 0), -1 + 2.0**-24: (-1, 1),
            2.0**23: (2**23, 0), -2.0**31: (-2**31, 0), 2.0**31: (2147483520, 0), 3e38: (2147483520, 0),
            -3.4e38: (-2**31, 0),
        }
        for p, expected in table.items():
            self.assertEqual(fixed.cell_and_fraction(p), expected, p)

    def test_fraction_of_the_caller(self) -> None:
        table = {0.0: 0, -0.0: 0, 2.0**-149: 0, 2.0**-20: 1, 2.0**-19 - 2.0**-42: 1, 0.75: 3 * 2**18,
                 1 - 2.0**-24: UNIT - 1, 1.0: UNIT, 1 + 2.0**-23: UNIT, 3e38: UNIT, -2.0**-20: 0, -0.5: 0, -3e38: 0}
        for f, expected in table.items():
            self.assertEqual(fixed.fraction_of(f), expected, f)
        self.assertEqual(fixed.perlin_cell("lattice+fixed", (5, -6), (1.5, -0.5), 7),
                         fixed.perlin_cell("lattice+fixed", (5, -6), (1.0, 0.0), 7))
        self.assertEqual(fixed.perlin_cell("lattice+fixed", (5, -6), (-0.5, 0.25), 7),
                         fixed.perlin_cell("lattice+fixed", (5, -6), (0.0, 0.25), 7))

    def test_positions(self) -> None:
        table = {
            1.75: (1, 3 * 2**30), -1.75: (-2, 2**30), -1.0: (-1, 0), -0.0: (0, 0), 2.0**-32: (0, 1), 2.0**-33: (0, 0),
            -2.0**-32: (-1, 2**32 - 1), -2.0**-33: (0, 0), -1e-40: (0, 0), -2.0**-21: (-1, 2**32 - 2**11),
            -1 - 2.0**-23: (-2, 2**32 - 2**9), -2.0**31: (-2**31, 0), 2.0**31: (2147483520, 0), -3.4e38: (-2**31, 0),
        }
        for p, (cell, r) in table.items():
            self.assertEqual(fixed.position_of(p), cell * 2**32 + r, p)

    def test_next_position(self) -> None:
        shift = Fraction(11, 32)
        one, third = 2**32, 2**32 // 3
        self.assertEqual(fixed.next_position(5 * one, 2 * 2**23, shift), 10 * one + 11 * 2**27)
        self.assertEqual(fixed.next_position(-5 * one, 3 * 2**22, Fraction(0)), -7 * one - one // 2)
        self.assertEqual(fixed.next_position(-third, 1, Fraction(0)), -171)  # -170.67, rounded down
        self.assertEqual(fixed.next_position(2**31 * one - 1, 2**24, Fraction(0)), -2)  # 2^64 - 2, wrapped
        self.assertEqual(fixed.next_position(-2**63, 255 * 2**23, shift), -2**63 + 11 * 2**27)
        self.assertEqual(fixed.next_position(7 * one, 0, shift), 11 * 2**27)


class Fade(unittest.TestCase):
    def test_by_hand(self) -> None:
        # At 1/4: x = 2^15, s = 2^30, z = 2^14, R = 172032, Q = 16384 + 10752; s(1/4) is 27136 / 2^18, too. At 1/2 x is
        # 65535, since the square of 2^16 is no word: z = 65534, R = 4, Q = 65535, t = 65535 * 65535 >> 15, cut.
        fractions = (0, 2**18, 2**19 - 1, 2**19, 2**19 + 1, 3 * 2**18, UNIT)
        self.assertEqual([fixed.fade(f) for f in fractions],
                         [0, 27136, 2**17 - 4, 2**17 - 4, 2**17 + 4, 2**18 - 27136, 2**18])

    def test_fractions_are_rounded_to_multiples_of_eight(self) -> None:
        around = [fixed.fade(f) for f in range(2**18 - 12, 2**18 + 12)]
        self.assertEqual(around, [t for t in around[::8] for _ in range(8)])
        self.assertLess(around[0], around[8])
        self.assertLess(around[8], around[16])

    def test_all_fractions(self) -> None:
        values = [fixed.fade(f) for f in range(UNIT + 1)]  # raises where an intermediate value does not fit
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
    def test_by_hand(self) -> None:
        self.assertEqual(fixed.lerp(100, 100 + 2560, 2**17), 100 + 1280)
        self.assertEqual(fixed.lerp(-2**29, 2**29, 2**18), 2**29)
        self.assertEqual(fixed.lerp(2**29, -2**29, 2**17), 0)
        self.assertEqual(fixed.lerp(0, 2**20, 513), 2048 + 4 * 1)
        self.assertEqual(fixed.lerp(0, -1, 2**18), -512)  # every step rounds down

    def test_is_below_the_exact_one_by_little(self) -> None:
        # d >> 9 loses up to 511/512 of its unit, t >> 9 times, and d >> 18 up to 1, t & 511 times.
        numbers = generator("lerp")
        for _ in range(2000):
            a, b = (numbers.integer(-2**29, 2**29) for _ in range(2))
            t = numbers.integer(0, 2**18)
            exact = a + Fraction((b - a) * t, 2**18)
            self.assertTrue(-1022 < fixed.lerp(a, b, t) - exact <= 0, (a, b, t))


class Sine(unittest.TestCase):
    def test_turns(self) -> None:
        turn = 2 * Fraction(oracle.PI, 2**oracle.SINE_BITS)
        numbers = generator("turns")
        for m in [0, 1, 2**16 - 1, 2**16, 2**31] + [numbers.integer(0, 2**31) for _ in range(500)]:
            error = (fixed.turns_of(m) - m * 2**32 / turn) % 2**32
            self.assertLess(min(error, 2**32 - error), 2, m)

    def test_of_every_part_of_a_quarter(self) -> None:
        # The argument q is rounded to x, and the last half of a step, where the sine is 1, goes to the last x: so the
        # error is largest at one end of the interval of an x.
        ends = [(max(x * 2**14 - 2**13, 0), x * 2**14 + 2**13 - 1) for x in range(2**16 - 1)]
        ends.append((65535 * 2**14 - 2**13, 2**30))
        values = []
        for x, (first, last) in enumerate(ends):
            values.append(fixed.sine_of_quarter(x * 2**14))
            self.assertEqual((fixed.sine_of_quarter(first), fixed.sine_of_quarter(last)), (values[x], values[x]), x)
            for q in (first, last):
                self.assertLess(abs(values[x] / 2**16 - math.sin(math.pi / 2 * q / 2**30)), 3.7e-5, x)
        self.assertEqual((values[0], values[65535], min(values), max(values)), (0, 65535, 0, 2**16))

    def test_is_near_the_exact_sine(self) -> None:
        numbers = generator("sine")
        words = [0, 1, 2**31 - 1, 2**31, 2**31 + 1, oracle.MASK] + [numbers.word() for _ in range(1000)]
        words += [numbers.integer(-2**bits, 2**bits) & oracle.MASK for bits in range(1, 31) for _ in range(20)]
        for w in words:
            self.assertLess(abs(Fraction(fixed.sine_of_word(w), 2**16) - oracle.sine_of_word(w)), 3.7e-5, w)

    def test_is_odd(self) -> None:
        numbers = generator("odd")
        for w in [1, 2**24 + 1] + [numbers.word() for _ in range(200)]:
            self.assertEqual(fixed.sine_of_word(w), -fixed.sine_of_word(-w & oracle.MASK))

    def test_gradients_of_a_c_program(self) -> None:
        self.assertEqual([g * 2**16 for g in fixed.gradient("lattice+sine+fixed", (5, -6, 7), 9)],
                         [-65525, 51380, 41229])
        self.assertEqual([g * 2**16 for g in fixed.gradient("lattice+sine+fixed", (2**31 - 1, -6))], [-59610, -12432])

    def test_octahedral_gradient_is_the_same(self) -> None:
        for cell in ((1, 2), (-3, 2**31)):
            self.assertEqual(fixed.gradient("pcg+fixed", cell, 3), oracle.gradient("pcg", cell, 3))


class Ramps(unittest.TestCase):
    def test_octahedral_ramps_are_exact(self) -> None:
        numbers = generator("ramps")
        for _ in range(1000):
            h = numbers.word()
            d = [numbers.integer(-UNIT, UNIT) for _ in range(3)]
            for ramp, gradient in ((fixed.ramp2, oracle.gradient2(h)), (fixed.ramp3, oracle.gradient3(h))):
                exact = sum(Fraction(g) * Fraction(x, UNIT) for g, x in zip(gradient, d))
                self.assertEqual(Fraction(ramp(h, d), 2**29), exact)

    def test_sine_ramps_are_rounded_down(self) -> None:
        numbers = generator("sine ramps")
        for n in (2, 3):
            for _ in range(500):
                g = [numbers.integer(-65536, 65536) for _ in range(n)]
                d = [numbers.integer(-UNIT, UNIT) for _ in range(n)]
                exact = Fraction(sum(a * b for a, b in zip(g, d)), 2**8)
                self.assertTrue(-n < fixed.sine_ramp(g, d) - exact <= 0)


class Noise(unittest.TestCase):
    # Of a C program written from the contract: hn_perlin, hn_perlin of cell and fraction, fBm, turbulence, clouds.
    POINT, SEED = tuple(map(golden_rows.to_f32, (-12.34375, 5.7, 0.8125))), 0xDEADBEEF
    CELL, FRACTION = (2**31 - 1, -2**31, -7), (0.1875, 1.0, 0.640625)
    VECTORS = {
        ("lattice+fixed", 2): (655546, -229145, 217300, 486364, 914360),
        ("lattice+fixed", 3): (-333911, 226917, -457540, 576775, 0),
        ("fnv1+fixed", 2): (-313224, 353789, 559406, 785310, 1844763),
        ("fnv1+fixed", 3): (178425, 520881, -74033, 202715, 178240),
        ("lattice+period48+fixed", 2): (1124504, -554878, 689959, 750933, 2047151),
        ("lattice+period48+fixed", 3): (-585668, -541472, -299874, 366881, 0),
        ("lattice+sine+fixed", 2): (485426, -449071, 271937, 378773, 1077948),
        ("lattice+sine+fixed", 3): (779366, -395129, 337937, 439251, 1274365),
    }

    def test_values_of_a_c_program(self) -> None:
        lacunarity, gain = golden_rows.to_f32(1.9), golden_rows.to_f32(0.7)
        for (name, n), expected in self.VECTORS.items():
            sums = [function(name, self.POINT[:n], 5, lacunarity, gain, self.SEED)
                    for function in (fixed.fbm, fixed.turbulence, fixed.clouds)]
            found = [fixed.perlin(name, self.POINT[:n], self.SEED),
                     fixed.perlin_cell(name, self.CELL[:n], self.FRACTION[:n], 5), *sums]
            self.assertEqual(tuple(map(units, found)), expected, (name, n))

    def test_is_near_the_exact_noise(self) -> None:
        for name, n in itertools.product((*NAMES, "fnv1+sine+period1048576+fixed"), (2, 3)):
            numbers = generator(name)
            for _ in range(40):
                # Multiples of 2^-20: nothing is cut off.
                p = [Fraction(numbers.integer(-2**26, 2**26), UNIT) for _ in range(n)]
                seed = numbers.seed()
                self.assertLess(abs(fixed.perlin(name, p, seed) - oracle.perlin(name, p, seed)), 2**-15)

    def test_zero_at_lattice_points(self) -> None:
        for name, n in itertools.product(NAMES, (2, 3)):
            for c in (-3.0, 0.0, -0.0, 2.0**23, -2.0**31, 3e38):
                self.assertEqual(fixed.perlin(name, (c,) * n, 5), 0)

    def test_values_are_floats(self) -> None:
        numbers = generator("floats")
        for name, n in itertools.product(NAMES, (2, 3)):
            for _ in range(20):
                value = fixed.perlin(name, golden_rows.anywhere(n, numbers), numbers.word())
                self.assertEqual(golden_rows.to_f32(float(value)), value)

    def test_nothing_overflows_and_how_large_it_gets(self) -> None:
        # Whatever the gradients: at each corner the largest ramp there is, of any sign.
        cases = (("lattice+fixed", 2, 2**21), ("lattice+fixed", 3, 2**21),
                 # It is rounded down, in units of 2^-21: along each axis by less than 8 (see Lerp), in the ramps and at
                 # the end by less than 2.
                 ("lattice+sine+fixed", 2, 2**21 + 18), ("lattice+sine+fixed", 3, 3 * 2**20 + 26))
        edges = (0, 1, int(0.3268 * UNIT), int(0.3491 * UNIT), UNIT // 2 - 1, UNIT // 2, UNIT // 2 + 1, UNIT - 1, UNIT)
        for name, n, limit in cases:
            numbers = generator(name)
            for fraction in itertools.product(edges, repeat=n):
                mixed = [numbers.pick((-1, 1)) for _ in range(2**n)]
                for signs in ([1] * 2**n, [-1] * 2**n, mixed):
                    self.assertLessEqual(abs(self.noise_of_largest_ramps(name, fraction, signs)), limit)

    def test_scaling_rounds_to_nearest(self) -> None:
        half = Fraction(1, 2)
        for n, factor in ((2, 1913), (3, 1819)):
            # All corners alike, there is nothing to interpolate. 512 steps of the first rounding meet all ends of the
            # second: both factors are odd.
            for ramp in (512 * k + low for k in range(-256, 256) for low in (255, 256)):
                with mock.patch.object(fixed, "corner_ramp", return_value=ramp):
                    value = fixed.noise("lattice+fixed", (0,) * n, (2**18,) * n, 0)
                rounded = math.floor(Fraction(ramp, 512) + half)
                self.assertEqual(value, math.floor(Fraction(rounded * factor, 512) + half), ramp)

    def noise_of_largest_ramps(self, name: str, fraction: Sequence[int], signs: Sequence[int]) -> int:
        remaining = iter(signs)

        def ramp(knobs: oracle.Configuration, corner: Sequence[int], d: Sequence[int], seed: int) -> int:
            largest = fixed.sine_ramp([2**16 if x > 0 else -2**16 for x in d], d) if knobs.sine else 512 * max(
                map(abs, d))
            return next(remaining) * largest

        with mock.patch.object(fixed, "corner_ramp", ramp):
            return fixed.noise(name, (0,) * len(fraction), fraction, 0)

    def test_the_checks_check(self) -> None:
        for check, bad in ((fixed.signed, (2**31, -2**31 - 1)), (fixed.word, (2**32, -1))):
            for n in bad:
                with self.assertRaises(OverflowError):
                    check(n)


class OctaveSums(unittest.TestCase):
    def test_weights(self) -> None:
        one = 2**18
        self.assertEqual(fixed.weights(3, 0.5), [one, one // 2, one // 4])
        self.assertEqual(fixed.weights(3, 0.0), [one, 0, 0])
        self.assertEqual(fixed.weights(40, 1.5), [one] * 32)
        self.assertEqual(fixed.weights(3, -1.0), [one, 0, 0])
        self.assertEqual((fixed.weights(0, 0.5), fixed.weights(-1, 0.5)), ([], []))
        # Powers of 0.7, whose 18 bits are 183500: of each product the floor.
        self.assertEqual(fixed.weights(4, 0.7), [one, 183500, 183500**2 >> 18, (183500**2 >> 18) * 183500 >> 18])

    def test_weighted_mean(self) -> None:
        one = 2**18
        self.assertEqual(fixed.weighted_mean([2**21, -2**20], [one, one // 2]), 2**20)
        self.assertEqual(fixed.weighted_mean([-3, 0], [one, one]), -1)  # towards 0
        self.assertEqual(fixed.weighted_mean([-3 * 2**20] * 32, [one] * 32), -3 * 2**20)
        self.assertEqual(fixed.weighted_mean([], []), 0)
        # The low bits of a weight: 1000 of 2^18 is 1 * 512 + 488, so 2^18 // 512 * 488 is added to 2^18 * 1.
        self.assertEqual(fixed.weighted_mean([0, 2**18], [one, 1000]),
                         (2**18 + 2**9 * 488 >> 9) * one // (one + 1000))

    def test_density(self) -> None:
        self.assertEqual([fixed.density(v) for v in (-2**21, -2**18, 2**18, 3 * 2**18, 2**21)],
                         [0, 0, 2**20, 2**21, 2**21])
        self.assertEqual(fixed.density(0), 5 * 2**16)
        values = []
        for v in range(-2**18, 3 * 2**18 + 1, 11):
            t = Fraction(v + 2**18, 2**20)
            values.append(fixed.density(v))
            self.assertLess(abs(Fraction(values[-1], 2**21) - t * t * (3 - 2 * t)), 2.6e-5)
        self.assertEqual(values, sorted(values))

    def test_no_octaves(self) -> None:
        for octaves in (0, -1):
            found = [function("pcg+fixed", (1.5, 2.5), octaves, 2.0, 0.5)
                     for function in (fixed.fbm, fixed.turbulence, fixed.clouds)]
            self.assertEqual(found, [0, 0, 0.15625])

    def test_one_octave_is_the_noise_where_nothing_is_cut_off(self) -> None:
        for p in ((0.375, -12.25), (5.125, 7.75, -0.625)):
            self.assertEqual(fixed.fbm("lattice+fixed", p, 1, 2.0, 0.5, 3), fixed.perlin("lattice+fixed", p, 3))
        # Else a position is rounded down, a coordinate of the noise towards 0.
        self.assertEqual(fixed.perlin("lattice+fixed", (-0.5 - 2.0**-24, 0.25), 3),
                         fixed.perlin("lattice+fixed", (-0.5, 0.25), 3))
        self.assertEqual(fixed.fbm("lattice+fixed", (-0.5 - 2.0**-24, 0.25), 1, 2.0, 0.5, 3),
                         fixed.perlin("lattice+fixed", (-0.5 - 2.0**-20, 0.25), 3))

    def test_arguments_are_cut(self) -> None:
        p = (0.375, -12.25)
        for octaves, lacunarity, gain, same in ((33, 2.0, 1.0, (32, 2.0, 1.0)), (4, 300.0, 0.5, (4, 255.0, 0.5)),
                                                (4, -2.0, 0.5, (4, 0.0, 0.5)), (4, 2.0, 1.5, (4, 2.0, 1.0)),
                                                (4, 2.0, -0.5, (1, 2.0, 1.0))):
            self.assertEqual(fixed.fbm("pcg+fixed", p, octaves, lacunarity, gain), fixed.fbm("pcg+fixed", p, *same))

    def test_are_near_the_exact_sums(self) -> None:
        for name, n in itertools.product(NAMES, (2, 3)):
            numbers = generator(name)
            for gain, octaves in ((0.5, 6), (0.75, 4), (1.0, 3)):
                p = [numbers.integer(-4096, 4096) / 64 for _ in range(n)]
                arguments = (name, p, octaves, 2.0, gain, numbers.word())
                for function, limit in (("fbm", 1), ("turbulence", 1), ("clouds", 4)):
                    difference = getattr(fixed, function)(*arguments) - getattr(oracle, function)(*arguments)
                    self.assertLess(abs(difference), limit * 2**-15)

    def test_repeat_after_a_period_with_a_whole_lacunarity(self) -> None:
        for function in (fixed.fbm, fixed.turbulence, fixed.clouds):
            values = [function("lattice+period48+fixed", (x, 7.75), 3, 2.0, 0.5, 3) for x in (5.125, 5.125 - 96)]
            self.assertEqual(*values)

    def test_seeds_step(self) -> None:
        seed, next_seed = 0xFFFFFFFF, 0x9E3779B8
        first = fixed.perlin("pcg+fixed", (0.375, -12.25), seed)
        second = fixed.perlin("pcg+fixed", (0.75 + 0.34375, -24.5 + 0.59375), next_seed)
        self.assertLess(abs(fixed.fbm("pcg+fixed", (0.375, -12.25), 2, 2.0, 0.25, seed) - (4 * first + second) / 5),
                        2**-20)
