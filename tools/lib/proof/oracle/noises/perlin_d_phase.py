"""Section 14 of docs/reference/contract.md: Perlin noise whose gradients rotate, with its derivatives."""

from __future__ import annotations

from proof.oracle.noises.perlin_d import exact, fixed

__all__ = ["exact", "fixed"]
