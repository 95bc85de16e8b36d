"""Section 14 of docs/reference/contract.md: simplex noise whose gradients rotate, with its derivatives."""

from __future__ import annotations

from proof.oracle.noises.simplex_d import exact, fixed

__all__ = ["exact", "fixed"]
