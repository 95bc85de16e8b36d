"""Tests of what is proven of floats, of the noises, their derivatives, the sine and the sums: simulated float
arithmetic, in any rounding mode, stays within the bounds."""

import math
import unittest
from unittest import mock

import numpy as np

from bounds import exact_model as exact
from bounds import fixed_model as fixed
from bounds import float_sums, noises, sine, sums
from bounds.float_model import MODES, Shader, shaders
from bounds.floats import to_float
from bounds.gradients import OCTAHEDRAL, SINE
from bounds.noises import value as value_noise
from bounds.noises import value_cubic
from bounds.noises.perlin import floats as perlin
from bounds.table import bounds_of, slope_bounds_of
from thorough import in_thorough_runs, some

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

    @in_thorough_runs
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
    NOISES = tuple((kind, dims) for dims, kind in CASES)

    def check(self, arguments, kinds=sums.KINDS, spread=None, seed=10, simulated=None):
        """Simulates at random points; the largest ratio of an error to its tolerance, which it must not exceed, of each
        kind. `arguments` draws those of a Sum, `spread` points; from a cell these are cells and fractions."""
        rng, worst = np.random.default_rng(seed), dict.fromkeys(kinds, 0.0)
        for kind, dims in self.NOISES:
            for turn, name in enumerate(kinds, dims):
                for shader in simulated or some(shaders(12), turn, 2):
                    s = sums.Sum(name, **arguments(rng, name))
                    p = (spread or self.spread)(rng, dims, s.p_max)
                    simulated_sum, exact_sum = self.pair(shader, kind, s, p)
                    tolerance = float_sums.octave_tolerance(s, proven(kind, dims))
                    error = abs(simulated_sum - exact_sum).max()
                    self.assertLessEqual(error, tolerance, s)
                    worst[name] = max(worst[name], error / tolerance)
        return worst

    @staticmethod
    def spread(rng, dims, reach):
        return list(rng.uniform(-reach, reach, (dims, 200)).astype(np.float32).astype(float))

    @staticmethod
    def pair(shader, kind, s, p):
        if not s.from_cell:
            return shader.octaves(kind, s, p), exact.octaves(kind, s, p)
        cells, f = np.floor(p).astype(np.int64), p - np.floor(p)
        whole = [fixed.whole_of_cell(*of_axis) for of_axis in zip(cells, f)]
        positions = [position for _, position in zip(range(s.count), fixed.whole_positions(s, whole))]
        places = [(c, [r / 2**24 for r in rests]) for c, rests in positions]
        return shader.octaves(kind, s, p, places), exact.octaves(kind, s, p)

    @staticmethod
    def strength(rng, name):
        return to_float(rng.choice((2.0, 64.0, rng.uniform(0, 4))) if name == "ping_pong" else rng.random())

    def random_sum(self, rng, name, **others):
        return {"p_max": 2.0 ** rng.integers(0, 8), "octaves": int(rng.integers(1, 7)),
                "lacunarity": to_float(rng.uniform(-3, 3)), "gain": to_float(rng.uniform(0, 2)),
                "strength": self.strength(rng, name)} | others

    def assert_near(self, worst, least):
        self.assertTrue(all(ratio > least for ratio in worst.values()), worst)

    @in_thorough_runs
    def test_simulated(self):
        self.assert_near(self.check(self.random_sum), 1 / 100)

    def test_first_octave(self):
        """Where positions are exact: what is left are the steps of the sum. A single octave hardly has any."""
        self.assert_near(self.check(lambda rng, name: self.random_sum(rng, name, octaves=1)), 1 / 15)

    @in_thorough_runs
    def test_with_a_period(self):
        def arguments(rng, name):
            return self.random_sum(rng, name, lacunarity=float(rng.integers(0, 4)), turns=False)
        self.assert_near(self.check(arguments), 1 / 60)

    @in_thorough_runs
    def test_from_a_cell(self):
        def arguments(rng, name):
            return self.random_sum(rng, name, p_max=2.0**20, lacunarity=to_float(rng.uniform(0, 3)), from_cell=True)
        self.assert_near(self.check(arguments), 1 / 60)

    def test_details_and_footprints(self):
        """Octaves that are about to vanish, too."""
        def details(rng, name):
            near = rng.integers(1, 6) + rng.choice((0.0, 2.0**-20, 0.5, rng.random()))
            return self.random_sum(rng, name, octaves=to_float(near))

        def footprints(rng, name):
            return self.random_sum(rng, name, footprint=to_float(rng.random() * 2.0 ** -rng.integers(-1, 8)))
        for arguments in (details, footprints):
            self.assert_near(self.check(arguments, ("fbm",)), 1 / 100)

    @in_thorough_runs
    def test_simulated_with_exact_positions(self):
        def arguments(rng, name):
            return self.random_sum(rng, name, p_max=16.0, lacunarity=2.0, gain=0.5, turns=False, exact_positions=True)

        def spread(rng, dims, reach):
            return list(rng.integers(-reach * 256, reach * 256, (dims, 200)) / 256)
        self.assert_near(self.check(arguments, spread=spread), 1 / 60)

    def must_fail(self, **others):
        """Arguments for which the tolerance of others is taken."""
        with self.assertRaises(AssertionError):
            self.check(lambda rng, name: self.random_sum(rng, name, **others))

    def test_exact_positions_do_not_hide_inexact_ones(self):
        """A must-fail check: positions that round, promised exact, exceed the tolerance."""
        for turns in (True, False):
            self.must_fail(p_max=4096.0, octaves=6, lacunarity=to_float(2.1), gain=0.5, turns=turns,
                           exact_positions=True)

    def test_fails_with_fewer_bits(self):
        """For each kind, in each of its forms."""
        fewer = [Shader("nearest", 7, lost_bits=9)]
        for name in sums.KINDS:
            for others in ({"turns": False, "lacunarity": 2.0}, {"from_cell": True, "lacunarity": 2.0}, {}):
                with self.subTest(name=name, **others), self.assertRaises(AssertionError):
                    self.check(lambda rng, name: self.random_sum(rng, name, gain=0.5, p_max=4.0, octaves=3, **others),
                               (name,), simulated=fewer)

    def test_fails_without_a_step(self):
        """What ping-pong does to the error of a noise is more than an fBm does."""
        with mock.patch.object(float_sums, "rule_of", lambda s: "fbm"):
            with self.assertRaises(AssertionError):
                self.check(lambda rng, name: self.random_sum(rng, name, octaves=1, strength=64.0), ("ping_pong",))

    def test_edges(self):
        def tolerance(octaves, gain=0.5, dims=2, gradient=OCTAHEDRAL, kind="fbm", **others):
            return float_sums.octave_tolerance(sums.Sum(kind, 1.0, octaves, 2.0, gain, **others), proven(gradient, dims))
        self.assertEqual([tolerance(octaves) for octaves in (0, -1, 0.0, -0.5)], [0] * 4)
        self.assertLess(tolerance(200), 2.001)
        self.assertEqual(tolerance(20, 1e20, 3), math.inf)
        self.assertLess(tolerance(200, dims=3, gradient=SINE), 3.001)
        for kind, largest in (("billow", 2.001), ("ridged", 1.001), ("ping_pong", 2.002), ("weighted", 3.01)):
            self.assertLess(tolerance(200, dims=3, gradient=SINE, kind=kind, strength=1.0), largest)
        self.assertEqual(float_sums.octave_tolerance(sums.Sum("fbm", 1.0, 1, 256.0, 0.5, from_cell=True),
                                               proven(OCTAHEDRAL, 2)), math.inf)
        with self.assertRaises(ValueError):
            tolerance(1, kind="fog")
