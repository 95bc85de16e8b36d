"""Section 14 of docs/reference/contract.md: Perlin noise whose gradients rotate, as those of the lattice do."""

from __future__ import annotations

from proof.oracle.noises.perlin import exact, fixed

__all__ = ["exact", "fixed"]
