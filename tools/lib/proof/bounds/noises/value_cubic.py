"""Proofs for hn_value_cubic, from docs/reference/contract.md, section 11.

RANGE. The weights b of an axis are not negative and sum to 1, so the value is within +-1, as the numbers are.

LIPSCHITZ. L is the largest sum over the 4^n points of |D B|, D the derivative along (1, .., 1) and B the product of the
weights: as in suprema.py, with points for corners. Along an axis sum |b'| is at most 3/2 (in the middle), sum |b''| is
f + 1 - f + |3 f - 2| + |1 - 3 f|, at most 4, and sum |b'''| is 8. So the second derivative along an axis, of D B for
any signs, is at most 8 + (n - 1) * 4 * 3/2.
"""

from __future__ import annotations

import functools
import itertools

import numpy as np

from proof.bounds.boxes import cell, smooth, supremum
from proof.bounds.gradients import Gradient
from proof.bounds.noises import Proof, ProvenBounds

TOLERANCE, LEVELS = 1e-4, {1: 16, 2: 12, 3: 9}


def weights(f):
    """b_-1 to b_2, exactly."""
    g = 1 - f
    return g**3 / 6, 2 / 3 - f**2 + f**3 / 2, 2 / 3 - g**2 + g**3 / 2, f**3 / 6


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


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return ProvenBounds(1.0, 1.0, lipschitz_bound(dims))


PROOFS = {"value_cubic": Proof(tuple((dims, None) for dims in (1, 2, 3)), derive)}
