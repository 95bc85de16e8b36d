"""Section 24 of docs/reference/contract.md: what gullies add to a height, and to its slopes.

Each octave is phasor noise whose waves run across the slope that those before it have left.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from proof.oracle import jacobians, noises, sums
from proof.oracle.feature_points import fixed_root, root
from proof.oracle.gradients import Knobs
from proof.oracle.hashes import signed as wrapped
from proof.oracle.integers import NOISE_UNIT, signed
from proof.oracle.jacobians import clamped_to, coarse, prod
from proof.oracle.lattice import Choice
from proof.oracle.sums import FixedPlace, Options, Place, clamped, product

PHASOR = noises.find("phasor_d")
LARGEST_SLOPE, LARGEST_DEPTH = 8, 8
SLOPE_UNIT = 2**16
UNITS = (NOISE_UNIT, SLOPE_UNIT, SLOPE_UNIT)
NOTHING = (0, 0)  # the periods of a tile that has none


def whole(options: Options) -> Options:
    """With the lacunarity of a tile."""
    return replace(options, lacunarity=sums.lacunarity_of(options, NOTHING))


def wave_of(u: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
    """k_i: across the slope."""
    x, y = u
    return (-Fraction(3, 2) * y, Fraction(3, 2) * x)


# --- Exact -------------------------------------------------------------------------------------------------------


def unit_of(e: Sequence[Fraction]) -> tuple[list[Fraction], Fraction]:
    """u_i, and how long it is."""
    length = root(sum(x * x for x in e))
    factor = 1 / (length + Fraction(1, 8))
    return [jacobians.rounded(x * factor) for x in e], jacobians.rounded(length * factor)


def exact(knobs: Knobs, place: Place, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    options, periods = whole(options), tuple(periods) or NOTHING
    depth = clamped(options.depth, 0, LARGEST_DEPTH)
    start = [clamped(x, -LARGEST_SLOPE, LARGEST_SLOPE) for x in (options.ex, options.ey)]
    height, e, doubled = Fraction(0), start, replace(options, footprint=2 * Fraction(options.footprint))
    for i, (q, p, s) in enumerate(sums.octaves_of(place, options, seed, periods)):
        u, length = unit_of(e)
        share = Fraction(options.gain)**i * length * sums.visible(doubled, i)
        value, _, dx, _, dy, _ = PHASOR.chosen(Choice(wave=wave_of(u))).exact(knobs, q, s, p)
        height += share * value
        grown = depth * options.lacunarity**i * share
        e = [clamped(jacobians.rounded(x + grown * g), -LARGEST_SLOPE, LARGEST_SLOPE) for x, g in zip(e, (dx, dy))]
    return (depth * height, *(after - before for before, after in zip(start, e)))


# --- Fixed -------------------------------------------------------------------------------------------------------

LARGEST_FIXED_SLOPE = LARGEST_SLOPE * SLOPE_UNIT


def over(x: int, d: int) -> int:
    """A part of the length D that a slope has for a wave, in units of 2^-21."""
    return int(math.copysign(2**19 * abs(x) // d, x))


def fixed_unit(e: Sequence[int]) -> tuple[list[int], int]:
    """u, and how long it is in units of 2^-18."""
    r = fixed_root(sum(x * x for x in e) // 2**12)
    d = r + 2**11
    return [over(x, d) for x in e], over(4 * r, d) >> 3


def fixed_growths(options: Options) -> Iterator[int]:
    """c_i of each octave, without end."""
    c = sums.in_weights(options.depth, LARGEST_DEPTH)
    m = sums.in_weights(options.gain) * math.trunc(options.lacunarity * 2**23) >> 23
    while True:
        yield c
        c = prod(c, m)


def fixed(knobs: Knobs, place: FixedPlace, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
    options, periods = whole(options), tuple(periods) or NOTHING
    start = [math.trunc(clamped(x, -LARGEST_SLOPE, LARGEST_SLOPE) * SLOPE_UNIT) for x in (options.ex, options.ey)]
    height, e, doubled = 0, start, replace(options, footprint=2 * Fraction(options.footprint))
    octaves = sums.fixed_octaves_of(place, options, seed, periods)
    for (at, p, s), weight, visible, growth in zip(octaves, sums.fixed_weights(options), sums.fixed_visible(doubled),
                                                   fixed_growths(options)):
        u, length = fixed_unit(e)
        share = product(length, visible)
        wave = wave_of([Fraction(x, NOISE_UNIT) for x in u])
        lattice = PHASOR.chosen(Choice(wave=wave)).lattice(knobs, s, p)
        value, _, dx, _, dy, _ = PHASOR.fixed_in_cell(lattice, [cell for cell, _ in at], [r >> 4 for _, r in at])
        height = signed(height + sums.fixed_weighted_by(value, product(weight, share)))
        e = [clamped_to(wrapped(x + prod(g, prod(growth, share))), LARGEST_FIXED_SLOPE) for x, g in zip(e, (dx, dy))]
    numbers = (coarse(prod(height, sums.in_weights(options.depth, LARGEST_DEPTH))),
               *(after - before for before, after in zip(start, e)))
    return tuple(Fraction(number, unit) for number, unit in zip(numbers, UNITS))
