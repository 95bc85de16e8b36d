"""Proves how large a sum over the points of a lattice (docs/reference/contract.md, section 13) and its derivatives can
be.

The noise is S * sum w(t) (g.d) over the lattice points, t = max(0, r - m |d|^2), with d the offset from the point in
steps. Along an axis u its derivative is made of g.v, with

    VALUE      w d                          the noise itself
    along u    w u - 2 m w' (d.u) d

Each is linear in each gradient, so its supremum over the gradients is the sum of h(v), h the support function.

Each sum is bounded by branch and bound over places in [0, 1/2]^n, in steps. This is enough: the lattice has a point at
0 and at every whole step along an axis, so a reflection brings any place to [0, 1/2]^n if the lattice is centred. The
rows of triangles are a step apart, and every second is shifted by half a step; half a turn about (1/4, 1/2) maps them
to each other. Reflections and half turns change only the signs of components, and h does not depend on these.
Derivatives are taken on the plane along each axis. In a centred lattice axes may be exchanged.

In a box g.v is bounded by its values at the vertices and its second derivatives along the axes, as in boxes.py. These
are sums of products, and a Jet has bounds of the factors. w' is once continuously differentiable and its second
derivative is bounded, which is enough.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from proof.bounds.boxes import Bound, Boxes, cell, smooth, supremum
from proof.bounds.gradients import Gradient
from proof.bounds.weights import CUBE, FIFTH, FOURTH, PLANE, Weight


@dataclass(frozen=True, eq=False)
class Kernel:
    """The sum of a noise."""
    dims: int
    radius: float  # r
    fall: int  # m
    scale: int  # 1024 S
    weight: Weight
    triangles: bool = False

    @property
    def steps(self) -> int:
        """To a cell."""
        return 2 if self.triangles else 1

    @functools.cached_property
    def points(self) -> tuple[tuple[float, ...], ...]:
        """The points that are near enough to count somewhere in [0, 1/2]^n."""
        if self.triangles:
            every = [(i + (j & 1) / 2, float(j)) for i in range(-2, 3) for j in range(-2, 3)]
        else:
            corners = list(itertools.product((-1.0, 0.0, 1.0), repeat=self.dims))
            every = corners + [tuple(x + 0.5 for x in corner) for corner in corners]
        return tuple(point for point in every if self.fall * sum(max(-x, x - 0.5, 0.0) ** 2 for x in point)
                     < self.radius)

    def nearness(self, d: np.ndarray) -> np.ndarray:
        """t at offsets."""
        return np.maximum(self.radius - self.fall * (d * d).sum(axis=0), 0.0)

    def offsets(self, place: np.ndarray) -> Iterator[np.ndarray]:
        """The offsets of places from each point."""
        for point in self.points:
            yield place - np.array(point)[:, None]


SIMPLEX = {2: Kernel(2, 819 / 1024, 1, 4099, PLANE, triangles=True),
           3: Kernel(3, 1.0, 2, 4918, FOURTH),
           4: Kernel(4, 1.0, 2, 4298, CUBE)}
ROTATING = {2: SIMPLEX[2], 3: replace(SIMPLEX[3], scale=4902)}  # with a phase
SMOOTH = {2: Kernel(2, 1.0, 1, 3081, CUBE, triangles=True), 3: Kernel(3, 0.75, 1, 4279, FIFTH)}


# --- Summands ---------------------------------------------------------------------------------------------------------

Axis = tuple[float, ...] | None  # of a derivative; None of the noise itself


def dot(d: np.ndarray, u: tuple[float, ...]) -> np.ndarray:
    return sum(x * y for x, y in zip(d, u))


def vector(kernel: Kernel, u: Axis, d: np.ndarray) -> np.ndarray:
    """v at offsets: axes by places."""
    w, dw = (kernel.weight.derivative(order, kernel.nearness(d)) for order in range(2))
    return w * d if u is None else w * np.array(u)[:, None] - 2 * kernel.fall * dw * dot(d, u) * d


def attained(kernel: Kernel, u: Axis, support, place: np.ndarray) -> np.ndarray:
    """The sum at places: axes by places. The gradients may be different at each place."""
    return sum(support(vector(kernel, u, d)) for d in kernel.offsets(place))


# --- Second derivatives -----------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Jet:
    """Bounds of |f|, |f'| and |f''| along an axis, in each box."""
    value: np.ndarray | float
    first: np.ndarray | float = 0.0
    second: np.ndarray | float = 0.0

    def __mul__(self, other: Jet) -> Jet:
        return Jet(self.value * other.value, self.first * other.value + self.value * other.first,
                   self.second * other.value + 2 * self.first * other.first + self.value * other.second)

    def __add__(self, other: Jet) -> Jet:
        return Jet(self.value + other.value, self.first + other.first, self.second + other.second)

    def times(self, factor: float) -> Jet:
        return Jet(self.value * factor, self.first * factor, self.second * factor)


@dataclass(frozen=True)
class Offsets:
    """One lattice point in each box: the middle of d, half a side, the largest |d_i|, the least and largest t."""
    kernel: Kernel
    middle: np.ndarray
    half: float
    size: np.ndarray
    least: np.ndarray
    largest: np.ndarray
    sizes: dict[int, np.ndarray] = field(default_factory=dict)  # the results of weight_size, which each axis needs

    @staticmethod
    def of(kernel: Kernel, boxes: Boxes, point: tuple[float, ...]) -> Offsets:
        half = boxes.side / 2
        middle = boxes.lo + half - np.array(point)[:, None]
        size, near = np.abs(middle) + half, np.maximum(np.abs(middle) - half, 0.0)
        return Offsets(kernel, middle, half, size, kernel.nearness(size), kernel.nearness(near))

    def along(self, u: tuple[float, ...]) -> np.ndarray:
        """The largest |d.u|."""
        return np.abs(dot(self.middle, u)) + self.half * sum(map(abs, u))

    def weight_size(self, order: int) -> np.ndarray:
        """The largest magnitude of a derivative of the weight by t."""
        if order not in self.sizes:
            size = self.kernel.weight.size(order, self.least, self.largest)
            self.sizes[order] = np.where(self.largest > 0, size, 0.0)
        return self.sizes[order]


def weight_jet(offsets: Offsets, axis: int, order: int = 0) -> Jet:
    """The jet of a derivative of the weight by t. t has the derivatives -2 m d and -2 m along the axis."""
    sizes = [offsets.weight_size(order + i) for i in range(3)]
    m, d = offsets.kernel.fall, offsets.size[axis]
    return Jet(sizes[0], 2 * m * d * sizes[1], (2 * m * d) ** 2 * sizes[2] + 2 * m * sizes[1])


def jet(kernel: Kernel, u: Axis, gradient: Gradient, offsets: Offsets, axis: int) -> Jet:
    """The jet of g.v along an axis, for any gradient."""
    ramp = Jet(gradient.support(offsets.size), gradient.along(tuple(float(i == axis) for i in range(kernel.dims))))
    if u is None:
        return weight_jet(offsets, axis) * ramp
    along = Jet(offsets.along(u), abs(u[axis]))
    return (weight_jet(offsets, axis) * Jet(gradient.along(u))
            + (weight_jet(offsets, axis, 1) * along * ramp).times(2 * kernel.fall))


# --- Suprema ----------------------------------------------------------------------------------------------------------

LEVELS = {2: 14, 3: 9, 4: 8}
TOLERANCE = {2: 1e-5, 3: 1e-5, 4: 1e-5}  # relative: how tight a bound is


OfPlaces = Callable[[np.ndarray], np.ndarray]
OfBoxes = Callable[[Offsets, int], np.ndarray]  # of one point in each box, along an axis


def by_vertices(kernel: Kernel, value: OfPlaces, second: OfBoxes) -> Bound:
    return smooth(value, lambda boxes: sum(sum(second(offsets, axis) for axis in range(kernel.dims))
                                           for offsets in (Offsets.of(kernel, boxes, point) for point in kernel.points)))


def exchange_of(kernel: Kernel, same_axes_from: int) -> int:
    """Axes may be exchanged from that one on; on the plane none."""
    return kernel.dims - 1 if kernel.triangles else min(same_axes_from, kernel.dims - 1)


@functools.cache
def largest(kernel: Kernel, u: Axis, gradient: Gradient, same_axes_from: int = 0) -> float:
    """A proven upper bound of the sum, not scaled, in steps. From an axis on, axes may be exchanged."""
    bound = by_vertices(kernel, functools.partial(attained, kernel, u, gradient.support),
                        lambda offsets, axis: jet(kernel, u, gradient, offsets, axis).second)
    return supremum(bound, cell(kernel.dims, half=True), LEVELS[kernel.dims], TOLERANCE[kernel.dims],
                    exchange_of(kernel, same_axes_from))


def axes(kernel: Kernel) -> list[tuple[float, ...]]:
    """The axes that differ: on the plane both."""
    count = kernel.dims if kernel.triangles else 1
    return [tuple(float(axis == i) for i in range(kernel.dims)) for axis in range(count)]


def range_of(kernel: Kernel, gradient: Gradient) -> float:
    """The range of the sum, not scaled."""
    return largest(kernel, None, gradient)


def slope_of(kernel: Kernel, gradient: Gradient) -> float:
    """The largest derivative, per step."""
    return max(largest(kernel, axis, gradient, 1) for axis in axes(kernel))
