"""Tests of phasor.py: by hand, beside floats and beside a program in C; weights, clamps and errors."""

from __future__ import annotations

import itertools
import math
import statistics
import unittest
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, INT_MIN, Generator, generator_of, to_f32
from proof.golden.simplex_rows import PHASES, fractions
from proof.oracle import integers, kernels, noises, rotation, words
from proof.oracle.gradients import Knobs, Real
from proof.oracle.integers import NOISE_UNIT, UNIT
from proof.oracle.lattice import Choice, Lattice
from proof.oracle.noises import phasor
from proof.oracle.noises.phasor import KERNELS
from proof.oracle.testing import KNOBS, FaultChecks

PHASOR = noises.find("phasor")
TILES = {2: ((), (1, 1), (2, 3), (7, 0), (INT_MAX, -4)), 3: ((), (1, 1, 1), (2, 1, 3), (0, 7, -1), (5, INT_MAX, 2))}
ENDS = (INT_MIN, -3, -1, 0, 4, INT_MAX)
QUARTER, HALF = Fraction(1, 4), Fraction(1, 2)

# How far fixed arithmetic may be off where it cuts neither the place nor the wave. The worst of 3600 was 2^-13.34.
ERROR = 2**-13

# The words of the point 0 of the plane, and of space: J = 0x16566, and M = 0xA2FF63 are all the low bits of
# (2 * 0x165667B1 + 1) * 4097. At the centre beside it J is 0x16566 ^ 0x165667 and A is twice as large: M is 0x8AE8C5.
WORD = 0x8F16D072
CENTRE = 0x628A2DC5
# In the middle of two points the weights sum to most, and with these waves theirs agree there.
MIDDLES = {2: (QUARTER, Fraction(0)), 3: (QUARTER,) * 3}
MOST = Fraction(9994, 10000)  # of that sum, times the scale

# How much the sum of the squares of the weights varies over a cell: at most so, as a part of its mean.
UNEVEN = {2: 0.106, 3: 0.159}
# How far W and E, which is a quarter of the slope on the plane, may be off, in units of 2^-18.
WEIGHT_ERROR, FALL_ERROR = Fraction(37, 4), Fraction(63, 4)


def at(cell: Sequence[int], f: Sequence[Real], wave: Sequence[Real], phase: Real = 0, seed: int = 7,
       periods: Sequence[int] = (), fixed: bool = False) -> tuple[Fraction, ...]:
    noise = PHASOR.rotated(phase).chosen(Choice(wave=tuple(wave)))
    return (noise.fixed_cell if fixed else noise.exact_cell)(KNOBS, cell, f, seed, periods)


def naive(cell: Sequence[int], f: Sequence[Real], wave: Sequence[Real], phase: Real = 0, seed: int = 7,
          periods: Sequence[int] = ()) -> tuple[float, float]:
    """The sum over all points around a cell, in floats."""
    n, value, quadrature = len(cell), 0.0, 0.0
    turns = math.fmod(phase, 1)
    # The numbers of the points beside those of the cell's first corner, whether they are centres, and where they are.
    if n == 2:
        around = [((i, j), False, (i / 2 + j % 2 / 4, j / 2)) for i in range(-5, 7) for j in range(-4, 6)]
    else:
        around = [(c, centre, [x + centre / 2 for x in c])
                  for c in itertools.product(range(-2, 4), repeat=3) for centre in (False, True)]
    steps = 2 if n == 2 else 1
    for numbers, centre, place in around:
        d = [x - y for x, y in zip(f, place)]
        t = 819 / 1024 - 4 * sum(x * x for x in d) if n == 2 else 1 - 2 * sum(x * x for x in d)
        if t <= 0:
            continue
        point = [steps * c + i for c, i in zip(cell, numbers)]
        point = [i % (steps * period) if period > 0 else i for i, period in zip(point, periods or (0,) * n)]
        a = words.point_word("lattice", point, seed, centre) / 2**32 + turns
        a += sum(max(-16.0, min(16.0, k)) * x for k, x in zip(wave, d))
        weight = t**3 * (1 + 15 * (1 - t)**2)
        value += weight * math.cos(2 * math.pi * a)
        quadrature += weight * math.sin(2 * math.pi * a)
    scale = (762 if n == 2 else 674) / 1024
    return scale * value, scale * quadrature


def some_wave(n: int, numbers: Generator) -> tuple[float, ...]:
    """One that fixed arithmetic does not cut: none, along an axis or a diagonal, or any; some are too long."""
    kind, k = numbers.integer(0, 3), numbers.pick((1.0, -0.5, 16.0, -16.0, 17.0, -3e38))
    if kind < 2:
        axis = numbers.integer(0, n - 1)
        return tuple(k * kind if i == axis else 0.0 for i in range(n))
    if kind == 2:
        return tuple(numbers.pick((k, -k)) for _ in range(n))
    return tuple(numbers.integer(-2**20, 2**20) / 2**16 for _ in range(n))


Place = tuple[list[int], Sequence[float], tuple[float, ...], float, int, Sequence[int]]


def places(name: str, count: int = 24) -> Iterator[Place]:
    """The arguments of `at`: on the planes at which other points count, beside them and near the ends of kernels."""
    numbers = generator_of(f"phasor {name}")
    for n in (2, 3):
        for index, f in enumerate(fractions(n, count, numbers)):
            cell = [numbers.pick((numbers.integer(-4, 3), numbers.pick(ENDS))) for _ in range(n)]
            phase = numbers.pick((numbers.pick(PHASES), numbers.uniform(-2, 2)))
            yield cell, f, some_wave(n, numbers), phase, numbers.word(), TILES[n][index % 5]


def length(found: Sequence[Real]) -> float:
    return math.hypot(*map(float, found))


def apart(a: Sequence[Real], b: Sequence[Real]) -> float:
    return length([x - y for x, y in zip(a, b, strict=True)])


# From a program in C, with its words of 32 bits, which was written from the contract: the hash, the cell, the fraction
# in units of 2^-20, the periods, the wave, the phase and the seed; value and quadrature in units of 2^-21.
VECTORS = (
    ("lattice", (0, 0), (0, 0), (0, 0), (0.0, 0.0), 0.0, 0, (-1191729, -462683)),
    ("lattice", (-1, INT_MAX), (300000, 700001), (3, 0), (16.0, -16.0), 0.75, 7, (-1168895, -573555)),
    ("pcg", (INT_MAX, INT_MIN), (UNIT, UNIT - 1), (0, 2), (-3e38, 2.0**-17), -1 / 3, words.MASK, (-349465, 1229709)),
    ("lattice", (5, -4), (262144, 131072), (0, 0), (1 + 3 * 2.0**-17, -1 - 3 * 2.0**-17), 2.0**-30, 0,
     (210197, -327700)),
    ("lattice", (4, -3), (12345, 1040000), (5, INT_MAX), (-9.625, 1e-40), 1000.125, 9, (-1273031, 117376)),
    ("lattice", (INT_MIN, -7), (524288, 524287), (0, 7), (-16.0, 16.0), -3e38, 1, (1985775, -85844)),
    ("lattice", (0, 0, 0), (0, 0, 0), (0, 0, 0), (0.0, 0.0, 0.0), 0.0, 0, (-1286713, -499559)),
    ("lattice", (INT_MAX, INT_MAX, -1), (UNIT, 524287, 700001), (0, 0, 0), (16.0, 16.0, 16.0), 0.25 - 2.0**-17, 3,
     (-947465, 1278998)),
    ("lattice", (-3, 8, 1000), (262144, 262144, 262144), (3, 4, 0), (-1 - 2.0**-17, 2.0**-17, -2.0**-17), -0.75, 5,
     (102297, -1458940)),
    ("pcg", (6, INT_MIN, 2), (1, 1048575, 524289), (7, 1, 48), (-16.0, math.pi, 17.0), -2.0**-31, words.MASK,
     (31415, 1179853)),
    ("lattice", (1, 2, 3), (500000, 23456, 999999), (0, -48, 2), (11.390625, -7.2578125, -16 + 2.0**-20), 0.4, 77,
     (964314, 1067894)))


# The parts of faults.
WORD_OF, ALONG, TURNS, FIXED_ALONG = Lattice.word, phasor.along, phasor.turns, phasor.fixed_along
WAVE, FIXED_WAVE = rotation.cosine_and_sine, integers.cosine_and_sine


class Phasor(FaultChecks, unittest.TestCase):
    def check_floats(self) -> None:
        for place in places("floats"):
            self.assertLess(apart(at(*place), naive(*place)), 1e-12, place)

    def check_fixed(self) -> None:
        """Of places and waves that are not cut."""
        for place in places("fixed"):
            self.assertLess(apart(at(*place), at(*place, fixed=True)), ERROR, place)

    def check_program(self) -> None:
        for hash_, cell, fraction, periods, wave, phase, seed, expected in VECTORS:
            noise = PHASOR.rotated(to_f32(phase)).chosen(Choice(wave=tuple(map(to_f32, wave))))
            found = noise.fixed_cell(Knobs(hash_), cell, [Fraction(x, UNIT) for x in fraction], seed, periods)
            self.assertEqual(found, tuple(Fraction(x, NOISE_UNIT) for x in expected))

    def check_smoothness(self) -> None:
        """The second derivative along an axis does not jump where a point comes or goes: with steps of 2^-12 cells
        neighbouring ones are alike."""
        step = Fraction(1, 2**12)
        for cell, f, wave, _, seed, periods in places("smoothness", 12):
            n = len(cell)
            wave = [k / 32 for k in wave]
            inner = [min(max(Fraction(x), 4 * step), 1 - 4 * step) for x in f]
            line = [at(cell, [x + i * step * (axis == n - 1) for axis, x in enumerate(inner)], wave, 0, seed, periods)
                    for i in range(-2, 3)]
            second = [[(a - 2 * b + c) / step**2 for a, b, c in zip(*line[i:i + 3])] for i in range(3)]
            self.assertLess(apart(second[0], second[2]), 2)

    def check_sums_of_weights(self) -> None:
        """If all waves met. In fixed arithmetic a cosine is up to 1, a sine of that 3 * 2^-16, and each is rounded."""
        numbers = generator_of("phasor weights")
        for n, kernel in KERNELS.items():
            for index in range(80):
                f = tuple(Fraction(numbers.integer(0, 2**numbers.integer(0, 20)), UNIT) for _ in range(n))
                if index % 4 == 0:
                    f = tuple(x + Fraction(numbers.integer(0, 2**index), 2**80) for x in MIDDLES[n])
                total = sum(kernel.weight.exact(t) for _, _, t in kernels.weighted_points(kernel, f))
                self.assertLessEqual(kernel.scale * total, MOST * 1024)
                found = sum(kernel.weight.of_square(*kernels.fixed_t(kernel, point.square))
                            for point in kernels.fixed_points(kernel, [int(x * UNIT) for x in f]))
                self.assertLessEqual(kernel.scale * found, MOST * 1024 * 2**18)

    def check_energy(self) -> None:
        """Over all phases the mean of the squared length is the sum of the squares of the weights. It is nearly the
        same everywhere: its deviation over a cell is a small part of its mean, and hardly less than what is allowed."""
        for n, kernel in KERNELS.items():
            side = {2: 24, 3: 6}[n]
            # By reflections and half turns a half of a cell along each axis has all that there is.
            found = [sum(float(kernel.weight.exact(t))**2 for _, _, t in kernels.weighted_points(kernel, f))
                     for f in itertools.product([Fraction(2 * i + 1, 4 * side) for i in range(side)], repeat=n)]
            deviation = statistics.pstdev(found) / statistics.fmean(found)
            self.assertTrue(UNEVEN[n] - 0.004 < deviation < UNEVEN[n], (n, deviation))

    def check_clamps(self) -> None:
        numbers = generator_of("phasor clamped")
        for cell, _, _, *others in places("clamps", 3):
            n = len(cell)
            f = [numbers.uniform(0.05, 0.2) for _ in cell]  # away from where an axis does not matter
            for axis, sign, fixed in itertools.product(range(n), (1, -1), (False, True)):
                def along(k: float) -> tuple[Fraction, ...]:
                    return at(cell, f, [sign * k if i == axis else 2.0 for i in range(n)], *others, fixed=fixed)

                for beyond in (16 + 2.0**-19, 17.0, 3e38):
                    self.assertEqual(along(16.0), along(beyond))
                self.assertNotEqual(along(16.0), along(15.75))

    def check_cuts(self) -> None:
        """Towards 0, the wave to a multiple of 2^-16, the phase to one of 2^-30 and the fraction to one of 2^-20."""
        fine, seed, differ = 2.0**-17, 11, 0
        for n, sign in itertools.product((2, 3), (1, -1)):
            f, phase = [0.3125, 0.4375, 0.1875][:n], sign * (0.3 // 2.0**-10 * 2.0**-10)
            wave, cut = [sign * (1.5 + 1.5 * fine)] * n, [sign * 1.5] * n
            for same in ((f, wave, phase), ([x + 2.0**-21 for x in f], cut, phase),
                         (f, cut, phase + sign * 2.0**-31), (f, [sign * (1.5 + fine)] * n, phase)):
                self.assertEqual(at([3] * n, *same, seed, fixed=True), at([3] * n, f, cut, phase, seed, fixed=True))
                self.assertNotEqual(at([3] * n, *same, seed), at([3] * n, f, cut, phase, seed))
            for other in ((f, [sign * (1.5 + 2 * fine)] * n, phase), (f, cut, phase + sign * 2.0**-14)):
                differ += at([3] * n, *other, seed, fixed=True) != at([3] * n, f, cut, phase, seed, fixed=True)
            self.assertEqual(at([3] * n, f, [sign * 2.0**-149] * n, phase, seed, fixed=True),
                             at([3] * n, f, [0.0] * n, phase, seed, fixed=True))
        self.assertGreater(differ, 4)

    CHECKS = ("floats", "fixed", "program", "smoothness", "sums_of_weights", "energy", "clamps", "cuts")
    FAULTS = (
        (Lattice, "word", lambda lattice, *rest: WORD_OF(replace(lattice, periods=()), *rest), ("floats", "program")),
        (Lattice, "of_triangles", property(lambda lattice: lattice), ("floats", "program")),
        (phasor, "clamped", lambda wave: list(map(Fraction, wave)), ("clamps", "program")),
        (KERNELS, 2, replace(KERNELS[2], scale=763), ("floats", "program", "sums_of_weights")),
        (KERNELS, 3, replace(KERNELS[3], m=1), ("floats", "program")),
        (KERNELS, 3, replace(KERNELS[3], weight=kernels.CUBE), ("floats", "program", "energy")),
        (KERNELS, 3, replace(KERNELS[3], weight=kernels.Weight(kernels.monomial(1, 1), kernels.third)),
         ("smoothness",)),
        (phasor, "along", lambda *rest: -ALONG(*rest), ("floats", "fixed")),
        (phasor, "turns", lambda lattice, *rest: TURNS(replace(lattice, phase=0), *rest), ("floats", "fixed")),
        (rotation, "cosine_and_sine", lambda a: WAVE(a)[::-1], ("floats", "fixed")),
        (phasor, "fixed_along", lambda *rest: min(max(FIXED_ALONG(*rest), -2**31), 2**31 - 1), ("program", "fixed")),
        (phasor, "fixed_wave", lambda wave: [math.floor(k * 2**16) for k in phasor.clamped(wave)], ("cuts",)),
        (rotation, "angle", lambda phase: 0, ("program", "fixed")),
        (integers, "cosine_and_sine", lambda a: FIXED_WAVE(a)[::-1], ("program", "fixed")))


class ByHand(unittest.TestCase):
    def test_at_points(self) -> None:
        t = Fraction(819, 1024)
        plane, space = Fraction(762, 1024) * t**3 * (1 + 15 * (1 - t)**2), Fraction(674, 1024)
        # There are no others so near. With the phase that the word lacks to a whole turn the wave is at its top.
        for cell, f, word, most in (((0, 0), (0, 0), WORD, plane), ((0, 0, 0), (0, 0, 0), WORD, space),
                                    ((0, 0, 0), (HALF,) * 3, CENTRE, space)):
            for wave in ((0,) * len(cell), (3, -5, 16)[:len(cell)]):
                for quarters, expected in enumerate(((most, 0), (0, most), (-most, 0), (0, -most))):
                    phase = Fraction(quarters, 4) - Fraction(word, 2**32)
                    self.assertEqual(at(cell, f, wave, phase, 0), expected)

    def test_fixed_at_a_point(self) -> None:
        # In the plane t, Q, G, M, W are 52416, 41923, 10493, 67124, 214744, in space 65535, 65534, 1, 65534, 262132.
        # A word has two bits more than a phase, so that the angle is 2: there the cosine is 65535, and the sine is 0.
        phase = -Fraction(WORD, 2**32)
        for n, weight, scale in ((2, 214744, 762), (3, 262132, 674)):
            value, quadrature = at((0,) * n, (0,) * n, (0,) * n, phase, 0, fixed=True)
            total = 65535 * 2**4 * (weight >> 9) + (65535 >> 5) * (weight & 511)
            self.assertEqual(value * NOISE_UNIT, ((((total + 256) >> 9) * scale) + 256) >> 9)
            self.assertEqual(quadrature, 0)

    def test_products_of_a_wave_are_rounded_down_each(self) -> None:
        # A last bit of D is 2^-32 of a turn, and no result shows it but by chance.
        products = (65537 * (16 - 2**17), -65537 * (2**18 + 1))
        found = phasor.fixed_along(KERNELS[2], (1 + 2.0**-16, -1 - 2.0**-16), (16 - 2**17, 2**18 + 1))
        self.assertEqual(found, products[0] // 32 + products[1] // 32)

    def test_angles_of_fixed_arithmetic_wrap(self) -> None:
        lattice = Lattice(KNOBS, phase=-0.25, choice=Choice(wave=(16.0, -16.0)))
        d = (UNIT // 2, -(UNIT // 2))  # half a step: 4 turns along each axis
        self.assertEqual(phasor.fixed_along(KERNELS[2], (16.0, -16.0), d), 8 * 2**32)
        self.assertEqual(phasor.fixed_turns(lattice, KERNELS[2], 2**30 - 5, d), words.MASK - 4)
        self.assertEqual(phasor.fixed_turns(lattice, KERNELS[2], 2**30 + 5, d), 5)
        self.assertEqual(phasor.fixed_turns(lattice, KERNELS[3], 0, d), 3 * 2**30)

    def test_a_wave_has_a_number_for_each_axis(self) -> None:
        for wave, fixed in itertools.product(((), (1.0,), (1.0, 2.0, 3.0)), (False, True)):
            with self.assertRaisesRegex(ValueError, "zip"):
                at((0, 0), (0.25, 0.125), wave, fixed=fixed)


class Weights(unittest.TestCase):
    def errors(self) -> tuple[Fraction, Fraction]:
        """The largest of W and of E on the plane over all t; `word` raises where a step is none."""
        kernel, of_weight, of_fall = KERNELS[2], 0, 0
        for t in range(2**16):
            q = t * t + 2**15 >> 16
            w, fall = kernel.weight.of_square(t, q), kernel.weight.fall(t, q)
            self.assertTrue(0 <= w < 2**18)
            self.assertEqual((KERNELS[3].weight.of_square(t, q), KERNELS[3].weight.fall(t, q)), (w, 2 * fall))
            # Of t^3 (1 + 15 (1 - t)^2) times 2^80, and of 3 (4 t - 5 t^2)^2 times 2^64.
            exact, slope = t**3 * (2**32 + 15 * (2**16 - t)**2), 3 * (2**18 * t - 5 * t * t)**2
            of_weight = max(of_weight, abs(w * 2**62 - exact))
            of_fall = max(of_fall, abs(fall * 2**48 - slope))
        return Fraction(of_weight, 2**62), Fraction(of_fall, 2**48)

    def test_every_t(self) -> None:
        of_weight, of_fall = self.errors()
        self.assertTrue(WEIGHT_ERROR - Fraction(1, 8) < of_weight < WEIGHT_ERROR, float(of_weight))
        self.assertTrue(FALL_ERROR - Fraction(1, 8) < of_fall < FALL_ERROR, float(of_fall))

    def test_another_step_is_noticed(self) -> None:
        """Steps that round down, a step that is too large for a word, and another weight."""
        for weight, fault in ((lambda t, q: (q + (15 * (t - q)**2 >> 16)) * t >> 14, self.failureException),
                              (lambda t, q: kernels.word((q * 2**16 + 15 * (t - q)**2) * t) >> 30, OverflowError),
                              (kernels.third, self.failureException)):
            changed = {n: replace(kernel, weight=replace(kernel.weight, of_square=weight))
                       for n, kernel in KERNELS.items()}
            with mock.patch.dict(KERNELS, changed), self.assertRaises(fault):
                self.test_every_t()
