"""hn_perlin and its derivatives: exact.py (ranges and slopes), floats.py and fixed.py (errors); with a phase as in
rotations.py, with gradients at all phases. hn_perlin_d computes the value in the same steps, so it has the same bounds.
Each component of hn_perlin_vector (docs/reference/contract.md, section 22) is hn_perlin with other hashes, and the
bounds hold for any; see value.py."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import rotations
from proof.bounds.floats import position_error
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, SINE, Gradient
from proof.bounds.noises import Proof, ProvenBounds, derived, listed, of_components
from proof.bounds.noises.perlin.exact import SCALE, lipschitz_bound, range_bound, slope_bound, slope_lipschitz_bound
from proof.bounds.noises.perlin.fixed import (
    RAMP_ONE,
    error_parts,
    fixed_error,
    largest_intermediates,
    largest_slope_intermediates,
    range_loss,
    slope_error_parts,
)
from proof.bounds.noises.perlin.floats import error_bound, slope_error_bound
from proof.bounds.table import shortest

ACCURACY = "docs/measured/accuracy.md"


def derive(dims: int, gradient: Gradient) -> ProvenBounds:
    exact, lipschitz = range_bound(dims, gradient), lipschitz_bound(dims, gradient)
    cell_error = error_bound(dims, gradient)
    error = position_error(cell_error, lipschitz)
    return ProvenBounds(exact if gradient is SINE else 1.0, exact, lipschitz, cell_error, error, exact + error,
                        fixed_error(dims, gradient), exact + range_loss(dims, gradient), error_parts(dims, gradient))


def derive_d(dims: int, gradient: Gradient) -> ProvenBounds:
    slope = derived(0.0, slope_bound(dims), slope_lipschitz_bound(dims), slope_error_bound(dims),
                    slope_error_parts(dims))
    return replace(derive(dims, gradient), slope=slope)


def largest_intermediates_d(dims: int, gradient: Gradient) -> dict[str, float]:
    largest = derive_d(dims, gradient).slope.fixed_largest
    return largest_intermediates(dims, gradient) | largest_slope_intermediates(dims, largest)


def quotes() -> list[tuple[str, str]]:
    """The claims of prose on its range."""
    exact = [shortest(range_bound(dims, OCTAHEDRAL), 5) for dims in (1, 2, 3, 4)]
    below = f"{', '.join(exact[:3])} and {exact[3]}"
    return [("docs/reference/knobs.md", f"noise stays below {below} in 1D to 4D."), (ACCURACY, f"stays below {below}.")]


def describe(dims: int, gradient: Gradient) -> dict[str, object]:
    return {"scale": SCALE[gradient][dims], "error_from_cell_to_nearest": error_bound(dims, gradient, 0.5),
            "fixed_beyond_the_range": range_loss(dims, gradient)}


# --- With a phase -----------------------------------------------------------------------------------------------------

def unit(dims: int) -> float:
    """The unit of scaled ramps."""
    return SCALE[ROTATED][dims] / RAMP_ONE[OCTAHEDRAL][dims]


def ratio(dims: int) -> float:
    """The ratio of the scales with and without a phase."""
    return SCALE[ROTATED][dims] / SCALE[OCTAHEDRAL][dims]


def derive_phase(dims: int, gradient: Gradient) -> ProvenBounds:
    return rotations.rotated(derive(dims, gradient), dims, range_bound(dims, ROTATED), lipschitz_bound(dims, ROTATED),
                             unit(dims), ratio(dims))


def derive_slope_phase(dims: int, gradient: Gradient) -> ProvenBounds:
    return rotations.rotated(derive_d(dims, gradient).slope, dims, slope_bound(dims, ROTATED),
                             slope_lipschitz_bound(dims, ROTATED), 4 * unit(dims), ratio(dims))


def derive_d_phase(dims: int, gradient: Gradient) -> ProvenBounds:
    return replace(derive_phase(dims, gradient), slope=derive_slope_phase(dims, gradient))


def scaled_intermediates(name: str, dims: int, largest: float, of_unit: float) -> dict[str, float]:
    return rotations.largest_intermediates(name, dims, largest / of_unit, round(1024 * SCALE[ROTATED][dims]))


def largest_phase_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    return (largest_intermediates(dims, gradient)
            | scaled_intermediates("value", dims, derive_phase(dims, gradient).fixed_largest, unit(dims)))


def largest_slope_phase_intermediates(dims: int, gradient: Gradient) -> dict[str, float]:
    slope = derive_slope_phase(dims, gradient).fixed_largest
    return (largest_phase_intermediates(dims, gradient) | largest_intermediates_d(dims, gradient)
            | scaled_intermediates("derivative", dims, slope, 4 * unit(dims)))


def describe_phase(dims: int, gradient: Gradient) -> dict[str, object]:
    error = ratio(dims) * error_bound(dims, gradient, 0.5)
    return {"scale": SCALE[ROTATED][dims],
            "error_from_cell_to_nearest": rotations.mixed(dims, error, range_bound(dims, ROTATED), 0.5)}


CASES = tuple((dims, OCTAHEDRAL) for dims in (1, 2, 3, 4))
PERLIN = Proof((*CASES, (2, SINE), (3, SINE)), derive, largest_intermediates, describe, quotes=quotes)
PERLIN_D = Proof(CASES, derive_d, largest_intermediates_d, lambda dims, _: {
    "slope_error_from_cell_to_nearest": slope_error_bound(dims, 0.5)})
PROOFS = {
    "perlin": PERLIN,
    "perlin_d": PERLIN_D,
    "perlin_phase": Proof(CASES[1:3], derive_phase, largest_phase_intermediates, describe_phase, quotes=lambda: [
        (ACCURACY,
         f"With a phase `hn_perlin` stays below {listed([range_bound(dims, ROTATED) for dims in (2, 3)])} in 2D")]),
    "perlin_d_phase": Proof(CASES[1:3], derive_d_phase, largest_slope_phase_intermediates),
    "perlin_vector": of_components(PERLIN),
    "perlin_vector_d": of_components(PERLIN_D)}
