"""Tests of what is proven of the steps of fixed arithmetic, that nothing wraps, and of its octave sums. They are
simulated from docs/contract.md."""

import math
import unittest
from unittest import mock

import numpy as np

from base.thorough import THOROUGH, in_thorough_runs
from proof.bounds import command, integers, noises, sine, steps, sums
from proof.bounds import exact_model as exact
from proof.bounds import fixed_model as fixed
from proof.bounds.adverse import adverse_words, changes, random_fractions, random_positions
from proof.bounds.boxes import Boxes, corners
from proof.bounds.fixed_model import ONE
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.noises import value as value_noise
from proof.bounds.noises.perlin import fixed as perlin
from proof.bounds.table import bounds_of

CASES = noises.find("perlin").CASES
DIMS = (1, 2, 3, 4)


def proven(kind, dims):
    """What bounds.inc has of hn_perlin."""
    return bounds_of("perlin", dims, kind.name)


class Integers(unittest.TestCase):
    def test_fade_and_slope(self):
        f = np.arange(ONE + 1, dtype=np.int64)
        self.assertTrue(np.array_equal(fixed.fade(f), integers.fades()))
        self.assertTrue(np.array_equal(fixed.slope(f), integers.slopes()))
        self.assertEqual([fixed.fade(f)[i] for i in (0, 2**19, ONE)], [0, 2**17 - 4, 2**18])
        self.assertEqual([fixed.slope(f)[i] for i in (0, ONE)], [0, 0])

    def test_halves_are_mirrored(self):
        """Half of the cell is enough for FADE."""
        errors = np.delete(integers.fade_errors() + integers.fade_errors()[::-1], ONE // 2)
        self.assertLess(abs(errors).max(), 1e-15)
        self.assertTrue(np.array_equal(integers.slopes(), integers.slopes()[::-1]))

    def test_lerp_roundings(self):
        rng = np.random.default_rng(7)
        a, b = rng.integers(-2**29, 2**29, (2, 300_000))
        f = rng.integers(0, ONE + 1, 300_000)
        t = fixed.fade(f)
        error = a + (b - a) * t / 2**18 - fixed.lerp(a, b, t)
        allowed = integers.lerp_roundings()[f]
        self.assertTrue((error <= allowed + 1e-6).all() and (error >= -1e-6 - (t < 0) * allowed).all())
        self.assertGreater((error / np.maximum(allowed, 1)).max(), 0.95)

    @in_thorough_runs
    def test_effects_hold_in_boxes(self):
        """FADE of random fractions with their errors, against the bounds of the boxes that they are in."""
        rng = np.random.default_rng(11)
        for dims, level in ((1, 6), (2, 5), (3, 4), (4, 4)):
            fractions = rng.integers(0, ONE // 2 + 1, (dims, 2000))
            boxes = Boxes(level, np.minimum(fractions >> (20 - level), 2 ** (level - 1) - 1))
            change = changes(list(fractions))
            offsets = {corner: fractions / ONE - np.array(corner)[:, None] for corner in corners(dims)}
            value = sum(abs(change(corner)[0]) * OCTAHEDRAL.support(d) for corner, d in offsets.items())
            first = np.eye(dims)[0][:, None]
            slope = sum(OCTAHEDRAL.support(change(corner)[1] * d + change(corner)[0] * first)
                        for corner, d in offsets.items())
            for seen, bound in ((value, integers.fade_effect(boxes, OCTAHEDRAL)),
                                (slope, integers.slope_fade_effect(boxes, OCTAHEDRAL))):
                self.assertLess((seen - bound).max(), 0)
                self.assertGreater((seen / bound).max(), 0.3)
            self.assertLess(value.max(), integers.largest_fade_effect(dims, OCTAHEDRAL))
            self.assertLess(slope.max(), integers.largest_slope_fade_effect(dims, OCTAHEDRAL))

    def test_nothing_wraps(self):
        """By default of two noises: docs/accuracy.md quotes the largest of all noises, which tools/make bounds
        --check compares."""
        for key in command.keys() if THOROUGH else [("perlin_d", 3, OCTAHEDRAL), ("cellular", 3, None)]:
            for name, value in noises.find(key[0]).largest_intermediates(*key[1:]).items():
                self.assertLess(value, 2**31, (key, name))
        for dims, kind in CASES:
            for name, value in sums.largest_octave_intermediates(proven(kind, dims).fixed_limit).items():
                self.assertLess(value, 2**31, (kind.name, dims, name))
        largest = perlin.largest_slope_intermediates(3, 4.0)
        self.assertGreater(largest["derivative's lerp"], 0.9 * 2**31)  # not absurdly far

    def test_wrapping_is_noticed(self):
        with self.assertRaises(OverflowError):
            integers.signed(np.array([2**31]))
        with self.assertRaises(OverflowError):
            integers.word(np.array([-1]))
        with mock.patch.dict(perlin.RAMP_ONE, {OCTAHEDRAL: {2: 2**31, 3: 2**30}}):
            self.assertGreater(perlin.largest_intermediates(2, OCTAHEDRAL)["difference"], 2**31)
            self.assertGreater(perlin.largest_slope_intermediates(3, 4.0)["derivative's difference"], 2**31)
        with mock.patch.object(value_noise, "NUMBER_ONE", 2**31):
            self.assertGreater(value_noise.largest_intermediates(2, None)["difference"], 2**31)

    def test_the_model_does_not_wrap(self):
        """A signed step of the model that wrapped would be far off; here each is compared with its own wide integer."""
        rng, largest = np.random.default_rng(12), [0]

        def recorded(x):
            largest[0] = max(largest[0], int(np.abs(x).max()))
            return exact.s32(x)
        with mock.patch.object(fixed, "s32", recorded):
            for dims in DIMS:
                fractions = random_fractions(rng, dims, 10_000)
                steep = adverse_words(rng, OCTAHEDRAL, fractions,
                                      lambda corner, d: [(1 - 2 * (sum(corner) % 2)) * x for x in d])
                fixed.perlin(OCTAHEDRAL, steep, fractions, derivatives=True)
                ends = {corner: rng.choice((0, 2**32 - 1), 10_000) for corner in corners(dims)}
                fixed.value(ends.__getitem__, fractions)
        self.assertTrue(2**30 < largest[0] < 2**31)

    def test_ramps_reach_their_bound(self):
        for dims in DIMS:
            words = np.arange(2**14, dtype=np.int64) << 18 if dims > 1 else np.array([511 << 14])
            ramps = fixed.ramp_of(fixed.of_words(dims, words), [np.array([ONE])] * dims)
            self.assertEqual(ramps.max(), OCTAHEDRAL.reach(dims) * fixed.RAMP_ONE[dims])

    def test_differences_reach_their_bound(self):
        """Of ramps in space, and what is interpolated of them along x, at places that are whole along z."""
        rng = np.random.default_rng(13)
        x, y = rng.random((2, 100_000))
        x[0], y[0] = 0.5, 0.0
        s, ones = exact.fade(x), np.ones(len(x))

        def both(a):
            return OCTAHEDRAL.support([a, y, ones]) + OCTAHEDRAL.support([a, 1 - y, ones])
        for seen, bound in (((1 - s) * both(x) + s * both(1 - x), perlin.LARGEST_DIFFERENCE[3]),
                            (15 / 8 * (both(x) + both(1 - x)) + 2, perlin.LARGEST_DERIVATIVES_DIFFERENCE[3])):
            self.assertTrue(0.99 * bound < seen.max() <= bound + 1e-12, (seen.max(), bound))
        largest = perlin.largest_intermediates(3, OCTAHEDRAL)
        self.assertGreater(largest["difference"], perlin.LARGEST_DIFFERENCE[3] * 2**29)

    def test_where_a_difference_of_ramps_wraps(self):
        """At corners without a weight: what it is then does not matter."""
        f = np.array([ONE // 3, ONE, ONE - 1]), np.array([ONE, ONE, ONE - 1]), np.array([ONE, ONE, ONE])
        words = {corner: np.array([0xFFE00000 if corner[0] else 0xAAAAAAAA & ~(3 << 21)] * 3) for corner in corners(3)}
        wrapped = fixed.perlin(OCTAHEDRAL, words.__getitem__, f, True)
        with mock.patch.object(fixed, "lerp", lambda a, b, t: a + fixed.part(b - a, t)), \
                mock.patch.object(fixed, "rise", lambda a, b: (b - a) >> 2), \
                mock.patch.object(fixed, "part", lambda d, t: (d >> 9) * (t >> 9) + (d >> 18) * (t & 511)):
            wide = fixed.perlin(OCTAHEDRAL, words.__getitem__, f, True)
        self.assertEqual(wrapped[0].tolist(), wide[0].tolist())
        self.assertEqual(np.array(wrapped[1]).tolist(), np.array(wide[1]).tolist())

    def test_sine(self):
        w = np.random.default_rng(8).integers(0, 2**32, 1_000_000)
        value = fixed.sine(w) / 2**16
        error = abs(value - np.sin(exact.sine_argument(w).astype(float))).max()
        self.assertTrue(0.9 * sine.fixed_sine_error() < error < sine.fixed_sine_error())
        self.assertLessEqual(abs(value).max(), sine.fixed_sine_largest())

    def test_clouds(self):
        v = np.arange(-2**21, 2**21 + 1)
        t = np.clip(2 * v / 2**21 + 0.25, 0, 1)
        error = abs(fixed.clouds(v) / 2**21 - t * t * (3 - 2 * t)).max()
        self.assertTrue(0.9 * sums.cloud_error() < error < sums.cloud_error())
        self.assertEqual((fixed.clouds(v).min(), fixed.clouds(v).max()), (0, 2**21))


class Octaves(unittest.TestCase):
    def check(self, arguments, kinds=sums.KINDS, count=1000, seed=9):
        """The largest ratio of an error to its tolerance, which it must not exceed, of each kind; `arguments` draws
        those of a Sum."""
        rng, worst = np.random.default_rng(seed), dict.fromkeys(kinds, 0.0)
        for dims, kind in CASES:
            for name in kinds:
                s = sums.Sum(name, **arguments(rng, name))
                p = random_positions(rng, dims, count, s.p_max)
                if s.exact_positions:
                    p = [np.round(x * 2**9) / 2**9 for x in p]
                start = fixed.whole
                if s.from_cell:
                    def start(x):
                        return fixed.whole_of_cell(np.floor(x).astype(np.int64), x - np.floor(x))
                value = fixed.octaves(kind, s, [start(x) for x in p]) / 2**21
                error = abs(value - exact.octaves(kind, s, p)).max()
                tolerance = sums.fixed_octave_tolerance(s, proven(kind, dims))
                self.assertLess(error, tolerance, s)
                worst[name] = max(worst[name], error / tolerance)
                self.assertLessEqual(abs(value).max(), proven(kind, dims).fixed_limit)
                self.assertTrue(name not in ("turbulence", "clouds", "ridged") or value.min() >= 0)
        return worst

    def random_sum(self, rng, name, **others):
        strength = rng.choice((2, 64, 3 * rng.random())) if name == "ping_pong" else rng.random()
        return {"p_max": 2.0 ** rng.integers(2, 8), "octaves": int(rng.integers(1, 9)),
                "lacunarity": float(np.float32(rng.uniform(0, 4))), "gain": float(np.float32(rng.random())),
                "strength": float(np.float32(strength))} | others

    def assert_near(self, worst, least):
        self.assertTrue(all(ratio > least for ratio in worst.values()), worst)

    @in_thorough_runs
    def test_simulated(self):
        self.assert_near(self.check(self.random_sum, count=4000), 1 / 12)

    def test_first_octave(self):
        self.assert_near(self.check(lambda rng, name: self.random_sum(rng, name, octaves=1)), 1 / 6)

    @in_thorough_runs
    def test_far_out(self):
        """Where floats have lost the fraction: the last octave at 2^18, with a lacunarity that is no float near it."""
        self.check(lambda rng, name: self.random_sum(rng, name, octaves=9, lacunarity=float(np.float32(2.1)), gain=0.5,
                                                     p_max=1024.0))

    def test_from_a_cell(self):
        self.check(lambda rng, name: self.random_sum(rng, name, from_cell=True))

    @in_thorough_runs
    def test_with_a_period(self):
        def arguments(rng, name, **others):
            return self.random_sum(rng, name, turns=False, lacunarity=float(rng.integers(0, 4)), **others)
        self.check(arguments)
        self.check(lambda rng, name: arguments(rng, name, p_max=16.0, exact_positions=True))

    def test_details_and_footprints(self):
        def details(rng, name):
            near = rng.integers(1, 9) + rng.choice((0.0, 2.0**-19, 0.5, rng.random()))
            return self.random_sum(rng, name, octaves=float(np.float32(near)))

        def footprints(rng, name):
            return self.random_sum(rng, name, footprint=float(np.float32(rng.random() * 2.0 ** -rng.integers(-1, 8))))
        for arguments in (details, footprints):
            for seed in range(3):
                self.check(arguments, ("fbm",), seed=seed)

    def test_what_is_left_out_is_noticed(self):
        """Must-fail checks: positions that are cut, promised exact; and what a step does to the error of a noise."""
        with self.assertRaises(AssertionError):
            self.check(lambda rng, name: self.random_sum(rng, name, octaves=9, lacunarity=3.99, gain=1.0, strength=64.0,
                                                         exact_positions=True), ("fbm", "ping_pong"))
        with mock.patch.object(sums, "fixed_terms", lambda s, errs: errs), self.assertRaises(AssertionError):
            self.check(lambda rng, name: self.random_sum(rng, name, octaves=1, strength=64.0), ("ping_pong",))

    def test_ridges(self):
        """An error of every d, at its worst: the bound of r is reached but for a factor, and what does not count that
        it grows from octave to octave is exceeded."""
        rng, size, count = np.random.default_rng(4), 2.0**-8, 6
        d = rng.random((count, 500_000)) * (1 - size)
        d[0] *= 2.0 ** -rng.uniform(0, 4, d.shape[1])
        d[1:] = 1 - size - d[1:] * rng.choice((0.0, 0.05, 1.0), d.shape[1])
        r, moved, bounds = 0.5, 0.5, steps.Ridge().fixed_errors([size - steps.WEIGHT_UNIT] * count, 0.0, 0.0)
        for of_octave, bound in zip(d, bounds):
            r, moved = (x**2 * np.minimum(2 * before, 1) for x, before in ((of_octave, r), (of_octave + size, moved)))
            self.assertTrue(bound / 4 < (moved - r).max() < bound)
        self.assertGreater((moved - r).max(), 2 * size)

    def test_cut_arguments(self):
        for arguments in ((2, 256.0, 0.5), (2, -1.0, 0.5), (2, 2.0, 1.5), (33, 2.0, 0.5), (32.5, 2.0, 0.5)):
            tolerance = sums.fixed_octave_tolerance(sums.Sum("fbm", 1.0, *arguments), proven(OCTAHEDRAL, 2))
            self.assertEqual(tolerance, math.inf)
        self.assertEqual(sums.fixed_octave_tolerance(sums.Sum("fbm", 1.0, 0, 2.0, 0.5), proven(OCTAHEDRAL, 2)), 0)

    def test_weights(self):
        for gain in (0.0, 0.3, 0.5, 0.999, 1.0):
            for octaves in (32, 31.75, 1.5, 1, 0.5):
                s = sums.Sum("fbm", 1.0, octaves, 2.0, gain)
                self.assertEqual(fixed.octave_weights(s), sums.fixed_weights(s))
        for footprint in (0.0, 1 / 300, 0.2, 0.5, 0.7, 1.5, 3.0):
            s = sums.Sum("fbm", 1.0, 12, 1.9, 0.5, footprint=footprint)
            self.assertEqual([fade for _, fade in zip(range(12), fixed.fades(s))], sums.fixed_fades(s))

    def test_products_are_rounded_down(self):
        rng = np.random.default_rng(3)
        a, b = np.append(rng.integers(0, 2**18 + 1, (2, 100_000)), [[2**18, 2**18, 511], [2**18, 511, 2**18]], axis=1)
        self.assertTrue(np.array_equal(fixed.product(a, b), a * b >> 18))
        for x, y in zip(a[-1000:].tolist(), b[-1000:].tolist()):
            self.assertEqual(sums.product(x, y), x * y >> 18)

    def test_no_step_wraps(self):
        """Each signed step of the sums, compared with its own wide integer, of values at the ends."""
        largest = []

        def recorded(x):
            largest.append(int(np.abs(x).max()))
            return exact.s32(x)
        ends = np.array([-2**21, -2**21 + 1, -1, 0, 1, 2**21 - 1, 2**21])
        wide = np.append(ends, [-3 * 2**20, 3 * 2**20])
        weights = np.array([0, 1, 511, 512, 2**17 + 511, 2**18 - 1, 2**18])[:, None]
        with mock.patch.object(fixed, "s32", recorded):
            fixed.weighted(wide, weights)
            fixed.product(weights, weights.T)
            for strength in (0.0, 1.0, 1.998, 63.999, 64.0):
                fixed.ping_pong(ends, strength)
        bound = max(sums.largest_octave_intermediates(1.5).values())
        self.assertTrue(0.74 * 2**31 < max(largest) <= bound < 2**31, (max(largest), bound))
        self.assertGreater(max(sums.largest_octave_intermediates(2.1).values()), 2**31)

    def test_parts_of_a_turn(self):
        """25 X - 20 Y of fractions of up to 2^24, and of what is left of cells, are what they are bounded by."""
        r, m = np.array([0, 2**24]), np.array([0, 31])
        largest = sums.largest_octave_intermediates(1.0)
        for part, name in ((r, "turn"), (m, "rest of a turn")):
            made = [a * part[:, None] + b * part for a, b in ((25, -20), (20, 25), (29, -13), (13, 29))]
            self.assertEqual(max(abs(x).max() for x in made), largest[name])

    def test_ping_pong_of_every_strength(self):
        """The integer's triangle wave is the exact one, at the ends of its periods as well."""
        v = np.unique(np.append(np.arange(-2**21, 2**21 + 1, 997), [-2**21 + 1, -1, 0, 1, 2**21 - 1, 2**21]))
        for strength in (0.0, 0.3, 1.0, 2.0, 3.7, 63.9999, 64.0, 100.0, -1.0):
            strength = float(np.float32(strength))
            t = (v / 2**21 + 1) * min(max(strength, 0), 64) % 2
            s = sums.Sum("ping_pong", 1.0, 1, 2.0, 0.5, strength)
            error = abs(fixed.ping_pong(v, strength) / 2**21 - (2 * np.minimum(t, 2 - t) - 1)).max()
            self.assertLessEqual(error, sums.fixed_terms(s, [0.0])[0])
