"""The numbers that pages state of the library: typical values, and how many are golden."""

from __future__ import annotations

import functools
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import catalog.model
from base.tree import GOLDEN
from base.twin import SOON, compile_program
from catalog.tables.markdown import table

# --- Typical values ---------------------------------------------------------------------------------------------------

CATALOG = catalog.model.read()
SUMS = tuple(f"hn_{sum_.name}" for sum_ in CATALOG.sums if sum_.shape != "slopes" and sum_.is_in(2))
PLAIN_SUMS = tuple(f"hn_{sum_.name}" for sum_ in CATALOG.sums if sum_.is_of_values)
COMMON = ("hn_perlin", "hn_value", "hn_value_cubic", "hn_simplex", "hn_simplex_smooth", "hn_fbm")


def lines_of(source: str) -> list[list[str]]:
    """The words of each line that a program beside this file prints."""
    with TemporaryDirectory() as folder:
        program = Path(folder) / "program"
        compile_program(source, Path(__file__).with_name(source), program, *SOON)
        output = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    return [line.split() for line in output.splitlines()]


@functools.cache
def typical() -> dict[tuple[str, int], list[float]]:
    """Mean, deviation, 1st and 99th percentile, by function and number of axes."""
    return {(name, int(axes)): [float(value) for value in values] for name, axes, *values in lines_of("typical.cpp")}


def typical_table(values: Mapping[tuple[str, int], list[float]], names: Sequence[str],
                  dimensions: Sequence[int] = (2, 3)) -> str:
    def cells(mean: float, deviation: float, low: float, high: float) -> list[str]:
        return [f"{_number(mean)} ± {_number(deviation)}", f"{_number(low)} to {_number(high)}"]

    rows = [[f"`{name}`", *(cell for axes in dimensions for cell in cells(*values[name, axes]))] for name in names]
    heads = (head for axes in dimensions for head in (f"{axes}D: mean ± deviation", "98 of 100 values"))
    return table(("", *heads), rows)


def _number(value: float) -> str:
    """With two digits after the point, and no more than it has."""
    return f"{round(value, 2) + 0.0:g}"


# --- The gain of a footprint ------------------------------------------------------------------------------------------


@functools.cache
def footprint() -> dict[str, float]:
    """How far pixels of a receding plane are from the mean of many places in them, by the way they are computed."""
    return {name: float(value) for name, value in lines_of("footprint.cpp")}


def footprint_quote(errors: Mapping[str, float]) -> str:
    return ("Against the mean of 16 by 16 places in each pixel of the picture's far half, the error (root mean square) is "
            f"{errors['with']:.3f} with the footprint and {errors['without']:.3f} without; the deviation of the noise is "
            f"{errors['deviation']:.2f}.\n")


# --- Golden values ---------------------------------------------------------------------------------------------------


def golden_quote() -> str:
    """The README's number of golden values, rounded down to ten thousands."""
    found = sum(len(group.split()) for path in GOLDEN.glob("*.golden") for row in path.read_text(encoding="ascii").splitlines()
                for group in row.split(" = ")[1:] if group != "-" and not row.startswith("columns "))
    return f"computes {found // 10_000 * 10_000:,} golden values"
