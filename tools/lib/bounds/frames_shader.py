"""Octave sums with slopes, and warps, in 32-bit floats, in the steps of the library's text: for bounds_frames_test.py.
They take and give what those of frames_model.py do."""

import numpy as np

from bounds import exact_model as exact
from bounds import fixed_model as fixed
from bounds.exact_model import SHIFT, TURNS, u32
from bounds.float_model import MODES, Shader
from bounds.frames_model import GOLDEN, seeds
from bounds.gradients import OCTAHEDRAL


class FramesShader(Shader):
    def turned(self, rows):
        """Of numbers, or of rows of them."""
        rows = list(rows)
        for axis, (c, t) in enumerate(TURNS[:len(rows) - 1]):
            a, b = rows[axis:axis + 2]
            rows[axis:axis + 2] = (self.mad(c / 32, a, self.round(-t / 32 * b)),
                                   self.mad(c / 32, b, self.round(t / 32 * a)))
        return rows

    def next_frame(self, frame, growth, turns):
        frame = [self.round(np.asarray(row) * growth) for row in frame]
        return self.turned(frame) if turns else frame

    def slopes_through(self, frame, g):
        if len(g) == 2:
            return [self.dot(frame, g), self.dot((frame[0], -frame[1]), (g[1], g[0]))]
        return [self.dot([row[axis] for row in frame], g) for axis in range(3)]

    def shift_through(self, frame, v):
        if len(v) == 2:
            return [self.dot((frame[0], -frame[1]), v), self.dot((frame[1], frame[0]), v)]
        return [self.dot(row, v) for row in frame]

    def next_position(self, s, q):
        """Of a float, or of a whole position."""
        if not s.from_cell:
            positions = self.positions(s, q)
            next(positions)
            return next(positions)
        places = fixed.whole_positions(s, q)
        next(places)
        cells, rests = next(places)
        return [c * 2**24 + r for c, r in zip(cells, rests)]

    def moved(self, s, x, move):
        if not s.from_cell:
            return self.round(x + move)
        cells = np.floor(move)
        rest = np.trunc(np.clip(self.round(move - cells), 0, 1) * 2.0**24)
        return x + cells.astype(np.int64) * 2**24 + rest.astype(np.int64)

    def place(self, s, q):
        if s.from_cell:
            return [x >> 24 for x in q], [(x & (2**24 - 1)) / 2**24 for x in q]
        cells = [np.floor(x) for x in q]
        return [c.astype(np.int64) for c in cells], [self.round(x - c) for x, c in zip(q, cells)]

    def sum(self, s, q):
        """From floats, or from whole positions."""
        dims, count, amplitude = len(q), s.count, min(max(s.amplitude, 0), 64)
        total, growth, weight, seed = 0.0, self.round(s.gain * s.lacunarity), 1.0, 0
        for _ in range(count):
            total = self.mad(s.gain, total, 1.0)
        frame = [1.0, 0.0] if dims == 2 else list(np.eye(3))
        sums, fall = [np.zeros(np.shape(q[0]))] * (dims + 1), None
        for _ in range(count):
            cells, f = self.place(s, q)
            if s.kind in ("warp", "warp_progressive"):
                v = [np.clip(self.value(exact.words_at(OCTAHEDRAL, cells, of_axis), f)[0], -1, 1)
                     for of_axis in seeds(seed, dims)]
                sums = [self.mad(weight, x, a) for a, x in zip(sums, v)]
                if s.kind == "warp_progressive":
                    rate = self.round(amplitude / total)
                    q = [self.moved(s, x, self.round(u * rate)) for x, u in zip(q, self.shift_through(frame, v))]
            else:
                n, g = self.perlin(OCTAHEDRAL, exact.words_at(OCTAHEDRAL, cells, np.int64(seed)), f, derivatives=True)
                used = weight
                if s.kind == "eroded":
                    turned = [0.0] * dims if fall is None else self.turned(fall) if s.turns else fall
                    fall = [np.clip(self.round(x + y), -8, 8) for x, y in zip(turned, g)]
                    divisor = self.mad(self.dot(fall, fall), min(max(s.strength, 0), 16), 1.0)
                    used = self.round(weight * self.round(1 / divisor))
                slopes = [self.round(a + x) for a, x in zip(sums[1:], self.slopes_through(frame, g))]
                sums = [self.mad(used, n, sums[0]), *slopes]
            q = self.next_position(s, q)
            weight, frame = self.round(weight * s.gain), self.next_frame(frame, growth, s.turns)
            seed = u32(seed + GOLDEN)
        means = [self.round(x / total) for x in sums] if count else sums
        if s.kind in ("warp", "warp_progressive"):
            return [self.round(np.clip(x, -1, 1) * amplitude) for x in means[:dims]]
        return means if s.kind == "fbm_d" else means[:1]


def shaders(seed):
    return [FramesShader(mode, [seed, i], fuse) for i, mode in enumerate(MODES) for fuse in (0.0, 0.5)]
