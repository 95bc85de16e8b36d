"""Sections 2 and 3 of docs/reference/contract.md: hashes of words, and of lattice points; the published ones of section
18; and the words of vectors of section 22.

All values are words: Python integers masked to 32 bits. A `name` is a hash's.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

MASK = 0xFFFFFFFF

# xxHash's primes 1 to 5; a lattice point is spread by them too.
PRIMES = (0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D, 0x27D4EB2F, 0x165667B1)


# --- Section 2: word hashes --------------------------------------------------------------------------------------


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


# --- Section 3: several words, and a lattice point ---------------------------------------------------------------


def mix(k: int) -> int:
    """The mixer, "prospector32"."""
    k = (k ^ k >> 15) * 0x2C1B3C6D & MASK
    k = (k ^ k >> 12) * 0x297A2D39 & MASK
    return k ^ k >> 15


# Between the words of a series that are mixed, such as the seeds of octaves: 2^32 over the golden ratio.
SEED_STEP = 0x9E3779B9


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


# How far the spread coordinates and the mixed seed are shifted, so that their high bits are left.
SHIFTS, SEED_SHIFT = (12, 11, 10, 9), 8

# The factors of the low 24 bits of the spread coordinates after the first, in the sum A.
FACTORS = (0xE6133E, 0x913FDC, 0x85AAB8)

# The centre of a cell (section 13) has h', a spread coordinate that a corner does not have, and its shift.
CENTRE, CENTRE_SHIFT = PRIMES[4], 8


def high_bits(point: Sequence[int], seed: int = 0, centre: bool = False) -> int:
    """J of a lattice point; with `centre` for the centre of the cell `point`."""
    j = mix(seed) >> SEED_SHIFT
    for coordinate, shift in zip(spread(point), SHIFTS):
        j ^= coordinate >> shift
    return j ^ CENTRE >> CENTRE_SHIFT if centre else j


def weighted_sum(point: Sequence[int], seed: int = 0, centre: bool = False) -> int:
    """A, likewise."""
    first, *others = spread(point)
    a = first + mix(seed) + (CENTRE if centre else 0)
    for coordinate, factor in zip(others, FACTORS):
        a += coordinate % 2**24 * factor
    return a & MASK


def joins(point: Sequence[int], seed: int = 0, centre: bool = False) -> tuple[int, int]:
    """J and M, likewise."""
    m = (2 * weighted_sum(point, seed, centre) + 1) * 4097
    return high_bits(point, seed, centre), m % 2**24


def point_word(name: str, point: Sequence[int], seed: int = 0, centre: bool = False) -> int:
    """The word of a lattice point under the hash `name`; with `centre` for the centre of the cell `point`."""
    j, m = joins(point, seed, centre)
    if name == "lattice":
        return j * m & MASK
    h = (WORD_HASHES[name](j) * m + j) & MASK
    return h ^ h >> 9


def hash_words(name: str, words: Sequence[int]) -> int:
    """hn_hash: with a word hash the chain as published, neither spread nor mixed."""
    return lattice(name, words) if name == "lattice" else chain(name, words)


def lattice(name: str, point: Sequence[int], seed: int = 0) -> int:
    """hn_lattice: the seeded and mixed hash of a lattice point."""
    return mix((point_word(name, point, seed) + weighted_sum(point, seed)) & MASK)


def signed(word: int) -> int:
    """The signed integer of a word (two's complement); of a larger integer, the low 32 bits as one."""
    return (word + 2**31 & MASK) - 2**31


# --- Section 18: published hashes that are no choice of HN_HASH --------------------------------------------------


def lowbias32(word: int) -> int:
    """hn_hash_lowbias32."""
    word = (word ^ word >> 16) * 0x7FEB352D & MASK
    word = (word ^ word >> 15) * 0x846CA68B & MASK
    return word ^ word >> 16


def congruential(word: int) -> int:
    """The first step of all hashes of the pcg family below: the step of a generator, for each component."""
    return word * 1664525 + 1013904223 & MASK


def pcg2d(x: int, y: int) -> tuple[int, int]:
    """hn_hash_pcg2d."""
    x, y = congruential(x), congruential(y)
    for _ in range(2):
        x = x + y * 1664525 & MASK
        y = y + x * 1664525 & MASK
        x, y = x ^ x >> 16, y ^ y >> 16
    return x, y


def pcg3d(x: int, y: int, z: int) -> tuple[int, int, int]:
    """hn_hash_pcg3d."""
    def products(x: int, y: int, z: int) -> tuple[int, int, int]:
        x = x + y * z & MASK
        y = y + z * x & MASK
        return x, y, z + x * y & MASK

    x, y, z = products(congruential(x), congruential(y), congruential(z))
    return products(x ^ x >> 16, y ^ y >> 16, z ^ z >> 16)


def pcg4d(x: int, y: int, z: int, w: int) -> tuple[int, int, int, int]:
    """hn_hash_pcg4d."""
    def products(x: int, y: int, z: int, w: int) -> tuple[int, int, int, int]:
        x = x + y * w & MASK
        y = y + z * x & MASK
        z = z + x * y & MASK
        return x, y, z, w + y * z & MASK

    x, y, z, w = products(congruential(x), congruential(y), congruential(z), congruential(w))
    return products(x ^ x >> 16, y ^ y >> 16, z ^ z >> 16, w ^ w >> 16)


# --- Section 22: further words of a lattice point ------------------------------------------------------------------

# The factors of a vector's components after the first.
COMPONENT_FACTORS = (0xEB1831, 0x84A5E5)


def component_word(word: int, component: int) -> int:
    """The number that replaces the hash of a lattice point for a component of a vector; 0 for x."""
    return (word >> 8) * COMPONENT_FACTORS[component - 1] & MASK if component else word
