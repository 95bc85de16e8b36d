"""Derives how far octave sums with slopes, and warps, may be off in fixed arithmetic, from the bounds of their noise
and its derivatives. conformance/sums/bounds.cpp has the same for floats, and how lengths grow. Integers of a Jacobian
do not depend on the position, and so they are compared with the exact numbers as they are."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

import catalog.model
from proof.bounds.integers import FADE_ONE, SLOPE_UNIT, UNIT
from proof.bounds.sums import (
    LARGEST_STRENGTH,
    ROTATIONS,
    SHIFTS,
    WEIGHT_UNIT,
    Sum,
    first_fixed_position,
    fixed_mean_error,
    fixed_positions,
    fixed_strength,
    fixed_weights,
    lengths,
    next_fixed_position,
    octave_tolerance,
    tolerance_of,
)
from proof.bounds.table import Bounds, slope_bounds_of
from proof.oracle import jacobians as oracle

LARGEST_GROWTH, LARGEST_SHIFT = 64.0, 256.0  # for which the bounds are promised
LARGEST_RISE = 4000.0  # the same of the growths' sum times the longest gradient
SLOPE_LIMIT = 128.0  # of a component, beyond which it is cut off
FALL_LIMIT = 8.0  # the same of what hn_eroded sums of slopes
FALL_UNIT = 2.0**-12
LARGEST_AMPLITUDE = max(LARGEST_STRENGTH[kind] for kind in SHIFTS)
FITTING = tuple(noise.name + phase for noise in catalog.model.read().noises  # what hn_add takes
                if noise.shape in ("slopes", "distance_with_slopes") for phase in ("", "_phase")[:1 + ("phase" in noise.options)])
DOUBLES = 1e-12  # more than the rounding errors of 32 Jacobians of up to 64, computed in doubles
COARSE = 127  # the largest loss of a large result, in its units


def stretch(s: Sum, dims: int) -> float:
    """How much the rotations between two octaves stretch a length."""
    return math.prod(ROTATIONS[:dims - 1]) if s.rotates else 1.0


def fitting_slopes() -> list[Bounds]:
    """The bounds of the derivatives of the noises that fit the hn_add of a loop with slopes."""
    return [slope_bounds_of(name, dims) for name in FITTING for dims in (2, 3)]


def longest_gradient(noise: Bounds, slope: Bounds) -> float:
    """As in conformance/sums/bounds.cpp."""
    full, rest = divmod(noise.lipschitz, slope.limit)
    return min(math.sqrt(full * slope.limit**2 + rest**2), math.sqrt(noise.dimensions) * slope.limit)


def steepest(s: Sum, noise: Bounds, slope: Bounds) -> float:
    """How much noise changes by, per step: of lengths, or where these are not bounded of the largest coordinate."""
    return longest_gradient(noise, slope) if s.rotates else noise.lipschitz


def cut_lacunarity(s: Sum) -> float:
    """From a cell that is the lacunarity of the contract; with fixed arithmetic it is used from a position, too."""
    return math.trunc(s.lacunarity * 2**23) / 2**23


def clamped_amplitude(s: Sum) -> float:
    return min(max(s.amplitude, 0.0), LARGEST_STRENGTH[s.kind])


def steepest_fall(strength: float, reach: float) -> float:
    """The largest slope of 1 / (1 + strength r^2) for r up to `reach`, as in conformance/sums/bounds.cpp."""
    r = min(reach, 1 / math.sqrt(3 * strength)) if strength > 0 else reach
    return 2 * strength * r / (1 + strength * r**2)**2


# --- In integers: Jacobians -------------------------------------------------------------------------------------------

def is_bounded(s: Sum, longest: float = 0.0) -> bool:
    """Whether the bounds are promised for these arguments, and this length of a gradient."""
    if not (0 <= s.lacunarity <= 255 and 0 <= s.gain <= 1 and s.octaves <= 32):
        return False
    growth = [(s.gain * s.lacunarity)**i for i in range(s.count)]
    return sum(growth) <= LARGEST_GROWTH and sum(growth) * longest <= LARGEST_RISE and (
        s.kind != "warp_progressive" or clamped_amplitude(s) * max(growth, default=0.0) <= LARGEST_SHIFT)


def jacobians(s: Sum, dims: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """The fixed Jacobian and the exact one of each octave."""
    ones, periods = 2**18 * np.eye(dims, dtype=int), () if s.rotates else (1,) * dims
    exactly = replace(s.options, lacunarity=cut_lacunarity(s) if s.from_cell else s.lacunarity)
    for _, fixed, exact in zip(range(s.count), oracle.fixed_jacobians_of(dims, s.options, periods),
                               oracle.jacobians_of(dims, exactly, periods)):
        yield np.array([fixed.times(one) for one in ones.tolist()]).T / FADE_ONE, np.array(exact, float)


def longest_column(matrix: np.ndarray) -> float:
    return float(np.linalg.norm(matrix, axis=0).max()) + DOUBLES


def norm(matrix: np.ndarray) -> float:
    """How much longer a vector becomes."""
    return float(np.linalg.norm(matrix, 2)) + DOUBLES


# --- In integers: slopes ----------------------------------------------------------------------------------------------

def fixed_effects(s: Sum, bounds: Bounds, steepest: float) -> list[float]:
    """The errors of the noise of each octave, or of its derivatives, where positions do not depend on the noise."""
    return [min(steepest * error + bounds.fixed_error, 2 * bounds.fixed_limit)
            for _, error in zip(range(s.count), fixed_positions(s, bounds.dimensions))]


def fixed_slope_tolerance(s: Sum, noise: Bounds, slope: Bounds) -> float:
    """The largest error of a derivative of hn_fbm_d: with the columns K of the Jacobians, sum(K . g) / T. A column is
    off by a part of what it is divided by, since both are in units of 2^-18. Each product of its numbers is rounded
    down by less than a unit, and so is the division; a result of 32 and more is cut to 127 units."""
    if not is_bounded(s, longest_gradient(noise, slope)) or slope.fixed_limit > SLOPE_LIMIT:
        return math.inf
    if not s.count:
        return 0.0
    dims, longest = noise.dimensions, longest_gradient(noise, slope) if s.rotates else slope.limit
    total, exact_total = sum(fixed_weights(s)) / FADE_ONE, sum(s.weights)
    error, largest = (dims * s.count / total + 1) * SLOPE_UNIT, 0.0
    for slope_err, (fixed, exact) in zip(fixed_effects(s, slope, slope.lipschitz), jacobians(s, dims)):
        error += longest_column(fixed) / total * lengths(s, dims) * slope_err
        error += longest_column(fixed / total - exact / exact_total) * longest
        largest += longest_column(exact) / exact_total * longest
    return error + (COARSE * SLOPE_UNIT if largest + error >= 32 else 0.0)


# --- In integers: erosion ---------------------------------------------------------------------------------------------

def fixed_fall_errors(s: Sum, noise: Bounds, slope: Bounds) -> list[float]:
    """The errors of the factors 1 / (1 + strength |e|^2). A slope is rounded down to 2^-12, and so are two coordinates
    by each rotation; a clamp brings no two vectors further apart. The square times the strength rounds down by less
    than 2^-16 of a number from 1 on, and the quotient by 2^-18. The cut of the strength changes a factor by up to d r^2
    / (1 + strength r^2)^2, which is largest where strength r^2 = 1."""
    dims, axes = noise.dimensions, math.sqrt(noise.dimensions)
    strength, cut = fixed_strength(s)
    longest = longest_gradient(noise, slope) + axes * slope.fixed_error
    rotations, ends, errs = ROTATIONS[:dims - 1] if s.rotates else (), axes * FALL_LIMIT, []
    err, reach = 0.0, 0.0
    for slope_err in fixed_effects(s, slope, slope.lipschitz):
        for rotation in rotations if errs else ():
            err, reach = rotation * err + math.sqrt(2) * FALL_UNIT, rotation * reach + math.sqrt(2) * FALL_UNIT
        err = min(err + axes * (slope_err + FALL_UNIT), 2 * ends)
        reach = min(reach + longest + axes * FALL_UNIT, ends)
        of_cut = cut * (min(reach**2, 1 / (4 * strength)) if strength > 0 else reach**2)
        errs.append(min(steepest_fall(strength, reach) * err + of_cut + 2.0**-16 + WEIGHT_UNIT, 1.0))
    return errs


def fixed_eroded_tolerance(s: Sum, noise: Bounds, slope: Bounds) -> float:
    """The largest error of hn_eroded, which is a mean of n / (1 + strength |e|^2). The product of a weight with the
    factor is rounded down to 2^-18."""
    if not is_bounded(s):
        return math.inf
    if not s.count:
        return 0.0
    limit, total = noise.fixed_limit, sum(fixed_weights(s)) / FADE_ONE
    terms = [noise_err + limit * fall_err for noise_err, fall_err in zip(
        fixed_effects(s, noise, steepest(s, noise, slope)), fixed_fall_errors(s, noise, slope))]
    return fixed_mean_error(s, limit, terms) + limit * s.count * WEIGHT_UNIT / total


# --- In integers: warps -----------------------------------------------------------------------------------------------

def fixed_shift_effects(s: Sum, noise: Bounds, slope: Bounds) -> list[float]:
    """The errors of the noise of each octave of hn_warp_progressive. A position moves by a row of the Jacobian times
    the vectors of noise: the row and its factor are off together, each product is rounded down to 2^-21, and so is that
    with the factor. An error of the noise comes back through the position."""
    dims, axes, errs = noise.dimensions, lengths(s, noise.dimensions), []
    amplitude, total = clamped_amplitude(s), sum(fixed_weights(s))
    cut = (math.trunc(amplitude * FADE_ONE) * FADE_ONE // total) / FADE_ONE
    factor, limit = amplitude / sum(s.weights), min(noise.fixed_limit, 1.0)
    position, error = first_fixed_position(s, dims)
    for fixed, exact in jacobians(s, dims):
        errs.append(min(steepest(s, noise, slope) * error + noise.fixed_error, 2 * limit))
        error += norm(cut * fixed - factor * exact) * axes + cut * norm(fixed) * axes * errs[-1]
        error += axes * (cut * dims + 1) * UNIT
        position, error = next_fixed_position(s, dims, position + factor * norm(exact) * axes, error)
    return errs


def fixed_warp_tolerance(s: Sum, noise: Bounds, slope: Bounds) -> float:
    """The largest error of a component of hn_warp or hn_warp_progressive, which is amplitude times a mean. The product
    is rounded down, and a result of 8 and more is cut to 127 units."""
    if not is_bounded(s):
        return math.inf
    if not s.count:
        return 0.0
    amplitude, limit = clamped_amplitude(s), min(noise.fixed_limit, 1.0)
    cut = math.trunc(amplitude * FADE_ONE) / FADE_ONE
    if s.kind == "warp_progressive":
        errs = fixed_shift_effects(s, noise, slope)
    else:
        errs = fixed_effects(s, noise, steepest(s, noise, slope))
    error = cut * fixed_mean_error(s, limit, [min(err, 2 * limit) for err in errs]) + (amplitude - cut) * limit + UNIT
    return error + (COARSE * UNIT if cut >= 8 else 0.0)


# --- Overflow ---------------------------------------------------------------------------------------------------------

def largest_intermediates(dims: int) -> dict[str, float]:
    """By name, bounds of the magnitudes that must stay below 2^31 where the bounds are promised, for any noise with
    derivatives: gain * lacunarity is then at most 63, since the first octave adds 1 to the sum. In a Jacobian a number
    is rounded down by less than 5 units for each octave, and earlier losses grow as the Jacobian does."""
    stretched = stretch(Sum("fbm_d", 0.0, 32, 1.0, 1.0), dims)**31
    jacobian = stretched * ((LARGEST_GROWTH - 1) * FADE_ONE + 5 * LARGEST_GROWTH)
    slope, vector = math.sqrt(dims) * SLOPE_LIMIT, math.sqrt(dims) / UNIT
    falls = ((25 + 20) / 32) ** (dims - 1) * FALL_LIMIT
    return {
        "Jacobian": jacobian, "rotation of a Jacobian": 32 * ROTATIONS[0] * jacobian,
        "sum of slopes": (stretched * (LARGEST_RISE + 5 * 32 * LARGEST_GROWTH / FADE_ONE * slope) / SLOPE_UNIT
                          + 32 * dims),
        "step": jacobian / FADE_ONE * vector + dims,
        "rotation of a fall": (25 + 20) * FALL_LIMIT / FALL_UNIT, "sum of falls": (falls + SLOPE_LIMIT) / FALL_UNIT,
        "step of a position": (LARGEST_SHIFT * stretched * (1 + 5 * LARGEST_GROWTH / FADE_ONE) * vector
                               + LARGEST_AMPLITUDE * dims + 1),
        "shift": LARGEST_AMPLITUDE / UNIT}


def largest_words(dims: int) -> dict[str, float]:
    """The largest words, which are below 2^32."""
    squares, strength = dims * (FALL_LIMIT / FALL_UNIT)**2, LARGEST_STRENGTH["eroded"]
    return {"squares": squares, "divisor": 2.0**16 + squares * strength * FADE_ONE / 2**26}


TOLERANCES = {  # in floats and fixed, from a sum and the bounds of its noise and of the derivatives of that
    "fbm_d": (functools.partial(tolerance_of, "slope"), fixed_slope_tolerance),  # for a derivative; the value has fbm's
    "eroded": (octave_tolerance, fixed_eroded_tolerance),
    "warp": (octave_tolerance, fixed_warp_tolerance),
    "warp_progressive": (octave_tolerance, fixed_warp_tolerance)}
