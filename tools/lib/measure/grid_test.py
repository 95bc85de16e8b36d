"""tools/measure cpu: python3 -m unittest measure.grid_test; and with the library: python3 -m measure.grid_test FOLDER, where
it is built."""

from __future__ import annotations

import json
import os
import sys
import unittest
from pathlib import Path
from unittest import mock

from base.cross_build import Build, Place, output_of
from base.testing import Case, called
from base.tree import ROOT
from measure import cpu, fills, stamps

ATTEMPTS = 5  # other programs on the machine can spoil a measurement, but hardly every time
FOLDER = Path()


class Fills(Case):
    def main(self, command, *arguments: object) -> tuple[int, str]:
        return called(command.main, *arguments, "--out", self.folder)

    def rows(self, name: str) -> list[dict[str, str]]:
        self.assertEqual(stamps.stale(self.folder / name), [])
        return stamps.read(self.folder / name).rows

    def fake(self, compiler: str, library: Path, *options: str) -> str:
        """A stand-in for FastNoise2 that does everything three times."""
        made = self.folder / "libfake.so"
        output_of(compiler, "-std=c++20", "-O1", "-shared", "-fPIC", "-I", ROOT / "include",
                  fills.SOURCES / "fast_noise_test.cpp", library, "-o", made, "-pthread", *options)
        return f"fastnoise2={made}"

    def native(self) -> str:
        """A shared library that is none."""
        output_of("gcc", "-shared", "-x", "c", os.devnull, "-o", self.folder / "none.so")
        return f"fastnoise2={self.folder / 'none.so'}"


class OfReports(Fills):
    def test_quotients_are_of_speeds(self) -> None:
        times = {"avx512/fast": (1, 2, 3), "avx512/FastNoise2": (2, 4, 6), "sse4.1/fast": (4, 4, 4), "sse4.1/fixed": (8, 8, 8)}
        report = json.dumps({"benchmarks": [
            {"run_name": name, "run_type": kind, "cpu_time": 1048576 * time}
            for name, some in times.items() for time in some for kind in ("iteration", "aggregate")]})
        narrow, wide = cpu.rows_of("perlin2", report)
        self.assertEqual((narrow["instructions"], narrow["fixed"], narrow["fixed spread"], narrow["grids"]),
                         ("sse4.1", "0.5", "0", ""))
        self.assertEqual((wide["grids"], wide["fast million/s"]), ("2", "500"))
        self.assertIn("| `perlin2` | 2.00 |", cpu.page_table([narrow, wide]))
        self.assertIn(" | 250 / 500 |\n", cpu.page_table([narrow, wide]))

    def test_bad_usage(self) -> None:
        for command, arguments, part in ((cpu, ("--against", "other=x"), "is not fastnoise2=FILE"),
                                         (cpu, ("--against", "fastnoise2=/nowhere/x.so"), "is not fastnoise2=FILE"),
                                         (cpu, ("--rounds", "2"), "--rounds"),
                                         (cpu, ("--agianst", "x"), "did you mean --against?")):
            status, printed = self.main(command, *arguments)
            self.assertEqual(status, 2)
            self.assertIn(part, printed)


@unittest.skipUnless(__name__ == "__main__", "the test bench.grid has the library")
class Cpu(Fills):
    def setUp(self) -> None:
        (self.folder / "src").symlink_to(FOLDER / "src")
        with mock.patch.object(Build, "library"):
            self.program = fills.built(Place("g++", (), linked=("-pthread", "-lbenchmark")), self.folder, "bench.cpp")
        self.enterContext(mock.patch.object(fills, "built", return_value=self.program))

    def test_a_library_whose_speed_is_known(self) -> None:
        theirs = self.fake("g++", FOLDER / "src/grid/libhashnoise-grid.a")
        measure = ("--filter", "perlin2", "--rounds", "3", "--against", theirs)
        wrong = None
        for _ in range(ATTEMPTS):
            status, printed = self.main(cpu, *measure, "--against", theirs.replace("fastnoise2", "strict"))
            self.assertEqual(status, 0, printed)
            rows = self.rows("gcc.csv")
            seen = {(row["instructions"], name): float(row[name]) for row in rows for name in ("grids", "points")}
            seen |= {(row["instructions"], name): 3 * float(row[f"strict {name}"]) / float(row[name]) / float(row["grids"])
                     for row in rows for name in ("fixed", "precise")}
            wrong = {what: ratio for what, ratio in seen.items()
                     if not 2.4 < ratio < 3.6 and (wrong is None or what in wrong)}
            if not wrong:
                break
        self.assertEqual(wrong, {}, "it computes everything three times")
        for name in ("tiles", "lists", "fast million/s"):
            self.assertGreater(float(rows[0][name]), 0)
        self.assertGreater(float(rows[-1]["threads"]), 0)
        self.assertIn("g++", stamps.read(self.folder / "gcc.csv").facts["by"])
        for lacking, part in (("node", "has no node Perlin"), ("variable", "no variable Feature Scale")):
            with mock.patch.dict(os.environ, FAKE_FAST_NOISE=lacking):
                status, printed = self.main(cpu, *measure)
            self.assertEqual(status, 1)
            self.assertIn(part, printed)
        with mock.patch.dict(os.environ, FAKE_FAST_NOISE="instructions"):
            listed = output_of(self.program, "perlin2", theirs, "--benchmark_list_tests").splitlines()
        self.assertGreater(len(listed), 4)
        self.assertIn([name for name in listed if name.endswith("/FastNoise2")], (["sse4.1/FastNoise2"], []))
        status, printed = self.main(cpu, "--filter", "perlin2", "--against", self.native())
        self.assertEqual(status, 1)
        self.assertIn("has no function fnGetMetadataCount", printed)


if __name__ == "__main__":
    FOLDER = Path(sys.argv[1]).resolve()
    unittest.main(defaultTest="Cpu", argv=sys.argv[:1], verbosity=2)
