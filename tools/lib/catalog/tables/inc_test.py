"""Tests of inc.py: it reads what the tables consist of, and refuses anything else with its place."""

from __future__ import annotations

import tempfile
import unittest
from pathlib import Path

from catalog.tables.inc import Row, TableError, read_rows

TABLE = """// ROW(not, this)
//
ROW("one", word, "x:f32 = value:f64",  // ROW(nor, that)
    return f(a, b);)

#include "further.inc"
#undef ROW
"""
FURTHER = """
ROW("first." "two", kind, "//x",
    g("name, (y");) ROW("third", kind, "", h(kind(1, 2));)
"""


class Reading(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "table.inc"

        self.path.with_name("further.inc").write_text(FURTHER)

    def rows(self, text: str, count: int = 4) -> list[Row]:
        self.path.write_text(text)
        return read_rows(self.path, "ROW", count)

    def test_rows_and_what_is_included(self) -> None:
        one, two, third = self.rows(TABLE)
        self.assertEqual(one.arguments, ('"one"', "word", '"x:f32 = value:f64"', "return f(a, b);"))
        self.assertEqual((one.text(0), one.word(1), one.path.name, one.line), ("one", "word", "table.inc", 3))
        self.assertEqual((two.text(0), two.text(2), two.arguments[3]), ("first.two", "//x", 'g("name, (y");'))
        self.assertEqual((third.text(0), third.word(1), third.arguments[3]), ("third", "kind", "h(kind(1, 2));"))
        self.assertEqual([(row.path.name, row.line) for row in (two, third)], [("further.inc", 2)] * 2)

    def test_other_forms_are_refused_with_their_place(self) -> None:
        for text, line, message in (
                ("\nCOLUMN(1, 2, 3, 4)\n", 2, "COLUMN"), ("ROW(1, 2, 3, 4)\n#if X\n", 2, "#if X"),
                ("ROW(1, 2, 3, 4)\nx ROW(1, 2, 3, 4)\n", 2, "x is not ROW"), ("ROW(1, 2, 3, 4);\n", 1, ";"),
                ("\n\nROW(1, 2,\n 3)\n", 3, "3 arguments instead of 4"), ("ROW(1, 2, 3, 4\n", 1, "not closed"),
                ("#define ROWS\nROW(1, 2, 3, 4)\n", 1, "#define ROWS"), ("/* */\n", 1, "/*")):
            with self.assertRaisesRegex(TableError, rf"table\.inc:{line}: .*{message.replace('*', '[*]')}", msg=text):
                self.rows(text)
        self.path.with_name("further.inc").write_text("\n\nCOLUMN(1)\n")
        with self.assertRaisesRegex(TableError, r"further\.inc:3: COLUMN"):
            self.rows(TABLE)
        with self.assertRaisesRegex(TableError, "no row of ROW"):
            self.rows("// nothing\n")

    def test_arguments_of_another_kind_are_refused(self) -> None:
        row, = self.rows('ROW("a" b, c d, "e", f)\n')
        for read in (lambda: row.text(0), lambda: row.word(1), lambda: row.text(3), lambda: row.word(2)):
            self.assertRaisesRegex(TableError, r"table\.inc:1: .* is no", read)
