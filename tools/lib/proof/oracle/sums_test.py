"""Tests of sums.py: octave sums of hn_perlin, by hand, and what the contract promises of them."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from base.thorough import in_thorough_runs
from proof.golden.generator import generator_of
from proof.oracle import noises, sums
from proof.oracle.gradients import Knobs, Real
from proof.oracle.sums import Options, Terms

PERLIN = noises.find("perlin")
SETTINGS = (Knobs("lattice"), Knobs("fnv1"), Knobs("lattice", sine=True))
LEAST = {"turbulence": 0, "clouds": 0, "ridged": 0, "hybrid": 0}  # of the others -1


def noise_at(knobs: Knobs, p: Sequence[Real], seed: int = 0, periods: Sequence[int] = ()) -> Fraction:
    value, = PERLIN.exact(knobs, p, seed, periods)
    return value


def fixed_noise_at(knobs: Knobs, p: Sequence[Real], seed: int = 0) -> Fraction:
    value, = PERLIN.fixed(knobs, p, seed)
    return value


def exact(name: str, knobs: Knobs, p: Sequence[Real], options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> Fraction:
    return sums.exact(name, PERLIN, knobs, sums.at_position(p), options, seed, periods)


def fixed(name: str, knobs: Knobs, p: Sequence[Real], options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> Fraction:
    return sums.fixed(name, PERLIN, knobs, sums.fixed_at_position(p), options, seed, periods)


def terms_of(noises_: Sequence[Real], weights: Sequence[Real] = (), gain: Real = 1, strength: Real = 0) -> Terms:
    """Octaves that have come to this."""
    weights = [Fraction(w) for w in weights or (1,) * len(noises_)]
    return Terms([Fraction(n) for n in noises_], weights, weights, Fraction(gain), Fraction(strength))


class Octaves(unittest.TestCase):
    """Where they are, and what they weigh."""

    def places(self, p: Sequence[Real], options: Options, periods: Sequence[int] = ()) -> list:
        return [(tuple(q), tuple(periods), seed)
                for q, periods, seed in sums.octaves_of(sums.at_position(p), options, 0xFFFFFFFF, periods)]

    def test_by_hand(self) -> None:
        # Twice the position is (0.75, -24.5), and (508.75, -597.5) / 32 after the rotation.
        self.assertEqual(self.places((0.375, -12.25), Options(2, 2.0, 0.5)),
                         [((0.375, -12.25), (), 0xFFFFFFFF), ((16.2421875, -18.078125), (), 0x9E3779B8)])
        # (2, 4, 6); (-0.9375, 4.375, 6); (-0.9375, 48.875 / 32, 230.875 / 32).
        self.assertEqual(self.places((1.0, 2.0, 3.0), Options(2, 2.0, 0.5))[1][0], (-0.59375, 2.12109375, 7.93359375))
        self.assertEqual(self.places((1.0, 2.0), Options(2, -2.0, 0.5))[1][0],
                         (Fraction(-50 + 80 + 11, 32), Fraction(-40 - 100 + 19, 32)))

    def test_on_the_line_and_in_four_dimensions_by_hand(self) -> None:
        self.assertEqual(self.places((-12.25,), Options(2, 2.5, 0.5)),
                         [((-12.25,), (), 0xFFFFFFFF), ((-30.625 + 11 / 32,), (), 0x9E3779B8)])
        # As in space, then (25 z - 20 w, 20 z + 25 w) / 32 with w = 8: z was 230.875 / 32.
        z = Fraction(1847, 256)
        self.assertEqual(self.places((1.0, 2.0, 3.0, 4.0), Options(2, 2.0, 0.5))[1][0],
                         (-0.59375, 2.12109375, (25 * z - 160) / 32 + Fraction(23, 32),
                          (20 * z + 200) / 32 + Fraction(27, 32)))
        self.assertEqual(self.places((1.0, 2.0, 3.0, 4.0), Options(2, 3.5, 0.5), (1, 2, 3, 0))[1],
                         ((3.34375, 6.59375, 9.71875, 12.84375), (3, 6, 9, 0), 0x9E3779B8))

    def test_with_periods_by_hand(self) -> None:
        # Nothing rotates, not even along an axis without a period. 2.9 is rounded down.
        self.assertEqual(self.places((0.375, -12.25), Options(3, 2.9, 0.5), (5, -5)),
                         [((0.375, -12.25), (5, -5), 0xFFFFFFFF), ((1.09375, -23.90625), (10, -10), 0x9E3779B8),
                          ((2.53125, -47.21875), (20, -20), 0x3C6EF371)])
        self.assertEqual(self.places((0.375, 1.5), Options(2, 2.0, 0.5), (0, 0))[1][0], (1.09375, 3.59375))
        self.assertEqual(self.places((1.0, 2.0, 3.0), Options(2, 3.0, 0.5), (1, 2, 3))[1][:2],
                         ((3.34375, 6.59375, 9.71875), (3, 6, 9)))

    def test_the_lacunarity_is_cut_with_a_period(self) -> None:
        for lacunarity, same in ((2.9, 2.0), (-1.5, 0.0), (0.75, 0.0), (300.0, 255.0)):
            found = [self.places((0.375, 0.5), Options(2, x, 0.5), (48, 0)) for x in (lacunarity, same)]
            self.assertEqual(*found)

    def test_a_cell_far_out_keeps_its_fraction(self) -> None:
        place = sums.in_cell((2**31 - 1, -2**31), (2.0**-30, 1.0))
        self.assertEqual(place, [2**31 - 1 + Fraction(1, 2**30), -2**31 + 1])
        options = Options(3, 2.0, 0.5)
        self.assertEqual(sums.exact("fbm", PERLIN, Knobs("pcg"), sums.in_cell((3, -5), (0.25, 1.0)), options),
                         exact("fbm", Knobs("pcg"), (3.25, -4.0), options))

    def test_from_a_cell_the_lacunarity_is_cut(self) -> None:
        found = [sums.from_cell(Options(2, x, 0.5)).lacunarity for x in (-1.5, 0.0, 1.5, 255.0, 300.0)]
        self.assertEqual(found, [0, 0, 1.5, 255, 255])

    def test_weights(self) -> None:
        self.assertEqual(sums.weights(Options(3, 2.0, 0.75)), [1, 0.75, 0.5625])
        self.assertEqual(sums.weights(Options(3, 2.0, 0.0)), [1, 0, 0])
        self.assertEqual(sums.weights(Options(2.25, 2.0, 0.5)), [1, 0.5, 0.0625])
        self.assertEqual(sums.weights(Options(2.0**-20, 2.0, 0.5)), [1])  # a single octave counts in full
        self.assertEqual(sums.weights(Options(1 + 2.0**-20, 2.0, 0.5)), [1, 2.0**-21])
        for none in (0, -1, 0.0, -0.5):
            self.assertEqual(sums.weights(Options(none, 2.0, 0.5)), [])

    def test_what_a_footprint_leaves(self) -> None:
        def left(footprint: float, lacunarity: float, count: int = 4) -> list[Fraction]:
            return [sums.visible(Options(count, lacunarity, 0.5, footprint=footprint), i) for i in range(count)]

        self.assertEqual(left(0.0, 2.0), [1, 1, 1, 1])
        self.assertEqual(left(0.125, 2.0), [1, 1, 1, 0.5])  # half a cell of the third, a whole one of the fourth
        self.assertEqual(left(0.375, 2.0), [1, 0.75, 0, 0])
        self.assertEqual(left(0.75, 0.5), [0.75] * 4)  # a lacunarity below 1 counts as 1
        self.assertEqual(left(0.75, -2.0), [0.75] * 4)
        self.assertEqual((left(1.5, 2.0), left(3.0, 1.0)), ([0] * 4, [0] * 4))


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
    def test_by_hand(self) -> None:
        for name, noises_, weights, strength, expected in BY_HAND:
            with self.subTest(name, noises=noises_, strength=strength):
                weights = weights or (1,) * len(noises_)
                self.assertEqual(sums.SUMS[name][0](terms_of(noises_, weights, Fraction(1, 2), strength)), expected)
                shares = [int(w * 2**18) for w in weights]
                of = Terms([int(n * 2**21) for n in noises_], shares, shares, 2**17, sums.in_weights(strength, 64))
                self.assertLess(abs(Fraction(sums.SUMS[name][1](of), 2**21) - Fraction(expected)), 2**-17)

    def test_shares_that_are_less_than_weights(self) -> None:
        terms = replace(terms_of((0.5, -0.25, 1), (1, 0.5, 0.5)), shares=[Fraction(1), Fraction(1, 2), Fraction(0)])
        self.assertEqual(sums.fbm(terms), Fraction(3, 16))


class OctaveSums(unittest.TestCase):
    POINTS = [(0.375, -12.25), (5.125, 7.75, -0.625)]

    def test_one_octave_is_the_noise(self) -> None:
        for point in self.POINTS:
            noise = noise_at(Knobs("lattice"), point, 3)
            for octaves, gain in ((1, 0.5), (6, 0.0), (0.375, 0.5)):
                options = Options(octaves, 2.0, gain)
                self.assertEqual(exact("fbm", Knobs("lattice"), point, options, 3), noise)
                self.assertEqual(exact("turbulence", Knobs("lattice"), point, options, 3), abs(noise))

    def test_another_way(self) -> None:
        """Floats, with a position of the plane as a complex number."""
        numbers = generator_of("another way")
        for _ in range(40):
            p = complex(numbers.uniform(-8, 8), numbers.uniform(-8, 8))
            lacunarity, gain, strength = numbers.uniform(0.5, 2.5), numbers.uniform(0, 1.25), numbers.uniform(0, 1)
            octaves, seed = numbers.integer(1, 4), numbers.word()
            options = Options(octaves, lacunarity, gain, strength)
            n, q = [], p
            for i in range(octaves):
                n.append(float(noise_at(Knobs("lattice"), (q.real, q.imag), seed + i * 0x9E3779B9 & 0xFFFFFFFF)))
                q = q * lacunarity * (25 + 20j) / 32 + (11 + 19j) / 32
            a = [gain**i for i in range(octaves)]

            def mean(values: Sequence[float], weights: Sequence[float] = ()) -> float:
                return math.fsum(w * v for w, v in zip(weights or a, values)) / math.fsum(a)

            ridges, heights, shares = [], [], [1.0]
            for i, v in enumerate(n):
                ridges.append((1 - abs(v))**2 * (min(1, 2 * ridges[-1]) if i else 1))
                heights.append((0.5 + v / 2) * (min(1, 2 * heights[-1]) if i else 1))
                shares.append(shares[-1] * gain * (1 - strength + strength * (1 + v) / 2))
            t = 0.25 + 2 * mean(n)
            expected = {"fbm": mean(n), "turbulence": mean(list(map(abs, n))),
                        "clouds": 0 if t < 0 else 1 if t > 1 else t * t * (3 - 2 * t),
                        "billow": mean([2 * abs(v) - 1 for v in n]), "ridged": mean(ridges),
                        "hybrid": mean(heights),
                        # Back and forth between -1 and 1: the arc sine of a sine.
                        "ping_pong": mean([-2 / math.pi * math.asin(math.cos(math.pi * (v + 1) * strength))
                                           for v in n]),
                        "weighted": mean(n, shares)}
            for name, value in expected.items():
                found = exact(name, Knobs("lattice"), (p.real, p.imag), options, seed)
                self.assertLess(abs(found - Fraction(value)), 1e-6 if name == "ping_pong" else 1e-9, name)

    def test_details_are_between_whole_numbers(self) -> None:
        numbers = generator_of("details")
        for _ in range(20):
            p, seed = (numbers.integer(-99, 99) / 16, numbers.integer(-99, 99) / 16), numbers.word()
            found = [exact("fbm", Knobs("pcg"), p, Options(octaves, 2.0, 0.5), seed)
                     for octaves in (3, 3.0, 3 + 2.0**-20, 3.5, 4 - 2.0**-20, 4)]
            self.assertEqual(found[0], found[1])
            self.assertLess(max(abs(found[1] - found[2]), abs(found[4] - found[5])), 2**-20)
            self.assertTrue(min(found[0], found[5]) < found[3] < max(found[0], found[5]))

    def test_a_footprint_takes_what_is_fine(self) -> None:
        p, seed = (0.375, -12.25), 7
        # At 1/2 over a power of the lacunarity the octave after it counts by half, and no other.
        for footprint, octaves in ((0.0, 5), (2.0**-5, 5), (2.0**-4, 4.5), (2.0**-2, 2.5), (0.5, 1.5)):
            found = exact("fbm", Knobs("pcg"), p, Options(5, 2.0, 0.5, footprint=footprint), seed)
            first = exact("fbm", Knobs("pcg"), p, Options(octaves, 2.0, 0.5), seed)
            self.assertEqual(found * sum(sums.weights(Options(5, 2.0, 0.5))),
                             first * sum(sums.weights(Options(octaves, 2.0, 0.5))))
        self.assertEqual(exact("fbm", Knobs("pcg"), p, Options(5, 2.0, 0.5, footprint=1.5), seed), 0)

    @in_thorough_runs
    def test_ranges(self) -> None:
        numbers = generator_of("ranges")
        for n, knobs in itertools.product((2, 3), SETTINGS):
            for _ in range(20):
                p = [numbers.integer(-640, 640) / 32 for _ in range(n)]
                options, seed = Options(4, 2.0, 0.5, numbers.uniform(0, 3)), numbers.word()
                for name in sums.SUMS:
                    largest = Fraction(3, 2) if knobs.sine and name in ("fbm", "turbulence") else 1
                    for function in (exact, fixed):
                        found = function(name, knobs, p, options, seed)
                        self.assertTrue(LEAST.get(name, -largest) <= found <= largest, name)

    def test_repeat_after_a_period(self) -> None:
        # With any lacunarity, since it is rounded down.
        for knobs, lacunarity in ((Knobs("lattice"), 2.0), (Knobs("lattice", sine=True), 3.0), (Knobs("lattice"), 1.5)):
            for point, name, function in itertools.product(self.POINTS, sums.SUMS, (exact, fixed)):
                options, moved = Options(3, lacunarity, 0.5, 0.75), [x - 96 for x in point]
                values = [function(name, knobs, p, options, 3, (48,) * len(p)) for p in (point, moved)]
                self.assertEqual(*values)
                values = [function(name, knobs, p, options, 3) for p in (point, moved)]
                self.assertTrue(values[0] != values[1] or name == "clouds", name)

    def test_seeds_differ(self) -> None:
        self.assertEqual(len({exact("fbm", Knobs("pcg"), (0.375, 0.5), Options(4, 2.0, 0.5), seed)
                              for seed in range(32)}), 32)


class FixedSums(unittest.TestCase):
    def test_positions(self) -> None:
        table = {
            1.75: (1, 3 * 2**22), -1.75: (-2, 2**22), -1.0: (-1, 0), -0.0: (0, 0), 2.0**-24: (0, 1), 2.0**-25: (0, 0),
            -2.0**-24: (-1, 2**24 - 1), -2.0**-25: (0, 0), -1e-40: (0, 0), -2.0**-21: (-1, 2**24 - 8),
            -1 - 2.0**-23: (-2, 2**24 - 2), -2.0**31: (-2**31, 0), 2.0**31: (2147483520, 0), -3.4e38: (-2**31, 0),
        }
        for p, place in table.items():
            self.assertEqual(sums.fixed_at_position([p]), [place], p)

    def test_places_in_cells(self) -> None:
        fractions = {0.0: 0, -0.5: 0, 2.0**-25: 0, 2.0**-24: 1, 0.75: 3 * 2**22, 1 - 2.0**-24: 2**24 - 1, 1.0: 2**24,
                     1.5: 2**24}
        for f, r in fractions.items():
            self.assertEqual(sums.fixed_in_cell([2**31 - 1], [f]), [(2**31 - 1, r)])

    def next_place(self, place: Sequence[tuple[int, int]], lacunarity: Real, periods: Sequence[int] = ()) -> list:
        _, (found, _, _) = sums.fixed_octaves_of(list(place), Options(2, lacunarity, 0.5), 0, periods)
        return found

    def test_next_positions(self) -> None:
        one = 2**24
        # As by hand above: (16.2421875, -18.078125).
        self.assertEqual(self.next_place(sums.fixed_at_position((0.375, -12.25)), 2.0),
                         [(16, 0.2421875 * one), (-19, 0.921875 * one)])
        self.assertEqual(self.next_place(sums.fixed_at_position((1.0, 2.0, 3.0)), 2.0),
                         [(-1, 0.40625 * one), (2, 0.12109375 * one), (7, 0.93359375 * one)])
        # A whole cell as fraction is the next cell, also beyond the last one.
        for cell in (5, -1, 2**31 - 1):
            self.assertEqual(self.next_place([(cell, one), (3, 0)], 1.5), self.next_place([(cell + 1, 0), (3, 0)], 1.5))
        self.assertEqual(self.next_place([(2**31 - 1, one), (0, 0)], 0.5, (0, 0)), [(0, 11 * 2**19), (0, 19 * 2**19)])
        self.assertEqual(self.next_place([(2**31 - 1, one), (0, 0)], 1.5, (0, 0)),
                         [(-2**31, 11 * 2**19), (0, 19 * 2**19)])
        # Rounded down twice: 3 units times 1/2 is 1, and -1 is -1; then (25 + 20) / 32, (20 - 25) / 32.
        self.assertEqual(self.next_place([(0, 3), (-1, one - 1)], 0.5), [(0, 1 + 11 * 2**19), (0, 19 * 2**19 - 1)])
        # The third axis rotates with what the second has become: 20 * 5 / 32 is 3, and then 29 * 3 / 32 and 13 * 3 / 32
        # are 2 and 1.
        self.assertEqual(self.next_place([(0, 5), (0, 0), (0, 0)], 1.0),
                         [(0, 3 + 11 * 2**19), (0, 2 + 19 * 2**19), (0, 1 + 23 * 2**19)])
        # And the fourth with what that has become: 13 * 25 / 32 is 10, and 20 * 10 / 32 is 6, 25 * 10 / 32 is 7.
        self.assertEqual(self.next_place([(0, 0), (0, 32), (0, 0), (0, 0)], 1.0),
                         [(0, 11 * 2**19 - 20), (0, 22 + 19 * 2**19), (0, 7 + 23 * 2**19), (0, 6 + 27 * 2**19)])
        self.assertEqual(self.next_place([(0, 0), (0, 0), (0, 0), (0, 33)], 1.0)[2:],
                         [(0, 23 * 2**19 - 21), (0, 27 * 2**19 + 25)])
        # On the line nothing rotates.
        self.assertEqual(self.next_place([(-1, one - 3)], 1.5), [(0, 11 * 2**19 - 5)])
        # The lacunarity is cut to a multiple of 2^-23.
        self.assertEqual(self.next_place([(2**23, 0), (0, 0)], 2.0**-23 + 2.0**-40),
                         self.next_place([(1, 0), (0, 0)], 1.0))

    def test_next_positions_wrap(self) -> None:
        one, end = 2**24, 2**31
        # Twice the last cells are -2 and 0; the rotation of 2^31 - 1 is beyond the range along both axes.
        self.assertEqual(self.next_place([(end - 1, 0), (-end, 0)], 2.0, (0, 0)), [(-2, 11 * 2**19), (0, 19 * 2**19)])
        x, y = (25 * (end - 1) - 20 * (1 - end)) * one // 32, (20 * (end - 1) + 25 * (1 - end)) * one // 32
        self.assertGreater(x, 2**55)
        x += 11 * 2**19 - 2**56
        y += 19 * 2**19
        self.assertEqual(self.next_place([(end - 1, 0), (1 - end, 0)], 1.0), [(x >> 24, x % one), (y >> 24, y % one)])
        # In space what the first rotation has brought beyond the range is reduced before the second: 135 * 2^24 cells
        # become -121 * 2^24.
        self.assertEqual(self.next_place([(3 * 2**29, 0), (3 * 2**29, 0), (0, 0)], 1.0),
                         [(15 * 2**24, 11 * 2**19), (-29 * 121 * 2**19, 19 * 2**19), (-13 * 121 * 2**19, 23 * 2**19)])
        # In four dimensions what the second rotation has brought beyond it is reduced before the third: with 45 * 2^25
        # along y after the first one, (13 * 45 + 29 * 63) / 32 times 2^25 becomes -421 * 2^22.
        self.assertEqual(self.next_place([(2**30, 0), (2**30, 0), (63 * 2**25, 0), (0, 0)], 1.0),
                         [(5 * 2**25, 11 * 2**19), (486 * 2**20, 19 * 2**19), (-25 * 421 * 2**17, 23 * 2**19),
                          (-20 * 421 * 2**17, 27 * 2**19)])
        # A product of 87 bits that all count.
        for position, lacunarity in itertools.product((2**55 - 1, -2**55 + 1, 0x123456789ABCDF), (255 - 2.0**-16, 1.9)):
            moved = math.floor(Fraction(math.trunc(lacunarity * 2**23), 2**23) * position)
            moved = (moved + 2**55) % 2**56 - 2**55
            (cell, r), _ = self.next_place([(position >> 24, position % one), (0, 0)], lacunarity)
            self.assertEqual((cell * one + r - math.floor(Fraction(25 * moved, 32)) - 11 * 2**19) % 2**56, 0)

    def test_weights(self) -> None:
        one = 2**18

        def weights(octaves: Real, gain: Real) -> list[int]:
            return sums.fixed_weights(Options(octaves, 2.0, gain))

        self.assertEqual(weights(3, 0.5), [one, one // 2, one // 4])
        self.assertEqual(weights(3, 0.0), [one, 0, 0])
        self.assertEqual(weights(40, 1.5), [one] * 32)
        self.assertEqual(weights(3, -1.0), [one, 0, 0])
        self.assertEqual((weights(0, 0.5), weights(-1, 0.5), weights(-0.5, 0.5)), ([], [], []))
        # Powers of 0.7, whose 18 bits are 183500: of each product the floor.
        self.assertEqual(weights(4, 0.7), [one, 183500, 183500**2 >> 18, (183500**2 >> 18) * 183500 >> 18])
        # Of the last one a part, cut to 18 bits.
        self.assertEqual(weights(2.75, 0.5), [one, one // 2, one * 3 // 16])
        self.assertEqual(weights(1 + 2.0**-18 + 2.0**-20, 1.0), [one, 1])
        self.assertEqual(weights(1 + 2.0**-19, 1.0), [one, 0])
        self.assertEqual((weights(0.5, 0.5), weights(2.0**-149, 0.5), weights(2.0**-32, 0.5)), ([one], [], [one]))
        self.assertEqual(weights(33.5, 1.0), [one] * 32)
        self.assertEqual(weights(31.5, 1.0), [one] * 31 + [one // 2])

    def test_what_a_footprint_leaves(self) -> None:
        one = 2**18

        def left(footprint: float, lacunarity: float, count: int = 4) -> list[int]:
            options = Options(count, lacunarity, 0.5, footprint=footprint)
            return list(itertools.islice(sums.fixed_visible(options), count))

        self.assertEqual(left(0.375, 2.0), [one, one * 3 // 4, 0, 0])
        self.assertEqual((left(0.0, 255.0), left(-1.0, 2.0), left(1.5, 2.0), left(9.0, 1.0)),
                         ([one] * 4, [one] * 4, [0] * 4, [0] * 4))
        self.assertEqual((left(0.75, 0.5), left(0.75, -2.0)), ([one * 3 // 4] * 4, [one * 3 // 4] * 4))
        # The footprint is cut to 2^-24, and what it has grown to is; 64 of these are one of a weight.
        self.assertEqual(left(0.5 + 63 * 2.0**-24, 1.0, 1) + left(0.5 + 2.0**-18, 1.0, 1), [one, one - 1])
        self.assertEqual(left((2**23 + 43) * 2.0**-24, 1.5, 2), [one, 3 * 2**17 - (3 * 2**22 + 64 >> 6)])
        self.assertEqual(left((2**23 + 42) * 2.0**-24, 1.5, 2), [one, 3 * 2**17 - (3 * 2**22 + 63 >> 6)])

    def test_product(self) -> None:
        for a, b in itertools.product((0, 1, 511, 512, 513, 183500, 2**18 - 1, 2**18), repeat=2):
            self.assertEqual(sums.product(a, b), ((a >> 9) * b + ((a & 511) * b >> 9)) >> 9)
            self.assertLessEqual(abs(Fraction(a * b, 2**18) - sums.product(a, b)), 1)
        for a, b in ((-1, 0), (0, 2**18 + 1)):
            with self.assertRaises(OverflowError):
                sums.product(a, b)

    def fixed_terms(self, values: Sequence[int], weights: Sequence[int], strength: int = 0) -> Terms[int]:
        return Terms(list(values), list(weights), list(weights), 2**17, strength)

    def test_mean(self) -> None:
        one = 2**18

        def mean(values: Sequence[int], weights: Sequence[int]) -> int:
            return sums.fixed_mean(self.fixed_terms(values, weights), values)

        self.assertEqual(mean([2**21, -2**20], [one, one // 2]), 2**20)
        self.assertEqual(mean([-3, 0], [one, one]), -1)  # towards 0
        self.assertEqual(mean([-3 * 2**20] * 32, [one] * 32), -3 * 2**20)
        self.assertEqual(mean([], []), 0)
        # The low bits of a weight: 1000 of 2^18 is 1 * 512 + 488, so 2^18 // 512 * 488 is added to 2^18 * 1.
        self.assertEqual(mean([0, 2**18], [one, 1000]), (2**18 + 2**9 * 488 >> 9) * one // (one + 1000))

    @in_thorough_runs
    def test_density(self) -> None:
        self.assertEqual([sums.density(v) for v in (-2**21, -2**18, 2**18, 3 * 2**18, 2**21)],
                         [0, 0, 2**20, 2**21, 2**21])
        self.assertEqual(sums.density(0), 5 * 2**16)
        values = []
        for v in range(-2**18, 3 * 2**18 + 1, 11):
            t = Fraction(v + 2**18, 2**20)
            values.append(sums.density(v))
            self.assertLess(abs(Fraction(values[-1], 2**21) - t * t * (3 - 2 * t)), 2.6e-5)
        self.assertEqual(values, sorted(values))

    def test_heights_of_hybrid_sums_are_cut(self) -> None:
        # To 18 bits, and so is what one leaves to the next: 777777 is no multiple of 16. (There are no vectors of
        # these.)
        h = (2**21 - 777777) >> 4
        following = ((h >> 9) * (2 * h) + ((h & 511) * (2 * h) >> 9)) >> 9
        for values, height in (([-777777], h << 3), ([-777777] * 2, (h + following << 3) // 2)):
            self.assertEqual(sums.fixed_hybrid(self.fixed_terms(values, [2**18] * len(values))), height)

    def test_heights(self) -> None:
        self.assertEqual([sums.fixed_height(v, 2 * 2**18) for v in (-2**21, -2**20, 0, 2**20, 2**21)],
                         [0, 2**30, 0, 2**30, 0])
        self.assertEqual([sums.fixed_height(v, 2**18) for v in (-2**21, 0, 2**21)], [0, 2**30, 0])
        for v, strength in itertools.product((-2**21, -777777, -1, 0, 1, 777777, 2**21 - 1, 2**21),
                                             (0, 1, 511, 512, 2**18, 700000, 2**24 - 1, 2**24)):
            t = Fraction((v + 2**21) * strength, 2**39) % 2
            off = abs(Fraction(sums.fixed_height(v, strength), 2**30) - min(t, 2 - t))
            self.assertLessEqual(off, 2**-30)
        self.assertEqual(sums.fixed_ping_pong(self.fixed_terms([-2**20, 2**21], [2**18] * 2, 2**19)), 0)

    def test_a_noise_that_is_larger(self) -> None:
        one = 2**18
        for v, at_most in ((5 * 2**19, 5 * 2**19), (-5 * 2**19, 5 * 2**19), (2**22, 3 * 2**20)):
            of, same = (self.fixed_terms([x], [one], one) for x in (v, 2**21 if v > 0 else -2**21))
            self.assertEqual(sums.fixed_fbm(of), math.copysign(at_most, v))
            self.assertEqual(sums.fixed_turbulence(of), at_most)
            for function in (sums.fixed_clouds, sums.fixed_billow, sums.fixed_ridged, sums.fixed_hybrid,
                             sums.fixed_ping_pong, sums.fixed_weighted):
                self.assertEqual(function(of), function(same))

    def test_one_octave_is_the_noise_where_nothing_is_cut_off(self) -> None:
        def one(p: Sequence[Real]) -> Fraction:
            return fixed("fbm", Knobs("lattice"), p, Options(1, 2.0, 0.5), 3)

        for p in ((0.375, -12.25), (5.125, 7.75, -0.625)):
            self.assertEqual(one(p), fixed_noise_at(Knobs("lattice"), p, 3))
        # Else a position is rounded down, a coordinate of the noise towards 0.
        self.assertEqual(fixed_noise_at(Knobs("lattice"), (-0.5 - 2.0**-24, 0.25), 3),
                         fixed_noise_at(Knobs("lattice"), (-0.5, 0.25), 3))
        self.assertEqual(one((-0.5 - 2.0**-24, 0.25)), fixed_noise_at(Knobs("lattice"), (-0.5 - 2.0**-20, 0.25), 3))

    def test_the_fraction_of_the_first_octave_may_be_one(self) -> None:
        knobs = Knobs("pcg")
        for cell, f in (((4, -7), (1.0, 0.25)), ((2**31 - 1, -2**31), (1.0, 1.0))):
            found = sums.fixed("fbm", PERLIN, knobs, sums.fixed_in_cell(cell, f), Options(1, 2.0, 0.5), 5)
            noise, = PERLIN.fixed_cell(knobs, cell, f, 5)
            self.assertEqual(found, noise)

    def test_arguments_are_cut(self) -> None:
        p = (0.375, -12.25)
        for options, same in (((33, 2.0, 1.0), (32, 2.0, 1.0)), ((4, 300.0, 0.5), (4, 255.0, 0.5)),
                              ((4, -2.0, 0.5), (4, 0.0, 0.5)), ((4, 2.0, 1.5), (4, 2.0, 1.0)),
                              ((4, 2.0, -0.5), (1, 2.0, 1.0))):
            self.assertEqual(*(fixed("fbm", Knobs("pcg"), p, Options(*x)) for x in (options, same)))
        for name, strength, same in (("ping_pong", 100.0, 64.0), ("ping_pong", -1.0, 0.0), ("weighted", 2.0, 1.0),
                                     ("weighted", -1.0, 0.0)):
            for function in (exact, fixed):
                found = [function(name, Knobs("pcg"), p, Options(4, 2.0, 0.5, x)) for x in (strength, same)]
                self.assertEqual(*found)

    def test_are_near_the_exact_sums(self) -> None:
        for knobs, n in itertools.product(SETTINGS, (2, 3)):
            numbers = generator_of(str(knobs))
            for gain, octaves, footprint in ((0.5, 6, 0.0), (0.75, 4, 0.0), (1.0, 2.625, 0.0), (0.5, 4, 0.09375)):
                p = [numbers.integer(-4096, 4096) / 64 for _ in range(n)]
                options, seed = Options(octaves, 2.0, gain, 0.75, footprint), numbers.word()
                for name, limit in (("fbm", 1), ("turbulence", 1), ("clouds", 4), ("billow", 2), ("ridged", 2),
                                    ("hybrid", 2), ("ping_pong", 2), ("weighted", 2)):
                    for periods in ((), (48, 7, 0)[:n]):
                        found = [function(name, knobs, p, options, seed, periods) for function in (exact, fixed)]
                        self.assertLess(abs(found[0] - found[1]), limit * 2**-15, (name, octaves))

    def test_from_a_cell_they_are_as_near_far_out(self) -> None:
        numbers = generator_of("far out")
        for n, name in itertools.product((2, 3), sums.SUMS):
            cell = [numbers.integer(-2**28, 2**28) for _ in range(n)]
            f = [numbers.uniform(0, 1) for _ in range(n)]
            arguments = Options(3, 2.0, 0.5, 0.75), numbers.word()
            off = abs(sums.exact(name, PERLIN, Knobs("lattice"), sums.in_cell(cell, f), *arguments) -
                      sums.fixed(name, PERLIN, Knobs("lattice"), sums.fixed_in_cell(cell, f), *arguments))
            self.assertLess(off, 2**-13, name)

    def test_a_period_that_is_no_power_of_two_ends_where_a_cell_fits_no_int(self) -> None:
        def repeats(period: int, x: float, octaves: int, lacunarity: float = 3.0) -> bool:
            options = Options(octaves, lacunarity, 1.0)
            one, other = (fixed("fbm", Knobs("lattice"), (at, 7.75), options, 3, (period, period))
                          for at in (x, x + period))
            return one == other

        # 48 * 3^16 = 2066242608 is below 2^31, and with the position of the last octave it is or is not.
        for x, octaves, whole in ((-49.0, 17, True), (1.0, 17, True), (2.0, 17, False)):
            self.assertEqual(repeats(48, x, octaves), whole, (x, octaves))
        # Powers of two repeat up to the octave whose period is 2^31.
        for octaves in (17, 25):
            self.assertTrue(repeats(64, 2.0, octaves, 2.0), octaves)

    def test_periods_keep_their_low_bits(self) -> None:
        # 2^30 * 2 is -2^31, which is none; twice that is 0. 3 * 2^29 * 3 is 2^29 modulo 2^32, a period again.
        self.assertEqual([sums.wrapped(2**30 * 2), sums.wrapped(-2**31 * 2), sums.wrapped(3 * 2**29 * 3)],
                         [-2**31, 0, 2**29])
        found = [tuple(periods) for _, periods, _ in sums.fixed_octaves_of(
            sums.fixed_at_position((0.5, 0.5)), Options(4, 3.9, 0.5), 3, (3 * 2**29, -5))]
        self.assertEqual(found, [(3 * 2**29, -5), (2**29, -15), (3 * 2**29, -45), (2**29, -135)])

    def test_seeds_step(self) -> None:
        found = [seed for _, _, seed in sums.fixed_octaves_of([(0, 0)], Options(3, 2.0, 0.5), 0xFFFFFFFF, (0,))]
        self.assertEqual(found, [0xFFFFFFFF, 0x9E3779B8, 0x3C6EF371])

    def test_what_is_no_number_has_no_value(self) -> None:
        for no_number in (float("nan"), float("inf")):
            for p, lacunarity, gain in (((no_number, 0.5), 2.0, 0.5), ((0.25, 0.5), no_number, 0.5),
                                        ((0.25, 0.5), 2.0, no_number)):
                for name, function in itertools.product(sums.SUMS, (exact, fixed)):
                    with self.assertRaises((ValueError, OverflowError)):
                        function(name, Knobs("lattice"), p, Options(2, lacunarity, gain), 3)
