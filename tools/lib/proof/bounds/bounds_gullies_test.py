"""Tests of how far hn_gullies may be off: the text of the library, over floats that round in any direction and over
integers, stays within the bounds, and reaches a part of them. Bounds that are too small are noticed."""

import functools
import itertools
import math
import unittest
from dataclasses import fields, replace

import numpy as np

from proof.bounds import gullies, gullies_model, kernel_model
from proof.bounds.float_sums import gullies_tolerance
from proof.bounds.noises.phasor import KERNELS
from proof.bounds.rounded import FIXED, Body, Rounding, Text, along_axes, roundings
from proof.bounds.sums import Sum
from proof.bounds.table import read_gullies

BODY = Body.of(
    "cx:i32 cy:i32 fx:f32 fy:f32 footprint:f32 ex:f32 ey:f32 octaves:i32 lacunarity:f32 gain:f32 depth:f32",
    "value:f32 dx:f32 dy:f32",
    "hn_place2 place = hn_place(ivec2(int(a.x), int(a.y)), vec2(float_of(a.z), float_of(a.w)));"
    "vec3 n = hn_gullies(place, float_of(b.x), vec2(float_of(b.y), float_of(b.z)), int(b.w), float_of(c.x),"
    "                    float_of(c.y), float_of(c.z), 0u);"
    "return uvec4(bits_of(n.x), bits_of(n.y), bits_of(n.z), 0u);")


@functools.cache
def text(*macros):
    return Text([], *macros, optimized=True, gullies=BODY)


def a_sum(octaves, lacunarity=2.0, gain=0.5, footprint=None):
    return Sum("fbm", 0.0, octaves, lacunarity, gain, footprint=footprint, rotates=False, from_cell=True)


def places(seed, count):
    """Cells and fractions; some are multiples of few bits."""
    rng = np.random.default_rng(seed)
    f = np.where(rng.random(count) < 0.5, rng.random((2, count)), rng.integers(0, 65, (2, count)) / 64)
    return list(rng.integers(-2**20, 2**20, (2, count))), f.astype(np.float32).astype(float)


def slopes(seed, count, steep):
    """Slopes about as long as that, or shorter where it is 0: flat ground."""
    rng = np.random.default_rng(seed)
    angle, size = rng.uniform(0, 2 * np.pi, count), steep * rng.uniform(0.99, 1.0, count) + 1e-3 * (steep == 0)
    return (size * [np.cos(angle), np.sin(angle)]).astype(np.float32).astype(float)


def computed(rounding, s, slope, depth, cells, f, *macros):
    columns = along_axes("c", cells) | along_axes("f", f) | along_axes("e", slope) | {
        "footprint": s.footprint or 0.0, "octaves": s.octaves, "lacunarity": s.lacunarity, "gain": s.gain,
        "depth": depth}
    return np.array(text(*macros)("gullies", rounding, **columns))


SUMS = (a_sum(1), a_sum(2), a_sum(3), a_sum(5), a_sum(3, 3.0, 0.25), a_sum(2, 1.0, 1.0), a_sum(3, footprint=1 / 16))
CASES = tuple((s, depth, steep) for i, (s, depth, steep) in enumerate(itertools.product(
    SUMS, (0.01, 0.1, 0.5), (0.0, 0.125, 1.0, 3.0, 8.0))) if i % 3 == 0)  # each sum with each depth and steepness
COUNT = 300


@functools.cache
def exactly(case, seed):
    """The slope, the place, and what gullies there are."""
    s, depth, steep = case
    (cells, f), slope = places(seed, COUNT), slopes(seed, COUNT, steep)
    return slope, cells, f, gullies_model.exact_gullies(s, slope, depth, cells, f)


def ratios(case, seed, found, tolerance_of):
    """The largest errors of the height and of a slope, over their tolerances."""
    s, depth, _ = case
    slope, _, _, expected = exactly(case, seed)
    errors, size, worst = abs(np.array(found) - expected), np.hypot(*np.clip(slope, -8, 8)), np.zeros(2)
    for i in (np.argmax(errors[0]), np.argmax(errors[1:].max(axis=0))):
        tolerance = tolerance_of(s, size[i], depth)
        worst = np.maximum(worst, [errors[0, i] / tolerance[0], errors[1:, i].max() / tolerance[1]])
    return worst


class Bounds(unittest.TestCase):
    def test_of_waves(self):
        """Nothing at random places is steeper, or rotates faster, than proven; and it comes near."""
        rng, bounds, count, kernel = np.random.default_rng(1), read_gullies(), 4000, KERNELS[2]
        words = {tuple(kernel_model.halves(point)): rng.integers(0, 2**32, count)
                 for point in kernel_model.points(kernel)}
        f, angle, other = rng.random((2, count)), *rng.uniform(0, 2 * np.pi, (2, count))
        f[:, :1000] = rng.normal(0, 0.05, (2, 1000)) % 1
        k, step = 1.5 * np.array([np.cos(angle), np.sin(angle)]), 1e-6 * np.array([np.cos(other), np.sin(other)])

        def at(wave):
            results = kernel_model.phasor_d(kernel, lambda point: words[tuple(point)], f, wave, np.zeros(count))
            return results[0].real, np.array([g.real for g in results[1:]])
        (v, g), (rotated_v, rotated_g) = at(k), at(k + step)
        for seen, bound in ((np.hypot(*g), bounds.steepest), (abs(rotated_v - v) / 1e-6, bounds.wave_rate),
                            (np.hypot(*(rotated_g - g)) / 1e-6, bounds.slope_wave_rate)):
            self.assertTrue(0.4 * bound < seen.max() < bound, (seen.max(), bound))

    def test_they_are_those_of_short_waves(self):
        bounds = read_gullies()
        self.assertLess(bounds.value, 1e-5)
        self.assertLess(bounds.slope, 2e-4)


def smaller(times):
    proven = read_gullies()
    return replace(proven, **{field.name: getattr(proven, field.name) / times for field in fields(proven)})


class Floats(unittest.TestCase):
    @staticmethod
    def worst(rounding, bounds=None):
        """The largest ratio of an error to its tolerance, of heights and of slopes."""
        def of(case):
            slope, cells, f, _ = exactly(case, 1)
            found = computed(rounding, case[0], slope, case[1], cells, f)
            return ratios(case, 1, found, lambda *at: gullies_tolerance(*at, bounds or read_gullies()))
        return np.max([of(case) for case in CASES], axis=0)

    def test_text(self):
        for rounding in roundings(7):
            worst = self.worst(rounding)
            self.assertTrue((worst < 1).all() and (worst > 1 / 30).all(), (rounding, worst))

    def test_fails_with_fewer_bits(self):
        """A must-fail check: a mantissa without 6 of its bits."""
        worst = self.worst(Rounding("nearest", lost_bits=6))
        self.assertTrue((worst > 1).all(), worst)

    def test_smaller_bounds_are_noticed(self):
        """A must-fail check: of the errors of waves, and of how fast these change."""
        worst = np.max([self.worst(rounding, smaller(32)) for rounding in roundings(9)[1::2]], axis=0)
        self.assertGreater(worst.max(), 1)

    def test_growth(self):
        """From octave to octave, by less on steep ground; and no further than to the ends."""
        bounds = read_gullies()
        steep, flat = ([gullies_tolerance(a_sum(n), r, 0.1, bounds) for n in range(1, 12)] for r in (3.0, 0.0))
        for tolerances in (steep, flat):
            for a, b in zip(tolerances, tolerances[1:]):
                self.assertTrue(a[0] <= b[0] and a[1] <= b[1])
        self.assertLess(steep[3][1], flat[3][1] + 1)
        self.assertLessEqual(gullies_tolerance(a_sum(30), 1.0, 8.0, bounds)[1], 16.00001)
        self.assertLessEqual(gullies_tolerance(a_sum(30), 1.0, 8.0, bounds)[0], 2 * 8 * 2.00001)
        self.assertEqual(gullies_tolerance(a_sum(5), 1.0, 0.0, bounds), (0, 0))
        self.assertEqual(gullies_tolerance(a_sum(0), 1.0, 1.0, bounds), (0, 0))


class Fixed(unittest.TestCase):
    @staticmethod
    def worst(bounds):
        def of(case):
            slope, cells, f, _ = exactly(case, 1)
            found = computed(Rounding("nearest"), case[0], slope, case[1], cells, f, FIXED)
            return ratios(case, 1, found, lambda *at: gullies.fixed_tolerance(*at, bounds))
        return np.max([of(case) for case in CASES], axis=0)

    def test_random_points(self):
        worst = self.worst(read_gullies())
        self.assertTrue((worst < 1).all() and (worst > 1 / 30).all(), worst)

    def test_smaller_bounds_are_noticed(self):
        """A must-fail check."""
        self.assertTrue((self.worst(smaller(32)) > 1).any())

    def test_the_domain(self):
        bounds = read_gullies()
        for s, depth in ((a_sum(33), 0.1), (a_sum(3, 300.0), 0.1), (a_sum(3, gain=1.5), 0.1),
                         (a_sum(7, 2.0, 1.0), 2.0)):
            self.assertEqual(gullies.fixed_tolerance(s, 1.0, depth, bounds), (math.inf, math.inf))
        self.assertLess(gullies.fixed_tolerance(a_sum(6, 2.0, 1.0), 1.0, 2.0, bounds)[0], math.inf)


if __name__ == "__main__":
    unittest.main()
