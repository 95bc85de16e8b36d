"""Tests of the gradients: each that the library has comes as often as each other, and no other comes."""

from __future__ import annotations

from itertools import product

import numpy as np

from quality.judgement import Finding, chi_square
from quality.lattice import Lattice

# Those of docs/contract.md, section 4: on the plane (3, 1) / 4 and (1, 3) / 4 with signs, in space the edges of a cube.
GRADIENTS = {2: np.array([g for g in product((-0.75, -0.25, 0.25, 0.75), repeat=2) if abs(g[0]) + abs(g[1]) == 1]),
             3: np.array([g for g in product((-1.0, 0.0, 1.0), repeat=3) if g.count(0.0) == 1])}


def _counts(lattice: Lattice) -> np.ndarray:
    """How often each of them comes."""
    base = 16.0 ** np.arange(lattice.dimensions)  # a gradient becomes one number, which is exact for the library's
    own = GRADIENTS[lattice.dimensions] @ base
    found, counts = np.unique(lattice.gradients.reshape(-1, lattice.dimensions) @ base, return_counts=True)
    return np.array([counts[found == one].sum() for one in own])


def frequencies(lattice: Lattice) -> list[Finding]:
    return [chi_square("directions: frequencies", _counts(lattice))]


def others(lattice: Lattice) -> Finding:
    """How many gradients are none of them."""
    count = int(lattice.words.size - _counts(lattice).sum())
    return Finding("directions: others", count, 0, 0, float(count == 0), lattice.words.size, 1)
