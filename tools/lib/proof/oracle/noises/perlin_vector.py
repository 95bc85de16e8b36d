"""Section 22 of docs/reference/contract.md: a Perlin noise along each axis."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.components import UNITS, vector
from proof.oracle.lattice import Lattice
from proof.oracle.noises import VECTOR as OUTPUTS
from proof.oracle.noises import perlin

__all__ = ["OUTPUTS", "UNITS", "exact", "fixed"]


def check(lattice: Lattice) -> None:
    if lattice.knobs.sine:
        raise ValueError("with the sine gradient there is no hn_perlin_vector")


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    check(lattice)
    return vector(perlin.exact)(lattice, cell, f)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    check(lattice)
    return vector(perlin.fixed)(lattice, cell, fraction)
