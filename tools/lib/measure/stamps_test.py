"""Tests of the texts of records: an edited noise makes its rows stale and no other, an edited comment none, and a
record without its text is an error."""

from __future__ import annotations

import contextlib
import io
import shutil
import unittest
from collections.abc import Callable
from pathlib import Path
from unittest import mock

from base.testing import Case
from base.tree import ROOT
from measure import record, stamps

SUBJECTS = ("noise2d.value.lattice", "noise2d.value.lattice+fixed", "noise2d.perlin.lattice", "noise3d.value.lattice",
            "warp.warp2.lattice", "noise2d.cellular.lattice+sine", "hash.pcg2d.any", "fbm.fbm2.own_noise", "empty2",
            "table.float2", "mine2")


class Texts(Case):
    def setUp(self) -> None:
        self.copies = 0
        self.file = self.put("bench.csv", *SUBJECTS)
        stamps.stamp(self.file, "a chip")

    def put(self, name: str, *ids: str) -> Path:
        path = self.folder / "results" / name
        record.write(path, [{"id": id_, "ratio": "1.5"} for id_ in ids], ("id", "ratio"))
        return path

    def edited(self, name: str, edit: Callable[[str], str]) -> Path:
        """Another tree, with a file that is edited."""
        self.copies += 1
        tree = self.folder / f"tree{self.copies}"
        for folder in stamps.SOURCES:
            shutil.copytree(ROOT / folder, tree / folder)
        before = (tree / name).read_text()
        self.assertTrue((after := edit(before)) != before, name)
        (tree / name).write_text(after)
        return tree / "glsl" / "hashnoise"

    def stale(self, name: str, edit: Callable[[str], str]) -> list[str]:
        return [row["id"] for row in stamps.stale(self.file, self.edited(f"glsl/hashnoise/{name}", edit))]

    def test_an_edited_noise_makes_its_rows_stale_and_no_other(self) -> None:
        self.assertEqual(stamps.stale(self.file), [])
        for name, old, new, others in (
                ("value2d.glsl", "HN_FN hn_float hn_value(hn_place2 place, hn_uint seed) {",
                 "HN_FN hn_float hn_value(hn_place2 place, hn_uint seed) { seed += 0u;",
                 ["noise2d.value.lattice", "noise2d.value.lattice+fixed"]),
                ("detail/arithmetic.glsl", "return a + hn_i_part(b - a, t);", "return hn_i_part(b - a, t) + a;",
                 ["noise2d.value.lattice+fixed"]),
                ("detail/hashes.glsl", "hn_i_congruential(v.x);", "hn_i_congruential(v.x) ^ 0u;",
                 ["hash.pcg2d.any"]),
                ("config.glsl", "#define HN_VERSION_PATCH ", "#define HN_VERSION_PATCH 7", [])):
            with self.subTest(name, new=new):
                self.assertEqual(self.stale(name, lambda text: text.replace(old, new)), others)

    def test_an_edited_comment_or_blank_makes_none_stale(self) -> None:
        for name in ("value2d.glsl", "detail/arithmetic.glsl"):
            self.assertEqual(self.stale(name, lambda text: text.replace("{\n", "{  // other words\n\n")), [])
        for name, old, new, is_same in (("src/grid/plan.cpp", "// ", "// Other words. ", True),
                                        ("src/grid/plan.cpp", "{\n", "{;\n", False),
                                        ("glsl/hashnoise/config.glsl", "#define HN_VERSION_PATCH ",
                                         "#define HN_VERSION_PATCH 7", True)):
            library = self.edited(name, lambda text: text.replace(old, new, 1))
            self.assertEqual(stamps.of_grid({}, library) == stamps.of_grid({}, stamps.GLSL), is_same, name)

    def test_what_does_not_name_its_text_is_an_error(self) -> None:
        text = self.file.read_text()
        for old, new, said in (("# date", "# day", "names the date"), ("# by: a chip\n", "", "names the by"),
                               (",none", ",", "row 9 does not name"), (",none", ",0123456", "row 9 does not name"),
                               (",text\n", ",word\n", "row 1 does not name")):
            self.file.write_text(text.replace(old, new))
            with self.subTest(new), self.assertRaisesRegex(ValueError, said):
                stamps.stale(self.file)
        self.assertEqual(stamps.paths(self.folder / "results"), [self.file])
        self.put("costs.txt", "empty2")
        with self.assertRaisesRegex(ValueError, "costs.txt: no command writes"):
            stamps.paths(self.folder / "results")

    def test_what_has_no_text_is_an_error(self) -> None:
        for id_ in ("noise2d.perlin.lattce", "noise2d.prelin.lattice", "noise2d.perlin.own_noise", "noise2d.perlin"):
            with self.subTest(id_), self.assertRaises(LookupError):
                stamps.stamp(self.put("bench.csv", id_), "a chip")

    def test_a_row_keeps_its_text(self) -> None:
        rows = [{**row, stamps.TEXT: "unknown"} for row in record.read(self.file).rows[:2]] + [{"id": "empty3"}]
        record.write(self.file, rows, ("id", "ratio", stamps.TEXT))
        stamps.stamp(self.file, "another chip")
        self.assertEqual([row[stamps.TEXT] for row in stamps.read(self.file).rows], ["unknown", "unknown", "none"])
        self.assertEqual(len(stamps.stale(self.file)), 2)
        self.assertEqual(stamps.changed(self.file), "2 of 3 rows")

    def test_a_release_refuses_them_but_for_hardware_that_is_not_here(self) -> None:
        record.write(self.file, [{"id": "noise2d.perlin.any", stamps.TEXT: "unknown"}],
                     facts={"date": "2026-11-26", "hashnoise": "1.0.0", "by": "a chip"})
        text = self.file.read_text()
        for facts, status in (("", 1), ("# needs: an oven\n", 0)):
            self.file.write_text(facts + text)
            with mock.patch.object(stamps, "paths", lambda: [self.file]), \
                    contextlib.redirect_stdout(io.StringIO()) as out:
                self.assertEqual(stamps.main([]), status)
            self.assertIn("results/bench.csv: noise2d.perlin.any unknown changed\n", out.getvalue())
            refused = "all rows are of another text; tools/measure clock measures them"
            self.assertEqual(refused in out.getvalue(), status == 1)


class Committed(unittest.TestCase):
    def test_each_record_names_its_text_and_there_is_such_a_text(self) -> None:
        paths = stamps.paths()
        self.assertEqual({path.name for path in paths}, {*stamps.KINDS})
        for path in paths:
            with self.subTest(path):
                stamps.read(path)
                if path.name != "bench.csv":  # its subjects are those of costs.csv, with settings that take longer
                    stamps.stale(path)
