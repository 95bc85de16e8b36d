"""Tests of phasor.py: by hand, beside floats and beside a program in C; turns, tiles, clamps, seams and errors."""

from __future__ import annotations

import itertools
import math
import statistics
import unittest
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from unittest import mock

from catalog.tables.functions import Function
from proof.golden.generator import INT_MAX, INT_MIN, Generator, generator_of, to_f32
from proof.golden.simplex_rows import PHASES, fractions
from proof.oracle import functions, integers, kernels, noises, turning, words
from proof.oracle.checked import Checked
from proof.oracle.gradients import Knobs, Real
from proof.oracle.integers import NOISE_UNIT, UNIT
from proof.oracle.lattice import Choice, Lattice
from proof.oracle.noises import phasor
from proof.oracle.noises.phasor import KERNELS

PHASOR = noises.find("phasor")
KNOBS = Knobs("lattice")
TILES = {2: ((), (1, 1), (2, 3), (7, 0), (INT_MAX, -4)), 3: ((), (1, 1, 1), (2, 1, 3), (0, 7, -1), (5, INT_MAX, 2))}
ENDS = (INT_MIN, -3, -1, 0, 4, INT_MAX)
QUARTER, HALF = Fraction(1, 4), Fraction(1, 2)

# How far fixed arithmetic may be off where it cuts neither the place nor the wave. The worst of 3600 was 2^-13.34.
ERROR = 2**-13

# The words of the point 0 of the plane, and of space: J = 0x16566, and M = 0xA2FF63 are all the low bits of
# (2 * 0x165667B1 + 1) * 4097. At the centre beside it J is 0x16566 ^ 0x165667 and A is twice as large: M is 0x8AE8C5.
WORD = 0x8F16D072
CENTRE = 0x628A2DC5
NEXT = 0x523EAED6  # that of the second point of the plane, half a cell further along x

# In the middle of two points the weights sum to most, and with these waves theirs agree there.
MIDDLES = {2: (QUARTER, Fraction(0)), 3: (QUARTER,) * 3}
AGREEING = {n: (Fraction(2 * (word - WORD), 2**32), *(0,) * (n - 1)) for n, word in ((2, NEXT), (3, CENTRE))}

MOST = Fraction(9994, 10000)  # of that sum, times the scale

# How much the sum of the squares of the weights varies over a cell: at most so, as a part of its mean.
UNEVEN = {2: 0.106, 3: 0.159}
# How far W and E, which is a quarter of the slope on the plane, may be off, in units of 2^-18.
WEIGHT_ERROR, FALL_ERROR = Fraction(37, 4), Fraction(63, 4)

Numbers = tuple[Real, ...]


def at(cell: Sequence[int], f: Sequence[Real], wave: Sequence[Real], phase: Real = 0, seed: int = 7,
       periods: Sequence[int] = (), fixed: bool = False) -> tuple[Fraction, ...]:
    noise = PHASOR.turned(phase).chosen(Choice(wave=tuple(wave)))
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


# What a program in C makes of it, with its words of 32 bits, which was written from the contract: the hash, the cell,
# the fraction in units of 2^-20, the periods, the wave, the phase and the seed; value and quadrature in units of 2^-21.
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


class Phasor(Checked, unittest.TestCase):
    def check_floats(self) -> None:
        for place in places("floats"):
            self.assertLess(apart(at(*place), naive(*place)), 1e-12, place)

    def check_fixed(self) -> None:
        """Of places and waves that are not cut."""
        for place in places("fixed"):
            self.assertLess(apart(at(*place), at(*place, fixed=True)), ERROR, place)

    def check_program(self) -> None:
        for hash_, cell, fraction, periods, wave, phase, seed, expected in VECTORS:
            noise = PHASOR.turned(to_f32(phase)).chosen(Choice(wave=tuple(map(to_f32, wave))))
            found = noise.fixed_cell(Knobs(hash_), cell, [Fraction(x, UNIT) for x in fraction], seed, periods)
            self.assertEqual(found, tuple(Fraction(x, NOISE_UNIT) for x in expected))

    def check_turns(self) -> None:
        """After whole turns it is the same, after half a turn the negative. A quarter less makes the quadrature the
        value."""
        for cell, f, wave, _, *others in places("turns", 6):
            for phase, fixed in itertools.product((-0.375, 0.0, 0.8125), (False, True)):
                value, quadrature = at(cell, f, wave, phase, *others, fixed=fixed)
                for turns in (-1, 1, 1000):
                    self.assertEqual(at(cell, f, wave, phase + turns, *others, fixed=fixed), (value, quadrature))
                self.assertEqual(at(cell, f, wave, phase - 0.25, *others, fixed=fixed)[0], quadrature)
                opposite = at(cell, f, wave, phase + 0.5, *others, fixed=fixed)
                # Of each of a handful of waves `part` drops less than 2^-20.
                self.assertLess(apart(opposite, (-value, -quadrature)), 2**-17 if fixed else 2**-200)
                self.assertGreater(apart(opposite, (value, quadrature)), 2**-10)

    def check_tiles(self) -> None:
        """With any wave, which may be of any length, and no sooner than after a period."""
        numbers = generator_of("phasor tiles")
        for (cell, f, wave, phase, seed, periods), fixed in itertools.product(places("tiles"), (False, True)):
            for axis, period in enumerate(periods):
                if 0 < period < 10 and abs(cell[axis]) < 10:
                    moved = [c + period * numbers.integer(1, 3) * (i == axis) for i, c in enumerate(cell)]
                    here = at(cell, f, wave, phase, seed, periods, fixed)
                    self.assertEqual(here, at(moved, f, wave, phase, seed, periods, fixed))
                    moved = [c + (i == axis) for i, c in enumerate(cell)]
                    if period > 1:
                        self.assertNotEqual(here, at(moved, f, wave, phase, seed, periods, fixed))

    def check_seams(self) -> None:
        """The end of a cell is where the next one begins, also where int ends and words of coordinates wrap."""
        for (cell, f, wave, phase, seed, periods), fixed in itertools.product(places("seams", 15), (False, True)):
            for axis in range(len(cell)):
                if cell[axis] == INT_MAX and periods and periods[axis] > 0:
                    continue  # over the end of int no tile goes on
                end = [1 if i == axis else x for i, x in enumerate(f)]
                begin = [0 if i == axis else x for i, x in enumerate(f)]
                following = [words.signed(c + (i == axis)) for i, c in enumerate(cell)]
                self.assertEqual(at(cell, end, wave, phase, seed, periods, fixed),
                                 at(following, begin, wave, phase, seed, periods, fixed))

    def check_continuity(self) -> None:
        """Across planes and where points come and go, and in the wave and in the phase."""
        small = Fraction(1, 2**19)
        for index, (cell, f, wave, phase, seed, periods) in enumerate(places("continuity")):
            n = len(cell)
            f = [min(max(Fraction(x), small), 1 - small) for x in f]
            # In a cell each wave turns by at most 16 turns along an axis, and weights change by less than the factor 8.
            steepest = 2 * math.pi * 16 * math.sqrt(n) + 8
            for move in ([small * (i == index % n) for i in range(n)], [small] * n):
                before = at(cell, [x - m for x, m in zip(f, move)], wave, phase, seed, periods)
                after = at(cell, [x + m for x, m in zip(f, move)], wave, phase, seed, periods)
                self.assertLess(apart(before, after), steepest * 2 * length(move))
            here = at(cell, f, wave, phase, seed, periods)
            longer = [Fraction(k) + small for k in wave]
            self.assertLess(apart(here, at(cell, f, longer, phase, seed, periods)), 2 * math.pi * n * small)
            later = at(cell, f, wave, Fraction(phase) + small, seed, periods)
            self.assertLess(apart(here, later), 6.3 * small)

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

    def check_lengths(self) -> None:
        """Never more than 1, and somewhere nearly that: in the middle of two points of the lattice."""
        longest = {2: 0.0, 3: 0.0}
        for place in (*places("lengths", 27), *(([0] * n, MIDDLES[n], AGREEING[n], 0.1, 0, ()) for n in (2, 3))):
            for fixed in (False, True):
                found = length(at(*place, fixed=fixed))
                self.assertLessEqual(found, 1)
                longest[len(place[0])] = max(longest[len(place[0])], found)
        self.assertGreater(min(longest.values()), 0.998)

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
        """Over all phases the mean of the squared length is the sum of the squares of the weights. That is nearly the
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

    CHECKS = ("floats", "fixed", "program", "turns", "tiles", "seams", "continuity", "smoothness", "lengths",
              "sums_of_weights", "energy", "clamps", "cuts")

    def test_faults_of_both_arithmetics_are_found(self) -> None:
        for change, noticing in (({"periods": ()}, ("floats", "program", "tiles")), ({"seed": 0}, ("floats",))):
            right = Lattice.word
            with mock.patch.object(Lattice, "word", lambda lattice, *rest: right(replace(lattice, **change), *rest)):
                self.assert_noticed(*noticing)
        with mock.patch.object(Lattice, "of_triangles", property(lambda lattice: lattice)):
            self.assert_noticed("floats", "program")
        kernels.weighted_points.cache_clear()
        self.addCleanup(kernels.weighted_points.cache_clear)
        with mock.patch.object(kernels, "AROUND", 0):  # no points beyond the corners of a cell
            self.assert_noticed("floats", "seams", "program")
        kernels.weighted_points.cache_clear()
        with mock.patch.object(phasor, "clamped", lambda wave: list(map(Fraction, wave))):
            self.assert_noticed("clamps", "program")
        for n, changes, noticing in (
                (2, {"scale": 763}, ("floats", "program", "sums_of_weights")), (3, {"m": 1}, ("floats", "program")),
                (3, {"scale": 675}, ("floats", "program", "lengths", "sums_of_weights")),
                (3, {"weight": kernels.CUBE}, ("floats", "program", "lengths", "energy")),
                (2, {"weight": kernels.QUARTIC}, ("floats", "program", "energy")),
                (3, {"weight": kernels.Weight(kernels.monomial(1, 0), lambda t, q: 2**18)}, ("continuity",)),
                (3, {"weight": kernels.Weight(kernels.monomial(1, 1), lambda t, q: 4 * t)}, ("smoothness",)),
                (2, {"weight": kernels.Weight(kernels.monomial(1, 2), lambda t, q: 4 * q)}, ("smoothness",))):
            with mock.patch.dict(KERNELS, {n: replace(KERNELS[n], **changes)}):
                self.assert_noticed(*noticing)

    def test_faults_of_the_exact_value_are_found(self) -> None:
        along, turns, waves = phasor.along, phasor.turns, turning.cosine_and_sine
        for name, fault, noticing in (
                ("along", lambda *rest: -along(*rest), ("floats", "fixed")),
                ("along", lambda kernel, *rest: along(kernel, *rest) * kernel.steps, ("floats", "fixed")),
                ("along", lambda *rest: Fraction(math.floor(4 * along(*rest)), 4), ("floats", "continuity")),
                ("turns", lambda lattice, *rest: turns(replace(lattice, phase=0), *rest), ("floats", "turns")),
                ("turns", lambda lattice, kernel, h, d: turns(lattice, kernel, h // 2, d), ("floats", "fixed")),
                ("turns", lambda lattice, kernel, h, d: turns(lattice, kernel, h, [abs(x) for x in d]), ("floats",))):
            with mock.patch.object(phasor, name, fault):
                self.assert_noticed(*noticing)
        with mock.patch.object(turning, "cosine_and_sine", lambda a: waves(a)[::-1]):
            self.assert_noticed("floats", "fixed", "turns")

    def test_faults_of_fixed_arithmetic_are_found(self) -> None:
        right, waves = phasor.fixed_along, integers.cosine_and_sine

        def towards_zero(kernel, wave, d):
            return sum(int(Fraction(k * x, 16 * kernel.steps)) for k, x in zip(phasor.fixed_wave(wave), d))

        def rounded_once(kernel, wave, d):
            return sum(k * x for k, x in zip(phasor.fixed_wave(wave), d)) // (16 * kernel.steps)

        def floored(wave):
            return [math.floor(k * 2**16) for k in phasor.clamped(wave)]

        def saturated(*rest):
            return min(max(right(*rest), -2**31), 2**31 - 1)

        for name, fault, noticing in (("fixed_along", lambda *rest: -right(*rest), ("program", "fixed")),
                                      ("fixed_along", saturated, ("program", "fixed")),
                                      ("fixed_wave", floored, ("cuts",))):
            with mock.patch.object(phasor, name, fault):
                self.assert_noticed(*noticing)
        with mock.patch.object(turning, "angle", lambda phase: 0):
            self.assert_noticed("program", "fixed", "turns")
        with mock.patch.object(integers, "cosine_and_sine", lambda a: waves(a)[::-1]):
            self.assert_noticed("program", "fixed", "turns")
        # A last bit of D is 2^-32 of a turn, and no result tells it from another but by chance.
        kernel, wave, d = KERNELS[2], (1 + 2.0**-16, -1 - 2.0**-16), (16 - 2**17, 2**18 + 1)
        products = (65537 * (16 - 2**17), -65537 * (2**18 + 1))
        self.assertEqual(right(kernel, wave, d), products[0] // 32 + products[1] // 32)
        self.assertEqual([f(kernel, wave, d) - right(kernel, wave, d) for f in (towards_zero, rounded_once)], [2, 1])


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

    def test_between_two_points(self) -> None:
        # Of the plane half a step, a quarter of a cell, from each.
        t = Fraction(819, 1024) - QUARTER
        most = Fraction(762, 1024) * t**3 * (1 + 15 * (1 - t)**2)
        self.assertEqual(words.point_word("lattice", (1, 0)), NEXT)
        for wave, turned in (((0, 0), 0), ((1, 0), 0.25), ((1, 9), 0.25), ((2, 0), 0.5), ((-3, 5), -0.75)):
            a, b = (2 * math.pi * x for x in (WORD / 2**32 + turned, NEXT / 2**32 - turned))
            found = at((0, 0), (QUARTER, 0), wave, 0, 0)
            self.assertLess(apart(found, (most * (math.cos(a) + math.cos(b)), most * (math.sin(a) + math.sin(b)))),
                            1e-14)
        # Of space in the middle of a corner and a centre: t is 1 - 2 * 3/16.
        most = Fraction(674, 1024) * Fraction(5, 8)**3 * (1 + 15 * Fraction(9, 64))
        for wave, turned in (((0, 0, 0), 0), ((1, 0, 0), 0.25), ((1, 2, -7), -1), ((16, 16, -15), 4.25)):
            a, b = (2 * math.pi * x for x in (WORD / 2**32 + turned, CENTRE / 2**32 - turned))
            found = at((0, 0, 0), (QUARTER,) * 3, wave, 0, 0)
            self.assertLess(apart(found, (most * (math.cos(a) + math.cos(b)), most * (math.sin(a) + math.sin(b)))),
                            1e-14)

    def test_without_a_wave_there_are_no_stripes(self) -> None:
        # Then each point has its phase, whatever the way to it: 3/16 of a step further both weights are others.
        f, found = Fraction(11, 32), at((0, 0), (Fraction(11, 32), 0), (0, 0), 0.3, 0)
        total = 0j
        for word, d in ((WORD, 2 * f), (NEXT, 2 * f - 1)):
            t = 819 / 1024 - float(d)**2
            a = 2 * math.pi * (word / 2**32 + 0.3)
            total += 762 / 1024 * t**3 * (1 + 15 * (1 - t)**2) * complex(math.cos(a), math.sin(a))
        self.assertLess(apart(found, (total.real, total.imag)), 1e-14)

    def test_a_wave_runs_along_its_direction(self) -> None:
        # Near a point there is no other: along the wave the phase grows by as many turns, across it stays.
        step = Fraction(1, 64)
        for move, turned in (((step, 0), 4 * step), ((-step, 0), -4 * step), ((0, step), 0)):
            f, cell = [x % 1 for x in move], [math.floor(x) for x in move]
            value, quadrature = at(cell, f, (4, 0), -Fraction(WORD, 2**32), 0)
            self.assertAlmostEqual(math.atan2(quadrature, value) / (2 * math.pi), float(turned), 15)

    def test_fixed_at_a_point(self) -> None:
        # In the plane t, Q, G, M, W are 52416, 41923, 10493, 67124, 214744, in space 65535, 65534, 1, 65534, 262132.
        # A word has two bits more than a phase, so that the angle is 2: there the cosine is 65535, and the sine is 0.
        phase = -Fraction(WORD, 2**32)
        for n, weight, scale in ((2, 214744, 762), (3, 262132, 674)):
            value, quadrature = at((0,) * n, (0,) * n, (0,) * n, phase, 0, fixed=True)
            total = 65535 * 2**4 * (weight >> 9) + (65535 >> 5) * (weight & 511)
            self.assertEqual(value * NOISE_UNIT, ((((total + 256) >> 9) * scale) + 256) >> 9)
            self.assertEqual(quadrature, 0)

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

    def test_fixed_at_a_position(self) -> None:
        wave = PHASOR.turned(0.375).chosen(Choice(wave=(3.0, -7.5)))
        self.assertEqual(wave.fixed(KNOBS, (-2.25 - 2.0**-21, 5.5 + 2.0**-21), 3),
                         wave.fixed_cell(KNOBS, (-3, 5), (0.75, 0.5), 3))


class Weights(unittest.TestCase):
    def errors(self) -> tuple[Fraction, Fraction]:
        """The largest of W and of E on the plane over all t, of which `word` raises where a step is none."""
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

    def test_the_slope_is_that_of_the_weight(self) -> None:
        for t in (Fraction(i, 16) for i in range(17)):
            for kernel in KERNELS.values():
                self.assertEqual(kernel.weight.exact(t), t**3 * (1 + 15 * (1 - t)**2))
                self.assertEqual(kernel.weight.slope(t), 3 * (4 * t - 5 * t**2)**2)


class Rows(unittest.TestCase):
    def test_evaluation(self) -> None:
        numbers = generator_of("phasor rows")
        for (cell, f, wave, phase, seed, periods), has_cell, has_periods, fixed in itertools.product(
                places("rows", 3), *[(False, True)] * 3):
            takes = ("cell" if has_cell else "position", *["period"] * has_periods, "wave", "phase")
            function = Function("noise2d.phasor_any", "simplex_noise", "phasor", takes, ("value", "quadrature"), "f64",
                                len(cell))
            cell = [numbers.integer(-4, 3) for _ in cell]
            periods = tuple(numbers.integer(1, 3) for _ in cell) if has_periods else ()
            place = (*cell, *f) if has_cell else tuple(c + x for c, x in zip(cell, f))
            found = functions.evaluator(function, fixed)(KNOBS, (*place, *periods, *wave, phase, seed))
            self.assertEqual(found, at(cell, f, wave, phase, seed, periods, fixed))


if __name__ == "__main__":
    unittest.main()
