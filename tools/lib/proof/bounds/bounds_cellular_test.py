"""Tests of the proofs for cellular noise: blocks of cells that are one smaller are refuted, ranges are nearly
attained, and the text of the library stays within the bounds."""

import functools
import itertools
import math
import unittest
from fractions import Fraction

import numpy as np

from base.thorough import in_thorough_runs, some
from proof.bounds import borders, distances, features, moving
from proof.bounds import cellular_model as model
from proof.bounds.exact_model import lattice_word
from proof.bounds.noises import cell_border
from proof.bounds.rounded import FIXED, Rounding, Text, along_axes, roundings
from proof.bounds.sine import fixed_sine, fixed_sines
from proof.bounds.table import bounds_of, slope_bounds_of
from proof.oracle import noises as oracle
from proof.oracle.gradients import Knobs

DIMS = (2, 3)
COUNT = {2: 3000, 3: 800}


NEAREST = Rounding("nearest")
SEED = 7


def proven(noise, dims):
    return bounds_of(noise, dims, "none")


# --- The text of the library ------------------------------------------------------------------------------------------

@functools.cache
def text(*macros):
    ids = [f"noise{dims}d.{name}_cell_full" for dims in DIMS for name in (
        "cellular", "cellular_three", "cellular_d", "cellular_smooth", "cell_border")]
    return Text([*ids, *(f"noise{dims}d.cellular_phase_cell_{form}" for dims in DIMS for form in ("period", "offset"))],
                *macros, optimized=True)


class Results:
    """The text's results at places of cells."""

    def __init__(self, rounding, home, f, jitter, phase=None, *macros):
        self.rounding, self.macros, self.dims = rounding, macros, len(f)
        self.columns = (along_axes("c", home) | along_axes("f", f) | along_axes("p", [0] * len(f))
                        | {"jitter": jitter, "seed": SEED} | ({} if phase is None else {"phase": phase}))

    def of(self, name, **others):
        return np.array(text(*self.macros)(f"noise{self.dims}d.{name}", self.rounding, **self.columns, **others))

    def nearest(self, metric, name="cellular_three"):
        return self.of(f"{name}_cell_full", metric=1 + model.METRICS.index(metric))


def words_around(home, reach=2):
    """The cells around others, and their words."""
    cells = list(itertools.product(range(-reach, reach + 1), repeat=len(home)))
    return cells, np.array([lattice_word([h + o for h, o in zip(home, c)], np.int64(SEED)) for c in cells])


def homes(rng, dims, count, touching, of=100_000):
    """Cells: so many have a point that nearly touches the next one's along x: the nearest of many."""
    home = rng.integers(-2**31, 2**31, (dims, of))
    own, other = (model.directions(dims, lattice_word([home[0] + step, *home[1:]], np.int64(SEED))) for step in (0, 1))
    gap = np.linalg.norm((other - own) / 1024 + np.eye(dims)[0][:, None], axis=0)
    return np.concatenate([home[:, np.argsort(gap)[:touching]], home[:, :count - touching]], axis=1)


class Blocks(unittest.TestCase):
    def test_the_neighbours_have_the_two_nearest(self):
        for dims in DIMS:
            self.assertEqual(features.not_proven(features.neighbours(dims), dims, 2), [])

    def test_with_a_slab_they_have_the_third(self):
        for dims in DIMS:
            block = features.neighbours(dims) | features.slab(dims, 0)
            self.assertEqual(features.not_proven(block, dims, 3), [])

    def test_fails_for_smaller_blocks(self):
        """Without any one cell; without the slab, or with one along another axis; and for 2^n cells, even for the
        nearest point alone."""
        for dims in DIMS:
            block = features.neighbours(dims)
            for cell in block:
                self.assertIn(cell, features.not_proven(block - {cell}, dims, 2))
            for cell in features.slab(dims, 0):
                self.assertIn(cell, features.not_proven((block | features.slab(dims, 0)) - {cell}, dims, 3))
            self.assertTrue(features.not_proven(block, dims, 3))
            self.assertTrue(features.not_proven(block | features.slab(dims, 1), dims, 3))
            corner = frozenset(itertools.product((0, 1), repeat=dims))
            self.assertTrue(features.not_proven(corner, dims, 1))

    def test_no_other_point_is_nearer_than_1(self):
        for dims in DIMS:
            block = features.neighbours(dims)
            self.assertEqual(features.not_beyond(block, dims), [])
            for cell in block:
                self.assertIn(cell, features.not_beyond(block - {cell}, dims))

    def test_random_points_agree(self):
        """In all metrics, for any jitter: the nearest of 5^n cells are in the block."""
        rng = np.random.default_rng(31)
        for dims in DIMS:
            cells, words = model.words_of_cells(rng, dims, COUNT[dims])
            f = -np.sort(-rng.uniform(0.5, 1, (dims, COUNT[dims])), axis=0)
            f[0, ::3] = 1.0
            points = model.Exact(cells, words, f, rng.choice((0.0, 0.3, 1.0), COUNT[dims]))
            block = np.array([max(map(abs, c)) <= 1 for c in cells])
            slab = block | np.array([c in features.slab(dims, 0) for c in cells])
            seen = False
            for metric in model.METRICS:
                every = model.distance(metric, points.offsets)
                of_all, of_block, of_slab = (np.sort(part, axis=0)[:3] for part in (every, every[block], every[slab]))
                self.assertLess(abs(of_all[:2] - of_block[:2]).max(), 1e-15)
                self.assertLess(abs(of_all - of_slab).max(), 1e-15)
                seen |= bool((of_all[2] < of_block[2]).any())
            self.assertTrue(seen)  # so the slab is needed

    @in_thorough_runs
    def test_borders_on_the_plane(self):
        """The proven bound is tight: with smaller boxes it is 0.028, which takes a minute. 3^n cells have more."""
        wrong, _ = borders.prove(borders.block(2), 2, 5, 6)
        self.assertLess(wrong, 0.09)
        wrong, smaller = (borders.prove(cells, 2, 4, 5)[0] for cells in (borders.block(2), features.neighbours(2)))
        self.assertTrue(wrong < 0.17 and smaller > 0.23)

    @in_thorough_runs
    def test_borders_are_searched(self):
        """In space only this proves that the block is large enough. It finds the faults of the 3^n cells, and of blocks
        without
        one of the slabs."""
        for dims, count, steps in ((2, 1200, 8), (3, 300, 3)):
            block = borders.block(dims)
            self.assertLess(borders.search(block, dims, 12, count, steps), 1e-9)
            missed = borders.search(features.neighbours(dims), dims, 20, count, steps)
            self.assertGreater(missed, 0.05)
            self.assertGreater(borders.search(block - features.slab(dims, 1), dims, 20, count, steps), missed / 2)


class Borders(unittest.TestCase):
    def test_a_climb(self):
        """It finds the page's number, and more than the largest borders that are known of the library."""
        known = {2: ((-567291, 57828), (0.5342983, 0.7685160), 233433071),
                 3: ((974166, -68968, 352045), (0.5813425, 0.4050027, 0.2685761), 2892670609)}
        for dims, place in known.items():
            seen = float(oracle.find("cell_border").exact_cell(Knobs("lattice", False), *place)[0])
            self.assertTrue({2: 0.702, 3: 0.618}[dims] < seen < cell_border.CLIMBED[dims])
            climbed = borders.climb(dims)
            self.assertTrue(cell_border.CLIMBED[dims] <= climbed < cell_border.CLIMBED[dims] + 0.01)
            self.assertLess(climbed, features.largest_border(dims))


class Ranges(unittest.TestCase):
    def test_distances_to_octahedra(self):
        """The farthest places of octahedra, in a grid."""
        rng = np.random.default_rng(33)
        for dims in DIMS:
            grid = np.array(list(itertools.product(np.linspace(-0.5, 0.5, 41), repeat=dims)))
            grid = grid[abs(grid).sum(axis=1) <= 0.5 + 1e-12]
            for _ in range(30):
                cell, place = rng.integers(-2, 3, dims), rng.uniform(-0.5, 0.5, (dims, 1))
                off = (place.T - cell - grid).T
                least = features.nearest(tuple(cell), place)[0]
                self.assertTrue(least - 1e-12 < model.distance("euclidean", off).min() < least + 0.03)
                for metric in model.METRICS:
                    most = features.farthest(tuple(cell), place, metric)[0]
                    self.assertAlmostEqual(model.distance(metric, off).max(), most, delta=1e-9)

    def test_known_ends(self):
        for dims in DIMS:
            known = {1: ((dims + 3) / 4) ** 0.5, 2: 1.5, 3: 2.5**0.5}
            for count, end in known.items():
                found = features.largest_distance(dims, count)
                self.assertTrue(end <= found < end * 1.0001)

    @in_thorough_runs
    def test_random_points_are_within(self):
        rng = np.random.default_rng(34)
        for dims in DIMS:
            cells, words = model.words_of_cells(rng, dims, COUNT[dims])
            points = model.Exact(cells, words, model.fractions(rng, dims, COUNT[dims]), 1.0)
            for metric in model.METRICS:
                largest = points.nearest(metric).max(axis=1)
                for count in (1, 2, 3):
                    end = features.largest_distance(dims, count, metric)
                    self.assertTrue(0.5 * end < largest[count - 1] <= end)
            border, apart = points.border()
            self.assertTrue(0.4 < border.max() <= features.largest_border(dims))
            self.assertGreaterEqual(apart.min(), distances.APART[dims])
            self.assertGreater(points.smooth().min(), 1 - (features.largest_weights(dims) + 1 / 4096) ** 0.25)
            self.assertTrue(2 <= features.largest_weights(dims) < 4)
            within = (model.distance("euclidean", points.offsets) < 1).sum(axis=0).max()
            self.assertTrue(within <= features.most_within(dims))

    def test_directions_do_not_reach_the_corners(self):
        words = np.arange(2**18, dtype=np.int64) << 14
        for dims in DIMS:
            self.assertEqual(abs(model.directions(dims, words)).max() / 512, distances.LARGEST_COMPONENT[dims])
            self.assertEqual(abs(model.directions(dims, words)).sum(axis=0).max(), 512)
            self.assertEqual(len(model.direction(dims, words)), dims)


class Errors(unittest.TestCase):
    def places(self, rng, dims):
        """Cells, fractions and jitters."""
        jitter = rng.choice((1.0, 0.0, float(np.float32(0.7))), COUNT[dims], p=(0.8, 0.05, 0.15))
        jitter = np.where(rng.random(COUNT[dims]) < 0.3, rng.random(COUNT[dims]).astype(np.float32), jitter)
        return homes(rng, dims, COUNT[dims], COUNT[dims] // 4), model.fractions(rng, dims, COUNT[dims]), jitter

    def compared(self, exact, found):
        """The bounds, and the largest error of each: a noise, and whether it is a derivative."""
        for name in ("cellular", "cellular_three"):
            pairs = [(exact.nearest(m), found.nearest(m, name)) for m in model.METRICS]
            yield name, max(abs(a[:len(b)] - b).max() for a, b in pairs)
        yield "cellular_smooth", abs(exact.smooth() - found.of("cellular_smooth_cell_full")).max()
        yield "cell_border", abs(exact.border()[0] - found.of("cell_border_cell_full")).max()
        first, second, _ = exact.nearest("euclidean")
        value, *unit = found.of("cellular_d_cell_full")
        yield "cellular_d", abs(first - value).max()
        own, _ = exact.of_nearest()
        clear = (second - first > 2.0**-12) & (first > 0)
        off = abs(np.array(unit) - own / np.maximum(first, 1e-30)).max(axis=0)
        yield "slope", (np.where(off < 2, off, np.inf) * first)[clear].max()

    def largest(self, dims, simulated, seed, *macros):
        home, f, jitter = self.places(np.random.default_rng(seed), dims)
        exact, worst = model.Exact(*words_around(home), f, jitter), {}
        for rounding in simulated:
            for name, error in self.compared(exact, Results(rounding, home, f, jitter, None, *macros)):
                worst[name] = max(worst.get(name, 0.0), float(error))
        return worst

    def check(self, worst, dims, kind, least):
        for name, error in worst.items():
            bounds = slope_bounds_of("cellular_d", dims) if name == "slope" else proven(name, dims)
            bound = getattr(bounds, kind)
            self.assertTrue(bound * least[name] < error < bound, (name, dims, error, bound))

    def test_floats(self):
        """Borders are compared with a bound for points that nearly touch, which points of hashes seldom do."""
        least = {"cellular": 1 / 15, "cellular_three": 1 / 15, "cellular_smooth": 1 / 30, "cell_border": 1 / 8000,
                 "cellular_d": 1 / 12, "slope": 1 / 30}
        for dims in DIMS:
            self.check(self.largest(dims, some(roundings(35), dims, 3), 36), dims, "cell_error", least)

    def test_fails_with_fewer_bits(self):
        for dims in DIMS:
            worst = self.largest(dims, [Rounding("nearest", lost_bits=8)], 38)
            for name in ("cellular", "cellular_three", "cellular_smooth", "cellular_d", "slope"):
                bounds = slope_bounds_of("cellular_d", dims) if name == "slope" else proven(name, dims)
                self.assertGreater(worst[name], bounds.cell_error, (name, dims))

    def test_fixed(self):
        """Half of the bound of a distance is exceeded: it is a place 2^-14 from a point."""
        least = {"cellular": 1 / 2, "cellular_three": 1 / 2, "cellular_smooth": 1 / 10, "cell_border": 1 / 4000,
                 "cellular_d": 1 / 2, "slope": 1 / 5}
        for dims in DIMS:
            worst = self.largest(dims, [NEAREST], 39, FIXED)
            for name in ("cellular", "cellular_three", "cellular_d"):
                worst[name] = max(worst[name], self.near_points(dims))
            self.check(worst, dims, "fixed_error", least)

    @staticmethod
    def near_points(dims):
        """The largest error at places near their point: at 0 jitter, near the middle of a cell."""
        f = 0.5 + np.zeros((dims, 2000))
        f[0] += np.arange(2000) * 2.0**-23
        home, still = np.random.default_rng(40).integers(-2**31, 2**31, (dims, 2000)), np.zeros(2000)
        exact, found = model.Exact(*words_around(home, 1), f, still), Results(NEAREST, home, f, still, None, FIXED)
        return abs(exact.nearest("euclidean")[0] - found.nearest("euclidean")[0]).max()

    def test_borders_of_points_that_nearly_touch(self):
        """Along a line from one point to the other, and aside of it: within the bounds, and of some size."""
        for dims in DIMS:
            rng, count = np.random.default_rng(41), 2000
            home = np.repeat(homes(rng, dims, 50, 50, 2_000_000), count // 50, axis=1)
            f = np.concatenate([rng.uniform(0.9, 1, (1, count)), rng.uniform(0.2, 0.8, (dims - 1, count))])
            f, jitter = f.astype(np.float32).astype(float), np.full(count, float(np.float32(1 - 0.7 * 2.0**-20)))
            exact, _ = model.Exact(*words_around(home), f, jitter).border()
            fixed = abs(exact - Results(NEAREST, home, f, jitter, None, FIXED).of("cell_border_cell_full")).max()
            bound = proven("cell_border", dims)
            self.assertTrue(bound.fixed_error / 4000 < fixed < bound.fixed_error, (dims, fixed, bound.fixed_error))
            floats = max(abs(exact - Results(rounding, home, f, jitter).of("cell_border_cell_full")).max()
                         for rounding in some(roundings(42), dims, 2))
            self.assertTrue(bound.cell_error / 4000 < floats < bound.cell_error, (dims, floats, bound.cell_error))

    def test_fixed_is_within_its_range(self):
        for dims in DIMS:
            found = Results(NEAREST, *self.places(np.random.default_rng(43), dims), None, FIXED)
            self.assertLessEqual(max(found.nearest(m).max() for m in model.METRICS),
                                 proven("cellular_three", dims).fixed_limit)
            self.assertLessEqual(found.of("cellular_smooth_cell_full").max(), proven("cellular_smooth", dims).fixed_limit)
            border = found.of("cell_border_cell_full")
            self.assertTrue(border.min() >= 0 and border.max() <= proven("cell_border", dims).fixed_limit)
            self.assertLessEqual(abs(found.of("cellular_d_cell_full")[1:]).max(),
                                 slope_bounds_of("cellular_d", dims).fixed_limit)


def phases(rng, count):
    """The phase is any angle, or near an eighth of a turn."""
    near = rng.integers(-8, 9, count) / 8 + rng.uniform(-1, 1, count) * 2.0 ** -rng.integers(3, 26, count)
    return np.clip(np.where(rng.random(count) < 0.5, near, rng.uniform(-1, 1, count)), -1, 1).astype(
        np.float32).astype(float)


class MovingPoints(unittest.TestCase):
    """Points that go round with a phase."""

    def points(self, rng, dims, reach=1):
        cells, words = model.words_of_cells(rng, dims, COUNT[dims], reach)
        jitter = np.where(rng.random(COUNT[dims]) < 0.2, rng.random(COUNT[dims]), 1.0).astype(np.float32).astype(float)
        return cells, words, model.fractions(rng, dims, COUNT[dims]), jitter, phases(rng, COUNT[dims])

    def test_the_neighbours_have_the_two_nearest(self):
        for dims in DIMS:
            block, radius = features.neighbours(dims), moving.RADIUS[dims]
            self.assertEqual(moving.not_proven(dims, block, radius), [])
            self.assertTrue(0.98 < 2 * radius / moving.room(dims) < 1)

    def test_fails_for_smaller_blocks_and_more_jitter(self):
        """Without any one cell, and with 1/32 more of the jitter."""
        for dims in DIMS:
            block, radius = features.neighbours(dims), moving.RADIUS[dims]
            for cell in block:
                self.assertIn(cell, moving.not_proven(dims, block - {cell}, radius))
            self.assertTrue(moving.not_proven(dims, block, radius + moving.LONGEST[dims] / 64))

    def test_random_points_agree(self):
        rng = np.random.default_rng(51)
        for dims in DIMS:
            cells, *others = self.points(rng, dims, 2)
            every = model.distance("euclidean", model.MovingExact(cells, *others).offsets)
            block = np.array([max(map(abs, c)) <= 1 for c in cells])
            of_all, of_block = (np.sort(part, axis=0)[:2] for part in (every, every[block]))
            self.assertLess(abs(of_all - of_block).max(), 1e-15)

    def test_factors_and_directions(self):
        words = np.arange(2**18, dtype=np.int64) << 14
        for dims in DIMS:
            longest = np.linalg.norm(model.directions(dims, words), axis=0).max() / 512
            self.assertAlmostEqual(longest, moving.LONGEST[dims], delta=1e-15)
            self.assertEqual(moving.JITTER[dims], {2: Fraction(7, 8), 3: Fraction(25, 32)}[dims])

    @staticmethod
    def farthest(f, phase):
        """The largest distances to the points of all cells, smallest first: of any words."""
        dims, every = len(f), np.arange(2**18, dtype=np.int64) << 14
        _, which = np.unique(model.directions(dims, every), axis=1, return_index=True)
        cells = sorted(features.neighbours(dims))
        place = np.repeat(np.array(f)[:, None], len(which), axis=1)
        points = model.MovingExact(cells, np.repeat(every[which][None], len(cells), axis=0), place, 1.0, phase)
        return np.sort(model.distance("euclidean", points.offsets).max(axis=1))

    def test_ends_are_attained(self):
        """In space the first was searched."""
        off = math.atan(1 / 511) / (2 * math.pi)
        for dims, count, f, phase in ((2, 1, (1.0, 1.0), 1 / 8 - off), (2, 2, (0.5, 0.5), 0.0),
                                      (3, 1, (0.96134, 0.03665, 0.0), 3.99007 / (2 * math.pi)),
                                      (3, 2, (0.5, 0.5, 0.5), 0.25)):
            end, found = moving.largest_distance(dims, count), self.farthest(f, phase)[count - 1]
            self.assertTrue((0.99999, 0.997)[(dims, count) == (3, 1)] * end < found <= end, (dims, count, found, end))

    def test_random_points_are_within(self):
        rng = np.random.default_rng(52)
        for dims in DIMS:
            cells, words, f, _, phase = self.points(rng, dims)
            largest = model.MovingExact(cells, words, f, 1.0, phase).nearest("euclidean").max(axis=1)
            for count in (1, 2):
                end = moving.largest_distance(dims, count)
                self.assertTrue(0.6 * end < largest[count - 1] <= end)

    def largest(self, dims, simulated, seed, *macros):
        """The errors of the distances and of an offset, where no other point is as near."""
        rng = np.random.default_rng(seed)
        _, _, f, jitter, phase = self.points(rng, dims)
        home = homes(rng, dims, COUNT[dims], 0)
        exact, worst = model.MovingExact(*words_around(home, 1), f, jitter, phase), np.zeros(2)
        first, second, _ = exact.nearest("euclidean")
        for rounding in simulated:
            found = Results(rounding, home, f, jitter, phase, *macros)
            off = abs(exact.to_nearest() - found.of("cellular_phase_cell_offset"))[:, second - first > 2.0**-10]
            worst = np.maximum(worst, [abs(found.of("cellular_phase_cell_period") - [first, second]).max(), off.max()])
        return worst

    def test_floats(self):
        for dims in DIMS:
            distance, offset = self.largest(dims, some(roundings(54), dims, 3), 53)
            bound = moving.distance_error(dims, moving.largest_distance(dims, 2))
            self.assertTrue(bound / 6 < distance < bound, (dims, distance, bound))
            bound = moving.offset_error(dims, False)
            self.assertTrue(bound / 10 < offset < bound <= proven("cellular_phase", dims).cell_error)

    def test_fails_with_fewer_bits(self):
        for dims in DIMS:
            for error in self.largest(dims, [Rounding("nearest", lost_bits=6)], 56):
                self.assertGreater(error, proven("cellular_phase", dims).cell_error)

    def test_fixed(self):
        for dims in DIMS:
            distance, offset = self.largest(dims, [NEAREST], 57, FIXED)
            bound = moving.fixed_distance_error(dims)
            self.assertTrue(bound / 5 < distance < bound, (dims, distance, bound))
            bound = moving.offset_error(dims, True)
            self.assertTrue(bound / 6 < offset < bound <= proven("cellular_phase", dims).fixed_error, (offset, bound))

    def test_fixed_near_a_point(self):
        """Without jitter, at the middle of a cell, the rank takes the most."""
        f = 0.5 + np.zeros((2, 2000))
        f[0] += np.arange(2000) * 2.0**-23
        home = np.random.default_rng(58).integers(-2**31, 2**31, (2, 2000))
        others = f, np.zeros(2000), np.full(2000, 0.125)
        exact = model.MovingExact(*words_around(home, 1), *others).nearest("euclidean")[0]
        bound, found = moving.fixed_distance_error(2), Results(NEAREST, home, *others, FIXED).of("cellular_phase_cell_period")
        self.assertTrue(bound / 2 < abs(exact - found[0]).max() < bound)

    def test_rotations(self):
        """The matrices of random phases, many near those where sines of fixed arithmetic are worst."""
        rng = np.random.default_rng(59)
        worst = 11116544 / 2**32 + rng.integers(-4, 4, 20_000) / 4 + rng.uniform(-1, 1, 20_000) * 2.0**-18
        phase = np.concatenate([phases(rng, 20_000), worst]).astype(np.float32).astype(float)
        angle, a = np.trunc((phase - np.trunc(phase)) * 2**30).astype(np.int64) * 4, 2 * np.pi * phase

        def sine(angle):
            half = angle & 0x7FFFFFFF
            g = fixed_sine(np.minimum((np.minimum(half, 2**31 - half) + 2**13) >> 14, 65535))
            return np.where(angle >> 31 & 1, -g, g)

        def rows(dims, cosine, sine, product):
            if dims == 2:
                return np.array([[cosine, sine], [-sine, cosine]])
            both = product(sine, cosine)
            return np.array([[cosine, sine, 0 * sine], [-both, product(cosine, cosine), sine],
                             [product(sine, sine), -both, cosine]])
        for dims in DIMS:
            off = (rows(dims, sine(angle + 2**30), sine(angle), moving.fixed_product) / 2**16
                   - rows(dims, np.cos(a), np.sin(a), np.multiply))
            seen = np.linalg.norm(off.transpose(2, 0, 1), 2, axis=(1, 2)).max()
            self.assertTrue(0.9 * moving.fixed_rotation_error(dims) < seen < moving.fixed_rotation_error(dims), (dims, seen))

    def test_nothing_wraps(self):
        """A sine may be 1. So its half times itself would wrap, which no sine below 1 does. The library multiplies in
        two parts, with the same result."""
        for dims in DIMS:
            self.assertLess(max(moving.largest_intermediates(dims).values()), 2**31)
        largest = int(fixed_sines().max())
        self.assertTrue((largest >> 1) * largest >= 2**31 > (largest - 1 >> 1) * (largest - 1) + 2**14)
        sines = np.concatenate([fixed_sines(), -fixed_sines()])
        for other in (sines, sines[::-1], np.full(len(sines), largest)):
            first, low = sines >> 1, (sines >> 1) * (other & 1) + 2**14
            parts = first * (other >> 1) + (low >> 1)
            self.assertTrue((parts >> 14 == moving.fixed_product(sines, other)).all())
            self.assertLessEqual(abs(parts).max(), moving.largest_intermediates(3)["product of two sines"])


def whole_root(q):
    """floor(sqrt(2^8 q)) of words."""
    n = q.astype(np.int64) << 8
    v = np.sqrt(n.astype(float)).astype(np.int64)
    v = np.where(v * v > n, v - 1, v)
    return np.where((v + 1) ** 2 <= n, v + 1, v)


class Roots(unittest.TestCase):
    def guesses(self, q, ulps, conversion=1.0):
        """hn_i_root for words, off to either side."""
        exact = np.sqrt(q.astype(float) * 2**8)
        for sign in (-1, 1):
            off = (1 + sign * conversion * distances.UNIT) ** 0.5 * (1 + sign * ulps * distances.UNIT)
            yield np.floor(exact * off).astype(np.int64)

    def mended(self, q, v):
        v = np.where((q << 8) - v * v < 0, v - 1, v)
        return np.where((q << 8) - v * v > 2 * v, v + 1, v)

    def words(self):
        root = np.arange(2**20, dtype=np.int64)[::-1]
        q = (root * root >> 8)[:50_000]
        rng = np.random.default_rng(44)
        return np.clip(np.concatenate([q, q + 1, q - 1, np.arange(5000), rng.integers(0, 2**32, 50_000)]), 0, 2**32 - 1)

    def test_a_guess_is_mended(self):
        """Less than 1 off: 6 ulp of at most 2^20, and half of one for the conversion."""
        self.assertLess((distances.ROOT_ULPS + 0.5) * distances.UNIT * 2**20, 1)
        q = self.words()
        for v in self.guesses(q, distances.ROOT_ULPS):
            self.assertTrue((self.mended(q, v) == whole_root(q)).all())

    def test_a_worse_guess_is_not(self):
        q = self.words()
        self.assertTrue(any((self.mended(q, v) != whole_root(q)).any() for v in self.guesses(q, 18.0)))

    def test_a_quotient_is_mended(self):
        """The largest quotient of borders is far below 2^19."""
        for dims in DIMS:
            largest = distances.largest_border_intermediates(dims)["quotient"]
            self.assertLess(largest, 2**19)
        self.assertLess((distances.QUOTIENT_ULPS + 1.001) * distances.UNIT * 2**19, 1)

    def test_newton(self):
        """1 / sqrt(q) of HN_PRECISE, to nearest: the guess, and the root, over all mantissas of two octaves."""
        bits = np.arange(0x3F800000, 0x40800000, 37, dtype=np.uint32)
        q = bits.view(np.float32)
        r = (np.uint32(0x5F375A86) - (bits >> np.uint32(1))).view(np.float32)
        exact = 1 / np.sqrt(q.astype(float))
        self.assertLess(abs(r / exact - 1).max(), 1 / 28)
        for _ in range(3):
            r = r * (np.float32(1.5) - q * np.float32(0.5) * r * r)
        root = (q * r).astype(float)
        self.assertTrue(0.5 < abs(root * exact - 1).max() / distances.UNIT < distances.ROOT_ULPS - 2)

    def test_weights_fit(self):
        """t * t and q * q of the largest t, and the sum."""
        q = 65535**2 >> 16
        self.assertTrue(65535**2 < 2**32 and q * q < 2**32)
        for dims in DIMS:
            self.assertLess(features.largest_weights(dims) + 2**-12, 4)
