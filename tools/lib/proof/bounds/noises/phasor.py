"""The ranges of hn_phasor and its derivatives, without and with a bandwidth, from docs/reference/contract.md, section 23.
One holds for the value and for the quadrature: each is the real part of

    S * sum of w(t) e(a)        e(a) = exp(2 pi i a) for the value, and -i times that for the quadrature

over the points of simplex noise (kernels.py); their hashes, and so the angles, may be any. The weight w is EVEN
of weights.py.

RANGE. It is S times the supremum of the sum of the weights, which is that of the length of value and quadrature, too.
The supremum is not at a point, but in the middle of two: half a step from each on the plane, and in space half way from a
corner to a centre. A move of the place, by a cut or the rounding of a fraction, takes neither out of its range.

DERIVATIVES. One along an axis u has, per step, in place of the weight

    -2 m w' (d.u) + 2 pi i (k.u) w        with k per step

The supremum over all angles is the sum of the magnitudes. |k.u| is at most 16 waves per cell. For given angles the sum is
as smooth as the weights: so in a box it is bounded by its values at the vertices and its second derivatives, as in
kernels.py.

BANDWIDTH. The wave of a point is at most 16 along each axis, too, so the ranges are the same.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass, replace

import numpy as np

from proof.bounds import kernels
from proof.bounds.boxes import cell, supremum
from proof.bounds.gradients import Gradient
from proof.bounds.kernels import Jet, Kernel, Offsets, dot, weight_jet
from proof.bounds.noises import Proof, ProvenBounds
from proof.bounds.weights import EVEN

WAVES = 16  # per cell along an axis, at most


@dataclass(frozen=True, eq=False)
class Waves(Kernel):
    """With so many waves per cell along an axis at most, in place of gradients."""
    waves: float = WAVES


# The lattices and the distances are hn_simplex's.
KERNELS = {2: Waves(2, 819 / 1024, 1, 762, EVEN, triangles=True), 3: Waves(3, 1.0, 2, 674, EVEN)}


def attained(kernel: Kernel, u: tuple[float, ...], rate: float, place: np.ndarray) -> np.ndarray:
    """The sum of | -2 m w' (d.u) + i rate w | at places: axes by places. Without a direction, and with a rate of 1, it
    is the sum of the weights."""
    total = 0.0
    for d in kernel.offsets(place):
        w, dw = (kernel.weight.derivative(order, kernel.nearness(d)) for order in range(2))
        total = total + np.hypot(2 * kernel.fall * dw * dot(d, u), rate * w)
    return total


def second_derivative(kernel: Kernel, u: tuple[float, ...], rate: float, offsets: Offsets, axis: int) -> np.ndarray:
    """A bound of the derivative of one point's part, in each box."""
    fall = weight_jet(offsets, axis, 1) * Jet(offsets.along(u), abs(u[axis]))
    return np.hypot(2 * kernel.fall * fall.second, rate * weight_jet(offsets, axis).second)


LEVELS, TOLERANCE = {2: 16, 3: 12}, 1e-6


@functools.cache
def largest(kernel: Kernel, u: tuple[float, ...], rate: float, same_axes_from: int = 0) -> float:
    """A proven upper bound of that sum, scaled. From an axis on, axes may be exchanged."""
    bound = kernels.by_vertices(kernel, functools.partial(attained, kernel, u, rate),
                                functools.partial(second_derivative, kernel, u, rate))
    return kernel.scale / 1024 * supremum(bound, cell(kernel.dims, half=True), LEVELS[kernel.dims], TOLERANCE,
                                          kernels.exchange_of(kernel, same_axes_from))


def range_of(kernel: Kernel) -> float:
    return largest(kernel, (0.0,) * kernel.dims, 1.0)


def rate_along(kernel: Waves, axes: float) -> float:
    """How fast an angle grows along so many axes at most, per step."""
    return 2 * math.pi * kernel.waves * axes / kernel.steps


def slope_of(kernel: Waves) -> float:
    """Per cell."""
    return kernel.steps * max(largest(kernel, axis, rate_along(kernel, 1), 1) for axis in kernels.axes(kernel))


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return ProvenBounds(1.0, range_of(KERNELS[dims]))


def derive_d(dims: int, _: Gradient | None) -> ProvenBounds:
    return replace(derive(dims, None), slope=ProvenBounds(0.0, slope_of(KERNELS[dims])))


CASES = tuple((dims, None) for dims in KERNELS)
PHASOR, PHASOR_D = Proof(CASES, derive), Proof(CASES, derive_d)
PROOFS = {"phasor": PHASOR, "phasor_bandwidth": PHASOR, "phasor_d": PHASOR_D, "phasor_d_bandwidth": PHASOR_D}
