"""The npm package: its files have their sources' text. packages/npm/tests runs it in Node.js and in browsers."""

import json
import re
import unittest
from pathlib import Path
from unittest import mock

from base.thorough import in_thorough_runs
from base.tree import GLSL, ROOT, glsl_files, version
from ship.npm import twin
from ship.npm.files import ARITHMETICS, glsl_modules, package
from ship.packing_support import lost_links
from translate.settings import Settings
from translate.single_file.files import flatten, in_order, minified, parts
from translate.wgsl.module import Module

EXPORT = re.compile(r"^export default (.*);$", re.MULTILINE)
IMPORT = re.compile(r'^import (\w+) from "(.*)";$', re.MULTILINE)
GUARD = re.compile(r"#(ifndef|define) HN_\w+_GLSL|#endif")
DESCRIBED = (ROOT / "packages" / "npm" / "package.json").read_text(encoding="utf-8")


def string_of(name: str, files: dict[str, str]) -> str:
    """The exports of a module of strings."""
    code = files[f"glsl/{name}.js"]
    paths = dict(IMPORT.findall(code))
    return "".join(json.loads(EXPORT.search(files[f"glsl/{paths[part][2:]}"])[1])
                   for part in EXPORT.search(code)[1].split(" + "))


# Types that no node takes or gives.
STRUCTS = r"ptr<|-> ?hn_(?:derivatives[\dx]+|hexes)|hn_(?:octaves|slopes|shifts)\d"


class Strings(unittest.TestCase):
    files = glsl_modules()

    def test_they_are_single_files(self):
        """But for the guards: in a single file they stand around the text that a file includes, and here behind it."""
        for path in GLSL.glob("*.glsl"):
            with self.subTest(path.name):
                lines = list(minified(flatten(path.name, set())))
                found = string_of(path.stem, self.files).splitlines()
                self.assertEqual(*([line for line in text if not GUARD.fullmatch(line)] for text in (found, lines)))
                self.assertEqual(sorted(found), sorted(lines))

    def test_plain_files_are_those_of_the_library(self):
        for name, path in glsl_files().items():
            self.assertEqual(self.files[f"glsl/{name}"], path.read_text())

    def test_what_is_needed_stands_first(self):
        self.assertEqual(in_order("detail/cubic_spline.glsl", parts())[-1], "detail/cubic_spline.glsl")
        self.assertEqual(in_order("perlin2d.glsl", parts())[0], "config.glsl")

    def test_types_and_chunks_are_of_all(self):
        for path in GLSL.glob("*.glsl"):
            self.assertIn(f"glsl/{path.stem}.d.ts", self.files)
            self.assertIn(f'export {{ default as {path.stem} }} from "./{path.stem}.js";', self.files["glsl/all.js"])


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files = package(b"\0asm")

    def test_its_version_is_that_of_the_library(self):
        self.assertNotIn('"version"', DESCRIBED)
        self.assertEqual(json.loads(self.files["package.json"])["version"], version())
        self.assertRegex(version(), r"^\d+\.\d+\.\d+$")
        page = ROOT / "docs" / "guide" / "javascript.md"
        self.assertIn(f"hashnoise-{version()}.tgz", page.read_text(encoding="utf-8"))

    def test_what_it_exports_is_there(self):
        for name, target in json.loads(self.files["package.json"])["exports"].items():
            for path in target.values() if isinstance(target, dict) else [target]:
                found = path.removeprefix("./").replace("*", "fbm2d")
                with self.subTest(name=name, path=path):
                    self.assertIn(found, [*self.files, "package.json"])

    def test_it_is_small(self):
        """The vectors of porters are four times as much."""
        self.assertLess(sum(map(len, self.files.values())), 3_500_000)

    def test_it_knows_the_same_names_of_other_libraries_as_the_header(self):
        header = (ROOT / "include" / "hashnoise" / "detail" / "closest.hpp").read_text(encoding="utf-8")
        known = re.search(r"NOISES_ELSEWHERE = \{(.*?)\}", self.files["index.js"], re.DOTALL)[1]
        self.assertEqual(dict(re.findall(r'(\w+): "(\w+)"', known)), dict(re.findall(r'\{"(\w+)", "(\w+)"\}', header)))

    def test_its_page_is_one_for_a_registry(self):
        page = self.files["README.md"]
        self.assertIn("\n    npm install hashnoise\n", page.partition("| purpose |")[0])
        self.assertEqual(lost_links({"README.md": page}, self.files), [])

    def test_its_wgsl_is_the_modules(self):
        for folder, arithmetic in ARITHMETICS.items():
            module = Module(GLSL, '#include "hashnoise.glsl"\n', Settings(arithmetic))
            code = self.files[f"wgsl/{folder}.js"]
            texts = [json.loads(text) for text in re.findall(r'definition\(("(?:[^"\\]|\\.)*")', code)]
            expected = ["".join(f"{line}\n" for line in minified(item.lines)) for item in module.definitions()]
            self.assertEqual(texts, expected)
            for item in module.definitions():
                needs = re.search(rf"const {item.name} = .*?\"(.*?)\);$", code.replace('\\"', ""), re.MULTILINE)
                self.assertTrue(needs[1].endswith("".join(f", {need}" for need in item.needs)))

    def test_every_function_that_sets_nothing_has_a_node(self):
        for folder in ARITHMETICS:
            public = re.findall(r"export const (\w+) = .*?definition\(\"(.*?)\"[,)]", self.files[f"wgsl/{folder}.js"])
            functions = {name for name, code in public
                         if code.startswith("fn ") and not re.search(STRUCTS, code.split("{")[0])}
            nodes = set(re.findall(r"export const (\w+) =", self.files[f"tsl/{folder}.js"]))
            self.assertEqual(nodes, functions)
            self.assertGreater(len(nodes), 200)
            self.assertEqual(set(re.findall(r"function (\w+)\(", self.files[f"tsl/{folder}.d.ts"])), functions)


class Twin(unittest.TestCase):
    @in_thorough_runs
    def test_it_is_the_same_every_time(self):
        try:
            first = twin.compiled()
        except twin.Failed as reason:
            self.skipTest(str(reason).partition("\n")[0])
        self.assertEqual(first, twin.compiled())
        self.assertLess(len(first), twin.MOST_BYTES)

    def test_nothing_of_others_is_linked(self):
        """Else the package would have to have its license, and tools/lib/ship/release/sbom.py to name it."""
        with mock.patch.object(twin, "_program", side_effect=lambda *names: names[0]), \
                mock.patch.object(twin.subprocess, "run", return_value=mock.Mock(stdout="version 14", returncode=0)) as ran, \
                self.assertRaises(FileNotFoundError):
            twin.compiled()
        linker, *words = ran.call_args.args[0]
        self.assertEqual(linker, "wasm-ld-14")
        self.assertEqual([Path(word).name for word in words if word not in twin.LINKED], ["twin.o", "-o", "twin.wasm"])
        self.assertFalse([word for word in twin.LINKED if word.startswith("-l") or not word.startswith("-")])

    def test_what_is_wrong_is_told(self):
        with self.assertRaises(twin.Failed):
            twin.compiled(source=ROOT / "absent.cpp")
