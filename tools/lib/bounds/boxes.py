"""What is proven for a cell, box by box: the interpolation of a lattice noise, and suprema by branch and bound.

Nothing is sampled: a supremum is bounded by branch and bound over boxes of fractions. Bounds are computed in doubles;
SAFE inflates each result by far more than their own rounding errors.
"""

import heapq
import itertools
import math

SAFE = 1 + 1e-9  # a few hundred double operations err by less than 1e-13 relative
# The largest |s'|, |s''| (at t = (1 - 1/sqrt(3)) / 2) and |s'''| on [0, 1].
FADE_1, FADE_2, FADE_3 = 15 / 8, 10 / math.sqrt(3), 60.0


def fade(t):
    return t * t * t * (t * (t * 6 - 15) + 10)


def fade_slope(t):
    return 30 * t * t * (1 - t) * (1 - t)


def corners(dims):
    return itertools.product((0, 1), repeat=dims)


def corner_weight(point, corner):
    return math.prod(fade(f) if o else 1 - fade(f) for f, o in zip(point, corner))


def weights_and_slopes(point):
    """The weight of each corner, and how fast it grows along (1, .., 1)."""
    factors = [((1 - fade(f), -fade_slope(f)), (fade(f), fade_slope(f))) for f in point]
    for corner in corners(len(point)):
        weight, slope = 1.0, 0.0
        for factor, factor_slope in (factors[i][o] for i, o in enumerate(corner)):
            weight, slope = weight * factor, slope * factor + weight * factor_slope
        yield corner, weight, slope


def halves(box):
    """The box cut in two across its widest axis."""
    axis = max(range(len(box)), key=lambda i: box[i][1] - box[i][0])
    lo, hi = box[axis]
    middle = (lo + hi) / 2
    return [box[:axis] + (part,) + box[axis + 1:] for part in ((lo, middle), (middle, hi))]


def supremum(bound, box, splits):
    """An upper bound over the box, given one for any sub-box: `splits` times halve the sub-box with the largest."""
    queue = [(-bound(box), box)]
    for _ in range(splits):
        _, worst = heapq.heappop(queue)
        for part in halves(worst):
            heapq.heappush(queue, (-bound(part), part))
    return -queue[0][0]


def smooth_bound(value, curvature, box):
    """Bounds `value` over the box, where value is a maximum of functions with |second derivative along an axis| at most
    `curvature`: multilinear interpolation between the vertices errs by at most curvature h^2 / 8 for each axis."""
    return max(map(value, itertools.product(*box))) + curvature / 8 * sum((hi - lo) ** 2 for lo, hi in box)


def slope_supremum(slope, curvature, dims):
    """The largest `slope` in a cell, given as for smooth_bound, which permuting the axes must not change."""
    def bound(box):
        if any(left[1] < right[0] for left, right in itertools.pairwise(box)):
            return 0.0  # no point with f_1 >= f_2 >= ..: another box stands for this one
        return smooth_bound(slope, curvature, box)
    return supremum(bound, ((0.0, 1.0),) * dims, 6000) * SAFE
