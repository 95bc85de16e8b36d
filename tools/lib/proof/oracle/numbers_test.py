"""Tests of numbers.py: the formulas of the contract written another way, and published points."""

from __future__ import annotations

import itertools
import math
import unittest

from proof.golden.generator import generator_of
from proof.oracle import hashes, numbers

DRAWS = generator_of("numbers")
SAMPLE = [0, 1, 2**31, hashes.MASK] + [DRAWS.word() for _ in range(200)]
SEEDS = (0, 1, 0xDEADBEEF, hashes.MASK)


def further(h: int, k: int) -> int:
    return hashes.mix((h + k * 0x9E3779B9) % 2**32)


class FromAWord(unittest.TestCase):
    """A wrong constant, bit or order in a number, a direction or a point from a word."""

    def test_numbers(self) -> None:
        for h in SAMPLE:
            four = tuple((word >> 8) / 2**24 for word in (h, *(further(h, k) for k in (1, 2, 3))))
            self.assertEqual([numbers.unorms(h, count) for count in (2, 3, 4)], [four[:2], four[:3], four])
            first, second = (f"{further(h, k):032b}" for k in (1, 2))
            total = h % 1024 + h // 1024 % 1024 + h // 2**20 % 1024
            self.assertEqual(numbers.gaussian(h) * 8192, 2048 * (first + second[:-1]).count("1") + 2 * total - 67581)

    def test_circle(self) -> None:
        # The sine of a quarter turn is 65535 / 65536.
        one = 65535 / 65536
        self.assertEqual([numbers.circle(h) for h in (0, 2**30, 2**31, 3 * 2**30, 2**29)],
                         [(one, 0), (0, one), (-one, 0), (0, -one), (46341 / 65536,) * 2])

    def test_sphere_and_what_is_filled(self) -> None:
        for h in SAMPLE:
            x, y, z = (65536 * component for component in numbers.sphere(h))
            self.assertEqual(z, (further(h, 1) // 65536) * 2 - 65535)
            radius = math.isqrt((2**32 - int(z)**2) // 16 * 256) // 8
            for component, unit in zip((x, y), numbers.circle(h)):
                self.assertEqual(component, math.floor(65536 * unit * radius / 2**15))
            r = [further(h, k) // 2**17 for k in range(5)]
            for point, of, u in ((numbers.disk, numbers.circle, max(r[1:3])),
                                 (numbers.ball, numbers.sphere, max(r[2:]))):
                self.assertEqual(point(h), tuple(math.floor(x * 65536 * u / 2**15) / 65536 for x in of(h)))

    def test_radius(self) -> None:
        # It is nearly the root. Only at four heights it shows that the square is cut before.
        lower = [z for z in range(-65535, 65536, 2) if math.isqrt(2**32 - z * z) // 2 > numbers.radius(z)]
        self.assertEqual(lower, [-20757, -14187, 14187, 20757])


class Shuffles(unittest.TestCase):
    """A step of the shuffle that is wrong or left out, though the result may still be a permutation."""

    def test_beyond_n_and_at_the_ends(self) -> None:
        for n, i in itertools.product((2, 5, 64, 1000), (3, 1000, hashes.MASK)):
            self.assertEqual(numbers.shuffle(i, n, 7), numbers.shuffle(i % n, n, 7))
        self.assertEqual([numbers.shuffle(i, n, 5) for i in (0, 1, hashes.MASK) for n in (0, 1)], [0] * 6)
        for n in (2**31 + 1, hashes.MASK):
            self.assertLess(numbers.shuffle(7, n, 5), n)


class Sobol(unittest.TestCase):
    """Points of another sequence, or points that are scrambled in another way or in another order."""

    def test_without_the_scrambling_it_is_the_published_sequence(self) -> None:
        # The first two dimensions of Joe and Kuo's tables, in the order of i.
        points = [(numbers.reversed_bits(i) / 2**28, numbers.reversed_bits(numbers.second_axis(i)) / 2**28)
                  for i in range(16)]
        self.assertEqual(points, [(0, 0), (8, 8), (4, 12), (12, 4), (2, 10), (10, 2), (6, 6), (14, 14),
                                  (1, 15), (9, 7), (5, 3), (13, 11), (3, 5), (11, 13), (7, 9), (15, 1)])
        # Of the k-th bit it is (1 + t)^k modulo 2.
        for k in (5, 16, 31):
            self.assertEqual(numbers.second_axis(1 << k), sum(math.comb(k, j) % 2 << j for j in range(k + 1)))

    def test_points(self) -> None:
        for i, seed in itertools.product((0, 1, 6, hashes.MASK), SEEDS):
            third, *others = (further(hashes.mix(seed), k) for k in (3, 1, 2))
            j = int(f"{numbers.scramble(int(f'{i:032b}'[::-1], 2), third):032b}"[::-1], 2)
            x, y = map(numbers.scramble, (j, numbers.second_axis(j)), others)
            # The high 24 bits of the reversed word are the low ones.
            self.assertEqual(numbers.sobol(i, seed),
                             tuple(sum((word >> k & 1) / 2**(k + 1) for k in range(24)) for word in (x, y)))

    def test_powers_of_two_are_nets(self) -> None:
        """However the square is divided into 2^m boxes, each has a point. Nothing else tests this promise."""
        for m, seed in itertools.product((3, 6), SEEDS):
            for block in (0, 1, 2**(32 - m) - 1):
                points = [numbers.sobol((block << m) + i, seed) for i in range(2**m)]
                for k in range(m + 1):
                    self.assertEqual(len({(int(x * 2**k), int(y * 2**(m - k))) for x, y in points}), 2**m)
