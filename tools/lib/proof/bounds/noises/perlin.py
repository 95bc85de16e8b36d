"""hn_perlin and its derivatives, from docs/reference/contract.md, sections 6, 8 and 10; with a phase as in rotations.py,
with gradients at all phases. hn_perlin_d computes the value in the same steps, so it has the same bounds. Each component
of hn_perlin_vector (section 22) is hn_perlin with other hashes, and the bounds hold for any; see value.py.

RANGE. The scales of the octahedral gradient are multiples of 1/1024 below the inverse of the supremum before scaling.
It is 1/2 times 511/512 on the line, 1.03636 in space and 1.07346 in 4D. On the plane it is for gradients that
rotate with a phase, which have the same scale: 0.559017, in the middle of the cell, where gradients that do not rotate
reach 0.508437. In space gradients that rotate reach 1.16420 and have a scale of their own. The rest up to 1 is room for
the errors of the fixed arithmetic; in space the scale without a phase could be 3/1024 larger.

SINE GRADIENT. Its components are independent, |g_i| <= 1, and nothing is scaled. The range is exact: the supremum over
the gradients is the sum over the axes of

    (1 - u_i) f_i + u_i (1 - f_i) = 1/2 - (1 - 2 f_i) (1 - 2 u_i) / 2 <= 1/2

with u_i = s(f_i) (the weights of the other axes sum to 1, and u_i <= 1/2 just where f_i <= 1/2), so it is n/2, in the
middle of the cell.

FIXED. The value differs from the exact one by five things. FADE, LERP and RAMP are bounded together, for each box:

    CUT      a coordinate is cut to a multiple of 2^-20, by less than that: at most L * 2^-20.
    FADE     see integers.py. At the cut position the ramps are exact.
    LERP     see integers.py.
    RAMP     octahedral ramps are exact. With the sine gradient each axis rounds down by less than 1 unit of 2^-28; and
             g is off, see below.
    SCALE    (((n + 256) >> 9) * S + 256) >> 9 is off by at most 256 S / 2^18 + 1/2 units of 2^-21 (n >> 7 by less than
             1).

A derivative is off by the same: by L of the derivative times 2^-20, and FADE with the slope of a fade.
Its rounding is in integers.py (slope_rounding). Its unit is 2^-19.

FIXED RANGE. The scales of the octahedral gradient leave 1 less the range of the exact noise, more than FADE, LERP, RAMP and
SCALE together (CUT moves a position, not a value out of its range): |hn_perlin| <= 1. Octave sums round by less than 2
units of 2^-21 an octave (sums.py), 64 in 32 octaves; of the first, whose weight is 2^18, the same room is left.
With the sine gradient, t <= 1/2 for f < 1/2 and t >= 1/2 for f > 1/2 suffice for n/2, as there, up to LERP, RAMP and
SCALE; of components that exceed 1, n/2 times that is added.
"""

from __future__ import annotations

import functools
from dataclasses import replace

from proof.bounds import suprema
from proof.bounds.boxes import SAFE
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, SINE, Gradient
from proof.bounds.integers import (
    ONE,
    RAMP_ONE,
    SLOPE_UNIT,
    UNIT,
    fade_keeps_to_its_side,
    fixed_scale,
    interpolation_intermediates,
    largest_fade_effect,
    largest_joint_effect,
    largest_rounding,
    largest_slope_fade_effect,
    overshoot,
    scaled_intermediate,
    scaling_error,
    slope_intermediates,
    slope_rounding,
)
from proof.bounds.noises import Proof, ProvenBounds, derived, listed, of_components
from proof.bounds.rotations import Rotating
from proof.bounds.sine import fixed_sine_error, fixed_sine_largest
from proof.bounds.table import shortest

ACCURACY = "docs/measured/accuracy.md"
SCALE = {OCTAHEDRAL: {1: 2.0, 2: 1831 / 1024, 3: 985 / 1024, 4: 953 / 1024},
         ROTATED: {2: 1831 / 1024, 3: 879 / 1024}, SINE: {2: 1.0, 3: 1.0}}


def range_bound(dims, gradient):
    """A proven upper bound of |value|."""
    if gradient is SINE:
        return dims / 2
    return scaled(suprema.VALUE, dims, gradient)


def scaled(quantity, dims, gradient):
    return SCALE[gradient][dims] * suprema.largest(quantity, dims, gradient)


def lipschitz_bound(dims, gradient):
    """A proven upper bound of the L1 norm of the noise's gradient."""
    return scaled(suprema.LIPSCHITZ, dims, gradient)


def slope_bound(dims, gradient=OCTAHEDRAL):
    """A proven upper bound of |derivative|."""
    return scaled(suprema.SLOPE, dims, gradient)


def slope_lipschitz_bound(dims, gradient=OCTAHEDRAL):
    return scaled(suprema.SLOPE_LIPSCHITZ, dims, gradient)


# --- Fixed ------------------------------------------------------------------------------------------------------------

def ramp_rounding(dims, gradient):
    """In these units."""
    return dims if gradient is SINE else 0


def scale_error(dims, gradient, unit=UNIT):
    return unit if gradient is SINE else scaling_error(fixed_scale(SCALE[gradient][dims], dims), unit)


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
    total = lipschitz_bound(dims, gradient) / ONE + joint_effect(dims, gradient) + scale_error(dims, gradient)
    if gradient is SINE:  # sum_o w_o(s) sum_i |d_i| <= n/2; FADE moved the fixed gradients, which may exceed 1
        total += fixed_sine_error() * dims / 2 + fade_effect(dims, gradient) * (fixed_sine_largest() - 1)
    return total * SAFE


def error_parts(dims, gradient):
    """The largest of each part, for a reader: they are not attained together."""
    return {"cut": lipschitz_bound(dims, gradient) / ONE, "fade": fade_effect(dims, gradient),
            "interpolation": rounding_effect(dims, gradient), "scaling": scale_error(dims, gradient),
            "gradient": fixed_sine_error() * dims / 2 if gradient is SINE else 0.0}


@functools.cache
def range_loss(dims, gradient):
    """How far FADE, LERP, RAMP and SCALE can take a value beyond the largest exact one."""
    if gradient is OCTAHEDRAL:
        return (joint_effect(dims, gradient) + scale_error(dims, gradient)) * SAFE
    if not fade_keeps_to_its_side():
        raise ValueError("the fade is on the other side of 1/2 than the fraction")
    loss = rounding_effect(dims, gradient) + scale_error(dims, gradient)
    # Components that exceed 1, weights of other axes that leave [0, 1].
    return (loss + dims / 2 * (fixed_sine_largest() * (1 + 2 * overshoot()) ** dims - 1)) * SAFE


# --- Derivatives ------------------------------------------------------------------------------------------------------

def slope_error_parts(dims):
    scale, one = (of[OCTAHEDRAL][dims] for of in (SCALE, RAMP_ONE))
    return {"cut": slope_lipschitz_bound(dims) / ONE, "fade": scale * largest_slope_fade_effect(dims, OCTAHEDRAL),
            "interpolation": scale * slope_rounding(dims) / (one / 4),
            "scaling": scale_error(dims, OCTAHEDRAL, SLOPE_UNIT)}


# --- Overflow ---------------------------------------------------------------------------------------------------------

# The largest difference of two ramps, or of two values between ramps, along an axis: their offsets are f and 1 - f
# there, and at most 1 along other axes. For two ramps it is 4 in space, where both other axes are at an end, at corners
# without a weight: then 2^31 wraps, and the value does not depend on it. Else it is less, by 2^-20 or more. Behind an
# interpolation along x it is at most 7/2: h is at most 1 + max(x, f), or 1 + max(1 - x, f), and likewise for 1 - f, and
# the mean of x and 1 - x
# with the weights 1 - s(x) and s(x) is at most 1/2. For h is the sum of the two largest: max(x, f) + max(x, 1 - f)
# is at most 1 + x.
LARGEST_DIFFERENCE = {2: 7 / 4, 3: 7 / 2, 4: 4.0}
# Two derivatives in space have slopes of at most 15/8 times two such differences. The differences of four ramps with
# the offsets x, 1 - x and y, 1 - y are 4 ramps of at most 1 + max(|x|, |y|), which sum to at most 7: the maxima are
# convex in x and y, and sum to 3 at the ends. A component is at most 1.
LARGEST_DERIVATIVES_DIFFERENCE = {3: 15 / 8 * 7 + 2}


def largest_intermediates(dims, gradient):
    """(The fade and the sine are checked as evaluated.) The partial sums of a ramp are at most h(1, .., 1) times its
    one; with the sine gradient n * 2^28 and a rounding. An interpolated value is scaled: the range before the scale,
    with the errors of fixed arithmetic."""
    one = RAMP_ONE[gradient][dims]
    if gradient is SINE:
        ramp = dims * (one * fixed_sine_largest() + 1)
        between = interpolation_intermediates(ramp, dims)
        return {"ramp": ramp, **between, "scaled": between["value"]}
    ramp = gradient.reach(dims) * one
    largest = (range_bound(dims, gradient) + range_loss(dims, gradient)) / SCALE[gradient][dims] * one
    return {"ramp": ramp, **interpolation_intermediates(ramp, dims, LARGEST_DIFFERENCE[dims] * one),
            "scaled": scaled_intermediate(largest, fixed_scale(SCALE[OCTAHEDRAL][dims], dims))}


def largest_slope_intermediates(dims, slope):
    """The words of derivatives up to that."""
    one = RAMP_ONE[OCTAHEDRAL][dims]
    apart = LARGEST_DERIVATIVES_DIFFERENCE[dims] * one / 4 if dims == 3 else None
    largest = slope / SCALE[OCTAHEDRAL][dims] * one / 4
    return {**slope_intermediates(min(2 * OCTAHEDRAL.reach(dims), 4) * one, OCTAHEDRAL.component(dims) * one / 4, dims,
                                  apart),
            "scaled derivative": scaled_intermediate(largest, fixed_scale(SCALE[OCTAHEDRAL][dims], dims))}


# --- Proofs -----------------------------------------------------------------------------------------------------------

def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    exact, lipschitz = range_bound(dims, gradient), lipschitz_bound(dims, gradient)
    if is_of_text(dims, gradient):
        return derived(1.0, exact, lipschitz)
    return derived(exact if gradient is SINE else 1.0, exact, lipschitz, None,
                   error_parts(dims, gradient), fixed_error(dims, gradient), exact + range_loss(dims, gradient))


def is_of_text(dims: int, gradient: Gradient) -> bool:
    """Whether the text proves the errors of HN_FIXED (text.py)."""
    return gradient is OCTAHEDRAL and dims < 4


def derive_d(dims: int, gradient: Gradient) -> ProvenBounds:
    parts = None if is_of_text(dims, gradient) else slope_error_parts(dims)
    slope = derived(0.0, slope_bound(dims), slope_lipschitz_bound(dims), None, parts)
    return replace(derive(dims, gradient), slope=slope)


def with_parts(dims: int) -> ProvenBounds:
    """For the noise with a phase, with the parts of the errors of HN_FIXED."""
    of = derive_d(dims, OCTAHEDRAL)
    return replace(of, fixed_parts=error_parts(dims, OCTAHEDRAL),
                   slope=replace(of.slope, fixed_parts=slope_error_parts(dims)))


def largest_intermediates_d(dims: int, gradient: Gradient) -> dict[str, float]:
    largest = slope_bound(dims) + sum(slope_error_parts(dims).values())
    return largest_intermediates(dims, gradient) | largest_slope_intermediates(dims, largest)


def quotes() -> list[tuple[str, str]]:
    """The claims of prose on its range."""
    exact = [shortest(range_bound(dims, OCTAHEDRAL), 5) for dims in (1, 2, 3, 4)]
    below = f"{', '.join(exact[:3])} and {exact[3]}"
    return [("docs/reference/knobs.md", f"noise stays below {below} in 1D to 4D."), (ACCURACY, f"stays below {below}.")]


CASES = tuple((dims, OCTAHEDRAL) for dims in (1, 2, 3, 4))
PERLIN = Proof((*CASES, (2, SINE), (3, SINE)), derive, lambda dims, gradient: (
    {} if is_of_text(dims, gradient) else largest_intermediates(dims, gradient)), quotes=quotes)
PERLIN_D = Proof(CASES, derive_d, lambda dims, gradient: (
    {} if is_of_text(dims, gradient) else largest_intermediates_d(dims, gradient)))
PHASE, PHASE_D = Rotating(
    with_parts, lambda dims: [of(dims, ROTATED) for of in (range_bound, lipschitz_bound)],
    lambda dims: [of(dims, ROTATED) for of in (slope_bound, slope_lipschitz_bound)],
    lambda dims: SCALE[ROTATED][dims], lambda dims: SCALE[OCTAHEDRAL][dims]).proofs(
        CASES[1:3], largest_intermediates, largest_intermediates_d)
PROOFS = {
    "perlin": PERLIN, "perlin_d": PERLIN_D, "perlin_d_phase": PHASE_D,
    "perlin_phase": replace(PHASE, quotes=lambda: [
        (ACCURACY,
         f"With a phase `hn_perlin` stays below {listed([range_bound(dims, ROTATED) for dims in (2, 3)])} in 2D")]),
    "perlin_vector": of_components(PERLIN), "perlin_vector_d": of_components(PERLIN_D)}
