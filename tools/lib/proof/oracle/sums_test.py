"""Tests of sums.py: octave sums of hn_perlin, by hand, and what the contract promises of them."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Sequence
from fractions import Fraction

from proof.oracle import noises, sums
from proof.oracle.gradients import Knobs, Real
from proof.oracle.sums import Options, Terms

Z = Fraction(1847, 256)  # of a position that has been rotated in space
PERLIN = noises.find("perlin")


def fixed(name: str, knobs: Knobs, p: Sequence[Real], options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> Fraction:
    return sums.fixed(name, PERLIN, knobs, sums.fixed_at_position(p), options, seed, periods)


def terms_of(noises_: Sequence[Real], weights: Sequence[Real] = (), gain: Real = 1, strength: Real = 0) -> Terms:
    """Octaves that have come to this."""
    weights = [Fraction(w) for w in weights or (1,) * len(noises_)]
    return Terms([Fraction(n) for n in noises_], weights, weights, Fraction(gain), Fraction(strength))


class Octaves(unittest.TestCase):
    """An octave at another place, with another seed, period or weight."""

    # The position, the lacunarity and the periods; the second octave, and its periods.
    BY_HAND = (
        # Twice the position is (0.75, -24.5), and (508.75, -597.5) / 32 after the rotation.
        ((0.375, -12.25), 2.0, (), (16.2421875, -18.078125), ()),
        # (2, 4, 6); (-0.9375, 4.375, 6); (-0.9375, 48.875 / 32, 230.875 / 32).
        ((1.0, 2.0, 3.0), 2.0, (), (-0.59375, 2.12109375, 7.93359375), ()),
        ((1.0, 2.0), -2.0, (), (Fraction(-50 + 80 + 11, 32), Fraction(-40 - 100 + 19, 32)), ()),
        ((-12.25,), 2.5, (), (-30.625 + 11 / 32,), ()),
        # As in space, then (25 z - 20 w, 20 z + 25 w) / 32 with w = 8: z was 230.875 / 32.
        ((1.0, 2.0, 3.0, 4.0), 2.0, (), (-0.59375, 2.12109375, (25 * Z - 160) / 32 + Fraction(23, 32),
                                         (20 * Z + 200) / 32 + Fraction(27, 32)), ()),
        # With periods nothing rotates, not even along an axis without one, and the lacunarity is cut.
        ((0.375, -12.25), 2.9, (5, -5), (1.09375, -23.90625), (10, -10)),
        ((0.375, 1.5), 2.0, (0, 0), (1.09375, 3.59375), (0, 0)),
        ((1.0, 2.0), 300.0, (1, 2), (255 + 11 / 32, 510 + 19 / 32), (255, 510)),
        ((1.0, 2.0), -1.5, (1, 2), (11 / 32, 19 / 32), (0, 0)),
        ((1.0, 2.0, 3.0, 4.0), 3.5, (1, 2, 3, 0), (3.34375, 6.59375, 9.71875, 12.84375), (3, 6, 9, 0)))

    def test_places(self) -> None:
        for p, lacunarity, periods, place, following in self.BY_HAND:
            found = sums.octaves_of(sums.at_position(p), Options(2, lacunarity, 0.5), 0xFFFFFFFF, periods)
            self.assertEqual([(tuple(q), tuple(tile), seed) for q, tile, seed in found],
                             [(p, periods, 0xFFFFFFFF), (place, following, 0x9E3779B8)])
        self.assertEqual(sums.in_cell((2**31 - 1, -2**31), (2.0**-30, 1.0)),
                         [2**31 - 1 + Fraction(1, 2**30), -2**31 + 1])
        self.assertEqual([sums.from_cell(Options(2, x, 0.5)).lacunarity for x in (-1.5, 1.5, 300.0)], [0, 1.5, 255])

    def test_weights(self) -> None:
        for octaves, gain, expected in ((3, 0.75, [1, 0.75, 0.5625]), (2.25, 0.5, [1, 0.5, 0.0625]),
                                        (2.0**-20, 0.5, [1]),  # a single octave counts in full
                                        (1 + 2.0**-20, 0.5, [1, 2.0**-21]), (0, 0.5, []), (-0.5, 0.5, []),
                                        (2.0**-33, 0.5, []), (2.0**-32, 0.5, [1]), (33.5, 1.0, [1] * 32)):
            self.assertEqual(sums.weights(Options(octaves, 2.0, gain)), expected)

    def test_what_a_footprint_leaves(self) -> None:
        for footprint, lacunarity, expected in (
                (0.0, 2.0, [1, 1, 1, 1]), (0.125, 2.0, [1, 1, 1, 0.5]), (0.375, 2.0, [1, 0.75, 0, 0]),
                (0.75, 0.5, [0.75] * 4), (0.75, -2.0, [0.75] * 4),  # a lacunarity below 1 counts as 1
                (-1.0, 2.0, [1] * 4), (1.5, 2.0, [0] * 4), (9.0, 1.0, [0] * 4)):
            options = Options(4, lacunarity, 0.5, footprint=footprint)
            self.assertEqual([sums.visible(options, i) for i in range(4)], expected)
            self.assertEqual([Fraction(x, 2**18) for x in itertools.islice(sums.fixed_visible(options), 4)], expected)


# Of octaves that have come to something: the noises, the weights unless all are 1, the strength, and the sum by hand.
SINGLE = {"clouds": ((-1, 0), (-0.125, 0), (0, 0.15625), (0.125, 0.5), (0.375, 1), (1, 1)),
          "billow": ((-1.5, 1), (-1, 1), (-0.25, -0.5), (0, -1), (0.75, 0.5), (1.5, 1)),
          "ridged": ((-1.5, 0), (-1, 0), (-0.5, 0.25), (0, 1), (0.75, 0.0625), (1.5, 0)),
          "hybrid": ((-1.5, 0), (-1, 0), (-0.5, 0.25), (0, 0.5), (0.75, 0.875), (1.5, 1))}
BACK_AND_FORTH = {2: (-1, 0, 1, 0, -1), 0: (-1,) * 5, -3: (-1,) * 5, 1: (-1, -0.5, 0, 0.5, 1),
                  3: (-1, 0.5, 0, -0.5, 1), 1.5: (-1, -0.25, 0.5, 0.75, 0)}
HEIGHTS = (-0.5, 0.5, 0.5, 1, -1, 1)
BY_HAND = (
    *((name, (n,), (), 0, value) for name, found in SINGLE.items() for n, value in found),
    ("fbm", (0.5, -0.25, 1), (1, 0.5, 0.5), 0, Fraction(7, 16)), ("fbm", (1.5, 1.5), (), 0, 1.5),
    ("turbulence", (0.5, -0.25, 1), (1, 0.5, 0.5), 0, Fraction(9, 16)),
    ("billow", (-0.5, 0.25), (1, 0.5), 0, Fraction(-1, 6)),
    # Ridges: 1/4; 1/4 of 2/4; 1 of 2/8; 1 of 2/4; 1 of 1, since 2/2 is no more.
    ("ridged", (0.5, -0.5, 0, 0, 0), (), 0, Fraction(17, 8) / 5),
    # Heights: 1/4; 3/4 of 2/4; 3/4 of 6/8; 1 of 1, since 18/16 is no more; 0; and nothing after that. The weights count
    # in the mean alone, not from one height to the next.
    ("hybrid", HEIGHTS, (), 0, Fraction(35, 16) / 6),
    ("hybrid", HEIGHTS, (1, 0.5, 0.25, 0.125, 0.125, 0.125), 0, Fraction(45, 64) / Fraction(17, 8)),
    # Of a constant noise: each is n + 1 times the one before, here 1/4 * (1/2)^i.
    ("hybrid", (-0.5,) * 5, (), 0, Fraction(31, 64) / 5),
    *(("ping_pong", (n,), (), strength, value) for strength, found in BACK_AND_FORTH.items()
      for n, value in zip((-1, -0.75, -0.5, -0.25, 0), found)),
    # 64 * 1.25 is even, 64.5 * 1.25 is not.
    ("ping_pong", (0.25,), (), 64, -1), ("ping_pong", (0.25,), (), 64.5, -1),
    ("ping_pong", (-2, 3, 0.5), (1, 0.5, 0.5), 1, -0.75),
    # Shares 1, (1/2) (3/4) and that times (1/2) (1/2); without a strength it is an fBm.
    *(("weighted", (0.5, 0, -1), (1, 0.5, 0.25), strength, (Fraction(1, 2) - Fraction(3, 32)) / Fraction(7, 4))
      for strength in (1, 3)),
    *(("weighted", (0.5, 0, -1), (1, 0.5, 0.25), strength, Fraction(1, 7)) for strength in (0, -1)),
    *((name, (), (), 0, {"clouds": 0.15625, "billow": -1}.get(name, 0)) for name in sums.SUMS))


class Sums(unittest.TestCase):
    """A formula of a sum that differs, exact or in fixed arithmetic, from what it is by hand."""

    def test_by_hand(self) -> None:
        for name, noises_, weights, strength, expected in BY_HAND:
            with self.subTest(name, noises=noises_, strength=strength):
                weights = weights or (1,) * len(noises_)
                self.assertEqual(sums.SUMS[name][0](terms_of(noises_, weights, Fraction(1, 2), strength)), expected)
                shares = [int(w * 2**18) for w in weights]
                of = Terms([int(n * 2**21) for n in noises_], shares, shares, 2**17, sums.in_weights(strength, 64))
                self.assertLess(abs(Fraction(sums.SUMS[name][1](of), 2**21) - Fraction(expected)), 2**-17)


ONE, FINE = 2**18, 2**24  # of weights, and of positions
END = 2**31
SHIFTS = [Fraction(shift, 32) for shift in (11, 19, 23, 27)]


class FixedSums(unittest.TestCase):
    """A position, a weight or a height of fixed arithmetic that is cut, rounded or wrapped in another place."""

    def test_places(self) -> None:
        for p, place in ((1.75, (1, 3 * 2**22)), (-1.75, (-2, 2**22)), (2.0**-24, (0, 1)), (2.0**-25, (0, 0)),
                         (-2.0**-24, (-1, FINE - 1)), (-2.0**-25, (0, 0)), (-1 - 2.0**-23, (-2, FINE - 2)),
                         (-2.0**31, (-END, 0)), (2.0**31, (2147483520, 0)), (-3.4e38, (-END, 0))):
            self.assertEqual(sums.fixed_at_position([p]), [place], p)
        for f, r in ((-0.5, 0), (2.0**-25, 0), (2.0**-24, 1), (0.75, 3 * 2**22), (1.0, FINE), (1.5, FINE)):
            self.assertEqual(sums.fixed_in_cell([END - 1], [f]), [(END - 1, r)])

    # Places of an octave, the lacunarity and the periods; and the next places less their shifts, in units of 2^-24.
    NEXT = (
        # A whole cell as fraction is the next cell, also beyond the last one.
        (((5, FINE), (0, 0)), 1.5, (0, 0), (6 * FINE, 0)), (((END - 1, FINE), (0, 0)), 0.5, (0, 0), (0, 0)),
        (((END - 1, FINE), (0, 0)), 1.5, (0, 0), (-END * FINE, 0)),
        # Rounded down twice: 3 units times 1/2 is 1, and -1 is -1; then (25 + 20) / 32, (20 - 25) / 32.
        (((0, 3), (-1, FINE - 1)), 0.5, (), (1, -1)),
        # The third axis rotates with what the second has become: 20 * 5 / 32 is 3, and then 29 * 3 / 32 and 13 * 3 / 32
        # are 2 and 1. And the fourth with what that has become: 13 * 25 / 32 is 10, and 20 * 10 / 32 is 6.
        (((0, 5), (0, 0), (0, 0)), 1.0, (), (3, 2, 1)),
        (((0, 0), (0, 32), (0, 0), (0, 0)), 1.0, (), (-20, 22, 7, 6)),
        (((0, 0), (0, 0), (0, 0), (0, 33)), 1.0, (), (0, 0, -21, 25)),
        # On the line nothing rotates. The lacunarity is cut to a multiple of 2^-23.
        (((-1, FINE - 3),), 1.5, (), (-5,)), (((2**23, 0),), 2.0**-23 + 2.0**-40, (), (FINE,)),
        # Twice the last cells are -2 and 0.
        (((END - 1, 0), (-END, 0)), 2.0, (0, 0), (-2 * FINE, 0)),
        # A coordinate beyond the range is reduced before the next rotation: 135 * 2^24 cells become -121 * 2^24 in
        # space; and in 4D, with 45 * 2^25 after the first, (13 * 45 + 29 * 63) / 32 * 2^25 becomes -421 * 2^22.
        (((3 * 2**29, 0), (3 * 2**29, 0), (0, 0)), 1.0, (),
         (15 * 2**24 * FINE, -29 * 121 * 2**19 * FINE, -13 * 121 * 2**19 * FINE)),
        (((2**30, 0), (2**30, 0), (63 * 2**25, 0), (0, 0)), 1.0, (),
         (5 * 2**25 * FINE, 486 * 2**20 * FINE, -25 * 421 * 2**17 * FINE, -20 * 421 * 2**17 * FINE)))

    def test_next_places(self) -> None:
        for place, lacunarity, periods, expected in self.NEXT:
            _, (found, *_) = sums.fixed_octaves_of(list(place), Options(2, lacunarity, 0.5), 0, periods)
            moved = [(x + int(shift * FINE) + 2**55) % 2**56 - 2**55 for x, shift in zip(expected, SHIFTS)]
            self.assertEqual(found, [(x // FINE, x % FINE) for x in moved], place)
        # A product of 87 bits that all count.
        position = 0x123456789ABCDF
        moved = (math.floor(Fraction(math.trunc(1.9 * 2**23), 2**23) * position) + 2**55) % 2**56 - 2**55
        _, ([(cell, r)], *_) = sums.fixed_octaves_of([(position >> 24, position % FINE)], Options(2, 1.9, 0.5), 0)
        self.assertEqual(cell * FINE + r, moved + 11 * 2**19)
        # Periods keep their low 32 bits: 3 * 2^29 * 3 is 2^29, a period again.
        found = [(tuple(periods), seed) for _, periods, seed in sums.fixed_octaves_of(
            [(0, 0)] * 2, Options(3, 3.9, 0.5), 0xFFFFFFFF, (3 * 2**29, -5))]
        self.assertEqual(found, [((3 * 2**29, -5), 0xFFFFFFFF), ((2**29, -15), 0x9E3779B8),
                                 ((3 * 2**29, -45), 0x3C6EF371)])

    def test_weights(self) -> None:
        for octaves, gain, expected in (
                (3, 0.5, [ONE, ONE // 2, ONE // 4]), (40, 1.5, [ONE] * 32), (3, -1.0, [ONE, 0, 0]), (-0.5, 0.5, []),
                # Powers of 0.7, whose 18 bits are 183500: of each product the floor. Of the last one a part, cut.
                (4, 0.7, [ONE, 183500, 183500**2 >> 18, (183500**2 >> 18) * 183500 >> 18]),
                (2.75, 0.5, [ONE, ONE // 2, ONE * 3 // 16]), (1 + 2.0**-18 + 2.0**-20, 1.0, [ONE, 1]),
                (0.5, 0.5, [ONE]), (31.5, 1.0, [ONE] * 31 + [ONE // 2])):
            self.assertEqual(sums.fixed_weights(Options(octaves, 2.0, gain)), expected)
        # The footprint is cut to 2^-24, and what it has grown to is; 64 of these are one of a weight.
        for units, lacunarity, i, left in ((2**23 + 63, 1.0, 0, ONE), (2**23 + 64, 1.0, 0, ONE - 1),
                                           (2**23 + 43, 1.5, 1, 3 * 2**17 - (3 * 2**22 + 64 >> 6)),
                                           (2**23 + 42, 1.5, 1, 3 * 2**17 - (3 * 2**22 + 63 >> 6))):
            options = Options(2, lacunarity, 0.5, footprint=units / FINE)
            self.assertEqual(list(itertools.islice(sums.fixed_visible(options), 2))[i], left)

    def test_products(self) -> None:
        for a, b in itertools.product((0, 511, 513, 183500, ONE), repeat=2):
            self.assertEqual(sums.product(a, b), ((a >> 9) * b + ((a & 511) * b >> 9)) >> 9)
        for a, b in ((-1, 0), (0, -1), (ONE + 1, 0), (0, ONE + 1)):
            with self.assertRaises(OverflowError):
                sums.product(a, b)

    def fixed_terms(self, values: Sequence[int], weights: Sequence[int], strength: int = 0) -> Terms[int]:
        return Terms(list(values), list(weights), list(weights), 2**17, strength)

    def test_mean(self) -> None:
        for values, weights, expected in (
                ([2**21, -2**20], [ONE, ONE // 2], 2**20), ([-3, 0], [ONE, ONE], -1),  # towards 0
                ([-3 * 2**20] * 32, [ONE] * 32, -3 * 2**20),
                # The low bits of a weight: 1000 is 1 * 512 + 488, so 2^18 // 512 * 488 is added to 2^18 * 1.
                ([0, ONE], [ONE, 1000], (ONE + 2**9 * 488 >> 9) * ONE // (ONE + 1000))):
            self.assertEqual(sums.fixed_mean(self.fixed_terms(values, weights), values), expected)

    def test_heights(self) -> None:
        # Of hybrid sums they are cut to 18 bits, and so is what one leaves to the next: 777777 is no multiple of 16.
        h = (2**21 - 777777) >> 4
        following = ((h >> 9) * (2 * h) + ((h & 511) * (2 * h) >> 9)) >> 9
        found = sums.fixed_hybrid(self.fixed_terms([-777777] * 2, [ONE] * 2))
        self.assertEqual(found, (h + following << 3) // 2)
        for v, strength in itertools.product((-2**21, -777777, -1, 0, 777777, 2**21), (0, 1, 511, ONE, 700000, 2**24)):
            t = Fraction((v + 2**21) * strength, 2**39) % 2
            self.assertLessEqual(abs(Fraction(sums.fixed_height(v, strength), 2**30) - min(t, 2 - t)), 2**-30)

    def test_a_noise_that_is_larger(self) -> None:
        for v, at_most in ((5 * 2**19, 5 * 2**19), (-5 * 2**19, 5 * 2**19), (2**22, 3 * 2**20)):
            of, same = (self.fixed_terms([x], [ONE], ONE) for x in (v, 2**21 if v > 0 else -2**21))
            self.assertEqual((sums.fixed_fbm(of), sums.fixed_turbulence(of)), (math.copysign(at_most, v), at_most))
            for function in (sums.fixed_clouds, sums.fixed_billow, sums.fixed_ridged, sums.fixed_hybrid,
                             sums.fixed_ping_pong, sums.fixed_weighted):
                self.assertEqual(function(of), function(same))

    def test_arguments_are_cut(self) -> None:
        for name, beyond, end in (("fbm", (4, 300.0, 0.5), (4, 255.0, 0.5)), ("fbm", (4, -2.0, 0.5), (4, 0.0, 0.5)),
                                  ("weighted", (4, 2.0, 0.5, 2.0), (4, 2.0, 0.5, 1.0))):
            self.assertEqual(*(fixed(name, Knobs("pcg"), (0.375, -12.25), Options(*x)) for x in (beyond, end)))
