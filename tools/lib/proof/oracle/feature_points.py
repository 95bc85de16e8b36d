"""Section 16 of docs/reference/contract.md: the points of cells, and which of them are nearest.

All cells of a block around the position are candidates. A point lies within an octahedron about the middle of its cell,
so it is at least as far as a box around that. The candidates are taken in the order of these least distances, until all
others are farther than the found ones; a point outside of the block must be farther, too, or a search raises.
With a phase points go round about the middle of their cells, and no farther from it.

Both arithmetics count in whole numbers: exactly, in units in which everything is whole, or in units of 2^-20.
"""

from __future__ import annotations

import functools
import itertools
import math
import operator
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from proof.oracle import gradients, moving_points
from proof.oracle.gradients import Real
from proof.oracle.hashes import signed
from proof.oracle.integers import UNIT
from proof.oracle.lattice import EUCLIDEAN, Lattice
from proof.oracle.moving_points import Matrix

# How far the block reaches beyond the cell of the position, in cells: 7 x 7 or 7 x 7 x 7 of them.
AROUND = 3

# The metrics; every other number is Euclidean.
SQUARED, MANHATTAN, CHEBYSHEV, HYBRID = 2, 3, 4, 5

# In which u is whole.
DIRECTION_UNIT = 512


def clamped(jitter: Real) -> Fraction:
    return min(max(Fraction(jitter), Fraction(0)), Fraction(1))


def direction2(h: int) -> tuple[float, float]:
    """A point of the square |x| + |y| = 1."""
    a = gradients.middle(h >> 14 & 511, 512)
    m = 1 - abs(a)
    return (a, -m if h >> 31 else m)


def direction3(h: int) -> tuple[float, float, float]:
    """A point of the octahedron |x| + |y| + |z| = 1."""
    p = gradients.middle(h >> 23 & 255, 256)
    q = gradients.middle(h >> 15 & 255, 256)
    m = 1 - max(abs(p), abs(q))
    return ((p + q) / 2, (p - q) / 2, -m if h >> 31 else m)


@functools.lru_cache(maxsize=65536)
def direction(word: int, n: int) -> tuple[int, ...]:
    """U, the direction of a word in units of 1/512."""
    u = direction2(word) if n == 2 else direction3(word)
    scaled = tuple(int(x * DIRECTION_UNIT) for x in u)
    assert all(a == x * DIRECTION_UNIT for a, x in zip(scaled, u))
    return scaled


def root(x: Fraction) -> Fraction:
    """The square root: exact if it is rational, else so that every number of up to 2^8 bits is less or greater than it
    as it is than the root. So rounding to a double is correct."""
    n = x.numerator * x.denominator
    more = max(0, 256 - n.bit_length() // 2)
    r = math.isqrt(n << 2 * more)
    if r * r == n << 2 * more:
        return Fraction(r, x.denominator << more)
    return Fraction(2 * r + 1, x.denominator << more + 1)


def square(d: Sequence[int]) -> int:
    return sum(x * x for x in d)


# A cell of the block, as so many cells away, and the least magnitude of the offset from its point along each axis.
Candidate = tuple[tuple[int, ...], tuple[int, ...]]


@dataclass(frozen=True)
class Arithmetic:
    """How a point is placed and how far it is. A rank grows with the distance, and with each component."""
    unit: int  # of a cell

    def from_middle(self, fraction: Sequence[int], beside: Sequence[int]) -> tuple[int, ...]:
        """The offset of the position from the middle of the cell which is so many cells away."""
        return tuple(f - o * self.unit - self.unit // 2 for f, o in zip(fraction, beside))

    def candidates(self, fraction: Sequence[int]) -> Iterator[Candidate]:
        """The cells of the block."""
        axes = [[(o, max(0, abs(f - o * self.unit - self.unit // 2) - self.reach)) for o in range(-AROUND, AROUND + 1)]
                for f in fraction]
        for along_axes in itertools.product(*axes):
            beside, least = zip(*along_axes)
            yield beside, least

    def moved(self, u: Sequence[int]) -> tuple[int, ...]:
        """How far a point is from the middle of its cell along each axis, by its direction U."""
        raise NotImplementedError

    @property
    def reach(self) -> int:
        """How far it is at most."""
        raise NotImplementedError

    @property
    def outside(self) -> int:
        """How far any point outside of the block is at least."""
        return AROUND * self.unit - 1

    def straight(self, d: tuple[int, ...]) -> tuple[int, ...]:
        """The offset along the axes of the caller."""
        return d

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
        if lattice.phase is None:
            return cls(cls.unit_of(f, [jitter]), jitter)
        ways = moving_points.ways(len(f), lattice.phase, jitter)
        unit = cls.unit_of(f, itertools.chain(*ways))
        steps = tuple(tuple(int(x * unit) // (2 * DIRECTION_UNIT) for x in row) for row in ways)
        return MovingExact(unit, jitter, steps)

    @staticmethod
    def unit_of(f: Sequence[Fraction], ways: Iterable[Fraction]) -> int:
        """The unit of a point's movement, for each half of a direction."""
        return 2 * DIRECTION_UNIT * math.lcm(UNIT, *(x.denominator for x in (*f, *ways)))

    @functools.cached_property
    def step(self) -> int:
        """For each unit of U."""
        return int(self.jitter * self.unit) // (2 * DIRECTION_UNIT)

    def moved(self, u: Sequence[int]) -> tuple[int, ...]:
        return tuple(x * self.step for x in u)

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


@dataclass(frozen=True)
class MovingExact(Exact):
    """Points that have gone round."""
    steps: Matrix  # for each unit of each component of U: the move along each axis

    def moved(self, u: Sequence[int]) -> tuple[int, ...]:
        return tuple(sum(a * x for a, x in zip(row, u)) for row in self.steps)

    @property
    def reach(self) -> int:
        # The magnitudes of U sum to one direction's.
        return DIRECTION_UNIT * max(abs(x) for row in self.steps for x in row)


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
    def of(cls, lattice: Lattice, n: int) -> Fixed:
        jitter = clamped(lattice.choice.jitter)
        if lattice.phase is None:
            return cls(UNIT, math.trunc(jitter * 2**20))
        return MovingFixed(UNIT, moving_points.fixed_jitter(n, jitter), moving_points.backwards(n, lattice.phase))

    def moved(self, u: Sequence[int]) -> tuple[int, ...]:
        return tuple(x * self.jitter // 2**10 for x in u)

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
class MovingFixed(Fixed):
    """Points go round: the position is rotated instead, backwards."""
    backwards: Matrix  # B

    def from_middle(self, fraction: Sequence[int], beside: Sequence[int]) -> tuple[int, ...]:
        middle = moving_points.times(self.backwards, tuple(f - 2**19 for f in fraction))
        return tuple(x - sum(16 * o * b for o, b in zip(beside, row)) for x, row in zip(middle, self.backwards))

    def candidates(self, fraction: Sequence[int]) -> Iterator[Candidate]:
        # Along an axis of the rotated block cells are not one behind the other.
        reach = self.reach
        for beside in itertools.product(range(-AROUND, AROUND + 1), repeat=len(fraction)):
            yield beside, tuple(max(0, abs(d) - reach) for d in self.from_middle(fraction, beside))

    @property
    def outside(self) -> int:
        # B makes nothing shorter by more than 2^-12, and roundings are a few units.
        return AROUND * (self.unit - self.unit // 2**10)

    def straight(self, d: tuple[int, ...]) -> tuple[int, ...]:
        return moving_points.times(moving_points.columns(self.backwards), d)


@dataclass(frozen=True)
class Point:
    """The point of a cell, which has the numbers of the lattice, neither wrapped nor replaced by a period yet. The
    offset leads from the point to the position."""
    rank: int
    cell: tuple[int, ...]
    offset: tuple[int, ...]
    is_beside: bool  # whether it is the cell of the position or a neighbour

    @property
    def order(self) -> tuple[int, ...]:
        """Among points at the same distance, the points of the position's cell and of its neighbours come first, and of
        these that of the cell with the smallest z, then y, then x."""
        return (self.rank, not self.is_beside, *reversed(self.cell))

    def named(self, lattice: Lattice) -> tuple[int, ...]:
        """Its cell as a shader sees it."""
        return tuple(map(signed, lattice.point(self.cell)))


class BlockTooSmall(RuntimeError):
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
        return cls(lattice, Fixed.of(lattice, len(cell)), tuple(cell), tuple(fraction), metric)

    def point(self, beside: Sequence[int]) -> Point:
        """The point of the cell which is so many cells away."""
        cell = tuple(c + o for c, o in zip(self.cell, beside))
        moved = self.arithmetic.moved(direction(self.lattice.word(cell), len(cell)))
        offset = tuple(map(operator.sub, self.arithmetic.from_middle(self.fraction, beside), moved))
        is_beside = all(abs(o) <= 1 for o in beside)
        return Point(self.arithmetic.rank(self.metric, offset), cell, offset, is_beside)

    def candidates(self) -> Iterator[Candidate]:
        return self.arithmetic.candidates(self.fraction)

    def nearest_first(self) -> list[tuple[int, tuple[int, ...]]]:
        """The cells of the block with the least rank that their points can have."""
        rank, metric = self.arithmetic.rank, self.metric
        return sorted((rank(metric, least), beside) for beside, least in self.candidates())

    @property
    def outside(self) -> tuple[int, ...]:
        """The least magnitude of the offset from a point outside of the block, as if it were out along x."""
        return (self.arithmetic.outside,) + (0,) * (len(self.cell) - 1)

    def nearest(self, count: int) -> list[Point]:
        """The nearest points, in their order."""
        found: list[Point] = []
        for least, beside in self.nearest_first():
            if len(found) == count and least > found[-1].rank:
                break
            found = sorted([*found, self.point(beside)], key=lambda point: point.order)[:count]
        if found[-1].rank >= self.arithmetic.rank(self.metric, self.outside):
            raise BlockTooSmall(f"{self} has points farther away than the block that is searched")
        return found

    def distances(self, count: int) -> tuple[Fraction, ...]:
        return tuple(self.arithmetic.distance(self.metric, point.rank) for point in self.nearest(count))


def metric_of(lattice: Lattice) -> int:
    """Points that move have the Euclidean one."""
    return lattice.choice.metric if lattice.phase is None else EUCLIDEAN


def exact_field(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> Field:
    """With the metric that the caller chose."""
    return Field.exact(lattice, cell, f, metric_of(lattice))


def fixed_field(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> Field:
    return Field.fixed(lattice, cell, fraction, metric_of(lattice))


def whole_numbers(values: Sequence[Fraction], unit: int) -> tuple[int, ...]:
    numbers = [value * unit for value in values]
    if wrong := [value for value, number in zip(values, numbers) if number.denominator != 1]:
        raise ValueError(f"{wrong[0]} is no multiple of 1 / {unit}, as section 16 of the contract requires")
    return tuple(map(int, numbers))
