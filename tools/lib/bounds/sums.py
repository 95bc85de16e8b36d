"""How far an octave sum over a noise may be off, from the bounds of that noise: in floats, and in fixed arithmetic."""

import functools
import math

import numpy as np

from bounds.boxes import SAFE
from bounds.floats import TINY
from bounds.floats import UNIT as FLOAT_UNIT
from bounds.integers import DOUBLE, FADE_ONE, UNIT, checked, signed, word
from bounds.table import Bounds

SHIFT_MAX = {2: 19 / 32, 3: 23 / 32}  # the largest component of the shift between octaves

# What clouds are off by beyond the error of an fBm: the clamp leaves no more than 1, whatever the limit; the smoothstep
# has slopes up to 3/2 and three roundings, relative to a value of at most 1.
FLOAT_CLOUD_ERROR = 1.5 * FLOAT_UNIT + 3.001 * FLOAT_UNIT

# --- In floats --------------------------------------------------------------------------------------------------------

def octave_tolerance(kind, noise: Bounds, p_max, octaves, lacunarity, gain, exact_positions):
    """The largest error of hn_fbm, hn_turbulence or hn_clouds (kind "fbm", "turbulence", "clouds") over a noise, for
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
    limit, position, position_err = noise.limit, p_max, 0.0
    amp, amp_err, total, total_err, sum_err, error = 1.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for _ in range(octaves):
        noise_err = min(noise.lipschitz * position_err + noise.error, 2 * limit)
        sum_err += (amp + amp_err) * (noise_err + FLOAT_UNIT * limit) + limit * amp_err + TINY
        total, total_err = 1 + gain * total, gain * (total_err + FLOAT_UNIT * (total + total_err)) + TINY
        sum_err += FLOAT_UNIT * (limit * total + sum_err)
        total_err += FLOAT_UNIT * (total + total_err)
        product_err = abs(lacunarity) * (position_err + FLOAT_UNIT * (position + position_err) + TINY) + TINY
        position = abs(lacunarity) * position + SHIFT_MAX[noise.dimensions]
        position_err = 0.0 if exact_positions else product_err + FLOAT_UNIT * (position + product_err)
        amp, amp_err = amp * gain, gain * (amp_err + FLOAT_UNIT * (amp + amp_err)) + TINY
    if total > 2.0**126:
        return math.inf
    if octaves > 0:
        error = (sum_err + limit * total_err) / (total - total_err)
        error += 2.5 * FLOAT_UNIT * (limit + error) + TINY
    if kind == "clouds":
        return 1.5 * 2 * error + FLOAT_CLOUD_ERROR
    return error  # abs is exact and brings no two values further apart


# --- In integers ------------------------------------------------------------------------------------------------------

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


def fixed_octave_tolerance(kind, noise: Bounds, p_max, octaves, lacunarity, gain, exact_positions):
    """As octave_tolerance, of the fixed arithmetic; for lacunarity in [0, 255], gain in [0, 1] and
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
    limit, error = noise.fixed_limit, 0.0
    if octaves > 0:
        fixed = fixed_weights(octaves, gain)
        exact = [gain**i for i in range(octaves)]
        total = sum(fixed)
        ratio = math.trunc(lacunarity * 2**23) / 2**23
        position, position_err = p_max, 0.0 if exact_positions else 2.0**-32
        for i in range(octaves):
            noise_err = min(noise.lipschitz * position_err + noise.fixed_error, 2 * limit)
            error += fixed[i] / total * noise_err + limit * abs(fixed[i] / total - exact[i] / sum(exact))
            if not exact_positions:
                position_err = ratio * position_err + (lacunarity - ratio) * position + 2.0**-32
            position = lacunarity * position + SHIFT_MAX[noise.dimensions]
        error += (2 * octaves * FADE_ONE / total + 1) * UNIT + DOUBLE
    if kind == "clouds":  # the clamp and the doubling are exact, the smoothstep has slopes up to 3/2
        return 1.5 * 2 * error + cloud_error()
    return error


def largest_octave_intermediates(limit):
    """By name, bounds of the magnitudes that must stay below 2^31, for a noise of at most `limit`: of
    v * (A >> 9) + (v >> 9) * (A & 511), A <= 2^18. Where A & 511 is not 0, A >> 9 is at most 511."""
    noise = limit * 2**21
    return {"octave": noise * 2**9 + (noise / 2**9 + 1) * 511, "sum of 32 octaves": 32 * (noise + 2)}
