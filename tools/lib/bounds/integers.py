"""What the fixed arithmetic (HN_FIXED, docs/contract.md, section 8) does to a noise of lattice points.

What depends on a single fraction is computed here for each of the 2^20 + 1 fractions F, in the integers of the
contract: the fade t of F, and how much an interpolation by t rounds. The rest is proven over boxes of fractions. Two
things move the value of every such noise:

    FADE     t is off by e(F). The corners' values n_o being given, this moves the noise by sum_o (w_o(t) - w_o(s)) n_o,
             and by at most sum_o |w_o(t) - w_o(s)| h(d_o), h the largest that n_o can be at the offset d_o. Along e_j
             that is convex (a maximum of linear functions), so it is largest where each e_j is at an end of its range
             in the box. It is far less than the sum over the axes of the largest |dn/dt_j| |e_j|: in the middle of a
             square those two are 1 |e_j| each, and never together.
    LERP     a + d t / 2^18 is rounded down, by less than 511/512 (t >> 9) + (t & 511) (from d & 511 and d & (2^18 - 1)
             in turn; where t < 0 the first is rounding up, by -511/512 (t >> 9)). The next interpolation takes the
             errors of a and b with the weights 1 - t and t, whose magnitudes make 1 plus what t leaves [0, 1] by,
             twice; so a level adds at most its own rounding.

In a box FADE is smooth up to the choice of the corners' values, and bounded as in boxes.py by its values at the
vertices and its second derivatives.
"""

import functools
import itertools
import math

import numpy as np

from bounds.boxes import FADE_1, FADE_2, corners, fade

ONE = 2**20  # I of the contract: the unit of fractions
FADE_ONE = 2**18  # the unit of t
UNIT = 2.0**-21  # of a result
BOXES = {2: 512, 3: 128}  # along an axis
SLAB = 4  # of them at a time: so few stay in the processor's cache
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


# --- The fade ---------------------------------------------------------------------------------------------------------

def fixed_fade(fraction):
    """t of the contract, in units of 2^-18."""
    g = np.minimum(fraction, ONE - fraction)
    x = np.minimum(g + 4, 2**19 - 1) >> 3
    s = word(x * x)
    z = word(s + 2**15) >> 16
    r = word(1572864 - 30 * x + 6 * z) >> 2
    q = word(s + (word(z * r) >> 2) + 2**15) >> 16
    t = word(x * q + 2**14) >> 15
    return np.where(fraction > 2**19, FADE_ONE - t, t)


@functools.cache
def fades():
    """t of every fraction."""
    return fixed_fade(np.arange(ONE + 1, dtype=np.int64))


@functools.cache
def fade_errors():
    """t - s(f) of every fraction."""
    return fades() / FADE_ONE - fade(np.arange(ONE + 1) / ONE)


def overshoot():
    """How far t leaves [0, 1]."""
    return max(0, -int(fades().min()), int(fades().max()) - FADE_ONE) / FADE_ONE


def fade_keeps_to_its_side():
    """t <= 1/2 before the middle of the cell, where any t will do, and t >= 1/2 behind it."""
    return fades()[:ONE // 2].max() <= FADE_ONE // 2 <= fades()[ONE // 2 + 1:].min()


def lerp_roundings():
    """For every fraction, how far an interpolation by its t rounds, in units of a ramp: down, or up where t < 0."""
    high, low = fades() >> 9, fades() & 511
    return 511 / 512 * np.abs(high) + low


# --- Boxes ------------------------------------------------------------------------------------------------------------

def by_box(values, boxes, reduce):
    """min or max (`reduce`) of the values over the fractions of each of the boxes along an axis, ends included."""
    inner = reduce.reduce(values[:-1].reshape(boxes, -1), axis=1)
    return reduce(inner, values[ONE // boxes::ONE // boxes])


def grids(values, dims):
    """The values along each axis, to be combined by broadcasting."""
    return np.meshgrid(*[values] * dims, indexing="ij", sparse=True)


def vertices_max(values):
    """For each box the largest of the values at its vertices."""
    for axis in range(values.ndim):
        count = values.shape[axis] - 1
        values = np.maximum(values.take(range(count), axis), values.take(range(1, count + 1), axis))
    return values


def weight(corner, fade_values):
    return math.prod(s if o else 1 - s for o, s in zip(corner, fade_values))


@functools.cache
def fade_effect(dims, largest):
    """For each box, a bound of FADE. `largest` maps offsets to h, the maximum of affine functions of them. Of
    sum_o +-(w_o(s + e) - w_o(s)) (f_i - o_i), for any signs and any i at each corner, the second derivative along an
    axis j is at most (2 FADE_2 + 4 FADE_1) times the product over the other axes of 1 + 2 |e_i|, less 1: the change of
    the weights is a sum over the non-empty sets of axes whose factor is +-e_i instead of a weight, j not among them."""
    boxes = BOXES[dims]
    ends = [grids(by_box(fade_errors(), boxes, reduce), dims) for reduce in (np.minimum, np.maximum)]
    effect = np.zeros([boxes] * dims)
    for vertex, start in itertools.product(corners(dims), range(0, boxes, SLAB)):
        slab = slice(start, start + SLAB)
        f = [x + v / boxes for x, v in zip(grids(np.arange(boxes) / boxes, dims), vertex)]
        f[0] = f[0][slab]
        s = [fade(x) for x in f]
        of_corners = [(corner, weight(corner, s), largest([x - o for x, o in zip(f, corner)]))
                      for corner in corners(dims)]
        for pick in corners(dims):
            errors = [ends[end][axis] for axis, end in enumerate(pick)]
            moved = [x + e for x, e in zip(s, [errors[0][slab], *errors[1:]])]
            change = sum(np.abs(weight(corner, moved) - exact) * h for corner, exact, h in of_corners)
            effect[slab] = np.maximum(effect[slab], change)
    error = np.abs(fade_errors()).max()
    curvature = (2 * FADE_2 + 4 * FADE_1) * ((1 + 2 * error) ** (dims - 1) - 1) * largest([1.0] * dims)
    # DOUBLE * 2^n corners: what the rounding of the exact fade may add.
    return effect + curvature / 8 * dims / boxes**2 + DOUBLE * 2**dims * dims


def rounding_effect(dims, of_corner=0):
    """For each box, a bound of LERP in units of the corners' values, which are themselves rounded by `of_corner`."""
    lerps = sum(grids(by_box(lerp_roundings(), BOXES[dims], np.maximum), dims))
    return (lerps + of_corner) * (1 + 2 * overshoot()) ** dims


# --- Overflow ---------------------------------------------------------------------------------------------------------

def interpolation_intermediates(corner, dims):
    """By name, bounds of the magnitudes in the interpolation of corners' values of at most `corner`. Interpolated
    values stay as large, with LERP. The first product is at most (|d| / 2^9 + 1) (t >> 9), the second half of the
    interpolation below (|d| / 2^18 + 1) * 511; their sum may be taken of both magnitudes."""
    value = corner + dims * lerp_roundings().max() + 2 * corner * overshoot() * dims
    difference = 2 * value
    t = int(np.abs(fades()).max())
    lerp = (difference / 2**9 + 1) * ((t >> 9) + 1) + (difference / 2**18 + 1) * 511
    return {"value": value, "difference": difference, "lerp": lerp}
