"""Tests of kernels.py: which points count, their words, and what the contract promises of the noises above them."""

from __future__ import annotations

import itertools
import unittest
from collections.abc import Callable, Iterator
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, generator_of
from proof.oracle import kernels, noises, words
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT
from proof.oracle.kernels import Kernel
from proof.oracle.lattice import Lattice
from proof.oracle.noises import simplex, simplex_smooth

KNOBS = Knobs("lattice")
# Each noise with each of its kernels.
KERNELS = [(name, n, kernel) for name, of in (("simplex", simplex), ("simplex_smooth", simplex_smooth))
           for n, kernel in of.KERNELS.items()]


def fractions(n: int, count: int) -> Iterator[tuple[Fraction, ...]]:
    numbers = generator_of(f"kernels{n}")
    for _ in range(count):
        yield tuple(Fraction(numbers.integer(0, UNIT), UNIT) for _ in range(n))


class Points(unittest.TestCase):
    def test_no_point_is_farther_away(self) -> None:
        for _, n, kernel in KERNELS:
            for f in [(Fraction(0),) * n, (Fraction(1),) * n, *fractions(n, 20)]:
                position, step = [int(kernel.steps * x * UNIT) for x in f], UNIT
                found = kernels.points(kernel, position, step)
                with mock.patch.object(kernels, "AROUND", 4 if n < 4 else 3):
                    self.assertEqual(set(found), set(kernels.points(kernel, position, step)))
                with mock.patch.object(kernels, "AROUND", 1):
                    self.assertEqual(set(found), set(kernels.points(kernel, position, step)))

    def test_triangles_by_hand(self) -> None:
        # The middle between the points (0, 0) and (1, 0), below the one of the next row, (0, 1), which is at 1/2, too.
        found = kernels.points(simplex.KERNELS[2], (2**9, 0), 2**10)
        self.assertEqual({point.numbers: point.offset for point in found}, {(0, 0): (512, 0), (1, 0): (-512, 0)})
        found = kernels.points(simplex.KERNELS[2], (2**9, 2**9), 2**10)
        self.assertEqual({point.numbers: point.offset for point in found},
                         {(0, 0): (512, 512), (1, 0): (-512, 512), (0, 1): (0, -512)})
        found = kernels.points(simplex.KERNELS[2], (0, 2**10), 2**10)
        self.assertEqual({point.numbers: point.offset for point in found}, {(-1, 1): (512, 0), (0, 1): (-512, 0)})

    def test_centred_by_hand(self) -> None:
        found = kernels.points(simplex.KERNELS[3], (2**8, 2**8, 0), 2**10)
        self.assertEqual({(point.numbers, point.centre): point.offset for point in found}, {
            ((0, 0, 0), False): (256, 256, 0), ((0, 0, 0), True): (-256, -256, -512),
            ((0, 0, -1), True): (-256, -256, 512)})

    def test_a_point_at_the_end_does_not_count(self) -> None:
        # In space the corner is half of the diagonal of a face away.
        for shift, counts in ((0, False), (-1, True)):
            found = kernels.points(simplex.KERNELS[3], (2**9 + shift, 2**9, 0), 2**10)
            self.assertEqual(any(point.numbers == (0, 0, 0) and not point.centre for point in found), counts)


class Weights(unittest.TestCase):
    def test_by_hand(self) -> None:
        half = Fraction(1, 2)
        for weight, value, slope in (
                (kernels.QUARTIC, Fraction(1, 4), Fraction(5, 4)), (kernels.CUBE, half**3, 3 * half**2),
                (kernels.FOURTH, half**4, 4 * half**3), (kernels.FIFTH, 4 * half**5, 20 * half**4),
                (kernels.PLANE_EVEN, Fraction(19, 32), Fraction(27, 16)),
                (kernels.SPACE_EVEN, Fraction(19, 32), Fraction(27, 16))):
            self.assertEqual((weight.exact(half), weight.slope(half)), (value, slope))

    def test_fixed_by_hand(self) -> None:
        # t is 2^15, and its square 2^14.
        for weight, value, fall in ((kernels.QUARTIC, 2**16, 5 * 2**14),
                                    (kernels.CUBE, 2**15, 6 * 2**14), (kernels.FOURTH, 2**14, 2**16),
                                    (kernels.PLANE_EVEN, 19 * 2**13, 27 * 2**12),
                                    (kernels.SPACE_EVEN, 19 * 2**13, 27 * 2**13)):
            self.assertEqual((weight.of_square(2**15, 2**14), weight.fall(2**15, 2**14)), (value, fall))
        self.assertEqual(kernels.FIFTH.of_square(2**15, 2**14), 2**15)

    def test_all_fixed_ones(self) -> None:
        # A half of a unit at Q, times at most 4 to W, and what t and W round.
        for name, n, kernel in KERNELS:
            for t in (*range(0, kernel.r * 64 - 1, 37), min(kernel.r * 64, 65535)):
                q = t * t + 2**15 >> 16
                x = Fraction(t, 2**16)
                self.assertLess(abs(kernel.weight.of_square(t, q) - kernel.weight.exact(x) * 2**18), 16, (name, n, t))
                if name == "simplex":
                    # E is m times the slope, in units of 2^-16.
                    exact = kernel.m * kernel.weight.slope(x) * 2**16
                    self.assertLess(abs(kernel.weight.fall(t, q) - exact), 14, (n, t))

    def test_what_t_is(self) -> None:
        # At the point, a quarter of a step away, at the end and beyond; in units of 2^-16.
        for kernel, expected in ((simplex.KERNELS[2], (52416, 48320, 0)), (simplex.KERNELS[3], (65535, 57344, 0)),
                                 (simplex_smooth.KERNELS[3], (49152, 45056, 0))):
            end = kernel.r * 2**30 // kernel.m
            self.assertEqual(tuple(kernels.fixed_t(kernel, square)[0] for square in (0, 2**36, end)), expected)
            self.assertEqual(kernels.fixed_t(kernel, end + 2**36), (0, 0))


class Words(unittest.TestCase):
    def word(self, kernel: Kernel, numbers: tuple[int, ...], cell: tuple[int, ...], centre: bool = False,
             periods: tuple[int, ...] = ()) -> int:
        point = kernels.Point(numbers, centre, (0,) * len(cell))
        return point.word(kernel, Lattice(Knobs("pcg"), 7, periods), cell)

    def test_of_triangles(self) -> None:
        kernel = simplex.KERNELS[2]
        self.assertEqual(self.word(kernel, (1, -1), (5, -6)), words.point_word("pcg", (11, -13), 7))
        # Twice the period: 2 * 3 along x; none along y.
        self.assertEqual(self.word(kernel, (1, -1), (-5, -6), periods=(3, 0)), words.point_word("pcg", (3, -13), 7))
        # 2 * INT_MAX + 2 is 2^32, which wraps; with the largest period it is 2.
        self.assertEqual(self.word(kernel, (2, 0), (INT_MAX, 5)), words.point_word("pcg", (0, 10), 7))
        self.assertEqual(self.word(kernel, (2, 0), (INT_MAX, 5), periods=(INT_MAX,) * 2),
                         words.point_word("pcg", (2, 10), 7))
        self.assertEqual(self.word(kernel, (-1, 0), (0, 5), periods=(INT_MAX,) * 2),
                         words.point_word("pcg", (2**32 - 3, 10), 7))

    def test_of_centres(self) -> None:
        # By the contract's formula. x' of 5, y' of -6 and z' of 7; h' is fixed.
        x, y, z = words.spread((5, -6, 7))
        h, s = 0x165667B1, words.mix(7)
        j = x >> 12 ^ y >> 11 ^ z >> 10 ^ h >> 8 ^ s >> 8
        a = x + y % 2**24 * 0xE6133E + z % 2**24 * 0x913FDC + h + s
        product = (words.pcg(j) * ((2 * a + 1) * 4097 % 2**24) + j) % 2**32
        expected = product ^ product >> 9
        self.assertEqual(self.word(simplex.KERNELS[3], (1, 0, -1), (4, -6, 8), True), expected)
        self.assertEqual(self.word(simplex.KERNELS[3], (1, 0, -1), (4, -6, 8), True, (100, -100, 0)),
                         words.point_word("pcg", (5, -6, 7), 7, True))
        self.assertEqual(self.word(simplex.KERNELS[3], (1, 0, -1), (4, -6, 8), True, (3, 5, 7)),
                         words.point_word("pcg", (2, 4, 0), 7, True))

    def test_a_centre_is_none_of_the_corners(self) -> None:
        for name, n in itertools.product(words.HASHES, (3, 4)):
            around = [words.point_word(name, point, 7, centre) for point in itertools.product((-1, 0, 1), repeat=n)
                      for centre in (False, True)]
            self.assertEqual(len(set(around)), 2 * 3**n)


class Noises(unittest.TestCase):
    def test_zero_at_lattice_points(self) -> None:
        for name, n, kernel in KERNELS:
            points = [(c,) * n for c in (-2**22, -3, 0, 7)]
            if kernel.triangles:
                points += [(Fraction(2 * i + j % 2, 4), Fraction(j, 2)) for i in range(-2, 3) for j in range(4)]
            else:
                points += [(Fraction(2 * c + 1, 2),) * n for c in (-3, 0, 7)]
            noise = noises.find(name)
            for point in points:
                self.assertEqual((noise.exact(KNOBS, point, 5), noise.fixed(KNOBS, point, 5)), ((0,), (0,)))

    def test_no_crease_where_a_point_begins_to_count(self) -> None:
        # Along a line through many ends the second differences, as fast as they change, do not leap.
        step = Fraction(1, 2**7)
        for name, n, _ in KERNELS:
            rest = (Fraction(3, 16), Fraction(5, 8), Fraction(7, 16))[:n - 1]
            values = [noises.find(name).exact(KNOBS, (7 + i * step, *rest), 3)[0] for i in range(131)]
            for _ in range(2):
                values = [(b - a) / step for a, b in itertools.pairwise(values)]
            self.assertLess(max(abs(b - a) for a, b in itertools.pairwise(values)), 16)

    def largest(self, kernel: Kernel, fraction: tuple[int, ...], of: Callable) -> int:
        """With gradients towards the position at every point."""
        n = len(fraction)
        some = [h << 21 for h in range(2**11)]
        steps = iter(kernels.fixed_points(kernel, fraction))

        def word(*_) -> int:
            d = next(steps).offset
            return max(some, key=lambda h: sum(a * b for a, b in zip(Lattice(KNOBS).fixed_octahedral(h, n), d)))

        with mock.patch.object(kernels.Point, "word", word):
            return of(kernel, Lattice(KNOBS), (0,) * n, fraction)

    def test_the_largest_ramps_do_not_overflow(self) -> None:
        for name, n, kernel in KERNELS:
            for f in fractions(n, 12):
                fraction = tuple(int(x * UNIT) for x in f)
                self.assertLessEqual(abs(self.largest(kernel, fraction, kernels.fixed_value)), 2**21)
                if name == "simplex":
                    for slope in self.largest(kernel, fraction, kernels.fixed_derivatives):
                        self.assertLess(abs(slope), 2**24)  # a float
