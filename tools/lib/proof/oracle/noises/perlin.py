"""Sections 6, 10, 14 and 22 of docs/reference/contract.md: Perlin noise, with its derivatives, with a phase, and one
along each axis."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.cells import corners, halves, interpolated, weighted_sum
from proof.oracle.components import vector
from proof.oracle.gradients import Knobs
from proof.oracle.integers import fade
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise, rotating
from proof.oracle.ramps import scaled, sine_ramp
from proof.oracle.slopes import Ramp, fade_slope, interpolated_ramp, weight_derivatives

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


# --- Derivatives and vectors ------------------------------------------------------------------------------------


def check_octahedral(lattice: Lattice, name: str) -> None:
    if lattice.knobs.sine:
        raise ValueError(f"with the sine gradient there is no {name}")


def exact_d(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    check_octahedral(lattice, "hn_perlin_d")
    of_weights = weight_derivatives(cell, f, lambda corner, offset: ramp(lattice, corner, offset))
    of_ramps = [weighted_sum(cell, f, lambda corner, _: Fraction(lattice.gradient(corner)[axis]))
                for axis in range(len(f))]
    factor = scale(lattice, len(f))
    return (*exact(lattice, cell, f), *(factor * (a + b) for a, b in zip(of_weights, of_ramps)))


def interpolated_d(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    ramps = []
    for corner, offset in corners(cell, fraction):
        gradient = lattice.fixed_octahedral(lattice.word(corner), len(cell))
        ramps.append(Ramp(fixed_ramp(lattice, corner, offset), (), gradient))
    for f in fraction:
        ramps = [interpolated_ramp(a, b, fade(f), fade_slope(f)) for a, b in halves(ramps)]
    result, = ramps
    return (result.value, *result.derivatives)


def fixed_d(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    check_octahedral(lattice, "hn_perlin_d")
    sums = lattice.fixed_sums(len(cell), lambda still: interpolated_d(still, cell, fraction))
    return fixed_scaled(lattice, len(cell), sums)


def of_vector(noise):
    def components(lattice: Lattice, cell: Sequence[int], f: Sequence) -> tuple:
        check_octahedral(lattice, "hn_perlin_vector")
        return noise(lattice, cell, f)

    return components


PERLIN, PERLIN_D = Noise("perlin", exact, fixed), Noise("perlin_d", exact_d, fixed_d)
NOISES = (PERLIN, PERLIN_D, rotating(PERLIN, "perlin_phase"), rotating(PERLIN_D, "perlin_d_phase"),
          vector(Noise("perlin_vector", of_vector(exact), of_vector(fixed))))
