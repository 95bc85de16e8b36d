"""Points and words for the tests of the bounds, random ones and adverse ones: those that make errors as large as they
can be."""

import math

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds import fixed_model as fixed
from proof.bounds.boxes import corners
from proof.bounds.fixed_model import ONE
from proof.bounds.gradients import SINE


def random_positions(rng, dims, count, reach=64.0):
    """Floats, many of them near lattice lines and on both sides of 0."""
    p = rng.uniform(-reach, reach, (dims, count))
    near = rng.random((dims, count)) < 0.3
    p = np.where(near, np.round(p) + rng.uniform(-0.06, 0.06, (dims, count)), p)
    return list(p.astype(np.float32).astype(float))


def random_fractions(rng, dims, count):
    """Of which some are near a corner of the cell, some in its middle."""
    f = rng.integers(0, ONE + 1, (dims, count))
    near = rng.integers(0, 2**14, (dims, count))
    f = np.where(rng.random((dims, count)) < 0.2, np.where(rng.random((dims, count)) < 0.5, near, ONE - near), f)
    middle = np.clip(ONE // 2 + rng.integers(-2**14, 2**14, (dims, count)), 0, ONE)
    return list(np.where(rng.random(count) < 0.5, middle, f))


def random_words(rng, kind, dims, count):
    return rng.integers(0, 2**32, (dims, count) if kind is SINE else count)


def best_words(rng, kind, dims, target, tries=40):
    """Words of gradients g with nearly the largest g.target of those that are tried, for many targets."""
    best = random_words(rng, kind, dims, len(target[0]))
    most = sum(g * t for g, t in zip(exact.gradient(kind, dims, best), target))
    for _ in range(tries - 1):
        words = random_words(rng, kind, dims, len(target[0]))
        reached = sum(g * t for g, t in zip(exact.gradient(kind, dims, words), target))
        best, most = np.where(reached > most, words, best), np.maximum(reached, most)
    return best


def adverse_words(rng, kind, fractions, wanted):
    """Those that make each corner's gradient times what `wanted` maps the corner and its offsets to as large as it is
    with a few tries."""
    dims, f = len(fractions), [x / ONE for x in fractions]
    words = {corner: best_words(rng, kind, dims, wanted(corner, [x - o for x, o in zip(f, corner)]))
             for corner in corners(dims)}
    return words.__getitem__


def changes(fractions):
    """From a corner to what the errors of the fades and of the first slope change its weight by, and the derivative of
    its weight along the first axis."""
    f = [x / ONE for x in fractions]
    t, slope = [fixed.fade(x) / 2**18 for x in fractions], fixed.slope(fractions[0]) / 2**18

    def of_corner(corner):
        def weight(fades):
            return [x if o else 1 - x for x, o in zip(fades, corner)]
        off, exactly = weight(t), weight([exact.fade(x) for x in f])
        sign = 2 * corner[0] - 1
        return (math.prod(off) - math.prod(exactly),
                sign * (slope * math.prod(off[1:]) - exact.slope(f[0]) * math.prod(exactly[1:])))
    return of_corner
