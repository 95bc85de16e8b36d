"""Tests of tools/measure gpu with a stand-in of the compilers. The real ones run where HN_GPU_DRIVERS names a
folder that tools/measure gpu --get-drivers filled."""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.debian import Missing
from base.testing import Case, called
from base.thorough import in_thorough_runs
from measure import record as records
from measure.gpu import chips, command, drivers, pages, record
from measure.gpu.chips import CHIPS, chip_named
from measure.gpu.compiling import Compiled, compile_all
from measure.peers import CALLS, dimensions, subject

# hn-conform as far as it is called. A shader costs what its file states: 7 cycles for each word of it, or trouble.
STAND_IN = """#!/bin/sh
case $1 in
  spirv)
    shift; mkdir -p "$2/spirv"
    for id in empty2 empty3 {ids}; do
      case $id in empty*) text=one;; *refused) text=refuse;; *crashes) text=crash;; *) text="one two three";; esac
      echo "$text" >"$2/spirv/$id.spv"; echo "$id 2"
    done
    ;;
  shader-statistics)
    shift
    echo '{{"device": "Stand-in", "driver": "1.0"}}'
    echo 'a line of the driver'
    for file; do
      set -- $(cat "$file")
      case $1 in
        refuse) echo '{{"error": "too hard"}}' ;;
        crash) echo 'printed before' >&2; printf '{{"stat'; kill -SEGV $$ ;;
        hang) exec sleep 60 ;;
        *) echo "{{\\"statistics\\": {{\\"Static cycle count\\": $((7 * $#)), \\"Instruction count\\": $#, \
\\"Number of GPRs\\": 24}}, \\"seconds\\": 0.002}}" ;;
      esac
    done ;;
esac
"""
AMPERE = chip_named("ampere")


class WithStandIn(Case):
    def setUp(self):
        self.program = self.make_program()
        self.drivers = self.folder / "drivers"
        libraries = self.drivers / "usr/lib/any"
        for file in (libraries / "libvulkan.so.1", libraries / "libnouveau_noop_drm_shim.so",
                     self.drivers / "usr/share/vulkan/icd.d/nouveau_icd.json"):
            file.parent.mkdir(parents=True, exist_ok=True)
            file.touch()
        # It starts the program behind --library-path X --preload Y.
        self.script(libraries / "ld-linux-any.so.2", 'shift 4\nexec "$@"')

    def make_program(self, *ids: str) -> Path:
        return self.script("hn-conform", STAND_IN.format(ids=" ".join(ids or ("perlin",))))

    def files(self, *texts: str) -> list[Path]:
        paths = [self.folder / str(number) for number in range(len(texts))]
        for path, text in zip(paths, texts):
            path.write_text(text)
        return paths

    def call(self, *arguments: object) -> tuple[int, str]:
        with mock.patch("measure.gpu.command.program", return_value=str(self.program)):
            return called(command.main, "--drivers", self.drivers, "--out", self.folder / "out", *arguments)

    def compile(self, *texts: str, limit: float = 30.0) -> list[Compiled]:
        command = [str(self.program), "shader-statistics"]
        device, results = compile_all(command, os.environ, self.files(*texts), limit=limit)
        self.assertEqual(device, ("Stand-in", "1.0"))
        return results


class Compiling(WithStandIn):
    def test_a_shader_that_is_refused_or_kills_the_compiler_costs_itself(self):
        one, crashed, refused, two, last = self.compile("one", "crash", "refuse", "one two", "crash")
        self.assertEqual((one.statistics["Static cycle count"], one.seconds), (7, 0.002))
        self.assertEqual(crashed.problem, "the compiler ended by SIGSEGV (printed before)")
        self.assertEqual(refused.problem, "too hard")
        self.assertEqual(two.statistics["Static cycle count"], 14)
        self.assertEqual(last.problem, crashed.problem)

    def test_one_that_takes_too_long_is_ended(self):
        _, hung, after = self.compile("one", "hang", "one", limit=0.5)
        self.assertEqual(hung.problem, "the compiler gave no answer for 0.5 s")
        self.assertFalse(after.problem)

    def test_whoever_is_interrupted_leaves_no_compiler_behind(self):
        started = mock.Mock(side_effect=KeyboardInterrupt)
        with mock.patch("subprocess.Popen.kill", autospec=True, side_effect=subprocess.Popen.kill) as kill, \
                self.assertRaises(KeyboardInterrupt):
            compile_all([str(self.program), "shader-statistics"], os.environ, self.files("one", "hang"), started)
        self.assertIsNotNone(kill.call_args.args[0].returncode)

    def test_a_compiler_that_cannot_start_says_why(self):
        for text, why in (("echo '{\"error\": \"no GPU\"}'", "no GPU"), ("echo text; exit 7", "ended with status 7"),
                          ("echo oh >&2; kill -ABRT $$", "ended by SIGABRT \\(oh\\)")):
            with self.subTest(why=why), self.assertRaisesRegex(Missing, why):
                program = self.script("broken", text)
                compile_all([str(program)], os.environ, self.files("one"))


class Records(Case):
    def shader(self, cycles: float, **more: float) -> Compiled:
        statistics = {"Static cycle count": cycles, "Instruction count": cycles / 2, "Number of GPRs": 24}
        return Compiled({**statistics, **more}, 0.0042)

    def test_a_row_is_less_the_empty_shader_but_for_registers(self):
        spilling = self.shader(327, **{"Spills to reg": 2, "Spills to memory": 1})
        row = record.row("perlin", AMPERE, spilling, self.shader(67))
        self.assertEqual(row, ("perlin", "ampere", "260", "130", "", "24", "3", "4.2", ""))
        navi = chip_named("navi31")
        statistics = {name: 50.0 for name in (navi.vendor.cost, "Instructions", "VGPRs")}
        row = record.row("perlin", navi, Compiled({**statistics, "VALU": 90, "SALU": 2}, 0.0),
                         Compiled({**statistics, "VALU": 4, "SALU": 2}, 0.0))
        self.assertEqual(row.kinds, "VALU 86")

    def test_statistics_of_another_name_are_a_problem_and_not_0(self):
        row = record.row("perlin", AMPERE, Compiled({"Cycles": 9}, 0.0), self.shader(67))
        self.assertEqual((row.cost, row.problem), ("", 'the driver reports no "Instruction count"'))
        row = record.row("perlin", AMPERE, self.shader(327), Compiled({}, 0.0, "crashed"))
        self.assertEqual((row.cost, row.problem), ("", "crashed"))

    def test_what_became_dearer_is_told(self):
        def rows(**costs: str) -> list[record.Row]:
            empty = record.Row("", "m1", *[""] * 7)
            return [empty._replace(id=id, **{"cost" if cost.isdigit() else "problem": cost})
                    for id, cost in costs.items()]

        before = {(row.id, row.chip): row for row in rows(same="5", more="5", less="5", fails="5", failed="crash")}
        now = rows(same="5", more="6", less="4", fails="crash", failed="9", new="1")
        self.assertEqual(record.dearer(before, now),
                         ["DEARER more on m1: 6, was 5", "FAILS fails on m1: crash; it cost 5"])
        self.assertEqual(record.dearer(before, rows(same="5", less="4")), [])

    def test_what_is_read_is_what_was_written(self):
        path = self.folder / "costs.csv"
        rows = [record.Row("perlin", "m1", "5", "4", "FSCIB 3, IC 2", "24", "0", "1.0", ""),
                record.Row("simplex", "m1", "", "", "", "", "", "", "too, hard")]
        chips_apart = [row._asdict() for row in rows]  # as records of before have them
        for table in (records.beside(chips_apart, ("id",), record.CHIP), chips_apart):
            records.write(path, table)
            self.assertEqual(list(record.read_costs(path).values()), rows)
            path.write_text(path.read_text().replace(",5,", ",five,"))
            with self.assertRaisesRegex(ValueError, f"{path}: the cost of perlin on m1 is 'five'"):
                record.read_costs(path)
        for text in ("", "id,ratio\nperlin,1\n"):
            path.write_text(text)
            with self.assertRaisesRegex(ValueError, "the first line must be id,chip,cost"):
                record.read_costs(path)


class Pages(unittest.TestCase):
    def test_a_loop_and_a_failure_are_marked(self):
        rows = {}
        for chip in chips.SHOWN:
            for call in pages.SHOWN_CALLS:
                for id in (f"{call.ours}.lattice", f"{call.ours}.lattice+fixed", f"{subject(call)}{dimensions(call)}"):
                    rows[id, chip] = record.Row(id, chip, "9", "9", "", "9", "0", "1.0", "")
        self.assertNotRegex(pages.chip_table(rows), r"\*|fails|6 octaves")
        self.assertIn("| Perlin 2D | 9 / 9; F 9, W 9, M 9 | 9 / 9;", pages.chip_table(rows))
        self.assertIn("| stripes 2D | 9 / 9; E 9, T 9 | 9 / 9;", pages.chip_table(rows))
        theirs = next(f"{subject(call)}2" for call in CALLS if call.peer == "fastnoiselite")
        rows[theirs, "adreno740"] = rows[theirs, "adreno740"]._replace(kinds="cat0 3, Loops 2")
        rows[theirs, "m1"] = rows[theirs, "m1"]._replace(cost="", problem="crashed")
        rows[theirs, "acm"] = rows[theirs, "acm"]._replace(kinds="floats 3, memory 2")
        line = pages.chip_table(rows).splitlines()[2]
        self.assertEqual(line.count("F 9*,"), 3)
        self.assertEqual(line.count("F 9+,"), 1)
        self.assertEqual(line.count("F fails"), 1)


class Chips(WithStandIn):
    def test_names_are_one_chips_each(self):
        self.assertEqual(len({chip.name for chip in CHIPS}), len(CHIPS))
        self.assertLessEqual(set(chips.SHOWN), {chip.name for chip in CHIPS})
        self.assertEqual({"NVIDIA", "AMD", "Adreno", "Apple", "Intel"}, {chip.vendor.title for chip in CHIPS})

    def test_they_are_listed(self):
        status, out = self.call("--list-chips")
        self.assertEqual((status, [line.split()[0] for line in out.splitlines()]), (0, [chip.name for chip in CHIPS]))

    def test_settings_of_ours_do_not_reach_a_compiler(self):
        with mock.patch.dict(os.environ, {"RADV_DEBUG": "nir", "NOUVEAU_CHIPSET": "1", "HN_KEPT": "1"}):
            environment = drivers.find(self.drivers).environment(AMPERE)
        self.assertNotIn("RADV_DEBUG", environment)
        self.assertEqual((environment["NOUVEAU_CHIPSET"], environment["HN_KEPT"]), ("0x174", "1"))


class Command(WithStandIn):
    def costs(self) -> dict[str, record.Row]:
        return {row.id: row for row in record.read_costs(self.folder / "out/costs.csv").values()}

    def test_another_copy_of_the_library(self):
        program = self.make_program()
        self.program = self.script("keeps", f'echo "$@" >>{self.folder}/calls\nexec {program} "$@"')
        self.assertEqual(self.call("--chip", "ampere", "--filter", "*", "--glsl", "/a/copy")[0], 0)
        self.assertRegex((self.folder / "calls").read_text(), "^spirv .* --glsl /a/copy\n")

    def test_measures_and_compares(self):
        self.program = self.make_program("perlin", "one-that-is-refused", "one-that-crashes")
        status, out = self.call("--chip", "ampere", "--filter", "*")
        self.assertEqual(status, 0, out)
        costs = self.costs()
        self.assertEqual((costs["perlin"].cost, costs["perlin"].instructions), ("14", "2"))
        self.assertEqual(costs["one-that-is-refused"].problem, "too hard")
        self.assertIn("FAILED one-that-crashes on ampere: the compiler ended by SIGSEGV", out)
        self.assertIn("ampere,\"NVIDIA GA104, Ampere\",Stand-in,1.0,Static cycle count",
                      (self.folder / "out/chips.csv").read_text())

        baseline = self.folder / "before.csv"
        baseline.write_text((self.folder / "out/costs.csv").read_text())
        again = ("--chip", "ampere", "--filter", "*", "--baseline", str(baseline))
        status, out = self.call(*again)
        self.assertEqual(status, 0, out)
        self.assertIn("3 costs compared, 0 cost more or fail; 0 of the baseline were not measured now", out)
        baseline.write_text(baseline.read_text().replace("perlin,14,", "perlin,13,"))
        status, out = self.call(*again)
        self.assertEqual(status, 1)
        self.assertIn("DEARER perlin on ampere: 14, was 13", out)

    def test_without_drivers_it_is_skipped_with_a_reason(self):
        status, err = self.call("--drivers", str(self.folder / "none"))
        self.assertEqual(status, 3)
        self.assertRegex(err, "skipped: there are no drivers in .*/none; tools/measure gpu --get-drivers puts them "
                              "there")
        self.assertIn("None can be measured yet", self.call("--list-chips", "--drivers", str(self.folder / "none"))[1])

    def test_a_chip_without_a_shim_is_skipped_and_the_others_are_not(self):
        status, out = self.call("--chip", "ampere", "--chip", "m1", "--filter", "*")
        self.assertEqual(status, 3)
        self.assertRegex(out, "m1 is skipped: .* has no libasahi_noop_drm_shim.so, which stands in for Apple's kernel")
        self.assertEqual(self.costs()["perlin"].chip, "ampere")

    def test_bad_input_is_status_2(self):
        self.program = self.make_program()
        bad = self.folder / "bad.csv"
        bad.write_text("id,ratio\n")
        refusing = self.script("refusing", "#!/bin/sh\nexit 2\n")
        for arguments, part in ((["--chip", "voodoo"], "invalid choice: 'voodoo'"),
                                (["--baseline", str(bad)], "the first line must be"),
                                (["--baseline", str(self.folder / "none.csv")], "none.csv"),
                                (["--wombat", str(self.folder / "none")], "--wombat: there is no"),
                                (["--frobnicate"], "--frobnicate")):
            with self.subTest(arguments=arguments):
                status, err = self.call(*arguments)
                self.assertEqual(status, 2)
                self.assertIn(part, err)
        self.program = refusing
        self.assertEqual(self.call("--filter", "none")[0], 2)
        self.assertEqual(self.call("--drivers", str(self.folder / "a b"))[0], 3)

    def test_without_apt_or_pypi_the_drivers_cannot_be_had(self):
        offline = mock.patch("base.cuda.environment", return_value=77)
        for patch, folder, part in ((mock.patch("shutil.which", return_value=None), "new", "there is no apt-get"),
                                    (mock.patch("base.debian.KEYS", self.folder / "none"), "new",
                                     "Debian's packages are checked"),
                                    (contextlib.nullcontext(), ".", "is not empty"), (offline, "drivers", "no nvcc")):
            with self.subTest(part=part), patch, mock.patch("subprocess.Popen", side_effect=AssertionError):
                status, err = self.call("--get-drivers", "--drivers", self.folder / folder)
                self.assertEqual(status, 4)
                self.assertIn(part, err)

    def test_what_apt_says_of_a_failure_is_told(self):
        programs = self.folder / "programs"
        programs.mkdir()
        self.script(programs / "apt-get", "#!/bin/sh\necho dlstatus:1:20.0:x\necho 'E: no such suite'; exit 100\n")
        self.script(programs / "dpkg-deb", "#!/bin/sh\n")
        with mock.patch.dict(os.environ, {"PATH": f"{programs}:{os.environ['PATH']}"}), \
                mock.patch("base.debian.KEYS", self.program):
            status, err = self.call("--get-drivers", "--drivers", str(self.folder / "new"), "--suite", "nonesuch")
        self.assertEqual(status, 4)
        self.assertIn("downloading: 20 %", err)
        self.assertRegex(err, "cannot read the list of nonesuch at .*:\nE: no such suite")
        self.assertFalse((self.folder / "new").exists())


@in_thorough_runs
class Real(unittest.TestCase):
    def test_every_chip_compiles(self):
        folder = Path(os.environ.get("HN_GPU_DRIVERS", command.DRIVERS))
        try:
            drivers.get(folder)
        except Missing as why:
            self.skipTest(str(why))
        with tempfile.TemporaryDirectory() as out, contextlib.redirect_stdout(io.StringIO()) as said:
            status = command.main(["--drivers", str(folder), "--out", out, "--filter",
                                   "noise2d.value.lattice"])
            self.assertEqual(status, 0, said.getvalue())
            costs = record.read_costs(Path(out) / "costs.csv")
        self.assertEqual({chip for _, chip in costs}, {chip.name for chip in CHIPS})
        for row in costs.values():
            self.assertGreater(float(row.cost), 10, row)
