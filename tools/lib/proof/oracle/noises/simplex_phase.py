"""Section 14 of docs/reference/contract.md: simplex noise with gradients that rotate."""

from __future__ import annotations

from dataclasses import replace

from proof.oracle.kernels import noise
from proof.oracle.noises import simplex

KERNELS = simplex.KERNELS | {3: replace(simplex.KERNELS[3], scale=4902)}

exact, fixed = noise(KERNELS)
