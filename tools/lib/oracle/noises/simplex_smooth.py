"""Section 13 of docs/contract.md: simplex noise whose kernels reach farther."""

from __future__ import annotations

from oracle.kernels import CUBE, FIFTH, Kernel, noise
from oracle.ramps import THREE_EIGHTHS, TWICE

# By the number of dimensions.
KERNELS = {2: Kernel(True, 1024, 1, CUBE, THREE_EIGHTHS, 2428), 3: Kernel(False, 768, 1, FIFTH, TWICE, 3901)}

exact, fixed = noise(KERNELS)
