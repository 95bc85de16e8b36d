"""hn_simplex_d with a phase: hn_simplex with a phase and its derivatives along the axes."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds.gradients import Gradient
from proof.bounds.kernels import ROTATING
from proof.bounds.noises import ProvenBounds, simplex_d, simplex_phase

CASES = simplex_phase.CASES


def derive(dims: int, gradient: Gradient | None) -> ProvenBounds:
    return replace(simplex_phase.derive(dims, gradient), slope=simplex_phase.derive_slope(dims))


def largest_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    slope, unit = simplex_phase.derive_slope(dims).fixed_largest, 4 * ROTATING[dims].steps * simplex_phase.unit(dims)
    return (simplex_phase.largest_intermediates(dims, gradient) | simplex_d.largest_intermediates(dims, gradient)
            | simplex_phase.scaled_intermediates("derivative", dims, slope, unit))
