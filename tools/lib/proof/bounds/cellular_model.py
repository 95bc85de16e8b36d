"""Cellular noise on arrays of places, exactly, in doubles, for bounds_cellular_test.py: with any words."""

import itertools

import numpy as np

from proof.bounds import exact_model as exact

METRICS = ("euclidean", "squared", "manhattan", "chebyshev", "hybrid")


def words_of_cells(rng, dims, count, reach=2):
    """A word for each cell around each place. Some are of points near the corners of their octahedra."""
    cells = list(itertools.product(range(-reach, reach + 1), repeat=dims))
    words = rng.integers(0, 2**32, (len(cells), count))
    extreme = np.array([0, 0x007FC000, 0x80000000, 0x807FC000] if dims == 2 else
                       [0, 0x7FFFFFFF, 0x007F8000, 0x7F800000, 0x40000000, 0xC0000000], np.int64)
    return cells, np.where(rng.random(words.shape) < 0.2, rng.choice(extreme, words.shape), words)


def fractions(rng, dims, count):
    """Floats in [0, 1], many of them at walls, in the middle, or near."""
    f = rng.random((dims, count))
    near = rng.choice((0.0, 0.5, 1.0), f.shape) + rng.uniform(-1, 1, f.shape) * 2.0 ** -rng.integers(2, 26, f.shape)
    f = np.where(rng.random(f.shape) < 0.5, near, f)
    return np.clip(f, 0, 1).astype(np.float32).astype(float)


def direction(dims, h):
    """(a, m) in units of 2^-9, (p, q, m) in units of 2^-8."""
    parts, one = ([exact.field(h, 14, 9)], 512) if dims == 2 else ([exact.field(h, 23, 8), exact.field(h, 15, 8)], 256)
    m = one - np.maximum.reduce([abs(part) for part in parts])
    return [*parts, np.where(h >> 31, -m, m)]


def directions(dims, words):
    """The direction in multiples of 1/512, along each axis."""
    parts = direction(dims, words)
    return np.array(parts) if dims == 2 else np.array([parts[0] + parts[1], parts[0] - parts[1], 2 * parts[2]])


def distance(metric, v):
    size = abs(v)
    return {"euclidean": lambda: np.sqrt((v * v).sum(axis=0)), "squared": lambda: (v * v).sum(axis=0),
            "manhattan": lambda: size.sum(axis=0), "chebyshev": lambda: size.max(axis=0),
            "hybrid": lambda: size.sum(axis=0) + (v * v).sum(axis=0)}[metric]()


class Exact:
    """Offsets from points: axes by cells by places."""

    def __init__(self, cells, words, f, jitter):
        dims = len(f)
        points = np.array(cells).T[:, :, None] + 0.5 + jitter / 2 * directions(dims, words) / 512
        self.offsets = f[:, None, :] - points

    def nearest(self, metric):
        return np.sort(distance(metric, self.offsets), axis=0)[:3]

    def smooth(self):
        weights = np.maximum(1 - distance("euclidean", self.offsets), 0) ** 4
        return 1 - (weights.sum(axis=0) + 1 / 4096) ** 0.25

    def of_nearest(self):
        first = distance("euclidean", self.offsets).argmin(axis=0)
        return np.take_along_axis(self.offsets, first[None, None], axis=1)[:, 0], first

    def border(self):
        """The distance to the border, and how far the two points are apart."""
        own, first = self.of_nearest()
        square = (self.offsets**2).sum(axis=0)
        apart = np.sqrt(((self.offsets - own[:, None]) ** 2).sum(axis=0))
        apart[first, np.arange(len(first))] = np.inf
        rank = np.where(np.isinf(apart), np.inf, (square - (own**2).sum(axis=0)) / (2 * np.where(np.isinf(apart), 1,
                                                                                                   apart)))
        return rank.min(axis=0), np.take_along_axis(apart, rank.argmin(axis=0)[None], axis=0)[0]


MOST = {2: 28 / 32, 3: 25 / 32}  # of the jitter, of points that move


class MovingExact(Exact):
    """Points go round."""

    def __init__(self, cells, words, f, jitter, phase):
        dims, a = len(f), 2 * np.pi * np.asarray(phase)
        u = directions(dims, words) / 512
        if dims == 3:
            u = np.array([u[0], u[1] * np.cos(a) - u[2] * np.sin(a), u[1] * np.sin(a) + u[2] * np.cos(a)])
        u = np.array([u[0] * np.cos(a) - u[1] * np.sin(a), u[0] * np.sin(a) + u[1] * np.cos(a), *u[2:]])
        self.offsets = f[:, None, :] - (np.array(cells).T[:, :, None] + 0.5 + MOST[dims] * jitter / 2 * u)

    def to_nearest(self):
        return -self.of_nearest()[0]
