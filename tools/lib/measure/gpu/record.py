"""The rows of costs.csv and chips.csv, and the comparison of costs with earlier ones."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

from measure import record
from measure.gpu.chips import Chip, Vendor
from measure.gpu.compiling import Compiled

SURPLUS = re.compile(r"^Estimated | instructions$| Count$")  # in the names of statistics
COSTS, DEVICES = "costs.csv", "chips.csv"
CHIP = "chip"  # costs.csv has the chips beside each other


class Row(NamedTuple):
    """A shader on a chip. Cost, instructions and kinds are less those of the empty shader."""
    id: str
    chip: str
    cost: str
    instructions: str
    kinds: str  # "VALU 93, SALU 3"
    registers: str
    spills: str
    compile_ms: str  # of the processor; empty if many were compiled at once
    problem: str  # why there is nothing else


def row(id: str, chip: Chip, shader: Compiled, empty: Compiled) -> Row:
    vendor = chip.vendor
    problem = shader.problem or empty.problem or lacks(shader.statistics, vendor)
    if problem:
        return Row(id, chip.name, "", "", "", "", "", "", " ".join(problem.split()))

    def more(name: str) -> float:
        return shader.statistics.get(name, 0) - empty.statistics.get(name, 0)

    kinds = ", ".join(f"{SURPLUS.sub('', name)} {more(name):g}" for name in vendor.kinds if more(name))
    return Row(id, chip.name, f"{more(vendor.cost):g}", f"{more(vendor.instructions):g}", kinds,
               f"{shader.statistics[vendor.registers]:g}",
               f"{sum(shader.statistics.get(name, 0) for name in vendor.spills):g}",
               "" if math.isnan(shader.seconds) else f"{shader.seconds * 1e3:.1f}", "")


def lacks(statistics: Mapping[str, float], vendor: Vendor) -> str:
    """Another version of a driver may have other names; 0 would be wrong then."""
    missing = {vendor.cost, vendor.instructions, vendor.registers} - set(statistics)
    return f"the driver reports no \"{min(missing)}\"" if missing else ""


def read_costs(path: Path) -> dict[tuple[str, str], Row]:
    rows = [Row(*(found.get(name, "") for name in Row._fields))
            for found in record.read(path, ("id", CHIP, "cost"), "tools/measure gpu", across=CHIP).rows]
    for found in rows:
        if not found.problem and record.number(found.cost) is None:
            raise ValueError(f"{path}: the cost of {found.id} on {found.chip} is {found.cost!r}, and not a number")
    return {(found.id, found.chip): found for found in rows}


def dearer(before: Mapping[tuple[str, str], Row], now: Iterable[Row]) -> list[str]:
    """Rows that cost more than before, or have no cost any more. Compilers repeat themselves, so that any growth
    counts."""
    lines = []
    for found in now:
        was = before.get((found.id, found.chip))
        if was is None or was.problem:
            continue
        if found.problem:
            lines.append(f"FAILS {found.id} on {found.chip}: {found.problem}; it cost {was.cost}")
        elif record.Change(*(record.Quantity(float(one.cost)) for one in (was, found))).is_more:
            lines.append(f"DEARER {found.id} on {found.chip}: {found.cost}, was {was.cost}")
    return lines
