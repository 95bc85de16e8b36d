"""Section 7 of docs/reference/contract.md: octave sums over a noise, exact, and in fixed arithmetic (section 8)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Generic, TypeVar

from proof.oracle.gradients import Knobs, Real
from proof.oracle.hashes import MASK, SEED_STEP
from proof.oracle.hashes import signed as wrapped
from proof.oracle.integers import NOISE_UNIT, clamp_to_int, signed, word
from proof.oracle.noises import Noise

SHIFT = (Fraction(11, 32), Fraction(19, 32), Fraction(23, 32), Fraction(27, 32))
# In 32nds the cosines and the sines of the rotations: in the plane of x and y, then of y and z, then of z and
# w.
ROTATIONS = ((25, 20), (29, 13), (25, 20))

Number = TypeVar("Number", int, Fraction)


@dataclass(frozen=True)
class Options:
    """The options of a sum beside the place and the seed."""
    octaves: Real  # the last counts in part, unless this is whole
    lacunarity: Real
    gain: Real
    strength: Real = 0
    footprint: Real = 0  # all octaves are visible
    amplitude: Real = 0
    phase: Real | None = None  # of the noise, the same in all octaves
    depth: Real = 0  # of gullies
    ex: Real = 0  # the slope that they begin with
    ey: Real = 0


@dataclass(frozen=True)
class Terms(Generic[Number]):
    """The sums over the octaves so far. In fixed arithmetic all are integers, in the units of the contract."""
    noises: list[Number]
    weights: list[Number]  # of the total
    shares: list[Number]  # the weights of the sum: less than those with a footprint
    gain: Number
    strength: Number


def clamped(x: Real, low: Real, high: Real) -> Fraction:
    return min(max(Fraction(x), Fraction(low)), Fraction(high))


def from_cell(options: Options) -> Options:
    """As a sum from a cell takes them."""
    return replace(options, lacunarity=clamped(options.lacunarity, 0, 255))


def lacunarity_of(options: Options, periods: Sequence[int]) -> Fraction:
    """As with fixed arithmetic and with periods."""
    factor = clamped(options.lacunarity, 0, 255)
    return Fraction(math.floor(factor)) if periods else factor


def rotate(q: Sequence[Number], thirty_second: Callable[[Number], Number]) -> list[Number]:
    """The rotation of a position, or of another vector. On the line it is left as it is."""
    q = list(q)
    for i, (cosine, sine) in zip(range(len(q) - 1), ROTATIONS):
        a, b = q[i:i + 2]
        q[i:i + 2] = thirty_second(cosine * a - sine * b), thirty_second(sine * a + cosine * b)
    return q


# --- Exact -------------------------------------------------------------------------------------------------------

Place = list[Fraction]


def at_position(p: Sequence[Real]) -> Place:
    return [Fraction(x) for x in p]


def in_cell(cell: Sequence[int], f: Sequence[Real]) -> Place:
    return [c + Fraction(x) for c, x in zip(cell, f)]


def most_octaves(options: Options) -> Fraction:
    """More than 32 count as 32."""
    return min(Fraction(options.octaves), Fraction(32))


def count_of(options: Options) -> int:
    """How many octaves there are."""
    return 0 if options.octaves < Fraction(1, 2**32) else math.ceil(most_octaves(options))


def growth_of(options: Options, periods: Sequence[int]) -> Fraction:
    """The lacunarity that counts."""
    return lacunarity_of(options, periods) if periods else Fraction(options.lacunarity)


def thirty_second(x: Fraction) -> Fraction:
    return x / 32


Octave = tuple[Place, Sequence[int], int]  # where it is sampled, with which periods and which seed


def following(octave: Octave, factor: Fraction) -> Octave:
    q, periods, seed = octave
    q = [x * factor for x in q]
    if not periods:
        q = rotate(q, thirty_second)
    return ([x + shift for x, shift in zip(q, SHIFT)], [int(period * factor) for period in periods],
            (seed + SEED_STEP) & MASK)


def octaves_of(q: Place, options: Options, seed: int, periods: Sequence[int] = ()) -> Iterator[Octave]:
    octave = (q, periods, seed)
    for _ in range(count_of(options)):
        yield octave
        octave = following(octave, growth_of(options, periods))


def weights(options: Options) -> list[Fraction]:
    count = count_of(options)
    found = [Fraction(options.gain)**i for i in range(count)]
    if count > 1:
        found[-1] *= most_octaves(options) - (count - 1)
    return found


def visible(options: Options, i: int) -> Fraction:
    """How much of octave i a footprint leaves."""
    detail = Fraction(options.footprint) * max(Fraction(options.lacunarity), Fraction(1))**i
    return clamped(Fraction(3, 2) - detail, 0, 1)


def terms(noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int,
          periods: Sequence[int] = ()) -> Terms[Fraction]:
    noises = [noise.exact(knobs, q, s, p)[0] for q, p, s in octaves_of(place, options, seed, periods)]
    found = weights(options)
    return Terms(noises, found, [weight * visible(options, i) for i, weight in enumerate(found)],
                 Fraction(options.gain), Fraction(options.strength))


def mean(of: Terms[Fraction], values: Sequence[Fraction]) -> Fraction:
    """The sum, divided by the total; 0 for no octaves."""
    if not values:
        return Fraction(0)
    return sum((share * value for share, value in zip(of.shares, values)), Fraction(0)) / sum(of.weights)


def within_one(of: Terms[Fraction]) -> list[Fraction]:
    return [clamped(n, -1, 1) for n in of.noises]


def fbm(of: Terms[Fraction]) -> Fraction:
    """In the range of the noise."""
    return mean(of, of.noises)


def turbulence(of: Terms[Fraction]) -> Fraction:
    """From 0 to the largest the noise can be."""
    return mean(of, list(map(abs, of.noises)))


def clouds(of: Terms[Fraction]) -> Fraction:
    """In [0, 1]."""
    t = clamped(2 * fbm(of) + Fraction(1, 4), 0, 1)
    return t * t * (3 - 2 * t)


def billow(of: Terms[Fraction]) -> Fraction:
    """In [-1, 1]."""
    return 2 * mean(of, list(map(abs, within_one(of)))) - 1


def ridged(of: Terms[Fraction]) -> Fraction:
    """In [0, 1]."""
    ridges, factor = [], Fraction(1)
    for n in within_one(of):
        ridges.append((1 - abs(n))**2 * factor)
        factor = min(2 * ridges[-1], Fraction(1))
    return mean(of, ridges)


def hybrid(of: Terms[Fraction]) -> Fraction:
    """In [0, 1]."""
    heights, factor = [], Fraction(1)
    for n in within_one(of):
        heights.append((1 + n) / 2 * factor)
        factor = min(2 * heights[-1], Fraction(1))
    return mean(of, heights)


def ping_pong(of: Terms[Fraction]) -> Fraction:
    """In [-1, 1]."""
    strength = clamped(of.strength, 0, 64)
    heights = [(n + 1) * strength % 2 for n in within_one(of)]
    return mean(of, [2 * min(t, 2 - t) - 1 for t in heights])


def weighted(of: Terms[Fraction]) -> Fraction:
    """In the range of the noise."""
    strength, noises = clamped(of.strength, 0, 1), within_one(of)
    shares, share = [], Fraction(1)
    for n in noises:
        shares.append(share)
        share *= of.gain * (1 - strength * (1 - n) / 2)
    return mean(replace(of, shares=shares), noises)


# --- Fixed -------------------------------------------------------------------------------------------------------

# A fixed-point position is a number of 56 bits in units of 2^-24 cells. The first one of a sum is given as cell and
# fraction, since the fraction of a caller may be a whole cell.
POSITION_UNIT = 2**24
FixedPlace = list[tuple[int, int]]


def fixed_at_position(p: Sequence[Real]) -> FixedPlace:
    found = []
    for x in map(Fraction, p):
        c = math.trunc(x)
        position = clamp_to_int(c) * POSITION_UNIT + math.trunc((x - c) * POSITION_UNIT)
        found.append(cell_and_rest(position))
    return found


def fixed_in_cell(cell: Sequence[int], f: Sequence[Real]) -> FixedPlace:
    return [(c, math.trunc(clamped(x, 0, 1) * POSITION_UNIT)) for c, x in zip(cell, f)]


def reduced(position: int) -> int:
    """To 56 bits, two's complement."""
    return (position + 2**55) % 2**56 - 2**55


def cell_and_rest(position: int) -> tuple[int, int]:
    return position >> 24, position & (POSITION_UNIT - 1)


FixedOctave = tuple[FixedPlace, Sequence[int], int]


def fixed_following(octave: FixedOctave, factor: Fraction) -> FixedOctave:
    place, periods, seed = octave
    multiplier = math.trunc(factor * 2**23)
    q = [reduced((cell * POSITION_UNIT + r) * multiplier >> 23) for cell, r in place]
    if not periods:
        q = rotate(q, lambda x: reduced(x >> 5))
    q = [reduced(x + int(shift * POSITION_UNIT)) for x, shift in zip(q, SHIFT)]
    return (list(map(cell_and_rest, q)), [wrapped(period * math.floor(factor)) for period in periods],
            (seed + SEED_STEP) & MASK)


def fixed_octaves_of(place: FixedPlace, options: Options, seed: int,
                     periods: Sequence[int] = ()) -> Iterator[FixedOctave]:
    octave = (place, periods, seed)
    for _ in range(count_of(options)):
        yield octave
        octave = fixed_following(octave, lacunarity_of(options, periods))


def fixed_at(noise: Noise, knobs: Knobs, octave: FixedOctave) -> tuple[int, ...]:
    """The result of the noise there, as integers in its units."""
    place, periods, seed = octave
    return noise.fixed_in_cell(noise.lattice(knobs, seed, periods), [cell for cell, _ in place],
                               [r >> 4 for _, r in place])


def product(a: int, b: int) -> int:
    """The product of two numbers in [0, 2^18], in units of 2^-18."""
    if not (0 <= a <= 2**18 and 0 <= b <= 2**18):
        raise OverflowError(f"{a} or {b} is not in [0, 2^18]")
    return signed(signed((a >> 9) * b) + (signed((a & 511) * b) >> 9)) >> 9


def in_weights(x: Real, high: int = 1) -> int:
    """A number in [0, high], in the units of weights."""
    return math.trunc(clamped(x, 0, high) * 2**18)


def fixed_weights(options: Options) -> list[int]:
    """The weights of the total, in units of 2^-18."""
    found, a = [], 2**18
    for _ in range(count_of(options)):
        found.append(a)
        a = product(a, in_weights(options.gain))
    if len(found) > 1:
        found[-1] = product(found[-1], in_weights(most_octaves(options) - (len(found) - 1)))
    return found


def fixed_visible(options: Options) -> Iterator[int]:
    """How much of each octave a footprint leaves, in units of 2^-18."""
    factor = max(math.trunc(clamped(options.lacunarity, 0, 255) * 2**23), 2**23)
    detail = math.trunc(clamped(options.footprint, 0, 2) * 2**24)
    while True:
        yield min(max(3 * 2**17 - (detail >> 6), 0), 2**18)
        detail = min(detail * factor >> 23, 2**25)


def fixed_terms(noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int,
                periods: Sequence[int] = ()) -> Terms[int]:
    noises = [math.trunc(Fraction(fixed_at(noise, knobs, octave)[0] * NOISE_UNIT, noise.units[0]))
              for octave in fixed_octaves_of(place, options, seed, periods)]
    found = fixed_weights(options)
    return Terms(noises, found, list(map(product, found, fixed_visible(options))), in_weights(options.gain),
                 in_weights(options.strength, 64))


def fixed_weighted_by(u: int, b: int) -> int:
    """The contract's `weighted`."""
    return signed(signed(u * (b >> 9)) + signed((u >> 9) * (b & 511))) >> 9


def fixed_mean(of: Terms[int], values: Sequence[int]) -> int:
    """The contract's v, in units of 2^-21."""
    if not values:
        return 0
    shares = sum(map(fixed_weighted_by, values, of.shares))
    return math.trunc(Fraction(signed(shares) * 2**18, signed(sum(of.weights))))


def fixed_within(of: Terms[int], largest: Real) -> list[int]:
    """The noise, or the nearer end."""
    end = int(largest * NOISE_UNIT)
    return [min(max(v, -end), end) for v in of.noises]


def density(v: int) -> int:
    """The density of clouds of an fBm, both in units of 2^-21."""
    t = min(max(2 * v + 2**19, 0), 2**21)
    c = (t - 2**20) >> 5
    return 2**20 + (signed(c * (word(0xC0000000 - word(c * c)) >> 16)) >> 10)


def fixed_fbm(of: Terms[int]) -> int:
    return fixed_mean(of, fixed_within(of, Fraction(3, 2)))


def fixed_turbulence(of: Terms[int]) -> int:
    return fixed_mean(of, list(map(abs, fixed_within(of, Fraction(3, 2)))))


def fixed_clouds(of: Terms[int]) -> int:
    return density(fixed_fbm(of))


def fixed_billow(of: Terms[int]) -> int:
    return 2 * fixed_mean(of, list(map(abs, fixed_within(of, 1)))) - 2**21


def fixed_ridged(of: Terms[int]) -> int:
    ridges, factor = [], 2**18
    for v in fixed_within(of, 1):
        d = (2**21 - abs(v)) >> 3
        ridges.append(product(product(d, d), factor))
        factor = min(2 * ridges[-1], 2**18)
    return fixed_mean(of, [ridge << 3 for ridge in ridges])


def fixed_hybrid(of: Terms[int]) -> int:
    heights, factor = [], 2**18
    for v in fixed_within(of, 1):
        heights.append(product((2**21 + v) >> 4, factor))
        factor = min(2 * heights[-1], 2**18)
    return fixed_mean(of, [height << 3 for height in heights])


def fixed_height(v: int, strength: int) -> int:
    """z_i of ping-pong, in units of 2^-30."""
    u = v + 2**21
    t = u * (strength >> 9) + (word(u * (strength & 511)) >> 9) & 2**31 - 1
    return min(t, 2**31 - t)


def fixed_ping_pong(of: Terms[int]) -> int:
    return fixed_mean(of, [(fixed_height(v, of.strength) >> 8) - 2**21 for v in fixed_within(of, 1)])


def fixed_weighted(of: Terms[int]) -> int:
    shares, share, noises = [], 2**18, fixed_within(of, 1)
    for v in noises:
        shares.append(share)
        left = 2**18 - product((2**21 - v) >> 4, min(of.strength, 2**18))
        share = product(product(share, left), of.gain)
    return fixed_mean(replace(of, shares=shares), noises)


# --- By name -----------------------------------------------------------------------------------------------------

# The exact sum, and the fixed one in units of 2^-21.
SUMS: dict[str, tuple[Callable[[Terms[Fraction]], Fraction], Callable[[Terms[int]], int]]] = {
    "fbm": (fbm, fixed_fbm), "turbulence": (turbulence, fixed_turbulence), "clouds": (clouds, fixed_clouds),
    "billow": (billow, fixed_billow), "ridged": (ridged, fixed_ridged), "hybrid": (hybrid, fixed_hybrid),
    "ping_pong": (ping_pong, fixed_ping_pong), "weighted": (weighted, fixed_weighted)}


def exact(name: str, noise: Noise, knobs: Knobs, place: Place, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> Fraction:
    return SUMS[name][0](terms(noise, knobs, place, options, seed, periods))


def fixed(name: str, noise: Noise, knobs: Knobs, place: FixedPlace, options: Options, seed: int = 0,
          periods: Sequence[int] = ()) -> Fraction:
    return Fraction(SUMS[name][1](fixed_terms(noise, knobs, place, options, seed, periods)), NOISE_UNIT)
