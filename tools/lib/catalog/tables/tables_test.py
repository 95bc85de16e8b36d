"""Tests of functions.py, configurations.py and glsl.py: they read the catalog, and refuse unknown entries."""

from __future__ import annotations

import re
import shutil
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path

from catalog.model import CATALOG, CatalogError
from catalog.tables import glsl
from catalog.tables.configurations import families, read_configurations
from catalog.tables.functions import read_functions


class Tables(unittest.TestCase):
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

    def test_functions(self) -> None:
        functions = {function.id: function for function in read_functions()}
        self.assertEqual({function.family for function in functions.values()} - set(families()), set())
        for id, form, axes, family in (("hash.word", "words", 1, "hash"), ("hash.vec4", "words", 4, "hash"),
                                       ("hash.unorm", "words", 1, "independent"), ("hash.lattice1", "point", 1, "hash"),
                                       ("gradient.sine3", "point", 3, "sine_gradient"),
                                       ("noise2d.perlin", "position", 2, "gradient_noise"),
                                       ("noise3d.perlin_cell", "cell", 3, "gradient_noise"),
                                       ("noise4d.perlin_d_cell_period", "cell", 4, "octahedral_noise"),
                                       ("noise1d.perlin_period", "position", 1, "octahedral_noise"),
                                       ("hash.pcg3d", "words", 3, "independent"),
                                       ("numbers.rehash", "items", 1, "independent"),
                                       ("numbers.shuffle", "items", 1, "independent"),
                                       ("position.cell3", "place", 3, "independent"),
                                       ("position.perlin2", "place_of_noise", 2, "extended_gradient_noise"),
                                       ("noise3d.cellular_cell_full", "cell", 3, "extended_cellular"),
                                       ("noise2d.cell_border_nearest", "position", 2, "extended_cellular"),
                                       ("noise2d.phasor", "position", 2, "simplex_noise"),
                                       ("noise2d.phasor_cell_period", "cell", 2, "simplex_noise"),
                                       ("noise3d.phasor_cell", "cell", 3, "simplex_noise"),
                                       ("fbm.fbm2_period", "sum", 2, "extended_octave_sum"),
                                       ("fbm.ping_pong3_cell_period", "sum", 3, "extended_octave_sum"),
                                       ("fbm.weighted2_cell", "sum", 2, "extended_octave_sum"),
                                       ("fbm.fbm3_detail", "sum", 3, "extended_octave_sum"),
                                       ("fbm.fbm2_footprint", "sum", 2, "extended_octave_sum"),
                                       ("fbm.clouds3", "sum", 3, "octave_sum"),
                                       ("fbm.ridged4_cell_period", "sum", 4, "octahedral_octave_sum"),
                                       ("fbm_d.eroded3_cell", "sum", 3, "octahedral_octave_sum"),
                                       ("warp.warp_progressive2_cell_period", "sum", 2, "extended_octave_sum")):
            function = functions[id]
            self.assertEqual((function.form, function.axes, function.family), (form, axes, family), id)
        cell, word = functions["noise3d.perlin_cell"], functions["hash.word"]
        self.assertEqual((cell.bound, cell.calls), ("perlin", "hn_perlin"))
        self.assertEqual(cell.overloads, (("place3", "uint"),))
        self.assertEqual((word.calls, word.overloads), ("hn_hash", (("uint",),)))
        self.assertEqual(functions["numbers.shuffle"].overloads, (("uint", "uint", "uint"),))
        self.assertEqual(functions["hash.pcg3d"].overloads, (("uvec3",),))
        self.assertEqual(functions["noise2d.perlin_cell_period"].overloads, (("place2", "uint"),))
        self.assertEqual(functions["noise4d.value_d"].overloads, (("vec4",), ("vec4", "uint")))
        self.assertEqual(functions["noise4d.value_d_value"].bound, "value_d")
        self.assertEqual((functions["position.perlin2"].calls, functions["position.perlin2"].types),
                         ("hn_perlin", ("place2",)))
        self.assertEqual(functions["noise2d.cellular_full"].overloads, (("vec2", "float", "int", "uint"),))
        self.assertEqual(functions["noise3d.cell_border_cell_offset"].overloads,
                         (("place3", "float", "uint", "out ivec3", "out vec3"),))
        self.assertEqual(functions["noise2d.phasor"].overloads, (("vec2", "vec2", "float", "uint"),))
        self.assertEqual(functions["noise3d.phasor_cell"].overloads, (("place3", "vec3", "float", "uint"),))
        self.assertEqual(["wave" in functions[id].takes for id in ("noise3d.phasor", "noise3d.simplex_phase")], [True, False])
        self.assertEqual([functions[f"noise2d.cellular_{form}"].sets for form in ("full", "nearest", "cell_offset")],
                         ["", "nearest", "offset"])
        self.assertEqual(functions["fbm.fbm2"].types, ("vec2", "int", "float", "float"))
        self.assertEqual(functions["fbm.fbm2"].settings, ("octaves", "lacunarity", "gain"))
        self.assertEqual(functions["fbm.ridged3_cell"].overloads, (("place3", "int", "float", "float", "uint"),))
        self.assertEqual(functions["fbm.ping_pong2_cell_period"].overloads,
                         (("place2", "int", "float", "float", "float", "uint"),))
        self.assertEqual(functions["fbm.fbm1_cell_period"].overloads,
                         (("place1", "int", "float", "float", "uint"),))
        self.assertEqual(functions["warp.warp2"].settings, ("octaves", "lacunarity", "gain", "amplitude"))
        self.assertEqual(functions["fbm_d.fbm_d3"].calls, "hn_fbm_d")
        self.assertEqual(functions["fbm.fbm2_detail"].overloads, (("vec2", "float", "float", "float", "uint"),))
        self.assertEqual(functions["fbm.fbm3_footprint"].overloads,
                         (("vec3", "float", "int", "float", "float", "uint"),))
        self.assertEqual([functions[id].has_cell for id in ("fbm.fbm2", "fbm.weighted3_cell", "noise2d.perlin_cell",
                                                            "hash.word")], [False, True, True, False])
        self.assertEqual([functions[id].exact for id in ("hash.word", "gradient.lattice2", "gradient.sine2",
                                                              "noise2d.cellular_nearest")],
                         [True, True, False, False])

    def test_sums_with_settings_of_their_own_and_components(self) -> None:
        functions = {function.id: function for function in read_functions()}
        self.assertEqual(functions["noise2d.gullies"].overloads,
                         (("vec2", "vec2", "int", "float", "float", "float", "uint"),))
        self.assertEqual(functions["noise2d.gullies_cell_period_footprint"].overloads,
                         (("place2", "float", "vec2", "int", "float", "float", "float", "uint"),))
        self.assertEqual([functions[f"noise3d.{name}"].component for name in (
            "value_vector_d_z", "perlin_vector_d_cell_period_y", "value_vector_d_x", "value_d", "phasor_d")],
            [2, 1, 0, None, None])
        self.assertEqual(functions["noise3d.perlin_worley"].overloads,
                         (("vec3", "int", "float", "float"), ("vec3", "int", "float", "float", "uint")))

    def test_columns_of_candidates_and_checks(self) -> None:
        functions = {function.id: function for function in read_functions()}
        for id_, form, axes, overloads in (
                ("hash.self_check", "zero", 1, (("uint",),)),
                ("scatter.point3", "candidate", 3, (("place3", "uint"), ("ivec3", "uint"))),
                ("scatter.scattered2", "candidate", 2, (("place2", "float", "uint"), ("ivec2", "float", "uint")))):
            function = functions[id_]
            self.assertEqual((function.form, function.axes, function.overloads), (form, axes, overloads))
            self.assertEqual((function.sets, "radius" in function.takes), ("", "scattered" in id_))

    def test_hex_tiling_has_a_seed_at_a_position(self) -> None:
        functions = {function.id: function for function in read_functions()}
        self.assertEqual(functions["noise2d.hex_weights"].overloads, (("vec2", "uint"),))

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


class Library(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_finds_overloads_and_their_comments(self) -> None:
        (self.folder / "a.glsl").write_text("""
// A noise.
//   seed     any
HN_FN hn_float hn_one(hn_place2 place,
                      hn_uint seed) {
}
HN_FN hn_float hn_one(hn_vec2 p) { return hn_i_none(hn_one(hn_place(p), 0u)); }

HN_FN hn_float hn_two(hn_vec3 p) { return 0.0f; }
HN_FN hn_float hn_i_three(hn_vec3 p) { return 0.0f; }
HN_FN hn_float hn_four(hn_vec4 p, HN_I_OUT(hn_vec4) gradient) { return 0.0f; }
""")
        first, second, third, fourth = glsl.declarations(self.folder)
        self.assertEqual([str(f) for f in (first, second, third)],
                         ["hn_one(place2, uint)", "hn_one(vec2)", "hn_two(vec3)"])
        self.assertEqual((first.line, second.line, third.line), (4, 7, 9))
        self.assertEqual(str(fourth), "hn_four(vec4, out vec4)")
        self.assertEqual(first.comment, glsl.Comment(2, (" A noise.", "   seed     any")))
        self.assertEqual(first.comment.headings, {"seed"})
        self.assertIs(second.comment, first.comment)  # an overload without one of its own
        self.assertIsNone(third.comment)

    def test_overloads_that_dimensions_made_have_the_comment_of_the_plane(self) -> None:
        (self.folder / "a.glsl").write_text("""
//   seed     any
HN_FN hn_float hn_one(hn_vec2 p) { return 0.0f; }
// Generated for 3 and 4 dimensions from the lines above.
HN_FN hn_float hn_one(hn_vec3 p) { return 0.0f; }
HN_FN hn_float hn_one(hn_vec4 p) { return 0.0f; }

// Another.
HN_FN hn_float hn_two(hn_vec4 p) { return 0.0f; }
""")
        plane, three, four, two = glsl.declarations(self.folder)
        self.assertEqual(plane.comment, glsl.Comment(2, ("   seed     any",)))
        self.assertIs(three.comment, plane.comment)
        self.assertIs(four.comment, plane.comment)
        self.assertEqual(two.comment, glsl.Comment(8, (" Another.",)))

    def test_tells_sums_of_octaves_from_their_steps(self) -> None:
        (self.folder / "a.glsl").write_text("""
#include "octaves3d.glsl"
HN_FN hn_float hn_one(hn_vec3 p) { return 0.0f; }
HN_FN bool hn_two(HN_I_INOUT(hn_octaves3) o) { return false; }
""")
        found = glsl.declarations(self.folder)
        self.assertEqual([str(f) for f in found], ["hn_one(vec3)", "hn_two(out octaves3)"])
        self.assertEqual([f.dimensions_of_sum for f in found], [3, None])

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
