"""Cellular noise on arrays of places, with random or adverse points: exactly in doubles, in the steps of the library's
floats with any rounding, and in fixed arithmetic. For bounds_cellular_test.py."""

import itertools

import numpy as np

from proof.bounds import exact_model as exact
from proof.bounds.distances import QUOTIENT_ULPS, ROOT_ULPS, UNIT
from proof.bounds.floats import TINY
from proof.bounds.rounded import MODES
from proof.bounds.sine import SINE_COEFFICIENTS, fixed_sine

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


def angles(phase):
    """In units of 2^-32 turns."""
    phase = np.asarray(phase, float)
    return exact.u32(np.trunc((phase - np.trunc(phase)) * 2**30).astype(np.int64) * 4)


def rows_of_turn(dims, cosine, sine, product):
    """The matrix that turns a place backwards."""
    if dims == 2:
        return [[cosine, sine], [-sine, cosine]]
    both = product(sine, cosine)
    return [[cosine, sine, 0 * sine], [-both, product(cosine, cosine), sine], [product(sine, sine), -both, cosine]]


class MovingExact(Exact):
    """Of points that go round."""

    def __init__(self, cells, words, f, jitter, phase):
        dims, a = len(f), 2 * np.pi * np.asarray(phase)
        u = directions(dims, words) / 512
        if dims == 3:
            u = np.array([u[0], u[1] * np.cos(a) - u[2] * np.sin(a), u[1] * np.sin(a) + u[2] * np.cos(a)])
        u = np.array([u[0] * np.cos(a) - u[1] * np.sin(a), u[0] * np.sin(a) + u[1] * np.cos(a), *u[2:]])
        self.offsets = f[:, None, :] - (np.array(cells).T[:, :, None] + 0.5 + MOST[dims] * jitter / 2 * u)

    def to_nearest(self):
        return -self.of_nearest()[0]


class Shader:
    """Evaluates in 32-bit floats, which are held in doubles, with a rounding mode ("random" chooses for each
    operation); may fuse a*b + c. (Elsewhere the text itself is evaluated so. But its points are hashes, which hardly ever
    are as adverse as these.)"""

    def __init__(self, mode, seed, fuse=0.0, lost_bits=0):
        self.mode, self.rng, self.fuse, self.lost_bits = mode, np.random.default_rng(seed), fuse, lost_bits

    def round(self, x):
        x = np.asarray(x, float)
        if self.lost_bits:
            mantissa, exponent = np.frexp(x)
            return np.ldexp(np.round(mantissa * 2 ** (24 - self.lost_bits)), exponent - 24 + self.lost_bits)
        nearest = x.astype(np.float32)
        if self.mode == "nearest":
            return nearest.astype(float)
        up = self.rng.random(x.shape) < 0.5 if self.mode == "random" else np.full(x.shape, self.mode == "up")
        other = np.nextafter(nearest, np.where(up, np.inf, -np.inf).astype(np.float32)).astype(float)
        nearest = nearest.astype(float)
        keep = (nearest == x) | ((nearest > x) == up) | (abs(x) < TINY)
        return np.where(keep, nearest, other)

    def mad(self, a, b, c):
        """a*b + c. The product of two floats is exact in a double."""
        product = np.asarray(a * b, float)
        fused = self.rng.random(product.shape) < self.fuse
        return self.round(np.where(fused, product, self.round(product)) + c)


def shaders(seed):
    return [Shader(mode, [seed, i], fuse) for i, mode in enumerate(MODES) for fuse in (0.0, 0.5)]


class Floats:
    """With a Shader, whose roots and quotients may be as far off as is assumed."""

    def __init__(self, shader, cells, words, f, jitter):
        self.s, self.dims = shader, len(f)
        d = shader.round(2 * f - 1)
        n = np.array(cells).T[:, :, None]
        d = shader.round(d[:, None] - 2 * n)
        self.parts = np.array(direction(self.dims, words)[:self.dims]) / (512 if self.dims == 2 else 256)
        if self.dims == 3:
            d = np.array([shader.round(d[0] + d[1]), shader.round(d[0] - d[1]), d[2]])
        self.offsets = shader.mad(-self.parts, np.broadcast_to(jitter, self.parts.shape), d)

    def root(self, q):
        return np.sqrt(q) * (1 + self.s.rng.choice((-1, 0, 1)) * ROOT_ULPS * UNIT)

    def quotient(self, a, b):
        return a / b * (1 + self.s.rng.choice((-1, 0, 1)) * QUOTIENT_ULPS * UNIT)

    def squared(self, v):
        s = self.s
        if self.dims == 2:
            return s.mad(v[0], v[0], s.round(v[1] * v[1]))
        return s.mad(v[2], v[2], s.mad(v[0], v[0], s.round(v[1] * v[1])) * 0.5)

    def rank(self, metric):
        s, v, size = self.s, self.offsets, abs(self.offsets)
        if metric in ("euclidean", "squared"):
            return self.squared(v)
        if metric == "chebyshev":
            return np.maximum(*size) if self.dims == 2 else np.maximum(s.round(size[0] + size[1]) / 2, size[2])
        total = s.round(size[0] + size[1]) if self.dims == 2 else s.round(np.maximum(size[0], size[1]) + size[2])
        return total if metric == "manhattan" else s.mad(self.squared(v), 0.5, total)

    def nearest(self, metric):
        rank = np.sort(self.rank(metric), axis=0)[:3]
        if metric == "euclidean":
            return self.root(rank) / 2
        return rank / (4 if metric == "squared" else 2)

    def smooth(self):
        s, total = self.s, 0.0
        for q in self.rank("euclidean"):
            t = np.maximum(s.round(1 - self.root(q) / 2), 0)
            t = s.round(t * t)
            total = s.round(total + s.round(t * t))
        return s.round(1 - self.root(self.root(s.round(total + 1 / 4096))))

    def of_nearest(self):
        first = self.rank("euclidean").argmin(axis=0)
        return np.take_along_axis(self.offsets, first[None, None], axis=1)[:, 0], first

    def unit(self):
        own, _ = self.of_nearest()
        if self.dims == 3:
            own = np.array([self.s.round(own[0] + own[1]) / 2, self.s.round(own[0] - own[1]) / 2, own[2]])
        q = 0.0
        for x in own:
            q = self.s.mad(x, x, q)
        return [self.quotient(x, self.root(np.maximum(q, 2.0**-96))) for x in own]

    def border(self):
        own, first = self.of_nearest()
        rank = self.rank("euclidean")
        gap = self.s.round(rank - np.take_along_axis(rank, first[None], axis=0))
        apart = self.squared(self.s.round(self.offsets - own[:, None]))
        apart[first, np.arange(len(first))] = 2.0**-200
        gap[first, np.arange(len(first))] = 1.0
        return self.root(self.quotient(self.s.round(gap * gap), apart)).min(axis=0) / 4


class MovingFloats(Floats):
    """Of points that go round, from phases in [-1, 1]."""

    def __init__(self, shader, cells, words, f, jitter, phase):
        self.s, self.dims = shader, len(f)
        s, n = shader, np.array(cells).T[:, :, None]
        self.turn = self.rows(phase)
        d = s.round(2 * f - 1)
        projected = [self.projected(d, row)[None] for row in self.turn]
        for axis in reversed(range(self.dims)):
            projected = [s.round(x - 2 * n[axis] * row[axis]) for x, row in zip(projected, self.turn)]
        self.parts = np.array(direction(self.dims, words)[:self.dims]) / (512 if self.dims == 2 else 256)
        if self.dims == 3:
            x, y, z = projected
            projected = [s.round(x + y), s.round(x - y), z]
        jitter = s.round(s.round(np.asarray(jitter) * (32 * MOST[self.dims]))) / 32
        self.offsets = s.mad(-self.parts, np.broadcast_to(jitter, self.parts.shape), np.array(projected))

    def sine(self, angle):
        """Of angles in units of 2^-32 turns, in the steps of sine.glsl."""
        half = angle & 0x7FFFFFFF
        x = (np.minimum(half, 2**31 - half) >> 6) / 2**24
        c1, c3, c5, c7 = SINE_COEFFICIENTS
        t = self.s.round(x * x)
        inner = self.s.mad(t, self.s.mad(t, self.s.mad(t, c7, c5), c3), c1)
        return np.where(angle >> 31 & 1, -1, 1) * self.s.round(x * inner)

    def rows(self, phase):
        angle = angles(phase)
        return rows_of_turn(self.dims, self.sine(exact.u32(angle + 2**30)), self.sine(angle),
                            lambda a, b: self.s.round(a * b))

    def projected(self, d, row):
        total = self.s.round(d[0] * row[0])
        for x, b in list(zip(d, row))[1:]:
            total = self.s.mad(x, b, total)
        return total

    def to_nearest(self):
        own, _ = self.of_nearest()
        if self.dims == 3:
            own = np.array([self.s.round(own[0] + own[1]) / 2, self.s.round(own[0] - own[1]) / 2, own[2]])
        return np.array([-self.projected(own, column) / 2 for column in zip(*self.turn)])


def fixed_root(q):
    """floor(sqrt(2^8 q)) of words."""
    n = q.astype(np.int64) << 8
    v = np.sqrt(n.astype(float)).astype(np.int64)
    v = np.where(v * v > n, v - 1, v)
    return np.where((v + 1) ** 2 <= n, v + 1, v)


class Fixed:
    def __init__(self, cells, words, f, jitter):
        place = (f * 2**20).astype(np.int64)
        cut = np.int64(np.trunc(np.asarray(jitter) * 2**20))
        points = np.array(cells).T[:, :, None] * 2**20 + 2**19 + (directions(len(f), words) * cut >> 10)
        self.offsets = place[:, None] - points

    @staticmethod
    def squared(v):
        return (v * v).sum(axis=0) >> 12

    def rank(self, metric):
        size = abs(self.offsets)
        return {"manhattan": lambda: size.sum(axis=0), "chebyshev": lambda: size.max(axis=0),
                "hybrid": lambda: size.sum(axis=0) + (self.squared(self.offsets) >> 8)}.get(
                    metric, lambda: self.squared(self.offsets))()

    def nearest(self, metric):
        rank = np.sort(self.rank(metric), axis=0)[:3]
        if metric == "euclidean":
            return fixed_root(rank) / 2**18
        return (rank >> 8 if metric == "squared" else rank) / 2**20

    def smooth(self):
        t = np.minimum(np.maximum(2**18 - fixed_root(self.rank("euclidean")), 0) >> 2, 65535)
        q = t * t >> 16
        return (2**19 - fixed_root(fixed_root((q * q >> 2).sum(axis=0) + 2**18) << 11)) / 2**19

    def of_nearest(self):
        first = self.rank("euclidean").argmin(axis=0)
        return np.take_along_axis(self.offsets, first[None, None], axis=1)[:, 0], first

    def unit(self):
        own, _ = self.of_nearest()
        m = abs(own).max(axis=0)
        a = np.where(m < 1024, 1024, 1)
        b = a * np.where(m * a < 32768, 32, 1)
        k = b * np.where(m * b < 131072, 4, 1)
        root = np.maximum(fixed_root(self.squared(k * own)), 1)
        return np.sign(own) * (abs(k * own) * 2**19 // root) / 2**21

    def border(self):
        own, first = self.of_nearest()
        rank = self.rank("euclidean")
        gap = rank - np.take_along_axis(rank, first[None], axis=0)
        root = fixed_root(self.squared((self.offsets - own[:, None]) >> 1))
        root[first, np.arange(len(first))] = 1
        gap[first, np.arange(len(first))] = 2**40
        return (16 * gap // root).min(axis=0) / 2**16


class MovingFixed(Fixed):
    """Of points that go round."""

    def __init__(self, cells, words, f, jitter, phase):
        dims, n = len(f), np.array(cells).T[:, :, None]
        place = (f * 2**20).astype(np.int64) - 2**19
        cut = (np.trunc(np.asarray(jitter) * 2**20).astype(np.int64) * int(32 * MOST[dims])) >> 5
        angle = angles(phase)
        self.rows = rows_of_turn(dims, self.sine(exact.u32(angle + 2**30)), self.sine(angle),
                                 lambda a, b: ((a >> 1) * b + 2**14) >> 15)
        points = directions(dims, words) * cut >> 10
        self.offsets = np.array([sum(self.turned(x, b)[None] - 16 * step * b for x, step, b in zip(place, n, row))
                                 for row in self.rows]) - points

    @staticmethod
    def sine(angle):
        half = angle & 0x7FFFFFFF
        g = fixed_sine(np.minimum((np.minimum(half, 2**31 - half) + 2**13) >> 14, 65535))
        return np.where(angle >> 31 & 1, -g, g)

    @staticmethod
    def turned(offset, b):
        return ((offset >> 8) * b >> 8) + ((offset & 255) * b >> 16)

    def to_nearest(self):
        own, _ = self.of_nearest()
        return -np.array([sum(map(self.turned, own, column)) for column in zip(*self.rows)]) / 2**20
