"""Tests of what is proven of floats, of a noise, the sine and the sums: simulated float arithmetic, in any rounding
mode, stays within the bounds."""

import itertools
import math
import random
import struct
import unittest
from unittest import mock

from bounds import sine, sums
from bounds.boxes import corners
from bounds.floats import TINY, to_float
from bounds.gradients import GRADIENTS, OCTAHEDRAL, SINE
from bounds.noises.perlin.exact import SCALE, steepest_gradients
from bounds.noises.perlin.floats import error_bound
from bounds.reference import contract_gradient, exact_noise, exact_noise_at, lattice_gradient
from bounds.table import bounds_of

NOISES = tuple(itertools.product(GRADIENTS, (2, 3)))
MODES = ("nearest", "down", "up", "random")
SHIFT = (11 / 32, 19 / 32, 23 / 32)


def proven(kind, dims):
    """What bounds.inc has of hn_perlin."""
    return bounds_of("perlin", dims, kind.name)


def exact_octaves(kind, p, octaves, lacunarity, gain, gradient):
    total = sum(gain**i for i in range(octaves))
    value, q = 0.0, list(p)
    for i in range(octaves):
        noise = exact_noise_at(q, i, gradient)
        value += gain**i * (abs(noise) if kind == "turbulence" else noise) / total
        q = [x * lacunarity + s for x, s in zip(q, SHIFT)]
    if kind != "clouds":
        return value
    t = min(max(2 * value + 0.25, 0.0), 1.0)
    return t * t * (3 - 2 * t)


# --- The shader's arithmetic ------------------------------------------------------------------------------------------

def float_step(x, direction):
    """The next float above or below the float x, which is not 0 (a rounded result of a non-zero double)."""
    bits = struct.unpack("<i", struct.pack("<f", x))[0]
    return struct.unpack("<f", struct.pack("<i", bits + (1 if (x > 0) == (direction > 0) else -1)))[0]


class Shader:
    """Evaluates in 32-bit floats with a rounding mode ("random" chooses for each operation); may fuse a*b + c."""

    def __init__(self, mode, rng, fuse=0.0, lost_bits=0):
        self.mode, self.rng, self.fuse, self.lost_bits = mode, rng, fuse, lost_bits

    def round(self, x):
        if self.lost_bits:
            mantissa, exponent = math.frexp(x)
            return math.ldexp(round(mantissa * 2 ** (24 - self.lost_bits)), exponent - 24 + self.lost_bits)
        nearest = to_float(x)
        up = self.rng.random() < 0.5 if self.mode == "random" else self.mode == "up"
        if self.mode == "nearest" or nearest == x or (nearest > x) == up or abs(x) < TINY:
            return nearest
        return float_step(nearest, 1 if up else -1)

    def mad(self, a, b, c):
        """a*b + c. The product of two floats is exact in a double."""
        return self.round((a * b if self.rng.random() < self.fuse else self.round(a * b)) + c)

    def fade(self, t):
        cube = self.round(self.round(t * t) * t)
        return self.round(cube * self.mad(self.round(t - 1), self.mad(t, 6, -9), 1))

    def lerp(self, a, b, t):
        return self.mad(t, self.round(b - a), a)

    def ramp(self, g, d):
        value = self.round(g[0] * d[0])
        for g_i, d_i in zip(g[1:], d[1:]):
            value = self.mad(g_i, d_i, value)
        return value

    def space_ramp(self, g, f, corner, z):
        """p*u + q*v + m*d.z, from the fraction."""
        a, b = (0.5 * self.round(f[0] + sign * f[1]) for sign in (1, -1))
        u, v = self.round(a - 0.5 * (corner[0] + corner[1])), self.round(b + 0.5 * (corner[1] - corner[0]))
        return self.ramp((g[0] + g[1], g[0] - g[1], g[2]), (u, v, z))

    def inexact(self, gradients):
        """Floats within the error of the sine gradient, often at its ends, so that the errors of all ramps add."""
        error, aligned = SINE.component_error, self.rng.choice((-1, 1, 0))

        def component(g, o):
            sign = aligned * (1 - 2 * o) or self.rng.uniform(-1, 1)  # an offset is negative where o is 1
            moved = to_float(min(max(g + sign * error, -1.0), 1.0))
            return moved if abs(moved - g) <= error else to_float(g)
        return lambda corner: tuple(map(component, gradients(corner), corner))

    def noise(self, f, gradients, kind=OCTAHEDRAL):
        if kind is SINE:
            gradients = self.inexact(gradients)
        offsets = [(t, self.round(t - 1)) for t in f]
        values = []
        for corner in (reverse[::-1] for reverse in corners(len(f))):  # so that x varies fastest
            own = [d[o] for d, o in zip(offsets, corner)]
            if kind is SINE or len(f) == 2:
                values.append(self.ramp(gradients(corner), own))
            else:
                values.append(self.space_ramp(gradients(corner), f, corner, own[2]))
        for t in f:
            weight = self.fade(t)
            values = [self.lerp(a, b, weight) for a, b in zip(values[::2], values[1::2])]
        return self.round(SCALE[kind][len(f)] * values[0])

    def noise_at(self, p, seed=0, kind=OCTAHEDRAL):
        cell = [math.floor(x) for x in p]
        return self.noise([self.round(x - c) for x, c in zip(p, cell)],
                          lambda corner: lattice_gradient(kind, tuple(c + o for c, o in zip(cell, corner)), seed), kind)

    def sine(self, q):
        """The sine of q / 2^32 turns, at most a quarter."""
        x = (q >> 6) / 2**24
        t = self.round(x * x)
        c1, c3, c5, c7 = sine.SINE_COEFFICIENTS
        return self.round(x * self.mad(t, self.mad(t, self.mad(t, c7, c5), c3), c1))

    def octaves(self, kind, p, octaves, lacunarity, gain, gradient):
        total, value, amp, q = 0.0, 0.0, 1.0, list(p)
        for i in range(octaves):
            noise = self.noise_at(q, i, gradient)
            value = self.mad(amp, abs(noise) if kind == "turbulence" else noise, value)
            total = self.mad(gain, total, 1)
            q = [self.mad(x, lacunarity, s) for x, s in zip(q, SHIFT)]
            amp = self.round(amp * gain)
        value = self.round(value / total)
        if kind != "clouds":
            return value
        t = min(max(self.mad(2, value, 0.25), 0.0), 1.0)
        return self.round(self.round(t * t) * self.mad(-2, t, 3))


def shaders(rng):
    return [Shader(mode, rng, fuse) for mode in MODES for fuse in (0.0, 0.5)]


def random_fraction(rng):
    """A float in [0, 1], often near its ends."""
    near = rng.random() * 2.0 ** -rng.randrange(26)
    return to_float(rng.choice((rng.random(), near, 1 - near, 1 - 2.0**-24, 1.0, 0.5)))


def random_gradients(rng, dims, kind):
    if kind is SINE:
        nearly = 1 - SINE.component_error  # one that may be 1 or less
        chosen = {corner: tuple(rng.choice((-nearly, nearly, math.sin(rng.randrange(2**31)))) for _ in range(dims))
                  for corner in corners(dims)}
        return chosen.__getitem__
    steep = [tuple(map(float, g)) for g in steepest_gradients(dims)]
    chosen = {corner: rng.choice(steep) if rng.random() < 0.7 else contract_gradient(dims, rng.getrandbits(32))
              for corner in corners(dims)}
    return chosen.__getitem__


class FloatError(unittest.TestCase):
    def largest_error(self, kind, dims, shader, count, seed):
        """From a cell and a fraction."""
        rng, largest = random.Random(seed), 0.0
        for _ in range(count):
            f = [random_fraction(rng) for _ in range(dims)]
            gradients = random_gradients(rng, dims, kind)
            largest = max(largest, abs(shader.noise(f, gradients, kind) - exact_noise(f, gradients, kind)))
        return largest

    def test_simulated_from_cell(self):
        for kind, dims in NOISES:
            bound = error_bound(dims, kind)
            seen = [self.largest_error(kind, dims, shader, 1000, 3) for shader in shaders(random.Random(4))]
            self.assertLess(max(seen), bound)
            self.assertGreater(max(seen), bound / 5)

    def test_simulated_to_nearest(self):
        for kind, dims in NOISES:
            bound = error_bound(dims, kind, 0.5)
            seen = self.largest_error(kind, dims, Shader("nearest", random.Random(5)), 3000, 6)
            self.assertLess(seen, bound)
            self.assertGreater(seen, bound / 10)

    def test_fails_with_fewer_bits(self):
        for kind, dims in NOISES:
            seen = self.largest_error(kind, dims, Shader("nearest", random.Random(7), lost_bits=6), 1000, 8)
            self.assertGreater(seen, proven(kind, dims).error)

    def test_simulated_from_position(self):
        """Also the negative positions whose fraction is rounded, up to 1."""
        rng = random.Random(9)
        for (kind, dims), shader in itertools.product(NOISES, shaders(rng)):
            for _ in range(500):
                p = [to_float(rng.choice((-1, 1)) * rng.random() * 2.0 ** rng.randrange(-40, 12)) for _ in range(dims)]
                self.assertLess(abs(shader.noise_at(p, 0, kind) - exact_noise_at(p, 0, kind)), proven(kind, dims).error)


class Sine(unittest.TestCase):
    def largest_error(self, shader, count=20000):
        """Over arguments that the reduction and the shift have moved as far as they may."""
        rng, largest = random.Random(14), 0.0
        for i in range(count):
            q = rng.choice((rng.randrange(2**30 + 1), rng.randrange(2**20), 2**30 - rng.randrange(2**20)))
            q = min(rng.choice((q, q | 63)), 2**30)
            value = shader.sine(q)
            self.assertTrue(0 <= value <= 1)
            largest = max(largest, abs(value - math.sin(math.pi / 2**31 * (q + rng.choice((-3, 0, 3))))))
        return largest

    def test_within_the_contract(self):
        self.assertLess(sine.sine_bound(), 2**-19)
        self.assertEqual(SINE.component_error, 2**-19)
        self.assertLess(sine.sine_largest(), 1)

    def test_simulated(self):
        for ulps, modes in ((1.0, MODES), (0.5, ("nearest",))):
            bound = sine.sine_bound(ulps)
            rng = random.Random(15)
            seen = max(self.largest_error(Shader(mode, rng, fuse)) for mode in modes for fuse in (0.0, 0.5))
            self.assertTrue(bound / 2 < seen < bound)

    def test_polynomial(self):
        seen = max(sine.sine_truncation((i / 20000,)) for i in range(20001))
        self.assertTrue(seen < sine.sine_truncation_bound() < 1.05 * seen)

    def test_fails_with_fewer_bits(self):
        self.assertGreater(self.largest_error(Shader("nearest", random.Random(16), lost_bits=4)), 2**-19)

    def test_fails_with_another_coefficient(self):
        """One that is off in its last digits is refused by the proof, and by the simulation."""
        c1, *others = sine.SINE_COEFFICIENTS
        for offset, too_large in ((3e-6, True), (-3e-6, False)):
            with mock.patch.object(sine, "SINE_COEFFICIENTS", (c1 + offset, *others)):
                self.assertGreater(sine.sine_bound(), 2**-19)
                self.assertEqual(sine.sine_largest() > 1, too_large)

    def test_coefficients_are_floats(self):
        for coefficient in sine.SINE_COEFFICIENTS:
            self.assertEqual(coefficient, to_float(coefficient))


class Octaves(unittest.TestCase):
    KINDS = ("fbm", "turbulence", "clouds")

    def check(self, rng, count, parameters):
        """Simulates on random parameters; the largest ratio of an error to its tolerance."""
        worst = 0.0
        for (gradient, dims), kind, shader in itertools.product(NOISES, self.KINDS, shaders(rng)):
            for _ in range(count):
                p, octaves, lacunarity, gain, exact = parameters(dims)
                simulated = shader.octaves(kind, p, octaves, lacunarity, gain, gradient)
                error = abs(simulated - exact_octaves(kind, p, octaves, lacunarity, gain, gradient))
                tolerance = sums.octave_tolerance(kind, proven(gradient, dims), max(map(abs, p)), octaves, lacunarity,
                                                  gain, exact)
                self.assertLessEqual(error, tolerance)
                worst = max(worst, error / tolerance)
        return worst

    def test_simulated(self):
        rng = random.Random(10)

        def parameters(dims):
            reach = 2.0 ** rng.randrange(12)
            p = [to_float(rng.uniform(-reach, reach)) for _ in range(dims)]
            return p, rng.randint(1, 6), to_float(rng.uniform(-3, 3)), to_float(rng.uniform(0, 2)), False
        self.assertGreater(self.check(rng, 25, parameters), 1 / 30)

    def test_simulated_with_exact_positions(self):
        rng = random.Random(11)

        def parameters(dims):
            return [rng.randrange(-4096, 4096) / 256 for _ in range(dims)], rng.randint(1, 6), 2.0, 0.5, True
        self.assertGreater(self.check(rng, 25, parameters), 1 / 60)

    def test_exact_positions_do_not_hide_inexact_ones(self):
        """A must-fail check: positions that round, promised exact, exceed the tolerance."""
        rng = random.Random(12)

        def parameters(dims):
            return [to_float(rng.uniform(-4096, 4096)) for _ in range(dims)], 6, to_float(2.1), 0.5, True
        with self.assertRaises(AssertionError):
            self.check(rng, 25, parameters)

    def test_edges(self):
        self.assertEqual(sums.octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, 0, 2.0, 0.5, False), 0)
        self.assertLess(sums.octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, 200, 2.0, 0.5, False), 2.001)
        self.assertEqual(sums.octave_tolerance("fbm", proven(OCTAHEDRAL, 3), 1.0, 20, 2.0, 1e20, False), math.inf)
        self.assertLess(sums.octave_tolerance("fbm", proven(SINE, 3), 1.0, 200, 2.0, 0.5, False), 3.001)
        with self.assertRaises(ValueError):
            sums.octave_tolerance("fog", proven(OCTAHEDRAL, 2), 1.0, 1, 2.0, 0.5, False)
