"""Section 16 of docs/reference/contract.md: how feature points go round with a phase."""

from __future__ import annotations

import functools
import math
from fractions import Fraction

from proof.oracle import rotation
from proof.oracle.gradients import Real
from proof.oracle.integers import signed

# k, by the number of dimensions: how far points that move are from the middle of their cells, beside those that do not.
NEARER = {2: Fraction(7, 8), 3: Fraction(25, 32)}

Matrix = tuple[tuple[Real, ...], ...]  # of rows


def columns(matrix: Matrix) -> Matrix:
    return tuple(zip(*matrix))


# --- Exact ------------------------------------------------------------------------------------------------------


@functools.lru_cache(maxsize=4096)
def forwards(n: int, phase: Real) -> Matrix:
    """M: it takes a direction by a phase."""
    rotation.check(n)
    c, s = rotation.cosine_and_sine(phase)
    if n == 2:
        return ((c, -s), (s, c))
    # First in the plane of y and z, then of x and y.
    return ((c, -s * c, s * s), (s, c * c, -c * s), (Fraction(0), s, c))


def ways(n: int, phase: Real, jitter: Fraction) -> Matrix:
    """k jitter M."""
    return tuple(tuple(NEARER[n] * jitter * x for x in row) for row in forwards(n, phase))


# --- Fixed ------------------------------------------------------------------------------------------------------


def fixed_product(a: int, b: int) -> int:
    """The product of two sines or cosines in units of 2^-16, rounded. Some are 1 or -1, whose product does not fit a
    signed integer before it is divided."""
    return (a // 2 * b + 2**14) // 2**15


@functools.lru_cache(maxsize=4096)
def backwards(n: int, phase: Real) -> Matrix:
    """B, in units of 2^-16: it takes a position by a phase, so that points need no rotation."""
    rotation.check(n)
    c, s = rotation.fixed_cosine_and_sine(phase)
    if n == 2:
        return ((c, s), (-s, c))
    cc, ss, sc = fixed_product(c, c), fixed_product(s, s), fixed_product(s, c)
    return ((c, s, 0), (-sc, cc, s), (ss, -sc, c))


def fixed_jitter(n: int, jitter: Fraction) -> int:
    """J, of a jitter in [0, 1]."""
    return math.floor(NEARER[n] * math.trunc(jitter * 2**20))


def rotated(e: int, b: int) -> int:
    """The product of an offset in units of 2^-20 and a number of B, in the units of the offset."""
    return signed((signed(e // 2**8 * b) // 2**8) + (signed(e % 2**8 * b) // 2**16))


@functools.lru_cache(maxsize=4096)  # a search calls it for each cell
def times(matrix: Matrix, d: tuple[int, ...]) -> tuple[int, ...]:
    """The product of whole numbers, in those units."""
    return tuple(sum(map(rotated, d, row)) for row in matrix)
