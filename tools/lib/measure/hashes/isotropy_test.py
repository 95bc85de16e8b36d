"""The isotropy of the noise: the statistic is what it is called, the library passes, shapes that show are rejected."""

import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np
from scipy import stats

from base.thorough import THOROUGH, in_thorough_runs
from base.tree import ROOT
from measure.hashes import controls, directions, gate, isotropy, library, report

FOLDER = tempfile.TemporaryDirectory()
TWIN = THOROUGH and library.build("DEFAULT", [], ROOT / "include", Path(FOLDER.name))


def rejecting(findings):
    return {finding.test for finding in findings if not finding.passed}


def judged(make, n):
    return gate.judge_gradients(controls.of_gradients(make(controls.GRADIENT_SHAPES[n])))


def preferences(twin, n):
    """The finding of a small effort."""
    return next(f for f in gate.each_finding(twin, n, gate.LEAST) if f.test == "isotropy")


@in_thorough_runs
class Statistic(unittest.TestCase):
    def test_axes_diagonals_and_all_directions(self):
        for n, least in ((2, -1), (3, -2 / 3)):
            corner = np.full((1, n), n ** -0.5)
            self.assertAlmostEqual(float(isotropy.preference(np.eye(n)[:1])[0]), 1)
            self.assertAlmostEqual(float(isotropy.preference(corner)[0]), least)
            points = np.random.default_rng(0).normal(size=(1 << 18, n))
            points /= np.linalg.norm(points, axis=-1, keepdims=True)
            self.assertAlmostEqual(float(isotropy.preference(points).mean()), 0, 2)

    def test_the_direction_of_a_wave(self):
        for wave in ((2, 1), (0, 3), (1, 2, 2)):
            n = len(wave)
            side = 8
            places = np.meshgrid(*[np.arange(side * isotropy.PER_CELL) / isotropy.PER_CELL] * n, indexing="ij")
            field = np.cos(2 * np.pi * sum(w * p for w, p in zip(wave, places)) / side).astype(np.float32)
            vectors, weights = isotropy.across(isotropy.structure(field))
            self.assertTrue(np.allclose(np.abs(vectors), np.array(wave) / np.linalg.norm(wave), atol=1e-3), wave)
            self.assertTrue(np.allclose(weights, 1, atol=1e-3))

    def test_the_interpolation_is_that_of_each_point_alone(self):
        # A control's noise is calculated from the corners of the cell of each point.
        control = controls.Function("control", TWIN.program, {}, controls.strong)
        for n in (2, 3):
            self.assertTrue(isotropy.same_noise(control, n, 5).passed)
            self.assertTrue(isotropy.same_noise(TWIN, n, 5).passed)

    def test_noise_that_is_not_that_of_the_gradients(self):
        class Other(library.Twin):
            def noise(self, positions, seed):
                return super().noise(positions, seed + 1)

        class Rough(library.Twin):
            def noise(self, positions, seed):
                return super().noise(positions, seed) + 1e-5 * (positions[:, 0] > 5)

        for kind in (Other, Rough):
            self.assertFalse(isotropy.same_noise(kind("other", TWIN.program), 2, 0).passed)

    def test_more_samples_change_little(self):
        gradients = next(isotropy.blocks(controls.as_the_library((256, 256))))
        few, many = (isotropy.mean_preference(*isotropy.across(isotropy.structure(isotropy.noise(gradients, k), k)))
                     for k in (isotropy.PER_CELL, 8))
        self.assertLess(abs(few - many), 0.005)

    def test_the_spread_of_random_blocks(self):
        for n, count in ((2, 20), (3, 12)):
            shape = (isotropy.SIDES[n],) * n
            values = [isotropy.of_gradients(TWIN.stage(controls.random(shape, seed), n)) for seed in range(count)]
            ratio = np.var(values, ddof=1) / isotropy.SPREAD[n] ** 2 * (count - 1)
            self.assertGreater(stats.chi2(count - 1).cdf(ratio), 1e-3, np.std(values))
            self.assertGreater(stats.chi2(count - 1).sf(ratio), 1e-3, np.std(values))


@in_thorough_runs
class Verdict(unittest.TestCase):
    def test_the_aim_may_be_reached_on_either_side(self):
        for value, passed in ((0.0, True), (isotropy.AIM[2], True), (-isotropy.AIM[2], True), (0.15, False), (-0.15, False)):
            self.assertEqual(isotropy.judge([value] * 16, 2).passed, passed, value)
        found = isotropy.judge([0.0] * 16, 2)
        self.assertAlmostEqual(found.threshold, isotropy.AIM[2] + stats.norm.isf(2.0 ** -20) * isotropy.SPREAD[2] / 4)
        self.assertAlmostEqual(found.lower, -found.threshold)
        self.assertFalse(isotropy.judge([found.threshold + 1e-6] * 16, 2).passed)
        self.assertTrue(isotropy.judge([found.threshold - 1e-6] * 16, 2).passed)

    def test_each_shape_is_rejected_by_the_tests_meant_for_it(self):
        for name, (make, tests) in controls.GRADIENTS.items():
            for n in (2, 3):
                found = rejecting(judged(make, n))
                self.assertLessEqual(set(tests), found, f"{name} in {n}D")
                if not tests:
                    self.assertEqual(found, set(), f"{name} in {n}D")

    def test_a_shape_that_is_rejected_where_it_should_pass(self):
        results = [report.HashResult("as_the_library", 2, judged(controls.diagonals, 2), None)]
        self.assertFalse(report.rejected_as_meant(results))

    def test_the_library_is_accepted(self):
        for n in (2, 3):
            found = preferences(TWIN, n)
            self.assertTrue(found.passed, found)
            # Not by the margin for chance alone.
            self.assertLess(abs(found.statistic), isotropy.AIM[n])

    def test_a_library_whose_gradients_are_diagonals(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for part in ("include", "glsl"):
                shutil.copytree(ROOT / part, folder / part)
            path = folder / "glsl" / "hashnoise" / "detail" / "direction.glsl"
            text = path.read_text()
            other = text.replace("hn_i_signed(hn_i_minus(1.0f, abs(x)), h)", "hn_i_signed(abs(x), h)")
            self.assertTrue(other != text, "direction.glsl has another text")
            path.write_text(other)
            twin = library.build("diagonals", [], folder / "include", folder)
            self.assertFalse(preferences(twin, 2).passed)
            self.assertTrue(isotropy.same_noise(twin, 2, 0).passed)
            window = gate.sample(twin, (256, 256), (0, 0), 0)
            self.assertFalse(directions.others(window).passed)


if __name__ == "__main__":
    unittest.main()
