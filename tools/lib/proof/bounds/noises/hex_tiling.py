"""Proofs for the weights and vectors of hn_hex_tiling, from docs/reference/contract.md, section 20. One bound
holds for both.

RANGE. Weights are from 0 to 1. A vector from a corner stays within the hexagon around it: half a cell along each axis.

LIPSCHITZ. A weight changes as X, as Y or as X - Y, which change by at most 3 where the coordinates change by 1. A
vector changes by 1.
"""

from __future__ import annotations

from proof.bounds.gradients import Gradient
from proof.bounds.integers import ONE
from proof.bounds.noises import Proof, ProvenBounds

LIPSCHITZ = 3.0
LARGEST_SKEWED = 3.0  # X, at the end of a cell


def derive(_: int, __: Gradient | None) -> ProvenBounds:
    return ProvenBounds(1.0, 1.0, LIPSCHITZ)


PROOFS = {"hex_tiling": Proof(((2, None),), derive, lambda *_: {"skewed": LARGEST_SKEWED * ONE})}
