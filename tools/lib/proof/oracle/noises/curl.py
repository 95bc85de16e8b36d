"""Section 15 of docs/reference/contract.md: the curl of simplex noise, without and with a phase."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TypeVar

from proof.oracle import rotation
from proof.oracle.hashes import MASK, SEED_STEP, mix
from proof.oracle.integers import SLOPE_UNIT, UNIT, signed
from proof.oracle.lattice import Lattice
from proof.oracle.noises import VECTOR, Noise, rotating
from proof.oracle.noises.simplex import SIMPLEX_D, SIMPLEX_D_PHASE

Number = TypeVar("Number", int, Fraction)

UNITS = (SLOPE_UNIT,) * 3
COARSER = 8  # in space a component with HN_FIXED is in units of 2^-16
MOVE = (Fraction(1, 2), Fraction(0), Fraction(1, 4))  # of the place of the second noise in space


def slopes_of(lattice: Lattice) -> Noise:
    return SIMPLEX_D if lattice.phase is None else SIMPLEX_D_PHASE


def second(lattice: Lattice) -> Lattice:
    """The lattice of the second noise in space. Its phase runs twice as fast."""
    phase = None if lattice.phase is None else 2 * Fraction(lattice.phase)
    return replace(lattice, seed=mix((lattice.seed + SEED_STEP) & MASK), phase=phase)


def fixed_second(lattice: Lattice) -> Lattice:
    """With twice the angle, a word, in place of the angle of twice the phase."""
    phase = None if lattice.phase is None else Fraction(2 * rotation.angle(lattice.phase) & MASK, 2**32)
    return replace(second(lattice), phase=phase)


def moved(cell: Sequence[int], f: Sequence[Number], unit: int) -> tuple[list[int], list[Number]]:
    """The place of the second noise in space, with fractions in units of 1 / unit. Behind the last cell of an int is
    one more."""
    moves = [type(x)(move * unit) for x, move in zip(f, MOVE, strict=True)]
    into_next = [x >= unit - move for x, move in zip(f, moves)]
    return ([c + next_ for c, next_ in zip(cell, into_next)],
            [x - (unit - move) if next_ else x + move for x, move, next_ in zip(f, moves, into_next)])


def in_the_plane(gradient: Sequence[Number]) -> tuple[Number, Number]:
    dx, dy = gradient
    return (dy, -dx)


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    noise = slopes_of(lattice)
    _, *a = noise.exact_in_cell(lattice, cell, f)
    if len(cell) == 2:
        return in_the_plane(a)
    _, *b = noise.exact_in_cell(second(lattice), *moved(cell, f, 1))
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def prod(a: int, b: int) -> int:
    """The product of two derivatives, in units of 2^-20."""
    low = signed(signed((a >> 9) * (b & 511)) + signed((a & 511) * (b >> 9)))
    return signed(signed((a >> 9) * (b >> 9)) + (low >> 9))


def fixed_component(a: Sequence[int], b: Sequence[int], i: int, j: int) -> int:
    return COARSER * (signed(prod(a[i], b[j]) - prod(a[j], b[i]) + 8) >> 4)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    noise = slopes_of(lattice)
    _, *a = noise.fixed_in_cell(lattice, cell, fraction)
    if len(cell) == 2:
        return in_the_plane(a)
    _, *b = noise.fixed_in_cell(fixed_second(lattice), *moved(cell, fraction, UNIT))
    return tuple(fixed_component(a, b, i, j) for i, j in ((1, 2), (2, 0), (0, 1)))


CURL = Noise("curl", exact, fixed, VECTOR, UNITS)
NOISES = (CURL, rotating(CURL, "curl_phase"))
