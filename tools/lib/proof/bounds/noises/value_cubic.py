"""Proofs for hn_value_cubic, from docs/reference/contract.md, section 11.

RANGE. The weights b of an axis are not negative and sum to 1, so the value is within +-1, as the numbers are.

LIPSCHITZ. L is the largest sum over the 4^n points of |D B|, D the derivative along (1, .., 1) and B the product of the
weights: as in suprema.py, with points for corners. Along an axis sum |b'| is at most 3/2 (in the middle), sum |b''| is
f + 1 - f + |3 f - 2| + |1 - 3 f|, at most 4, and sum |b'''| is 8. So the second derivative along an axis, of D B for
any signs, is at most 8 + (n - 1) * 4 * 3/2.

FLOATS. See floats.py: numbers with 3 added, weights, and sums of four products along each axis.

FIXED. The fixed numbers are the exact ones. The fixed value differs from the exact one by four things:

    CUT      a coordinate is cut to a multiple of 2^-20, and rounded to one of 2^-15: L * (2^-20 + 2^-16).
    WEIGHTS  at x, the four weights of an axis are off by |e| of sum E at most, evaluated for all x. The products of
             the weights change by at most (1 + E)^n - 1 in sum.
    BLEND    four products round down by at most the number evaluated for all weights; the sums of |b| are 1.
    SCALE    (n + 128) >> 8 rounds to nearest, by 1/2 unit of 2^-21 at most.
"""

from __future__ import annotations

import functools
import itertools

import numpy as np

from proof.bounds.boxes import SAFE, cell, smooth, supremum
from proof.bounds.floats import (
    Approx,
    approx_blend,
    approx_offsets,
    approx_spline,
    error_supremum,
    spline_weight,
)
from proof.bounds.gradients import Gradient
from proof.bounds.integers import (
    FADE_ONE,
    ONE,
    SPLINE_STEP,
    UNIT,
    part_intermediate,
    spline_rounding,
    spline_weight_error,
    splines,
)
from proof.bounds.noises import Proof, ProvenBounds, derived
from proof.bounds.noises.value import NUMBER_ONE, OFFSET

TOLERANCE, LEVELS = 1e-4, {1: 16, 2: 12, 3: 9}


def weights(f):
    """b_-1 to b_2, exactly."""
    (last, second), (first, third) = spline_weight(f), spline_weight(1 - f)
    return first, second, third, last


def weight_slopes(f):
    g = 1 - f
    return -g * g / 2, 1.5 * f * f - 2 * f, 2 * g - 1.5 * g * g, f * f / 2


def steepest(point: np.ndarray) -> np.ndarray:
    """sum |D B| at the points: axes by points."""
    along = [list(zip(weights(f), weight_slopes(f))) for f in point]
    total = 0.0
    for factors in itertools.product(*along):
        product, slope = 1.0, 0.0
        for b, db in factors:
            product, slope = product * b, slope * b + product * db
        total = total + abs(slope)
    return total


@functools.cache
def lipschitz_bound(dims: int) -> float:
    curvature = dims * (8 + (dims - 1) * 4 * 1.5)
    bound = smooth(steepest, lambda boxes: np.full(boxes.index.shape[1], curvature))
    return supremum(bound, cell(dims), LEVELS[dims], TOLERANCE, 0)


def value_error(lo, hi):
    """The largest error in floats from a cell and a fraction in each box, given by its ends along each axis."""
    value = Approx.within(1.0)
    for a, b in zip(lo, hi):
        value = approx_blend(value, approx_spline(approx_offsets(a, b)[0]), OFFSET)
    return value.err


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    if splines().min() < 0 or (splines().sum(axis=0) != FADE_ONE).any():
        raise ValueError("a weight is negative, or the weights do not sum to 1")
    lipschitz, cell_error = lipschitz_bound(dims), error_supremum(value_error, dims)
    parts = {"cut": lipschitz * (1 / ONE + SPLINE_STEP / 2), "weights": (1 + spline_weight_error()) ** dims - 1,
             "interpolation": dims * spline_rounding() / NUMBER_ONE, "scaling": UNIT / 2}
    fixed_largest = 1 + parts["interpolation"] + parts["scaling"]
    return derived(1.0, 1.0, lipschitz, cell_error, parts, fixed_largest=fixed_largest * SAFE)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    """A sum of four parts is at most as large as the numbers, with its roundings, since the weights sum to 1. (The
    words of the weights are checked as evaluated.)"""
    value = NUMBER_ONE + dims * spline_rounding()
    return {"number": 2.0**30, "part": part_intermediate(value, splines()), "blend": value + 128}


PROOFS = {"value_cubic": Proof(tuple((dims, None) for dims in (1, 2, 3)), derive, largest_intermediates)}
