"""The catalog is right, its products are committed, and a wrong entry is reported with its place."""

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
from catalog import command, copies, parameters, sections, shaders, suite
from catalog.model import CATALOG, CatalogError, read


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
                self.assertRegex(output, rf"{re.escape(path.name)}:\d+: it is not what the catalog makes; run tools/make "
                                         r"catalog, or if it was edited by hand change catalog/")

    def test_the_lines_that_it_replaces_are_printed(self):
        path = command.ROOT / "glsl/hashnoise/fbm2d.glsl"
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(command, "ROOT", Path(folder)):
            edited = Path(folder) / "glsl/hashnoise/fbm2d.glsl"
            edited.parent.mkdir(parents=True)
            text = path.read_text(encoding="utf-8")
            edited.write_text(text.replace("Use it for marble and fire.", "Use it for fire."), encoding="utf-8")
            line = text[:text.index("Use it for marble")].count("\n") + 1
            output = io.StringIO()
            with mock.patch.object(command, "files", return_value={edited: text}):
                status, said = self.check()
                with contextlib.redirect_stdout(output):
                    self.assertEqual(command.main([]), 0)
            self.assertEqual((status, edited.read_text(encoding="utf-8")), (1, text))
        place = f"glsl/hashnoise/fbm2d.glsl:{line}"
        self.assertEqual(said, f"{place}: it is not what the catalog makes; run tools/make catalog, or if it was edited by "
                               "hand change catalog/sums.toml: tools/make catalog replaces it\n")
        self.assertEqual(output.getvalue(), f"{place}: replaced by what the catalog makes\n")

    def test_what_repeats_the_version_has_the_next_one(self):
        """Whatever the lines are now, they are right in another version and at another address. Without one the files are
        as they were."""
        with mock.patch.object(copies, "version", return_value="2.13.4"), \
                mock.patch.object(copies, "released", return_value="2.12.0"), \
                mock.patch.object(copies, "address", return_value="https://example.org/another"):
            wrong = copies.wrong()
            made = {path.relative_to(ROOT).as_posix(): text for path, text in command.files().items()}
            for file, lines in copies.LINES.items():
                for line in lines:
                    self.assertIn(copies.filled(line), made[file])
                    self.assertTrue([one for one in wrong if one.startswith(f"{file}: ") and one.endswith(
                        f" must be {copies.shown(copies.filled(line))}; tools/make catalog writes it")], line)
        self.assertIn("#define HN_I_NAMESPACE v2_13\n#define HN_I_LIBRARY v2\n", made["include/hashnoise/glsl.hpp"])
        self.assertIn("GIT_TAG v2.12.0", made["docs/guide/build-systems.md"])
        self.assertIn('homepage = "https://example.org/another"\n', made["packages/conan/conanfile.py"])
        self.assertEqual(copies.wrong(), [])
        for file in copies.LINES:
            self.assertEqual(copies.made(file, made[file]), (ROOT / file).read_text(encoding="utf-8"))
        self.assertEqual(site("https://github.com/Some-One/noise"), "https://some-one.github.io/noise")

    def test_a_line_that_is_missing_is_told(self):
        with self.assertRaisesRegex(LookupError, "CITATION.cff must have version: "):
            copies.made("CITATION.cff", "title: hashnoise\n")

    def test_files_of_the_suite_are_written_once(self):
        with tempfile.TemporaryDirectory() as name:
            suite.write(Path(name))
            paths = [path for path in Path(name).rglob("*") if path.is_file()]
            self.assertEqual({path.relative_to(name).as_posix() for path in paths}, suite.files().keys())
            with mock.patch.object(Path, "write_text", side_effect=AssertionError):
                suite.write(Path(name))

    def test_a_step_that_the_library_does_not_have(self):
        for step in ("cubes", "detail"):
            message = (rf"^catalog/sums\.toml: fbm: step is '{step}', and has to be one of billow, .*hybrid, .*weighted, "
                       r"or a new hn_i_add_.* in glsl/hashnoise/detail/octave\.glsl$")
            with self.assertRaisesRegex(CatalogError, message):
                shaders.check_steps([dataclasses.replace(read().sums[0], step=step)])

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
