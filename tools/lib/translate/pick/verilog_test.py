"""The text that tools/pick --language verilog writes has the bits of the library.

    python3 -m translate.pick.verilog_test FOLDER         the vectors in that folder, by Icarus Verilog
    python3 -m translate.pick.verilog_test FOLDER Whole   more of them, and by Verilator beside the library in C++

Exit status: 0 the same, 1 not, 77 a simulator is not installed.
"""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
import unittest
from collections.abc import Sequence
from pathlib import Path

from base.png import read_png
from base.renderer import Renderer
from base.testing import skipped_without
from base.tree import GLSL, ROOT
from translate.parsing.tokens import Unknown
from translate.pick import command, verilog, verilog_bench
from translate.pick.runners import ran
from translate.pick.verilog import FunctionCircuit
from translate.pick.verilog_bench import LINT, SUM
from translate.single_file import files
from translate.tools import own

POINTS = 1_000_000
# Functions, the vectors of each, its constants, and the noise of a sum.
FEW = (("hn_simplex2", "noise2d.simplex_cell", "", ""),)
ALL = (*FEW, ("hn_random2", "noise2d.random_cell", "", ""), ("hn_perlin2", "noise2d.perlin_cell", "", ""), ("hn_perlin3", "noise3d.perlin_cell", "", ""),
       ("hn_simplex3", "noise3d.simplex_cell", "", ""), ("hn_value2", "noise2d.value_cell", "", ""),
       ("hn_cellular2", "noise2d.cellular_cell", "", ""), ("hn_fbm2", "fbm.fbm2_cell", "octaves=2,lacunarity=1,gain=0.7", ""),
       ("hn_fbm2", "", SUM, ""), ("hn_fbm2", "", SUM, "hn_simplex2"))
EXAMPLE = ROOT / "examples" / "silicon"


def made(name: str, constants: str = "", noise: str = "", **choices: str) -> FunctionCircuit:
    choice = command.Choice("verilog", "fixed", noise=noise, constants=constants, **choices)
    return verilog.circuits([name], choice, command.read_library(GLSL, choice), GLSL)[0]


def text(of: FunctionCircuit) -> str:
    return verilog.text([of], [])


class Texts(unittest.TestCase):
    def refusal(self, *names: str, **choices: str) -> str:
        with self.assertRaises(Unknown) as refused:
            command.picked(names, command.Choice(language="verilog", arithmetic="fixed", **choices))
        self.assertNotIn("\n", str(refused.exception))
        return str(refused.exception)

    def test_what_is_no_circuit_is_refused_with_what_would_be_right(self) -> None:
        self.assertRegex(self.refusal("hn_fbm2"), "add --constants octaves=6,lacunarity=2.0,gain=0.5$")
        self.assertRegex(self.refusal("hn_perlin2_phase"), "takes phase, .* add --constants phase=0.25$")
        self.assertRegex(self.refusal("hn_value2", noise="hn_simplex2"), "is no sum")
        self.assertRegex(self.refusal("hn_position2"), "has no value in whole numbers .*Ask for a noise")
        self.assertRegex(self.refusal("hn_next2"), "takes hn_octaves2, for which a module has no port: ask for")
        self.assertRegex(self.refusal("hn_perlin2", constants="octaves=3"), "no such parameter; it takes place, seed")
        self.assertRegex(self.refusal("hn_fbm2", constants="octaves=x,lacunarity=2,gain=1"), "such as octaves=6")
        self.assertRegex(self.refusal("hn_perlin2", clock="400"), "too fast .*: at most --clock 149")

    def test_options_of_circuits_are_refused_elsewhere(self) -> None:
        for option in command.OF_VERILOG:
            with self.assertRaisesRegex(Unknown, f"--{option} is of --language verilog"):
                command.picked(["hn_perlin2"], command.Choice(**{option: "1"}))
        with self.assertRaisesRegex(Unknown, "take --arithmetic fixed"):
            command.picked(["hn_perlin2"], command.Choice(language="verilog"))

    def test_a_clock_and_a_number_of_stages_place_registers(self) -> None:
        slow, fast = made("hn_random2", clock="20"), made("hn_random2", clock="140")
        self.assertLess(slow.pipeline.latency, fast.pipeline.latency)
        for stages in ("1", "5"):
            self.assertEqual(made("hn_random2", stages=stages).pipeline.latency, int(stages))

    def test_multipliers_are_at_most_as_many_as_there_are(self) -> None:
        counts = [sum(gate.kind == "times" for gate in made("hn_random2", multipliers=most).pipeline.order)
                  for most in ("", "5", "0")]
        self.assertGreater(counts[0], counts[1])
        self.assertLessEqual(counts[1], 5)
        self.assertEqual(counts[2], 0)

    def test_a_port_is_what_is_read(self) -> None:
        self.assertEqual([port.name for port in made("hn_random2", "seed=7").read], ["cell_x", "cell_y"])


class Simulated(unittest.TestCase):
    folder: Path

    def differing(self, of: FunctionCircuit, shown: str, name: str, by_verilator: bool = False) -> tuple[int, int]:
        """In how many rows they differ."""
        found = verilog_bench.vectors(of, self.folder / f"{name}.json")
        with tempfile.TemporaryDirectory() as folder:
            values = verilog_bench.at_points(of, shown, verilog_bench.of_read(of, found.points), Path(folder), by_verilator)
        expected = [" ".join(map(str, row)) for row in found.values]
        return sum(a != b for a, b in zip(values, expected, strict=True)), len(values)

    def compare(self, functions: Sequence[tuple[str, str, str, str]]) -> None:
        for name, file, constants, noise in functions:
            if file:
                with self.subTest(name):
                    of = made(name, constants, noise)
                    wrong, count = self.differing(of, text(of), file)
                    self.assertEqual(wrong, 0)
                    self.assertGreaterEqual(count, 3 if constants else 20)

    def test_vectors(self) -> None:
        self.compare(FEW)

    def test_a_fault_is_noticed(self) -> None:
        of = made("hn_random2")
        shown = re.sub(r"([a-z_0-9]+) \^ ", r"\1 | ", text(of), count=1)
        self.assertNotEqual(shown, text(of))
        wrong, count = self.differing(of, shown, "noise2d.random_cell")
        self.assertGreater(wrong, 5)


class Whole(Simulated):
    """In minutes."""

    def test_vectors(self) -> None:
        self.compare(ALL)

    def test_linters_are_silent_and_the_bits_are_those_of_the_library(self) -> None:
        for name, file, constants, noise in ALL:
            for multipliers in ("", "28", "0") if name in ("hn_simplex2", "hn_value2") else ("",):
                with self.subTest(name, noise=noise, multipliers=multipliers), tempfile.TemporaryDirectory() as folder:
                    of = made(name, constants, noise, multipliers=multipliers)
                    shown = text(of)
                    (Path(folder) / f"{name}.v").write_text(shown, encoding="ascii")
                    self.assertEqual(ran(Path(folder), *LINT, f"{name}.v"), "")
                    self.assertEqual(verilog_bench.differing(of, shown, POINTS, Path(folder)), 0)
                    if file:
                        self.assertEqual(self.differing(of, shown, file, by_verilator=True)[0], 0)

    def test_the_frame_of_the_example_is_that_of_its_shader(self) -> None:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name) / "silicon"
            shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("made", "pattern", "hn_fbm2.v"))
            self.assertIn("\n0 of 921600 pixels differ", ran(folder, "make", "picture", f"root={ROOT}"))
            for module in ("pattern", "ulx3s"):
                ran(folder, *LINT, "-GLATENCY=9", "-Wno-DECLFILENAME", "--top-module", module, "hn_fbm2.v", "pattern.v", "ulx3s.v")
            width, height, pixels = read_png(folder / "frame.png")
            shader = (folder / "noise.frag").read_text(encoding="ascii").replace("uniform int frame", "const int frame = 2")
        begin, _, body = shader.partition('#include "hashnoise/octaves2d.glsl"')
        body = "".join(line for line in body.splitlines(True) if not line.startswith("#include"))
        library = files.text(["octaves2d.glsl", "position.glsl", "simplex2d.glsl"])
        renderer = Renderer(side=640)
        drawn = renderer.draw(renderer.program(
            "".join(line for line in begin.splitlines(True) if "include" not in line) + library + body))
        self.assertEqual((width, height), (640, 480))
        self.assertEqual([round(255 * level) for level in drawn[0:4 * width * height:4]], list(pixels[::3]))
        self.assertGreater(len(set(pixels)), 200)

    def test_the_comparison_with_the_library_notices_a_fault(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            of = made("hn_value2")
            shown = re.sub(r"([a-z_0-9]+) \+ ", r"\1 - ", text(of), count=1)
            self.assertGreater(verilog_bench.differing(of, shown, 1000, Path(folder)), 100)


if __name__ == "__main__":
    Simulated.folder = Path(sys.argv[1]).resolve()
    cases = sys.argv[2:] or ["Texts", "Simulated"]
    with skipped_without():
        for name in ("iverilog", *(["verilator"] if cases == ["Whole"] else [])):
            own(name)
    unittest.main(argv=[sys.argv[0], *cases], verbosity=2)
