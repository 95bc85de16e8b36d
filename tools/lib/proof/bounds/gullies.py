"""hn_gullies: proofs for the waves of its octaves, and how far the sum may be off in fixed arithmetic, from
docs/reference/contract.md, section 24. conformance/sums/gullies.cpp has the proof for floats,
and how far a slope e that is off moves the step of an octave.

WAVES. A wave is k = 3/2 (-u_y, u_x) with |u| < 1, so it is shorter than 3/2. The bounds of value and derivatives are
as of phasor noise, for 3/2 waves along each axis. How long the vector g of both derivatives is, and how fast v
and g change with k, is bounded by a sum over the points of

    G            hypot(2 m w' |d|, |k| w)                              in units of 1 / cells, times 2 pi with each k
    of v         2 pi |d| w
    of g         2 pi hypot(max(w, 2 m w' |d|^2 - w), 2 pi |k| |d| w)

with d in cells. The last is the largest length of what k changes of (dw/dx_j + 2 pi i k_j w) e(a): w along the axes,
and 2 pi i d times the bracket. The matrix w - 2 m w' d d^T has the eigenvalues w and w - 2 m w' |d|^2.

FIXED. The square of r rounds down by less than 2^-20. This moves r by less than 2^-20 / r, and by 2^-10 at most; the
root rounds down by less than 2^-14. So r times the first is below 2^-20, and u is off by both over (r + 1/8)^2, but for
a hundredth. Each of its components is rounded down to 2^-21. |u| is rounded down to 2^-18 twice, and so is its product
with a rate or a weight. Rates and weights are compared with the exact ones as they are.

NO OVERFLOW. Where the bounds hold a rate is at most 64, which is 2^24, and a step of a slope is at most 64 G, below
2^26. The heights sum to no more than 32 octaves of an fBm."""

from __future__ import annotations

import functools
import math
import re
from dataclasses import astuple, dataclass, replace

import numpy as np

from proof.bounds import text
from proof.bounds.answers import library
from proof.bounds.boxes import Boxes, cell, supremum
from proof.bounds.integers import FADE_ONE, UNIT
from proof.bounds.kernels import Offsets
from proof.bounds.noises import phasor, phasor_d
from proof.bounds.noises.phasor import KERNELS, TURN, scale_of
from proof.bounds.prover import Job, Prover, is_within
from proof.bounds.rounded import table
from proof.bounds.sums import WEIGHT_UNIT, Sum, doubled, fixed_fades, fixed_weights, tile_positions
from proof.bounds.table import GulliesBounds, read_gullies, scientific, shortest

LONGEST = 3 / 2  # wave
PLANE = replace(KERNELS[2], waves=LONGEST)
# Whose errors the text proves: the field of the bounds, and the results.
FUNCTIONS = {"noise2d.phasor_cell_period": ("value", "value", "quadrature"),
             "noise2d.phasor_d_cell_period_quadrature": ("slope", "dx", "dy")}


# The numbers of a point, from its distance in cells, its weight and the least of that, and the fall 2 m w' |d| per cell.
QUANTITIES = {
    "steep": lambda d, w, least, fall: np.hypot(fall, TURN * LONGEST * w),
    "wave_rate": lambda d, w, least, fall: TURN * d * w,
    "wave_rate_of_slope": lambda d, w, least, fall: TURN * np.hypot(np.maximum(w, fall * d - least),
                                                                    TURN * LONGEST * d * w)}


@functools.cache
def largest(quantity: str) -> float:
    """A proven upper bound of the sum over the points, scaled."""
    weight = PLANE.weight

    def of_points(size, least, most):
        """In steps, with the least and the largest t known."""
        d = np.sqrt((size**2).sum(axis=0))
        fall = 2 * PLANE.fall * weight.size(1, least, most) * d * PLANE.steps
        return QUANTITIES[quantity](d / PLANE.steps, weight.derivative(0, most), weight.derivative(0, least), fall)

    def bound(boxes: Boxes):
        near = [Offsets.of(PLANE, boxes, point) for point in PLANE.points]
        return (sum(of_points(offsets.size, offsets.least, offsets.largest) for offsets in near),
                sum(of_points(offsets.middle, *[PLANE.nearness(offsets.middle)] * 2) for offsets in near))
    return scale_of(PLANE) * supremum(bound, cell(2, half=True), 14, 0.001, None)


def bounds() -> GulliesBounds:
    """The errors of the waves in floats are the published ones, which the text proves."""
    value, slope, published = phasor.derived_value(PLANE), phasor_d.derived_slope(PLANE), read_gullies()
    return GulliesBounds(text.below(published.value), value.lipschitz, largest("wave_rate"), text.below(published.slope),
                         slope.lipschitz, largest("wave_rate_of_slope"), largest("steep"), value.fixed_error, slope.fixed_error)


def wrong_errors() -> list[str]:
    """A message for each of them that the text does not prove."""
    published = read_gullies()
    short = {name: replace(table()[name], code=re.sub(r"float_of\((b\.[zw])\)", rf"min(max(-{LONGEST}f, float_of(\1)), {LONGEST}f)",
                                                      table()[name].code)) for name in FUNCTIONS}
    jobs = [Job(name, tuple(outputs), dict.fromkeys(("kx", "ky", "phase"), "any"), target=getattr(published, kind))
            for name, (kind, *outputs) in FUNCTIONS.items()]
    return [f"GULLIES_BOUNDS of conformance/expected/bounds.inc: the text of {job.function} proves {proven.bound:.3g}, and not "
            f"{job.target:.3g}" for job, proven in zip(jobs, Prover(short).prove(jobs)) if not is_within(proven, job.target)]


# --- The sum, in floats ------------------------------------------------------------------------------------------------

def float_tolerance(s: Sum, slope: float, depth: float, bounds: GulliesBounds) -> tuple[float, float]:
    """The largest error of the height and of a slope, for a slope of that length, in a tile."""
    footprint = -1.0 if s.footprint is None else s.footprint
    height, added = library(False).gullies([s.octaves, s.lacunarity, s.gain, s.exact_positions, footprint, slope, depth,
                                            *astuple(bounds)])
    return height, added


# --- The sum, fixed ---------------------------------------------------------------------------------------------------

FLAT = 1 / 8
LARGEST_SLOPE = math.sqrt(2) * 8
SLOPE_UNIT, ROOT_UNIT = 2.0**-16, 2.0**-14
LARGEST_RATE = 64.0  # for which the bounds are promised
COARSE = 127  # the largest loss of a large height, in its units


def clamped_depth(depth: float) -> float:
    return min(max(depth, 0.0), 8.0)


def is_bounded(s: Sum, depth: float) -> bool:
    """Whether the bounds are promised for these arguments."""
    return (0 <= s.lacunarity <= 255 and 0 <= s.gain <= 1 and s.octaves <= 32
            and all(clamped_depth(depth) * (s.gain * s.lacunarity)**i <= LARGEST_RATE for i in range(s.count)))


def largest_rate(a: float, b: float, r: float) -> float:
    """The largest (a / 8 + b r) / (r + 1/8)^2 from some r on: it rises up to an r, and falls from there."""
    at = max(r, FLAT * (1 - 2 * a / b))
    return (a * FLAT + b * at) / (at + FLAT)**2


@dataclass(frozen=True)
class Slope:
    """How long it is at least and at most, and its error."""
    least: float
    most: float
    error: float

    @property
    def steepness(self) -> float:
        return self.most / (self.most + FLAT)

    def next(self, step: float, error: float) -> Slope:
        return Slope(max(self.least - step, 0.0), min(self.most + step, LARGEST_SLOPE), min(error, 2 * LARGEST_SLOPE))


def fixed_product_error(slope: Slope, limit: float, wave_rate: float, error: float) -> float:
    """The error of |u| times a number that is at most that large, changes with k by `wave_rate`, and has that error."""
    nearest = max(slope.least - slope.error, 0.0)
    root_error = min(2.0**-10, 2.0**-20 / nearest if nearest else 1.0) + ROOT_UNIT
    of_u = 1.01 * (2.0**-20 / (nearest + FLAT)**2 + ROOT_UNIT * largest_rate(0.0, 1.0, nearest))
    of_size = 1.01 * FLAT * root_error / (nearest + FLAT)**2 + 2.0**-21 + 2 * WEIGHT_UNIT
    of_number = min(wave_rate * LONGEST * (of_u + math.sqrt(2) * 2.0**-21) + error, 2 * limit)
    off = largest_rate(limit, LONGEST * wave_rate, nearest) * slope.error
    return min(off + slope.steepness * of_number + of_size * (limit + of_number), 2.001 * limit)


def fixed_rates(s: Sum, depth: float) -> list[float]:
    """The number that multiplies |u| g in each octave."""
    c = math.trunc(clamped_depth(depth) * FADE_ONE)
    growth, rates = math.trunc(s.gain * FADE_ONE) * math.trunc(s.lacunarity * 2**23) >> 23, []
    for _ in range(s.count):
        rates.append(c / FADE_ONE)
        c = c * growth >> 18
    return rates


def fixed_tolerance(s: Sum, slope: float, depth: float, bounds: GulliesBounds) -> tuple[float, float]:
    """The largest error of the height and of a slope, for a slope of that length, in a tile."""
    if not is_bounded(s, depth):
        return math.inf, math.inf
    deep, cut = clamped_depth(depth), math.trunc(clamped_depth(depth) * FADE_ONE) / FADE_ONE
    if not s.count or not deep:
        return 0.0, 0.0
    e = Slope(slope, slope, math.sqrt(2) * SLOPE_UNIT)
    height, total, fades = 0.0, 0.0, doubled(s).fades
    octaves = zip(fixed_weights(s), fixed_fades(doubled(s)), fixed_rates(s, depth), tile_positions(s))
    for i, (weight, fade, rate, position_error) in enumerate(octaves):
        weight, fade, exact_weight, exact_rate = weight / FADE_ONE, fade / FADE_ONE, s.gain**i, deep * (
            s.gain * s.lacunarity)**i
        of_fade = abs(fade - fades[i])
        of_value = fixed_product_error(e, 1.0, bounds.wave_rate, bounds.lipschitz * position_error + bounds.fixed_value)
        height += weight * (fade * of_value + of_fade) + abs(weight - exact_weight) + WEIGHT_UNIT + 2 * UNIT
        total += exact_weight * fades[i] * e.steepness
        of_slope = fixed_product_error(e, bounds.steepest, bounds.slope_wave_rate, math.sqrt(2) * (
            bounds.slope_lipschitz * position_error + bounds.fixed_slope))
        largest = bounds.steepest * e.steepness * fades[i]
        error = rate * (fade * of_slope + of_fade * bounds.steepest) + abs(rate - exact_rate) * largest
        error += 1.01 * bounds.steepest * WEIGHT_UNIT + math.sqrt(2) * SLOPE_UNIT
        e = e.next(exact_rate * largest, e.error + error)
    most = 2 * deep * sum(s.weights)
    error = min(cut * height + (deep - cut) * total + UNIT, most)
    return error + (COARSE * UNIT if deep * total >= 7 else 0.0), min(e.error, 16.0)


def quotes() -> list[str]:
    """Numbers in the prose of docs/measured/accuracy.md."""
    exact, of = bounds(), bounds().rounded()

    def rate(r: float, digits: int) -> str:
        return shortest(largest_rate(of.steepest, LONGEST * of.slope_wave_rate, r), digits)
    return [f"within {scientific(exact.value)} of the value and {scientific(exact.slope)} of a derivative",
            f"by {rate(0.0, 2)} d on flat ground, {rate(1.0, 3)} d for a slope of 1, "
            f"and {rate(3.0, 3)} d for one of 3",
            f"{scientific(exact.fixed_value)} of the value and {scientific(exact.fixed_slope)} of a derivative, with the cut"]
