#!/usr/bin/env python3
"""hn-conform bench as its user meets it."""

import csv
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from program import PROGRAM, ProgramTest, instructions_of

ONE_SUBJECT = "hash.word.fnv1"
REFERENCES = ["empty2", "empty3", "table.float2", "table.float3", "table.integer2", "table.integer3"]

# A noise of values at the corners of a square, in as little code as there is.
VALUE_NOISE = """\
float corner(vec2 cell) { return fract(sin(dot(cell, vec2(12.9898, 78.233))) * 43758.5453); }
float value_noise(vec2 p) {
  vec2 f = fract(p);
  vec2 cell = floor(p);
  float below = mix(corner(cell), corner(cell + vec2(1.0, 0.0)), f.x);
  float above = mix(corner(cell + vec2(0.0, 1.0)), corner(cell + vec2(1.0, 1.0)), f.x);
  return mix(below, above, f.y);
}
"""
VALUE_NOISE_3D = "float value_noise(vec3 p) { return mix(value_noise(p.xy + floor(p.z)), 0.0, fract(p.z)); }\n"


class BenchCli(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """A run of one subject, whose results the tests take for those of an earlier run."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.earlier = pathlib.Path(folder.name) / "earlier"
        subprocess.run([PROGRAM, "bench", "--out", cls.earlier, "--rounds", "3", "--filter", ONE_SUBJECT], check=True,
                       capture_output=True, timeout=120)

    def bench(self, *arguments):
        return self.call("bench", "--out", self.out, "--rounds", "3", "--filter", ONE_SUBJECT, *arguments)

    def have_run(self):
        shutil.copytree(self.earlier, self.out)

    def lines(self):
        return (self.out / "bench.csv").read_text(encoding="utf-8").splitlines(keepends=True)

    def facts(self):
        return dict(line[2:].rstrip("\n").split(": ", 1) for line in self.lines() if line.startswith("# "))

    def subjects(self):
        rows = csv.DictReader(line for line in self.lines() if not line.startswith("# "))
        return {subject["id"]: subject for subject in rows}

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def assert_everything_is_there(self, *ids):
        self.assertEqual(sorted(self.subjects()), sorted([*REFERENCES, *ids]))

    def test_a_run_leaves_its_numbers_and_where_they_are_from(self):
        done = self.bench("--filter", "noise2d.perlin.lattice+fixed")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{self.out}/bench.csv", done.stdout)
        self.assertRegex(done.stdout, r"(?m)^ *1\.00 ± 0\.00 table\.float2$")
        self.assertEqual(sorted(path.name for path in self.out.iterdir()), ["bench.csv"])
        self.assert_everything_is_there(ONE_SUBJECT, "noise2d.perlin.lattice+fixed")
        facts = self.facts()
        self.assertEqual(facts["driver"], "osmesa")
        self.assertEqual(facts["rounds"], "3")
        self.assertRegex(facts["date"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertIn(f"bench --out {self.out} --rounds 3 --filter {ONE_SUBJECT}", facts["command"])
        for name in ("renderer", "OpenGL", "GLSL", "library", "clock", "load"):
            self.assertIn(name, facts)
        subjects = self.subjects()
        for name, subject in subjects.items():
            self.assertGreater(int(subject["spirv"]), 0, name)
            self.assertGreater(float(subject["compile_ms"]), 0, name)
            self.assertGreaterEqual(float(subject["spread"]), 0, name)
        for dimensions in (2, 3):
            self.assertEqual(float(subjects[f"empty{dimensions}"]["ratio"]), 0)
            self.assertEqual(float(subjects[f"table.float{dimensions}"]["ratio"]), 1)
            self.assertEqual(float(subjects[f"table.float{dimensions}"]["spread"]), 0)

    def test_other_peoples_shaders_are_measured(self):
        both = self.write("both.glsl", VALUE_NOISE + VALUE_NOISE_3D)
        plane = self.write("in:the plane.glsl", VALUE_NOISE)
        space = self.write("space.glsl", (VALUE_NOISE + VALUE_NOISE_3D).replace("value_noise(vec2", "flat_noise(vec2")
                           .replace("value_noise(p.xy", "flat_noise(p.xy"))
        # It has its version, and its neighbours.
        self.write("corner.glsl", VALUE_NOISE)
        braces = self.write("braces.glsl", "#include \"corner.glsl\"\nconst float kTwo[] = { 1.0, 2.0 };\n"
                            "float two(vec2 p) { return kTwo[int(p.x) & 1] * value_noise(p); }\n")
        done = self.bench("--against", f"both={both}:value_noise(p) * 2.0 - 1.0", "--against",
                          f"{plane}:value_noise(p) // a comment", "--against", f"space={space}:value_noise(p)",
                          "--against", f"choice={both}:p.x > 0.5 ? value_noise(p) : 0.0", "--against",
                          f"braces@420={braces}:two(p)")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assert_everything_is_there(ONE_SUBJECT, "both2", "both3", "braces2", "choice2", "choice3", "space3",
                                        "value_noise2")
        for name, subject in self.subjects().items():
            self.assertEqual(subject["problem"], "", name)
        # It is not an empty shader that was measured.
        for name in ("both2", "braces2"):
            self.assertGreater(int(self.subjects()[name]["spirv"]), int(self.subjects()["empty2"]["spirv"]) + 10)

    def test_what_does_not_compile_is_told_before_anything_is_measured(self):
        good = self.write("good.glsl", VALUE_NOISE)
        broken = self.write("broken.glsl", VALUE_NOISE.replace("floor(p)", "flor(p)"))
        older = self.write("older.glsl", "#version 120\n" + VALUE_NOISE.replace("floor(p)", "flor(p)"))
        self.have_run()
        before = (self.out / "bench.csv").read_text()
        start = sum(os.times()[2:4])
        # The whole library would take minutes of processor time.
        done = self.call("bench", "--out", self.out, "--against", f"good={good}:value_noise(p)", "--against",
                         f"broken={broken}:value_noise(p)", "--against", f"older={older}:value_noise(p)", "--against",
                         f"vector={good}:vec2(p)", "--against", f"whole={good}:int(p.x)", "--against",
                         f"absent={good}:simplex(p)")
        self.assertLess(sum(os.times()[2:4]) - start, 60)
        self.assert_refused(done, f"broken={broken}:value_noise(p)", f"{broken}:4", f"{older}:5", f"{good}:vec2(p)",
                            f"{good}:int(p.x)", "simplex", "the expression of absent:1")
        self.assertNotIn("good=", done.stderr)
        self.assertEqual((self.out / "bench.csv").read_text(), before)

    def test_bad_usage_is_status_2_and_says_what_would_be_right(self):
        shader = self.write("noise.glsl", VALUE_NOISE)
        self.write("file", "")
        for arguments, *expected in (
            (["--against", "noise"], "there is no file \"noise\"", "write FILE:EXPRESSION"),
            (["--against", f"v={shader}"], "there is no expression", "write FILE:EXPRESSION"),
            (["--against", f"{shader}: "], "there is no expression", "write FILE:EXPRESSION"),
            (["--against", f"v={self.folder}/none.glsl:value_noise(p)"], f"there is no file \"{self.folder}/none.glsl\""),
            (["--against", f"v={self.folder}:value_noise(p)"], f"there is no file \"{self.folder}\""),
            (["--against", f"v@425={shader}:value_noise(p)"], "\"425\" is not a version", "there are 330, 400"),
            (["--against", f"../a={shader}:value_noise(p)"], f"there is no file \"../a={shader}\""),
            (["--against", f"empty={shader}:value_noise(p)"], "empty"),
            (["--against", f"v={shader}:1.0", "--against", f"v={shader}:2.0"], "the name v is used twice"),
            (["--filter", "nothing*"], "no subject matches", "noise2d.perlin.lattice"),
            (["--driver", "voodoo"], "there are: osmesa, egl"),
            (["--driver", "egl-gles"], "desktop OpenGL"),
            (["--out", self.folder / "file" / "out"], "cannot make the folder", "--out wants a folder"),
            (["--out", self.folder / "file"], "cannot make the folder", "--out wants a folder"),
            (["--glsl", self.folder], "a copy of every file of glsl/hashnoise/"),
        ):
            with self.subTest(arguments=arguments):
                start = sum(os.times()[2:4])
                # The whole library: nothing of it may have been measured before the message.
                done = self.call("bench", *arguments, *([] if "--out" in arguments else ["--out", self.out]))
                self.assertLess(sum(os.times()[2:4]) - start, 60)
                self.assert_refused(done, *expected)
                self.assertNotIn("compile", done.stderr)
                self.assertFalse((self.out / "bench.csv").exists())

    def test_dump_writes_what_was_counted(self):
        shader = self.write("noise.glsl", VALUE_NOISE)
        done = self.bench("--dump", "--filter", "noise3d.perlin.lattice", "--against", f"v={shader}:value_noise(p)")
        self.assertEqual(done.returncode, 0, done.stderr)
        subjects = self.subjects()
        self.assertEqual(sorted(path.stem for path in (self.out / "spirv").iterdir()), sorted(subjects))
        for name, subject in subjects.items():
            with self.subTest(name=name):
                self.assertEqual(instructions_of(self.out / "spirv" / f"{name}.spv"), int(subject["spirv"]))


class SpirvCli(ProgramTest):
    def setUp(self):
        super().setUp()
        self.noise = self.folder / "noise.glsl"
        self.noise.write_text(VALUE_NOISE)

    def spirv(self, *arguments):
        return self.call("spirv", "--out", self.out, *arguments)

    def test_writes_what_bench_counts_without_a_driver(self):
        done = self.spirv("--filter", ONE_SUBJECT, "--against", f"v={self.noise}:value_noise(p)")
        self.assertEqual(done.returncode, 0, done.stderr)
        dimensions = dict(line.split() for line in done.stdout.splitlines())
        self.assertEqual(dimensions, {"empty2": "2", "empty3": "3", ONE_SUBJECT: "2", "v2": "2"})
        for name in dimensions:
            file = self.folder / "out" / "spirv" / f"{name}.spv"
            self.assertEqual(file.read_bytes()[:4], b"\x03\x02\x23\x07")
            subprocess.run(["spirv-val", "--target-env", "vulkan1.0", file], check=True)

    def test_what_cannot_be_is_status_2(self):
        for arguments, part in ((["--filter", "nothing"], "no subject matches --filter 'nothing'"),
                                (["--filter", "nothing", "--against", f"v={self.noise}:vec2(p)"],
                                 "this does not compile with #version 450 for Vulkan"),
                                (["--against", "v=absent.glsl:p.x"], 'there is no file "absent.glsl"')):
            with self.subTest(arguments=arguments):
                self.assert_refused(self.spirv(*arguments), part)
                self.assertFalse(self.out.exists())

    def test_statistics_are_those_that_the_driver_tells(self):
        self.assertEqual(self.spirv("--filter", ONE_SUBJECT).returncode, 0)
        good = self.folder / "out" / "spirv" / f"{ONE_SUBJECT}.spv"
        drivers = ":".join(map(str, pathlib.Path("/usr/share/vulkan/icd.d").glob("radeon_icd*.json")))
        done = self.call("shader-statistics", good, self.folder / "absent.spv", good,
                         environment={"VK_DRIVER_FILES": drivers, "VK_ICD_FILENAMES": drivers, "NODEVICE_SELECT": "1",
                                      "RADV_FORCE_FAMILY": "navi21"})
        device, *shaders = map(json.loads, done.stdout.splitlines())
        if "error" in device:
            self.skipTest(device["error"])  # no RADV is here, or one that does without GPUs in another way
        self.assertRegex(device["device"], "(?i)navi21")
        self.assertEqual(["error" in shader for shader in shaders], [False, True, False])
        self.assertIn("absent.spv", shaders[1]["error"])
        self.assertGreater(shaders[0]["statistics"]["Instructions"], 10)
        self.assertGreater(shaders[0]["seconds"], 0)

    def test_statistics_without_a_driver_say_so(self):
        done = subprocess.run([PROGRAM, "shader-statistics", self.noise], capture_output=True, text=True, check=False,
                              env={"VK_DRIVER_FILES": "/absent.json", "VK_ICD_FILENAMES": "/absent.json"}, timeout=120)
        self.assertEqual(done.returncode, 1)
        self.assertIn("libvulkan", json.loads(done.stdout)["error"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
