"""hn_value: what is proven of it, from docs/contract.md, section 9.

RANGE. The number of a corner is an odd multiple of 2^-16 in (-1, 1), so at most LARGEST. The weights are not negative
and sum to 1, so the value is at most LARGEST, too, and reaches it at a lattice point. That leaves 2^-16 up to 1.

LIPSCHITZ. The noise is continuously differentiable, so |value(p) - value(q)| <= L max_i |p_i - q_i|, where L is the
largest L1 norm of its gradient: of sum_j sigma_j d/df_j, over the signs sigma. Reflecting axes makes all signs +1. With
D = sum_j d/df_j and a corner's number free within +-LARGEST, L = LARGEST * sup_f sum_o |D w_o|. For any one choice of
signs of the D w_o that sum is smooth. Its second derivative along an axis j is at most sum_o |d_jjj w_o| + the sum over
the other axes i of sum_o |d_jj d_i w_o|. An axis along which w is not differentiated gives the factor 1 (its two
weights), another twice the largest derivative of s.

FLOATS. The numbers are floats, exactly: they have 16 bits. Their interpolation is that of floats.py of the folder
above. The computed value is LARGEST plus the error at most, which is less than 1.

FIXED. The numbers are exact in units of 2^-29. The fixed value differs from the exact one by four things:

    CUT      a coordinate is cut to a multiple of 2^-20, by less than that: at most L * 2^-20.
    FADE     see integers.py. A corner's number is at most LARGEST at any offset.
    LERP     see integers.py.
    SCALE    (n + 128) >> 8 rounds to nearest, by 1/2 unit of 2^-21 at most.

FADE and LERP are bounded together, for each box. Only LERP and SCALE, and t where it leaves [0, 1], take a value out of
the range of the exact noise, by less than the 2^-16 that are left.
"""

from __future__ import annotations

import functools

from bounds.boxes import FADE_1, FADE_2, FADE_3, SAFE, slope_supremum, supremum, weights_and_slopes
from bounds.floats import Approx, approx_interpolation, approx_offsets, position_error
from bounds.gradients import Gradient
from bounds.integers import ONE, UNIT, fade_effect, interpolation_intermediates, overshoot, rounding_effect
from bounds.noises import Derived

GRADIENTS = (None,)
DIMENSIONS = (2, 3)

PROMISE = 1.0  # of the contract
LARGEST = 1 - 2.0**-16  # a corner's number
NUMBER_ONE = 2**29  # the unit of such a number in fixed arithmetic


@functools.cache
def steepest_slope(point: tuple[float, ...]) -> float:
    """The largest slope along (1, .., 1) that corners within +-1 give here."""
    return sum(abs(slope) for _, _, slope in weights_and_slopes(point))


@functools.cache
def lipschitz_bound(dims: int) -> float:
    curvature = 2 * FADE_3 + (dims - 1) * 2 * FADE_2 * 2 * FADE_1
    return LARGEST * slope_supremum(steepest_slope, curvature, dims)


def value_error(box: tuple[tuple[float, float], ...], ulps: float) -> float:
    """The largest error in floats from a cell and a fraction in the box."""
    numbers = [Approx(-LARGEST, LARGEST, 0.0, ulps)] * 2 ** len(box)
    return approx_interpolation(numbers, [approx_offsets(lo, hi, ulps)[0] for lo, hi in box]).err


@functools.cache
def error_bound(dims: int, ulps: float = 1.0) -> float:
    return supremum(functools.partial(value_error, ulps=ulps), ((0.0, 1.0),) * dims, 3000) * SAFE


def largest_number(_: object) -> float:
    """At any offset."""
    return LARGEST


def derive(dims: int, _: Gradient | None) -> Derived:
    lipschitz, cell_error = lipschitz_bound(dims), error_bound(dims)
    error = position_error(cell_error, lipschitz)
    fade, lerp, scaling = fade_effect(dims, largest_number), rounding_effect(dims) / NUMBER_ONE, UNIT / 2
    fixed_error = (lipschitz / ONE + (fade + lerp).max() + scaling) * SAFE
    fixed_largest = (LARGEST * (1 + 2 * overshoot()) ** dims + lerp.max() + scaling) * SAFE
    parts = {"cut": lipschitz / ONE, "fade": fade.max(), "interpolation": lerp.max(), "scaling": scaling}
    return Derived(PROMISE, LARGEST, lipschitz, cell_error, error, LARGEST + error, fixed_error, fixed_largest, parts)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    """A number is the difference of one below 2^30 and one below 2^29; rounding at the end adds 128."""
    return {"number": 2.0**30} | interpolation_intermediates(LARGEST * NUMBER_ONE, dims)


def quotes() -> list[tuple[str, str]]:
    return []


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"error_from_cell_to_nearest": error_bound(dims, 0.5)}
