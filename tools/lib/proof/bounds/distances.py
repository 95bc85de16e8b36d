"""How fast the distances of cellular noise change, and how large its integers are."""

from __future__ import annotations

import math

from proof.bounds import features

LARGEST_COMPONENT = {2: 511 / 512, 3: 255 / 256}  # of a direction


def euclidean_reach(metric: str, dims: int, largest: float) -> float:
    """How far a point can be that is so far in a metric."""
    return {"euclidean": largest, "squared": math.sqrt(largest), "manhattan": largest,
            "chebyshev": largest * math.sqrt(dims), "hybrid": (math.sqrt(1 + 4 * largest) - 1) / 2}[metric]


def manhattan_reach(metric: str, dims: int, largest: float) -> float:
    """The reach in the Manhattan metric."""
    if metric == "hybrid":
        return dims * (math.sqrt(1 + 4 * largest / dims) - 1) / 2
    if metric == "manhattan":
        return largest
    return euclidean_reach(metric, dims, largest) * math.sqrt(dims)


def metric_slope(metric: str, dims: int, largest: float) -> float:
    """How fast a distance changes, for the largest coordinate."""
    if metric == "hybrid":
        return dims + 2 * manhattan_reach(metric, dims, largest)
    if metric == "squared":
        return 2 * manhattan_reach(metric, dims, largest)
    return {"euclidean": math.sqrt(dims), "manhattan": float(dims), "chebyshev": 1.0}[metric]


BLOCK_REACH = {dims: math.sqrt(2.5**2 + (dims - 1) * 1.5**2) for dims in (2, 3)}  # to the farthest point of a block


# Magnitudes of fixed arithmetic. Words are below 2^32, so half of them is listed.

def largest_square(dims: int) -> float:
    """In cells, of an offset from a point of a block: of its farthest cell in the middle of a slab, or at a corner."""
    return 2.5**2 + (dims - 1) * 1.5**2 + 2.0**-10


def square_intermediates(largest: float) -> dict[str, float]:
    """The words of a square of so many cells, and of its rest after a root."""
    return {"half of a square": largest * 2**28 / 2, "rest of a square": 2 * math.sqrt(largest) * 2**18 + 2}


def largest_intermediates(dims: int) -> dict[str, float]:
    """The product of a direction and the jitter, and the square."""
    return {"offset of a point": 512 * LARGEST_COMPONENT[dims] * 2.0**20, **square_intermediates(largest_square(dims))}


def largest_direction_intermediates(dims: int) -> dict[str, float]:
    """A component that is divided, which is lengthened only if it is below 2^-3 cells."""
    longest = features.largest_distance(dims, 1) + 2.0**-10
    return {"half of a numerator": longest * 2**31 / 2, "half of a rest": math.sqrt(dims) * longest * 2**18 * 2**8 / 2}


def largest_smooth_intermediates(dims: int) -> dict[str, float]:
    weights = features.largest_weights(dims) + 2.0**-10
    return {"half of the sum of weights": weights * 2**30 / 2, "half of a root": math.sqrt(weights) * 2**30 / 2}


def largest_border_intermediates(dims: int) -> dict[str, float]:
    """A difference of squares over a root is below the sum of two distances, but for the errors of a small root."""
    sum_of_distances = BLOCK_REACH[dims] + features.largest_distance(dims, 1)
    return {"quotient": 1.02 * sum_of_distances * 2**15, "rest of a quotient": 4 * BLOCK_REACH[dims] * 2**17 + 2}
