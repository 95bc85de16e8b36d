"""docs/reference/contract.md on arrays, with LATTICE, in doubles: words, gradients and numbers of lattice points, and
the exact noises, their derivatives and octave sums. Written from that page alone, for the tests of the bounds and
smoothness.py.

A noise takes the fractions along its axes, and a function from a corner of the cell (0 and 1 along each axis; -1 to 2
in cubic noise) to its words: an array, or with the sine gradient one for each component.
"""

import itertools
import math

import numpy as np

from proof.bounds.boxes import corners
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, SINE
from proof.bounds.sums import CATALOG, clamped_strength, name_of_step, step_of

SCALE = {OCTAHEDRAL: {1: 2048 / 1024, 2: 1831 / 1024, 3: 985 / 1024, 4: 953 / 1024},
         ROTATED: {2: 1831 / 1024, 3: 879 / 1024}, SINE: {2: 1.0, 3: 1.0}}
SHIFT = (11 / 32, 19 / 32, 23 / 32, 27 / 32)
ROTATIONS = ((25, 20), (29, 13), (25, 20))  # 32 times cosine and sine, in the plane of an axis and the next


# --- Words ------------------------------------------------------------------------------------------------------------

def u32(x):
    return x & 0xFFFFFFFF


def s32(x):
    return ((x + 2**31) & 0xFFFFFFFF) - 2**31


def mix(k):
    for shift, factor in ((15, 0x2C1B3C6D), (12, 0x297A2D39)):
        k = u32((k ^ (k >> shift)) * factor)
    return k ^ (k >> 15)


def lattice_word(cells, seed, centre=False):
    """The word of a lattice point (section 3, with LATTICE), or of the centre of its cell (section 13)."""
    spread = [u32(u32(c) * prime) for c, prime in zip(cells, (0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D, 0x27D4EB2F))]
    spread[0] = u32(spread[0] + 0x165667B1)
    mixed = mix(seed)
    join, total = mixed >> 8, u32(mixed + spread[0])
    for word, shift in zip(spread, (12, 11, 10, 9)):
        join = join ^ (word >> shift)
    for word, factor in zip(spread[1:], (0xE6133E, 0x913FDC, 0x85AAB8)):
        total = u32(total + word % 2**24 * factor)
    if centre:
        join, total = join ^ (0x165667B1 >> 8), u32(total + 0x165667B1)
    return u32(join * ((2 * total + 1) * 4097 % 2**24))


def hash_word(word):
    """hn_hash of a single word."""
    return mix(u32(lattice_word([word], np.int64(0)) + u32(word) * 0x9E3779B1 + 0x165667B1))


def sine_words(cells, seed):
    words = [hash_word(u32(cells[0])) ^ mix(seed)]
    for c in cells[1:]:
        words.append(hash_word(u32(words[-1] + c)))
    return [u32(words[-1] + word) for word in words]


def words_at(kind, cells, seed=np.int64(0)):
    """From a corner to its words, in a cell at these coordinates."""
    def words(corner):
        moved = [c + o for c, o in zip(cells, corner)]
        return sine_words(moved, seed) if kind is SINE else lattice_word(moved, seed)
    return words


def words_of_component(words, axis):
    """The values of a component of a vector (section 22), from the words of the corners."""
    factor = (1, 0xEB1831, 0x84A5E5)[axis]
    return (lambda corner: u32((words(corner) >> 8) * factor)) if axis else words


# --- Gradients and numbers --------------------------------------------------------------------------------------------

def field(h, shift, bits):
    """2 * bits of the word + 1, less their number: odd."""
    return 2 * ((h >> shift) & (2**bits - 1)) + 1 - 2**bits


PARTS = {1: 512, 2: 4, 3: 1, 4: 1}  # in which gradients are whole
# The axes of a gradient, by the third of the words, and in four dimensions by bit 20, too.
PAIRS = {3: ((0, 1), (0, 2), (1, 2)), 4: ((0, 1), (2, 3), (0, 2), (1, 3), (0, 3), (1, 2))}


def whole_gradient(dims, h):
    """The components of the octahedral gradient, in those parts."""
    if dims == 1:
        return [field(h, 14, 9)]
    if dims == 2:
        a = field(h, 21, 2)
        return [a, np.where(h >> 31, abs(a) - 4, 4 - abs(a))]
    pair = (h >= 0x55555555) + 1 * (h >= 0xAAAAAAAA)
    if dims == 4:
        pair = 2 * pair + ((h >> 20) & 1)
    first, second = np.array(PAIRS[dims]).T[:, pair]
    a, b = (1 - 2 * ((h >> bit) & 1) for bit in (22, 21))
    return [np.where(first == axis, a, 0) + np.where(second == axis, b, 0) for axis in range(dims)]


def sine_argument(w):
    """The word as a signed integer of 24 significant bits."""
    return s32(w).astype(np.float32).astype(np.int64)


def gradient(kind, dims, words):
    if kind is SINE:
        return [np.sin(sine_argument(w).astype(float)) for w in words]
    return [g / PARTS[dims] for g in whole_gradient(dims, words)]


def edge(h):
    """e, which a gradient in space is after a sixth of a turn (section 14): of its axes it keeps one."""
    x, y, z = whole_gradient(3, h)
    b = 1 - 2 * ((h >> 20) & 1)
    return [np.where(z == 0, 0, np.where(y == 0, x, b)), np.where(z == 0, y, np.where(y == 0, b, 0)),
            np.where(z == 0, b, np.where(y == 0, 0, z))]


def rotated(dims, words, turns):
    """Octahedral gradients after so many turns."""
    g, c, s = gradient(OCTAHEDRAL, dims, words), np.cos(2 * math.pi * turns), np.sin(2 * math.pi * turns)
    quarter = [-g[1], g[0]] if dims == 2 else [(2 * b - a) / math.sqrt(3) for a, b in zip(g, edge(words))]
    return [c * a + s * b for a, b in zip(g, quarter)]


def number(h):
    return (h % 2**23) / 2**22 - 1


# --- Noises -----------------------------------------------------------------------------------------------------------

def fade(f):
    return f**3 * (f * (f * 6 - 15) + 10)


def slope(f):
    return 30 * f**2 * (1 - f) ** 2


def weights(corner, fractions):
    """The weight of a corner, and its derivatives along the axes."""
    factors = [fade(f) if o else 1 - fade(f) for f, o in zip(fractions, corner)]
    slopes = [slope(f) if o else -slope(f) for f, o in zip(fractions, corner)]
    along = [math.prod(slopes[i] if i == axis else factor for i, factor in enumerate(factors))
             for axis in range(len(factors))]
    return math.prod(factors), along


def perlin(kind, words_of, fractions, gradient_of=gradient):
    """The value, and the derivatives, that a function makes of the kind, the dimensions and the words."""
    dims = len(fractions)
    value, derivatives = 0.0, [0.0] * dims
    for corner in corners(dims):
        g = gradient_of(kind, dims, words_of(corner))
        ramp = sum(component * (f - o) for component, f, o in zip(g, fractions, corner))
        weight, along = weights(corner, fractions)
        value = value + weight * ramp
        derivatives = [d + weight * component + change * ramp for d, component, change in zip(derivatives, g, along)]
    scale = SCALE[kind][dims]
    return scale * value, [scale * d for d in derivatives]


def value(words_of, fractions):
    """The value of value noise, and the derivatives."""
    total, derivatives = 0.0, [0.0] * len(fractions)
    for corner in corners(len(fractions)):
        weight, along = weights(corner, fractions)
        n = number(words_of(corner))
        total = total + weight * n
        derivatives = [d + change * n for d, change in zip(derivatives, along)]
    return total, derivatives


def spline(f):
    g = 1 - f
    return g**3 / 6, 2 / 3 - f**2 + f**3 / 2, 2 / 3 - g**2 + g**3 / 2, f**3 / 6


def value_cubic(words_of, fractions):
    along = [spline(f) for f in fractions]
    return sum(math.prod(b[o + 1] for b, o in zip(along, point)) * number(words_of(point))
               for point in itertools.product((-1, 0, 1, 2), repeat=len(fractions)))


def cells_and_fractions(p):
    cells = [np.floor(x) for x in p]
    return [c.astype(np.int64) for c in cells], [x - c for x, c in zip(p, cells)]


def perlin_at(kind, p, seed=np.int64(0)):
    cells, fractions = cells_and_fractions(p)
    return perlin(kind, words_at(kind, cells, seed), fractions)


def rotate(q):
    """See section 7."""
    q = list(q)
    for axis, (c, s) in enumerate(ROTATIONS[:len(q) - 1]):
        q[axis:axis + 2] = (c * q[axis] - s * q[axis + 1]) / 32, (s * q[axis] + c * q[axis + 1]) / 32
    return q


def fade_of_footprint(s, i):
    return 1.0 if s.footprint is None else np.clip(1.5 - s.footprint * max(s.lacunarity, 1) ** i, 0, 1)


def density(mean):
    t = np.clip(2 * mean + 0.25, 0, 1)
    return t * t * (3 - 2 * t)


# The value of a sum, from the mean of its octaves.
ENDS = {"": lambda mean: mean, "bounded": lambda mean: mean, "billows": lambda mean: 2 * mean - 1, "density": density}


def octaves(kind, s, p):
    """An octave sum (bounds.sums.Sum)."""
    count, seed, total, before, weight = max(math.ceil(s.octaves), 0), 0, 0.0, 0.5, 1.0
    powers, step, strength = [s.gain**i for i in range(count)], step_of(s.kind), clamped_strength(s)
    if count > 1:
        powers[-1] *= s.octaves - (count - 1)
    for i, power in enumerate(powers):
        n = perlin_at(kind, p, np.int64(seed))[0]
        if step.clamps:
            n = np.clip(n, -1, 1)
        term, before = step.term(n, before, strength)
        used = weight if name_of_step(s.kind) == "bent" else power * fade_of_footprint(s, i)
        total = total + used * term
        weight = weight * s.gain * (1 - strength * (1 - n) / 2)
        q = [x * s.lacunarity for x in p]
        p = [x + shift for x, shift in zip(rotate(q) if s.rotates else q, SHIFT)]
        seed = u32(seed + 0x9E3779B9)
    return ENDS[CATALOG[s.kind].mean](total / sum(powers) if count else np.zeros(np.shape(p[0])))
