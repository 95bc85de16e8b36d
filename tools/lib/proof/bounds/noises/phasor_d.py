"""hn_phasor_d: hn_phasor with its derivatives, from docs/reference/contract.md, section 23. The value is computed in
the same steps, so it has the same bounds. One bound holds for the derivatives of the value and of the quadrature: as in
phasor.py each is the real part of a sum of z e(a) over the points, with e(a) of length 1 and along an axis

    z = -2 m w' d_i + 2 pi i k_i w

RANGE. It is what phasor.py bounds along a vector.

LIPSCHITZ. The derivative of that along a vector s has in place of z

    -2 m w' s_i + 4 m^2 w'' d_i (d.s) - c b w  +  i (c (-2 m w' (d.s)) + b (-2 m w' d_i))    c = 2 pi k_i, b = 2 pi k.s

Its length is convex in c and in b, so it is largest where both are: for both signs of their product. As in kernels.py
it is bounded by the value in the middle of a box and the first derivatives.

FIXED. The fall is as in kernel_fixed.py, with a cosine, which is at most 1, in place of a ramp. The sum is in units of
2^-27 per step. Its product with S, in units of 2^-19, is exact in units of 2^-24 per cell, and so

    TURN     2 pi k_i is off by the largest error over all integers K, 2^21 + 1 in number, and by the cut of the wave,
             times a value of at most 1. With T = 512 a + b the part of 2^8 z is z/2 a + z/2^10 b, and z >> 1 and
             z >> 10 round down
    VALUE    the error of z times 2 pi k_i
    LAST     the last sum is rounded to a multiple of 2^-16

BANDWIDTH. In place of the value each of its terms is multiplied by T of the point. There the half of a term rounds down by up to 2^-29, the part of each is off as `part` is, and the sum is
rounded to a multiple of 2^-14 before it is scaled.

NO OVERFLOW. |z| is at most 2^21. The last sum is the derivative in units of 2^-24, which is less than 128. Its two
terms are less than that each, too.
"""

from __future__ import annotations

import functools
from dataclasses import replace

import numpy as np

from proof.bounds import kernel_fixed, kernels
from proof.bounds.boxes import Boxes, cell, supremum
from proof.bounds.gradients import Gradient
from proof.bounds.integers import ONE, SLOPE_UNIT, UNIT, part_intermediate
from proof.bounds.kernels import Jet, Offsets, dot, weight_jet
from proof.bounds.noises import Proof, ProvenBounds, derived, phasor
from proof.bounds.noises.phasor import KERNELS, OWN, RAMP_ONE, TURN, WAVE_CUT, Waves, scale_of

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


# --- Fixed ------------------------------------------------------------------------------------------------------------

@functools.cache
def fixed_rounding_effect(kernel: Waves) -> float:
    """The effect of rounding at the points: on a derivative and, times 2 pi k, through the value; per cell, not
    scaled."""
    rate = TURN * kernel.waves

    def of_boxes(boxes: Boxes):
        points = [kernel_fixed.Point(kernel, boxes, point) for point in kernel.points]
        return rate * sum(point.value() for point in points) + kernel.steps * np.maximum.reduce(
            [sum(point.falling(axis) for point in points) for axis in range(kernel.dims)])
    return kernel_fixed.error_supremum(kernel, of_boxes)


def whole_turns(kernel: Waves) -> np.ndarray:
    """T of every K up to the largest wave's."""
    k = np.arange(-int(kernel.waves / WAVE_CUT), int(kernel.waves / WAVE_CUT) + 1)
    return (k * (205887 >> 9) + (k >> 9) * (205887 & 511)) >> 9


@functools.cache
def fixed_rotation_error(kernel: Waves) -> float:
    """How far T times a value of at most 1 is off, and the part of the contract from it."""
    turns = whole_turns(kernel)
    exactly = TURN * 2.0**-3 * np.arange(-(len(turns) // 2), len(turns) // 2 + 1)
    off = abs(turns - exactly).max() * 2.0**-13 + TURN * kernel.wave_cut
    if kernel.is_own:
        of_part = kernel_fixed.part_rounding(abs(turns).max() / 2**18).item() * 2.0**-23
        return off + scale_of(kernel) * (kernel.dims + 1) * (of_part + TURN * kernel.waves * 2.0**-29)
    rounding = abs((turns >> 9) / 2).max() + abs(turns & 511).max()
    return off + rounding * FINE


def fixed_parts(kernel: Waves, lipschitz: float) -> dict[str, float]:
    of_value = (scale_of(kernel) * 2.0**-15 if kernel.is_own else
                TURN * kernel.waves * kernel_fixed.scale_error(kernel, UNIT))
    scaling = kernel.steps * kernel_fixed.scale_error(kernel, SLOPE_UNIT) + of_value
    return {"cut": lipschitz / ONE, "points": scale_of(kernel) * fixed_rounding_effect(kernel), "scaling": scaling,
            "turn": fixed_rotation_error(kernel) + LAST / 2}


# --- Proofs -----------------------------------------------------------------------------------------------------------

def derived_slope(kernel: Waves) -> ProvenBounds:
    lipschitz = lipschitz_of(kernel)
    return derived(0.0, range_of(kernel), lipschitz, parts=fixed_parts(kernel, lipschitz))


def derive(dims: int, gradient: Gradient | None) -> ProvenBounds:
    return replace(phasor.derive(dims, gradient), slope=derived_slope(KERNELS[dims]))


def derive_own(dims: int, gradient: Gradient | None) -> ProvenBounds:
    return replace(phasor.derive_own(dims, gradient), slope=derived_slope(OWN[dims]))


def largest_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    kernel, slope = KERNELS[dims], derive(dims, gradient).slope
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
        "last sum": (slope.fixed_largest + LAST) / FINE,
        "first term": kernel.steps * scale_of(kernel) * leaning / 2**27 / FINE}


def sum_of_falls(kernel: Waves) -> float:
    """The largest sum of fall * |d_i|, in units of 2^-27."""
    return max(phasor.largest(kernel, axis, 0.0, 1) for axis in kernels.axes(kernel)) * 2**27


def largest_own_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    kernel, turns = OWN[dims], whole_turns(OWN[dims])
    rounding = (kernel.dims + 1) * kernel_fixed.part_rounding(abs(turns).max() / 2**18).item()
    of_terms = TURN * kernel.waves * phasor.range_of(kernel) / scale_of(kernel) * 2**23 + rounding
    return largest_intermediates(dims, gradient) | {
        "rotated term": part_intermediate(2.0**28, turns[[0, -1]]), "rotated terms": of_terms + 2**8,
        "scaled terms": (of_terms / 2**9 + 1) * kernel.scale}


PROOFS = {"phasor_d": Proof(phasor.CASES, derive, largest_intermediates),
          "phasor_d_bandwidth": Proof(phasor.CASES, derive_own, largest_own_intermediates)}
