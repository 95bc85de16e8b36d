"""Proves how large hn_perlin and its derivatives can be and how fast they can change: as suprema.py of the folder
above, times the scale of docs/contract.md, section 6.

RANGE. With the octahedral gradient the supremum before scaling is 1/2 times 511/512 in 1D. It is in the middle of the
cell in the other dimensions, too: 3/4 in 2D, 5/6 in 3D; in 4D it is 1.07346, elsewhere. The scales are multiples of
1/1024 below its inverse, which leaves the room up to 1 that the errors of the fixed arithmetic need.

SINE GRADIENT. Its components are independent, |g_i| <= 1, and nothing is scaled. The range is exact: the supremum over
the gradients is the sum over the axes of

    (1 - u_i) f_i + u_i (1 - f_i) = 1/2 - (1 - 2 f_i) (1 - 2 u_i) / 2 <= 1/2

with u_i = s(f_i) (the weights of the other axes sum to 1, and u_i <= 1/2 just where f_i <= 1/2), so it is n/2, in the
middle of the cell.
"""

from bounds import suprema
from bounds.gradients import OCTAHEDRAL, SINE

SCALE = {OCTAHEDRAL: {1: 2.0, 2: 1365 / 1024, 3: 1228 / 1024, 4: 953 / 1024}, SINE: {2: 1.0, 3: 1.0}}


def range_bound(dims, gradient):
    """A proven upper bound of |value|."""
    if gradient is SINE:
        return dims / 2
    return scaled(suprema.VALUE, dims, gradient)


def scaled(quantity, dims, gradient):
    return SCALE[gradient][dims] * suprema.largest(quantity, dims, gradient)


def lipschitz_bound(dims, gradient):
    """A proven upper bound of the L1 norm of the noise's gradient."""
    return scaled(suprema.LIPSCHITZ, dims, gradient)


def slope_bound(dims):
    """A proven upper bound of |derivative|."""
    return scaled(suprema.SLOPE, dims, OCTAHEDRAL)


def slope_lipschitz_bound(dims):
    return scaled(suprema.SLOPE_LIPSCHITZ, dims, OCTAHEDRAL)


def attained_in_the_middle(dims):
    """What |value| is in the middle of a cell, in 2D or 3D, if its corners have the best of the library's gradients
    there: the length |x| + |y| (+ |z|) of a gradient, which is 2 - L, times 1/2. The least L is that of the direction
    whose components are nearest to each other."""
    if dims == 2:  # (a, m): an odd multiple of 1/512, and the rest
        least = 257 / 512
    else:  # ((p + q) / 2, (p - q) / 2, m), with odd multiples of 1/256: q = 1/256, and p near 2/3
        least = min(max((p + 1) / 512, (256 - p) / 256) for p in range(1, 256, 2))
    return SCALE[OCTAHEDRAL][dims] * (2 - least) / 2
