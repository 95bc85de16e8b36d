"""The kinds of gradient that HN_GRADIENT selects, and how far they reach.

The support function h(v) of a set of gradients is the largest g.v. It depends on |v_i| only.

OCTAHEDRAL. A gradient is a direction, |x| + |y| (+ |z|) = 1, times 2 - L, with L the largest of its components. The
library has some of them; h is that of all. As signs and axes may be exchanged, the best gradient for |v| sorted as
a >= b (>= c) is sorted, too. Let its largest component be 1 - t before it is lengthened by 1 + t.

    2D: (1 + t) ((1 - t) a + t b) over t in [0, 1/2]. The derivative is b - 2 t (a - b).
    3D: the second component is min(t, 1 - t), since b >= c and no component exceeds the largest. So up to t = 1/2 it is
        as in 2D, and in [1/2, 2/3] it is (1 + t) ((1 - t) (a + b) + (2 t - 1) c), with the derivative
        -2 t (a + b) + (4 t + 1) c. Both derivatives fall, and at t = 1/2 the second, 3 c - a - b, is not above the
        first, 2 b - a. So the function is concave, and its maximum is where the derivative is 0, or at an end.

On the line, gradients are at most 1 - 1/512. In four dimensions they are the corners of the 24-cell, of which h is the
sum of the two largest.

SIMPLEX NOISE has directions times 1 + k (1 - L), for other k. There the last per mille counts: h is that of the
library's directions, which are few. As they may be exchanged (directions), the best is sorted like |v|. Of those with
the same largest component it is the one with the largest second one.

UNIT. All vectors that are as long as 1. The largest length of a gradient, times that, contains all gradients.

No component of an OCTAHEDRAL gradient exceeds 1: (2 - L) times a component is at most (2 - L) L. |g.v| is at most
max |v_i| times h(1, .., 1).
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

LARGEST_1D = 1 - 1 / 512


def _quotient(a, b):
    return np.divide(a, b, out=np.zeros(np.broadcast(a, b).shape), where=b > 0)


def _plane_support(a, b):
    early = 2 * b <= a  # the maximum is at t = b / (2 (a - b)), else at 1/2
    return np.where(early, a + _quotient(b * b, 4 * (a - b)), 0.75 * (a + b))


def _space_support(a, b, c):
    both = a + b
    late = np.where(11 * c >= 4 * both, 5 / 9 * (both + c), both - c + _quotient(c * c, 4 * (both - 2 * c)))
    return np.where((3 * c > both) & (2 * b > a), late, _plane_support(a, b))


def octahedral_support(v):
    """h of vectors: axes by vectors."""
    v = np.abs(np.asarray(v, float))
    if len(v) == 1:
        return LARGEST_1D * v[0]
    if len(v) == 2:
        return _plane_support(np.maximum(v[0], v[1]), np.minimum(v[0], v[1]))
    if len(v) == 3:
        largest, least = np.maximum.reduce(v), np.minimum.reduce(v)
        return _space_support(largest, v[0] + v[1] + v[2] - largest - least, least)
    high, low = np.maximum(v[0], v[1]), np.minimum(v[0], v[1])
    other, lower = np.maximum(v[2], v[3]), np.minimum(v[2], v[3])
    return np.maximum(high + other, np.maximum(high + low, other + lower))


@functools.cache
def directions(dims: int) -> np.ndarray:
    """Those of the library with their components in order, a >= b (>= c) >= 0: vectors by axes. On the plane they are
    odd multiples of 1/512. In space they are multiples of 1/256, of which two are odd; so there are some more here."""
    if dims == 2:
        a = np.arange(257, 512, 2)
        return np.stack([a, 512 - a], axis=1) / 512
    a, b = (grid.ravel() for grid in np.meshgrid(np.arange(1, 257), np.arange(0, 257)))
    c = 256 - a - b
    fits = (a >= b) & (b >= c) & (c >= 0) & (a % 2 + b % 2 + c % 2 == 2)
    return np.stack([a, b, c], axis=1)[fits] / 256


def lengthened(some: np.ndarray, more: float) -> np.ndarray:
    """Directions times 1 + more (1 - L)."""
    return some * (1 + more * (1 - some[:, :1]))


@functools.cache
def longest(dims: int, more: float = 1.0) -> float:
    """The largest length of a gradient of the library."""
    return float(np.sqrt((lengthened(directions(dims), more) ** 2).sum(axis=1)).max())


@functools.cache
def _best_directions(dims: int) -> np.ndarray:
    """For each largest component the one with the largest second component."""
    every = directions(dims)
    return np.array([every[every[:, 0] == a][-1] for a in np.unique(every[:, 0])]) if dims == 3 else every


def directions_support(v, more: float):
    """h of directions of the library times 1 + more (1 - L), on the plane and in space."""
    ordered = -np.sort(-np.abs(np.asarray(v, float)), axis=0)
    return (lengthened(_best_directions(len(ordered)), more) @ ordered).max(axis=0)


def mixed_support(p, q, r):
    """h in space, of gradients of which no component is smaller than that along r; p >= q."""
    between = np.minimum((q + r) / 2, p)
    t = np.divide(between, 2 * (p - between), out=np.full(p.shape, 2 / 3), where=4 * (p - between) > 3 * between)
    return np.where(r <= q, _space_support(p, q, r), (1 + t) * ((1 - t) * p + t * between))


def unit_support(v):
    """Of the ball of radius 1."""
    v = np.asarray(v, float)
    return np.sqrt((v * v).sum(axis=0))


def sine_support(v):
    """Of the cube |g_i| <= 1."""
    return np.abs(v).sum(axis=0)


@dataclass(frozen=True, eq=False)
class Gradient:
    name: str
    support: Callable
    component_error: float  # of floats: what the contract allows

    def reach(self, dims: int) -> float:
        """The largest |g.v| for |v_i| <= 1."""
        return float(self.support(np.ones((dims, 1)))[0])


OCTAHEDRAL = Gradient("octahedral", octahedral_support, 0.0)
SINE = Gradient("sine", sine_support, 2.0**-19)
UNIT = Gradient("as long as 1", unit_support, 0.0)


def of_directions(more: float) -> Gradient:
    return Gradient(f"longer by {more}", lambda v: directions_support(v, more), 0.0)


GRADIENTS = (OCTAHEDRAL, SINE)
