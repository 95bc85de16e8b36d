"""The command line of tools/measure likeness, which describes it."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from base.renderer import Renderer
from base.usage import Parser
from measure import stamps
from measure.likeness import picture, ports
from measure.likeness.table import ROWS
from measure.peers.copies import add_options, some_given
from measure.peers.table import OTHERS, PEERS

DESCRIPTION = """\
Finds the scale and the factor with which a call of ours looks like one of another library.

    tools/measure likeness [--fastnoiselite FILE] [--materialx DIR] [--webgl-noise DIR] [--psrdnoise DIR] [--lygia DIR]
                           [--glsl-noise DIR] [--pictures DIR] [--out DIR | --check]

Each option is the path of a copy of yours; its help names which file or folder of it. Peers without an option are left
out. Unity's Shader Graph and the snippets of Inigo Quilez have none, since ports of ours are measured.

It leaves likeness.csv in DIR. docs/measured/results/llvmpipe/likeness.csv is such a file; tools/make readme makes the
tables of docs/guide/moving.md of it. It needs libOSMesa.

Exit status: 0 done, 1 ours does not look alike even so, or with --check the numbers are not those of docs; 2 bad
usage."""

# Peers whose calls have rows.
ALIKE = tuple(peer for peer in (*PEERS, *OTHERS) if any(row.peer == peer.option for row in ROWS))
# A record of the same calls differs by less, whatever the driver.
SAME = 0.02


def differences(found: list[ports.Port], record: Mapping[str, ports.Port]) -> list[str]:
    """Between what was found and what a record has."""
    printed = []
    for each in found:
        before = record.get(each.id)
        if before is None:
            printed.append(f"{each.id}: the record has no such row")
        else:
            numbers = (("scale", each.scale, before.scale), ("factor", each.factor, before.factor))
            printed += [f"{each.id}: the {name} is {now:.3f}, and {then:.3f} in the record"
                     for name, now, then in numbers if not abs(now / then - 1.0) <= SAME]
    return printed


def run(paths: Mapping[str, Path], out: Path, pictures: Path | None, check: bool) -> int:
    """Writes likeness.csv into a folder, or with check compares with that of docs; 1 if something is not as it should
    be."""
    paths = {**ports.PORTS, **paths}
    renderer = Renderer()
    found = ports.ports(paths, tell=lambda port: print(
        f"{port.id}: scale {port.scale:.3f}, factor {port.factor:.3f}", flush=True), renderer=renderer)
    problems = ports.problems(found)
    if check:
        problems += differences(found, ports.read())
    else:
        out.mkdir(parents=True, exist_ok=True)
        ports.write(found, out / ports.RECORD.name)
        stamps.stamp(out / ports.RECORD.name, renderer.version)
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


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure likeness", DESCRIPTION)
    add_options(parser, ALIKE)
    parser.add_argument("--pictures", type=Path, metavar="DIR",
                        help="draw theirs, ours as it is, ours as ported, and a board of the first and the last")
    parser.add_argument("--out", type=Path, metavar="DIR", default=Path("out"), help="(default: %(default)s)")
    parser.add_argument("--check", action="store_true", help="compare with the numbers of docs, and write no record")
    options = parser.parse_args(arguments)
    return run(some_given(parser, options, ALIKE), options.out, options.pictures, options.check)
