"""Section 23 of docs/reference/contract.md: phasor noise, a sum of waves around the points of the lattices of simplex
noise.

A caller chooses the wave: so many turns of the phase there are in a cell, along each axis. With a bandwidth each point
has a wave of its own, about that.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TypeVar

from proof.oracle import integers, kernels, numbers, ramps, rotation
from proof.oracle.gradients import Real
from proof.oracle.hashes import MASK, component_word
from proof.oracle.integers import NOISE_UNIT, part, signed
from proof.oracle.kernels import Kernel
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise, rotating, simplex

Number = TypeVar("Number", int, Fraction)

OUTPUTS = ("value", "quadrature")
UNITS = (NOISE_UNIT,) * 2
# By the number of dimensions. The lattices and t are as for simplex noise. In space the same weight falls twice as
# fast, since t does.
KERNELS = {2: replace(simplex.KERNELS[2], weight=kernels.PLANE_EVEN, scale=762),
           3: replace(simplex.KERNELS[3], weight=kernels.SPACE_EVEN, scale=674)}

MOST = 16  # waves in a cell, along each axis
TURN = 2**32  # in units of words
FIXED_WAVE = 2**16  # the unit of K


def clamped(wave: Sequence[Real]) -> list[Fraction]:
    """k."""
    return [min(max(Fraction(k), Fraction(-MOST)), Fraction(MOST)) for k in wave]


def bandwidth_of(lattice: Lattice) -> Fraction:
    """b."""
    return min(max(Fraction(lattice.choice.bandwidth or 0), Fraction(0)), Fraction(MOST))


def direction(h: int, n: int) -> tuple[int, ...]:
    """U of a point's word, in n dimensions."""
    g, height = component_word(h, 1), component_word(h, 2)
    return numbers.circle_units(g) if n == 2 else numbers.sphere_of(g, height)


def summed(waves: Iterable[tuple[Number, Sequence[Number]]],
           product: Callable[[Number, Number], Number]) -> tuple[Number, ...]:
    """The sums of cosines and of sines: of each point its weight, and both."""
    return tuple(map(sum, zip(*([product(x, weight) for x in wave] for weight, wave in waves))))


# --- Exact ------------------------------------------------------------------------------------------------------


def wave_of(lattice: Lattice, h: int) -> list[Fraction]:
    """k_i of the point with the word h: k without a bandwidth."""
    wave, b = clamped(lattice.choice.wave), bandwidth_of(lattice)
    return clamped([k + b * u / numbers.POINT_UNIT for k, u in zip(wave, direction(h, len(wave)), strict=True)])


def along(kernel: Kernel, wave: Sequence[Fraction], d: Sequence[Fraction]) -> Fraction:
    """k . d, in turns; an offset is in steps, and a wave counts in a cell."""
    return sum(k * x for k, x in zip(wave, d, strict=True)) / kernel.steps


def turns(lattice: Lattice, kernel: Kernel, h: int, d: Sequence[Fraction]) -> Fraction:
    """a, at the offset d from a point with the word h."""
    return Fraction(h, TURN) + Fraction(lattice.phase) + along(kernel, wave_of(lattice, h), d)


def waves(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]
          ) -> Iterator[tuple[Sequence[Fraction], Fraction, tuple[Fraction, Fraction], Sequence[Fraction]]]:
    """For each point the offset from it in steps, t, the cosine and the sine of its turns, and its wave."""
    kernel = KERNELS[len(cell)]
    for point, d, t in kernels.weighted_points(kernel, tuple(f)):
        h = point.word(kernel, lattice, cell)
        yield d, t, rotation.cosine_and_sine(turns(lattice, kernel, h, d)), wave_of(lattice, h)


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    kernel = KERNELS[len(cell)]
    weighted = [(kernel.weight.exact(t), wave) for _, t, wave, _ in waves(lattice, cell, f)]
    return tuple(Fraction(kernel.scale, 1024) * total for total in summed(weighted, lambda x, weight: x * weight))


# --- Fixed ------------------------------------------------------------------------------------------------------


def fixed_wave(wave: Sequence[Real]) -> list[int]:
    """K."""
    return [math.trunc(k * FIXED_WAVE) for k in clamped(wave)]


def fixed_wave_of(lattice: Lattice, h: int) -> list[int]:
    """The waves of the point with the word h."""
    wave, b, most = fixed_wave(lattice.choice.wave), math.trunc(bandwidth_of(lattice) * FIXED_WAVE), MOST * FIXED_WAVE
    return [min(max(k + (b * u >> 16), -most), most) for k, u in zip(wave, direction(h, len(wave)), strict=True)]


def fixed_along(kernel: Kernel, wave: Sequence[int], d: Sequence[int]) -> int:
    """D, in units of 2^-32 turns; several have a sum, and only the sum of all is reduced. The products have 40 bits."""
    return sum(k * x // (2**4 * kernel.steps) for k, x in zip(wave, d, strict=True))


def fixed_turns(lattice: Lattice, kernel: Kernel, h: int, d: Sequence[int]) -> int:
    """a, a word."""
    return h + rotation.angle(lattice.phase) + fixed_along(kernel, fixed_wave_of(lattice, h), d) & MASK


def fixed_waves(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]
                ) -> Iterator[tuple[Sequence[int], tuple[int, int], tuple[int, int], Sequence[int]]]:
    """For each point the offset from it in units of 2^-20 steps, t and Q, the cosine and the sine times 2^29, and its
    waves."""
    kernel = KERNELS[len(cell)]
    for point in kernels.fixed_points(kernel, fraction):
        h = point.word(kernel, lattice, cell)
        cosine, sine = integers.cosine_and_sine(fixed_turns(lattice, kernel, h, point.offset))
        yield (point.offset, kernels.fixed_t(kernel, point.square), (signed(2**13 * cosine), signed(2**13 * sine)),
               fixed_wave_of(lattice, h))


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    kernel = KERNELS[len(cell)]
    weighted = [(kernel.weight.of_square(*powers), wave) for _, powers, wave, _ in fixed_waves(lattice, cell, fraction)]
    return tuple(ramps.scaled(signed(total), kernel.scale) for total in summed(weighted, part))


NOISES = tuple(rotating(Noise("", exact, fixed, OUTPUTS, UNITS), name) for name in ("phasor", "phasor_bandwidth"))
