"""hn_value_vector (docs/reference/contract.md, section 22): each component is hn_value with other words. What is proven of that
holds for any words. Those of y and z are products of two factors below 2^24, of which the low 32 bits stay. So they are
words, too, and their numbers are in the range of those of hn_value.
"""

from __future__ import annotations

from proof.bounds.noises import value

CASES = ((2, None), (3, None))
derive, largest_intermediates = value.derive, value.largest_intermediates
