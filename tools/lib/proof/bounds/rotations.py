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

IN INTEGERS two parts (docs/reference/contract.md, section 10) round down, with factors as large as A and B in units of
2^-18.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from proof.bounds import sine
from proof.bounds.gradients import Gradient
from proof.bounds.integers import FADE_ONE, RAMP_ONE, fixed_scale, part_intermediate, scaled_intermediate
from proof.bounds.noises import Proof, ProvenBounds
from proof.errors import record

Words = Callable[[int, "Gradient | None"], dict[str, float]]

IN_SUM = {2: math.sqrt(2), 3: 2.0}  # |A| + |B|, by the number of dimensions
LARGEST_SHARE = {2: 1.0, 3: 2 / math.sqrt(3)}  # of A and of B
# Two parts, each in units of its whole.
MIXED_ROUNDING = {dims: 511 * in_sum + 2 + 2 * 511 for dims, in_sum in IN_SUM.items()}


def rotated_words(name: str, dims: int, value: float, scale: int) -> dict[str, float]:
    """The words that are scaled: n and m are as large as it, or as they are without a phase."""
    share = math.ceil(LARGEST_SHARE[dims] * FADE_ONE) + 32
    mixture = IN_SUM[dims] * value * sine.fixed_sine_largest() + 2 * MIXED_ROUNDING[dims]
    return {f"part of a turned {name}": part_intermediate(value, np.array([share])), f"rotated {name}": mixture,
            f"scaled {name}": scaled_intermediate(value, scale)}


@dataclass(frozen=True)
class Rotating:
    """A noise and its ranges, by the number of dimensions."""
    name: str  # without a phase
    promise: float
    reach: Callable[[int], Sequence[float]]  # its range and Lipschitz constant with gradients at all phases
    slope_reach: Callable[[int], Sequence[float]]  # and those of a derivative
    scale: Callable[[int], float]
    steps: Callable[[int], int] = lambda _: 1  # to a cell

    def bounds(self, dims: int, slope: bool) -> ProvenBounds:
        return ProvenBounds(*(0.0, *self.slope_reach(dims)) if slope else (self.promise, *self.reach(dims)))

    def unit(self, dims: int, slope: bool) -> float:
        """The unit of scaled ramps, or of the parts of a derivative."""
        return self.scale(dims) / RAMP_ONE[dims] * (4 * self.steps(dims) if slope else 1)

    def words(self, dims: int, slope: bool) -> dict[str, float]:
        off = record.proven(f"{self.name}{'_d' * slope}_phase", dims, "octahedral" if self.name == "perlin" else "none",
                            record.DERIVATIVE if slope else record.VALUE, arithmetic=record.FIXED)
        return rotated_words("derivative" if slope else "value", dims,
                             (self.bounds(dims, slope).range + off) / self.unit(dims, slope), fixed_scale(self.scale(dims), dims))

    def proofs(self, cases: tuple[tuple[int, Gradient | None], ...], words: Words, slope_words: Words
               ) -> tuple[Proof, Proof]:
        """The proofs of the noise, and of the noise with its derivatives; with their words without a phase."""
        def of_value(dims: int, gradient: Gradient | None) -> dict[str, float]:
            return words(dims, gradient) | self.words(dims, False)

        return (Proof(cases, lambda dims, _: self.bounds(dims, False), of_value),
                Proof(cases, lambda dims, _: replace(self.bounds(dims, False), slope=self.bounds(dims, True)),
                      lambda dims, of: of_value(dims, of) | slope_words(dims, of) | self.words(dims, True)))
