"""The tables of docs/measured/quality.md and hashes.md, from what tools/measure hashes found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from base.tree import ROOT
from catalog.tables.markdown import table
from measure import record as records

RESULTS = ROOT / "docs" / "measured" / "results"
LOOKS = ("structures", "waves", "slices")  # measures of all noises
Rows = Sequence[Mapping[str, str]]


def record(name: str) -> list[dict[str, str]]:
    return records.read(RESULTS / name).rows


def _said(row: Mapping[str, str]) -> str:
    return f"{row['failed']} of {row['of']}: {row['worst']}" if int(row["failed"]) else "passes"


def pasted_table(rows: Rows) -> str:
    """A row for each hash in the plane and in space, a column for each place: the same in the order of the record."""
    windows: dict[tuple[str, str], list[str]] = {}
    for row in rows:
        windows.setdefault((row["hash"], row["dimensions"]), []).append(_said(row))
    return table(("hash", "around the origin", "tens of thousands of cells away", "millions", "8 million"),
                 [[f"{name}, {n}D", *said] for (name, n), said in sorted(windows.items(), key=lambda item: item[0][1])])


def hash_table(rows: Rows) -> str:
    """The results of each hash in the plane and in space, and the parts of the gate that fail."""
    found: dict[str, dict[str, list[Mapping[str, str]]]] = {}
    for row in rows:
        if row["part"] != "all":
            found.setdefault(row["hash"], {}).setdefault(row["dimensions"], []).append(row)

    def cell(parts: Rows) -> str:
        return ", ".join([f"{sum(int(row['of']) for row in parts)}",
                          *(f"**{row['part']}: {_said(row)}**" for row in parts if row["failed"] != "0")])

    return table(("hash", "results in 2D", "in 3D"),
                 [[f"`{name}`", *map(cell, parts.values())] for name, parts in found.items()])


def control_table(rows: Rows) -> str:
    """The hashes that must fail, and the first one, which must not."""
    return table(("control", "tests that fail", "by most"),
                 [[f"{row['hash']}{', in space' * (row['dimensions'] == '3')}", f"{row['failed']} of {row['of']}",
                   row["worst"] * (row["failed"] != "0")] for row in rows if row["part"] == "all"])


def look_table(rows: Rows) -> str:
    """A row for each noise: the harmonics of its structures and of its waves, and how much slices differ."""
    noises: dict[tuple[str, str], dict[str, list[str]]] = {}
    for row in rows:
        if row["noise"].split(",")[0] not in ("hn_phasor", "hn_fbm"):
            kind = row["measure"].split(",")[0]
            noises.setdefault((row["noise"], row["dimensions"]), {}).setdefault(kind, []).append(row["mean"])
    return table(("noise", *LOOKS), [[f"`{name.split(',')[0]}`{name[len(name.split(',')[0]):]}, {n}D",
                                      *(", ".join(found.get(kind, ())) for kind in LOOKS)]
                                     for (name, n), found in noises.items()])


def trace_table(rows: Rows) -> str:
    """Measures of single noises, and all that have a limit; a cell has the values of all waves, or slices."""
    def limit(row: Mapping[str, str]) -> str:
        least = row["measure"].split(",")[0] in ("even", "slices")
        return ("at least " * least + row["allowed"]) * bool(row["allowed"])

    found: dict[tuple[str, str, str], list[str]] = {}
    for row in rows:
        if row["allowed"] or row["measure"].split(",")[0] not in LOOKS:
            measure = row["measure"].partition(", wave (")[0].partition(", slices")[0]
            found.setdefault((f"`{row['noise']}`, {row['dimensions']}D", measure, limit(row)), []).append(row["mean"])
    return table(("noise", "measure", "value", "allowed"),
                 [[noise, measure, ", ".join(values), allowed] for (noise, measure, allowed), values in found.items()])
