"""The numbers that pages state of the library: typical values, and costs."""

from __future__ import annotations

import csv
import subprocess
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

from tables.markdown import table
from tree import ROOT
from twin import compile_program

BENCH = ROOT / "docs" / "results" / "llvmpipe" / "bench.csv"
Costs = Mapping[str, Mapping[str, str]]  # the rows of bench.csv, by id

# --- Typical values -----------------------------------------------------------------------------------------------------


def typical() -> dict[tuple[str, int], list[float]]:
    """Mean, deviation, 1st and 99th percentile, by function and number of axes."""
    with TemporaryDirectory() as folder:
        program = Path(folder) / "typical"
        compile_program("typical.cpp", Path(__file__).with_name("typical.cpp"), program)
        lines = subprocess.run([program], capture_output=True, text=True, check=True).stdout.splitlines()
    return {(name, int(axes)): [float(value) for value in values] for name, axes, *values in map(str.split, lines)}


def typical_table(values: Mapping[tuple[str, int], list[float]]) -> str:
    def cells(mean: float, deviation: float, low: float, high: float) -> list[str]:
        return [f"{_number(mean)} ± {_number(deviation)}", f"{_number(low)} to {_number(high)}"]

    rows = [[f"`{name}`", *cells(*values[name, 2]), *cells(*values[name, 3])]
            for name in dict.fromkeys(name for name, _ in values)]
    return table(("", "2D: mean ± deviation", "98 of 100 values", "3D: mean ± deviation", "98 of 100 values"), rows)


def _number(value: float) -> str:
    """With two digits after the point, and no more than it has."""
    return f"{round(value, 2) + 0.0:g}"


# --- Costs --------------------------------------------------------------------------------------------------------------

NOISES = {  # what stands in the table, by the end of its ids
    "table.float": "Perlin/Float (`table.float`)",
    "table.integer": "Perlin/Integer (`table.integer`)",
    "lattice": "`lattice`, the default",
    "fnv1+sine": "`fnv1+sine`, the paper's",
}
ROWS = ("table.float", "table.integer", "lattice", "lattice+precise", "lattice+fixed", "partial_fnv1", "murmur",
        "partial_jenkins", "fnv1", "jenkins", "lattice+period64", "fnv1+sine")


def costs() -> Costs:
    with open(BENCH, newline="", encoding="utf-8") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def ids(noise: str) -> list[str]:
    """In 2D and in 3D."""
    return [f"{noise}{n}" if noise.startswith("table.") else f"noise{n}d.perlin.{noise}" for n in (2, 3)]


def cost_table(rows: Costs) -> str:
    lines = [[NOISES.get(noise, f"`{noise}`"), *(f"{float(rows[id]['ratio']):.2f}" for id in ids(noise)),
              *(rows[id]["navi21"] for id in ids(noise))] for noise in ROWS]
    return table(("noise", "2D", "3D", "instructions on AMD's NAVI21, 2D", "3D"), lines)


def cost_quote(rows: Costs) -> str:
    """What the README says of them."""
    plane, space = (1 / float(rows[id]["ratio"]) for id in ids("lattice"))
    return f"takes {plane:.1f} times as long in 2D, and {space:.1f} times in 3D"
