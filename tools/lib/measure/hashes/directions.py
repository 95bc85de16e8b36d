"""Tests of the gradients: each that the library has comes as often as it should, and no other comes."""

from __future__ import annotations

from itertools import product

import numpy as np

from measure.hashes.judgement import Finding, chi_square
from measure.hashes.lattice import Lattice

# The directions of docs/reference/contract.md, section 4: on the plane (3, 1) / 4 and (1, 3) / 4 with signs, in space
# the edges of a cube.
GRADIENTS = {2: np.array([g for g in product((-0.75, -0.25, 0.25, 0.75), repeat=2) if abs(g[0]) + abs(g[1]) == 1]),
             3: np.array([g for g in product((-1.0, 0.0, 1.0), repeat=3) if g.count(0.0) == 1])}


def likelihoods(dimensions: int) -> np.ndarray:
    """How likely each of them is. In space the thirds of all words end within a block of the bits 22 and 21, so that of
    the four gradients of a third some are more likely by 0.2%, and one is less likely by 0.4%."""
    if dimensions == 2:
        return np.full(8, 1 / 8)
    ends = [0, 0x55555555, 0xAAAAAAAA, 1 << 32]  # words that choose x and y, x and z, y and z

    def below(end: int, signs: int) -> int:  # words with these bits
        return (end >> 23 << 21) + min(max(end % (1 << 23) - (signs << 21), 0), 1 << 21)

    found = []
    for gradient in GRADIENTS[3]:
        axes = np.flatnonzero(gradient)
        signs = 2 * int(gradient[axes[0]] < 0) + int(gradient[axes[1]] < 0)
        third = int(axes.sum()) - 1
        found.append(below(ends[third + 1], signs) - below(ends[third], signs))
    return np.array(found) / 2.0 ** 32


def _counts(lattice: Lattice) -> np.ndarray:
    """How often each of them comes."""
    base = 16.0 ** np.arange(lattice.dimensions)  # a gradient becomes one number, which is exact for the library's
    own = GRADIENTS[lattice.dimensions] @ base
    found, counts = np.unique(lattice.gradients.reshape(-1, lattice.dimensions) @ base, return_counts=True)
    return np.array([counts[found == one].sum() for one in own])


def frequencies(lattice: Lattice) -> list[Finding]:
    """Their chi-square, of counts that are weighted to be equally likely: by 0.4% at most, as much as its value is off."""
    likely = likelihoods(lattice.dimensions)
    return [chi_square("directions: frequencies", _counts(lattice) / (likely * len(likely)))]


def others(lattice: Lattice) -> Finding:
    """How many gradients are none of them."""
    count = int(lattice.words.size - _counts(lattice).sum())
    return Finding("directions: others", count, 0, 0, float(count == 0), lattice.words.size, 1)
