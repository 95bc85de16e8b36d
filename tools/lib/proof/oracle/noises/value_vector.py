"""Section 22 of docs/contract.md: a value noise along each axis."""

from __future__ import annotations

from oracle.components import UNITS, vector
from oracle.noises import VECTOR as OUTPUTS
from oracle.noises import value

__all__ = ["OUTPUTS", "UNITS", "exact", "fixed"]

exact, fixed = vector(value.exact), vector(value.fixed)
