"""Tests of jacobians.py, by hand."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from proof.golden.generator import Generator, generator_of
from proof.oracle import jacobians, noises, sums
from proof.oracle.gradients import Knobs, Real
from proof.oracle.hashes import MASK, SEED_STEP
from proof.oracle.integers import NOISE_UNIT
from proof.oracle.jacobians import Plane, Space
from proof.oracle.noises import Noise
from proof.oracle.sums import Options, in_cell

LATTICE = Knobs("lattice")
ONE = 2**18
PERLIN, VECTOR = map(noises.find, ("perlin", "value_vector"))


def exact(name: str, p: Sequence[Real], options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    noise = noises.find(jacobians.SUMS[name].noise)
    return jacobians.exact(name, noise, LATTICE, sums.at_position(p), options, seed, periods)


def fixed(name: str, p: Sequence[Real], options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    noise = noises.find(jacobians.SUMS[name].noise)
    return jacobians.fixed(name, noise, LATTICE, sums.fixed_at_position(p), options, seed, periods)


def somewhere(n: int, numbers: Generator) -> list[Fraction]:
    """A position that fixed arithmetic does not cut."""
    return [Fraction(numbers.integer(-2**23, 2**23), 2**20) for _ in range(n)]


def cases(name: str, count: int = 6) -> Iterator[tuple[list[Fraction], int, Sequence[int]]]:
    """Positions of both dimensions, seeds, and none or some periods."""
    numbers = generator_of(name)
    for n, periodic, _ in itertools.product((2, 3), (False, True), range(count)):
        yield somewhere(n, numbers), numbers.word(), (48, 5, 0)[:n] if periodic else ()


def first(of: Callable, n: int, options: Options, periods: Sequence[int] = (), count: int = 2) -> list:
    return list(itertools.islice(of(n, options, periods), count))


class Jacobians(unittest.TestCase):
    """A Jacobian that is none of the octave, is transposed, or is rounded or wraps in another place."""

    def test_by_hand(self) -> None:
        # 0.5 * 3 times the rotation, which is 25/32 and 20/32.
        c, s = Fraction(75, 64), Fraction(60, 64)
        self.assertEqual(first(jacobians.jacobians_of, 2, Options(3, 3.0, 0.5), (), 3),
                         [[[1, 0], [0, 1]], [[c, -s], [s, c]],
                          [[c * c - s * s, -2 * c * s], [2 * c * s, c * c - s * s]]])
        _, one, two = first(jacobians.fixed_jacobians_of, 2, Options(3, 3.0, 0.5), (), 3)
        self.assertEqual((one, two), (Plane(int(c * ONE), int(s * ONE)),
                                      Plane(int((c * c - s * s) * ONE), int(2 * c * s * ONE))))
        # In space the rows rotate: (25, -20, 0) / 32, and of (20, 25, 0) / 32 and (0, 0, 1) 29 and 13 32nds.
        rows = ((800, -640, 0), (580, 725, -416), (260, 325, 928))
        _, one = first(jacobians.jacobians_of, 3, Options(3, 2.0, 0.5))
        self.assertEqual([[1024 * x for x in row] for row in one], list(map(list, rows)))
        _, one = first(jacobians.fixed_jacobians_of, 3, Options(3, 2.0, 0.5))
        self.assertEqual(one.rows, tuple(tuple(x * ONE // 1024 for x in row) for row in rows))
        # With periods nothing rotates, and the lacunarity is whole.
        for n in (2, 3):
            unit = [[Fraction(i == j, 2) for j in range(n)] for i in range(n)]
            fixed_unit = Plane(ONE // 2) if n == 2 else Space(tuple(tuple(int(x * ONE) for x in row) for row in unit))
            for of, expected in ((jacobians.jacobians_of, unit), (jacobians.fixed_jacobians_of, fixed_unit)):
                self.assertEqual(first(of, n, Options(3, 2.9, 0.25), (5, 0, 0)[:n])[1], expected)

    def test_fixed_numbers_are_rounded_down(self) -> None:
        # The gain is cut to 2^-18 and the product of it with the lacunarity, too: 183500 * 1.9 is 348649.99...
        m = 183500 * math.trunc(Fraction(1.9) * 2**23) // 2**23
        self.assertEqual(m, 348649)
        self.assertEqual(first(jacobians.fixed_jacobians_of, 2, Options(3, 1.9, 0.7)),
                         [Plane(), Plane(25 * m // 32, 20 * m // 32)])
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
        for a, b, expected in ((2**30, 2**20, 0), (2**31 - 1, 3 * 2**17, ((2**31 - 1) * 3 >> 1) - 2**32),
                               (-2**24, 2**25, -2**31)):
            self.assertEqual(jacobians.prod(a, b), expected)
        self.assertEqual(jacobians.thirty_second(2**31), -2**26)
        # 255 times as large in each octave: 255^4 is beyond 2^31 units.
        options = Options(6, 255.0, 1.0)
        *_, last = first(jacobians.fixed_jacobians_of, 2, options, (1, 1), 6)
        self.assertEqual(last, Plane(sums.wrapped(255**5 * ONE)))


class Flows(unittest.TestCase):
    """A velocity that is rotated the wrong way or cut, so that a flow has sources, or another phase."""

    def test_back_is_the_inverse_of_the_rotation(self) -> None:
        for v, determinant in (([3, 5], Fraction(1025, 1024)), ([3, 5, -7], Fraction(1025, 1024) * Fraction(1010, 1024))):
            turned = sums.rotate(list(map(Fraction, v)), sums.thirty_second)
            self.assertEqual(jacobians.back(turned), [determinant * x for x in v])

    def test_octaves_by_hand(self) -> None:
        p, options = [Fraction(1, 3), Fraction(5, 7), Fraction(2, 9)], Options(2, 2.0, 0.5, phase=Fraction(1, 8))
        curl = noises.find("curl_phase").rotated(Fraction(1, 8))
        q = [x + s for x, s in zip(sums.rotate([2 * x for x in p], sums.thirty_second), sums.SHIFT)]
        one, two = curl.exact(LATTICE, p, 7), jacobians.back(curl.exact(LATTICE, q, 7 + SEED_STEP & MASK))
        self.assertEqual(exact("curl_fbm", p, options, 7), tuple((a + b / 2) / Fraction(3, 2) for a, b in zip(one, two)))
        for of in (exact, fixed):
            self.assertEqual(of("curl_fbm", p, Options(0, 2.0, 0.5), 7), (0, 0, 0))


class Derivatives(unittest.TestCase):
    """A slope of a sum that is cut in another way, or rotated back in another."""

    def test_two_octaves_by_hand(self) -> None:
        # Slopes of (1/4, 1/2) and then of (-1, 1/8), each with a gain times a lacunarity of 3/2: rotated back they are
        # (-25 + 20/8, 25/8 + 20) / 32 times 3/2, and the weights are 3/2.
        octaves = {0: (0, 2**17, 2**18), SEED_STEP: (0, -2**19, 2**16)}
        noise = Noise("by hand", lambda lattice, *_: tuple(Fraction(x, 2**19) for x in octaves[lattice.seed]),
                      lambda lattice, *_: octaves[lattice.seed])
        for periods, others in (((), (Fraction(-45, 64), Fraction(185, 256))), ((5, 5), (-1, Fraction(1, 8)))):
            expected = (0, *((Fraction(a) + Fraction(3, 2) * b) / Fraction(3, 2) for a, b in zip((0.25, 0.5), others)))
            found = jacobians.exact("fbm_d", noise, LATTICE, in_cell((0, 0), (0, 0)), Options(2, 3.0, 0.5), 0, periods)
            self.assertEqual(found, expected)
            found = jacobians.fixed("fbm_d", noise, LATTICE, [(0, 0), (0, 0)], Options(2, 3.0, 0.5), 0, periods)
            self.assertEqual(found, tuple(Fraction(math.trunc(x * 2**19), 2**19) for x in expected))

    def test_slopes_of_a_noise_are_cut_off(self) -> None:
        for slope, counts in ((130, 128), (-130, -128), (-9, -9)):
            noise = Noise("steep", None, lambda *_: (0, slope * 2**19, 0))
            found = jacobians.fixed("fbm_d", noise, LATTICE, [(0, 0)] * 2, Options(1, 2.0, 0.5))
            self.assertEqual(found, (0, counts, 0))

    def test_what_a_float_holds(self) -> None:
        for v, held in ((2**24 - 1, 2**24 - 1), (2**24, 2**24), (2**24 + 127, 2**24), (-2**24 - 127, -2**24),
                        (2**27 + 300, 2**27 + 256), (-2**27 - 300, -2**27 - 256), (1 - 2**24, 1 - 2**24)):
            self.assertEqual(jacobians.coarse(v), held)


class Eroded(unittest.TestCase):
    """A slope that does not rotate, a sum of slopes or a strength that is cut in another place."""

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
        # (1, 2): 5. The rotation of it is (-15, 70) / 32, and with (0.5, -2) this is (1, 6) / 32. In space (1, 2, 1)
        # becomes (-15 / 32, (29 * 70 / 32 - 13) / 32, (13 * 70 / 32 + 29) / 32). With periods nothing rotates: of sums
        # of 3, 6, 9 and 5 only 8 of the 9 count, also later.
        e = [Fraction(-15, 32) + 1, (Fraction(29 * 70, 32) - 13) / 32, (Fraction(13 * 70, 32) + 29) / 32 - 1]
        for slopes, strength, periods, squares in (
                (((1, 2), (0.5, -2)), 0.5, (), (5, Fraction(37, 1024))),
                (((1, 2), (0.5, -2)), 0.5, (3, 0), (5, Fraction(9, 4))),
                (((1, 2, 1), (1, 0, -1)), 2, (), (6, sum(x * x for x in e))),
                (((3, 0), (3, 0), (3, 0), (-4, 0)), 1, (5, 5), (9, 36, 64, 16)),
                (((-3, 0), (-3, 0), (-3, 0), (4, 0)), 1, (5, 5), (9, 36, 64, 16)),
                (((1, 2),), 16.5, (), (5 * Fraction(16) / Fraction(16.5),)), (((1, 2),), -1, (), (0,))):
            exactly, whole = self.eroded(len(slopes[0]), slopes, strength, periods)
            self.assertEqual(exactly, sum(1 / (1 + Fraction(strength) * square) for square in squares) / len(squares))
            self.assertLess(abs(exactly - whole), 2**-16)

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
    """An octave that is moved to another place, or a shift of another amplitude."""

    def test_one_octave_by_hand(self) -> None:
        for p, seed, periods in cases("one octave", 2):
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
            start = VECTOR.exact(LATTICE, q, seed, periods)
            factor, moved = (1 if periods else Fraction(3, 2)), [x + Fraction(5, 6) * v for x, v in zip(q, start)]
            for name, at in (("warp", q), ("warp_progressive", moved)):
                following = [factor * x for x in at]
                if not periods:
                    x, y, *z = following
                    following = [(25 * x - 20 * y) / 32, (20 * x + 25 * y) / 32]
                    if z:
                        y = following.pop()
                        following += [(29 * y - 13 * z[0]) / 32, (13 * y + 29 * z[0]) / 32]
                following = [x + Fraction(shift, 32) for x, shift in zip(following, (11, 19, 23))]
                second = VECTOR.exact(LATTICE, following, seed + 0x9E3779B9 & MASK, periods)
                for a, b, found in zip(start, second, exact(name, p, options, seed, periods)):
                    self.assertLess(abs(Fraction(5, 4) * (2 * a + b) / 3 - found), 2**-200)

    def test_amplitudes(self) -> None:
        for name, function in itertools.product(("warp", "warp_progressive"), (exact, fixed)):
            for beyond, end in ((64.5, 64.0), (-1.0, 0.0)):
                self.assertEqual(*(function(name, (0.375, -12.25), Options(3, 1.5, 0.5, amplitude=x))
                                   for x in (beyond, end)))

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

    def test_without_octaves_they_are_0(self) -> None:
        for name, n, function in itertools.product(jacobians.SUMS, (2, 3), (exact, fixed)):
            found = function(name, (0.375,) * n, Options(0, 2.0, 0.5, 1.0, amplitude=1.0))
            self.assertEqual(found, (0,) * {"fbm_d": 1 + n, "eroded": 1}.get(name, n))
