"""Proofs for hn_simplex and its derivatives, hn_simplex_smooth, and both of the former with a phase, from
docs/reference/contract.md, sections 13 and 14. kernels.py has the range and the slopes, kernel_fixed.py the integers, and
rotations.py what a phase changes; here they are put together. With derivatives the value is computed in the same steps, so
it has the same bounds."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import kernel_fixed, kernels
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, Gradient
from proof.bounds.kernels import ROTATING, SIMPLEX, SMOOTH, Kernel
from proof.bounds.noises import Proof, ProvenBounds
from proof.bounds.rotations import Rotating


def derived_value(kernel: Kernel) -> ProvenBounds:
    return ProvenBounds(1.0, kernel.scale / 1024 * kernels.range_of(kernel, OCTAHEDRAL), lipschitz_of(kernel, OCTAHEDRAL))


def derived_slope(kernel: Kernel) -> ProvenBounds:
    return ProvenBounds(0.0, slope_of(kernel, OCTAHEDRAL), slope_lipschitz_of(kernel, OCTAHEDRAL))


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
    return {} if dims == 2 else kernel_fixed.largest_intermediates(SIMPLEX[dims])


def largest_slope_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return {} if dims == 2 else largest_intermediates(dims, None) | kernel_fixed.largest_slope_intermediates(SIMPLEX[dims])


CASES, ROTATING_CASES, SMOOTH_CASES = (tuple((dims, None) for dims in of) for of in (SIMPLEX, ROTATING, SMOOTH))
PHASE, PHASE_D = Rotating(
    "simplex", 1.0, lambda dims: (ROTATING[dims].scale / 1024 * kernels.range_of(ROTATING[dims], ROTATED),
                                  lipschitz_of(ROTATING[dims], ROTATED)),
    lambda dims: [of(ROTATING[dims], ROTATED) for of in (slope_of, slope_lipschitz_of)],
    lambda dims: ROTATING[dims].scale / 1024, lambda dims: SIMPLEX[dims].steps).proofs(
        ROTATING_CASES, lambda dims, _: {} if dims == 2 else kernel_fixed.largest_intermediates(ROTATING[dims]),
        largest_slope_intermediates)
PROOFS = {
    "simplex": Proof(CASES, derive, largest_intermediates),
    "simplex_d": Proof(CASES, derive_d, largest_slope_intermediates),
    "simplex_phase": PHASE,
    "simplex_d_phase": PHASE_D,
    "simplex_smooth": Proof(SMOOTH_CASES, lambda dims, _: derived_value(SMOOTH[dims]),
                            lambda dims, _: kernel_fixed.largest_intermediates(SMOOTH[dims]))}
