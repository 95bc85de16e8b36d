"""Tests of tools/golden

What the files say and how, and that `golden --check` notices what differs.
"""

from __future__ import annotations

import contextlib
import io
import itertools
import math
import struct
import tempfile
import unittest
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from unittest import mock

from golden import command as golden
from golden import rows as golden_rows
from oracle import exact as oracle


class GoldenContents(unittest.TestCase):
    FUNCTIONS = {function.name: function for function in golden.functions()}

    def rows(self, name: str) -> list[tuple]:
        return self.FUNCTIONS[name].rows(golden_rows.Generator(golden_rows.fnv1a64(name.encode())))

    def test_format(self) -> None:
        lines = golden.render(self.FUNCTIONS["noise2d.perlin"], "fnv1").split("\n")
        self.assertEqual(lines[:8], [
            "hashnoise golden 1", "function noise2d.perlin", "hash fnv1", "arithmetic fast", "bits 0.2.0",
            "columns x:f32 y:f32 seed:u32 = value:f64", "rows 192",
            "c0000000 c0000000 00000000 = 0000000000000000",
        ])
        self.assertEqual(len(lines), 7 + 192 + 1)
        self.assertEqual(lines[-1], "")

    def file(self, function: str, configuration: str) -> list[str]:
        """The lines of a golden file."""
        candidates = [f for f in golden.functions() if f.name == function and configuration in f.configurations]
        self.assertEqual(len(candidates), 1)
        return golden.render(candidates[0], configuration).split("\n")

    def test_format_of_other_configurations(self) -> None:
        exact = self.file("gradient.lattice2", "lattice+period48")
        self.assertEqual(exact[2:6], ["hash lattice+period48", "arithmetic exact", "bits 0.2.0",
                                      "columns x:i32 y:i32 seed:u32 = gx:f32 gy:f32"])
        fast = self.file("gradient.sine3", "fnv1+sine+period1048576")
        self.assertEqual(fast[2:6], ["hash fnv1+sine+period1048576", "arithmetic fast", "bits 0.2.0",
                                     "columns x:i32 y:i32 z:i32 seed:u32 = gx:f64 gy:f64 gz:f64"])
        self.assertEqual(self.file("noise2d.perlin", "lattice+sine")[5], "columns x:f32 y:f32 seed:u32 = value:f64")
        fixed = self.file("gradient.sine2", "lattice+sine+fixed")
        self.assertEqual(fixed[2:4], ["hash lattice+sine+fixed", "arithmetic fixed"])

    def test_fixed_arithmetic_by_hand(self) -> None:
        # Where a float has no fraction there is no noise.
        lines = self.file("noise2d.perlin", "lattice+fixed")
        self.assertIn("80000000 80000000 00000000 = 0000000000000000", lines)
        self.assertIn("7f61b1e6 7f61b1e6 00000000 = 0000000000000000", lines)  # 3e38
        clouds = self.file("fbm.clouds2", "lattice+fixed")
        no_octaves = [line for line in clouds[7:-1] if line.split()[2] in ("00000000", "ffffffff")]
        self.assertGreaterEqual(len(no_octaves), 4)
        for line in no_octaves:
            self.assertEqual(line.split()[-1], "3fc4000000000000", line)  # 5/32

    def test_values_of_fixed_arithmetic_are_floats(self) -> None:
        for function in golden.functions():
            for name in function.configurations:
                if not golden.is_fixed(name):
                    continue
                for line in golden.render(function, name).split("\n")[7:-1]:
                    for pattern in line.split(" = ")[1].split():
                        value, = struct.unpack(">d", bytes.fromhex(pattern))
                        self.assertEqual(golden_rows.to_f32(value), value)
                        self.assertTrue(value != 0 or math.copysign(1, value) == 1)

    def test_fixed_arithmetic_sees_the_other_inputs_first(self) -> None:
        for function in golden.functions():
            for name in function.configurations:
                if golden.is_fixed(name):
                    rows, others = function.rows_with(name), self.rows(function.name)
                    self.assertEqual(rows[:len(others)], others)
                    self.assertEqual(len(rows) > len(others), not function.name.startswith("gradient."), name)

    def test_inputs_of_fixed_arithmetic_reach_every_edge(self) -> None:
        edges = {-1e-40, -2.0**-21, -2.0**-20, 2.0**-149, 2.0**23, 2.0**31, -2.0**31, 3e38, -3.4e38}
        edges = set(map(golden_rows.to_f32, edges))
        for n in (2, 3):
            points = [row[:n] for row in self.FUNCTIONS[f"noise{n}d.perlin"].rows_with("lattice+fixed")]
            for axis in range(n):
                self.assertTrue(edges <= {p[axis] for p in points})
                self.assertTrue(any(p[axis] == 0 and math.copysign(1, p[axis]) < 0 for p in points))
                phases = {p[axis] - round(p[axis]) for p in points if abs(p[axis]) < 100}
                self.assertTrue(any(0 < x < 2**-17 for x in phases) and any(-2**-17 < x < 0 for x in phases))
            cells = self.FUNCTIONS[f"noise{n}d.perlin_cell"].rows_with("lattice+fixed")
            for axis in range(n):
                self.assertTrue({0, 2.0**-149, 0.5, 1 - 2.0**-24, 1} <= {row[n + axis] for row in cells})
            sums = self.FUNCTIONS[f"fbm.fbm{n}"].rows_with("lattice+fixed")
            octaves, lacunarities, gains = ({row[n + i] for row in sums} for i in range(3))
            self.assertTrue({-1, 0, 1, 32, 33} <= octaves)
            self.assertTrue(set(map(golden_rows.to_f32, (1.9, 3.7, 0, 255))) <= lacunarities)
            self.assertTrue({0, 1, 1.5} <= gains)
            self.assertTrue(any(abs(x) >= 2**31 for row in sums for x in row[:n]))

    def test_configurations_see_the_same_inputs(self) -> None:
        for function, names in (("noise2d.perlin_cell", ("lattice", "lattice+sine", "lattice+period48")),
                                ("gradient.lattice2", ("lattice", "fnv1", "lattice+period48")),
                                ("gradient.sine2", ("lattice+sine", "fnv1+sine+period1048576"))):
            inputs = [[line.split(" = ")[0] for line in self.file(function, name)[7:]] for name in names]
            self.assertTrue(all(other == inputs[0] for other in inputs))

    def test_configurations(self) -> None:
        sine = {f"{name}+sine" for name in ("fnv1", "partial_fnv1", "jenkins", "partial_jenkins", "murmur", "lattice")}
        sine |= {"fnv1+sine+period1048576"}
        periodic = {"lattice+period64", "lattice+period48", "lattice+period1048576"}
        fixed = {"lattice+fixed", "lattice+sine+fixed"}
        expected = {"gradient.lattice": {*oracle.HASHES, *periodic}, "gradient.sine": {*sine, "lattice+sine+fixed"},
                    "noise": {*oracle.HASHES, *sine, *periodic, *fixed, "fnv1+fixed", "lattice+period48+fixed"},
                    "fbm": {*oracle.HASHES, "lattice+sine", *fixed}}
        for name in self.FUNCTIONS:
            found = [c for function in golden.functions() if function.name == name for c in function.configurations]
            names = next((names for prefix, names in expected.items() if name.startswith(prefix)), None)
            names = names or (set(oracle.HASHES) if found != ["any"] else {"any"})
            self.assertEqual(sorted(found), sorted(names), name)

    def test_cell_gradient_rows_reach_every_case(self) -> None:
        for n in (2, 3):
            coordinates = {c for row in self.rows(f"gradient.lattice{n}") for c in row[:n]}
            self.assertTrue({0, 1, -1, golden_rows.INT_MIN, golden_rows.INT_MAX} <= coordinates)
            for period in (48, 64, 2**20):
                for sign, reach in itertools.product((-1, 1), (period, 2**30)):
                    phases = {c % period for c in coordinates if c * sign >= reach}
                    self.assertTrue({0, 1, period - 1} <= phases, (n, period, sign, reach))

    def test_a_tie_matters_to_every_sine_gradient(self) -> None:
        def away(n: int) -> int:
            step = 1 << max(n.bit_length() - 24, 0)
            return int(math.copysign((abs(n) + step // 2) // step * step, n))

        for n, name in itertools.product((2, 3), golden_rows.SINE):
            cells = [(row[:n], row[n]) for row in self.rows(f"gradient.sine{n}")]
            even = [component for cell in cells for component in oracle.gradient(name, *cell)]
            with mock.patch.object(oracle, "round24", away):
                other = [component for cell in cells for component in oracle.gradient(name, *cell)]
            # By more than the contract allows.
            self.assertGreater(max(abs(a - b) for a, b in zip(even, other)), 2**-19, (n, name))

    def test_the_sine_is_exact_enough_for_the_nearest_double(self) -> None:
        # The weights of the components of a noise sum to n / 2 at most; clouds are up to three times as steep as it.
        margin = 3 * Fraction(3, 2) * oracle.SINE_ERROR
        for function in golden.functions():
            if "lattice+sine" in function.configurations:
                for row in self.rows(function.name):
                    for value in function.evaluate("lattice+sine", row):
                        if value not in (0, 1):
                            self.assertEqual(float(value - margin), float(value + margin), (function.name, row))

    def test_patterns(self) -> None:
        self.assertEqual(golden.line("a:i32 b:u32 c:f32 d:f64", (-2, 255, -1.5, 0.5)),
                         "fffffffe 000000ff bfc00000 3fe0000000000000")
        self.assertEqual(golden.line("a:f64", (Fraction(1, 3),)), "3fd5555555555555")
        self.assertEqual(golden.line("a:f64", (Fraction(0),)), "0000000000000000")
        with self.assertRaises(ValueError):
            golden.line("a:f32", (0.1,))
        with self.assertRaises(ValueError):
            golden.line("a:u32 b:u32", (1,))

    def test_digest_runs_over_the_last_coordinate_first(self) -> None:
        function = golden.Function("hash.test", "x:i32 y:i32 seed:u32", "value:u32", None,
                                   lambda _, row: (100 * row[0] + 10 * row[1] + row[2],),
                                   digest=golden.Digest((1, 2), (2, 3), 4))
        values = b"".join(value.to_bytes(4, "little") for value in (124, 134, 144, 224, 234, 244))
        self.assertEqual(golden.digest_line(function, "any"),
                         f"digest origin=1,2 size=2,3 seed=4 fnv1a64={golden_rows.fnv1a64(values):016x}")

    def test_digest_wraps(self) -> None:
        for name in oracle.HASHES:
            self.assertEqual(oracle.hash_words(name, (2**32, 2**32 + 1)), oracle.hash_words(name, (0, 1)), name)

    def test_row_counts(self) -> None:
        least = {"hash.word": 64, "hash.gradient2": 128, "hash.gradient3": 128,
                 "gradient.lattice2": 96, "gradient.lattice3": 96, "gradient.sine2": 96, "gradient.sine3": 96}
        for name in self.FUNCTIONS:
            expected = least.get(name, 192 if name.startswith("noise") else 64)
            self.assertGreaterEqual(len(self.rows(name)), expected, name)

    def test_gradient_rows_reach_every_case(self) -> None:
        words = [word for word, in self.rows("hash.gradient3")]
        self.assertEqual({tuple(x > 0 for x in oracle.gradient2(word)) for word in words},
                         set(itertools.product((False, True), repeat=2)))
        signs = {tuple((x > 0) - (x < 0) for x in oracle.gradient3(word)) for word in words}
        self.assertEqual(signs, {(x, y, z) for x, y, z in itertools.product((-1, 0, 1), repeat=3) if z and (x or y)})

    def test_perlin_rows_reach_every_case(self) -> None:
        for n in (2, 3):
            points = [row[:n] for row in self.rows(f"noise{n}d.perlin")]
            self.assertTrue(any(all(x == math.floor(x) for x in p) and min(p) < 0 for p in points))
            self.assertTrue(any(all(x * 2 % 2 == 1 for x in p) for p in points))
            for far in (2**20, 2**22):
                self.assertTrue(any(all(abs(abs(x) - far) <= 4 and x % 1 for x in p) for p in points))

    def test_octave_positions_are_exact_in_float32(self) -> None:
        for name, n in (("fbm.fbm2", 2), ("fbm.clouds3", 3)):
            for row in self.rows(name):
                octaves, lacunarity = row[n:n + 2]
                if lacunarity != 1.90625:
                    self.assert_exact_positions(row[:n], octaves, lacunarity)

    def assert_exact_positions(self, q: Sequence[float], octaves: int, lacunarity: float) -> None:
        # From each octave to the next, with and without a fused multiply-add.
        for _ in range(octaves - 1):
            scaled = [x * lacunarity for x in q]
            q = [x + float(shift) for x, shift in zip(scaled, oracle.SHIFT)]
            for x in scaled + q:
                self.assertEqual(golden_rows.to_f32(x), x)

    def test_many_clouds_are_neither_clear_nor_full(self) -> None:
        for n in (2, 3):
            values = [oracle.clouds("lattice", row[:n], *row[n:]) for row in self.rows(f"fbm.clouds{n}")]
            self.assertGreaterEqual(sum(0 < value < 1 for value in values), len(values) / 2)
            self.assertIn(0, values)


class GoldenCheck(unittest.TestCase):
    """What --check must notice, on a few files in a directory of its own."""

    def setUp(self) -> None:
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = Path(directory.name) / "golden"
        some = [function for function in golden.functions() if function.configurations == ("any",)]
        self.files = {f"{function.name}.any.golden": golden.render(function, "any") for function in some}
        golden.write(self.directory, self.files)

    def run_main(self, *arguments: str) -> tuple[int, str]:
        """The exit status and what was printed, with `generate` cut down to the few files."""
        out = io.StringIO()
        with mock.patch.object(golden, "generate", return_value=self.files), contextlib.redirect_stdout(out):
            return golden.main([*arguments, "--out", str(self.directory)]), out.getvalue()

    def test_untouched_files_pass(self) -> None:
        self.assertEqual(self.run_main("--check")[0], 0)

    def test_flipped_digit_is_noticed(self) -> None:
        path = self.directory / "hash.unorm.any.golden"
        lines = path.read_text().split("\n")
        lines[9] = lines[9][:-1] + ("1" if lines[9][-1] == "0" else "0")
        path.write_text("\n".join(lines))
        status, output = self.run_main("--check")
        self.assertEqual(status, 1)
        self.assertRegex(output, r"^hash\.unorm\.any\.golden: differs, line 10: expected .*, found .*\n$")

    def test_line_ends_and_truncation_are_noticed(self) -> None:
        path = self.directory / "hash.snorm.any.golden"
        whole = path.read_bytes()
        for damaged in (whole.replace(b"\n", b"\r\n"), whole[:-1], whole + b"\n", b"", whole[:-2] + b"\xff\n"):
            path.write_bytes(damaged)
            status, output = self.run_main("--check")
            self.assertEqual((status, output.count("\n")), (1, 1), output)

    def test_missing_file_is_noticed(self) -> None:
        (self.directory / "hash.gradient3.any.golden").unlink()
        self.assertEqual(self.run_main("--check"), (1, "hash.gradient3.any.golden: missing\n"))

    def test_missing_directory_is_noticed(self) -> None:
        self.directory = self.directory / "none"
        self.assertEqual(self.run_main("--check")[0], 1)

    def test_extra_file_is_noticed(self) -> None:
        (self.directory / "hash.old.any.golden").write_text("")
        self.assertEqual(self.run_main("--check"), (1, "hash.old.any.golden: extra\n"))

    def test_writing_removes_stale_files_only(self) -> None:
        (self.directory / "hash.old.any.golden").write_text("")
        (self.directory / "README.md").write_text("")
        self.assertEqual(self.run_main()[0], 0)
        self.assertEqual({path.name for path in self.directory.iterdir()}, {*self.files, "README.md"})
        self.assertEqual(self.run_main("--check")[0], 0)

    def test_bad_usage(self) -> None:
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as exit_:
            golden.main(["--chekc"])
        self.assertEqual(exit_.exception.code, 2)
