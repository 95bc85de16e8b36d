"""Tests of what is proven of floats, of the noises, their derivatives, the sine and the sums: simulated float
arithmetic, in any rounding mode, stays within the bounds."""

import math
import unittest
from unittest import mock

import numpy as np

from bounds import exact_model as exact
from bounds import noises, sine, sums
from bounds.float_model import MODES, Shader, shaders
from bounds.floats import to_float
from bounds.gradients import OCTAHEDRAL, SINE
from bounds.noises import value as value_noise
from bounds.noises import value_cubic
from bounds.noises.perlin import floats as perlin
from bounds.table import bounds_of, slope_bounds_of

CASES = noises.find("perlin").CASES
DIMS = (1, 2, 3, 4)
COUNT = {1: 20_000, 2: 10_000, 3: 4_000, 4: 2_000}


def proven(kind, dims):
    """What bounds.inc has of hn_perlin."""
    return bounds_of("perlin", dims, kind.name)


def random_fractions(rng, dims, count):
    """Floats in [0, 1], often near its ends."""
    near = rng.random((dims, count)) * 2.0 ** -rng.integers(0, 26, (dims, count))
    choice = rng.integers(0, 6, (dims, count))
    fractions = np.choose(choice, [rng.random((dims, count)), near, 1 - near, 1 - 2.0**-24, 1.0, 0.5])
    return list(fractions.astype(np.float32).astype(float))


def words_of_cell(rng, kind, dims, count):
    """From a corner, or a point of cubic noise, to random words."""
    words = {}

    def words_of(corner):
        if corner not in words:
            words[corner] = rng.integers(0, 2**32, (dims, count) if kind is SINE else count)
        return words[corner]
    return words_of


class FloatError(unittest.TestCase):
    """From a cell and a fraction, with random words: these hardly ever make errors add up. They see about 1/3 of the
    bound in 1D, and of derivatives in 4D, which have the loosest bound, 1/12."""

    def largest(self, noise, dims, kind=None, seed=1, simulated=None):
        """The largest error of a noise, and of its derivatives. `noise` maps a shader and what a noise takes to the
        simulated and the exact value, and the same of the derivatives."""
        rng, errors = np.random.default_rng(seed), [0.0, 0.0]
        for shader in simulated or shaders(seed):
            f = random_fractions(rng, dims, COUNT[dims])
            words_of = words_of_cell(rng, kind, dims, COUNT[dims])
            (value, expected), derivatives = noise(shader, words_of, f)
            errors[0] = max(errors[0], abs(value - expected).max())
            errors[1] = max([errors[1], *(abs(d - e).max() for d, e in derivatives)])
        return errors

    @staticmethod
    def perlin(kind):
        def noise(shader, words_of, f):
            exact_value, slopes = exact.perlin(kind, words_of, f)
            if kind is SINE:
                return (shader.perlin(kind, words_of, f), exact_value), []
            value, derivatives = shader.perlin(kind, words_of, f, derivatives=True)
            return (value, exact_value), list(zip(derivatives, slopes))
        return noise

    @staticmethod
    def value(shader, words_of, f):
        (exact_value, slopes), (value, derivatives) = exact.value(words_of, f), shader.value(words_of, f)
        return (value, exact_value), list(zip(derivatives, slopes))

    @staticmethod
    def value_cubic(shader, words_of, f):
        return (shader.value_cubic(words_of, f), exact.value_cubic(words_of, f)), []

    def every_noise(self):
        """Each with its bounds of values and derivatives, for a rounding of so many ulps."""
        for dims, kind in CASES:
            def bounds(ulps, dims=dims, kind=kind):
                return (perlin.error_bound(dims, kind, ulps),
                        perlin.slope_error_bound(dims, ulps) if kind is OCTAHEDRAL else None)
            yield self.perlin(kind), dims, kind, bounds
        for dims in DIMS:
            yield self.value, dims, None, lambda ulps, dims=dims: (value_noise.error_bound(dims, ulps),
                                                                   value_noise.slope_error_bound(dims, ulps))
        for dims in DIMS[:3]:
            yield self.value_cubic, dims, None, lambda ulps, dims=dims: (value_cubic.error_bound(dims, ulps), None)

    def test_simulated_from_cell(self):
        for noise, dims, kind, bounds in self.every_noise():
            for seen, bound in zip(self.largest(noise, dims, kind), bounds(1.0)):
                if bound:
                    self.assertTrue(bound / 20 < seen < bound, (noise, dims, seen, bound))

    def test_simulated_to_nearest(self):
        for noise, dims, kind, bounds in self.every_noise():
            nearest = [Shader("nearest", 5)]
            for seen, bound in zip(self.largest(noise, dims, kind, 6, nearest), bounds(0.5)):
                if bound:
                    self.assertTrue(bound / 30 < seen < bound, (noise, dims, seen, bound))

    def test_fails_with_fewer_bits(self):
        for noise, dims, kind, bounds in self.every_noise():
            fewer = [Shader("nearest", 7, lost_bits=6)]
            for seen, bound in zip(self.largest(noise, dims, kind, 8, fewer), bounds(1.0)):
                if bound:
                    self.assertGreater(seen, bound, (noise, dims))

    def test_limits(self):
        """Of derivatives, and of value noise where the fade is computed above 1."""
        for dims in DIMS:
            rng = np.random.default_rng(9)
            f, words_of = random_fractions(rng, dims, COUNT[dims]), words_of_cell(rng, None, dims, COUNT[dims])
            for shader in shaders(10):
                value, derivatives = shader.value(words_of, f)
                self.assertLessEqual(abs(value).max(), bounds_of("value", dims, "none").limit)
                self.assertLessEqual(abs(np.array(derivatives)).max(), slope_bounds_of("value_d", dims).limit)
                _, derivatives = shader.perlin(OCTAHEDRAL, words_of, f, derivatives=True)
                self.assertLessEqual(abs(np.array(derivatives)).max(), slope_bounds_of("perlin_d", dims).limit)

    def test_simulated_from_position(self):
        """Also the negative positions whose fraction is rounded, up to 1."""
        rng = np.random.default_rng(9)
        for (dims, kind), shader in ((case, shader) for case in CASES for shader in shaders(11)):
            reach = 2.0 ** rng.integers(-40, 12, (dims, 2000))
            p = list((rng.uniform(-1, 1, (dims, 2000)) * reach).astype(np.float32).astype(float))
            error = abs(shader.perlin_at(kind, p) - exact.perlin_at(kind, p)[0]).max()
            self.assertLess(error, proven(kind, dims).error)


class Sine(unittest.TestCase):
    def largest_error(self, shader, count=20000):
        """Over arguments that the reduction and the shift have moved as far as they may."""
        rng = np.random.default_rng(14)
        near = rng.integers(0, 2**20, count)
        q = np.choose(rng.integers(0, 3, count), [rng.integers(0, 2**30 + 1, count), near, 2**30 - near])
        q = np.minimum(np.where(rng.random(count) < 0.5, q, q | 63), 2**30)
        value = shader.sine(q)
        self.assertTrue((value >= 0).all() and (value <= 1).all())
        return abs(value - np.sin(np.pi / 2**31 * (q + rng.choice((-3, 0, 3), count)))).max()

    def test_within_the_contract(self):
        self.assertLess(sine.sine_bound(), 2**-19)
        self.assertEqual(SINE.component_error, 2**-19)
        self.assertLess(sine.sine_largest(), 1)

    def test_simulated(self):
        for ulps, modes in ((1.0, MODES), (0.5, ("nearest",))):
            bound = sine.sine_bound(ulps)
            seen = max(self.largest_error(Shader(mode, 15, fuse)) for mode in modes for fuse in (0.0, 0.5))
            self.assertTrue(bound / 2 < seen < bound)

    def test_polynomial(self):
        seen = sine.sine_truncation(np.linspace(0, 1, 20001)[None]).max()
        self.assertTrue(seen < sine.sine_truncation_bound() < 1.05 * seen)

    def test_fails_with_fewer_bits(self):
        self.assertGreater(self.largest_error(Shader("nearest", 16, lost_bits=4)), 2**-19)

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
    NOISES = tuple((kind, dims) for dims, kind in CASES if dims in sums.SHIFT_MAX)

    def check(self, count, parameters):
        """Simulates on random parameters; the largest ratio of an error to its tolerance."""
        worst = 0.0
        for kind, dims in self.NOISES:
            for name, shader in ((name, shader) for name in self.KINDS for shader in shaders(12)):
                for _ in range(count):
                    p, octaves, lacunarity, gain, known = parameters(dims)
                    simulated = shader.octaves(kind, name, p, octaves, lacunarity, gain)
                    error = abs(simulated - exact.octaves(kind, name, p, octaves, lacunarity, gain)).max()
                    tolerance = sums.octave_tolerance(name, proven(kind, dims), max(abs(x).max() for x in p), octaves,
                                                      lacunarity, gain, known)
                    self.assertLessEqual(error, tolerance)
                    worst = max(worst, error / tolerance)
        return worst

    def test_simulated(self):
        rng = np.random.default_rng(10)

        def parameters(dims):
            reach = 2.0 ** rng.integers(0, 12)
            p = rng.uniform(-reach, reach, (dims, 200)).astype(np.float32).astype(float)
            return (list(p), int(rng.integers(1, 7)), to_float(rng.uniform(-3, 3)), to_float(rng.uniform(0, 2)), False)
        self.assertGreater(self.check(1, parameters), 1 / 30)

    def test_simulated_with_exact_positions(self):
        rng = np.random.default_rng(11)

        def parameters(dims):
            return list(rng.integers(-4096, 4096, (dims, 200)) / 256), int(rng.integers(1, 7)), 2.0, 0.5, True
        self.assertGreater(self.check(1, parameters), 1 / 60)

    def test_exact_positions_do_not_hide_inexact_ones(self):
        """A must-fail check: positions that round, promised exact, exceed the tolerance."""
        rng = np.random.default_rng(12)

        def parameters(dims):
            p = rng.uniform(-4096, 4096, (dims, 200)).astype(np.float32).astype(float)
            return list(p), 6, to_float(2.1), 0.5, True
        with self.assertRaises(AssertionError):
            self.check(1, parameters)

    def test_edges(self):
        self.assertEqual(sums.octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, 0, 2.0, 0.5, False), 0)
        self.assertLess(sums.octave_tolerance("fbm", proven(OCTAHEDRAL, 2), 1.0, 200, 2.0, 0.5, False), 2.001)
        self.assertEqual(sums.octave_tolerance("fbm", proven(OCTAHEDRAL, 3), 1.0, 20, 2.0, 1e20, False), math.inf)
        self.assertLess(sums.octave_tolerance("fbm", proven(SINE, 3), 1.0, 200, 2.0, 0.5, False), 3.001)
        with self.assertRaises(ValueError):
            sums.octave_tolerance("fog", proven(OCTAHEDRAL, 2), 1.0, 1, 2.0, 0.5, False)
