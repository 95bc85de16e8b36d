"""The catalog is right, its products are committed, and a wrong entry is reported with its place."""

import ast
import contextlib
import dataclasses
import io
import re
import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.tree import ROOT, site
from catalog import command, copies, grid, parameters, sections, shaders, suite
from catalog.model import CATALOG, CatalogError, read
from catalog.tables import functions


class Made(unittest.TestCase):
    def check(self):
        output = io.StringIO()
        with contextlib.redirect_stderr(output):
            status = command.main(["--check"])
        return status, output.getvalue()

    def test_what_is_made_of_it_is_committed(self):
        self.assertEqual(self.check(), (0, ""))

    def test_a_file_that_is_changed_by_hand_is_noticed(self):
        made = command.files()
        for path in made:
            with self.subTest(path=path.name):
                changed = {**made, path: made[path] + "\n"}
                with mock.patch.object(command, "files", return_value=changed):
                    status, output = self.check()
                self.assertEqual(status, 1)
                self.assertRegex(output, rf"{re.escape(path.name)}: it is not what the catalog makes; "
                                         r"run tools/make catalog$")

    def test_what_repeats_the_version_has_the_next_one(self):
        """Whatever the lines are now, they are right in another version and at another address."""
        with mock.patch.object(copies, "version", return_value="2.13.4"), \
                mock.patch.object(copies, "released", return_value="2.12.0"), \
                mock.patch.object(copies, "address", return_value="https://example.org/another"):
            wrong = copies.wrong()
            made = {path.relative_to(ROOT).as_posix(): text for path, text in command.files().items()}
            for file, lines in copies.LINES.items():
                for line in lines:
                    self.assertIn(copies.filled(line), made[file])
                    self.assertTrue([one for one in wrong if one.startswith(f"{file}: ") and one.endswith(
                        f" must be {copies.filled(line).strip()}; tools/make catalog writes it")], line)
        self.assertIn("#define HN_I_NAMESPACE v2_13\n#define HN_I_LIBRARY v2\n", made["include/hashnoise/glsl.hpp"])
        self.assertIn("GIT_TAG v2.12.0", made["docs/guide/build-systems.md"])
        self.assertEqual(copies.wrong(), [])
        self.assertEqual(site("https://github.com/Some-One/noise"), "https://some-one.github.io/noise")

    def test_a_line_that_is_missing_is_told(self):
        with self.assertRaisesRegex(LookupError, "CITATION.cff must have version: "):
            copies.made("CITATION.cff", "title: hashnoise\n")

    def test_every_part_knows_of_every_entry(self):
        made = {path.name: text for path, text in command.files().items()}
        catalog = read()
        for function in (*catalog.noises, *catalog.sums):
            with self.subTest(function=function.name):
                self.assertIn(f", {function.name}, {function.first}, {function.last}, ", made["catalog.inc"])
                if "__init__.pyi" in made:  # the package can be deleted
                    module = made["_sums.py" if function in catalog.sums else "_noises.py"]
                    self.assertRegex(made["__init__.pyi"], rf"(?m)^def {function.name}\(")
                    self.assertRegex(module, rf"(?m)^{function.name} = _")
                self.assertIn(f'.call = "hn_{function.name}(p', suite.files()["library/functions.inc"])
                self.assertIn(f"HN_ONLY_TYPES_OF_GLSL(hn_{function.name})\n", made["functions_of_glsl.h"])
                if getattr(function, "step", "") not in ("", "eroded"):
                    self.assertRegex(made["fbm2d.glsl"], rf"(?m)^HN_FN hn_float hn_i_{function.name}\(hn_octaves2 o")

    def test_rows_of_the_suite(self):
        warp = next(sum_ for sum_ in read().sums if sum_.name == "warp")
        body = ("hn_vec2 p = vec2(float_of(a.x), float_of(a.y)); hn_vec2 n = hn_warp(p, int(a.z), float_of(a.w), float_of(b.x), "
                "float_of(b.y), SEED(b.z)); return uvec4(bits_of(n.x), bits_of(n.y), 0u, 0u);")
        row = next(functions.of_sum(warp))
        self.assertEqual((row.id, row.includes, row.columns, row.bench, row.body), (
            "warp.warp2", "warp2d.glsl",
            "x:f32 y:f32 octaves:i32 lacunarity:f32 gain:f32 amplitude:f32 seed:u32 = sx:f64 sy:f64",
            "hn_warp(p, 6, 2.0, 0.5, 1.0, 0u)", body))
        typed = suite.of_functions(read(), [row])
        self.assertIn('.family = extended_octave_sum, .bound = "warp"', typed)
        self.assertIn('.inputs = {{"x", f32}, {"y", f32}, {"octaves", i32}, {"lacunarity", f32}', typed)
        self.assertIn(f'COLUMN("seed", u32)), {body})\n', suite.of_bodies([row]))

    def test_ids_of_what_a_derivative_belongs_to(self):
        of = {row.id: row.plain for row in functions.read_functions()}
        for id_, plain in (("noise2d.perlin_d_cell", "noise2d.perlin_cell"), ("noise4d.value_d_value", "noise4d.value"),
                           ("noise4d.perlin_d_cell_value", "noise4d.perlin_cell"), ("fbm_d.eroded2_cell", "fbm.fbm2_cell"),
                           ("noise2d.perlin_d_phase", "noise2d.perlin_phase"), ("noise2d.perlin", ""), ("fbm.fbm2", "")):
            self.assertEqual(of[id_], plain)

    def test_files_of_the_suite_are_written_once(self):
        with tempfile.TemporaryDirectory() as name:
            suite.write(Path(name))
            paths = [path for path in Path(name).rglob("*") if path.is_file()]
            self.assertEqual({path.relative_to(name).as_posix() for path in paths}, suite.files().keys())
            with mock.patch.object(Path, "write_text", side_effect=AssertionError):
                suite.write(Path(name))

    def test_the_glsl_of_a_sum(self):
        ping_pong = next(sum_ for sum_ in read().sums if sum_.name == "ping_pong")
        self.assertEqual(shaders.loop(ping_pong), """\
HN_FN hn_float hn_i_ping_pong(hn_octaves2 o, hn_float strength) {
  do hn_add_ping_pong(o, hn_perlin(o.place, o.seed), strength);
  while (hn_next(o));
  return hn_i_value(hn_i_bounded(hn_i_mean(o.sum)));
}
""")
        self.assertLessEqual(max(map(len, (shaders.comment(ping_pong) + shaders.forms(ping_pong)).splitlines())), 120)

    def test_a_step_that_the_library_does_not_have(self):
        for step in ("cubes", "detail"):
            message = (rf"^catalog/sums\.toml: fbm: step is '{step}', and has to be one of billow, .*hybrid, .*weighted, "
                       r"or a new hn_i_add_.* in glsl/hashnoise/detail/octave\.glsl$")
            with self.assertRaisesRegex(CatalogError, message):
                shaders.check_steps([dataclasses.replace(read().sums[0], step=step)])

    def test_made_code_is_code(self):
        for path, text in command.files().items():
            if path.suffix in (".py", ".pyi"):
                with self.subTest(path=path.name):
                    ast.parse(text)
                    self.assertLessEqual(max(map(len, text.splitlines())), 120)

    def test_entries_in_the_order_of_the_file(self):
        text = grid.files(read())[grid.PATH]
        named = re.findall(r"^HN_CATALOG_NOISE\(\w+, (\w+),", text, re.MULTILINE)
        self.assertEqual(named, re.findall(r"^\[(\w+)\]$", (CATALOG / "noises.toml").read_text(), re.MULTILINE))

    def test_a_page_without_its_marks(self):
        with self.assertRaisesRegex(LookupError, r"README\.md has 0 lines with 'tools/make catalog: nothing'"):
            sections.with_section("README.md", "nothing", "")


class Wrong(unittest.TestCase):
    """Each entry is changed in a copy of the catalog."""

    def refused(self, file, old, new):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name, "catalog")
            shutil.copytree(CATALOG, folder)
            text = (folder / file).read_text(encoding="utf-8")
            self.assertEqual(len(re.findall(old, text, re.MULTILINE)), 1, old)
            (folder / file).write_text(re.sub(old, new, text, flags=re.MULTILINE), encoding="utf-8")
            with self.assertRaises(CatalogError) as caught:
                read(folder)
            return str(caught.exception)

    def test_messages(self):
        perlin, fbm = r"(?<=^\[perlin\]\n)", r"(?<=^\[fbm\]\n)"
        for file, old, new, message in (
                ("noises.toml", rf"{perlin}dimensions = .*\n", "", "catalog/noises.toml: perlin has no dimensions"),
                ("noises.toml", rf"{perlin}dimensions = .*\n", "dimensions = [1, 5]\n",
                 "perlin: dimensions are [1, 5], and have to be in [1, 4]"),
                ("noises.toml", rf"{perlin}dimensions", "new = 1\ndimensions", "perlin has a key 'new', which means nothing"),
                ("noises.toml", rf"{perlin}(dimensions = .*\n)", r'\1shape = "round"\n',
                 "perlin: shape is 'round', and has to be one of value, slopes, "),
                ("noises.toml", r"(?<=^\[perlin\.options\]\n)phase", "phrase", "perlin: a noise has no option phrase"),
                ("noises.toml", r'^plain = "perlin"\n', "", "perlin_d: what has derivatives has a plain, and nothing else"),
                ("noises.toml", r'^plain = "perlin"$', 'plain = "merlin"', "perlin_d: plain is 'merlin', which is no noise"),
                ("noises.toml", r"(?<=^\[curl\.ranges\]\n)axis = .*", "axis = [[-1, 1]]",
                 "curl: the ranges of axis have to be one for each dimension"),
                ("noises.toml", rf"{perlin}dimensions = ", "dimensions = ] ", "catalog/noises.toml: Invalid value"),
                ("noises.toml", rf"{perlin}((?:.*\n)+?)families = .*\n", r"\1", "perlin has no families"),
                ("noises.toml", rf"{perlin}((?:.*\n)+?)families = \{{ usual", r"\1families = { unusual",
                 "perlin.families has no usual"),
                ("noises.toml", r'(?<=^\[phasor\]\n)((?:.*\n)+?)rows = .*', r'\1rows = "by machine"',
                 "phasor: rows is 'by machine', and has to be one of by hand"),
                ("noises.toml", r'(?<=^\[phasor\]\n)((?:.*\n)+?)rows = ', r'\1families = { usual = "curl" }\nrows = ',
                 "phasor: rows that stand by hand name their families themselves"),
                ("sums.toml", r'(?<=^\[perlin_worley\]\n)', 'noise = "perlin"\n',
                 "perlin_worley has a key 'noise', which means nothing"),
                ("sums.toml", r'(?<=^\[perlin_worley\]\n)', 'step = "noise"\n',
                 "perlin_worley: a sum that is a value has a step, and no other has one"),
                ("sums.toml", r'(?<=^\[ridged\]\n)((?:.*\n)+?)step = .*\n', r"\1",
                 "ridged: a sum that is a value has a step, and no other has one"),
                ("sums.toml", r'(?<=^\[ridged\]\n)((?:.*\n)+?)mean = .*', r'\1mean = "median"',
                 "ridged: mean is 'median', and has to be one of "),
                ("sums.toml", rf"{fbm}dimensions", "range = 7\ndimensions", "Cannot overwrite a value"),
                ("sums.toml", r'(?<=^\[warp\]\n)((?:.*\n)+?)range = .*', r'\1range = "strength"',
                 "warp: range is 'strength', and has to be two numbers or noise or amplitude"),
                ("sums.toml", r'(?<=^\[warp\]\n)((?:.*\n)+?)noise = "value_vector"', r'\1noise = "cellular"',
                 "warp: it sums noises of the shape vector, and cellular is none"),
                ("sums.toml", r"(?<=^\[ping_pong\.strength\]\n)((?:.*\n)+?)default = 2", r"\1default = 65",
                 "ping_pong.strength: the default is not in [0, 64]"),
                ("settings.toml", r"(?<=^\[gain\]\n)", 'kind = "odd"\n',
                 "catalog/settings.toml: gain: kind is 'odd', and has to be one of whole"),
                ("settings.toml", r"(?<=^\[gain\]\n)((?:.*\n)*?)fixed = .*", r"\1fixed = [1]",
                 "catalog/settings.toml: gain: fixed has to be two numbers, and is [1]"),
                ("settings.toml", r"^\[metrics\].*\nnames = .*", "", "catalog/settings.toml: metrics has to be a table")):
            with self.subTest(message=message):
                self.assertIn(message, self.refused(file, old, new))

    def test_a_parameter_has_a_text_ends_and_a_default(self):
        for function, parameter, is_fixed, numbers in (
                ("hn_fbm2", "gain", False, (0, None, 0.5)), ("hn_fbm2", "gain", True, (0, 1, 0.5)),
                ("hn_fbm2", "lacunarity", False, (None, None, 2)), ("hn_fbm2", "lacunarity", True, (0, 255, 2)),
                ("hn_warp3", "amplitude", True, (0, 64, 1)), ("hn_eroded3_place", "strength", True, (0, 16, 1)),
                ("hn_weighted2", "strength", True, (0, 1, 1)), ("hn_ping_pong2", "strength", True, (0, 64, 2)),
                ("hn_cellular2_jitter", "metric", True, (1, 5, 1)), ("hn_fbm2", "seed", True, (None, None, 0))):
            with self.subTest((function, parameter), is_fixed=is_fixed):
                found = parameters.about(function, parameter, is_fixed)
                self.assertEqual(found[1:], numbers)
                self.assertRegex(found.what, r"^\w[^`\"]{8,89}$")
        self.assertIsNone(parameters.about("hn_perlin2", "amplitude", True))

    def test_it_is_bad_usage(self):
        errors = io.StringIO()
        with mock.patch.object(command, "read", side_effect=CatalogError("catalog/noises.toml: perlin has no shape")), \
                contextlib.redirect_stderr(errors), self.assertRaises(SystemExit) as stop:
            command.main(["--check"])
        self.assertEqual((stop.exception.code, errors.getvalue()),
                         (2, "tools/make catalog: catalog/noises.toml: perlin has no shape\n"))
