"""Section 13 of docs/contract.md: simplex noise."""

from __future__ import annotations

from oracle.kernels import CUBE, FOURTH, QUARTIC, Kernel, noise
from oracle.ramps import THREE_EIGHTHS, WHOLE

# By the number of dimensions. In four no gradient is lengthened.
KERNELS = {2: Kernel(True, 819, 1, QUARTIC, THREE_EIGHTHS, 3242), 3: Kernel(False, 1024, 2, FOURTH, WHOLE, 6570),
           4: Kernel(False, 1024, 2, CUBE, WHOLE, 4298)}

exact, fixed = noise(KERNELS)
