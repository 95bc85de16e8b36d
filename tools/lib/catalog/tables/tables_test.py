"""Tests of functions.py, configurations.py and glsl.py: they read the catalog, and refuse unknown entries."""

from __future__ import annotations

import re
import shutil
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path

from base.testing import Case
from catalog.model import CATALOG, CatalogError
from catalog.tables import glsl
from catalog.tables.configurations import read_configurations
from catalog.tables.functions import read_functions


class Tables(unittest.TestCase):
    """tools.check.complete compares the overloads of all rows with the library, and golden files have their columns."""

    def refused(self, read: Callable, file: str, old: str, new: str, message: str) -> None:
        """The messages for a copy of the catalog with one file changed."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name, "catalog")
            shutil.copytree(CATALOG, folder)
            text = (folder / file).read_text(encoding="utf-8")
            self.assertEqual(text.count(old), 1, old)
            (folder / file).write_text(text.replace(old, new), encoding="utf-8")
            with self.assertRaisesRegex(CatalogError, rf"catalog(?:/{file})?: .*{message}"):
                read(folder)

    def test_wrong_rows(self) -> None:
        for old, new, message in (
                ('word = { takes = ["key"] }', 'word = { takes = ["kay"] }', "hash.word: nothing is known of kay, which it"),
                ('word = { takes = ["key"] }', 'word = { gives = ["key"] }', "hash.word has no takes"),
                ('word = { takes = ["key"] }', 'word = { takes = ["key"], new = 1 }', "hash.word has a key 'new', which"),
                ('word = { takes = ["key"] }', 'word = { takes = ["key"], type = "f16" }', "type is 'f16', and has to be one of"),
                ('word = { takes = ["key"] }', 'word = { takes = ["key"], family = "hush" }', "family is 'hush', and has to be"),
                ('word = { takes = ["key"] }', 'vec2 = { takes = ["key"] }', "hash.vec2: it is there already"),
                ("gullies = { takes", 'gullies = { sets = "both", takes', "sets is 'both', and has to be one of nearest, offset"),
                ("[perlin_worley]\nid = \"noise{n}d.{name}\"\ndimensions = [3]", "[perlin_worley]\nid = \"noise{n}d.{name}\"\ndimensions = [2]",
                 "rows of perlin_worley have .2. dimensions, and its entry has 3"),
                ('gives = ["value", "quadrature"]', 'gives = ["a", "b", "c", "d", "e"]', "it has more words than the 16")):
            self.refused(read_functions, "functions.toml", old, new, message)

    def test_configurations(self) -> None:
        configurations = {configuration.name: configuration for configuration in read_configurations()}
        fixed = configurations["lattice+sine+fixed"]
        self.assertEqual((fixed.hash, fixed.gradient, fixed.fixed), ("lattice", "sine", True))
        self.assertFalse(configurations["lattice+precise"].has_golden_values)
        self.assertIn("independent", configurations["lattice"].families)
        functions = {function.id: function for function in read_functions()}
        self.assertEqual([configurations["pcg"].covers(functions[id]) for id in
                          ("noise2d.perlin", "noise2d.simplex", "noise2d.simplex_cell")], [True, True, False])
        self.assertFalse(configurations["fnv1"].covers(functions["noise2d.simplex"]))

    def test_wrong_configurations(self) -> None:
        for old, new, message in (
                ('gradient = "sine"\narithmetics = ["fast"]', 'gradient = "cosine"\narithmetics = ["fast"]',
                 "fast_sine: gradient is 'cosine', and has to be one of octahedral, sine"),
                ('"lattice_noise"]\nall_but = ["sine', '"noise"]\nall_but = ["sine', "fast: families has 'noise', which is none of"),
                ("[further.pcg]", "[further.md5]", "further has md5, which is no configuration")):
            self.refused(read_configurations, "configurations.toml", old, new, message)


class Library(Case):
    def test_a_comment_may_stand_above_a_directive(self) -> None:
        """The rest of what is read the tests of complete and of the interface compare with the library."""
        comment, = {one.comment for one in glsl.declarations() if one.name == "hn_hash"}
        self.assertIn("The selected hash as published", comment.lines[1])

    def test_a_second_look_finds_what_is_written_in_another_way(self) -> None:
        (self.folder / "a.glsl").write_text("""
HN_FN hn_float hn_one(hn_vec2 p) { return hn_two(p) + hn_three(p); }
hn_float hn_two(hn_vec2 p) {
  if (hn_one(p) > 0.0f) { return 0.0f; }
  return 1.0f;
}
  HN_FN hn_float hn_three(hn_vec2 p) { return 0.0f; }
// hn_float hn_four(hn_vec2 p) {
#define MACRO(p) \\
  hn_five(p) {}
HN_FN hn_float hn_six(hn_vec2 p);
HN_FN hn_float hn_i_seven(hn_vec2 p) { return 0.0f; }
HN_FN HN_I_HIGHP float hn_eight(hn_vec2 p) {
}
""")
        self.assertEqual([str(f) for f in glsl.declarations(self.folder)], ["hn_one(vec2)"])
        self.assertEqual([text.replace(f"{self.folder}/", "") for text in glsl.overlooked(self.folder)],
                         ["a.glsl:3: hn_two", "a.glsl:7: hn_three", "a.glsl:13: hn_eight"])

    def test_no_mark_of_a_generator_is_in_a_comment_that_users_see(self) -> None:
        (self.folder / "a.glsl").write_text("""
// tools/make catalog: forms
// A noise.
HN_FN hn_float hn_one(hn_vec2 p) { return 0.0f; }
""")

        def marked(library: Path) -> list[str]:
            return [function.name for function in glsl.declarations(library)
                    if function.comment and any(re.match(r" tools/make \w+: ", line) for line in function.comment.lines)]

        self.assertEqual(marked(self.folder), ["hn_one"])
        self.assertEqual(marked(glsl.LIBRARY), [])
