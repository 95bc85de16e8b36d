"""The error of hn_perlin and of the derivatives of hn_perlin_d in float arithmetic, against the exact value at the
exact real fraction.

The ramps of the corners are evaluated as

    1D: g*d                      2D: g.x*d.x + g.y*d.y
    3D and 4D: +-d_i +- d_j      sine:  g.x*d.x + g.y*d.y (+ g.z*d.z), from left to right

and the noise is the scale times their interpolation (floats.py of the folder above). The propagation takes the worst
gradient at each corner, and at each step of it: it is rigorous, not tight. Gradients are exact. On the plane a product
with 1/4 is exact, too, and so is one with 1 in space.

SINE GRADIENT. The float of a component is within 2^-19 of the exact one, and at most 1; each product of a ramp takes
that over times |d_i|. The computed noise may leave [-n/2, n/2] by its error.
"""

import functools

import numpy as np

from proof.bounds.boxes import corners
from proof.bounds.floats import (
    TINY,
    Approx,
    approx_derivatives,
    approx_interpolation,
    approx_offsets,
    error_supremum,
    rounding,
)
from proof.bounds.gradients import OCTAHEDRAL, SINE, two_largest
from proof.bounds.noises.perlin.exact import SCALE


def largest_of(numbers):
    return functools.reduce(np.maximum, numbers)


def approx_plane_ramp(own, ulps):
    """With 3/4 along either axis and 1/4 along the other."""
    x, y = own
    err = largest_of((3 * a.err + b.err) / 4 + rounding(0.75 * (a.size() + a.err), ulps) for a, b in ((x, y), (y, x)))
    size = OCTAHEDRAL.support([x.size(), y.size()])
    return Approx(-size, size, err + TINY, ulps).rounded()


def approx_sum_of_two(own, ulps):
    """The sum of the two that are largest, with the two largest errors."""
    size, err = (sum(two_largest(np.broadcast_arrays(*numbers))) for numbers in
                 ([d.size() for d in own], [d.err for d in own]))
    return Approx(-size, size, err, ulps).rounded()


def approx_octahedral_ramp(own, ulps):
    """From the offsets of a corner, or of a lattice point."""
    if len(own) == 1:
        return Approx(-own[0].size(), own[0].size(), own[0].err, ulps).rounded()
    return approx_plane_ramp(own, ulps) if len(own) == 2 else approx_sum_of_two(own, ulps)


def approx_sine_ramp(own, ulps):
    """g . d for any |g_i| <= 1 whose floats are within SINE.component_error, and at most 1, too."""
    products = []
    for d in own:
        size = d.size()
        products.append(Approx(-size, size, d.err + size * SINE.component_error, ulps).rounded())
    return functools.reduce(Approx.sum, products)


def ramps_and_fractions(lo, hi, gradient, ulps):
    """The ramps of the corners, x varying fastest."""
    offsets = [approx_offsets(a, b, ulps) for a, b in zip(lo, hi)]
    ramp = approx_sine_ramp if gradient is SINE else approx_octahedral_ramp
    ramps = [ramp([offset[o] for offset, o in zip(offsets, corner[::-1])], ulps) for corner in corners(len(lo))]
    return ramps, [fraction for fraction, _ in offsets]


def value_error(lo, hi, gradient, ulps):
    """The largest error of hn_perlin from a cell and a fraction in each box, given by its ends along each axis."""
    value = approx_interpolation(*ramps_and_fractions(lo, hi, gradient, ulps))
    return (value if gradient is SINE else value.scaled(SCALE[gradient][len(lo)])).err


def slope_error(lo, hi, ulps):
    """The error of the derivatives, with octahedral gradients."""
    component = OCTAHEDRAL.component(len(lo))
    derivatives = approx_derivatives(*ramps_and_fractions(lo, hi, OCTAHEDRAL, ulps),
                                     Approx(-component, component, 0.0, ulps))
    return largest_of(derivative.scaled(SCALE[OCTAHEDRAL][len(lo)]).err for derivative in derivatives)


@functools.cache
def error_bound(dims, gradient, ulps=1.0):
    """A proven upper bound of the error from (cell, fraction)."""
    return error_supremum(functools.partial(value_error, gradient=gradient, ulps=ulps), dims)


@functools.cache
def slope_error_bound(dims, ulps=1.0):
    return error_supremum(functools.partial(slope_error, ulps=ulps), dims)
