"""Cellular noise, found in another way: among all points of a block. Nothing of the oracle's search is used."""

from __future__ import annotations

import itertools
import math
import unittest

import numpy as np
from scipy.spatial import Voronoi, cKDTree

from proof.golden.cellular_rows import METRICS
from proof.golden.generator import generator_of
from proof.oracle import feature_points, hashes, nearest, noises
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Choice

SEED = 0xC0FFEE
BLOCK = {2: 12, 3: 7}  # of cells, from 0 on along each axis
EDGE = 3  # positions keep so far away from the ends of the block
# By metric.
DISTANCES = {1: lambda d: np.linalg.norm(d, axis=1), 2: lambda d: np.sum(d**2, axis=1),
             3: lambda d: np.sum(np.abs(d), axis=1), 4: lambda d: np.max(np.abs(d), axis=1),
             5: lambda d: np.sum(np.abs(d) + d**2, axis=1)}
NEAR = 1e-12


def points_of(n: int, jitter: float, name: str = "lattice") -> tuple[np.ndarray, np.ndarray]:
    """The cells of the block and their points."""
    cells = np.array(list(itertools.product(range(BLOCK[n]), repeat=n)))
    direction = feature_points.direction2 if n == 2 else feature_points.direction3
    u = np.array([direction(hashes.point_word(name, tuple(map(int, cell)), SEED)) for cell in cells])
    return cells, cells + 0.5 + jitter / 2 * u


NEARER = {2: 7 / 8, 3: 25 / 32}


def rotation(n: int, phase: float) -> np.ndarray:
    """M, of points that move."""
    c, s = math.cos(2 * math.pi * phase), math.sin(2 * math.pi * phase)
    in_the_plane = np.array(((c, -s, 0), (s, c, 0), (0, 0, 1)))
    return in_the_plane[:2, :2] if n == 2 else in_the_plane @ np.array(((1, 0, 0), (0, c, -s), (0, s, c)))


def moved(n: int, jitter: float, phase: float) -> np.ndarray:
    """The points of the block with a phase."""
    cells, points = points_of(n, NEARER[n] * jitter)
    middles = cells + 0.5
    return middles + (points - middles) @ rotation(n, phase).T


def positions(n: int, count: int) -> list[list[float]]:
    numbers = generator_of(f"witness{n}")
    return [[numbers.uniform(EDGE, BLOCK[n] - EDGE) for _ in range(n)] for _ in range(count)]


def borders(points: np.ndarray) -> dict[int, list[np.ndarray]]:
    """Of each point, those across an edge, or a face, of its Voronoi cell."""
    beside: dict[int, list[np.ndarray]] = {}
    for a, b in Voronoi(points).ridge_points:
        beside.setdefault(int(a), []).append(points[b])
        beside.setdefault(int(b), []).append(points[a])
    return beside


class Witness(unittest.TestCase):
    """A point at another place, a point that a search leaves out, or a distance, a border or a sum that is another."""

    def check_distances(self, n: int, jitter: float, points: np.ndarray, cells: np.ndarray) -> None:
        self.assertEqual({*DISTANCES}, {*METRICS})
        for metric, of in DISTANCES.items():
            choice = Choice(jitter, metric)
            for p in positions(n, 20):
                every = of(points - p)
                indices = np.argsort(every)[:3]
                distances = every[indices]
                found = noises.find("cellular_three").chosen(choice).exact(Knobs("lattice"), p, SEED)
                np.testing.assert_allclose([float(x) for x in found], distances, rtol=0, atol=NEAR)
                if distances[1] - distances[0] > NEAR:
                    self.assertEqual(nearest.NEAREST.chosen(choice).exact(Knobs("lattice"), p, SEED),
                                     tuple(cells[indices[0]]))
                    offset = nearest.OFFSET.chosen(choice).exact(Knobs("lattice"), p, SEED)
                    np.testing.assert_allclose([float(x) for x in offset], points[indices[0]] - p, rtol=0, atol=NEAR)

    def check_borders(self, n: int, jitter: float, points: np.ndarray) -> None:
        tree, beside = cKDTree(points), borders(points)
        for p in positions(n, 20):
            _, index = tree.query(p)
            point = points[index]
            # How far it is to each plane in the middle between the points, along its normal.
            expected = min(np.dot((point + other) / 2 - p, other - point) / np.linalg.norm(other - point)
                           for other in beside[int(index)])
            found, = noises.find("cell_border").chosen(Choice(jitter)).exact(Knobs("lattice"), p, SEED)
            self.assertAlmostEqual(float(found), expected, 11)

    def check_smooth(self, n: int, jitter: float, points: np.ndarray) -> None:
        for p in positions(n, 20):
            near = np.maximum(0, 1 - np.linalg.norm(points - p, axis=1))
            found, = noises.find("cellular_smooth").chosen(Choice(jitter)).exact(Knobs("lattice"), p, SEED)
            self.assertAlmostEqual(float(found), 1 - (np.sum(near**4) + 1 / 4096)**0.25, 11)

    def check_moving(self, n: int, jitter: float, phase: float, points: np.ndarray) -> None:
        tree, cells = cKDTree(points), points_of(n, 0)[0]
        distance, near, offset = (noise.chosen(Choice(jitter)).rotated(phase) for noise in
                                  (noises.find("cellular_phase"), nearest.NEAREST, nearest.OFFSET))
        for p in positions(n, 20):
            distances, indices = tree.query(p, 2)
            found = distance.exact(Knobs("lattice"), p, SEED)
            np.testing.assert_allclose([float(x) for x in found], distances, rtol=0, atol=NEAR)
            if distances[1] - distances[0] > NEAR:
                self.assertEqual(near.exact(Knobs("lattice"), p, SEED), tuple(cells[indices[0]]))
                found = offset.exact(Knobs("lattice"), p, SEED)
                np.testing.assert_allclose([float(x) for x in found], points[indices[0]] - p, rtol=0, atol=NEAR)

    def test_points_that_move(self) -> None:
        for n, (jitter, phase) in itertools.product((2, 3), ((1.0, 0.3), (0.75, -0.125))):
            self.check_moving(n, jitter, phase, moved(n, jitter, phase))

    def test_of_all_points(self) -> None:
        for n, jitter in itertools.product((2, 3), (1.0, 0.25)):
            cells, points = points_of(n, jitter)
            self.check_distances(n, jitter, points, cells)
            self.check_borders(n, jitter, points)
            self.check_smooth(n, jitter, points)
