#!/usr/bin/env python3
"""hn-conform paper as its user meets it: its records, and the noise calculated again."""

import copy
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from program import PROGRAM, ROOT, ProgramTest, instructions_of

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "paper"))
from check import noise_differences, order_faults, read  # noqa: E402


class Paper(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.out = pathlib.Path(folder.name) / "out"
        cls.arguments = ["paper", "--rounds", "3", "--dump", "--out", str(cls.out)]
        done = subprocess.run([PROGRAM, *cls.arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise AssertionError(f"status {done.returncode}: {done.stderr}")
        cls.records = {name: read(cls.out / f"{name}.csv") for name in ("table", "values", "period", "bandwidth")}
        cls.table = cls.records["table"][1]

    def values(self, name):
        return (self.out / "values" / f"{name}.f32").read_bytes()

    def test_records_have_their_rows_and_where_they_are_from(self):
        for name, count in (("table", 38), ("values", 84), ("period", 40), ("bandwidth", 70)):
            facts, rows = self.records[name]
            self.assertEqual(len(rows), count)
            self.assertEqual({row.get("problem", "") for row in rows}, {""})
            self.assertRegex(facts["date"], r"^20\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
            self.assertEqual(facts["command"], " ".join(["hn-conform", *self.arguments]))
            self.assertEqual(facts["driver"], "osmesa")
            self.assertIn("llvmpipe", facts["renderer"])

    def test_files_have_the_values_of_a_square_or_of_a_million_places(self):
        side = int(self.records["values"][0]["side"])
        self.assertGreaterEqual(side, 512)
        files = {row["file"]: row["what"] for row in self.records["values"][1]}
        self.assertEqual(len(files), 84)
        for file, what in files.items():
            self.assertEqual((self.out / file).stat().st_size, 4 * (1 << 20 if what == "statistics" else side * side))
        drawn = {(self.out / file).read_bytes() for file, what in files.items() if what != "statistics"}
        self.assertEqual(len(drawn), 48)

    def test_times_and_periods_are_numbers_that_can_be(self):
        for row in self.table:
            for size in ("800x600", "1024x768"):
                self.assertGreater(float(row[f"ms_{size}"]), 0.0)
        for row in self.records["bandwidth"][1]:
            self.assertGreater(float(row["milliseconds"]), 0.0)
        rows = self.records["period"][1]
        self.assertEqual({row["verdict"] for row in rows}, {"as stated"})
        self.assertEqual({row["period"] for row in rows}, {"256", "1048576", "48", "999983"})

    def test_instructions_are_those_that_spirv_dis_shows(self):
        self.assertEqual(len({row["id"] for row in self.table}), 38)
        self.assertEqual(len(list((self.out / "spirv").iterdir())), 38)
        for row in self.table:
            self.assertEqual(instructions_of(self.out / "spirv" / f"{row['id']}.spv"), int(row["spirv"]), row["id"])

    def test_instructions_are_in_the_papers_order(self):
        self.assertEqual(order_faults(self.table), [])

    def test_another_order_is_seen(self):
        for form, algorithm, change, fault in (
            ("ours", "Perlin/Murmur", -100, "ours, 2D"),
            ("as published", "Perlin/FNV1", 1, "apart"),
            ("as intended", "Perlin/Jenkins", -200, "as intended, 2D"),
            ("tables in textures", "Perlin/Float", 60, "not the paper's order"),
        ):
            rows = copy.deepcopy(self.table)
            row = next(row for row in rows if row["form"] == form and row["algorithm"] == algorithm)
            row["spirv"] = str(int(row["spirv"]) + change)
            self.assertTrue(any(fault in found for found in order_faults(rows)), algorithm)

    def test_noise_of_tables_is_that_of_the_formulas(self):
        files = [row["file"] for row in self.records["values"][1]
                 if row["file"].split(".")[1] == "table" and row["what"] == "statistics"]
        self.assertEqual(len(files), 4)
        for file in files:
            self.assertLessEqual(max(noise_differences(file, (self.out / file).read_bytes())), 2.0 ** -10, file)

    def test_another_noise_is_seen(self):
        self.assertGreater(max(noise_differences("float.table.2d", self.values("fnv1.ours.2d"))), 0.25)
        grid = bytearray(self.values("float.table.2d"))
        for sign in range(3, len(grid), 4):
            grid[sign] ^= 0x80
        self.assertGreater(max(noise_differences("float.table.2d", grid)), 0.25)


class Broken(ProgramTest):
    def test_a_shader_that_does_not_compile_costs_its_rows_and_status_1(self):
        glsl = self.folder / "glsl"
        shutil.copytree(ROOT / "glsl" / "hashnoise", glsl)
        text = (glsl / "noise3d.glsl").read_text()
        (glsl / "noise3d.glsl").write_text(text.replace("#include", "broken;\n#include", 1))
        done = self.call("paper", "--rounds", "3", "--glsl", glsl, "--out", self.out)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("NOT AS EXPECTED", done.stdout)
        rows = {row["id"]: row for row in read(self.out / "table.csv")[1]}
        self.assertIn(f"{glsl}/noise3d.glsl:", rows["fnv1.ours.2d"]["problem"])  # the driver's words, with the line
        self.assertEqual(rows["fnv1.ours.2d"]["ms_800x600"], "failed")
        # It has nothing of the library in it.
        self.assertGreater(float(rows["fnv1.published.2d"]["ms_800x600"]), 0.0)


class Usage(ProgramTest):
    def test_mistakes_are_reported_before_anything_is_measured(self):
        (self.folder / "file").write_text("")
        for arguments, status, part in (
            (["--driver", "voodoo"], 2, "there are: osmesa, egl"),
            (["--driver", "egl-device:many"], 2, "there are: osmesa, egl"),
            (["--driver", "egl-device:99"], 3, "egl-device:99 cannot be used here"),
            (["--out", self.folder / "file" / "out"], 2, "--out wants a folder that can be written"),
            (["--out", "/proc/paper"], 2, "--out wants a folder that can be written"),
            (["--glsl", self.folder], 2, "a copy of every file of glsl/hashnoise/"),
        ):
            with self.subTest(arguments=arguments):
                start = sum(os.times()[2:4])
                done = self.call("paper", *([] if "--out" in arguments else ["--out", self.out]), *arguments)
                self.assertLess(sum(os.times()[2:4]) - start, 10.0)  # of the processor; a run takes about a minute
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertIn(part, done.stderr)


if __name__ == "__main__":
    unittest.main()
