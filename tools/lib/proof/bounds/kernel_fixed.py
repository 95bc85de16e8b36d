"""Bounds how large the integers of HN_FIXED are in a sum over lattice points (docs/reference/contract.md, section 13)."""

from __future__ import annotations

import math

import numpy as np

from proof.bounds import kernels
from proof.bounds.gradients import LENGTH, OCTAHEDRAL
from proof.bounds.integers import (
    FADE_ONE,
    RAMP_ONE,
    fixed_scale,
    part_intermediate,
    scaled_intermediate,
)
from proof.bounds.kernels import Kernel
from proof.errors import record


def ramp_one(dims: int) -> int:
    return RAMP_ONE[dims]


def part_rounding(factor, negative=False):
    """The rounding of part(d, t) for |t| up to the factor, a real number in units of 2^-18: see integers.py. If no t is
    above 0, the two products round to different sides."""
    units = np.ceil(factor * FADE_ONE)
    high, low = 511 / 512 * (units / 512 + 1), np.minimum(units, 511)
    return np.where(factor > 0, np.where(negative, np.maximum(high, low), high + low), 0.0)


def scale_of(kernel: Kernel) -> int:
    return fixed_scale(kernel.scale / 1024, kernel.dims)


def longest_ramp(kernel: Kernel) -> float:
    """For offsets of at most 1."""
    return OCTAHEDRAL.reach(kernel.dims) * ramp_one(kernel.dims)


def pieces(kernel: Kernel) -> tuple[np.ndarray, np.ndarray]:
    """The ends of 4096 ranges of t."""
    low = np.arange(4096) / 4096 * kernel.radius
    return low, low + kernel.radius / 4096


def weighted_intermediates(kernel: Kernel, ramp: float) -> dict[str, float]:
    """The words of ramps up to that size. The value is at most 1. No offset from a point that is visited is more than 1
    along an axis: so the squares sum to at most 2 steps on the plane, and elsewhere to 1, or 3/2 with the larger
    kernel, where m is 1. The word m q is then at most 2^31. The products in the weights of simplex noise fit 32
    bits, since t < 2^16, and t (98304 - t) is at most 49152^2. A sum of the parts of some of the points is as large as
    that of all can be."""
    weight = kernel.weight.size(0, *pieces(kernel)).max() * FADE_ONE + 1
    return {"half of the word of a square": 2.0**30, "ramp": ramp,
            "attenuated": part_intermediate(ramp, np.array([math.ceil(weight)])),
            "scaled": scaled_intermediate(1024 / kernel.scale * ramp_one(kernel.dims), scale_of(kernel))}


def largest_intermediates(kernel: Kernel) -> dict[str, float]:
    return weighted_intermediates(kernel, longest_ramp(kernel))


def largest_slope_intermediates(kernel: Kernel) -> dict[str, float]:
    """The words of a derivative. Where E is not 0, m d^2 <= r - t: so the length of an offset is at most
    sqrt((r - t) / m), from which k = R E and the product with the offset, for t in each of many ranges. On the plane
    Q (73728 - t) is less than 4/27 of 73728^3 / 2^16. For a sum of points more is known: each is at
    most its share of the largest derivative."""
    dims, one, whole = kernel.dims, ramp_one(kernel.dims), np.array([FADE_ONE])
    low, high = pieces(kernel)
    eighth = kernel.fall / 4 * kernel.weight.size(1, low, high)
    away = np.sqrt((kernel.radius - low) / kernel.fall)
    k = float((eighth * away).max()) * LENGTH[dims] * one * 1.001 + 4 * 1023
    moved = float((eighth * away * away).max()) * LENGTH[dims] * one * 1.001 + 4 * 1023
    off = record.proven("simplex_d", dims, "none", record.DERIVATIVE, arithmetic=record.FIXED)
    derivative = kernels.slope_of(kernel, OCTAHEDRAL) + off / (kernel.steps * kernel.scale / 1024)
    return {"falling": k, "k": part_intermediate(k, whole),
            "fall of the plane": 4 / 27 * 73728**3 / 2**16 + 2**16,
            "leaning": OCTAHEDRAL.component(dims) * one / 4 + 2 * (moved + 2 * 1023),
            "scaled derivative": scaled_intermediate(derivative * one / 4, scale_of(kernel))}
