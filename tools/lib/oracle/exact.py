"""The oracle: every value that hashnoise defines, computed a second time.

Written from docs/contract.md alone, in plain Python, so that it shares neither code nor assumptions with the
library. Words are Python integers masked to 32 bits. Sections 2 to 4 of the contract are exact in the library too; the
noise is exact only here, in rational arithmetic. (A sine is irrational: here it is off by less than SINE_ERROR, far too
little to change the double nearest to it.) Where the contract gives a formula, that formula is what stands here, even
where a shader would do something faster.

A `name` is that of a hash in sections 2 to 4, and of a configuration in sections 5 to 7: see Configuration. Section 8,
the same in integers, is fixed.py.
"""

from __future__ import annotations

import functools
import itertools
import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

MASK = 0xFFFFFFFF

# xxHash's primes 1 to 5; a lattice point is spread by them too.
PRIMES = (0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D, 0x27D4EB2F, 0x165667B1)


# --- Section 2: word hashes -------------------------------------------------------------------------------------


def rotl(word: int, count: int) -> int:
    """The word rotated left by `count` bits, 0 < count < 32."""
    return (word << count | word >> (32 - count)) & MASK


def word_bytes(word: int) -> bytes:
    """The four bytes of a word, byte 0 (the least significant) first."""
    return word.to_bytes(4, "little")


def fnv1(items: Iterable[int]) -> int:
    """FNV-1, 32 bit, of a byte string. (The partial hash feeds it words instead of bytes.)"""
    h = 2166136261
    for item in items:
        h = (h * 16777619 & MASK) ^ item
    return h


def one_at_a_time(items: Iterable[int]) -> int:
    """Jenkins' one-at-a-time hash of a byte string. (The partial hash feeds it a word instead of bytes.)"""
    h = 0
    for item in items:
        h = (h + item) & MASK
        h = (h + (h << 10)) & MASK
        h ^= h >> 6
    h = (h + (h << 3)) & MASK
    h ^= h >> 11
    return (h + (h << 15)) & MASK


def xxh32(data: bytes, seed: int = 0) -> int:
    """XXH32 of a byte string shorter than one stripe (16 bytes), by steps 1 and 4 to 6 of its specification."""
    if len(data) >= 16:
        raise ValueError("longer inputs go through the stripes, which are not implemented")
    p1, p2, p3, p4, p5 = PRIMES
    lanes_end = len(data) // 4 * 4
    h = (seed + p5 + len(data)) & MASK
    for i in range(0, lanes_end, 4):
        h = (h + int.from_bytes(data[i:i + 4], "little") * p3) & MASK
        h = rotl(h, 17) * p4 & MASK
    for byte in data[lanes_end:]:
        h = (h + byte * p5) & MASK
        h = rotl(h, 11) * p1 & MASK
    h = (h ^ h >> 15) * p2 & MASK
    h = (h ^ h >> 13) * p3 & MASK
    return h ^ h >> 16


def murmur(word: int) -> int:
    """The paper's Murmur: MurmurHash2's body for one word, from the state 10, without the final avalanche."""
    m = 1540483477
    k = word * m & MASK
    k ^= k >> 24
    k = k * m & MASK
    return (10 * m & MASK) ^ k


def pcg(word: int) -> int:
    """Jarzynski and Olano's pcg_hash: one step of O'Neill's 32-bit LCG, then the output function RXS-M-XS."""
    s = (word * 747796405 + 2891336453) & MASK
    w = (s >> ((s >> 28) + 4) ^ s) * 277803737 & MASK
    return w >> 22 ^ w


def custom(word: int) -> int:
    """The user-defined hash that the conformance suite itself brings, as its HN_HASH_FN."""
    return (word ^ word >> 16) * 0x045D9F3B & MASK


WORD_HASHES: dict[str, Callable[[int], int]] = {
    "fnv1": lambda word: fnv1(word_bytes(word)),
    "partial_fnv1": lambda word: fnv1((word, word)),
    "jenkins": lambda word: one_at_a_time(word_bytes(word)),
    "partial_jenkins": lambda word: one_at_a_time((word,)),
    "murmur": murmur,
    "pcg": pcg,
    "xxhash32": lambda word: xxh32(word_bytes(word)),
    "custom": custom,
}

HASHES = ("fnv1", "partial_fnv1", "jenkins", "partial_jenkins", "murmur", "pcg", "xxhash32", "lattice", "custom")


# --- Section 3: several words, and a lattice point --------------------------------------------------------------


def mix(k: int) -> int:
    """The mixer, "prospector32"."""
    k = (k ^ k >> 15) * 0x2C1B3C6D & MASK
    k = (k ^ k >> 12) * 0x297A2D39 & MASK
    return k ^ k >> 15


def chain(name: str, words: Sequence[int]) -> int:
    """The paper's chain of one to four words under the word hash `name`."""
    k = 0
    for word in words:
        # For the first word k is still 0, so that the chain begins with H(x).
        k = WORD_HASHES[name]((k + word) & MASK)
    return k


def spread(point: Sequence[int]) -> list[int]:
    """The coordinates x', y', z', w' (signed ones count as two's complement)."""
    # Only x has a summand: it keeps the origin, which the factors alone would leave 0, from a word of 0.
    offsets = (PRIMES[4], 0, 0, 0)
    return [(x * prime + offset) & MASK for x, prime, offset in zip(point, PRIMES, offsets)]


# How far each spread coordinate is shifted to fold it.
FOLDS = (18, 17, 19, 20)


def fold(words: Sequence[int]) -> list[int]:
    """The words X, Y, Z, W of the spread coordinates."""
    return [word ^ word >> shift for word, shift in zip(words, FOLDS)]


def point_word(name: str, point: Sequence[int], seed: int = 0) -> int:
    """The word of a lattice point under the hash `name`."""
    s = mix(seed)
    coordinates = spread(point)
    j = s
    for folded in fold(coordinates):
        j ^= folded
    m = (2 * (sum(coordinates) + s) + 1) & MASK
    hashed = j if name == "lattice" else WORD_HASHES[name](j)
    return hashed * m & MASK


def hash_words(name: str, words: Sequence[int]) -> int:
    """hn_hash: with a word hash the chain as published, neither spread nor mixed."""
    return lattice(name, words) if name == "lattice" else chain(name, words)


def lattice(name: str, point: Sequence[int], seed: int = 0) -> int:
    """hn_lattice: the seeded and mixed hash of a lattice point."""
    return mix(point_word(name, point, seed))


# --- Section 4: from a hash to a float --------------------------------------------------------------------------


def unorm(h: int) -> float:
    """hn_unorm: in [0, 1)."""
    return (h >> 8) / 2**24


def snorm(h: int) -> float:
    """hn_snorm: in [-1, 1)."""
    return (h >> 8) / 2**23 - 1


def middle(i: int, count: int) -> float:
    """The middle of interval i of `count` equal ones of [-1, 1]: the contract's `a`, `p` and `q`."""
    return (2 * i + 1) / count - 1


def gradient2(h: int) -> tuple[float, float]:
    """hn_gradient2: a point of the square |x| + |y| = 1."""
    a = middle(h >> 22 & 511, 512)
    m = 1 - abs(a)
    return (a, -m if h >> 31 else m)


def gradient3(h: int) -> tuple[float, float, float]:
    """hn_gradient3: a point of the octahedron |x| + |y| + |z| = 1."""
    p = middle(h >> 23 & 255, 256)
    q = middle(h >> 15 & 255, 256)
    m = 1 - max(abs(p), abs(q))
    return ((p + q) / 2, (p - q) / 2, -m if h >> 31 else m)


# --- Section 5: the gradient at a lattice point -----------------------------------------------------------------

# From here on every value is exact: a real number, as a fraction. Who prints one rounds it, once.
Real = Fraction | float


@dataclass(frozen=True)
class Configuration:
    """What the noise depends on besides its arguments: HN_HASH, HN_GRADIENT (octahedral or sine) and HN_PERIOD.

    HN_ARITHMETIC says only how it is computed: to the functions of this file `fixed` is nothing.
    """
    hash: str
    sine: bool = False
    period: int = 0  # 0: none
    fixed: bool = False

    def __post_init__(self) -> None:
        power_of_two = self.period & (self.period - 1) == 0
        if self.hash not in HASHES or not 0 <= self.period <= (2**30 if power_of_two else 2**20):
            raise ValueError(f"no configuration of the library: {self}")


@functools.cache
def configuration(name: str) -> Configuration:
    """The configuration of a name: the hash, then "+sine", "+period<N>", "+fixed" where they apply, in this order."""
    match = re.fullmatch(r"(\w+)(\+sine)?(?:\+period([1-9][0-9]*))?(\+fixed)?", name, re.ASCII)
    if not match:
        raise ValueError(f"not a name of a configuration: {name}")
    return Configuration(match[1], match[2] is not None, int(match[3] or 0), match[4] is not None)


def signed(word: int) -> int:
    """The signed integer of a word (two's complement); of a larger integer, that of its low 32 bits."""
    return (word + 2**31 & MASK) - 2**31


def wrapped(coordinate: int, period: int) -> int:
    """A coordinate of a cell, moved into [0, period) if there is a period."""
    # The far corner of the cell at INT_MAX is at 2^31: it wraps where there is no period.
    return coordinate - period * (coordinate // period) if period else signed(coordinate)


def round24(n: int) -> int:
    """The number of 24 significant bits that is nearest to n, ties to even."""
    step = 2 ** max(n.bit_length() - 24, 0)
    return round(Fraction(n, step)) * step  # Python rounds a fraction half to even


# The fixed point of the sine. PI is off by less than 2^9 units (16 times 1/2 for each of its 42 terms, little more),
# and reducing an arc of 2^31 takes it less than 2^30 times: 2^39 units. That leaves nearly three times a double's bits.
SINE_BITS = 192
SINE_ERROR = Fraction(1, 2**150)


def arctan_inverse(n: int) -> int:
    """arctan(1 / n) in fixed point, by its series."""
    power, total, i = 2**SINE_BITS // n, 0, 0
    while power:
        total += (-1)**i * (power // (2 * i + 1))
        power, i = power // n**2, i + 1
    return total


PI = 4 * (4 * arctan_inverse(5) - arctan_inverse(239))  # Machin's formula


@functools.cache
def sine(n: int) -> Fraction:
    """The sine of n radians, -2^31 <= n <= 2^31, off by less than SINE_ERROR."""
    one = 2**SINE_BITS
    half_turns = (n * one + PI // 2) // PI
    x = n * one - half_turns * PI  # in [-pi/2, pi/2]
    term, total, i = x, 0, 1
    while term:
        total += term
        term, i = -term * x * x // (one * one * (i + 1) * (i + 2)), i + 2
    return Fraction(total if half_turns % 2 == 0 else -total, one)


def sine_of_word(w: int) -> Fraction:
    """The contract's S(w)."""
    return sine(round24(signed(w)))


def sine_arguments(name: str, cell: Sequence[int], seed: int) -> list[int]:
    """The words of which the paper's gradient, in 2D or 3D, takes the sine, under the hash `name`."""
    chained = [hash_words(name, [cell[0] & MASK]) ^ mix(seed)]
    for c in cell[1:]:
        chained.append(hash_words(name, [(chained[-1] + c) & MASK]))
    return [(chained[-1] + word) & MASK for word in chained]


# By the number of dimensions.
OCTAHEDRAL: dict[int, Callable[[int], tuple[float, ...]]] = {2: gradient2, 3: gradient3}


def gradient(name: str, cell: Sequence[int], seed: int = 0) -> tuple[Real, ...]:
    """hn_gradient in 2D or 3D."""
    knobs = configuration(name)
    point = [wrapped(c, knobs.period) for c in cell]
    if knobs.sine:
        return tuple(sine_of_word(word) for word in sine_arguments(knobs.hash, point, seed))
    return OCTAHEDRAL[len(cell)](point_word(knobs.hash, point, seed))


# --- Section 6: Perlin noise ------------------------------------------------------------------------------------

OCTAHEDRAL_SCALES = {2: Fraction(1913, 1024), 3: Fraction(1819, 1024)}


def scale(name: str, n: int) -> Fraction:
    """The factor of the weighted sum in n dimensions."""
    return Fraction(1) if configuration(name).sine else OCTAHEDRAL_SCALES[n]


def smooth(t: Fraction) -> Fraction:
    """s(t), the weight of the far corner along one axis."""
    return 6 * t**5 - 15 * t**4 + 10 * t**3


def perlin_cell(name: str, cell: Sequence[int], fraction: Sequence[Real], seed: int = 0) -> Fraction:
    """hn_perlin(cell, f, seed) in 2D or 3D, as the contract's weighted sum over the corners."""
    f = [Fraction(x) for x in fraction]
    near_and_far = [(1 - smooth(x), smooth(x)) for x in f]
    total = Fraction(0)
    for corner in itertools.product((0, 1), repeat=len(f)):
        point = [c + o for c, o in zip(cell, corner)]
        ramp = sum(Fraction(g) * (x - o) for g, x, o in zip(gradient(name, point, seed), f, corner))
        total += ramp * math.prod(weights[o] for weights, o in zip(near_and_far, corner))
    return total * scale(name, len(f))


def perlin(name: str, p: Sequence[Real], seed: int = 0) -> Fraction:
    """hn_perlin(p, seed) in 2D or 3D."""
    cell = [math.floor(x) for x in p]
    return perlin_cell(name, cell, [Fraction(x) - c for x, c in zip(p, cell)], seed)


# --- Section 7: octave sums -------------------------------------------------------------------------------------

SHIFT = (Fraction(11, 32), Fraction(19, 32), Fraction(23, 32))


def octave_terms(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real,
                 seed: int) -> list[tuple[Fraction, Fraction]]:
    """The weight and the noise of each octave."""
    terms = []
    q = [Fraction(x) for x in p]
    for i in range(octaves):
        terms.append((Fraction(gain)**i, perlin(name, q, seed)))
        q = [x * Fraction(lacunarity) + shift for x, shift in zip(q, SHIFT)]
        seed = (seed + 0x9E3779B9) & MASK
    return terms


def weighted_mean(terms: Sequence[tuple[Fraction, Fraction]]) -> Fraction:
    """sum(weight * value) / sum(weight); 0 for no terms."""
    if not terms:
        return Fraction(0)
    total = sum((weight * value for weight, value in terms), Fraction(0))
    return total / sum(weight for weight, _ in terms)


def fbm(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int = 0) -> Fraction:
    """hn_fbm: in the range of the noise."""
    return weighted_mean(octave_terms(name, p, octaves, lacunarity, gain, seed))


def turbulence(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int = 0) -> Fraction:
    """hn_turbulence: from 0 to the largest the noise can be."""
    terms = octave_terms(name, p, octaves, lacunarity, gain, seed)
    return weighted_mean([(weight, abs(value)) for weight, value in terms])


def clouds(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int = 0) -> Fraction:
    """hn_clouds: in [0, 1]."""
    t = min(max(2 * fbm(name, p, octaves, lacunarity, gain, seed) + Fraction(1, 4), Fraction(0)), Fraction(1))
    return t * t * (3 - 2 * t)
