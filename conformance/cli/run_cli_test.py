#!/usr/bin/env python3
"""hn-conform run on several drivers, and what becomes of it when processes are killed, stopped and split."""

import json
import os
import pathlib
import shutil
import subprocess
import time
import unittest

from program import CHEAP, PROGRAM, ROOT, ProgramTest

SOME = ("--thorough", "--filter", "hash.*.fragment.gl330.golden")  # many that are compiled quickly


def runs(pid):
    """Not a process that has ended and waits for whoever adopted it to ask, which an init of a container may never
    do."""
    try:
        status = pathlib.Path(f"/proc/{pid}/stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return False
    return status.rpartition(")")[2].split()[0] != "Z"


def children(pid):
    """The processes that run cases, by driver."""
    found = {}
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            text = status.read_text()
            command = (status.parent / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue  # it ended in the meantime
        if int(text[text.rindex(")") + 2:].split()[1]) == pid and len(command) > 2 and command[1] == b"child":
            found[pathlib.Path(command[2].decode()).stem] = int(status.parent.name)
    return found


class Run(ProgramTest):
    def start(self, *arguments, out=None, environment=None):
        command = [PROGRAM, "run", "--out", out or self.out, *arguments]
        process = subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env={**os.environ, **(environment or {})})
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        return process

    def run_program(self, *arguments, out=None, environment=None):
        process = self.start(*arguments, out=out, environment=environment)
        process.out, process.err = process.communicate()
        return process

    def runs(self, out=None):
        results = json.loads(((out or self.out) / "results.json").read_text())
        return {run["driver"]: run for run in results["runs"]}

    def statuses(self, driver, out=None):
        return {case["id"]: case["status"] for case in self.runs(out)[driver]["cases"]}

    def wait_for_cases(self, count):
        """Waits until the journal has so many results."""
        deadline = time.monotonic() + 60
        journal = self.out / "journal.jsonl"
        while time.monotonic() < deadline:
            if journal.exists() and journal.read_text().count('"result"') >= count:
                return
            time.sleep(0.01)
        self.fail("the run does not begin")

    def test_a_run_that_is_killed_is_resumed(self):
        process = self.start("--driver", "osmesa", "--jobs", 1, *SOME)
        self.wait_for_cases(20)
        pids = children(process.pid)
        process.kill()
        process.communicate()
        deadline = time.monotonic() + 30
        while any(map(runs, pids.values())) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertFalse(any(map(runs, pids.values())), "a child is left")
        lines = (self.out / "journal.jsonl").read_text().splitlines()
        done = self.run_program("--driver", "osmesa", "--jobs", 1, "--seed", 2, "--resume", *SOME)
        self.assertEqual(done.returncode, 2)
        self.assertIn("other settings: \"suite\"", done.err)
        done = self.run_program("--driver", "osmesa", "--jobs", 1, "--resume", *SOME)
        self.assertEqual(done.returncode, 0, done.out)
        self.assertEqual(list(self.statuses("osmesa")), self.listed(*SOME))
        # Earlier results stay as they were, to the time that each took.
        before = [json.loads(line)["report"]["result"] for line in lines if '"result"' in line and line.endswith("}")]
        after = {case["id"]: case for case in self.runs()["osmesa"]["cases"]}
        self.assertGreaterEqual(len(before), 20)
        for case in before:
            self.assertEqual(after[case["id"]]["seconds"], case["seconds"])

    def test_resuming_nothing_is_a_new_run(self):
        done = self.run_program("--resume", "--filter", CHEAP)
        self.assertEqual(done.returncode, 0, done.err)
        self.assertIn("nothing to resume", done.err)

    def test_a_new_run_says_that_it_removes_what_could_be_resumed(self):
        journal = pathlib.Path(self.out) / "journal.jsonl"
        journal.parent.mkdir(parents=True, exist_ok=True)
        journal.write_text("kept\n")
        done = self.run_program("--filter", CHEAP)
        self.assertEqual(done.returncode, 0, done.err)
        self.assertIn(f"what an earlier run left in {journal} for --resume is removed", done.err)
        self.assertFalse(journal.exists())

    def test_shards_are_the_whole(self):
        filters = ("--filter", "noise2d.perlin.*golden", "--filter", "noise2d.*highp")
        self.assertEqual(self.run_program(*filters, out=self.folder / "whole").returncode, 0)
        shards = []
        for shard in ("1/3", "2/3", "3/3"):
            shards.append(self.folder / shard[0])
            self.assertEqual(self.run_program(*filters, "--shard", shard, out=shards[-1]).returncode, 0)
        merge = ("merge", "--out", self.out)
        done = self.call(*merge, *shards[:2])
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
        self.assertEqual(len(merged["osmesa"]["commands"]), 3)
        for driver, run in whole.items():
            for case in [*run["cases"], *merged[driver]["cases"]]:
                for measured in ("seconds", "processor_seconds"):
                    case.pop(measured, None)
            self.assertEqual(merged[driver]["cases"], run["cases"])
        self.assert_refused(self.call(*merge, *shards, shards[0]), "twice")

    def test_drivers_are_named_globbed_and_may_be_missing(self):
        one = ("--filter", CHEAP.replace("gl330", "es300"))
        done = self.run_program("--driver", "egl*", *one)
        self.assertEqual(done.returncode, 0, done.err + done.out)
        self.assertLessEqual({"egl", "egl-gles", "egl-device:0"}, set(self.runs()))
        done = self.run_program("--driver", "osmesa", "--driver", "egl-device:99", *one)
        self.assertEqual(done.returncode, 3)
        self.assertIn("no EGL device 99", self.runs()["egl-device:99"]["absent"])
        self.assertEqual(self.runs()["osmesa"]["totals"]["pass"], 1)
        done = self.run_program("--driver", "metal", *one)
        self.assertEqual(done.returncode, 2)
        self.assertIn("glfw-osmesa", done.err)

    def test_a_driver_gets_the_cases_of_its_platform(self):
        both = ("--filter", "noise2d.perlin.lattice.fixed.fragment.gl330.golden",
                "--filter", "noise2d.perlin.lattice.fixed.*.vulkan.golden",
                "--filter", "noise2d.perlin.lattice.fixed.*.hlsl60.golden")
        done = self.run_program("--driver", "osmesa", "--driver", "vulkan:99", *both)
        self.assertEqual(done.returncode, 3)
        self.assertIn("there is no Vulkan device 99", self.runs()["vulkan:99"]["absent"])
        self.assertEqual([case["id"].split(".")[5] for case in self.runs()["osmesa"]["cases"]], ["gl330"])
        done = self.run_program("--driver", "osmesa", *both[2:])
        self.assertEqual(done.returncode, 2)
        self.assertIn("no case is for one of these drivers", done.err)
        # Without a loader, or without a driver, all else goes on as before.
        done = self.run_program("--driver", "vulkan:0", "--driver", "osmesa", *both,
                                environment={"VK_DRIVER_FILES": "/nowhere", "VK_ICD_FILENAMES": "/nowhere"})
        self.assertEqual(done.returncode, 3)
        self.assertEqual(self.runs()["osmesa"]["totals"]["pass"], 1)

    def vulkan(self, *arguments):
        """A run on all devices of Vulkan."""
        done = self.run_program("--driver", "vulkan:*", *arguments)
        if "there is no driver" in done.err:
            self.skipTest("no device of Vulkan is here")
        return done

    def test_vulkan_runs_each_language_and_notices_a_changed_constant(self):
        some = ("--deal", "--filter", "noise2d.perlin.lattice.fixed.*.vulkan.*", "--filter",
                "noise2d.perlin.lattice.fixed.*.hlsl60.*", "--filter", "noise3d.perlin.lattice.fast.*.hlsl60.golden")
        done = self.vulkan(*some, "--thorough")
        self.assertEqual(done.returncode, 0, done.err + done.out)
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
        self.assertIn("needs no excuse", done.out)
        table.write_text(row.replace("abs_of_int", "abs_of_none"))
        done = self.run_program("--expect", expect, *more)
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"{table}:2: no case matches", done.err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
