"""Section 13 of docs/reference/contract.md: simplex noise."""

from __future__ import annotations

from proof.oracle.kernels import CUBE, FOURTH, QUARTIC, Kernel, noise

# By the number of dimensions.
KERNELS = {2: Kernel(True, 819, 1, QUARTIC, 4099), 3: Kernel(False, 1024, 2, FOURTH, 4918),
           4: Kernel(False, 1024, 2, CUBE, 4298)}

exact, fixed = noise(KERNELS)
