"""Sections 13 and 23 of docs/reference/contract.md: sums over the points of a lattice of triangles, or of a centred
one.

Every point in the neighbourhood of a cell is tried, so nothing here knows which of them a position meets.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from proof.oracle import ramps
from proof.oracle.gradients import Real
from proof.oracle.integers import UNIT, part, signed, word
from proof.oracle.lattice import Lattice

# How many cells a point may be away from the cell, along each axis. A kernel reaches one cell at most.
AROUND = 2


@dataclass(frozen=True)
class Weight:
    """w(t), and with HN_FIXED W and E, how it falls, of t and its square Q."""
    terms: tuple[tuple[Fraction, int], ...]  # factors, and powers of t
    of_square: Callable[[int, int], int]
    fall: Callable[[int, int], int] | None = None  # only of noises with derivatives

    def exact(self, t: Fraction) -> Fraction:
        return sum((factor * t**power for factor, power in self.terms), Fraction(0))

    def slope(self, t: Fraction) -> Fraction:
        return sum((factor * power * t**(power - 1) for factor, power in self.terms), Fraction(0))


def monomial(factor: int, power: int) -> tuple[tuple[Fraction, int], ...]:
    return ((Fraction(factor), power),)


def third(t: int, q: int) -> int:
    """t^3, in units of 2^-18."""
    return word(word(q * t) + 2**13) >> 14


def quartic(t: int, q: int) -> int:
    """t^3 (3 - 2 t)."""
    u = word(word(t * (98304 - t)) + 2**15) >> 16
    return word(word(q * u) + 2**12) >> 13


def even(t: int, q: int) -> int:
    """t^3 (1 + 15 (1 - t)^2). The squares of these weights sum to nearly the same everywhere."""
    g = t - q
    m = q + (word(word(15 * g * g) + 2**15) >> 16)
    return word(word(m * t) + 2**13) >> 14


def even_fall(t: int, q: int) -> int:
    """A quarter of the slope, 3 (4 t - 5 t^2)^2, in units of 2^-18."""
    h = 4 * t - 5 * q
    return 3 * (word(word(h * h) + 2**15) >> 16)


QUARTIC = Weight(((Fraction(3), 3), (Fraction(-2), 4)), quartic,
                 lambda t, q: signed(signed(q * (73728 - t)) + 2**12) >> 13)
CUBE = Weight(monomial(1, 3), third, lambda t, q: 6 * q)
FOURTH = Weight(monomial(1, 4), lambda t, q: word(word(q * q) + 2**13) >> 14, lambda t, q: 2 * third(t, q))
FIFTH = Weight(monomial(4, 5), lambda t, q: word(word((word(word(q * q) + 2**15) >> 16) * t) + 2**11) >> 12)
EVEN_TERMS = ((Fraction(16), 3), (Fraction(-30), 4), (Fraction(15), 5))
PLANE_EVEN = Weight(EVEN_TERMS, even, even_fall)
SPACE_EVEN = Weight(EVEN_TERMS, even, lambda t, q: 2 * even_fall(t, q))


@dataclass(frozen=True)
class Kernel:
    """A row of the contract's table. Whole numbers: r and the scale are in units of 1/1024."""
    triangles: bool
    r: int
    m: int
    weight: Weight
    scale: int

    @property
    def steps(self) -> int:
        """In a cell."""
        return 2 if self.triangles else 1

    def reaches(self, square: int, step: int) -> bool:
        """Whether a point counts: of the square of its distance, in units; a step has `step` of them."""
        return 1024 * self.m * square < self.r * step**2


@dataclass(frozen=True)
class Point:
    """A lattice point: its numbers beside the cell's corner, and how far the position is from it."""
    numbers: tuple[int, ...]
    centre: bool
    offset: tuple[int, ...]

    @property
    def square(self) -> int:
        return sum(d * d for d in self.offset)

    def word(self, kernel: Kernel, lattice: Lattice, cell: Sequence[int]) -> int:
        if kernel.triangles:
            lattice = lattice.of_triangles
        return lattice.word([kernel.steps * c + i for c, i in zip(cell, self.numbers)], self.centre)


def triangle_points(position: Sequence[int], step: int) -> Iterator[Point]:
    x, y = position
    numbers = range(-2 * AROUND, 2 * (1 + AROUND) + 1)
    for i, j in itertools.product(numbers, repeat=2):
        yield Point((i, j), False, (x - i * step - j % 2 * (step // 2), y - j * step))


def centred_points(kernel: Kernel, position: Sequence[int], step: int) -> Iterator[Point]:
    for centre in (False, True):
        # In four dimensions there are many: those that are too far along one axis alone are left out at once.
        axes = [[(c, x - c * step - centre * (step // 2)) for c in range(-AROUND, 1 + AROUND + 1)] for x in position]
        near = [[(c, d) for c, d in axis if kernel.reaches(d * d, step)] for axis in axes]
        for along_axes in itertools.product(*near):
            numbers, offset = zip(*along_axes)
            yield Point(numbers, centre, offset)


def points(kernel: Kernel, position: Sequence[int], step: int) -> list[Point]:
    """The points that count at a position in a cell, in units; a step has `step` of them, an even number."""
    if kernel.triangles:
        around = triangle_points(position, step)
    else:
        around = centred_points(kernel, position, step)
    return [point for point in around if kernel.reaches(point.square, step)]


# --- Exact ------------------------------------------------------------------------------------------------------


@functools.lru_cache(maxsize=4096)
def weighted_points(kernel: Kernel, f: tuple[Fraction, ...]) -> list[tuple[Point, tuple[Fraction, ...], Fraction]]:
    """The points that count at the fractions f, with their offsets in steps and their t."""
    step = 2 * math.lcm(*(x.denominator for x in f))
    found = []
    for point in points(kernel, [int(kernel.steps * x * step) for x in f], step):
        t = Fraction(kernel.r, 1024) - kernel.m * Fraction(point.square, step**2)
        found.append((point, tuple(Fraction(d, step) for d in point.offset), t))
    return found


def dot(g: Sequence[Real], d: Sequence[Fraction]) -> Fraction:
    return sum((Fraction(a) * b for a, b in zip(g, d)), Fraction(0))


def gradient(kernel: Kernel, lattice: Lattice, cell: Sequence[int], point: Point) -> tuple[Real, ...]:
    return lattice.octahedral(point.word(kernel, lattice, cell), len(cell))


def value(kernel: Kernel, lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> Fraction:
    total = Fraction(0)
    for point, d, t in weighted_points(kernel, tuple(f)):
        total += kernel.weight.exact(t) * dot(gradient(kernel, lattice, cell, point), d)
    return Fraction(kernel.scale, 1024) * total


def derivatives(kernel: Kernel, lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> list[Fraction]:
    """The derivatives of the value, per cell."""
    totals = [Fraction(0)] * len(f)
    for point, d, t in weighted_points(kernel, tuple(f)):
        g = gradient(kernel, lattice, cell, point)
        weight, along = kernel.weight.exact(t), -2 * kernel.m * kernel.weight.slope(t) * dot(g, d)
        totals = [total + weight * Fraction(a) + along * b for total, a, b in zip(totals, g, d)]
    return [Fraction(kernel.scale * kernel.steps, 1024) * total for total in totals]


# --- Fixed ------------------------------------------------------------------------------------------------------


def fixed_points(kernel: Kernel, fraction: Sequence[int]) -> list[Point]:
    """With offsets in units of 2^-20 steps."""
    return points(kernel, [kernel.steps * x for x in fraction], UNIT)


def fixed_t(kernel: Kernel, square: int) -> tuple[int, int]:
    """t and Q, its square, of a squared distance in units of 2^-40."""
    n = square // 2**10
    t = min((max(kernel.r * 2**20 - kernel.m * n, 0) + 2**13) >> 14, 65535)
    return t, word(word(t * t) + 2**15) >> 16


def fixed_scale(kernel: Kernel, n: int) -> int:
    """The contract's S of `scaled`: in four dimensions the ramps have a coarser unit."""
    return 2 * kernel.scale if n == 4 else kernel.scale


def fixed_sum(kernel: Kernel, lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> int:
    total = 0
    for point in fixed_points(kernel, fraction):
        ramp = lattice.fixed_ramp(point.word(kernel, lattice, cell), point.offset)
        total = signed(total + part(ramp, kernel.weight.of_square(*fixed_t(kernel, point.square))))
    return total


def fixed_slopes(kernel: Kernel, lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> list[int]:
    n = len(cell)
    totals = [0] * n
    for point in fixed_points(kernel, fraction):
        powers = fixed_t(kernel, point.square)
        h = point.word(kernel, lattice, cell)
        weight = kernel.weight.of_square(*powers)
        along = part(lattice.fixed_ramp(h, point.offset), kernel.weight.fall(*powers))
        for axis, (g, d) in enumerate(zip(lattice.fixed_octahedral(h, n), point.offset)):
            totals[axis] = signed(totals[axis] + signed(part(g, weight) - 2 * part(along, d >> 2)))
    return totals


def fixed_value(kernel: Kernel, lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> int:
    total, = lattice.fixed_sums(len(cell), lambda still: [fixed_sum(kernel, still, cell, fraction)])
    return ramps.scaled(total, fixed_scale(kernel, len(cell)))


def fixed_derivatives(kernel: Kernel, lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> list[int]:
    """In units of 2^-19 per cell."""
    totals = lattice.fixed_sums(len(cell), lambda still: fixed_slopes(kernel, still, cell, fraction))
    return [kernel.steps * ramps.scaled(total, fixed_scale(kernel, len(cell))) for total in totals]


# --- Noises -----------------------------------------------------------------------------------------------------

Exact = Callable[[Lattice, Sequence[int], Sequence[Fraction]], tuple[Fraction, ...]]
Fixed = Callable[[Lattice, Sequence[int], Sequence[int]], tuple[int, ...]]


def noise(kernels: Mapping[int, Kernel], with_derivatives: bool = False) -> tuple[Exact, Fixed]:
    """The two definitions of a noise, from its kernels by the number of dimensions."""
    def of(value_of: Callable, derivatives_of: Callable) -> Callable:
        def in_cell(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction | int]) -> tuple[Fraction | int, ...]:
            arguments = (kernels[len(cell)], lattice, cell, f)
            return (value_of(*arguments), *(derivatives_of(*arguments) if with_derivatives else ()))

        return in_cell

    return of(value, derivatives), of(fixed_value, fixed_derivatives)
