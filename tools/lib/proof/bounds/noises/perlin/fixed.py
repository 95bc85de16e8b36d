"""The error of hn_perlin and of the derivatives of hn_perlin_d in fixed arithmetic (docs/reference/contract.md,
sections 8 and 10), proven; that the noise stays in range, and that nothing wraps that must not.

HN_PERLIN. The fixed value differs from the exact one by five things. FADE, LERP and RAMP are bounded together, for each
box:

    CUT      a coordinate is cut to a multiple of 2^-20, by less than that: at most L * 2^-20.
    FADE     see integers.py. At the cut position the ramps are exact.
    LERP     see integers.py.
    RAMP     octahedral ramps are exact. With the sine gradient each axis rounds down by less than 1 unit of 2^-28; and
             g is off, see below.
    SCALE    (((n + 256) >> 9) * S + 256) >> 9 is off by at most 256 S / 2^18 + 1/2 units of 2^-21 (n >> 7 by less than
             1).

HN_PERLIN_D. A derivative is off by the same: by L of the derivative times 2^-20, and FADE with the slope of a fade.
Its rounding is in integers.py (slope_rounding). Its unit is 2^-19.

RANGE. The scales of the octahedral gradient leave 1 less the range of exact.py, more than FADE, LERP, RAMP and
SCALE together (CUT moves a position, not a value out of its range): |hn_perlin| <= 1. Octave sums round by less than 2
units of 2^-21 an octave (sums.py), 64 in 32 octaves; of the first, whose weight is 2^18, the same room is left.
With the sine gradient, t <= 1/2 for f < 1/2 and t >= 1/2 for f > 1/2 suffice for n/2, as there, up to LERP, RAMP and
SCALE; of components that exceed 1, n/2 times that is added.
"""

import functools

from proof.bounds.boxes import SAFE
from proof.bounds.gradients import OCTAHEDRAL, SINE
from proof.bounds.integers import (
    ONE,
    SLOPE_UNIT,
    UNIT,
    fade_keeps_to_its_side,
    interpolation_intermediates,
    largest_fade_effect,
    largest_joint_effect,
    largest_rounding,
    largest_slope_fade_effect,
    overshoot,
    scaled_intermediate,
    slope_intermediates,
    slope_rounding,
)
from proof.bounds.noises.perlin.exact import SCALE, lipschitz_bound, range_bound, slope_lipschitz_bound
from proof.bounds.sine import fixed_sine_error, fixed_sine_largest

RAMP_ONE = {OCTAHEDRAL: {1: 2**29, 2: 2**29, 3: 2**29, 4: 2**28}, SINE: {2: 2**28, 3: 2**28}}


def ramp_rounding(dims, gradient):
    """In these units."""
    return dims if gradient is SINE else 0


def fixed_scale(dims):
    """S of the contract; the ramps in 4D have units twice as large."""
    return round(SCALE[OCTAHEDRAL][dims] * 1024) * (2**29 // RAMP_ONE[OCTAHEDRAL][dims])


def scaling_error(dims, gradient, unit=UNIT):
    return (1 if gradient is SINE else 256 * fixed_scale(dims) / 2**18 + 1 / 2) * unit


@functools.cache
def joint_effect(dims, gradient):
    """FADE, LERP and RAMP."""
    effect = largest_joint_effect(dims, gradient, RAMP_ONE[gradient][dims], ramp_rounding(dims, gradient))
    return SCALE[gradient][dims] * effect


def rounding_effect(dims, gradient):
    """LERP and RAMP alone."""
    rounding = largest_rounding(dims, ramp_rounding(dims, gradient))
    return SCALE[gradient][dims] * rounding / RAMP_ONE[gradient][dims]


def fade_effect(dims, gradient):
    return SCALE[gradient][dims] * largest_fade_effect(dims, gradient)


@functools.cache
def fixed_error(dims, gradient):
    """A proven upper bound of the error of hn_perlin in fixed arithmetic, from a position or a cell and a fraction."""
    total = lipschitz_bound(dims, gradient) / ONE + joint_effect(dims, gradient) + scaling_error(dims, gradient)
    if gradient is SINE:  # sum_o w_o(s) sum_i |d_i| <= n/2; FADE moved the fixed gradients, which may exceed 1
        total += fixed_sine_error() * dims / 2 + fade_effect(dims, gradient) * (fixed_sine_largest() - 1)
    return total * SAFE


def error_parts(dims, gradient):
    """The largest of each part, for a reader: they are not attained together."""
    return {"cut": lipschitz_bound(dims, gradient) / ONE, "fade": fade_effect(dims, gradient),
            "interpolation": rounding_effect(dims, gradient), "scaling": scaling_error(dims, gradient),
            "gradient": fixed_sine_error() * dims / 2 if gradient is SINE else 0.0}


@functools.cache
def range_loss(dims, gradient):
    """How far FADE, LERP, RAMP and SCALE can take a value beyond the largest exact one."""
    if gradient is OCTAHEDRAL:
        return (joint_effect(dims, gradient) + scaling_error(dims, gradient)) * SAFE
    if not fade_keeps_to_its_side():
        raise ValueError("the fade is on the other side of 1/2 than the fraction")
    loss = rounding_effect(dims, gradient) + scaling_error(dims, gradient)
    # Components that exceed 1, weights of other axes that leave [0, 1].
    return (loss + dims / 2 * (fixed_sine_largest() * (1 + 2 * overshoot()) ** dims - 1)) * SAFE


# --- Derivatives ------------------------------------------------------------------------------------------------------

def slope_error_parts(dims):
    scale, one = (of[OCTAHEDRAL][dims] for of in (SCALE, RAMP_ONE))
    return {"cut": slope_lipschitz_bound(dims) / ONE, "fade": scale * largest_slope_fade_effect(dims, OCTAHEDRAL),
            "interpolation": scale * slope_rounding(dims, gradients=True) / (one / 4),
            "scaling": scaling_error(dims, OCTAHEDRAL, SLOPE_UNIT)}


# --- Overflow ---------------------------------------------------------------------------------------------------------

# The largest difference of two ramps, or of two values between ramps, along an axis: their offsets are f and 1 - f
# there, and at most 1 along other axes. For two ramps it is 4 in space, where both other axes are at an end, at corners
# without a weight: then 2^31 wraps, and the value does not depend on it. Else it is less, by 2^-20 or more. Behind an
# interpolation along x it is at most 7/2: h is at most 1 + max(x, f), or 1 + max(1 - x, f), and likewise for 1 - f, and
# the mean of x and 1
# - x with the weights 1 - s(x) and s(x) is at most 1/2. For h is the sum of the two largest: max(x, f) + max(x, 1 - f)
# is at most 1 + x.
LARGEST_DIFFERENCE = {1: 1.0, 2: 7 / 4, 3: 7 / 2, 4: 4.0}
# Two derivatives in space have slopes of at most 15/8 times two such differences. The differences of four ramps with
# the offsets x, 1 - x and y, 1 - y are 4 ramps of at most 1 + max(|x|, |y|), which sum to at most 7: the maxima are
# convex in x and y, and sum to 3 at the ends. A component is at most 1.
LARGEST_DERIVATIVES_DIFFERENCE = {3: 15 / 8 * 7 + 2}


def largest_intermediates(dims, gradient):
    """(The fade and the sine are checked as evaluated.) The partial sums of a ramp are at most h(1, .., 1) times its
    one;
    with the sine gradient n * 2^28 and a rounding. An interpolated value is scaled: the range before the scale, with
    the
    errors of fixed arithmetic."""
    one = RAMP_ONE[gradient][dims]
    if gradient is SINE:
        ramp = dims * (one * fixed_sine_largest() + 1)
        between = interpolation_intermediates(ramp, dims)
        return {"ramp": ramp, **between, "scaled": between["value"]}
    ramp = gradient.reach(dims) * one
    largest = (range_bound(dims, gradient) + range_loss(dims, gradient)) / SCALE[gradient][dims] * one
    return {"ramp": ramp, **interpolation_intermediates(ramp, dims, LARGEST_DIFFERENCE[dims] * one),
            "scaled": scaled_intermediate(largest, fixed_scale(dims))}


def largest_slope_intermediates(dims, slope):
    """The words of derivatives up to that."""
    one = RAMP_ONE[OCTAHEDRAL][dims]
    apart = LARGEST_DERIVATIVES_DIFFERENCE[dims] * one / 4 if dims == 3 else None
    largest = slope / SCALE[OCTAHEDRAL][dims] * one / 4
    return {**slope_intermediates(min(2 * OCTAHEDRAL.reach(dims), 4) * one, OCTAHEDRAL.component(dims) * one / 4, dims,
                                  apart),
            "scaled derivative": scaled_intermediate(largest, fixed_scale(dims))}
