"""Section 14 of docs/contract.md: simplex noise whose gradients turn, with its derivatives."""

from __future__ import annotations

from oracle.kernels import noise_with_derivatives
from oracle.noises.simplex_phase import KERNELS

exact, fixed = noise_with_derivatives(KERNELS)
