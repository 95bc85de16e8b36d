"""Proofs for the weights and vectors of hn_hex_tiling, from docs/reference/contract.md, section 20. One bound
holds for both.

RANGE. Weights are from 0 to 1. A vector from a corner stays within the hexagon around it: half a cell along each axis.

LIPSCHITZ. A weight changes as X, as Y or as X - Y, which change by at most 3 where the coordinates change by 1. A
vector changes by 1.

FLOATS, in steps; a cell has two:

    X = 2*x + y;  Y = 2*y;  u = X - floor(X);  v = Y - floor(Y)
    1 - u, u - v, v    or, unless u > v,    1 - v, v - u, u
    a = u - v/2;  a or a - 1 or a + 1/2 or a - 1/2;    v or v - 1;    halved

X is below 4 and rounds by up to 2^-22: SKEWED. u and v are exact after that, as are halves. Where that moves X over a
whole number, the corners are on the other side; where it moves u over v, the weights of both sides differ by no
more than u moved. Each difference is at most 1 and rounds by up to 2^-24: ONE. So a weight is off by SKEWED and ONE,
and a vector by half of SKEWED and twice ONE, which is less.

FIXED. A coordinate is cut to a multiple of 2^-20, which moves it by less than that. There is no other error.
"""

from __future__ import annotations

from proof.bounds.floats import TINY, position_error, rounding
from proof.bounds.gradients import Gradient
from proof.bounds.integers import ONE
from proof.bounds.noises import Proof, ProvenBounds
from proof.bounds.table import scientific

LIPSCHITZ = 3.0
LARGEST_SKEWED = 3.0  # X, at the end of a cell
BELOW_ONE = 1 - 2.0**-24


def skewed_error() -> float:
    """The error of X, and so of u; a coordinate that is subnormal may be 0."""
    return rounding(LARGEST_SKEWED) + 3 * TINY


def weight_error() -> float:
    """From a cell."""
    return skewed_error() + rounding(BELOW_ONE)


def offset_error(_: int, fixed: bool) -> float:
    """The error of a component of a vector, in cells."""
    if fixed:
        return 1 / ONE
    return position_error((skewed_error() + 2 * rounding(BELOW_ONE)) / 2, 1.0)


def derive(_: int, __: Gradient | None) -> ProvenBounds:
    cell_error, cut = weight_error(), LIPSCHITZ / ONE
    return ProvenBounds(1.0, 1.0, LIPSCHITZ, cell_error, position_error(cell_error, LIPSCHITZ), 1.0, cut, 1.0, {"cut": cut})


PROOFS = {"hex_tiling": Proof(
    ((2, None),), derive, lambda *_: {"skewed": LARGEST_SKEWED * ONE},
    offset_error=offset_error,
    quotes=lambda: [("docs/measured/accuracy.md", f"vector is within {scientific(offset_error(2, False))} cells")])}
