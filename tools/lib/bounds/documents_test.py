"""Tests of documents.py, table.py and command.py: what quotes a bound follows the derivation, and another number is an
error with its place. The derivation itself is not run: RAW is what it gave of one noise, and others are left out."""

import contextlib
import io
import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from bounds import command, documents, noises, table
from bounds.gradients import OCTAHEDRAL, SINE
from bounds.noises import Derived
from bounds.table import rounded_up, scientific, shortest
from tables.inc import TableError
from tree import ROOT

RAW = {("perlin", dims, gradient): Derived(*numbers, {"cut": 4.35e-6}) for dims, gradient, numbers in (
    (2, OCTAHEDRAL, (1.0, 0.999984208, 4.56535614, 3.23311779e-06, 3.50523422e-06, 0.99998771, 4.8915056e-05, 0.99948)),
    (3, OCTAHEDRAL, (1.0, 0.999919942, 6.17185551, 5.17145935e-06, 5.5393306e-06, 0.99992548, 6.02868199e-05, 0.9989)),
    (2, SINE, (1.0, 1.0, 3.7500001, 4.35114336e-06, 4.57466078e-06, 1.00000458, 7.9792903e-05, 1.00000809)),
    (3, SINE, (1.5, 1.5, 6.9375197, 7.78083655e-06, 8.19434495e-06, 1.5000082, 0.000139288989, 1.5000119)))}

OTHERS = [name for name in noises.names() if name != "perlin"]


class Rounding(unittest.TestCase):
    def test_is_up(self):
        self.assertEqual([scientific(x) for x in (3.2301e-6, 3.23e-6 - 1e-12, 9.999e-5)],
                         ["3.24e-6", "3.23e-6", "1.00e-4"])
        self.assertEqual([scientific(3.2301e-6, 2), str(rounded_up(3.7500001, 3)), str(rounded_up(4.5, 3))],
                         ["3.3e-6", "3.76", "4.50"])
        self.assertEqual([shortest(0.99991994, 6), shortest(1.5, 6), shortest(12.0, 3)], ["0.99992", "1.5", "12"])

    def test_a_row(self):
        self.assertEqual(table.noise_row(RAW["perlin", 3, SINE].bounds("perlin", 3, SINE)),
                         'NOISE_BOUNDS("perlin", 3, sine, 7.79e-6, 8.20e-6, 6.94, 1.50001, 1.40e-4, 1.50002)\n')
        # Within what the contract promises, the limit is that.
        self.assertEqual(table.noise_row(RAW["perlin", 2, OCTAHEDRAL].bounds("perlin", 2, None)),
                         'NOISE_BOUNDS("perlin", 2, none, 3.24e-6, 3.51e-6, 4.57, 1.0, 4.90e-5, 1.0)\n')


class Tree(unittest.TestCase):
    """A copy of what quotes bounds, in which a number is changed."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        patch = mock.patch.object(noises, "names", return_value=["perlin"])
        patch.start()
        self.addCleanup(patch.stop)
        for part in ("glsl", "docs/accuracy.md", "docs/knobs.md", str(table.PATH.relative_to(ROOT))):
            (self.root / part).parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if (ROOT / part).is_dir() else shutil.copy)(ROOT / part, self.root / part)
        for path in (path for name in OTHERS for path in (self.root / "glsl").glob(f"{name}*.glsl")):
            path.unlink()
        self.write()  # what depends on RAW's parts

    def write(self):
        for path, text in command.files(RAW, self.root).items():
            path.write_text(text)

    def differences(self):
        return [message.replace(f"{self.root}/", "") for message in command.differences(RAW, self.root)]

    def change(self, path, old, new):
        text = (self.root / path).read_text()
        self.assertIn(old, text)
        (self.root / path).write_text(text.replace(old, new, 1))

    def line(self, path, text):
        lines = (self.root / path).read_text().split("\n")
        return next(number for number, line in enumerate(lines, 1) if text in line)

    def comment_over(self, file, signature):
        """The path of a file of the library in which the comment over a function is."""
        return next(f"glsl/{path.name}" for path in sorted((self.root / "glsl").glob(file))
                    if signature in path.read_text())

    def test_the_copy_is_right(self):
        self.assertEqual(self.differences(), [])

    def test_table_and_page_are_compared(self):
        self.change(table.PATH.relative_to(ROOT), "3.24e-6", "3.23e-6")
        self.change("docs/accuracy.md", "3.24e-6", "3.23e-6")
        self.assertEqual(self.differences(), [
            "conformance/expected/bounds.inc: not up to date; run tools/bounds --write",
            "docs/accuracy.md: not up to date; run tools/bounds --write"])

    def test_a_page_without_its_marks(self):
        self.change("docs/accuracy.md", "<!-- tools/bounds: sums -->", "")
        with self.assertRaisesRegex(LookupError, "docs/accuracy.md has no <!-- tools/bounds: sums -->"):
            self.write()

    def test_prose_is_compared(self):
        for path, old, new in (("docs/knobs.md", "3.51e-6 | 5.54e-6", "3.51e-6 | 5.55e-6"),
                               ("docs/knobs.md", "0.99992", "0.99991"),
                               ("docs/accuracy.md", "adds 2.53e-5", "adds 2.52e-5")):
            with self.subTest(path=path, old=old):
                self.setUp()
                # A table quotes it twice: in both lines.
                text = (self.root / path).read_text().replace(old, new)
                (self.root / path).write_text(text)
                message, = self.differences()
                self.assertRegex(message, rf"^{path}: it must state .*{old.split()[-1]}")

    def test_comments_are_compared(self):
        noise2d = self.comment_over("*2d.glsl", " hn_perlin(hn_")
        noise3d = self.comment_over("*3d.glsl", " hn_perlin(hn_")
        gradient = self.comment_over("*.glsl", " hn_gradient(")
        clouds = self.comment_over("*.glsl", " hn_clouds(")
        cases = (
            (noise2d, "at most 3.3e-6", "at most 3.2e-6", r"3.2e-6 of hn_perlin\(ivec2, vec2, uint\) should be 3.3e-6"),
            (noise2d, "at most 3.51e-6", "at most 3.52e-6", r"3.52e-6 of hn_perlin\(vec2, uint\) should be 3.51e-6"),
            (noise2d, "HN_GRADIENT_SINE 4.58e-6", "HN_GRADIENT_SINE 4.6e-5", r"should be 4.6e-6"),
            (noise3d, "HN_FIXED 6.03e-5", "HN_FIXED 6.02e-5", r"should be 6.03e-5"),
            (noise3d, "HN_GRADIENT_SINE 1.40e-4", "HN_GRADIENT_SINE 1.4e-5", r"should be 1.4e-4"),
            (noise3d, "proven bound 0.99992", "proven bound 0.9999", r"0.9999 of .* should be 1"),
            (gradient, "(HN_FIXED: 3.7e-5", "(HN_FIXED: 3.6e-5", "should be 3.7e-5"),
            (clouds, "HN_FIXED 2.6e-5", "HN_FIXED 2.7e-5", "should be 2.6e-5"),
            (clouds, "  [0, 1]: 0 is clear", "  [0, 1.0001]: 0 is clear", "1.0001 of .* is derived nowhere"))
        for path, old, new, message in cases:
            with self.subTest(new=new):
                self.setUp()
                self.change(path, old, new)
                found, = self.differences()
                self.assertRegex(found, rf"^{path}:{self.line(path, new)}: .*{message}")


class Command(unittest.TestCase):
    def check(self, problem: Exception) -> tuple[int, str]:
        """The status of --check and its message, if the comparison ends so."""
        shown = io.StringIO()
        with mock.patch.object(command, "derive", return_value=RAW), contextlib.redirect_stderr(shown), \
                mock.patch.object(command, "differences", side_effect=problem):
            return command.main(["--check"]), shown.getvalue()

    def test_a_broken_table_or_page_is_a_message(self):
        for problem in (TableError("bounds.inc:3: x is not a word"), LookupError("accuracy.md has no marks")):
            self.assertEqual(self.check(problem), (2, f"{problem}\n"))

    def test_a_mistake_of_the_program_is_not(self):
        with self.assertRaises(KeyError):
            self.check(KeyError("x"))


class Entries(unittest.TestCase):
    def test_perlin_is_found_and_others_are_not(self):
        self.assertIn("perlin", noises.names())
        with self.assertRaisesRegex(LookupError, "write tools/lib/bounds/noises/merlin.py"):
            noises.find("merlin")

    def test_a_noise_without_a_row(self):
        with self.assertRaisesRegex(LookupError, "bounds.inc has no bounds of merlin in 2D"):
            table.bounds_of("merlin", 2, "octahedral")

    def test_the_table_is_read_as_it_is_written(self):
        rounded = [of_noise.bounds(*key).rounded() for key, of_noise in RAW.items()]
        self.assertEqual([bounds for bounds in table.read() if bounds.noise == "perlin"], rounded)
        self.assertEqual(table.read_sine(), table.SineBounds(2.0**-19, 3.66e-5))

    def test_every_example_of_a_sum_is_in_its_table(self):
        rows = documents.sums_table(RAW).split("\n")
        self.assertEqual(rows[2], "| `hn_fbm(vec2)`, exact positions | 4.9e-6 | 5.2e-5 | 6.0e-6 | 8.3e-5 |")
        self.assertEqual(len(rows), 2 + len(documents.EXAMPLES) + 1)
