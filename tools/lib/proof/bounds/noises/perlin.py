"""The ranges of hn_perlin and its derivatives, from docs/reference/contract.md, sections 6, 8 and 10; with a phase for
gradients at all phases (section 14). hn_perlin_d computes the value in the same steps, so it has the same range. Each
component of hn_perlin_vector (section 22) is hn_perlin with other hashes, and the range holds for any; see means.py.

SCALES. The octahedral gradient has multiples of 1/1024 below the inverse of the supremum before scaling.
It is 1/2 times 511/512 on the line, 1.03636 in space and 1.07346 in 4D. On the plane it is for gradients that
rotate with a phase, which have the same scale: 0.559017, in the middle of the cell, where gradients that do not rotate
reach 0.508437. In space gradients that rotate reach 1.16420 and have a scale of their own. The rest up to 1 is room for
the errors of the fixed arithmetic; in space the scale without a phase could be 3/1024 larger.

SINE GRADIENT. Its components are independent, |g_i| <= 1, and nothing is scaled. The range is exact: the supremum over
the gradients is the sum over the axes of

    (1 - u_i) f_i + u_i (1 - f_i) = 1/2 - (1 - 2 f_i) (1 - 2 u_i) / 2 <= 1/2

with u_i = s(f_i) (the weights of the other axes sum to 1, and u_i <= 1/2 just where f_i <= 1/2), so it is n/2, in the
middle of the cell.

The scales of the octahedral gradient leave 1 less the range of the exact noise, more than the error: |hn_perlin| <= 1.
Octave sums round by less than 2 units of 2^-21 an octave (sums.py), 64 in 32 octaves; of the first, whose weight is 2^18,
the same room is left.
"""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import suprema
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, SINE, Gradient
from proof.bounds.noises import Proof, ProvenBounds, of_components
from proof.bounds.table import shortest

SCALE = {OCTAHEDRAL: {1: 2.0, 2: 1831 / 1024, 3: 985 / 1024, 4: 953 / 1024},
         ROTATED: {2: 1831 / 1024, 3: 879 / 1024}, SINE: {2: 1.0, 3: 1.0}}


def range_bound(dims: int, gradient: Gradient) -> float:
    """A proven upper bound of |value|."""
    return dims / 2 if gradient is SINE else SCALE[gradient][dims] * suprema.largest(suprema.VALUE, dims, gradient)


def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    exact = range_bound(dims, gradient)
    return ProvenBounds(exact if gradient is SINE else 1.0, exact)


def derive_d(dims: int, gradient: Gradient) -> ProvenBounds:
    slope = SCALE[gradient][dims] * suprema.largest(suprema.SLOPE, dims, gradient)
    return replace(derive(dims, gradient), slope=ProvenBounds(0.0, slope))


def quotes() -> list[tuple[str, str]]:
    """The claims of prose on its range."""
    exact = [shortest(range_bound(dims, OCTAHEDRAL), 5) for dims in (1, 2, 3, 4)]
    below = f"{', '.join(exact[:3])} and {exact[3]}"
    return [("docs/reference/knobs.md", f"noise stays below {below} in 1D to 4D.")]


CASES = tuple((dims, OCTAHEDRAL) for dims in (1, 2, 3, 4))
PERLIN = Proof((*CASES, (2, SINE), (3, SINE)), derive, quotes=quotes)
PERLIN_D = Proof(CASES, derive_d)
PROOFS = {
    "perlin": PERLIN, "perlin_d": PERLIN_D,
    "perlin_phase": Proof(CASES[1:3], lambda dims, _: derive(dims, ROTATED)),
    "perlin_d_phase": Proof(CASES[1:3], lambda dims, _: derive_d(dims, ROTATED)),
    "perlin_vector": of_components(PERLIN), "perlin_vector_d": of_components(PERLIN_D)}
