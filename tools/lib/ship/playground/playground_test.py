"""The playground's page: its modules in one script, and the functions inside of it."""

import base64
import contextlib
import hashlib
import io
import json
import re
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path
from unittest import mock

import ship.playground.command as command
import ship.playground.page as page
from base.thorough import THOROUGH, in_thorough_runs
from base.tree import TOOLS, version
from ship.playground import linked, picks
from translate.pick.command import Choice, picked


def unpacked(text: str) -> bytes:
    return zlib.decompress(base64.b64decode(text))


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pieces = "YQ=="  # the test playground.page makes a page of all texts
        cls.text = cls.made(cls)

    def made(self) -> str:
        with mock.patch.object(picks, "kept_text", lambda _: self.pieces):
            return page.page()

    def test_it_is_one_file_that_is_the_same_each_time(self):
        self.assertEqual(self.made(), self.text)
        self.assertNotRegex(self.text, r"\{\{(?:style|looks|script|hash|version|pieces)\}\}")
        self.assertNotRegex(self.text, r'(?i)(?:src|href)="(?!data:)')
        self.assertNotRegex(self.text, r"\bimport\(|@import|url\((?!data:)")

    def test_only_its_own_script_may_run(self):
        """Scripts are those of a type that browsers run."""
        code = re.findall(r'(?s)<script(?: type="module")?>(.*?)</script>', self.text)
        self.assertEqual(len(code), 1)
        allowed = "sha256-" + base64.b64encode(hashlib.sha256(code[0].encode()).digest()).decode()
        self.assertIn(f"default-src 'none'; script-src '{allowed}';", self.text)
        self.assertNotIn(page.hash_of(code[0] + " "), self.text)

    def test_the_functions_are_in_it(self):
        self.assertIn(f'<span id="version">{version()}</span>', self.text)
        self.assertIn(f'id="pieces">{self.pieces}<', self.text)


class Linked(unittest.TestCase):
    def test_tools_bake_is_called_with_the_words_of_the_link(self):
        """Later words count. A file of floats has no range, and neither has one with a range of its own."""
        with mock.patch.object(linked, "text", lambda *_: json.dumps({"source": ["a", "b"], "commands": [
                {"words": ["fbm", "--source", "pattern.py"], "range": "-1:2"}, {"words": []}]})):
            for options, added in {("-o", "a.exr"): [], ("-o", "a.png"): ["--range=-1:2"], ("--out=a.f32",): [],
                                   ("-o", "a.png", "--range", "0:1"): [], ("-o", "a.png", "--normalize"): [],
                                   ("-o", "a", "--format", "r16"): ["--range=-1:2"]}.items():
                words, source = linked.words_of_bake("#", options)
                self.assertEqual(words, ["fbm", "--source", "pattern.py", *added, *options])
                self.assertEqual(source, "a\nb")

    def test_a_size_takes_the_place_of_that_of_the_link(self):
        for options, shown in {("--size", "30x20"): "seed=1&width=30&height=20", ("--size=8x8x8",): "seed=1&width=9",
                               ("--size", "4x4", "--size=5x6"): "seed=1&width=5&height=6", (): "seed=1&width=9"}.items():
            with mock.patch.object(linked, "text", mock.Mock(side_effect=linked.Unfit)) as text:
                with self.assertRaises(linked.Unfit):
                    linked.words_of_bake("page.html#seed=1&width=9", options)
            self.assertEqual(text.call_args[0][0].partition("#")[2], shown)

    def test_a_link_that_cannot_be_baked_is_refused(self):
        for link in ("#noise=cellular", "#hash=pcg", "#sum=none&noise=cells", "#seed=many"):
            done = subprocess.run([TOOLS / "bake", link, "-o", "a.exr"], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""), link)
            self.assertRegex(done.stderr, "^(tools/bake has|The link has)", link)


class Picks(unittest.TestCase):
    SETTING = picks.Setting(picks.SHADING, "fixed", "lattice", 1)

    def test_pieces_are_what_tools_pick_writes(self):
        setting = self.SETTING._replace(is_small=True)
        _, pieces = picks.pieces_of(setting)
        for language in ("glsl", "wgsl", "metal"):
            made = picked(picks.small_roots(1), Choice(language, "fixed"))
            for piece in pieces[setting.key(language)]:
                self.assertIn(piece.text, made, language)
        _, pieces = picks.pieces_of(picks.Setting(("c", "rust"), "fixed", "lattice", 1, is_small=True))
        made = picked(picks.small_roots(1), Choice("rust", "fixed"))
        for piece in pieces["rust fixed lattice 1"]:
            self.assertIn(piece.text, made)

    def test_other_hashes_are_as_if_picked_as_a_whole(self):
        """With the longest one, and in a thorough run in every dimension."""
        small = [picks.pieces_of(setting) for setting in picks.settings() if setting.hash in ("jenkins", "murmur")]
        for n in picks.DIMENSIONS if THOROUGH else (1,):
            base = self.SETTING._replace(dimensions=n, hash=picks.base_of_hashes(n))
            found = picks.every_module([picks.pieces_of(base), *small])
            _, whole = picks.pieces_of(base._replace(hash="jenkins"))
            for key, pieces in whole.items():
                self.assertEqual(found[key], pieces)
                self.assertNotEqual(found[key.replace("jenkins", base.hash)], pieces)

    @in_thorough_runs
    def test_hashes_have_the_same_pieces_in_small_programs(self):
        """Whatever the dimension and the arithmetic. By default the test above sees it, with one hash."""
        def own(arithmetic: str, n: int) -> list[list[list[picks.Piece]]]:
            settings = [one._replace(arithmetic=arithmetic, dimensions=n) for one in picks.settings() if one.is_small]
            return [picks.own_pieces(programs) for programs in zip(*(picks.pieces_of(one)[1].values() for one in settings))]

        expected = own("fast", 2)
        for n in picks.DIMENSIONS:
            for arithmetic in ("fixed", "fast"):
                self.assertEqual(own(arithmetic, n), expected, (arithmetic, n))

    def test_hashes_that_differ_elsewhere_are_refused(self):
        one, other, step = picks.Piece("one", "1"), picks.Piece("one", "2"), picks.Piece("step", "3")
        word, second = picks.Piece("word", "4"), picks.Piece("word", "5")
        self.assertEqual(picks.own_pieces([[one, word], [one, step, second]]), [[word], [step, second]])
        self.assertEqual(picks.with_hash([one, word, other], [step, second]), [one, step, second, other])
        for small in ([[one, word], [other, second]], [[one, step], [one, word]]):
            with self.assertRaisesRegex(ValueError, "differ in more than one function"):
                picks.own_pieces(small)
        with self.assertRaises(ValueError):
            picks.with_hash([one], [word])

    def test_each_piece_is_there_once(self):
        one, other = picks.Piece("one", "1"), picks.Piece("other", "2")
        made = picks.data({"glsl fast lattice 2": [other, one], "glsl fixed lattice 2": [one]})
        self.assertEqual(made["pieces"], "~one\n1\n~other\n2")
        self.assertEqual(made["modules"], {"glsl fast lattice 2": [1, -1], "glsl fixed lattice 2": [0]})

    def test_lines_that_repeat_are_there_once(self):
        a, b = "a" * picks.LEAST_REPEATED, "b"
        self.assertEqual(picks.without_repeats([a, b, a, b, b, a, b, a]), [a, b, "~2 2", "~3 3", "~2 1"])
        with self.assertRaisesRegex(ValueError, "begins with ~ and a number: ~1"):
            picks.without_repeats(["~1"])

    def test_a_text_is_compressed(self):
        self.assertEqual(unpacked(picks.compressed("abc" * 999)), b"abc" * 999)


class Script(unittest.TestCase):
    """A module that one script cannot contain is an error that names the file."""

    def refused(self, files: dict[str, str], message: str):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                (Path(folder) / name).write_text(text)
            with mock.patch.object(page, "SOURCES", Path(folder)), self.assertRaisesRegex(page.Unfit, message):
                page.script()

    def test_an_import_comes_before_what_needs_it(self):
        names = list(page.modules())
        self.assertEqual(names[-1], "main.js")
        self.assertLess(names.index("model.js"), names.index("code.js"))
        self.assertNotRegex(page.script(), r"(?m)^(?:import|export) ")

    def test_other_imports_and_exports(self):
        self.refused({"main.js": 'import all from "./other.js";\n'}, "main.js has a line .* import all")
        self.refused({"main.js": 'import { a as b } from "./a.js";\n', "a.js": "export default 1;\n"},
                     "a.js has a line .* export default")

    def test_names_that_two_modules_have(self):
        self.refused({"main.js": 'import { a } from "./a.js";\nconst b = a;\n', "a.js": "export const a = 1;\nclass b {}\n"},
                     "b is defined in playground/a.js and in playground/main.js")

    def test_the_end_of_a_script(self):
        self.refused({"main.js": 'const text = "</script>";\n'}, "main.js has </script in it")


class Command(unittest.TestCase):
    def test_it_tells_what_it_does_and_last_the_path(self):
        def made(tell):
            tell("A long step ...")
            self.assertEqual(err.getvalue(), "A long step ...\n")  # before the step is over
            return "the page"

        with tempfile.TemporaryDirectory() as folder, mock.patch.object(command, "page", made), \
                mock.patch.object(sys, "argv", ["playground", "--out", f"{folder}/a/page.html"]), \
                contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()) as err:
            self.assertEqual(command.main(), 0)
            path = Path(folder).resolve() / "a" / "page.html"
            self.assertEqual((out.getvalue(), path.read_text()), (f"{path}\n", "the page"))

    def test_the_picture_is_of_a_page_with_the_new_looks(self):
        """They are drawn first, and if that fails the page has no picture."""
        for statuses in ([0, 0], [77]):
            drawn: list[tuple[str, str]] = []

            def draw(html, file):
                drawn.append((file.name, html.read_text()))
                return statuses[len(drawn) - 1]

            with tempfile.TemporaryDirectory() as folder, mock.patch.object(command, "page", lambda _: f"looks {len(drawn)}"), \
                    mock.patch.object(sys, "argv", ["playground", "--out", f"{folder}/page.html", "--picture"]), \
                    mock.patch.object(command, "draw", draw), contextlib.redirect_stdout(io.StringIO()):
                self.assertEqual(command.main(), statuses[-1])
            self.assertEqual(drawn, [("looks.webp", "looks 0"), ("playground.png", "looks 1")][:len(statuses)])

    def test_bad_usage_is_status_2(self):
        for arguments in (["--out"], ["more"], ["--out", "/dev/null/page.html"], ["--picks"]):
            done = subprocess.run([sys.executable, TOOLS / "playground", *arguments], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
