"""Tests of AMD's counts, by a stand-in for hn-conform shader-statistics."""

from __future__ import annotations

import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from measure import amd, record

PROGRAM = """\
#!{python}
import json, os, sys
print(json.dumps({{"device": os.environ["RADV_FORCE_FAMILY"], "driver": "x"}}), flush=True)
for file in sys.argv[2:]:
    if "crash" in file: os.abort()
    text = open(file).read()
    print(json.dumps({{"error": "too hard\\nmore"}} if text == "hard" else
                     {{"statistics": {{"Instructions": int(text)}}, "seconds": 0.1}}), flush=True)
"""


class Counts(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.program = self.folder / "program"
        self.program.write_text(PROGRAM.format(python=sys.executable))
        self.program.chmod(0o755)
        (self.folder / "radeon_icd.x.json").touch()
        self.enterContext(mock.patch.object(amd, "FOLDERS", (self.folder,)))

    def add(self, **files: str) -> tuple[bool, record.Record]:
        for name, text in files.items():
            (self.folder / f"{name}.spv").write_text(text)
        path = self.folder / "bench.csv"
        record.write(path, [{"id": id, "spirv": 9, "nvidia": "not here", "problem": "old" * (id == "none")}
                            for id in (*files, "none")], facts={"date": "today"})
        return amd.add_counts(path, self.folder, str(self.program)), record.read(path)

    def test_stand_behind_those_of_spirv(self) -> None:
        good, found = self.add(one="12", two="345")
        self.assertTrue(good)
        self.assertEqual(list(found.rows[0]), ["id", "spirv", "navi21", "vega10", "nvidia", "problem"])
        self.assertEqual([row["vega10"] for row in found.rows], ["12", "345", "failed"])
        self.assertEqual((found.facts, found.rows[2]["problem"]), ({"date": "today"}, "old"))

    def test_a_shader_that_fails_costs_its_count(self) -> None:
        good, found = self.add(one="12", crash="1", hard="hard", last="3")
        self.assertFalse(good)
        self.assertEqual([row["navi21"] for row in found.rows], ["12", "failed", "failed", "3", "failed"])
        self.assertRegex(found.rows[1]["problem"], "^vega10: the compiler ended by SIGABRT.*\nnavi21: the compiler")
        self.assertIn("navi21: too hard", found.rows[2]["problem"])

    def test_without_the_driver_the_reason_is_a_fact(self) -> None:
        (self.folder / "radeon_icd.x.json").unlink()
        good, found = self.add(one="12")
        self.assertTrue(good)
        self.assertEqual(found.rows[0]["navi21"], "not here")
        self.assertIn("Mesa's RADV is not here: no radeon_icd", found.facts["no counts from vega10 here"])

    def test_settings_of_ours_do_not_reach_the_driver(self) -> None:
        with mock.patch.dict(os.environ, {"RADV_DEBUG": "nir", "ACO_DEBUG": "x", "VK_LAYER_PATH": "y", "HN_KEPT": "1"}):
            found = amd.environment("navi21")
        self.assertEqual((found["RADV_DEBUG"], found["RADV_FORCE_FAMILY"], found["HN_KEPT"]), ("nocache", "navi21", "1"))
        self.assertEqual({"ACO_DEBUG", "VK_LAYER_PATH"} & set(found), set())


if __name__ == "__main__":
    unittest.main()
