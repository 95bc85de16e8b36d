"""Section 13 of docs/reference/contract.md: simplex noise with its derivatives."""

from __future__ import annotations

from proof.oracle.kernels import noise_with_derivatives
from proof.oracle.noises.simplex import KERNELS

exact, fixed = noise_with_derivatives(KERNELS)
