#!/usr/bin/env python3
"""hn-conform run on several drivers, and of parts of the cases."""

import json
import shutil
import unittest

from program import CHEAP, ROOT, ProgramTest


class Run(ProgramTest):
    def run_program(self, *arguments, out=None, environment=None):
        return self.call("run", "--out", out or self.out, *arguments, environment=environment)

    def runs(self, out=None):
        results = json.loads(((out or self.out) / "results.json").read_text())
        return {run["driver"]: run for run in results["runs"]}

    def test_a_new_run_says_so(self):
        journal = self.out / "journal.jsonl"
        for arguments, message in ((("--resume",), "nothing to resume"),
                                   ((), f"what an earlier run left in {journal} for --resume is removed")):
            done = self.run_program(*arguments, "--filter", CHEAP)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(message, done.stderr)
            self.assertFalse(journal.exists())
            journal.write_text("kept\n")

    def test_shards_are_the_whole(self):
        filters = ("--filter", "noise2d.perlin.lattice.*golden", "--filter", "noise2d.*highp")
        self.assertEqual(self.run_program(*filters, out=self.folder / "whole").returncode, 0)
        shards = []
        for shard in ("1/2", "2/2"):
            shards.append(self.folder / shard[0])
            self.assertEqual(self.run_program(*filters, "--shard", shard, out=shards[-1]).returncode, 0)
        merge = ("merge", "--out", self.out)
        done = self.call(*merge, shards[0])
        self.assertEqual(done.returncode, 1)
        self.assertIn("cases are missing", done.stderr + done.stdout)
        self.assertIn("cases are missing; not all of its shards are here", (self.out / "index.html").read_text())
        self.assertTrue(any(run.get("missing") and not run["as_expected"] for run in self.runs().values()))
        done = self.call(*merge, *shards)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("All as expected: ", (self.out / "index.html").read_text())
        self.assertTrue((self.out / "junit.xml").exists())
        whole, merged = self.runs(self.folder / "whole"), self.runs()
        self.assertEqual(set(whole), {"osmesa", "glslang"})
        self.assertEqual(len(merged["osmesa"]["commands"]), 2)
        for driver, run in whole.items():
            for case in [*run["cases"], *merged[driver]["cases"]]:
                for measured in ("seconds", "processor_seconds"):
                    case.pop(measured, None)
            self.assertEqual(merged[driver]["cases"], run["cases"])
        self.assert_refused(self.call(*merge, *shards, shards[0]), "twice")

    def test_drivers_are_named_globbed_and_may_be_missing(self):
        one = ("--filter", CHEAP.replace("gl330", "es300"))
        done = self.run_program("--driver", "egl*", *one)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        self.assertLessEqual({"egl", "egl-gles", "egl-device:0"}, set(self.runs()))
        done = self.run_program("--driver", "osmesa", "--driver", "egl-device:99", *one)
        self.assertEqual(done.returncode, 3)
        self.assertIn("no EGL device 99", self.runs()["egl-device:99"]["absent"])
        self.assertEqual(self.runs()["osmesa"]["totals"]["pass"], 1)
        done = self.run_program("--driver", "metal", *one)
        self.assertEqual(done.returncode, 2)
        self.assertIn("glfw-osmesa", done.stderr)

    def test_a_driver_gets_the_cases_of_its_platform(self):
        both = ("--filter", CHEAP, "--filter", "hash.word.lattice.exact.compute.vulkan.golden",
                "--filter", "hash.word.lattice.exact.compute.hlsl60.golden")
        done = self.run_program("--driver", "osmesa", "--driver", "vulkan:99", *both)
        self.assertEqual(done.returncode, 3)
        self.assertIn("there is no Vulkan device 99", self.runs()["vulkan:99"]["absent"])
        self.assertEqual([case["id"].split(".")[5] for case in self.runs()["osmesa"]["cases"]], ["gl330"])
        done = self.run_program("--driver", "osmesa", *both[2:])
        self.assertEqual(done.returncode, 2)
        self.assertIn("no case is for one of these drivers", done.stderr)
        # Without a loader, or without a driver, all else goes on as before.
        done = self.run_program("--driver", "vulkan:0", "--driver", "osmesa", *both,
                                environment={"VK_DRIVER_FILES": "/nowhere", "VK_ICD_FILENAMES": "/nowhere"})
        self.assertEqual(done.returncode, 3)
        self.assertEqual(self.runs()["osmesa"]["totals"]["pass"], 1)

    def vulkan(self, *arguments):
        """A run on all devices of Vulkan."""
        done = self.run_program("--driver", "vulkan:*", *arguments)
        if "there is no driver" in done.stderr:
            self.skipTest("no device of Vulkan is here")
        return done

    def test_vulkan_runs_each_language_and_notices_a_changed_constant(self):
        some = ("--deal", "--filter", "noise2d.perlin.lattice.fixed.*.vulkan.*", "--filter",
                "noise2d.perlin.lattice.fixed.*.hlsl60.*", "--filter", "noise3d.perlin.lattice.fast.*.hlsl60.golden")
        done = self.vulkan(*some, "--thorough")
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        for name, run in self.runs().items():
            self.assertGreater(run["totals"]["pass"], 0, name)
            self.assertEqual(run["totals"]["unsupported"], 0, name)
        copy = self.folder / "glsl"
        shutil.copytree(ROOT / "glsl" / "hashnoise", copy)
        text = (copy / "detail/word.glsl").read_text()
        self.assertEqual(text.count("0x2C1B3C6Du"), 1)
        (copy / "detail/word.glsl").write_text(text.replace("0x2C1B3C6Du", "0x2C1B3C6Fu"))
        done = self.vulkan(*some, "--thorough", "--glsl", copy)
        self.assertEqual(done.returncode, 1)
        cases = [case for run in self.runs().values() for case in run["cases"] if not case["id"].endswith(".spirv")]
        wrong = {case["id"].split(".")[5] for case in cases if case["status"] == "fail" and case["mismatches"] > 0}
        self.assertEqual(wrong, {"vulkan", "hlsl60"})
        for case in cases:
            if case["id"].endswith((".golden", ".twin")):
                self.assertEqual(case["status"], "fail", case["id"])

    def test_vulkan_shows_an_injected_fault_in_glsl(self):
        self.vulkan("--inject", "integers_saturated", "--deal", "--filter",
                    "noise2d.perlin.lattice.fixed.compute.*.golden")
        cases = {case["id"].split(".")[5]: case for run in self.runs().values() for case in run["cases"]}
        self.assertEqual(cases["vulkan"]["status"], "fail")
        self.assertGreater(cases["vulkan"]["mismatches"], 0)
        self.assertEqual(cases["hlsl60"]["status"], "unsupported")
        self.assertIn("faults are injected into GLSL", cases["hlsl60"]["message"])

    def test_a_way_names_the_step_that_is_wrong(self):
        script = self.folder / "swaps"
        script.write_text("#!/bin/sh\nspirv-dis $1 | sed s/OpBitwiseXor/OpBitwiseOr/ | "
                          "spirv-as --target-env spv1.0 - -o $2\n")
        script.chmod(0o755)
        driver = ("--driver", "vulkan:0")
        way = ("--through", "spirv-opt", "--through", f"{script} {{in}} {{out}}",
               "--takes", "spirv", "--gives", "spirv")
        done = self.run_program(*driver, *way, "--filter", "hash.word.lattice.exact.compute.vulkan.golden")
        if "is not here" in done.stderr:
            self.skipTest("no device of Vulkan is here")
        self.assertEqual(done.returncode, 1, done.stderr)
        run = self.runs()["vulkan:0"]
        self.assertEqual([step["name"] for step in run["way"]], ["spirv-opt", "swaps"])
        self.assertNotIn("golden", run)
        case, = run["cases"]
        self.assertEqual((case["status"], case["step"]["number"]), ("fail", 2), case["message"])
        self.assertIn("wrong after", case["message"].split("\n")[0])
        self.assertTrue((self.out / case["step"]["input"]).is_file())
        self.assertIn("OpBitwiseXor", case["step"]["text"])
        page = (self.out / "index.html").read_text()
        self.assertIn("<h3>vulkan:0 through spirv-opt ", page)
        self.assertIn("Copy a report for the makers of swaps", page)
        for arguments, message in (((*driver, "--through", "spirv-otp"), "spirv-opt"),
                                   ((*driver, *way[4:]), "are for commands"),
                                   (("--driver", "webgpu", *way[:2]), "driver webgpu: it takes no shader"),
                                   ((*driver, *way[:2], "--filter", CHEAP), "takes spirv, which cases of vulkan, hlsl60 have, and these cases are of ")):
            done = self.run_program(*arguments)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(message, done.stderr)

    # Takes the place of wgpu: any call of it succeeds, and each result is 0.
    WGPU = """import os, sys
class Any:
    def __getattr__(self, name): return results if name == "read_buffer" else self
    def __call__(self, *words, **more): return sizes.append(len(more.get("data", ""))) or self
    def __getitem__(self, name): return "any"
    def __or__(self, other): return self
    size = 1
def results(buffer): return bytes(max(sizes[-20:]) // 4)  # as many as the last points have
sizes = []
gpu = BufferUsage = ShaderStage = Any()
sys.modules["wgpu.backends.wgpu_native"] = type("native", (), {"version_info": (1, 2)})
__version__ = "9.9"
"""

    def test_wgpu_fails_crashes_or_is_absent(self):
        package = self.folder / "wgpu" / "__init__.py"
        package.parent.mkdir()
        for more, status, words in (
                ("", "fail", "got 0 (00000000), expected"),
                ("def results(buffer): print('printed', flush=True); 1 / 0", "fail", "wgpu: division by zero\nprinted"),
                ("def results(buffer): print('printed', flush=True); os.abort()", "crash",
                 "the device was lost\nwgpu: ended by signal 6 (Aborted)\nprinted"),
                ("def results(buffer): raise RuntimeError('the device is lost')", "crash", "the device is lost"),
                ("gpu = None", None, "AttributeError")):
            package.write_text(self.WGPU + more)
            done = self.run_program("--driver", "wgpu", "--filter", "noise2d.perlin.lattice.fixed.compute.wgsl.golden",
                                    environment={"HN_WGPU": str(self.folder)})
            with self.subTest(more):
                run = self.runs()["wgpu"]
                if status is None:
                    self.assertEqual(done.returncode, 3)
                    self.assertIn(words, run["absent"])
                    continue
                self.assertEqual(run["gl_version"], "wgpu 9.9, wgpu-native 1.2")
                self.assertEqual(run["cases"][0]["status"], status)
                self.assertIn(words, run["cases"][0]["message"])

    def test_only_an_expectation_excuses_and_only_what_needs_it(self):
        one = ("--inject", "abs_int", "--filter", CHEAP)
        more = ("--filter", "bugs.modulo_of_non_negative.any.exact.fragment.gl330.defined")  # does not notice it
        expect = self.folder / "expect"
        expect.mkdir()
        table = expect / "some.csv"
        row = "driver,renderer,case,status,reason\nosmesa,*,bugs.abs_of_int.*,fail,a fault is injected\n"
        table.write_text(row)
        self.assertEqual(self.run_program(*one).returncode, 1)
        done = self.run_program("--expect", expect, *one)
        # Nothing passed, so an excuse is not enough.
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.run_program("--expect", expect, *one, *more).returncode, 0)
        done = self.run_program("--expect", expect, *one[2:], *more)
        self.assertEqual(done.returncode, 1)
        self.assertIn("needs no excuse", done.stdout)
        table.write_text(row.replace("abs_of_int", "abs_of_none"))
        done = self.run_program("--expect", expect, *more)
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"{table}:2: no case matches", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
