"""Proofs for hn_cellular, from docs/reference/contract.md, section 16; and of hn_cellular_three, which has
its entry in cellular_three.py. features.py and distances.py of the folder above have the proofs.

One bound holds for all metrics: the largest. The bound of floats is the hybrid metric's, whose distances are the largest;
in fixed arithmetic the Euclidean one's, by the root of a small square. The errors of offsets are smaller.
"""

from __future__ import annotations

from proof.bounds import distances, features
from proof.bounds.floats import position_error
from proof.bounds.gradients import Gradient
from proof.bounds.noises import ProvenBounds, listed

CASES = ((2, None), (3, None))
COUNT = 2


def derived(dims: int, count: int) -> ProvenBounds:
    """Bounds of so many distances."""
    most = {metric: features.largest_distance(dims, count, metric) for metric in features.METRICS}
    cell_error = max(distances.metric_error(metric, dims, largest) for metric, largest in most.items())
    slope = max(distances.metric_slope(metric, dims, largest) for metric, largest in most.items())
    fixed = max(distances.fixed_metric_error(metric, dims, largest) for metric, largest in most.items())
    error, largest = position_error(cell_error, slope), max(most.values())
    return ProvenBounds(largest, largest, slope, cell_error, error, largest + error, fixed, largest + fixed,
                   distances.fixed_parts(dims))


def derive(dims: int, _: Gradient | None) -> ProvenBounds:
    return derived(dims, COUNT)


def largest_intermediates(dims: int, _: Gradient | None) -> dict[str, float]:
    return distances.largest_intermediates(dims)


def quotes() -> list[tuple[str, str]]:
    plane, space = ([features.largest_distance(dims, count) for count in (1, 2, 3)] for dims in (2, 3))
    return [("docs/measured/accuracy.md", f"{listed(plane)} in 2D, and below {listed(space)} in 3D")]


def ends(dims: int) -> list[float]:
    return [features.largest_distance(dims, count) for count in (1, COUNT)]


offset_error = distances.offset_error


def describe(dims: int, _: Gradient | None) -> dict[str, object]:
    return {f"{name}_largest": features.largest_distance(dims, count) for count, name in ((1, "first"), (2, "second"))}
