"""The numbers in the inputs of the golden files, and of tests."""

from __future__ import annotations

import struct
from collections.abc import Sequence

INT_MIN, INT_MAX = -2**31, 2**31 - 1
SEEDS = (0, 1, 0xFFFFFFFF)

Row = tuple  # one value per input column, integers and floats


def fnv1a64(data: bytes) -> int:
    """FNV-1a, 64 bit: seeds the generator, and makes the digests."""
    h = 14695981039346656037
    for byte in data:
        h = (h ^ byte) * 1099511628211 & 0xFFFFFFFFFFFFFFFF
    return h


def to_f32(value: float) -> float:
    """The float32 nearest to `value`."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


class Generator:
    """SplitMix64 (Steele, Lea and Flood 2014), with the few kinds of draw that the rows need."""

    def __init__(self, seed: int) -> None:
        self.state = seed

    def next(self) -> int:
        """The next 64 bits."""
        self.state = (self.state + 0x9E3779B97F4A7C15) & 0xFFFFFFFFFFFFFFFF
        z = self.state
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & 0xFFFFFFFFFFFFFFFF
        z = (z ^ z >> 27) * 0x94D049BB133111EB & 0xFFFFFFFFFFFFFFFF
        return z ^ z >> 31

    def word(self) -> int:
        return self.next() >> 32

    def integer(self, low: int, high: int) -> int:
        """An integer from `low` to `high`, both included."""
        return low + self.next() % (high - low + 1)

    def pick(self, choices: Sequence) -> object:
        return choices[self.integer(0, len(choices) - 1)]

    def uniform(self, low: float, high: float) -> float:
        return to_f32(low + (high - low) * (self.next() >> 11) / 2**53)

    def seed(self) -> int:
        """A noise seed: one of the edge cases, or any word."""
        return self.pick((*SEEDS, self.word()))


def generator_of(name: str) -> Generator:
    """One of its own for each function, and for each test."""
    return Generator(fnv1a64(name.encode("ascii")))
