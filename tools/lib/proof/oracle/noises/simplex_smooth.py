"""Section 13 of docs/reference/contract.md: simplex noise whose kernels reach farther."""

from __future__ import annotations

from proof.oracle.kernels import CUBE, FIFTH, Kernel, noise

# By the number of dimensions.
KERNELS = {2: Kernel(True, 1024, 1, CUBE, 3081), 3: Kernel(False, 768, 1, FIFTH, 4279)}

exact, fixed = noise(KERNELS)
