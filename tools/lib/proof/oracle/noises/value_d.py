"""Section 10 of docs/reference/contract.md: value noise with its derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.cells import corners, halves
from proof.oracle.integers import fade, lerp, part
from proof.oracle.lattice import Lattice
from proof.oracle.noises import value
from proof.oracle.slopes import Ramp, fade_slope, interpolated_ramp, rise, weight_derivatives


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    derivatives = weight_derivatives(cell, f, lambda corner, _: value.number(lattice, corner))
    return (*value.exact(lattice, cell, f), *derivatives)


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


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    numbers = [value.fixed_number(lattice, corner) for corner, _ in corners(cell, fraction)]
    if len(cell) == 1:
        ramps, done = list(map(Ramp, numbers)), 0
    else:
        ramps, done = faces(numbers, fraction), 2
    for f in fraction[done:]:
        ramps = [interpolated_ramp(a, b, fade(f), fade_slope(f)) for a, b in halves(ramps)]
    result, = ramps
    return tuple(map(value.rounded, (result.value, *result.derivatives)))
