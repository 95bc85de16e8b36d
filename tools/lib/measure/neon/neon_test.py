"""tools/measure neon: python3 -m unittest measure.neon.neon_test; and with the library: python3 -m
measure.neon.neon_test FOLDER, where it is built for ARM."""

from __future__ import annotations

import contextlib
import io
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.tree import ROOT
from measure import stamps
from measure.elsewhere import NEON, Failed, output_of
from measure.neon import command
from measure.neon.counting import Counter, Refused, of_a_fill
from measure.neon.record import ratios
from measure.record import read, three_digits

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
# Fills take 1000 instructions by this library, 2500 by FastNoise2, and 70 besides.
QEMU = """\
if [ "$1" = --version ]; then echo 'qemu-aarch64 version 7.2.9 (of a test)'; exit; fi
for last; do what=$before; before=$last; done
if [ "$last" = --list ]; then printf '100 0.25\\nperlin2\\ncellular3\\n'; exit; fi
case $* in *fastnoise2=*) each=2500 ;; *fixed*) each=${FIXED-2000} ;; *precise*) each=1250 ;; *) each=1000 ;; esac
case $* in
  *fastnoise2=*none.so*) echo 'no FastNoise2' >&2; exit 2 ;;
  *fastnoise2=*other.so*) echo 'no node' >&2; exit 1 ;;
esac
echo $((70 + each * last)) >number
"""


class Case(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def main(self, *arguments: str | Path) -> tuple[int, str, str]:
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                status = command.main([*map(str, arguments), "--out", str(self.folder / "out")])
            except SystemExit as stop:
                status = int(stop.code or 0)
        return status, out.getvalue(), err.getvalue()

    def results(self) -> list[str]:
        return sorted(path.name for path in (self.folder / "out").glob("*"))

    def record(self):
        return read(self.folder / "out" / "neon.csv")


@unittest.skipIf(NEON.missing(), f"there is no {' and no '.join(NEON.missing())}")
class ByQemu(Case):
    """The plugin's count for a program whose instructions are known."""

    def program(self, status: int) -> Path:
        source, program = self.folder / "loop.s", self.folder / "loop"
        source.write_text(LOOP.replace("STATUS", str(status)), encoding="ascii")
        output_of(NEON.compiler, "-nostdlib", "-static", source, "-o", program)
        return program

    def test_each_instruction_is_counted(self) -> None:
        self.assertEqual(Counter(self.folder).instructions(self.program(0)), 1 + 2 * 1000 + 3)

    def test_a_program_that_fails_has_no_number(self) -> None:
        counter = Counter(self.folder)
        with self.assertRaisesRegex(Failed, "loop ended with status 7"):
            counter.instructions(self.program(7))
        with self.assertRaises(Refused):
            counter.instructions(self.program(2))


class ByAStandIn(Case):
    """QEMU and the compiler are scripts."""

    def setUp(self) -> None:
        super().setUp()
        self.script("qemu-aarch64", QEMU)
        self.script("aarch64-linux-gnu-g++", "echo 12.9.0")
        self.enterContext(mock.patch.dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"))
        self.enterContext(mock.patch.object(command, "missing", return_value=[]))
        self.enterContext(mock.patch.object(command, "build", return_value=self.folder / "hn-fill"))
        (self.folder / "libFastNoise.so").touch()

    def script(self, name: str, text: str) -> None:
        (self.folder / name).write_text(f"#!/bin/sh\n{text}\n", encoding="ascii")
        (self.folder / name).chmod(0o755)

    def test_what_besides_a_fill_is_executed_is_not_counted(self) -> None:
        self.assertEqual(of_a_fill(Counter(self.folder), self.folder / "hn-fill", "fast", "perlin2"), 1000)

    def test_the_record_and_the_page(self) -> None:
        status, out, _ = self.main("--against", f"fastnoise2={self.folder}/libFastNoise.so", "--note", "A note.")
        self.assertEqual(status, 0)
        self.assertIn("2 subjects counted", out)
        record = self.record()
        self.assertEqual([record.facts[name] for name in ("points", "step", "compiler", "emulator", "note", "command")],
                         ["100", "0.25", "GCC 12.9.0", "QEMU 7.2.9", "A note.",
                          "tools/measure neon --against fastnoise2=libFastNoise.so"])
        counts = {"fast": "1000", "fixed": "2000", "precise": "1250", "FastNoise2": "2500"}
        self.assertEqual(record.rows, [{"noise": noise, **counts} for noise in ("perlin2", "cellular3")])
        self.assertEqual(list(ratios(record.rows[0]).values()), [2.5, 0.5, 0.8])
        page = (self.folder / "out" / "neon.md").read_text(encoding="utf-8")
        self.assertIn("| `perlin2` | 2.50 | 0.50 | 0.80 |\n", page)
        self.assertIn("| `cellular3` | 10.0 | 20.0 | 12.5 | 25.0 |\n", page)
        self.assertIn(" A note. By `tools/measure neon", page)
        self.assertEqual(stamps.stale(self.folder / "out" / "neon.md"), [])
        self.assertNotIn(str(self.folder), page + str(record))

    def test_some_subjects_without_another_library(self) -> None:
        self.assertEqual(self.main("--filter", "cell*")[0], 0)
        self.assertEqual([row["noise"] for row in self.record().rows], ["cellular3"])
        page = (self.folder / "out" / "neon.md").read_text(encoding="utf-8")
        self.assertIn("| noise | HN_FIXED beside HN_FAST | HN_PRECISE beside HN_FAST |\n", page)
        self.assertIn("| `cellular3` | 10.0 | 20.0 | 12.5 |\n", page)

    def test_numbers_that_tell_nothing(self) -> None:
        with mock.patch.dict(os.environ, FIXED="0"):
            status, _, err = self.main()
        self.assertEqual((status, self.results()), (1, []))
        self.assertIn("perlin2, fixed: 70 instructions fill a grid once, and 70 twice", err)

    def test_a_plugin_that_leaves_no_number(self) -> None:
        self.script("qemu-aarch64", QEMU.replace("echo $((70 + each * last)) >number", ":"))
        status, _, err = self.main()
        self.assertEqual((status, self.results()), (1, []))
        self.assertIn("its plugin left no number", err)

    def test_another_library_that_is_none(self) -> None:
        for name, expected, part in (("none.so", 2, "no FastNoise2"), ("other.so", 1, "no node")):
            (self.folder / name).touch()
            status, _, err = self.main("--against", f"fastnoise2={self.folder / name}")
            self.assertEqual((status, self.results()), (expected, []))
            self.assertIn(part, err)

    def test_bad_usage(self) -> None:
        for arguments, part in ((("--against", "other=x"), "it wants fastnoise2=FILE"),
                                (("--against", "fastnoise2="), "it wants fastnoise2=FILE"),
                                (("--against", "fastnoise2=/nowhere/x.so"), "/nowhere/x.so is no file"),
                                (("--filter", "worley*"), "no subject matches --filter"),
                                (("--rounds", "3"), "--rounds")):
            status, _, err = self.main(*arguments)
            self.assertEqual((status, self.results()), (2, []))
            self.assertIn(part, err)

    def test_a_library_that_cannot_be_built(self) -> None:
        with mock.patch.object(command, "build", side_effect=Failed("cmake ended with 1")):
            status, _, err = self.main()
        self.assertEqual((status, self.results()), (4, []))
        self.assertIn("it could not be built: cmake ended with 1", err)


class Missing(Case):
    def test_packages_are_named(self) -> None:
        with mock.patch.object(shutil, "which", return_value=None), mock.patch.object(command, "INCLUDE", self.folder):
            status, _, err = self.main()
        self.assertEqual(status, 4)
        for package in ("cmake", "ninja-build", "gcc", "g++-aarch64-linux-gnu", "qemu-user", "libfmt-dev",
                        "libexpected-dev", "nlohmann-json3-dev"):
            self.assertIn(f" {package}", err)
            self.assertIn(package, command.DESCRIPTION)

    def test_one_package(self) -> None:
        (self.folder / "fmt").mkdir()
        (self.folder / "fmt" / "format.h").touch()
        with mock.patch.object(shutil, "which", return_value="/bin/true"), \
                mock.patch.object(command, "INCLUDE", self.folder), \
                mock.patch.dict(command.HEADERS, {"tl/expected.hpp": "libexpected-dev"}, clear=True):
            self.assertEqual(command.missing(), ["libexpected-dev"])
            with mock.patch.dict(command.HEADERS, {"fmt/format.h": "libfmt-dev"}, clear=True):
                self.assertEqual(command.missing(), [])


class Digits(unittest.TestCase):
    def test_three(self) -> None:
        self.assertEqual([three_digits(number) for number in (1234.5, 99.96, 99.94, 19.28, 3.0)],
                         ["1234", "100", "99.9", "19.3", "3.00"])


@unittest.skipUnless(__name__ == "__main__", "the test neon.whole compiles the library")
class Whole(Case):
    """The library, and a stand-in for FastNoise2 that does everything three times."""

    build: Path

    def test_a_library_whose_cost_is_known(self) -> None:
        self.enterContext(mock.patch.object(command, "build", return_value=command.build(self.build)))
        options = ("--filter", "perlin2")
        status, _, err = self.main(*options)
        self.assertEqual(status, 0, err)
        alone = self.record().rows
        theirs = self.folder / "libfake.so"
        output_of(NEON.compiler, "-std=c++20", "-O1", "-shared", "-fPIC", "-I", ROOT / "include",
                  ROOT / "src/bench_cpu/tests/fake_fast_noise.cpp", self.build / "src/grid/libhashnoise-grid.a",
                  "-o", theirs, "-pthread")
        status, _, err = self.main(*options, "--against", f"fastnoise2={theirs}")
        self.assertEqual(status, 0, err)
        row, = self.record().rows
        beside_theirs, *others = ratios(row).values()
        self.assertAlmostEqual(beside_theirs, 3.0, delta=0.01)
        for name in ("fast", "fixed", "precise"):
            self.assertAlmostEqual(int(row[name]) / int(alone[0][name]), 1.0, delta=1e-5)
        self.assertLess(max(others), 1.0)
        with mock.patch.dict(os.environ, FAKE_FAST_NOISE="all instructions"):
            status, _, err = self.main(*options, "--against", f"fastnoise2={theirs}")
        self.assertEqual(status, 1)
        self.assertIn("has no neon in it", err)
        native = self.folder / "libnative.so"
        subprocess.run(["gcc", "-shared", "-x", "c", os.devnull, "-o", native], check=True)
        status, _, err = self.main(*options, "--against", f"fastnoise2={native}")
        self.assertEqual(status, 2)
        self.assertIn("cannot load", err)


if __name__ == "__main__":
    Whole.build = Path(sys.argv.pop()).resolve()
    if packages := command.missing():
        print(f"skipped: there is no {' and no '.join(packages)}")
        sys.exit(77)
    unittest.main(defaultTest="Whole", verbosity=2)
