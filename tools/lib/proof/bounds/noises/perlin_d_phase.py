"""hn_perlin_d with a phase: hn_perlin with a phase and its derivatives along the axes, which perlin_phase.py proves."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, perlin_d, perlin_phase

CASES = perlin_phase.CASES


def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    return replace(perlin_phase.derive(dims, gradient), slope=perlin_phase.derive_slope(dims, gradient))


def largest_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    slope = perlin_phase.derive_slope(dims, gradient).fixed_largest
    return (perlin_phase.largest_intermediates(dims, gradient) | perlin_d.largest_intermediates(dims, gradient)
            | perlin_phase.scaled_intermediates("derivative", dims, slope, 4 * perlin_phase.unit(dims)))
