"""Sections 4 and 5 of docs/contract.md: from a hash to a float, and the gradient at a lattice point.

Section 4 is exact in the library too. Of the sine gradient only the oracle is: a sine is irrational, so it is off by
less than SINE_ERROR, far too little to change the double nearest to it.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from oracle.words import HASHES, MASK, hash_words, mix, point_word, signed


# --- Section 4: from a hash to a float ---------------------------------------------------------------------------


def unorm(h: int) -> float:
    """hn_unorm: in [0, 1)."""
    return (h >> 8) / 2**24


def snorm(h: int) -> float:
    """hn_snorm: in [-1, 1)."""
    return (h >> 8) / 2**23 - 1


def middle(i: int, count: int) -> float:
    """The middle of interval i of `count` equal ones of [-1, 1]: the contract's `a`, `p` and `q`."""
    return (2 * i + 1) / count - 1


def gradient2(h: int) -> tuple[float, float]:
    """hn_gradient2: a point of the square |x| + |y| = 1."""
    a = middle(h >> 22 & 511, 512)
    m = 1 - abs(a)
    return (a, -m if h >> 31 else m)


def gradient3(h: int) -> tuple[float, float, float]:
    """hn_gradient3: a point of the octahedron |x| + |y| + |z| = 1."""
    p = middle(h >> 23 & 255, 256)
    q = middle(h >> 15 & 255, 256)
    m = 1 - max(abs(p), abs(q))
    return ((p + q) / 2, (p - q) / 2, -m if h >> 31 else m)


# --- Section 5: the gradient at a lattice point ------------------------------------------------------------------


# From here on every value is exact: a real number, as a fraction. Who prints one rounds it, once.
Real = Fraction | float


@dataclass(frozen=True)
class Knobs:
    """What the noise depends on besides its arguments: HN_HASH, HN_GRADIENT (octahedral or sine) and HN_PERIOD.
    HN_ARITHMETIC says only how it is computed."""
    hash: str
    sine: bool = False
    period: int = 0  # 0: none

    def __post_init__(self) -> None:
        power_of_two = self.period & (self.period - 1) == 0
        if self.hash not in HASHES or not 0 <= self.period <= (2**30 if power_of_two else 2**20):
            raise ValueError(f"no setting of the library: {self}")


def wrapped(coordinate: int, period: int) -> int:
    """A coordinate of a cell, moved into [0, period) if there is a period."""
    # The far corner of the cell at INT_MAX is at 2^31: it wraps where there is no period.
    return coordinate - period * (coordinate // period) if period else signed(coordinate)


def round24(n: int) -> int:
    """The number of 24 significant bits that is nearest to n, ties to even."""
    step = 2 ** max(n.bit_length() - 24, 0)
    return round(Fraction(n, step)) * step  # Python rounds a fraction half to even


# --- The sine ----------------------------------------------------------------------------------------------------


# The fixed point of the sine. PI is off by less than 2^9 units (16 times 1/2 for each of its 42 terms, little more),
# and reducing an arc of 2^31 takes it less than 2^30 times: 2^39 units. That leaves nearly three times a double's bits.
SINE_BITS = 192
SINE_ERROR = Fraction(1, 2**150)


def arctan_inverse(n: int) -> int:
    """arctan(1 / n) in fixed point, by its series."""
    power, total, i = 2**SINE_BITS // n, 0, 0
    while power:
        total += (-1)**i * (power // (2 * i + 1))
        power, i = power // n**2, i + 1
    return total


PI = 4 * (4 * arctan_inverse(5) - arctan_inverse(239))  # Machin's formula


@functools.cache
def sine(n: int) -> Fraction:
    """The sine of n radians, -2^31 <= n <= 2^31, off by less than SINE_ERROR."""
    one = 2**SINE_BITS
    half_turns = (n * one + PI // 2) // PI
    x = n * one - half_turns * PI  # in [-pi/2, pi/2]
    term, total, i = x, 0, 1
    while term:
        total += term
        term, i = -term * x * x // (one * one * (i + 1) * (i + 2)), i + 2
    return Fraction(total if half_turns % 2 == 0 else -total, one)


def sine_of_word(w: int) -> Fraction:
    """The contract's S(w)."""
    return sine(round24(signed(w)))


def sine_arguments(name: str, cell: Sequence[int], seed: int) -> list[int]:
    """The words of which the paper's gradient, in 2D or 3D, takes the sine, under the hash `name`."""
    chained = [hash_words(name, [cell[0] & MASK]) ^ mix(seed)]
    for c in cell[1:]:
        chained.append(hash_words(name, [(chained[-1] + c) & MASK]))
    return [(chained[-1] + word) & MASK for word in chained]


# By the number of dimensions.
OCTAHEDRAL: dict[int, Callable[[int], tuple[float, ...]]] = {2: gradient2, 3: gradient3}


def gradient(knobs: Knobs, cell: Sequence[int], seed: int = 0) -> tuple[Real, ...]:
    """hn_gradient in 2D or 3D."""
    point = [wrapped(c, knobs.period) for c in cell]
    if knobs.sine:
        return tuple(sine_of_word(word) for word in sine_arguments(knobs.hash, point, seed))
    return OCTAHEDRAL[len(cell)](point_word(knobs.hash, point, seed))
