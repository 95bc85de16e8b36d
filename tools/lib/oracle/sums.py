"""Section 7 of docs/contract.md: octave sums over a noise, exact, and in fixed arithmetic (section 8)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction

from oracle.gradients import Knobs, Real
from oracle.integers import NOISE_UNIT, clamp_to_int, signed, word
from oracle.lattice import Lattice
from oracle.noises import Noise
from oracle.words import MASK, signed as wrapped

SHIFT = (Fraction(11, 32), Fraction(19, 32), Fraction(23, 32))


def clamped(lacunarity: Real) -> Fraction:
    """As with fixed arithmetic and with periods."""
    return min(max(Fraction(lacunarity), Fraction(0)), Fraction(255))


# --- Exact -------------------------------------------------------------------------------------------------------


def octave_terms(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int,
                 periods: Sequence[int] = ()) -> list[tuple[Fraction, Fraction]]:
    """The weight and the noise of each octave."""
    terms = []
    q = [Fraction(x) for x in p]
    factor = Fraction(math.floor(clamped(lacunarity))) if periods else Fraction(lacunarity)
    for i in range(octaves):
        value, *_ = noise.exact(knobs, q, seed, periods)
        terms.append((Fraction(gain)**i, value))
        q = [x * factor + shift for x, shift in zip(q, SHIFT)]
        periods = [int(period * factor) for period in periods]
        seed = (seed + 0x9E3779B9) & MASK
    return terms


def weighted_mean(terms: Sequence[tuple[Fraction, Fraction]]) -> Fraction:
    """sum(weight * value) / sum(weight); 0 for no terms."""
    if not terms:
        return Fraction(0)
    total = sum((weight * value for weight, value in terms), Fraction(0))
    return total / sum(weight for weight, _ in terms)


def fbm(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real,
        seed: int = 0, periods: Sequence[int] = ()) -> Fraction:
    """hn_fbm: in the range of the noise."""
    return weighted_mean(octave_terms(noise, knobs, p, octaves, lacunarity, gain, seed, periods))


def turbulence(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real,
               seed: int = 0, periods: Sequence[int] = ()) -> Fraction:
    """hn_turbulence: from 0 to the largest the noise can be."""
    terms = octave_terms(noise, knobs, p, octaves, lacunarity, gain, seed, periods)
    return weighted_mean([(weight, abs(value)) for weight, value in terms])


def clouds(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real,
           seed: int = 0, periods: Sequence[int] = ()) -> Fraction:
    """hn_clouds: in [0, 1]."""
    t = 2 * fbm(noise, knobs, p, octaves, lacunarity, gain, seed, periods) + Fraction(1, 4)
    t = min(max(t, Fraction(0)), Fraction(1))
    return t * t * (3 - 2 * t)


# --- Fixed -------------------------------------------------------------------------------------------------------


def position_of(p: Real) -> int:
    """A coordinate as a number of 64 bits: the cell, then the fraction in units of 2^-32."""
    exact = Fraction(p)
    c = math.trunc(exact)
    u = math.trunc(abs(exact - c) * 2**32)
    cell, r = clamp_to_int(c), word(u)
    if exact < c:
        cell, r = clamp_to_int(c) - (u != 0), -u & MASK
    return signed(cell) * 2**32 + r


def next_position(position: int, multiplier: int, shift: Fraction) -> int:
    """The position in the next octave; `multiplier` is the lacunarity in units of 2^-23."""
    moved = (position * multiplier >> 23) + int(shift * 2**32)
    return (moved + 2**63) % 2**64 - 2**63


def weights(octaves: int, gain: Real) -> list[int]:
    """The weight of each octave, in units of 2^-18."""
    g = math.trunc(min(max(Fraction(gain), Fraction(0)), Fraction(1)) * 2**18)
    values, a = [], 2**18
    for _ in range(min(octaves, 32)):
        values.append(a)
        a = signed(signed((a >> 9) * g) + (signed((a & 511) * g) >> 9)) >> 9
    return values


def fixed_values(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, seed: int,
                 periods: Sequence[int] = ()) -> list[int]:
    """The noise of each octave, in units of 2^-21."""
    factor = clamped(lacunarity)
    multiplier = math.floor(factor) * 2**23 if periods else math.trunc(factor * 2**23)
    positions = list(map(position_of, p))
    values = []
    for _ in range(octaves):
        lattice = Lattice(knobs, seed, tuple(periods))
        value, *_ = noise.fixed_in_cell(lattice, [q >> 32 for q in positions], [(q & MASK) >> 12 for q in positions])
        values.append(value)
        positions = [next_position(q, multiplier, shift) for q, shift in zip(positions, SHIFT)]
        periods = [wrapped(period * math.floor(factor)) for period in periods]
        seed = (seed + 0x9E3779B9) & MASK
    return values


def fixed_mean(values: Sequence[int], value_weights: Sequence[int]) -> int:
    """The contract's v, in units of 2^-21."""
    if not values:
        return 0
    terms = [signed(signed(v * (a >> 9)) + signed((v >> 9) * (a & 511))) >> 9 for v, a in zip(values, value_weights)]
    return math.trunc(Fraction(signed(sum(terms)) * 2**18, signed(sum(value_weights))))


def fixed_sum(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int,
              periods: Sequence[int], of_noise: Callable[[int], int] = int) -> int:
    """The weighted mean of `of_noise` of the noise, in units of 2^-21."""
    value_weights = weights(octaves, gain)
    values = fixed_values(noise, knobs, p, len(value_weights), lacunarity, seed, periods)
    return fixed_mean(list(map(of_noise, values)), value_weights)


def density(v: int) -> int:
    """The density of clouds of an fBm, both in units of 2^-21."""
    t = min(max(2 * v + 2**19, 0), 2**21)
    c = (t - 2**20) >> 5
    return 2**20 + (signed(c * (word(0xC0000000 - word(c * c)) >> 16)) >> 10)


def fixed_fbm(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real,
              seed: int = 0, periods: Sequence[int] = ()) -> Fraction:
    return Fraction(fixed_sum(noise, knobs, p, octaves, lacunarity, gain, seed, periods), NOISE_UNIT)


def fixed_turbulence(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real,
                     seed: int = 0, periods: Sequence[int] = ()) -> Fraction:
    return Fraction(fixed_sum(noise, knobs, p, octaves, lacunarity, gain, seed, periods, abs), NOISE_UNIT)


def fixed_clouds(noise: Noise, knobs: Knobs, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real,
                 seed: int = 0, periods: Sequence[int] = ()) -> Fraction:
    return Fraction(density(fixed_sum(noise, knobs, p, octaves, lacunarity, gain, seed, periods)), NOISE_UNIT)


# By name: the exact sum, and the fixed one.
SUMS: dict[str, tuple[Callable[..., Fraction], Callable[..., Fraction]]] = {
    "fbm": (fbm, fixed_fbm), "turbulence": (turbulence, fixed_turbulence), "clouds": (clouds, fixed_clouds)}
