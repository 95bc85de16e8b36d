"""Section 6 of docs/reference/contract.md: Perlin noise."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.cells import interpolated, weighted_sum
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice
from proof.oracle.ramps import scaled, sine_ramp

# --- Exact ------------------------------------------------------------------------------------------------------

OCTAHEDRAL_SCALES = {1: Fraction(2), 2: Fraction(1831, 1024), 3: Fraction(985, 1024), 4: Fraction(953, 1024)}
ROTATING_SCALES = OCTAHEDRAL_SCALES | {3: Fraction(879, 1024)}  # with a phase (section 14)


def check(knobs: Knobs, n: int) -> None:
    if knobs.sine and n not in (2, 3):
        raise ValueError(f"with the sine gradient there is no Perlin noise in {n}D")


def scale(lattice: Lattice, n: int) -> Fraction:
    """The factor of the weighted sum in n dimensions."""
    if lattice.knobs.sine:
        return Fraction(1)
    return (OCTAHEDRAL_SCALES if lattice.phase is None else ROTATING_SCALES)[n]


def ramp(lattice: Lattice, corner: Sequence[int], offset: Sequence[Fraction]) -> Fraction:
    return sum((Fraction(g) * x for g, x in zip(lattice.gradient(corner), offset)), Fraction(0))


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    check(lattice.knobs, len(f))
    total = weighted_sum(cell, f, lambda corner, offset: ramp(lattice, corner, offset))
    return (total * scale(lattice, len(f)),)


# --- Fixed (section 8) ------------------------------------------------------------------------------------------


# By the number of dimensions, for octahedral gradients.
FIXED_SCALES = {1: 2048, 2: 1831, 3: 985, 4: 1906}
ROTATING_FIXED_SCALES = FIXED_SCALES | {3: 879}


def fixed_scaled(lattice: Lattice, n: int, sums: Sequence[int]) -> tuple[int, ...]:
    """The results in n dimensions, of the sums that are scaled."""
    scales = FIXED_SCALES if lattice.phase is None else ROTATING_FIXED_SCALES
    return tuple(scaled(x, scales[n]) for x in sums)


def fixed_ramp(lattice: Lattice, corner: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a corner at the offset d from it."""
    if lattice.knobs.sine:
        return sine_ramp(lattice.fixed_sine_gradient(corner), d)
    return lattice.fixed_ramp(lattice.word(corner), d)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    check(lattice.knobs, len(cell))
    if lattice.knobs.sine:
        lattice.check_phase()
    sums = lattice.fixed_sums(len(cell),
        lambda still: [interpolated(cell, fraction, lambda corner, d: fixed_ramp(still, corner, d))])
    return (sums[0] >> 7,) if lattice.knobs.sine else fixed_scaled(lattice, len(cell), sums)
