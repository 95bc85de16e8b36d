"""Derives how large the exact noise and its derivatives can be, before they are scaled: suprema over the cell and all
gradients.

The noise is sum_o w_o n_o over the corners o of a cell, with w_o the product of s(f_i) or 1 - s(f_i). n_o is the ramp
g_o.(f - o). Everything here is a sum over the corners of g_o.v_o(f), linear in each gradient, so its supremum over the
gradients is the sum of h(v_o), h the support function (gradients.py). With d = f - o and e the first axis, v_o is

    VALUE    w d                  the noise itself
    SLOPE    (d_1 w) d + w e      its derivative along the first axis

Any axis may stand for the first, since axes may be exchanged.

The suprema are found by branch and bound. For any one choice of the gradients the sum is smooth. Its second derivative
along an axis j is bounded with sum_o |d^k w_o|, which is a product over the axes: 1 for an axis along which w is not
differentiated (its two weights), and else twice the largest derivative of s in the box. Further |g.d| <= h(1, .., 1)
and |g_j| <= h(1, 0, ..).
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from proof.bounds.boxes import Boxes, cell, corners, fade_derivative, largest_derivative, smooth, supremum
from proof.bounds.gradients import Gradient


@dataclass(frozen=True)
class Quantity:
    """v_o as the derivatives of w along the first axis: the orders of what multiplies d, and of what multiplies e."""
    of_offset: int
    of_axis: int | None
    same_axes_from: int  # axes from this one on may be exchanged


VALUE = Quantity(0, None, 0)
SLOPE = Quantity(1, 0, 1)

TOLERANCE = {1: 1e-6, 2: 1e-6, 3: 1e-5, 4: 1e-5}  # relative: how tight a bound is
LEVELS = {1: 20, 2: 16, 3: 12, 4: 11}


def derivatives(point: np.ndarray) -> Iterator[tuple[tuple[int, ...], tuple[np.ndarray, np.ndarray]]]:
    """Each corner with w and d_1 w."""
    factors = [((1 - s, -ds), (s, ds)) for s, ds in ((fade_derivative(order, f) for order in range(2)) for f in point)]
    for corner in corners(len(point)):
        (w, d_1), *others = (factors[axis][o] for axis, o in enumerate(corner))
        for s, _ in others:
            w, d_1 = w * s, d_1 * s
        yield corner, (w, d_1)


def vector(quantity: Quantity, point: np.ndarray, corner: tuple[int, ...], of_corner: tuple) -> np.ndarray:
    """v_o."""
    v = of_corner[quantity.of_offset] * (point - np.array(corner)[:, None])
    if quantity.of_axis is not None:
        v[0] += of_corner[quantity.of_axis]
    return v


def steepest(quantity: Quantity, gradient: Gradient, point: np.ndarray) -> np.ndarray:
    """The largest that gradients make of the sum at the points: axes by points."""
    return sum(gradient.support(vector(quantity, point, corner, of_corner)) for corner, of_corner in derivatives(point))


def curvature(quantity: Quantity, gradient: Gradient, boxes: Boxes) -> np.ndarray:
    """For each box, the sum over the axes of a bound of the second derivative."""
    largest = {order: 2 * largest_derivative(order, boxes.lo, boxes.hi) for order in range(1, 4)}

    def of(what: int, axis: int, further: int) -> np.ndarray:
        """A bound of sum_o |d^further / df_axis^further of the derivative of w that has the order `what`|."""
        along = [further * (i == axis) + what * (i == 0) for i in range(boxes.dims)]
        return math.prod(largest[order][i] for i, order in enumerate(along) if order)

    total = np.zeros(boxes.index.shape[1])
    for axis in range(boxes.dims):
        total += gradient.reach(boxes.dims) * of(quantity.of_offset, axis, 2)
        total += 2 * gradient.component(boxes.dims) * of(quantity.of_offset, axis, 1)
        if quantity.of_axis is not None:
            total += gradient.component(boxes.dims) * of(quantity.of_axis, axis, 2)
    return total


@functools.cache
def largest(quantity: Quantity, dims: int, gradient: Gradient) -> float:
    """A proven upper bound of the quantity, not scaled. It is the same at f_i and 1 - f_i."""
    bound = smooth(functools.partial(steepest, quantity, gradient), functools.partial(curvature, quantity, gradient))
    return supremum(bound, cell(dims, half=True), LEVELS[dims], TOLERANCE[dims], min(quantity.same_axes_from, dims - 1))
