"""Section 16 of docs/reference/contract.md: the distances of the nearest three points of cells."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.feature_points import exact_field, fixed_field, whole_numbers
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Lattice

COUNT = 3
OUTPUTS = ("first", "second", "third")
UNITS = (UNIT,) * COUNT


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    return exact_field(lattice, cell, f).distances(COUNT)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    return whole_numbers(fixed_field(lattice, cell, fraction).distances(COUNT), UNIT)
