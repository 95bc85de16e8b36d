"""The record of judgements, docs/measured/results/judged.csv, and the table of docs/measured/judge.md."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from base.tree import ROOT
from catalog.tables.markdown import table
from measure import record, stamps

RECORD = ROOT / "docs" / "measured" / "results" / "judged.csv"
COLUMNS = ("noise", "dimensions", "measure", "fails", "number")
# How the numbers of a measure are shown, and what the column is called.
SHOWN = {"range": ("largest value", "{:.3f}"), "jumps": ("jump", "{:.2g}"),
         "derivative": ("error of derivatives", "{:.2g}"), "repeats": ("repeats after", "{:.0f}"),
         "mirrors": ("mirrored", "{:.2f}"), "seeds": ("seeds", "{:.3f}"), "cells": ("cells", "{:.3f}"),
         "directions": ("directions", "{:.3f}"), "far": ("as far as", "{:.0e}"), "compilers": ("compilers", "{:.1g}"),
         "cost": ("cost", "{:.2g}")}


def read(path: Path = RECORD) -> list[dict[str, str]]:
    return record.read(path).rows


def put(path: Path, subject, findings: Iterable, by: str) -> None:
    """The numbers of a noise, where it stood before or behind the others, and the renderer."""
    rows = read(path) if path.exists() else []
    of = {"noise": subject.name, "dimensions": str(subject.dimensions)}
    verdicts = {None: "", True: "yes", False: "no"}
    new = [{**of, "measure": finding.measure, "fails": verdicts[finding.fails], "number": f"{finding.number:.4g}"}
           for finding in findings]
    kept = [row for row in rows if any(row[name] != value for name, value in of.items())]
    at = next((i for i, row in enumerate(rows) if all(row[name] == value for name, value in of.items())), len(kept))
    record.write(path, [*kept[:at], *new, *kept[at:]], (*COLUMNS, stamps.TEXT))
    stamps.stamp(path, by, kind=RECORD.name)


def judge_table(rows: Sequence[Mapping[str, str]]) -> str:
    """A row for each noise; what fails is bold."""
    noises: dict[tuple[str, str], dict[str, str]] = {}
    for row in rows:
        shown = SHOWN.get(row["measure"])
        number = shown[1].format(float(row["number"])) if shown else ""
        if row["measure"] == "repeats" and row["fails"] == "no":
            number = "no"
        noises.setdefault((row["noise"], row["dimensions"]), {})[row["measure"]] = (
            f"**{number}**" if row["fails"] == "yes" else number)
    return table(("noise", *(name for name, _ in SHOWN.values())),
                 [[f"{name}, {n}D", *(found.get(measure, "") for measure in SHOWN)]
                  for (name, n), found in noises.items()])
