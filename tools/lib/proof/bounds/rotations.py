"""Noise whose gradients rotate with a phase (docs/reference/contract.md, section 14): what is proven of it, from what
is proven of the noise without a phase, with the scale of that with a phase.

At the angle a = 2 pi phase a gradient g has become cos(a) g + sin(a) g', and the noise, or a derivative, N(a) = cos(a)
N(0) + sin(a) N(1/4 turn). The exact noise is bounded with all gradients at all phases (ROTATED in gradients.py), and so
is how fast it changes. So the length of (N(0), N(1/4 turn)) is at most the range R. A cosine and a sine that are off by
d move the noise by at most sqrt(2) d R.

It is computed as A n + B m, where n is the noise of the gradients g, and m the noise of other gradients of the same
set: all bounds of n hold for m, too.

ON THE PLANE these are the g', A the cosine and B the sine. |A| + |B| is at most sqrt(2), and so is that times e what
the noise is moved by if n and m are off by e.

IN SPACE they are the edges e = (g + sqrt(3) g') / 2, B = 2 sin(a) / sqrt(3) and A = cos(a) - B / 2. Both are 2 /
sqrt(3) times a cosine, of angles that are 120 degrees apart: so |A| + |B| is at most 2, at a = 120 degrees. B is
rounded, by b, and A, by a' beside the cosine and B / 2: this moves the noise by b (m - n / 2) + a' n = b sqrt(3)/2
N(1/4 turn) + a' n, at most (sqrt(3)/2 b + a') R.

IN FLOATS the text proves the rest: PROVEN in text.py.

IN INTEGERS the cosine and the sine are off by the error of a sine, and by the angle that is cut off. In space B is 2
sin(a) / sqrt(3) with 20277 / 2^15 for 4 (2 / sqrt(3) - 1), rounded down to a multiple of 2^-18, and B >> 1 rounds down
to one. All parts of an error but the cut of the place and SCALE are moved by sqrt(2), or by 2. Two parts
(docs/reference/contract.md, section 10) round down, with factors as large as A and B in units of 2^-18.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from proof.bounds import sine
from proof.bounds.gradients import Gradient
from proof.bounds.integers import FADE_ONE, RAMP_ONE, fixed_scale, part_intermediate, scaled_intermediate
from proof.bounds.noises import Proof, ProvenBounds, derived

Words = Callable[[int, "Gradient | None"], dict[str, float]]

ANGLE_CUT = 2 * math.pi * 2.0**-30  # a phase is cut off to a multiple of 2^-30 turns
IN_SUM = {2: math.sqrt(2), 3: 2.0}  # |A| + |B|, by the number of dimensions
OFF_IN_SUM = {2: 2.0, 3: 3.0}  # how far they are off, by the error of a cosine and a sine
LARGEST_SHARE = {2: 1.0, 3: 2 / math.sqrt(3)}  # of A and of B
# Two parts, each in units of its whole.
MIXED_ROUNDING = {dims: 511 * in_sum + 2 + 2 * 511 for dims, in_sum in IN_SUM.items()}


@functools.cache
def float_error() -> float:
    """The error of the cosine and the sine of a phase."""
    return sine.sine_bound() + ANGLE_CUT


@functools.cache
def fixed_error() -> float:
    return sine.fixed_sine_error() + ANGLE_CUT


def fixed_rounding(dims: int) -> float:
    """The rounding in integers, where a sine is at most 2^16."""
    if dims == 2:
        return 0.0
    b = (1 + abs(20277 / 2**15 - 4 * (LARGEST_SHARE[3] - 1)) * 2**16) / FADE_ONE
    return b / LARGEST_SHARE[3] + 1 / 2 / FADE_ONE


def moved(dims: int, error: float, off: float, largest: float, rounding: float = 0.0) -> float:
    """A noise of at most that size, if n and m are off by `error`, and the cosine and the sine by `off`, and what A and
    B round by moves it by `rounding`."""
    return (IN_SUM[dims] * error + (math.sqrt(2) * off + rounding) * largest
            + (OFF_IN_SUM[dims] * off + 2 * rounding) * error)


def rotated(still: ProvenBounds, dims: int, largest: float, lipschitz: float, unit: float,
            ratio: float = 1.0) -> ProvenBounds:
    """Bounds of a noise, or of its derivatives. In integers n has this unit, times the scale, which is so much of that
    without a phase, and no more than it: SCALE is no more, either."""
    if not still.fixed_parts:  # the text proves that error
        return derived(still.promise, largest, lipschitz)
    parts = {name: IN_SUM[dims] * ratio * value for name, value in still.fixed_parts.items()}
    parts |= {"cut": still.fixed_parts["cut"] / still.lipschitz * lipschitz, "scaling": still.fixed_parts["scaling"]}
    beside = ratio * sum(value for name, value in still.fixed_parts.items() if name not in ("cut", "scaling"))
    parts["gradient"] = (moved(dims, beside, fixed_error(), largest, fixed_rounding(dims)) - IN_SUM[dims] * beside
                         + MIXED_ROUNDING[dims] * unit)
    return derived(still.promise, largest, lipschitz, parts=parts)


def rotated_words(name: str, dims: int, value: float, scale: int) -> dict[str, float]:
    """The words that are scaled: n and m are as large as it, or as they are without a phase."""
    share = math.ceil(LARGEST_SHARE[dims] * FADE_ONE) + 32
    mixture = IN_SUM[dims] * value * sine.fixed_sine_largest() + 2 * MIXED_ROUNDING[dims]
    return {f"part of a turned {name}": part_intermediate(value, np.array([share])), f"rotated {name}": mixture,
            f"scaled {name}": scaled_intermediate(value, scale)}


@dataclass(frozen=True)
class Rotating:
    """A noise and its ranges, by the number of dimensions."""
    still: Callable[[int], ProvenBounds]  # without a phase, with its derivatives
    reach: Callable[[int], Sequence[float]]  # its range and Lipschitz constant with gradients at all phases
    slope_reach: Callable[[int], Sequence[float]]  # and those of a derivative
    scale: Callable[[int], float]
    still_scale: Callable[[int], float]
    steps: Callable[[int], int] = lambda _: 1  # to a cell

    def bounds(self, dims: int, slope: bool) -> ProvenBounds:
        still = self.still(dims)
        return rotated(still.slope if slope else still, dims, *(self.slope_reach if slope else self.reach)(dims),
                       self.unit(dims, slope), self.scale(dims) / self.still_scale(dims))

    def unit(self, dims: int, slope: bool) -> float:
        """The unit of scaled ramps, or of the parts of a derivative."""
        return self.scale(dims) / RAMP_ONE[dims] * (4 * self.steps(dims) if slope else 1)

    def words(self, dims: int, slope: bool) -> dict[str, float]:
        largest = self.bounds(dims, slope).fixed_largest
        return {} if largest is None else rotated_words("derivative" if slope else "value", dims,
                                                        largest / self.unit(dims, slope), fixed_scale(self.scale(dims), dims))

    def proofs(self, cases: tuple[tuple[int, Gradient | None], ...], words: Words, slope_words: Words
               ) -> tuple[Proof, Proof]:
        """The proofs of the noise, and of the noise with its derivatives; with their words without a phase."""
        def of_value(dims: int, gradient: Gradient | None) -> dict[str, float]:
            return words(dims, gradient) | self.words(dims, False)

        return (Proof(cases, lambda dims, _: self.bounds(dims, False), of_value),
                Proof(cases, lambda dims, _: replace(self.bounds(dims, False), slope=self.bounds(dims, True)),
                      lambda dims, of: of_value(dims, of) | slope_words(dims, of) | self.words(dims, True)))
