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

LIBRARY. Where the last per mille counts, t is at most what it is in the library (MOST). The functions above are concave
in t, so it is the maximum or that limit.

UNIT. All vectors that are as long as 1: LONGEST times that contains all gradients. In the plane of a gradient's two
largest components its squared length is (1 + t)^2 ((1 - t)^2 + t^2), of which the derivative by t is
2 t (1 + t) (4 t - 1): so it is largest at an end, 1 or what the largest t makes of it. In space, for each t, it is
convex in the third component, so that is 0, or beyond t = 1/2 the second is as large as the first:
(1 + t)^2 (2 (1 - t)^2 + (2 t - 1)^2) falls up to t = 2/3. So it is at most 9/8.

No component of a gradient exceeds 1: (2 - L) times a component is at most (2 - L) L. |g.v| is at most max |v_i| times
h(1, .., 1).
"""

from __future__ import annotations

import math
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


# The largest 1 - L of the library's gradients. The direction with the least L is the one whose components are nearest to
# each other: (257, 255) / 512 on the plane, and (172, 170, 170) / 512 in space.
MOST = {2: 255 / 512, 3: 340 / 512}
# The largest length of a gradient: on the plane of the one with that t, in space of (1/2, 1/2, 0) * 3/2.
LONGEST = {2: math.hypot(257, 255) / 512 * (1 + 255 / 512), 3: math.sqrt(9 / 8)}


def longer(t, a, b):
    """What a gradient makes of v, with 1 - t along a and t along b before it is lengthened."""
    return (1 + t) * ((1 - t) * a + t * b)


def _best(a, b, most):
    """The largest of `longer` for t up to `most`."""
    interior = np.divide(b, 2 * (a - b), out=np.full(np.shape(a), most), where=b < 2 * most * (a - b))
    return longer(np.minimum(interior, most), a, b)


def library_support(v):
    """h, on the plane and in space of gradients of which 1 - L is at most MOST, as in the library."""
    v = np.abs(np.asarray(v, float))
    if len(v) not in (2, 3):
        return octahedral_support(v)
    most, largest, least = MOST[len(v)], np.maximum.reduce(v), np.minimum.reduce(v)
    if len(v) == 2:
        return _best(largest, least, most)
    both = v.sum(axis=0) - least
    capped = (1 + most) * ((1 - most) * both + (2 * most - 1) * least)
    # The derivative by t is positive at the largest t where the maximum would be beyond.
    beyond = (4 * most + 1) * least > 2 * most * both
    return np.where(beyond, capped, _space_support(largest, both - largest, least))


def mixed_support(p, q, r):
    """h in space, of gradients of which no component is smaller than that along r; p >= q."""
    ordered = library_support(np.stack([p, q, r]))
    return np.where(r <= q, ordered, _best(p, (q + r) / 2, MOST[3]))


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
LIBRARY = Gradient("of the library", library_support, 0.0)
UNIT = Gradient("as long as 1", unit_support, 0.0)
TURNED = Gradient("turned", lambda v: LONGEST[len(v)] * unit_support(v), 0.0)
GRADIENTS = (OCTAHEDRAL, SINE)
