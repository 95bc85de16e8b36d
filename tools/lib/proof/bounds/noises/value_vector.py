"""hn_value_vector (docs/reference/contract.md, section 22): each component is hn_value with other hashes. The bounds of
hn_value hold for any hashes. The hashes of y and z are the low 32 bits of products of two factors below 2^24. So they
are
hashes, too, and their numbers are in the range of hn_value's."""

from __future__ import annotations

from proof.bounds.noises import value

CASES = ((2, None), (3, None))
derive, largest_intermediates = value.derive, value.largest_intermediates
