"""Section 14 of docs/reference/contract.md: Perlin noise with gradients that rotate."""

from __future__ import annotations

from proof.oracle.noises.perlin import exact, fixed

__all__ = ["exact", "fixed"]
