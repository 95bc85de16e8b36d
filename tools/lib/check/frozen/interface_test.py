"""The table of the interface: the library is as it has it, and a change of each kind of text is reported."""

from __future__ import annotations

import unittest
from functools import cache
from pathlib import Path
from unittest import mock

from base.testing import Case
from base.tree import INTERFACE, ROOT
from catalog import parameters
from check.frozen import interface
from ship import hlsl_nodes
from translate.pick import program

TEXT_OF = Path.read_text
STAYS = "It stays from 1.0 on"
REMEDY = ": restore it, or give what is new another name"
CHANGES = (  # of a file; the report
    ("catalog/settings.toml", "default = 6", "default = 5",
     f"default octaves: it was 6, and is 5. {STAYS}{REMEDY}"),
    ("catalog/settings.toml", "default = 6", "default = 5", "blender billow2.octaves: it was int 6, and is int 5."),
    ("catalog/settings.toml", '["euclidean", "squared"', '["squared", "euclidean"',
     "default metric: it was euclidean, and is squared."),
    # A range stays in both directions: 16 bits of a narrower one are other numbers.
    ("catalog/sums.toml", "range = [0, 1]", "range = [0, 2]",
     f"range turbulence: it was 0 1, and is 0 2. {STAYS}{REMEDY}"),
    ("catalog/sums.toml", "range = [0, 1]", "range = [0, 0.99]",
     f"range turbulence: it was 0 1, and is 0 0.99. {STAYS}{REMEDY}"),
    ("catalog/noises.toml", "f1 = [[0, 1.1181]", "f1 = [[0, 1.118]",
     "range cellular 2D, f1: it was 0 1.1181, and is 0 1.118."),
    ("catalog/noises.toml", "[perlin.options]",
     "[perlin.ranges]\nvalue = [[], [-0.91, 0.91], [], []]\n[perlin.options]",
     "range perlin 2D, value: it was -1 1, and is -0.91 0.91."),
    ("conformance/expected/bounds.inc", "2.44e-6, 2.67e-6", "2.44e-6, 2.68e-6",
     "bound hn_perlin 2, octahedral: it was 2.44e-6 2.67e-6 3.77 1.0 4.30e-5 1.0, and is 2.44e-6 2.68e-6 3.77 1.0 "
     f"4.30e-5 1.0. {STAYS} (a bound may only become smaller){REMEDY}"),
    ("docs/measured/accuracy.md", "`hn_fbm(vec2)` | 6.1e-5", "`hn_fbm(vec2)` | 6.2e-5",
     "bound hn_fbm(vec2): it was 6.1e-5 "),
    ("glsl/hashnoise/cellular2d.glsl", "(hn_vec2 p, hn_float jitter, hn_int metric,",
     "(hn_vec2 p, hn_int metric, hn_float jitter,", "form hn_cellular2_jitter: it was vec2 hn_cellular(vec2, float, "
     "int, uint), and is vec2 hn_cellular(vec2, int, float, uint)."),
    ("glsl/hashnoise/curl2d.glsl", "hn_curl(hn_vec2 p) {", "hn_i_curl(hn_vec2 p) {",
     "function hn_curl(vec2): it was there, and is gone."),
    ("glsl/hashnoise/config.glsl", "define HN_HASH HN_HASH_LATTICE", "define HN_HASH HN_HASH_PCG",
     "constant HN_HASH: it was HN_HASH_LATTICE, and is HN_HASH_PCG."),
    ("glsl/hashnoise/detail/cell2d.glsl", "hn_ivec2 cell;\n  hn_i_num2 f", "hn_uvec2 cell;\n  hn_i_num2 f",
     "struct hn_place2.cell: it was ivec2, and is uvec2."),
    ("include/hashnoise/field.hpp", " = Arithmetic::kFast", " = Arithmetic::kFixed",
     "c++ Settings.arithmetic: it was 3: Arithmetic = Arithmetic::kFast, and is "),
    ("include/hashnoise/points.hpp", "PerAxis<float, D> f{};", "float first_f{};", "c++ CellGrid.f: it was 2: "),
    ("packages/python/hashnoise/__init__.pyi", "def random(x: _Number, y: _Number", "def random(y: _Number, x: _Number",
     "python random.x: it was 1, and is 2"),
    ("packages/npm/src/index.d.ts", "allInCell(cell: number |", "allInCell(cell: string |",
     "javascript Field.allInCell: it was (cell: number | "),
    ("packages/npm/src/index.d.ts", "init(module?:", "init(module:", "javascript init: it was (module?: WebAssembly."),
    ("packages/npm/src/index.d.ts", "      cell?:", "      cells?:", "javascript Field.grid: it was ( size: "),
    ("packages/npm/src/index.d.ts", "      first?:", "      first:", "javascript Field.grid: it was ( size: "),
    ("packages/npm/src/index.d.ts", "    coordinates: Coordinates,", "    coordinates: object,",
     "javascript Field.points 2: it was ( coordinates: Coordinates"),
    ("packages/npm/package.json", "./tsl/fixed\"", "./tsl/exact\"",
     "javascript hashnoise/tsl/fixed: it was import, and is gone."),
    ("packages/python/hashnoise/_bake.py", '"arithmetic": "fixed"', '"arithmetic": "fast"',
     "default arithmetic of tools/bake: it was fixed, and is fast."),
    ("src/grid/plan.cpp", "wave[0] = 3.0f", "wave[0] = 2.0f", "default wave: it was 3.0 along x, and is 2.0 along x."),
    ("packages/blender/nodes.py", "SCALE = 5.0", "SCALE = 4.0", "blender Scale: it was 5.0, and is 4.0."),
    ("packages/blender/nodes.py", '("F1", "F2")', '("First", "F2")',
     "blender cellular2.f1: it was output float, and is gone."),
)


class Interface(Case):
    def setUp(self) -> None:
        self.table = interface.read(INTERFACE)

    def test_the_library_is_as_in_the_committed_table(self) -> None:
        rows = interface.library()
        self.assertEqual([*interface.changed(self.table, rows), *interface.stale(self.table, rows)], [])
        if not interface.DELETED:
            self.assertEqual(INTERFACE.read_text(encoding="utf-8"), interface.text_of(rows))

    def test_a_change_is_reported(self) -> None:
        for file, before, after, said in CHANGES:
            if not (ROOT / file).exists() or said.split()[0] in interface.DELETED:
                continue

            def changed(path: Path, *arguments: str, **named: str) -> str:
                text = TEXT_OF(path, *arguments, **named)
                return text.replace(before, after, 1) if path == ROOT / file else text

            read = program._read_once  # that is cached
            read = read.__wrapped__ if file.startswith("glsl/") else read
            catalog = cache(parameters._read.__wrapped__)
            with self.subTest(said), mock.patch.object(Path, "read_text", changed), \
                    mock.patch.object(program, "_read_once", read), mock.patch.object(parameters, "_read", catalog):
                self.assertNotEqual((ROOT / file).read_text(encoding="utf-8"), TEXT_OF(ROOT / file, encoding="utf-8"))
                self.assertIn(said, "\n".join(interface.changed(self.table, interface.library())))

    @unittest.skipIf("materialx" in interface.DELETED, "MaterialX was deleted")
    def test_a_changed_node_of_materialx_is_reported(self) -> None:
        from ship.materialx import files as materialx
        key = "jitter", "float"
        other = materialx.INPUTS[key]._replace(said='value="0.5"')
        with mock.patch.dict(materialx.INPUTS, {key: other}):
            messages = [*interface.changed(self.table, interface.library())]
        self.assertRegex(messages[0], r"\Amaterialx hn_\w+.jitter: it was float 1.0, and is float 0.5\. ")
        with mock.patch.dict(materialx.TYPES, {"vec3": "color3"}):
            messages = "\n".join(interface.changed(self.table, interface.library()))
        self.assertIn("materialx hn_warp3d.out: it was output vector3, and is output color3. ", messages)

    def test_a_changed_output_of_a_node_is_reported(self) -> None:
        with mock.patch.dict(hlsl_nodes.PORTS, {"vec2": "float3"}):
            messages = "\n".join(interface.changed(self.table, interface.library()))
        self.assertIn("graph HashNoiseWarp2.Out: it was output float2, and is output float3. ", messages)
        if "unreal" not in interface.DELETED:
            self.assertIn("unreal warp2 fast: it was return hn_warp(", messages)

    def test_what_is_new_and_bounds_that_shrink_are_no_change_and_written(self) -> None:
        init, grid = ("javascript", "init"), ("javascript", "Field.grid")
        first = "first?: number | ArrayLike<number>; "
        self.table |= {init: "(): Promise<void>", grid: self.table[grid].replace(first, "")}
        rows = {**self.table, ("function", "hn_new(vec2)"): "", ("bound", "hn_sine"): "0x1p-20 3.66e-5",
                init: "(module?: WebAssembly.Module): Promise<void>",
                grid: self.table[grid].replace("out?:", f"{first}out?:")}
        self.assertNotEqual(rows[grid], self.table[grid])
        self.assertEqual([*interface.changed(self.table, rows)], [])
        self.assertEqual([*interface.stale(self.table, rows)],
                         ["bound hn_sine: its row is older. Run tools/make freeze",
                          "function hn_new(vec2): it has no row. Run tools/make freeze",
                          "javascript Field.grid: its row is older. Run tools/make freeze",
                          "javascript init: its row is older. Run tools/make freeze"])

    def test_bounds_and_ranges_of_experimental_functions_are_free_until_they_are_ready(self) -> None:
        bounds = " ".join(name for kind, name in self.table if kind in ("bound", "range"))
        self.assertNotRegex(bounds, "gullies|distribution|perlin_worley")
        self.assertIn(("form", "hn_gullies2"), self.table)
        with mock.patch.object(interface, "read_functions", lambda: []):
            new = {name for kind, name in interface.library().keys() - self.table.keys()}
        self.assertIn("hn_distribution_fbm", new)

    def test_a_table_that_is_none_is_reported(self) -> None:
        path = self.folder / "interface.csv"
        for text in ("", "kind,name\n", "kind,name,what\nform,hn_perlin2\n"):
            path.write_text(text, encoding="utf-8")
            with self.assertRaisesRegex(ValueError, "line 1 has to be kind,name,what"):
                interface.read(path)
