"""tools/costs.csv: what the steps and tests of the commands cost, as it was measured.

    kind      name          value
    budget    tests         the processor seconds that all tests of a default run may take
    speed     loop          the processor seconds of the loop of tools/lib/base/progress.sh on the machine of reference: those of all
                            other rows are as they would be there
    packages  each          seconds to install a package, with what it needs
    build     NAME          processor seconds of a build from nothing; steps: in how many steps
    run       COMMAND       processor seconds of a run without options; of tools/test the seconds that its tests take,
                            times the cores, since some tests wait
    test      NAME          processor seconds of a test; a program of gtest is one row with all of its tests

`before` is the value in the last table that kept to the budget.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

HEADER = ["kind", "name", "value", "before"]
SHOWN = 5  # of those that grew


@dataclass
class Row:
    value: float
    before: float | None = None


Table = dict[tuple[str, str], Row]


def read(text: str) -> Table:
    lines = list(csv.reader(io.StringIO(text)))
    if not lines or lines[0] != HEADER:
        raise ValueError(f"the first line of the table must be {','.join(HEADER)}")
    return {(kind, name): Row(float(value), float(before) if before else None) for kind, name, value, before in lines[1:]}


def read_file(path: Path) -> Table:
    return read(path.read_text(encoding="utf-8")) if path.exists() else {}


def written(table: Table) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for (kind, name), row in sorted(table.items()):
        writer.writerow([kind, name, f"{row.value:.4g}", "" if row.before is None else f"{row.before:.4g}"])
    return text.getvalue()


def tests_of(table: Table) -> dict[str, Row]:
    return {name: row for (kind, name), row in table.items() if kind == "test"}


def keeps_to_budget(table: Table) -> bool:
    return sum(row.value for row in tests_of(table).values()) <= table["budget", "tests"].value


def _growth(name: str, row: Row) -> str:
    if row.before is None:
        return f"{name} is new with {row.value:.0f} s"
    return f"{name} went from {row.before:.0f} to {row.value:.0f} s"


def problems(table: Table, tests: Iterable[str]) -> list[str]:
    """Faults of the table, given the rows that the tests of a default run should have."""
    rows, expected = tests_of(table), set(tests)
    found = [f"{name} has no row: run tools/test --record -R NAME_OF_THE_TEST" for name in sorted(expected - rows.keys())]
    found += [f"{name} is no test of a default run any more: run tools/test --record -N, which removes its row"
              for name in sorted(rows.keys() - expected)]
    if not keeps_to_budget(table):
        total, budget = sum(row.value for row in rows.values()), table["budget", "tests"].value
        grown = [(row.value - (row.before or 0), name) for name, row in rows.items() if row.value > (row.before or 0)]
        most = "; ".join(_growth(name, rows[name]) for _, name in sorted(grown, reverse=True)[:SHOWN])
        found.append(f"the tests of a default run take {total:.0f} s of processor time, and may take {budget:.0f}: {most}. "
                     "Make them cheaper, or register one with CONFIGURATIONS Thorough")
    return found


def rebased(table: Table, speed: float) -> Table:
    """The table as it would be on a machine on which the loop takes so long. Packages come over a network."""
    factor = speed / table.get(("speed", "loop"), Row(speed)).value
    rebased = {(kind, name): Row(row.value * factor, row.before and row.before * factor)
               if kind in ("budget", "build", "run", "test") else row for (kind, name), row in table.items()}
    return rebased | {("speed", "loop"): Row(speed)}


def updated(table: Table, measured: dict[tuple[str, str], float], tests: Iterable[str]) -> Table:
    """The table with new values, without the rows of tests that there are no more."""
    accept = ("budget", "tests") not in table or keeps_to_budget(table)
    expected, new = set(tests), {}
    for key, row in table.items():
        if key[0] != "test" or key[1] in expected:
            new[key] = Row(row.value, row.value if accept and key[0] == "test" else row.before)
    for key, value in measured.items():
        before = new[key].before if key in new and key[0] == "test" else None
        new[key] = Row(value, before)
    return new
