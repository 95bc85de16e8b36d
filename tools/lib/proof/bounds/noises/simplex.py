"""Proofs for hn_simplex and its derivatives, hn_simplex_smooth, and both of the former with a phase, from
docs/reference/contract.md, sections 13 and 14. kernels.py has the range and the slopes, kernel_floats.py and
kernel_fixed.py the errors, and rotations.py what a phase changes; here they are put together. With derivatives the
value is computed in the same steps, so it has the same bounds."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import kernel_fixed, kernel_floats, kernels, rotations
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, Gradient
from proof.bounds.kernel_fixed import ramp_one
from proof.bounds.kernels import ROTATING, SIMPLEX, SMOOTH, Kernel
from proof.bounds.noises import Proof, ProvenBounds, derived, listed

ACCURACY = "docs/measured/accuracy.md"


def derived_value(kernel: Kernel) -> ProvenBounds:
    exact, lipschitz = kernel.scale / 1024 * kernels.range_of(kernel, OCTAHEDRAL), lipschitz_of(kernel, OCTAHEDRAL)
    return derived(1.0, exact, lipschitz, kernel_floats.error_bound(kernel),
                   kernel_fixed.error_parts(kernel, lipschitz))


def derived_slope(kernel: Kernel) -> ProvenBounds:
    lipschitz = slope_lipschitz_of(kernel, OCTAHEDRAL)
    return derived(0.0, slope_of(kernel, OCTAHEDRAL), lipschitz, kernel_floats.slope_error_bound(kernel),
                   kernel_fixed.slope_error_parts(kernel, lipschitz))


# Per cell, and scaled.

def lipschitz_of(kernel: Kernel, gradient: Gradient) -> float:
    return kernel.steps * kernel.scale / 1024 * kernels.lipschitz_of(kernel, gradient)


def slope_of(kernel: Kernel, gradient: Gradient) -> float:
    return kernel.steps * kernel.scale / 1024 * kernels.slope_of(kernel, gradient)


def slope_lipschitz_of(kernel: Kernel, gradient: Gradient) -> float:
    return kernel.steps**2 * kernel.scale / 1024 * kernels.slope_lipschitz_of(kernel, gradient)


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return derived_value(SIMPLEX[dims])


def derive_d(dims: int, _: Gradient | None) -> ProvenBounds:
    return replace(derive(dims, None), slope=derived_slope(SIMPLEX[dims]))


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return kernel_fixed.largest_intermediates(SIMPLEX[dims])


def largest_slope_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return largest_intermediates(dims, None) | kernel_fixed.largest_slope_intermediates(SIMPLEX[dims])


def below(proof: Proof) -> str:
    return listed([proof.derive(*case).range for case in proof.cases])


def describe(kernels_: dict[int, Kernel], dims: int) -> dict[str, object]:
    return {"scale": kernels_[dims].scale / 1024,
            "error_from_cell_to_nearest": kernel_floats.error_bound(kernels_[dims], 0.5)}


# --- With a phase -----------------------------------------------------------------------------------------------------

def unit(dims: int) -> float:
    """The unit of scaled ramps."""
    return ROTATING[dims].scale / 1024 / ramp_one(dims)


def ratio(dims: int) -> float:
    """The ratio of the scales with and without a phase."""
    return ROTATING[dims].scale / SIMPLEX[dims].scale


def derive_phase(dims: int, _: Gradient | None) -> ProvenBounds:
    kernel = ROTATING[dims]
    return rotations.rotated(derived_value(SIMPLEX[dims]), dims,
                             kernel.scale / 1024 * kernels.range_of(kernel, ROTATED),
                             lipschitz_of(kernel, ROTATED), unit(dims), ratio(dims))


def derive_slope_phase(dims: int) -> ProvenBounds:
    kernel = ROTATING[dims]
    return rotations.rotated(derived_slope(SIMPLEX[dims]), dims, slope_of(kernel, ROTATED),
                             slope_lipschitz_of(kernel, ROTATED), 4 * kernel.steps * unit(dims), ratio(dims))


def scaled_intermediates(name: str, dims: int, largest: float, of_unit: float) -> dict[str, float]:
    return rotations.largest_intermediates(name, dims, largest / of_unit, kernel_fixed.fixed_scale(ROTATING[dims]))


def largest_phase_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return (kernel_fixed.largest_intermediates(ROTATING[dims])
            | scaled_intermediates("value", dims, derive_phase(dims, None).fixed_largest, unit(dims)))


def largest_slope_phase_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    slope, of_unit = derive_slope_phase(dims).fixed_largest, 4 * ROTATING[dims].steps * unit(dims)
    return (largest_phase_intermediates(dims, None) | largest_slope_intermediates(dims, None)
            | scaled_intermediates("derivative", dims, slope, of_unit))


CASES, ROTATING_CASES, SMOOTH_CASES = (tuple((dims, None) for dims in of) for of in (SIMPLEX, ROTATING, SMOOTH))
PROOFS = {
    "simplex": Proof(
        CASES, derive, largest_intermediates, lambda dims, _: describe(SIMPLEX, dims),
        quotes=lambda: [(ACCURACY, f"`hn_simplex` stays below {below(PROOFS['simplex'])} in 2D to 4D")]),
    "simplex_d": Proof(
        CASES, derive_d, largest_slope_intermediates, lambda dims, _: {
            "slope_error_from_cell_to_nearest": kernel_floats.slope_error_bound(SIMPLEX[dims], 0.5)}),
    "simplex_phase": Proof(
        ROTATING_CASES, derive_phase, largest_phase_intermediates,
        lambda dims, _: {"scale": ROTATING[dims].scale / 1024},
        quotes=lambda: [(ACCURACY, f"and `hn_simplex` below {below(PROOFS['simplex_phase'])}.")]),
    "simplex_d_phase": Proof(
        ROTATING_CASES, lambda dims, _: replace(derive_phase(dims, None), slope=derive_slope_phase(dims)),
        largest_slope_phase_intermediates),
    "simplex_smooth": Proof(
        SMOOTH_CASES, lambda dims, _: derived_value(SMOOTH[dims]),
        lambda dims, _: kernel_fixed.largest_intermediates(SMOOTH[dims]), lambda dims, _: describe(SMOOTH, dims),
        quotes=lambda: [(ACCURACY, f"`hn_simplex_smooth` below {below(PROOFS['simplex_smooth'])} in 2D")])}
