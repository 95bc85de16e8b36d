"""Proofs for hn_phasor, without and with a bandwidth, from docs/reference/contract.md, section 23. One bound holds for
the value and for the quadrature: each is the real part of

    S * sum of w(t) e(a)        e(a) = exp(2 pi i a) for the value, and -i times that for the quadrature

over the points of simplex noise (kernels.py); their hashes, and so the angles, may be any. The weight w is EVEN
of weights.py.

RANGE. It is S times the supremum of the sum of the weights, which is that of the length of value and quadrature, too.
The supremum is not at a point, but in the middle of two: half a step from each on the plane, and in space half way from a
corner to a centre. A move of the place, by a cut or the rounding of a fraction, takes neither out of its range.

LIPSCHITZ. The derivative along a vector u, per step, has in place of the weight

    -2 m w' (d.u) + 2 pi i (k.u) w        with k per step

The supremum over all angles is the sum of the magnitudes. |k.u| is at most the sum of 16 waves per cell along each
axis, for any signs of u. For given angles the sum is as smooth as the weights: so in a box it is bounded by its values
at the vertices and its second derivatives, as in kernels.py.

BANDWIDTH. The wave of a point is at most 16 along each axis, too, so ranges and slopes are the same.

NO OVERFLOW. K is at most 2^20. An offset is at most 1 step along an axis, and the contract's product takes the high and
the low 10 bits in turn: the low ones are below 2^10, and the high ones are at most 2^10. The words on the way to a
weight and to its fall are evaluated for every t.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass

import numpy as np

from proof.bounds import kernel_fixed, kernels
from proof.bounds.boxes import cell, supremum
from proof.bounds.gradients import Gradient
from proof.bounds.integers import word
from proof.bounds.kernels import Jet, Kernel, Offsets, dot, weight_jet
from proof.bounds.noises import Proof, ProvenBounds
from proof.bounds.sine import fixed_sine_largest
from proof.bounds.weights import EVEN

WAVES = 16  # per cell along an axis, at most
WAVE_CUT = 2.0**-16  # in waves per cell


@dataclass(frozen=True, eq=False)
class Waves(Kernel):
    """With so many waves per cell along an axis at most, in place of gradients."""
    waves: float = WAVES


# The lattices and the distances are hn_simplex's.
KERNELS = {2: Waves(2, 819 / 1024, 1, 762, EVEN, triangles=True), 3: Waves(3, 1.0, 2, 674, EVEN)}
CASES = tuple((dims, None) for dims in KERNELS)
TURN = 2 * math.pi
RAMP_ONE = 2**29  # the unit of the factors of weights


# --- Exactly ----------------------------------------------------------------------------------------------------------

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
    """A proven upper bound of that sum. From an axis on, axes may be exchanged."""
    bound = kernels.by_vertices(kernel, functools.partial(attained, kernel, u, rate),
                                functools.partial(second_derivative, kernel, u, rate))
    return supremum(bound, cell(kernel.dims, half=True), LEVELS[kernel.dims], TOLERANCE,
                    kernels.exchange_of(kernel, same_axes_from))


def scale_of(kernel: Kernel) -> float:
    return kernel.scale / 1024


def range_of(kernel: Kernel) -> float:
    return scale_of(kernel) * largest(kernel, (0.0,) * kernel.dims, 1.0)


def rate_along(kernel: Waves, axes: float) -> float:
    """How fast an angle grows along so many axes at most, per step."""
    return TURN * kernel.waves * axes / kernel.steps


def lipschitz_of(kernel: Waves) -> float:
    """Per cell."""
    rate = rate_along(kernel, kernel.dims)
    return kernel.steps * scale_of(kernel) * max(largest(kernel, sign, rate, same)
                                                 for sign, same in kernels.signs(kernel))


# --- Proofs -----------------------------------------------------------------------------------------------------------

def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return ProvenBounds(1.0, range_of(KERNELS[dims]), lipschitz_of(KERNELS[dims]))


@functools.cache
def largest_words() -> dict[str, int]:
    """The largest words on the way to W and E, as they are evaluated for every t."""
    t = np.arange(2**16, dtype=np.int64)
    q = (t * t + 2**15) >> 16
    g, h = t - q, 4 * t - 5 * q
    of_g = 15 * g * g + 2**15
    words = {"of G": of_g, "of M": (q + (of_g >> 16)) * t + 2**13, "of H": h * h + 2**15}
    return {name: int(word(of_t).max()) for name, of_t in words.items()}


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    kernel, wave = KERNELS[dims], WAVES / WAVE_CUT
    largest_words()  # raises where one would not fit
    return {"wave times the high bits": wave * 2**10, "wave times the low bits": wave * (2**10 - 1),
            "bandwidth times a direction": (wave / 2**10 + 1) * 2**16,
            **kernel_fixed.weighted_intermediates(kernel, fixed_sine_largest() * RAMP_ONE)}


PROOFS = {"phasor": Proof(CASES, derive, largest_intermediates),
          "phasor_bandwidth": Proof(CASES, derive, largest_intermediates)}
