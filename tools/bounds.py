#!/usr/bin/env python3
"""Proves the numbers the documentation quotes about hn_perlin: its range, its Lipschitz constant, its float error.

    python3 tools/bounds.py           a table
    python3 tools/bounds.py --json    the same as JSON

Everything is derived from docs/contract.md and from the expression given below, and nothing is sampled: a supremum is
bounded by branch and bound over boxes of fractions, and "attained" values are evaluated at a named point. A corner o of
the cell has the weight w and the gradient g_o; u_i is s(f_i). The octahedral gradient has |g_o|_1 = 1. The other is
treated under SINE GRADIENT.

RANGE. For a fixed f the value is scale * sum_o w g_o.(f - o), linear in each gradient, and the largest |g.d| is
max_i |d_i| (the support function of the octahedron): the supremum is scale * sup_f sum_o w max_i |f_i - o_i|. That sum
is unchanged by f_i -> 1 - f_i and by permuting axes, so let f_1 <= ... <= f_n <= 1/2. Then the max is 1 - f_k for the
first axis k with o_k = 1 (any other candidate is 1 - f_j with f_j >= f_k, or f_j <= 1/2), and f_n at o = 0. It nests:

    S(f_1, .., f_n) = u_1 (1 - f_1) + (1 - u_1) S(f_2, .., f_n),    S(f_n) = u_n (1 - f_n) + (1 - u_n) f_n <= 1/2

(the last increases on [0, 1/2]). As 1 - u >= 0, the supremum is M_n, where M_1 = 1/2 and M_k is, with M = M_(k-1), the
largest M + s(t) (1 - t - M): maxima in one variable. The maximizers come out sorted, so M_n is attained over all
|g|_1 = 1. The gradients of the contract are multiples of 2^-16 and never quite a vertex of the octahedron; the tool
shows a value that they do reach, in rational arithmetic.

LIPSCHITZ. The noise is continuously differentiable, so |noise(p) - noise(q)| <= L max_i |p_i - q_i|, where L is the
largest L1 norm of its gradient: of sum_j sigma_j d/df_j, over the signs sigma. Reflecting axes makes all signs +1. With
D = sum_j d/df_j and the support function again,

    L = scale * sup_f sum_o max_i |w + (D w) (f_i - o_i)|.

For any one choice of the gradients that sum is smooth, its second derivative along an axis at most K (slope_curvature),
so within a box it exceeds its values at the box's vertices by at most K/8 sum_j h_j^2, h the sides. The bound is
proven, and tight to about 1e-5 over all |g|_1 = 1.

FLOAT ERROR. Of this evaluation in 32-bit floats, against the exact value at the exact real fraction:

    cell = floor(p);  f = p - cell;  d = f or f - 1;  ramp = g.x*d.x + g.y*d.y (+ g.z*d.z), from left to right
    s(t) = ((t*t)*t) * ((t - 1)*(t*6 - 9) + 1);  lerp(a, b, t) = a + t*(b - a)
    scale * lerp(lerp(n00, n10, u), lerp(n01, n11, u), v), in 3D one level more

GLSL fixes no rounding mode: an operation returns one of the two floats around its exact result, so it errs by less than
one ulp ("to nearest": half an ulp). Inputs and results below 2^-126 may become 0. Fusing a*b + c only drops a rounding.
NOT covered: a compiler that reassociates, distributes or replaces these operations (fast math, a lerp of another form),
mediump, and octahedral gradients that are not exact. The propagation takes all |g|_1 = 1 at once, independently at each
corner: it is rigorous, not tight. (The usual form of the fade, with t*(t*6 - 15) + 10, is the same polynomial and costs
the same, but cancels from terms near 10 to a result near 1, and triples the bound.)

From a position there is one rounding more: p - floor(p) is exact except for -1/2 < p < 0, where it lies in (1/2, 1],
whose floats are 2^-24 apart. That moves f by at most 2^-24 along each axis and so adds L * 2^-24.

SINE GRADIENT. Its components are independent, |g_i| <= 1, and nothing is scaled. The support function of the cube is
sum_i |d_i|, which takes the place of the maximum in the Lipschitz constant. The range is exact: the supremum over the
gradients is the sum over the axes of

    (1 - u_i) f_i + u_i (1 - f_i) = 1/2 - (1 - 2 f_i) (1 - 2 u_i) / 2 <= 1/2

(the weights of the other axes sum to 1, and u_i <= 1/2 just where f_i <= 1/2), so it is n/2, in the middle of the cell.
The float of a component is within 2^-19 of the exact one, and at most 1; each product of a ramp takes that over times
|d_i|. The computed noise may leave [-n/2, n/2] by its error.

THE SINE itself. In quarter turns the argument is y, and sin(pi/2 y) is evaluated as follows; its sign is exact:

    x = float(q >> 6) * 2^-24;  t = x*x;  s = x*(c1 + t*(c3 + t*(c5 + t*c7)))

q is an integer in [0, 2^30] and within 3 of y * 2^30, the shift drops up to 63 more, and q >> 6, at most 2^24, is a
float: so x is in [0, 1], and |x - y| <= 66 / 2^30. As the sine's slope is at most pi/2, |s - sin(pi/2 y)| is at most
the float error of s at x, plus the polynomial's distance from sin(pi/2 x), plus pi/2 * 66 / 2^30: the first two by
branch and bound over x. s <= 1, since before its last rounding it is at most 1, and no rounding crosses a float.

OCTAVE SUMS. See octave_tolerance.

The bounds themselves are computed in doubles; SAFE inflates each result by far more than its own rounding errors.
"""

import argparse
import functools
import heapq
import itertools
import json
import math
import struct
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

SCALE = {2: 1913 / 1024, 3: 1819 / 1024}
SHIFT_MAX = {2: 19 / 32, 3: 23 / 32}  # the largest component of the shift between octaves


@dataclass(frozen=True, eq=False)
class Gradient:
    """A kind of gradient, and by the number of dimensions what octave_tolerance uses of its noise: the bounds derived
    below, rounded up to 3 digits, the limit to 6."""
    name: str
    support: Callable  # of the |d_i|: the largest |g.d|
    component_error: float
    scale: dict[int, float]
    error: dict[int, float]  # from a position
    lipschitz: dict[int, float]
    limit: dict[int, float]  # of |noise|, exact as well as computed


OCTAHEDRAL = Gradient("octahedral", max, 0.0, SCALE,
                      {2: 3.51e-6, 3: 5.43e-6}, {2: 4.57, 3: 6.18}, {2: 1.0, 3: 1.0})
SINE = Gradient("sine", sum, 2.0**-19, {2: 1.0, 3: 1.0},
                {2: 4.58e-6, 3: 8.20e-6}, {2: 3.76, 3: 6.94}, {2: 1.00001, 3: 1.50001})
GRADIENTS = (OCTAHEDRAL, SINE)

UNIT = 2.0**-23  # the largest relative error of a faithfully rounded operation
TINY = 2.0**-126  # the largest absolute error of flushing a subnormal to 0
SAFE = 1 + 1e-9  # a few hundred double operations err by less than 1e-13 relative

# The largest |s'|, |s''| (at t = (1 - 1/sqrt(3)) / 2) and |s'''| on [0, 1].
FADE_1, FADE_2, FADE_3 = 15 / 8, 10 / math.sqrt(3), 60.0

# Where the values called attained are evaluated: near the maximizers. RANGE_WITNESS is exact in 32-bit floats.
RANGE_WITNESS = {2: (11713438 / 2**25, 0.5), 3: (10965218 / 2**25, 11713438 / 2**25, 0.5)}
SLOPE_WITNESS = {OCTAHEDRAL: {2: (0.6144139, 0.2900403), 3: (0.5, 0.3973426, 0.6026574)},
                 SINE: {2: (0.5, 0.5), 3: (0.5, 0.5, 0.5)}}


def fade(t):
    return t * t * t * (t * (t * 6 - 15) + 10)


def fade_slope(t):
    return 30 * t * t * (1 - t) * (1 - t)


def corners(dims):
    return itertools.product((0, 1), repeat=dims)


def halves(box):
    """The box cut in two across its widest axis."""
    axis = max(range(len(box)), key=lambda i: box[i][1] - box[i][0])
    lo, hi = box[axis]
    middle = (lo + hi) / 2
    return [box[:axis] + (part,) + box[axis + 1:] for part in ((lo, middle), (middle, hi))]


def supremum(bound, box, splits):
    """An upper bound over the box, given one for any sub-box: `splits` times halve the sub-box with the largest."""
    queue = [(-bound(box), box)]
    for _ in range(splits):
        _, worst = heapq.heappop(queue)
        for part in halves(worst):
            heapq.heappush(queue, (-bound(part), part))
    return -queue[0][0]


def smooth_bound(value, curvature, box):
    """Bounds `value` over the box, where value is a maximum of functions with |second derivative along an axis| at most
    `curvature`: multilinear interpolation between the vertices errs by at most curvature h^2 / 8 for each axis."""
    return max(map(value, itertools.product(*box))) + curvature / 8 * sum((hi - lo) ** 2 for lo, hi in box)


# --- Range ------------------------------------------------------------------------------------------------------------

def range_bound(dims, scale):
    """A proven upper bound of |value|: M_1 = 1/2, M_k = max_t M + s(t) (1 - t - M), times the scale."""
    curvature = FADE_2 + 2 * FADE_1  # of s(t) (1 - t - M), as |1 - t - M| <= 1
    top = 0.5
    for _ in range(dims - 1):
        def gain(point, top=top):
            return fade(point[0]) * (1 - point[0] - top)
        top += supremum(functools.partial(smooth_bound, gain, curvature), ((0.0, 0.5),), 400)
    return scale * top * SAFE


def steepest_gradients(dims):
    """The contract's gradients nearest to the vertices of the octahedron: their components are multiples of 2^-16."""
    step = Fraction(1, 65536)
    if dims == 2:  # (a, 1 - |a|), a an odd multiple
        positive = [(1 - step, step), (step, 1 - step)]
    else:  # (a, b, 1 - |a| - |b|), a and b odd multiples
        positive = [(1 - step, step, 0 * step), (step, 1 - step, 0 * step), (step, step, 1 - 2 * step)]
    signs = list(itertools.product((1, -1), repeat=dims))
    return [tuple(s * g for s, g in zip(sign, gradient)) for gradient in positive for sign in signs]


def range_witness(dims):
    """A value that hn_perlin attains, exactly: (value, point, gradient at each corner)."""
    point = RANGE_WITNESS[dims]
    exact = [Fraction(f) for f in point]
    value, chosen = Fraction(0), {}
    for corner in corners(dims):
        offset = [f - o for f, o in zip(exact, corner)]
        weight = math.prod(fade(f) if o else 1 - fade(f) for f, o in zip(exact, corner))
        ramp, gradient = max((sum(g * d for g, d in zip(g, offset)), g) for g in steepest_gradients(dims))
        value += weight * ramp
        chosen[corner] = gradient
    return Fraction(SCALE[dims]) * value, point, chosen


def sine_range(dims):
    """The supremum of |value| over all gradients of the cube, attained in the middle of the cell."""
    return dims / 2


# --- Lipschitz constant -----------------------------------------------------------------------------------------------

@functools.cache
def steepest_slope(point, support):
    """sum_o support |w + (D w) (f_i - o_i)|: the largest slope along (1, .., 1) that gradients give here, unscaled."""
    weights = [((1 - fade(f), -fade_slope(f)), (fade(f), fade_slope(f))) for f in point]
    total = 0.0
    for corner in corners(len(point)):
        weight, slope = 1.0, 0.0
        for factor, factor_slope in (weights[i][o] for i, o in enumerate(corner)):
            weight, slope = weight * factor, slope * factor + weight * factor_slope
        total += support(abs(weight + slope * (f - o)) for f, o in zip(point, corner))
    return total


def slope_curvature(dims, support):
    """Of sum_o (+-) (w + (D w) (f_i - o_i)), any signs and any i at each corner, a bound of the second derivative along
    an axis j: sum_o |d_jj w| + |d_jj D w| + 2 |d_j D w|. In such a sum an axis along which w is not differentiated
    gives the factor 1 (its two weights), another gives twice the largest derivative of s. Where a gradient's support is
    the sum, there is one such term for each i."""
    along = 2 * FADE_2 + 2 * FADE_3 + 2 * 2 * FADE_2
    across = 2 * FADE_2 * 2 * FADE_1 + 2 * (2 * FADE_1) ** 2
    return support((1,) * dims) * (along + (dims - 1) * across)


@functools.cache
def lipschitz_bound(dims, gradient):
    """A proven upper bound of the L1 norm of the noise's gradient."""
    curvature = slope_curvature(dims, gradient.support)
    slope = functools.partial(steepest_slope, support=gradient.support)

    def bound(box):
        if any(left[1] < right[0] for left, right in itertools.pairwise(box)):
            return 0.0  # no point with f_1 >= f_2 >= ..: axes can be permuted, so another box stands for this one
        return smooth_bound(slope, curvature, box)
    return gradient.scale[dims] * supremum(bound, ((0.0, 1.0),) * dims, 6000) * SAFE


def lipschitz_witness(dims, gradient):
    """A slope that is attained, at SLOPE_WITNESS, with gradients at vertices of the octahedron or cube."""
    return gradient.scale[dims] * steepest_slope(SLOPE_WITNESS[gradient][dims], gradient.support)


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


def approx_octahedral_ramp(offsets, ulps):
    """g . d for any |g|_1 = 1. The products err by UNIT * |g_i d_i| each, by UNIT * max |d_i| together; likewise the
    errors of d make at most the largest of them, and every partial sum is at most max |d_i|."""
    size = max(d.size() for d in offsets)
    err = max(d.err for d in offsets)
    ramp = Approx(-size, size, err + ulps * UNIT * (size + err) + len(offsets) * TINY, ulps)
    for _ in offsets[1:]:
        ramp = ramp.rounded()
    return ramp


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


def value_error(box, gradient, ulps):
    """The largest error of hn_perlin from a cell and a fraction in the box."""
    approx_ramp = approx_sine_ramp if gradient is SINE else approx_octahedral_ramp
    offsets = [approx_offsets(lo, hi, ulps) for lo, hi in box]
    values = [approx_ramp([offsets[i][o] for i, o in enumerate(corner[::-1])], ulps) for corner in corners(len(box))]
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


# --- Report -----------------------------------------------------------------------------------------------------------

def derive(dims, gradient):
    """All bounds of one dimension and kind of gradient, as a dictionary."""
    lipschitz = lipschitz_bound(dims, gradient)
    result = {"scale": gradient.scale[dims]}
    if gradient is SINE:
        result["range_at_most"] = sine_range(dims)
    else:
        witness, point, gradients = range_witness(dims)
        result |= {
            "range_at_most": range_bound(dims, SCALE[dims]),
            "range_attained": float(witness),
            "range_attained_at": point,
            "range_attained_with": {str(corner): list(map(float, g)) for corner, g in gradients.items()},
        }
    result |= {
        "lipschitz_at_most": lipschitz,
        "lipschitz_attained": lipschitz_witness(dims, gradient),
        "lipschitz_attained_at": SLOPE_WITNESS[gradient][dims],
    }
    for name, ulps in (("any_rounding", 1.0), ("to_nearest", 0.5)):
        cell_error = error_bound(dims, gradient, ulps)
        result["error_from_cell_" + name] = cell_error
        result["error_from_position_" + name] = position_error(cell_error, lipschitz, ulps)
    return result


def derive_sine():
    """The bounds of the sine itself."""
    return {
        "polynomial_error": sine_truncation_bound(),
        "argument_error": math.pi / 2 * SINE_ARGUMENT_ERROR,
        "error_any_rounding": sine_bound(),
        "error_to_nearest": sine_bound(0.5),
        "error_promised": SINE.component_error,
        "below_1_by_any_rounding": 1 - sine_largest(),
    }


OCTAVE_EXAMPLES = [  # kind, dims, p_max, octaves, lacunarity, gain, exact_positions
    ("fbm", 2, 16.0, 5, 2.0, 0.5, True),
    ("fbm", 2, 16.0, 5, 2.0, 0.5, False),
    ("fbm", 3, 16.0, 5, 2.0, 0.5, False),
    ("fbm", 3, 1024.0, 8, 2.0, 0.5, False),
    ("turbulence", 3, 16.0, 5, 1.9, 0.6, False),
    ("clouds", 2, 16.0, 5, 2.0, 0.5, False),
]


def print_numbers(result):
    for name, value in result.items():
        if isinstance(value, float) and name != "scale":
            print(f"  {name.replace('_', ' '):36} {value:.9g}")


def print_table(results, sine):
    for (kind, dims), result in results.items():
        print(f"hn_perlin {dims}D, {kind} gradient, scale {result['scale'] * 1024:.0f}/1024")
        print_numbers(result)
        if "range_attained_at" in result:
            print(f"  {'range attained at':36} {result['range_attained_at']} with the gradients (times 2^16)")
            for corner, gradient in result["range_attained_with"].items():
                print(f"  {'':36} {corner}: {tuple(round(g * 65536) for g in gradient)}")
        print(f"  {'lipschitz attained at':36} {result['lipschitz_attained_at']}")
    print("the sine of the sine gradient")
    print_numbers(sine)
    print("octave_tolerance(kind, dims, p_max, octaves, lacunarity, gain, exact_positions), octahedral and sine")
    for example in OCTAVE_EXAMPLES:
        tolerances = (octave_tolerance(*example, gradient) for gradient in GRADIENTS)
        print(f"  {str(example):52} " + " ".join(f"{tolerance:<9.3g}" for tolerance in tolerances).rstrip())


def main():
    parser = argparse.ArgumentParser(description="Proves the range, Lipschitz constant and float error of hn_perlin.")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    as_json = parser.parse_args().json
    results = {(gradient.name, dims): derive(dims, gradient) for gradient in GRADIENTS for dims in SCALE}
    sine = derive_sine()
    if as_json:
        by_gradient = {g.name: {dims: results[g.name, dims] for dims in SCALE} for g in GRADIENTS}
        print(json.dumps({**by_gradient, "sine_itself": sine}, indent=2))
    else:
        print_table(results, sine)


if __name__ == "__main__":
    main()
