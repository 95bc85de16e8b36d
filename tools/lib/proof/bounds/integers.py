"""Integers of HN_FIXED (docs/reference/contract.md, sections 8 to 11): the fade t and its slope of each of the 2^20 + 1
fractions F, and how much a product with each of them rounds. The text proves the errors of values (text.py); the errors of
derivatives of Perlin noise in 4D, and with a phase in 3D, are proven here, over boxes of fractions. Two things move them:

    FADE     t is off by e(F), and the slope of a fade by e'(F). A derivative is sum_o g_o.v_o with the v_o of SLOPE in
             suprema.py, so it moves by at most sum_o h(change of v_o), h the largest that a ramp can be. This is convex
             along each e_j and along e' (a maximum of linear functions), so it is largest where each is at an end of its
             range in the box. It is far less than the sum over the axes of the largest |d/dt_j| |e_j|.
    LERP     a + d t / 2^18 is rounded down, by less than 511/512 (t >> 9) + (t & 511) (from d & 511 and d & (2^18 - 1)
             in turn; where t < 0 the first is rounding up, by -511/512 (t >> 9)). The next interpolation takes the
             errors of a and b with the weights 1 - t and t, whose magnitudes make 1 plus what t leaves [0, 1] by,
             twice; so a level adds at most its own rounding.

In a box FADE is smooth up to the choice of the corners' values, and bounded as in suprema.py by its values at the
vertices and its second derivatives. The change of the weights is a sum over the non-empty sets of axes whose factor is
+-e_i instead of a weight. At 1 - f the fade is off by -e and its slope by e', so half of the cell is enough.
"""

from __future__ import annotations

import functools
import itertools
import math

import numpy as np

from proof.bounds.boxes import SAFE, Boxes, corners, fade, fade_derivative, grid, in_chunks, largest_derivative
from proof.bounds.gradients import Gradient

ONE = 2**20  # I of the contract: the unit of fractions
FADE_ONE = 2**18  # the unit of t and of slopes
UNIT = 2.0**-21  # of a result
SLOPE_UNIT = 2.0**-19  # of a derivative
DOUBLE = 1e-15  # more than the rounding error of the exact fade in doubles


def checked(values, low, high):
    """The integers as they are, if they need not wrap."""
    if np.min(values) < low or np.max(values) >= high:
        raise OverflowError(f"{np.min(values)} .. {np.max(values)} is not within [{low}, {high})")
    return values


def signed(values):
    return checked(values, -2**31, 2**31)


def word(values):
    return checked(values, 0, 2**32)


# --- Of each fraction -------------------------------------------------------------------------------------------------

@functools.cache
def fractions():
    return np.arange(ONE + 1, dtype=np.int64)


def nearer_end(fraction):
    """x of the contract, in units of 2^-17."""
    return np.minimum(np.minimum(fraction, ONE - fraction) + 4, 2**19 - 1) >> 3


def fixed_fade(fraction):
    """t of the contract, in units of 2^-18."""
    x = nearer_end(fraction)
    s = word(x * x)
    z = word(s + 2**15) >> 16
    r = word(1572864 - 30 * x + 6 * z) >> 2
    q = word(s + (word(z * r) >> 2) + 2**15) >> 16
    t = word(x * q + 2**14) >> 15
    return np.where(fraction > 2**19, FADE_ONE - t, t)


def fixed_slope(fraction):
    """The slope of the fade, in units of 2^-18."""
    x = nearer_end(fraction)
    q = word(x * (2**17 - x)) >> 16
    return word((word(q * q) >> 4) * 15 + 4096) >> 13


@functools.cache
def fades():
    """t of every fraction."""
    return fixed_fade(fractions())


@functools.cache
def slopes():
    return fixed_slope(fractions())


@functools.cache
def fade_errors():
    """t - s(f) of every fraction."""
    return fades() / FADE_ONE - fade(fractions() / ONE)


@functools.cache
def slope_errors():
    return slopes() / FADE_ONE - fade_derivative(1, fractions() / ONE)


def overshoot():
    """How far t leaves [0, 1]."""
    return max(0, -int(fades().min()), int(fades().max()) - FADE_ONE) / FADE_ONE


def part_roundings(factors):
    """How far a product of the contract, part(d, t), rounds, in units of d: down, or up where t < 0."""
    return 511 / 512 * np.abs(factors >> 9) + (factors & 511)


@functools.cache
def lerp_roundings():
    """For every fraction, how far an interpolation by its t rounds."""
    return part_roundings(fades())


# --- Boxes ------------------------------------------------------------------------------------------------------------

# The levels of boxes: of all of them, and of those that are nearly the worst.
SLOPE_COARSE, SLOPE_FINE = {1: 12, 2: 8, 3: 5, 4: 4}, {1: 14, 2: 9, 3: 7, 4: 5}
NEARLY = 0.92


@functools.cache
def by_level(values, level):
    """The least and the largest of values() over the fractions of each of 2^level boxes along an axis, ends
    included."""
    boxes = 2**level
    inner = values()[:-1].reshape(boxes, -1)
    last = values()[ONE // boxes::ONE // boxes]
    return np.minimum(inner.min(axis=1), last), np.maximum(inner.max(axis=1), last)


def ends(values, boxes: Boxes) -> list[np.ndarray]:
    """Both, along each axis of the boxes."""
    return [of_box[boxes.index] for of_box in by_level(values, boxes.level)]


def weight(corner, fade_values):
    return math.prod(s if o else 1 - s for o, s in zip(corner, fade_values))


def _magnitudes(boxes: Boxes, values=fade_errors):
    return np.maximum.reduce([abs(end) for end in ends(values, boxes)])


def _but(product, *axes):
    """The product over the other axes."""
    kept = [factor for axis, factor in enumerate(product) if axis not in axes]
    return math.prod(kept) if kept else 1.0


def _largest(boxes: Boxes) -> list[np.ndarray | None]:
    """Bounds of the derivatives of s in each box, by their order, from 1 to 3."""
    return [None, *(largest_derivative(order, boxes.lo, boxes.hi) for order in (1, 2, 3))]


def slope_fade_effect(boxes: Boxes, gradient: Gradient) -> np.ndarray:
    """For each box, a bound of FADE of the derivative along the first axis."""
    errors, dims, effect = ends(fade_errors, boxes), boxes.dims, 0.0
    slope_ends = [end[0] for end in ends(slope_errors, boxes)]
    for point in boxes.vertices():
        s, ds = fade(point), fade_derivative(1, point[0])
        exact = {corner: weight(corner, s) for corner in corners(dims)}
        offsets = {corner: point - np.array(corner)[:, None] for corner in corners(dims)}
        for pick, slope_end in itertools.product(corners(dims), slope_ends):
            t = [s[axis] + errors[end][axis] for axis, end in enumerate(pick)]
            change = 0.0
            for corner in corners(dims):
                sign, rest = 2 * corner[0] - 1, corner[1:]
                climb = sign * ((ds + slope_end) * weight(rest, t[1:]) - ds * weight(rest, s[1:]))
                v = climb * offsets[corner]
                v[0] += weight(corner, t) - exact[corner]
                change = change + gradient.support(v)
            effect = np.maximum(effect, change)
    return effect + _slope_fade_curvature(boxes, gradient) / 8 * boxes.side**2 + DOUBLE * 4**dims * dims


def _slope_fade_curvature(boxes: Boxes, gradient: Gradient) -> np.ndarray:
    """The second derivatives of sum_o g_o.(change of v_o). With v_o = (d_1 w) d + w e and offsets d that grow by 1, it
    is h(1, .., 1) times the second derivative of d_1 w, and h(1, 0, ..) times twice its first and the second of w.
    Along the first axis s' of d_1 w is differentiated, and its change has the factor of the others; along another the
    change has the factors s' + e' and 1 + 2 e, less the exact product."""
    reach, component = gradient.reach(boxes.dims), gradient.component(boxes.dims)
    grown, slope_error = 1 + 2 * _magnitudes(boxes), _magnitudes(boxes, slope_errors)[0]
    largest, total = _largest(boxes), 0.0
    for axis in range(boxes.dims):
        if axis == 0:
            first, second = (2 * largest[order][0] * (_but(grown, 0) - 1) for order in (2, 3))
        else:
            others = 2 * ((largest[1][0] + slope_error) * _but(grown, 0, axis) - largest[1][0])
            first, second = (2 * largest[order][axis] * others for order in (1, 2))
        total = total + reach * second + component * (2 * first + 2 * largest[2][axis] * (_but(grown, axis) - 1))
    return total


@functools.cache
def largest_slope_fade_effect(dims: int, gradient: Gradient) -> float:
    """The largest over the boxes. Boxes with nearly the largest are halved, for a tighter bound."""
    boxes, settled = grid(dims, SLOPE_COARSE[dims]).sorted_from(min(1, dims - 1)), 0.0

    def effect(some: Boxes) -> tuple[np.ndarray]:
        return slope_fade_effect(some, gradient),
    while boxes.level < SLOPE_FINE[dims]:
        of_box, = in_chunks(effect, boxes)
        nearly = of_box > NEARLY * of_box.max()
        settled = max(settled, float(of_box[~nearly].max(initial=0.0)))
        boxes = boxes.only(nearly).halved().sorted_from(min(1, dims - 1))
    return max(settled, float(in_chunks(effect, boxes)[0].max())) * SAFE


# --- Derivatives ------------------------------------------------------------------------------------------------------

def slope_rounding(dims: int) -> float:
    """A bound of what derivatives round by, in units four times as large as for the ramps. Every shift by 2 rounds down by at most 3/4. After k interpolations a ramp is rounded down by at most k lambda, lambda the
    largest rounding of LERP, and so a rise is off by that at most, up or down. Components of gradients are multiples of
    2^18 in their units, so their first interpolation is exact, and k of them round by less than k lambda. The product
    with the slope has its own rounding, and the result is interpolated along the axes behind."""
    lerp, product = float(lerp_roundings().max()), float(part_roundings(slopes()).max())
    steepest, worst = slopes().max() / FADE_ONE, 0.0
    for axis in range(dims):
        behind = dims - 1 - axis
        rise = axis * lerp / 4 + 3 / 4
        worst = max(worst, axis * lerp + steepest * rise + product + behind * lerp)
    return worst * (1 + 2 * overshoot()) ** dims


# --- Overflow ---------------------------------------------------------------------------------------------------------

def part_intermediate(value: float, factors) -> float:
    """The magnitude of part(d, t) for |d| up to `value`: the first product is at most (|d| / 2^9 + 1) (t >> 9), the
    second below (|d| / 2^18 + 1) * 511; their sum may be taken of both magnitudes."""
    return (value / 2**9 + 1) * ((int(np.abs(factors).max()) >> 9) + 1) + (value / 2**18 + 1) * 511


def interpolation_intermediates(corner: float, dims: int, difference: float | None = None) -> dict[str, float]:
    """By name, bounds of the magnitudes in the interpolation of corners' values of at most `corner`; two that are
    interpolated differ by at most `difference`. Interpolated values stay as large, with LERP."""
    off = dims * lerp_roundings().max()
    value = corner + off + 2 * corner * overshoot() * dims
    apart = 2 * value if difference is None else difference + 2 * off + 4 * corner * overshoot() * dims
    return {"value": value, "difference": apart, "lerp": part_intermediate(apart, fades())}


def slope_intermediates(rise: float, gradient: float, dims: int, difference: float | None = None) -> dict[str, float]:
    """The words of the derivatives that are interpolated with the values. Components of gradients are at most
    `gradient`, and rises of values, before they are shifted, at most `rise`. Two derivatives differ by at most
    `difference`, but for their rounding."""
    climb = part_intermediate(rise / 4 + 1, slopes())
    made = gradient + dims * lerp_roundings().max() + climb
    apart = None if difference is None else difference + 2 * slope_rounding(dims)
    return {"climb": climb, **{f"derivative's {name}": value for name, value in
                               interpolation_intermediates(made, dims, apart).items()}}


# --- Scales of ramps --------------------------------------------------------------------------------------------------

RAMP_ONE = {1: 2**29, 2: 2**29, 3: 2**29, 4: 2**28}  # the units of ramps


def fixed_scale(scale: float, dims: int) -> int:
    """S of the contract; the ramps in 4D have units twice as large."""
    return round(scale * 1024) * (2**29 // RAMP_ONE[dims])


def scaling_error(scale: int, unit: float) -> float:
    return (256 * scale / 2**18 + 1 / 2) * unit


def scaled_intermediate(value: float, scale: int) -> float:
    """((n + 256) >> 9) * S + 256."""
    return (value / 2**9 + 1) * scale + 256
