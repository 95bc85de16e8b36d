"""hn_cellular_three: see cellular.py."""

from __future__ import annotations

from proof.bounds import features
from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, cellular

CASES = cellular.CASES
COUNT = 3
largest_intermediates, quotes = cellular.largest_intermediates, cellular.quotes


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return cellular.derived(dims, COUNT)


def ends(dims: int) -> list[float]:
    return [features.largest_distance(dims, COUNT)]


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {"third_largest": features.largest_distance(dims, COUNT)}
