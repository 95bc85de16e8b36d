"""Records of what was measured: CSV files. A row is what was measured and its setting, a column a quantity, whose name
has the unit. Facts of all rows, such as the date and the driver, stands above them as comments: "# date:
2026-11-26"."""

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


def read(path: Path, columns: Sequence[str] = (), by: str = "tools/measure") -> Record:
    """ValueError if the table is not one of these columns, as a command writes it."""
    facts, table = {}, []
    with open(path, newline="", encoding="utf-8") as file:
        for line in file:
            if table or not line.startswith("# "):
                table.append(line)
            else:
                name, _, value = line[2:].rstrip("\n").partition(": ")
                facts[name] = value
    reader = csv.DictReader(table)
    heads = list(reader.fieldnames or ())
    if columns and [head for head in heads if head in columns] != list(columns):
        raise ValueError(f"{path}: the first line must be {','.join(columns)}, as {by} writes it")
    return Record(facts, list(reader))


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
