"""Octave sums with slopes, and warps, on arrays with LATTICE: exactly in doubles, and in integers that wrap as the
contract says. Written from docs/contract.md, sections 7, 8 and 22, for bounds_frames_test.py.

A sum is a bounds.sums.Sum of one of the kinds fbm_d, eroded, warp and warp_progressive. It gives a list of arrays: the
value, the value and the derivatives, or the components."""

import math

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds import fixed_model as fixed
from proof.bounds.exact_model import SHIFT, TURNS, u32
from proof.bounds.fixed_model import s32, s56
from proof.bounds.gradients import OCTAHEDRAL

GOLDEN = 0x9E3779B9


def words_of_components(cells, seed):
    """For each component of hn_value_vector, those of the corners."""
    words = exact.words_at(OCTAHEDRAL, cells, np.int64(seed))
    return [exact.words_of_component(words, axis) for axis in range(len(cells))]


# --- Exactly ----------------------------------------------------------------------------------------------------------

def times(matrix, vector):
    return [sum(a * x for a, x in zip(row, vector)) for row in matrix]


def exact_sum(s, p):
    dims, count, amplitude = len(p), s.count, min(max(s.amplitude, 0), 64)
    total = sum(s.gain**i for i in range(count))
    lacunarity = math.floor(s.lacunarity * 2**23) / 2**23 if s.from_cell else s.lacunarity
    frame, seed, sums, fall = np.eye(dims), 0, [0.0] * (dims + 1), [0.0] * dims
    for i in range(count):
        weight = s.gain**i
        if s.kind in ("warp", "warp_progressive"):
            cells, f = exact.cells_and_fractions(p)
            v = [np.clip(exact.value(words, f)[0], -1, 1) for words in words_of_components(cells, seed)]
            sums = [a + weight * x for a, x in zip(sums, v)]
            if s.kind == "warp_progressive":
                p = [x + amplitude / total * move for x, move in zip(p, times(frame, v))]
        else:
            n, g = exact.perlin_at(OCTAHEDRAL, p, np.int64(seed))
            fall = [x + y for x, y in zip(exact.turn(fall) if s.turns else fall, g)]
            fall = [np.clip(x, -8, 8) for x in fall]
            if s.kind == "eroded":
                n = n / (1 + min(max(s.strength, 0), 16) * sum(x * x for x in fall))
            sums = [a + x for a, x in zip(sums, [weight * n, *times(frame.T, g)])]
        p = [x * lacunarity for x in p]
        p = [x + shift for x, shift in zip(exact.turn(p) if s.turns else p, SHIFT)]
        frame = np.array(exact.turn(list(frame)) if s.turns else frame) * (s.gain * lacunarity)
        seed = u32(seed + GOLDEN)
    means = [x / total for x in sums] if count else [np.zeros(np.shape(p[0]))] * (dims + 1)
    if s.kind in ("warp", "warp_progressive"):
        return [amplitude * x for x in means[:dims]]
    return means if s.kind == "fbm_d" else means[:1]


# --- In integers ------------------------------------------------------------------------------------------------------

def prod(a, b):
    """Of numbers of 32 bits, in Python's integers or within 64 bits. That nothing wraps is compared."""
    return s32((a * b) >> 18)


def coarse(v):
    return np.where(abs(v) < 2**24, v, np.sign(v) * (abs(v) & ~127))


def quotient(v, total):
    """trunc(v 2^18 / T)."""
    v = v * 2**18
    return np.sign(v) * (abs(v) // total)


def turned_frame(rows):
    """Of rows of numbers."""
    rows = [np.array(row) for row in rows]
    for axis, (c, t) in enumerate(TURNS[:len(rows) - 1]):
        a, b = rows[axis:axis + 2]
        rows[axis:axis + 2] = s32(c * a - t * b) >> 5, s32(t * a + c * b) >> 5
    return rows


def next_frame(frame, growth, turns):
    """(c, s) in the plane, three rows in space."""
    frame = [prod(np.array(row), growth) for row in frame]
    return turned_frame(frame) if turns else frame


def slopes_through(frame, g):
    """What an octave adds to D."""
    if len(g) == 2:
        c, s = frame
        return [prod(c, g[0]) + prod(s, g[1]), prod(c, g[1]) - prod(s, g[0])]
    return [sum(prod(row[axis], x) for row, x in zip(frame, g)) for axis in range(3)]


def shift_through(frame, v):
    """u of the contract."""
    if len(v) == 2:
        c, s = frame
        return [prod(c, v[0]) - prod(s, v[1]), prod(s, v[0]) + prod(c, v[1])]
    return [sum(prod(number, x) for number, x in zip(row, v)) for row in frame]


def factor_of_fall(fall, strength):
    """W of the contract. 2^53.6 holds the product with the strength."""
    e = u32(sum(x * x for x in fall))
    return 2**34 // (2**16 + (e * strength >> 26))


def fixed_sum(s, q):
    """From whole positions; in units of 2^-21, and of 2^-19 for derivatives."""
    dims, ratio, gain = len(q), math.trunc(s.lacunarity * 2**23), math.trunc(s.gain * 2**18)
    all_weights = fixed.octave_weights(s) if s.count else []
    growth, strength = gain * ratio >> 23, math.trunc(min(max(s.strength, 0), 16) * 2**18)
    largest = math.trunc(min(max(s.amplitude, 0), 64) * 2**18)
    frame = [np.int64(2**18), np.int64(0)] if dims == 2 else list(np.eye(3, dtype=np.int64) * 2**18)
    seed, sums, fall = 0, [np.zeros(np.shape(q[0]), np.int64)] * (dims + 1), None
    for weight in all_weights:
        cells, f = [x >> 24 for x in q], [(x & (2**24 - 1)) >> 4 for x in q]
        if s.kind in ("warp", "warp_progressive"):
            v = [np.clip(fixed.value(words, f)[0], -2**21, 2**21) for words in words_of_components(cells, seed)]
            sums = [s32(a + fixed.weighted(x, weight)) for a, x in zip(sums, v)]
            if s.kind == "warp_progressive":
                cut = largest * 2**18 // sum(all_weights)
                q = [s56(x + 8 * prod(s32(move), cut)) for x, move in zip(q, shift_through(frame, v))]
        else:
            v, g = fixed.perlin(OCTAHEDRAL, exact.words_at(OCTAHEDRAL, cells, np.int64(seed)), f, derivatives=True)
            g = [np.clip(x, -2**26, 2**26) for x in g]
            if s.kind == "eroded":
                turned = [0] * dims if fall is None else fixed.turn(fall) if s.turns else fall
                fall = [np.clip(x + (y >> 7), -2**15, 2**15) for x, y in zip(turned, g)]
                weight = fixed.product(weight, factor_of_fall(fall, strength))
            v = np.clip(v, -3 * 2**20, 3 * 2**20)
            sums = [s32(a + x) for a, x in zip(sums, [fixed.weighted(v, weight), *slopes_through(frame, g)])]
        q = [s56(fixed.times(x, ratio)) for x in q]
        q = [s56(x + int(shift * 2**24)) for x, shift in zip(fixed.turn(q) if s.turns else q, SHIFT)]
        frame, seed = next_frame(frame, growth, s.turns), u32(seed + GOLDEN)
    means = [quotient(x, sum(all_weights)) for x in sums] if all_weights else sums
    if s.kind in ("warp", "warp_progressive"):
        return [coarse(prod(x, largest)) for x in means[:dims]]
    return [means[0], *(coarse(x) for x in means[1:])] if s.kind == "fbm_d" else means[:1]
