#!/usr/bin/env python3
"""hn-bench-cpu as its user meets it, and hn-fill.

Usage: bench_cpu_cli_test.py PROGRAM FAKE-FASTNOISE2 NO-FASTNOISE2 HN-FILL
"""

from __future__ import annotations

import csv
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = FAKE = OTHER = FILL = ""
ATTEMPTS = 5  # other programs on the machine can spoil a measurement, but hardly every time


class BenchCpu(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def call(self, *arguments, **environment):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=300,
                              cwd=self.folder, env={**os.environ, **environment})

    def bench(self, *arguments, rounds=3, **environment):
        return self.call("--out", self.out, "--rounds", rounds, "--filter", "perlin2", *arguments, **environment)

    def record(self):
        path, = self.out.glob("*.csv")
        return path.read_text(encoding="utf-8")

    def rows(self):
        return list(csv.DictReader(line for line in self.record().splitlines() if not line.startswith("# ")))

    def fact(self, name):
        found, = (line for line in self.record().splitlines() if line.startswith(f"# {name}: "))
        return found.partition(": ")[2]

    def script(self, text):
        path = self.folder / "python"
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)
        return path

    def assert_bad(self, status, arguments, *parts, **environment):
        done = self.bench(*arguments, **environment)
        self.assertEqual(done.returncode, status, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)
        self.assertEqual(list(self.out.glob("*.*")), [])

    def test_without_another_library(self):
        done = self.bench()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        rows = self.rows()
        self.assertEqual({row["noise"] for row in rows}, {"perlin2"})
        for row in rows:
            for name in ("fixed", "precise", "tiles", "lists", "fast million/s"):
                self.assertGreater(float(row[name]), 0)
            self.assertEqual(row["grids"], "")
        self.assertGreater(float(rows[-1]["threads"]), 0)
        self.assertNotIn(str(self.folder), self.record())

    def test_a_library_whose_speed_is_known(self):
        wrong = None
        for _ in range(ATTEMPTS):
            done = self.bench("--against", f"fastnoise2={FAKE}", "--against", f"strict={FAKE}", rounds=7)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = self.rows()
            seen = {(row["instructions"], name): float(row[name]) for row in rows for name in ("grids", "points")}
            seen |= {(row["instructions"], name): float(row[f"strict {name}"]) / float(row[name]) / float(row["grids"]) * 3
                     for row in rows for name in ("fixed", "precise")}
            wrong = {what: ratio for what, ratio in seen.items()
                     if not 2.4 < ratio < 3.6 and (wrong is None or what in wrong)}
            if not wrong:
                break
        self.assertEqual(wrong, {}, "it computes everything three times")
        self.assertIn("libfake-fast-noise.so", self.fact("command"))
        self.assertNotIn(str(pathlib.Path(FAKE).parent), self.record())

    def test_instructions_that_it_has_not_are_left_out(self):
        done = self.bench("--against", f"fastnoise2={FAKE}", FAKE_FAST_NOISE="instructions")
        self.assertEqual(done.returncode, 0, done.stderr)
        compared = [row["instructions"] for row in self.rows() if row["grids"]]
        self.assertIn(compared, (["sse4.1"], []))  # of another family of processors it has none

    def test_what_is_no_such_library(self):
        self.assert_bad(2, ["--against", "fastnoise2=/nowhere/libFastNoise.so"], "cannot load /nowhere/libFastNoise.so",
                        "BUILD_SHARED_LIBS=ON")
        text = self.folder / "text.so"
        text.write_text("no library")
        self.assert_bad(2, ["--against", f"fastnoise2={text}"], "cannot load", str(text))
        self.assert_bad(2, ["--against", f"fastnoise2={OTHER}"], "has no function fnGetMetadataName")
        self.assert_bad(2, ["--against", f"other={FAKE}"], "fastnoise2=FILE")
        self.assert_bad(2, ["--against", "fastnoise2="], "fastnoise2=FILE")
        self.assert_bad(2, ["--against", "strict=/nowhere/libFastNoise.so"], "cannot load /nowhere/libFastNoise.so")
        self.assert_bad(1, ["--against", f"fastnoise2={FAKE}"], "has no node Perlin", FAKE_FAST_NOISE="node")
        self.assert_bad(1, ["--against", f"fastnoise2={FAKE}"], "no variable Feature Scale", FAKE_FAST_NOISE="variable")
        self.assert_bad(1, ["--against", f"fastnoise2={FAKE}", "--filter", "value2"], "has no node Value")

    def test_bad_usage(self):
        for arguments, part in ((["--rounds", "2"], "--rounds"), (["--round", "3"], "--round"), (["x"], "x"),
                                (["--out", "/dev/null/x"], "/dev/null/x"), (["--filter", "nothing"], "no subject")):
            with self.subTest(arguments=arguments):
                done = self.call(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(part, done.stderr)

    def test_python(self):
        slow = self.script("echo 1000 2000")
        done = self.bench("--python", slow)
        self.assertEqual(done.returncode, 0, done.stderr)
        new, own = (float(self.fact(f"Python with {what}").split()[0]) for what in ("a new array", "out="))
        self.assertAlmostEqual(new / own, 2, places=3)
        self.assert_bad(1, ["--python", self.script("echo none")], '"none\\x0a" and not two times')
        self.assert_bad(1, ["--python", self.script("echo no module >&2; exit 1")], "no module")
        self.assert_bad(1, ["--python", "/nowhere/python3"], "/nowhere/python3")

    def test_a_signal_ends_it(self):
        # Where the tests run in the background of a script, the signal is ignored, and so it would be by the program.
        process = subprocess.Popen([PROGRAM, "--out", self.out, "--rounds", "1000"], cwd=self.folder,
                                   stderr=subprocess.PIPE, text=True,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.addCleanup(process.kill)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        _, printed = process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertIn("no results are written", printed)
        self.assertEqual(list(self.out.glob("*.*")), [])

    def test_help(self):
        done = self.call("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Exit status: 0 done", done.stdout)


class Fill(unittest.TestCase):
    def call(self, *arguments, **environment):
        done = subprocess.run([FILL, *arguments], capture_output=True, text=True, check=False, timeout=300,
                              env={**os.environ, **environment})
        return done.returncode, done.stdout, done.stderr

    def test_what_there_is_to_fill(self):
        status, out, _ = self.call("--list")
        head, *ids = out.splitlines()
        self.assertEqual((status, head), (0, f"{1 << 20} 0.0371"))
        self.assertEqual(len(ids), len(set(ids)))
        self.assertLess({"value2", "cellular3", "fbm_perlin2", "ridged_simplex3"}, set(ids))

    def test_nothing_else_is_done(self):
        for what in ("fast", "fixed", "precise", f"fastnoise2={FAKE}"):
            self.assertEqual(self.call(what, "perlin2", "1"), (0, "", ""))
        self.assertEqual(self.call("fast", "perlin3", "1"), (0, "", ""))

    def test_another_library_that_is_none(self):
        for file, environment, expected, part in ((OTHER, {}, 2, "has no function fnGetMetadataName"),
                                                  ("/nowhere/x.so", {}, 2, "cannot load /nowhere/x.so"),
                                                  (FAKE, {"FAKE_FAST_NOISE": "node"}, 1, "has no node Perlin"),
                                                  (FAKE, {"FAKE_FAST_NOISE": "all instructions"}, 1,
                                                   "this FastNoise2 has no ")):
            status, out, err = self.call(f"fastnoise2={file}", "perlin2", "1", **environment)
            self.assertEqual((status, out), (expected, ""))
            self.assertIn(part, err)

    def test_bad_usage(self):
        for words in ((), ("--help",), ("fast", "perlin2"), ("quick", "perlin2", "1"), ("fast", "perlin4", "1"),
                      ("fast", "perlin2", "0"), ("fast", "perlin2", "1001"), ("fast", "perlin2", "1x"),
                      ("fast", "perlin2", "1", "1")):
            status, out, err = self.call(*words)
            self.assertEqual((status, out), (2, ""), words)
            self.assertIn("usage: hn-fill", err)


if __name__ == "__main__":
    PROGRAM, FAKE, OTHER, FILL = sys.argv[1:5]
    unittest.main(argv=sys.argv[:1])
