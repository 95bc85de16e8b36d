"""The range of hn_curl, from docs/reference/contract.md, section 15.

On the plane its components are derivatives of hn_simplex_d, or their negatives. In space the component along x is
a_y b_z - a_z b_y of two gradients a and b of hn_simplex_d, b at the place that is moved by m = (1/2, 0, 1/4). Let u be
the direction of (a_y, a_z), H(u) the largest derivative along u, and H_m(u) that at the place that is moved. The
component is the length of (a_y, a_z), which is a derivative along u, times the derivative of the other noise at a right
angle to u. So it is at most the largest H(u) H_m(u'), u' being u rotated by a quarter, over places and directions; and
likewise along y and z.

These symmetries take a place and a direction to others with the same product, as u is as good as -u:

    the translations of the lattice, which move both places alike;
    x -> -x, and y -> -y: m becomes m less a translation; an angle in the plane of u, from one of its axes, becomes its
    negative, or stays;
    x <-> y and z -> -z: m becomes m less a translation; the component along x becomes that along y, so that only one
    of them is looked at;
    place -> -(place + m) and u -> u', which exchanges the factors.

With the last one an angle is between an eighth of a turn and three eighths. The first two bring the place to
[0, 1/2]^3, and leave the angle between these. No reflection of z alone is among them.

With any gradients the product is smooth, and is bounded from its values at the vertices of boxes and its second
derivatives, as in boxes.py. Derivatives by the place are as in kernels.py. A box has all angles, and vertices at some
of them. Both factors are sinusoids of the angle, so their product is one of twice the angle, and a constant. Its second
derivative is at most twice the product of their amplitudes, which are derivatives along some directions.

With a phase the gradients are ROTATED (gradients.py), and each noise has a phase of its own. All of the above holds,
as rotated gradients have the same symmetries. (These are bounds for all pairs of phases.)
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Iterator, Sequence

import numpy as np

from proof.bounds.boxes import Boxes, cell, supremum
from proof.bounds.gradients import LENGTH, OCTAHEDRAL, ROTATED, Gradient
from proof.bounds.kernels import ROTATING, SIMPLEX, Jet, Kernel, Offsets, weight_jet
from proof.bounds.noises import Proof, ProvenBounds, simplex

TOLERANCE, LEVEL = 1e-3, 10
PARTS = 64  # of a quarter, between directions
MOVE = (0.5, 0.0, 0.25)
AXES = ((1, 2), (0, 1))  # of the planes of the components along x, whose bounds that along y shares, and along z
KERNELS = {OCTAHEDRAL: SIMPLEX, ROTATED: ROTATING}

Points = Sequence[np.ndarray]


def points_of(kernel: Kernel, move: Sequence[float]) -> Points:
    """Where the place that is moved is near a point of the lattice: those that count somewhere in [0, 1/2]^3."""
    every = (np.array(corner) + half - np.array(move)
             for half in (0.0, 0.5) for corner in itertools.product(range(-1, 3), repeat=kernel.dims))
    return [point for point in every
            if kernel.fall * (np.maximum(np.maximum(-point, point - 0.5), 0.0) ** 2).sum() < kernel.radius]


def both(kernel: Kernel) -> tuple[Points, Points]:
    """The points of both noises."""
    return points_of(kernel, (0.0,) * 3), points_of(kernel, MOVE)


# --- The largest product ----------------------------------------------------------------------------------------------

def along(kernel: Kernel, points: Points, place: np.ndarray, u: np.ndarray, gradient: Gradient = OCTAHEDRAL):
    """The largest derivative along each direction at each place, per step: places by directions."""
    total = np.zeros((place.shape[1], u.shape[1]))
    for point in points:
        d = place - point[:, None]
        t = kernel.radius - kernel.fall * (d * d).sum(axis=0)
        near = np.flatnonzero(t > 0)
        d, (w, slope) = d[:, near], (kernel.weight.derivative(order, t[near])[:, None] for order in range(2))
        total[near] += gradient.support(w * u[:, None] - 2 * kernel.fall * slope * (d.T @ u) * d[:, :, None])
    return total


def directions(axes: tuple[int, int], turn: float, parts: int) -> np.ndarray:
    """The directions that divide a quarter into so many parts."""
    angle = math.pi / 4 + turn + np.linspace(0, math.pi / 2, parts + 1)
    u = np.zeros((3, parts + 1))
    u[axes[0]], u[axes[1]] = np.cos(angle), np.sin(angle)
    return u


def product(gradient: Gradient, parts: int, place: np.ndarray):
    """The largest H(u) H_m(u') of these directions."""
    kernel = KERNELS[gradient][3]
    of_planes = [math.prod(along(kernel, points, place, directions(axes, turn, parts), gradient)
                           for points, turn in zip(both(kernel), (0.0, math.pi / 2))).max(axis=1) for axes in AXES]
    return np.maximum(*of_planes)


def jets(kernel: Kernel, points: Points, boxes: Boxes, gradient: Gradient = OCTAHEDRAL) -> Iterator[Jet]:
    """The jets of a derivative along any direction, for any gradients: by the place, along each axis."""
    near = [Offsets.of(kernel, boxes, tuple(point)) for point in points]
    for axis in range(kernel.dims):
        total = Jet(0.0)
        for offsets in near:
            of_u = Jet(np.sqrt((offsets.size**2).sum(axis=0)), 1.0)
            falling = weight_jet(offsets, axis, 1) * of_u * Jet(gradient.support(offsets.size),
                                                                gradient.component(kernel.dims))
            total = total + weight_jet(offsets, axis).times(LENGTH[kernel.dims]) + falling.times(2 * kernel.fall)
        yield total


@functools.cache
def largest_product(gradient: Gradient = OCTAHEDRAL) -> float:
    """Per cell."""
    kernel = KERNELS[gradient][3]

    def bound(boxes: Boxes):
        parts = min(2 ** max(boxes.level - 3, 0), PARTS)
        reached = boxes.at_vertices(functools.partial(product, gradient, parts)).max(axis=0)
        products = [a * b for a, b in zip(*(jets(kernel, points, boxes, gradient) for points in both(kernel)))]
        by_place, by_angle = sum(of_axis.second for of_axis in products), 2 * products[0].value
        return reached + (by_place * boxes.side**2 + by_angle * (math.pi / 2 / parts) ** 2) / 8, reached
    return (kernel.scale / 1024) ** 2 * supremum(bound, cell(3, half=True), LEVEL, TOLERANCE)


# --- Bounds -----------------------------------------------------------------------------------------------------------

def proof(of_dims: dict[int, Kernel], gradient: Gradient) -> Proof:
    return Proof(((2, None), (3, None)), lambda dims, _: simplex.slope_of(of_dims[dims], gradient) if dims == 2
                 else ProvenBounds(0.0, largest_product(gradient)))


PROOFS = {"curl": proof(SIMPLEX, OCTAHEDRAL), "curl_phase": proof(ROTATING, ROTATED)}
