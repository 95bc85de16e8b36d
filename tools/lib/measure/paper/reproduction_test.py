"""Tests of the page of the paper, of records that stand in for those of hn-conform."""

from __future__ import annotations

import contextlib
import io
import re
from unittest import mock

import numpy as np

from base.testing import Case
from measure import record
from measure.paper import reproduction

FACTS = {"driver": "osmesa", "renderer": "llvmpipe <x>", "OpenGL": "4.5", "GLSL": "4.50", "date": "2026-01-02T03:04:05Z",
         "command": "hn-conform paper --out 'x'", "library": "hashnoise", "clock": "wall", "rounds": "3"}
FORMS = ("as published", "as intended", "ours")
ALGORITHMS = (*((name, form) for pair in reproduction.HASHES for name in pair for form in FORMS),
              ("Perlin/Float", "tables in textures"), ("Perlin/Integer", "tables in textures"))
SIDE = 4


def sampled(seed: int) -> np.ndarray:
    return np.clip(np.random.default_rng(seed).normal(0.0, 0.25, 1 << 12), -1.5, 1.5).astype("<f4")


class Paper(Case):
    def setUp(self) -> None:
        self.out = self.folder

    def write_records(self, problem: str = "") -> None:
        table = [{"id": f"{name}.{form}.{n}d", "algorithm": name, "form": form, "dimensions": n, "spirv": 100 + number,
                  **{f"{what}_{size}": 0.5 + number for size in reproduction.SIZES
                     for what in ("ms", "ratio", "spread")}, "problem": ""}
                 for n in "23" for number, (name, form) in enumerate((("(empty shader)", ""), *ALGORITHMS))]
        if problem:
            table[1].update({name: "failed" for name in list(table[1])[4:-1]}, problem=problem)
        record.write(self.out / "table.csv", table,
                     facts={**FACTS, "cells": "32"})
        values = []
        (self.out / "values").mkdir()
        for name, form in ALGORITHMS:
            for n, what in (*(("2", what) for what in reproduction.PICTURES), ("2", "statistics"), ("3", "statistics")):
                file = f"values/{len(values)}.f32"
                found = sampled(len(values)) if what == "statistics" else np.full(SIDE * SIDE, 0.25, "<f4")
                found.tofile(self.out / file)
                values.append({"algorithm": name, "form": form, "dimensions": n, "what": what, "file": file, "problem": ""})
        record.write(self.out / "values.csv", values, facts={
            **FACTS, "side": SIDE, "cells of noise": 16, "cells of sums": 4, "2D": "a grid", "3D": "another"})
        record.write(self.out / "period.csv", [
            {"algorithm": "Perlin/FNV1", "form": "ours", "dimensions": 2, "period": 48, "differing_values": differing,
             "shortest_repeat_x": 48, "shortest_repeat_y": 48, "shortest_repeat_z": "no axis", "verdict": verdict,
             "problem": ""} for differing, verdict in ((0, "as stated"), (7, "does not repeat"))],
                     facts={**FACTS, "points": 65536})
        record.write(self.out / "bandwidth.csv", [
            {"noise": name, "dimensions": n, "fetches": fetches, "milliseconds": own + 2 * fetches, "spread": 0}
            for n in "23" for name, own in (("fetches alone", 1), ("Perlin/Float", 3)) for fetches in (0, 8, 16, 32)],
                     facts={**FACTS, "texture": "256 MiB"})

    def measure(self, *arguments: str, status: int = 0, problem: str = "", only: str = "") -> tuple[int, str]:
        def run(_) -> int:
            self.write_records(problem)
            if only:
                for name in set(reproduction.RECORDS) - {only}:
                    (self.out / f"{name}.csv").unlink()
            return status

        with mock.patch.object(reproduction.conform, "run", run), contextlib.redirect_stdout(io.StringIO()):
            given = reproduction.main(["--out", str(self.out), *arguments])
        return given, (self.out / "index.html").read_text(encoding="utf-8")


class Whole(Paper):
    def test_the_page_has_every_section_and_its_pictures(self) -> None:
        status, text = self.measure()
        self.assertEqual(status, 0)
        files = re.findall(r'(?:href|src)="(?!data:)([^"]*)"', text)
        self.assertEqual(len(files), 2 * len(reproduction.FORMS))
        for file in files:
            self.assertTrue((self.out / file).is_file(), file)
        self.assertNotRegex(text, r"\b(nan|inf)\b|could not be measured")
        for part in ("llvmpipe &lt;x&gt;", "2026-01-02T03:04:05Z", ">does not repeat<", ">as stated<", ">~165<",
                     "256 MiB", "65536 values", "2D: a grid. 3D: another."):
            self.assertIn(part, text)
        self.assertFalse((self.out / "values").exists())

    def test_numbers_stand_beside_the_papers(self) -> None:
        self.write_records()
        row = record.read(self.out / "table.csv").rows[1]
        self.assertEqual(reproduction.cells(row, ("spirv",)),
                         ["101", "~165", "1.50", "11.5", "1.50 ± 1.50", "2.50", "1.50", "17.5", "1.50 ± 1.50", "2.19"])
        self.assertEqual(reproduction.cells({**row, "algorithm": "ours"}, ())[:3], ["not in it", "1.50", "not in it"])

    def test_what_failed_is_named_and_costs_status_1(self) -> None:
        status, text = self.measure("--dump", status=1, problem="a.glsl:1: no")
        self.assertEqual(status, 1)
        self.assertIn("<pre>a.glsl:1: no</pre>", text)
        self.assertIn('<td class="number">failed</td>', text)
        self.assertTrue((self.out / "values").exists())

    def test_a_section_that_is_missing_is_named(self) -> None:
        self.assertEqual(self.measure(status=1, only="period")[1].count("It could not be measured."), 3)


class Numbers(Case):
    def test_statistics(self) -> None:
        row = {"algorithm": "a", "form": "b", "dimensions": "2"}
        found = reproduction.sample(row, np.array([-1.0, -0.5, 0.0, 0.5, 1.25, 0.0, 0.25, -0.25], "<f4"))
        self.assertEqual((found.minimum, found.maximum, found.mean, found.zeros), (-1.0, 1.25, 0.03125, 0.25))
        self.assertEqual(found.cells()[:2], ["-1.0000 to 1.2500", "no"])
        # 10^log10_p is the probability that scipy has.
        values = sampled(1)
        self.assertAlmostEqual(10 ** reproduction.sample(row, values).normality_log10_p,
                               reproduction.stats.normaltest(values.astype(float)).pvalue, 9)

    def test_chi_square_leaves_sparse_bins_out(self) -> None:
        statistic, degrees, p = reproduction.chi_square(np.array([100, 9, 50]), np.array([60, 10, 50]))
        self.assertEqual((statistic, degrees), (10.0, 1))
        self.assertAlmostEqual(p, 0.0015654, 6)

    def test_greys(self) -> None:
        values = np.array([-1.0, 0.0, 0.5, 2.0, np.nan])
        self.assertEqual(reproduction.greys(values, "noise").tolist(), [0, 128, 191, 255, 0])
        self.assertEqual(reproduction.greys(values, "turbulence").tolist(), [0, 0, 255, 255, 0])

    def test_where_a_curve_bends(self) -> None:
        self.assertEqual(reproduction.bend([0, 8, 16, 32], [20.0, 20.0, 36.0, 68.0]), (2.0, 8.0))
