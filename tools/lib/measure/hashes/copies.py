"""Tests for what comes twice: words, and runs of cells that are copies of others, shifted, mirrored or turned."""

from __future__ import annotations

import numpy as np
from scipy import stats

from measure.hashes.judgement import Finding, peak, poisson, two_tails
from measure.hashes.lattice import Lattice

# Bits that a run has at least. A window has 2^21 runs in the plane and 2^22.5 in space. A run is equal to the reverse
# of one that begins in it where a part of their line is a palindrome. A palindrome takes half as many bits, and such
# pairs come in clusters: each palindrome may have a longer one around it. Of 3 bits for a cell, 80 bits are 27 cells,
# and a palindrome of them is equal in 14 pairs of cells: 2^(21 - 42) are expected, and two pairs at once come hardly
# ever. With 50 bits it would be 2^(21 - 27), and a random lattice would fail once in 2^11 windows, by three pairs at
# once.
RUN_BITS = 80
# Odd multipliers that make one word of a run: those of SplitMix64 (Steele, Lea and Flood, 2014), which spread well.
MULTIPLIER = np.uint64(0xBF58476D1CE4E5B9)
FINISH = np.uint64(0x94D049BB133111EB)


def equal_pairs(values: np.ndarray) -> int:
    """How many pairs of equal values there are."""
    ordered = np.sort(values, axis=None)
    edges = np.flatnonzero(np.diff(ordered)) + 1
    lengths = np.diff(np.concatenate([[0], edges, [ordered.size]]))
    return int((lengths * (lengths - 1) // 2).sum())


def run_length(bits: int) -> int:
    """Cells of a run: at least three, so that two runs through the same cell are not already half equal."""
    return max(3, -(-RUN_BITS // bits))


def run_keys(values: np.ndarray, length: int) -> np.ndarray:
    """A 64-bit word for each run of cells along each axis; a run and its reverse have the same."""
    keys = []
    for axis in range(values.ndim):
        count = values.shape[axis] - length + 1
        cells = [np.take(values, range(i, i + count), axis).astype(np.uint64) for i in range(length)]
        keys.append(np.minimum(_fold(cells), _fold(cells[::-1])).reshape(-1))
    return np.concatenate(keys)


def _fold(cells: list[np.ndarray]) -> np.ndarray:
    key = np.zeros_like(cells[0])
    for cell in cells:
        key = (key + cell) * MULTIPLIER
        key ^= key >> np.uint64(31)
    return key * FINISH


def expected_runs(runs: int, others: int, length: int, bits: int, dimensions: int) -> float:
    """How many pairs of equal runs a random lattice has: twice the chance of a pair, since one may be reversed. Pairs
    that cross in the same place of both need one equation less, a run and a reversed one further along the same line
    one for each two cells. (An upper bound: near the edges there are fewer of these.)"""
    chance = 2.0 * 2.0 ** -min(64, length * bits)
    if others:
        return runs * others * chance
    crossed = (dimensions - 1) * length * 2.0 ** -min(64, (length - 1) * bits)
    mirrored = sum(2.0 ** -((length + further) // 2 * bits) for further in range(1, length))
    return runs * ((runs - 1) / 2 * chance + crossed + mirrored)


def duplicates(lattice: Lattice) -> list[Finding]:
    """Pairs of equal words, of equal consumed bits, and of equal runs."""
    return words(lattice) + consumed(lattice)


def consumed(lattice: Lattice) -> list[Finding]:
    """The same without the words: what of them is consumed."""
    n, bits = lattice.words.size, len(lattice.bits)
    findings = []
    chance = 2.0 ** -bits
    if bits < 32:
        # Counting pairs is the chi-square over all values: sum of (count - n chance)^2 / (n chance), which has
        # 2^bits - 1 degrees of freedom if every value is expected often; else pairs are rare, and so Poisson.
        count = equal_pairs(lattice.values)
        if n * chance >= 5:
            findings.append(two_tails("equal values", (2 * count + n) / (n * chance) - n, stats.chi2(2 ** bits - 1), n))
        else:
            findings.append(poisson("equal values", count, n * (n - 1) / 2 * chance, n))
    return findings + [runs(lattice)]


def runs(lattice: Lattice) -> Finding:
    """Pairs of equal runs of cells, by their consumed bits."""
    bits = len(lattice.bits)
    length = run_length(bits)
    keys = run_keys(lattice.values, length)
    expected = expected_runs(keys.size, 0, length, bits, lattice.dimensions)
    return poisson("copied runs", equal_pairs(keys), expected, keys.size, f"runs of {length} cells")


def words(lattice: Lattice) -> list[Finding]:
    """Equal words: how many pairs, and whether several of them are the same distance apart in the same two lines."""
    n = lattice.words.size
    first, second = pairs_of_equals(lattice.words)
    findings = [poisson("equal words", len(first), n * (n - 1) / 2 * 2.0 ** -lattice.varying, n)]
    for axis in range(lattice.dimensions):
        findings.append(_copied_lines(lattice, first, second, axis))
    return findings


def pairs_of_equals(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The places of each two cells that follow each other in order and are equal. (Of three that are equal, two pairs:
    these are too rare to matter, or so common that all of this fails.)"""
    values = values.reshape(-1)
    order = np.argsort(values, kind="stable")
    ordered = values[order]
    same = np.flatnonzero(ordered[1:] == ordered[:-1])
    return order[same], order[same + 1]


def _copied_lines(lattice: Lattice, first: np.ndarray, second: np.ndarray, axis: int) -> Finding:
    """The most pairs of equal words that one shift, or one reflection, of a line along the axis onto another makes."""
    shape = lattice.words.shape
    size, length = int(np.prod(shape)), shape[axis]
    lines = size // length
    at, line = [], []
    for cells in (first, second):
        index = list(np.unravel_index(cells, shape))
        at.append(index.pop(axis))
        line.append(np.ravel_multi_index(index, [n for a, n in enumerate(shape) if a != axis]))
    swap = line[0] > line[1]  # a pair is the same whichever of it comes first
    lines_key = np.minimum(*line).astype(np.int64) * lines + np.maximum(*line)
    shift = np.where(swap, at[0] - at[1], at[1] - at[0]) + length
    most = max((int(np.unique(lines_key * 4 * length + way, return_counts=True)[1].max())
                for way in (shift, at[0] + at[1] + 2 * length)), default=0) if len(first) else 0
    # Two lines, one laid onto the other: length shifts and length reflections, each with at most length pairs of words,
    # which are equal as rarely as any. With loc=1, sf is the probability of reaching a number, not of exceeding it.
    ways = lines * (lines + 1) // 2 * 2 * length
    return peak("copied lines", most, stats.poisson(length * 2.0 ** -lattice.varying, loc=1), length, ways,
                f"along {'xyz'[axis]}")


def average(counts: list[int], size: int, varying: int) -> Finding:
    """Whether windows have as many pairs of equal words on average as they should; by their own spread, since pairs may
    come together in some windows (then lines are copied) without being too many."""
    expected = size * (size - 1) / 2 * 2.0 ** -varying
    error = max(np.std(counts, ddof=1), np.sqrt(expected)) / np.sqrt(len(counts))
    return two_tails("equal words, windows on average", np.mean(counts) / expected,
                     stats.t(len(counts) - 1, 1, error / expected), len(counts))


def shared(a: np.ndarray, b: np.ndarray) -> int:
    """How many pairs of one value of a and one of b are equal."""
    values, counts = np.unique(a, return_counts=True)
    ordered = np.sort(b, axis=None)
    hits = np.searchsorted(ordered, values, "right") - np.searchsorted(ordered, values, "left")
    return int((hits * counts).sum())


def between(a: Lattice, b: Lattice) -> list[Finding]:
    """Common to two seeds: words anywhere, and runs of cells."""
    n = a.words.size
    return [poisson("seeds: common words", shared(a.words, b.words), n * b.words.size * 2.0 ** -a.varying, n),
            common_runs("seeds: common runs", a, b)]


def common_runs(test: str, a: Lattice, b: Lattice) -> Finding:
    """Pairs of equal runs of cells, one from each window, by their consumed bits."""
    bits = len(a.bits)
    length = run_length(bits)
    ours, theirs = run_keys(a.values, length), run_keys(b.values, length)
    expected = expected_runs(ours.size, theirs.size, length, bits, a.dimensions)
    return poisson(test, shared(ours, theirs), expected, ours.size, f"runs of {length} cells")
