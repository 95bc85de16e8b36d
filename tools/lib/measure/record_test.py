"""Tests of records: what is written is read, and a comparison sees what grew by more than both spreads."""

from __future__ import annotations

import math
import unittest

from base.testing import Case
from measure import record
from measure.record import Change, Quantity


class Files(Case):
    def setUp(self) -> None:
        self.path = self.folder / "new" / "a.csv"

    def test_what_is_written_is_read(self) -> None:
        rows = [{"id": "a,b", "ms": "1.5"}, {"id": "# c\nd", "ms": "failed"}]
        record.write(self.path, rows, facts={"date": "today", "why": "x: y,\nz"})
        self.assertEqual(record.read(self.path, ("id", "ms")), ({"date": "today", "why": "x: y, z"}, rows))
        self.assertTrue(self.path.read_text().startswith("# date: today\n# why: x: y, z\nid,ms\n"))
        record.write(self.path, [], ("id",))
        self.assertEqual(record.read(self.path), ({}, []))

    def test_rows_that_stand_beside_each_other_are_read_apart(self) -> None:
        rows = [{"id": "perlin", "chip": "m1", "cost": "5", "problem": ""},
                {"id": "perlin", "chip": "acm", "cost": "", "problem": "too hard"},
                {"id": "value", "chip": "acm", "cost": "3", "problem": ""}]
        record.write(self.path, record.beside(rows, ("id",), "chip"))
        self.assertEqual(self.path.read_text(),
                         "id,m1 cost,acm cost,acm problem\nperlin,5,,too hard\nvalue,,3,\n")
        self.assertEqual(record.read(self.path, ("id", "chip", "cost"), across="chip").rows, rows)
        with self.assertRaisesRegex(ValueError, "the first line must be id,chip,price"):
            record.read(self.path, ("id", "chip", "price"), across="chip")
        record.write(self.path, rows)
        self.assertEqual(record.read(self.path, across="chip").rows, rows)

    def test_another_table_is_refused(self) -> None:
        for text in ("", "a,b\n", "ms,id\n", "{}\n"):
            self.path.parent.mkdir(exist_ok=True)
            self.path.write_text(text)
            with self.assertRaisesRegex(ValueError, "a.csv: the first line must be id,ms, as tools/measure x writes it"):
                record.read(self.path, ("id", "ms"), "tools/measure x")


class Comparison(unittest.TestCase):
    def test_a_round_has_a_sample_of_each(self) -> None:
        self.assertEqual(record.ratio([2, 4, 6], [2, 2, 2]), Quantity(2, 1))
        with self.assertRaisesRegex(ValueError, "3 samples stand beside 2 of the reference"):
            record.ratio([1, 2, 3], [1, 2])

    def test_more_is_beyond_both_spreads(self) -> None:
        for before, now, is_more in (  # powers of two, so that sums are exact
                ((1.0, 0.25), (1.0, 0.25), False),
                ((1.0, 0.25), (1.5, 0.25), False),  # just the sum of the spreads
                ((1.0, 0.25), (math.nextafter(1.5, 2.0), 0.25), True),
                ((1.0, 0.5), (1.5, 0.0), False),
                ((1.0, 0.0), (1.5, 0.5), False),
                ((1.0, 0.0), (math.nextafter(1.0, 2.0), 0.0), True),
                ((1.0, 0.25), (0.25, 0.25), False),
                ((-0.5, 0.125), (0.0, 0.125), True)):
            with self.subTest(before=before, now=now):
                self.assertEqual(Change(Quantity(*before), Quantity(*now)).is_more, is_more)

    def test_of_what_both_have_as_a_number(self) -> None:
        before = [{"id": name, "ms": "1", "spread": "0.5"} for name in ("kept", "gone", "broken")]
        now = [{"id": "new", "ms": "9", "spread": "0"}, {"id": "kept", "ms": "9", "spread": "0"},
               {"id": "broken", "ms": "failed", "spread": "failed"}]
        compared = record.compare(*(record.quantities(rows, ("id",), "ms", "spread") for rows in (before, now)))
        self.assertEqual(compared, {("kept",): Change(Quantity(1.0, 0.5), Quantity(9.0))})
