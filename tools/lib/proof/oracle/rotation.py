"""Section 14 of docs/reference/contract.md: gradients that rotate by a phase."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeVar

from proof.oracle import gradients, integers
from proof.oracle.gradients import Real
from proof.oracle.hashes import MASK

Number = TypeVar("Number", int, float, Fraction)

DIMENSIONS = (2, 3)


def check(n: int) -> None:
    if n not in DIMENSIONS:
        raise ValueError(f"gradients rotate in two and three dimensions, not in {n}D")


def edge(g: Sequence[Number], h: int) -> tuple[Number | int, ...]:
    """e, which the gradient g of the word h is after a sixth of a turn."""
    b = -1 if h >> 20 & 1 else 1
    return ((0, g[1], b), (g[0], b, 0), (b, 0, g[2]))[gradients.third(h)]


def other(g: Sequence[Number], h: int) -> tuple[Number | int, ...]:
    """The vector whose sum fixed arithmetic adds to the sum of the gradient g of the word h: g' on the plane, e in
    space."""
    check(len(g))
    return (-g[1], g[0]) if len(g) == 2 else edge(g, h)


# --- Exact ------------------------------------------------------------------------------------------------------


def cosine_and_sine(phase: Real) -> tuple[Fraction, Fraction]:
    """Exact at whole quarters of a turn, else each is off by less than SINE_ERROR."""
    turns = Fraction(phase)
    return gradients.sine_of_turns(turns + Fraction(1, 4)), gradients.sine_of_turns(turns)


# 1 / sqrt(3), too small by less than 2^-SINE_BITS, which is far less than SINE_ERROR.
INVERSE_ROOT = Fraction(math.isqrt(2**(2 * gradients.SINE_BITS) // 3), 2**gradients.SINE_BITS)


def shares(phase: Real, n: int) -> tuple[Fraction, Fraction]:
    """How much a rotated gradient in n dimensions has of the gradient, and of the other vector: the cosine and the sine
    on the plane, A and B in space. Exact at whole and half turns, else they are off by less than 3 SINE_ERROR in
    sum."""
    cosine, sine = cosine_and_sine(phase)
    return (cosine, sine) if n == 2 else (cosine - sine * INVERSE_ROOT, 2 * sine * INVERSE_ROOT)


@functools.lru_cache(maxsize=4096)  # a noise with derivatives calls it several times
def mixed(g: tuple[Real, ...], other_: tuple[Real, ...], phase: Real) -> tuple[Fraction, ...]:
    a, b = shares(phase, len(g))
    return tuple(a * Fraction(x) + b * Fraction(y) for x, y in zip(g, other_))


def rotated(g: tuple[Real, ...], h: int, phase: Real) -> tuple[Fraction, ...]:
    """The gradient g of the word h after `phase` turns."""
    return mixed(g, other(g, h), phase)


# --- Fixed ------------------------------------------------------------------------------------------------------


def angle(phase: Real) -> int:
    """T, in units of 2^-32 of a turn."""
    exact = Fraction(phase)
    return 4 * math.trunc((exact - math.trunc(exact)) * 2**30) & MASK


@dataclass(frozen=True)
class Rotation:
    """How much a phase takes of the sum n, and of the sum n' of the other vectors, in units of 2^-18: C and Z of the
    contract on the plane, A and B in space."""
    of_gradients: int
    of_others: int

    def of(self, n: int, n_other: int) -> int:
        return integers.signed(integers.part(n, self.of_gradients) + integers.part(n_other, self.of_others))


def fixed_cosine_and_sine(phase: Real) -> tuple[int, int]:
    """In units of 2^-16."""
    return integers.cosine_and_sine(angle(phase))


@functools.cache
def rotation_of(phase: Real, n: int) -> Rotation:
    """In n dimensions."""
    check(n)
    c, z = (4 * number for number in fixed_cosine_and_sine(phase))
    if n == 2:
        return Rotation(c, z)
    b = z + (integers.signed((z >> 2) * 20277) >> 15)
    return Rotation(c - (b >> 1), b)
