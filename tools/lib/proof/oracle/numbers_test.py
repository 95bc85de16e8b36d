"""Tests of numbers.py: by hand, and the distributions that the contract promises."""

from __future__ import annotations

import itertools
import math
import unittest
from collections import Counter
from collections.abc import Callable, Iterable
from fractions import Fraction
from unittest import mock

from base.thorough import in_thorough_runs
from proof.golden.generator import generator_of, to_f32
from proof.oracle import gradients, numbers, words
from proof.oracle.testing import LIMIT, equal_chances, unevenness

Shuffle = Callable[[int, int, int], int]
Point = Callable[[int], tuple[float, ...]]


def some_words(name: str, count: int) -> list[int]:
    draws = generator_of(name)
    return [0, 1, 2**31, words.MASK] + [draws.word() for _ in range(count)]


SAMPLE = some_words("numbers", 2**14)


class FurtherWords(unittest.TestCase):
    def test_by_hand(self) -> None:
        for h, k, argument in ((5, 0, 5), (5, 1, 0x9E3779BE), (0x80000000, 2, 0xBC6EF372), (0, 0xFFFFFFFF, 0x61C88647),
                               (words.MASK, 1, 0x9E3779B8)):
            self.assertEqual(numbers.rehash(h, k), words.mix(argument))

    def test_unorms(self) -> None:
        for h in SAMPLE[:100]:
            four = tuple((word >> 8) / 2**24 for word in (h, *(numbers.rehash(h, k) for k in (1, 2, 3))))
            self.assertEqual([numbers.unorms(h, count) for count in (2, 3, 4)], [four[:2], four[:3], four])

    def test_they_are_independent_of_each_other(self) -> None:
        cells = equal_chances(itertools.product(range(4), repeat=4))
        self.assertLess(unevenness((tuple(int(4 * u) for u in numbers.unorms(h, 4)) for h in SAMPLE), cells), LIMIT)


def sums_of_three() -> list[int]:
    """How often each sum of three numbers of ten bits comes."""
    counts = [1]
    for _ in range(3):
        # Each count is the sum of the last 1024 of those before.
        sums = list(itertools.accumulate(counts + [0] * 1023))
        counts = [sums[i] - (sums[i - 1024] if i >= 1024 else 0) for i in range(len(sums))]
    return counts


def normal_counts() -> dict[int, int]:
    """How often each N comes, of 2^93 equally likely cases: 63 coins and thirty bits."""
    counts: Counter[int] = Counter()
    for coins, (total, count) in itertools.product(range(64), enumerate(sums_of_three())):
        counts[numbers.gaussian_of(coins, total)] += math.comb(63, coins) * count
    return dict(sorted(counts.items()))


class Normal(unittest.TestCase):
    COUNTS = normal_counts()
    CASES = 2**93

    def moment(self, power: int) -> Fraction:
        return Fraction(sum(n**power * count for n, count in self.COUNTS.items()), self.CASES * 2**(13 * power))

    def test_every_case_is_counted(self) -> None:
        self.assertEqual(sum(self.COUNTS.values()), self.CASES)
        self.assertEqual(sums_of_three()[:3] + sums_of_three()[-2:], [1, 3, 6, 3, 1])

    def test_numbers_are_odd_and_symmetric(self) -> None:
        self.assertEqual((min(self.COUNTS), max(self.COUNTS)), (-67581, 67581))
        self.assertTrue(all(n % 2 == 1 for n in self.COUNTS))
        self.assertEqual(self.COUNTS, {-n: count for n, count in self.COUNTS.items()})

    def test_mean_and_variance(self) -> None:
        # A uniform number of 1024 steps lacks 2^-20 of the variance of a continuous one.
        self.assertEqual((self.moment(1), self.moment(2)), (0, 1 - Fraction(1, 2**26)))
        # Of coins alone the excess would be -2 / 63.
        self.assertAlmostEqual(float(self.moment(4) / self.moment(2)**2 - 3), -0.03086, delta=1e-5)

    def test_distance_from_the_normal_distribution(self) -> None:
        below, distance = 0, 0.0
        for n, count in self.COUNTS.items():
            normal = (1 + math.erf(n / 8192 / math.sqrt(2))) / 2
            distance = max(distance, abs(below / self.CASES - normal), abs((below + count) / self.CASES - normal))
            below += count
        self.assertTrue(0.00074 < distance < 0.00075, distance)

    def test_by_hand(self) -> None:
        for h in SAMPLE[:100]:
            first, second = (f"{words.mix(h + k * 0x9E3779B9 & words.MASK):032b}" for k in (1, 2))
            coins = (first + second[:-1]).count("1")
            total = h % 1024 + h // 1024 % 1024 + h // 2**20 % 1024
            self.assertEqual(numbers.gaussian(h) * 8192, 2048 * coins + 2 * total - 67581)
            self.assertEqual(to_f32(numbers.gaussian(h)), numbers.gaussian(h))

    def test_words_have_this_distribution(self) -> None:
        # In slices of about a 24th.
        chances: Counter[int] = Counter()
        slice_of, below = {}, 0
        for n, count in self.COUNTS.items():
            slice_of[n] = 24 * below // self.CASES
            chances[slice_of[n]] += count / self.CASES
            below += count
        found = [round(8192 * numbers.gaussian(h)) for h in SAMPLE]
        self.assertLess(unevenness((slice_of[n] for n in found), chances), LIMIT)
        # With a coin less it is not.
        self.assertGreater(unevenness((slice_of[n - 2048 * (numbers.rehash(n, 1) & 1)] for n in found), chances), LIMIT)


def lengths(point: Point, sample: Iterable[int]) -> tuple[float, float]:
    """The shortest and the longest."""
    found = [math.hypot(*point(h)) for h in sample]
    return min(found), max(found)


class Directions(unittest.TestCase):
    def test_circle_by_hand(self) -> None:
        # The sine of a quarter turn is 65535 / 65536.
        one = 65535 / 65536
        self.assertEqual([numbers.circle(h) for h in (0, 2**30, 2**31, 3 * 2**30)],
                         [(one, 0), (0, one), (-one, 0), (0, -one)])
        self.assertEqual(numbers.circle(0x20000000), (46341 / 65536,) * 2)

    def test_circle_is_the_angle(self) -> None:
        for h in SAMPLE[:2000]:
            turns = Fraction(h, 2**32)
            exact = (gradients.sine_of_turns(turns + Fraction(1, 4)), gradients.sine_of_turns(turns))
            for found, component in zip(numbers.circle(h), exact):
                self.assertLess(abs(found - component), 2**-14)

    def test_circle_has_nearly_unit_vectors(self) -> None:
        shortest, longest = lengths(numbers.circle, SAMPLE)
        self.assertTrue(1 - 3.63e-5 < shortest < 1 - 3e-5 and 1 + 2.9e-5 < longest < 1 + 3.86e-5, (shortest, longest))

    def test_sphere_has_nearly_unit_vectors(self) -> None:
        shortest, longest = lengths(numbers.sphere, SAMPLE)
        self.assertTrue(1 - 7.5e-5 < shortest < 1 - 6e-5 and 1 + 3e-5 < longest < 1 + 4.3e-5, (shortest, longest))

    def test_sphere_by_hand(self) -> None:
        for h in SAMPLE[:1000]:
            x, y, z = (65536 * component for component in numbers.sphere(h))
            self.assertEqual(z, (numbers.rehash(h, 1) // 65536) * 2 - 65535)
            for component, unit in zip((x, y), numbers.circle(h)):
                self.assertEqual(component, math.floor(65536 * unit * numbers.radius(int(z)) / 2**15))

    def test_radius(self) -> None:
        # It is nearly the root: a unit of it is two of Z. Only at four heights it shows that the square is cut before.
        lower = []
        for z in range(-65535, 65536, 2):
            squared = 2**32 - z * z
            r = numbers.radius(z)
            self.assertEqual(r, math.isqrt(squared // 16 * 256) // 8)
            self.assertTrue(r < 2**15 and 4 * r * r <= squared < (2 * r + 2.25)**2 + 16)
            lower += [z] * (math.isqrt(squared) // 2 - r)
        self.assertEqual(lower, [-20757, -14187, 14187, 20757])

    def test_sphere_is_uniform(self) -> None:
        # Seen along each axis: the parts of a sphere between equally distant planes are equally large.
        for axis in range(3):
            self.assertLess(self.unevenness_along(numbers.sphere, axis), LIMIT)

    def unevenness_along(self, point: Point, axis: int) -> float:
        return unevenness((math.floor(8 * min(point(h)[axis], 0.99999)) for h in SAMPLE), equal_chances(range(-8, 8)))

    def test_a_cone_would_not_be_uniform(self) -> None:
        def on_a_cone(h: int) -> tuple[float, ...]:
            (c, s), z = numbers.circle(h), numbers.sphere(h)[2]
            return c * (1 - abs(z)), s * (1 - abs(z)), z

        self.assertGreater(self.unevenness_along(on_a_cone, 0), LIMIT)


def every_vector_of_the_circle() -> set[tuple[int, int]]:
    """The sine takes an angle in units of 2^-16 of a quarter, rounded: in between, and at a tie and its neighbours."""
    return {numbers.circle_units(k * 2**14 + part & words.MASK)
            for k in range(2**18) for part in (-2**13 - 1, -2**13, -2**13 + 1, 0)}


class Filled(unittest.TestCase):
    """The disk and the ball."""

    def test_by_hand(self) -> None:
        for h in SAMPLE[:1000]:
            r = [numbers.rehash(h, k) // 2**17 for k in range(5)]
            for point, of, u in ((numbers.disk, numbers.circle, max(r[1:3])),
                                 (numbers.ball, numbers.sphere, max(r[2:]))):
                self.assertEqual(point(h), tuple(math.floor(x * 65536 * u / 2**15) / 65536 for x in of(h)))

    def test_products_fit_signed_integers(self) -> None:
        numbers.shortened((65536, -65536), 32767)
        with self.assertRaises(OverflowError):
            numbers.shortened((65536,), 32768)

    def unevenness_of_shells(self, point: Point, dimensions: int) -> float:
        """Over sixteen rings of the disk, or shells of the ball, of equal size."""
        return unevenness((min(int(16 * math.hypot(*point(h))**dimensions), 15) for h in SAMPLE),
                          equal_chances(range(16)))

    def test_uniform_from_the_centre_out(self) -> None:
        self.assertLess(self.unevenness_of_shells(numbers.disk, 2), LIMIT)
        self.assertLess(self.unevenness_of_shells(numbers.ball, 3), LIMIT)

    def test_with_a_number_less_they_are_not(self) -> None:
        def short(units: Callable[[int], tuple[int, ...]], further: tuple[int, ...]) -> Point:
            return lambda h: numbers.in_units(numbers.shortened(units(h), numbers.largest(h, further)))

        self.assertGreater(self.unevenness_of_shells(short(numbers.circle_units, (1,)), 2), LIMIT)
        self.assertGreater(self.unevenness_of_shells(short(numbers.sphere_units, (2, 3)), 3), LIMIT)

    def test_uniform_around_and_from_the_centre_out(self) -> None:
        def sector(h: int) -> tuple[int, int]:
            x, y = numbers.disk(h)
            return int(4 * math.hypot(x, y)**2), math.floor(math.atan2(y, x) / math.pi * 3.99999)

        cells = equal_chances(itertools.product(range(4), range(-4, 4)))
        self.assertLess(unevenness(map(sector, SAMPLE), cells), LIMIT)

        def octant(h: int) -> tuple[int, ...]:
            return int(2 * min(math.hypot(*numbers.ball(h)), 0.99999)**3), *(x < 0 for x in numbers.ball(h))

        cells = equal_chances(itertools.product(range(2), *[(False, True)] * 3))
        self.assertLess(unevenness(map(octant, SAMPLE), cells), LIMIT)

    def test_the_largest_number_can_lead_just_beyond(self) -> None:
        # Negative products are rounded down. On the disk the length is below 1 with any U below the largest.
        for h, point, excess in ((0xB7EA4A68, numbers.disk, 1.75e-5), (0xAF91816F, numbers.ball, 2.85e-5)):
            self.assertTrue(excess - 1e-6 < math.hypot(*point(h)) - 1 < excess)

    @in_thorough_runs
    def test_no_further_than_that(self) -> None:
        vectors = every_vector_of_the_circle()
        shortest, longest = lengths(lambda v: v, vectors)
        self.assertTrue(65536 * (1 - 3.63e-5) < shortest < longest < 65536 * (1 + 3.86e-5))
        for u, least, most in ((32767, 2.2e-5, 2.3e-5), (32766, -1e-5, 0)):
            _, longest = lengths(lambda v: numbers.shortened(v, u), vectors)
            self.assertTrue(least < longest / 65536 - 1 < most, (u, longest / 65536 - 1))


def permutation(shuffle: Shuffle, n: int, seed: int) -> tuple[int, ...]:
    return tuple(shuffle(i, n, seed) for i in range(n))


def permutes(shuffle: Shuffle, n: int, seed: int) -> bool:
    return sorted(permutation(shuffle, n, seed)) == list(range(n))


def unshuffle(value: int, n: int, seed: int) -> int:
    """The i that hn_shuffle takes to the value: the ten rounds from the last to the first."""
    b = (n - 1).bit_length()
    s = words.mix(seed)
    while True:
        for k in range(10, 0, -1):
            a = words.mix((s + k * 0x9E3779B9) % 2**32)
            y = (value - a // 65536) * pow(a | 1, -1, 2**b) % 2**b
            d = 1 if k in (1, 3, 5, 7, 9) else (b + 1) // 2
            value = 0
            for shift in range(0, b, d):
                value ^= y >> shift
        if value < n:
            return value


class Shuffles(unittest.TestCase):
    SEEDS = (0, 1, 0x9E3779B9, words.MASK)
    LARGE = (2**31, 2**31 - 1, 2**30 + 1, 10**9, 65537, 65536)

    def test_is_a_permutation(self) -> None:
        for n in (*range(1, 41), 63, 64, 65, 100, 256, 257, 1000, 4097):
            for seed in self.SEEDS:
                self.assertTrue(permutes(numbers.shuffle, n, seed), (n, seed))

    def test_a_step_modulo_n_is_none(self) -> None:
        def reduced(i: int, n: int, seed: int) -> int:
            return numbers.shuffle_step(i, 2**(n - 1).bit_length() - 1, seed) % n

        self.assertTrue(permutes(reduced, 16, 0))
        self.assertFalse(any(permutes(reduced, n, seed) for n in (11, 21, 37) for seed in range(20)))

    def test_of_two_by_hand(self) -> None:
        # Modulo 2 a round adds bit 16 of a_k, and nothing else.
        for seed in range(100):
            s = words.mix(seed)
            swap = sum(words.mix(s + k * 0x9E3779B9 & words.MASK) >> 16 & 1 for k in range(1, 11)) % 2
            self.assertEqual(permutation(numbers.shuffle, 2, seed), (swap, 1 - swap))

    def lost(self) -> list[tuple[int, int, int]]:
        """The points that do not come back by the rounds in reverse: (i, n, seed)."""
        draws = generator_of("shuffle")
        rows = [(draws.integer(0, n - 1), n, draws.seed()) for n in (*self.LARGE, *range(2, 40)) for _ in range(10)]
        return [row for row in rows if unshuffle(numbers.shuffle(*row), *row[1:]) != row[0]]

    def test_comes_back_by_the_rounds_in_reverse(self) -> None:
        self.assertEqual(self.lost(), [])

    def test_a_round_left_out_would_show(self) -> None:
        # It is still a permutation.
        with mock.patch.object(numbers, "ROUNDS", 9):
            self.assertTrue(permutes(numbers.shuffle, 100, 3))
            self.assertGreater(len(self.lost()), 200)

    def test_beyond_n_and_at_the_ends(self) -> None:
        for n, seed in itertools.product((1, 2, 5, 64, 1000), self.SEEDS):
            for i in (n, n + 3, words.MASK):
                self.assertEqual(numbers.shuffle(i, n, seed), numbers.shuffle(i % n, n, seed))
        for i, n in itertools.product((0, 1, 7, words.MASK), (0, 1)):
            self.assertEqual(numbers.shuffle(i, n, 5), 0)
        for n in (2**31 + 1, words.MASK):
            self.assertLess(numbers.shuffle(7, n, 5), n)

    def unevenness_of_permutations(self, n: int) -> float:
        cells = equal_chances(itertools.permutations(range(n)))
        return unevenness((permutation(numbers.shuffle, n, seed) for seed in range(100 * len(cells))), cells)

    def test_every_permutation_comes_as_often(self) -> None:
        for n in (3, 4, 5):
            self.assertLess(self.unevenness_of_permutations(n), LIMIT)

    def test_with_few_rounds_it_does_not(self) -> None:
        with mock.patch.object(numbers, "ROUNDS", 3):
            self.assertGreater(self.unevenness_of_permutations(4), LIMIT)

    def test_pairs_go_everywhere(self) -> None:
        for n in (7, 16):
            cells = equal_chances(itertools.permutations(range(n), 2))
            found = [(numbers.shuffle(0, n, seed), numbers.shuffle(1, n, seed)) for seed in range(40 * len(cells))]
            self.assertLess(unevenness(found, cells), LIMIT)


def is_a_net(points: list[tuple[float, ...]]) -> bool:
    """Whether 2^m points have one in each of the 2^m boxes, however those are divided: a (0, m, 2)-net in base 2."""
    m = len(points).bit_length() - 1
    return all(len({(int(x * 2**k), int(y * 2**(m - k))) for x, y in points}) == 2**m for k in range(m + 1))


class Sobol(unittest.TestCase):
    SEEDS = (0, 1, 0xDEADBEEF, words.MASK)

    def test_without_the_scrambling_it_is_the_published_sequence(self) -> None:
        # The first two dimensions of Joe and Kuo's tables, in the order of i.
        points = [(numbers.reversed_bits(i) / 2**32, numbers.reversed_bits(numbers.second_axis(i)) / 2**32)
                  for i in range(16)]
        expected = [(0, 0), (8, 8), (4, 12), (12, 4), (2, 10), (10, 2), (6, 6), (14, 14),
                    (1, 15), (9, 7), (5, 3), (13, 11), (3, 5), (11, 13), (7, 9), (15, 1)]
        self.assertEqual(points, [(x / 16, y / 16) for x, y in expected])

    def test_second_axis_is_by_pascals_triangle(self) -> None:
        # v_k is (1 + t)^k modulo 2.
        for k in (0, 1, 2, 5, 16, 31):
            expected = sum(math.comb(k, j) % 2 << j for j in range(k + 1))
            self.assertEqual(numbers.second_axis(1 << k), expected)
        for i in SAMPLE[:50]:
            self.assertEqual(numbers.second_axis(i), numbers.second_axis(i & 0xFFFF) ^ numbers.second_axis(i & ~0xFFFF))

    def test_scrambling_keeps_which_low_bits_are_shared(self) -> None:
        draws = generator_of("scramble")
        for _ in range(300):
            bits, x, s = draws.integer(0, 31), draws.word(), draws.seed()
            y = x ^ 1 << bits ^ (draws.word() << bits + 1 & words.MASK)
            difference = numbers.scramble(x, s) ^ numbers.scramble(y, s)
            self.assertEqual(difference & -difference, 1 << bits)

    def test_scrambling_comes_back_by_its_steps_in_reverse(self) -> None:
        def undone(y: int, factor: int) -> int:
            """The x whose x ^ x * factor is y: the factor is even, so that its bits follow from the lowest on."""
            x = 0
            for k in range(32):
                x |= (y ^ x * factor) & 1 << k
            return x

        draws = generator_of("unscramble")
        for _ in range(200):
            x, s = draws.word(), draws.seed()
            y = undone(undone(numbers.scramble(x, s), 0x53A22864), 0x05526C56)
            y = (y * pow(s // 65536 | 1, -1, 2**32) - s) % 2**32
            self.assertEqual(undone(y, 0x3D20ADEA), x)

    def test_points_by_hand(self) -> None:
        for i, seed in itertools.product((0, 1, 6, words.MASK), self.SEEDS):
            s = words.mix(seed)
            third, *others = (words.mix(s + k * 0x9E3779B9 & words.MASK) for k in (3, 1, 2))
            j = int(f"{numbers.scramble(int(f'{i:032b}'[::-1], 2), third):032b}"[::-1], 2)
            x, y = map(numbers.scramble, (j, numbers.second_axis(j)), others)
            # The high 24 bits of the reversed word are the low ones.
            expected = tuple(sum((word >> k & 1) / 2**(k + 1) for k in range(24)) for word in (x, y))
            self.assertEqual(numbers.sobol(i, seed), expected)

    def net(self, m: int, start: int, seed: int) -> list[tuple[float, ...]]:
        return [numbers.sobol(start + i, seed) for i in range(2**m)]

    def test_powers_of_two_are_nets(self) -> None:
        for m, seed in itertools.product(range(9), self.SEEDS):
            for block in (0, 1, 2**(32 - m) - 1):
                self.assertTrue(is_a_net(self.net(m, block << m, seed)), (m, block, seed))

    @in_thorough_runs
    def test_a_large_net(self) -> None:
        self.assertTrue(is_a_net(self.net(16, 5 << 16, 7)))

    def test_what_is_no_net(self) -> None:
        self.assertFalse(is_a_net(self.net(4, 0, 3)[:-1] + [numbers.sobol(16, 3)]))
        with mock.patch.object(numbers, "second_axis", lambda j: j):
            self.assertFalse(is_a_net(self.net(3, 0, 3)))
        with mock.patch.object(numbers, "order", numbers.scramble):
            self.assertFalse(is_a_net(self.net(4, 0, 3)))
        with mock.patch.object(numbers, "reversed_bits", lambda word: word):
            self.assertFalse(is_a_net(self.net(4, 0, 3)))

    def test_another_order_in_each_power_of_two_of_points(self) -> None:
        for bits, block, s in itertools.product((0, 1, 6), (0, 1, 37), (0, 5, words.MASK)):
            found = [numbers.order(block << bits | i, s) for i in range(2**bits)]
            self.assertEqual(sorted(found), [found[0] >> bits << bits | i for i in range(2**bits)])

    def pairs_of(self, seeds: tuple[int, int]) -> list[list[bool]]:
        """In which halves of the axes point i of one sequence is, and of another."""
        return [[x >= 0.5 for seed in seeds for x in numbers.sobol(i, seed)] for i in range(2000)]

    def test_two_sequences_are_independent_of_each_other(self) -> None:
        cells = equal_chances(itertools.product((False, True), repeat=4))
        for seeds in ((0, 1), (1, 0x9E3779BA), (5, 1000)):
            found = self.pairs_of(seeds)
            self.assertLess(unevenness(map(tuple, found), cells), LIMIT)
            self.assertAlmostEqual(sum(a and b for a, _, b, _ in found) / len(found), 1 / 4, delta=0.03)

    def test_with_points_in_one_order_they_are_not(self) -> None:
        with mock.patch.object(numbers, "order", lambda i, s: i):
            found = self.pairs_of((0, 1))
        self.assertIn(sum(a and b for a, _, b, _ in found) / len(found), (0, 1 / 2))

    def test_seeds_move_points_everywhere(self) -> None:
        cells = equal_chances(itertools.product(range(8), repeat=2))
        for i in (0, 5):
            found = [tuple(int(8 * x) for x in numbers.sobol(i, seed)) for seed in range(4000)]
            self.assertLess(unevenness(found, cells), LIMIT)
