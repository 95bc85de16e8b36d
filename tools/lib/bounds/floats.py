"""The error of the float arithmetic (HN_FAST and HN_PRECISE), proven: of hn_perlin, its sine, and the octave sums.

FLOAT ERROR. Of this evaluation in 32-bit floats, against the exact value at the exact real fraction:

    cell = floor(p);  f = p - cell;  d = f or f - 1;  ramp = g.x*d.x + g.y*d.y (+ g.z*d.z), from left to right
    octahedral in 3D:  a = 0.5*(f.x + f.y);  b = 0.5*(f.x - f.y);  ramp = p*u + q*v + m*d.z, where for the corners
        (0, 0), (1, 0), (0, 1), (1, 1) of x and y  u = a, a - 0.5, a - 0.5, a - 1  and  v = b, b - 0.5, b + 0.5, b
    s(t) = ((t*t)*t) * ((t - 1)*(t*6 - 9) + 1);  lerp(a, b, t) = a + t*(b - a)
    scale * lerp(lerp(n00, n10, u), lerp(n01, n11, u), v), in 3D one level more

GLSL fixes no rounding mode: an operation returns one of the two floats around its exact result, so it errs by less than
one ulp ("to nearest": half an ulp). Inputs and results below 2^-126 may become 0. Fusing a*b + c only drops a rounding.
NOT covered: a compiler that reassociates, distributes or replaces these operations (fast math, a lerp of another form),
mediump, and octahedral gradients that are not exact. The propagation takes all |g|_1 = 1 at once, independently at each
corner: it is rigorous, not tight. (The usual form of the fade, with t*(t*6 - 15) + 10, is the same polynomial and costs
the same, but cancels from terms near 10 to a result near 1, and triples the bound.)

In 3D |u| + |v| = max(|d_1|, |d_2|) (before rounding) and P = max(|p|, |q|) = 1 - |m|, so |p u| + |q v| + |m d_3| is at
most max_i |d_i|, as g.d is, and errors of u, v and d_3 come to at most P (U + V) + (1 - P) D_3 <= max(U + V, D_3).

From a position there is one rounding more: p - floor(p) is exact except for -1/2 < p < 0, where it lies in (1/2, 1],
whose floats are 2^-24 apart. That moves f by at most 2^-24 along each axis and so adds L * 2^-24.

HN_PRECISE rounds to nearest, and takes a coordinate below 2^-32 as 0, which moves a value by at most L * 2^-32: far
less than rounding to nearest saves, so the bounds hold for it, too.

SINE GRADIENT. The float of a component is within 2^-19 of the exact one, and at most 1; each product of a ramp takes
that over times |d_i|. The computed noise may leave [-n/2, n/2] by its error.

THE SINE itself. In quarter turns the argument is y, and sin(pi/2 y) is evaluated as follows; its sign is exact:

    x = float(q >> 6) * 2^-24;  t = x*x;  s = x*(c1 + t*(c3 + t*(c5 + t*c7)))

q is an integer in [0, 2^30] and within 3 of y * 2^30, the shift drops up to 63 more, and q >> 6, at most 2^24, is a
float: so x is in [0, 1], and |x - y| <= 66 / 2^30. As the sine's slope is at most pi/2, |s - sin(pi/2 y)| is at most
the float error of s at x, plus the polynomial's distance from sin(pi/2 x), plus pi/2 * 66 / 2^30: the first two by
branch and bound over x. s <= 1, since before its last rounding it is at most 1, and no rounding crosses a float.

OCTAVE SUMS. See octave_tolerance.
"""

import functools
import math
import struct

from bounds.perlin import OCTAHEDRAL, SAFE, SHIFT_MAX, SINE, corners, fade, smooth_bound, supremum

UNIT = 2.0**-23  # the largest relative error of a faithfully rounded operation
TINY = 2.0**-126  # the largest absolute error of flushing a subnormal to 0


# --- Float error ------------------------------------------------------------------------------------------------------

class Approx:
    """A quantity computed in floats: its exact value is in [lo, hi], the computed one differs by at most err.
    An operation rounds with an error below `ulps` ulp."""

    def __init__(self, lo, hi, err, ulps):
        self.lo, self.hi, self.err, self.ulps = lo, hi, err, ulps

    def size(self):
        """Of the exact value."""
        return max(abs(self.lo), abs(self.hi))

    def rounded(self):
        """After one rounding: the ulp of the largest magnitude the computed value can have."""
        return Approx(self.lo, self.hi, self.err + rounding(self.size() + self.err, self.ulps), self.ulps)

    def clipped(self, lo, hi):
        """With a range known from elsewhere."""
        return Approx(max(self.lo, lo), min(self.hi, hi), self.err, self.ulps)

    def plus(self, constant):
        return Approx(self.lo + constant, self.hi + constant, self.err, self.ulps).rounded()

    def scaled(self, constant):
        """Times a positive constant."""
        return Approx(self.lo * constant, self.hi * constant, self.err * constant, self.ulps).rounded()

    def sum(self, other):
        return Approx(self.lo + other.lo, self.hi + other.hi, self.err + other.err, self.ulps).rounded()

    def times(self, other):
        ends = [a * b for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        err = self.size() * other.err + other.size() * self.err + self.err * other.err
        return Approx(min(ends), max(ends), err, self.ulps).rounded()


def rounding(magnitude, ulps):
    """The largest error of rounding a result of at most this magnitude; the ulp is 2^(e - 23) in [2^e, 2^(e + 1))."""
    exponent = math.frexp(magnitude * SAFE)[1] - 1
    return ulps * math.ldexp(1.0, exponent - 23) + TINY


def approx_fade(t):
    d = approx_offsets(t.lo, t.hi, t.ulps)[1]
    inner = d.times(t.scaled(6.0).plus(-9.0)).plus(1.0)
    return t.times(t).times(t).times(inner).clipped(fade(t.lo), fade(t.hi))  # s increases


def between(t, a, b):
    """The largest (1 - t) a + t b over the range of t, in which it is linear."""
    return max((1 - t.lo) * a + t.lo * b, (1 - t.hi) * a + t.hi * b)


def approx_lerp(a, b, t):
    """a + t (b - a). Before its three roundings its error is (1 - t) A + t B + T (b' - a'), with the errors A, B, T of
    a, b, t and the computed b' - a': less than operation by operation, which would count the error of a twice. The
    exact value is between a and b, whose ranges are centred on 0."""
    difference = a.size() + b.size() + a.err + b.err
    difference_rounding = rounding(difference, t.ulps)
    product = (t.hi + t.err) * (difference + difference_rounding)
    err = between(t, a.err, b.err) + t.err * difference
    err += (t.hi + t.err) * difference_rounding + rounding(product, t.ulps)
    size = between(t, a.size(), b.size())
    return Approx(-size, size, err, t.ulps).rounded()


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


def approx_offsets(lo, hi, ulps):
    """f and f - 1, which is exact for f >= 1/2 (Sterbenz), else in [-1, -1/2], whose floats are 2^-24 apart."""
    minus_one = ulps * 2.0**-24 if lo < 0.5 else 0.0
    return Approx(lo, hi, TINY, ulps), Approx(lo - 1, hi - 1, minus_one + TINY, ulps)


def approx_ramp(offsets, corner, gradient, ulps):
    own = [offset[o] for offset, o in zip(offsets, corner)]
    if gradient is SINE:
        return approx_sine_ramp(own, ulps)
    return approx_plane_ramp(own, ulps) if len(own) == 2 else approx_space_ramp(offsets, corner, ulps)


def value_error(box, gradient, ulps):
    """The largest error of hn_perlin from a cell and a fraction in the box."""
    offsets = [approx_offsets(lo, hi, ulps) for lo, hi in box]
    values = [approx_ramp(offsets, corner[::-1], gradient, ulps) for corner in corners(len(box))]
    for fraction, _ in offsets:  # x varies fastest in `values`, so each level interpolates neighbours
        weight = approx_fade(fraction)
        values = [approx_lerp(a, b, weight) for a, b in zip(values[::2], values[1::2])]
    return (values[0] if gradient is SINE else values[0].scaled(gradient.scale[len(box)])).err


@functools.cache
def error_bound(dims, gradient, ulps=1.0):
    """A proven upper bound of the error from (cell, fraction)."""
    bound = functools.partial(value_error, gradient=gradient, ulps=ulps)
    return supremum(bound, ((0.0, 1.0),) * dims, 3000) * SAFE


def position_error(cell_error, lipschitz, ulps=1.0):
    """The same from a position: the fraction is up to 2^-24 (to nearest: half of it) off."""
    return cell_error + lipschitz * ulps * 2.0**-24


# --- The sine itself ------------------------------------------------------------------------------------------------

def to_float(x):
    """The 32-bit float nearest to x."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


SINE_DECIMALS = (1.57079090, -0.64589171, 0.07943160, -0.00433127)  # of x, x^3, x^5, x^7
SINE_COEFFICIENTS = tuple(map(to_float, SINE_DECIMALS))
SINE_ARGUMENT_ERROR = (3 + 2**6 - 1) / 2**30  # of x in quarter turns: 3 units of the reduction, 63 of the shift
DOUBLE = 2.0**-48  # more than the rounding errors of the few double operations below, on numbers up to 2


def sine_polynomial(x):
    c1, c3, c5, c7 = SINE_COEFFICIENTS
    return x * (c1 + x * x * (c3 + x * x * (c5 + x * x * c7)))


def sine_truncation(point):
    """What the polynomial, in exact arithmetic, is off by."""
    return abs(sine_polynomial(point[0]) - math.sin(math.pi / 2 * point[0]))


def sine_curvature():
    """Of the polynomial, and of its difference from the sine: bounds of the second derivative on [0, 1]."""
    polynomial = sum(k * (k - 1) * abs(c) for k, c in zip((1, 3, 5, 7), SINE_COEFFICIENTS))
    return polynomial, polynomial + (math.pi / 2) ** 2


def approx_sine_factors(box, ulps):
    """x, and the bracket that it is multiplied with last."""
    x = Approx(*box[0], 0.0, ulps)
    t = x.times(x).clipped(box[0][0] ** 2, box[0][1] ** 2)
    c1, c3, c5, c7 = SINE_COEFFICIENTS
    inner = t.times(Approx(c7, c7, 0.0, ulps)).plus(c5)
    return x, t.times(t.times(inner).plus(c3)).plus(c1)


def sine_bound(ulps=1.0):
    """A proven upper bound of |s - sin| for the sine of the gradient, at the exact argument."""
    curvature = sine_curvature()[1]

    def bound(box):
        x, bracket = approx_sine_factors(box, ulps)
        return x.times(bracket).err + smooth_bound(sine_truncation, curvature, box)
    return supremum(bound, ((0.0, 1.0),), 4000) * SAFE + math.pi / 2 * SINE_ARGUMENT_ERROR + DOUBLE


def sine_truncation_bound():
    """A proven upper bound of what the polynomial alone is off by."""
    bound = functools.partial(smooth_bound, sine_truncation, sine_curvature()[1])
    return supremum(bound, ((0.0, 1.0),), 4000) * SAFE + DOUBLE


def sine_largest(ulps=1.0):
    """A proven upper bound of s before its last rounding. If that is at most 1, which is a float, then so is s."""
    curvature = sine_curvature()[0]

    def bound(box):
        x, bracket = approx_sine_factors(box, ulps)
        return smooth_bound(lambda point: sine_polynomial(point[0]), curvature, box) + x.hi * bracket.err
    return supremum(bound, ((0.0, 1.0),), 4000) + DOUBLE


# --- Octave sums ------------------------------------------------------------------------------------------------------

def octave_tolerance(kind, dims, p_max, octaves, lacunarity, gain, exact_positions, gradient=OCTAHEDRAL):
    """The largest error of hn_fbm, hn_turbulence or hn_clouds (kind "fbm", "turbulence", "clouds") over hn_perlin, for
    |p_i| <= p_max, against the exact sums of docs/contract.md at the same floats p, lacunarity and gain >= 0, evaluated

        sum = sum + amp*noise(q);  total = 1 + gain*total;  q = q*lacunarity + shift;  amp = amp*gain
        value = sum / total
        t = clamp(2*fbm + 0.25, 0, 1);  clouds = t*t*(3 - 2*t)

    Each *_err bounds the error of its float. The noise is at most the limit, exact as well as computed, so |sum| is at
    most limit * total; a division errs by up to 2.5 ulp. exact_positions is the caller's promise that every q is
    computed without rounding (few bits in p and lacunarity). Infinite where the total leaves 2^126: GLSL bounds the
    error of a division only for divisors below."""
    if kind not in ("fbm", "turbulence", "clouds"):
        raise ValueError(kind)
    limit, position, position_err = gradient.limit[dims], p_max, 0.0
    amp, amp_err, total, total_err, sum_err, error = 1.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for _ in range(octaves):
        noise_err = min(gradient.lipschitz[dims] * position_err + gradient.error[dims], 2 * limit)
        sum_err += (amp + amp_err) * (noise_err + UNIT * limit) + limit * amp_err + TINY
        total, total_err = 1 + gain * total, gain * (total_err + UNIT * (total + total_err)) + TINY
        sum_err += UNIT * (limit * total + sum_err)
        total_err += UNIT * (total + total_err)
        product_err = abs(lacunarity) * (position_err + UNIT * (position + position_err) + TINY) + TINY
        position = abs(lacunarity) * position + SHIFT_MAX[dims]
        position_err = 0.0 if exact_positions else product_err + UNIT * (position + product_err)
        amp, amp_err = amp * gain, gain * (amp_err + UNIT * (amp + amp_err)) + TINY
    if total > 2.0**126:
        return math.inf
    if octaves > 0:
        error = (sum_err + limit * total_err) / (total - total_err)
        error += 2.5 * UNIT * (limit + error) + TINY
    if kind == "clouds":  # the clamp leaves no more than 1, whatever the limit; the smoothstep has slopes up to 3/2 and
        # three roundings, relative to a value of at most 1
        return 1.5 * (2 * error + UNIT) + 3.001 * UNIT
    return error  # abs is exact and brings no two values further apart
