"""hn_self_check, the end of section 18 of docs/reference/contract.md."""

from __future__ import annotations

from collections.abc import Iterator

from proof.oracle import numbers, positions
from proof.oracle.hashes import MASK, lattice, mix, signed

ROUNDS = 16
UNITS = 7  # of hn_cell and hn_fraction


def numbers_of(h: int, w: int, i: int) -> Iterator[float]:
    """The whole numbers that a round takes in, in their order: of its word h, of the w with which it began, and of its
    number."""
    yield h
    yield from (2**24 * x for x in numbers.unorms(h, 3))
    yield from (2**16 * x for x in numbers.sphere(h))
    yield from (2**16 * x for x in numbers.disk(h))
    yield 2**13 * numbers.gaussian(h)
    yield numbers.shuffle(h, i + 1000, w)
    yield from (2**24 * x for x in numbers.sobol(h, w))
    yield positions.cell(signed(h), i + 1, UNITS)
    yield 2**24 * positions.fraction(signed(h), i + 1, UNITS)


def self_check(name: str, zero: int) -> int:
    """hn_self_check with the hash `name`."""
    w = zero
    for i in range(ROUNDS):
        h = lattice(name, (signed(w), i - 8, signed(w >> 9) - 2**22), w)
        for number in numbers_of(h, w, i):
            if number != int(number):
                raise ValueError(f"{number} is no whole number")
            w = mix(w + int(number) & MASK)
    return w
