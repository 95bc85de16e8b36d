"""Section 9 of docs/reference/contract.md: value noise."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.cells import interpolated, weighted_sum
from proof.oracle.integers import signed
from proof.oracle.lattice import Lattice


def number(lattice: Lattice, corner: Sequence[int]) -> Fraction:
    """V(h) of a lattice point."""
    return Fraction(lattice.word(corner) % 2**23, 2**22) - 1


def fixed_number(lattice: Lattice, corner: Sequence[int]) -> int:
    """N(h): the same in units of 2^-29."""
    return signed(lattice.word(corner) % 2**23 * 2**7 - 2**29)


def rounded(n: int) -> int:
    """The result of the interpolation, in units 2^8 times as large."""
    return signed(n + 128) >> 8


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    return (weighted_sum(cell, f, lambda corner, _: number(lattice, corner)),)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    return (rounded(interpolated(cell, fraction, lambda corner, _: fixed_number(lattice, corner))),)
