"""The domain of octave sums with slopes, and of warps, in fixed arithmetic: where nothing leaves 32 bits, for any noise."""

from __future__ import annotations

import math

import catalog.model
from proof.bounds.sums import LARGEST_STRENGTH, ROTATIONS, SHIFTS
from proof.bounds.table import Bounds, slope_bounds_of

FADE_ONE = 2**18  # the unit of weights
UNIT, SLOPE_UNIT = 2.0**-21, 2.0**-19  # of a value, and of a derivative
LARGEST_GROWTH, LARGEST_SHIFT = 64.0, 256.0  # for which the bounds are promised
LARGEST_RISE = 4000.0  # the same of the growths' sum times the longest gradient
SLOPE_LIMIT = 128.0  # of a component, beyond which it is cut off
FALL_LIMIT = 8.0  # the same of what hn_eroded sums of slopes
FALL_UNIT = 2.0**-12
LARGEST_AMPLITUDE = max(LARGEST_STRENGTH[kind] for kind in SHIFTS)
FITTING = tuple(noise.name + phase for noise in catalog.model.read().noises  # what hn_add takes
                if noise.shape in ("slopes", "distance_with_slopes") for phase in ("", "_phase")[:1 + ("phase" in noise.options)])


def stretch(dims: int) -> float:
    """How much the rotations between two octaves stretch a length."""
    return math.prod(ROTATIONS[:dims - 1])


def fitting_slopes() -> list[Bounds]:
    """The bounds of the derivatives of the noises that fit the hn_add of a loop with slopes."""
    return [slope_bounds_of(name, dims) for name in FITTING for dims in (2, 3)]


def longest_gradient(noise: Bounds, slope: Bounds) -> float:
    """How long the vector of all derivatives is at most: the sum of their sizes is at most L."""
    full, rest = divmod(noise.lipschitz, slope.limit)
    return min(math.sqrt(full * slope.limit**2 + rest**2), math.sqrt(noise.dimensions) * slope.limit)


# --- Overflow ---------------------------------------------------------------------------------------------------------

def largest_intermediates(dims: int) -> dict[str, float]:
    """By name, bounds of the magnitudes that must stay below 2^31 where the bounds are promised, for any noise with
    derivatives: gain * lacunarity is then at most 63, since the first octave adds 1 to the sum. In a Jacobian a number
    is rounded down by less than 5 units for each octave, and earlier losses grow as the Jacobian does."""
    stretched = stretch(dims)**31
    jacobian = stretched * ((LARGEST_GROWTH - 1) * FADE_ONE + 5 * LARGEST_GROWTH)
    slope, vector = math.sqrt(dims) * SLOPE_LIMIT, math.sqrt(dims) / UNIT
    falls = ((25 + 20) / 32) ** (dims - 1) * FALL_LIMIT
    return {
        "Jacobian": jacobian, "rotation of a Jacobian": 32 * ROTATIONS[0] * jacobian,
        "sum of slopes": (stretched * (LARGEST_RISE + 5 * 32 * LARGEST_GROWTH / FADE_ONE * slope) / SLOPE_UNIT
                          + 32 * dims),
        "step": jacobian / FADE_ONE * vector + dims,
        "rotation of a fall": (25 + 20) * FALL_LIMIT / FALL_UNIT, "sum of falls": (falls + SLOPE_LIMIT) / FALL_UNIT,
        "step of a position": (LARGEST_SHIFT * stretched * (1 + 5 * LARGEST_GROWTH / FADE_ONE) * vector
                               + LARGEST_AMPLITUDE * dims + 1),
        "shift": LARGEST_AMPLITUDE / UNIT}


def largest_words(dims: int) -> dict[str, float]:
    """The largest words, which are below 2^32."""
    squares, strength = dims * (FALL_LIMIT / FALL_UNIT)**2, LARGEST_STRENGTH["eroded"]
    return {"squares": squares, "divisor": 2.0**16 + squares * strength * FADE_ONE / 2**26}
