"""Tests of tools/make faults

A script stands in for hn-conform, so that this takes no driver and no time.
"""

from __future__ import annotations

import json

from base.testing import Case, called
from check.faults import command as faults

STAND_IN = """#!/bin/sh
[ "$*" = "run --inject list" ] && exec cat list
fault=healthy
while [ $# -gt 0 ]; do
  case $1 in --inject) fault=$2 ;; --out) out=$2 ;; esac
  shift
done
cp $fault.json "$out/results.json"
exit "$(cat $fault)"
"""
LIST = """one
  fault: it is wrong
  reported in: a place: 1
  injected: this
  remark: some
two
  fault: it too
  reported in: nowhere
  injected: that
"""

PASS = (0, [("hash.word.x", "pass", 0), ("hash.vec2.x", "pass", 0), ("bugs.a.x", "warning", 1)])
RED = (1, [("hash.word.x", "fail", 3), ("hash.vec2.x", "fail", 1), ("bugs.a.x", "warning", 1), ("bugs.b.x", "warning", 2)])
NOT_COMPILED = (1, [("hash.word.x", "fail", 0), ("hash.vec2.x", "fail", 1)])
UNNOTICED = (1, [("hash.word.x", "pass", 0)])


class Faults(Case):
    def setUp(self):
        self.table = self.folder / "faults.md"

    def call(self, *arguments, healthy=PASS, one=RED, two=RED):
        program = self.script("hn-conform", STAND_IN.replace("#!/bin/sh", f"#!/bin/sh\ncd {self.folder}"))
        (self.folder / "list").write_text(LIST)
        for name, (status, cases) in {"healthy": healthy, "one": one, "two": two}.items():
            results = [dict(id=id_, status=of, mismatches=wrong, message="why") for id_, of, wrong in cases]
            (self.folder / f"{name}.json").write_text(json.dumps(dict(runs=[dict(cases=results)])))
            (self.folder / name).write_text(str(status))
        status, self.shown = called(faults.main, "--program", program, "--out", self.table, *arguments)
        return status

    def test_named_faults_take_the_other_rows_from_the_file(self):
        self.assertEqual(self.call(), 0)
        self.assertEqual(self.call("--check", "two", one=UNNOTICED), 0)
        self.assertEqual(self.call("--check", "two", two=(1, [("hash.word.x", "fail", 3)])), 1)

    def test_rows_are_compared_without_a_run(self):
        self.assertEqual(self.call(), 0)
        self.assertEqual(self.call("--check", "--rows", healthy=RED), 0)
        text = self.table.read_text()
        for old, new in (("it too", "it also"), ("nowhere", "somewhere"), ("| that |", "| this |"), ("| `two`", "| `2`")):
            with self.subTest(new=new):
                self.assertIn(old, text)
                self.table.write_text(text.replace(old, new))
                self.assertEqual(self.call("--check", "--rows"), 1)
                self.assertEqual(self.call("--check", "one"), 1)
        for arguments in (("--rows",), ("--check", "--rows", "one")):
            self.assertEqual(self.call(*arguments), 2, arguments)

    def test_the_table_tells_what_failed_and_what_else_warned(self):
        self.assertEqual(self.call(), 0)
        text = self.table.read_text()
        self.assertIn("| `one`: it is wrong | a place: 1 | this (some) | **hash** word, vec2 | **bugs** b |\n", text)
        self.assertIn("warnings are given by **bugs** a.", text)

    def test_an_old_table_is_noticed(self):
        self.assertEqual(self.call("--check"), 1)
        self.assertFalse(self.table.exists())
        self.call()
        by_hand = "\n## Found\n\nIt is there.\n"
        self.table.write_text(self.table.read_text() + by_hand)
        self.assertEqual(self.call("--check"), 0)
        self.table.write_text(self.table.read_text().replace("vec2", "vec3"))
        self.assertEqual(self.call("--check"), 1)
        self.assertEqual(self.call(), 0)
        self.assertTrue(self.table.read_text().endswith(f"by **bugs** a.\n{by_hand}"))

    def test_the_healthy_driver_may_warn_of_less_but_not_of_more(self):
        more, less = ((0, [*PASS[1], ("bugs.c.x", status, 1)]) for status in ("warning", "pass"))
        self.assertEqual(self.call(healthy=less), 0)
        self.assertEqual(self.call("--check", healthy=more), 1)
        self.assertIn("faults.md is not what tools/make faults writes now", self.shown)
        self.assertEqual(self.call(healthy=more), 0)
        for arguments in (), ("--check",):
            self.assertEqual(self.call(*arguments, healthy=less), 0, arguments)
        self.assertIn("warnings are given by **bugs** a, c.", self.table.read_text(), "those of another machine stay")
        self.assertEqual(self.call("--check"), 1, "there is no such case any more")
        self.assertEqual(self.call(), 0)
        self.assertIn("warnings are given by **bugs** a.", self.table.read_text())

    def test_a_fault_that_nothing_notices(self):
        for two in (UNNOTICED, PASS):
            self.assertEqual(self.call(two=two), 1)
            self.assertIn("two: NOT NOTICED", self.shown)
        self.assertFalse(self.table.exists())

    def test_a_shader_that_does_not_compile_notices_nothing(self):
        self.assertEqual(self.call(one=NOT_COMPILED), 1)
        self.assertIn("one: NOT JUDGED: hash.word.x: why", self.shown)

    def test_the_healthy_driver_must_pass(self):
        self.assertEqual(self.call(healthy=RED), 3)
        self.assertEqual(self.call(one=(2, [])), 3)

    def test_some_faults_leave_the_table(self):
        self.assertEqual(self.call("two", one=UNNOTICED), 0)
        self.assertFalse(self.table.exists())
        self.assertEqual(self.call("three"), 2)
