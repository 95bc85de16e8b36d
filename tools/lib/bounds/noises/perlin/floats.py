"""The error of hn_perlin and of the derivatives of hn_perlin_d in float arithmetic, against the exact value at the
exact real fraction.

The ramps of the corners are evaluated as

    1D: g*d
    2D: r = x*d.x + y*d.y, with the direction (x, y);  ramp = r*more + r
    3D: a = 0.5*f.x + 0.5*f.y;  b = 0.5*f.x - 0.5*f.y;  r = p*u + q*v + m*d.z, where for the corners
        (0, 0), (1, 0), (0, 1), (1, 1) of x and y  u = a, a - 0.5, a - 0.5, a - 0.5 - 0.5  and  v = b, b - 0.5, b + 0.5,
        b; ramp = r*more + r
    4D: +-d_i +- d_j
    sine:  g.x*d.x + g.y*d.y (+ g.z*d.z), from left to right

and the noise is the scale times their interpolation (floats.py of the folder above). The propagation takes all
gradients of the octahedron at once, independently at each corner: it is rigorous, not tight. Its directions, `more` = 1
- L and the components of its gradients are exact: multiples of 2^-18 up to 1.

In 3D |u| + |v| = max(|d_1|, |d_2|) (before rounding) and P = max(|p|, |q|) = 1 - |m|, so |p u| + |q v| + |m d_3| is at
most max_i |d_i|, as the direction times d is, and errors of u, v and d_3 come to at most
P (U + V) + (1 - P) D_3 <= max(U + V, D_3).

SINE GRADIENT. The float of a component is within 2^-19 of the exact one, and at most 1; each product of a ramp takes
that over times |d_i|. The computed noise may leave [-n/2, n/2] by its error.
"""

import functools

import numpy as np

from bounds.boxes import corners
from bounds.floats import (TINY, UNIT, Approx, approx_derivatives, approx_interpolation, approx_offsets, error_supremum,
                           rounding)
from bounds.gradients import OCTAHEDRAL, SINE
from bounds.noises.perlin.exact import SCALE

MORE = {2: 1 / 2, 3: 2 / 3}  # the largest 1 - L


def largest_of(numbers):
    return functools.reduce(np.maximum, numbers)


def approx_direction(size, err, terms, ulps):
    """d . v for any direction |d|_1 = 1, where |d . v| is at most `size` and the errors of what d multiplies come to
    `err`. The products err by UNIT * |d_i v_i| each, by UNIT * size together, and every partial sum is at most the
    size."""
    ramp = Approx(-size, size, err + ulps * UNIT * (size + err) + terms * TINY, ulps)
    for _ in range(terms - 1):
        ramp = ramp.rounded()
    return ramp


def approx_lengthened(ramp, own):
    """r*more + r, whose size is h of what the gradient is multiplied with."""
    more = MORE[len(own)]
    size = OCTAHEDRAL.support(np.broadcast_arrays(*[d.size() for d in own]))
    err = ramp.err * (1 + more) + rounding((ramp.size() + ramp.err) * more, ramp.ulps)
    return Approx(-size, size, err, ramp.ulps).rounded()


def approx_plane_ramp(own, ulps):
    ramp = approx_direction(largest_of(d.size() for d in own), largest_of(d.err for d in own), 2, ulps)
    return approx_lengthened(ramp, own)


def halved(value):
    return Approx(value.lo / 2, value.hi / 2, value.err / 2 + TINY, value.ulps)


def diagonal_difference(x, y, ulps):
    """x - y, which is exact where one is at most twice the other (Sterbenz)."""
    lo, hi = x.lo - y.hi, x.hi - y.lo
    exact = np.maximum(x.hi, y.hi) <= 2 * np.minimum(x.lo, y.lo)
    err = x.err + y.err + np.where(exact, 0.0, rounding(np.maximum(-lo, hi), ulps))
    return Approx(lo, hi, err, ulps)


def shifted(value, constant):
    """value + constant for |constant| = 0.5 and |value| <= 1: exact where the value, as computed, has the other sign
    and half the constant's size or more (Sterbenz; 1/4 is a float, so rounding does not cross it)."""
    if constant == 0:
        return value
    nearest_0 = value.lo if constant < 0 else -value.hi
    moved = Approx(value.lo + constant, value.hi + constant, value.err, value.ulps)
    err = np.where(nearest_0 >= abs(constant) / 2, moved.err, moved.rounded().err)
    return Approx(moved.lo, moved.hi, err, value.ulps)


def approx_space_ramp(offsets, corner, ulps):
    """p*u + q*v + m*d.z, lengthened; `offsets` are those of the corner, from which the size, and those of f."""
    (x, _), (y, _), z = offsets[0], offsets[1], offsets[2][corner[2]]
    x, y = (halved(Approx(f.lo, f.hi, TINY, ulps)) for f in (x, y))
    u = x.sum(y)
    for _ in range(corner[0] + corner[1]):
        u = shifted(u, -0.5)
    v = shifted(diagonal_difference(x, y, ulps), 0.5 * (corner[1] - corner[0]))
    own = [offset[o] for offset, o in zip(offsets, corner)]
    ramp = approx_direction(largest_of(d.size() for d in own), np.maximum(u.err + v.err, z.err), 3, ulps)
    return approx_lengthened(ramp, own)


def approx_sum_of_two(own, ulps):
    """Of the two that are largest, with the two largest errors."""
    sizes, errs = (np.sort(np.broadcast_arrays(*[getattr(d, name) for d in offsets]), axis=0)[-2:].sum(axis=0)
                   for name, offsets in (("hi", [Approx(0, d.size(), 0, ulps) for d in own]), ("err", own)))
    return Approx(-sizes, sizes, errs, ulps).rounded()


def approx_sine_ramp(own, ulps):
    """g . d for any |g_i| <= 1 of which the float is within SINE.component_error, and at most 1, too."""
    products = []
    for d in own:
        size = d.size()
        products.append(Approx(-size, size, d.err + size * SINE.component_error, ulps).rounded())
    return functools.reduce(Approx.sum, products)


def approx_ramp(offsets, corner, gradient, ulps):
    own = [offset[o] for offset, o in zip(offsets, corner)]
    if gradient is SINE:
        return approx_sine_ramp(own, ulps)
    if len(own) == 1:
        return Approx(-own[0].size(), own[0].size(), own[0].err, ulps).rounded()
    if len(own) == 4:
        return approx_sum_of_two(own, ulps)
    return approx_plane_ramp(own, ulps) if len(own) == 2 else approx_space_ramp(offsets, corner, ulps)


def ramps_and_fractions(lo, hi, gradient, ulps):
    """The ramps of the corners, x varying fastest."""
    offsets = [approx_offsets(a, b, ulps) for a, b in zip(lo, hi)]
    ramps = [approx_ramp(offsets, corner[::-1], gradient, ulps) for corner in corners(len(lo))]
    return ramps, [fraction for fraction, _ in offsets]


def value_error(lo, hi, gradient, ulps):
    """The largest error of hn_perlin from a cell and a fraction in each box, given by its ends along each axis."""
    value = approx_interpolation(*ramps_and_fractions(lo, hi, gradient, ulps))
    return (value if gradient is SINE else value.scaled(SCALE[gradient][len(lo)])).err


def slope_error(lo, hi, ulps):
    """The same of the derivatives, with octahedral gradients."""
    derivatives = approx_derivatives(*ramps_and_fractions(lo, hi, OCTAHEDRAL, ulps), Approx(-1.0, 1.0, 0.0, ulps))
    return largest_of(derivative.scaled(SCALE[OCTAHEDRAL][len(lo)]).err for derivative in derivatives)


@functools.cache
def error_bound(dims, gradient, ulps=1.0):
    """A proven upper bound of the error from (cell, fraction)."""
    return error_supremum(functools.partial(value_error, gradient=gradient, ulps=ulps), dims)


@functools.cache
def slope_error_bound(dims, ulps=1.0):
    return error_supremum(functools.partial(slope_error, ulps=ulps), dims)
