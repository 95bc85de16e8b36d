"""Integers of HN_FIXED (docs/reference/contract.md, sections 8 to 11): the fade t and its slope of each of the 2^20 + 1
fractions F, how much a product with each of them rounds, and how large the words are."""

from __future__ import annotations

import functools

import numpy as np

ONE = 2**20  # I of the contract: the unit of fractions
FADE_ONE = 2**18  # the unit of t and of slopes
UNIT = 2.0**-21  # of a result
SLOPE_UNIT = 2.0**-19  # of a derivative
DOUBLE = 1e-15  # more than the rounding error of the exact fade in doubles


def checked(values, low, high):
    """The integers as they are, if they need not wrap."""
    if np.min(values) < low or np.max(values) >= high:
        raise OverflowError(f"{np.min(values)} .. {np.max(values)} is not within [{low}, {high})")
    return values


def signed(values):
    return checked(values, -2**31, 2**31)


def word(values):
    return checked(values, 0, 2**32)


# --- Of each fraction -------------------------------------------------------------------------------------------------

@functools.cache
def fractions():
    return np.arange(ONE + 1, dtype=np.int64)


def nearer_end(fraction):
    """x of the contract, in units of 2^-17."""
    return np.minimum(np.minimum(fraction, ONE - fraction) + 4, 2**19 - 1) >> 3


def fixed_fade(fraction):
    """t of the contract, in units of 2^-18."""
    x = nearer_end(fraction)
    s = word(x * x)
    z = word(s + 2**15) >> 16
    r = word(1572864 - 30 * x + 6 * z) >> 2
    q = word(s + (word(z * r) >> 2) + 2**15) >> 16
    t = word(x * q + 2**14) >> 15
    return np.where(fraction > 2**19, FADE_ONE - t, t)


def fixed_slope(fraction):
    """The slope of the fade, in units of 2^-18."""
    x = nearer_end(fraction)
    q = word(x * (2**17 - x)) >> 16
    return word((word(q * q) >> 4) * 15 + 4096) >> 13


@functools.cache
def fades():
    """t of every fraction."""
    return fixed_fade(fractions())


@functools.cache
def slopes():
    return fixed_slope(fractions())


def overshoot():
    """How far t leaves [0, 1]."""
    return max(0, -int(fades().min()), int(fades().max()) - FADE_ONE) / FADE_ONE


def part_roundings(factors):
    """How far a product of the contract, part(d, t), rounds, in units of d: down, or up where t < 0."""
    return 511 / 512 * np.abs(factors >> 9) + (factors & 511)


@functools.cache
def lerp_roundings():
    """For every fraction, how far an interpolation by its t rounds."""
    return part_roundings(fades())


# --- Derivatives ------------------------------------------------------------------------------------------------------

def slope_rounding(dims: int) -> float:
    """A bound of what derivatives round by, in units four times as large as for the ramps. Every shift by 2 rounds down by at most 3/4. After k interpolations a ramp is rounded down by at most k lambda, lambda the
    largest rounding of LERP, and so a rise is off by that at most, up or down. Components of gradients are multiples of
    2^18 in their units, so their first interpolation is exact, and k of them round by less than k lambda. The product
    with the slope has its own rounding, and the result is interpolated along the axes behind."""
    lerp, product = float(lerp_roundings().max()), float(part_roundings(slopes()).max())
    steepest, worst = slopes().max() / FADE_ONE, 0.0
    for axis in range(dims):
        behind = dims - 1 - axis
        rise = axis * lerp / 4 + 3 / 4
        worst = max(worst, axis * lerp + steepest * rise + product + behind * lerp)
    return worst * (1 + 2 * overshoot()) ** dims


# --- Overflow ---------------------------------------------------------------------------------------------------------

def part_intermediate(value: float, factors) -> float:
    """The magnitude of part(d, t) for |d| up to `value`: the first product is at most (|d| / 2^9 + 1) (t >> 9), the
    second below (|d| / 2^18 + 1) * 511; their sum may be taken of both magnitudes."""
    return (value / 2**9 + 1) * ((int(np.abs(factors).max()) >> 9) + 1) + (value / 2**18 + 1) * 511


def interpolation_intermediates(corner: float, dims: int, difference: float | None = None) -> dict[str, float]:
    """By name, bounds of the magnitudes in the interpolation of corners' values of at most `corner`; two that are
    interpolated differ by at most `difference`. Interpolated values stay as large, with LERP."""
    off = dims * lerp_roundings().max()
    value = corner + off + 2 * corner * overshoot() * dims
    apart = 2 * value if difference is None else difference + 2 * off + 4 * corner * overshoot() * dims
    return {"value": value, "difference": apart, "lerp": part_intermediate(apart, fades())}


def slope_intermediates(rise: float, gradient: float, dims: int, difference: float | None = None) -> dict[str, float]:
    """The words of the derivatives that are interpolated with the values. Components of gradients are at most
    `gradient`, and rises of values, before they are shifted, at most `rise`. Two derivatives differ by at most
    `difference`, but for their rounding."""
    climb = part_intermediate(rise / 4 + 1, slopes())
    made = gradient + dims * lerp_roundings().max() + climb
    apart = None if difference is None else difference + 2 * slope_rounding(dims)
    return {"climb": climb, **{f"derivative's {name}": value for name, value in
                               interpolation_intermediates(made, dims, apart).items()}}


# --- Scales of ramps --------------------------------------------------------------------------------------------------

RAMP_ONE = {1: 2**29, 2: 2**29, 3: 2**29, 4: 2**28}  # the units of ramps


def fixed_scale(scale: float, dims: int) -> int:
    """S of the contract; the ramps in 4D have units twice as large."""
    return round(scale * 1024) * (2**29 // RAMP_ONE[dims])


def scaled_intermediate(value: float, scale: int) -> float:
    """((n + 256) >> 9) * S + 256."""
    return (value / 2**9 + 1) * scale + 256
