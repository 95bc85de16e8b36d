"""Sections 4 and 5 of docs/reference/contract.md: from a hash to a float, and the gradient at a lattice point.

Section 4 is exact in the library too. For the sine gradient only the oracle is: a sine is irrational, so it is off by
less than SINE_ERROR, far too little to change the double nearest to it.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Union

from proof.oracle.hashes import HASHES, MASK, hash_words, mix, point_word, signed

# --- Section 4: from a hash to a float ---------------------------------------------------------------------------


def unorm(h: int) -> float:
    """hn_unorm: in [0, 1)."""
    return (h >> 8) / 2**24


def snorm(h: int) -> float:
    """hn_snorm: in [-1, 1)."""
    return (h >> 8) / 2**23 - 1


def middle(i: int, count: int) -> float:
    """The middle of interval i of `count` equal ones of [-1, 1]: the contract's `a`, and `p` and `q` of section 16."""
    return (2 * i + 1) / count - 1


def gradient1(h: int) -> tuple[float]:
    """hn_gradient1: a slope in (-1, 1)."""
    return (middle(h >> 14 & 511, 512),)


def gradient2(h: int) -> tuple[float, float]:
    """hn_gradient2: one of eight."""
    a = middle(h >> 21 & 3, 4)
    b = 1 - abs(a)
    return (a, -b if h >> 31 else b)


def of_two_axes(n: int, axes: tuple[int, int], h: int) -> tuple[float, ...]:
    """A gradient in n dimensions that has these two axes, with the signs of a word."""
    g = [0.0] * n
    g[axes[0]] = -1.0 if h >> 22 & 1 else 1.0
    g[axes[1]] = -1.0 if h >> 21 & 1 else 1.0
    return tuple(g)


def third(h: int) -> int:
    """In which third of the words one is: the row of the contract's table."""
    return (h >= 0x55555555) + (h >= 0xAAAAAAAA)


def gradient3(h: int) -> tuple[float, float, float]:
    """hn_gradient3: an edge of a cube."""
    return of_two_axes(3, ((0, 1), (0, 2), (1, 2))[third(h)], h)


# By the third, and by bit 20.
PAIRS = (((0, 1), (2, 3)), ((0, 2), (1, 3)), ((0, 3), (1, 2)))


def gradient4(h: int) -> tuple[float, float, float, float]:
    """hn_gradient4: a corner of the 24-cell."""
    return of_two_axes(4, PAIRS[third(h)][h >> 20 & 1], h)


# --- Section 5: the gradient at a lattice point ------------------------------------------------------------------


# From here on every value is exact: a real number, as a fraction. Who prints one rounds it, once.
Real = Union[Fraction, float]


@dataclass(frozen=True)
class Knobs:
    """The knobs of the noise's values: HN_HASH and HN_GRADIENT (octahedral or sine). HN_ARITHMETIC changes only how
    they are
    computed."""
    hash: str
    sine: bool = False

    def __post_init__(self) -> None:
        if self.hash not in HASHES:
            raise ValueError(f"no setting of the library: {self}")

    def sine_in(self, dimensions: int) -> bool:
        """Whether the gradient is the paper's, which is one of two or three dimensions."""
        return self.sine and dimensions in (2, 3)


def round24(n: int) -> int:
    """The number of 24 significant bits that is nearest to n, ties to even."""
    step = 2 ** max(n.bit_length() - 24, 0)
    return round(Fraction(n, step)) * step  # Python rounds a fraction half to even


# --- The sine ----------------------------------------------------------------------------------------------------


# The fixed point of the sine. PI is off by less than 2^9 units (16 times 1/2 for each of its 42 terms, little more),
# and reducing an arc of 2^31 takes it less than 2^30 times: 2^39 units. This leaves a double's bits even of a noise
# whose fractions are 2^-126.
SINE_BITS = 256
SINE_ERROR = Fraction(1, 2**214)


def arctan_inverse(n: int) -> int:
    """arctan(1 / n) in fixed point, by its series."""
    power, total, i = 2**SINE_BITS // n, 0, 0
    while power:
        total += (-1)**i * (power // (2 * i + 1))
        power, i = power // n**2, i + 1
    return total


PI = 4 * (4 * arctan_inverse(5) - arctan_inverse(239))  # Machin's formula


def sine_series(x: int) -> int:
    """The sine of x in [-pi/2, pi/2], both in fixed point, by its series."""
    one = 2**SINE_BITS
    term, total, i = x, 0, 1
    while term:
        total += term
        term, i = -term * x * x // (one * one * (i + 1) * (i + 2)), i + 2
    return total


@functools.cache
def sine(n: int) -> Fraction:
    """The sine of n radians, -2^31 <= n <= 2^31, off by less than SINE_ERROR."""
    one = 2**SINE_BITS
    half_turns = (n * one + PI // 2) // PI
    total = sine_series(n * one - half_turns * PI)
    return Fraction(total if half_turns % 2 == 0 else -total, one)


@functools.cache
def sine_of_turns(turns: Fraction) -> Fraction:
    """The sine of so many turns: exact at whole quarters, else off by less than SINE_ERROR."""
    quarters = 4 * turns
    if quarters.denominator == 1:
        return Fraction((0, 1, 0, -1)[quarters.numerator % 4])
    half_turns = round(2 * turns)
    total = sine_series(round((2 * turns - half_turns) * PI))
    return Fraction(total if half_turns % 2 == 0 else -total, 2**SINE_BITS)


def sine_of_word(w: int) -> Fraction:
    """The contract's S(w)."""
    return sine(round24(signed(w)))


def sine_arguments(name: str, cell: Sequence[int], seed: int) -> list[int]:
    """The hashes whose sines are the paper's gradient, in 2D or 3D, under the hash `name`."""
    chained = [hash_words(name, [cell[0] & MASK]) ^ mix(seed)]
    for c in cell[1:]:
        chained.append(hash_words(name, [(chained[-1] + c) & MASK]))
    return [(chained[-1] + word) & MASK for word in chained]


# By the number of dimensions.
OCTAHEDRAL: dict[int, Callable[..., tuple[float, ...]]] = {
    1: gradient1, 2: gradient2, 3: gradient3, 4: gradient4}


def gradient(knobs: Knobs, cell: Sequence[int], seed: int = 0) -> tuple[Real, ...]:
    if knobs.sine_in(len(cell)):
        return tuple(sine_of_word(word) for word in sine_arguments(knobs.hash, cell, seed))
    return OCTAHEDRAL[len(cell)](point_word(knobs.hash, cell, seed))
