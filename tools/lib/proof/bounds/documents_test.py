"""Tests of documents.py, table.py and command.py: what quotes a bound follows the derivation, and another number is an
error with its place. The derivation itself is not run: RAW is its result for a noise and of the one with its
derivatives, and others are left out."""

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
from proof.bounds import text as text_proofs
from proof.bounds.gradients import OCTAHEDRAL, SINE
from proof.bounds.noises import ProvenBounds
from proof.bounds.prover import Proven
from proof.bounds.table import rounded_up, scientific, shortest

RAW = {("perlin", dims, gradient): ProvenBounds(*numbers, {"cut": 4.35e-6}) for dims, gradient, numbers in (
    (1, OCTAHEDRAL, (1, 0.998047325, 2.68904068, 1.458e-06, 1.61830372e-06, 0.998048943, 3.70550766e-05, 0.99808)),
    (2, OCTAHEDRAL, (1, 0.909129023, 3.76671991, 2.43583288e-06, 2.66034689e-06, 0.909131683, 4.29217982e-05, 0.9092)),
    (3, OCTAHEDRAL, (1, 0.996888828, 5.19026883, 4.13874209e-06, 4.44810622e-06, 0.996893276, 5.39168815e-05, 0.997)),
    (4, OCTAHEDRAL, (1, 0.999033831, 6.43035966, 6.89510628e-06, 7.278386e-06, 0.999041109, 6.92584549e-05, 0.9991)),
    (2, SINE, (1.0, 1.0, 3.75000221, 4.35355953e-06, 4.57707708e-06, 1.00000458, 7.98294426e-05, 1.00000809)),
    (3, SINE, (1.5, 1.5, 6.93756014, 7.69718103e-06, 8.11069184e-06, 1.50000811, 0.000139159166, 1.5000119)))}
RAW |= {("perlin_d", dims, OCTAHEDRAL): replace(RAW["perlin", dims, OCTAHEDRAL], slope=ProvenBounds(*numbers, {"cut": 2e-5}))
        for dims, numbers in (
    (1, (0, 2.68904067, 14.9707175, 6.56868161e-06, 7.4610059e-06, 2.68904814, 0.000171702229, 2.6891981)),
    (2, (0, 2.90564073, 14.8241721, 1.23307053e-05, 1.32142948e-05, 2.90565395, 0.00020028267, 2.90582688)),
    (3, (0, 3.60720851, 17.2759678, 1.8719057e-05, 1.97487849e-05, 3.60722826, 0.000227519079, 3.60741956)),
    (4, (0, 3.61689537, 21.9417659, 3.14717456e-05, 3.27795768e-05, 3.61692815, 0.000317362357, 3.61719181)))}
RAW["perlin_d", 3, OCTAHEDRAL] = replace(RAW["perlin_d", 3, OCTAHEDRAL], fixed_intermediate=0.94901 * 2**31)

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
        self.assertEqual(table.row_of("NOISE_BOUNDS", RAW["perlin", 3, SINE].bounds("perlin", 3, SINE)),
                         'NOISE_BOUNDS("perlin", 3, sine, 7.70e-6, 8.12e-6, 6.94, 1.50001, 1.40e-4, 1.50002)\n')
        # Within the contract's promise, the limit is that.
        self.assertEqual(table.row_of("NOISE_BOUNDS", RAW["perlin", 2, OCTAHEDRAL].bounds("perlin", 2, None)),
                         'NOISE_BOUNDS("perlin", 2, none, 2.44e-6, 2.67e-6, 3.77, 1.0, 4.30e-5, 1.0)\n')
        # A derivative has no promise.
        slope = RAW["perlin_d", 2, OCTAHEDRAL].slope.bounds("perlin_d", 2, OCTAHEDRAL)
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
        self.change(table.PATH.relative_to(ROOT), "2.01e-4", "2.00e-4")
        self.change("docs/measured/accuracy.md", "2.44e-6", "2.45e-6")
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
        for path, old, new in (("docs/reference/knobs.md", "2.67e-6 | 4.45e-6", "2.67e-6 | 4.46e-6"),
                               ("docs/measured/accuracy.md", "0.95 * 2^31", "0.94 * 2^31"),
                               ("docs/measured/accuracy.md", "-6.56e-5 to 2.40e-5,", "-6.56e-5 to 2.39e-5,"),
                               ("docs/measured/accuracy.md", "adds 2.53e-5", "adds 2.52e-5")):
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
        cases = (
            (noise2d, "at most 2.44e-6", "at most 2.43e-6",
             r"2.43e-6 of hn_perlin\(place2, uint\) should be 2.44e-6"),
            (noise2d, "at most 2.67e-6", "at most 2.68e-6", r"2.68e-6 of hn_perlin\(place2, uint\) should be 2.67e-6"),
            (noise2d, "HN_GRADIENT_SINE 4.36e-6", "HN_GRADIENT_SINE 4.4e-5", r"should be 4.4e-6"),
            (noise3d, "HN_GRADIENT_SINE 1.40e-4", "HN_GRADIENT_SINE 1.4e-5", r"should be 1.4e-4"),
            (noise3d, "proven bound 0.99689", "proven bound 0.9968", r"0.9968 of .* should be 0.9969"),
            (noise2d, "at most 2.44e-6", "at most 1e-9", r"1e-9 of hn_perlin\(place2, uint\) should be 3e-6"),
            (noise2d, "at most 2.44e-6", "at most 2^-30", r"2\^-30 of hn_perlin\(place2, uint\) should be 2\^-18"),
            (noise2d, "at most 2.44e-6", "at most 0.01", r"0.01 of hn_perlin\(place2, uint\) should be 3e-6"),
            (clouds, "twice hn_turbulence's", "twice hn_turbulence's, plus 2^-30",
             r"2\^-30 of hn_billow.* is derived nowhere"),
            (first, "at most 6.57e-6", "at most 6.56e-6",
             r"6.56e-6 of hn_perlin_d\(place1, uint\) should be 6.57e-6"),
            (first, "[-2.69, 2.69]", "[-2.69, 2.68]", r"2.68 of hn_perlin_d\(place1, uint\) should be 2.69"),
            (second, "[-2.91,", "[-2.9,", r"2.9 of hn_perlin_d\(place2, uint\) should be 3"),
            (fourth, "HN_FIXED 3.18e-4", "HN_FIXED 3.17e-4", r"3.17e-4 of hn_perlin_d\(place4, uint\) should be 3.18e-4"),
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
        self.change(path, "at most 3.28e-5", "small")
        self.change(path, "at most 3.15e-5", "smaller")
        self.change(path, "HN_FIXED 3.18e-4", "HN_FIXED more")
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
        slope = ProvenBounds(0, 2.92167, 14.9, 2.42e-5, 2.506e-5, 2.9217, 3.594e-4, 2.92203, {})
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


class SeveralNumbers(unittest.TestCase):
    """A comment may state several ends of ranges, in their order, and the error of an offset."""

    def wrong(self, ends="first in [0, 1.1181], the second in [0, 1.5001]", offset="3.88e-7. HN_FIXED 2.39e-6"):
        of_noise = ProvenBounds(3.76, 3.76, 5.84, 3.179e-6, 3.529e-6, 3.76, 6.809e-5, 3.76, {})
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
        self.assertRegex(self.wrong(offset="3.53e-6. HN_FIXED 2.39e-6")[0], "3.53e-6 of .* should be 3.88e-7")
        self.assertRegex(self.wrong(offset="3.88e-7. HN_FIXED 6.81e-5")[0], "6.81e-5 of .* should be 2.39e-6")


class Command(unittest.TestCase):
    def check(self, problem: Exception) -> tuple[int, str]:
        """The status of --check and its message, if the comparison ends so."""
        shown = io.StringIO()
        with mock.patch.object(command, "derive", return_value=RAW), contextlib.redirect_stderr(shown), \
                mock.patch.object(command, "without_proof", return_value=[]), \
                mock.patch.object(text_proofs, "prove", return_value=[]), \
                mock.patch.multiple(command.identity, wrong_texts=list, wrong_forms=lambda *_: []), \
                mock.patch.object(command.gullies, "wrong_errors", list), \
                mock.patch.object(command, "differences", side_effect=problem):
            return command.main(["--check"]), shown.getvalue()

    def test_a_broken_table_or_page_is_a_message(self):
        self.assertEqual(self.check(LookupError("accuracy.md has no marks")), (2, "accuracy.md has no marks\n"))

    def test_a_mistake_of_the_program_is_not(self):
        with self.assertRaises(KeyError):
            self.check(KeyError("x"))


class FromText(unittest.TestCase):
    """Proven errors beside published ones."""
    LINE = text_proofs.Line("perlin perlin_d", (2,))

    def found(self, value, slope):
        return [(case, Proven(slope if case.kind == text_proofs.SLOPE else value, 0.0, 5, 0.0, "" if value < 1 else "a root", []))
                for case in text_proofs.cases([self.LINE])]

    def test_a_larger_error_is_found(self):
        self.assertEqual(text_proofs.wrong(self.found(2.435e-6, 1.23e-5), RAW), [])
        errs = "noise2d.perlin{}_cell: the {} errs by {} at most{}, and its text proves {} (in 5 boxes)"
        self.assertEqual(text_proofs.wrong(self.found(2.437e-6, 1.23e-5), RAW), [
            errs.format(name, "value", *of) for name in ("", "_d") for of in (
                ("2.436e-06", " from a cell", "2.437e-06"), ("2.66e-06", " from a position", "2.662e-06"))])
        self.assertEqual(len(text_proofs.wrong(self.found(2.435e-6, 1.234e-5), RAW)), 2)
        self.assertIn("proves inf: a root", text_proofs.wrong(self.found(math.inf, 1.23e-5), RAW)[0])

    def test_a_noise_without_formulas(self):
        key, found = ("perlin", 2, OCTAHEDRAL), self.found(2.4e-6, 0.0)
        without = noises.derived(1.0, 0.909, 3.7667, None, {"cut": 4e-6, "scaling": 3.89e-5})
        with mock.patch.object(text_proofs, "PROVEN", [self.LINE]):
            of_row = text_proofs.completed(key, without, found)
            self.assertEqual(of_row.bounds(*key).rounded(), table.bounds_of("perlin", 2, "octahedral"))
            with mock.patch.object(text_proofs, "published", return_value=None):
                self.assertEqual(text_proofs.completed(key, without, found).cell_error, 2.4e-6)
        with self.assertRaisesRegex(LookupError, "perlin in 2D has no formulas of its error, and is not in PROVEN"):
            with mock.patch.object(text_proofs, "PROVEN", []):
                text_proofs.completed(key, without, found)

    def test_a_noise_without_a_module(self):
        """All of its bounds are from its text; a range beyond the catalog's, and a bound that is not proven, are named."""
        every = noises.proofs()
        proof = noises.of_text("value", noises.without_module({*every} - {"value"})["value"])
        key, sizes = ("value", 2, None), {"error": 3e-6, "most": 1.0, "least": 0.9, "slope": 7.5}
        with mock.patch.object(noises, "proofs", return_value=every | {"value": proof}), \
                mock.patch.object(text_proofs, "published", return_value=None):
            lines = [line for line in text_proofs.lines() if line.noises == "value"]
            for most, wrong in ((1.0, []), (1.01, ["catalog/noises.toml: value is up to 1.01 in 2D, by its text"])):
                found = [(case, Proven((sizes | {"most": most})[case.job.measure], 0.0, 5, 0.0, ""))
                         for case in text_proofs.cases(lines)]
                of = text_proofs.completed(key, proof.derive(2, None), found)
                self.assertEqual((of.range, of.lipschitz, of.cell_error, of.fixed_error), (most, 7.5, 3e-6, 3e-6))
                self.assertEqual(text_proofs.wrong([], {key: of}), wrong)
            self.assertEqual(text_proofs.unseen(found), [])
            case = next(case for case, _ in found if case.line.fixed)
            self.assertRegex(text_proofs.unseen([(case, Proven(math.inf, 0.0, 5, 0.0, "a root"))])[0],
                             "its text proves no error with HN_FIXED: a root")


class New(unittest.TestCase):
    """Entries of the catalog that somebody adds, and their claims."""

    def test_without_a_proof_each_is_refused_by_its_name(self):
        of_all = catalog.model.read()
        new = replace(of_all, metrics=(*of_all.metrics, "minkowski"), sums=[
            replace(sum_, name="billow_d") for sum_ in of_all.sums if sum_.name == "fbm_d"])
        with mock.patch.object(command.catalog.model, "read", return_value=new):
            self.assertEqual(command.without_proof(), [
                "tools/lib/proof/bounds has no proof of the sum billow_d",
                "tools/lib/proof/bounds/features.py has no proof of the metric minkowski"])

    def test_wrong_claims_on_sums(self):
        has_to_be = f"the error {{}} has to be one of {claims.FORMS}"
        not_proven = "the error {} is not proven: proven are {} times that, with HN_FIXED {} times"
        for name, changes, *messages in (
                ("ridged", {"range": (0.4, 0.5)}, "range is (0.4, 0.5), and (0.0, 1.0) is derived", "returns has [0, 1], which is not its range",
                 "brief has [0, 1], which is not its range", "use has [0, 1], which is not its range"),
                *(("turbulence", {"error": error}, has_to_be.format(error))
                  for error in ("at most 1e-9", "2^-30", "hardly any", "`ridges`'s")),
                ("turbulence", {"error": "twice `fbm`'s"}, not_proven.format("twice `fbm`'s", 1, 1)),
                ("billow", {"error": "3 times `turbulence`'s"}, not_proven.format("3 times `turbulence`'s", 2, 2))):
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
