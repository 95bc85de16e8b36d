"""tools/pack rust: the content of the crate, as far as no cargo is needed to check it."""

from __future__ import annotations

import re
import unittest
from unittest import mock

from base.thorough import some
from base.tree import GOLDEN
from catalog.tables.functions import read_functions
from ship import packing
from ship.packing import Refused
from ship.rust import files
from translate.pick.scalars import bare

FUNCTIONS = {function.id: function for function in read_functions()}


class Calls(unittest.TestCase):
    def test_a_place_is_made_of_what_the_row_has(self) -> None:
        cell = "f::Place2::in_cell([w[0] as i32, w[1] as i32], [f32::from_bits(w[2]), f32::from_bits(w[3])])"
        for id, name, expected in (
                ("noise2d.perlin", "hn_perlin2", "f::perlin2(f32::from_bits(w[0]), f32::from_bits(w[1]), w[2])"),
                ("noise2d.perlin_cell", "hn_perlin2_place", f"f::perlin2_place({cell}, w[4])"),
                ("noise2d.perlin_cell_period", "hn_perlin2_place",
                 f"f::perlin2_place({cell}.tile([w[4] as i32, w[5] as i32]), w[6])"),
                ("noise2d.perlin_period", "hn_perlin2_place",
                 "f::perlin2_place(f::Place2::of([f32::from_bits(w[0]), f32::from_bits(w[1])])"
                 ".tile([w[2] as i32, w[3] as i32]), w[4])"),
                ("position.perlin2", "hn_perlin2_place",
                 "f::perlin2_place(f::Place2::of_units([w[0] as i32, w[1] as i32], w[2] as i32, w[3] as i32), w[4])"),
                ("noise2d.cellular_offset", "hn_cellular2_nearest", "f::cellular2_nearest(f32::from_bits(w[0]), "
                 "f32::from_bits(w[1]), f32::from_bits(w[2]), w[3] as i32, w[4]).2")):
            with self.subTest(id):
                self.assertEqual(files.call(FUNCTIONS[id], name, "f"), f"{expected}.numbers()")

    def test_every_function_of_the_crate_is_called(self) -> None:
        table, needed = files.calls((*files.MODULES, "hash"))
        known = files.library("fixed").forms
        # The vectors have only those places at which there is noise.
        all_names = {bare(name) for functions in (*files.MODULES.values(), files.HASHES)
                     if functions != files.MODULES["place"] for name in files.of_module(known, *functions)}
        called = set(re.findall(r"(?:fast|fixed|hash)::(\w+)\(", table))
        self.assertEqual(called, all_names)
        self.assertTrue(all((GOLDEN / f"{id}.golden").is_file() for id in needed))
        self.assertGreater(len(all_names), 100)


class Places(unittest.TestCase):
    def test_a_place_has_the_same_traits_in_each_arithmetic_and_nothing_of_callers_but_methods(self) -> None:
        found = [files.written(files.Made(arithmetic, "place")) for arithmetic in files.ARITHMETICS]
        for shown in found:
            self.assertEqual(re.findall(r"(?m)^#\[derive\((.*)\)\]", shown), ["Clone, Copy, Debug, Default, PartialEq"] * 4)
            self.assertEqual(len(re.findall(r"(?m)^    pub\(crate\) tiled: bool,", shown)), 4)
            self.assertNotRegex(shown, r"(?m)^    pub \w+:|^pub fn")


class Comments(unittest.TestCase):
    def test_they_have_the_crates_names_and_one_arithmetic(self) -> None:
        for arithmetic, error in some((("fast", "at most 2.08e-6 against the exact value, in any metric and rounding mode. "
                                   "From a cell at most 2.08e-6; of the offset at most 2.98e-7."),
                                  ("fixed", "at most 6.81e-5 against the exact value, in any metric; of the offset at "
                                   "most 2.38e-6.")), 1):
            shown = files.written(files.Made(arithmetic, "cellular"))
            self.assertEqual(shown.count("pub fn"), shown.count("#[inline]\n#[must_use]\npub fn"))
            self.assertEqual(len(re.findall("(?m)^fn", shown)), shown.count("#[inline]\nfn"))
            comments = re.sub(r"\s*/// *", " ", "".join(re.findall(r"(?m)^///.*\n", shown)))
            with self.subTest(arithmetic):
                self.assertIn(f"Error: {error}", comments)
                self.assertEqual("(in steps of 2^-18)" in comments, arithmetic == "fixed")
                self.assertIn("; then nearest, the cell of the nearest point, modulo the period: lattice2(nearest, seed) is",
                              comments)
                self.assertNotRegex(comments, r"HN_|hn_|tools/pick|- nearest|set to|[iu]vec")


class Modules(unittest.TestCase):
    def test_they_are_chosen(self) -> None:
        self.assertEqual(files.chosen("hash, place,hash"), ["hash", "place"])
        for only, said in (("place,hash,perlim", r"there is no module perlim \(did you mean perlin\?\)"),
                           ("perlin,hash", "the others need the module place")):
            with self.assertRaisesRegex(Refused, said):
                files.chosen(only)
        with mock.patch.object(files, "package", return_value={}) as package:
            packing.files_of("rust", only="hash,place")
        package.assert_called_with(only="hash,place")
