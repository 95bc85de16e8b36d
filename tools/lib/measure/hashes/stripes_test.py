"""Traces of the lattice in phasor noise and Perlin-Worley noise: each statistic rejects the field that is meant for
it, and a thorough run judges the library."""

import re
import shutil
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

import numpy as np

from base.thorough import in_thorough_runs
from base.tree import ROOT
from measure.hashes import fields, library, report, stripes

SMALL = stripes.Effort(range(2), 18, 8, 4, 64)
WAVE = (1.5, 1.0)
POINTS = 4  # of the lattice of a model, along a cell
REACH = 3   # of its points, as far as they are looked for


def round_weight(sharpness):
    return lambda x, y: np.exp(-sharpness * (x * x + y * y))


# As wide a spectrum as the library's weight has.
OURS = (2 * np.pi * stripes.own_width(2, stripes.reach_of(WAVE, SMALL.per_cell))) ** 2


def model(weight=round_weight(OURS), points=POINTS, more=0.0, phases=lambda seed: seed):
    """Waves around the points of a lattice of squares, with a larger wave than given along each axis."""
    def field(positions, period, wave, seed):
        side = period * points
        angles = np.random.default_rng(phases(seed)).uniform(size=(side, side))
        first, total = np.floor(positions * points).astype(int), 0j
        for move in np.ndindex(2 * REACH, 2 * REACH):
            cells = first + np.array(move) - (REACH - 1)
            away = positions - cells / points
            angle = away @ (np.array(wave) + more) + angles[tuple((cells % side).T)]
            total = total + weight(*away.T) * np.exp(2j * np.pi * angle)
        return total
    return field


def plane_wave(positions, period, wave, seed):
    return np.exp(2j * np.pi * (positions @ np.array(wave) + seed * 0.3))


# Fields, and the statistics that must reject it.
CONTROLS = {
    "another wave than the given one": (model(more=0.06), {"centre"}),
    "one wave everywhere": (plane_wave, {"width"}),
    "a weight that is longer along y": (model(lambda x, y: np.exp(-1.6 * OURS * x * x - 0.5 * OURS * y * y)),
                                        {"width", "round"}),
    "points that are too far apart": (model(round_weight(4 * OURS), points=2), {"width", "even"}),
    "the same phases with each seed": (model(phases=lambda seed: 0), {"seeds"}),
}


class Controls(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.good = stripes.measure(model(), WAVE, SMALL)

    def test_random_phases_with_a_weight_as_wide_are_accepted(self):
        self.assertEqual(self.good.problems, [], self.good)
        self.assertGreater(self.good.even, 0.8)

    def test_each_control_is_rejected_by_what_is_meant_for_it(self):
        for name, (field, meant) in CONTROLS.items():
            found = stripes.measure(field, WAVE, SMALL)
            self.assertLessEqual(meant, set(found.problems), (name, found))

    def test_every_statistic_has_a_control(self):
        nothing = replace(self.good, centres=self.good.centres + 1.0, along=[0.0], harmonics={2: [1.0]}, even=0.0,
                          seeds=replace(self.good.seeds, p=0.0))
        self.assertEqual(set(nothing.problems), {name for _, meant in CONTROLS.values() for name in meant})

    def test_stripes_that_follow_the_wave_are_steady(self):
        self.assertAlmostEqual(stripes.measure(plane_wave, WAVE, SMALL).steady, 1.0, 6)
        self.assertLess(self.good.steady, 0.99)

    def test_the_page_tells_what_is_wrong(self):
        self.assertNotIn("**", report.stripes_table([self.good]))
        bad = replace(self.good, centres=self.good.centres + 1.0, even=0.01)
        self.assertRegex(report.stripes_table([self.good, bad]),
                         r"\n\| 2D, \(1\.5, 1\) \| \*\*1\.\d+\*\* \| .* \| \*\*0\.01\*\* \|")


class Grid:
    """A stand-in of the library whose noise is the lattice, and little else."""

    def tile(self, name, positions, period, seed, phase):
        rough = np.random.default_rng(seed).normal(size=len(positions))
        return (np.cos(2 * np.pi * positions).sum(axis=1) + 0.1 * rough).astype(np.float32)


class Looks(unittest.TestCase):
    def test_the_lattice_itself_is_rejected(self):
        with mock.patch.object(fields, "SEEDS", (0, 1)), mock.patch.dict(fields.SIDES, {3: 8}), \
                mock.patch.object(fields, "PLACES", 1 << 10):
            found = fields.look(Grid(), next(noise for noise in fields.NOISES if noise.judged))
        self.assertLessEqual({"structures", "fixed"}, set(found.problems), found)
        self.assertGreater(np.mean(found.spectrum[4]), 0.9)
        self.assertLess(abs(np.mean(found.rest)), 0.1)

    def test_each_limit_is_heeded(self):
        noise = next(noise for noise in fields.NOISES if noise.judged)
        good = fields.Look(noise, {4: [0.05, 0.07]}, {4: [0.2, 0.2]}, [0.9, 0.9], [0.08, 0.08], [0.02, 0.02])
        self.assertEqual(good.problems, [])
        for name, values in (("structures", {4: [-0.11, -0.11]}), ("slices", [0.8]), ("fixed", [0.11]), ("rest", [-0.04])):
            self.assertEqual(replace(good, **{name: values}).problems, [name])
        self.assertIn("**`hn_perlin_worley` 3D**", report.look_table([replace(good, slices=[0.8, 0.8])]))
        self.assertNotIn("**", report.look_table([good]))


@in_thorough_runs
class Library(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.twin = library.build("DEFAULT", [], ROOT / "include", cls.folder)

    def test_stripes_are_accepted(self):
        for found in stripes.shown(self.twin.phasor):
            self.assertEqual(found.problems, [], found)

    def test_another_weight_is_rejected(self):
        """A fourth power, which falls sooner."""
        for part in ("include", "glsl"):
            shutil.copytree(ROOT / part, self.folder / part)
        path = self.folder / "glsl" / "hashnoise" / "phasor2d.glsl"
        text = path.read_text(encoding="utf-8")
        changed, count = re.subn(r"\bhn_i_weight\w*\(", "hn_i_weight4(", text)
        self.assertGreater(count, 0)
        path.write_text(changed, encoding="utf-8")
        twin = library.build("CHANGED", [], self.folder / "include", self.folder)
        found = stripes.measure(twin.phasor, stripes.WAVES[2][1])
        self.assertLessEqual({"width", "even"}, set(found.problems), found)

    def test_clouds_are_accepted_and_value_noise_is_not(self):
        clouds = next(noise for noise in fields.NOISES if noise.judged)
        found = fields.look(self.twin, clouds)
        self.assertEqual(found.problems, [], found)
        value = replace(fields.look(self.twin, fields.Noise("value", 3)), noise=clouds, fixed=[0.0], rest=[0.0])
        self.assertEqual(value.problems, ["structures", "slices"])


if __name__ == "__main__":
    unittest.main()
