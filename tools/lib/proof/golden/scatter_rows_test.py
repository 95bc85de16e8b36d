"""Tests of scatter_rows.py: a fault of a function changes a value of its rows, whatever it is."""

from __future__ import annotations

import functools
import unittest
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from unittest import mock

from base.thorough import THOROUGH
from catalog.tables import functions as table
from proof.golden import scatter_rows
from proof.golden.generator import INT_MAX, INT_MIN, Row, generator_of
from proof.oracle import functions, lattice, scatter, words
from proof.oracle.gradients import Knobs, Real
from proof.oracle.lattice import Lattice
from proof.oracle.scatter import UNIT

KNOBS = Knobs("lattice")
AXES = {2: "xy", 3: "xyz"}
FUNCTIONS = {function.name: function for function in table.read_functions() if function.file == "scatter"}


def function_of(n: int, radius: bool) -> table.Function:
    return FUNCTIONS[f"{'scattered' if radius else 'point'}{n}"]


@dataclass
class Rows:
    function: table.Function
    rows: list[Row]

    def values(self) -> list[tuple[Real, ...]]:
        scatter.candidate.cache_clear()  # which may remember a fault's cells, or the right ones
        evaluate = functions.evaluator(self.function, False)
        return [evaluate(KNOBS, row) for row in self.rows]

    @functools.cached_property
    def right(self) -> list[tuple[Real, ...]]:
        return self.values()


def rows_of(n: int, radius: bool) -> Rows:
    function = function_of(n, radius)
    return Rows(function, scatter_rows.rows_of(function, generator_of(function.id)))


POINTS = {n: rows_of(n, False) for n in AXES}
# In space the rows are made in the same way as in the plane, and take much longer.
SCATTERED = {n: rows_of(n, True) for n in AXES if n == 2 or THOROUGH}


class ScatterRows(unittest.TestCase):
    def setUp(self) -> None:
        self.addCleanup(scatter.candidate.cache_clear)

    def assert_noticed(self, of: Rows, module: object, name: str, fault: object, what: object = "") -> None:
        right = of.right
        with mock.patch.object(module, name, fault):
            self.assertNotEqual(of.values(), right, (of.function.id, name, what))

    def test_each_neighbour_matters(self) -> None:
        for n, of in SCATTERED.items():
            steps = scatter.steps(n)
            for left_out in steps:
                self.assert_noticed(of, scatter, "steps", lambda _, o=left_out: [s for s in steps if s != o], left_out)

    def test_distances_matter_to_the_last_unit(self) -> None:
        rivals = scatter.rivals

        def changed(change: Callable[[int], int]) -> Callable:
            return lambda *arguments: ((o, change(square)) for o, square in rivals(*arguments))

        for of in SCATTERED.values():
            # At the radius itself a rival counts in place of not; then sums of squares that wrap, as words and as ints.
            for change in (lambda square: square - 1, lambda square: square % 2**32, words.signed):
                self.assert_noticed(of, scatter, "rivals", changed(change))

    def test_the_end_of_a_radius_and_its_cut_matter(self) -> None:
        for of in SCATTERED.values():
            for fault in (lambda radius: int(min(max(radius, -1e6), 1) * UNIT),
                          lambda radius: int(max(min(radius, 1e6), 0) * UNIT),
                          lambda radius: round(min(max(radius, 0), 1) * UNIT)):
                self.assert_noticed(of, scatter, "reach", fault)

    def test_words_are_compared_as_they_are(self) -> None:
        candidate = scatter.candidate.__wrapped__

        def signed(*arguments) -> scatter.Candidate:
            found = candidate(*arguments)
            return scatter.Candidate(words.signed(found.word), found.place)

        signed.cache_clear = lambda: None
        for of in SCATTERED.values():
            self.assert_noticed(of, scatter, "candidate", signed)

    def test_periods_matter(self) -> None:
        right = lattice.repeated
        for of in (*POINTS.values(), *SCATTERED.values()):
            for what, fault in (("none", lambda c, period: c),
                                ("wrapped before", lambda c, period: right(words.signed(c), period)),
                                ("towards 0", lambda c, period: c - period * int(c / period) if period > 0 else c)):
                if what == "wrapped before" and of.function.id.startswith("scatter.point"):
                    continue  # its cell is an int
                self.assert_noticed(of, lattice, "repeated", fault, what)

    def test_each_axis_has_its_own(self) -> None:
        def exchanged(lattice_: Lattice, corner: Sequence[int]) -> list[int]:
            return [lattice.repeated(c, period) for c, period in zip(corner, lattice_.periods[::-1])]

        for of in (*POINTS.values(), *SCATTERED.values()):
            self.assert_noticed(of, Lattice, "point", exchanged)

    def test_rows_have_edges(self) -> None:
        for n, of in SCATTERED.items():
            self.assertTrue(set(scatter_rows.RADII) <= {row[2 * n] for row in of.rows})
            for axis in range(n):
                self.assertTrue(set(scatter_rows.PERIODS) <= {row[n + axis] for row in of.rows})
                self.assertTrue({INT_MIN, INT_MAX} <= {row[axis] for row in of.rows})
            values = [value > 0 for value, in of.right]
            self.assertTrue(len(values) / 3 < sum(values) < len(values) * 3 / 4, (n, sum(values), len(values)))
        for n, of in POINTS.items():
            self.assertTrue({INT_MIN, INT_MAX} <= {row[0] for row in of.rows})
