"""Section 6 of docs/contract.md: Perlin noise."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from oracle.cells import interpolated, weighted_sum
from oracle.gradients import Knobs, gradient, wrapped
from oracle.integers import signed, sine_gradient
from oracle.words import point_word

# --- Exact ------------------------------------------------------------------------------------------------------

OCTAHEDRAL_SCALES = {2: Fraction(1913, 1024), 3: Fraction(1819, 1024)}


def scale(knobs: Knobs, n: int) -> Fraction:
    """The factor of the weighted sum in n dimensions."""
    return Fraction(1) if knobs.sine else OCTAHEDRAL_SCALES[n]


def exact(knobs: Knobs, cell: Sequence[int], f: Sequence[Fraction], seed: int) -> Fraction:
    def ramp(corner: Sequence[int], offset: Sequence[Fraction]) -> Fraction:
        return sum((Fraction(g) * x for g, x in zip(gradient(knobs, corner, seed), offset)), Fraction(0))

    return weighted_sum(cell, f, ramp) * scale(knobs, len(f))


# --- Fixed (section 8) ------------------------------------------------------------------------------------------


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


def sine_ramp(components: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a sine gradient, in units of 2^-28."""
    return signed(sum(signed((g >> 8) * x) + (signed((g & 255) * x) >> 8) for g, x in zip(components, d)))


def corner_ramp(knobs: Knobs, corner: Sequence[int], d: Sequence[int], seed: int) -> int:
    """The ramp of a corner at the offset d from it."""
    point = [wrapped(c, knobs.period) for c in corner]
    if knobs.sine:
        return sine_ramp(sine_gradient(knobs, point, seed), d)
    ramp, _ = OCTAHEDRAL[len(point)]
    return ramp(point_word(knobs.hash, point, seed), d)


def fixed(knobs: Knobs, cell: Sequence[int], fraction: Sequence[int], seed: int) -> int:
    n = interpolated(cell, fraction, lambda corner, d: corner_ramp(knobs, corner, d, seed))
    if knobs.sine:
        return n >> 7
    _, factor = OCTAHEDRAL[len(cell)]
    return signed(signed(((n + 256) >> 9) * factor) + 256) >> 9
