"""Section 16 of docs/contract.md: the points of cells, and which of them are nearest.

All cells of a block around the position are candidates. A point lies within an octahedron about the middle of its cell,
so it is at least as far as a box around that. The candidates are taken in the order of these least distances, until all
others are farther than what was found; what lies outside of the block must be farther, too, or a search raises.

Both arithmetics count in whole numbers: exactly, in units in which everything is whole, or in units of 2^-20.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from oracle import gradients
from oracle.gradients import Real
from oracle.integers import UNIT
from oracle.lattice import EUCLIDEAN, Lattice
from oracle.words import signed

# How far the block reaches beyond the cell of the position, in cells: 7 x 7 or 7 x 7 x 7 of them.
AROUND = 3

# The metrics; every other number is Euclidean.
SQUARED, MANHATTAN, CHEBYSHEV, HYBRID = 2, 3, 4, 5

# In which u is whole.
DIRECTION_UNIT = 512


def clamped(jitter: Real) -> Fraction:
    return min(max(Fraction(jitter), Fraction(0)), Fraction(1))


@functools.lru_cache(maxsize=65536)
def direction(word: int, n: int) -> tuple[int, ...]:
    """U, the direction of a word in units of 1/512."""
    u = gradients.direction2(word) if n == 2 else gradients.direction3(word)
    scaled = tuple(int(x * DIRECTION_UNIT) for x in u)
    assert all(a == x * DIRECTION_UNIT for a, x in zip(scaled, u))
    return scaled


def root(x: Fraction) -> Fraction:
    """The square root: exact if it is rational, else so that every number of up to 2^8 bits is less or greater than it
    as it is than the root. So what is rounded to a double is rounded correctly."""
    n = x.numerator * x.denominator
    more = max(0, 256 - n.bit_length() // 2)
    r = math.isqrt(n << 2 * more)
    if r * r == n << 2 * more:
        return Fraction(r, x.denominator << more)
    return Fraction(2 * r + 1, x.denominator << more + 1)


def square(d: Sequence[int]) -> int:
    return sum(x * x for x in d)


@dataclass(frozen=True)
class Arithmetic:
    """How a point is placed and how far it is. A rank grows with the distance, and with each component."""
    unit: int  # of a cell

    def moved(self, u: int) -> int:
        """How far a point is from the middle of its cell along an axis, of a component of U."""
        raise NotImplementedError

    @property
    def reach(self) -> int:
        """How far it is at most."""
        raise NotImplementedError

    def rank(self, metric: int, d: Sequence[int]) -> int:
        raise NotImplementedError

    def distance(self, metric: int, rank: int) -> Fraction:
        raise NotImplementedError


@dataclass(frozen=True)
class Exact(Arithmetic):
    """The unit is fine enough for the position and the points."""
    jitter: Fraction

    @classmethod
    def of(cls, lattice: Lattice, f: Sequence[Fraction]) -> Exact:
        jitter = clamped(lattice.choice.jitter)
        return cls(2 * DIRECTION_UNIT * math.lcm(UNIT, jitter.denominator, *(x.denominator for x in f)), jitter)

    @functools.cached_property
    def step(self) -> int:
        """For each unit of U."""
        return int(self.jitter * self.unit) // (2 * DIRECTION_UNIT)

    def moved(self, u: int) -> int:
        return u * self.step

    @property
    def reach(self) -> int:
        return DIRECTION_UNIT * self.step

    def rank(self, metric: int, d: Sequence[int]) -> int:
        if metric == MANHATTAN:
            return sum(map(abs, d))
        if metric == CHEBYSHEV:
            return max(map(abs, d))
        if metric == HYBRID:
            return self.unit * sum(map(abs, d)) + square(d)
        return square(d)

    def distance(self, metric: int, rank: int) -> Fraction:
        if metric in (MANHATTAN, CHEBYSHEV):
            return Fraction(rank, self.unit)
        squared = Fraction(rank, self.unit**2)
        return squared if metric in (SQUARED, HYBRID) else root(squared)


def fixed_root(n: int) -> int:
    """root(N)."""
    return math.isqrt(2**8 * n)


def fixed_square(d: Sequence[int]) -> int:
    """The contract's N of the offsets D."""
    return square(d) // 2**12


@dataclass(frozen=True)
class Fixed(Arithmetic):
    jitter: int  # J

    @classmethod
    def of(cls, lattice: Lattice) -> Fixed:
        return cls(UNIT, math.trunc(clamped(lattice.choice.jitter) * 2**20))

    def moved(self, u: int) -> int:
        return u * self.jitter // 2**10

    @property
    def reach(self) -> int:
        return -(-DIRECTION_UNIT * self.jitter // 2**10)

    def rank(self, metric: int, d: Sequence[int]) -> int:
        if metric == MANHATTAN:
            return sum(map(abs, d))
        if metric == CHEBYSHEV:
            return max(map(abs, d))
        if metric == HYBRID:
            return sum(map(abs, d)) + fixed_square(d) // 2**8
        return fixed_square(d)

    def distance(self, metric: int, rank: int) -> Fraction:
        if metric in (MANHATTAN, CHEBYSHEV, HYBRID):
            return Fraction(rank, 2**20)
        return Fraction(rank // 2**8, 2**20) if metric == SQUARED else Fraction(fixed_root(rank), 2**18)


@dataclass(frozen=True)
class Point:
    """The point of a cell, which has the numbers of the lattice, neither wrapped nor replaced by a period yet. The
    offset is that of the position from the point."""
    rank: int
    cell: tuple[int, ...]
    offset: tuple[int, ...]

    @property
    def order(self) -> tuple[int, ...]:
        """Of points at the same distance, that of the cell with the smallest z, then y, then x comes first."""
        return (self.rank, *reversed(self.cell))

    def named(self, lattice: Lattice) -> tuple[int, ...]:
        """Its cell as a shader sees it."""
        return tuple(map(signed, lattice.point(self.cell)))


class TooFar(RuntimeError):
    """A point outside of the block might count."""


@dataclass(frozen=True)
class Field:
    """The points around a position, which is a cell and a fraction in it."""
    lattice: Lattice
    arithmetic: Arithmetic
    cell: tuple[int, ...]
    fraction: tuple[int, ...]
    metric: int

    @classmethod
    def exact(cls, lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction], metric: int) -> Field:
        arithmetic = Exact.of(lattice, f)
        return cls(lattice, arithmetic, tuple(cell), tuple(int(x * arithmetic.unit) for x in f), metric)

    @classmethod
    def fixed(cls, lattice: Lattice, cell: Sequence[int], fraction: Sequence[int], metric: int) -> Field:
        return cls(lattice, Fixed.of(lattice), tuple(cell), tuple(fraction), metric)

    def point(self, beside: Sequence[int]) -> Point:
        """That of the cell which is so many cells away."""
        unit, moved = self.arithmetic.unit, self.arithmetic.moved
        cell = tuple(c + o for c, o in zip(self.cell, beside))
        u = direction(self.lattice.word(cell), len(cell))
        offset = tuple(f - o * unit - unit // 2 - moved(a) for f, o, a in zip(self.fraction, beside, u))
        return Point(self.arithmetic.rank(self.metric, offset), cell, offset)

    def candidates(self) -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
        """The cells of the block, and the least magnitude of the offset from their points along each axis."""
        unit, reach = self.arithmetic.unit, self.arithmetic.reach
        axes = [[(o, max(0, abs(f - o * unit - unit // 2) - reach)) for o in range(-AROUND, AROUND + 1)]
                for f in self.fraction]
        for along_axes in itertools.product(*axes):
            beside, least = zip(*along_axes)
            yield beside, least

    def nearest_first(self) -> list[tuple[int, tuple[int, ...]]]:
        """The cells of the block with the least rank that their points can have."""
        rank, metric = self.arithmetic.rank, self.metric
        return sorted((rank(metric, least), beside) for beside, least in self.candidates())

    @property
    def outside(self) -> tuple[int, ...]:
        """The least magnitude of the offset from a point outside of the block, along the axis along which it is out."""
        return (AROUND * self.arithmetic.unit - 1,) + (0,) * (len(self.cell) - 1)

    def nearest(self, count: int) -> list[Point]:
        """The nearest points, in their order."""
        found: list[Point] = []
        for least, beside in self.nearest_first():
            if len(found) == count and least > found[-1].rank:
                break
            found = sorted([*found, self.point(beside)], key=lambda point: point.order)[:count]
        if found[-1].rank >= self.arithmetic.rank(self.metric, self.outside):
            raise TooFar(f"{self} has points farther away than the block that is searched")
        return found

    def distances(self, count: int) -> tuple[Fraction, ...]:
        return tuple(self.arithmetic.distance(self.metric, point.rank) for point in self.nearest(count))


def exact_field(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> Field:
    """With the metric that the caller chose."""
    return Field.exact(lattice, cell, f, lattice.choice.metric)


def fixed_field(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> Field:
    return Field.fixed(lattice, cell, fraction, lattice.choice.metric)


def whole_numbers(values: Sequence[Fraction], unit: int) -> tuple[int, ...]:
    """The values in units of 1 / unit, of which they are multiples."""
    numbers = [value * unit for value in values]
    assert all(number.denominator == 1 for number in numbers)
    return tuple(map(int, numbers))
