"""Section 9 of docs/contract.md: value noise."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from oracle.cells import interpolated, weighted_sum
from oracle.gradients import Knobs, wrapped
from oracle.integers import signed
from oracle.words import point_word


def high_bits(knobs: Knobs, corner: Sequence[int], seed: int) -> int:
    """The high 16 bits of the word of a corner: what its number is made of."""
    return point_word(knobs.hash, [wrapped(c, knobs.period) for c in corner], seed) >> 16


def exact(knobs: Knobs, cell: Sequence[int], f: Sequence[Fraction], seed: int) -> Fraction:
    def number(corner: Sequence[int], _: Sequence[Fraction]) -> Fraction:
        return Fraction(2 * high_bits(knobs, corner, seed) + 1, 2**16) - 1

    return weighted_sum(cell, f, number)


def fixed(knobs: Knobs, cell: Sequence[int], fraction: Sequence[int], seed: int) -> int:
    """Section 9 with HN_FIXED."""
    def number(corner: Sequence[int], _: Sequence[int]) -> int:
        return signed(signed(2**14 * high_bits(knobs, corner, seed)) - 65535 * 2**13)

    return signed(interpolated(cell, fraction, number) + 128) >> 8
