"""Tests of tools/umbrella."""

from __future__ import annotations

import contextlib
import io
import shutil
import tempfile
import unittest
from pathlib import Path

from commands.support import load_script

umbrella = load_script("umbrella")


class Umbrella(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.glsl = Path(scratch.name, "glsl")
        shutil.copytree(umbrella.GLSL, self.glsl)

    def run_main(self, *arguments: str) -> tuple[int, list[str]]:
        output = io.StringIO()
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
            try:
                status = umbrella.main([*arguments, "--glsl", str(self.glsl)])
            except SystemExit as stop:
                status = stop.code
        return status, [line.split()[0] for line in output.getvalue().splitlines()]

    def test_the_library_has_what_it_makes(self):
        self.assertEqual(self.run_main("--check"), (0, []))

    def test_a_new_noise_is_included_by_its_dimension(self):
        for noise in ("waves2d", "simplex2_fast2d", "simplex22d"):
            (self.glsl / f"{noise}.glsl").write_text("// a noise\n")
            self.assertEqual(self.run_main("--check"), (1, ["noise2d.glsl"]))
            self.assertEqual(self.run_main(), (0, []))
            self.assertIn(f'#include "{noise}.glsl"\n', (self.glsl / "noise2d.glsl").read_text())
            self.assertNotIn(noise, (self.glsl / "noise3d.glsl").read_text())
            self.assertEqual(self.run_main("--check"), (0, []))

    def test_the_whole_library_has_what_no_other_file_includes(self):
        (self.glsl / "warp.glsl").write_text('#include "fbm.glsl"\n')
        self.assertEqual(self.run_main("--check"), (1, ["hashnoise.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        self.assertEqual(umbrella.INCLUDE.findall((self.glsl / "hashnoise.glsl").read_text()),
                         ["noise2d.glsl", "noise3d.glsl", "warp.glsl"])

    def test_a_new_dimension_has_a_file_and_an_old_one_none(self):
        for noise in self.glsl.glob("*3d.glsl"):
            if noise.name != "noise3d.glsl":
                noise.rename(self.glsl / noise.name.replace("3d", "4d"))
        self.assertEqual(self.run_main("--check"), (1, ["hashnoise.glsl", "noise3d.glsl", "noise4d.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        self.assertIn('#include "perlin4d.glsl"\n', (self.glsl / "noise4d.glsl").read_text())
        self.assertFalse((self.glsl / "noise3d.glsl").exists())

    def test_a_change_by_hand_is_told(self):
        for file in ("noise2d.glsl", "noise3d.glsl", "hashnoise.glsl"):
            with self.subTest(file=file):
                path = self.glsl / file
                path.write_text(path.read_text() + "\n")
                self.assertEqual(self.run_main("--check"), (1, [file]))
                self.assertEqual(self.run_main(), (0, []))

    def test_bad_usage(self):
        self.glsl = self.glsl / "absent"
        self.assertEqual(self.run_main()[0], 2)


if __name__ == "__main__":
    unittest.main()
