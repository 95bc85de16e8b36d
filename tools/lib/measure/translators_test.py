"""Tests of tools/measure translators: Debian's spirv-opt has two bugs, which the suite finds, and a right one has none.

    python3 -m measure.translators_test HN_CONFORM
"""

from __future__ import annotations

import sys
import unittest

from base.testing import Case
from measure.translators import BUGS, has, is_expected, outcomes, rows
from translate.tools import BY_NAME, Tool

TOOL = BY_NAME["spirv-opt-2023.1"]
CASES = [f"bugs.{bug.case}.*" for bug in BUGS if has(bug, TOOL, "spirv")]


class Translators(Case):
    program: str

    def rows(self, tool: Tool) -> list[dict[str, str]]:
        return list(rows(tool, "spirv", outcomes(self.program, tool, "spirv", self.folder / "out", *CASES)))

    def test_the_bugs_of_debian_12_are_found(self) -> None:
        found = self.rows(TOOL)
        self.assertEqual({row["bug"]: row["outcome"] for row in found}, {
            "KhronosGroup/SPIRV-Tools 5499": "found", "KhronosGroup/SPIRV-Tools 5822": "found"})
        self.assertTrue(all(is_expected(row, TOOL, "spirv") for row in found))

    def test_a_translator_without_them_is_not_as_published(self) -> None:
        script = self.script("spirv-opt", '[ "$1" = --version ] && exec echo v2023.1\ncp "$2" "$4"')
        found = self.rows(TOOL._replace(find=lambda tool: script))
        self.assertEqual([row["outcome"] for row in found], ["right", "right"])
        self.assertFalse(any(is_expected(row, TOOL, "spirv") for row in found))

    def test_a_bug_is_in_the_versions_from_its_first_to_its_last(self) -> None:
        bug, = (bug for bug in BUGS if bug.number == "gfx-rs/wgpu 9181")
        versions = ("0.9.5", "0.13.2", "0.29.0", "0.32.0")
        self.assertEqual([has(bug, BY_NAME[f"wgpu-{version}"], "") for version in versions], [False, True, True, False])
        self.assertIsNone(has(bug, TOOL, "spirv"))

    def test_a_bug_that_nobody_knows_has_a_row(self) -> None:
        row, = (row for row in rows(TOOL, "spirv", {"bugs.abs_of_int.x": "found"}) if row["bug"] == "new")
        self.assertFalse(is_expected(row, TOOL, "spirv"))


if __name__ == "__main__":
    Translators.program = sys.argv.pop(1)
    unittest.main()
