"""Tests of what is proven of octave sums with slopes, and of warps: the models of docs/contract.md and of the library's
text stay within the bounds, and reach a part of them. What is left out of a bound, or of a model, is noticed."""

import functools
import itertools
import math
import unittest
from unittest import mock

import numpy as np

from bounds import exact_model as exact
from bounds import fixed_model as fixed
from bounds import frames, frames_model, sums
from bounds.adverse import random_positions
from bounds.float_sums import octave_tolerance
from bounds.floats import to_float
from bounds.gradients import OCTAHEDRAL
from bounds.integers import SLOPE_UNIT, UNIT
from bounds.rounded import Rounding, Text, along_axes, roundings
from bounds.sums import SHIFTS, SLOPED, Sum
from bounds.table import bounds_of, slope_bounds_of
from thorough import in_thorough_runs

DIMS = (2, 3)
KINDS = SLOPED + SHIFTS


def proven(kind, dims):
    """What bounds.inc has of the noise of a sum, and of its derivatives."""
    noise = "value" if kind in SHIFTS else "perlin"
    return bounds_of(noise, dims, "octahedral"), slope_bounds_of(f"{noise}_d", dims)


def tolerances(s, dims, is_fixed):
    """Of each number of a result."""
    noise, slope = proven(s.kind, dims)
    own = frames.TOLERANCES[s.kind][is_fixed](s, noise, slope)
    of_value = (octave_tolerance, sums.fixed_octave_tolerance)[is_fixed]
    return {"fbm_d": [of_value(s, noise)] + [own] * dims, "eroded": [own]}.get(s.kind, [own] * dims)


def whole(s, p):
    return [fixed.whole_of_cell(np.floor(x).astype(np.int64), x - np.floor(x)) if s.from_cell else fixed.whole(x)
            for x in p]


def in_floats(s, result):
    """A fixed one."""
    units = [UNIT, *[SLOPE_UNIT] * 3] if s.kind == "fbm_d" else [UNIT] * 3
    return [x * unit for x, unit in zip(result, units)]


def random_sum(rng, kind, **others):
    """One within the domain of the bounds."""
    s = Sum(kind, **({"p_max": 2.0 ** rng.integers(0, 6), "octaves": int(rng.integers(1, 8)),
                      "lacunarity": to_float(rng.uniform(0, 3)), "gain": to_float(rng.uniform(0, 1)),
                      "strength": to_float(rng.choice((1.0, 16.0, rng.random()))),
                      "amplitude": to_float(rng.choice((0.25, 64.0, rng.random())))} | others))
    return s if frames.is_bounded(s) else random_sum(rng, kind, **others)


class Fixed(unittest.TestCase):
    def check(self, arguments=None, kinds=KINDS, count=1000, seed=1, draws=6, **others):
        """The largest ratio of an error to its tolerance, which it must not exceed, of each kind."""
        rng, worst = np.random.default_rng(seed), dict.fromkeys(kinds, 0.0)
        for kind, dims, _ in itertools.product(kinds, DIMS, range(draws)):
            s = random_sum(rng, kind, **(arguments(rng) if arguments else {}), **others)
            p = random_positions(rng, dims, count, s.p_max)
            result = in_floats(s, frames_model.fixed_sum(s, whole(s, p)))
            expected = frames_model.exact_sum(s, p)
            for computed, x, tolerance in zip(result, expected, tolerances(s, dims, True), strict=True):
                error = abs(computed - x).max()
                self.assertLess(error, tolerance, (s, dims))
                worst[kind] = max(worst[kind], error / tolerance)
            if kind in SHIFTS:
                self.assertLessEqual(np.abs(result).max(), s.amplitude)
        return worst

    def assert_near(self, worst, least):
        self.assertTrue(all(ratio > least for ratio in worst.values()), worst)

    @in_thorough_runs
    def test_simulated(self):
        self.assert_near(self.check(count=2000), 1 / 15)

    def test_first_octave(self):
        self.assert_near(self.check(octaves=1), 1 / 8)

    @in_thorough_runs
    def test_usual_arguments(self):
        """Of 6 octaves, as the tables have them. The worst case of a progressive warp is rare."""
        for kind, least, others in (("fbm_d", 1 / 12, {}), ("eroded", 1 / 20, {"strength": 1.0}),
                                    ("warp", 1 / 8, {"amplitude": 0.5}),
                                    ("warp_progressive", 1 / 30, {"amplitude": 0.25}),
                                    ("warp_progressive", 1 / 150, {"amplitude": 0.5})):
            usual = self.check(kinds=(kind,), octaves=6, lacunarity=2.0, gain=0.5, p_max=16.0, draws=1, count=8000,
                               **others)
            self.assert_near(usual, least)

    def test_with_a_period(self):
        self.assert_near(self.check(lambda rng: {"lacunarity": float(rng.integers(0, 4))}, turns=False), 1 / 15)

    def test_from_a_cell(self):
        self.assert_near(self.check(from_cell=True), 1 / 15)

    @in_thorough_runs
    def test_at_the_ends_of_the_domain(self):
        """Results of 8 and more, of which bits are dropped, and frames and steps that are as large as they may be."""
        for gain, lacunarity, octaves in ((1.0, 1.0, 32), (1.0, 4.0, 3), (0.25, 252.0, 2), (0.75, 1.25, 20)):
            self.check(octaves=octaves, gain=gain, lacunarity=lacunarity, amplitude=64.0 / max(1, gain * lacunarity),
                       p_max=4.0, draws=1)
        self.check(kinds=("warp",), amplitude=64.0, draws=2)

    def test_without_octaves(self):
        for kind, octaves in itertools.product(KINDS, (0, -1)):
            s = Sum(kind, 1.0, octaves, 2.0, 0.5, 1.0, 1.0)
            for is_fixed in (False, True):
                self.assertEqual(tolerances(s, 2, is_fixed), [0.0] * len(tolerances(s, 2, is_fixed)))
            result = frames_model.fixed_sum(s, whole(s, [np.array([0.3]), np.array([0.4])]))
            self.assertEqual([float(x[0]) for x in result], [0.0] * len(result))

    def test_the_domain(self):
        def bounded(kind, *arguments, **others):
            return frames.is_bounded(Sum(kind, 1.0, *arguments, **others))
        self.assertTrue(bounded("fbm_d", 6, 2.0, 1.0) and not bounded("fbm_d", 7, 2.0, 1.0))
        self.assertTrue(bounded("fbm_d", 2, 63.0, 1.0) and not bounded("fbm_d", 2, 64.0, 1.0))
        self.assertTrue(bounded("warp_progressive", 6, 2.0, 1.0, amplitude=8.0))
        self.assertFalse(bounded("warp_progressive", 6, 2.0, 1.0, amplitude=8.1))
        self.assertTrue(bounded("warp", 6, 2.0, 1.0, amplitude=64.0))
        for arguments in ((33, 1.0, 0.5), (2, -1.0, 0.5), (2, 256.0, 0.1), (2, 2.0, 1.5)):
            for kind in KINDS:
                self.assertEqual(tolerances(Sum(kind, 1.0, *arguments, 1.0, 1.0), 2, True)[-1], math.inf)

    def must_fail(self, name, replacement, kinds, **others):
        with mock.patch.object(frames, name, replacement), self.assertRaises(AssertionError):
            self.check(kinds=kinds, draws=3, **others)

    def test_what_is_left_out_is_noticed(self):
        """Of the bounds."""
        self.must_fail("fixed_effects", lambda s, *_: [0.0] * s.count, ("fbm_d",))
        self.must_fail("fixed_fall_errors", lambda s, *_: [0.0] * s.count, ("eroded",), strength=16.0)
        self.must_fail("fixed_shift_effects", lambda s, *_: [0.0] * s.count, ("warp_progressive",))

    def test_a_fault_of_the_model_is_noticed(self):
        """As a fault of the library would be."""
        def transposed(frame, g):
            return shift_through(frame, g)
        def same(cells, seed):
            return words_of_components(cells, seed)[:1] * len(cells)
        shift_through, words_of_components = frames_model.shift_through, frames_model.words_of_components
        for name, fault, kind in (
                ("slopes_through", transposed, "fbm_d"), ("coarse", lambda v: v & ~1023, "fbm_d"),
                ("factor_of_fall", lambda fall, strength: 2**18, "eroded"),
                ("words_of_components", same, "warp"),
                ("turned_frame", lambda rows: [np.array(row) for row in rows], "warp_progressive")):
            # The exact model has the words of its own name.
            own = frames_model.exact_sum
            with mock.patch.object(frames_model, name, fault), self.assertRaises(AssertionError), \
                    mock.patch.object(frames_model, "exact_sum", self.with_words(own)):
                self.check(kinds=(kind,), octaves=4, lacunarity=2.0, gain=0.5, strength=1.0, amplitude=1.0, draws=1)

    @staticmethod
    def with_words(exact_sum, words=frames_model.words_of_components):
        def exactly(s, p):
            with mock.patch.object(frames_model, "words_of_components", words):
                return exact_sum(s, p)
        return exactly


@functools.cache
def text():
    """What is asked of the library."""
    return Text(row_of(kind, dims, form) for kind in KINDS for dims in DIMS for form in ("", "_cell", "_cell_period"))


def row_of(kind, dims, form):
    return f"{'warp' if kind in SHIFTS else 'fbm_d'}.{kind}{dims}{form}"


class Floats(unittest.TestCase):
    """The text of the library over floats of any rounding mode."""

    @staticmethod
    def computed(rounding, s, p):
        """In a tile without a period nothing turns."""
        places, form = along_axes("", p), ""
        if s.from_cell:
            places, form = along_axes("c", map(np.floor, p)) | along_axes("f", [x - np.floor(x) for x in p]), "_cell"
        if not s.turns:
            places, form = places | along_axes("p", [0] * len(p)), "_cell_period"
        settings = {"octaves": s.octaves, "lacunarity": s.lacunarity, "gain": s.gain, "seed": 0}
        if s.kind in SHIFTS:
            settings["amplitude"] = s.amplitude
        elif s.kind == "eroded":
            settings["strength"] = s.strength
        return text()(row_of(s.kind, len(p), form), rounding, **places, **settings)

    def check(self, kinds=KINDS, count=100, seed=2, simulated=None, arguments=None, **others):
        rng, worst = np.random.default_rng(seed), dict.fromkeys(kinds, 0.0)
        for kind, dims, rounding in itertools.product(kinds, DIMS, simulated or roundings(3)):
            s = random_sum(rng, kind, **(arguments(rng) if arguments else {}), **others)
            p = rng.uniform(-s.p_max, s.p_max, (dims, count))
            p = list(np.floor(p) + (p - np.floor(p)).astype(np.float32) if s.from_cell
                     else p.astype(np.float32).astype(float))
            result = self.computed(rounding, s, p)
            for computed, x, tolerance in zip(result, frames_model.exact_sum(s, p), tolerances(s, dims, False),
                                              strict=True):
                error = abs(computed - x).max()
                self.assertLess(error, tolerance, (s, dims))
                worst[kind] = max(worst[kind], error / tolerance)
            if kind in SHIFTS:
                self.assertLessEqual(np.abs(result).max(), s.amplitude)
        return worst

    def assert_near(self, worst, least):
        self.assertTrue(all(ratio > least for ratio in worst.values()), worst)

    @in_thorough_runs
    def test_simulated(self):
        self.assert_near(self.check(), 1 / 60)

    def test_first_octave(self):
        self.assert_near(self.check(octaves=1), 1 / 60)

    @in_thorough_runs
    def test_with_a_period(self):
        self.assert_near(self.check(arguments=lambda rng: {"lacunarity": float(rng.integers(0, 4))}, turns=False,
                                    from_cell=True), 1 / 100)

    @in_thorough_runs
    def test_from_a_cell(self):
        self.assert_near(self.check(from_cell=True, p_max=2.0**16), 1 / 60)

    def test_fails_with_fewer_bits(self):
        fewer = [Rounding("nearest", lost_bits=10)]
        for kind, turns in itertools.product(KINDS, (True, False)):
            with self.subTest(kind=kind, turns=turns), self.assertRaises(AssertionError):
                self.check((kind,), simulated=fewer, octaves=2, lacunarity=2.0, gain=0.5, strength=1.0, amplitude=0.25,
                           p_max=4.0, turns=turns, from_cell=not turns)

    def test_tiny_results(self):
        """HN_PRECISE replaces them by 0."""
        s = Sum("warp", 1.0, 3, 2.0, 0.5, amplitude=2.0**-98)
        self.assertGreaterEqual(tolerances(s, 2, False)[0], 2.0**-98)

    def test_the_domain(self):
        for arguments in ({"lacunarity": 1e20, "octaves": 6}, {"lacunarity": 2.0, "octaves": 20, "gain": 1e20},
                          {"lacunarity": 256.0, "octaves": 2, "from_cell": True}):
            for kind in KINDS:
                s = Sum(kind, 1.0, **({"gain": 1.0, "strength": 1.0, "amplitude": 1.0} | arguments))
                self.assertEqual(tolerances(s, 2, False)[-1], math.inf)


class Steps(unittest.TestCase):
    def test_the_longest_gradient(self):
        """Random ones, and those that are sought near the steepest place, the middle of a cell."""
        rng = np.random.default_rng(4)
        for dims in DIMS:
            f = 0.5 + rng.uniform(-0.5, 0.5, (dims, 200_000)) * rng.random(200_000)
            words = rng.integers(0, 2**32, (2**dims, 200_000))
            of_corner = dict(zip(itertools.product((0, 1), repeat=dims), words))
            for kind, found in (("fbm_d", exact.perlin(OCTAHEDRAL, of_corner.__getitem__, list(f))),
                                ("warp", exact.value(of_corner.__getitem__, list(f)))):
                seen, bound = np.linalg.norm(found[1], axis=0).max(), frames.longest_gradient(*proven(kind, dims))
                self.assertTrue(bound / 2.5 < seen < bound, (dims, kind, seen, bound))

    def test_the_steepest_fall(self):
        r = np.linspace(0, 14, 140_001)
        for strength, reach in itertools.product((0.0, 0.001, 0.3, 1.0, 16.0), (0.1, 1.0, 13.9)):
            inside = r[r <= reach]
            fall = 1 / (1 + strength * inside**2)
            seen, bound = abs(np.diff(fall)).max() / r[1], frames.steepest_fall(strength, reach)
            self.assertTrue(0.99 * bound <= seen <= bound * (1 + 1e-9), (strength, reach, seen, bound))
        self.assertAlmostEqual(frames.steepest_fall(1.0, 9.0), 0.6495, delta=1e-4)

    def test_frames(self):
        """The integers of the bounds are those of the model, and near the exact numbers."""
        rng = np.random.default_rng(5)
        for dims, turns in itertools.product(DIMS, (True, False)):
            s = random_sum(rng, "fbm_d", octaves=7, turns=turns)
            ratio, gain = math.trunc(s.lacunarity * 2**23), math.trunc(s.gain * 2**18)
            frame = [2**18, 0] if dims == 2 else list(np.eye(3, dtype=np.int64) * 2**18)
            for _, found in zip(range(7), frames.fixed_frames(s, dims)):
                column = [row[0] for row in found]
                self.assertEqual(np.array(column if dims == 2 else found).tolist(), np.array(frame).tolist())
                frame = frames_model.next_frame(frame, gain * ratio >> 23, turns)
            for rounded, exactly in frames.frames(s, dims):
                self.assertLess(abs(rounded - exactly).max(), 1e-3)

    def test_nothing_wraps(self):
        for dims in DIMS:
            for name, value in frames.largest_intermediates(dims).items():
                self.assertLess(value, 2**31, (dims, name))
            for name, value in frames.largest_words(dims).items():
                self.assertLess(value, 2**32, (dims, name))
        for limit in ("LARGEST_GROWTH", "LARGEST_SHIFT"):
            with mock.patch.object(frames, limit, 8 * getattr(frames, limit)):
                self.assertGreater(max(frames.largest_intermediates(3).values()), 2**31)

    def test_no_step_wraps(self):
        """The model's own signed steps, at the ends of the domain, with the slopes and vectors that are worst, against
        the bounds, of which they reach a part."""
        bounds, largest = {dims: frames.largest_intermediates(dims) for dims in DIMS}, {}
        for dims, (gain, lacunarity, octaves) in itertools.product(DIMS, (
                (1.0, 63.0, 2), (1.0, 7.45, 3), (1.0, 1.04, 32), (0.25, 252.0, 2), (1.0, 2.0, 6))):
            s = Sum("warp_progressive", 1.0, octaves, lacunarity, gain)
            growth = math.trunc(gain * 2**18) * math.trunc(lacunarity * 2**23) >> 23
            amplitude = min(64.0, 256 / max(1.0, (gain * lacunarity) ** (octaves - 1)))
            self.assertTrue(frames.is_bounded(Sum("warp_progressive", 1.0, octaves, lacunarity, gain, 0.0, amplitude)))

            def record(name, x):
                size = max(int(np.abs(part).max()) for part in x)
                largest[name] = max(largest.get(name, 0), size)
                self.assertLessEqual(size, bounds[dims][name], (s, name))
            ends = [np.array(x) for x in zip(*itertools.product((-1, 1), repeat=dims))]
            frame, slopes = [2**18, 0] if dims == 2 else list(np.eye(3, dtype=np.int64) * 2**18), [0] * dims
            for _ in range(octaves):
                record("frame", [np.array(frame)])
                slopes = [a + abs(x) for a, x in zip(slopes, frames_model.slopes_through(frame,
                                                                                         [x * 2**21 for x in ends]))]
                record("sum of slopes", slopes)
                steps = frames_model.shift_through(frame, [x * 2**21 for x in ends])
                record("step", steps)
                record("step of a position", [x * math.trunc(amplitude * 2**18) >> 18 for x in steps])
                frame = frames_model.next_frame(frame, growth, s.turns)
        for name, size in largest.items():
            self.assertGreater(size, 0.3 * bounds[3][name], name)

    def test_coarse(self):
        v = np.array([2**24 - 1, 2**24, 2**24 + 127, 2**24 + 128, 2**31 - 1, -2**24 - 127, -2**31 + 1])
        self.assertEqual(frames_model.coarse(v).tolist(), [2**24 - 1, 2**24, 2**24, 2**24 + 128, 2**31 - 128, -2**24,
                                                           -2**31 + 128])
        self.assertTrue(all(to_float(float(x)) == x for x in frames_model.coarse(v)))
        self.assertLessEqual(abs(frames_model.coarse(v) - v).max(), frames.COARSE)
