"""Proofs for hn_value and its derivatives, from docs/reference/contract.md, sections 9 and 10. hn_value_d computes the
value in the same steps, so it has the same bounds.

Each component of hn_value_vector (section 22) is hn_value with other hashes, and the bounds hold for any. The hashes of
y and z are the low 32 bits of products of two factors below 2^24. So they are hashes, too, and their numbers are in the
range of hn_value's.

RANGE. The number of a corner is within +-1, and -1 occurs. The weights are not negative and sum to 1, so the value is
within +-1, too. A derivative is s'(f_1) times an interpolation of differences of two numbers: at most
15/8 * 2.

LIPSCHITZ. See suprema.py. At a corner's number within +-1, L is the largest sum_o |D w_o|.

FLOATS. A number is computed with 3 added: it has 23 bits in [2, 4), exactly, and the difference of two is exact, too.
Their interpolation is in floats.py of the folder above. A value from 2 to 4 less 3 is exact, and so it is where it
was rounded beyond. The computed value may be beyond +-1 by its error.

FIXED. The fixed numbers are the exact ones. The fixed value differs from the exact one by four things. FADE and LERP
are bounded together, for each box:

    CUT      a coordinate is cut to a multiple of 2^-20, by less than that: at most L * 2^-20.
    FADE     see integers.py. A corner's number is at most 1 at any offset.
    LERP     see integers.py.
    SCALE    (n + 128) >> 8 rounds to nearest, by 1/2 unit of 2^-21 at most.

In a derivative, the slope s'(f_1) is off by e', and the differences of numbers, at most 2, are interpolated along the
other axes. With sum_o |change of w_o| over these, which is FADE in one dimension less, that comes to
2 (|e'| + slope * FADE).
"""

from __future__ import annotations

import functools
from dataclasses import replace

import numpy as np

from proof.bounds import suprema
from proof.bounds.boxes import FADE_MAX, SAFE
from proof.bounds.floats import (
    Approx,
    approx_interpolation,
    approx_number_derivatives,
    approx_offsets,
    error_supremum,
)
from proof.bounds.gradients import Gradient
from proof.bounds.integers import (
    FADE_ONE,
    ONE,
    SLOPE_UNIT,
    UNIT,
    interpolation_intermediates,
    largest_fade_effect,
    largest_joint_effect,
    largest_rounding,
    overshoot,
    slope_errors,
    slope_intermediates,
    slope_rounding,
    slopes,
)
from proof.bounds.noises import Proof, ProvenBounds, derived, of_components

OFFSET = 3.0  # of numbers in floats
NUMBER_ONE = 2**29  # the unit of such a number in fixed arithmetic
STEEPEST = 2 * FADE_MAX[1]


def numbers_and_fractions(lo, hi):
    """The errors of the corners, without the offset."""
    numbers = [Approx.within(1.0)] * 2 ** len(lo)
    return numbers, [approx_offsets(a, b)[0] for a, b in zip(lo, hi)]


def value_error(lo, hi):
    """The largest error in floats from a cell and a fraction in each box, given by its ends along each axis."""
    return approx_interpolation(*numbers_and_fractions(lo, hi), OFFSET).err


def slope_error(lo, hi):
    derivatives = approx_number_derivatives(*numbers_and_fractions(lo, hi), OFFSET)
    return functools.reduce(np.maximum, (derivative.err for derivative in derivatives))


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    lipschitz, cell_error = suprema.largest(suprema.LIPSCHITZ, dims, None), error_supremum(value_error, dims)
    lerp = largest_rounding(dims) / NUMBER_ONE
    parts = {"cut": lipschitz / ONE, "fade": largest_fade_effect(dims, None), "interpolation": lerp,
             "scaling": UNIT / 2}
    fixed_error = lipschitz / ONE + largest_joint_effect(dims, None, NUMBER_ONE) + UNIT / 2
    fixed_largest = (1 + 2 * overshoot()) ** dims + lerp + UNIT / 2
    return derived(1.0, 1.0, lipschitz, cell_error, parts, fixed_error * SAFE, fixed_largest * SAFE)


def derive_slope(dims: int) -> ProvenBounds:
    lipschitz, cell_error = suprema.largest(suprema.SLOPE_LIPSCHITZ, dims, None), error_supremum(slope_error, dims)
    others = largest_fade_effect(dims - 1, None)
    parts = {"cut": lipschitz / ONE,
             "fade": 2 * (float(np.abs(slope_errors()).max()) + slopes().max() / FADE_ONE * others),
             "interpolation": slope_rounding(dims, gradients=False) / (NUMBER_ONE / 4), "scaling": SLOPE_UNIT / 2}
    return derived(0.0, STEEPEST, lipschitz, cell_error, parts, fixed_largest=STEEPEST + sum(parts.values()) * SAFE)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    """A number is the difference of one below 2^30 and one at 2^29; rounding at the end adds 128."""
    return {"number": 2.0**30} | interpolation_intermediates(NUMBER_ONE, dims)


def largest_slope_intermediates(dims: int, gradient: Gradient | None) -> dict[str, float]:
    return largest_intermediates(dims, gradient) | slope_intermediates(2 * NUMBER_ONE, 0, dims)


CASES = tuple((dims, None) for dims in (1, 2, 3, 4))
VALUE = Proof(CASES, derive, largest_intermediates)
VALUE_D = Proof(CASES, lambda dims, _: replace(derive(dims, None), slope=derive_slope(dims)), largest_slope_intermediates)
PROOFS = {
    "value": VALUE,
    "value_d": VALUE_D,
    "value_vector": of_components(VALUE),
    "value_vector_d": of_components(VALUE_D)}
