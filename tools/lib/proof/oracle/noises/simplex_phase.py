"""Section 14 of docs/reference/contract.md: simplex noise whose gradients rotate, as those of the lattice do."""

from __future__ import annotations

from proof.oracle.noises.simplex import exact, fixed

__all__ = ["exact", "fixed"]
