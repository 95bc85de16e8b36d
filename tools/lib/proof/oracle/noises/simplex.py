"""Sections 13 and 14 of docs/reference/contract.md: simplex noise, with its derivatives, with a phase, and with kernels
that reach farther."""

from __future__ import annotations

from dataclasses import replace

from proof.oracle.kernels import CUBE, FIFTH, FOURTH, QUARTIC, Kernel, noise
from proof.oracle.noises import Noise, rotating

# By the number of dimensions.
KERNELS = {2: Kernel(True, 819, 1, QUARTIC, 4099), 3: Kernel(False, 1024, 2, FOURTH, 4918),
           4: Kernel(False, 1024, 2, CUBE, 4298)}
ROTATING = KERNELS | {3: replace(KERNELS[3], scale=4902)}
SMOOTH = {2: Kernel(True, 1024, 1, CUBE, 3081), 3: Kernel(False, 768, 1, FIFTH, 4279)}

SIMPLEX_D = Noise("simplex_d", *noise(KERNELS, with_derivatives=True))
SIMPLEX_D_PHASE = rotating(Noise("", *noise(ROTATING, with_derivatives=True)), "simplex_d_phase")
NOISES = (Noise("simplex", *noise(KERNELS)), SIMPLEX_D,
          rotating(Noise("", *noise(ROTATING)), "simplex_phase"), SIMPLEX_D_PHASE,
          Noise("simplex_smooth", *noise(SMOOTH)))
