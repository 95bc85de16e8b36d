"""Lattices that the tests must reject, and random ones that they must accept: in numpy, without the library."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np

from measure.hashes import isotropy
from measure.hashes.directions import GRADIENTS as OWN
from measure.hashes.lattice import Lattice, cells_of
from measure.hashes.library import Twin

Shape = tuple[int, ...]

# Gradients take the bits 31, 22 and 21 in the plane and in space.


def random(shape: Shape, seed: int = 0) -> np.ndarray:
    """Independent words, by Philox."""
    return np.random.Generator(np.random.Philox(seed)).integers(0, 1 << 32, shape, np.uint32)


def _cells(shape: Shape) -> list[np.ndarray]:
    return [c.astype(np.uint32).reshape(shape) for c in cells_of((0,) * len(shape), shape).T]


def mix(k: np.ndarray) -> np.ndarray:
    """A good mixer (triple32 of hash-prospector), for keys that are weak in spite of one."""
    for shift, factor in ((17, 0xED5AD4BB), (11, 0xAC4C1B51), (15, 0x31848BAB)):
        k = (k ^ k >> np.uint32(shift)) * np.uint32(factor)
    return k ^ k >> np.uint32(14)


PRIMES = [np.uint32(p) for p in (0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D)]  # xxHash's, odd multiples as anybody would take


def linear_sum(shape: Shape) -> np.ndarray:
    """A sum of multiples of the coordinates, unmixed."""
    return sum(c * p for c, p in zip(_cells(shape), PRIMES))


def linear_xor(shape: Shape) -> np.ndarray:
    """An exclusive or of linear functions over bits, unmixed."""
    key = np.zeros(shape, np.uint32)
    for c, p in zip(_cells(shape), PRIMES):
        for bit in range(32):
            key ^= (c >> np.uint32(bit) & 1) * (p << np.uint32(bit) ^ p >> np.uint32(31 - bit))
    return key


def mixed_sum(shape: Shape) -> np.ndarray:
    """A sum of small multiples, mixed well: cells on a line across have the same key."""
    return mix(sum(c * np.uint32(m) for c, m in zip(_cells(shape), (1, 7, 49))))


def _partial_fnv1(k: np.ndarray) -> np.ndarray:
    return (np.uint32(2166136261 * 16777619 & 0xFFFFFFFF) ^ k) * np.uint32(16777619) ^ k


def partial_fnv1(shape: Shape) -> np.ndarray:
    """The paper's partial FNV1 in its chain H(H(x) + y), as published."""
    key = np.uint32(0)
    for c in _cells(shape):
        key = _partial_fnv1(key + c)
    return key


def _pcg(k: np.ndarray) -> np.ndarray:
    s = k * np.uint32(747796405) + np.uint32(2891336453)
    w = (s >> (s >> np.uint32(28)) + np.uint32(4) ^ s) * np.uint32(277803737)
    return w >> np.uint32(22) ^ w


def chain(shape: Shape) -> np.ndarray:
    """H(H(x') + y') with PCG, mixed: good words, but in this window a column is a copy of another, moved. The window is
    one in which the keys of two columns differ by a small multiple of what a step along y adds."""
    step, inverse = PRIMES[1], np.uint32(pow(int(PRIMES[1]), -1, 1 << 32))
    for start in range(0, 1 << 20, shape[0]):
        columns = _pcg(np.arange(start, start + shape[0], dtype=np.uint32) * PRIMES[0])
        steps = np.sort(columns * inverse)  # how many steps along y each column is from the key 0
        if np.diff(steps).min() < shape[-1] // 4:
            break
    return mix(_pcg(columns[:, None] + np.arange(shape[-1], dtype=np.uint32) * step))


def fract_sin(shape: Shape) -> np.ndarray:
    """The one-liner of unknown origin, fract(sin(dot(p, (12.9898, 78.233))) * 43758.5453), in 32-bit floats; its 24
    bits are the high ones of a word."""
    factors = (12.9898, 78.233, 37.719)
    dot = sum(c.astype(np.float32) * np.float32(f) for c, f in zip(_cells(shape), factors))
    value = np.sin(dot) * np.float32(43758.5453)
    return ((value - np.floor(value)).astype(float) * 2 ** 32).astype(np.uint64).clip(0, 2 ** 32 - 1).astype(np.uint32)


def stuck_bit(shape: Shape) -> np.ndarray:
    """A bit that is always set."""
    return random(shape) | np.uint32(1 << 22)


def biased_bit(shape: Shape) -> np.ndarray:
    """A bit that only value noise takes is set with a probability of 0.515."""
    rare = np.random.default_rng(1).random(shape) < 0.03
    return random(shape) | rare.astype(np.uint32) << np.uint32(19)


def copied_line(shape: Shape) -> np.ndarray:
    """A row is another, moved by two cells."""
    words = random(shape)
    words[(shape[0] // 3,) * (len(shape) - 1)] = np.roll(words[(5,) * (len(shape) - 1)], 2)
    return words


def copied_part(shape: Shape) -> np.ndarray:
    """Thirty cells of a row are those of another."""
    words = random(shape)
    words[(shape[0] // 3,) * (len(shape) - 1) + (slice(20, 50),)] = words[(5,) * (len(shape) - 1) + (slice(0, 30),)]
    return words


def copied_high_bits(shape: Shape) -> np.ndarray:
    """The high 18 bits of a row, which gradients use, are those of another row, moved by two cells."""
    words = random(shape)
    low = np.uint32(0x3FFF)
    line, other = (shape[0] // 3,) * (len(shape) - 1), (5,) * (len(shape) - 1)
    words[line] = np.roll(words[other], 2) & ~low | words[line] & low
    return words


def opposite_bits(shape: Shape) -> np.ndarray:
    """In one stripe of eight, bit 31 is that of four cells before, inverted, and bit 22 the same, as it is."""
    words = random(shape)
    before = np.roll(words, 4, 0) ^ np.uint32(1 << 31)
    high = np.uint32(1 << 31 | 1 << 22)
    stripe = (np.arange(shape[0]) % 8 >= 4).reshape(-1, *(1,) * (len(shape) - 1))
    return np.where(stripe, words & ~high | before & high, words)


def alike_bits(shape: Shape) -> np.ndarray:
    """Two bits of a word agree with a probability of 0.51."""
    words = random(shape)
    some = np.random.default_rng(1).random(shape) < 0.02
    alike = words & np.uint32(0xFFDFFFFF) | (words >> np.uint32(22) & 1) << np.uint32(21)
    return np.where(some, alike, words)


def mirrored_line(shape: Shape) -> np.ndarray:
    """A row is another, reversed."""
    words = random(shape)
    words[(shape[0] // 3,) * (len(shape) - 1)] = words[(5,) * (len(shape) - 1)][::-1]
    return words


def mirrored_quadrant(shape: Shape) -> np.ndarray:
    """A quadrant is the opposite one, reflected in the middle."""
    words = random(shape)
    half = tuple(slice(0, n // 2) for n in shape)
    other = tuple(slice(n - 1, n - n // 2 - 1, -1) for n in shape)
    words[other] = words[half]
    return words


def transposed(shape: Shape) -> np.ndarray:
    """The same with the first two axes exchanged."""
    words = random(shape)
    swapped = words.swapaxes(0, 1)
    x, y = _cells(shape)[:2]
    return np.where(x < y, words, swapped)


def period(shape: Shape) -> np.ndarray:
    """Repeats after half of the window along its last axis."""
    words = random(shape)
    words[..., shape[-1] // 2:] = words[..., :shape[-1] // 2]
    return words


def nudged(shape: Shape) -> np.ndarray:
    """A hundredth of the directions is nudged to one side."""
    words = random(shape)
    some = np.random.default_rng(1).random(shape) < 0.01
    return np.where(some, words & np.uint32(0x3FFFFFFF), words)


def correlated_part(shape: Shape) -> np.ndarray:
    """In one block of 32 x 32 (or 16^3) cells a cell often has the word of the one before it."""
    words = random(shape)
    size = 32 if len(shape) == 2 else 16
    block = words[(slice(size, 2 * size),) * len(shape)]
    again = np.random.default_rng(1).random(block.shape) < 0.4
    again[..., 0] = False
    block[again] = np.roll(block, 1, -1)[again]
    return words


def equal_neighbours(shape: Shape) -> np.ndarray:
    """One word in a hundred is that of the neighbour."""
    words = random(shape)
    return np.where(np.random.default_rng(1).random(shape) < 0.01, np.roll(words, 1, 0), words)


def counter(shape: Shape) -> np.ndarray:
    """All different, in random order: too even, as a counter is that has been mixed."""
    return mix(np.arange(int(np.prod(shape)), dtype=np.uint32).reshape(shape))


# Each control with the tests that must reject it.
WINDOWS: dict[str, tuple[Callable[[Shape], np.ndarray], tuple[str, ...]]] = {
    "linear_sum": (linear_sum, ("autocorrelation", "spectral peak", "rectangles")),
    "linear_xor": (linear_xor, ("rectangles",)),
    "mixed_sum": (mixed_sum, ("equal words", "copied runs")),
    "partial_fnv1": (partial_fnv1, ("autocorrelation", "avalanche", "avalanche: pairs")),
    "fract_sin": (fract_sin, ("autocorrelation",)),
    "stuck_bit": (stuck_bit, ("chi-square of values", "lines", "numbers: lines")),
    "biased_bit": (biased_bit, ("numbers: chi-square of values",)),
    "copied_high_bits": (copied_high_bits, ("copied runs",)),
    "opposite_bits": (opposite_bits, ("autocorrelation of bits",)),
    "copied_line": (copied_line, ("copied lines",)),
    "copied_part": (copied_part, ("copied runs",)),
    "alike_bits": (alike_bits, ("pairs of bits",)),
    "mirrored_line": (mirrored_line, ("copied lines",)),
    "mirrored_quadrant": (mirrored_quadrant, ("copied lines", "copied runs")),
    "transposed": (transposed, ("copied runs",)),
    "period": (period, ("autocorrelation", "autocorrelation of bits")),
    "nudged": (nudged, ("directions: frequencies",)),
    "correlated_part": (correlated_part, ("blocks", "numbers: blocks")),
    "equal_neighbours": (equal_neighbours, ("chi-square of neighbours", "numbers: chi-square of neighbours",
                                            "equal words")),
    "counter": (counter, ("equal words",)),
    "chain": (chain, ("copied lines",)),
}
ONLY_2D = {"chain", "counter"}
# In a smaller window too few equal words are expected to miss them, and a nudge is too small for one of its tests.
FULL_SIZE = {"counter", "nudged"}


def as_the_library(shape: Shape) -> np.ndarray:
    """The gradients of the library."""
    return np.random.default_rng(2).choice(OWN[len(shape)], shape)


def diagonals(shape: Shape) -> np.ndarray:
    """Gradients along the diagonals alone, 4 or 8 of them."""
    return np.random.default_rng(2).choice([-1.0, 1.0], (*shape, len(shape)))


def on_circle(shape: Shape) -> np.ndarray:
    """Gradients of length 1 in uniform directions."""
    points = np.random.default_rng(2).normal(size=(*shape, len(shape)))
    return points / np.linalg.norm(points, axis=-1, keepdims=True)


GRADIENTS: dict[str, tuple[Callable[[Shape], np.ndarray], tuple[str, ...]]] = {
    "as_the_library": (as_the_library, ()),
    "on_circle": (on_circle, ("directions: others",)),
    "diagonals": (diagonals, ("isotropy", "directions: others")),
}
# Windows of as many blocks as isotropy takes, or more.
GRADIENT_SHAPES = {2: (512, 512), 3: (64, 64, 64)}


def of_gradients(gradients: np.ndarray) -> Lattice:
    """A lattice of gradients that belong to no words."""
    return Lattice(np.zeros(gradients.shape[:-1], np.uint32), gradients.astype(np.float32), np.empty(0, int))


@dataclass
class Function(Twin):
    """A hash in numpy in the place of the library's: for the tests that choose their cells and seeds."""
    function: Callable[[np.ndarray, np.ndarray], np.ndarray] = None

    def words(self, cells, seeds):
        seeds = np.broadcast_to(np.asarray(seeds, np.uint32), len(cells))
        return self.function((cells.astype(np.int64) & 0xFFFFFFFF).astype(np.uint64), seeds.astype(np.uint64))

    def gradients(self, cells, seeds):
        return self.stage(self.words(cells, seeds), cells.shape[1])

    def noise(self, positions, seed):
        """The noise of its own gradients (else it would be the library's): the ramps of all corners, by their weights."""
        cells = np.floor(positions)
        place = positions - cells
        fade = isotropy.fade(place)
        values = np.zeros(len(positions))
        for corner in np.ndindex((2,) * positions.shape[1]):
            ramps = (self.gradients(cells + corner, seed) * (place - corner)).sum(axis=-1)
            values += ramps * np.where(corner, fade, 1 - fade).prod(axis=-1)
        return values


def strong(cells: np.ndarray, seeds: np.ndarray) -> np.ndarray:
    """A hash that no test rejects: each coordinate goes through all of SplitMix64's mixer."""
    key = _split_mix(seeds)
    for c in cells.T:
        key = _split_mix(key ^ c)
    return (key >> np.uint64(32)).astype(np.uint32)


def _split_mix(k: np.ndarray) -> np.ndarray:
    k = k + np.uint64(0x9E3779B97F4A7C15)
    k = (k ^ k >> np.uint64(30)) * np.uint64(0xBF58476D1CE4E5B9)
    k = (k ^ k >> np.uint64(27)) * np.uint64(0x94D049BB133111EB)
    return k ^ k >> np.uint64(31)


def _moved(cells: np.ndarray, by: np.ndarray) -> np.ndarray:
    """The cells, moved along x."""
    moved = cells.copy()
    moved[:, 0] = moved[:, 0] + by & np.uint64(0xFFFFFFFF)
    return moved


def seed_moves(cells, seeds):
    """Another seed is the same field elsewhere."""
    return strong(_moved(cells, seeds), 0 * seeds)


def seed_permutes(cells, seeds):
    """Another seed is the same field with its columns exchanged."""
    cells = cells.copy()
    cells[:, 0] ^= seeds
    return strong(cells, 0 * seeds)


def seed_flips(cells, seeds):
    """The seed is added by exclusive or at the end."""
    return strong(cells, 0 * seeds) ^ seeds.astype(np.uint32)


def seed_loses_a_bit(cells, seeds):
    """A bit of the seed has no effect."""
    return strong(cells, seeds & np.uint64(0xFFFEFFFF))


def seeds_are_alike(cells, seeds):
    """A word is that of the other seed once in fifty times."""
    same = strong(cells, 0 * seeds + np.uint64(99)) % np.uint32(50) == 0
    return np.where(same, strong(cells, 0 * seeds), strong(cells, seeds))


def far_period(cells, seeds):
    """Repeats after 2^20 cells."""
    return strong(cells & np.uint64(0xFFFFF), seeds)


def weak_coordinate_bit(cells, seeds):
    """Bit 11 of the last coordinate flips bit 31 a little too rarely."""
    words = strong(cells, seeds)
    base = cells.copy()
    base[:, -1] &= np.uint64(0xFFFFF7FF)
    calm = strong(base, seeds ^ np.uint64(1))
    return np.where(calm % np.uint32(25) == 0, words & np.uint32(0x7FFFFFFF) | calm & np.uint32(0x80000000), words)


def product(cells, seeds):
    """The product of an exclusive or of folded coordinates and of their sum, the default of version 0.2: cells far
    apart often have the same word."""
    mixed = mix(seeds.astype(np.uint32))
    spread = [c.astype(np.uint32) * step for c, step in zip(cells.T, PRIMES)]
    join, total = mixed, mixed
    for c, shift in zip(spread, (18, 17, 19)):
        join = join ^ c ^ c >> np.uint32(shift)
        total = total + c
    return join * (total * np.uint32(2) + np.uint32(1))


NEAR_RETURN = 244002641  # cells, after which the product of x and the first of PRIMES is 1 further


def near_copies(cells, seeds):
    """After 244,002,641 cells along x the word is the same once in five times, and nothing else is wrong."""
    back = _moved(cells, np.full(len(cells), (1 << 32) - NEAR_RETURN, np.uint64))
    same = strong(cells, seeds ^ np.uint64(1 << 40)) % np.uint32(5) == 0
    return np.where(same, strong(back, seeds), strong(cells, seeds))


NEAR_RETURNS = ("near returns", "near returns: gradients", "near returns: equal words")

FUNCTIONS: dict[str, tuple[Callable, tuple[str, ...]]] = {
    "seed_moves": (seed_moves, ("seeds: correlation", "seeds: common words", "seeds: common runs")),
    "seed_permutes": (seed_permutes, ("seeds: common words", "seeds: common runs")),
    "seed_flips": (seed_flips, ("seeds: avalanche", "seeds: pairs of bits")),
    "seed_loses_a_bit": (seed_loses_a_bit, ("seeds: avalanche",)),
    "seeds_are_alike": (seeds_are_alike, ("seeds: correlation", "seeds: common words")),
    "far_period": (far_period, ("far pairs", "far pairs: equal words")),
    "weak_coordinate_bit": (weak_coordinate_bit, ("avalanche",)),
    "product": (product, NEAR_RETURNS),
    "near_copies": (near_copies, NEAR_RETURNS),
}


# Words of the further components of vectors in space, from those of the first. Factors are those of the good bits.

def _times(words: np.ndarray, *factors: int) -> list[np.ndarray]:
    return [(words >> np.uint32(8)) * np.uint32(factor) for factor in factors]


def _good(words: np.ndarray, seed: int) -> np.ndarray:
    """Words of 24 random bits that have nothing to do with others."""
    return random(words.shape, seed) & np.uint32(0xFFFFFF00)


def independent(words: np.ndarray) -> list[np.ndarray]:
    """Components that do not depend on each other."""
    return [_good(words, 100), _good(words, 101)]


def first_factors(words: np.ndarray) -> list[np.ndarray]:
    """The factors 0x9E3779 and 0x85EBCB, with which vectors were made first. 256 times the first one is nearly a
    multiple of 2^32 over the golden ratio; and the factors depend on each other."""
    return _times(words, 0x9E3779, 0x85EBCB)


def factor_of_one(words: np.ndarray) -> list[np.ndarray]:
    """The factors 1 and 3."""
    return _times(words, 1, 3)


def same_factor(words: np.ndarray) -> list[np.ndarray]:
    """The same factor for y and z."""
    return _times(words, 0xC2B2AF, 0xC2B2AF)


def three_times(words: np.ndarray) -> list[np.ndarray]:
    """The factor of z is three times that of y, modulo 2^24."""
    return _times(words, 0x85EBCB, 0x91C361)


def rotated(words: np.ndarray) -> list[np.ndarray]:
    """The word, rotated by 8 bits and by 16."""
    return [words << np.uint32(turn) | words >> np.uint32(32 - turn) for turn in (8, 16)]


def sum_of_two(words: np.ndarray) -> list[np.ndarray]:
    """x + y + z is a multiple of 2^32, and any two of them are independent."""
    y = _good(words, 100)
    return [y, np.uint32(0) - words - y]


def xor_of_two(words: np.ndarray) -> list[np.ndarray]:
    """z is the exclusive or of x and y."""
    y = _good(words, 100)
    return [y, words ^ y]


def moved_component(words: np.ndarray) -> list[np.ndarray]:
    """y is x elsewhere."""
    return [np.roll(words, (3, -1, 5), (0, 1, 2)), _good(words, 100)]


def few_words(words: np.ndarray) -> list[np.ndarray]:
    """The further words are made of 20 bits."""
    return [mix(words >> np.uint32(12)), mix(words >> np.uint32(12) ^ np.uint32(0xABCDE000))]


def alike_vectors(name: str, positions: np.ndarray, seed: int, twin: Twin) -> np.ndarray:
    """The noises of a vector are the same noise, moved by one and a half cells for each."""
    return np.stack([twin.vectors(name, positions + 1.5 * k, seed)[:, 0] for k in range(positions.shape[1])], -1)


COMPONENTS: dict[str, tuple[Callable[[np.ndarray], list[np.ndarray]], tuple[str, ...]]] = {
    "independent": (independent, ()),
    "first_factors": (first_factors, ("three components: parities",)),
    "factor_of_one": (factor_of_one, ("one component: chi-square of values",)),
    "same_factor": (same_factor, ("components: correlation", "components: correlation of numbers",
                                  "components: pairs of bits", "components: common runs")),
    "three_times": (three_times, ("two components: numbers", "two components: waves")),
    "rotated": (rotated, ("two components: gradients", "two components: parities", "components: pairs of bits")),
    "sum_of_two": (sum_of_two, ("three components: numbers", "three components: waves")),
    "xor_of_two": (xor_of_two, ("three components: gradients", "three components: parities")),
    "moved_component": (moved_component, ("components: correlation", "components: correlation of numbers",
                                          "components: common runs")),
    "few_words": (few_words, ("one component: equal words",)),
}
# Their windows are so large that they show how the first factors depend on each other.
COMPONENT_SHAPE = (128, 64, 64)
VECTORS = {"alike_vectors": (alike_vectors, ("components: value noise", "components: perlin noise"))}


@dataclass
class Vectors(Twin):
    """The library, with other vectors."""
    others: Callable[[str, np.ndarray, int, Twin], np.ndarray] = None

    def vectors(self, name, positions, seed):
        return self.others(name, positions, seed, super())
