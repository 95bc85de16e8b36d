#!/usr/bin/env python3
"""hn-bake's messages on wrong expressions, and its exit status. Usage: bake_expression_test.py PATH-OF-HN-BAKE

Each compilation takes a second. expression_test.cpp compiles one for all, and tests the values."""

from __future__ import annotations

import os
import pathlib
import pty
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
VALUE = ["--expression", "hn_value(p)"]
FOREVER = "float forever(float x) { while (true) { x += 1.0; } return x; }\n"


class Expressions(unittest.TestCase):
    def setUp(self):
        for name in ("folder", "temporary"):
            folder = tempfile.TemporaryDirectory()
            self.addCleanup(folder.cleanup)
            setattr(self, name, pathlib.Path(folder.name))
        self.environment = {**os.environ, "TMPDIR": str(self.temporary)}

    def assert_error(self, arguments, status, *parts):
        """This status, a message with these parts, and no file."""
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, env=self.environment, capture_output=True,
                              text=True, check=False, timeout=120)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertTrue(done.stderr.startswith("hn-bake: "), done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)
        self.assert_nothing_is_left()

    def assert_nothing_is_left(self):
        self.assertEqual([path.name for path in self.folder.iterdir() if path.suffix != ".glsl"], [])
        self.assertEqual(list(self.temporary.iterdir()), [])

    def test_bad_usage(self):
        for arguments, *parts in (
            ([*VALUE, "-o", "a.png"], "--range LEAST:GREATEST", "--normalize", "png has 16 bits"),
            ([*VALUE, "-o", "a.r16"], "r16 has 16 bits"),
            ([*VALUE, "-o", "a.ktx2"], "--format ktx2-float"),
            ([*VALUE, "--noise", "perlin", "-o", "a.exr"], "--noise is for a function", "hn_fbm(p, 6"),
            ([*VALUE, "--octaves", "6", "-o", "a.exr"], "--octaves is for a function"),
            ([*VALUE, "--wave", "2x1", "-o", "a.exr"], "--wave is for a function"),
            ([*VALUE, "--phase", "0.5", "-o", "a.exr"], "--phase is for a function"),
            ([*VALUE, "--metric", "squared", "-o", "a.exr"], "--metric is for a function"),
            ([*VALUE, "--instruction-set", "sse4.1", "-o", "a.exr"], "--instruction-set is for a function"),
            (["fbm", *VALUE, "-o", "a.exr"], '"fbm"', "in place of a function"),
            (["fbm", "--source", "a.glsl", "-o", "a.exr"], "for an --expression"),
            (["-o", "a.exr"], "a function is missing"),
            ([*VALUE, "--source", "none.glsl", "-o", "a.exr"], "cannot read none.glsl"),
            ([*VALUE, "-o", "none/a.exr"], "there is no folder none"),
            (["--expression", "1.0; 2.0", "-o", "a.exr"], "--expression, line 1, column 4", "\n  1.0; 2.0\n     ^\n"),
            (["value_d", "--size", "2x2x2x2", "-o", "a.ktx2"], "at most three axes"),
            (["perlin", "--size", "8x8x8", "--columns", "2", "-o", "a.ktx2"], "for volumes in pictures"),
        ):
            with self.subTest(arguments=arguments):
                self.assert_error(arguments, 2, *parts)

    def test_what_the_compiler_refuses_is_told_where_it_stands(self):
        (self.folder / "a.glsl").write_text("float a(vec2 q) {\n  return 0.5 * hn_value(q.yx, 3);\n}\n")
        self.assert_error(["--expression", "a(p)", "--source", "a.glsl", "-o", "a.f32"], 2,
                          "hn-bake: --source a.glsl, line 2, column 24: there is no hn_value(vec2, int)\n"
                          "    return 0.5 * hn_value(q.yx, 3);\n" + 25 * " " + "^\n")

    def test_a_compiler_that_is_missing(self):
        self.environment["CXX"] = "no-such-compiler"
        self.assert_error([*VALUE, "-o", "a.f32"], 4, "no-such-compiler", "install g++ or clang")
        self.environment["CXX"] = "false"
        self.assert_error([*VALUE, "-o", "a.f32"], 4, "could not be compiled", "false ended with status 1")

    def test_a_signal_while_it_is_compiled(self):
        process = subprocess.Popen([PROGRAM, *VALUE, "-o", "a.f32"], cwd=self.folder, env=self.environment,
                                   stderr=subprocess.DEVNULL)
        self.wait_for("expression.cpp")
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(60), -signal.SIGTERM)
        self.assert_nothing_is_left()

    def test_a_loop_without_an_end_is_interrupted(self):
        (self.folder / "a.glsl").write_text(FOREVER)
        ours, theirs = pty.openpty()
        call = [PROGRAM, "--expression", "forever(p.x)", "--source", "a.glsl", "--threads", "2", "-o", "a.f32"]
        process = subprocess.Popen(call, cwd=self.folder, env=self.environment, stderr=theirs)
        os.close(theirs)
        self.wait_for("axes")
        running = self.processes_at_work(process.pid, 2)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(60), -signal.SIGINT)
        self.assert_nothing_is_left()
        printed = os.read(ours, 4096).decode()
        os.close(ours)
        self.assertIn("compiling the expression", printed)
        for child in running:
            self.wait_until(lambda child=child: not self.is_running(child))

    def wait_until(self, there):
        end = time.monotonic() + 60
        while not there():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def wait_for(self, name: str):
        self.wait_until(lambda: list(self.temporary.glob(f"hashnoise-*/{name}")))

    def processes_at_work(self, parent: int, count: int) -> list[str]:
        found: list[str] = []

        def look() -> bool:
            found[:] = [child for path in pathlib.Path(f"/proc/{parent}/task").glob("*/children")
                        for child in path.read_text().split() if self.is_running(child)]
            return len(found) == count

        self.wait_until(look)
        return found

    @staticmethod
    def is_running(pid: str) -> bool:
        try:
            return b"expression" in pathlib.Path(f"/proc/{pid}/cmdline").read_bytes()
        except OSError:
            return False


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
