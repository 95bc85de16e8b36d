"""hn_gullies on arrays with LATTICE, without periods: exactly, in doubles. Written from docs/reference/contract.md,
section 24, for bounds_gullies_test.py. A sum is a bounds.sums.Sum in a tile, and gives the height and
the sums for both slopes, in floats."""

import math

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds import kernel_model, sums
from proof.bounds.exact_model import SHIFT, u32
from proof.bounds.jacobians_model import GOLDEN
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
