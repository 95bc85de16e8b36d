"""Sums over lattice points, gradients that turn, and waves, on arrays: exactly in doubles, and in integers. Written
from docs/contract.md, sections 13, 14 and 23, for bounds_kernel_test.py, bounds_phasor_test.py and
bounds_phasor_d_test.py. Floats are those of the library's text (rounded.py).

A noise takes the fractions along its axes, and a function from a lattice point, as coordinates in half steps, to its
words. A phase is a word in units of 2^-32 turns, or None."""

import itertools
import math

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds import fixed_model as fixed
from proof.bounds.exact_model import s32, u32
from proof.bounds.fixed_model import ONE, part
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.weights import CUBE, EVEN, FIFTH, PLANE


def points(kernel):
    """Those that may be near a place of the cell, in steps."""
    if kernel.triangles:
        return [(i + (j % 2) / 2, j) for i in range(-2, 4) for j in range(-1, 4)]
    corners = list(itertools.product(range(-1, 3), repeat=kernel.dims))
    return corners + [tuple(x + 0.5 for x in corner) for corner in corners]


def words_at(kernel, cells):
    """From a point to its words, in cells at these coordinates."""
    def words(halves):
        if not kernel.triangles:
            return exact.lattice_word([c + h // 2 for c, h in zip(cells, halves)], np.int64(0), centre=halves[0] % 2 == 1)
        row = halves[1] // 2
        column = (halves[0] - row % 2) // 2
        return exact.lattice_word([2 * cells[0] + column, 2 * cells[1] + row], np.int64(0))
    return words


def halves(point):
    return [int(2 * x) for x in point]


def at(near, words):
    """The words, or phases if there are any, of the places that a point is near to: a few of all. Some hash gives one
    word for all places."""
    return words if words is None or len(words) == 1 else words[near]


def turned(g, phase):
    if phase is None:
        return g
    angle = phase / 2**31 * math.pi
    return [np.cos(angle) * a + np.sin(angle) * b for a, b in zip(g, exact.quarter(g))]


# --- Exactly ----------------------------------------------------------------------------------------------------------

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
        g = turned(exact.gradient(OCTAHEDRAL, kernel.dims, at(near, words_of(point))), at(near, phase))
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
    """The same with the derivatives per cell, each with its quadrature as the imaginary part: first the value."""
    place = np.array([x * kernel.steps for x in fractions])
    waves, falls = np.clip(wave, -16, 16), np.zeros(place.shape, complex)
    for point, near, d, t in near_points(kernel, place):
        turns = at(near, words_of(point)) / 2**32 + phase[near] + sum(waves[:, near] * d) / kernel.steps
        falls[:, near] -= 2 * kernel.fall * d * weight(kernel, t)[1] * np.exp(2j * math.pi * (turns % 1))
    value = phasor(kernel, words_of, fractions, wave, phase)
    return [value, *(kernel.steps * kernel.scale / 1024 * falls + 2j * math.pi * waves * value)]


def perlin(words_of, fractions, phase):
    return exact.perlin(OCTAHEDRAL, words_of, fractions, lambda g: turned(g, phase))


# --- In integers ------------------------------------------------------------------------------------------------------

def fixed_weight(kernel, t):
    """W and E."""
    q = u32(t * t + 2**15) >> 16
    if kernel.weight is EVEN:
        g, h = t - q, 4 * t - 5 * q
        inner = q + (u32(15 * g * g + 2**15) >> 16)
        return u32(inner * t + 2**13) >> 14, 3 * kernel.fall * (u32(h * h + 2**15) >> 16)
    cube = u32(q * t + 2**13) >> 14
    if kernel.weight is CUBE:
        return cube, 6 * q
    if kernel.weight is PLANE:
        u = u32(t * (98304 - t) + 2**15) >> 16
        return u32(q * u + 2**12) >> 13, s32(q * (73728 - t) + 2**12) >> 13
    if kernel.weight is FIFTH:
        return u32((u32(q * q + 2**15) >> 16) * t + 2**11) >> 12, None
    return u32(q * q + 2**13) >> 14, 2 * cube


def near_fixed_points(kernel, place):
    for point in points(kernel):
        d = place - np.array([int(x * ONE) for x in point])[:, None]
        n = sum(d * d) >> 10
        t = np.minimum((np.maximum(int(kernel.radius * 2**30) - kernel.fall * n, 0) + 2**13) >> 14, 65535)
        near = np.flatnonzero(t > 0)
        if near.size:
            yield halves(point), near, d[:, near], t[near]


def fixed_scaled(n, scale):
    return s32((s32(n + 256) >> 9) * scale + 256) >> 9


def fixed_sums(kernel, words_of, place, turned=False):
    """What is scaled, first of the value, then of the derivatives."""
    total, along = np.zeros(place.shape[1], np.int64), np.zeros(place.shape, np.int64)
    for point, near, d, t in near_fixed_points(kernel, place):
        w, fall = fixed_weight(kernel, t)
        g = fixed.of_words(kernel.dims, at(near, words_of(point)), turned)
        ramp = fixed.ramp_of(g, d)
        total[near] += part(ramp, w)
        if fall is not None:
            k = part(ramp, fall)
            for axis, a in enumerate(fixed.components(g)):
                along[axis, near] += part(a, w) - 2 * part(k, d[axis] >> 2)
    return [s32(total), *map(s32, along)]


def fixed_simplex(kernel, words_of, fractions, phase=None):
    """v in units of 2^-21, and the derivatives in units of 2^-19."""
    place = np.array([kernel.steps * f for f in fractions])
    sums = fixed_sums(kernel, words_of, place)
    if phase is not None:
        sums = fixed.mixed(phase, sums, fixed_sums(kernel, words_of, place, True))
    scale = kernel.scale * (2 if kernel.dims == 4 else 1)
    value, *along = [fixed_scaled(n, scale) for n in sums]
    return value, [kernel.steps * d for d in along]


def fixed_angle(turns):
    """A number of turns as a word."""
    return u32(4 * np.trunc((turns - np.trunc(turns)) * 2.0**30).astype(np.int64))


def fixed_waves(wave):
    """K."""
    return np.trunc(np.clip(wave, -16, 16) * 2.0**16).astype(np.int64)


def fixed_phasor(kernel, words_of, fractions, wave, phase):
    """The value and the quadrature in units of 2^-21."""
    place, waves, angle = np.array([kernel.steps * f for f in fractions]), fixed_waves(wave), fixed_angle(phase)
    total = np.zeros((2, place.shape[1]), np.int64)
    for point, near, d, t in near_fixed_points(kernel, place):
        a = at(near, words_of(point)) + angle[near] + sum((waves[:, near] * d) >> (5 if kernel.triangles else 4))
        w = fixed_weight(kernel, t)[0]
        for n, word in zip(total, (u32(a + 2**30), u32(a))):
            n[near] += part(2**13 * fixed.sine_of_turns(word), w)
    return [fixed_scaled(s32(n), kernel.scale) for n in total]


def fixed_phasor_d(kernel, words_of, fractions, wave, phase):
    """The value and the quadrature, and then those of each derivative, in units of 2^-16."""
    place, waves, angle = np.array([kernel.steps * f for f in fractions]), fixed_waves(wave), fixed_angle(phase)
    falls = np.zeros((kernel.dims, 2, place.shape[1]), np.int64)
    for point, near, d, t in near_fixed_points(kernel, place):
        a = at(near, words_of(point)) + angle[near] + sum((waves[:, near] * d) >> (5 if kernel.triangles else 4))
        fall = fixed_weight(kernel, t)[1]
        for axis, part_number in itertools.product(range(kernel.dims), range(2)):
            sine = fixed.sine_of_turns(u32(a + 2**30 * (part_number == 0)))
            falls[axis, part_number, near] -= 2 * part(part(2**13 * sine, fall), d[axis] >> 2)
    v, z = fixed_phasor(kernel, words_of, fractions, wave, phase)
    results = [[v, z]]
    for k, of_axis in zip(waves, falls):
        a, b = (fixed_scaled(s32(n), kernel.scale) * 32 * kernel.steps for n in of_axis)
        turns = part(2**9 * k, 205887) >> 9
        results.append([s32(a - part(2**8 * z, turns) + 2**7) >> 8, s32(b + part(2**8 * v, turns) + 2**7) >> 8])
    return results
