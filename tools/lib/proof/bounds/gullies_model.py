"""hn_gullies on arrays with LATTICE, without periods: exactly in doubles, and in integers. Written from
docs/contract.md, section 24, for bounds_gullies_test.py. A sum is a bounds.sums.Sum in a tile, and gives the height and
what is added to both slopes, in floats."""

import math

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds import fixed_model as fixed
from proof.bounds import kernel_model, sums
from proof.bounds.exact_model import SHIFT, u32
from proof.bounds.fixed_model import s32, s56
from proof.bounds.frames_model import GOLDEN, coarse, prod
from proof.bounds.noises.phasor import KERNELS

KERNEL = KERNELS[2]


def words_at(cells, seed):
    def words(halves):
        row = halves[1] // 2
        column = (halves[0] - row % 2) // 2
        return exact.lattice_word([2 * cells[0] + column, 2 * cells[1] + row], np.int64(seed))
    return words


def exact_gullies(s, slope, depth, cells, fractions):
    e = first = [np.clip(x, -8, 8) for x in slope]
    height, seed, ratio, f = 0.0 * first[0], 0, math.floor(s.lacunarity), list(fractions)
    depth = min(max(depth, 0.0), 8.0)
    for i, fade in zip(range(s.count), sums.doubled(s).fades):
        r = np.hypot(*e)
        u = [x / (r + 1 / 8) for x in e]
        wave, part = 1.5 * np.array([-u[1], u[0]]), s.gain**i * np.hypot(*u) * fade
        v, *g = kernel_model.phasor_d(KERNEL, words_at(cells, seed), f, wave, 0 * r)
        height = height + part * v.real
        e = [np.clip(x + depth * ratio**i * part * y.real, -8, 8) for x, y in zip(e, g)]
        f = [ratio * x + shift for x, shift in zip(f, SHIFT)]
        cells = [c * ratio + np.floor(x).astype(np.int64) for c, x in zip(cells, f)]
        f, seed = [x - np.floor(x) for x in f], u32(seed + GOLDEN)
    return [depth * height, *(x - y for x, y in zip(e, first))]


# --- In integers ------------------------------------------------------------------------------------------------------

def root(q):
    """2^8 q is below 2^53."""
    return np.floor(np.sqrt(2.0**8 * q)).astype(np.int64)


def over(x, d):
    return np.sign(x) * (2**19 * abs(x) // d)


def product(a, b):
    return ((a >> 9) * b + (((a & 511) * b) >> 9)) >> 9


def fixed_gullies(s, slope, depth, q):
    """From whole positions."""
    e = first = [np.trunc(np.clip(x, -8, 8) * 2**16).astype(np.int64) for x in slope]
    deep, ratio = math.trunc(min(max(depth, 0.0), 8.0) * 2**18), math.floor(s.lacunarity) * 2**23
    growth, c, seed, total = math.trunc(s.gain * 2**18) * ratio >> 23, deep, 0, 0 * first[0]
    for weight, fade in zip(sums.fixed_weights(s), sums.fixed_fades(sums.doubled(s))):
        cells, f = [x >> 24 for x in q], [(x & (2**24 - 1)) >> 4 for x in q]
        r = root((e[0]**2 + e[1]**2) >> 12)
        wave = 1.5 * 2.0**-21 * np.array([-over(e[1], r + 2**11), over(e[0], r + 2**11)])
        part = product(over(4 * r, r + 2**11) >> 3, fade)
        value, *slopes = kernel_model.fixed_phasor_d(KERNEL, words_at(cells, seed), f, wave, np.zeros(r.shape))
        total = s32(total + fixed.weighted(value[0], product(weight, part)))
        rate = prod(c, part)
        e = [np.clip(s32(x + prod(y[0], rate)), -2**19, 2**19) for x, y in zip(e, slopes)]
        c, seed = prod(c, growth), u32(seed + GOLDEN)
        q = [s56(fixed.times(x, ratio) + int(shift * 2**24)) for x, shift in zip(q, SHIFT)]
    return [coarse(prod(total, deep)) * 2.0**-21, *((x - y) * 2.0**-16 for x, y in zip(e, first))]
