"""Section 10 of docs/reference/contract.md: Perlin noise with its derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.cells import corners, halves, weighted_sum
from proof.oracle.integers import fade
from proof.oracle.lattice import Lattice
from proof.oracle.noises import perlin
from proof.oracle.slopes import Ramp, fade_slope, interpolated_ramp, weight_derivatives


def check(lattice: Lattice) -> None:
    if lattice.knobs.sine:
        raise ValueError("with the sine gradient there is no hn_perlin_d")


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    check(lattice)
    of_weights = weight_derivatives(cell, f, lambda corner, offset: perlin.ramp(lattice, corner, offset))
    of_ramps = [weighted_sum(cell, f, lambda corner, _: Fraction(lattice.gradient(corner)[axis]))
                for axis in range(len(f))]
    scale = perlin.scale(lattice, len(f))
    return (*perlin.exact(lattice, cell, f), *(scale * (a + b) for a, b in zip(of_weights, of_ramps)))


def interpolated(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    ramps = []
    for corner, offset in corners(cell, fraction):
        gradient = lattice.fixed_octahedral(lattice.word(corner), len(cell))
        ramps.append(Ramp(perlin.fixed_ramp(lattice, corner, offset), (), gradient))
    for f in fraction:
        ramps = [interpolated_ramp(a, b, fade(f), fade_slope(f)) for a, b in halves(ramps)]
    result, = ramps
    return (result.value, *result.derivatives)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    check(lattice)
    sums = lattice.fixed_sums(len(cell), lambda still: interpolated(still, cell, fraction))
    return perlin.fixed_scaled(lattice, len(cell), sums)
