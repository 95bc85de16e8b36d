"""The error of hn_perlin in float arithmetic, against the exact value at the exact real fraction.

The ramps of the corners are evaluated as

    ramp = g.x*d.x + g.y*d.y (+ g.z*d.z), from left to right
    octahedral in 3D:  a = 0.5*(f.x + f.y);  b = 0.5*(f.x - f.y);  ramp = p*u + q*v + m*d.z, where for the corners
        (0, 0), (1, 0), (0, 1), (1, 1) of x and y  u = a, a - 0.5, a - 0.5, a - 1  and  v = b, b - 0.5, b + 0.5, b

and the noise is the scale times their interpolation (floats.py of the folder above). NOT covered: octahedral gradients
that are not exact. The propagation takes all |g|_1 = 1 at once, independently at each corner: it is rigorous, not tight.

In 3D |u| + |v| = max(|d_1|, |d_2|) (before rounding) and P = max(|p|, |q|) = 1 - |m|, so |p u| + |q v| + |m d_3| is at
most max_i |d_i|, as g.d is, and errors of u, v and d_3 come to at most P (U + V) + (1 - P) D_3 <= max(U + V, D_3).

SINE GRADIENT. The float of a component is within 2^-19 of the exact one, and at most 1; each product of a ramp takes
that over times |d_i|. The computed noise may leave [-n/2, n/2] by its error.
"""

import functools

from bounds.boxes import SAFE, corners, supremum
from bounds.floats import TINY, UNIT, Approx, approx_interpolation, approx_offsets, rounding
from bounds.gradients import SINE
from bounds.noises.perlin.exact import SCALE


def approx_octahedral_ramp(size, err, terms, ulps):
    """g . d for any |g|_1 = 1, where |g . d| is at most `size` and the errors of what g multiplies come to `err`. The
    products err by UNIT * |g_i d_i| each, by UNIT * size together, and every partial sum is at most the size."""
    ramp = Approx(-size, size, err + ulps * UNIT * (size + err) + terms * TINY, ulps)
    for _ in range(terms - 1):
        ramp = ramp.rounded()
    return ramp


def approx_plane_ramp(offsets, ulps):
    return approx_octahedral_ramp(max(d.size() for d in offsets), max(d.err for d in offsets), 2, ulps)


def diagonal_sum(x, y, ulps):
    """a = 0.5*(f.x + f.y): halving is exact."""
    total = Approx(x.lo, x.hi, TINY, ulps).sum(Approx(y.lo, y.hi, TINY, ulps))
    return Approx(total.lo / 2, total.hi / 2, total.err / 2 + TINY, ulps)


def diagonal_difference(x, y, ulps):
    """b = 0.5*(f.x - f.y), whose difference is exact where one is at most twice the other (Sterbenz)."""
    lo, hi = x.lo - y.hi, x.hi - y.lo
    exact = max(x.hi, y.hi) <= 2 * min(x.lo, y.lo)
    err = 2 * TINY + (0.0 if exact else rounding(max(-lo, hi), ulps))
    return Approx(lo / 2, hi / 2, err / 2 + TINY, ulps)


def shifted(value, constant):
    """value + constant for |constant| = 0.5 or 1 and |value| <= 1: exact where the value, as computed, has the other
    sign and half the constant's size or more (Sterbenz; 1/4 and 1/2 are floats, so rounding does not cross them)."""
    nearest_0 = value.lo if constant < 0 else -value.hi
    moved = Approx(value.lo + constant, value.hi + constant, value.err, value.ulps)
    return moved if nearest_0 >= abs(constant) / 2 or constant == 0 else moved.rounded()


def approx_space_ramp(offsets, corner, ulps):
    """p*u + q*v + m*d.z; `offsets` are those of the corner, from which the size, and those of f."""
    (x, _), (y, _), z = offsets[0], offsets[1], offsets[2][corner[2]]
    u = shifted(diagonal_sum(x, y, ulps), -0.5 * (corner[0] + corner[1]))
    v = shifted(diagonal_difference(x, y, ulps), 0.5 * (corner[1] - corner[0]))
    size = max(offset[o].size() for offset, o in zip(offsets, corner))
    return approx_octahedral_ramp(size, max(u.err + v.err, z.err), 3, ulps)


def approx_sine_ramp(offsets, ulps):
    """g . d for any |g_i| <= 1 of which the float is within SINE.component_error, and at most 1, too."""
    products = []
    for d in offsets:
        size = d.size()
        products.append(Approx(-size, size, d.err + size * SINE.component_error, ulps).rounded())
    return functools.reduce(Approx.sum, products)


def approx_ramp(offsets, corner, gradient, ulps):
    own = [offset[o] for offset, o in zip(offsets, corner)]
    if gradient is SINE:
        return approx_sine_ramp(own, ulps)
    return approx_plane_ramp(own, ulps) if len(own) == 2 else approx_space_ramp(offsets, corner, ulps)


def value_error(box, gradient, ulps):
    """The largest error of hn_perlin from a cell and a fraction in the box."""
    offsets = [approx_offsets(lo, hi, ulps) for lo, hi in box]
    values = [approx_ramp(offsets, corner[::-1], gradient, ulps) for corner in corners(len(box))]
    value = approx_interpolation(values, [fraction for fraction, _ in offsets])
    return (value if gradient is SINE else value.scaled(SCALE[gradient][len(box)])).err


@functools.cache
def error_bound(dims, gradient, ulps=1.0):
    """A proven upper bound of the error from (cell, fraction)."""
    bound = functools.partial(value_error, gradient=gradient, ulps=ulps)
    return supremum(bound, ((0.0, 1.0),) * dims, 3000) * SAFE
