"""docs/contract.md on arrays, with LATTICE: the fixed arithmetic in integers that wrap as the contract says, and the
exact noise and octave sums in doubles. Written from that page alone, for bounds_fixed_test.py."""

import math

import numpy as np

from bounds.boxes import corners
from bounds.gradients import SINE
from bounds.noises.perlin.exact import SCALE

SHIFT = (11 / 32, 19 / 32, 23 / 32)


def u32(x):
    return x & 0xFFFFFFFF


def s32(x):
    return ((x + 2**31) & 0xFFFFFFFF) - 2**31


def mix(k):
    for shift, factor in ((15, 0x2C1B3C6D), (12, 0x297A2D39)):
        k = u32((k ^ (k >> shift)) * factor)
    return k ^ (k >> 15)


def lattice_word(cells, seed):
    """The word of a lattice point (docs/contract.md, section 3, with LATTICE)."""
    spread = [u32(u32(c) * prime) for c, prime in zip(cells, (0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D))]
    spread[0] = u32(spread[0] + 0x165667B1)
    join = total = mix(seed)
    for word, shift in zip(spread, (18, 17, 19)):
        join, total = join ^ word ^ (word >> shift), u32(total + word)
    return u32(join * u32(2 * total + 1))


def hash_word(word):
    return mix(lattice_word([word], np.int64(0)))


def gradient_parts(dims, h):
    """(a, m) in units of 2^-9, (p, q, m) in units of 2^-8."""
    if dims == 2:
        parts, one = [2 * ((h >> 22) & 511) - 511], 512
    else:
        parts, one = [2 * ((h >> 23) & 255) - 255, 2 * ((h >> 15) & 255) - 255], 256
    m = one - np.maximum.reduce([abs(part) for part in parts])
    return [*parts, np.where(h >> 31, -m, m)]


def sine_words(cells, seed):
    words = [hash_word(u32(cells[0])) ^ mix(seed)]
    for c in cells[1:]:
        words.append(hash_word(u32(words[-1] + c)))
    return [u32(words[-1] + word) for word in words]


def sine_argument(w):
    """The word as a signed integer of 24 significant bits."""
    return s32(w).astype(np.float32).astype(np.int64)


def fixed_sine(w):
    argument = sine_argument(w)
    m = abs(argument)
    high, low = m >> 16, m & 0xFFFF
    turns = u32(m * 0x28BE60DB + high * 0x9391 + (u32(high * 0x054A + low * 0x9391) >> 16))
    q = turns & 0x7FFFFFFF
    x = np.minimum((np.minimum(q, 0x80000000 - q) + 2**13) >> 14, 65535)
    u = u32(x * x) >> 16
    y = u32(102943 - (u32(u * (42328 - (u32(u * (5208 - ((u * 288) >> 16))) >> 16))) >> 16))
    g = u32(x * (y >> 1) + 2**14) >> 15
    return np.where((turns >> 31) ^ (u32(w) >> 31), -g, g)


def parts_at(kind, cells, seed):
    if kind is SINE:
        return [fixed_sine(w) for w in sine_words(cells, seed)]
    return gradient_parts(len(cells), lattice_word(cells, seed))


def exact_gradient(kind, parts):
    if len(parts) == 2:
        return [part / 512 for part in parts]
    p, q, m = (part / 256 for part in parts)
    return [(p + q) / 2, (p - q) / 2, m]


def exact_at(kind, cells, seed):
    if kind is SINE:
        return [np.sin(sine_argument(w).astype(float)) for w in sine_words(cells, seed)]
    return exact_gradient(kind, gradient_parts(len(cells), lattice_word(cells, seed)))


def fixed_fade(f):
    g = np.minimum(f, 2**20 - f)
    x = np.minimum(g + 4, 2**19 - 1) >> 3
    s = u32(x * x)
    z = u32(s + 2**15) >> 16
    r = u32(1572864 - 30 * x + 6 * z) >> 2
    q = u32(s + (u32(z * r) >> 2) + 2**15) >> 16
    t = u32(x * q + 2**14) >> 15
    return np.where(f > 2**19, 2**18 - t, t)


def fixed_lerp(a, b, t):
    d = s32(b - a)
    return s32(a + s32(s32((d >> 9) * (t >> 9)) + s32((d >> 18) * (t & 511))))


def fixed_ramp(kind, parts, offsets):
    if kind is SINE:
        return s32(sum(s32((g >> 8) * d) + (((g & 255) * d) >> 8) for g, d in zip(parts, offsets)))
    if len(parts) == 2:
        return s32(s32(parts[0] * offsets[0]) + s32(parts[1] * offsets[1]))
    (p, q, m), (x, y, z) = parts, offsets
    return s32(s32(s32(p * (x + y)) + s32(q * (x - y))) + s32(m * 2 * z))


def fixed_noise(kind, parts_of, fractions):
    """v, in units of 2^-21; `parts_of` maps a corner to its gradient's."""
    dims = len(fractions)
    values = [fixed_ramp(kind, parts_of(corner), [f - o * 2**20 for f, o in zip(fractions, corner)])
              for corner in (reverse[::-1] for reverse in corners(dims))]  # so that x varies fastest
    for f in fractions:
        t = fixed_fade(f)
        values = [fixed_lerp(a, b, t) for a, b in zip(values[::2], values[1::2])]
    if kind is SINE:
        return values[0] >> 7
    return s32((s32(values[0] + 256) >> 9) * {2: 1913, 3: 1819}[dims] + 256) >> 9


def exact_noise(kind, gradient_of, fractions):
    total = 0.0
    s = [f**3 * (f * (f * 6 - 15) + 10) for f in fractions]
    for corner in corners(len(fractions)):
        weight = math.prod(x if o else 1 - x for x, o in zip(s, corner))
        total = total + weight * sum(g * (f - o) for g, f, o in zip(gradient_of(corner), fractions, corner))
    return SCALE[kind][len(fractions)] * total


def moved(cells, corner):
    return [c + o for c, o in zip(cells, corner)]


def fixed_noise_at_cell(kind, cells, fractions, seed=np.int64(0)):
    return fixed_noise(kind, lambda corner: parts_at(kind, moved(cells, corner), seed), fractions)


def fixed_noise_at(kind, p):
    """The fixed noise at a position of floats."""
    c = [np.trunc(x) for x in p]
    k = [np.trunc((x - whole) * 2.0**20).astype(np.int64) for x, whole in zip(p, c)]
    cells = [whole.astype(np.int64) + (part >> 20) for whole, part in zip(c, k)]
    return fixed_noise_at_cell(kind, cells, [part & (2**20 - 1) for part in k])


def exact_noise_at(kind, p, seed=np.int64(0)):
    cells = [np.floor(x) for x in p]
    whole = [c.astype(np.int64) for c in cells]
    return exact_noise(kind, lambda corner: exact_at(kind, moved(whole, corner), seed),
                       [x - c for x, c in zip(p, cells)])


def fixed_position(x):
    """The cell and the fraction in units of 2^-32."""
    c = np.trunc(x)
    u = np.trunc(abs(x - c) * 2.0**32).astype(np.int64)
    below = x - c < 0
    return c.astype(np.int64) - (below & (u > 0)), np.where(below, u32(-u), u)


def fixed_step(cell, r, ratio, shift):
    """(cell 2^32 + r) L / 2^23 + shift: the cells' part has no fraction, as 2^32 / 2^23 is whole."""
    total = cell * ratio * 2**9 + ((r * ratio) >> 23) + int(shift * 2**32)
    return s32(total >> 32), u32(total)


def weights(octaves, gain):
    g, all_of_them = math.trunc(gain * 2**18), [2**18]
    for _ in range(octaves - 1):
        a = all_of_them[-1]
        all_of_them.append(((a >> 9) * g + (((a & 511) * g) >> 9)) >> 9)
    return all_of_them


def fixed_octaves(kind, name, p, octaves, lacunarity, gain):
    ratio, position, total, seed = math.trunc(lacunarity * 2**23), [fixed_position(x) for x in p], 0, 0
    for a in weights(octaves, gain):
        v = fixed_noise_at_cell(kind, [cell for cell, _ in position], [r >> 12 for _, r in position], np.int64(seed))
        v = abs(v) if name == "turbulence" else v
        total = total + (s32(s32(v * (a >> 9)) + s32((v >> 9) * (a & 511))) >> 9)
        position = [fixed_step(cell, r, ratio, shift) for (cell, r), shift in zip(position, SHIFT)]
        seed = (seed + 0x9E3779B9) & 0xFFFFFFFF
    total = total * 2**18
    v = np.sign(total) * (abs(total) // sum(weights(octaves, gain)))
    return fixed_clouds(v) if name == "clouds" else v


def fixed_clouds(v):
    c = (np.clip(2 * v + 2**19, 0, 2**21) - 2**20) >> 5
    return 2**20 + (s32(c * (u32(0xC0000000 - u32(c * c)) >> 16)) >> 10)


def exact_octaves(kind, name, p, octaves, lacunarity, gain):
    value, total, seed = 0.0, sum(gain**i for i in range(octaves)), 0
    for i in range(octaves):
        n = exact_noise_at(kind, p, np.int64(seed))
        value = value + gain**i / total * (abs(n) if name == "turbulence" else n)
        p = [x * lacunarity + shift for x, shift in zip(p, SHIFT)]
        seed = (seed + 0x9E3779B9) & 0xFFFFFFFF
    t = np.clip(2 * value + 0.25, 0, 1)
    return t * t * (3 - 2 * t) if name == "clouds" else value
