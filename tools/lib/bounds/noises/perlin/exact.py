"""How large hn_perlin can be and how fast it can change, proven.

Everything is derived from docs/contract.md. "Attained" values are evaluated at a named point. A corner o of the cell has
the weight w and the gradient g_o; u_i is s(f_i). The octahedral gradient has |g_o|_1 = 1. The other is treated under
SINE GRADIENT.

RANGE. For a fixed f the value is scale * sum_o w g_o.(f - o), linear in each gradient, and the largest |g.d| is
max_i |d_i| (the support function of the octahedron): the supremum is scale * sup_f sum_o w max_i |f_i - o_i|. That sum
is unchanged by f_i -> 1 - f_i and by permuting axes, so let f_1 <= ... <= f_n <= 1/2. Then the max is 1 - f_k for the
first axis k with o_k = 1 (any other candidate is 1 - f_j with f_j >= f_k, or f_j <= 1/2), and f_n at o = 0. It nests:

    S(f_1, .., f_n) = u_1 (1 - f_1) + (1 - u_1) S(f_2, .., f_n),    S(f_n) = u_n (1 - f_n) + (1 - u_n) f_n <= 1/2

(the last increases on [0, 1/2]). As 1 - u >= 0, the supremum is M_n, where M_1 = 1/2 and M_k is, with M = M_(k-1), the
largest M + s(t) (1 - t - M): maxima in one variable. The maximizers come out sorted, so M_n is attained over all
|g|_1 = 1.

RANGE OF THE LIBRARY. Its gradients are not all |g|_1 = 1: they keep away from the vertices. In 2D g is (a, +-m) with a
an odd multiple of 1/N, N = 512, and |a| + m = 1; as |a| d_1 + m d_2 is linear in |a|, the largest is at an end of |a|,
1/N or 1 - 1/N:

    h(d) = (1 - 1/N) max(|d_1|, |d_2|) + 1/N min(|d_1|, |d_2|).

In 3D g.d is p (d_1 + d_2) / 2 + q (d_1 - d_2) / 2 +- m d_3 with p and q odd multiples of 1/N, N = 256. Given
P = max(|p|, |q|), the best is |p| = |q| = P, which makes P max(|d_1|, |d_2|) + (1 - P) |d_3|: the same h, of
max(|d_1|, |d_2|) and |d_3|. The supremum of scale * sum_o w h(f - o) is found by branch and bound. It is smaller than
that over all |g|_1 = 1, which leaves the room that the errors of the fixed arithmetic need. The tool shows a value that
the library reaches where a cell has the gradients for it, in rational arithmetic.

LIPSCHITZ. The noise is continuously differentiable, so |noise(p) - noise(q)| <= L max_i |p_i - q_i|, where L is the
largest L1 norm of its gradient: of sum_j sigma_j d/df_j, over the signs sigma. Reflecting axes makes all signs +1. With
D = sum_j d/df_j and the support function again,

    L = scale * sup_f sum_o max_i |w + (D w) (f_i - o_i)|.

For any one choice of the gradients that sum is smooth, its second derivative along an axis at most K (slope_curvature),
so within a box it exceeds its values at the box's vertices by at most K/8 sum_j h_j^2, h the sides. The bound is
proven, and tight to about 1e-5 over all |g|_1 = 1.

SINE GRADIENT. Its components are independent, |g_i| <= 1, and nothing is scaled. The support function of the cube is
sum_i |d_i|, which takes the place of the maximum in the Lipschitz constant. The range is exact: the supremum over the
gradients is the sum over the axes of

    (1 - u_i) f_i + u_i (1 - f_i) = 1/2 - (1 - 2 f_i) (1 - 2 u_i) / 2 <= 1/2

(the weights of the other axes sum to 1, and u_i <= 1/2 just where f_i <= 1/2), so it is n/2, in the middle of the cell.
"""

import functools
import itertools
from fractions import Fraction

from bounds.boxes import (FADE_1, FADE_2, FADE_3, SAFE, corner_weight, corners, fade, slope_supremum, smooth_bound,
                          supremum, weights_and_slopes)
from bounds.gradients import OCTAHEDRAL, SINE

SCALE = {OCTAHEDRAL: {2: 1913 / 1024, 3: 1819 / 1024}, SINE: {2: 1.0, 3: 1.0}}
STEPS = {2: 512, 3: 256}  # gradients are made of odd multiples of 1 / STEPS
# Where the values called attained are evaluated: near the maximizers. RANGE_WITNESS is exact in 32-bit floats.
RANGE_WITNESS = {2: (11713438 / 2**25, 0.5), 3: (10965218 / 2**25, 11713438 / 2**25, 0.5)}
SLOPE_WITNESS = {OCTAHEDRAL: {2: (0.6144139, 0.2900403), 3: (0.5, 0.3973426, 0.6026574)},
                 SINE: {2: (0.5, 0.5), 3: (0.5, 0.5, 0.5)}}


# --- Range ------------------------------------------------------------------------------------------------------------

def range_bound(dims, scale):
    """A proven upper bound of |value|: M_1 = 1/2, M_k = max_t M + s(t) (1 - t - M), times the scale."""
    curvature = FADE_2 + 2 * FADE_1  # of s(t) (1 - t - M), as |1 - t - M| <= 1
    top = 0.5
    for _ in range(dims - 1):
        def gain(point, top=top):
            return fade(point[0]) * (1 - point[0] - top)
        top += supremum(functools.partial(smooth_bound, gain, curvature), ((0.0, 0.5),), 400)
    return scale * top * SAFE


def library_support(offset):
    """h of RANGE OF THE LIBRARY: the largest g.d over its gradients."""
    *flat, last = map(abs, offset)
    ends = (max(flat), last)
    return max(ends) - (max(ends) - min(ends)) / STEPS[len(offset)]


@functools.cache
def library_range(dims):
    """A proven upper bound of |value| over the library's gradients. For any choice of them the sum's second derivative
    along an axis is at most the sum of |d_jj w| + 2 |d_j w|, that is 2 FADE_2 + 2 * 2 FADE_1."""
    @functools.cache
    def value(point):
        return sum(corner_weight(point, corner) * library_support([f - o for f, o in zip(point, corner)])
                   for corner in corners(dims))
    bound = functools.partial(smooth_bound, value, 2 * FADE_2 + 4 * FADE_1)
    return SCALE[OCTAHEDRAL][dims] * supremum(bound, ((0.0, 0.5),) * dims, 10000) * SAFE  # symmetric in f_i -> 1 - f_i


def steepest_gradients(dims):
    """The library's gradients nearest to the vertices of the octahedron."""
    step = Fraction(1, STEPS[dims])
    if dims == 2:
        positive = [(1 - step, step), (step, 1 - step)]
    else:  # |p| = |q|, both at their largest, or both at their smallest
        positive = [(1 - step, 0 * step, step), (0 * step, 1 - step, step),
                    (step, 0 * step, 1 - step), (0 * step, step, 1 - step)]
    signs = list(itertools.product((1, -1), repeat=dims))
    return [tuple(s * g for s, g in zip(sign, gradient)) for gradient in positive for sign in signs]


def range_witness(dims):
    """A value that hn_perlin attains, exactly: (value, point, gradient at each corner)."""
    point = RANGE_WITNESS[dims]
    exact = [Fraction(f) for f in point]
    value, chosen = Fraction(0), {}
    for corner in corners(dims):
        offset = [f - o for f, o in zip(exact, corner)]
        ramp, gradient = max((sum(g * d for g, d in zip(g, offset)), g) for g in steepest_gradients(dims))
        value += corner_weight(exact, corner) * ramp
        chosen[corner] = gradient
    return Fraction(SCALE[OCTAHEDRAL][dims]) * value, point, chosen


def sine_range(dims):
    """The supremum of |value| over all gradients of the cube, attained in the middle of the cell."""
    return dims / 2


# --- Lipschitz constant -----------------------------------------------------------------------------------------------

@functools.cache
def steepest_slope(point, support):
    """sum_o support |w + (D w) (f_i - o_i)|: the largest slope along (1, .., 1) that gradients give here, unscaled."""
    return sum(support(abs(weight + slope * (f - o)) for f, o in zip(point, corner))
               for corner, weight, slope in weights_and_slopes(point))


def slope_curvature(dims, support):
    """A bound of the second derivative of sum_o (+-) (w + (D w) (f_i - o_i)), any signs and any i at each corner, along
    an axis j: sum_o |d_jj w| + |d_jj D w| + 2 |d_j D w|. In such a sum an axis along which w is not differentiated
    gives the factor 1 (its two weights), another gives twice the largest derivative of s. Where a gradient's support is
    the sum, there is one such term for each i."""
    along = 2 * FADE_2 + 2 * FADE_3 + 2 * 2 * FADE_2
    across = 2 * FADE_2 * 2 * FADE_1 + 2 * (2 * FADE_1) ** 2
    return support((1,) * dims) * (along + (dims - 1) * across)


@functools.cache
def lipschitz_bound(dims, gradient):
    """A proven upper bound of the L1 norm of the noise's gradient."""
    curvature = slope_curvature(dims, gradient.support)
    slope = functools.partial(steepest_slope, support=gradient.support)
    return SCALE[gradient][dims] * slope_supremum(slope, curvature, dims)


def lipschitz_witness(dims, gradient):
    """A slope that is attained, at SLOPE_WITNESS, with gradients at vertices of the octahedron or cube."""
    return SCALE[gradient][dims] * steepest_slope(SLOPE_WITNESS[gradient][dims], gradient.support)
