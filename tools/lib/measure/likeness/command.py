"""Measures what looks like the noise of other libraries: tools/peers --likeness."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

from likeness import picture, ports
from likeness.renderer import Renderer
from likeness.table import ROWS

# A record of the same calls differs by less, whatever the driver.
SAME = 0.02


def differences(found: list[ports.Port], record: Mapping[str, ports.Port]) -> list[str]:
    """Between what was found and what a record has."""
    told = []
    for each in found:
        before = record.get(each.id)
        if before is None:
            told.append(f"{each.id}: the record has no such row")
        else:
            numbers = (("scale", each.scale, before.scale), ("factor", each.factor, before.factor))
            told += [f"{each.id}: the {name} is {now:.3f}, and {then:.3f} in the record"
                     for name, now, then in numbers if not abs(now / then - 1.0) <= SAME]
    return told


def run(paths: Mapping[str, Path], out: Path, pictures: Path | None, check: bool) -> int:
    """Writes likeness.csv into a folder, or with check compares with that of docs; 1 if something is not as it should
    be."""
    renderer = Renderer()
    found = ports.ports(paths, tell=lambda port: print(
        f"{port.id}: scale {port.scale:.3f}, factor {port.factor:.3f}", flush=True), renderer=renderer)
    problems = ports.problems(found)
    if check:
        problems += differences(found, ports.read())
    else:
        out.mkdir(parents=True, exist_ok=True)
        ports.write(found, out / ports.RECORD.name)
    if pictures is not None:
        pictures.mkdir(parents=True, exist_ok=True)
        factors = {port.id: port.factor for port in found}
        by_id = {row.id: row for row in ROWS}
        for port in found:
            row = by_id[port.id]
            picture.draw(renderer, row, port, paths[row.peer], ports.our_source(row, factors), pictures)
    for problem in problems:
        print(problem, file=sys.stderr)
    return bool(problems)
