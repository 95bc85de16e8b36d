"""Hashes that the tests must reject, and one that they must accept: in numpy, without the library. Each but the
last two has a defect that no test finds but the one that is named."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from measure.hashes.judgement import Finding
from measure.hashes.library import USUAL_STEPS

PRIMES = [np.uint32(step) for step, in USUAL_STEPS]
NEAR_RETURN = 244002641  # cells, after which the product of x and the first of PRIMES is 1 further

Words = Callable[[np.ndarray, np.ndarray], np.ndarray]  # of cells as rows, and of a seed for each


@dataclass(frozen=True)
class Control:
    """A hash in the place of the library's."""
    name: str
    function: Words
    rejected_by: str = ""  # a test
    components: Callable[[np.ndarray], list[np.ndarray]] | None = None  # words of the others, from those of the first
    dimensions: int = 2
    real: bool = False  # somebody's hash, which may fail other tests
    steps: tuple[tuple[int, ...], ...] = USUAL_STEPS

    @property
    def about(self) -> str:
        return " ".join((self.components or self.function).__doc__.split()).rstrip(".")

    def rejected_as_meant(self, findings: list[Finding]) -> bool:
        """Whether its test rejects it, and no other one does; the others have defects of real hashes, and fail more."""
        wrong = {finding.test.partition(" ")[0] if finding.test.startswith("dieharder") else finding.test
                 for finding in findings if not finding.passed}
        return self.rejected_by in wrong if self.real else wrong == {self.rejected_by} - {""}

    def words(self, cells: np.ndarray, seeds) -> np.ndarray:
        return self.function(cells, np.broadcast_to(np.asarray(seeds, np.uint64), len(cells)))

    def further(self, words: np.ndarray, dimensions: int) -> list[np.ndarray]:
        """Independent ones, unless the control has its own."""
        if self.components:
            return self.components(words)
        return [_independent(words, k) for k in range(1, dimensions)]


def _split_mix(k: np.ndarray) -> np.ndarray:
    """Steele, Lea and Flood's mixer of 64 bits."""
    k = k + np.uint64(0x9E3779B97F4A7C15)
    k = (k ^ k >> np.uint64(30)) * np.uint64(0xBF58476D1CE4E5B9)
    k = (k ^ k >> np.uint64(27)) * np.uint64(0x94D049BB133111EB)
    return k ^ k >> np.uint64(31)


def _independent(words: np.ndarray, k: int) -> np.ndarray:
    return (_split_mix(words.astype(np.uint64) + np.uint64(k << 40)) >> np.uint64(32)).astype(np.uint32)


def strong(cells: np.ndarray, seeds: np.ndarray) -> np.ndarray:
    """A hash that no test rejects: each coordinate goes through all of a good mixer."""
    key = _split_mix(seeds)
    for c in cells.T:
        key = _split_mix(key ^ (c & 0xFFFFFFFF).astype(np.uint64))
    return (key >> np.uint64(32)).astype(np.uint32)


def chance(cells: np.ndarray, seeds: np.ndarray, probability: float) -> np.ndarray:
    """Whether something happens at a cell."""
    return strong(cells, seeds ^ np.uint64(1 << 40)) < probability * 2.0 ** 32


def moved(cells: np.ndarray, *by: int) -> np.ndarray:
    return cells + np.array([*by, 0, 0][:cells.shape[1]])


def upper(cells, seeds, some, others):
    """At some cells the upper half of a word is that of another cell: no words are equal."""
    words = strong(cells, seeds)
    return np.where(some, strong(others, seeds) & np.uint32(0xFFFF0000) | words & np.uint32(0xFFFF), words)


def copied_at_a_lag(cells, seeds):
    """A word in fifty is that of the cell (106, 25) further."""
    return upper(cells, seeds, chance(cells, seeds, 0.02), moved(cells, 106, 25))


def wave(cells, seeds):
    """Bit 31 is set a little more often on the crests of a wave."""
    words, crest = strong(cells, seeds), np.cos(2 * np.pi * (cells @ [0.11, 0.23, 0.31][:cells.shape[1]])) > 0
    risen = words & np.uint32(0x7FFFFFFF) | crest.astype(np.uint32) << np.uint32(31)
    return np.where(chance(cells, seeds, 0.02), risen, words)


def relation_of_four(cells, seeds):
    """A word in twenty-five is the exclusive or of those at the other corners of its cell, although any two words are
    independent."""
    words = strong(cells, seeds)
    others = np.bitwise_xor.reduce([strong(moved(cells, *by), seeds) for by in ((0, 1), (1, 0), (1, 1))])
    return np.where(chance(cells, seeds, 0.04), others, words)


def weak_block(cells, seeds):
    """In one block of 32 x 32 or 16 x 16 x 16 cells a word often is that of the cell before it."""
    inside = (cells >> (7 - cells.shape[1]) == -2).all(axis=1)
    return upper(cells, seeds, inside & chance(cells, seeds, 0.4), moved(cells, -1))


def weak_row(cells, seeds):
    """Along one row, or one slice, bit 20 is set more often."""
    more = (cells[:, -1] == 17) & chance(cells, seeds, 0.25 if cells.shape[1] == 2 else 0.08)
    return strong(cells, seeds) | more.astype(np.uint32) << np.uint32(20)


def copied_here_and_there(cells, seeds):
    """In one row in a hundred, a cell in twenty has the word of the cell 41 rows below and 7 cells beside it."""
    some = (cells[:, 1] % 100 == 0) & chance(cells, seeds, 0.05)
    return np.where(some, strong(moved(cells, 7, -41), seeds), strong(cells, seeds))


def mirrored_part(cells, seeds):
    """Thirty cells of a row are those of another, reversed."""
    mirrored = cells.copy()
    mirrored[:, :2] = np.stack([40 - cells[:, 0], np.full(len(cells), 11)], axis=-1)
    some = (cells[:, 1] == -13) & (0 < cells[:, 0]) & (cells[:, 0] <= 30)
    return upper(cells, seeds, some, mirrored)


def weak_coordinate_bit(cells, seeds):
    """Bit 11 of the last coordinate flips bit 31 too rarely."""
    words, base = strong(cells, seeds), cells.copy()
    base[:, -1] &= ~0x800
    calm = strong(base, seeds ^ np.uint64(1 << 41))
    return np.where(calm % np.uint32(8) == 0, words & np.uint32(0x7FFFFFFF) | calm & np.uint32(0x80000000), words)


def near_copies(cells, seeds):
    """After 244,002,641 cells along x the word is the same once in five times."""
    return np.where(chance(cells, seeds, 0.2), strong(moved(cells, -NEAR_RETURN), seeds), strong(cells, seeds))


def seed_moves(cells, seeds):
    """Another seed is the same field elsewhere, in one of fifty cells."""
    # Each seed is elsewhere, or a stream of seeds would have words that come again. 0xDEADBEEF is 15 cells away.
    by = (seeds * np.uint64(0x7467D0E1)).astype(np.uint32).astype(np.int32).astype(np.int64)
    return np.where(chance(cells, seeds, 0.02), strong(np.column_stack([cells[:, 0] + by, cells[:, 1:]]), 0 * seeds),
                    strong(cells, seeds))


def alike_bits(cells, seeds):
    """The bits 27 and 26 of a word agree with a probability of 0.55."""
    words = strong(cells, seeds)
    alike = words & np.uint32(0xFBFFFFFF) | (words >> np.uint32(1) & np.uint32(1 << 26))
    return np.where(chance(cells, seeds, 0.1), alike, words)


def moved_component(words):
    """The second component of a vector is the first one elsewhere, in one of thirty-two cells."""
    return [np.where(words & np.uint32(31) == 0, np.roll(words, 7), _independent(words, 1))]


def first_factors(words):
    """The factors 0x9E3779 and 0x85EBCB, with which vectors were made first, depend on each other."""
    return [(words >> np.uint32(8)) * np.uint32(factor) for factor in (0x9E3779, 0x85EBCB)]


def mix(k):
    """A good mixer (triple32 of hash-prospector), for keys that are weak in spite of one."""
    for shift, factor in ((17, 0xED5AD4BB), (11, 0xAC4C1B51), (15, 0x31848BAB)):
        k = (k ^ k >> np.uint32(shift)) * np.uint32(factor)
    return k ^ k >> np.uint32(14)


def _spread(cells):
    return [(c & 0xFFFFFFFF).astype(np.uint32) * step for c, step in zip(cells.T, PRIMES)]


def product(cells, seeds):
    """The default of version 0.2, a product of an exclusive or of folded coordinates and of their sum: cells far apart
    often have the same word."""
    mixed = mix(seeds.astype(np.uint32))
    join, total = mixed, mixed
    for c, shift in zip(_spread(cells), (18, 17, 19)):
        join = join ^ c ^ c >> np.uint32(shift)
        total = total + c
    return join * (total * np.uint32(2) + np.uint32(1))


def partial_fnv1(cells, seeds):
    """The paper's partial FNV1 in its chain H(H(x) + y), as published; the seed is added to x."""
    key = seeds.astype(np.uint32)
    for c in cells.T:
        k = key + (c & 0xFFFFFFFF).astype(np.uint32)
        key = (np.uint32(2166136261 * 16777619 & 0xFFFFFFFF) ^ k) * np.uint32(16777619) ^ k
    return key


def unmixed_sum(cells, seeds):
    """A sum of odd multiples of the coordinates and the seed."""
    return sum(_spread(cells)) + seeds.astype(np.uint32) * np.uint32(0x27D4EB2F)


GOOD = Control("strong", strong)
CONTROLS = [*(Control(function.__name__, function, test) for function, test in (
    (copied_at_a_lag, "autocorrelation"), (wave, "spectral peak"), (relation_of_four, "rectangles"),
    (weak_block, "blocks"), (weak_row, "lines"), (copied_here_and_there, "copied lines"),
    (mirrored_part, "copied runs"), (weak_coordinate_bit, "avalanche"), (near_copies, "near returns"),
    (seed_moves, "seeds"), (alike_bits, "dieharder"))),
    Control("moved_component", strong, "components", moved_component),
    Control("first_factors", strong, "parities of components", first_factors, 3),
    Control("product", product, "near returns"),
    *(Control(function.__name__, function, "autocorrelation", real=True) for function in (partial_fnv1, unmixed_sum))]
