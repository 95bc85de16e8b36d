"""Records of what was measured: CSV files. A row is what was measured and its setting, a column a quantity, whose name
has the unit. Facts of all rows, such as the date and the driver, stand above them as comments: "# date: 2026-11-26".
Rows that differ in one column alone, such as the chip, may stand in one row: "navi31 cost" is the cost where the chip is
navi31."""

from __future__ import annotations

import csv
import statistics
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple


class Record(NamedTuple):
    facts: dict[str, str]
    rows: list[dict[str, str]]


class Quantity(NamedTuple):
    value: float
    spread: float = 0.0  # half the distance between its quartiles

    def __str__(self) -> str:
        return f"{self.value:.2f} ± {self.spread:.2f}"


def ratio(samples: Sequence[float], reference: Sequence[float]) -> Quantity:
    """The median of the quotients of each round, and half the distance between their quartiles."""
    if len(samples) != len(reference):
        raise ValueError(f"{len(samples)} samples stand beside {len(reference)} of the reference: a round has one of each")
    low, middle, high = statistics.quantiles(one / other for one, other in zip(samples, reference))
    return Quantity(middle, (high - low) / 2)


class Change(NamedTuple):
    before: Quantity
    now: Quantity

    @property
    def is_more(self) -> bool:
        """By more than both spreads."""
        return self.now.value - self.before.value > self.now.spread + self.before.spread


def read(path: Path, columns: Sequence[str] = (), by: str = "tools/measure", across: str = "") -> Record:
    """ValueError if the table is not one of these columns, as a command writes it. With the name of a column the rows
    are as they were before beside() put them into one, and a table that has this column is read as it is."""
    facts, table = {}, []
    with open(path, newline="", encoding="utf-8") as file:
        for line in file:
            if table or not line.startswith("# "):
                table.append(line)
            else:
                name, _, value = line[2:].rstrip("\n").partition(": ")
                facts[name] = value
    reader = csv.DictReader(table)
    rows, heads = list(reader), list(reader.fieldnames or ())
    if across and across not in heads:
        rows, heads = apart(rows, heads, across)
    if columns and [head for head in heads if head in columns] != list(columns):
        raise ValueError(f"{path}: the first line must be {','.join(columns)}, as {by} writes it")
    return Record(facts, rows)


def write(path: Path, rows: Iterable[Mapping[str, object]], columns: Sequence[str] = (),
          facts: Mapping[str, object] | None = None) -> None:
    """The columns are those of the first row, unless others are named."""
    rows = list(rows)
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        file.writelines(f"# {name}: {' '.join(str(value).split())}\n" for name, value in (facts or {}).items())
        writer = csv.DictWriter(file, columns or list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def beside(rows: Iterable[Mapping[str, str]], key: Sequence[str], across: str) -> list[dict[str, str]]:
    """One row for each key. Columns that would be empty in all of them are left out."""
    rows = list(rows)
    values = dict.fromkeys(row[across] for row in rows)
    names = [name for name in (rows[0] if rows else ()) if name not in (*key, across)]
    found: dict[tuple[str, ...], dict[str, str]] = {}
    for row in rows:
        cells = found.setdefault(tuple(row[name] for name in key), {name: row[name] for name in key})
        cells |= {f"{row[across]} {name}": row[name] for name in names if row[name]}
    used = {name for cells in found.values() for name in cells}
    heads = [*key, *(head for value in values for name in names if (head := f"{value} {name}") in used)]
    return [{head: cells.get(head, "") for head in heads} for cells in found.values()]


def apart(rows: Iterable[Mapping[str, str]], heads: Sequence[str], across: str) -> tuple[list[dict[str, str]], list[str]]:
    """The rows and columns that beside() had."""
    common = [head for head in heads if " " not in head]
    values, names = (list(dict.fromkeys(head.split(" ", 1)[i] for head in heads if " " in head)) for i in (0, 1))
    return ([{**{name: row[name] for name in common}, across: value, **cells} for row in rows for value in values
             if any((cells := {name: row.get(f"{value} {name}", "") for name in names}).values())],
            [*common, across, *names])


def number(text: str | None) -> float | None:
    """Nothing for the words that stand where there is no number."""
    try:
        return float(text or "")
    except ValueError:
        return None


def three_digits(number: float) -> str:
    # From here on three digits are those before the point, which the other format would write.
    return f"{number:.0f}" if abs(number) >= 99.95 else f"{number:#.3g}"


def quantities(rows: Iterable[Mapping[str, str]], key: Sequence[str], value: str,
               spread: str = "") -> dict[tuple[str, ...], Quantity]:
    """The quantities that are numbers, by name."""
    found = {}
    for row in rows:
        one, around = number(row[value]), number(row[spread]) if spread else 0.0
        if one is not None and around is not None:
            found[tuple(row[name] for name in key)] = Quantity(one, around)
    return found


def compare(before: Mapping[tuple[str, ...], Quantity],
            now: Mapping[tuple[str, ...], Quantity]) -> dict[tuple[str, ...], Change]:
    """Rows that both have."""
    return {key: Change(before[key], found) for key, found in now.items() if key in before}
