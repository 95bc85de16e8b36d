"""Section 13 of docs/contract.md: simplex noise."""

from __future__ import annotations

from oracle.kernels import Kernel, noise

# By the number of dimensions.
KERNELS = {2: Kernel(True, 819, 1, 6155), 3: Kernel(False, 1024, 2, 5036), 4: Kernel(False, 1024, 2, 4298)}

exact, fixed = noise(KERNELS)
