"""Tests of documents.py, table.py and command.py: what quotes a bound follows the derivation, and another number is an
error with its place. The derivation itself is not run: EXACT is its result for a noise and of the one with its
derivatives, RAW has errors of the record beside it, and others are left out."""

import contextlib
import io
import math
import re
import shutil
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

import catalog.model
from base.tree import ROOT
from catalog.tables import glsl
from proof.bounds import claims, command, documents, noises, sums, table
from proof.bounds.gradients import OCTAHEDRAL, SINE
from proof.bounds.noises import ProvenBounds
from proof.bounds.table import rounded_up, scientific, shortest
from proof.errors import record

EXACT = {("perlin", dims, gradient): ProvenBounds(*numbers) for dims, gradient, numbers in (
    (1, OCTAHEDRAL, (1, 0.998047325)), (2, OCTAHEDRAL, (1, 0.909129023)),
    (3, OCTAHEDRAL, (1, 0.996888828)), (4, OCTAHEDRAL, (1, 0.999033831)),
    (2, SINE, (1.0, 1.0)), (3, SINE, (1.5, 1.5)))}
EXACT |= {("perlin_d", dims, OCTAHEDRAL): replace(EXACT["perlin", dims, OCTAHEDRAL], slope=ProvenBounds(0, steepest))
          for dims, steepest in ((1, 2.68904067), (2, 2.90564073), (3, 3.60720851), (4, 3.61689537))}
RAW = {key: command.with_errors(key, bounds) for key, bounds in EXACT.items()}
# The errors that comments state.
PLANE, LINE_D, SPACE_D = RAW["perlin", 2, OCTAHEDRAL], RAW["perlin_d", 1, OCTAHEDRAL].slope, RAW["perlin_d", 4, OCTAHEDRAL].slope

NAMES = ["perlin", "perlin_d"]
OTHERS = [name for name in noises.names() if name not in NAMES]


class Rounding(unittest.TestCase):
    def test_is_up(self):
        self.assertEqual([scientific(x) for x in (3.2301e-6, 3.23e-6 - 1e-12, 9.999e-5)],
                         ["3.24e-6", "3.23e-6", "1.00e-4"])
        self.assertEqual([scientific(3.2301e-6, 2), str(rounded_up(3.7500001, 3)), str(rounded_up(4.5, 3))],
                         ["3.3e-6", "3.76", "4.50"])
        self.assertEqual([shortest(0.99991994, 6), shortest(1.5, 6), shortest(12.0, 3)], ["0.99992", "1.5", "12"])

    def test_a_row(self):
        of_sine = ProvenBounds(1.5, 1.5, 6.93756014, 7.69718103e-06, 8.11069184e-06, 1.50000811, 0.000139159166, 1.5000119)
        self.assertEqual(table.row_of("NOISE_BOUNDS", of_sine.bounds("perlin", 3, SINE)),
                         'NOISE_BOUNDS("perlin", 3, sine, 7.70e-6, 8.12e-6, 6.94, 1.50001, 1.40e-4, 1.50002)\n')
        # Within the contract's promise, the limit is that.
        within = ProvenBounds(1, 0.909129023, 3.76671991, 2.43583288e-06, 2.66034689e-06, 0.909131683, 4.29217982e-05, 0.9092)
        self.assertEqual(table.row_of("NOISE_BOUNDS", within.bounds("perlin", 2, None)),
                         'NOISE_BOUNDS("perlin", 2, none, 2.44e-6, 2.67e-6, 3.77, 1.0, 4.30e-5, 1.0)\n')
        # A derivative has no promise.
        slope = ProvenBounds(0, 2.90564073, 14.8241721, 1.23307053e-05, 1.32142948e-05, 2.90565395, 0.00020028267, 2.90582688
                             ).bounds("perlin_d", 2, OCTAHEDRAL)
        self.assertEqual(table.row_of("SLOPE_BOUNDS", slope), 'SLOPE_BOUNDS("perlin_d", 2, octahedral, 1.24e-5, 1.33e-5, 14.9, '
                                                 '2.90566, 2.01e-4, 2.90583)\n')


class Tree(unittest.TestCase):
    """A copy of what quotes bounds, in which a number is changed."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        patch = mock.patch.object(noises, "names", return_value=NAMES)
        patch.start()
        self.addCleanup(patch.stop)
        for part in ("catalog", "glsl", "docs/measured/accuracy.md", "docs/reference/knobs.md",
                     "docs/reference/fractals.md", str(table.PATH.relative_to(ROOT))):
            (self.root / part).parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if (ROOT / part).is_dir() else shutil.copy)(ROOT / part, self.root / part)
        for path in (path for name in OTHERS for path in (self.root / "glsl").rglob(f"{name}*.glsl")):
            path.unlink()
        # A phase has bounds of its own.
        self.change("catalog/noises.toml", "d_phase = [[], [-2.93, 2.93], [-3.34, 3.34], []]\n", "")
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
        return next(str(path.relative_to(self.root)) for path in sorted((self.root / "glsl" / "hashnoise").glob(file))
                    if signature in path.read_text())

    def test_the_copy_is_right(self):
        self.assertEqual(self.differences(), [])

    def test_table_and_page_are_compared(self):
        for path in (table.PATH.relative_to(ROOT), "docs/measured/accuracy.md"):
            self.change(path, scientific(PLANE.cell_error), "9.99e-9")
        self.assertEqual(self.differences(), [
            "conformance/expected/bounds.inc: not up to date; run tools/make bounds",
            "docs/measured/accuracy.md: not up to date; run tools/make bounds"])

    def test_every_table_has_its_marks(self):
        for name in documents.TABLES:
            self.setUp()
            self.change("docs/measured/accuracy.md", f"<!-- tools/make bounds: {name} -->", "")
            with self.assertRaisesRegex(LookupError, f"docs/measured/accuracy.md has no <!-- tools/make bounds: {name} -->"):
                self.write()

    def test_prose_is_compared(self):
        errors = f"{scientific(PLANE.error)} | {scientific(RAW['perlin', 3, OCTAHEDRAL].error)}"
        for path, old, new in (("docs/reference/knobs.md", errors, "2.67e-6 | 4.46e-6"),
                               ("docs/measured/accuracy.md", "0.994 * 2^31", "0.993 * 2^31")):
            with self.subTest(path=path, old=old):
                self.setUp()
                # A table quotes it twice: in both lines.
                text = (self.root / path).read_text().replace(old, new)
                (self.root / path).write_text(text)
                message, = self.differences()
                self.assertRegex(message, rf"^{path}: it must state .*{re.escape(old.split()[-1])}")

    def test_comments_are_compared(self):
        noise2d = self.comment_over("*2d.glsl", " hn_perlin(hn_")
        noise3d = self.comment_over("*3d.glsl", " hn_perlin(hn_")
        gradient = self.comment_over("*.glsl", " hn_gradient(")
        clouds = self.comment_over("*2d.glsl", " hn_clouds(hn_")
        first, second, fourth = (self.comment_over(f"*{dims}d.glsl", " hn_perlin_d(hn_") for dims in (1, 2, 4))
        cell, position, of_sine, fixed = map(scientific, (
            PLANE.cell_error, PLANE.error, RAW["perlin", 2, SINE].cell_error, RAW["perlin", 3, SINE].fixed_error))
        cases = (
            (noise2d, f"at most {cell}", "at most 2.43e-9", rf"2.43e-9 of hn_perlin\(place2, uint\) should be {cell}"),
            (noise2d, f"at most {position}", "at most 2.68e-9", rf"2.68e-9 of hn_perlin\(place2, uint\) should be {position}"),
            (noise2d, f"HN_GRADIENT_SINE {of_sine}", "HN_GRADIENT_SINE 4.4e-9",
             f"should be {scientific(RAW['perlin', 2, SINE].cell_error, 2)}"),
            (noise3d, f"HN_GRADIENT_SINE {fixed}", "HN_GRADIENT_SINE 1.4e-9",
             f"should be {scientific(RAW['perlin', 3, SINE].fixed_error, 2)}"),
            (noise3d, "proven bound 0.99689", "proven bound 0.9968", r"0.9968 of .* should be 0.9969"),
            (noise2d, f"at most {cell}", "at most 1e-9", rf"1e-9 of hn_perlin\(place2, uint\) should be {scientific(PLANE.cell_error, 1)}"),
            (noise2d, f"at most {cell}", "at most 2^-30",
             rf"2\^-30 of hn_perlin\(place2, uint\) should be 2\^{math.ceil(math.log2(PLANE.cell_error))}"),
            (clouds, "twice hn_turbulence's", "twice hn_turbulence's, plus 2^-30",
             r"2\^-30 of hn_billow.* is derived nowhere"),
            (first, f"at most {scientific(LINE_D.cell_error)}", "at most 6.56e-9",
             rf"6.56e-9 of hn_perlin_d\(place1, uint\) should be {scientific(LINE_D.cell_error)}"),
            (first, "[-2.69, 2.69]", "[-2.69, 2.68]", r"2.68 of hn_perlin_d\(place1, uint\) should be 2.69"),
            (second, "[-2.91,", "[-2.9,", r"2.9 of hn_perlin_d\(place2, uint\) should be 3"),
            (fourth, f"HN_FIXED {scientific(SPACE_D.fixed_error)}", "HN_FIXED 3.17e-9",
             rf"3.17e-9 of hn_perlin_d\(place4, uint\) should be {scientific(SPACE_D.fixed_error)}"),
            (gradient, "(HN_FIXED: 3.7e-5", "(HN_FIXED: 3.6e-5", "should be 3.7e-5"),
            (clouds, "HN_FIXED 2.6e-5", "HN_FIXED 2.7e-5", "should be 2.6e-5"),
            (clouds, "  [0, 1]: 0 is clear", "  [0, 1.0001]: 0 is clear", "1.0001 of .* is derived nowhere"))
        while cases:  # a change of each text, and another in the next turn
            self.setUp()
            now = {case[:2]: case for case in reversed(cases)}
            cases = [case for case in cases if now[case[:2]] != case]
            for path, old, new, _ in now.values():
                self.change(path, old, new)
            found = self.differences()
            self.assertEqual(len(found), len(now), found)
            for path, _, new, message in now.values():
                with self.subTest(new=new):
                    self.assertRegex("\n".join(found), rf"(?m)^{path}:{self.line(path, new)}: .*{message}")

    def test_ranges_are_compared(self):
        for path, old, new, message in (
                ("catalog/noises.toml", "d = [[-2.69, 2.69], [-2.91, 2.91]", "d = [[-2.69, 2.69], [-2.92, 2.92]",
                 r"perlin_d: the range of d in 2D is \[-2.92, 2.92\]; derived are \[.*2.90564.*\]$"),
                ("catalog/noises.toml", "d = [[-2.69, 2.69]", "d_phase = [[-2.7, 2.7], [], [], []]\nd = [[-2.69, 2.69]",
                 r"perlin_d: the range of d_phase in 1D is \[-2.7, 2.7\]; nothing derives it$"),
                ("catalog/noises.toml", 'returns = "[-1, 1], mean 0, 0', 'returns = "[0.4, 0.5], proven, mean 0, 0',
                 r"perlin: returns has \[0.4, 0.5\], which is not its range$"),
                (self.comment_over("*2d.glsl", " hn_perlin(hn_"), "[-1, 1] (proven", "[0, 1] (proven",
                 r"\[0, 1\] is not the range of hn_perlin in catalog/$")):
            with self.subTest(new=new):
                self.setUp()
                self.change(path, old, new)
                self.assertRegex("\n".join(self.differences()), rf"(?m)^{path}:.*{message}")

    def test_each_comment_states_an_error(self):
        path = self.comment_over("*4d.glsl", " hn_perlin_d(hn_")
        self.change(path, f"at most {scientific(SPACE_D.error)}", "small")
        self.change(path, f"at most {scientific(SPACE_D.cell_error)}", "smaller")
        self.change(path, f"HN_FIXED {scientific(SPACE_D.fixed_error)}", "HN_FIXED more")
        found, = self.differences()
        self.assertRegex(found, rf"^{path}:\d+: the comment over hn_perlin_d\(place4, uint\) states no error")


class Phases(unittest.TestCase):
    """The forms of a noise with a phase have bounds of their own, and the forms of a cell share a comment with the
    rest."""

    def test_names(self):
        def named(*types, name="hn_perlin"):
            return documents.noise_of(glsl.Declaration(Path("x"), 1, name, types, None))
        self.assertEqual([named("place1", "uint"), named("float", "uint"), named("vec2", "uint")],
                         ["perlin"] * 3)
        for types in (("vec2", "float", "uint"), ("place3", "float", "uint")):
            self.assertEqual(named(*types, name="hn_simplex_d"), "simplex_d_phase")
        for types, noise in ((("place2", "float", "int", "uint"), "cellular"), (("vec3", "uint"), "cellular"),
                             (("place2", "float", "float", "uint"), "cellular_phase")):
            self.assertEqual(named(*types, name=f"hn_{noise}"), noise)
        self.assertEqual(documents.name_of(("perlin_phase", 2, OCTAHEDRAL)), "`hn_perlin(vec2)`, with a phase")
        self.assertEqual(documents.name_of(("cellular_phase", 3, None)), "`hn_cellular_phase(vec3)`")

    def test_numbers(self):
        """The larger error for both, and the range of a derivative; another number is wrong."""
        slope = ProvenBounds(0, 2.92167, 14.9, 2.42e-5, 2.506e-5, 2.9217, 3.594e-4, 2.92203)
        derived = {("perlin_d_phase", 2, OCTAHEDRAL): replace(RAW["perlin", 2, OCTAHEDRAL], slope=slope)}

        def wrong(error, largest):
            lines = (f"   returns  in [-{largest}, {largest}]", f"   error    at most {error}. HN_FIXED 3.60e-4")
            function = glsl.Declaration(Path("x"), 9, "hn_perlin_d", ("place2", "float", "uint"),
                                        glsl.Comment(7, lines))
            with mock.patch.object(noises, "names", return_value=["perlin_d_phase"]):
                return list(documents.wrong_numbers(function, derived).values())
        self.assertEqual(wrong("2.51e-5", "2.93"), [])
        self.assertRegex(wrong("2.42e-5", "2.93")[0], "2.42e-5 of .* should be 2.51e-5")
        self.assertRegex(wrong("2.51e-5", "12.9")[0], "12.9 of .* should be 2.93")


OFFSETS = ". HN_FIXED ".join(scientific(documents.offset_error("cellular", 2, fixed)) for fixed in (False, True))


class SeveralNumbers(unittest.TestCase):
    """A comment may state several ends of ranges, in their order, and the error of an offset."""

    def wrong(self, ends="first in [0, 1.1181], the second in [0, 1.5001]", offset=OFFSETS):
        of_noise = ProvenBounds(3.76, 3.76, 5.84, 3.179e-6, 3.529e-6, 3.76, 6.809e-5, 3.76)
        lines = (f"   returns  the {ends}", f"   error    at most 3.53e-6; of the offset at most {offset}",
                 "   cost     none")
        function = glsl.Declaration(Path("x"), 9, "hn_cellular", ("place2", "float", "int", "uint"),
                                    glsl.Comment(7, lines))
        return list(documents.wrong_numbers(function, {("cellular", 2, None): of_noise}).values())

    def test_they_are_right(self):
        self.assertEqual(self.wrong(), [])

    def test_each_is_compared(self):
        for ends, right in (("first in [0, 1.1182], the second in [0, 1.5001]", "1.1181"),
                            ("first in [0, 1.1181], the second in [0, 1.5]", "1.6"),
                            ("second in [0, 1.5001], the first in [0, 1.1181]", "1.1181")):
            self.assertRegex(self.wrong(ends=ends)[0], f"should be {right}")
        self.assertRegex(self.wrong(ends="[0, 1.1181], [0, 1.5001], [0, 1.6]")[0], "1.6 .* is derived nowhere")

    def test_the_error_of_an_offset(self):
        floats, fixed = OFFSETS.split(". HN_FIXED ")
        self.assertRegex(self.wrong(offset=f"3.53e-9. HN_FIXED {fixed}")[0], f"3.53e-9 of .* should be {floats}")
        self.assertRegex(self.wrong(offset=f"{floats}. HN_FIXED 6.81e-9")[0], f"6.81e-9 of .* should be {fixed}")


class Command(unittest.TestCase):
    def check(self, problem: Exception) -> tuple[int, str]:
        """The status of --check and its message, if the comparison ends so."""
        shown = io.StringIO()
        with mock.patch.object(command, "derive", return_value=RAW), contextlib.redirect_stderr(shown), \
                mock.patch.object(command, "without_proof", return_value=[]), \
                mock.patch.object(command.identity, "wrong_texts", list), \
                mock.patch.object(command, "differences", side_effect=problem):
            return command.main(["--check"]), shown.getvalue()

    def test_a_broken_table_or_page_is_a_message(self):
        self.assertEqual(self.check(LookupError("accuracy.md has no marks")), (2, "accuracy.md has no marks\n"))

    def test_a_mistake_of_the_program_is_not(self):
        with self.assertRaises(KeyError):
            self.check(KeyError("x"))


class New(unittest.TestCase):
    """Entries of the catalog that somebody adds, and their claims."""

    def test_without_a_proof_each_is_refused_by_its_name(self):
        of_all = catalog.model.read()
        new = replace(of_all, metrics=(*of_all.metrics, "minkowski"), sums=[
            replace(sum_, name="billow_d") for sum_ in of_all.sums if sum_.name == "fbm_d"])
        with mock.patch.object(command.catalog.model, "read", return_value=new):
            self.assertEqual(command.without_proof(), [
                "catalog/sums.toml: billow_d: nothing derives its range: add it to SUMS in tools/lib/proof/oracle/sums.py",
                "tools/lib/proof/bounds/features.py has no proof of the metric minkowski"])

    def test_without_an_error_each_is_refused_by_its_name(self):
        rest = {key: entry for key, entry in record.read().items() if key.name not in ("hybrid", "perlin_d")}
        with mock.patch.object(record, "read", return_value=rest):
            self.assertEqual(command.without_proof(), [
                f"record.csv has no error of hybrid, {arithmetic}: run tools/make errors" for arithmetic in ("fixed", "floats")])
            with self.assertRaisesRegex(LookupError, "record.csv has no row of perlin_d, 2D, octahedral, derivative, from a cell, floats"):
                command.derived_of(("perlin_d", 2, OCTAHEDRAL))

    def test_wrong_claims_on_sums(self):
        has_to_be = f"the error {{}} has to be one of {claims.FORMS}"
        for name, changes, *messages in (
                ("ridged", {"range": (0.4, 0.5)}, "range is (0.4, 0.5), and (0.0, 1.0) is derived", "returns has [0, 1], which is not its range",
                 "brief has [0, 1], which is not its range", "use has [0, 1], which is not its range"),
                *(("turbulence", {"error": error}, has_to_be.format(error))
                  for error in ("at most 1e-9", "2^-30", "hardly any", "`ridges`'s"))):
            with self.subTest(name, **changes):
                self.assertEqual(list(claims.wrong_sum(replace(sums.CATALOG[name], **changes))),
                                 [f"{name}: {message}" for message in messages])


class Entries(unittest.TestCase):
    def test_perlin_is_found_and_others_are_not(self):
        self.assertIn("perlin", noises.names())
        message = "no bounds of merlin, which is no noise of the catalog"
        with self.assertRaisesRegex(LookupError, message):
            noises.find("merlin")

    def test_a_noise_without_a_row(self):
        with self.assertRaisesRegex(LookupError, "bounds.inc has no bounds of merlin in 2D"):
            table.bounds_of("merlin", 2, "octahedral")

    def test_the_table_is_read_as_it_is_written(self):
        def of_these(rows):
            return [bounds for bounds in rows if bounds.noise in NAMES]

        rounded = [of_noise.bounds(*key).rounded() for key, of_noise in RAW.items()]
        self.assertEqual(of_these(table.read()), rounded)
        slopes = [of_noise.slope.bounds(*key).rounded() for key, of_noise in RAW.items() if of_noise.slope]
        self.assertEqual(of_these(table.read(macro="SLOPE_BOUNDS")), slopes)
        self.assertEqual(table.slope_bounds_of("perlin_d", 2), slopes[1])
