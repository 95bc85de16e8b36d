"""tools/pack wesl: the content of the package. wesl.linked_test links it."""

from __future__ import annotations

import json
import re
import unittest

from base.tree import version
from ship.wesl import files
from translate.names import RESERVED, is_public


class Names(unittest.TestCase):
    def test_they_are_those_of_a_module(self) -> None:
        for code, expected in (("fn hn_perlin2(p: vec2f) -> f32 {", "fn perlin2(p: vec2f) -> f32 {"),
                               ("hn_tile2_place(hn_place_of2(p))", "tile2_place(place_of2(p))"),
                               ("var o: hn_octaves2;", "var o: Octaves2;"), ("hn_unorm(h)", "unorm_(h)"),
                               ("HN_METRIC_EUCLIDEAN + HN_I_ONE", "METRIC_EUCLIDEAN + HN_I_ONE"),
                               ("hn_i_scramble(k)", "hn_i_scramble(k)")):
            self.assertEqual(files.renamed(code), expected)

    def test_each_is_one_word_that_is_free(self) -> None:
        for arithmetic in files.MODULES.values():
            old = [item.name for item in files.definitions(arithmetic) if is_public(item.name)]
            new = [files.renamed(name) for name in old]
            self.assertEqual(len(set(new)), len(new))
            self.assertFalse(RESERVED & set(new))

    def test_no_variable_hides_a_function_that_is_called(self) -> None:
        for arithmetic in files.MODULES.values():
            for item in files.definitions(arithmetic):
                code = "\n".join(item.lines)
                declared = set(re.findall(r"\b(?:let|var) (\w+)|\b(\w+): ", code))
                declared = {name for pair in declared for name in pair if name}
                with self.subTest(item.name):
                    self.assertFalse(declared & {files.renamed(name) for name in item.needs})

    def test_those_with_a_line_behind_them_are_those_that_the_page_names(self) -> None:
        new = {files.renamed(item.name) for item in files.definitions("HN_FAST")}
        page = (files.PACKAGE / "README.md").read_text(encoding="utf-8")
        self.assertEqual({name for name in new if name.endswith("_")}, set(re.findall(r"`(\w+_)`", page)) - {"hn_"})


class Package(unittest.TestCase):
    made = files.package()

    def test_npm_and_cargo_have_the_same_text(self) -> None:
        content = json.loads(self.made["weslBundle.js"].partition("weslBundle = ")[2].partition(";\nexport")[0])
        self.assertEqual(content["name"], files.NAME)
        for module, name in (("lib.wesl", "package"), ("fixed.wesl", "fixed")):
            of_cargo = self.made[f"shaders/{name}.wesl"]
            self.assertEqual(content["modules"][module], re.sub(r"(?m)^public ", "", of_cargo))
            self.assertGreater(of_cargo.count("\npublic fn "), 350)
            self.assertNotIn("public fn hn_i_", of_cargo)

    def test_its_version_is_that_of_the_library(self) -> None:
        self.assertEqual(json.loads(self.made["package.json"])["version"], version())
        self.assertIn(f'version = "{version()}"', self.made["Cargo.toml"])
        self.assertIn(f'name = "{files.NAME}"', self.made["Cargo.toml"])
        self.assertIn(f'crate_name: "{files.NAME}"', self.made["src/lib.rs"])
