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
from proof.oracle.words import MASK

Number = TypeVar("Number", int, float, Fraction)

DIMENSIONS = (2, 3)


def check(n: int) -> None:
    if n not in DIMENSIONS:
        raise ValueError(f"gradients rotate in two and three dimensions, not in {n}D")


def quarter_rotated(g: Sequence[Number]) -> tuple[Number, ...]:
    """g', the gradient after a quarter of a turn: in space in the plane of the two axes that it has."""
    check(len(g))
    first, second = (0, 1) if len(g) == 2 else (axis for axis, x in enumerate(g) if x)
    quarter = [x - x for x in g]
    quarter[first], quarter[second] = -g[second], g[first]
    return tuple(quarter)


# --- Exact ------------------------------------------------------------------------------------------------------


def cosine_and_sine(phase: Real) -> tuple[Fraction, Fraction]:
    """Exact at whole quarters of a turn, else each is off by less than SINE_ERROR."""
    turns = Fraction(phase)
    return gradients.sine_of_turns(turns + Fraction(1, 4)), gradients.sine_of_turns(turns)


@functools.lru_cache(maxsize=4096)  # a noise with derivatives calls it several times
def rotated(g: tuple[Real, ...], phase: Real) -> tuple[Fraction, ...]:
    """The gradient g after `phase` turns."""
    cosine, sine = cosine_and_sine(phase)
    return tuple(cosine * Fraction(a) + sine * Fraction(b) for a, b in zip(g, quarter_rotated(g)))


# --- Fixed ------------------------------------------------------------------------------------------------------


def angle(phase: Real) -> int:
    """A, in units of 2^-32 of a turn."""
    exact = Fraction(phase)
    return 4 * math.trunc((exact - math.trunc(exact)) * 2**30) & MASK


@dataclass(frozen=True)
class Rotation:
    """C and Z, the cosine and the sine of a phase, in units of 2^-18."""
    cosine: int
    sine: int

    def of(self, a: int, b: int) -> int:
        """Of what there is without a rotation and after a quarter of one."""
        return integers.signed(integers.part(a, self.cosine) + integers.part(b, self.sine))


def fixed_cosine_and_sine(phase: Real) -> tuple[int, int]:
    """In units of 2^-16."""
    return integers.cosine_and_sine(angle(phase))


@functools.cache
def rotation_of(phase: Real) -> Rotation:
    cosine, sine = fixed_cosine_and_sine(phase)
    return Rotation(4 * cosine, 4 * sine)
