"""The kinds of gradient, and how far they reach.

The support function h(v) of a set of gradients is the largest g.v. It depends on |v_i| only, and not on their order.

OCTAHEDRAL. On the line gradients are at most 1 - 1/512. On the plane they are (3, 1) / 4 and (1, 3) / 4 with signs: h
is three quarters of the larger component and a quarter of the other. In space and in four dimensions two components are
1 or -1: h is the sum of the two largest.

ROTATED. All that octahedral ones become with a phase (docs/reference/contract.md, section 14), at each lattice point
with another one. On the plane these are all vectors that are as long as they are, sqrt(10) / 4. In space an edge g and
the edge e, 60 degrees apart, are both perpendicular to g x e, which is 1 or -1 along each axis: so g goes along the
circle of the radius sqrt(2) that is perpendicular to a diagonal s of the cube. Each of the four has six edges on its
circle, and a reflection only exchanges diagonals. On a circle the largest g.v is sqrt(2) times the length of v without
its part along s, sqrt(|v|^2 - (s.v)^2 / 3); h belongs to the diagonal with the least |s.v|. With the magnitudes a >= b
>= c of the components, |s.v| is one of a + b + c, a + b - c, a - b + c and |a - b - c|. The last is the least: the
third is more by 2 c or 2 (a - b).

SINE. The cube |g_i| <= 1.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

LARGEST_1D = 1 - 1 / 512
LENGTH = {1: LARGEST_1D, 2: math.sqrt(10) / 4, 3: math.sqrt(2), 4: math.sqrt(2)}  # of the longest


def two_largest(v):
    """Magnitudes, the largest ones first. Four are compared as the larger of pairs, which is faster than to
    sort."""
    v = np.abs(np.asarray(v, float))
    if len(v) == 2:
        return np.maximum(v[0], v[1]), np.minimum(v[0], v[1])
    high, low = np.maximum(v[0], v[1]), np.minimum(v[0], v[1])
    if len(v) == 3:
        return np.maximum(high, v[2]), np.maximum(low, np.minimum(high, v[2]))
    other, lower = two_largest(v[2:])
    return np.maximum(high, other), np.maximum(np.minimum(high, other), np.where(high > other, low, lower))


def octahedral_support(v):
    """h of vectors: axes by vectors."""
    if len(v) == 1:
        return LARGEST_1D * np.abs(v[0])
    a, b = two_largest(v)
    return (3 * a + b) / 4 if len(v) == 2 else a + b


def rotated_support(v):
    if len(v) == 2:
        return LENGTH[2] * np.hypot(*v)
    v = np.abs(np.asarray(v, float))
    a = v.max(axis=0)
    along = (2 * a - v.sum(axis=0)) / math.sqrt(3)  # a - b - c: of v, along the diagonal
    return LENGTH[3] * np.sqrt((v * v).sum(axis=0) - along * along)


def sine_support(v):
    return np.abs(v).sum(axis=0)


@dataclass(frozen=True, eq=False)
class Gradient:
    name: str
    support: Callable

    def reach(self, dims: int) -> float:
        """The largest |g.v| for |v_i| <= 1."""
        return self.along((1.0,) * dims)

    def component(self, dims: int) -> float:
        """The largest |g_i|."""
        return self.along((1.0,) + (0.0,) * (dims - 1))

    def along(self, u: tuple[float, ...]) -> float:
        """h(u)."""
        return float(self.support(np.array(u)[:, None])[0])


OCTAHEDRAL = Gradient("octahedral", octahedral_support)
ROTATED = Gradient("rotated", rotated_support)
SINE = Gradient("sine", sine_support)

GRADIENTS = (OCTAHEDRAL, SINE)
