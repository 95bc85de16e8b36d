"""The table of docs/measured/hashes.md, from what tools/measure hashes --against found of the hashes that people paste."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from base.tree import ROOT
from catalog.tables.markdown import table
from measure import record as records

RECORD = ROOT / "docs" / "measured" / "results" / "hashes.csv"


def record() -> list[dict[str, str]]:
    return records.read(RECORD).rows


def _said(row: Mapping[str, str]) -> str:
    return f"{row['failed']} of {row['of']}: {row['worst']}" if int(row["failed"]) else "passes"


def hash_table(rows: Sequence[Mapping[str, str]]) -> str:
    """A row for each hash in the plane and in space, a column for each place: the same in the order of the record."""
    windows: dict[tuple[str, str], list[str]] = {}
    for row in rows:
        windows.setdefault((row["hash"], row["dimensions"]), []).append(_said(row))
    return table(("hash", "around the origin", "tens of thousands of cells away", "millions", "8 million"),
                 [[f"{name}, {n}D", *said] for (name, n), said in sorted(windows.items(), key=lambda item: item[0][1])])
