"""Octave sums: their kinds, and how much their rotations stretch a length."""

from __future__ import annotations

import math

import catalog.model
from proof.oracle import sums as oracle

CATALOG = {sum_.name: sum_ for sum_ in catalog.model.read().sums}
KINDS = tuple(name for name, sum_ in CATALOG.items() if sum_.is_of_values)
SLOPED, SHIFTS = ("fbm_d", "eroded"), ("warp", "warp_progressive")  # sums with slopes, and of vectors: jacobians.py
FLOWS = ("curl_fbm",)  # with or without a phase
# By how much each rotation of a position makes a length larger at most, which stays along other axes.
ROTATIONS = tuple(max(math.hypot(*rotation) / 32, 1.0) for rotation in oracle.ROTATIONS)
LARGEST_STRENGTH = {name: float(sum_.strength.most) for name, sum_ in CATALOG.items() if sum_.strength}
