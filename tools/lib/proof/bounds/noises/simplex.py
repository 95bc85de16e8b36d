"""The ranges of hn_simplex and its derivatives, hn_simplex_smooth, and both of the former with a phase, from
docs/reference/contract.md, sections 13 and 14. kernels.py derives them, with a phase for gradients at all phases. With
derivatives the value is computed in the same steps, so it has the same range."""

from __future__ import annotations

from dataclasses import replace

from proof.bounds import kernels
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, Gradient
from proof.bounds.kernels import ROTATING, SIMPLEX, SMOOTH, Kernel
from proof.bounds.noises import Proof, ProvenBounds


def value_of(kernel: Kernel, gradient: Gradient = OCTAHEDRAL) -> ProvenBounds:
    return ProvenBounds(1.0, kernel.scale / 1024 * kernels.range_of(kernel, gradient))


def slope_of(kernel: Kernel, gradient: Gradient = OCTAHEDRAL) -> ProvenBounds:
    """Per cell."""
    return ProvenBounds(0.0, kernel.steps * kernel.scale / 1024 * kernels.slope_of(kernel, gradient))


def proofs(of_dims: dict[int, Kernel], gradient: Gradient = OCTAHEDRAL) -> tuple[Proof, Proof]:
    """Of the noise, and of that with its derivatives."""
    cases = tuple((dims, None) for dims in of_dims)
    return (Proof(cases, lambda dims, _: value_of(of_dims[dims], gradient)),
            Proof(cases, lambda dims, _: replace(value_of(of_dims[dims], gradient), slope=slope_of(of_dims[dims], gradient))))


STILL, STILL_D = proofs(SIMPLEX)
PHASE, PHASE_D = proofs(ROTATING, ROTATED)
PROOFS = {"simplex": STILL, "simplex_d": STILL_D, "simplex_phase": PHASE, "simplex_d_phase": PHASE_D,
          "simplex_smooth": proofs(SMOOTH)[0]}
