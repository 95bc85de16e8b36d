"""The oracle of fixed arithmetic: section 8 of docs/contract.md, HN_FIXED, which gives the same bits everywhere.

Written from the contract alone, as oracle.py, whose hashes, gradients and names of configurations it takes. The
formulas are those of the contract, in Python's integers. Those never overflow, so that the contract's words of 32 bits
need two checks: `signed` and `word` raise where a value would not fit. What should wrap is masked, where it stands.

Functions of the same name as in oracle.py take the same arguments. Their values are exactly those of the library.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction

from oracle import exact as oracle
from oracle.exact import MASK, Real

UNIT = 2**20  # the contract's I, of fractions
NOISE_UNIT = 2**21
SINE_UNIT = 2**16


def signed(n: int) -> int:
    """The number itself, which must be a signed integer of 32 bits."""
    if not -2**31 <= n < 2**31:
        raise OverflowError(f"{n} does not fit a signed integer")
    return n


def word(n: int) -> int:
    """The number itself, which must be a word."""
    if not 0 <= n <= MASK:
        raise OverflowError(f"{n} does not fit a word")
    return n


# --- Coordinates, the fade, interpolation -----------------------------------------------------------------------


def clamp_to_int(c: int) -> int:
    """A whole coordinate within the range of int: at most the largest float there."""
    return min(max(c, -2147483648), 2147483520)


def fraction_of(f: Real) -> int:
    """The fraction that a caller gives, in [0, UNIT]."""
    return math.trunc(min(max(Fraction(f), Fraction(0)), Fraction(1)) * UNIT)


def cell_and_fraction(p: Real) -> tuple[int, int]:
    """The cell of a coordinate, and its fraction in [0, UNIT)."""
    exact = Fraction(p)
    c = math.trunc(exact)
    k = math.trunc((exact - c) * UNIT)
    return signed(clamp_to_int(c) + (k >> 20)), k & (UNIT - 1)


def fade(fraction: int) -> int:
    """The weight of the far corner along one axis, in units of 2^-18."""
    g = min(fraction, UNIT - fraction)
    x = min(g + 4, 2**19 - 1) >> 3
    s = word(x * x)
    z = word(s + 2**15) >> 16
    r = word(1572864 - 30 * x + 6 * z) >> 2
    q = word(s + (word(z * r) >> 2) + 2**15) >> 16
    t = word(word(x * q) + 2**14) >> 15
    return 2**18 - t if fraction > 2**19 else t


def lerp(a: int, b: int, t: int) -> int:
    """The interpolation from a to b by t, in units of 2^-18."""
    d = signed(b - a)
    return signed(a + signed(signed((d >> 9) * (t >> 9)) + signed((d >> 18) * (t & 511))))


# --- The sine ---------------------------------------------------------------------------------------------------


def turns_of(m: int) -> int:
    """The arc of m radians, 0 <= m <= 2^31, in units of 2^-32 of a turn; whole turns are left out."""
    high, low = m >> 16, m & 0xFFFF
    return (m * 0x28BE60DB + word(high * 0x9391) + (word(high * 0x054A + low * 0x9391) >> 16)) & MASK


def sine_of_quarter(q: int) -> int:
    """The sine of q, in units of 2^-30 of a quarter turn, up to one; in units of 2^-16."""
    x = min((q + 2**13) >> 14, 65535)
    u = word(x * x) >> 16
    y = 102943 - (word(u * (42328 - (word(u * (5208 - (word(u * 288) >> 16))) >> 16))) >> 16)
    return word(x * (y >> 1) + 2**14) >> 15


def sine_of_word(w: int) -> int:
    """S(w) in units of 2^-16."""
    turns = turns_of(abs(oracle.round24(oracle.signed(w))))
    q = turns & 0x7FFFFFFF
    q = min(q, 0x80000000 - q)
    g = sine_of_quarter(q)
    return -g if turns >> 31 != w >> 31 else g


# --- Ramps and noise --------------------------------------------------------------------------------------------


def sign_of(h: int, m: int) -> int:
    """m, negated if bit 31 of h is set."""
    return -m if h >> 31 else m


def ramp2(h: int, d: Sequence[int]) -> int:
    """The octahedral ramp in the plane, in units of 2^-29, of the word h of a corner at the offset d from it."""
    a = 2 * (h >> 22 & 511) - 511
    m = sign_of(h, 512 - abs(a))
    return signed(signed(a * d[0]) + signed(m * d[1]))


def ramp3(h: int, d: Sequence[int]) -> int:
    """The octahedral ramp in space, likewise."""
    p = 2 * (h >> 23 & 255) - 255
    q = 2 * (h >> 15 & 255) - 255
    m = sign_of(h, 256 - max(abs(p), abs(q)))
    flat = signed(signed(p * (d[0] + d[1])) + signed(q * (d[0] - d[1])))
    return signed(flat + signed(m * 2 * d[2]))


# By the number of dimensions: the ramp, and the scale of the noise.
OCTAHEDRAL: dict[int, tuple[Callable[[int, Sequence[int]], int], int]] = {2: (ramp2, 1913), 3: (ramp3, 1819)}


def sine_ramp(gradient: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a sine gradient, in units of 2^-28."""
    return signed(sum(signed((g >> 8) * x) + (signed((g & 255) * x) >> 8) for g, x in zip(gradient, d)))


def sine_gradient(knobs: oracle.Configuration, point: Sequence[int], seed: int) -> tuple[int, ...]:
    """The components of the sine gradient at a point of the lattice that is already wrapped, in units of 2^-16."""
    return tuple(map(sine_of_word, oracle.sine_arguments(knobs.hash, point, seed)))


def corner_ramp(knobs: oracle.Configuration, corner: Sequence[int], d: Sequence[int], seed: int) -> int:
    """The ramp of a corner at the offset d from it."""
    point = [oracle.wrapped(c, knobs.period) for c in corner]
    if knobs.sine:
        return sine_ramp(sine_gradient(knobs, point, seed), d)
    ramp, _ = OCTAHEDRAL[len(point)]
    return ramp(oracle.point_word(knobs.hash, point, seed), d)


def noise(name: str, cell: Sequence[int], fraction: Sequence[int], seed: int) -> int:
    """The noise of a cell and a fraction, in units of 2^-21."""
    knobs = oracle.configuration(name)
    values = []
    for offset in itertools.product((0, 1), repeat=len(cell)):
        corner = [c + o for c, o in zip(cell, offset)]
        values.append(corner_ramp(knobs, corner, [f - o * UNIT for f, o in zip(fraction, offset)], seed))
    # Of the corners the first half has o = 0 along x, the second o = 1; so it goes on with y and z.
    for f in fraction:
        half = len(values) // 2
        values = [lerp(a, b, fade(f)) for a, b in zip(values[:half], values[half:])]
    n, = values
    if knobs.sine:
        return n >> 7
    _, scale = OCTAHEDRAL[len(cell)]
    return signed(signed(((n + 256) >> 9) * scale) + 256) >> 9


def gradient(name: str, cell: Sequence[int], seed: int = 0) -> tuple[Real, ...]:
    """hn_gradient in 2D or 3D."""
    knobs = oracle.configuration(name)
    if not knobs.sine:
        return oracle.gradient(name, cell, seed)
    point = [oracle.wrapped(c, knobs.period) for c in cell]
    return tuple(Fraction(g, SINE_UNIT) for g in sine_gradient(knobs, point, seed))


def perlin_cell(name: str, cell: Sequence[int], fraction: Sequence[Real], seed: int = 0) -> Fraction:
    """hn_perlin(cell, f, seed) in 2D or 3D."""
    return Fraction(noise(name, cell, list(map(fraction_of, fraction)), seed), NOISE_UNIT)


def perlin(name: str, p: Sequence[Real], seed: int = 0) -> Fraction:
    """hn_perlin(p, seed) in 2D or 3D."""
    cell, fraction = zip(*map(cell_and_fraction, p))
    return Fraction(noise(name, cell, fraction, seed), NOISE_UNIT)


# --- Octave sums ------------------------------------------------------------------------------------------------


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


def octave_values(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, seed: int) -> list[int]:
    """The noise of each octave, in units of 2^-21."""
    multiplier = math.trunc(min(max(Fraction(lacunarity), Fraction(0)), Fraction(255)) * 2**23)
    positions = list(map(position_of, p))
    values = []
    for _ in range(octaves):
        values.append(noise(name, [q >> 32 for q in positions], [(q & MASK) >> 12 for q in positions], seed))
        positions = [next_position(q, multiplier, shift) for q, shift in zip(positions, oracle.SHIFT)]
        seed = (seed + 0x9E3779B9) & MASK
    return values


def weighted_mean(values: Sequence[int], value_weights: Sequence[int]) -> int:
    """The contract's v, in units of 2^-21."""
    if not values:
        return 0
    terms = [signed(signed(v * (a >> 9)) + signed((v >> 9) * (a & 511))) >> 9 for v, a in zip(values, value_weights)]
    return math.trunc(Fraction(signed(sum(terms)) * 2**18, signed(sum(value_weights))))


def octave_sum(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int,
               of_noise: Callable[[int], int] = int) -> int:
    """The weighted mean of `of_noise` of the noise, in units of 2^-21."""
    value_weights = weights(octaves, gain)
    values = octave_values(name, p, len(value_weights), lacunarity, seed)
    return weighted_mean(list(map(of_noise, values)), value_weights)


def density(v: int) -> int:
    """The density of clouds of an fBm, both in units of 2^-21."""
    t = min(max(2 * v + 2**19, 0), 2**21)
    c = (t - 2**20) >> 5
    return 2**20 + (signed(c * (word(0xC0000000 - word(c * c)) >> 16)) >> 10)


def fbm(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int = 0) -> Fraction:
    """hn_fbm."""
    return Fraction(octave_sum(name, p, octaves, lacunarity, gain, seed), NOISE_UNIT)


def turbulence(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int = 0) -> Fraction:
    """hn_turbulence."""
    return Fraction(octave_sum(name, p, octaves, lacunarity, gain, seed, abs), NOISE_UNIT)


def clouds(name: str, p: Sequence[Real], octaves: int, lacunarity: Real, gain: Real, seed: int = 0) -> Fraction:
    """hn_clouds."""
    return Fraction(density(octave_sum(name, p, octaves, lacunarity, gain, seed)), NOISE_UNIT)
