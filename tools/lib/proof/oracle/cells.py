"""The noises of a lattice share this: a value at each corner of a cell, weighted (docs/reference/contract.md, 6 and
8)."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import TypeVar

from proof.oracle.integers import UNIT, fade, lerp

Value = TypeVar("Value")


# --- Exact -------------------------------------------------------------------------------------------------------


def smooth(t: Fraction) -> Fraction:
    """s(t), the weight of the far corner along one axis."""
    return 6 * t**5 - 15 * t**4 + 10 * t**3


@functools.lru_cache(maxsize=4096)  # the golden files of all configurations have the same fractions
def corner_weights(f: tuple[Fraction, ...]) -> list[tuple[tuple[int, ...], Fraction]]:
    near_and_far = [(1 - smooth(x), smooth(x)) for x in f]
    return [(corner, math.prod(weights[o] for weights, o in zip(near_and_far, corner)))
            for corner in itertools.product((0, 1), repeat=len(f))]


def weighted_sum(cell: Sequence[int], f: Sequence[Fraction],
                 value: Callable[[Sequence[int], Sequence[Fraction]], Fraction]) -> Fraction:
    """Over the corners of the cell, of the `value` at a corner and at an offset from it."""
    total = Fraction(0)
    for corner, weight in corner_weights(tuple(f)):
        total += weight * value([c + o for c, o in zip(cell, corner)], [x - o for x, o in zip(f, corner)])
    return total


# --- Fixed -------------------------------------------------------------------------------------------------------


def corners(cell: Sequence[int], fraction: Sequence[int]) -> Iterator[tuple[list[int], list[int]]]:
    """The corners of a cell, those with o = 0 along x first, and the offset from each."""
    for corner in itertools.product((0, 1), repeat=len(cell)):
        yield [c + o for c, o in zip(cell, corner)], [f - o * UNIT for f, o in zip(fraction, corner)]


def halves(values: Sequence[Value]) -> Iterator[tuple[Value, Value]]:
    """The values at o = 0 and at o = 1 of the next axis: x, then y, z, w."""
    half = len(values) // 2
    return zip(values[:half], values[half:])


def interpolated(cell: Sequence[int], fraction: Sequence[int],
                 value: Callable[[Sequence[int], Sequence[int]], int]) -> int:
    """In fixed arithmetic: first along x, then y, z, w."""
    values = [value(corner, offset) for corner, offset in corners(cell, fraction)]
    for f in fraction:
        values = [lerp(a, b, fade(f)) for a, b in halves(values)]
    n, = values
    return n
