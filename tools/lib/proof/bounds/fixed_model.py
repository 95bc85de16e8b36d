"""The fixed arithmetic of docs/contract.md on arrays, with LATTICE, in integers that wrap as the contract says. Written
from that page alone, for bounds_fixed_test.py and smoothness.py. A noise takes what those of exact_model.py take, with
fractions in units of 2^-20, and returns integers."""

import itertools
import math
import sys

import numpy as np

from proof.bounds.boxes import corners
from proof.bounds.exact_model import PARTS, SHIFT, TURNS, quarter, s32, sine_argument, u32, whole_gradient, words_at
from proof.bounds.floats import pairs
from proof.bounds.gradients import SINE
from proof.bounds.sums import step_of

ONE = 2**20
RAMP_ONE = {1: 2**29, 2: 2**29, 3: 2**29, 4: 2**28}  # of octahedral gradients


# --- Steps ------------------------------------------------------------------------------------------------------------

def sine_of_turns(turns):
    """In units of 2^-32 turns."""
    q = turns & 0x7FFFFFFF
    x = np.minimum((np.minimum(q, 0x80000000 - q) + 2**13) >> 14, 65535)
    u = u32(x * x) >> 16
    y = u32(102943 - (u32(u * (42328 - (u32(u * (5208 - ((u * 288) >> 16))) >> 16))) >> 16))
    g = u32(x * (y >> 1) + 2**14) >> 15
    return np.where(turns >> 31, -g, g)


def sine(w):
    argument = sine_argument(w)
    m = abs(argument)
    high, low = m >> 16, m & 0xFFFF
    turns = u32(m * 0x28BE60DB + high * 0x9391 + (u32(high * 0x054A + low * 0x9391) >> 16))
    return np.where(u32(w) >> 31, -1, 1) * sine_of_turns(turns)


def nearer_end(f):
    return np.minimum(np.minimum(f, ONE - f) + 4, 2**19 - 1) >> 3


def fade(f):
    x = nearer_end(f)
    s = u32(x * x)
    z = u32(s + 2**15) >> 16
    r = u32(1572864 - 30 * x + 6 * z) >> 2
    q = u32(s + (u32(z * r) >> 2) + 2**15) >> 16
    t = u32(x * q + 2**14) >> 15
    return np.where(f > 2**19, 2**18 - t, t)


def slope(f):
    x = nearer_end(f)
    q = u32(x * (2**17 - x)) >> 16
    return u32(u32((u32(q * q) >> 4) * 15) + 4096) >> 13


def sixth(x):
    q = u32(x * x)
    return u32(u32((q >> 15) * x) + (u32((q & 32767) * x) >> 15)) // 6


def spline(f):
    x = u32(f + 16) >> 5
    first, last = (u32(cube + 2**11) >> 12 for cube in (sixth(2**15 - x), sixth(x)))
    middle = u32(u32(715829931 + 3 * sixth(x)) - u32(x * x)) >> 12
    return first, middle, 2**18 - first - middle - last, last


def part(d, t):
    return s32(s32((d >> 9) * (t >> 9)) + s32((d >> 18) * (t & 511)))


def lerp(a, b, t):
    return s32(a + part(s32(b - a), t))


def rise(a, b):
    return s32(b - a) >> 2


def scaled(dims, n):
    return s32((s32(n + 256) >> 9) * {1: 2048, 2: 1831, 3: 985, 4: 1906}[dims] + 256) >> 9


# --- Perlin noise -----------------------------------------------------------------------------------------------------

def of_words(dims, words, turned=False):
    """The octahedral gradient, in the units of exact_model.PARTS; or a quarter of a turn later."""
    g = whole_gradient(dims, words)
    return quarter(g) if turned else g


def ramp_of(g, offsets):
    dims = len(g)
    return s32(RAMP_ONE[dims] // (PARTS[dims] * ONE) * s32(sum(s32(a * d) for a, d in zip(g, offsets))))


def components(g):
    """Of a gradient, in the units of derivatives, four times as large as those of ramps."""
    return [RAMP_ONE[len(g)] // (4 * PARTS[len(g)]) * a for a in g]


def sine_ramp(words, offsets):
    return s32(sum(s32((g >> 8) * d) + (((g & 255) * d) >> 8) for g, d in zip(map(sine, words), offsets)))


def x_first(dims):
    """The corners with x varying fastest."""
    return (reverse[::-1] for reverse in corners(dims))


def perlin_sums(kind, words_of, fractions, derivatives=False, turned=False):
    """What is scaled, first of the value; with the derivatives, if they are wanted, a quarter of a turn later or not."""
    dims, nodes = len(fractions), []
    for corner in x_first(dims):
        words = words_of(corner)
        offsets = [f - o * ONE for f, o in zip(fractions, corner)]
        if kind is SINE:
            nodes.append((sine_ramp(words, offsets), [], []))
        else:
            g = of_words(dims, words, turned)
            nodes.append((ramp_of(g, offsets), [], components(g) if derivatives else []))
    for f in fractions:
        t, s = fade(f), slope(f)
        joined = []
        for (a, made, g), (b, others, h) in pairs(nodes):
            rest = [lerp(x, y, t) for x, y in zip(g, h)]
            more = [lerp(x, y, t) for x, y in zip(made, others)]
            if derivatives:
                more.append(s32(rest.pop(0) + part(rise(a, b), s)))
            joined.append((lerp(a, b, t), more, rest))
        nodes = joined
    (n, made, _), = nodes
    return [n, *made]


def perlin(kind, words_of, fractions, derivatives=False, phase=None):
    """v in units of 2^-21; with the derivatives, in units of 2^-19, if they are wanted."""
    sums = perlin_sums(kind, words_of, fractions, derivatives)
    if phase is not None:
        sums = mixed(phase, sums, perlin_sums(kind, words_of, fractions, derivatives, True))
    v, *made = [n >> 7 if kind is SINE else scaled(len(fractions), n) for n in sums]
    return (v, made) if derivatives else v


# --- Phases -----------------------------------------------------------------------------------------------------------

def rotation(phase):
    """C and Z, of a phase as a word."""
    return 4 * sine_of_turns(u32(phase + 2**30)), 4 * sine_of_turns(phase)


def mixed(phase, sums, turned):
    c, z = rotation(phase)
    return [s32(part(a, c) + part(b, z)) for a, b in zip(sums, turned)]


# --- Value noise ------------------------------------------------------------------------------------------------------

def number(h):
    return s32(h % 2**23 * 2**7 - 2**29)


def value(words_of, fractions):
    """v in units of 2^-21, and the derivatives in units of 2^-19."""
    nodes = [(number(words_of(corner)), []) for corner in x_first(len(fractions))]
    t, s = [fade(f) for f in fractions], [slope(f) for f in fractions]
    rises = [rise(a, b) for (a, _), (b, _) in pairs(nodes)]
    nodes = [(lerp(a, b, t[0]), []) for (a, _), (b, _) in pairs(nodes)]
    if len(fractions) == 1:
        nodes = [(nodes[0][0], [part(rises[0], s[0])])]
    for axis in range(1, len(fractions)):
        joined = []
        for (a, made), (b, others) in pairs(nodes):
            more = [lerp(x, y, t[axis]) for x, y in zip(made, others)]
            joined.append((lerp(a, b, t[axis]), [*more, part(rise(a, b), s[axis])]))
        if axis == 1:
            along_x = [part(lerp(x, y, t[1]), s[0]) for x, y in pairs(rises)]
            joined = [(n, [d, *made]) for d, (n, made) in zip(along_x, joined)]
        nodes = joined
    (n, made), = nodes
    return s32(n + 128) >> 8, [s32(d + 128) >> 8 for d in made]


def value_cubic(words_of, fractions):
    values = [number(words_of(point[::-1])) for point in itertools.product((-1, 0, 1, 2), repeat=len(fractions))]
    for f in fractions:
        b = spline(f)
        values = [s32(sum(part(n, weight) for n, weight in zip(four, b)))
                  for four in zip(*(values[i::4] for i in range(4)))]
    return s32(values[0] + 128) >> 8


# --- Positions and octave sums ----------------------------------------------------------------------------------------

def cells_and_fractions(p):
    """Of positions of floats."""
    c = [np.trunc(x) for x in p]
    k = [np.trunc((x - whole) * 2.0**20).astype(np.int64) for x, whole in zip(p, c)]
    return [whole.astype(np.int64) + (rest >> 20) for whole, rest in zip(c, k)], [rest & (ONE - 1) for rest in k]


def perlin_at(kind, p):
    cells, fractions = cells_and_fractions(p)
    return perlin(kind, words_at(kind, cells), fractions)


def s56(x):
    return ((x + 2**55) & (2**56 - 1)) - 2**55


def whole(x):
    """X of a float, in units of 2^-24."""
    c = np.trunc(x)
    return c.astype(np.int64) * 2**24 + np.trunc((x - c) * 2.0**24).astype(np.int64)


def whole_of_cell(cell, f):
    return cell * 2**24 + np.trunc(np.clip(f, 0, 1) * 2.0**24).astype(np.int64)


def times(x, ratio):
    """floor(X L / 2^23) of up to 87 bits, by parts of 24: none wraps."""
    high, low = x >> 24, x & (2**24 - 1)
    product = high * ratio  # below 2^31 2^31
    return (product << 1) + ((low * ratio) >> 23)


def turn(q):
    """In 56 bits, which hold what a frame and a slope have, too."""
    q = list(q)
    for axis, (c, s) in enumerate(TURNS[:len(q) - 1]):
        x, y = q[axis:axis + 2]
        q[axis:axis + 2] = s56((c * x - s * y) >> 5), s56((s * x + c * y) >> 5)
    return q


def whole_positions(s, q):
    """Of each octave the cells, and the fractions in units of 2^-24."""
    ratio = math.trunc(min(max(s.lacunarity, 0), 255) * 2**23)
    yield [x >> 24 for x in q], [x & (2**24 - 1) for x in q]
    while True:
        q = [s56(times(x, ratio)) for x in q]
        q = [s56(x + int(shift * 2**24)) for x, shift in zip(turn(q) if s.turns else q, SHIFT)]
        yield [x >> 24 for x in q], [x & (2**24 - 1) for x in q]


def product(a, b):
    return s32(s32((a >> 9) * b) + (s32((a & 511) * b) >> 9)) >> 9


def weighted(v, a):
    return s32(s32(v * (a >> 9)) + s32((v >> 9) * (a & 511))) >> 9


def octave_weights(s):
    g, count = math.trunc(s.gain * 2**18), math.ceil(s.octaves)
    all_of_them = [2**18]
    for _ in range(count - 1):
        all_of_them.append(product(all_of_them[-1], g))
    if count > 1:
        all_of_them[-1] = product(all_of_them[-1], math.trunc((s.octaves - (count - 1)) * 2**18))
    return all_of_them


def fades(s):
    if s.footprint is None:
        yield from itertools.repeat(2**18)
    e, finer = math.trunc(min(max(s.footprint, 0), 2) * 2**24), max(math.trunc(s.lacunarity * 2**23), 2**23)
    while True:
        yield min(max(3 * 2**17 - (e >> 6), 0), 2**18)
        e = min(e * finer >> 23, 2**25)


def ping_pong(v, strength):
    """t of the contract is a word; what it is multiplied with counts modulo 2^32."""
    cut, u = math.trunc(min(max(strength, 0), 64) * 2**18), v + 2**21
    t = u32(u32(u * (cut >> 9)) + (s32(u * (cut & 511)) >> 9)) & (2**31 - 1)
    return (np.minimum(t, 2**31 - t) >> 8) - 2**21


def octaves(kind, s, q):
    """An octave sum (bounds.sums.Sum) from whole positions."""
    total, seed, before, used, step = 0, 0, 2**17, 2**18, step_of(s.kind)
    all_weights, strength = octave_weights(s), math.trunc(min(max(s.strength, 0), 1) * 2**18)
    for a, fade, (cells, fractions) in zip(all_weights, fades(s), whole_positions(s, q)):
        v = perlin(kind, words_at(kind, cells, np.int64(seed)), [r >> 4 for r in fractions])
        most = 2**21 if step.clamps else 3 * 2**20
        v = np.clip(v, -most, most)
        term, before = step.fixed_term(sys.modules[__name__], v, before, s.strength)
        total = s32(total + weighted(term, used if s.kind == "weighted" else product(a, fade)))
        used = product(product(used, 2**18 - product((2**21 - v) >> 4, strength)), math.trunc(s.gain * 2**18))
        seed = u32(seed + 0x9E3779B9)
    total = total * 2**18
    v = np.sign(total) * (abs(total) // sum(all_weights))
    return clouds(v) if s.kind == "clouds" else s32(2 * v) - 2**21 if s.kind == "billow" else v


def clouds(v):
    c = (np.clip(2 * v + 2**19, 0, 2**21) - 2**20) >> 5
    return 2**20 + (s32(c * (u32(0xC0000000 - u32(c * c)) >> 16)) >> 10)
