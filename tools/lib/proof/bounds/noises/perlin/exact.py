"""Proves how large hn_perlin and its derivatives can be and how fast they can change: as suprema.py of the folder
above, times the scale of docs/reference/contract.md, section 6.

RANGE. The scales of the octahedral gradient are multiples of 1/1024 below the inverse of the supremum before scaling.
It is 1/2 times 511/512 on the line, 1.03636 in space and 1.07346 in 4D. On the plane it is for gradients that
rotate with a phase, which have the same scale: 0.559017, in the middle of the cell, where gradients that do not rotate
reach 0.508437. In space gradients that rotate reach 1.16420 and have a scale of their own. The rest up to 1 is room for
the errors of the fixed arithmetic; in space the scale without a phase could be 3/1024 larger.

SINE GRADIENT. Its components are independent, |g_i| <= 1, and nothing is scaled. The range is exact: the supremum over
the gradients is the sum over the axes of

    (1 - u_i) f_i + u_i (1 - f_i) = 1/2 - (1 - 2 f_i) (1 - 2 u_i) / 2 <= 1/2

with u_i = s(f_i) (the weights of the other axes sum to 1, and u_i <= 1/2 just where f_i <= 1/2), so it is n/2, in the
middle of the cell.
"""

from proof.bounds import suprema
from proof.bounds.gradients import OCTAHEDRAL, ROTATED, SINE

SCALE = {OCTAHEDRAL: {1: 2.0, 2: 1831 / 1024, 3: 985 / 1024, 4: 953 / 1024},
         ROTATED: {2: 1831 / 1024, 3: 879 / 1024}, SINE: {2: 1.0, 3: 1.0}}


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


def slope_bound(dims, gradient=OCTAHEDRAL):
    """A proven upper bound of |derivative|."""
    return scaled(suprema.SLOPE, dims, gradient)


def slope_lipschitz_bound(dims, gradient=OCTAHEDRAL):
    return scaled(suprema.SLOPE_LIPSCHITZ, dims, gradient)
