"""Tests of inc.py: it reads what the tables consist of, and refuses anything else with its place."""

from __future__ import annotations

import tempfile
import unittest
from pathlib import Path

from tables.inc import Row, TableError, read_rows

TABLE = """// ROW(not, this)
//
ROW("one", word, "x:f32 = value:f64",  // ROW(nor, that)
    return f(a, b);)

#define PAIR(name, kind)            \\
  ROW("first." name, kind, "//x",   \\
      g(name);)                     \\
  ROW("second." name "_too", kind, "name, (y", h(kind(1, 2));)
PAIR("perlin", noise)
#undef PAIR
#undef ROW
"""


class Reading(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "table.inc"

    def rows(self, text: str, count: int = 4) -> list[Row]:
        self.path.write_text(text)
        return read_rows(self.path, "ROW", count)

    def test_rows_and_macros(self) -> None:
        one, first, second = self.rows(TABLE)
        self.assertEqual(one.arguments, ('"one"', "word", '"x:f32 = value:f64"', "return f(a, b);"))
        self.assertEqual((one.text(0), one.word(1), one.line), ("one", "word", 3))
        self.assertEqual((first.text(0), first.text(2), first.arguments[3]), ("first.perlin", "//x", 'g("perlin");'))
        self.assertEqual((second.text(0), second.text(2), second.word(1)), ("second.perlin_too", "name, (y", "noise"))
        self.assertEqual(second.arguments[3], "h(noise(1, 2));")
        self.assertEqual((first.line, second.line), (10, 10))

    def test_other_forms_are_refused_with_their_place(self) -> None:
        for text, line, message in (
                ("\nCOLUMN(1, 2, 3, 4)\n", 2, "COLUMN"), ("ROW(1, 2, 3, 4)\n#if X\n", 2, "#if X"),
                ("ROW(1, 2, 3, 4)\nx ROW(1, 2, 3, 4)\n", 2, "neither"), ("ROW(1, 2, 3, 4);\n", 1, ";"),
                ("\n\nROW(1, 2,\n 3)\n", 3, "3 arguments instead of 4"), ("ROW(1, 2, 3, 4\n", 1, "not closed"),
                (TABLE.replace('PAIR("perlin", noise)', 'PAIR("perlin")'), 10, "PAIR has 1 arguments instead of 2"),
                ("#define ROWS\nROW(1, 2, 3, 4)\n", 1, "#define ROWS"), ("/* */\n", 1, "/*")):
            with self.assertRaisesRegex(TableError, rf"table\.inc:{line}: .*{message.replace('*', '[*]')}", msg=text):
                self.rows(text)
        with self.assertRaisesRegex(TableError, "no row of ROW"):
            self.rows("// nothing\n")

    def test_arguments_of_another_kind_are_refused(self) -> None:
        row, = self.rows('ROW("a" b, c d, "e", f)\n')
        for read in (lambda: row.text(0), lambda: row.word(1), lambda: row.text(3), lambda: row.word(2)):
            self.assertRaisesRegex(TableError, r"table\.inc:1: .* is no", read)
