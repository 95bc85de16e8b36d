"""Tests of tools/make dimensions."""

from __future__ import annotations

import shutil

from base.testing import Case, called
from translate.dimensions import command

# hashnoise.glsl includes these first.
NOISES = ["noise1d.glsl", "noise2d.glsl", "noise3d.glsl", "noise4d.glsl"]
# Then it includes functions built on noise, and others.
BUILT = command.INCLUDE.findall((command.GLSL / "hashnoise.glsl").read_text())[len(NOISES):]


class Umbrella(Case):
    def setUp(self):
        self.glsl = self.folder / "glsl"
        shutil.copytree(command.GLSL, self.glsl)

    def run_main(self, *arguments: str) -> tuple[int, list[str]]:
        status, printed = called(command.main, *arguments, "--glsl", self.glsl)
        self.replaced = [line for line in printed.splitlines() if status == 0 and line.endswith((" replaced", " removed"))]
        return status, [line.split()[0] for line in printed.splitlines() if line not in self.replaced]

    def includes(self, file: str) -> list[str]:
        return command.INCLUDE.findall((self.glsl / file).read_text())

    def test_the_library_has_what_it_makes(self):
        self.assertEqual(self.run_main("--check"), (0, []))
        self.assertLess({"curl.glsl", "fbm.glsl", "self_check.glsl"}, set(BUILT))

    def test_a_new_noise_is_included_by_its_dimension(self):
        for noise in ("waves2d", "simplex2_fast2d", "simplex22d"):
            (self.glsl / f"{noise}.glsl").write_text("// a noise\n")
            self.assertEqual(self.run_main("--check"), (1, ["detail/undef_guards.h", "noise2d.glsl"]))
            self.assertEqual(self.run_main(), (0, []))
            self.assertIn(f'#include "{noise}.glsl"\n', (self.glsl / "noise2d.glsl").read_text())
            self.assertNotIn(noise, (self.glsl / "noise3d.glsl").read_text())
            self.assertEqual(self.run_main("--check"), (0, []))

    def test_what_is_built_on_noise_is_in_a_file_of_its_own(self):
        for dimension in ("2", "3"):
            (self.glsl / f"zone{dimension}d.glsl").write_text(f'#include "perlin{dimension}d.glsl"\n')
        self.assertEqual(self.run_main("--check"), (1, ["detail/undef_guards.h", "hashnoise.glsl", "zone.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        self.assertEqual(self.includes("zone.glsl"), ["zone2d.glsl", "zone3d.glsl"])
        self.assertEqual(self.includes("hashnoise.glsl"), [*NOISES, *BUILT, "zone.glsl"])
        self.assertEqual(self.run_main("--check"), (0, []))

        (self.glsl / "zone3d.glsl").unlink()
        self.assertEqual(self.run_main("--check"), (1, ["detail/undef_guards.h", "zone.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        self.assertEqual(self.includes("zone.glsl"), ["zone2d.glsl"])

        # Without an include of its own dimension it is a noise.
        (self.glsl / "zone2d.glsl").write_text('#include "detail/direction.glsl"\n#include "perlin3d.glsl"\n')
        self.assertEqual(self.run_main("--check"), (1, ["detail/undef_guards.h", "hashnoise.glsl", "noise2d.glsl", "zone.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        self.assertIn("zone2d.glsl", self.includes("noise2d.glsl"))
        self.assertFalse((self.glsl / "zone.glsl").exists())

    def test_every_noise_is_declared_before_what_is_built_on_noise(self):
        (self.glsl / "a_sum2d.glsl").write_text('#include "perlin2d.glsl"\n')
        self.assertEqual(self.run_main(), (0, []))
        self.assertEqual(self.includes("hashnoise.glsl"), [*NOISES, "a_sum.glsl", *BUILT])

    def test_the_whole_library_has_what_no_other_file_includes(self):
        (self.glsl / "zone.glsl").write_text('#include "fbm.glsl"\n')
        self.assertEqual(self.run_main("--check"), (1, ["detail/undef_guards.h", "hashnoise.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        self.assertEqual(self.includes("hashnoise.glsl"), [*NOISES, *(file for file in BUILT if file != "fbm.glsl"), "zone.glsl"])

    def test_octaves_are_the_same_in_every_dimension_but_for_their_positions(self):
        path = self.glsl / "octaves2d.glsl"
        path.write_text(path.read_text().replace("o.seed += HN_I_SEED_STEP;", "o.seed += 1u;"))
        self.assertEqual(self.run_main("--check"), (1, ["octaves1d.glsl", "octaves3d.glsl", "octaves4d.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        path.write_text(path.read_text().replace("b * q.x + a * q.y", "a * q.y + b * q.x"))  # by hand in each
        self.assertEqual(self.run_main("--check"), (0, []))
        path.write_text(path.read_text().replace("o.y = hn_i_", "o.y = hn_i_hole_"))
        self.assertEqual(self.run_main("--check"), (1, ["octaves2d.glsl,"]))  # what would o.z be?
        self.assertEqual(self.run_main(), (1, ["octaves2d.glsl,"]))

    def test_what_a_file_has_of_other_dimensions_is_made_of_what_is_above(self):
        path = self.glsl / "position.glsl"
        text = path.read_text()
        path.write_text(text.replace("hn_fraction(position.z, cells, units)", "hn_fraction(position.z, units, cells)"))
        self.assertEqual(self.run_main("--check"), (1, ["position.glsl"]))
        self.assertEqual(self.run_main(), (0, []))
        self.assertEqual(path.read_text(), text)

    def test_a_change_by_hand_is_told(self):
        for file in ("detail/undef_guards.h", "fbm.glsl", "noise2d.glsl", "noise3d.glsl", "hashnoise.glsl"):
            with self.subTest(file=file):
                path = self.glsl / file
                path.write_text(path.read_text() + "\n")
                self.assertEqual(self.run_main("--check"), (1, [file]))
                self.assertEqual(self.run_main(), (0, []))
                self.assertEqual(self.replaced, [f"{file} is replaced"])

    def test_bad_usage(self):
        self.glsl = self.glsl / "absent"
        self.assertEqual(self.run_main()[0], 2)
