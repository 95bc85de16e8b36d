"""Tests of the consumed bits: how often each value comes, alone and with its neighbours, everywhere and in parts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measure.hashes.judgement import Finding, chi_square, normal
from measure.hashes.lattice import Lattice, neighbours, shifted

WINDOW = 8   # bits: 256 bins. Windows start every four bits, so that each run of five bits is whole in one
PAIR = 6     # bits of each of two neighbours: 4096 bins
NUMBER = np.arange(22, 14, -1)  # the high bits of a word's number, which value noise takes
BLOCK = {2: 32, 3: 16}  # cells along the side of a block: 1024 blocks of 1024 cells, 512 of 4096
CHUNK = 1 << 16         # cells whose bits are spread out at a time


def spread_bits(words: np.ndarray, bits: np.ndarray) -> np.ndarray:
    """The given bits of words along a new last axis, as bytes of 0 and 1."""
    return (words[..., None] >> bits.astype(np.uint32) & 1).astype(np.uint8)


def fields(bits: np.ndarray, width: int, step: int) -> list[int]:
    """Where a field of so many consumed bits may start, counted from the highest; the last ends at the lowest."""
    last = max(len(bits) - width, 0)
    return sorted({*range(0, last, step), last})


def field(lattice: Lattice, start: int, width: int) -> np.ndarray:
    return lattice.values >> np.uint32(len(lattice.bits) - width - start) & np.uint32((1 << width) - 1)


def values(lattice: Lattice) -> list[Finding]:
    """Chi-square of fields of consumed bits."""
    width = min(WINDOW, len(lattice.bits))
    starts = fields(lattice.bits, width, WINDOW // 2)
    counts = [np.bincount(field(lattice, start, width).reshape(-1), minlength=1 << width) for start in starts]
    return [chi_square("chi-square of values", counts, lambda i: f"bits {lattice.bits[starts[i]]} and below")]


def pairs(lattice: Lattice) -> list[Finding]:
    """Chi-square of the values of neighbours: the highest and the lowest consumed bits of each."""
    width = min(PAIR, len(lattice.bits))
    ends = {"low": field(lattice, len(lattice.bits) - width, width)}
    if width < len(lattice.bits):
        ends["high"] = field(lattice, 0, width)
    counts, names = [], []
    for offset in neighbours(lattice.dimensions):
        for a, first in ends.items():
            for b, second in ends.items():
                both = first << np.uint32(width) | shifted(second, offset)
                counts.append(np.bincount(both.reshape(-1), minlength=1 << 2 * width))
                names.append(f"{a} and {b} bits, offset {offset}")
    return [chi_square("chi-square of neighbours", counts, lambda i: names[i])]


def numbers(lattice: Lattice) -> list[Finding]:
    """The same of what value noise takes of a word, and where it is weak in a part of the window."""
    lattice = replace(lattice, bits=NUMBER)
    findings = values(lattice) + pairs(lattice) + local(lattice)
    for finding in findings:
        finding.test = f"numbers: {finding.test}"
    return findings


def bit_products(words: np.ndarray, others: np.ndarray, bits: np.ndarray) -> np.ndarray:
    """For each pair of bits, how many standard deviations the bits of words agree with those of others too often."""
    total = np.zeros((len(bits), len(bits)))
    words, others = words.reshape(-1), others.reshape(-1)
    for start in range(0, words.size, CHUNK):
        a, b = (1 - 2 * spread_bits(w[start:start + CHUNK], bits).astype(np.float32) for w in (words, others))
        total += a.T @ b  # integers below 2^24: exact in floats
    return total / np.sqrt(words.size)


def bit_pairs(lattice: Lattice) -> list[Finding]:
    """Each consumed bit with each other of the same word, and with each of the neighbours' words."""
    within = bit_products(lattice.words, lattice.words, lattice.bits)
    np.fill_diagonal(within, 0)
    offsets = neighbours(lattice.dimensions)
    z = np.stack([within] + [bit_products(lattice.words, shifted(lattice.words, o), lattice.bits) for o in offsets])
    places = ["in a word", *(f"offset {offset}" for offset in offsets)]
    return [normal("pairs of bits", z, lattice.words.size,
                   lambda o, i, j: f"bits {lattice.bits[i]} and {lattice.bits[j]}, {places[o]}")]


def quads(lattice: Lattice) -> list[Finding]:
    """Second differences over the corners of rectangles, by exclusive or and by subtraction: 0 for a linear key."""
    values, z, names = lattice.values, [], []
    for a in range(lattice.dimensions):
        for b in range(a + 1, lattice.dimensions):
            # Below half of the window: there, the corners of a rectangle are those of three others.
            for step in (1 << k for k in range((min(values.shape) // 2 - 1).bit_length())):
                along_a, along_b = np.roll(values, -step, a), np.roll(values, -step, b)
                corner = np.roll(along_a, -step, b)
                for way, mixed in (("xor", values ^ along_a ^ along_b ^ corner),
                                   ("difference", values - along_a - along_b + corner)):
                    z.append(_bias(mixed, len(lattice.bits)))
                    names.append(f"{way} over {step} along {'xyz'[a]} and {'xyz'[b]}")
    return [normal("rectangles", np.array(z), lattice.words.size, lambda i, bit: f"bit {bit} of the {names[i]}")]


def _bias(values: np.ndarray, bits: int) -> np.ndarray:
    """For each of the low bits, lowest first, how many standard deviations it is set too often."""
    ones = np.array([np.count_nonzero(values & np.uint32(1 << bit)) for bit in range(bits)])
    return (2 * ones - values.size) / np.sqrt(values.size)


def local(lattice: Lattice) -> list[Finding]:
    """Each consumed bit in every block, row and column: how often it is set, and how often it is as the next one is."""
    size = min(BLOCK[lattice.dimensions], min(lattice.words.shape))
    sums: dict[str, np.ndarray] = {}
    samples = size ** lattice.dimensions
    cut = [n - n % size for n in lattice.words.shape]
    window = tuple(slice(0, n) for n in cut)
    for name, words in _local_words(lattice):
        blocks = words[window].reshape([k for n in cut for k in (n // size, size)])
        ones = np.stack([(blocks >> np.uint32(bit) & 1).sum(axis=tuple(range(1, blocks.ndim, 2)), dtype=np.int64)
                         for bit in lattice.bits], axis=-1)
        sums[name] = (2 * ones - samples) / np.sqrt(samples)
    names, z = list(sums), np.stack(list(sums.values()))
    return [normal("blocks", z, samples,
                   lambda i, *at: f"{names[i]}, bit {lattice.bits[at[-1]]}, block {','.join(map(str, at[:-1]))}",
                   pool=False),
            lines(lattice)]


def _local_words(lattice: Lattice):
    yield "set", lattice.words
    for axis in range(lattice.dimensions):
        yield f"as the next along {'xyz'[axis]}", lattice.words ^ np.roll(lattice.words, -1, axis)


def lines(lattice: Lattice) -> Finding:
    """For each axis, each value of its coordinate and each bit: of the cells with that coordinate, how many have it."""
    scores, names = [], []
    for axis in range(lattice.dimensions):
        rest = tuple(a for a in range(lattice.dimensions) if a != axis)
        count = lattice.words.size // lattice.words.shape[axis]
        for bit in lattice.bits:
            ones = (lattice.words >> np.uint32(bit) & 1).sum(axis=rest, dtype=np.int64)
            scores.append((2 * ones - count) / np.sqrt(count))
            names += [f"{'xyz'[axis]} = {line}, bit {bit}" for line in range(len(ones))]
    return normal("lines", np.concatenate(scores), lattice.words.size // max(lattice.words.shape), lambda i: names[i],
                  pool=False)
