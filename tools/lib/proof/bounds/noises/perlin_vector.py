"""hn_perlin_vector (docs/reference/contract.md, section 22): each component is hn_perlin with other hashes. The bounds
of
hn_perlin hold for any hashes; see value_vector.py."""

from __future__ import annotations

from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.noises import perlin

CASES = ((2, OCTAHEDRAL), (3, OCTAHEDRAL))
derive, largest_intermediates = perlin.derive, perlin.largest_intermediates
