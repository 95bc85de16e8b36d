"""Section 20 of docs/reference/contract.md: hex tiling. With HN_FIXED nothing but the fraction differs: all else is
exact."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from proof.oracle.gradients import Real
from proof.oracle.integers import UNIT
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise

CORNERS = "abc"  # as rows name them
OUTPUTS = (*(f"w{corner}" for corner in CORNERS), *CORNERS, *(f"x{corner}" for corner in CORNERS),
           *(f"y{corner}" for corner in CORNERS))
# Weights, words, and vectors: corners lie at quarters of cells, so that these are as fine as a fraction.
UNITS = (*(UNIT,) * 3, *(1,) * 3, *(UNIT,) * 6)


@dataclass(frozen=True)
class Corner:
    """In skewed coordinates: a whole number of steps along either axis."""
    skewed: tuple[int, int]

    @property
    def point(self) -> tuple[int, int]:
        """The numbers of section 13."""
        i, j = self.skewed
        return i - (j + j % 2) // 2, j

    @property
    def place(self) -> tuple[Fraction, Fraction]:
        """In cells."""
        i, j = self.point
        return Fraction(i, 2) + Fraction(j % 2, 4), Fraction(j, 2)


def triangle(place: Sequence[Fraction]) -> tuple[list[Corner], list[Fraction]]:
    """The corners around a place, in cells, and their weights."""
    x, y = 2 * place[0] + place[1], 2 * place[1]
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    if u > v:
        between, weights = (i + 1, j), [1 - u, u - v, v]
    else:
        between, weights = (i, j + 1), [1 - v, v - u, u]
    return list(map(Corner, ((i, j), between, (i + 1, j + 1)))), weights


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Real, ...]:
    place = [c + x for c, x in zip(cell, f)]
    corners, weights = triangle(place)
    words = [lattice.of_triangles.hash(corner.point) for corner in corners]
    vectors = [[a - b for a, b in zip(place, corner.place)] for corner in corners]
    return (*weights, *words, *(x for x, _ in vectors), *(y for _, y in vectors))


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    found = [x * unit for x, unit in zip(exact(lattice, cell, [Fraction(x, UNIT) for x in fraction]), UNITS)]
    if any(x != int(x) for x in found):
        raise ValueError(f"not whole in its unit: {found}")
    return tuple(map(int, found))


NOISES = (Noise("hex_tiling", exact, fixed, OUTPUTS, UNITS),)
