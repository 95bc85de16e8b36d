"""Section 21 of docs/reference/contract.md: uniform values, and the spreads by which they are computed, exact, and in
fixed arithmetic.

Only the reach of a sum is irrational: it is off by less than 2^-199 times itself, far too little to change the
double nearest to it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TypeVar

from proof.oracle import sums
from proof.oracle.feature_points import fixed_root
from proof.oracle.gradients import Real
from proof.oracle.integers import signed, word
from proof.oracle.sums import clamped

Number = TypeVar("Number", int, Fraction)

LEAST_REACH, LARGEST_REACH = Fraction(1, 16), 3
MOST_OCTAVES = 32
UNIT = 2**21  # of values and the numbers of their spread
SUM_UNIT = 2**18  # of the numbers of the spread of a sum
PARTS = 1024  # of BELL and WAY
BELL = (103, 381, 736)
WAY = (592, 1958, 452)
VARIANCE = (65, 33, 17, 7)  # V
ROOT_BITS = 200

# By the numbers of the noises, from 1 on, and times TABLE_UNIT.
TABLE_UNIT = 4096
TABLE = ((4386, 1861, 2547, 3506), (4192, 1310, 2400, 3358), (4043, 833, 2233, 3164), (3957, 453, 1904, 2991),
         (3847, 1006, 2480, 3274), (3312, 126, 1874, 2995), (2423, 68, 1551, 2913), (3930, 91, 1356, 1679),
         (4082, 21, 1195, 3017), (2953, 348, 1923, 3001), (2707, 122, 1749, 2951), (4235, 4, 2867, 3147),
         (4253, 790, 1515, 3070), (3718, 507, 886, 2305), (4533, 51, 2427, 3152), (4162, 875, 2535, 3241),
         (2596, 306, 1551, 2823), (2954, 111, 1490, 2882))
PERLIN2 = 9  # that any other number counts as


def spread(noise: int) -> tuple[float, ...]:
    """hn_distribution."""
    number = noise if 1 <= noise <= len(TABLE) else PERLIN2
    return tuple(x / TABLE_UNIT for x in TABLE[number - 1])


# --- Exact -------------------------------------------------------------------------------------------------------


def in_range(reach: Real, a: Real, b: Real, c: Real) -> tuple[Fraction, ...]:
    """The numbers of a spread."""
    a = clamped(a, 0, 1)
    b = clamped(b, a, 1)
    return clamped(reach, LEAST_REACH, LARGEST_REACH), a, b, clamped(c, b, 1)


def tail(a: Fraction, b: Fraction, c: Fraction, y: Fraction) -> Fraction:
    """T."""
    return 4 * a * y * (1 - y)**3 + 6 * b * y**2 * (1 - y)**2 + 4 * c * y**3 * (1 - y) + y**4


def uniform_d(value: Real, *spread: Real) -> tuple[Fraction, Fraction]:
    reach, a, b, c = in_range(*spread)
    w = 1 - min(abs(Fraction(value)) / reach, Fraction(1))
    y = w**2
    half = tail(a, b, c, y) / 2
    slope = 4 * w * (a * (1 - y)**3 + 3 * (b - a) * y * (1 - y)**2 + 3 * (c - b) * y**2 * (1 - y) + (1 - c) * y**3)
    return (1 - half if value >= 0 else half), slope / reach


def weights(octaves: Real, gain: Real) -> list[Fraction]:
    """A_i; the last counts in part."""
    return sums.weights(options(octaves, gain))


def options(octaves: Real, gain: Real) -> sums.Options:
    return sums.Options(clamped(octaves, 1, MOST_OCTAVES), 1, clamped(gain, 0, 1))


def variance(coefficients: Sequence[Number], one: Number) -> Number:
    """V, of numbers in the unit of one."""
    return sum((factor * x for factor, x in zip(VARIANCE, (*coefficients, one), strict=True)), 0 * one)


def root(x: Fraction) -> Fraction:
    """Exact where the root is rational."""
    square = x.numerator * x.denominator
    return Fraction(math.isqrt(square << 2 * ROOT_BITS), x.denominator << ROOT_BITS)


def spread_fbm(*arguments: Real) -> tuple[Fraction, ...]:
    """hn_distribution_fbm: of a spread, octaves and a gain."""
    *spread, octaves, gain = arguments
    reach, *coefficients = in_range(*spread)
    found = weights(octaves, gain)
    s1, s2, s4, s8 = (sum((a**n for a in found), Fraction(0)) for n in (1, 2, 4, 8))
    rho4, rho8 = s4 / s2**2, s8 / s2**4
    d = coefficients[2] - Fraction(BELL[2], PARTS)
    of_sum = []
    for x, bell, way in zip(coefficients, BELL, WAY):
        at, moved = Fraction(bell, PARTS), Fraction(way, PARTS) * d
        of_sum.append(clamped(at + rho4 * moved + rho8 * (x - at - moved), 0, 1))
    ratio = variance(coefficients, Fraction(1)) / variance(of_sum, Fraction(1))
    return reach * root(s2 * ratio) / s1, *of_sum


# --- Fixed -------------------------------------------------------------------------------------------------------


def fixed_in_range(unit: int, reach: Real, a: Real, b: Real, c: Real) -> tuple[int, ...]:
    """The numbers of a spread as integers."""
    r = math.trunc(clamped(reach, LEAST_REACH, LARGEST_REACH) * unit)
    a, b, c = (math.trunc(clamped(x, 0, 1) * unit) for x in (a, b, c))
    b = max(a, b)
    return r, a, b, max(b, c)


def product(a: int, b: int) -> int:
    """As the weights of sums, but a may be negative, and both may be above 1."""
    if b < 0:
        raise OverflowError(f"{b} is negative")
    return signed(signed((a >> 9) * b) + (word((a & 511) * b) >> 9)) >> 9


def quotient(x: int, t: int) -> int:
    """mean(x, t)."""
    return x * 2**18 // t


def mix(p: int, q: int, y: int) -> int:
    return p + product(q - p, y)


def fixed_uniform_d(value: Real, *spread: Real) -> tuple[Fraction, Fraction]:
    r, a, b, c = fixed_in_range(UNIT, *spread)
    v = math.trunc(clamped(value, -LARGEST_REACH, LARGEST_REACH) * UNIT)
    w = 2**18 - quotient(min(abs(v), r), r)
    y = product(w, w)
    numbers = [0, a, b, c, UNIT]
    while len(numbers) > 2:
        numbers = [mix(p, q, y) for p, q in zip(numbers, numbers[1:])]
    t0, t1 = numbers
    t = mix(t0, t1, y)
    slope = signed(quotient(4 * product(t1 - t0, w), r))
    return Fraction(t if v < 0 else 2 * UNIT - t, 2 * UNIT), Fraction(slope, 2**18)


def fixed_spread_fbm(*arguments: Real) -> tuple[Fraction, ...]:
    """hn_distribution_fbm: of a spread, octaves and a gain."""
    *spread, octaves, gain = arguments
    r, *coefficients = fixed_in_range(SUM_UNIT, *spread)
    of_one = sums.fixed_weights(options(octaves, gain))
    of_two = [product(a, a) for a in of_one]
    of_four = [product(a, a) for a in of_two]
    of_eight = [product(a, a) for a in of_four]
    s1, s2, s4, s8 = map(sum, (of_one, of_two, of_four, of_eight))
    reciprocal = quotient(SUM_UNIT, s2)  # R
    rho4 = product(product(s4, reciprocal), reciprocal)
    squared = product(reciprocal, reciprocal)  # Q
    rho8 = product(product(s8, squared), squared)
    step = SUM_UNIT // PARTS
    of_sum = []
    for x, bell, way in zip(coefficients, BELL, WAY):
        h = signed(way * (coefficients[2] - BELL[2] * step)) // PARTS
        moved = bell * step + product(h, rho4) + product(x - bell * step - h, rho8)
        of_sum.append(min(max(moved, 0), SUM_UNIT))
    v, v_of_sum = (signed(variance(some, SUM_UNIT)) >> 3 for some in (coefficients, of_sum))
    reciprocal = quotient(SUM_UNIT, s1)  # W
    n = product(product(s2, reciprocal), reciprocal)
    ratio = min(quotient(product(v, n), v_of_sum), 2**21)  # P
    reach = product(r, fixed_root(word(ratio << 10)))
    return tuple(Fraction(x, SUM_UNIT) for x in (reach, *of_sum))
