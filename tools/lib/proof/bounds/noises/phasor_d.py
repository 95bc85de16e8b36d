"""hn_phasor_d: hn_phasor with its derivatives, from docs/reference/contract.md, section 23. The value is computed in
the same steps, so it has the same bounds. One bound holds for the derivatives of the value and of the quadrature: as in
phasor.py each is the real part of a sum of z e(a) over the points, with e(a) of length 1 and along an axis

    z = -2 m w' d_i + 2 pi i k_i w

RANGE. It is what phasor.py bounds along a vector.

LIPSCHITZ. The derivative of that along a vector s has in place of z

    -2 m w' s_i + 4 m^2 w'' d_i (d.s) - c b w  +  i (c (-2 m w' (d.s)) + b (-2 m w' d_i))    c = 2 pi k_i, b = 2 pi k.s

Its length is convex in c and in b, so it is largest where both are: for both signs of their product. As in kernels.py
it is bounded by the value in the middle of a box and the first derivatives.

NO OVERFLOW. |z| is at most 2^21. The last sum is the derivative in units of 2^-24, which is less than 128. Its two
terms are less than that each, too.
"""

from __future__ import annotations

import functools
from dataclasses import replace

import numpy as np

from proof.bounds import kernel_fixed, kernels
from proof.bounds.boxes import cell, supremum
from proof.bounds.gradients import Gradient
from proof.bounds.integers import part_intermediate
from proof.bounds.kernels import Jet, Offsets, dot, weight_jet
from proof.bounds.noises import Proof, ProvenBounds, phasor
from proof.bounds.noises.phasor import KERNELS, RAMP_ONE, TURN, WAVE_CUT, Waves, scale_of
from proof.errors import record

FINE, LAST = 2.0**-24, 2.0**-16  # the units of the terms of a derivative, and of the derivative


# --- Exactly ----------------------------------------------------------------------------------------------------------

def range_of(kernel: Waves) -> float:
    """The range of a derivative, per cell."""
    rate = phasor.rate_along(kernel, 1)
    return kernel.steps * scale_of(kernel) * max(phasor.largest(kernel, axis, rate, 1) for axis in kernels.axes(kernel))


def attained(kernel: Waves, u, s, rates: tuple[float, float], place: np.ndarray) -> np.ndarray:
    """The sum of the lengths of the second derivatives along u and s, at places: axes by places."""
    m, total = kernel.fall, 0.0
    for d in kernel.offsets(place):
        w, dw, ddw = (kernel.weight.derivative(order, kernel.nearness(d)) for order in range(3))
        real = -2 * m * dw * np.dot(u, s) + 4 * m * m * ddw * dot(d, u) * dot(d, s) - rates[0] * rates[1] * w
        total = total + np.hypot(real, 2 * m * dw * (rates[0] * dot(d, s) + rates[1] * dot(d, u)))
    return total


def slope_along(kernel: Waves, u, s, rates: tuple[float, float], offsets: Offsets, axis: int) -> np.ndarray:
    """A bound of the first derivative of one point's part, in each box."""
    m = kernel.fall
    of_u, of_s = (Jet(offsets.along(v), abs(v[axis])) for v in (u, s))
    w, dw, ddw = (weight_jet(offsets, axis, order) for order in range(3))
    real = (dw.times(2 * m * abs(np.dot(u, s))) + (ddw * of_u * of_s).times(4 * m * m)
            + w.times(abs(rates[0] * rates[1])))
    across = (dw * (of_s.times(abs(rates[0])) + of_u.times(abs(rates[1])))).times(2 * m)
    return np.hypot(real.first, across.first)


LEVELS, TOLERANCE = {2: 14, 3: 9}, {2: 0.003, 3: 0.02}


@functools.cache
def steepest(kernel: Waves, u: tuple[float, ...], s: tuple[float, ...], rates: tuple[float, float],
             same_axes_from: int) -> float:
    """A proven upper bound of that sum, not scaled. From an axis on, axes may be exchanged."""
    bound = kernels.by_middle(kernel, functools.partial(attained, kernel, u, s, rates),
                              functools.partial(slope_along, kernel, u, s, rates))
    return supremum(bound, cell(kernel.dims, half=True), LEVELS[kernel.dims], TOLERANCE[kernel.dims],
                    kernels.exchange_of(kernel, same_axes_from))


def second_derivative(kernel: Waves, u: tuple[float, ...], s: tuple[float, ...], same_axes_from: int) -> float:
    """The largest along an axis and then a vector of signs or another axis, per step, not scaled."""
    along, across = (phasor.rate_along(kernel, sum(map(abs, v))) for v in (u, s))
    return max(steepest(kernel, u, s, (along, sign * across), same_axes_from) for sign in (1, -1))


def lipschitz_of(kernel: Waves) -> float:
    """The constant of a derivative, per cell."""
    return kernel.steps**2 * scale_of(kernel) * max(second_derivative(kernel, *of) for of in kernels.axes_and_signs(kernel))


def whole_turns(kernel: Waves) -> np.ndarray:
    """T of every K up to the largest wave's."""
    k = np.arange(-int(kernel.waves / WAVE_CUT), int(kernel.waves / WAVE_CUT) + 1)
    return (k * (205887 >> 9) + (k >> 9) * (205887 & 511)) >> 9


# --- Proofs -----------------------------------------------------------------------------------------------------------

def derive(dims: int, gradient: Gradient | None) -> ProvenBounds:
    kernel = KERNELS[dims]
    return replace(phasor.derive(dims, gradient), slope=ProvenBounds(0.0, range_of(kernel), lipschitz_of(kernel)))


def largest_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    kernel = KERNELS[dims]
    largest = range_of(kernel) + record.proven("phasor_d_bandwidth", dims, "none", record.DERIVATIVE, arithmetic=record.FIXED)
    low, high = kernel_fixed.pieces(kernel)
    eighth = kernel.fall / 4 * kernel.weight.size(1, low, high)
    factor = np.array([np.ceil(eighth.max() * 2**18) + 1])
    whole, turns = np.array([2**18]), whole_turns(kernel)
    k = float(eighth.max()) * RAMP_ONE + 2 * 1023
    leaning = sum_of_falls(kernel) + kernel_fixed.part_rounding(1.0).item() * 8 * len(kernel.points)
    return phasor.largest_intermediates(dims, gradient) | {
        "falling": part_intermediate(float(RAMP_ONE), factor), "leaning": 2 * part_intermediate(k, whole),
        "scaled derivative": kernel_fixed.scaled_intermediate(leaning, kernel.scale),
        "turn": part_intermediate(2.0**9 * kernel.waves / WAVE_CUT, np.array([205887])),
        "rotated": part_intermediate(2.0**29, turns[[0, -1]]),
        "last sum": (largest + LAST) / FINE,
        "first term": kernel.steps * scale_of(kernel) * leaning / 2**27 / FINE}


def sum_of_falls(kernel: Waves) -> float:
    """The largest sum of fall * |d_i|, in units of 2^-27."""
    return max(phasor.largest(kernel, axis, 0.0, 1) for axis in kernels.axes(kernel)) * 2**27


def largest_own_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    kernel, turns = KERNELS[dims], whole_turns(KERNELS[dims])
    rounding = (kernel.dims + 1) * kernel_fixed.part_rounding(abs(turns).max() / 2**18).item()
    of_terms = TURN * kernel.waves * phasor.range_of(kernel) / scale_of(kernel) * 2**23 + rounding
    return largest_intermediates(dims, gradient) | {
        "rotated term": part_intermediate(2.0**28, turns[[0, -1]]), "rotated terms": of_terms + 2**8,
        "scaled terms": (of_terms / 2**9 + 1) * kernel.scale}


PROOFS = {"phasor_d": Proof(phasor.CASES, derive, largest_intermediates),
          "phasor_d_bandwidth": Proof(phasor.CASES, derive, largest_own_intermediates)}
