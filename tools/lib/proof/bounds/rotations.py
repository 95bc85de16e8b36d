"""Noise whose gradients rotate with a phase (docs/reference/contract.md, section 14): what is proven of it, from what
is proven of the noise without a phase.

At the angle a = 2 pi phase a gradient g has become cos(a) g + sin(a) g', and the noise, or a derivative, cos(a) n +
sin(a) n', where n is that of the gradients g, and n' that of the g'. A gradient that has rotated by a quarter is one of
the set, so all bounds of n hold for n', too. The exact noise is bounded with all gradients at all phases (ROTATED in
gradients.py), and so is how fast it changes. So the length of (n, n') is at most the range R, and |n| + |n'| at most
sqrt(2) R. A move of n and n' by at most e moves the noise by at most sqrt(2) e.

IN FLOATS the cosine and the sine are off by that of a sine, and by the angle that is cut off. Two products round, their
sum and what is scaled.

IN INTEGERS they are off likewise. All parts of an error but the cut of the place and SCALE are moved by sqrt(2). Two
parts (docs/reference/contract.md, section 10) round down, with factors whose squares sum to that of 2^18.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from proof.bounds import sine
from proof.bounds.floats import TINY, UNIT
from proof.bounds.integers import FADE_ONE, part_intermediate
from proof.bounds.noises import ProvenBounds, derived

ANGLE_CUT = 2 * math.pi * 2.0**-30  # a phase is cut off to a multiple of 2^-30 turns
MIXED_ROUNDING = math.sqrt(2) * 511 + 2 + 2 * 511  # of two parts, in units of what they are parts of


@functools.cache
def float_error(ulps: float = 1.0) -> float:
    """Of the cosine and the sine of a phase."""
    return sine.sine_bound(ulps) + ANGLE_CUT


@functools.cache
def fixed_error() -> float:
    return sine.fixed_sine_error() + ANGLE_CUT


def moved(error: float, off: float, largest: float) -> float:
    """A noise of at most that size, if n and n' are off by `error`, and the cosine and the sine by `off`."""
    return math.sqrt(2) * (error + off * largest) + 2 * off * error


def mixed(error: float, largest: float, ulps: float = 1.0) -> float:
    """The error of a noise in floats, from that of n and n'."""
    err = moved(error, float_error(ulps), largest)
    return err + 3 * ulps * UNIT * (1 + UNIT)**3 * (largest + err) + 4 * TINY


def rotated(still: ProvenBounds, largest: float, lipschitz: float, unit: float) -> ProvenBounds:
    """Of a noise, or its derivatives. In integers n has this unit, times the scale."""
    parts = {name: math.sqrt(2) * value for name, value in still.fixed_parts.items()}
    parts |= {"cut": still.fixed_parts["cut"] / still.lipschitz * lipschitz, "scaling": still.fixed_parts["scaling"]}
    beside = sum(value for name, value in still.fixed_parts.items() if name not in ("cut", "scaling"))
    parts["gradient"] = moved(beside, fixed_error(), largest) - math.sqrt(2) * beside + MIXED_ROUNDING * unit
    return derived(still.promise, largest, lipschitz, mixed(still.cell_error, largest), parts)


def largest_intermediates(name: str, value: float) -> dict[str, float]:
    """Of what is scaled: n and n' are as large as it, or as they are without a phase."""
    return {f"part of a turned {name}": part_intermediate(value, np.array([FADE_ONE])),
            f"rotated {name}": math.sqrt(2) * value * sine.fixed_sine_largest() + 2 * MIXED_ROUNDING}
