"""Tests of phasor.py and phasor_d.py: beside a program in C, and by hand."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Sequence
from fractions import Fraction

from proof.golden.generator import INT_MAX, INT_MIN, to_f32
from proof.oracle import hashes, noises
from proof.oracle.gradients import Real
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Choice, Lattice
from proof.oracle.noises import Noise, phasor, phasor_d
from proof.oracle.noises.phasor import KERNELS
from proof.oracle.testing import KNOBS

PHASOR, SLOPES = map(noises.find, ("phasor", "phasor_d"))

# How far W and E, which is a quarter of the slope on the plane, may be off, in units of 2^-18.
WEIGHT_ERROR, FALL_ERROR = Fraction(37, 4), Fraction(63, 4)


def at(cell: Sequence[int], f: Sequence[Real], wave: Sequence[Real], phase: Real = 0, seed: int = 7,
       periods: Sequence[int] = (), bandwidth: Real | None = None, fixed: bool = False, of: Noise = PHASOR
       ) -> tuple[Fraction, ...]:
    noise = of.rotated(phase).chosen(Choice(wave=tuple(wave), bandwidth=bandwidth))
    return (noise.fixed_cell if fixed else noise.exact_cell)(KNOBS, cell, f, seed, periods)


# From a program in C, with its words of 32 bits, which was written from the contract: the cell, the fraction in units
# of 2^-20, the periods, the wave, the phase and the seed; value, quadrature and their derivatives; a bandwidth, and the
# same with it.
VECTORS = (
    ((0, 0), (0, 0), (0, 0), (0.0, 0.0), 0.0, 0,
     (-1191729, -462683, 0, 0, 0, 0),
     0.0, (-1191729, -462683, 0, 0, 0, 0)),
    ((-1, INT_MAX), (300000, 700001), (3, 0), (16.0, -16.0), 0.75, 7,
     (-1168895, -573555, 1792742, -3747043, -1798347, 3576300),
     2.5, (810368, -1019595, 2939443, 2254931, -2871467, -2291556)),
    ((INT_MIN, -7), (UNIT, 524287), (0, 7), (-3e+38, 2.0**-17), -1 / 3, hashes.MASK,
     (63154, -7117, -53212, -473364, 2, 1),
     16.0, (-831748, 1408009, 4188549, 2298202, 3013264, 2805772)),
    ((4, -3), (12345, 1040000), (5, INT_MAX), (-9.625, 1e-40), 1000.125, 9,
     (-1273031, 117376, 221825, 2405854, 0, 0),
     0.0999, (-1272875, 118897, 223632, 2394156, -2074, -22211)),
    ((0, 0, 0), (0, 0, 0), (0, 0, 0), (0.0, 0.0, 0.0), 0.0, 0,
     (-1286713, -499559, 0, 0, 0, 0, 0, 0),
     2.0**-17, (-1286713, -499559, 0, 0, 0, 0, 0, 0)),
    ((INT_MAX, INT_MIN, -1), (UNIT, 524287, 700001), (0, 0, 0), (16.0, 16.0, -16.0), 0.25, 3,
     (281412, 152674, -659430, 1152848, -584228, 1077799, 574002, -833215),
     3e38, (453139, -766979, 1101919, 867132, 2914633, 1467778, -1610771, -719618)),
    ((-3, 8, 1000), (262144, 262144, 262143), (3, 4, 0), (-1 - 2.0**-17, 2.0**-17, 17.0), -0.75, 5,
     (102169, -1458972, -341774, -23934, -55305, -3873, 4528182, 317095),
     5.3, (-865329, 593050, 515983, -321662, -51867, -622524, -1825230, -2663240)),
    ((1, 2, 3), (500000, 23456, 999999), (0, -48, 2), (11.390625, -7.2578125, 1.5), 0.4, 77,
     (-593777, 1327792, -3106456, -1353753, 1899695, 890611, -405857, -194012),
     -2.0, (-593777, 1327792, -3106446, -1353760, 1899693, 890615, -405849, -194013)))


class Phasor(unittest.TestCase):
    """A wave of another point, phase, direction or weight, or a step that is cut in another place."""

    def test_beside_a_program(self) -> None:
        for cell, fraction, periods, wave, phase, seed, without, bandwidth, with_bandwidth in VECTORS:
            f, wave = [Fraction(x, UNIT) for x in fraction], tuple(map(to_f32, wave))
            for b, expected in ((None, without), (to_f32(bandwidth), with_bandwidth)):
                found = at(cell, f, wave, to_f32(phase), seed, periods, b, True, SLOPES)
                self.assertEqual(tuple(x * unit for x, unit in zip(found, SLOPES.units)), expected)

    def test_waves_of_fixed_arithmetic(self) -> None:
        for of in (phasor.fixed_wave, lambda wave: [k * 2**16 for k in phasor.clamped(wave)]):
            self.assertEqual(of((16 + 2.0**-19, -3e38, 15.75)), [2**20, -2**20, 63 * 2**14])
        self.assertEqual(phasor.fixed_wave((1 + 3 * 2.0**-17, -1 - 3 * 2.0**-17)), [65537, -65537])
        # Each product is rounded down. A last bit is 2^-32 of a turn, and no result shows it but by chance.
        products = (65537 * (16 - 2**17), -65537 * (2**18 + 1))
        found = phasor.fixed_along(KERNELS[2], (65537, -65537), (16 - 2**17, 2**18 + 1))
        self.assertEqual(found, products[0] // 32 + products[1] // 32)
        # Angles wrap. Half a step is 4 turns along each axis.
        lattice, d = Lattice(KNOBS, phase=-0.25, choice=Choice(wave=(16.0, -16.0))), (UNIT // 2, -(UNIT // 2))
        self.assertEqual([phasor.fixed_turns(lattice, KERNELS[2], 2**30 + h, d) for h in (-5, 5)], [hashes.MASK - 4, 5])
        self.assertEqual(phasor.fixed_turns(lattice, KERNELS[3], 0, d), 3 * 2**30)
        # 2 pi is 51471.85 in units of 2^-13, and 16 times that 823549.7.
        self.assertEqual([phasor_d.fixed_turn(k * 2**16) for k in (-16, -1, 0, 1, 16)],
                         [-823548, -51472, 0, 51471, 823548])
        for wave, fixed in itertools.product(((1.0,), (1.0, 2.0, 3.0)), (False, True)):
            with self.assertRaisesRegex(ValueError, "zip"):
                at((0, 0), (0.25, 0.125), wave, fixed=fixed)

    def test_weights(self) -> None:
        """W and E of many t; `word` raises where a step is none."""
        weight = KERNELS[2].weight
        for t in (*range(0, 2**16, 13), 2**16 - 1):
            q = t * t + 2**15 >> 16
            w, fall = weight.of_square(t, q), weight.fall(t, q)
            self.assertEqual((KERNELS[3].weight.of_square(t, q), KERNELS[3].weight.fall(t, q)), (w, 2 * fall))
            # Of t^3 (1 + 15 (1 - t)^2) times 2^80, and of 3 (4 t - 5 t^2)^2 times 2^64.
            exact, slope = t**3 * (2**32 + 15 * (2**16 - t)**2), 3 * (2**18 * t - 5 * t * t)**2
            self.assertTrue(0 <= w < 2**18 and abs(w * 2**62 - exact) < WEIGHT_ERROR * 2**62, t)
            self.assertLess(abs(fall * 2**48 - slope), FALL_ERROR * 2**48, t)
