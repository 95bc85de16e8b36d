"""Tests of cellular_phase.py, and of claims about the nearest point that moves: by hand, by naive searches of points
that are rotated in floats and in whole numbers, and by what a phase does."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Iterator, Sequence
from fractions import Fraction
from unittest import mock

from proof.golden.generator import INT_MAX, INT_MIN, generator_of, to_f32
from proof.golden.simplex_rows import PHASES
from proof.oracle import feature_points, noises
from proof.oracle.feature_points import BlockTooSmall, direction2, direction3
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT, cosine_and_sine
from proof.oracle.lattice import Choice, Lattice
from proof.oracle.moving_points_test import LARGEST
from proof.oracle.nearest import NEAREST, OFFSET
from proof.oracle.noises import Noise
from proof.oracle.rotation import angle

LATTICE = Knobs("lattice")
STILL, MOVING = noises.find("cellular"), noises.find("cellular_phase")
NEARER = {2: 7 / 8, 3: 25 / 32}


def at(noise: Noise, phase: float, jitter: float = 1.0) -> Noise:
    return noise.chosen(Choice(jitter)).rotated(phase)


def samples(name: str, n: int, count: int = 24) -> Iterator[tuple[list[Fraction], int, float, float]]:
    """Positions that fixed arithmetic does not cut, seeds, phases and jitters."""
    numbers = generator_of(f"{name}{n}")
    edges = [*PHASES, *LARGEST]
    for index in range(count):
        phase = edges[index // 2 % len(edges)] if index % 2 else numbers.uniform(-2, 2)
        jitter = (1.0, numbers.integer(0, UNIT) / UNIT, 1.0, 0.0)[index % 4]
        p = [Fraction(numbers.integer(-2**24, 2**24), UNIT) for _ in range(n)]
        if index % 3 == 0:  # on a wall
            p[index % n] = Fraction(round(p[index % n]))
        yield p, numbers.word(), phase, jitter


def t(e: int, b: int) -> int:
    """The contract's rotated(e, b)."""
    return ((e >> 8) * b >> 8) + ((e & 255) * b >> 16)


def sines(phase: float) -> tuple[int, int, int, int, int]:
    """C, S, CC, SS and SC."""
    c, s = cosine_and_sine(angle(phase))
    return c, s, (c >> 1) * c + 2**14 >> 15, (s >> 1) * s + 2**14 >> 15, (s >> 1) * c + 2**14 >> 15


def fixed_offset(f: Sequence[int], o: Sequence[int], word: int, phase: float, jitter: float) -> list[int]:
    """D, from the text of the contract, without a loop over the axes."""
    c, s, cc, ss, sc = sines(phase)
    whole = int(Fraction(jitter) * 2**20)
    if len(f) == 2:
        j = whole * 7 >> 3
        ux, uy = (int(512 * x) for x in direction2(word))
        ex, ey = f[0] - 2**19, f[1] - 2**19
        return [t(ex, c) + t(ey, s) - 16 * o[0] * c - 16 * o[1] * s - (ux * j >> 10),
                t(ex, -s) + t(ey, c) + 16 * o[0] * s - 16 * o[1] * c - (uy * j >> 10)]
    j = whole * 25 >> 5
    ux, uy, uz = (int(512 * x) for x in direction3(word))
    ex, ey, ez = (x - 2**19 for x in f)
    return [t(ex, c) + t(ey, s) - 16 * (o[0] * c + o[1] * s) - (ux * j >> 10),
            t(ex, -sc) + t(ey, cc) + t(ez, s) - 16 * (o[1] * cc + o[2] * s - o[0] * sc) - (uy * j >> 10),
            t(ex, ss) + t(ey, -sc) + t(ez, c) - 16 * (o[0] * ss - o[1] * sc + o[2] * c) - (uz * j >> 10)]


def forwards(d: Sequence[int], phase: float) -> tuple[int, ...]:
    """The right offset, in units of -2^-20."""
    c, s, cc, ss, sc = sines(phase)
    if len(d) == 2:
        x, y = d
        return t(x, c) + t(y, -s), t(x, s) + t(y, c)
    x, y, z = d
    return t(x, c) + t(y, -sc) + t(z, ss), t(x, s) + t(y, cc) + t(z, -sc), t(y, s) + t(z, c)


class Naive(unittest.TestCase):
    def test_all_of_fixed_arithmetic(self) -> None:
        for n in (2, 3):
            for p, seed, phase, jitter in samples("fixed", n, 60 if n == 2 else 20):
                cell = [math.floor(x) for x in p]
                f = [int((x - c) * UNIT) for x, c in zip(p, cell)]
                found = []
                for o in itertools.product(range(-2, 3), repeat=n):
                    name = tuple(c + a for c, a in zip(cell, o))
                    d = fixed_offset(f, o, Lattice(LATTICE, seed).word(name), phase, jitter)
                    found.append((sum(x * x for x in d) >> 12, max(map(abs, o)) > 1, name[::-1], d))
                (first, _, name, d), (second, *_), *_ = sorted(found)
                self.assertEqual(at(MOVING, phase, jitter).fixed(LATTICE, p, seed),
                                 tuple(Fraction(math.isqrt(rank << 8), 2**18) for rank in (first, second)))
                self.assertEqual(at(NEAREST, phase, jitter).fixed(LATTICE, p, seed), name[::-1])
                self.assertEqual(at(OFFSET, phase, jitter).fixed(LATTICE, p, seed),
                                 tuple(Fraction(-a, UNIT) for a in forwards(d, phase)))


class Phases(unittest.TestCase):
    def test_without_a_rotation_points_are_nearer_to_the_middle(self) -> None:
        for n in (2, 3):
            for p, seed, _, jitter in samples("zero", n, 8):
                nearer = STILL.chosen(Choice(Fraction(jitter) * Fraction(NEARER[n])))
                self.assertEqual(at(MOVING, 0.0, jitter).exact(LATTICE, p, seed), nearer.exact(LATTICE, p, seed))

    def test_without_a_jitter_nothing_moves(self) -> None:
        for n in (2, 3):
            for p, seed, phase, _ in samples("no jitter", n, 12):
                still = STILL.chosen(Choice(0.0)).exact(LATTICE, p, seed)
                moving = at(MOVING, phase, 0.0)
                self.assertEqual(moving.exact(LATTICE, p, seed), still)
                for a, b in zip(moving.fixed(LATTICE, p, seed), still):
                    self.assertLess(abs(a - b), 2**-12)

    def test_the_metric_is_the_euclidean_one(self) -> None:
        for noise, of in itertools.product((MOVING, NEAREST, OFFSET), ("exact", "fixed")):
            found = {getattr(noise.chosen(Choice(0.75, metric)).rotated(0.3), of)(LATTICE, (0.3, 0.9), 5)
                     for metric in (1, 2, 3, 4, 5)}
            self.assertEqual(len(found), 1)

    def test_jitters_beyond_the_ends(self) -> None:
        for of, (jitter, end) in itertools.product(("exact", "fixed"), ((-0.5, 0.0), (1.75, 1.0))):
            self.assertEqual(*(getattr(at(MOVING, 0.3, x), of)(LATTICE, (0.25, 3.5), 7) for x in (jitter, end)))


class FixedArithmetic(unittest.TestCase):
    def test_ties_are_those_of_the_contract(self) -> None:
        # At a corner, without a jitter, points are equally far: that of the cell with the smallest z, y, x counts. In
        # space the rounded B makes some axes longer than others, unless it turns by whole quarters.
        for phase in (*PHASES, *LARGEST, to_f32(0.3)):
            for p, cell in (((4.0, -6.0), (3, -7)), ((4.0, -6.0, 8.0), (3, -7, 7))):
                self.assertEqual(at(NEAREST, phase, 0.0).exact(LATTICE, p), cell, phase)
                if len(p) == 2 or phase * 4 % 1 == 0:
                    self.assertEqual(at(NEAREST, phase, 0.0).fixed(LATTICE, p), cell, phase)

    def test_names_at_the_ends_of_int(self) -> None:
        noise = at(NEAREST, 0.3, 0.0)
        for of in (noise.exact_cell, noise.fixed_cell):
            self.assertEqual(of(LATTICE, (INT_MIN, 0), (0.125, 0.5)), (INT_MIN, 0))
            self.assertEqual(of(LATTICE, (INT_MIN, 0), (0.0, 0.0), 0, (7, 0)), ((-2**31 - 1) % 7, -1))
            self.assertEqual(of(LATTICE, (INT_MAX, -1), (0.875, 1.0)), (INT_MAX, -1))


class Searches(unittest.TestCase):
    def test_a_larger_block_changes_nothing(self) -> None:
        for n in (2, 3):
            for p, seed, phase, jitter in samples("larger", n, 10 if n == 2 else 3):
                noise = at(MOVING, phase, jitter)
                found = noise.exact(LATTICE, p, seed), noise.fixed(LATTICE, p, seed)
                with mock.patch.object(feature_points, "AROUND", 5):
                    self.assertEqual((noise.exact(LATTICE, p, seed), noise.fixed(LATTICE, p, seed)), found)

    def test_a_block_that_is_too_small_is_found(self) -> None:
        for of in ("exact", "fixed"):
            with mock.patch.object(feature_points, "AROUND", 0), self.assertRaises(BlockTooSmall):
                getattr(at(MOVING, 0.3), of)(LATTICE, (0.0, 0.25), 1)
