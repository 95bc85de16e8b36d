"""tools/measure cpu and neon: python3 -m unittest measure.grid_test; and with the library: python3 -m measure.grid_test
Cpu FOLDER, where it is built, or Neon FOLDER, where it is built for ARM."""

from __future__ import annotations

import json
import os
import sys
import unittest
from pathlib import Path
from unittest import mock

from base.cross_build import NEON, Build, Failed, Place, output_of
from base.testing import Case, called
from base.tree import ROOT
from measure import cpu, fills, neon, stamps

ATTEMPTS = 5  # other programs on the machine can spoil a measurement, but hardly every time
FOLDER = Path()
# It executes 5 instructions, and 2 in each turn.
LOOP = """\
.globl _start
_start:
  mov x0, #1000
turn:
  subs x0, x0, #1
  b.ne turn
  mov x0, #STATUS
  mov x8, #93
  svc #0
  nop
"""
# A fill takes an instruction for each of 2^20 points by this library, and 2.5 by FastNoise2; and 70 besides.
QEMU = """\
if [ "$1" = --version ]; then echo 'qemu-aarch64 version 7.2.9 (of a test)'; exit; fi
case $* in
  *out=number*" 1 "*) times=1 ;; *out=number*" 2 "*) times=2 ;;
  *) printf 'perlin2\\ncellular3\\n'; exit ;;
esac
case $* in *none.so*) echo 'no FastNoise2' >&2; exit 1 ;; *FastNoise2*) each=2621440 ;; *) each=${EACH-1048576} ;; esac
echo $((70 + each * times)) >number
"""


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
                                         (neon, ("--against", "fastnoise2=/nowhere/x.so"), "is not fastnoise2=FILE"),
                                         (cpu, ("--rounds", "2"), "--rounds"), (neon, ("--rounds", "3"), "--rounds"),
                                         (cpu, ("--agianst", "x"), "did you mean --against?")):
            status, printed = self.main(command, *arguments)
            self.assertEqual(status, 2)
            self.assertIn(part, printed)


@unittest.skipIf(NEON.missing(), f"there is no {' and no '.join(NEON.missing())}")
class ByQemu(Fills):
    """The plugin's count for a program whose instructions are known."""

    def program(self, status: int) -> Path:
        source, program = self.folder / "loop.s", self.folder / "loop"
        source.write_text(LOOP.replace("STATUS", str(status)), encoding="ascii")
        output_of(NEON.compiler, "-nostdlib", "-static", source, "-o", program)
        return program

    def test_each_instruction_is_counted(self) -> None:
        counter = neon.Counter(self.folder)
        self.assertEqual(counter.instructions(self.program(0)), 1 + 2 * 1000 + 3)
        with self.assertRaisesRegex(Failed, "loop ended with status 7"):
            counter.instructions(self.program(7))


class ByAStandIn(Fills):
    """QEMU and the compiler are scripts."""

    def setUp(self) -> None:
        for name, text in (("qemu-aarch64", QEMU), ("aarch64-linux-gnu-g++", "echo g++ 12.9.0")):
            self.script(name, text)
        self.enterContext(mock.patch.dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"))
        self.enterContext(mock.patch.object(fills, "built", return_value=self.folder / "filler"))

    def test_what_besides_a_fill_is_executed_is_not_counted(self) -> None:
        (self.folder / "other.so").touch()
        status, printed = self.main(neon, "--against", f"fastnoise2={self.folder}/other.so", "--filter", "cell*")
        self.assertEqual(status, 0, printed)
        row, = self.rows("neon.csv")
        self.assertEqual(list(row.values())[:5], ["cellular3", "1", "1", "1", "2.5"])
        self.assertIn("| `cellular3` | 1.00 | 1.00 | 1.00 | 2.50 | 2.50 |", neon.page_table([row]))

    def test_what_cannot_be_counted_or_built(self) -> None:
        with mock.patch.dict(os.environ, EACH="0"):
            status, printed = self.main(neon)
        self.assertEqual(status, 1)
        self.assertIn("fast perlin2: 70 instructions fill a grid once, and 70 twice", printed)
        status, printed = self.main(neon, "--against", self.native())
        self.assertEqual((status, (self.folder / "neon.csv").exists()), (1, False))
        self.assertIn("no FastNoise2", printed)
        with mock.patch.object(fills, "built", side_effect=Failed("cmake ended with 1")):
            self.assertEqual(self.main(neon)[0], 4)
        status, printed = self.main(neon, "--filter", "worley*")
        self.assertEqual(status, 1)
        self.assertIn("--filter leaves no noise; there are perlin2, cellular3", printed)


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


@unittest.skipUnless(__name__ == "__main__", "the test neon.whole compiles the library")
class Neon(Fills):
    def test_a_library_whose_cost_is_known(self) -> None:
        self.enterContext(mock.patch.object(neon, "FOLDER", FOLDER))
        theirs = self.fake(NEON.compiler, FOLDER / "src/grid/libhashnoise-grid.a")
        status, printed = self.main(neon, "--filter", "perlin2", "--against", theirs)
        self.assertEqual(status, 0, printed)
        row, = self.rows("neon.csv")
        self.assertAlmostEqual(float(row["FastNoise2"]) / float(row["fast"]), 3.0, delta=0.01)
        self.assertLess(float(row["fast"]), min(float(row["fixed"]), float(row["precise"])))
        with mock.patch.dict(os.environ, FAKE_FAST_NOISE="all instructions"):
            status, printed = self.main(neon, "--filter", "perlin2", "--against", theirs)
        self.assertEqual(status, 1)
        self.assertIn("there is no FastNoise2 in it for neon", printed)


if __name__ == "__main__":
    which, place = sys.argv[1:]
    FOLDER = Path(place).resolve()
    if which == "Neon" and (missing := NEON.missing()):
        print(f"skipped: there is no {' and no '.join(missing)}")
        sys.exit(77)
    unittest.main(defaultTest=which, argv=sys.argv[:1], verbosity=2)
