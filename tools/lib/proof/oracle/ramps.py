"""Ramps and gradients in fixed arithmetic: section 8 of docs/reference/contract.md."""

from __future__ import annotations

from collections.abc import Sequence

from proof.oracle import gradients
from proof.oracle.integers import UNIT, signed

# By the number of dimensions: the unit of the ramps. The unit of gradients is a quarter of it.
RAMP_UNITS = {1: 2**29, 2: 2**29, 3: 2**29, 4: 2**28}
# In which a gradient's components are whole numbers.
GRADIENT_UNITS = {1: 512, 2: 4, 3: 1, 4: 1}


def whole_gradient(h: int, n: int) -> tuple[int, ...]:
    """The gradient of a word in n dimensions, in those units."""
    return tuple(int(x * GRADIENT_UNITS[n]) for x in gradients.OCTAHEDRAL[n](h))


def ramp(g: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a whole gradient at the offset d from its lattice point, which has units of 2^-20. It is exact."""
    n = len(d)
    return signed(RAMP_UNITS[n] // (GRADIENT_UNITS[n] * UNIT) * signed(sum(signed(a * x) for a, x in zip(g, d))))


def components(g: Sequence[int]) -> tuple[int, ...]:
    """The components of a whole gradient, in units four times as large as a ramp's."""
    n = len(g)
    return tuple(RAMP_UNITS[n] // (4 * GRADIENT_UNITS[n]) * x for x in g)


def sine_ramp(components: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a sine gradient, in units of 2^-28."""
    return signed(sum(signed((g >> 8) * x) + (signed((g & 255) * x) >> 8) for g, x in zip(components, d)))


def scaled(n: int, factor: int) -> int:
    """A weighted sum of octahedral ramps in units of 2^-21, with the contract's S: 1024 times the scale."""
    return signed(signed((signed(n + 256) >> 9) * factor) + 256) >> 9
