#!/usr/bin/env python3
"""hn-conform paper as its user meets it: the page, the pictures, and the numbers calculated again from what --dump
writes. Usage: paper_cli_test.py PATH-OF-HN-CONFORM"""

import concurrent.futures
import copy
import itertools
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "paper"))
from check import (Page, chi_square_faults, csv_faults, floats, noise_differences, order_faults, page_faults,
                   picture_faults, spirv_faults, statistics_faults,
                   statistics_faults_of_file, table_faults)  # noqa: E402

PROGRAM = ""


class Paper(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.out = pathlib.Path(folder.name) / "out"
        cls.arguments = ["paper", "--rounds", "3", "--dump", "--out", str(cls.out)]
        cls.done = subprocess.run([PROGRAM, *cls.arguments], capture_output=True, text=True, check=False)
        if cls.done.returncode != 0:
            raise AssertionError(f"status {cls.done.returncode}: {cls.done.stderr}")
        cls.page = (cls.out / "index.html").read_text()
        cls.data = json.loads((cls.out / "paper.json").read_text())
        cls.samples = {sample["id"]: sample for sample in cls.data["statistics"]["samples"]}

    def grid(self, sample_id):
        return (self.out / "grids" / f"{sample_id}.f32").read_bytes()

    def provenance(self):
        keys = ("renderer", "gl_version", "glsl_version", "date", "command", "version")
        return {key: self.data[key] for key in keys}

    # The page.

    def test_it_says_where_the_page_is(self):
        self.assertIn(f"{self.out}/index.html", self.done.stdout)
        self.assertIn("llvmpipe", self.done.stdout)

    def test_the_page_is_complete_and_loads_nothing_from_elsewhere(self):
        self.assertEqual(page_faults(self.page, self.out, self.provenance()), [])
        page = Page(self.page)
        self.assertEqual(sum(link.endswith(".png") for link in page.links), 3 * (18 * 2 + 1))
        self.assertRegex(self.data["date"], r"^20\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertEqual(self.data["command"], " ".join(["hn-conform", *self.arguments]))
        self.assertEqual(self.data["driver"], "osmesa")

    def test_a_page_with_a_fault_is_seen(self):
        for old, new, fault in (
            ("fnv1.intended.clouds.png", "fnv2.intended.clouds.png", "there is no file fnv2"),
            ('src="', 'src="https://example.org/', "leads elsewhere: https://example.org/"),
            ('src="', 'src="//example.org/', "leads elsewhere: //"),
            ("</body>", "<script>1</script></body>", "a tag <script>"),
            ("</style>", "body { background: url(https://example.org/x.png) }</style>", "a style loads"),
            ("</style>", '@import "x.css";</style>', "a style loads"),
            ("1.00 ± 0.00", "nan ± 0.00", "the text has nan"),
            ('<td class="number">~165</td>', '<td class="number"></td>', "an empty cell under 2D"),
            (self.data["date"], "", "does not say date"),
            ("<code>hn-conform paper", "<code>hn-conform pap", "does not say command"),
        ):
            with self.subTest(new=new):
                self.assertIn(old, self.page)
                faults = page_faults(self.page.replace(old, new, 1), self.out, self.provenance())
                self.assertTrue(any(fault in found for found in faults), faults)

    def test_the_table_stands_beside_the_papers(self):
        self.assertEqual(table_faults(self.page, self.data["table"]["rows"]), [])

    def test_a_wrong_number_in_the_table_is_seen(self):
        rows = self.data["table"]["rows"]
        for old, new in (("~165", "~164"), (">33.1<", ">33.2<"), (">4.65<", ">4.64<"), ("Perlin/Murmur<", "Murmur<")):
            with self.subTest(new=new):
                self.assertIn(old, self.page)
                # Everywhere: a time that was measured may happen to be the same number.
                self.assertNotEqual(table_faults(self.page.replace(old, new), rows), [])
        changed = copy.deepcopy(rows)
        changed[1]["instructions"]["spirv"] += 1
        self.assertNotEqual(table_faults(self.page, changed), [])

    def test_the_files_that_are_told_exist(self):
        for name, rows in (("table.csv", 38), ("statistics.csv", 36), ("period.csv", 40), ("bandwidth.csv", 70)):
            self.assertEqual(csv_faults(self.out / name, rows), [])
        side = self.data["figures"]["side"]
        self.assertGreaterEqual(side, 512)
        self.assertEqual([sheet["file"] for sheet in self.data["figures"]["sheets"]],
                         ["sheet.intended.png", "sheet.published.png", "sheet.ours.png"])
        for sheet in self.data["figures"]["sheets"]:
            self.assertEqual(picture_faults((self.out / sheet["file"]).read_bytes(), 3 * side, 6 * side), [])
            figures = [figure["file"] for row in sheet["rows"] for figure in row["figures"]]
            self.assertEqual(len(set(figures)), 18)
            pictures = {(self.out / figure).read_bytes() for figure in figures}
            self.assertEqual(len(pictures), 18)
            for picture in pictures:
                self.assertEqual(picture_faults(picture, side, side), [])

    def test_a_picture_with_a_fault_is_seen(self):
        picture = (self.out / "fnv1.intended.noise.png").read_bytes()
        self.assertEqual(picture_faults(picture, 512, 513), ["(512, 512) pixels, not (512, 513)"])
        self.assertEqual(picture_faults(picture[1:], 512, 512), ["no PNG"])
        self.assertEqual(picture_faults(picture[:-20], 512, 512), ["the PNG has no end"])

    # The numbers.

    def test_times_and_periods_are_numbers_that_can_be(self):
        for row in self.data["table"]["rows"]:
            for timing in row["timing"]:
                self.assertGreater(timing["milliseconds"], 0.0)
        for curve in self.data["bandwidth"]["curves"]:
            self.assertEqual(len(curve["milliseconds"]), 7)
            self.assertGreater(min(curve["milliseconds"]), 0.0)
        rows = self.data["periods"]["rows"]
        self.assertEqual({row["verdict"] for row in rows}, {"as stated"})
        self.assertEqual({row["period"] for row in rows}, {256, 1048576, 48, 999983})

    def test_instructions_are_those_that_spirv_dis_shows(self):
        rows = self.data["table"]["rows"]
        self.assertEqual(len({row["id"] for row in rows}), 38)
        self.assertEqual(len(list((self.out / "spirv").iterdir())), 38)
        for row in rows:
            self.assertEqual(spirv_faults(row, self.out / "spirv" / f"{row['id']}.spv"), [])

    def test_a_wrong_count_is_seen(self):
        row = copy.deepcopy(self.data["table"]["rows"][1])
        other = self.out / "spirv" / "jenkins.published.2d.spv"
        self.assertRegex(spirv_faults(row, other)[0], r"fnv1.published.2d: \d+ instructions, not \d+")
        row["instructions"]["spirv"] -= 1
        self.assertEqual(len(spirv_faults(row, self.out / "spirv" / f"{row['id']}.spv")), 1)
        self.assertIn("spirv-dis says", spirv_faults(row, self.out / "paper.json")[0])

    def test_instructions_are_in_the_papers_order(self):
        self.assertEqual(order_faults(self.data["table"]["rows"]), [])

    def test_another_order_is_seen(self):
        for form, algorithm, change, fault in (
            ("ours", "murmur", -100, "ours, 2D"),
            ("as published", "fnv1", 1, "apart"),
            ("as intended", "jenkins", -200, "as intended, 2D"),
            ("tables in textures", "float", 60, "not the paper's order"),
        ):
            rows = copy.deepcopy(self.data["table"]["rows"])
            row = next(row for row in rows if row["form"] == form and row["algorithm"] == algorithm)
            row["instructions"]["spirv"] += change
            self.assertTrue(any(fault in found for found in order_faults(rows)), algorithm)

    def test_statistics_are_those_of_the_grids(self):
        self.assertEqual(len(self.samples), 36)
        samples = list(self.samples.values())
        paths = [self.out / "grids" / f"{sample['id']}.f32" for sample in samples]
        with concurrent.futures.ProcessPoolExecutor() as pool:
            faults = list(pool.map(statistics_faults_of_file, samples, paths))
        self.assertEqual(list(itertools.chain(*faults)), [])

    def test_a_changed_byte_of_a_grid_is_seen(self):
        sample = self.samples["murmur.intended.3d"]
        grid = bytearray(self.grid(sample["id"]))
        # Of a number between 1/8 and 1/4: the lowest byte, the sign.
        at = 4 * next(i for i, value in enumerate(floats(grid)) if 0.125 <= value < 0.25)
        for byte, change, faults in ((at, 0x80, ("mean",)), (at + 3, 0x80, ("mean", "skewness", "histogram"))):
            grid[byte] ^= change
            found = statistics_faults(sample, grid)
            grid[byte] ^= change
            for fault in faults:
                self.assertTrue(any(fault in text for text in found), found)
        self.assertEqual(len(statistics_faults(sample, grid[:-4])), 1)

    def test_a_changed_statistic_is_seen(self):
        grid = self.grid("fnv1.ours.2d")
        changed = copy.deepcopy(self.samples["fnv1.ours.2d"])
        changed["histogram"][40] += 1
        for key in ("count", "minimum", "maximum", "mean", "variance", "skewness", "excess_kurtosis", "zeros"):
            changed[key] += 1e-9
        self.assertEqual(len(statistics_faults(changed, grid)), 9)

    def test_chi_square_is_that_of_the_histograms(self):
        comparisons = self.data["statistics"]["partial_against_full"]
        self.assertEqual(len(comparisons), 12)
        for comparison in comparisons:
            self.assertEqual(chi_square_faults(comparison, self.samples), [])
        wrong = {**comparisons[0], "degrees": comparisons[0]["degrees"] + 1}
        self.assertEqual(len(chi_square_faults(wrong, self.samples)), 1)

    def test_noise_is_that_of_the_formulas(self):
        largest = {}
        for sample in self.samples.values():
            form = sample["id"].split(".")[1]
            if form in ("intended", "table"):
                differences = noise_differences(sample, self.grid(sample["id"]))
                largest[form] = max(largest.get(form, 0.0), *differences)
        print("largest differences from the formulas:", {form: f"{value:.2g}" for form, value in largest.items()})
        self.assertEqual(set(largest), {"intended", "table"})
        for form, value in largest.items():
            self.assertLessEqual(value, 2.0 ** -10, form)

    def test_another_noise_is_seen(self):
        for sample_id, other in (("fnv1.intended.2d", "partial_fnv1.intended.2d"),
                                 ("murmur.intended.3d", "murmur.published.3d"), ("float.table.2d", "fnv1.ours.2d")):
            self.assertGreater(max(noise_differences(self.samples[sample_id], self.grid(other))), 0.25)
        grid = bytearray(self.grid("fnv1.intended.2d"))
        for sign in range(3, len(grid), 4):
            grid[sign] ^= 0x80
        self.assertGreater(max(noise_differences(self.samples["fnv1.intended.2d"], grid)), 0.25)


class Broken(unittest.TestCase):
    def test_a_shader_that_does_not_compile_costs_its_rows_and_status_1(self):
        with tempfile.TemporaryDirectory() as folder:
            glsl = pathlib.Path(folder) / "glsl"
            shutil.copytree(pathlib.Path(__file__).resolve().parent.parent.parent / "glsl" / "hashnoise", glsl)
            text = (glsl / "noise3d.glsl").read_text()
            (glsl / "noise3d.glsl").write_text(text.replace("#include", "broken;\n#include", 1))
            out = pathlib.Path(folder) / "out"
            done = subprocess.run([PROGRAM, "paper", "--rounds", "3", "--glsl", str(glsl), "--out", str(out)],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn("NOT AS EXPECTED", done.stdout)
            page = (out / "index.html").read_text()
            self.assertIn(f"{glsl}/noise3d.glsl:", page)  # the driver's words, with file and line
            self.assertIn("failed", page)
            rows = {row["id"]: row for row in json.loads((out / "paper.json").read_text())["table"]["rows"]}
            self.assertIn("error", rows["fnv1.ours.2d"])
            self.assertIn("timing", rows["fnv1.published.2d"])  # has nothing of the library in it


class Usage(unittest.TestCase):
    def call(self, *arguments):
        """Mistakes are told before anything is measured."""
        start = time.monotonic()
        done = subprocess.run([PROGRAM, "paper", *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertLess(time.monotonic() - start, 10.0)  # a run takes about a minute
        return done

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_bad_usage_is_status_2_and_says_what_would_be_right(self):
        (self.folder / "file").write_text("")
        out = ["--out", self.folder / "out"]
        for arguments, expected in (
            ([*out, "--driver", "voodoo"], "there are: osmesa, egl"),
            ([*out, "--driver", "egl-device:many"], "there are: osmesa, egl"),
            (["--out", self.folder / "file" / "out"], "--out wants a folder that can be written"),
            (["--out", "/proc/paper"], "--out wants a folder that can be written"),
            ([*out, "--rounds", "2"], "rounds"),
            ([*out, "--rounds", "-3"], "rounds"),
            ([*out, "--rounds", "many"], "rounds"),
            ([*out, "--glsl", self.folder], "a copy of every file of glsl/hashnoise/"),
            ([*out, "--frobnicate"], "frobnicate"),
        ):
            with self.subTest(arguments=arguments):
                done = self.call(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(expected, done.stderr + done.stdout)

    def test_a_driver_that_is_not_here_is_status_3(self):
        done = self.call("--out", self.folder / "out", "--driver", "egl-device:99")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("egl-device:99 cannot be used here", done.stderr)

    def test_help_is_status_0(self):
        self.assertEqual(self.call("--help").returncode, 0)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
