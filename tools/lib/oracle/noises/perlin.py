"""Section 6 of docs/contract.md: Perlin noise."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from oracle.cells import interpolated, weighted_sum
from oracle.gradients import Knobs, gradient4
from oracle.integers import signed
from oracle.lattice import Lattice

# --- Exact ------------------------------------------------------------------------------------------------------

OCTAHEDRAL_SCALES = {1: Fraction(2), 2: Fraction(1365, 1024), 3: Fraction(1228, 1024), 4: Fraction(953, 1024)}


def check(knobs: Knobs, n: int) -> None:
    if knobs.sine and n not in (2, 3):
        raise ValueError(f"with the sine gradient there is no Perlin noise in {n}D")


def scale(knobs: Knobs, n: int) -> Fraction:
    """The factor of the weighted sum in n dimensions."""
    return Fraction(1) if knobs.sine else OCTAHEDRAL_SCALES[n]


def ramp(lattice: Lattice, corner: Sequence[int], offset: Sequence[Fraction]) -> Fraction:
    """The ramp of a corner at an offset from it."""
    return sum((Fraction(g) * x for g, x in zip(lattice.gradient(corner), offset)), Fraction(0))


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction]:
    check(lattice.knobs, len(f))
    total = weighted_sum(cell, f, lambda corner, offset: ramp(lattice, corner, offset))
    return (total * scale(lattice.knobs, len(f)),)


# --- Fixed (section 8) ------------------------------------------------------------------------------------------


def sign_of(h: int, m: int) -> int:
    """m, negated if bit 31 of h is set."""
    return -m if h >> 31 else m


def ramp1(h: int, d: Sequence[int]) -> int:
    """The ramp on a line, in units of 2^-29, of the word h of a corner at the offset d from it."""
    a = 2 * (h >> 22 & 511) - 511
    return signed(a * d[0])


def ramp2(h: int, d: Sequence[int]) -> int:
    """The octahedral ramp in the plane, likewise."""
    a = 2 * (h >> 22 & 511) - 511
    m = sign_of(h, 512 - abs(a))
    e = min(abs(a), abs(m))
    r = signed(signed(a * d[0]) + signed(m * d[1]))
    return signed(r + signed((r >> 9) * e))


def ramp3(h: int, d: Sequence[int]) -> int:
    """The octahedral ramp in space, likewise."""
    p = 2 * (h >> 23 & 255) - 255
    q = 2 * (h >> 15 & 255) - 255
    m = sign_of(h, 256 - max(abs(p), abs(q)))
    e = min(512 - abs(p) - abs(q), 512 - 2 * abs(m))
    flat = signed(signed(p * (d[0] + d[1])) + signed(q * (d[0] - d[1])))
    r = signed(flat + signed(m * 2 * d[2]))
    return signed(r + signed((r >> 9) * e))


def ramp4(h: int, d: Sequence[int]) -> int:
    """The ramp in four dimensions, in units of 2^-28."""
    return signed(256 * signed(sum(int(g) * x for g, x in zip(gradient4(h), d))))


# By the number of dimensions: the ramp, its unit, and the scale of the noise.
OCTAHEDRAL_RAMPS: dict[int, Callable[[int, Sequence[int]], int]] = {1: ramp1, 2: ramp2, 3: ramp3, 4: ramp4}
RAMP_UNITS = {1: 2**29, 2: 2**29, 3: 2**29, 4: 2**28}
FIXED_SCALES = {1: 2048, 2: 1365, 3: 1228, 4: 1906}


def scaled(n: int, dimensions: int) -> int:
    """The result of the interpolation of octahedral ramps, in units of 2^-21."""
    return signed(signed((signed(n + 256) >> 9) * FIXED_SCALES[dimensions]) + 256) >> 9


def sine_ramp(components: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a sine gradient, in units of 2^-28."""
    return signed(sum(signed((g >> 8) * x) + (signed((g & 255) * x) >> 8) for g, x in zip(components, d)))


def fixed_ramp(lattice: Lattice, corner: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a corner at the offset d from it."""
    if lattice.knobs.sine:
        return sine_ramp(lattice.fixed_sine_gradient(corner), d)
    return OCTAHEDRAL_RAMPS[len(d)](lattice.word(corner), d)


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int]:
    check(lattice.knobs, len(cell))
    n = interpolated(cell, fraction, lambda corner, d: fixed_ramp(lattice, corner, d))
    return (n >> 7 if lattice.knobs.sine else scaled(n, len(cell)),)
