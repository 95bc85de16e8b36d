"""Tests of the proofs for simplex noise, of gradients that rotate and of curl: the library's text stays within the
bounds, and reaches a part of them. A wrong constant is noticed."""

import functools
import itertools
import math
import unittest
from unittest import mock

import numpy as np

from base.thorough import in_thorough_runs
from proof.bounds import exact_model as exact
from proof.bounds import kernel_model, kernels, rotations
from proof.bounds.boxes import Boxes
from proof.bounds.gradients import LENGTH, OCTAHEDRAL, ROTATED
from proof.bounds.kernels import ROTATING, SIMPLEX, SMOOTH, Offsets, Quantity
from proof.bounds.noises import curl, simplex, simplex_phase
from proof.bounds.rounded import FIXED, Body, Rounding, Text, along_axes, roundings, table
from proof.bounds.table import bounds_of

NOISES = [("simplex", kernel, False) for kernel in SIMPLEX.values()]
NOISES += [("simplex_smooth", kernel, False) for kernel in SMOOTH.values()]
NOISES += [("simplex_phase", kernel, True) for kernel in ROTATING.values()]
SLOPES = {"simplex": "simplex_d", "simplex_phase": "simplex_d_phase", "perlin_phase": "perlin_d_phase"}


def proven(noise, dims):
    """The rows of the value and of the derivatives, if it has any."""
    slope = bounds_of(SLOPES[noise], dims, "octahedral", "SLOPE_BOUNDS") if noise in SLOPES else None
    return bounds_of(noise, dims, "octahedral"), slope


def random_phase(rng, count, rotating=True):
    return rng.integers(0, 2**30, count) * 4 if rotating else None


def random_case(rng, kernel, rotating, count):
    """Words of each point, fractions and a phase."""
    words = {tuple(kernel_model.halves(point)): rng.integers(0, 2**32, count) for point in kernel_model.points(kernel)}
    fractions = list(rng.random((kernel.dims, count)))
    return lambda halves: words[tuple(halves)], fractions, random_phase(rng, count, rotating)


def largest_differences(computed, expected):
    (value, along), (exact_value, exact_along) = computed, expected
    return abs(value - exact_value).max(), max(abs(a - b).max() for a, b in zip(along, exact_along))


def searched(function, dims, count=600, rounds=40):
    """Nearly the largest of a function of places, by random search near the best few."""
    rng = np.random.default_rng(dims)
    places, reach = rng.uniform(0, 0.5, (dims, 20 * count)), 0.2
    for _ in range(rounds):
        best = places[:, np.argsort(function(places))[-5:]]
        places = np.concatenate([best, np.clip(np.repeat(best, count // 5, axis=1)
                                               + rng.uniform(-reach, reach, (dims, count)), 0, 0.5)], axis=1)
        reach *= 0.8
    return float(function(places).max())


class Exact(unittest.TestCase):
    @in_thorough_runs
    def test_bounds_are_attained(self):
        """By the library's gradients; a bound a little smaller would be refuted."""
        for kernel in (*SIMPLEX.values(), *SMOOTH.values()):
            for gradient, quantity in itertools.product((OCTAHEDRAL, ROTATED) if kernel.dims < 4 else (OCTAHEDRAL,), (
                    kernels.VALUE, Quantity(((0.0,) * (kernel.dims - 1) + (1.0,),)), Quantity(((1.0,) * kernel.dims,)))):
                bound = kernels.largest(kernel, quantity, gradient, kernel.dims - 1)
                seen = searched(lambda place: kernels.attained(kernel, quantity, gradient.support, place),
                                kernel.dims)
                self.assertTrue(0.999 * bound < seen <= bound, (kernel.dims, gradient.name, quantity, seen, bound))

    @in_thorough_runs
    def test_scales_leave_little_room(self):
        for noise, kernel, rotating in NOISES:
            derived = simplex_phase.derive(kernel.dims, None) if rotating else simplex.derived_value(kernel)
            self.assertLess(max(derived.largest, derived.fixed_largest), 1, noise)
            # On the plane simplex noise has the scale of that whose gradients rotate. In 4D the scale could be 4301 of
            # 1024 and is 4298: the bound is tighter than it was when the scale was chosen, and the values stay.
            if noise != "simplex" or kernel.dims > 2:
                steps = 4 if kernel.dims == 4 else 2
                self.assertGreater(derived.fixed_largest + steps / kernel.scale, 1, noise)
            limits, _ = proven(noise, kernel.dims)
            self.assertEqual((limits.limit, limits.fixed_limit), (1, 1))

    def test_model_is_what_is_bounded(self):
        """The contract's noise is the sum over the kernel's points, and its derivatives are those by differences."""
        rng, step = np.random.default_rng(3), 1e-6
        for noise, kernel, rotating in NOISES:
            words, fractions, phase = random_case(rng, kernel, rotating, 300)
            f = [x * 0.49 for x in fractions]
            value, along = kernel_model.simplex(kernel, words, f, phase)
            place, total = np.array(f) * kernel.steps, 0.0
            inside = (place <= 0.5).all(axis=0)
            for point in kernel.points:
                g = kernel_model.gradients(kernel.dims, words(kernel_model.halves(point)), phase)
                v = kernels.vector(kernel, kernels.VALUE, place - np.array(point)[:, None])
                total = total + sum(np.array(g) * v)
            self.assertLess(abs(total * kernel.scale / 1024 - value)[inside].max(), 1e-12, noise)
            for axis, derivative in enumerate(along):
                moved = [[x + sign * step * (i == axis) for i, x in enumerate(f)] for sign in (1, -1)]
                high, low = (kernel_model.simplex(kernel, words, place, phase)[0] for place in moved)
                rise = (high - low) / (2 * step)
                self.assertLess(abs(rise - derivative).max(), 1e-6, noise)

    def test_second_derivatives(self):
        """Random gradients in small boxes are within the assumptions."""
        rng, step = np.random.default_rng(4), 1e-4
        for kernel in (*SIMPLEX.values(), *SMOOTH.values()):
            boxes = Boxes(5, rng.integers(0, 16, (kernel.dims, 200)))
            u = (1.0,) * kernel.dims
            for quantity in (kernels.VALUE, Quantity((u,))):
                for point in kernel.points:
                    g = exact.gradient(OCTAHEDRAL, kernel.dims, rng.integers(0, 2**32, 200))
                    middle = (boxes.lo + boxes.hi) / 2 - np.array(point)[:, None]

                    def product(d):
                        return sum(np.array(g) * kernels.vector(kernel, quantity, d))
                    offsets = Offsets.of(kernel, boxes, point)
                    for axis, unit in enumerate(np.eye(kernel.dims)):
                        moved = step * unit[:, None]
                        second = (product(middle + moved) + product(middle - moved) - 2 * product(middle)) / step**2
                        bound = kernels.jet(kernel, quantity, OCTAHEDRAL, offsets, axis).second
                        self.assertLess((abs(second) - bound).max(), 1e-4)


@functools.cache
def text(*macros):
    """The calls of the library."""
    ids = [f"noise{dims}d.{name}_cell" for dims in (2, 3, 4)
           for name in ("simplex", "simplex_d", "simplex_smooth", "simplex_phase", "simplex_d_phase", "perlin_phase",
                        "perlin_d_phase")]
    return Text([id for id in [*ids, "curl.curl3_cell"] if id in table()], *macros, optimized=True,
                **({} if macros else {"rotation": ROTATION}))


ROTATION = Body.of("phase:f32", "cosine:f32 sine:f32", "hn_vec2 r = hn_i_rotation(float_of(a.x));"
                "return uvec4(bits_of(r.x), bits_of(r.y), 0u, 0u);")


class Errors:
    """The errors of the library's text with these macros."""
    MACROS: tuple[str, ...] = ()

    def errors(self, noise, dims, exactly, rotating, some, count=5000):
        """The largest of the value and of the derivatives; `exactly` are for cells, fractions and phases."""
        rng = np.random.default_rng(8)
        f = list(rng.random((dims, count)).astype(np.float32).astype(float))
        cells = list(rng.integers(-2**31, 2**31, (dims, count)))
        phase = rng.integers(0, 2**24, count) * 256 if rotating else None
        expected = exactly(cells, f, phase)
        columns = along_axes("c", cells) | along_axes("f", f) | {"seed": 0}
        if rotating:
            columns["phase"] = phase / 2**32
        found = []
        for rounding in some:
            value = text(*self.MACROS)(f"noise{dims}d.{noise}_cell", rounding, **columns)[0]
            slopes = expected[1]
            if noise in SLOPES:
                slopes = text(*self.MACROS)(f"noise{dims}d.{SLOPES[noise]}_cell", rounding, **columns)[-dims:]
            found.append(largest_differences((value, slopes), expected))
        return np.max(found, axis=0)

    def of_simplex(self, noise, kernel, rotating, some, count=5000):
        return self.errors(noise, kernel.dims, lambda cells, f, phase: kernel_model.simplex(
            kernel, kernel_model.words_at(kernel, cells), f, phase), rotating, some, count)

    def of_perlin(self, dims, some, count=5000):
        return self.errors("perlin_phase", dims, lambda cells, f, phase: kernel_model.perlin(
            exact.words_at(OCTAHEDRAL, cells), f, phase), True, some, count)


class Floats(Errors, unittest.TestCase):
    """Floats in any rounding mode."""

    def test_any_rounding(self):
        for noise, kernel, rotating in NOISES:
            value, slope = proven(noise, kernel.dims)
            seen, seen_slope = self.of_simplex(noise, kernel, rotating, roundings(10))
            self.assertTrue(value.cell_error / 10 < seen < value.cell_error, (noise, kernel.dims, seen))
            if slope:
                self.assertTrue(slope.cell_error / 14 < seen_slope < slope.cell_error, (noise, kernel.dims, seen_slope))

    def test_fails_with_fewer_bits(self):
        """A must-fail check: a mantissa without 5 of its bits."""
        for noise, kernel, rotating in NOISES:
            value, slope = proven(noise, kernel.dims)
            seen, seen_slope = self.of_simplex(noise, kernel, rotating, [Rounding("nearest", lost_bits=5)])
            self.assertGreater(seen, value.cell_error, noise)
            if slope:
                self.assertGreater(seen_slope, slope.cell_error, noise)

    def test_rotated_perlin(self):
        # In space the proof takes both sums to be off as far as they may, to opposite sides: it is less tight there.
        for dims, part, slope_part in ((2, 9, 14), (3, 12, 16)):
            value, slope = proven("perlin_phase", dims)
            for some, fails in ((roundings(13), False), ([Rounding("nearest", lost_bits=6)], True)):
                seen, seen_slope = self.of_perlin(dims, some)
                self.assertEqual((seen > value.cell_error, seen_slope > slope.cell_error), (fails, fails))
                self.assertTrue(seen > value.cell_error / part and seen_slope > slope.cell_error / slope_part)


class Fixed(Errors, unittest.TestCase):
    MACROS = (FIXED,)

    def of_all(self, count):
        """The proven bound, and the largest error."""
        for noise, kernel, rotating in NOISES:
            yield proven(noise, kernel.dims), self.of_simplex(noise, kernel, rotating, [Rounding("nearest")], count)
        for dims in (2, 3):
            yield proven("perlin_phase", dims), self.of_perlin(dims, [Rounding("nearest")], count)

    def test_random_points(self):
        for bounds, seen in self.of_all(20_000):
            for bound, error in zip(bounds, seen):
                if bound:
                    self.assertTrue(bound.fixed_error / 9 < error < bound.fixed_error, (bound, error))

    def test_fails_with_another_weight(self):
        """A must-fail check: exact weights that are a little larger, for both kinds of noise."""
        weight, fade = kernel_model.weight, exact.fade
        with mock.patch.object(kernel_model, "weight", lambda k, t: [(1 + 2**-8) * n for n in weight(k, t)]), \
                mock.patch.object(exact, "fade", lambda f: (1 + 2**-8) * fade(f)):
            for bounds, seen in self.of_all(5000):
                for bound, error in zip(bounds, seen):
                    if bound:
                        self.assertGreater(error, bound.fixed_error, bound)


EDGES = np.array([edge for edge in itertools.product((-1.0, 0.0, 1.0), repeat=3) if np.dot(edge, edge) == 2])


class Curl(unittest.TestCase):
    KERNEL = SIMPLEX[3]
    SCALE = KERNEL.scale / 1024

    def rise(self, d, u):
        """The vector whose product with a gradient is the derivative along u, at the offset d; and of a gradient, its
        derivatives."""
        w, slope = kernel_model.weight(self.KERNEL, np.maximum(1 - 2 * (d * d).sum(axis=0), 0.0))
        return w * u - 4 * slope * (u * d).sum(axis=0) * d

    def farthest(self, move, place, u):
        """The derivatives, per cell, of the gradients for which the one along u is largest: axes by places by
        directions. `u` is the same, or is another one at each place."""
        total = 0.0
        for point in curl.points_of(self.KERNEL, move):
            d = (place - point[:, None])[..., None]
            g = EDGES[np.tensordot(EDGES, self.rise(d, u), 1).argmax(axis=0)]
            total = total + self.rise(d, g.transpose(2, 0, 1))
        return self.SCALE * total

    def reached(self, place):
        """The largest component of these gradients."""
        found = 0.0
        for i, j in curl.AXES:
            a = self.farthest((0.0,) * 3, place, curl.directions((i, j), 0.0, 32)[:, None])
            turned = np.zeros(a.shape)
            turned[i], turned[j] = -a[j], a[i]
            b = self.farthest(curl.MOVE, place, turned)
            found = np.maximum(found, (a[i] * b[j] - a[j] * b[i]).max(axis=1))
        return found

    def reached_sum(self, place):
        """The largest of two components of both gradients."""
        found = 0.0
        for i, j in curl.AXES:
            u = np.zeros((3, 1, 2))
            u[i], u[j] = 1.0, (1.0, -1.0)
            lengths = sum(abs(self.farthest(move, place, u)[[i, j]]).sum(axis=0).max(axis=1)
                          for move in ((0.0,) * 3, curl.MOVE))
            found = np.maximum(found, lengths)
        return found

    def test_bounds_are_nearly_attained(self):
        # The product of the largest derivatives along two directions is of gradients in other directions than these.
        limit = bounds_of("curl", 3, "octahedral").limit
        self.assertTrue(0.995 * limit < searched(self.reached, 3, 20, 20) < limit)
        largest = curl.largest_sum()
        self.assertTrue(0.998 * largest < searched(self.reached_sum, 3, 20, 20) < largest)

    def test_without_the_move_it_would_be_more(self):
        with mock.patch.object(curl, "MOVE", (0.0,) * 3):
            at_a_point = self.reached(np.zeros((3, 1)))[0]
        self.assertAlmostEqual(at_a_point, (self.SCALE * LENGTH[3])**2)
        self.assertGreater(at_a_point, 1.4 * bounds_of("curl", 3, "octahedral").limit)

    def test_symmetries(self):
        """The largest product of derivatives along two directions is the same at symmetrical places."""
        rng, around = np.random.default_rng(11), [point for half in (0.0, 0.5) for point in
                                                  np.array(list(itertools.product(range(-1, 3), repeat=3))) + half]
        move = np.array(curl.MOVE)

        def slope(place, u):
            return curl.along(self.KERNEL, around, (place % 1)[:, None], u[:, None])[0, 0]

        def product(place, u, v):
            return slope(place, u) * slope(place + move, v)

        exchange = np.array(((0, 1, 0), (1, 0, 0), (0, 0, -1)))
        for _ in range(5):
            place, u, v = rng.uniform(0, 1, 3), *rng.normal(size=(2, 3))
            expected = product(place, u, v)
            for of in (np.diag((-1, 1, 1)), np.diag((1, -1, 1)), exchange):
                self.assertAlmostEqual(product(of @ place, of @ u, of @ v), expected)
            self.assertAlmostEqual(product(place + 0.5, u, -v), expected)
            self.assertAlmostEqual(product(-place - move, v, u), expected)
            for no_symmetry in (np.diag((1, 1, -1)), abs(exchange)):
                self.assertNotAlmostEqual(product(no_symmetry @ place, no_symmetry @ u, no_symmetry @ v), expected)

    def test_second_derivatives(self):
        """Random gradients along random directions, in small boxes, are within the assumptions."""
        rng, step = np.random.default_rng(12), 1e-4
        boxes = Boxes(5, rng.integers(0, 16, (3, 200)))
        middle, angle = (boxes.lo + boxes.hi) / 2, rng.uniform(0, math.pi, 200)
        both = curl.both(self.KERNEL)
        edges = [[EDGES[rng.integers(0, 12, 200)].T for _ in points] for points in both]

        def product(place, angle):
            return math.prod(
                sum((g * self.rise(place - point[:, None], u)).sum(axis=0)
                    for g, point in zip(gradients, points))
                for gradients, points, u in zip(edges, both, (
                    np.stack([np.zeros(200), np.cos(angle), np.sin(angle)]),
                    np.stack([np.zeros(200), -np.sin(angle), np.cos(angle)]))))
        jets = [a * b for a, b in zip(*(curl.jets(self.KERNEL, points, boxes) for points in both))]
        for axis, bound in enumerate((*(jet.second for jet in jets), 2 * jets[0].value)):
            moved = step * np.eye(4)[axis][:, None]
            second = (product(middle + moved[:3], angle + moved[3]) + product(middle - moved[:3], angle - moved[3])
                      - 2 * product(middle, angle)) / step**2
            self.assertLess((abs(second) - bound).max(), 1e-4)
            self.assertGreater((abs(second) / bound).max(), 0.01)

    def errors(self, some, *macros, count=5000):
        """The largest of the library's text."""
        rng = np.random.default_rng(13)
        f = rng.random((3, count)).astype(np.float32).astype(float)
        cells = rng.integers(-2**31, 2**31, (3, count))
        following = f >= 1 - np.array(curl.MOVE)[:, None]
        moved = f + np.array(curl.MOVE)[:, None] - following
        a, b = (np.array(kernel_model.simplex(self.KERNEL, kernel_model.words_at(self.KERNEL, at, seed), place)[1])
                for at, place, seed in ((cells, f, 0), (cells + following, moved, exact.mix(np.int64(0x9E3779B9)))))
        expected = np.cross(a, b, axis=0)
        columns = along_axes("c", cells) | along_axes("f", f) | {"seed": 0}
        return max(abs(np.array(text(*macros)("curl.curl3_cell", rounding, **columns)) - expected).max()
                   for rounding in some)

    def test_errors(self):
        row = bounds_of("curl", 3, "octahedral")
        for some, macros, bound, part in ((roundings(14), (), row.cell_error, 25),
                                          ([Rounding("nearest")], (FIXED,), row.fixed_error, 12)):
            self.assertTrue(bound / part < self.errors(some, *macros) < bound)
        self.assertGreater(self.errors([Rounding("nearest", lost_bits=6)]), row.cell_error)

    def test_products_of_integers(self):
        """The contract's, of random derivatives."""
        rng, slope = np.random.default_rng(7), proven("simplex", 3)[1]
        a, b = rng.uniform(-slope.limit / 2, slope.limit / 2, (2, 2, 50_000))
        n, m = np.round(a * 2**19).astype(np.int64), np.round(b * 2**19).astype(np.int64)

        def prod(x, y):
            return (x >> 9) * (y >> 9) + (((x >> 9) * (y & 511) + (x & 511) * (y >> 9)) >> 9)
        component = ((prod(n[0], m[1]) - prod(n[1], m[0]) + 8) >> 4) / 2**16
        off = abs(component - (n[0] * m[1] - n[1] * m[0]) / 2**38).max()
        self.assertTrue(2.0**-18 < off < 2.0**-17 + 2 * curl.FIXED_PRODUCT)


class Rotations(unittest.TestCase):
    def test_support(self):
        """No gradient at many phases is beyond the support, and nearly all of it is reached."""
        rng = np.random.default_rng(15)
        for dims in (2, 3):
            words = np.arange(0, 2**32, 2**20)
            g = np.concatenate([kernel_model.gradients(dims, words, phase) for phase in range(0, 2**32, 2**25)], axis=1)
            v = np.concatenate([rng.normal(size=(dims, 60)), np.eye(dims), np.ones((dims, 1))], axis=1)
            reached, h = (g.T @ v).max(axis=0), ROTATED.support(v)
            self.assertLess((reached - h).max(), 1e-14)
            self.assertGreater((reached / h).min(), 0.998)
            self.assertAlmostEqual(np.sqrt((g * g).sum(axis=0)).max(), LENGTH[dims])

    def test_what_is_added_is_of_the_same_set(self):
        words = np.random.default_rng(16).integers(0, 2**32, 2000)
        for dims in (2, 3):
            g = np.array(exact.gradient(OCTAHEDRAL, dims, words))
            other = np.array(exact.rotated(dims, words, 1 / 4 if dims == 2 else 1 / 6)).round(12)
            self.assertEqual(*({tuple(abs(column)) for column in some.T} for some in (g, other)))
            self.assertLess(abs((g * other).sum(axis=0) - (dims == 3)).max(), 1e-11)

    def test_shares_of_two_sums(self):
        angle = np.linspace(0, 2 * math.pi, 721)
        for dims in (2, 3):
            b = rotations.LARGEST_SHARE[dims] * np.sin(angle)
            a = np.cos(angle) - (b / 2 if dims == 3 else 0)
            self.assertAlmostEqual((abs(a) + abs(b)).max(), rotations.IN_SUM[dims])
            self.assertAlmostEqual(max(abs(a).max(), abs(b).max()), rotations.LARGEST_SHARE[dims])

    def test_errors_of_two_sums(self):
        """Two sums that are off as far as they may, a cosine and a sine that are, and in space their results:
        one of them is nearly off by the bound."""
        rng = np.random.default_rng(17)
        angle, part = rng.uniform(0, 2 * math.pi, (2, 100_000))
        n, quarter = np.cos(part), np.sin(part)
        for dims, error, off, round_b, round_a in ((2, 1e-4, 1e-6, 0, 0), (2, 1e-6, 1e-4, 0, 0), (3, 1e-4, 1e-6, 0, 0),
                                                   (3, 1e-6, 1e-4, 0, 0), (3, 1e-7, 1e-7, 1e-4, 0),
                                                   (3, 1e-7, 1e-7, 0, 1e-4), (3, 1e-5, 1e-5, 1e-5, 1e-5)):
            signs = rng.choice((-1, 1), (6, 100_000))
            a, b, m = np.cos(angle) + off * signs[0], np.sin(angle) + off * signs[1], quarter
            if dims == 3:
                b, m = 2 / math.sqrt(3) * b + round_b * signs[4], (n + math.sqrt(3) * quarter) / 2
                a = a - b / 2 + round_a * signs[5]
            seen = abs(a * (n + error * signs[2]) + b * (m + error * signs[3])
                       - np.cos(angle) * n - np.sin(angle) * quarter).max()
            bound = rotations.moved(dims, error, off, 1.0, math.sqrt(3) / 2 * round_b + round_a)
            # All at once is seldom the worst of each.
            self.assertTrue((0.75 if round_a and round_b else 0.95) * bound < seen <= bound, (dims, error, off))

    def test_rounding_of_shares(self):
        """In integers of all sines, and in floats of the worst of them."""
        s = np.arange(-2**16, 2**16 + 1)
        for c in (0, 12345, 65535):
            b = 4 * s + ((s * 20277) >> 15)
            off_b = b - 8 / math.sqrt(3) * s
            off_a = 4 * c - (b >> 1) - (4 * c - b / 2)
            seen = (math.sqrt(3) / 2 * abs(off_b) + abs(off_a)).max() / 2**18
            self.assertTrue(0.8 * rotations.fixed_rounding(3) < seen <= rotations.fixed_rounding(3))
        sine = np.sin(np.linspace(0, 2 * math.pi, 100_000)).astype(np.float32)
        for factor in (rotations.FACTOR, np.nextafter(np.float32(rotations.FACTOR), np.float32(2))):
            b = np.float32(factor) * sine
            cosine = np.sqrt(1 - sine.astype(float) ** 2).astype(np.float32)
            a = cosine - np.float32(0.5) * b
            off_b, off_a = b - 2 / math.sqrt(3) * sine.astype(float), a - (cosine.astype(float) - b.astype(float) / 2)
            seen = (math.sqrt(3) / 2 * abs(off_b) + abs(off_a)).max()
            self.assertLess(seen, rotations.float_rounding(3))
        self.assertGreater(seen, rotations.float_rounding(3) / 3)

    def test_sine_of_a_phase(self):
        angle = np.random.default_rng(16).integers(0, 2**30, 20_000) * 4
        for rounding in roundings(17):
            phase = angle >> 8 << 8  # a float has all its bits
            _, found = text()("rotation", rounding, phase=phase / 2**32)
            self.assertLess(abs(found - np.sin(phase / 2**31 * math.pi)).max(), rotations.float_error())


if __name__ == "__main__":
    unittest.main()
