"""Derives how large the exact noise and its derivatives can be, before they are scaled: suprema over the cell and all
gradients.

The noise is sum_o w_o n_o over the corners o of a cell, with w_o the product of s(f_i) or 1 - s(f_i). n_o is the ramp
g_o.(f - o), or for value noise a number within +-1. Everything here is a sum over the corners of g_o.v_o(f), linear in
each gradient, so its supremum over the gradients is the sum of h(v_o), h the support function (gradients.py). With
d = f - o, e the first axis, and D the derivative along (1, .., 1), v_o is

    VALUE            w d                                        the noise itself
    SLOPE            (d_1 w) d + w e                            its derivative along the first axis
    LIPSCHITZ        (D w) d + w (1, .., 1)                     the L1 norm of its gradient
    SLOPE_LIPSCHITZ  (D d_1 w) d + (D w) e + (d_1 w) (1, .., 1) the L1 norm of the gradient of the derivative

and for value noise it is what d is multiplied with. The L1 norm of a gradient is the largest sum_j sigma_j d/df_j over
the signs sigma. Reflecting axes (f_i to 1 - f_i and g_i to -g_i) makes all signs +1, so L holds for all: as the
noise is twice and its derivative once continuously differentiable, |noise(p) - noise(q)| <= L max_i |p_i - q_i|, and
likewise for the derivative. Any axis may stand for the first, since axes may be exchanged.

The suprema are found by branch and bound. For any one choice of the gradients the sum is smooth. Its second derivative
along an axis j is bounded with sum_o |d^k w_o|, which is a product over the axes: 1 for an axis along which w is not
differentiated (its two weights), and else twice the largest derivative of s in the box. Further |g.d| <= h(1, .., 1)
and |g_j| <= h(1, 0, ..).
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from proof.bounds.boxes import Boxes, cell, corners, fade_derivative, largest_derivative, smooth, supremum
from proof.bounds.gradients import Gradient


@dataclass(frozen=True)
class Quantity:
    """v_o as indices of what `derivatives` yields: of what multiplies d, e and (1, .., 1)."""
    of_offset: int
    of_axis: int | None
    of_ones: int | None
    same_axes_from: int  # axes from this one on may be exchanged
    mirrored: bool  # f_i to 1 - f_i changes nothing


W, D_1, D, D_D_1 = range(4)  # what `derivatives` yields
VALUE = Quantity(W, None, None, 0, True)
SLOPE = Quantity(D_1, W, None, 1, True)
LIPSCHITZ = Quantity(D, None, W, 0, False)
SLOPE_LIPSCHITZ = Quantity(D_D_1, D, D_1, 1, False)

TOLERANCE = {1: 1e-6, 2: 1e-6, 3: 1e-5, 4: 1e-5}  # relative: how tight a bound is
LEVELS = {1: 20, 2: 16, 3: 12, 4: 11}


def derivatives(point: np.ndarray) -> Iterator[tuple[tuple[int, ...], tuple[np.ndarray, ...]]]:
    """Each corner with w, d_1 w, D w and D d_1 w."""
    factors = [[(1 - s, -ds, -dds), (s, ds, dds)] for s, ds, dds in
               ((fade_derivative(order, f) for order in range(3)) for f in point)]
    for corner in corners(len(point)):
        w, d_1, d, d_d_1 = 1.0, 0.0, 0.0, 0.0
        for axis, o in enumerate(corner):
            s, ds, dds = factors[axis][o]
            if axis == 0:
                w, d_1, d, d_d_1 = s, ds, ds, dds
            else:
                w, d_1, d, d_d_1 = w * s, d_1 * s, d * s + w * ds, d_d_1 * s + d_1 * ds
        yield corner, (w, d_1, d, d_d_1)


def vector(quantity: Quantity, point: np.ndarray, corner: tuple[int, ...], of_corner: tuple) -> np.ndarray:
    """v_o."""
    v = of_corner[quantity.of_offset] * (point - np.array(corner)[:, None])
    if quantity.of_ones is not None:
        v = v + of_corner[quantity.of_ones]
    if quantity.of_axis is not None:
        v[0] += of_corner[quantity.of_axis]
    return v


def steepest(quantity: Quantity, gradient: Gradient | None, point: np.ndarray) -> np.ndarray:
    """The largest that gradients, or numbers, make of the sum at the points: axes by points."""
    if gradient is None:
        return sum(abs(of_corner[quantity.of_offset]) for _, of_corner in derivatives(point))
    return sum(gradient.support(vector(quantity, point, corner, of_corner)) for corner, of_corner in derivatives(point))


def orders(what: int, dims: int) -> list[np.ndarray]:
    """The orders along each axis of the derivatives of w that `what` is the sum of."""
    unit = np.eye(dims, dtype=int)
    return {W: [0 * unit[0]], D_1: [unit[0]], D: list(unit), D_D_1: list(unit + unit[0])}[what]


def curvature(quantity: Quantity, gradient: Gradient | None, boxes: Boxes) -> np.ndarray:
    """For each box, the sum over the axes of a bound of the second derivative."""
    dims, largest = boxes.dims, {}
    for order in range(1, 5):
        largest[order] = 2 * largest_derivative(order, boxes.lo, boxes.hi)

    def of(what: int, axis: int, further: int) -> np.ndarray:
        """A bound of sum_o |d^further / df_axis^further of what|."""
        total = 0.0
        for order in orders(what, dims):
            order = order + further * (np.arange(dims) == axis)
            product = 1.0
            for i in np.flatnonzero(order):
                product = product * largest[order[i]][i]
            total = total + product
        return total

    total = np.zeros(boxes.index.shape[1])
    reach = gradient.reach(dims) if gradient else 1.0
    for axis in range(dims):
        total += reach * of(quantity.of_offset, axis, 2)
        if gradient:
            total += 2 * gradient.component(dims) * of(quantity.of_offset, axis, 1)
            if quantity.of_axis is not None:
                total += gradient.component(dims) * of(quantity.of_axis, axis, 2)
            if quantity.of_ones is not None:
                total += reach * of(quantity.of_ones, axis, 2)
    return total


@functools.cache
def largest(quantity: Quantity, dims: int, gradient: Gradient | None) -> float:
    """A proven upper bound of the quantity, not scaled."""
    bound = smooth(functools.partial(steepest, quantity, gradient), functools.partial(curvature, quantity, gradient))
    return supremum(bound, cell(dims, quantity.mirrored), LEVELS[dims], TOLERANCE[dims],
                    min(quantity.same_axes_from, dims - 1))
