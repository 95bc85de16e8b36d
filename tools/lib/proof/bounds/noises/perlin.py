"""hn_perlin and its derivatives, from docs/reference/contract.md, sections 6, 8 and 10; with a phase as in rotations.py,
with gradients at all phases. hn_perlin_d computes the value in the same steps, so it has the same bounds. Each component
of hn_perlin_vector (section 22) is hn_perlin with other hashes, and the bounds hold for any; see value.py.

RANGE. The scales of the octahedral gradient are multiples of 1/1024 below the inverse of the supremum before scaling.
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
from proof.bounds.integers import RAMP_ONE, fixed_scale, scaled_intermediate, slope_intermediates
from proof.bounds.noises import Proof, ProvenBounds, of_components
from proof.bounds.rotations import Rotating
from proof.bounds.table import shortest
from proof.errors import record

SCALE = {OCTAHEDRAL: {1: 2.0, 2: 1831 / 1024, 3: 985 / 1024, 4: 953 / 1024},
         ROTATED: {2: 1831 / 1024, 3: 879 / 1024}, SINE: {2: 1.0, 3: 1.0}}


def range_bound(dims, gradient):
    """A proven upper bound of |value|."""
    if gradient is SINE:
        return dims / 2
    return scaled(suprema.VALUE, dims, gradient)


def scaled(quantity, dims, gradient):
    return SCALE[gradient][dims] * suprema.largest(quantity, dims, gradient)


def lipschitz_bound(dims, gradient):
    """A proven upper bound of the L1 norm of the noise's gradient."""
    return scaled(suprema.LIPSCHITZ, dims, gradient)


def slope_bound(dims, gradient=OCTAHEDRAL):
    """A proven upper bound of |derivative|."""
    return scaled(suprema.SLOPE, dims, gradient)


def slope_lipschitz_bound(dims, gradient=OCTAHEDRAL):
    return scaled(suprema.SLOPE_LIPSCHITZ, dims, gradient)


# --- Overflow ---------------------------------------------------------------------------------------------------------

# Two derivatives in space have slopes of at most 15/8 times two differences of ramps. The differences of four ramps with
# the offsets x, 1 - x and y, 1 - y are 4 ramps of at most 1 + max(|x|, |y|), which sum to at most 7: the maxima are
# convex in x and y, and sum to 3 at the ends. A component is at most 1.
LARGEST_DERIVATIVES_DIFFERENCE = {3: 15 / 8 * 7 + 2}


def largest_slope_intermediates(dims, slope):
    """The words of derivatives up to that, in 3D with a phase, and in 4D."""
    one = RAMP_ONE[dims]
    apart = LARGEST_DERIVATIVES_DIFFERENCE[dims] * one / 4 if dims == 3 else None
    largest = slope / SCALE[OCTAHEDRAL][dims] * one / 4
    return {**slope_intermediates(min(2 * OCTAHEDRAL.reach(dims), 4) * one, OCTAHEDRAL.component(dims) * one / 4, dims,
                                  apart),
            "scaled derivative": scaled_intermediate(largest, fixed_scale(SCALE[OCTAHEDRAL][dims], dims))}


# --- Proofs -----------------------------------------------------------------------------------------------------------

def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    exact = range_bound(dims, gradient)
    return ProvenBounds(exact if gradient is SINE else 1.0, exact, lipschitz_bound(dims, gradient))


def derive_d(dims: int, gradient: Gradient) -> ProvenBounds:
    return replace(derive(dims, gradient), slope=ProvenBounds(0.0, slope_bound(dims), slope_lipschitz_bound(dims)))


def largest_intermediates_d(dims: int, _: Gradient | None = None) -> dict[str, float]:
    """In 3D, of the noise with a phase; in 4D."""
    off = record.proven("perlin_d", dims, "octahedral", record.DERIVATIVE, arithmetic=record.FIXED)
    return largest_slope_intermediates(dims, slope_bound(dims) + off)


def quotes() -> list[tuple[str, str]]:
    """The claims of prose on its range."""
    exact = [shortest(range_bound(dims, OCTAHEDRAL), 5) for dims in (1, 2, 3, 4)]
    below = f"{', '.join(exact[:3])} and {exact[3]}"
    return [("docs/reference/knobs.md", f"noise stays below {below} in 1D to 4D.")]


CASES = tuple((dims, OCTAHEDRAL) for dims in (1, 2, 3, 4))
PERLIN = Proof((*CASES, (2, SINE), (3, SINE)), derive, quotes=quotes)
PERLIN_D = Proof(CASES, derive_d, lambda dims, _: largest_intermediates_d(dims) if dims == 4 else {})
PHASE, PHASE_D = Rotating(
    "perlin", 1.0, lambda dims: [of(dims, ROTATED) for of in (range_bound, lipschitz_bound)],
    lambda dims: [of(dims, ROTATED) for of in (slope_bound, slope_lipschitz_bound)], lambda dims: SCALE[ROTATED][dims]).proofs(
        CASES[1:3], lambda *_: {}, lambda dims, _: {} if dims == 2 else largest_intermediates_d(dims))
PROOFS = {
    "perlin": PERLIN, "perlin_d": PERLIN_D, "perlin_d_phase": PHASE_D,
    "perlin_phase": PHASE,
    "perlin_vector": of_components(PERLIN), "perlin_vector_d": of_components(PERLIN_D)}
