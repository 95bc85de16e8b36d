"""Sums over lattice points, and gradients that turn, in 32-bit floats on arrays, in the steps of the library's text,
with any rounding: for bounds_kernel_test.py. Words depend on the point, as kernel_model.words_of_hash gives them."""

import numpy as np

from bounds import exact_model as exact
from bounds.exact_model import u32
from bounds.float_model import MODES, Shader
from bounds.kernel_model import is_smooth, lengthened, more_of, quarter


class KernelShader(Shader):
    # --- Distances: of each point its coordinates in half steps, the offsets, and the square of the distance ---

    def square(self, d):
        total = self.round(d[0] * d[0])
        for x in d[1:]:
            total = self.mad(x, x, total)
        return total

    def triangle(self, f):
        skewed, v = self.round(2 * f[0] + f[1]), 2 * f[1]
        column, row = np.floor(skewed), np.floor(v)
        u, v = skewed - column, v - row
        x, side = self.round(u - v / 2), u > v
        middle = np.where(side, self.round(x - 1), self.round(x + 0.5))
        far = self.round(v - 1)
        corners = ((0, 0, x, v), (side, ~side, middle, np.where(side, v, far)), (1, 1, self.round(x - 0.5), far))
        for right, up, along, across in corners:
            i, j = column + right, row + up
            yield (2 * i - j, 2 * j), [along, across], self.square([along, across])

    def rows(self, f):
        x, y = 2 * f[0], 2 * f[1]
        row = np.floor(y)
        v = y - row
        for up in (0, 1):
            shift = ((row + up) % 2) / 2
            place = self.round(x - shift)
            first = np.floor(place)
            along, across = self.round(place - first), v if up == 0 else self.round(v - 1)
            for right, d in ((0, along), (1, self.round(along - 1))):
                yield (2 * (first + right + shift), 2 * (row + up)), [d, across], self.square([d, across])

    def kinds(self, f):
        """Of the corners and the centres: the nearest point and the next one along each axis, in half steps, and the
        offsets from both."""
        ahead, inner = [self.round(x - 1) for x in f], [self.round(x - 0.5) for x in f]
        high = [x > 0.5 for x in f]
        outer = [np.where(h, self.round(x - 1), self.round(x + 1)) for h, x in zip(high, inner)]
        yield ([2.0 * h for h in high], [2.0 - 2 * h for h in high],
               [np.where(h, a, x) for h, a, x in zip(high, ahead, f)],
               [np.where(h, x, a) for h, a, x in zip(high, ahead, f)])
        yield [np.ones(x.shape) for x in f], [np.where(h, 3.0, -1.0) for h in high], inner, outer

    def summed(self, numbers):
        total = numbers[0]
        for x in numbers[1:]:
            total = self.round(total + x)
        return total

    def few(self, f):
        (corner, across, near, far), (centre, beyond, inner, outer) = self.kinds(f)
        size = [abs(x) for x in near]
        a, b = np.maximum.reduce(size), np.minimum.reduce(size)
        q = self.square(near)
        total = self.summed(size) if len(f) == 3 else self.round(self.round(size[0] + size[1])
                                                                 + self.round(size[2] + size[3]))
        to_centre = self.round(q + self.round(len(f) / 4 - total))
        yield corner, near, q

        def next_one(some, others, offsets, other_offsets, chosen, square):
            points = [np.where(c, y, x) for c, x, y in zip(chosen, some, others)]
            return points, [np.where(c, y, x) for c, x, y in zip(chosen, offsets, other_offsets)], square
        yield next_one(corner, across, near, far, [s >= a for s in size], self.round(q + self.round(1 - 2 * a)))
        yield centre, inner, to_centre
        yield next_one(centre, beyond, inner, outer, [s <= b for s in size], self.round(to_centre + 2 * b))

    def many(self, f):
        for nearest, others, d, e in self.kinds(f):
            size, q = [abs(x) for x in d], self.square(d)
            total = self.summed(size)
            yield nearest, d, q
            for axis in range(3):
                twice = 2 * size[axis]
                opposite = self.round(total - twice) > 0.5
                more = np.minimum(self.round(1 - twice), self.round(self.round(2 - 2 * total) + twice))
                moved = [opposite ^ (i == axis) for i in range(3)]
                yield ([np.where(m, y, x) for m, x, y in zip(moved, nearest, others)],
                       [np.where(m, y, x) for m, x, y in zip(moved, d, e)], self.round(q + more))

    def distances(self, kernel, f):
        if kernel.triangles:
            return self.rows(f) if is_smooth(kernel) else self.triangle(f)
        return self.many(f) if is_smooth(kernel) else self.few(f)

    # --- Ramps ---

    def wave(self, angle):
        q = angle & 0x7FFFFFFF
        return np.where(angle >> 31, -1, 1) * self.sine(np.minimum(q, 0x80000000 - q))

    def mixed(self, phase, a, b):
        return self.mad(self.wave(u32(phase + 2**30)), a, self.round(self.wave(phase) * b))

    def direction_ramp(self, words, d, factor, phase):
        dims = len(d)
        parts = [x / (512 if dims == 2 else 256) for x in exact.direction(dims, words)]
        if dims == 2:
            more, along, g = np.minimum(abs(parts[0]), abs(parts[1])), d, parts
        else:
            p, q, m = parts
            more = np.minimum(1 - (abs(p) + abs(q)) / 2, 1 - abs(m))
            along = [self.round(d[0] + d[1]) / 2, self.round(d[0] - d[1]) / 2, d[2]]
            g = [(p + q) / 2, (p - q) / 2, m]
        n = self.dot(parts, along)
        if phase is not None:
            n = self.mixed(phase, n, self.dot(quarter(g), d))
        return self.mad(n, factor * more, n)

    def gradient_of(self, g, phase):
        return g if phase is None else [self.mixed(phase, a, b) for a, b in zip(g, quarter(g))]

    # --- Simplex noise ---

    def weights(self, kernel, t):
        """w, and the fall."""
        m, q = kernel.fall, self.round(t * t)
        cube = self.round(q * t)
        if kernel.dims == 4 or (kernel.dims == 2 and is_smooth(kernel)):
            return cube, self.round(q * 6 * m)
        if kernel.dims == 2:
            return (self.round(cube * self.mad(t, -2.0, 3.0)), self.round(q * self.mad(t, -16.0, 18.0)) * m)
        fourth = self.round(q * q)
        return (self.round(fourth * t) * 4 if is_smooth(kernel) else fourth), self.round(cube * 8 * m)

    def simplex(self, kernel, words_of, fractions, phase=None):
        """The value, and the derivatives per cell."""
        value, along = 0.0, [0.0] * kernel.dims
        for point, d, q in self.distances(kernel, fractions):
            words = words_of(np.asarray(x).astype(np.int64) for x in point)
            w, fall = self.weights(kernel, np.maximum(self.mad(-float(kernel.fall), q, kernel.radius), 0.0))
            if kernel.dims == 4:
                g = exact.gradient(None, 4, words)
                ramp = self.round(sum(a * x for a, x in zip(g, d)))
            else:
                ramp = self.direction_ramp(words, d, more_of(kernel), phase)
                g = self.gradient_of(lengthened(kernel, words), phase)
            value = self.round(value + self.round(ramp * w))
            k = self.round(ramp * fall)
            along = [self.round(e + self.mad(-k, x, self.round(a * w))) for e, a, x in zip(along, g, d)]
        scale = kernel.scale / 1024
        return self.round(scale * value), [kernel.steps * self.round(scale * e) for e in along]


class TurnedPerlin(KernelShader):
    """hn_perlin with a phase."""
    phase = None

    def ramp(self, kind, words, f, corner):
        return self.direction_ramp(words, [self.round(x - o) for x, o in zip(f, corner)], 1.0, self.phase)

    def components(self, kind, words, dims):
        return self.gradient_of(exact.gradient(kind, dims, words), self.phase)


def shaders(seed, kind=KernelShader):
    return [kind(mode, [seed, i], fuse) for i, mode in enumerate(MODES) for fuse in (0.0, 0.5)]
