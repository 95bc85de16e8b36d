"""Section 10 of docs/reference/contract.md: the derivatives of what cells.py weights and interpolates."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from proof.oracle.cells import smooth
from proof.oracle.integers import UNIT, difference, lerp, part, signed, word

# --- Exact -------------------------------------------------------------------------------------------------------


def smooth_slope(t: Fraction) -> Fraction:
    """s'(t)."""
    return 30 * t**2 * (1 - t)**2


@functools.lru_cache(maxsize=4096)
def corner_slopes(f: tuple[Fraction, ...]) -> list[tuple[tuple[int, ...], list[Fraction]]]:
    """The corners of a cell, with the derivatives of their weights along each axis."""
    weights = [(1 - smooth(x), smooth(x)) for x in f]
    slopes = [(-smooth_slope(x), smooth_slope(x)) for x in f]

    def along(axis: int, corner: Sequence[int]) -> Fraction:
        return math.prod((slopes if i == axis else weights)[i][o] for i, o in enumerate(corner))

    return [(corner, [along(axis, corner) for axis in range(len(f))])
            for corner in itertools.product((0, 1), repeat=len(f))]


def weight_derivatives(cell: Sequence[int], f: Sequence[Fraction],
                       value: Callable[[Sequence[int], Sequence[Fraction]], Fraction]) -> list[Fraction]:
    """Along each axis, the sum over the corners of the derivative of the weight times the `value`."""
    totals = [Fraction(0)] * len(f)
    for corner, slopes in corner_slopes(tuple(f)):
        at_corner = value([c + o for c, o in zip(cell, corner)], [x - o for x, o in zip(f, corner)])
        totals = [total + slope * at_corner for total, slope in zip(totals, slopes)]
    return totals


# --- Fixed -------------------------------------------------------------------------------------------------------


def fade_slope(fraction: int) -> int:
    """The slope of the fade, in units of 2^-18."""
    x = min(min(fraction, UNIT - fraction) + 4, 2**19 - 1) >> 3
    q = word(x * (2**17 - x)) >> 16
    return word(word((word(q * q) >> 4) * 15) + 4096) >> 13


def rise(a: int, b: int) -> int:
    """From a to b, in units four times as large."""
    return difference(a, b) >> 2


@dataclass(frozen=True)
class Ramp:
    """The interpolated numbers: a value, with its derivatives along the axes that are done, and the components of its
    gradient along the others, in units four times as large. Value noise has no gradient."""
    value: int
    derivatives: tuple[int, ...] = ()
    gradient: tuple[int, ...] = ()


def interpolated_ramp(a: Ramp, b: Ramp, t: int, slope: int) -> Ramp:
    """From a to b along the next axis, with its fade and the slope of that."""
    derivative = part(rise(a.value, b.value), slope)
    components = [lerp(x, y, t) for x, y in zip(a.gradient, b.gradient, strict=True)]
    if components:
        derivative = signed(components.pop(0) + derivative)
    interpolated = [lerp(x, y, t) for x, y in zip(a.derivatives, b.derivatives, strict=True)]
    return Ramp(lerp(a.value, b.value, t), (*interpolated, derivative), tuple(components))
