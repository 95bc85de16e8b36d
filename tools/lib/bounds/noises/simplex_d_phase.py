"""hn_simplex_d with a phase: hn_simplex with a phase and its derivatives along the axes."""

from __future__ import annotations

from dataclasses import replace

from bounds import kernel_fixed
from bounds.gradients import Gradient
from bounds.kernels import SIMPLEX
from bounds.noises import Derived, simplex, simplex_phase

CASES = simplex_phase.CASES


def derive(dims: int, gradient: Gradient | None) -> Derived:
    return replace(simplex_phase.derive(dims, gradient), slope=simplex.derived_slope(SIMPLEX[dims], turning=True))


def largest_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    return (simplex_phase.largest_intermediates(dims, gradient)
            | kernel_fixed.largest_slope_intermediates(SIMPLEX[dims], True))


def quotes() -> list[tuple[str, str]]:
    return []


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {}
