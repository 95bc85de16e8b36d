"""Tests of phasor_d.py: beside differences of phasor noise, by hand, and beside a program in C."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.oracle import kernels, noises, words
from proof.oracle.gradients import Real
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Choice
from proof.oracle.noises import phasor, phasor_d
from proof.oracle.noises.phasor import KERNELS
from proof.oracle.noises.phasor_test import WORD, places
from proof.oracle.testing import KNOBS, FaultChecks

SLOPES, PHASOR = map(noises.find, ("phasor_d", "phasor"))

# How far fixed arithmetic may be off where it cuts neither the place nor the wave. The worst of 480 was 2^-6.86: its
# value is off by 2^-13, and in a cell there are up to 16 turns of it.
ERROR = 2**-6.5


def of(noise: noises.Noise, place: tuple, fixed: bool = False) -> tuple[Fraction, ...]:
    cell, f, wave, phase, seed, periods = place
    noise = noise.rotated(phase).chosen(Choice(wave=tuple(wave)))
    return (noise.fixed_cell if fixed else noise.exact_cell)(KNOBS, cell, f, seed, periods)


def moved(place: tuple, axis: int, step: Fraction) -> tuple:
    cell, f, *others = place
    return (cell, [Fraction(x) + step * (i == axis) for i, x in enumerate(f)], *others)


def derivatives(found: Sequence[Real]) -> list[Sequence[Real]]:
    """A pair along each axis."""
    return list(zip(found[2::2], found[3::2], strict=True))


# From a program in C, with its words of 32 bits, which was written from the contract: the cell, the fraction in units
# of 2^-20, the periods, the wave, the phase and the seed; value, quadrature and their derivatives.
VECTORS = (
    ((0, 0), (0, 0), (0, 0), (0.0, 0.0), 0.0, 0,
     (-1191729, -462683, 0, 0, 0, 0)),
    ((-1, INT_MAX), (300000, 700001), (3, 0), (16.0, -16.0), 0.75, 7,
     (-1168895, -573555, 1792742, -3747043, -1798347, 3576300)),
    ((INT_MIN, -7), (UNIT, 524287), (0, 7), (-3e+38, 2.0**-17), -1 / 3, words.MASK,
     (63154, -7117, -53212, -473364, 2, 1)),
    ((4, -3), (12345, 1040000), (5, INT_MAX), (-9.625, 1e-40), 1000.125, 9,
     (-1273031, 117376, 221825, 2405854, 0, 0)),
    ((0, 0, 0), (0, 0, 0), (0, 0, 0), (0.0, 0.0, 0.0), 0.0, 0,
     (-1286713, -499559, 0, 0, 0, 0, 0, 0)),
    ((INT_MAX, INT_MIN, -1), (UNIT, 524287, 700001), (0, 0, 0), (16.0, 16.0, -16.0), 0.25, 3,
     (281412, 152674, -659430, 1152848, -584228, 1077799, 574002, -833215)),
    ((-3, 8, 1000), (262144, 262144, 262143), (3, 4, 0), (-1 - 2.0**-17, 2.0**-17, 17.0), -0.75, 5,
     (102169, -1458972, -341774, -23934, -55305, -3873, 4528182, 317095)),
    ((1, 2, 3), (500000, 23456, 999999), (0, -48, 2), (11.390625, -7.2578125, 1.5), 0.4, 77,
     (-593777, 1327792, -3106456, -1353753, 1899695, 890611, -405857, -194012)))


class Derivatives(FaultChecks, unittest.TestCase):
    def check_differences(self) -> None:
        """Of the exact value, on both sides, also where points come and go."""
        step = Fraction(1, 2**24)
        for place in places("differences", 15):
            for axis, along in enumerate(derivatives(of(SLOPES, place))):
                ends = [of(PHASOR, moved(place, axis, step * side)) for side in (-1, 1)]
                for a, b, derivative in zip(*ends, along):
                    # A third derivative is up to (2 pi 16)^3 and somewhat more.
                    self.assertLess(abs((b - a) / (2 * step) - derivative), 2**22 * step**2, place)

    def check_fixed(self) -> None:
        for place in places("fixed derivatives"):
            for exact, fixed in zip(of(SLOPES, place)[2:], of(SLOPES, place, True)[2:], strict=True):
                self.assertLess(abs(exact - fixed), ERROR, place)
                self.assertEqual((fixed * 2**16).denominator, 1)
                self.assertLess(abs(fixed), 2**8)

    def check_program(self) -> None:
        for cell, fraction, periods, wave, phase, seed, expected in VECTORS:
            wave, f = tuple(map(to_f32, wave)), [Fraction(x, UNIT) for x in fraction]
            found = of(SLOPES, (cell, f, wave, to_f32(phase), seed, periods), True)
            self.assertEqual(tuple(x * unit for x, unit in zip(found, SLOPES.units)), expected)

    CHECKS = ("differences", "fixed", "program")
    FAULTS = (
        (phasor_d, "TWO_PI", Fraction(355, 56), ("differences",)), (phasor_d, "FIXED_TWO_PI", 205888, ("program",)),
        (phasor_d, "of_weights", lambda lattice, cell, fraction: [(0, 0)] * len(cell), ("fixed", "program")),
        (phasor_d, "fixed_turn", lambda k: 0, ("fixed", "program")),
        *((KERNELS, n, replace(KERNELS[n], weight=replace(weight, fall=lambda t, q: kernels.even_fall(t, q) + 2**10)),
           ("fixed", "program")) for n, weight in ((2, kernels.PLANE_EVEN), (3, kernels.SPACE_EVEN))))


class ByHand(unittest.TestCase):
    def test_at_a_point(self) -> None:
        """There the weight is the largest, and the wave alone counts."""
        for n, wave in ((2, (3, -5)), (2, (17, 0)), (3, (3, -5, 16))):
            t = Fraction(KERNELS[n].r, 1024)
            most = Fraction(KERNELS[n].scale, 1024) * KERNELS[n].weight.exact(t)
            place = ((0,) * n, (0,) * n, wave, -Fraction(WORD, 2**32), 0, ())
            value, quadrature, *found = of(SLOPES, place)
            self.assertEqual((value, quadrature), (most, 0))
            for k, (of_value, of_quadrature) in zip(wave, derivatives((value, quadrature, *found))):
                self.assertEqual(of_value, 0)
                self.assertAlmostEqual(float(of_quadrature), 2 * math.pi * min(k, 16) * float(most), 12)

    def test_turns_of_fixed_arithmetic(self) -> None:
        # 2 pi is 51471.85 in units of 2^-13, and 16 times that 823549.7.
        self.assertEqual([phasor_d.fixed_turn(k * 2**16) for k in (-16, -1, 0, 1, 16)],
                         [-823548, -51472, 0, 51471, 823548])

    def test_where_waves_are_steepest_nothing_overflows(self) -> None:
        """`signed` raises where it would. All waves meet, in the direction that makes sums largest."""
        with mock.patch.object(phasor.integers, "cosine_and_sine", lambda a: (65536, -65536)), \
                mock.patch.object(phasor_d.phasor, "fixed", lambda *_: (2**21, -2**21)):
            numbers = generator_of("steepest")
            for n, _ in itertools.product((2, 3), range(100)):
                f = [Fraction(numbers.integer(0, 64), 64) for _ in range(n)]
                for sign in (-16, 16):
                    of(SLOPES, ((0,) * n, f, (sign,) * n, 0, 0, ()), True)
