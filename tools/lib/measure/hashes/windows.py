"""Tests of a window of the lattice, in which all cells are compared with each other: at all distances, in blocks and
lines, and as copies. Windows wrap: the neighbour of the last cell is the first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from scipy import fft, linalg, stats

from measure.hashes.judgement import Finding, normal, peak, rare, worst

AXES = "xyz"
# The bits that are judged: noise uses these, and below them the low bits of the numbers of value noise.
BITS = tuple(range(31, 15, -1))
# By how many components a vector has, the bits of each that gradients and numbers use first: 12 at one point, since the
# components are made of the 24 good bits of one word, and nothing makes them independent to the last of these.
COMPONENT_BITS = {2: (31, 30, 22, 21, 29, 28), 3: (31, 30, 22, 21)}
BLOCK = {2: 32, 3: 16}  # cells along the side of a block
# Bits that a run of cells has at least. A run that begins in its own reverse is equal to it where half of the cells
# are a palindrome, which needs half as many bits.
RUN_BITS = 80
# Odd multipliers that make one word of a run: those of SplitMix64 (Steele, Lea and Flood, 2014), which spread well.
MULTIPLIER, FINISH = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)


@dataclass
class Window:
    words: np.ndarray  # uint32; axis 0 is x, and so on
    place: str
    bits: tuple[int, ...] = BITS  # that are judged, highest first and beside each other

    def signs(self, bit: int) -> np.ndarray:
        """A bit as -1 where it is set, and 1."""
        return 1 - 2 * (self.words >> np.uint32(bit) & np.uint32(1)).astype(np.float32)


def cells_of(origin: Sequence[int], shape: Sequence[int]) -> np.ndarray:
    """Every cell of a window as a row, the last axis fastest."""
    return np.indices(shape).reshape(len(shape), -1).T + np.array(origin)


def judge(window: Window) -> list[Finding]:
    found = [*fourier(window), rectangles(window), *parts(window), copied_runs([window])]
    return placed(found + [copied_lines(window)] * (window.bits == BITS), window.place)


def placed(findings: list[Finding], place: str) -> list[Finding]:
    return [replace(finding, where="; ".join(filter(None, (finding.where, place)))) for finding in findings]


# --- All distances at once, by Fourier transforms ---------------------------------------------------------------------

def fourier(window: Window) -> list[Finding]:
    """The correlation of each bit with itself at all lags, and the strongest wave in it. A bit that is set too often
    is a wave of the frequency 0."""
    shape, bits = window.words.shape, len(window.bits)
    real = _self_inverse(shape)
    found = []
    for bit in window.bits:
        power = np.abs(fft.rfftn(window.signs(bit))) ** 2 / window.words.size  # of mean 1
        z = fft.irfftn(power, s=shape) * np.sqrt(window.words.size)
        z[real] /= np.sqrt(2)  # where a lag is its own opposite each product is in the sum twice
        z.flat[0] = 0
        found.append(normal("autocorrelation", z, lambda *lag: f"bit {bit}, lag {_signed(lag, shape)}", bits))
        # Powers are exponential; where the transform is real they are squares of normal values, and are replaced by
        # the exponential value that is as improbable.
        alone = real[..., :power.shape[-1]]
        power[alone] = -stats.norm.logsf(np.sqrt(power[alone])) - np.log(2)
        at = np.unravel_index(np.argmax(power), power.shape)
        found.append(peak("spectral peak", power[at], stats.expon(), power.size * bits,
                          f"bit {bit}, frequency {_signed(at, shape)}"))
    return worst(found)


def crossed(test: str, a: Window, b: Window) -> Finding:
    """The correlation of each bit of two windows at all shifts, and reflected."""
    found = []
    for bit in a.bits:
        first, second = (fft.rfftn(window.signs(bit)) for window in (a, b))
        for how, product in (("shifted by", first.conj() * second), ("reflected in", first * second)):
            z = fft.irfftn(product, s=a.words.shape) / np.sqrt(a.words.size)
            found.append(normal(test, z, lambda *lag: f"bit {bit}, {how} {_signed(lag, z.shape)}", 2 * len(a.bits)))
    return placed(worst(found), f"{a.place}, and {b.place}")[0]


def _self_inverse(shape: tuple[int, ...]) -> np.ndarray:
    """Where -i = i modulo the size along every axis: there a transform of real numbers is real."""
    return sum(2 * i % n != 0 for i, n in zip(np.indices(shape, sparse=True), shape)) == 0


def _signed(index: Sequence[int], shape: Sequence[int]) -> str:
    return ",".join(str(int(i) - n if 2 * i > n else int(i)) for i, n in zip(index, shape))


# --- Cells together ---------------------------------------------------------------------------------------------------

def rectangles(window: Window) -> Finding:
    """Each bit of the exclusive or over the corners of rectangles of 1, 2, 4, ... cells: 0 if words are an exclusive
    or of functions of x and of y."""
    words, z, names = window.words, [], []
    for a, b in combinations(range(words.ndim), 2):
        # Below half of the window: there, the corners of a rectangle are those of three others.
        for step in (1 << k for k in range((min(words.shape) // 2 - 1).bit_length())):
            mixed = words ^ np.roll(words, -step, a)
            z.append(_bias(mixed ^ np.roll(mixed, -step, b), window.bits))
            names.append(f"over {step} along {AXES[a]} and {AXES[b]}")
    return normal("rectangles", np.array(z), lambda i, bit: f"bit {window.bits[bit]} {names[i]}")


def _bias(words: np.ndarray, bits: Sequence[int], axes: tuple[int, ...] | None = None) -> np.ndarray:
    """How many standard deviations each bit is set too often, over some axes or all; the bits are the last axis."""
    ones = np.stack([np.count_nonzero(words & np.uint32(1 << bit), axis=axes) for bit in bits], axis=-1)
    samples = words.size * len(bits) // ones.size
    return (2 * ones - samples) / np.sqrt(samples)


def parities(components: Sequence[Window]) -> Finding:
    """The parity of every choice of bits of the components of a vector at one point: how often it is even."""
    key = np.zeros_like(components[0].words)
    for window in components:
        for bit in COMPONENT_BITS[len(components)]:
            key = key << np.uint32(1) | window.words >> np.uint32(bit) & np.uint32(1)
    signs = linalg.hadamard(64)
    z = signs @ np.bincount(key.reshape(-1), minlength=1 << 12).reshape(64, 64) @ signs / np.sqrt(key.size)
    z[0, 0] = 0
    return normal("parities of components", z, lambda high, low: f"bits {high:06b}{low:06b}")


def parts(window: Window) -> list[Finding]:
    """Each bit in every block, row and column: how often it is set, and in blocks how often it is as the next one."""
    words, n = window.words, window.words.ndim
    size = min(BLOCK[n], *words.shape)
    within = words[tuple(slice(0, side - side % size) for side in words.shape)]
    split = [part for side in within.shape for part in (side // size, size)]
    changes = {"set": within, **{f"as the next along {AXES[axis]}": within ^ np.roll(within, -1, axis)
                                 for axis in range(n)}}
    z = np.stack([_bias(change.reshape(split), window.bits, tuple(range(1, 2 * n, 2))) for change in changes.values()])
    names = list(changes)
    blocks = normal("blocks", z, lambda i, *at: f"bit {window.bits[at[-1]]} {names[i]}, block {at[:-1]}")
    lines = [normal("lines", _bias(words, window.bits, tuple(a for a in range(n) if a != axis)),
                    lambda line, bit: f"bit {window.bits[bit]}, {AXES[axis]} = {line}", n) for axis in range(n)]
    return [blocks, *worst(lines)]


# --- Copies -----------------------------------------------------------------------------------------------------------

def copied_lines(window: Window) -> Finding:
    """The most pairs of equal words that one shift, or one reflection, of a line onto another makes."""
    flat, shape = window.words.reshape(-1), window.words.shape
    order = np.argsort(flat, kind="stable")
    same = np.flatnonzero(flat[order[1:]] == flat[order[:-1]])
    # A bit may be the same in all words (the lowest one of partial FNV1): then so many more are equal.
    varying = int(np.bitwise_or.reduce(flat) ^ np.bitwise_and.reduce(flat)).bit_count()
    found = []
    for axis, length in enumerate(shape):
        lines = flat.size // length
        at, line = [], []
        for cells in (order[same], order[same + 1]):
            index = list(np.unravel_index(cells, shape))
            at.append(index.pop(axis))
            line.append(np.ravel_multi_index(index, [n for a, n in enumerate(shape) if a != axis]))
        key = (np.minimum(*line).astype(np.int64) * lines + np.maximum(*line)) * 4 * length
        shift = np.where(line[0] > line[1], at[0] - at[1], at[1] - at[0]) + length
        most = max((np.unique(key + way, return_counts=True)[1].max(initial=0)
                    for way in (shift, at[0] + at[1] + 2 * length)))
        # Each of the shifts and reflections has at most `length` pairs of words, which are equal as rarely as any.
        # With loc=1, sf is the probability of reaching a number, not of exceeding it.
        found.append(peak("copied lines", most, stats.poisson(length * 2.0 ** -varying, loc=1),
                          lines * (lines + 1) * length * len(shape), f"along {AXES[axis]}"))
    return worst(found)[0]


def copied_runs(windows: Sequence[Window]) -> Finding:
    """Pairs of equal runs of cells, along any axis and in either direction, in one window or in two."""
    length = max(3, -(-RUN_BITS // len(windows[0].bits)))
    keys = np.sort(np.concatenate([_run_keys(window, length) for window in windows]))
    lengths = np.diff(np.flatnonzero(np.concatenate([[True], keys[1:] != keys[:-1], [True]])))
    # Keys of 64 bits are equal by chance, and so are palindromes.
    expected = len(keys) ** 2 / 2 * 2.0 ** -64 + len(keys) * 2.0 ** (-RUN_BITS // 2)
    return rare("copied runs", int((lengths * (lengths - 1) // 2).sum()), expected, f"runs of {length} cells")


def _run_keys(window: Window, length: int) -> np.ndarray:
    """A word for each run along each axis; a run and its reverse have the same."""
    values = (window.words >> np.uint32(min(window.bits)) & np.uint32((1 << len(window.bits)) - 1)).astype(np.uint64)
    keys = []
    for axis, side in enumerate(values.shape):
        cells = [np.take(values, range(i, i + side - length + 1), axis) for i in range(length)]
        keys.append(np.minimum(_fold(cells), _fold(cells[::-1])).reshape(-1))
    return np.concatenate(keys)


def _fold(cells: Sequence[np.ndarray]) -> np.ndarray:
    key = np.zeros_like(cells[0])
    for cell in cells:
        key = (key + cell) * MULTIPLIER
        key ^= key >> np.uint64(31)
    return key * FINISH
