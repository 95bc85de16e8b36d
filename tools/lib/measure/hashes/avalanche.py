"""Tests that change one bit of a coordinate or of the seed, or go far along an axis, and look at the consumed bits."""

from __future__ import annotations

from typing import Callable

import numpy as np

from measure.hashes.bits import spread_bits
from measure.hashes.judgement import Finding, normal, poisson
from measure.hashes.lattice import Lattice, varying_bits
from measure.hashes.library import Twin

COORDINATE_BITS = 12   # coordinates in [0, 4096)
FAR = 24               # hn_perlin takes positions below 2^23 in magnitude: no two are further apart than 2^24 cells
CHUNK = 1 << 16

Words = Callable[[np.ndarray], np.ndarray]  # the words at cells


def flips(words: Words, cells: np.ndarray, changes: list[tuple[int, int]], bits: np.ndarray):
    """For each change (axis, bit of its coordinate): of each consumed bit how often it flips, and of each pair how
    often both do or both do not; as standard normal values."""
    before = words(cells)
    single = np.zeros((len(changes), len(bits)))
    double = np.zeros((len(changes), len(bits), len(bits)))
    for i, (axis, bit) in enumerate(changes):
        # Only from 0 to 1: from 1 to 0 it would be the same pairs of cells again, where both are among the cells.
        clear = (cells[:, axis] >> bit & 1) == 0
        other = cells[clear]
        other[:, axis] |= 1 << bit
        single[i], double[i] = _agreement(before[clear] ^ words(other), bits)
    return single, double


def _agreement(changed: np.ndarray, bits: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    single, double = np.zeros(len(bits)), np.zeros((len(bits), len(bits)))
    for start in range(0, changed.size, CHUNK):
        sign = 1 - 2 * spread_bits(changed[start:start + CHUNK], bits).astype(np.float32)
        single += sign.sum(axis=0, dtype=float)
        double += sign.T @ sign
    np.fill_diagonal(double, 0)
    return single / np.sqrt(changed.size), double / np.sqrt(changed.size)


def judge_flips(words: Words, cells: np.ndarray, width: int, bits: np.ndarray) -> list[Finding]:
    changes = [(axis, bit) for axis in range(cells.shape[1]) for bit in range(width)]
    single, double = flips(words, cells, changes, bits)

    def named(i):
        return f"{'xyz'[changes[i][0]]} bit {changes[i][1]}"

    # A probability of flipping is (1 - z / sqrt(n)) / 2; of about half of the cells the bit is clear.
    n = len(cells) // 2
    return [normal("avalanche", single, n, lambda i, j: f"{named(i)} to bit {bits[j]}", 0.5 / np.sqrt(n)),
            normal("avalanche: pairs", double, n, lambda i, j, k: f"{named(i)} to bits {bits[j]} and {bits[k]}",
                   0.5 / np.sqrt(n))]


def of_twin(twin: Twin, dimensions: int, seed: int, count: int) -> list[Finding]:
    """Avalanche at so many random cells of [0, 4096)^n, all different, for each bit that is clear there."""
    places = np.unique(np.random.default_rng(dimensions).integers(0, 1 << COORDINATE_BITS * dimensions, 2 * count))
    cells = np.stack([places >> COORDINATE_BITS * axis & (1 << COORDINATE_BITS) - 1 for axis in range(dimensions)], -1)
    findings = judge_flips(lambda c: twin.words(c, seed), cells, COORDINATE_BITS, twin.consumed(dimensions))
    return _at(findings, f"seed {seed}")


def of_window(lattice: Lattice) -> list[Finding]:
    """The same in a window of words: its cells, and as many bits of a coordinate as stay in it."""
    size = min(lattice.words.shape)
    width = size.bit_length() - 1
    cells = np.stack(np.meshgrid(*[np.arange(1 << width)] * lattice.dimensions, indexing="ij"), axis=-1)
    cells = cells.reshape(-1, lattice.dimensions)
    return judge_flips(lambda c: lattice.words[tuple(c.T)], cells, width, lattice.bits)


def of_seeds(twin: Twin, dimensions: int, count: int) -> list[Finding]:
    """How often each consumed bit flips with each bit of the seed."""
    rng = np.random.default_rng(16 + dimensions)
    cells = rng.integers(0, 1 << COORDINATE_BITS, (count, dimensions))
    seeds = rng.integers(0, 1 << 32, count, np.uint32)
    bits = twin.consumed(dimensions)
    before = twin.words(cells, seeds)
    z = np.stack([_agreement(before ^ twin.words(cells, seeds ^ np.uint32(1 << bit)), bits)[0] for bit in range(32)])
    return [normal("seeds: avalanche", z, count, lambda i, j: f"seed bit {i} to bit {bits[j]}", 0.5 / np.sqrt(count))]


def far(twin: Twin, dimensions: int, seed: int, count: int) -> list[Finding]:
    """Random cells against those a power of two further along an axis or all: equal words, and bits that agree."""
    cells = np.random.default_rng(32 + dimensions).integers(-(1 << 23), 1 << 23, (count, dimensions))
    bits = twin.consumed(dimensions)
    before = twin.words(cells, seed)
    z, names, equal = [], [], 0
    directions = np.concatenate([np.eye(dimensions, dtype=int), np.ones((1, dimensions), int)])
    for direction in directions:
        for power in range(FAR + 1):
            changed = before ^ twin.words(cells + (direction << power), seed)
            z.append(_agreement(changed, bits)[0])
            names.append(f"2^{power} along {'+'.join(a for a, d in zip('xyz', direction) if d)}")
            equal += int(np.count_nonzero(changed == 0))
    pairs = count * len(names)
    return _at([normal("far pairs", np.array(z), count, lambda i, j: f"bit {bits[j]}, {names[i]}", 1 / np.sqrt(count)),
                poisson("far pairs: equal words", equal, pairs * 2.0 ** -varying_bits(before), pairs)], f"seed {seed}")


def _at(findings: list[Finding], where: str) -> list[Finding]:
    for finding in findings:
        finding.where = f"{finding.where}, {where}" if finding.where else where
    return findings
