#!/usr/bin/env python3
"""hn-conform bench as its user meets it. Usage: bench_cli_test.py PATH-OF-HN-CONFORM"""

import csv
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
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


class BenchCli(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A run of one subject, whose results the tests take for those of an earlier run."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.earlier = pathlib.Path(folder.name) / "earlier"
        subprocess.run([PROGRAM, "bench", "--out", cls.earlier, "--rounds", "3", "--filter", ONE_SUBJECT], check=True,
                       capture_output=True, timeout=120)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def call(self, *arguments):
        # A loop without end must not hang the tests.
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=120)

    def bench(self, *arguments):
        return self.call("bench", "--out", self.out, "--rounds", "3", "--filter", ONE_SUBJECT, *arguments)

    def have_run(self):
        shutil.copytree(self.earlier, self.out)

    def report(self):
        return json.loads((self.out / "bench.json").read_text())

    def subjects(self):
        return {subject["id"]: subject for subject in self.report()["subjects"]}

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def test_a_comparison_tells_what_it_is_worth(self):
        self.have_run()
        report = self.report()
        report["renderer"] = "Voodoo"
        report["subjects"] = [subject for subject in report["subjects"] if subject["id"] == "table.float2"]
        report["subjects"].append({"id": "gone", "ratio": 1.0, "spread": 0.0})
        baseline = self.write("baseline.json", json.dumps(report))
        done = self.bench("--baseline", baseline)
        self.assertIn("another renderer: Voodoo", done.stdout)
        self.assertIn("1 subjects compared; 1 of the baseline were not measured now", done.stdout)

    def assert_everything_is_there(self, *ids):
        """The same subjects in bench.json, in bench.csv and on the page."""
        self.assertEqual(sorted(self.subjects()), sorted([*REFERENCES, *ids]))
        with open(self.out / "bench.csv", newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual({len(row) for row in rows}, {len(rows[0])})
        self.assertEqual([row[0] for row in rows[1:]], [subject["id"] for subject in self.report()["subjects"]])
        page = (self.out / "index.html").read_text()
        for name in self.subjects():
            self.assertIn(f"<th>{name}</th>", page)

    def test_a_run_leaves_its_numbers_and_where_they_are_from(self):
        done = self.bench("--filter", "noise2d.perlin.lattice+fixed")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{self.out}/index.html", done.stdout)
        self.assertEqual(sorted(path.name for path in self.out.iterdir()), ["bench.csv", "bench.json", "index.html"])
        self.assert_everything_is_there(ONE_SUBJECT, "noise2d.perlin.lattice+fixed")
        report = self.report()
        self.assertEqual(report["driver"], "osmesa")
        self.assertEqual(report["rounds"], 3)
        self.assertRegex(report["date"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertIn(f"bench --out {self.out} --rounds 3 --filter {ONE_SUBJECT}", report["command"])
        page = html.unescape((self.out / "index.html").read_text())
        for part in (report["date"], report["command"], report["renderer"], report["timing"]["clock"],
                     report["timing"]["reason"], "osmesa"):
            self.assertIn(part, page)
        for name, reason in report["absent_counts"].items():
            self.assertIn(f"No counts from {name} here: {reason}", page)
        subjects = self.subjects()
        for name, subject in subjects.items():
            self.assertGreater(subject["instructions"]["spirv"], 0, name)
            self.assertGreater(subject["compile_seconds"], 0, name)
            self.assertGreaterEqual(subject["spread"], 0, name)
        for dimensions in (2, 3):
            self.assertEqual(subjects[f"empty{dimensions}"]["ratio"], 0)
            self.assertEqual(subjects[f"table.float{dimensions}"]["ratio"], 1)
            self.assertEqual(subjects[f"table.float{dimensions}"]["spread"], 0)

    def test_other_peoples_shaders_are_measured(self):
        both = self.write("both.glsl", VALUE_NOISE + VALUE_NOISE_3D)
        plane = self.write("in:the plane.glsl", VALUE_NOISE)
        space = self.write("space.glsl", (VALUE_NOISE + VALUE_NOISE_3D).replace("value_noise(vec2", "flat_noise(vec2")
                           .replace("value_noise(p.xy", "flat_noise(p.xy"))
        versions = self.write("versions.glsl", "#version 120\n" + VALUE_NOISE + "// #version 100\n#version 300 es")
        extended = self.write("extended.glsl", "# version 330\n#extension GL_ARB_gpu_shader5 : enable\n" + VALUE_NOISE)
        # It has its version, and its neighbours.
        self.write("corner.glsl", VALUE_NOISE)
        braces = self.write("braces.glsl", "#include \"corner.glsl\"\nconst float kTwo[] = { 1.0, 2.0 };\n"
                            "float two(vec2 p) { return kTwo[int(p.x) & 1] * value_noise(p); }\n")
        self.assertEqual(self.bench("--against", f"braces={braces}:two(p)").returncode, 2)
        done = self.bench("--against", f"both={both}:value_noise(p) * 2.0 - 1.0", "--against",
                          f"plane={plane}:value_noise(p)", "--against", f"space={space}:value_noise(p)", "--against",
                          f"versions={versions}:value_noise(p)", "--against",
                          f"choice={both}:p.x > 0.5 ? value_noise(p) : 0.0", "--against",
                          f"extended={extended}:value_noise(p) // a comment", "--against",
                          f"braces@420={braces}:two(p)")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assert_everything_is_there(ONE_SUBJECT, "both2", "both3", "braces2", "choice2", "choice3", "extended2",
                                        "plane2", "space3", "versions2")
        for name, subject in self.subjects().items():
            self.assertNotIn("error", subject, name)
        # It is not an empty shader that was measured.
        for name in ("both2", "braces2"):
            self.assertGreater(self.subjects()[name]["instructions"]["spirv"],
                               self.subjects()["empty2"]["instructions"]["spirv"] + 10)

    def test_what_does_not_compile_is_told_before_anything_is_measured(self):
        good = self.write("good.glsl", VALUE_NOISE)
        broken = self.write("broken.glsl", VALUE_NOISE.replace("floor(p)", "flor(p)"))
        older = self.write("older.glsl", "#version 120\n" + VALUE_NOISE.replace("floor(p)", "flor(p)"))
        self.have_run()
        before = (self.out / "bench.json").read_text()
        start = time.monotonic()
        # The whole library would take minutes. Other tests run beside this one.
        done = self.call("bench", "--out", self.out, "--against", f"good={good}:value_noise(p)", "--against",
                         f"broken={broken}:value_noise(p)", "--against", f"older={older}:value_noise(p)", "--against",
                         f"vector={good}:vec2(p)", "--against", f"whole={good}:int(p.x)", "--against",
                         f"absent={good}:simplex(p)")
        self.assertLess(time.monotonic() - start, 60)
        self.assertEqual(done.returncode, 2, done.stderr)
        for part in (f"broken={broken}:value_noise(p)", f"{broken}:4", f"{older}:5", f"{good}:vec2(p)",
                     f"{good}:int(p.x)", "simplex", "the expression of absent:1"):
            self.assertIn(part, done.stderr)
        self.assertNotIn("good=", done.stderr)
        self.assertEqual((self.out / "bench.json").read_text(), before)

    def test_bad_usage_is_status_2_and_says_what_would_be_right(self):
        shader = self.write("noise.glsl", VALUE_NOISE)
        self.write("file", "")
        self.write("text.json", "no JSON")
        self.write("results.json", '{"schema": 1, "runs": []}')
        for arguments, *expected in (
            (["--against", "noise"], "there is no name", "write NAME=FILE:EXPRESSION"),
            (["--against", f"{shader}:value_noise(p)"], "there is no name", "write NAME=FILE:EXPRESSION"),
            (["--against", f"={shader}:value_noise(p)"], "there is no name", "write NAME=FILE:EXPRESSION"),
            (["--against", f"v={shader}"], "there is no expression", "write NAME=FILE:EXPRESSION"),
            (["--against", f"v={shader}:"], "there is no expression", "write NAME=FILE:EXPRESSION"),
            (["--against", f"v={shader}: "], "there is no expression", "write NAME=FILE:EXPRESSION"),
            (["--against", f"v={self.folder}/none.glsl:value_noise(p)"], f"there is no file \"{self.folder}/none.glsl\""),
            (["--against", f"v={self.folder}:value_noise(p)"], f"there is no file \"{self.folder}\""),
            (["--against", f"v@425={shader}:value_noise(p)"], "\"425\" is not a version", "there are 330, 400"),
            (["--against", f"@420={shader}:value_noise(p)"], "there is no name"),
            (["--against", f"a.b={shader}:value_noise(p)"], "a name is a word", "a.b"),
            (["--against", f"../a={shader}:value_noise(p)"], "a name is a word", "../a"),
            (["--against", f"empty={shader}:value_noise(p)"], "empty"),
            (["--against", f"v={shader}:1.0", "--against", f"v={shader}:2.0"], "the name v is used twice"),
            (["--filter", "nothing*"], "no subject matches", "noise2d.perlin.lattice"),
            (["--driver", "voodoo"], "there are: osmesa, egl"),
            (["--driver", "egl-gles"], "desktop OpenGL"),
            (["--baseline", self.folder / "none.json"], "cannot read", "none.json", "--baseline wants a bench.json"),
            (["--baseline", self.folder / "text.json"], "text.json is not a bench.json"),
            (["--baseline", self.folder / "results.json"], "results.json is not a bench.json"),
            (["--baseline", self.folder], "cannot read", "--baseline wants a bench.json"),
            (["--out", self.folder / "file" / "out"], "cannot make the folder", "--out wants a folder"),
            (["--out", self.folder / "file"], "cannot make the folder", "--out wants a folder"),
            (["--glsl", self.folder], "a copy of every file of glsl/hashnoise/"),
            (["--rounds", "2"], "--rounds"),
            (["--rounds", "few"], "--rounds"),
            (["--frobnicate"], "frobnicate"),
        ):
            with self.subTest(arguments=arguments):
                start = time.monotonic()
                # The whole library: nothing of it may have been measured before the message.
                done = self.call("bench", *arguments, *([] if "--out" in arguments else ["--out", self.out]))
                self.assertLess(time.monotonic() - start, 60)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                for part in expected:
                    self.assertIn(part, done.stderr + done.stdout)
                self.assertNotIn("compile", done.stderr)
                self.assertFalse((self.out / "bench.json").exists())

    def test_help_is_status_0(self):
        self.assertEqual(self.call("bench", "--help").returncode, 0)

    def changed_baseline(self, name, change):
        """The result of the last run with change(subject) applied."""
        report = self.report()
        for subject in report["subjects"]:
            change(subject)
        return self.write(name, json.dumps(report))

    def test_slower_than_the_baseline_is_status_1_and_no_slower_is_0(self):
        self.have_run()

        # The spread of a few rounds on a busy machine may be any, so these differ by more than machines do.
        def was_fast(subject):
            subject["spread"] = 0
            subject["ratio"] = -1000 if subject["id"] == ONE_SUBJECT else 1000

        def was_unsteady(subject):
            subject["spread"] = 1e9

        fast = self.changed_baseline("fast.json", was_fast)
        done = self.bench("--baseline", fast)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(re.findall(r"^SLOWER (\S+):", done.stdout, re.MULTILINE), [ONE_SUBJECT])
        self.assertIn("was -1000.000 +- 0.000", done.stdout)
        page = (self.out / "index.html").read_text()
        self.assertEqual(page.count('<span class="bad">slower</span>'), 1)

        # The result of a run may be the baseline of the one that replaces it.
        (self.out / "bench.json").write_text(self.changed_baseline("unsteady.json", was_unsteady).read_text())
        done = self.bench("--baseline", self.out / "bench.json")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("SLOWER", done.stdout)
        self.assertIn("Against the baseline", (self.out / "index.html").read_text())
        self.assertLess(self.subjects()[ONE_SUBJECT]["spread"], 1e9)

    def test_dump_writes_what_was_counted(self):
        shader = self.write("noise.glsl", VALUE_NOISE)
        done = self.bench("--dump", "--filter", "noise3d.perlin.lattice", "--against", f"v={shader}:value_noise(p)")
        self.assertEqual(done.returncode, 0, done.stderr)
        subjects = self.subjects()
        self.assertEqual(sorted(path.stem for path in (self.out / "spirv").iterdir()), sorted(subjects))
        for name, subject in subjects.items():
            with self.subTest(name=name):
                text = subprocess.run(["spirv-dis", "--no-color", self.out / "spirv" / f"{name}.spv"],
                                      capture_output=True, text=True, check=True).stdout
                operations = re.findall(r"^\s*(?:%\S+ = )?(Op\w+)", text, re.MULTILINE)
                inside = False
                count = 0
                for operation in operations:
                    inside = inside and operation != "OpFunctionEnd"
                    count += inside and operation not in ("OpLabel", "OpFunctionParameter")
                    inside = inside or operation == "OpFunction"
                self.assertEqual(count, subject["instructions"]["spirv"])


class SpirvCli(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.noise = self.folder / "noise.glsl"
        self.noise.write_text(VALUE_NOISE)

    def spirv(self, *arguments):
        return subprocess.run([PROGRAM, "spirv", "--out", self.folder / "out", *arguments], capture_output=True,
                              text=True, check=False, timeout=120)

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
                done = self.spirv(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(part, done.stderr)
                self.assertFalse((self.folder / "out").exists())

    def test_statistics_are_those_that_the_driver_tells(self):
        self.assertEqual(self.spirv("--filter", ONE_SUBJECT).returncode, 0)
        good = self.folder / "out" / "spirv" / f"{ONE_SUBJECT}.spv"
        drivers = ":".join(map(str, pathlib.Path("/usr/share/vulkan/icd.d").glob("radeon_icd*.json")))
        done = subprocess.run([PROGRAM, "shader-statistics", good, self.folder / "absent.spv", good],
                              capture_output=True, text=True, check=False, timeout=120,
                              env={"VK_DRIVER_FILES": drivers, "VK_ICD_FILENAMES": drivers, "NODEVICE_SELECT": "1",
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
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)
