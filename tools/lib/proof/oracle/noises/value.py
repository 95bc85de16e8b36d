"""Sections 9, 10 and 22 of docs/reference/contract.md: value noise, with its derivatives, and one along each axis."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.cells import corners, halves, interpolated, weighted_sum
from proof.oracle.components import vector
from proof.oracle.integers import fade, lerp, part, signed
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise
from proof.oracle.slopes import Ramp, fade_slope, interpolated_ramp, rise, weight_derivatives


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


# --- Derivatives -------------------------------------------------------------------------------------------------


def exact_d(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    derivatives = weight_derivatives(cell, f, lambda corner, _: number(lattice, corner))
    return (*exact(lattice, cell, f), *derivatives)


def faces(numbers: Sequence[int], fraction: Sequence[int]) -> list[Ramp]:
    """The numbers, interpolated along x and y."""
    (t_x, t_y), (s_x, s_y) = map(fade, fraction[:2]), map(fade_slope, fraction[:2])
    edges = [(lerp(a, b, t_x), rise(a, b)) for a, b in halves(numbers)]
    ramps = []
    for (near, near_rise), (far, far_rise) in halves(edges):
        # Only here is a derivative made after a later axis: of the rises along x, interpolated along y.
        d_x = part(lerp(near_rise, far_rise, t_y), s_x)
        ramps.append(Ramp(lerp(near, far, t_y), (d_x, part(rise(near, far), s_y))))
    return ramps


def fixed_d(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    numbers = [fixed_number(lattice, corner) for corner, _ in corners(cell, fraction)]
    if len(cell) == 1:
        ramps, done = list(map(Ramp, numbers)), 0
    else:
        ramps, done = faces(numbers, fraction), 2
    for f in fraction[done:]:
        ramps = [interpolated_ramp(a, b, fade(f), fade_slope(f)) for a, b in halves(ramps)]
    result, = ramps
    return tuple(map(rounded, (result.value, *result.derivatives)))


NOISES = (Noise("value", exact, fixed), Noise("value_d", exact_d, fixed_d),
          vector(Noise("value_vector", exact, fixed)))
