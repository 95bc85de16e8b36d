"""Tests of jacobians.py: by hand, by difference quotients, and fixed arithmetic by the exact one."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Iterator, Sequence
from fractions import Fraction
from unittest import mock

from proof.golden.generator import Generator, generator_of
from proof.oracle import jacobians, noises, sums
from proof.oracle.gradients import Knobs, Real
from proof.oracle.integers import NOISE_UNIT, signed
from proof.oracle.jacobians import Plane, Space
from proof.oracle.noises import Noise
from proof.oracle.sums import Options, in_cell
from proof.oracle.words import MASK, SEED_STEP

LATTICE = Knobs("lattice")
ONE = 2**18
PERLIN, SLOPES, VECTOR = map(noises.find, ("perlin", "perlin_d", "value_vector"))


def exact(name: str, p: Sequence[Real], options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    noise = noises.find(jacobians.SUMS[name].noise)
    return jacobians.exact(name, noise, LATTICE, sums.at_position(p), options, seed, periods)


def fixed(name: str, p: Sequence[Real], options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    noise = noises.find(jacobians.SUMS[name].noise)
    return jacobians.fixed(name, noise, LATTICE, sums.fixed_at_position(p), options, seed, periods)


def vector_at(p: Sequence[Real], seed: int, periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    return VECTOR.exact(LATTICE, p, seed, periods)


def somewhere(n: int, numbers: Generator) -> list[Fraction]:
    """A position that fixed arithmetic does not cut."""
    return [Fraction(numbers.integer(-2**23, 2**23), 2**20) for _ in range(n)]


def cases(name: str, count: int = 6) -> Iterator[tuple[list[Fraction], int, Sequence[int]]]:
    """Positions of both dimensions, seeds, and none or some periods."""
    numbers = generator_of(name)
    for n, periodic, _ in itertools.product((2, 3), (False, True), range(count)):
        yield somewhere(n, numbers), numbers.word(), (48, 5, 0)[:n] if periodic else ()


class Jacobians(unittest.TestCase):
    def exact_jacobians(self, n: int, options: Options, periods: Sequence[int] = (),
                     count: int = 3) -> list[jacobians.Matrix]:
        return list(itertools.islice(jacobians.jacobians_of(n, options, periods), count))

    def test_by_hand(self) -> None:
        # 0.5 * 3 times the rotation, which is 25/32 and 20/32.
        unit, first, second = self.exact_jacobians(2, Options(3, 3.0, 0.5))
        c, s = Fraction(75, 64), Fraction(60, 64)
        self.assertEqual((unit, first), ([[1, 0], [0, 1]], [[c, -s], [s, c]]))
        self.assertEqual(second, [[c * c - s * s, -2 * c * s], [2 * c * s, c * c - s * s]])
        # In space the rows rotate: (25, -20, 0) / 32, and of (20, 25, 0) / 32 and (0, 0, 1) 29 and 13 32nds.
        _, first, _ = self.exact_jacobians(3, Options(3, 2.0, 0.5))
        self.assertEqual([[1024 * x for x in row] for row in first],
                         [[800, -640, 0], [580, 725, -416], [260, 325, 928]])

    def test_with_periods_nothing_rotates_and_the_lacunarity_is_whole(self) -> None:
        for n in (2, 3):
            found = self.exact_jacobians(n, Options(3, 2.9, 0.25), (5, 0, 0)[:n])
            self.assertEqual(found, [[[Fraction(i == j, 2**k) for j in range(n)] for i in range(n)] for k in range(3)])

    def test_a_jacobian_is_how_the_positions_of_an_octave_move(self) -> None:
        for p, _, periods in cases("steps", 2):
            options, step = Options(4, 2.75, 0.5), [Fraction(1, 3), Fraction(-2, 7), Fraction(5)][:len(p)]
            moved = [x + dx for x, dx in zip(p, step)]
            for i, ((a, *_), (b, *_), jacobian) in enumerate(zip(
                    sums.octaves_of(p, options, 0, periods), sums.octaves_of(moved, options, 0, periods),
                    self.exact_jacobians(len(p), options, periods, 4))):
                self.assertEqual([(y - x) * Fraction(1, 2**i) for x, y in zip(a, b)], jacobians.times(jacobian, step))

    def fixed_jacobians(self, n: int, options: Options, periods: Sequence[int] = (),
                     count: int = 3) -> list[Plane | Space]:
        return list(itertools.islice(jacobians.fixed_jacobians_of(n, options, periods), count))

    def test_fixed_by_hand(self) -> None:
        _, first, second = self.fixed_jacobians(2, Options(3, 3.0, 0.5))
        c, s = 25 * 3 * ONE // 64, 20 * 3 * ONE // 64
        self.assertEqual(first, Plane(c, s))
        c, s = c * 3 // 2, s * 3 // 2
        self.assertEqual(second, Plane((25 * c - 20 * s) // 32, (20 * c + 25 * s) // 32))
        _, first, _ = self.fixed_jacobians(3, Options(3, 2.0, 0.5))
        self.assertEqual(first.rows, ((ONE // 32 * 25, -ONE // 32 * 20, 0),
                                      (580 * ONE // 1024, 725 * ONE // 1024, -416 * ONE // 1024),
                                      (260 * ONE // 1024, 325 * ONE // 1024, 928 * ONE // 1024)))
        for n, unit in ((2, Plane(ONE // 2)), (3, Space(tuple(tuple(ONE // 2 * (i == j) for j in range(3))
                                                               for i in range(3))))):
            self.assertEqual(self.fixed_jacobians(n, Options(3, 2.9, 0.25), (5, 5, 5)[:n])[1], unit)

    def test_fixed_numbers_are_rounded_down(self) -> None:
        # The gain is cut to 2^-18 and the product of it with the lacunarity, too: 183500 * 1.9 is 348649.99...
        m = 183500 * math.trunc(Fraction(1.9) * 2**23) // 2**23
        self.assertEqual(m, 348649)
        self.assertEqual(self.fixed_jacobians(2, Options(3, 1.9, 0.7), (), 2)[1], Plane(25 * m // 32, 20 * m // 32))
        # With a Jacobian that is negative: -3 halves are -1.5, and this is -2 before the rotation.
        self.assertEqual(Plane(-3, 3).scaled(ONE // 2), Plane(-2, 1))
        self.assertEqual(Plane(-2, 1).rotated(), Plane(-70 // 32, -15 // 32))
        self.assertEqual(Space(((1, 0, 0), (0, 1, 0), (0, 0, 1))).rotated().rows, ((0, -1, 0), (0, 0, -1), (0, 0, 0)))

    def test_products_with_a_jacobian(self) -> None:
        self.assertEqual(Plane(2 * ONE, ONE).times((3, 5)), [1, 13])
        self.assertEqual(Plane(2 * ONE, ONE).transposed_times((3, 5)), [11, 7])
        rows = [[Fraction(x) for x in row] for row in ((1, 2, 3), (4, 5, 6), (7, 8, 10))]
        of_fixed = Space(tuple(tuple(int(x) * ONE for x in row) for row in rows))
        v, products = (1, -2, 3), ([6, 12, 21], [14, 16, 21])
        self.assertEqual((of_fixed.times(v), of_fixed.transposed_times(v)), products)
        self.assertEqual((jacobians.times(rows, v), jacobians.times(jacobians.transposed(rows), v)), products)
        # Each product is rounded down, then they are summed or subtracted.
        self.assertEqual(Plane(ONE // 2, ONE // 2).times((-1, 1)), [-1, -1])
        self.assertEqual(Plane(ONE // 2, ONE // 2).transposed_times((-1, 1)), [-1, 1])

    def test_overflow_wraps(self) -> None:
        self.assertEqual(jacobians.prod(2**30, 2**20), 0)
        self.assertEqual(jacobians.prod(2**31 - 1, 3 * 2**17), ((2**31 - 1) * 3 >> 1) - 2**32)
        self.assertEqual(jacobians.prod(-2**25, 2**25), 0)
        self.assertEqual(jacobians.prod(-2**24, 2**25), -2**31)
        self.assertEqual(jacobians.thirty_second(2**31), -2**26)
        # 255 times as large in each octave: 255^4 is beyond 2^31 units.
        options = Options(6, 255.0, 1.0)
        *_, last = self.fixed_jacobians(2, options, (1, 1), 6)
        self.assertEqual(last, Plane(sums.wrapped(255**5 * ONE)))
        for n in (2, 3):
            with mock.patch.object(jacobians, "wrapped", signed), self.assertRaises(OverflowError):
                self.fixed_jacobians(n, options, (), 6)


class LargestNumbers(unittest.TestCase):
    """Of any noise, at the ends of the domain that the contract gives Jacobians: nothing wraps."""

    # Octaves, lacunarities, gains and amplitudes: the Jacobians sum to 64 at most, and with the amplitude are 256 at
    # most.
    ENDS = ((2, 63.0, 1.0, 4.0), (2, 255.0, 63 / 255, 4.0), (6, 2.0, 1.0, 8.0), (3, 2.0, 1.0, 64.0),
            (5, 2.0, 1.0, 16.0), (32, 1.04, 1.0, 64.0), (32, 1.0, 1.0, 64.0), (3, 7.4, 1.0, 4.0))

    def largest(self, n: int, options: Options, periods: Sequence[int], rise: float = 4000) -> None:
        """The largest slope along each axis: octaves that all point the way in which their Jacobians do. The lengths of
        their
        gradients are the rise, divided by the sum of the Jacobians."""
        count, ends = sums.count_of(options), list(itertools.product((-1, 1), repeat=n))
        found = list(itertools.islice(jacobians.fixed_jacobians_of(n, options, periods), count))
        place = [(0, 0)] * n
        growth = sum((options.gain * options.lacunarity)**i for i in range(count))
        slope = int(min(rise / growth / math.sqrt(n), 128) * 2**19)
        for axis in range(n):
            slopes = [max(([x * slope for x in end] for end in ends), key=lambda g: jacobian.transposed_times(g)[axis])
                      for jacobian in found]
            with mock.patch.object(jacobians, "fixed_slopes_of", return_value=([2**21] * count, slopes)):
                jacobians.fixed_fbm_d(SLOPES, LATTICE, place, options, 0, periods)
                jacobians.fixed_eroded(SLOPES, LATTICE, place, options, 0, periods)
            vectors = [max(([x * 2**21 for x in end] for end in ends), key=lambda v: jacobian.times(v)[axis])
                       for jacobian in found]
            with mock.patch.object(jacobians, "fixed_vector", side_effect=vectors):
                jacobians.fixed_warp_progressive(VECTOR, LATTICE, place, options, 0, periods)

    def test_in_the_domain_nothing_wraps(self) -> None:
        with mock.patch.object(jacobians, "wrapped", signed):
            for n, (octaves, lacunarity, gain, amplitude) in itertools.product((2, 3), self.ENDS):
                growth = [(gain * lacunarity)**i for i in range(octaves)]
                self.assertTrue(sum(growth) <= 64 and max(growth) * amplitude <= 256)
                for strength, periods in itertools.product((0.0, 16.0), ((), (5,) * n)):
                    self.largest(n, Options(octaves, lacunarity, gain, strength, amplitude=amplitude), periods)

    def test_far_beyond_it_something_does(self) -> None:
        with mock.patch.object(jacobians, "wrapped", signed):
            beyond = (Options(3, 200.0, 1.0), Options(2, 255.0, 1.0, amplitude=64.0))
            for n, options in itertools.product((2, 3), beyond):
                with self.assertRaises(OverflowError):
                    self.largest(n, options, ())


class Derivatives(unittest.TestCase):
    def test_value_is_that_of_fbm(self) -> None:
        for p, seed, periods in cases("values", 3):
            for options in (Options(5, 2.0, 0.5), Options(3, 1.75, 1.5), Options(40, 1.0, 0.75), Options(0, 2.0, 0.5)):
                if options.octaves < 6:
                    found = sums.exact("fbm", PERLIN, LATTICE, p, options, seed, periods)
                    self.assertEqual(exact("fbm_d", p, options, seed, periods)[0], found)
                found = sums.fixed("fbm", PERLIN, LATTICE, sums.fixed_at_position(p), options, seed, periods)
                self.assertEqual(fixed("fbm_d", p, options, seed, periods)[0], found)

    def test_they_are_difference_quotients(self) -> None:
        step = Fraction(1, 2**50)
        for p, seed, periods in cases("quotients", 2):
            for options in (Options(1, 2.0, 0.5), Options(3, 2.0, 0.5), Options(3, 1.75, 1.5), Options(3, -1.5, 0.25)):
                _, *found = exact("fbm_d", p, options, seed, periods)
                for axis, slope in enumerate(found):
                    ends = [[x + sign * step * (i == axis) for i, x in enumerate(p)] for sign in (-1, 1)]
                    a, b = (sums.exact("fbm", PERLIN, LATTICE, end, options, seed, periods) for end in ends)
                    self.assertLess(abs((b - a) / (2 * step) - slope), 2**-80)

    def test_one_octave_is_the_noise(self) -> None:
        for p, seed, periods in cases("one octave"):
            for options in (Options(1, 2.0, 0.5), Options(6, 2.0, 0.0)):
                self.assertEqual(exact("fbm_d", p, options, seed, periods), SLOPES.exact(LATTICE, p, seed, periods))
            self.assertEqual(fixed("fbm_d", p, Options(1, 2.0, 0.5), seed, periods),
                             SLOPES.fixed(LATTICE, p, seed, periods))

    def test_two_octaves_by_hand(self) -> None:
        # Slopes of (1/4, 1/2) and then of (-1, 1/8), each with a gain times a lacunarity of 3/2: rotated back they are
        # (-25 + 20/8, 25/8 + 20) / 32 times 3/2, and the weights are 3/2.
        octaves = {0: (0, 2**17, 2**18), SEED_STEP: (0, -2**19, 2**16)}
        noise = Noise("by hand", lambda lattice, *_: tuple(Fraction(x, 2**19) for x in octaves[lattice.seed]),
                      lambda lattice, *_: octaves[lattice.seed])
        found = jacobians.exact("fbm_d", noise, LATTICE, in_cell((0, 0), (0, 0)), Options(2, 3.0, 0.5))
        expected = [(Fraction(a) + Fraction(3, 2) * b / 32) / Fraction(3, 2)
                    for a, b in ((0.25, Fraction(-45, 2)), (0.5, Fraction(185, 8)))]
        self.assertEqual(found, (0, *expected))
        found = jacobians.fixed("fbm_d", noise, LATTICE, [(0, 0), (0, 0)], Options(2, 3.0, 0.5))
        self.assertEqual(found, tuple(Fraction(math.trunc(x * 2**19), 2**19) for x in (0, *expected)))
        found = jacobians.fixed("fbm_d", noise, LATTICE, [(0, 0), (0, 0)], Options(2, 3.0, 0.5), periods=(5, 5))
        self.assertEqual(found, tuple(Fraction(math.trunc(x * 2**19), 2**19) for x in
                                      (0, (Fraction(1, 4) - Fraction(3, 2)) / Fraction(3, 2),
                                       (Fraction(1, 2) + Fraction(3, 16)) / Fraction(3, 2))))

    def test_slopes_of_a_noise_are_cut_off(self) -> None:
        for slope, counts in ((130, 128), (-130, -128), (128, 128), (-9, -9)):
            noise = Noise("steep", None, lambda *_: (0, slope * 2**19, 0))
            found = jacobians.fixed("fbm_d", noise, LATTICE, [(0, 0)] * 2, Options(1, 2.0, 0.5))
            self.assertEqual(found, (0, counts, 0))

    def test_what_a_float_holds(self) -> None:
        for v, held in ((2**24 - 1, 2**24 - 1), (2**24, 2**24), (2**24 + 127, 2**24), (-2**24 - 127, -2**24),
                        (2**27 + 300, 2**27 + 256), (-2**27 - 300, -2**27 - 256), (1 - 2**24, 1 - 2**24)):
            self.assertEqual(jacobians.coarse(v), held)


class Eroded(unittest.TestCase):
    def test_no_strength_is_fbm(self) -> None:
        for p, seed, periods in cases("no strength", 3):
            for strength in (0, -1.0):
                options = Options(4, 2.0, 0.5, strength)
                self.assertEqual(exact("eroded", p, options, seed, periods)[0],
                                 sums.exact("fbm", PERLIN, LATTICE, p, options, seed, periods))
                self.assertEqual(fixed("eroded", p, options, seed, periods)[0],
                                 sums.fixed("fbm", PERLIN, LATTICE, sums.fixed_at_position(p), options, seed, periods))

    def test_strengths_beyond_the_ends(self) -> None:
        p = (0.375, -12.25)
        for function in (exact, fixed):
            found = [function("eroded", p, Options(4, 2.0, 0.5, strength)) for strength in (16.0, 16.5, 3e38)]
            self.assertEqual(found, found[:1] * 3)
            self.assertNotEqual(function("eroded", p, Options(4, 2.0, 0.5, 15.0)), found[0])

    def eroded(self, n: int, slopes: Sequence[Sequence[Real]], strength: Real, periods: Sequence[int] = ()) -> tuple:
        """Of octaves that are all 1, and have these slopes."""
        seeds = [i * SEED_STEP & MASK for i in range(len(slopes))]
        of_seed = dict(zip(seeds, slopes, strict=True))
        noise = Noise("by hand", lambda lattice, *_: (Fraction(1), *map(Fraction, of_seed[lattice.seed])),
                      lambda lattice, *_: (2**21, *(int(x * 2**19) for x in of_seed[lattice.seed])))
        options, place = Options(len(slopes), 2.0, 1.0, strength), [Fraction(0)] * n
        return (jacobians.exact("eroded", noise, LATTICE, place, options, 0, periods)[0],
                jacobians.fixed("eroded", noise, LATTICE, [(0, 0)] * n, options, 0, periods)[0])

    def test_by_hand(self) -> None:
        # (1, 2): 5. The rotation of it is (-15, 70) / 32, and with (0.5, -2) this is (1, 6) / 32.
        exactly, whole = self.eroded(2, ((1, 2), (0.5, -2)), 0.5)
        self.assertEqual(exactly, (1 / Fraction(7, 2) + 1 / (1 + Fraction(37, 2048))) / 2)
        self.assertLess(abs(exactly - whole), 2**-16)
        exactly, whole = self.eroded(2, ((1, 2), (0.5, -2)), 0.5, (3, 0))
        self.assertEqual(exactly, (1 / Fraction(7, 2) + 1 / (1 + Fraction(9, 8))) / 2)
        self.assertLess(abs(exactly - whole), 2**-16)
        # In space (1, 2, 1) becomes (-15 / 32, (29 * 70 / 32 - 13) / 32, (13 * 70 / 32 + 29) / 32).
        e = [Fraction(-15, 32) + 1, (Fraction(29 * 70, 32) - 13) / 32, (Fraction(13 * 70, 32) + 29) / 32 - 1]
        exactly, whole = self.eroded(3, ((1, 2, 1), (1, 0, -1)), 2)
        self.assertEqual(exactly, (Fraction(1, 13) + 1 / (1 + 2 * sum(x * x for x in e))) / 2)
        self.assertLess(abs(exactly - whole), 2**-16)

    def test_slopes_that_sum_to_much(self) -> None:
        # With periods nothing rotates: 3, 6, 9, 5. Only 8 of the 9 count, also later.
        slopes = ((3, 0), (3, 0), (3, 0), (-4, 0))
        exactly, whole = self.eroded(2, slopes, 1, (5, 5))
        self.assertEqual(exactly, (Fraction(1, 10) + Fraction(1, 37) + Fraction(1, 65) + Fraction(1, 17)) / 4)
        self.assertLess(abs(exactly - whole), 2**-16)
        self.assertEqual(self.eroded(2, [(-x, y) for x, y in slopes], 1, (5, 5)), (exactly, whole))

    def test_shares_by_hand(self) -> None:
        # Slopes in units of 2^-19: one of e is 128 of them, and -1 is -1 of e.
        for g, e in ((-1, -1), (127, 0), (128, 1), (2**21, 2**14)):
            steep = e * e * ONE * 16 >> 26
            self.assertEqual(jacobians.fixed_shares([ONE], [(g, 0)], 16.0, True), [2**34 // (2**16 + steep)])
        # All at the ends, with the largest strength: 1 + 16 * 3 * 64 is 3073, and 2^18 / 3073 is 85.3.
        self.assertEqual(jacobians.fixed_shares([0, 0, 0, ONE], [(2**21,) * 3] * 4, 16.0, False)[3], 85)
        # The rotation of (1000, 3001) is (-35020, 95025) / 32, which is rounded down, and that of (2969, 500) in space
        # is (79601, 53097) / 32.
        for slopes, e in (([(128000, 384128), (0, 0)], (-1095, 2969)),
                          ([(128000, 384128, 64000), (0, 0, 128)], (-1095, 2487, 1660))):
            steep = sum(x * x for x in e) * 16 * ONE >> 26
            self.assertEqual(jacobians.fixed_shares([0, ONE], slopes, 16.0, True), [0, 2**34 // (2**16 + steep)])


class Warps(unittest.TestCase):
    def test_one_octave_by_hand(self) -> None:
        for p, seed, periods in cases("one octave"):
            values = VECTOR.exact(LATTICE, p, seed, periods)
            self.assertEqual(values[:1], noises.find("value").exact(LATTICE, p, seed, periods))
            for name in ("warp", "warp_progressive"):
                self.assertEqual(exact(name, p, Options(1, 2.0, 0.5, amplitude=2.5), seed, periods),
                                 tuple(Fraction(5, 2) * v for v in values))
                self.assertEqual(fixed(name, p, Options(1, 2.0, 0.5, amplitude=2.0), seed, periods),
                                 tuple(2 * v for v in VECTOR.fixed(LATTICE, p, seed, periods)))

    def test_two_octaves_by_hand(self) -> None:
        # 1.5 times as far at half the weight: a weight of 2/3 and of 1/3, a Jacobian of 3/4 of the rotation for what
        # follows.
        for p, seed, periods in cases("two octaves", 2):
            options = Options(2, 1.5, 0.5, amplitude=1.25)
            q = list(p)
            first = vector_at(q, seed, periods)
            factor, moved = (1 if periods else Fraction(3, 2)), [x + Fraction(5, 6) * v for x, v in zip(q, first)]
            for name, at in (("warp", q), ("warp_progressive", moved)):
                following = [factor * x for x in at]
                if not periods:
                    x, y, *z = following
                    following = [(25 * x - 20 * y) / 32, (20 * x + 25 * y) / 32]
                    if z:
                        y = following.pop()
                        following += [(29 * y - 13 * z[0]) / 32, (13 * y + 29 * z[0]) / 32]
                following = [x + Fraction(shift, 32) for x, shift in zip(following, (11, 19, 23))]
                second = vector_at(following, seed + 0x9E3779B9 & MASK, periods)
                for a, b, found in zip(first, second, exact(name, p, options, seed, periods)):
                    self.assertLess(abs(Fraction(5, 4) * (2 * a + b) / 3 - found), 2**-200)

    def test_each_octave_moves_all_that_follow(self) -> None:
        """The position of the last octave is that of the position moved by what the sums before it have come to."""
        for p, seed, periods in cases("moves", 2):
            options = Options(3, 2.0, 0.5, amplitude=0.75)
            octaves = [octave for octave, _ in jacobians.progressive_octaves(VECTOR, LATTICE, p, options, seed, periods)]
            vectors = [v for _, v in jacobians.progressive_octaves(VECTOR, LATTICE, p, options, seed, periods)]
            jacobian = list(itertools.islice(jacobians.jacobians_of(len(p), options, periods), 2))
            # In cells of the first octave, the second moves by as much as its Jacobian and its gain give: the rotation
            # back of what it moves, over the lacunarity.
            *_, (plain, *_) = sums.octaves_of(p, options, seed, periods)
            moves = [Fraction(3, 4) / Fraction(7, 4) * x for x in vectors[0]]
            *_, (moved, *_) = sums.octaves_of([a + b for a, b in zip(p, moves)], options, seed, periods)
            then = [Fraction(3, 7) * 2 * x for x in jacobians.times(jacobian[1], vectors[1])]
            if not periods:
                then = sums.rotate(then, sums.thirty_second)
            for a, b, c in zip(moved, then, octaves[2][0]):
                self.assertLess(abs(a + b - c), 2**-200)
            self.assertNotEqual(plain, octaves[2][0])

    def test_amplitudes(self) -> None:
        p = (0.375, -12.25)
        for name, function in itertools.product(("warp", "warp_progressive"), (exact, fixed)):
            found = [function(name, p, Options(3, 1.5, 0.5, amplitude=x)) for x in (64.0, 64.5, 3e38)]
            self.assertEqual(found, found[:1] * 3)
            for none in (0.0, -1.0):
                self.assertEqual(function(name, p, Options(3, 1.5, 0.5, amplitude=none)), (0, 0))

    def test_rounded_positions_do_not_count(self) -> None:
        """The doubles of progressive warps are the same with positions that are 64 bits finer."""
        numbers = generator_of("finer")
        for n in (2, 3):
            for octaves, lacunarity, gain, amplitude in ((4, 2.0, 0.5, 2.0), (2, 255.0, 0.125, 64.0),
                                                         (6, 1.9, 0.7, 0.5)):
                options = Options(octaves, lacunarity, gain, amplitude=amplitude)
                arguments = somewhere(n, numbers), options, numbers.word()
                found = [float(x) for x in exact("warp_progressive", *arguments)]
                with mock.patch.object(jacobians, "FINEST", jacobians.FINEST * 2**64):
                    self.assertEqual([float(x) for x in exact("warp_progressive", *arguments)], found)
                with mock.patch.object(jacobians, "FINEST", 2**16):
                    self.assertNotEqual([float(x) for x in exact("warp_progressive", *arguments)], found)

    def test_a_larger_noise(self) -> None:
        noise = Noise("large", lambda *_: (Fraction(-3, 2),) * 2, lambda *_: (-3 * 2**20,) * 2)
        for name in ("warp", "warp_progressive"):
            options = Options(2, 2.0, 0.5, amplitude=3.0)
            self.assertEqual(jacobians.exact(name, noise, LATTICE, in_cell((0, 0), (0, 0)), options), (-3, -3))
            self.assertEqual(jacobians.fixed(name, noise, LATTICE, [(0, 0)] * 2, options), (-3, -3))

    def test_what_moves_by_hand(self) -> None:
        # 2^-18 of a number in units of 2^-21, in units of 2^-24; down, and beyond the last cell.
        self.assertEqual(jacobians.fixed_moved([(3, 5), (-1, 0)], (2**21, -1), ONE), [(4, 5), (-2, 2**24 - 8)])
        self.assertEqual(jacobians.fixed_moved([(2**31 - 1, 2**24), (-2**31, 3)], (0, -1), ONE // 2),
                         [(-2**31, 0), (2**31 - 1, 2**24 - 5)])
        # A move of 33 bits: 2^21 of 250 cells.
        self.assertEqual(jacobians.fixed_moved([(0, 0)], (2**21 * 250,), ONE), [(250, 0)])

    def test_fixed_components_by_hand(self) -> None:
        # The mean of a single octave is that octave, and prod rounds down.
        for v, amplitude, component in ((700001, 1.0, 700001), (-700001, 0.5, -350001), (700001, 0.5, 350000),
                                        (2**21, 64.0, 2**27), (1 - 2**21, 63.75, -1044479 * 128)):
            noise = Noise("alike", None, lambda *_: (v, v))
            found = jacobians.fixed("warp", noise, LATTICE, [(0, 0)] * 2, Options(1, 2.0, 0.5, amplitude=amplitude))
            self.assertEqual(found, (Fraction(component, NOISE_UNIT),) * 2, (v, amplitude))


class All(unittest.TestCase):
    def test_without_octaves_they_are_0(self) -> None:
        for name, n, function in itertools.product(jacobians.SUMS, (2, 3), (exact, fixed)):
            found = function(name, (0.375,) * n, Options(0, 2.0, 0.5, 1.0, amplitude=1.0))
            self.assertEqual(found, (0,) * {"fbm_d": 1 + n, "eroded": 1}.get(name, n))

    def test_fixed_is_near(self) -> None:
        for name, tried, error in (
                ("fbm_d", ((1, 2.0, 0.5), (5, 2.0, 0.5), (4, 1.75, 0.75), (3, 3.0, 1.0)), 2**-12),
                ("eroded", ((1, 2.0, 0.5, 16.0), (5, 2.0, 0.5, 1.0), (4, 2.0, 0.75, 4.0), (3, 2.0, 1.0, 0.125)),
                 2**-12),
                ("warp", ((1, 2.0, 0.5), (4, 2.0, 0.5), (3, 2.0, 0.75), (2, 2.0, 1.0)), 2**-15),
                ("warp_progressive", ((1, 2.0, 0.5), (4, 2.0, 0.5), (3, 2.0, 0.75), (2, 2.0, 1.0)), 2**-10)):
            for (p, seed, periods), of in itertools.product(cases("near"), tried):
                arguments = p, Options(*of, amplitude=min(of[0], 2) / 2), seed, periods
                for a, b in zip(exact(name, *arguments), fixed(name, *arguments), strict=True):
                    self.assertLess(abs(a - b), error, (name, of))

    def test_they_repeat_after_a_period(self) -> None:
        for name, function, n in itertools.product(jacobians.SUMS, (exact, fixed), (2, 3)):
            p, options = (0.375, -12.25, 5.125)[:n], Options(3, 2.5, 0.5, 1.0, amplitude=1.0)
            one, other, far = (function(name, [x + moved for x in p], options, 5, periods)
                               for moved, periods in ((0, (48,) * n), (48, (48,) * n), (48, ())))
            self.assertEqual(one, other)
            self.assertNotEqual(one, far)

    def test_seeds_differ(self) -> None:
        for name, function in itertools.product(jacobians.SUMS, (exact, fixed)):
            self.assertEqual(len({function(name, (0.375, 0.5), Options(2, 2.0, 0.5, 1.0, amplitude=1.0), seed)
                                  for seed in range(16)}), 16)
