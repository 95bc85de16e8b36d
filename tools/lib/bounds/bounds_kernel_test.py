"""Tests of what is proven of simplex noise, of gradients that turn and of curl: the models of docs/contract.md and the
library's text stay within the bounds, and reach a part of them. A wrong constant is noticed."""

import functools
import math
import unittest
from unittest import mock

import numpy as np

from bounds import exact_model as exact
from bounds import gradients, kernel_fixed, kernel_floats, kernel_model, kernels, turns
from bounds.boxes import Boxes, corners
from bounds.fixed_model import ONE
from bounds.gradients import OCTAHEDRAL, UNIT
from bounds.kernels import SIMPLEX, SMOOTH, Offsets, Quantity
from bounds.noises import curl
from bounds.rounded import Body, Rounding, Text, along_axes, roundings, table
from bounds.table import bounds_of
from thorough import in_thorough_runs

NOISES = [("simplex", kernel, False) for kernel in SIMPLEX.values()]
NOISES += [("simplex_smooth", kernel, False) for kernel in SMOOTH.values()]
NOISES += [("simplex_phase", SIMPLEX[dims], True) for dims in (2, 3)]
SLOPES = {"simplex": "simplex_d", "simplex_phase": "simplex_d_phase", "perlin_phase": "perlin_d_phase"}


def proven(noise, dims):
    """The rows of the value and of the derivatives, if it has any."""
    slope = bounds_of(SLOPES[noise], dims, "octahedral", "SLOPE_BOUNDS") if noise in SLOPES else None
    return bounds_of(noise, dims, "octahedral"), slope


def random_phase(rng, count, turning=True):
    return rng.integers(0, 2**30, count) * 4 if turning else None


def random_case(rng, kernel, turning, count):
    """Words of each point, fractions and a phase."""
    words = {tuple(kernel_model.halves(point)): rng.integers(0, 2**32, count) for point in kernel_model.points(kernel)}
    fractions = [rng.integers(0, ONE + 1, count) for _ in range(kernel.dims)]
    return lambda halves: words[tuple(halves)], fractions, random_phase(rng, count, turning)


def largest_differences(computed, expected):
    """Of the values and of the derivatives."""
    (value, along), (exact_value, exact_along) = computed, expected
    return abs(value - exact_value).max(), max(abs(a - b).max() for a, b in zip(along, exact_along))


class Gradients(unittest.TestCase):
    @staticmethod
    def of_library(dims, more):
        bits, first = {2: (18, 14), 3: (17, 15)}[dims]
        words = np.arange(2**bits, dtype=np.int64) << first
        kernel = mock.Mock(dims=dims)
        with mock.patch.object(kernel_model, "more_of", lambda _: more):
            return np.array(kernel_model.lengthened(kernel, words))

    def test_support_is_that_of_the_library(self):
        rng = np.random.default_rng(1)
        for dims, more in ((2, 3 / 8), (2, 1), (3, 1), (3, 2)):
            g = self.of_library(dims, more)
            v = np.concatenate([rng.normal(size=(dims, 60)), np.eye(dims), np.ones((dims, 1))], axis=1)
            reached, h = (g.T @ v).max(axis=0), gradients.directions_support(v, more)
            self.assertLess((reached - h).max(), 1e-14)
            self.assertLess((h - reached).max(), 0.012)  # in space it has some directions more
            longest = np.sqrt((g * g).sum(axis=0)).max()
            self.assertTrue(longest <= gradients.longest(dims, more) + 1e-15 < longest + 1e-3)

    def test_turned_support(self):
        """Of the library's gradients at random angles; for small angles it is nearly reached."""
        rng, g = np.random.default_rng(2), self.of_library(3, 1)
        for angle in (0.0, 0.02, 0.4, 1.1, math.pi / 2):
            v = rng.normal(size=(3, 40))
            moved = np.array(kernel_model.turned(list(g), angle / math.pi * 2**31))
            reached, h = (moved.T @ v).max(axis=0), turns.turned_support(v, np.full(40, angle))
            self.assertLess((reached - h).max(), 1e-12)
            self.assertLess((h / reached).max(), 1.02 if angle < 0.03 else 1.2)


class Exact(unittest.TestCase):
    def searched(self, function, dims, count=600, rounds=40):
        """Nearly the largest of a function of places, by random search near the best few."""
        rng = np.random.default_rng(dims)
        places, reach = rng.uniform(0, 0.5, (dims, 20 * count)), 0.2
        for _ in range(rounds):
            best = places[:, np.argsort(function(places))[-5:]]
            places = np.concatenate([best, np.clip(np.repeat(best, count // 5, axis=1)
                                                   + rng.uniform(-reach, reach, (dims, count)), 0, 0.5)], axis=1)
            reach *= 0.8
        return float(function(places).max())

    @in_thorough_runs
    def test_bounds_are_attained(self):
        """By the library's gradients; a bound a little smaller would be refuted."""
        for kernel in (*SIMPLEX.values(), *SMOOTH.values()):
            support, ones = kernel.gradient.support, (1.0,) * kernel.dims
            for quantity, bound in ((kernels.VALUE, kernels.range_of(kernel, kernel.gradient)),
                                    (Quantity(((0.0,) * (kernel.dims - 1) + (1.0,),)), None),
                                    (Quantity((ones,)), None)):
                bound = bound or kernels.largest(kernel, quantity, kernel.gradient, kernel.dims - 1)
                seen = self.searched(lambda place: kernels.attained(kernel, quantity, support, place), kernel.dims)
                self.assertTrue(0.999 * bound < seen <= bound, (kernel.dims, quantity, seen, bound))

    @in_thorough_runs
    def test_scales_leave_little_room(self):
        for noise, kernel, turning in NOISES:
            exactly = turns.range_of(kernel) if turning else kernels.range_of(kernel, kernel.gradient)
            parts = kernel_fixed.error_parts(kernel, turning, 0.0)
            largest = max(kernel_fixed.without_cut(parts), kernel_floats.error_bound(kernel, turning))
            self.assertLess(exactly * kernel.scale / 1024 + largest, 1, noise)
            self.assertGreater(exactly * (kernel.scale + 2) / 1024, 0.999, noise)
            limits, _ = proven(noise, kernel.dims)
            self.assertEqual((limits.limit, limits.fixed_limit), (1, 1))

    def test_model_is_what_is_bounded(self):
        """The contract's noise is the sum over the kernel's points, and its derivatives are those by differences."""
        rng, step = np.random.default_rng(3), 1e-6
        for noise, kernel, turning in NOISES:
            words, fractions, phase = random_case(rng, kernel, turning, 300)
            f = [x / ONE * 0.49 for x in fractions]
            value, along = kernel_model.simplex(kernel, words, f, phase)
            place, total = np.array(f) * kernel.steps, 0.0
            inside = (place <= 0.5).all(axis=0)
            for point in kernel.points:
                g = kernel_model.turned(kernel_model.lengthened(kernel, words(kernel_model.halves(point))), phase)
                v = kernels.vector(kernel, kernels.VALUE, place - np.array(point)[:, None])
                total = total + sum(np.array(g) * v)
            self.assertLess(abs(total * kernel.scale / 1024 - value)[inside].max(), 1e-12, noise)
            for axis, derivative in enumerate(along):
                moved = [[x + sign * step * (i == axis) for i, x in enumerate(f)] for sign in (1, -1)]
                high, low = (kernel_model.simplex(kernel, words, place, phase)[0] for place in moved)
                rise = (high - low) / (2 * step)
                self.assertLess(abs(rise - derivative).max(), 1e-6, noise)

    def test_second_derivatives(self):
        """Of random gradients, in small boxes: they are within what is assumed."""
        rng, step = np.random.default_rng(4), 1e-4
        for kernel in (*SIMPLEX.values(), *SMOOTH.values()):
            boxes = Boxes(5, rng.integers(0, 16, (kernel.dims, 200)))
            u = (1.0,) * kernel.dims
            for quantity in (kernels.VALUE, Quantity((u,))):
                for point in kernel.points:
                    g = kernel_model.lengthened(kernel, rng.integers(0, 2**32, 200))
                    middle = (boxes.lo + boxes.hi) / 2 - np.array(point)[:, None]

                    def product(d):
                        return sum(np.array(g) * kernels.vector(kernel, quantity, d))
                    offsets = Offsets.of(kernel, boxes, point)
                    for axis, unit in enumerate(np.eye(kernel.dims)):
                        moved = step * unit[:, None]
                        second = (product(middle + moved) + product(middle - moved) - 2 * product(middle)) / step**2
                        bound = kernels.jet(kernel, quantity, kernel.gradient, offsets, axis).second
                        self.assertLess((abs(second) - bound).max(), 1e-4)


class Fixed(unittest.TestCase):
    def errors(self, kernel, turning, count=60_000, seed=5):
        words, fractions, phase = random_case(np.random.default_rng(seed), kernel, turning, count)
        value, along = kernel_model.fixed_simplex(kernel, words, fractions, phase)
        return largest_differences((value / 2**21, [x / 2**19 for x in along]),
                                   kernel_model.simplex(kernel, words, [x / ONE for x in fractions], phase))

    def test_random_points(self):
        for noise, kernel, turning in NOISES:
            seen, seen_slope = self.errors(kernel, turning, 20_000 if kernel.dims == 4 else 60_000)
            value, slope = proven(noise, kernel.dims)
            self.assertTrue(value.fixed_error / 5 < seen < value.fixed_error, (noise, kernel.dims, seen))
            if slope:
                self.assertTrue(slope.fixed_error / 8 < seen_slope < slope.fixed_error, (noise, seen_slope))

    def test_fails_with_another_weight(self):
        """Must-fail checks: a weight of fewer bits, a fall that is a little too large."""
        weight = kernel_model.fixed_weight
        for noise, kernel, turning in NOISES:
            value, slope = proven(noise, kernel.dims)
            with mock.patch.object(kernel_model, "fixed_weight",
                                   lambda k, t: (weight(k, t)[0] & ~1023, weight(k, t)[1])):
                self.assertGreater(self.errors(kernel, turning, 20_000)[0], value.fixed_error, noise)
            if slope:
                with mock.patch.object(kernel_model, "fixed_weight",
                                       lambda k, t: (weight(k, t)[0], weight(k, t)[1] + 1024)):
                    self.assertGreater(self.errors(kernel, turning, 20_000)[1], slope.fixed_error, noise)

    def perlin_errors(self, dims):
        rng = np.random.default_rng(6)
        words = {corner: rng.integers(0, 2**32, 60_000) for corner in corners(dims)}
        fractions, phase = [rng.integers(0, ONE + 1, 60_000) for _ in range(dims)], random_phase(rng, 60_000)
        value, along = kernel_model.fixed_perlin(words.__getitem__, fractions, phase)
        expected = kernel_model.perlin(words.__getitem__, [x / ONE for x in fractions], phase)
        return largest_differences((value / 2**21, [x / 2**19 for x in along]), expected)

    def test_turned_perlin(self):
        """And a must-fail check: a sine that is off."""
        for dims in (2, 3):
            value, slope = proven("perlin_phase", dims)
            seen, seen_slope = self.perlin_errors(dims)
            self.assertTrue(value.fixed_error / 8 < seen < value.fixed_error)
            self.assertTrue(slope.fixed_error / 8 < seen_slope < slope.fixed_error)
            rotation = kernel_model.fixed_rotation
            with mock.patch.object(kernel_model, "fixed_rotation", lambda phase: rotation(phase + 2**20)):
                seen, seen_slope = self.perlin_errors(dims)
            self.assertTrue(seen > value.fixed_error and seen_slope > slope.fixed_error)

    @in_thorough_runs
    def test_curl(self):
        """The contract's products, of random derivatives."""
        rng, (row, slope) = np.random.default_rng(7), (bounds_of("curl", 3, "octahedral"), proven("simplex", 3)[1])
        a, b = rng.uniform(-slope.limit / 2, slope.limit / 2, (2, 2, 50_000))
        n, m = np.round(a * 2**19).astype(np.int64), np.round(b * 2**19).astype(np.int64)

        def prod(x, y):
            return (x >> 9) * (y >> 9) + (((x >> 9) * (y & 511) + (x & 511) * (y >> 9)) >> 9)
        component = ((prod(n[0], m[1]) - prod(n[1], m[0]) + 8) >> 4) / 2**16
        off = abs(component - (n[0] * m[1] - n[1] * m[0]) / 2**38).max()
        self.assertTrue(2.0**-18 < off < 2.0**-17 + 2 * curl.FIXED_PRODUCT)
        self.assertLess(curl.longest_pair()[1], row.limit)
        # At a lattice point the derivatives are the gradients' components times the scale.
        scale, longest = SIMPLEX[3].scale / 1024, gradients.longest(3)
        self.assertTrue(0.998 * row.limit < (scale * longest) ** 2 < row.limit)


@functools.cache
def text():
    """What is asked of the library."""
    ids = [f"noise{dims}d.{name}_cell" for dims in (2, 3, 4)
           for name in ("simplex", "simplex_d", "simplex_smooth", "simplex_phase", "simplex_d_phase", "perlin_phase",
                        "perlin_d_phase")]
    return Text([id for id in ids if id in table()], optimized=True, rotation=ROTATION)


ROTATION = Body("phase:f32", "cosine:f32 sine:f32", "hn_vec2 r = hn_i_rotation(float_of(a.x));"
                "return uvec4(bits_of(r.x), bits_of(r.y), 0u, 0u);")


class Floats(unittest.TestCase):
    """The text of the library over floats of any rounding mode."""

    def errors(self, noise, dims, exactly, turning, some, count=5000):
        """The largest of the value and of the derivatives; `exactly` are those of cells, fractions and phases."""
        rng = np.random.default_rng(8)
        f = list(rng.random((dims, count)).astype(np.float32).astype(float))
        cells = list(rng.integers(-2**31, 2**31, (dims, count)))
        phase = rng.integers(0, 2**24, count) * 256 if turning else None
        expected = exactly(cells, f, phase)
        columns = along_axes("c", cells) | along_axes("f", f) | {"seed": 0}
        if turning:
            columns["phase"] = phase / 2**32
        found = []
        for rounding in some:
            value = text()(f"noise{dims}d.{noise}_cell", rounding, **columns)[0]
            slopes = expected[1]
            if noise in SLOPES:
                slopes = text()(f"noise{dims}d.{SLOPES[noise]}_cell", rounding, **columns)[-dims:]
            found.append(largest_differences((value, slopes), expected))
        return np.max(found, axis=0)

    def of_simplex(self, noise, kernel, turning, some):
        return self.errors(noise, kernel.dims, lambda cells, f, phase: kernel_model.simplex(
            kernel, kernel_model.words_at(kernel, cells), f, phase), turning, some)

    def test_any_rounding(self):
        for noise, kernel, turning in NOISES:
            value, slope = proven(noise, kernel.dims)
            seen, seen_slope = self.of_simplex(noise, kernel, turning, roundings(10))
            self.assertTrue(value.cell_error / 10 < seen < value.cell_error, (noise, kernel.dims, seen))
            if slope:
                self.assertTrue(slope.cell_error / 14 < seen_slope < slope.cell_error, (noise, kernel.dims, seen_slope))

    def test_fails_with_fewer_bits(self):
        """A must-fail check: a mantissa without 5 of its bits."""
        for noise, kernel, turning in NOISES:
            value, slope = proven(noise, kernel.dims)
            seen, seen_slope = self.of_simplex(noise, kernel, turning, [Rounding("nearest", lost_bits=5)])
            self.assertGreater(seen, value.cell_error, noise)
            if slope:
                self.assertGreater(seen_slope, slope.cell_error, noise)

    def test_turned_perlin(self):
        for dims in (2, 3):
            value, slope = proven("perlin_phase", dims)
            for some, fails in ((roundings(13), False), ([Rounding("nearest", lost_bits=6)], True)):
                seen, seen_slope = self.errors("perlin_phase", dims, lambda cells, f, phase: kernel_model.perlin(
                    exact.words_at(OCTAHEDRAL, cells), f, phase), True, some)
                self.assertEqual((seen > value.cell_error, seen_slope > slope.cell_error), (fails, fails))
                self.assertTrue(seen > value.cell_error / 9 and seen_slope > slope.cell_error / 14)


class Turns(unittest.TestCase):
    def test_values_at_angles(self):
        """A search over places and angles; on the plane it nearly reaches the bound, in space at the angle 0."""
        rng = np.random.default_rng(15)
        place = np.concatenate([rng.uniform(0, 0.5, (3, 30_000)), np.zeros((3, 1))], axis=1)
        for dims, kernel in ((2, SIMPLEX[2]), (3, SIMPLEX[3])):
            angle = rng.uniform(0, math.pi, 30_001)
            support = (lambda v: kernel.gradient.support(np.stack(turns.turned(*v, angle)))) if dims == 2 else (
                lambda v: turns.turned_support(v, angle))
            seen = kernels.attained(kernel, kernels.VALUE, support, place[:dims]).max()
            self.assertTrue(0.97 * turns.range_of(kernel) < seen <= turns.range_of(kernel))
            self.assertLessEqual(kernels.range_of(kernel, kernel.gradient), turns.range_of(kernel))
            self.assertLess(turns.range_of(kernel), kernel.longest * kernels.range_of(kernel, UNIT) + 1e-9)

    def test_sine_of_a_phase(self):
        angle = np.random.default_rng(16).integers(0, 2**30, 20_000) * 4
        exactly = np.sin(angle / 2**31 * math.pi)
        for rounding in roundings(17):
            phase = angle >> 8 << 8  # of which a float has all bits
            _, found = text()("rotation", rounding, phase=phase / 2**32)
            self.assertLess(abs(found - np.sin(phase / 2**31 * math.pi)).max(), kernel_floats.turn_error(1.0))
        cosine, sine = kernel_model.fixed_rotation(angle)
        self.assertLess(abs(sine / 2**18 - exactly).max(), kernel_fixed.turn_error())
        self.assertLess(abs(cosine / 2**18 - np.cos(angle / 2**31 * math.pi)).max(), kernel_fixed.turn_error())


if __name__ == "__main__":
    unittest.main()
