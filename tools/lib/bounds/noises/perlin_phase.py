"""hn_perlin with a phase: what is proven of it, from docs/contract.md, section 14. turns.py has its range.

The other bounds of the exact noise are longest() times those of all gradients as long as 1 (suprema.py). Its floats are
those of noises/perlin/floats.py with the ramps of kernel_floats.py.

FIXED. It is off by the same as hn_perlin; FADE is longest() times that of gradients as long as 1. Ramps round by more,
and components of gradients round, too. TURN (kernel_fixed.py) moves every gradient times a vector by so much for each
length of that vector, so it moves the noise by that times the largest noise of all gradients as long as 1, and likewise
a derivative.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from bounds import suprema, turns
from bounds.boxes import SAFE, corners
from bounds.floats import (approx_derivatives, approx_interpolation, approx_offsets, error_supremum, position_error)
from bounds.gradients import OCTAHEDRAL, UNIT, Gradient, longest
from bounds.integers import (ONE, SLOPE_UNIT, interpolation_intermediates, largest_fade_effect, largest_joint_effect,
                             largest_rounding, largest_slope_fade_effect, lerp_roundings, part_intermediate,
                             scaled_intermediate, slope_rounding, slopes)
from bounds.kernel_fixed import MIXED_ROUNDING, ramp_rounding, turn_effect, turned_intermediates
from bounds.kernel_floats import component, turned_ramp
from bounds.noises import Derived, listed
from bounds.noises.perlin.exact import SCALE
from bounds.noises.perlin.fixed import fixed_scale, scaling_error
from bounds.noises.perlin.floats import largest_of

CASES = ((2, OCTAHEDRAL), (3, OCTAHEDRAL))
RAMP_ONE = 2**29


def scale_of(dims: int) -> float:
    return SCALE[OCTAHEDRAL][dims]


def largest(quantity: suprema.Quantity, dims: int) -> float:
    """Of all gradients that are as long as 1, not scaled."""
    return suprema.largest(quantity, dims, UNIT)


# --- In floats --------------------------------------------------------------------------------------------------------

def ramps_and_fractions(lo, hi, ulps):
    offsets = [approx_offsets(a, b, ulps) for a, b in zip(lo, hi)]
    ramps = [turned_ramp([offset[o] for offset, o in zip(offsets, corner[::-1])], 1.0, ulps)
             for corner in corners(len(lo))]
    return ramps, [fraction for fraction, _ in offsets]


def value_error(lo, hi, ulps):
    return approx_interpolation(*ramps_and_fractions(lo, hi, ulps)).scaled(scale_of(len(lo))).err


def slope_error(lo, hi, ulps):
    derivatives = approx_derivatives(*ramps_and_fractions(lo, hi, ulps), component(longest(len(lo)), True, ulps))
    return largest_of(derivative.scaled(scale_of(len(lo))).err for derivative in derivatives)


@functools.cache
def error_bound(dims: int, ulps: float = 1.0) -> float:
    return error_supremum(functools.partial(value_error, ulps=ulps), dims)


@functools.cache
def slope_error_bound(dims: int, ulps: float = 1.0) -> float:
    return error_supremum(functools.partial(slope_error, ulps=ulps), dims)


# --- In integers ------------------------------------------------------------------------------------------------------

def error_parts(dims: int, lipschitz: float) -> dict[str, float]:
    scale, of_corner = scale_of(dims), ramp_rounding(dims, 1.0, turns=True)
    return {"cut": lipschitz / ONE, "fade": scale * longest(dims) * largest_fade_effect(dims, UNIT),
            "interpolation": scale * largest_rounding(dims, of_corner) / RAMP_ONE,
            "scaling": scaling_error(dims, OCTAHEDRAL),
            "gradient": scale * turn_effect(longest(dims)) * largest(suprema.VALUE, dims)}


def beyond_the_range(dims: int, parts: dict[str, float]) -> float:
    """FADE and LERP are bounded together. FADE moves gradients that are longer by what TURN may add."""
    joint = longest(dims) * largest_joint_effect(dims, UNIT, RAMP_ONE, ramp_rounding(dims, 1.0, turns=True))
    return (scale_of(dims) * joint * (1 + turn_effect(longest(dims))) + parts["scaling"] + parts["gradient"]) * SAFE


def slope_error_parts(dims: int, lipschitz: float) -> dict[str, float]:
    """A component rounds before it is interpolated, and is then divided by 4 with it."""
    scale = scale_of(dims)
    rounding = slope_rounding(dims, ramp_rounding(dims, 1.0, turns=True), gradients=True) + MIXED_ROUNDING / 4 * 1.001
    fade = longest(dims) * largest_slope_fade_effect(dims, UNIT) * (1 + turn_effect(longest(dims)))
    return {"cut": lipschitz / ONE, "fade": scale * fade, "interpolation": scale * rounding / (RAMP_ONE / 4),
            "scaling": scaling_error(dims, OCTAHEDRAL, SLOPE_UNIT),
            "gradient": scale * turn_effect(longest(dims)) * largest(suprema.SLOPE, dims)}


# --- Bounds -----------------------------------------------------------------------------------------------------------

def range_of(dims: int) -> float:
    return scale_of(dims) * turns.perlin_range_of(dims)


def derive(dims: int, _: Gradient) -> Derived:
    exact = range_of(dims)
    lipschitz = scale_of(dims) * longest(dims) * largest(suprema.LIPSCHITZ, dims)
    cell_error = error_bound(dims)
    error = position_error(cell_error, lipschitz)
    parts = error_parts(dims, lipschitz)
    beyond = beyond_the_range(dims, parts)
    return Derived(1.0, exact, lipschitz, cell_error, error, exact + error, lipschitz / ONE + beyond, exact + beyond,
                   parts)


def derive_slope(dims: int) -> Derived:
    scale = scale_of(dims) * longest(dims)
    exact, lipschitz = scale * largest(suprema.SLOPE, dims), scale * largest(suprema.SLOPE_LIPSCHITZ, dims)
    cell_error = slope_error_bound(dims)
    error = position_error(cell_error, lipschitz)
    parts = slope_error_parts(dims, lipschitz)
    fixed_error = sum(parts.values()) * SAFE
    return Derived(0.0, exact, lipschitz, cell_error, error, exact + error, fixed_error,
                   exact + fixed_error - parts["cut"], parts)


def largest_difference(dims: int) -> float:
    """Of the values of two corners along an axis, or of what is interpolated behind both: at f along that axis and the
    ends of the others, their offsets are as long as sqrt(f^2 + n - 1) and sqrt((1 - f)^2 + n - 1). The sum is largest
    at an end. The roundings of the ramps and of interpolations are added."""
    rounding = ramp_rounding(dims, 1.0, turns=True) + dims * float(lerp_roundings().max())
    lengths = (math.sqrt(dims) + math.sqrt(dims - 1)) * (longest(dims) + turn_effect(longest(dims)))
    return lengths * RAMP_ONE + 2 * rounding


def largest_intermediates(dims: int, _: Gradient) -> dict[str, float]:
    difference = largest_difference(dims)
    ramp = longest(dims) * math.sqrt(dims) * RAMP_ONE + ramp_rounding(dims, 1.0, turns=True)
    return {**turned_intermediates(dims, longest(dims)), "ramp": ramp, "difference": difference,
            "lerp": part_intermediate(difference, np.array([2**18])),
            "scaled": scaled_intermediate(1 / scale_of(dims) * RAMP_ONE, fixed_scale(dims))}


def largest_slope_intermediates(dims: int, slope: float) -> dict[str, float]:
    """As slope_intermediates of integers.py."""
    climb = part_intermediate(largest_difference(dims) / 4 + 1, slopes())
    component_size = (longest(dims) + turn_effect(longest(dims))) * RAMP_ONE + 2 * MIXED_ROUNDING
    made = component_size / 4 + dims * float(lerp_roundings().max()) + 1 + climb
    largest_derivative = slope / scale_of(dims) * RAMP_ONE / 4
    return {"climb": climb, "scaled derivative": scaled_intermediate(largest_derivative, fixed_scale(dims)),
            **{f"derivative's {name}": value for name, value in interpolation_intermediates(made, dims).items()}}


def quotes() -> list[tuple[str, str]]:
    below = listed([range_of(dims) for dims, _ in CASES])
    return [("docs/accuracy.md", f"With a phase `hn_perlin` stays below {below} in 2D")]


def describe(dims: int, _: Gradient) -> dict[str, object]:
    return {"error_from_cell_to_nearest": error_bound(dims, 0.5)}
