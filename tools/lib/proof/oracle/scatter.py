"""Section 19 of docs/reference/contract.md: scattered points. All of it is exact in the library, too."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from proof.oracle.gradients import Real
from proof.oracle.lattice import Lattice
from proof.oracle.numbers import rehash

UNIT = 2**15  # of a cell: of candidates and of radii


@dataclass(frozen=True)
class Candidate:
    word: int                # of its cell
    place: tuple[int, ...]   # from the corner of its cell, in units


@functools.lru_cache(maxsize=4096)  # each cell is a neighbour of many
def candidate(lattice: Lattice, cell: tuple[int, ...]) -> Candidate:
    h = lattice.hash(cell)
    first, second = rehash(h, 1), rehash(h, 2)
    return Candidate(h, (first >> 17, first >> 2 & 32767, second >> 17)[:len(cell)])


def point(lattice: Lattice, cell: Sequence[int]) -> tuple[float, ...]:
    """hn_scatter_point."""
    return tuple(x / UNIT for x in candidate(lattice, tuple(cell)).place)


def reach(radius: Real) -> int:
    """R."""
    return math.trunc(min(max(Fraction(radius), Fraction(0)), Fraction(1)) * UNIT)


def steps(n: int) -> list[tuple[int, ...]]:
    """From a cell to its neighbours: each o of the contract."""
    return [o for o in itertools.product((-1, 0, 1), repeat=n) if any(o)]


def rivals(lattice: Lattice, cell: Sequence[int]) -> Iterator[tuple[tuple[int, ...], int]]:
    """The neighbours whose words leave no room for a smaller one nearby: the step to each, and the square of how far
    its candidate is from the cell's."""
    own = candidate(lattice, tuple(cell))
    for o in steps(len(cell)):
        other = candidate(lattice, tuple(c + step for c, step in zip(cell, o)))
        if own.word <= other.word:
            yield o, sum((step * UNIT + b - a)**2 for step, a, b in zip(o, own.place, other.place))


def stands(lattice: Lattice, cell: Sequence[int], radius: Real) -> bool:
    limit = reach(radius)**2
    return all(square >= limit for _, square in rivals(lattice, cell))


def scattered(lattice: Lattice, cell: Sequence[int], radius: Real) -> int:
    return rehash(candidate(lattice, tuple(cell)).word, 5) | 1 if stands(lattice, cell, radius) else 0
