"""Section 22 of docs/reference/contract.md: vectors whose components are noises of one hash."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TypeVar

from proof.oracle.integers import NOISE_UNIT
from proof.oracle.lattice import Lattice
from proof.oracle.noises import VECTOR, Noise

DIMENSIONS = (2, 3)

Number = TypeVar("Number", int, Fraction)
InCell = Callable[[Lattice, Sequence[int], Sequence[Number]], tuple[Number, ...]]


def vector(noise: Noise) -> Noise:
    """A noise for each axis, from one that returns a number."""
    def of(in_cell: InCell[Number]) -> InCell[Number]:
        def components(lattice: Lattice, cell: Sequence[int], f: Sequence[Number]) -> tuple[Number, ...]:
            if len(cell) not in DIMENSIONS:
                raise ValueError(f"vectors of noises are in two and three dimensions, not in {len(cell)}D")
            found = [in_cell(replace(lattice, component=i), cell, f) for i in range(len(cell))]
            return tuple(value for value, in found)

        return components

    return replace(noise, exact_in_cell=of(noise.exact_in_cell), fixed_in_cell=of(noise.fixed_in_cell), outputs=VECTOR,
                   units=(NOISE_UNIT,) * 3)


def component(noise: Noise, i: int) -> Noise:
    """Component i of a vector with derivatives: the noise with its derivatives, of other words."""
    def of(in_cell: InCell[Number]) -> InCell[Number]:
        def numbers(lattice: Lattice, cell: Sequence[int], f: Sequence[Number]) -> tuple[Number, ...]:
            if len(cell) not in DIMENSIONS or i >= len(cell):
                raise ValueError(f"a vector in {len(cell)}D has no component {i} with derivatives")
            return in_cell(replace(lattice, component=i), cell, f)

        return numbers

    return replace(noise, exact_in_cell=of(noise.exact_in_cell), fixed_in_cell=of(noise.fixed_in_cell))
