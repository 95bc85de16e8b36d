"""Proofs for hn_simplex, from docs/reference/contract.md, section 13. kernels.py has its range and slopes,
kernel_floats.py and kernel_fixed.py its errors; here they are put together, for all noises of this kind."""

from __future__ import annotations

from proof.bounds import kernel_fixed, kernel_floats, kernels
from proof.bounds.gradients import OCTAHEDRAL, Gradient
from proof.bounds.kernels import SIMPLEX, Kernel
from proof.bounds.noises import ProvenBounds, derived, listed

CASES = tuple((dims, None) for dims in SIMPLEX)


def derived_value(kernel: Kernel) -> ProvenBounds:
    exact, lipschitz = kernel.scale / 1024 * kernels.range_of(kernel, OCTAHEDRAL), lipschitz_of(kernel, OCTAHEDRAL)
    return derived(1.0, exact, lipschitz, kernel_floats.error_bound(kernel), kernel_fixed.error_parts(kernel, lipschitz))


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


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return kernel_fixed.largest_intermediates(SIMPLEX[dims])


def quotes() -> list[tuple[str, str]]:
    below = listed([derive(*case).range for case in CASES])
    return [("docs/measured/accuracy.md", f"`hn_simplex` stays below {below} in 2D to 4D")]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"scale": SIMPLEX[dims].scale / 1024,
            "error_from_cell_to_nearest": kernel_floats.error_bound(SIMPLEX[dims], 0.5)}
