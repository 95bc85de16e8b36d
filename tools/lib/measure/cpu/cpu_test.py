"""Tests of tools/measure cpu: its page, of a record that a stand-in for hn-bench-cpu leaves."""

from __future__ import annotations

import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.tree import ROOT
from catalog.tables.markdown import table
from measure import record, stamps
from measure.cpu import command

FACTS = {"date": "2026-01-01T00:00:00Z", "command": "tools/measure cpu", "compiler": "GCC 12.2.0",
         "processor": "a processor", "library": "0.4.0", "text": "01234567", "rounds": "9", "step": "0.0371",
         "note": "A note.",
         "Python with out=": "0.85 ± 0.02", "Python with a new array": "0.95 ± 0.01"}


def row(noise: str, instructions: str, **measured: str) -> dict[str, str]:
    cells = {"noise": noise, "instructions": instructions}
    for what in command.SECTIONS:
        value, _, spread = measured.get(what, "").partition(" ± ")
        cells |= {what: value, f"{what} spread": spread}
    return {**cells, "fast million/s": measured.get("rate", "")}


ROWS = [row("perlin2", "avx2", grids="1.25 ± 0.03", fixed="0.55 ± 0.01", rate="1234.5"),
        row("perlin2", "avx512", grids="0.75 ± 0.02", fixed="0.65 ± 0.01", rate="0.5")]


class Page(unittest.TestCase):
    def test_tells_which_aims_are_missed(self) -> None:
        of = record.Record(FACTS, ROWS)
        page = command.page(of)
        for part in ("compiled by GCC 12.2.0\n\na processor, GCC 12.2.0, hashnoise 0.4.0 of the text 01234567, "
                     "2026-01-01T00:00:00Z. A note. By `tools/",
                     "| `perlin2` | 1.2 | 1.25 ± 0.03 | **0.75 ± 0.02** missed |",
                     "| `perlin2` | **0.55 ± 0.01** missed | 0.65 ± 0.01 |", "(`out=`) | **0.85 ± 0.02** missed |",
                     "with a new array each time | 0.95 ± 0.01 |", "| `perlin2` | avx2 | 1234 |", "| avx512 | 0.500 |"):
            self.assertIn(part, page)
        self.assertEqual(command.missed(of), ["perlin2, avx2: fixed 0.55 ± 0.01, which is to be 0.6",
                                              "perlin2, avx512: grids 0.75 ± 0.02, which is to be 1.2",
                                              "Python with out=: 0.85 ± 0.02, which is to be 0.9"])

    def test_has_no_section_for_what_was_not_measured(self) -> None:
        facts = {name: value for name, value in FACTS.items() if not name.startswith("Python")}
        page = command.page(record.Record({**facts, "note": ""}, ROWS))
        self.assertNotRegex(page, "Two threads|Python")
        self.assertIn("00Z. By `", page)

    def test_what_cannot_be_told_is_neither_met_nor_missed(self) -> None:
        unknown = {**row("value2", "avx2"), "grids": "cannot be told", "grids spread": "cannot be told"}
        of = record.Record({}, [unknown])
        self.assertEqual(command.missed(of), [])
        self.assertIn("| `value2` | 1 | cannot be told |", command.section(of, "grids"))

    def test_the_pages_here_are_such_pages(self) -> None:
        """Their first table, of its own cells."""
        text = (ROOT / "docs" / "measured" / "results" / "cpu" / "gcc.md").read_text(encoding="utf-8")
        lines = text[text.index("| noise |"):text.index("## Lists")].strip().splitlines()
        heads, _, *cells = ([cell.strip() for cell in line.strip("|").split("|")] for line in lines)
        rows = [row(name.strip("`"), instructions, grids=number.replace("**", "").replace(" missed", ""))
                for name, _, *numbers in cells for instructions, number in zip(heads[2:], numbers)]
        again = command.section(record.Record({}, rows), "grids")
        plain = table(heads, cells).replace("**", "").replace(" missed", "")
        self.assertEqual(again[again.index("| noise |"):-1].replace("**", "").replace(" missed", ""), plain)


class Command(unittest.TestCase):
    def test_the_record_that_was_written_gets_its_page(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder)
            record.write(out / "clang.csv", [], ("noise",))
            passed = []

            def run(words: list[str]) -> int:
                passed.append(words)
                record.write(out / "gcc.csv", ROWS, facts=FACTS)
                return 0

            with mock.patch.object(command.conform, "run", run), contextlib.redirect_stdout(io.StringIO()) as printed:
                self.assertEqual(command.main(["program", "--out", folder, "--rounds", "3"]), 0)
            self.assertEqual(passed, [["program", "--out", folder, "--rounds", "3"]])
            self.assertIn("compiled by GCC", (out / "gcc.md").read_text(encoding="utf-8"))
            self.assertEqual(stamps.stale(out / "gcc.md"), [])
            self.assertFalse((out / "clang.md").exists())
            self.assertIn(f"3 aims missed: {out}/gcc.md", printed.getvalue())
            with mock.patch.object(command.conform, "run", return_value=2):
                self.assertEqual(command.main(["program", "--out", folder]), 2)


if __name__ == "__main__":
    unittest.main()
