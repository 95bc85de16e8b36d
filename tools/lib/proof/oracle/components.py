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


def of_component(in_cell: InCell[Number], i: int) -> InCell[Number]:
    def numbers(lattice: Lattice, cell: Sequence[int], f: Sequence[Number]) -> tuple[Number, ...]:
        if len(cell) not in DIMENSIONS or i >= len(cell):
            raise ValueError(f"vectors of noises are in two and three dimensions, and one in {len(cell)}D has no "
                             f"component {i}")
        return in_cell(replace(lattice, component=i), cell, f)

    return numbers


def component(noise: Noise, i: int) -> Noise:
    """Component i of a vector with derivatives: the noise with its derivatives, of other words."""
    return replace(noise, exact_in_cell=of_component(noise.exact_in_cell, i),
                   fixed_in_cell=of_component(noise.fixed_in_cell, i))


def vector(noise: Noise) -> Noise:
    """A noise for each axis, from one that returns a number."""
    def of(in_cell: InCell[Number]) -> InCell[Number]:
        return lambda lattice, cell, f: tuple(value for i in range(len(cell))
                                              for value in of_component(in_cell, i)(lattice, cell, f))

    return replace(noise, exact_in_cell=of(noise.exact_in_cell), fixed_in_cell=of(noise.fixed_in_cell), outputs=VECTOR,
                   units=(NOISE_UNIT,) * 3)
