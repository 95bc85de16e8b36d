"""Section 8 of docs/reference/contract.md, what noises in fixed arithmetic share: coordinates, fade, interpolation, the
sine.

The formulas are the contract's, in Python's integers. Python's never overflow, so that the contract's words of
32 bits need two checks: `signed` and `word` raise where a value would not fit. Numbers that should wrap are masked in
place.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from fractions import Fraction

from proof.oracle import gradients, hashes
from proof.oracle.gradients import Knobs, Real
from proof.oracle.hashes import MASK

UNIT = 2**20  # the contract's I, of fractions
NOISE_UNIT = 2**21
SLOPE_UNIT = 2**19  # of derivatives
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


# --- Coordinates, the fade, interpolation ------------------------------------------------------------------------


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


@functools.cache
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


def part(d: int, t: int) -> int:
    """The part t of d, in units of 2^-18."""
    return signed(signed((d >> 9) * (t >> 9)) + signed((d >> 18) * (t & 511)))


def difference(a: int, b: int) -> int:
    """b - a, which wraps. It need not but in Perlin noise in space, at corners that have no weight."""
    return hashes.signed(b - a)


def lerp(a: int, b: int, t: int) -> int:
    """The interpolation from a to b by t, in units of 2^-18; it wraps where the difference does."""
    return hashes.signed(a + part(difference(a, b), t))


# --- The sine ----------------------------------------------------------------------------------------------------


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


def sine_of_turns(turns: int) -> int:
    """The sine of an arc in units of 2^-32 of a turn; in units of 2^-16."""
    q = turns & 0x7FFFFFFF
    g = sine_of_quarter(min(q, 0x80000000 - q))
    return -g if turns >> 31 else g


def cosine_and_sine(turns: int) -> tuple[int, int]:
    """The cosine and the sine, likewise rounded."""
    return sine_of_turns(turns + 2**30 & MASK), sine_of_turns(turns)


def sine_of_word(w: int) -> int:
    """S(w) in units of 2^-16."""
    g = sine_of_turns(turns_of(abs(gradients.round24(hashes.signed(w)))))
    return -g if w >> 31 else g


def sine_gradient(knobs: Knobs, point: Sequence[int], seed: int) -> tuple[int, ...]:
    """The components of the sine gradient at a point of the lattice, in units of 2^-16."""
    return tuple(map(sine_of_word, gradients.sine_arguments(knobs.hash, point, seed)))


def gradient(knobs: Knobs, cell: Sequence[int], seed: int = 0) -> tuple[Real, ...]:
    if not knobs.sine_in(len(cell)):
        return gradients.gradient(knobs, cell, seed)
    return tuple(Fraction(g, SINE_UNIT) for g in sine_gradient(knobs, cell, seed))
