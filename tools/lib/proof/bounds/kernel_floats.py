"""The error of a sum over lattice points (kernels.py) in float arithmetic, in the sense of floats.py.

    t = max(r - m q, 0); the point adds (ramp)*w, and to a derivative g*w - x*k, k = (ramp)*(fall), with the weight w
    and its fall as in weights.py, and the ramp as in floats.py

TRIANGLES. q = x*x + y*y. In hn_simplex the skewed x is rounded, and then x of the first corner. Both move the place,
the same for all points: by up to 2^-22 and 2^-24 steps. From there x of the others and y are rounded once.

CENTRED. By reflections the nearest corner is at 0, and offsets from it are exact. An offset from the corner behind an
axis rounds by 2^-24, one from the centre of the cell by 2^-25, and one from a centre behind an axis by both. Squares of
distances are sums: of the squares of the sizes s_i of the offsets from the nearest corner, and

    hn_simplex          1 - 2 s_i to the next corner, n/4 - sum s_i to the centre of the cell, and from there 2 s_i
    hn_simplex_smooth   from the nearest point of either kind min(1 - 2 s_i, 2 - 2 sum s + 2 s_i)

A point that rounding leaves out, or visits with the distance of another point, is as far away as the radius but
for some 2^-22, and so is its t. A weight of simplex noise is below 2^-58 there, and its fall below 2^-36. The weights
and falls of phasor noise, at most 16 t^3 and 192 t^2, are below 2^-55 and 2^-32. The `forgotten` part of a weight is
more than all of that.

The numbers of a point in a box of places are propagated as in floats.py. The points that are not near add zeros, so
sums round at most as many times as there are points to visit, less one.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator

import numpy as np

from proof.bounds import kernels
from proof.bounds.boxes import cell, of_ends, supremum
from proof.bounds.floats import TINY, Approx, largest_of, rounding
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.kernels import SMOOTH, Kernel, Quantity

Offsets = list[Approx]


# --- Distances --------------------------------------------------------------------------------------------------------

def offsets_of(kernel: Kernel, lo, hi, point) -> Offsets:
    if kernel.triangles:
        errors = [2.0**-24] * 2
    else:
        home = point[0] % 1
        errors = [2.0**-25 * (home > 0) + 2.0**-24 * (x != home) for x in point]
    return [Approx(a - x, b - x, err + TINY) for a, b, x, err in zip(lo, hi, point, errors)]


def total(numbers):
    return functools.reduce(Approx.sum, numbers)


def squared(offsets: Offsets) -> Approx:
    """The sum of squares, whose range is known."""
    exact = [(np.where((d.lo <= 0) & (d.hi >= 0), 0.0, np.minimum(d.lo**2, d.hi**2)), d.size() ** 2) for d in offsets]
    q = total([d.times(d).clipped(*ends) for d, ends in zip(offsets, exact)])
    return q.clipped(sum(low for low, _ in exact), sum(high for _, high in exact))


def to_neighbour(sizes: Offsets, axes: list[int], base: Approx, smooth: bool, is_centre: bool) -> Approx:
    """The square of the distance of a point behind those axes, from the nearest one's of its kind."""
    one, twice = Approx(1.0, 1.0), sizes[axes[0]].exactly(2.0)
    if not smooth:
        return base.sum(twice if is_centre else one.minus(twice))
    far = Approx(2.0, 2.0).minus(total(sizes).exactly(2.0)).sum(twice)
    near = one.minus(twice)
    return base.sum(Approx(np.minimum(near.lo, far.lo), near.hi, np.maximum(near.err, far.err)))


def distances(kernel: Kernel, lo, hi) -> Iterator[tuple[Offsets, Approx]]:
    """The offsets of each point, and the square of its distance."""
    smooth = kernel is SMOOTH.get(kernel.dims)
    for point in kernel.points:
        offsets = offsets_of(kernel, lo, hi, point)
        exact = squared(offsets)
        if kernel.triangles:
            yield offsets, exact
            continue
        home = point[0] % 1
        axes = [axis for axis, x in enumerate(point) if x != home]
        sizes = offsets_of(kernel, lo, hi, (0.0,) * kernel.dims)
        if smooth and home:
            inner = offsets_of(kernel, lo, hi, (home,) * kernel.dims)
            sizes = [d.exactly(-1.0) for d in inner]
        q = squared(sizes)
        if home and not smooth:
            q = q.sum(Approx(kernel.dims / 4, kernel.dims / 4).minus(total(sizes)))
        if axes:
            q = to_neighbour(sizes, axes, q, smooth, home > 0)
        yield offsets, Approx(exact.lo, exact.hi, q.err)


def nearness(kernel: Kernel, q: Approx) -> Approx:
    """t."""
    lo, hi = (np.maximum(kernel.radius - kernel.fall * x, 0.0) for x in (q.hi, q.lo))
    return Approx(lo, hi, kernel.fall * q.err).rounded()


# --- The sum ----------------------------------------------------------------------------------------------------------

def added(kernel: Kernel, terms: list[Approx]) -> Approx:
    size = sum(term.size() for term in terms)
    err = sum(term.err for term in terms)
    for _ in range(kernel.visited - 1):
        err = err + rounding(size + err)
    return Approx.within(size, err + kernel.weight.forgotten).scaled(kernel.scale / 1024)


def weighted(kernel: Kernel, t: Approx) -> Approx:
    return kernel.weight.floats(t).clipped(*kernel.weight.ends(0, t.lo, t.hi))


def fall(kernel: Kernel, t: Approx) -> Approx:
    ends = [2 * kernel.fall * end for end in kernel.weight.ends(1, t.lo, t.hi)]
    return kernel.weight.float_fall(t, kernel.fall).clipped(*ends)


def value_error(kernel: Kernel, lo, hi):
    """The largest error in each box of places, given by its ends along each axis."""
    terms = [kernel.float_ramp(own).times(weighted(kernel, nearness(kernel, q)))
             for own, q in distances(kernel, lo, hi)]
    return added(kernel, terms).err


def slope_error(kernel: Kernel, lo, hi):
    """The error of the derivatives, per step."""
    component = OCTAHEDRAL.component(kernel.dims)
    along, g = [[] for _ in range(kernel.dims)], Approx.within(component)
    for own, q in distances(kernel, lo, hi):
        t = nearness(kernel, q)
        k = kernel.float_ramp(own).times(fall(kernel, t))
        upright = g.times(weighted(kernel, t))
        for terms, d in zip(along, own):
            terms.append(upright.minus(k.times(d)))
    return largest_of(added(kernel, terms).err for terms in along)


# --- Bounds -----------------------------------------------------------------------------------------------------------

LEVELS, TOLERANCE = {2: 10, 3: 7, 4: 6}, 0.003
SKEWED = 2.0**-22 + 2.0**-24  # in steps: how far the place moves on the plane


def error_supremum(error, kernel: Kernel) -> float:
    """The supremum of an error that boxes give by their ends."""
    return supremum(of_ends(error), cell(kernel.dims, half=True), LEVELS[kernel.dims], TOLERANCE,
                    None if kernel.triangles else 0, most=100_000)


def moved(kernel: Kernel, along_x: Callable[[], float]) -> float:
    """The effect of the move of the place on a quantity with that derivative."""
    if not kernel.triangles:
        return 0.0
    return SKEWED * kernel.scale / 1024 * along_x()


@functools.cache
def error_bound(kernel: Kernel) -> float:
    """A proven upper bound of the error from (cell, fraction)."""
    return error_supremum(functools.partial(value_error, kernel), kernel) + moved(kernel, kernel.along_x)


@functools.cache
def slope_error_bound(kernel: Kernel) -> float:
    """The bound of the error of the derivatives, per cell."""
    of_move = moved(kernel, lambda: max(kernels.largest(kernel, Quantity((axis, (1.0, 0.0))), OCTAHEDRAL)
                                        for axis in kernels.axes(kernel)))
    return kernel.steps * (error_supremum(functools.partial(slope_error, kernel), kernel) + of_move)
