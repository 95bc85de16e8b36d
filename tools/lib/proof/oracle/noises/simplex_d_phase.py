"""Section 14 of docs/reference/contract.md: simplex noise whose gradients rotate, with its derivatives."""

from __future__ import annotations

from proof.oracle.kernels import noise_with_derivatives
from proof.oracle.noises.simplex_phase import KERNELS

exact, fixed = noise_with_derivatives(KERNELS)
