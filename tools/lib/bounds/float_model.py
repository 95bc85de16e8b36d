"""The noises in 32-bit floats on arrays, in the steps of the library's text, with any rounding: for
bounds_float_test.py. A noise takes what those of exact_model.py take."""

import itertools
import math

import numpy as np

from bounds import exact_model as exact
from bounds import sine
from bounds.exact_model import SCALE, SHIFT, TURNS
from bounds.fixed_model import x_first
from bounds.floats import TINY, pairs
from bounds.gradients import SINE
from bounds.sums import step_of

MODES = ("nearest", "down", "up", "random")


class Shader:
    """Evaluates in 32-bit floats, which are held in doubles, with a rounding mode ("random" chooses for each
    operation); may fuse a*b + c."""

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

    def fade(self, t):
        cube = self.round(self.round(t * t) * t)
        return self.round(cube * self.mad(self.round(t - 1), self.mad(t, 6.0, -9.0), 1.0))

    def slope(self, t):
        q = self.mad(-t, t, t)
        return self.round(self.round(q * q) * 30)

    def lerp(self, a, b, t):
        return self.mad(t, self.round(b - a), a)

    def dot(self, g, d):
        value = self.round(g[0] * d[0])
        for g_i, d_i in zip(g[1:], d[1:]):
            value = self.mad(g_i, d_i, value)
        return value

    # --- Perlin noise ---

    def plane_and_space_ramp(self, words, f, corner):
        """The direction's ramp, lengthened by 1 - L."""
        dims = len(f)
        parts = [x / (512 if dims == 2 else 256) for x in exact.direction(dims, words)]
        if dims == 2:
            more = np.minimum(abs(parts[0]), abs(parts[1]))
            along = [self.round(x - o) for x, o in zip(f, corner)]
        else:
            p, q, m = map(abs, parts)
            more = np.minimum(1 - (p + q) / 2, 1 - m)
            u, v = self.round(f[0] / 2 + f[1] / 2), self.round(f[0] / 2 - f[1] / 2)
            for _ in range(corner[0] + corner[1]):
                u = self.round(u - 0.5)
            along = [u, self.round(v + 0.5 * (corner[1] - corner[0])), self.round(f[2] - corner[2])]
        n = self.dot(parts, along)
        return self.mad(n, more, n)

    def ramp(self, kind, words, f, corner):
        offsets = [self.round(x - o) for x, o in zip(f, corner)]
        if kind is SINE:
            return self.dot(self.inexact(exact.gradient(SINE, len(f), words), corner), offsets)
        if len(f) in (2, 3):
            return self.plane_and_space_ramp(words, f, corner)
        g = exact.gradient(kind, len(f), words)
        return self.round(sum(a * d for a, d in zip(g, offsets)))  # in 4D two are 0

    def components(self, kind, words, dims):
        """Of a gradient, for the derivatives."""
        return exact.gradient(kind, dims, words)

    def inexact(self, g, corner):
        """Floats within the error of the sine gradient, often at its ends, so that the errors of all ramps add."""
        error, aligned = SINE.component_error, self.rng.choice((-1, 1, 0))

        def component(x, o):
            sign = aligned * (1 - 2 * o) or self.rng.uniform(-1, 1, x.shape)  # an offset is negative where o is 1
            moved = np.clip(x + sign * error, -1.0, 1.0).astype(np.float32).astype(float)
            return np.where(abs(moved - x) <= error, moved, x.astype(np.float32).astype(float))
        return [component(x, o) for x, o in zip(g, corner)]

    def perlin(self, kind, words_of, fractions, derivatives=False):
        """The value; with the derivatives, if they are wanted."""
        dims, scale = len(fractions), SCALE[kind][len(fractions)]
        nodes = [(self.ramp(kind, words_of(corner), fractions, corner), [],
                  self.components(kind, words_of(corner), dims) if derivatives else []) for corner in x_first(dims)]
        for f in fractions:
            t, slope = self.fade(f), self.slope(f)
            joined = []
            for (a, made, g), (b, others, h) in pairs(nodes):
                rest = [self.lerp(x, y, t) for x, y in zip(g, h)]
                more = [self.lerp(x, y, t) for x, y in zip(made, others)]
                if derivatives:
                    more.append(self.mad(self.round(b - a), slope, rest.pop(0)))
                joined.append((self.lerp(a, b, t), more, rest))
            nodes = joined
        (n, made, _), = nodes
        value = self.round(scale * n)
        return (value, [self.round(scale * d) for d in made]) if derivatives else value

    def perlin_at(self, kind, p, seed=np.int64(0)):
        cells = [np.floor(x) for x in p]
        words_of = exact.words_at(kind, [c.astype(np.int64) for c in cells], seed)
        return self.perlin(kind, words_of, [self.round(x - c) for x, c in zip(p, cells)])

    def perlin_in(self, kind, cells, fractions, seed):
        return self.perlin(kind, exact.words_at(kind, cells, seed), fractions)

    # --- Value noise ---

    def value(self, words_of, fractions):
        """The value, and the derivatives. Numbers have 3 added."""
        t, slopes = [self.fade(f) for f in fractions], [self.slope(f) for f in fractions]
        nodes = [exact.number(words_of(corner)) + 3 for corner in x_first(len(fractions))]
        rises = [self.round(b - a) for a, b in pairs(nodes)]
        nodes = [(self.lerp(a, b, t[0]), []) for a, b in pairs(nodes)]
        if len(fractions) == 1:
            nodes = [(nodes[0][0], [self.round(rises[0] * slopes[0])])]
        for axis in range(1, len(fractions)):
            joined = []
            for (a, made), (b, others) in pairs(nodes):
                more = [self.lerp(x, y, t[axis]) for x, y in zip(made, others)]
                joined.append((self.lerp(a, b, t[axis]), [*more, self.round(self.round(b - a) * slopes[axis])]))
            if axis == 1:
                along_x = [self.round(self.lerp(x, y, t[1]) * slopes[0]) for x, y in pairs(rises)]
                joined = [(n, [d, *made]) for d, (n, made) in zip(along_x, joined)]
            nodes = joined
        (n, made), = nodes
        return self.round(n - 3), made

    def spline(self, f):
        g = self.round(1 - f)
        sixth, two_thirds = self.round(1 / 6), self.round(2 / 3)
        first = self.round(self.round(self.round(g * g) * g) * sixth)
        last = self.round(self.round(self.round(f * f) * f) * sixth)
        second = self.mad(last, 3.0, self.mad(-f, f, two_thirds))
        return first, second, self.mad(first, 3.0, self.mad(-g, g, two_thirds)), last

    def value_cubic(self, words_of, fractions):
        points = itertools.product((-1, 0, 1, 2), repeat=len(fractions))
        values = [exact.number(words_of(point[::-1])) + 3 for point in points]
        for f in fractions:
            b = self.spline(f)
            values = [self.dot(four, b) for four in zip(*(values[i::4] for i in range(4)))]
        return self.round(values[0] - 3)

    # --- The sine, and octave sums ---

    def sine(self, q):
        """The sine of q / 2^32 turns, at most a quarter."""
        x = (q >> 6) / 2**24
        t = self.round(x * x)
        c1, c3, c5, c7 = sine.SINE_COEFFICIENTS
        return self.round(x * self.mad(t, self.mad(t, self.mad(t, c7, c5), c3), c1))

    def positions(self, s, p):
        """Of each octave, computed from the one before."""
        turns = [(c, t, *(self.round(s.lacunarity * (part / 32)) for part in (c, t))) for c, t in TURNS[:len(p) - 1]]
        q = list(p)
        while True:
            yield q
            if not s.turns or not turns:
                q = [self.mad(x, s.lacunarity, shift) for x, shift in zip(q, SHIFT)]
                continue
            turned = [q[0]]
            for axis, (c, t, scaled_c, scaled_t) in enumerate(turns):
                a, b = (scaled_c, scaled_t) if axis == 0 else (c / 32, t / 32)
                turned[axis:] = (self.mad(a, turned[axis], -self.round(scaled_t * q[axis + 1])),
                                 self.mad(b, turned[axis], self.round(scaled_c * q[axis + 1])))
            q = [self.round(x + shift) for x, shift in zip(turned, SHIFT)]

    def fades(self, s):
        """What a footprint leaves of each octave."""
        e = s.footprint
        while True:
            yield np.clip(self.round(1.5 - e), 0.0, 1.0)
            e = self.round(e * max(s.lacunarity, 1.0))

    def octaves(self, kind, s, p, places=None):
        """An octave sum (bounds.sums.Sum); `places` are the cells and fractions of its octaves, if it has whole
        positions."""
        count, seed, amp, before, step = max(math.ceil(s.octaves), 0), 0, 1.0, 0.5, step_of(s.kind)
        value = np.zeros(np.shape(p[0]))
        part = total = s.octaves - (count - 1) if count > 1 else 1.0
        for _ in range(count - 1):
            total = self.mad(s.gain, total, 1.0)
        positions = zip(range(count), places or self.positions(s, p),
                        itertools.repeat(1.0) if s.footprint is None else self.fades(s))
        for i, q, fade in positions:
            n = self.perlin_in(kind, *q, np.int64(seed)) if places else self.perlin_at(kind, q, np.int64(seed))
            if step.clamps:
                n = np.clip(n, -1, 1)
            term, before = step.term(self, n, before, s.strength)
            used = self.round(self.round(amp * (part if i == count - 1 else 1.0)) * fade)
            value = self.mad(used, term, value)
            if s.kind == "weighted":
                amp = self.round(amp * self.mad(-s.strength, self.round(0.5 - 0.5 * n), 1.0))
            amp = self.round(amp * s.gain)
            seed = exact.u32(seed + 0x9E3779B9)
        value = self.round(value / total) if count else value
        if s.kind == "billow":
            return self.mad(2.0, value, -1.0)
        if s.kind != "clouds":
            return value
        t = np.clip(self.mad(2.0, value, 0.25), 0.0, 1.0)
        return self.round(self.round(t * t) * self.mad(-2.0, t, 3.0))


def shaders(seed):
    return [Shader(mode, [seed, i], fuse) for i, mode in enumerate(MODES) for fuse in (0.0, 0.5)]
