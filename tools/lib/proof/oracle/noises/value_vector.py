"""Section 22 of docs/reference/contract.md: a value noise along each axis."""

from __future__ import annotations

from proof.oracle.components import UNITS, vector
from proof.oracle.noises import VECTOR as OUTPUTS
from proof.oracle.noises import value

__all__ = ["OUTPUTS", "UNITS", "exact", "fixed"]

exact, fixed = vector(value.exact), vector(value.fixed)
