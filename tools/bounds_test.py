#!/usr/bin/env python3
"""Tests tools/bounds.py: the constants are the derived bounds, and simulated float arithmetic stays within them."""

import functools
import itertools
import math
import pathlib
import random
import struct
import unittest
import zlib
from unittest import mock

import bounds

DIMS = (2, 3)
NOISES = tuple(itertools.product(bounds.GRADIENTS, DIMS))
MODES = ("nearest", "down", "up", "random")
SHIFT = (11 / 32, 19 / 32, 23 / 32)


# --- A noise of its own, from docs/contract.md; the hash does not matter here, so it is a checksum --------------------

def contract_gradient(dims, word):
    a, b = ((2 * half + 1) / 65536 - 1 for half in (word >> 16, word & 0xFFFF))
    if dims == 2:
        return (a, -(1 - abs(a)) if word & 0x8000 else 1 - abs(a))
    z = 1 - abs(a) - abs(b)
    t = max(-z, 0.0)
    return (a + t if a < 0 else a - t, b + t if b < 0 else b - t, z)


def sine_gradient(dims, word):
    """The exact one; a word for each component is made of the word given."""
    return tuple(math.sin(zlib.crc32(b"%d %d" % (word, i)) - 2**31) for i in range(dims))


@functools.cache
def lattice_gradient(kind, cell, seed=0):
    word = zlib.crc32(repr((cell, seed)).encode())
    return sine_gradient(len(cell), word) if kind is bounds.SINE else contract_gradient(len(cell), word)


def exact_noise(f, gradients, kind=bounds.OCTAHEDRAL):
    """In doubles; `gradients` maps a corner to its gradient."""
    total = 0.0
    for corner in itertools.product((0, 1), repeat=len(f)):
        weight = math.prod(bounds.fade(t) if o else 1 - bounds.fade(t) for t, o in zip(f, corner))
        total += weight * sum(g * (t - o) for g, t, o in zip(gradients(corner), f, corner))
    return kind.scale[len(f)] * total


def exact_noise_at(p, seed=0, kind=bounds.OCTAHEDRAL):
    cell = [math.floor(x) for x in p]
    return exact_noise([x - c for x, c in zip(p, cell)],
                       lambda corner: lattice_gradient(kind, tuple(c + o for c, o in zip(cell, corner)), seed), kind)


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

to_float = bounds.to_float


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
        if self.mode == "nearest" or nearest == x or (nearest > x) == up or abs(x) < bounds.TINY:
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

    def inexact(self, gradients):
        """Floats within the error of the sine gradient, often at its ends, so that the errors of all ramps add."""
        error, aligned = bounds.SINE.component_error, self.rng.choice((-1, 1, 0))

        def component(g, o):
            sign = aligned * (1 - 2 * o) or self.rng.uniform(-1, 1)  # an offset is negative where o is 1
            moved = to_float(min(max(g + sign * error, -1.0), 1.0))
            return moved if abs(moved - g) <= error else to_float(g)
        return lambda corner: tuple(map(component, gradients(corner), corner))

    def noise(self, f, gradients, kind=bounds.OCTAHEDRAL):
        if kind is bounds.SINE:
            gradients = self.inexact(gradients)
        offsets = [(t, self.round(t - 1)) for t in f]
        reversed_corners = itertools.product((0, 1), repeat=len(f))  # so that x varies fastest
        values = [self.ramp(gradients(corner), [d[o] for d, o in zip(offsets, corner)])
                  for corner in (r[::-1] for r in reversed_corners)]
        for t in f:
            weight = self.fade(t)
            values = [self.lerp(a, b, weight) for a, b in zip(values[::2], values[1::2])]
        return self.round(kind.scale[len(f)] * values[0])

    def noise_at(self, p, seed=0, kind=bounds.OCTAHEDRAL):
        cell = [math.floor(x) for x in p]
        return self.noise([self.round(x - c) for x, c in zip(p, cell)],
                          lambda corner: lattice_gradient(kind, tuple(c + o for c, o in zip(cell, corner)), seed), kind)

    def sine(self, q):
        """Of q / 2^32 turns, at most a quarter."""
        x = (q >> 6) / 2**24
        t = self.round(x * x)
        c1, c3, c5, c7 = bounds.SINE_COEFFICIENTS
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
    if kind is bounds.SINE:
        nearly = 1 - bounds.SINE.component_error  # one that may be 1 or less
        chosen = {corner: tuple(rng.choice((-nearly, nearly, math.sin(rng.randrange(2**31)))) for _ in range(dims))
                  for corner in bounds.corners(dims)}
        return chosen.__getitem__
    steep = [tuple(map(float, g)) for g in bounds.steepest_gradients(dims)]
    chosen = {corner: rng.choice(steep) if rng.random() < 0.7 else contract_gradient(dims, rng.getrandbits(32))
              for corner in bounds.corners(dims)}
    return chosen.__getitem__


class Range(unittest.TestCase):
    def test_below_one_even_with_the_float_error(self):
        for dims in DIMS:
            largest = bounds.range_bound(dims, bounds.SCALE[dims]) + bounds.OCTAHEDRAL.error[dims]
            self.assertLess(largest, bounds.OCTAHEDRAL.limit[dims])
            self.assertEqual(bounds.OCTAHEDRAL.limit[dims], 1)

    def test_limit_of_the_sine_gradient(self):
        for dims in DIMS:
            largest, limit = bounds.sine_range(dims) + bounds.SINE.error[dims], bounds.SINE.limit[dims]
            self.assertTrue(largest <= limit < largest + 1e-5)
            self.assertEqual(limit, round(limit, 5))

    def test_sine_range_is_that_of_the_sum(self):
        """Attained in the middle of the cell, and nowhere more."""
        def supremum(f):
            weights = {corner: math.prod(bounds.fade(t) if o else 1 - bounds.fade(t) for t, o in zip(f, corner))
                       for corner in bounds.corners(len(f))}
            return sum(w * sum(abs(t - o) for t, o in zip(f, corner)) for corner, w in weights.items())
        rng = random.Random(13)
        for dims in DIMS:
            self.assertEqual(supremum((0.5,) * dims), bounds.sine_range(dims))
            for _ in range(5000):
                total = supremum([0.5 + rng.uniform(-0.5, 0.5) ** rng.choice((1, 3, 9)) for _ in range(dims)])
                self.assertLess(total, bounds.sine_range(dims) + 1e-12)

    def test_attained(self):
        for dims in DIMS:
            value, point, gradients = bounds.range_witness(dims)
            self.assertEqual(point, tuple(map(to_float, point)))
            self.assertAlmostEqual(float(value), exact_noise(point, gradients.__getitem__), delta=1e-14)
            bound = bounds.range_bound(dims, bounds.SCALE[dims])
            self.assertTrue(bound - 1e-5 < value < bound)

    def test_known_suprema(self):
        self.assertAlmostEqual(bounds.range_bound(2, 1), 0.5352764390514959, delta=2e-9)
        self.assertAlmostEqual(bounds.range_bound(3, 1), 0.5629016051291905, delta=2e-9)

    def test_fails_with_a_larger_scale(self):
        for dims in DIMS:
            self.assertGreater(bounds.range_bound(dims, 1.02 * bounds.SCALE[dims]), 1)
            self.assertGreater(1.02 * bounds.range_witness(dims)[0], 1)

    def test_unfolded_sum_stays_below(self):
        """The sum over the corners as it stands, over the whole cube: the folding and nesting lose nothing."""
        rng = random.Random(1)
        for dims in DIMS:
            bound = bounds.range_bound(dims, 1)
            for _ in range(5000):
                f = [rng.random() for _ in range(dims)]
                total = sum(math.prod(bounds.fade(t) if o else 1 - bounds.fade(t) for t, o in zip(f, corner))
                            * max(abs(t - o) for t, o in zip(f, corner)) for corner in bounds.corners(dims))
                self.assertLessEqual(total, bound)

    def test_steepest_gradients_are_the_contracts(self):
        edges = (0, 1, 0x7FFE, 0x7FFF, 0x8000, 0x8001, 0xFFFE, 0xFFFF)
        for dims in DIMS:
            known = {contract_gradient(dims, high << 16 | low) for high in edges for low in edges}
            for gradient in bounds.steepest_gradients(dims):
                self.assertEqual(sum(map(abs, gradient)), 1)
                self.assertIn(gradient, known)


class Lipschitz(unittest.TestCase):
    def test_constant_is_the_derived_bound(self):
        for kind, dims in NOISES:
            derived, constant = bounds.lipschitz_bound(dims, kind), kind.lipschitz[dims]
            self.assertTrue(derived <= constant <= 1.01 * derived)
            self.assertEqual(constant, float(f"{constant:.2e}"))
            self.assertLessEqual(bounds.lipschitz_witness(dims, kind), derived)

    def test_random_differences(self):
        rng = random.Random(2)
        for kind, dims in NOISES:
            for _ in range(5000):
                p = [rng.uniform(-4, 4) for _ in range(dims)]
                reach = 10 ** rng.uniform(-5, 0)
                q = [x + rng.choice((rng.uniform(-1, 1), -1, 1)) * reach for x in p]
                distance = max(abs(a - b) for a, b in zip(p, q))
                rise = abs(exact_noise_at(p, 0, kind) - exact_noise_at(q, 0, kind))
                self.assertLessEqual(rise, kind.lipschitz[dims] * distance)

    def steepest_rise(self, kind, dims, step):
        """Over 2 * step along the diagonal at the witness, with the steepest gradient at each corner."""
        ends = [[t + sign * step for t in bounds.SLOPE_WITNESS[kind][dims]] for sign in (1, -1)]
        zero = (0.0,) * dims

        def rise(corner, gradient):
            high, low = (exact_noise(f, lambda o: gradient if o == corner else zero, kind) for f in ends)
            return high - low
        vertices = itertools.product((-1.0, 1.0), repeat=dims)
        gradients = vertices if kind is bounds.SINE else bounds.steepest_gradients(dims)
        gradients = [tuple(map(float, g)) for g in gradients]
        return sum(max(rise(corner, g) for g in gradients) for corner in bounds.corners(dims))

    def test_nearly_attained_by_differences(self):
        """Also a must-fail check: a constant 1% smaller would be refuted."""
        step = 1e-4
        for kind, dims in NOISES:
            slope = self.steepest_rise(kind, dims, step) / (2 * step)
            self.assertLess(slope, kind.lipschitz[dims])
            self.assertGreater(slope, 0.99 * kind.lipschitz[dims])


class FloatError(unittest.TestCase):
    def largest_error(self, kind, dims, shader, count, seed):
        """From a cell and a fraction."""
        rng, largest = random.Random(seed), 0.0
        for _ in range(count):
            f = [random_fraction(rng) for _ in range(dims)]
            gradients = random_gradients(rng, dims, kind)
            largest = max(largest, abs(shader.noise(f, gradients, kind) - exact_noise(f, gradients, kind)))
        return largest

    def test_constant_is_the_derived_bound(self):
        for kind, dims in NOISES:
            derived = bounds.position_error(bounds.error_bound(dims, kind), bounds.lipschitz_bound(dims, kind))
            self.assertTrue(derived <= kind.error[dims] <= 1.01 * derived)
            self.assertEqual(kind.error[dims], float(f"{kind.error[dims]:.2e}"))

    def test_simulated_from_cell(self):
        for kind, dims in NOISES:
            bound = bounds.error_bound(dims, kind)
            seen = [self.largest_error(kind, dims, shader, 1000, 3) for shader in shaders(random.Random(4))]
            self.assertLess(max(seen), bound)
            self.assertGreater(max(seen), bound / 5)

    def test_simulated_to_nearest(self):
        for kind, dims in NOISES:
            bound = bounds.error_bound(dims, kind, 0.5)
            seen = self.largest_error(kind, dims, Shader("nearest", random.Random(5)), 3000, 6)
            self.assertLess(seen, bound)
            self.assertGreater(seen, bound / 10)

    def test_fails_with_fewer_bits(self):
        for kind, dims in NOISES:
            seen = self.largest_error(kind, dims, Shader("nearest", random.Random(7), lost_bits=6), 1000, 8)
            self.assertGreater(seen, kind.error[dims])

    def test_simulated_from_position(self):
        """Also the negative positions whose fraction is rounded, up to 1."""
        rng = random.Random(9)
        for (kind, dims), shader in itertools.product(NOISES, shaders(rng)):
            for _ in range(500):
                p = [to_float(rng.choice((-1, 1)) * rng.random() * 2.0 ** rng.randrange(-40, 12)) for _ in range(dims)]
                self.assertLess(abs(shader.noise_at(p, 0, kind) - exact_noise_at(p, 0, kind)), kind.error[dims])


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
        self.assertLess(bounds.sine_bound(), 2**-19)
        self.assertEqual(bounds.SINE.component_error, 2**-19)
        self.assertLess(bounds.sine_largest(), 1)

    def test_simulated(self):
        for ulps, modes in ((1.0, MODES), (0.5, ("nearest",))):
            bound = bounds.sine_bound(ulps)
            rng = random.Random(15)
            seen = max(self.largest_error(Shader(mode, rng, fuse)) for mode in modes for fuse in (0.0, 0.5))
            self.assertTrue(bound / 2 < seen < bound)

    def test_polynomial(self):
        seen = max(bounds.sine_truncation((i / 20000,)) for i in range(20001))
        self.assertTrue(seen < bounds.sine_truncation_bound() < 1.05 * seen)

    def test_fails_with_fewer_bits(self):
        self.assertGreater(self.largest_error(Shader("nearest", random.Random(16), lost_bits=4)), 2**-19)

    def test_fails_with_another_coefficient(self):
        """One that is off in its last digits is refused by the proof, and by the simulation."""
        c1, *others = bounds.SINE_COEFFICIENTS
        for offset, too_large in ((3e-6, True), (-3e-6, False)):
            with mock.patch.object(bounds, "SINE_COEFFICIENTS", (c1 + offset, *others)):
                self.assertGreater(bounds.sine_bound(), 2**-19)
                self.assertEqual(bounds.sine_largest() > 1, too_large)

    def test_coefficients_are_floats(self):
        for coefficient in bounds.SINE_COEFFICIENTS:
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
                tolerance = bounds.octave_tolerance(kind, dims, max(map(abs, p)), octaves, lacunarity, gain, exact,
                                                    gradient)
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
        self.assertEqual(bounds.octave_tolerance("fbm", 2, 1.0, 0, 2.0, 0.5, False), 0)
        self.assertLess(bounds.octave_tolerance("fbm", 2, 1.0, 200, 2.0, 0.5, False), 2.001)
        self.assertEqual(bounds.octave_tolerance("fbm", 3, 1.0, 20, 2.0, 1e20, False), math.inf)
        self.assertLess(bounds.octave_tolerance("fbm", 3, 1.0, 200, 2.0, 0.5, False, bounds.SINE), 3.001)
        with self.assertRaises(ValueError):
            bounds.octave_tolerance("fog", 2, 1.0, 1, 2.0, 0.5, False)


class Transcription(unittest.TestCase):
    """The places outside of this tool that state its numbers."""

    def assert_states(self, path, *numbers):
        text = (pathlib.Path(__file__).resolve().parent.parent / path).read_text()
        for number in numbers:
            self.assertIn(number, text, path)

    @staticmethod
    def rounded_up(value, digits):
        """To a number of significant digits, as the documents write it."""
        step = 10.0 ** (math.floor(math.log10(value)) + 1 - digits)
        return f"{math.ceil(value / step - 1e-9) * step:.{digits - 1}e}".replace("e-0", "e-")

    @staticmethod
    def as_written(value):
        """To 3 significant digits, as the documents write it."""
        return f"{value:.2e}".replace("e-0", "e-")

    def test_the_suite_uses_these_bounds(self):
        for kind, dims in NOISES:
            numbers = (self.rounded_up(bounds.error_bound(dims, kind), 3), self.as_written(kind.error[dims]),
                       str(kind.lipschitz[dims]), str(kind.limit[dims]))
            self.assert_states("conformance/tolerance.cpp", f"NoiseBounds{{{', '.join(numbers)}}}")

    def test_the_sources_state_the_bounds_of_the_octahedral_gradient(self):
        for dims in DIMS:
            kind, range_bound = bounds.OCTAHEDRAL, {2: "0.999985", 3: "0.99992"}[dims]
            position, cell = self.as_written(kind.error[dims]), self.rounded_up(bounds.error_bound(dims, kind), 2)
            self.assertLess(bounds.range_bound(dims, bounds.SCALE[dims]), float(range_bound))
            self.assert_states(f"glsl/noise{dims}d.glsl", position, cell, range_bound)
            self.assert_states("README.md", position, range_bound)

    def test_the_page_states_these_bounds(self):
        def of_noise(number):
            return " | ".join(number(kind, dims) for kind, dims in NOISES)

        rows = (of_noise(lambda kind, dims: str(kind.lipschitz[dims])),
                of_noise(lambda kind, dims: self.rounded_up(bounds.error_bound(dims, kind), 3)),
                of_noise(lambda kind, dims: self.as_written(kind.error[dims])))
        self.assert_states("docs/accuracy.md", *(f"| {row} |" for row in rows))
        self.assertEqual([bounds.sine_range(dims) for dims in DIMS], [1, 3 / 2])
        self.assert_states("docs/accuracy.md", "| 0.999985 | 0.99992 | 1 | 3/2 |",
                           *(str(bounds.SINE.limit[dims]) for dims in DIMS))

    def test_the_page_states_the_bounds_of_octave_sums(self):
        for kind, dims, exact in (("fbm", 2, True), ("fbm", 2, False), ("fbm", 3, False), ("clouds", 2, False)):
            row = " | ".join(self.rounded_up(bounds.octave_tolerance(kind, dims, 16.0, 5, 2.0, 0.5, exact, gradient), 2)
                             for gradient in bounds.GRADIENTS)
            self.assert_states("docs/accuracy.md", f"| {row} |")
        octahedral, sine = (bounds.octave_tolerance("fbm", 3, 1024.0, 8, 2.0, 0.5, False, g) for g in bounds.GRADIENTS)
        self.assertTrue(0.021 < octahedral < 0.022 and 0.023 < sine < 0.024)
        self.assert_states("docs/accuracy.md", "is 0.022 (with the sine gradient 0.024)")

    def test_the_page_states_the_bounds_of_the_sine(self):
        polynomial = (f"{c:.8f}" for c in bounds.SINE_DECIMALS)
        self.assert_states("docs/accuracy.md", *polynomial, f"{round(bounds.SINE_ARGUMENT_ERROR * 2**30)} / 2^30")
        self.assert_states("docs/accuracy.md", *(self.rounded_up(value, 3) for value in (
            bounds.sine_truncation_bound(), math.pi / 2 * bounds.SINE_ARGUMENT_ERROR, bounds.sine_bound(),
            bounds.SINE.component_error)))
        below = math.floor((1 - bounds.sine_largest()) * 1e9) / 1e9
        self.assert_states("docs/accuracy.md", self.as_written(below))


if __name__ == "__main__":
    unittest.main()
