"""Section 16 of docs/reference/contract.md: the distances of the nearest two points of cells, which go round with a
phase."""

from __future__ import annotations

from proof.oracle.noises.cellular import OUTPUTS, UNITS, exact, fixed

__all__ = ["OUTPUTS", "UNITS", "exact", "fixed"]
