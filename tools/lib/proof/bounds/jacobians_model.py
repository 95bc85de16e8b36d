"""Octave sums with slopes, and warps, on arrays with LATTICE: exactly, in doubles. Written from
docs/reference/contract.md, sections 7, 8 and 22, for bounds_jacobians_test.py.

A sum is a bounds.sums.Sum of one of the kinds fbm_d, eroded, warp and warp_progressive. It gives a list of arrays: the
value, the value and the derivatives, or the components."""

import math

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds.exact_model import SHIFT, u32
from proof.bounds.gradients import OCTAHEDRAL

GOLDEN = 0x9E3779B9


def words_of_components(cells, seed):
    """The numbers of the corners, for each component of hn_value_vector."""
    words = exact.words_at(OCTAHEDRAL, cells, np.int64(seed))
    return [exact.words_of_component(words, axis) for axis in range(len(cells))]


def times(matrix, vector):
    return [sum(a * x for a, x in zip(row, vector)) for row in matrix]


def exact_sum(s, p):
    dims, count, amplitude = len(p), s.count, min(max(s.amplitude, 0), 64)
    total = sum(s.gain**i for i in range(count))
    lacunarity = math.floor(s.lacunarity * 2**23) / 2**23 if s.from_cell else s.lacunarity
    jacobian, seed, sums, fall = np.eye(dims), 0, [0.0] * (dims + 1), [0.0] * dims
    for i in range(count):
        weight = s.gain**i
        if s.kind in ("warp", "warp_progressive"):
            cells, f = exact.cells_and_fractions(p)
            v = [np.clip(exact.value(words, f)[0], -1, 1) for words in words_of_components(cells, seed)]
            sums = [a + weight * x for a, x in zip(sums, v)]
            if s.kind == "warp_progressive":
                p = [x + amplitude / total * move for x, move in zip(p, times(jacobian, v))]
        else:
            n, g = exact.perlin_at(OCTAHEDRAL, p, np.int64(seed))
            fall = [x + y for x, y in zip(exact.rotate(fall) if s.rotates else fall, g)]
            fall = [np.clip(x, -8, 8) for x in fall]
            if s.kind == "eroded":
                n = n / (1 + min(max(s.strength, 0), 16) * sum(x * x for x in fall))
            sums = [a + x for a, x in zip(sums, [weight * n, *times(jacobian.T, g)])]
        p = [x * lacunarity for x in p]
        p = [x + shift for x, shift in zip(exact.rotate(p) if s.rotates else p, SHIFT)]
        jacobian = np.array(exact.rotate(list(jacobian)) if s.rotates else jacobian) * (s.gain * lacunarity)
        seed = u32(seed + GOLDEN)
    means = [x / total for x in sums] if count else [np.zeros(np.shape(p[0]))] * (dims + 1)
    if s.kind in ("warp", "warp_progressive"):
        return [amplitude * x for x in means[:dims]]
    return means if s.kind == "fbm_d" else means[:1]
