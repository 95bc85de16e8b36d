"""Traces of the lattice in noises: the statistics find what is there, and simplex noise shows what it should."""

import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy import stats

from base.thorough import THOROUGH, in_thorough_runs
from base.tree import ROOT
from measure.hashes import fields, library

FOLDER = tempfile.TemporaryDirectory()
TWIN = THOROUGH and library.build("DEFAULT", [], ROOT / "include", Path(FOLDER.name))
PERLIN2, SIMPLEX2, SMOOTH2 = fields.NOISES[:3]
PERLIN3, SIMPLEX3, SMOOTH3 = [n for n in fields.NOISES if n.dimensions == 3][:3]


def worst(values: dict[int, list[float]]) -> float:
    return max(abs(fields.mean_and_error(v)[0]) for v in values.values())


@in_thorough_runs
class Statistics(unittest.TestCase):
    def test_a_field_of_waves_in_three_directions_has_the_sixth_harmonic_alone(self):
        # Directions 0, 60 and 120 degrees, as nearly as a field that wraps allows: 15, 26 of 30 are 60.02 degrees.
        side = 240
        x, y = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
        field = sum(np.cos(2 * np.pi * (a * x + b * y) / side) for a, b in ((30, 0), (15, 26), (-15, 26)))
        found = {order: fields.harmonic(*fields.waves(field), order) for order in fields.ORDERS}
        self.assertAlmostEqual(found[2], 0, 2)
        self.assertAlmostEqual(found[4], 0, 2)
        self.assertAlmostEqual(found[6], 1, 2)

    def test_a_lattice_of_squares_and_a_stretched_one(self):
        vectors = np.array([[1, 0], [0, 1], [1, 0]], float)
        self.assertAlmostEqual(fields.harmonic(vectors[:2], np.ones(2), 4), 1)
        self.assertAlmostEqual(fields.harmonic(vectors[:2], np.ones(2), 2), 0)
        self.assertAlmostEqual(fields.harmonic(vectors, np.ones(3), 2), 1 / 3)

    def test_white_noise_has_no_direction(self):
        field = np.random.default_rng(0).normal(size=(512, 512))
        for order in fields.ORDERS:
            self.assertLess(abs(fields.harmonic(*fields.waves(field), order)), 0.01)

    def test_blocks_wrap(self):
        for noise in (PERLIN2, SIMPLEX2, SMOOTH2):
            block = fields.block(TWIN, noise, 0)
            inside = np.abs(np.diff(block, axis=0)).max()
            self.assertLess(np.abs(block[0] - block[-1]).max(), 1.5 * inside)


@in_thorough_runs
class Simplex(unittest.TestCase):
    def test_shows_less_of_its_lattice_than_perlin_noise_in_the_plane(self):
        perlin, simplex, smooth = (fields.look(TWIN, noise) for noise in (PERLIN2, SIMPLEX2, SMOOTH2))
        for ours in (simplex, smooth):
            self.assertLess(worst(ours.spectrum), worst(perlin.spectrum) / 4)
        # Structures lean towards the sides of triangles, those of Perlin noise towards axes and diagonals alike. A
        # larger kernel costs a fourth point, and leaves less of that.
        self.assertLess(worst(simplex.structures), 0.8 * worst(perlin.structures))
        self.assertLess(worst(smooth.structures), worst(simplex.structures) / 2)

    def test_shows_less_of_its_lattice_than_perlin_noise_in_space(self):
        perlin, simplex, smooth = (fields.look(TWIN, noise) for noise in (PERLIN3, SIMPLEX3, SMOOTH3))
        for ours in (simplex, smooth):
            self.assertLess(worst(ours.structures), worst(perlin.structures))
            self.assertLess(worst(ours.spectrum), worst(perlin.spectrum) / 4)

    def test_a_phase_in_space_shows_no_more_of_it(self):
        # Gradients that rotate in the plane of their two axes would have 0.36 and 0.86 here, and a lower kurtosis.
        for still in (PERLIN3, SIMPLEX3):
            kurtosis = stats.kurtosis(fields.block(TWIN, still, 0), axis=None)
            preference = worst(fields.look(TWIN, still).structures)
            for phase in (1 / 12, 1 / 8, 1 / 4):
                moved = replace(still, phase=phase)
                self.assertLess(worst(fields.look(TWIN, moved).structures), preference + 0.03)
                self.assertAlmostEqual(stats.kurtosis(fields.block(TWIN, moved, 0), axis=None), kurtosis, delta=0.05)

    def test_another_weight_would_show_the_triangles(self):
        # The classic weight, a fourth power, instead of the flat one.
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder)
            for name in ("include", "glsl"):
                for path in (ROOT / name).rglob("*.*"):
                    target = copy / path.relative_to(ROOT)
                    target.parent.mkdir(parents=True, exist_ok=True)
                    text = path.read_text(encoding="utf-8")
                    if path.name == "simplex2d.glsl":
                        self.assertIn("hn_i_weight_plane(", text)
                        text = text.replace("hn_i_weight_plane(", "hn_i_weight4(")
                    target.write_text(text, encoding="utf-8")
            twin = library.build("CLASSIC", [], copy / "include", copy)
            classic = fields.look(twin, SIMPLEX2)
        self.assertGreater(worst(classic.structures), 0.22)


if __name__ == "__main__":
    unittest.main()
