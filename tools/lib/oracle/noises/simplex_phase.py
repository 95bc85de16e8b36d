"""Section 14 of docs/contract.md: simplex noise whose gradients turn."""

from __future__ import annotations

from dataclasses import replace

from oracle.kernels import noise
from oracle.noises import simplex

# Only in the plane is the scale another one.
KERNELS = {2: replace(simplex.KERNELS[2], scale=5810), 3: simplex.KERNELS[3]}

exact, fixed = noise(KERNELS)
