"""Section 17 of docs/reference/contract.md: random numbers, one for each cell."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise

UNIT = 2**24
TINY = Fraction(1, 2**32)  # with HN_PRECISE a coordinate of a position below it counts as 0


def number(lattice: Lattice, cell: Sequence[int]) -> int:
    """hn_unorm of hn_lattice of a cell, in units of 2^-24."""
    return lattice.hash(cell) >> 8


# --- Exact ------------------------------------------------------------------------------------------------------


def counted(c: int, f: Fraction) -> int:
    """The cell to which a coordinate counts. No float f of a caller is so near to 1: it is from a tiny position."""
    return 0 if c == -1 and 1 - TINY < f < 1 else c


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    return (Fraction(number(lattice, list(map(counted, cell, f))), UNIT),)


# --- Fixed ------------------------------------------------------------------------------------------------------


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    return (number(lattice, cell),)


NOISES = (Noise("random", exact, fixed, units=(UNIT,)),)
