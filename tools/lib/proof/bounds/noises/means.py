"""The ranges of hn_value, hn_value_cubic, hn_hex_tiling and hn_random (docs/reference/contract.md, sections 9 to 11, 17, 20).

HN_VALUE, HN_VALUE_CUBIC. The number of a corner is within +-1, and -1 occurs. The weights are not negative and sum to 1,
so the value is within +-1, too. A derivative of hn_value is s'(f_1) times an interpolation of differences of two numbers:
at most 15/8 * 2. Each component of hn_value_vector (section 22) is hn_value with other
hashes: for y and z the low 32 bits of products of two factors below 2^24. So their numbers are in the range of hn_value's.

HN_HEX_TILING. Weights are from 0 to 1. A vector from a corner stays within the hexagon around it: half a cell along each
axis.

HN_RANDOM. A word's upper 24 bits, divided by 2^24: from 0 to 1 - 2^-24.
"""

from __future__ import annotations

from dataclasses import replace

from proof.bounds.boxes import FADE_MAX
from proof.bounds.noises import Proof, ProvenBounds, of_components

WITHIN_1 = ProvenBounds(1.0, 1.0)


def cases(*dims: int) -> tuple[tuple[int, None], ...]:
    return tuple((of, None) for of in dims)


VALUE = Proof(cases(1, 2, 3, 4), lambda *_: WITHIN_1)
VALUE_D = Proof(VALUE.cases, lambda *_: replace(WITHIN_1, slope=ProvenBounds(0.0, 2 * FADE_MAX[1])))
PROOFS = {
    "value": VALUE, "value_d": VALUE_D, "value_vector": of_components(VALUE), "value_vector_d": of_components(VALUE_D),
    "value_cubic": Proof(cases(1, 2, 3), lambda *_: WITHIN_1),
    "hex_tiling": Proof(cases(2), lambda *_: WITHIN_1),
    "random": Proof(cases(1, 2, 3, 4), lambda *_: ProvenBounds(1.0, 1 - 2.0**-24), least=lambda _: 0.0)}
