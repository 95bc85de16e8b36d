"""The error of the fixed arithmetic (HN_FIXED, docs/contract.md, section 8) against the exact values of sections 5 to
7, proven; that it stays in range, and that what must not wrap does not.

What depends on a single fraction is computed here for each of the 2^20 + 1 fractions F, in the integers of the
contract: the fade t of F, and how much an interpolation by t rounds. The rest is proven over boxes of fractions.

HN_PERLIN. The fixed value differs from the exact one by five things, which are bounded together, for each box:

    CUT      a coordinate is cut to a multiple of 2^-20, by less than that. The noise at the cut position is off by at
             most L(f) * 2^-20, L(f) being the largest slope at a fraction (LIPSCHITZ in perlin.py, here for all
             signs sigma; the way from p to the cut p is in the same box, or beyond the edge of the cell, in the box
             opposite, where L is the same by symmetry).
    FADE     t is off by e(F). At the cut position the ramps are exact, so for given gradients this moves the value by
             sum_o (w_o(t) - w_o(s)) g_o.d_o, and by at most sum_o |w_o(t) - w_o(s)| h(d_o), h the support function.
             Along e_j that is convex (a maximum of linear functions), so it is largest where each e_j is at an end of
             its range in the box. It is far less than the sum over the axes of the largest |dn/dt_j| |e_j|: in the
             middle of a square those two are 1 |e_j| each, and never together.
    LERP     a + d t / 2^18 is rounded down, by less than 511/512 (t >> 9) + (t & 511) (from d & 511 and d & (2^18 - 1)
             in turn; where t < 0 the first is rounding up, by -511/512 (t >> 9)). The next interpolation takes the
             errors of a and b with the weights 1 - t and t, whose magnitudes make 1 plus what t leaves [0, 1] by,
             twice; so a level adds at most its own rounding.
    RAMP     of the sine gradient only: each axis rounds down by less than 1 unit of 2^-28; and g is off, see below.
    SCALE    (((n + 256) >> 9) * S + 256) >> 9 is off by at most 256 S / 2^18 + 1/2 units of 2^-21 (n >> 7 by less than
             1).

In a box the first two are smooth up to the choice of gradients, and bounded as in perlin.py by their values at
the vertices and their second derivatives.

RANGE. The octahedral gradients of the library leave 1 - library_range of perlin.py, more than FADE, LERP and
SCALE together (CUT moves a position, not a value out of its range): |hn_perlin| <= 1. Octave sums round by less than 2
units of 2^-21 an octave (SUMS), 64 in 32 octaves; of the first, whose weight is 2^18, the same room is left.
With the sine gradient, t <= 1/2 for f < 1/2 and t >= 1/2 for f > 1/2 suffice for n/2, as there, up to LERP, RAMP and
SCALE; of components that exceed 1, n/2 times that is added.

SINE. q is within 3 of the exact argument in units of 2^-30 quarter turns, and x is q * 2^-14, rounded: for each of the 2^16 x
the sine lies between its values at the ends of x's range of q, and the integers are evaluated.

SUMS. See fixed_octave_tolerance.
"""

import functools
import itertools
import math

import numpy as np

from bounds.perlin import FADE_1, FADE_2, OCTAHEDRAL, SAFE, SCALE, SHIFT_MAX, SINE, fade, slope_curvature

ONE = 2**20  # I of the contract: the unit of fractions
FADE_ONE = 2**18  # the unit of t
UNIT = 2.0**-21  # of a result
RAMP_ONE = {OCTAHEDRAL: 2**29, SINE: 2**28}
BOXES = {2: 512, 3: 128}  # along an axis
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


def by_box(values, boxes, reduce):
    """min or max (`reduce`) of the values over the fractions of each of the boxes along an axis, ends included."""
    inner = reduce.reduce(values[:-1].reshape(boxes, -1), axis=1)
    return reduce(inner, values[ONE // boxes::ONE // boxes])


# --- The noise --------------------------------------------------------------------------------------------------------

def grids(values, dims):
    """The values along each axis, to be combined by broadcasting."""
    return np.meshgrid(*[values] * dims, indexing="ij", sparse=True)


def vertices_max(values):
    """For each box the largest of the values at its vertices."""
    for axis in range(values.ndim):
        count = values.shape[axis] - 1
        values = np.maximum(values.take(range(count), axis), values.take(range(1, count + 1), axis))
    return values


def support(gradient, offsets):
    return functools.reduce(np.maximum if gradient is OCTAHEDRAL else np.add, map(np.abs, offsets))


@functools.cache
def slopes(dims, gradient):
    """For each box, a bound of L(f), unscaled."""
    f = grids(np.linspace(0, 1, BOXES[dims] + 1), dims)
    s, ds = [fade(x) for x in f], [30 * (x * (1 - x)) ** 2 for x in f]
    largest = np.zeros([BOXES[dims] + 1] * dims)
    for signs in itertools.product((1, -1), repeat=dims - 1):
        signs, total = (1, *signs), 0.0
        for corner in itertools.product((0, 1), repeat=dims):
            weight, slope = 1.0, 0.0
            for i, o in enumerate(corner):
                factor, factor_slope = (s[i], signs[i] * ds[i]) if o else (1 - s[i], -signs[i] * ds[i])
                weight, slope = weight * factor, slope * factor + weight * factor_slope
            total = total + support(gradient, [sign * weight + slope * (x - o)
                                               for sign, x, o in zip(signs, f, corner)])
        largest = np.maximum(largest, total)
    return vertices_max(largest) + slope_curvature(dims, gradient.support) / 8 * dims / BOXES[dims] ** 2


def weight_change(corner, fade_values, errors):
    """|w_o(s + e) - w_o(s)|"""
    before, after = 1.0, 1.0
    for o, s, e in zip(corner, fade_values, errors):
        before, after = before * (s if o else 1 - s), after * (s + e if o else 1 - s - e)
    return np.abs(after - before)


@functools.cache
def fade_effect(dims, gradient):
    """For each box, a bound of FADE, unscaled. Of sum_o +-(w_o(s + e) - w_o(s)) (f_i - o_i), for any signs and any i at
    each corner, the second derivative along an axis j is at most (2 FADE_2 + 4 FADE_1) times the product over the other
    axes of 1 + 2 |e_i|, less 1: the change of the weights is a sum over the non-empty sets of axes whose factor is
    +-e_i instead of a weight, j not among them."""
    boxes = BOXES[dims]
    ends = [grids(by_box(fade_errors(), boxes, reduce), dims) for reduce in (np.minimum, np.maximum)]
    largest = np.zeros([boxes] * dims)
    for vertex in itertools.product((0, 1), repeat=dims):
        f = grids(np.arange(boxes) / boxes, dims)
        f = [x + v / boxes for x, v in zip(f, vertex)]
        s = [fade(x) for x in f]
        supports = {corner: support(gradient, [x - o for x, o in zip(f, corner)])
                    for corner in itertools.product((0, 1), repeat=dims)}
        for pick in itertools.product((0, 1), repeat=dims):
            errors = [ends[end][axis] for axis, end in enumerate(pick)]
            total = sum(weight_change(corner, s, errors) * h for corner, h in supports.items())
            largest = np.maximum(largest, total)
    error = np.abs(fade_errors()).max()
    curvature = (2 * FADE_2 + 4 * FADE_1) * ((1 + 2 * error) ** (dims - 1) - 1) * gradient.support((1,) * dims)
    # DOUBLE * 2^n corners: what the rounding of the exact fade may add.
    return largest + curvature / 8 * dims / boxes**2 + DOUBLE * 2**dims * dims


def rounding_effect(dims, gradient):
    """For each box, a bound of LERP and RAMP, unscaled."""
    ramps = dims if gradient is SINE else 0
    lerps = sum(grids(by_box(lerp_roundings(), BOXES[dims], np.maximum), dims))
    return (lerps + ramps) * (1 + 2 * overshoot()) ** dims / RAMP_ONE[gradient]


def scaling_error(dims, gradient):
    return (1 if gradient is SINE else 256 * SCALE[dims] * 1024 / 2**18 + 1 / 2) * UNIT


@functools.cache
def fixed_error(dims, gradient):
    """A proven upper bound of the error of hn_perlin in fixed arithmetic, from a position or a cell and a fraction."""
    boxes = slopes(dims, gradient) / ONE + fade_effect(dims, gradient) + rounding_effect(dims, gradient)
    total = gradient.scale[dims] * boxes.max() + scaling_error(dims, gradient)
    if gradient is SINE:  # sum_o w_o(s) sum_i |d_i| <= n/2; FADE moved the fixed gradients, which may exceed 1
        total += fixed_sine_error() * dims / 2 + fade_effect(dims, gradient).max() * (fixed_sine_largest() - 1)
    return total * SAFE


def error_parts(dims, gradient):
    """The largest of each part, for a reader: they are not attained together."""
    scale = gradient.scale[dims]
    return {"cut": scale * slopes(dims, gradient).max() / ONE, "fade": scale * fade_effect(dims, gradient).max(),
            "lerp": scale * rounding_effect(dims, gradient).max(), "scale": scaling_error(dims, gradient),
            "gradient": fixed_sine_error() * dims / 2 if gradient is SINE else 0.0}


@functools.cache
def range_loss(dims, gradient):
    """How far FADE, LERP, RAMP and SCALE can take a value beyond the largest exact one."""
    boxes = rounding_effect(dims, gradient)
    if gradient is OCTAHEDRAL:
        boxes = boxes + fade_effect(dims, gradient)
    elif not fade_keeps_to_its_side():
        raise ValueError("the fade is on the other side of 1/2 than the fraction")
    loss = gradient.scale[dims] * boxes.max() + scaling_error(dims, gradient)
    if gradient is SINE:  # components that exceed 1, weights of other axes that leave [0, 1]
        loss += dims / 2 * (fixed_sine_largest() * (1 + 2 * overshoot()) ** dims - 1)
    return loss * SAFE


# --- Overflow ---------------------------------------------------------------------------------------------------------

def largest_intermediates(dims, gradient):
    """By name, bounds of the magnitudes that must stay below 2^31. (The fade and the sine are checked as evaluated.)
    A ramp is at most its one: 2^29 for the octahedron, as |a| |D| + |m| |D'| <= 512 * 2^20, and of the partial sums in
    space |p (Dx + Dy) + q (Dx - Dy)| <= P * 2 max |D| <= 255 * 2^21; n * 2^28 and a rounding for the cube. So are
    interpolated values, with LERP. The first product is at most (|d| / 2^9 + 1) (t >> 9), the second half of the
    interpolation below (|d| / 2^18 + 1) * 511; their sum may be taken of both magnitudes."""
    largest = RAMP_ONE[gradient] if gradient is OCTAHEDRAL else dims * (RAMP_ONE[gradient] * fixed_sine_largest() + 1)
    value = largest + dims * lerp_roundings().max() + 2 * largest * overshoot() * dims
    difference = 2 * value
    t = int(np.abs(fades()).max())
    lerp = (difference / 2**9 + 1) * ((t >> 9) + 1) + (difference / 2**18 + 1) * 511
    scaled = (value / 2**9 + 1) * 1024 * gradient.scale[dims] + 256 if gradient is OCTAHEDRAL else value
    # Of an octave sum: v * (A >> 9) + (v >> 9) * (A & 511), A <= 2^18. Where A & 511 is not 0, A >> 9 is at most 511.
    noise = gradient.fixed_limit[dims] * 2**21
    octave = noise * 2**9 + (noise / 2**9 + 1) * 511
    return {"ramp": largest, "difference": difference, "lerp": lerp, "scaled": scaled, "octave": octave,
            "sum of 32 octaves": 32 * (noise + 2)}


# --- The sine ---------------------------------------------------------------------------------------------------------

def fixed_sine(x):
    """g of the contract for x in [0, 2^16), in units of 2^-16."""
    u = word(x * x) >> 16
    inner = 5208 - (word(u * 288) >> 16)
    inner = 42328 - (word(u * word(inner)) >> 16)
    y = 102943 - (word(u * word(inner)) >> 16)
    return word(x * (word(y) >> 1) + 2**14) >> 15


SINE_REDUCTION = 3  # how far q is off, in units of 2^-30 quarter turns: as in floats


@functools.cache
def fixed_sines():
    """g of every x."""
    return fixed_sine(np.arange(2**16, dtype=np.int64))


def fixed_sine_largest():
    """1, or what a component exceeds it to."""
    return max(1.0, fixed_sines().max() / 2**16)


@functools.cache
def fixed_sine_error():
    """A proven upper bound of |S - sin|, from all x."""
    least = np.arange(2**16) * 2**14 - 2**13 - SINE_REDUCTION  # below 0 for x = 0: at worst sin is the other way round
    most = least + 2**14 - 1 + 2 * SINE_REDUCTION
    most[-1] = 2**30  # where the sine is largest
    errors = [np.abs(fixed_sines() / 2**16 - np.sin(np.pi / 2 * q / 2**30)).max() for q in (least, most)]
    return float(max(errors)) * SAFE + DOUBLE


# --- Octave sums ------------------------------------------------------------------------------------------------------

def fixed_weights(octaves, gain):
    """A_i of the contract, in units of 2^-18."""
    g, weights = math.trunc(gain * FADE_ONE), [FADE_ONE]
    while len(weights) < octaves:
        a = weights[-1]
        weights.append(((a >> 9) * g + (((a & 511) * g) >> 9)) >> 9)
    return weights[:max(octaves, 0)]


@functools.cache
def cloud_error():
    """The largest |density - t t (3 - 2 t)| of all t."""
    t = np.arange(2**21 + 1, dtype=np.int64)
    c = (t - 2**20) >> 5
    density = 2**20 + (signed(c * (word(0xC0000000 - word(c * c)) >> 16)) >> 10)
    checked(density, 0, 2**21 + 1)
    exact = (t / 2**21) ** 2 * (3 - 2 * (t / 2**21))
    return np.abs(density * UNIT - exact).max() * SAFE + DOUBLE


def fixed_octave_tolerance(kind, dims, p_max, octaves, lacunarity, gain, exact_positions, gradient=OCTAHEDRAL):
    """As octave_tolerance in floats.py, of the fixed arithmetic; for lacunarity in [0, 255], gain in [0, 1] and
    at most 32 octaves, which is what it does not cut.

    Positions: p is cut to 2^-32 at first, the lacunarity to l, a multiple of 2^-23, and every product is rounded down
    to 2^-32. A noise is off by L times its position's error and by fixed_error (the cut to 2^-20 is in that). The
    weights are compared with the exact ones as they are: a change of weights by c_i, of sums 1 both, moves the mean by
    at most limit * sum |c_i|. A product v A / 2^18 is rounded down by less than 2 units of 2^-21, and so is their sum
    by less than 2 an octave; the division by less than 1. exact_positions is the caller's promise that p are multiples
    of 2^-32 (floats from 2^-9 on are) and that each product is, too (a whole lacunarity)."""
    if kind not in ("fbm", "turbulence", "clouds"):
        raise ValueError(kind)
    if not (0 <= lacunarity <= 255 and 0 <= gain <= 1 and octaves <= 32):
        return math.inf
    limit, error = gradient.fixed_limit[dims], 0.0
    if octaves > 0:
        fixed = fixed_weights(octaves, gain)
        exact = [gain**i for i in range(octaves)]
        total = sum(fixed)
        ratio = math.trunc(lacunarity * 2**23) / 2**23
        position, position_err = p_max, 0.0 if exact_positions else 2.0**-32
        for i in range(octaves):
            noise_err = min(gradient.lipschitz[dims] * position_err + gradient.fixed_error[dims], 2 * limit)
            error += fixed[i] / total * noise_err + limit * abs(fixed[i] / total - exact[i] / sum(exact))
            if not exact_positions:
                position_err = ratio * position_err + (lacunarity - ratio) * position + 2.0**-32
            position = lacunarity * position + SHIFT_MAX[dims]
        error += (2 * octaves * FADE_ONE / total + 1) * UNIT + DOUBLE
    if kind == "clouds":  # the clamp and the doubling are exact, the smoothstep has slopes up to 3/2
        return 1.5 * 2 * error + cloud_error()
    return error
