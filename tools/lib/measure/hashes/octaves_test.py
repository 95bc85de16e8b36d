"""Traces of the lattice in octave sums: the statistics find what is there, the library passes, and sums whose
octaves do not turn, or repeat alike, are rejected."""

import re
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np

from base.thorough import THOROUGH, in_thorough_runs
from base.tree import ROOT
from measure.hashes import library, octaves, report

FOLDER = tempfile.TemporaryDirectory()
TWIN = THOROUGH and library.build("DEFAULT", [], ROOT / "include", Path(FOLDER.name))
FEW = range(2)


def changed(pattern: str, replacement: str) -> library.Twin:
    """The library with another text in detail/octave.glsl."""
    folder = Path(tempfile.mkdtemp(dir=FOLDER.name))
    for part in ("include", "glsl"):
        shutil.copytree(ROOT / part, folder / part)
    path = folder / "glsl" / "hashnoise" / "detail" / "octave.glsl"
    text, found = re.subn(pattern, replacement, path.read_text(encoding="utf-8"))
    assert found == 1, f"{pattern} is {found} times in octave.glsl"
    path.write_text(text, encoding="utf-8")
    return library.build("changed", [], folder / "include", folder)


def directions(twin, cut):
    return octaves.directions(twin, cut, FEW, with_structures=False)


@in_thorough_runs
class Statistics(unittest.TestCase):
    def waves(self, angles, per_cell, cycles):
        """The slopes of waves in some directions."""
        x, y = np.meshgrid(*[np.arange(octaves.SIDE) / per_cell] * 2, indexing="ij")
        slopes = [0, 0]
        for angle in angles:
            along = np.cos(angle), np.sin(angle)
            wave = np.cos(2 * np.pi * cycles * (x * along[0] + y * along[1]))
            slopes = [slope + part * wave for slope, part in zip(slopes, along)]
        return tuple(slopes)

    def test_a_wave_along_an_axis_and_along_a_diagonal(self):
        for angle, expected in ((0, 1), (np.pi / 2, 1), (np.pi / 4, -1), (np.pi / 8, 0)):
            waves = self.waves([angle], octaves.WAVES_PER_CELL, 7.0)
            self.assertAlmostEqual(octaves.spectrum_harmonic(waves), expected, 2)
            waves = self.waves([angle], octaves.PER_CELL, 2.0)
            for smoothing in octaves.SMOOTHINGS:
                self.assertAlmostEqual(octaves.structure_harmonic(waves, smoothing), expected, 2)

    def test_waves_in_all_directions(self):
        waves = self.waves(np.arange(12) * np.pi / 12, octaves.WAVES_PER_CELL, 7.0)
        self.assertAlmostEqual(octaves.spectrum_harmonic(waves), 0, 2)

    def test_slopes_are_those_of_the_sum(self):
        """One octave, whose slope a difference to both sides gives as well."""
        cut = octaves.CUTS[0]
        along = octaves.slopes(TWIN, cut, 1, 8.0, 3)
        start = np.random.default_rng((3, 2)).uniform(-500, 500, 2)
        for axis in (0, 1):
            step = 2.0**-8 * np.eye(2)[axis]
            after, before = TWIN.octave_sum(np.array([start + step, start - step]), 1, 2.0, 0.5, 3).astype(float)
            self.assertAlmostEqual(along[axis][0, 0], (after - before) * 2.0**7, 2)


@in_thorough_runs
class Turns(unittest.TestCase):
    def test_the_library_is_accepted(self):
        for cut in (*octaves.CUTS, *octaves.CUTS_4D):
            found = directions(TWIN, cut)
            self.assertTrue(found.passed, found)

    def test_octaves_that_do_not_turn_are_rejected(self):
        twin = changed(r"(hn_ivec2 hn_i_rotated_axis\(hn_ivec2 a, hn_ivec2 b, [^)]*\) \{)", r"\1\n  if (true) return a;")
        for cut in (*octaves.CUTS, *octaves.CUTS_4D):
            found = directions(twin, cut)
            self.assertFalse(found.passed, found)

    def test_a_tile_does_not_turn(self):
        """The library's own sums without turns, which the page compares with."""
        found = octaves.directions(TWIN, octaves.CUTS[0], FEW, with_structures=False, period=octaves.FAR)
        self.assertGreater(np.mean(found.spectrum), 1.5 * octaves.LIMIT)

    def test_either_sign_is_judged(self):
        for value, passed in ((0.0, True), (0.029, True), (0.031, False), (-0.031, False)):
            self.assertEqual(octaves.Directions(octaves.CUTS[0], None, [value] * 2, {}).passed, passed)


@in_thorough_runs
class Page(unittest.TestCase):
    def test_it_passes_only_if_all_do(self):
        def shown(spectrum, correlation):
            found = [octaves.Directions(cut, None, [spectrum, spectrum], {0.5: [0.0, 0.1], 1.0: [0.0, 0.1]})
                     for cut in octaves.CUTS]
            return octaves.Shown(found, found, [octaves.Repeats(2, 0.0), octaves.Repeats(3, correlation)])
        self.assertTrue(shown(0.0, 0.0).passed)
        self.assertFalse(shown(0.1, 0.0).passed)
        self.assertFalse(shown(0.0, 0.1).passed)
        text = report.sums_table(shown(0.01, 0.0)) + report.repeats_table(shown(0.01, 0.0))
        self.assertIn("| 3D, slices across y | 0.0100 | 0.0500 ± 0.0500", text)
        self.assertIn("0.0500 ± 0.0500", text)
        self.assertNotIn("**", text)
        self.assertIn("| **0.1000", report.sums_table(shown(0.1, 0.0)))
        self.assertIn("| 3D | **0.1** |", report.repeats_table(shown(0.0, 0.1)))


@in_thorough_runs
class Tiles(unittest.TestCase):
    def test_a_tile_repeats_after_its_period(self):
        for n in (2, 3):
            self.assertAlmostEqual(octaves.correlation(TWIN, n, octaves.PERIOD * np.eye(n)[0], FEW), 1, 3)

    def test_the_library_does_not_repeat_sooner(self):
        for n in (2, 3):
            found = octaves.repeats(TWIN, n)
            self.assertTrue(found.passed, found)

    def test_octaves_that_repeat_alike_are_rejected(self):
        twin = changed(r"return int\(uint\(period\) \* uint\(lacunarity\)\);", "return period;")
        for n in (2, 3):
            found = octaves.repeats(twin, n, FEW)
            self.assertFalse(found.passed, found)
            self.assertGreater(found.correlation, 0.99)


if __name__ == "__main__":
    unittest.main()
