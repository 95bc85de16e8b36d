"""Traces of the lattice in noises: the statistics find what is there, the library passes, and others do not."""

import unittest
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest import mock

import numpy as np

from base.thorough import THOROUGH, in_thorough_runs
from measure.hashes import fields, library, stripes
from measure.hashes.hashes_test import changed

FOLDER = TemporaryDirectory()
TWIN = THOROUGH and library.build("DEFAULT", [], Path(FOLDER.name))
NOISES = {(noise.title, noise.dimensions): noise for noise in fields.NOISES}


def failing(measures):
    return {found.name for found in measures if not found.passed}


def another(test, name, pattern, replacement):
    include = changed(test, name, pattern, replacement)
    return library.build("changed", [], include.parent, include)


class Directions(unittest.TestCase):
    def test_a_field_of_waves_in_three_directions_has_the_sixth_harmonic_alone(self):
        # Directions 0, 60 and 120 degrees, as nearly as a field that wraps allows: 15, 26 of 30 are 60.02 degrees.
        x, y = np.indices((240, 240))
        field = sum(np.cos(2 * np.pi * (a * x + b * y) / 240) for a, b in ((30, 0), (15, 26), (-15, 26)))
        for order, expected in ((2, 0), (4, 0), (6, 1)):
            self.assertAlmostEqual(fields.harmonic(*fields.waves(field), order), expected, 2)

    def test_axes_diagonals_and_all_directions(self):
        for n, least in ((2, -1), (3, -2 / 3)):
            points = np.random.default_rng(0).normal(size=(1 << 18, n))
            points /= np.linalg.norm(points, axis=-1, keepdims=True)
            for vectors, expected in ((np.eye(n), 1), (np.full((1, n), n ** -0.5), least), (points, 0)):
                self.assertAlmostEqual(fields.harmonic(vectors, np.ones(len(vectors)), 4), expected, 2)

    def test_the_structures_of_a_wave_are_across_it(self):
        for wave in ((2, 1), (0, 3), (1, 2, 2)):
            places = np.indices((8 * fields.PER_CELL,) * len(wave)) / fields.PER_CELL
            field = np.cos(2 * np.pi * np.tensordot(wave, places, 1) / 8)
            vectors, weights = fields.structures(field)
            self.assertTrue(np.allclose(np.abs(vectors), np.array(wave) / np.linalg.norm(wave), atol=1e-3), wave)
            self.assertTrue(np.allclose(weights, 1, atol=1e-3))


class Lattice:
    """A stand-in of the library whose noise is the lattice, and little else."""

    def tile(self, name, positions, period, seed, phase):
        rough = np.random.default_rng(seed).normal(size=len(positions))
        return (np.cos(2 * np.pi * positions).sum(axis=1) + 0.1 * rough).astype(np.float32)

    def octave_sum(self, positions, octaves, seed, period):
        return np.cos(2 * np.pi * 7 * positions).sum(axis=1)


class Limits(unittest.TestCase):
    def test_the_lattice_itself_is_rejected(self):
        with mock.patch.object(fields, "SEEDS", (0, 1)), mock.patch.dict(fields.SIDES, {3: 8}), \
                mock.patch.object(fields, "PLACES", 1 << 10):
            found = failing(fields.look(Lattice(), NOISES["hn_perlin_worley", 3]))
            self.assertLessEqual({"structures, 4", "the same in each cell"}, found)
            with mock.patch.object(fields, "SIDE", 128):
                self.assertEqual(failing(fields.sums(Lattice(), "")), {"waves, 4"})

    def test_each_limit_is_heeded(self):
        found = fields.Measure("hn_perlin", 2, "", [0.05, 0.07], 0.1)
        self.assertTrue(found.passed)
        self.assertTrue(replace(found, values=[9.0], limit=None).passed)
        for values, least in (([0.11, 0.11], False), ([-0.11, -0.11], False), ([0.05], True)):
            self.assertFalse(replace(found, values=values, least=least).passed)


@in_thorough_runs
class Library(unittest.TestCase):
    def test_noises_are_accepted(self):
        for noise in fields.NOISES:
            self.assertEqual(failing(fields.look(TWIN, noise)), set(), noise)
        for cut in fields.CUTS:
            self.assertEqual(failing(fields.sums(TWIN, cut)), set())

    def test_gradients_on_diagonals_are_rejected(self):
        twin = another(self, "detail/direction.glsl", r"hn_i_signed\(hn_i_minus\(1\.0f, abs\(x\)\), h\)",
                       "hn_i_signed(abs(x), h)")
        self.assertEqual(failing(fields.look(twin, NOISES["hn_perlin", 2])), {"structures, 4"})

    def test_octaves_that_do_not_turn_are_rejected(self):
        twin = another(self, "detail/octave.glsl", r"(hn_ivec2 hn_i_rotated_axis\(hn_ivec2 a, hn_ivec2 b, [^)]*\) \{)",
                       r"\1\n  if (true) return a;")
        self.assertIn("waves, 4", failing(fields.sums(twin, "")))

    def test_value_noise_in_place_of_clouds_is_rejected(self):
        class Value(library.Twin):
            def tile(self, name, *others):
                return super().tile("value", *others)

        found = failing(fields.look(Value("value", TWIN.program), NOISES["hn_perlin_worley", 3]))
        self.assertLessEqual({"structures, 4", "slices"}, found)

    def test_simplex_noise_shows_less_of_its_lattice_than_perlin_noise(self):
        def waves(name, n):
            found = fields.look(TWIN, NOISES[name, n])
            return max(abs(one.mean) for one in found if one.name.startswith("waves"))

        for n in (2, 3):
            for name in ("hn_simplex", "hn_simplex_smooth"):
                self.assertLess(waves(name, n), waves("hn_perlin", n) / 4)

    def test_another_weight_would_show_the_triangles(self):
        """The classic weight, a fourth power, instead of the flat one."""
        twin = another(self, "simplex2d.glsl", r"hn_i_weight_plane\(", "hn_i_weight4(")
        found = fields.look(twin, NOISES["hn_simplex", 2])
        self.assertGreater(max(abs(each.mean) for each in found if each.name.startswith("structures")), 0.22)


# --- Stripes ----------------------------------------------------------------------------------------------------------

SMALL = stripes.Effort(range(2), 18, 8, 4, 64)
WAVE = (1.5, 1.0)
POINTS = 4  # of the lattice of a model, along a cell
REACH = 3   # of its points, as far as they are looked for
# As wide a spectrum as the library's weight has.
OURS = (2 * np.pi * stripes.own_width(2, stripes.reach_of(WAVE, SMALL.per_cell))) ** 2


def model(along_x=OURS, along_y=OURS, points=POINTS, more=0.0):
    """Waves around the points of a lattice of squares, with a larger wave than given along each axis."""
    def field(positions, period, wave, seed):
        side = period * points
        angles = np.random.default_rng(seed).uniform(size=(side, side))
        first, total = np.floor(positions * points).astype(int), 0j
        for move in np.ndindex(2 * REACH, 2 * REACH):
            cells = first + np.array(move) - (REACH - 1)
            away = positions - cells / points
            angle = away @ (np.array(wave) + more) + angles[tuple((cells % side).T)]
            total = total + np.exp(-away ** 2 @ [along_x, along_y]) * np.exp(2j * np.pi * angle)
        return total
    return field


class Stripes(unittest.TestCase):
    def test_each_model_is_rejected_by_what_is_meant_for_it(self):
        for field, meant in ((model(), set()), (model(more=0.06), {"centre"}),
                             (model(1.6 * OURS, 0.5 * OURS), {"error of the width along"}),
                             (model(4 * OURS, 4 * OURS, points=2), {"even"})):
            found = {name.partition(",")[0] for name in failing(stripes.measure(field, WAVE, SMALL))}
            self.assertLessEqual(meant, found)
            if not meant:
                self.assertEqual(found, set())

    @in_thorough_runs
    def test_the_library_is_accepted_and_another_weight_is_not(self):
        for wave in stripes.WAVES:
            self.assertEqual(failing(stripes.measure(TWIN.phasor, wave)), set())
        # A fourth power falls sooner.
        twin = another(self, "phasor2d.glsl", r"\bhn_i_weight\w*\(", "hn_i_weight4(")
        found = {name.partition(",")[0] for name in failing(stripes.measure(twin.phasor, stripes.WAVES[1]))}
        self.assertLessEqual({"error of the width along", "even"}, found)
