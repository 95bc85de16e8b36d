"""Windows of the integer lattice, and the words and gradients in them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from measure.hashes.library import Twin


@dataclass
class Lattice:
    """The words of a window. Axis 0 of the array is x, and so on."""
    words: np.ndarray        # uint32, one axis per dimension
    gradients: np.ndarray    # the same with the components as a last axis
    bits: np.ndarray         # those that the gradient stage uses, highest first
    origin: tuple[int, ...] = ()
    seed: int = 0

    @property
    def dimensions(self) -> int:
        return self.words.ndim

    @property
    def place(self) -> str:
        return f"origin {','.join(map(str, self.origin))} seed {self.seed}" if self.origin else "given"

    @property
    def varying(self) -> int:
        """How many bits of the words are not the same everywhere; see varying_bits."""
        return varying_bits(self.words)

    @cached_property
    def values(self) -> np.ndarray:
        """The consumed bits alone, as integers."""
        values = np.zeros_like(self.words)
        for bit in self.bits:
            values = values << 1 | (self.words >> np.uint32(bit) & 1)
        return values


def cells_of(origin: tuple[int, ...], shape: tuple[int, ...]) -> np.ndarray:
    """Every cell of a window as a row, the last axis fastest."""
    axes = [np.arange(o, o + n, dtype=np.int64) for o, n in zip(origin, shape)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(shape))


def sample(twin: Twin, shape: tuple[int, ...], origin: tuple[int, ...], seed: int) -> Lattice:
    cells = cells_of(origin, shape)
    return Lattice(twin.words(cells, seed).reshape(shape), twin.gradients(cells, seed).reshape(*shape, len(shape)),
                   twin.consumed(len(shape)), origin, seed)


def of_words(words: np.ndarray, twin: Twin) -> Lattice:
    """A lattice of words from anywhere, with the gradients that the library makes of them."""
    words = np.ascontiguousarray(words, np.uint32)
    gradients = twin.stage(words.reshape(-1), words.ndim).reshape(*words.shape, words.ndim)
    return Lattice(words, gradients, twin.consumed(words.ndim))


def varying_bits(words: np.ndarray) -> int:
    """How many bits of words are not the same in all of them. A bit below those that gradients take may be (that of
    partial FNV1, which is always odd); then equal words are as likely as with so many bits less. Another test finds it
    where it is consumed."""
    return int(np.bitwise_or.reduce(words, axis=None) ^ np.bitwise_and.reduce(words, axis=None)).bit_count()


def neighbours(dimensions: int) -> list[tuple[int, ...]]:
    """The offsets to a cell's neighbours, diagonal ones as well, one of each opposite pair."""
    offsets = np.stack(np.meshgrid(*[[-1, 0, 1]] * dimensions, indexing="ij"), axis=-1).reshape(-1, dimensions)
    return [tuple(int(o) for o in offset) for offset in offsets if tuple(offset) > (0,) * dimensions]


def shifted(array: np.ndarray, offset: tuple[int, ...]) -> np.ndarray:
    """The array in which each cell has what its neighbour at the offset had; the window wraps."""
    return np.roll(array, [-o for o in offset], axis=tuple(range(len(offset))))
