"""Tests of the proofs for cellular noise: blocks of cells that are one smaller are refuted, ranges are nearly attained,
and the text of the library stays within the bounds where these are largest."""

import functools
import itertools
import math
import unittest

import numpy as np

from base.thorough import in_thorough_runs
from proof.bounds import borders, features, moving
from proof.bounds.rounded import EXACT, Text, along_axes
from proof.oracle import feature_points
from proof.oracle import noises as oracle
from proof.oracle.gradients import Knobs

DIMS = (2, 3)
DISTANCES = {  # of vectors, by the metric
    "euclidean": lambda v: np.sqrt((v * v).sum(axis=0)), "squared": lambda v: (v * v).sum(axis=0),
    "manhattan": lambda v: abs(v).sum(axis=0), "chebyshev": lambda v: abs(v).max(axis=0),
    "hybrid": lambda v: abs(v).sum(axis=0) + (v * v).sum(axis=0)}


@functools.cache
def directions(dims):
    """All of the contract: axes by directions."""
    words = [sign << 31 | bits << (14 if dims == 2 else 15) for sign in (0, 1)
             for bits in range(2**(9 if dims == 2 else 16))]
    return np.array([feature_points.direction(word, dims) for word in words]).T / 512


def not_beyond(block, dims):
    """The cells outside of the block that may have a point nearer than 1, by the largest component."""
    return [o for o in features.outside(block, dims)
            if not any(all(abs(o_i - x[i]) - features.HALF >= 1 for x in features.simplex(dims)) for i, o_i in enumerate(o))]


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
            self.assertEqual(not_beyond(block, dims), [])
            for cell in block:
                self.assertIn(cell, not_beyond(block - {cell}, dims))

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
        without one of the slabs."""
        for dims, count, steps in ((2, 1200, 8), (3, 300, 3)):
            block = borders.block(dims)
            self.assertLess(borders.search(block, dims, 12, count, steps), 1e-9)
            missed = borders.search(features.neighbours(dims), dims, 20, count, steps)
            self.assertGreater(missed, 0.05)
            self.assertGreater(borders.search(block - features.slab(dims, 1), dims, 20, count, steps), missed / 2)


class Borders(unittest.TestCase):
    def test_known_ends(self):
        """The bound is beyond the largest borders that are known of the library."""
        known = {2: ((-567291, 57828), (0.5342983, 0.7685160), 233433071),
                 3: ((974166, -68968, 352045), (0.5813425, 0.4050027, 0.2685761), 2892670609)}
        for dims, place in known.items():
            seen = float(oracle.find("cell_border").exact_cell(Knobs("lattice", False), *place)[0])
            self.assertTrue({2: 0.702, 3: 0.618}[dims] < seen < features.largest_border(dims))


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
                self.assertTrue(least - 1e-12 < DISTANCES["euclidean"](off).min() < least + 0.03)
                for metric in features.METRICS:
                    most = features.farthest(tuple(cell), place, metric)[0]
                    self.assertAlmostEqual(DISTANCES[metric](off).max(), most, delta=1e-9)

    def test_known_ends(self):
        for dims in DIMS:
            known = {1: ((dims + 3) / 4) ** 0.5, 2: 1.5, 3: 2.5**0.5}
            for count, end in known.items():
                found = features.largest_distance(dims, count)
                self.assertTrue(end <= found < end * 1.0001)

    def test_directions_do_not_reach_the_corners(self):
        for dims in DIMS:
            self.assertEqual(abs(directions(dims)).max(), {2: 511 / 512, 3: 255 / 256}[dims])
            self.assertEqual(abs(directions(dims)).sum(axis=0).max(), 1)
            longest = np.linalg.norm(directions(dims), axis=0).max()
            self.assertAlmostEqual(longest, moving.LONGEST[dims], delta=1e-15)


class Metrics(unittest.TestCase):
    """The range of hn_cellular is the largest of all metrics. Here each metric has its own, and reaches half of it."""

    def test_each(self):
        rng = np.random.default_rng(3)
        for dims, (count, name), (number, metric) in itertools.product(
                DIMS, ((2, "cellular"), (3, "cellular_three")), enumerate(features.METRICS, 1)):
            columns = along_axes("c", rng.integers(-1000, 1000, (dims, 4000))) | along_axes("p", np.zeros((dims, 1), int)) | {
                "jitter": 1.0, "metric": number, "seed": rng.integers(0, 2**32, 4000)}
            exact = np.array(text()(f"noise{dims}d.{name}_cell_full", EXACT, **columns, **along_axes("f", rng.random((dims, 4000)))))
            bound = features.largest_distance(dims, count, metric)
            with self.subTest(metric, dims=dims, count=count):
                self.assertTrue(bound / 2 < exact.max() < bound * (1 + 1e-9), (exact.max(), bound))


@functools.cache
def text():
    return Text([])


class MovingPoints(unittest.TestCase):
    """Points that go round with a phase."""

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

    @staticmethod
    def farthest(f, phase):
        """The largest distances to the points of all cells, smallest first: of any words."""
        dims, angle = len(f), 2 * np.pi * phase
        u = np.array(moving.rows(dims, np.cos(angle), np.sin(angle), np.multiply)).T @ directions(dims)
        return sorted(np.linalg.norm(np.array(f)[:, None] - np.array(cell)[:, None] - 0.5 - moving.JITTER[dims] / 2 * u,
                                     axis=0).max() for cell in features.neighbours(dims))

    def test_ends_are_attained(self):
        """In space the first was searched."""
        off = math.atan(1 / 511) / (2 * math.pi)
        for dims, count, f, phase in ((2, 1, (1.0, 1.0), 1 / 8 - off), (2, 2, (0.5, 0.5), 0.0),
                                      (3, 1, (0.96134, 0.03665, 0.0), 3.99007 / (2 * math.pi)),
                                      (3, 2, (0.5, 0.5, 0.5), 0.25)):
            end, found = moving.largest_distance(dims, count), self.farthest(f, phase)[count - 1]
            self.assertTrue((0.99999, 0.997)[(dims, count) == (3, 1)] * end < found <= end, (dims, count, found, end))


class Weights(unittest.TestCase):
    def test_weights_fit(self):
        for dims in DIMS:
            self.assertLess(features.largest_weights(dims) + 2**-12, 4)
