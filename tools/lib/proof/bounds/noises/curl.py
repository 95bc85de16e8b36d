"""hn_curl: what is proven of it, from docs/reference/contract.md, section 15.

On the plane its components are derivatives of hn_simplex_d, or their negatives. In space a component is
a_y b_z - a_z b_y of two gradients a and b of hn_simplex_d. Let u be the direction of (a_y, a_z), and H(u) the largest
derivative along u there. The component is the length of (a_y, a_z), which is a derivative along u, times the derivative
of the other noise at a right angle to u. So it is at most the largest H(u) H(u rotated by a quarter), over places and
directions. Let R be the largest H(u): the largest length that two components of a gradient have together.

Whatever changes each derivative by at most e moves a component by at most e (|a_y| + |a_z| + |b_y| + |b_z|) + 2 e^2,
and so by 2 sqrt(2) R e + 2 e^2: the place, and the errors of the derivatives. In floats the products and the difference round; |a_y b_z| + |a_z b_y| is at most R^2. In integers prod(a, b) is below the product by less than 2 units
of 2^-20, 1 for the low digits and 1 for the shift. The result is rounded to a multiple of 2^-16.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from proof.bounds.boxes import SAFE, Boxes, cell, supremum
from proof.bounds.floats import UNIT, position_error, rounding
from proof.bounds.gradients import LENGTH, OCTAHEDRAL, Gradient
from proof.bounds.kernels import SIMPLEX, Jet, Kernel, Offsets, weight_jet
from proof.bounds.noises import ProvenBounds, simplex, simplex_d

CASES = ((2, None), (3, None))
TOLERANCE, LEVEL = 1e-3, 8
FIXED_PRODUCT = 2.0**-20  # the unit of prod


# --- The largest length of two components -----------------------------------------------------------------------------

def along(kernel: Kernel, place, angle):
    """The largest derivative along (0, cos, sin), per step."""
    u, total = np.stack([np.zeros(angle.shape), np.cos(angle), np.sin(angle)]), 0.0
    for point in kernel.points:
        d = place - np.array(point)[:, None]
        t = np.maximum(kernel.radius - kernel.fall * (d * d).sum(axis=0), 0.0)
        w, slope = (kernel.weight.derivative(order, t) for order in range(2))
        total = total + OCTAHEDRAL.support(w * u - 2 * kernel.fall * slope * (d * u).sum(axis=0) * d)
    return total


def curvature(kernel: Kernel, boxes: Boxes):
    """The sum of the second derivatives along the axes, and the one by the angle, which is at most the derivative
    itself along some direction."""
    by_place = by_angle = 0.0
    for point in kernel.points:
        offsets = Offsets.of(kernel, boxes, point)
        length = np.sqrt((offsets.size**2).sum(axis=0))
        for axis in range(kernel.dims):
            ramp = Jet(OCTAHEDRAL.support(offsets.size), OCTAHEDRAL.component(kernel.dims))
            falling = weight_jet(offsets, axis, 1) * Jet(length, 1.0) * ramp
            derivative = weight_jet(offsets, axis).times(LENGTH[kernel.dims]) + falling.times(2 * kernel.fall)
            by_place = by_place + derivative.second
        by_angle = by_angle + derivative.value
    return by_place, by_angle


@functools.cache
def longest_pair() -> tuple[float, float]:
    """R and the largest product, per cell. By reflections the place is in [0, 1/2]^3; then u may have any angle up to
    pi, or up to pi/2 for the product, which a quarter of a turn does not change."""
    kernel, scale = SIMPLEX[3], SIMPLEX[3].scale / 1024

    def bound(boxes: Boxes, whole: float, rotated: tuple[float, ...]):
        by_place, by_angle = curvature(kernel, Boxes(boxes.level, boxes.index[1:]))
        beyond = (by_place + (2 * whole) ** 2 * by_angle) / 8 * boxes.side**2
        reached = boxes.at_vertices(
            lambda point: np.array([along(kernel, point[1:], 2 * whole * point[0] + turn) for turn in rotated]))
        return (reached.max(axis=1) + beyond).prod(axis=0), reached.prod(axis=0).max(axis=0)

    def largest(whole: float, *rotated: float) -> float:
        of_boxes = functools.partial(bound, whole=whole, rotated=rotated)
        return supremum(of_boxes, cell(4, half=True), LEVEL, TOLERANCE)
    return scale * largest(math.pi, 0.0), scale**2 * largest(math.pi / 2, 0.0, math.pi / 2)


# --- Bounds -----------------------------------------------------------------------------------------------------------

def moved(error: float) -> float:
    """A component, if each derivative is off by that."""
    return 2 * math.sqrt(2) * longest_pair()[0] * error + 2 * error**2


def float_error(of_derivative: float) -> float:
    size = longest_pair()[0] ** 2 + moved(of_derivative)
    return moved(of_derivative) + UNIT * size + float(rounding(size * (1 + UNIT), 1.0))


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    slope = simplex.derived_slope(SIMPLEX[dims])
    if dims == 2:
        return slope
    longest, exact = longest_pair()
    lipschitz = 2 * math.sqrt(2) * longest * slope.lipschitz
    cell_error = float_error(slope.cell_error)
    error = position_error(cell_error, lipschitz) + moved(slope.error - slope.cell_error)
    parts = {"cut": moved(slope.fixed_parts["cut"]),
             "points": moved(slope.fixed_error) - moved(slope.fixed_parts["cut"]) + 2 * FIXED_PRODUCT,
             "scaling": 2.0**-17}
    fixed_error = sum(parts.values()) * SAFE
    return ProvenBounds(0.0, exact, lipschitz, cell_error, error, exact + error, fixed_error, exact + fixed_error, parts)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    of_derivatives = simplex_d.largest_intermediates(dims, None)
    if dims == 2:
        return of_derivatives
    derivative = simplex.derived_slope(SIMPLEX[3]).fixed_largest * 2**19
    product = (derivative / 2**9 + 1) ** 2 + 2 * (derivative / 2**9 + 1) * 511 / 2**9 + 2
    return of_derivatives | {"product": product, "difference of products": 2 * product + 8}


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"longest_pair_of_components": longest_pair()[0]} if dims == 3 else {}
