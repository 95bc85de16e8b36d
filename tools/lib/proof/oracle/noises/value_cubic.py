"""Section 11 of docs/reference/contract.md: cubic value noise."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Sequence
from fractions import Fraction

from proof.oracle.integers import part, signed, word
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise
from proof.oracle.noises.value import fixed_number, number, rounded

OFFSETS = (-1, 0, 1, 2)  # of the points that count, along each axis

# --- Exact ------------------------------------------------------------------------------------------------------


def spline_weights(f: Fraction) -> tuple[Fraction, ...]:
    """The weights of the four points along one axis."""
    def middle(t: Fraction) -> Fraction:
        return Fraction(2, 3) - t**2 + t**3 / 2

    return ((1 - f)**3 / 6, middle(f), middle(1 - f), f**3 / 6)


@functools.lru_cache(maxsize=4096)
def point_weights(f: tuple[Fraction, ...]) -> list[tuple[tuple[int, ...], Fraction]]:
    weights = [dict(zip(OFFSETS, spline_weights(x))) for x in f]
    return [(offset, math.prod(of_axis[o] for of_axis, o in zip(weights, offset)))
            for offset in itertools.product(OFFSETS, repeat=len(f))]


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    total = Fraction(0)
    for offset, weight in point_weights(tuple(f)):
        total += weight * number(lattice, [c + o for c, o in zip(cell, offset)])
    return (total,)


# --- Fixed ------------------------------------------------------------------------------------------------------


def sixth(x: int) -> int:
    """A sixth of the cube of x, which is in units of 2^-15; in units of 2^-30."""
    q = word(x * x)
    return word(word((q >> 15) * x) + (word((q & 32767) * x) >> 15)) // 6


def fixed_weights(fraction: int) -> tuple[int, ...]:
    """In units of 2^-18."""
    x = (fraction + 16) >> 5
    first, last = word(sixth(2**15 - x) + 2**11) >> 12, word(sixth(x) + 2**11) >> 12
    second = word(word(715829931 + 3 * sixth(x)) - word(x * x)) >> 12
    return (first, second, 2**18 - first - second - last, last)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    # The smallest x comes first; so each axis takes as many rows of four as values are left.
    values = [fixed_number(lattice, [c + o for c, o in zip(cell, offset)])
              for offset in itertools.product(OFFSETS, repeat=len(cell))]
    for f in fraction:
        count, weights = len(values) // 4, fixed_weights(f)
        values = [signed(sum(part(n, b) for n, b in zip(values[i::count], weights, strict=True)))
                  for i in range(count)]
    n, = values
    return (rounded(n),)


NOISES = (Noise("value_cubic", exact, fixed),)
