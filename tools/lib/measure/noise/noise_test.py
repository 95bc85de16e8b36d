"""Tests of tools/measure noise: each defect in a noise is found, and ours has none."""

from __future__ import annotations

import re
import unittest
from unittest import mock

import numpy as np

from base.renderer import Renderer
from base.testing import Case, called
from base.thorough import in_thorough_runs
from measure import stamps
from measure.noise import command, measures, page, record
from measure.noise.measures import Finding, Measured
from measure.noise.noise import Sampler, Subject

# Value noise with a good hash and its derivatives, from which each control takes something.
NOISE = """
uint mixed(uint k) { k = (k ^ (k >> 16u)) * 0x7FEB352Du; k = (k ^ (k >> 15u)) * 0x846CA68Bu; return k ^ (k >> 16u); }
float corner(ivec2 c, uint seed) {
  return float(mixed(uint(c.x) + mixed(uint(c.y) + mixed(seed))) >> 8u) / 8388608.0 - 1.0;
}
float value(vec2 p, uint seed, out vec2 slope) {
  vec2 f = fract(p), t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0), d = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  ivec2 c = ivec2(floor(p));
  float a = corner(c, seed), b = corner(c + ivec2(1, 0), seed), e = corner(c + ivec2(0, 1), seed);
  float g = corner(c + 1, seed);
  slope = d * vec2(mix(b - a, g - e, t.y), mix(e - a, g - b, t.x));
  return mix(mix(a, b, t.x), mix(e, g, t.x), t.y);
}
float value(vec2 p, uint seed) { vec2 slope; return value(p, seed, slope); }
float sine(vec2 c) { return fract(sin(dot(c, vec2(12.9898, 78.233))) * 43758.5453) * 2.0 - 1.0; }
"""
# The measure of its name fails for each.
CONTROLS = {
    "range": "1.05 * value(p, seed)",
    "jumps": "value(p, seed) + step(0.37, fract(p.x * 0.7 + p.y)) * 0.004",
    "derivative": "value(p, seed, slope); slope.y *= 1.03",
    "repeats": "value(mod(p, 173.0), seed)",
    "mirrors": "value(vec2(abs(p.x), p.y), seed)",
    "seeds": "value(p, seed & 0xFEu)",
    "cells": "value(p, seed) + 0.2 * value(p + vec2(64.0, 0.0), seed)",
    "directions": "0.1 * value(p, seed) + sin(p.x * 3.0) * sin(p.y * 3.0)",
    "far": "value(p, seed) * clamp(1.0 - p.x * 1e-4, 0.0, 1.0)",
    "compilers": "sine(floor(p))",
    "values": "value(p, seed) / max(value(p, seed), 0.0)",
}
MEASURES = {"values": measures.spread, "range": measures.extremes, "jumps": measures.jumps,
            "derivative": measures.slopes, "repeats": measures.repeats, "mirrors": measures.mirrors,
            "seeds": measures.seeds, "cells": measures.cells, "directions": measures.directions, "far": measures.far,
            "compilers": lambda m: measures.compilers(m, lambda: command.by_softpipe(m.sampler.subject))}


class Measures(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.renderer = Renderer()

    def setUp(self) -> None:
        self.enterContext(mock.patch.object(measures, "DRAWINGS", 1))

    def measured(self, expression: str) -> Measured:
        return Measured(Sampler(Subject("control", NOISE, expression, 2, (-1.0, 1.0)), self.renderer))

    def test_each_defect_is_told(self) -> None:
        self.assertEqual((set(CONTROLS), set(CONTROLS)), (set(MEASURES), set(command.JUDGED)))
        for name, expression in CONTROLS.items():
            with self.subTest(name):
                finding = MEASURES[name](self.measured(expression))
                self.assertEqual((finding.measure, finding.fails), (name, True), finding.sentence)

    def test_what_has_none_of_them_passes(self) -> None:
        measured = self.measured("value(p, seed, slope)")
        for name, measure in MEASURES.items():
            with self.subTest(name):
                finding = measure(measured)
                self.assertIs(finding.fails, False, finding.sentence)

    def test_a_constant_is_no_noise(self) -> None:
        found = {name: measure(self.measured("0.5")) for name, measure in MEASURES.items() if name != "compilers"}
        self.assertEqual([name for name, finding in found.items() if finding and finding.fails], ["values", "far"])

    def test_what_is_not_claimed_is_not_judged(self) -> None:
        measured = self.measured("value(p, 7u)")
        self.assertIsNone(measures.seeds(measured))
        self.assertIsNone(measures.slopes(measured))
        without = Measured(Sampler(Subject("", NOISE, "value(p, 7u)", 2), self.renderer))
        self.assertIsNone(measures.extremes(without).fails)

    def test_the_numbers_are_those_of_the_defects(self) -> None:
        self.assertAlmostEqual(MEASURES["jumps"](self.measured(CONTROLS["jumps"])).number, 0.004, delta=2e-4)
        self.assertEqual(MEASURES["repeats"](self.measured(CONTROLS["repeats"])).number, 173)
        self.assertAlmostEqual(MEASURES["derivative"](self.measured(CONTROLS["derivative"])).number, 0.06, delta=0.05)


class Command(Case):
    def setUp(self) -> None:
        self.enterContext(mock.patch.object(measures, "DRAWINGS", 1))
        self.file = self.folder / "noise.glsl"
        self.file.write_text(NOISE)

    def test_a_page_a_record_and_a_status(self) -> None:
        out = self.folder / "new" / "out"
        with mock.patch.multiple(command, by_softpipe=lambda subject: None, ROUNDS=1, VALUES=2):
            shown = called(command.main, f"{self.file}:{CONTROLS['jumps']}", "--require", "jumps,range", "--range", "-1", "1.01",
                              "--out", out, "--name", "a <control>")
        self.assertEqual(shown[0], 1, shown)
        self.assertRegex(shown[1], r"(?m)^FAIL jumps +It jumps by 0\.004")
        self.assertRegex(shown[1], r"(?m)^     cost +On llvmpipe a value costs [\d.]+ times")
        self.assertEqual([row["measure"] for row in record.read(out / "judged.csv") if row["fails"] == "yes"], ["jumps"])
        self.assertIn("# by: llvmpipe (LLVM ", (out / "judged.csv").read_text())
        text = (out / "index.html").read_text()
        self.assertIn("a &lt;control&gt;", text)
        self.assertIn("hn_perlin, for comparison", text)
        self.assertEqual(text.count(">FAIL "), 1)

    @in_thorough_runs
    def test_ours_passes_in_space(self) -> None:
        library = command.ours(3)
        with mock.patch.object(command, "by_softpipe", return_value=None):
            found = command.judged(Sampler(library))
        self.assertEqual([finding.sentence for finding in found.values() if finding.fails], [])

    def test_bad_usage(self) -> None:
        good = f"{self.file}:value(p, seed)"
        for arguments, message in (((), "FILE:EXPRESSION"), ((str(self.file),), "is not FILE:EXPRESSION"),
                                   (("/nowhere.glsl:f(p)",), "cannot read /nowhere.glsl"),
                                   ((f"{self.file}:absent(p)",), "does not compile as a float of p, a vec2"),
                                   ((good, "--range", "1", "-1"), "the first is to be below the second"),
                                   ((good, "--require", "beauty"), "there is no such measure. There are values, range"),
                                   ((f"{self.file}:value(p, 7u)", "--require", "seeds"), "uses no `seed`"),
                                   ((good, "--require", "derivative"), "sets no `slope`"),
                                   ((good, "--require", "jumps,range"), "comes without --range"),
                                   ((good, "--dimensions", "4"), "invalid choice")):
            with self.subTest(arguments):
                status, printed = called(command.main, *arguments)
                self.assertEqual(status, 2)
                self.assertIn(message, printed)


class Record(Case):
    def test_a_noise_has_its_place_in_the_table(self) -> None:
        first, second = (Subject(name, "", "", 2) for name in ("a", "b"))
        path = self.folder / "new" / "judged.csv"
        for subject, repeats in ((first, 289.0), (second, 0.0), (first, 71.0)):
            record.put(path, subject, [Finding("values", False, 0.25, ""), Finding("cost", None, 1.5, ""),
                                       Finding("repeats", repeats > 0, repeats, "")], "a renderer")
        self.assertEqual(stamps.stale(path), [])
        rows = record.read(path)
        self.assertEqual([row["noise"] for row in rows], ["a"] * 3 + ["b"] * 3)
        shown = record.judge_table(rows).splitlines()
        self.assertEqual([re.sub(r"\|( +\|)+", "|", line) for line in shown[2:]],
                         ["| a, 2D | **71** | 1.5 |", "| b, 2D | no | 1.5 |"])


class Page(unittest.TestCase):
    def test_pictures_have_the_values_from_below(self) -> None:
        shown = page.greys(np.array([[0.0, np.nan], [1.0, 2.0]]))
        self.assertTrue(shown.startswith('<img alt="" width="128" src="data:image/png;base64,'))
        self.assertIn('height="32.00"', page.bars([1, 2]))
