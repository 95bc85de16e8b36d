"""The error of hn_perlin in fixed arithmetic (docs/contract.md, section 8), proven; that it stays in range, and that what
must not wrap does not.

HN_PERLIN. The fixed value differs from the exact one by five things, which are bounded together, for each box:

    CUT      a coordinate is cut to a multiple of 2^-20, by less than that. The noise at the cut position is off by at
             most L(f) * 2^-20, L(f) being the largest slope at a fraction (LIPSCHITZ in exact.py, here for all
             signs sigma; the way from p to the cut p is in the same box, or beyond the edge of the cell, in the box
             opposite, where L is the same by symmetry).
    FADE     see integers.py. At the cut position the ramps are exact.
    LERP     see integers.py.
    RAMP     of the sine gradient only: each axis rounds down by less than 1 unit of 2^-28; and g is off, see below.
    SCALE    (((n + 256) >> 9) * S + 256) >> 9 is off by at most 256 S / 2^18 + 1/2 units of 2^-21 (n >> 7 by less than
             1).

CUT is smooth in a box up to the choice of gradients, and bounded by its values at the vertices and its second
derivatives.

RANGE. The octahedral gradients of the library leave 1 - library_range of exact.py, more than FADE, LERP and
SCALE together (CUT moves a position, not a value out of its range): |hn_perlin| <= 1. Octave sums round by less than 2
units of 2^-21 an octave (sums.py), 64 in 32 octaves; of the first, whose weight is 2^18, the same room is left.
With the sine gradient, t <= 1/2 for f < 1/2 and t >= 1/2 for f > 1/2 suffice for n/2, as there, up to LERP, RAMP and
SCALE; of components that exceed 1, n/2 times that is added.
"""

import functools
import itertools

import numpy as np

from bounds.boxes import SAFE, fade
from bounds.gradients import OCTAHEDRAL, SINE
from bounds.integers import (BOXES, ONE, UNIT, fade_effect, fade_keeps_to_its_side, grids, interpolation_intermediates,
                             overshoot, rounding_effect, vertices_max)
from bounds.noises.perlin.exact import SCALE, slope_curvature
from bounds.sine import fixed_sine_error, fixed_sine_largest

RAMP_ONE = {OCTAHEDRAL: 2**29, SINE: 2**28}


def largest_ramp(offsets):
    """The largest that a ramp of an octahedral gradient can be."""
    return functools.reduce(np.maximum, map(np.abs, offsets))


def largest_sine_ramp(offsets):
    return sum(map(np.abs, offsets))


LARGEST_RAMP = {OCTAHEDRAL: largest_ramp, SINE: largest_sine_ramp}


@functools.cache
def slopes(dims, gradient):
    """For each box, a bound of L(f), unscaled."""
    f = grids(np.linspace(0, 1, BOXES[dims] + 1), dims)
    s, ds = [fade(x) for x in f], [30 * (x * (1 - x)) ** 2 for x in f]
    largest = np.zeros([BOXES[dims] + 1] * dims)
    for signs in itertools.product((1, -1), repeat=dims - 1):
        signs, total = (1, *signs), 0.0
        for corner in itertools.product((0, 1), repeat=dims):
            weight, slope = 1.0, 0.0
            for i, o in enumerate(corner):
                factor, factor_slope = (s[i], signs[i] * ds[i]) if o else (1 - s[i], -signs[i] * ds[i])
                weight, slope = weight * factor, slope * factor + weight * factor_slope
            total = total + LARGEST_RAMP[gradient]([sign * weight + slope * (x - o)
                                               for sign, x, o in zip(signs, f, corner)])
        largest = np.maximum(largest, total)
    return vertices_max(largest) + slope_curvature(dims, gradient.support) / 8 * dims / BOXES[dims] ** 2


def ramp_fade_effect(dims, gradient):
    """For each box, a bound of FADE, unscaled."""
    return fade_effect(dims, LARGEST_RAMP[gradient])


def ramp_rounding_effect(dims, gradient):
    """For each box, a bound of LERP and RAMP, unscaled."""
    return rounding_effect(dims, dims if gradient is SINE else 0) / RAMP_ONE[gradient]


def scaling_error(dims, gradient):
    return (1 if gradient is SINE else 256 * SCALE[gradient][dims] * 1024 / 2**18 + 1 / 2) * UNIT


@functools.cache
def fixed_error(dims, gradient):
    """A proven upper bound of the error of hn_perlin in fixed arithmetic, from a position or a cell and a fraction."""
    boxes = slopes(dims, gradient) / ONE + ramp_fade_effect(dims, gradient) + ramp_rounding_effect(dims, gradient)
    total = SCALE[gradient][dims] * boxes.max() + scaling_error(dims, gradient)
    if gradient is SINE:  # sum_o w_o(s) sum_i |d_i| <= n/2; FADE moved the fixed gradients, which may exceed 1
        total += fixed_sine_error() * dims / 2 + ramp_fade_effect(dims, gradient).max() * (fixed_sine_largest() - 1)
    return total * SAFE


def error_parts(dims, gradient):
    """The largest of each part, for a reader: they are not attained together."""
    scale = SCALE[gradient][dims]
    return {"cut": scale * slopes(dims, gradient).max() / ONE, "fade": scale * ramp_fade_effect(dims, gradient).max(),
            "interpolation": scale * ramp_rounding_effect(dims, gradient).max(), "scaling": scaling_error(dims, gradient),
            "gradient": fixed_sine_error() * dims / 2 if gradient is SINE else 0.0}


@functools.cache
def range_loss(dims, gradient):
    """How far FADE, LERP, RAMP and SCALE can take a value beyond the largest exact one."""
    boxes = ramp_rounding_effect(dims, gradient)
    if gradient is OCTAHEDRAL:
        boxes = boxes + ramp_fade_effect(dims, gradient)
    elif not fade_keeps_to_its_side():
        raise ValueError("the fade is on the other side of 1/2 than the fraction")
    loss = SCALE[gradient][dims] * boxes.max() + scaling_error(dims, gradient)
    if gradient is SINE:  # components that exceed 1, weights of other axes that leave [0, 1]
        loss += dims / 2 * (fixed_sine_largest() * (1 + 2 * overshoot()) ** dims - 1)
    return loss * SAFE


# --- Overflow ---------------------------------------------------------------------------------------------------------

def largest_intermediates(dims, gradient):
    """(The fade and the sine are checked as evaluated.) A ramp is at most its one: 2^29 for the octahedron, as
    |a| |D| + |m| |D'| <= 512 * 2^20, and of the partial sums in space
    |p (Dx + Dy) + q (Dx - Dy)| <= P * 2 max |D| <= 255 * 2^21; n * 2^28 and a rounding for the cube."""
    largest = RAMP_ONE[gradient] if gradient is OCTAHEDRAL else dims * (RAMP_ONE[gradient] * fixed_sine_largest() + 1)
    between = interpolation_intermediates(largest, dims)
    scaled = between["value"]
    if gradient is OCTAHEDRAL:
        scaled = (scaled / 2**9 + 1) * 1024 * SCALE[gradient][dims] + 256
    return {"ramp": largest, **between, "scaled": scaled}
