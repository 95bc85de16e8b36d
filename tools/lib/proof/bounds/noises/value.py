"""Proofs for hn_value and its derivatives, from docs/reference/contract.md, sections 9 and 10. hn_value_d computes the
value in the same steps, so it has the same bounds.

Each component of hn_value_vector (section 22) is hn_value with other hashes, and the bounds hold for any. The hashes of
y and z are the low 32 bits of products of two factors below 2^24. So they are hashes, too, and their numbers are in the
range of hn_value's.

RANGE. The number of a corner is within +-1, and -1 occurs. The weights are not negative and sum to 1, so the value is
within +-1, too. A derivative is s'(f_1) times an interpolation of differences of two numbers: at most
15/8 * 2.

LIPSCHITZ. See suprema.py. At a corner's number within +-1, L is the largest sum_o |D w_o|.
"""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import suprema
from proof.bounds.boxes import FADE_MAX
from proof.bounds.gradients import Gradient
from proof.bounds.noises import Proof, ProvenBounds, of_components

STEEPEST = 2 * FADE_MAX[1]


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return ProvenBounds(1.0, 1.0, suprema.largest(suprema.LIPSCHITZ, dims, None))


def derive_slope(dims: int) -> ProvenBounds:
    lipschitz = suprema.largest(suprema.SLOPE_LIPSCHITZ, dims, None)
    return ProvenBounds(0.0, STEEPEST, lipschitz)


CASES = tuple((dims, None) for dims in (1, 2, 3, 4))
VALUE = Proof(CASES, derive)
VALUE_D = Proof(CASES, lambda dims, _: replace(derive(dims, None), slope=derive_slope(dims)))
PROOFS = {
    "value": VALUE,
    "value_d": VALUE_D,
    "value_vector": of_components(VALUE),
    "value_vector_d": of_components(VALUE_D)}
