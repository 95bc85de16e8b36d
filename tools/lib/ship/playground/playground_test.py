"""The playground's page: its modules in one script, and the library inside of it."""

import base64
import contextlib
import gzip
import hashlib
import io
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import ship.playground.command as command
import ship.playground.page as page
from base.tree import TOOLS, version
from ship.playground import picks
from ship.playground.library import definitions, library, modules, of_pictures, written
from translate.pick.command import Choice


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.printed = []
        cls.modules = dict(modules(cls.printed.append))  # which takes seconds
        with mock.patch("ship.playground.library.modules", lambda _: cls.modules.items()):
            cls.library = library(cls.printed.append)
        cls.picks = picks.woven({"tools/pick hn_a": "a\n"})  # the test playground.page makes a page of all texts
        cls.text = cls.made(cls)

    def made(self) -> str:
        with mock.patch.object(page, "library", lambda _: self.library), \
                mock.patch.object(picks, "data", lambda _: self.picks):
            return page.page()

    def test_it_is_one_file_that_is_the_same_each_time(self):
        self.assertEqual(self.made(), self.text)
        self.assertNotIn("{{", self.text)
        self.assertNotRegex(self.text, r'(?i)(?:src|href)="(?!data:)')
        self.assertNotRegex(self.text, r"\bimport\(|@import|url\((?!data:)")

    def test_only_its_own_script_may_run(self):
        """Of the scripts, those of a type that browsers run."""
        code = re.findall(r'(?s)<script(?: type="module")?>(.*?)</script>', self.text)
        self.assertEqual(len(code), 1)
        allowed = "sha256-" + base64.b64encode(hashlib.sha256(code[0].encode()).digest()).decode()
        self.assertIn(f"default-src 'none'; script-src '{allowed}';", self.text)
        self.assertNotIn(page.hash_of(code[0] + " "), self.text)

    def test_each_long_step_is_told(self):
        steps = "HN_FAST, 1 of 2", "HN_FIXED, 2 of 2"
        self.assertEqual(self.printed, [f"Translating the library to WGSL with {step} ..." for step in steps])

    def test_the_library_is_in_it(self):
        packed = re.search(r'id="library">([^<]*)<', self.text)[1]
        self.assertEqual(json.loads(gzip.decompress(base64.b64decode(packed))), self.library)
        self.assertEqual(self.library["version"], version())
        self.assertIn("#define HN_HASH_LATTICE 8", self.library["glsl"]["config.glsl"])
        self.assertEqual(len(self.library["wgsl"]["settings"]), 16)
        packed = re.search(r'id="picks">([^<]*)<', self.text)[1]
        self.assertEqual(json.loads(gzip.decompress(base64.b64decode(packed))), self.picks)

    def test_the_settings_of_wgsl_are_those_of_the_whole_library(self):
        def entries(found):
            return sorted(map(written, found.values()), key=lambda entry: entry["name"])

        whole = entries(definitions(of_pictures(), "HN_FIXED", "JENKINS"))
        self.assertEqual(entries(self.modules["fixed jenkins"]), whole)
        self.assertNotEqual(entries(self.modules["fixed lattice"]), whole)

    def test_what_a_definition_needs_is_there(self):
        entries = self.library["wgsl"]["definitions"]
        for setting, numbers in self.library["wgsl"]["settings"].items():
            names = {entries[number]["name"] for number in numbers}
            self.assertEqual(len(names), len(numbers))
            for number in numbers:
                self.assertLessEqual(set(entries[number]["needs"]), names, setting)


class Picks(unittest.TestCase):
    @staticmethod
    def unwoven(data: dict) -> dict[str, str]:
        return {command: "".join(f"{line}\n" for place, count in zip(spans[::2], spans[1::2])
                                 for line in data["lines"][place:place + count])
                for command, spans in data["texts"].items()}

    def test_they_are_made_once(self):
        steps = []
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(picks, "FOLDER", Path(folder) / "picks"), \
                mock.patch.object(picks, "calls", lambda: [["hn_random3"]]), \
                mock.patch.object(picks, "CHOICES", [Choice("wgsl", "fixed"), Choice()]):
            data = picks.data(steps.append)
            self.assertEqual(picks.data(steps.append), data)
        self.assertEqual(steps, ["Picking what 1 pictures call, in 2 texts each, which takes a minute at first ..."])
        written = self.unwoven(data)
        self.assertEqual([*written], ["tools/pick hn_random3 --language wgsl --arithmetic fixed", "tools/pick hn_random3"])
        done = subprocess.run([TOOLS / "pick", "hn_random3"], capture_output=True, text=True, check=True)
        self.assertEqual(written["tools/pick hn_random3"], done.stdout.replace("tools/pick hn_random3", picks.COMMAND))

    def test_lines_that_are_alike_are_there_once(self):
        named = {"a": "1\n2\n3\n", "b": "0\n2\n3\n1\n2\n", "c": "2\n3\n0\n2\n", "d": ""}
        data = picks.woven(named)
        self.assertEqual(data["lines"], ["1", "2", "3", "0"])
        self.assertEqual(data["texts"], {"a": [0, 3], "b": [3, 1, 1, 2, 0, 2], "c": [1, 3, 1, 1], "d": []})
        self.assertEqual(self.unwoven(data), named)


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

    def test_the_picture_is_that_of_the_page_and_its_status_counts(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(command, "page", lambda _: "the page"), \
                mock.patch.object(command, "draw", return_value=77) as draw, \
                mock.patch.object(sys, "argv", ["playground", "--out", f"{folder}/page.html", "--picture"]), \
                contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(command.main(), 77)
            draw.assert_called_once_with(Path(folder) / "page.html")

    def test_bad_usage_is_status_2(self):
        for arguments in (["--out"], ["more"], ["--out", "/dev/null/page.html"], ["--picks"]):
            done = subprocess.run([sys.executable, TOOLS / "playground", *arguments], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)


if __name__ == "__main__":
    unittest.main()
