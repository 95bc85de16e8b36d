"""Sums over lattice points, gradients that rotate, and waves, on arrays: exactly, in doubles. Written from
docs/reference/contract.md, sections 13, 14 and 23, for bounds_kernel_test.py, bounds_phasor_test.py and
bounds_phasor_d_test.py. Floats come from the library's text (rounded.py).

A noise takes the fractions along its axes, and a function from a lattice point, as coordinates in half steps, to its
words. A phase is a word in units of 2^-32 turns, or None."""

import itertools
import math

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds.gradients import OCTAHEDRAL, ROTATED
from proof.bounds.weights import CUBE, EVEN, FIFTH, PLANE


def points(kernel):
    """The points that may be near a place of the cell, in steps."""
    if kernel.triangles:
        return [(i + (j % 2) / 2, j) for i in range(-2, 4) for j in range(-1, 4)]
    corners = list(itertools.product(range(-1, 3), repeat=kernel.dims))
    return corners + [tuple(x + 0.5 for x in corner) for corner in corners]


def words_at(kernel, cells, seed=0):
    """From a point to its words, in cells at these coordinates."""
    seed = np.int64(seed)

    def words(halves):
        if not kernel.triangles:
            return exact.lattice_word([c + h // 2 for c, h in zip(cells, halves)], seed, centre=halves[0] % 2 == 1)
        row = halves[1] // 2
        column = (halves[0] - row % 2) // 2
        return exact.lattice_word([2 * cells[0] + column, 2 * cells[1] + row], seed)
    return words


def halves(point):
    return [int(2 * x) for x in point]


def at(near, words):
    """The words, or phases if there are any, of the places that a point is near to: a few of all. Some hash gives one
    word for all places."""
    return words if words is None or len(words) == 1 else words[near]


def gradients(dims, words, phase):
    if phase is None:
        return exact.gradient(OCTAHEDRAL, dims, words)
    return exact.rotated(dims, words, phase / 2**32)


def weight(kernel, t):
    """w and its derivative."""
    if kernel.weight is CUBE:
        return t**3, 3 * t**2
    if kernel.weight is PLANE:
        return 3 * t**3 - 2 * t**4, 9 * t**2 - 8 * t**3
    if kernel.weight is EVEN:
        return t**3 * (1 + 15 * (1 - t)**2), 3 * (4 * t - 5 * t**2)**2
    return (4 * t**5, 20 * t**4) if kernel.weight is FIFTH else (t**4, 4 * t**3)


def near_points(kernel, place):
    """Each point, the places that it is near to, its offsets there and t."""
    for point in points(kernel):
        d = place - np.array(point)[:, None]
        t = kernel.radius - kernel.fall * sum(d * d)
        near = np.flatnonzero(t > 0)
        if near.size:
            yield halves(point), near, d[:, near], t[near]


def simplex(kernel, words_of, fractions, phase=None):
    """The value, and the derivatives per cell."""
    place = np.array([x * kernel.steps for x in fractions])
    value, derivatives = np.zeros(place.shape[1]), np.zeros(place.shape)
    for point, near, d, t in near_points(kernel, place):
        w, slope = weight(kernel, t)
        g = gradients(kernel.dims, at(near, words_of(point)), at(near, phase))
        ramp = sum(a * b for a, b in zip(g, d))
        value[near] += w * ramp
        for axis, a in enumerate(g):
            derivatives[axis, near] += a * w - 2 * kernel.fall * d[axis] * slope * ramp
    scale = kernel.scale / 1024
    return scale * value, list(scale * kernel.steps * derivatives)


def phasor(kernel, words_of, fractions, wave, phase):
    """The value, and the quadrature as the imaginary part. The phase is in turns."""
    place = np.array([x * kernel.steps for x in fractions])
    waves, total = np.clip(wave, -16, 16), np.zeros(place.shape[1], complex)
    for point, near, d, t in near_points(kernel, place):
        turns = at(near, words_of(point)) / 2**32 + phase[near] + sum(waves[:, near] * d) / kernel.steps
        total[near] += weight(kernel, t)[0] * np.exp(2j * math.pi * (turns % 1))
    return kernel.scale / 1024 * total


def phasor_d(kernel, words_of, fractions, wave, phase):
    """The noise with its derivatives per cell, each with its quadrature as the imaginary part: first the value."""
    place = np.array([x * kernel.steps for x in fractions])
    waves, falls = np.clip(wave, -16, 16), np.zeros(place.shape, complex)
    for point, near, d, t in near_points(kernel, place):
        turns = at(near, words_of(point)) / 2**32 + phase[near] + sum(waves[:, near] * d) / kernel.steps
        falls[:, near] -= 2 * kernel.fall * d * weight(kernel, t)[1] * np.exp(2j * math.pi * (turns % 1))
    value = phasor(kernel, words_of, fractions, wave, phase)
    return [value, *(kernel.steps * kernel.scale / 1024 * falls + 2j * math.pi * waves * value)]


def perlin(words_of, fractions, phase):
    return exact.perlin(ROTATED, words_of, fractions, lambda _, dims, words: gradients(dims, words, phase))
