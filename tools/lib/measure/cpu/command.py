"""Makes a page of what hn-bench-cpu measures, and names the aims that are missed. cpu.sh describes the options.

    command.py cpu PROGRAM [options of PROGRAM]"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

from base.tree import GLSL, ROOT
from base.usage import Parser
from catalog.tables.markdown import table
from measure import conform, record, stamps
from measure.record import Quantity, Record, three_digits

# How many times as fast as FastNoise2 a grid is to be; the others 1.
GRIDS = {"perlin2": 1.2, "perlin3": 1.1, "simplex2": 1.1, "simplex3": 1.1, "cellular2": 2.0, "cellular3": 2.0}
AIMS = {"fixed": 0.6, "lists": 0.5}
PYTHON_AIM = 0.9
# By the names of the record: title and text.
SECTIONS = {
    "grids": ("Grids, beside FastNoise2", "How many times as fast as FastNoise2 a grid is filled, both with the same "
              "instructions, by one thread, with HN_FAST. The aim stands behind each noise."),
    "points": ("Lists of points, beside FastNoise2", "The same at a million points that are passed. There is no aim."),
    "octaves": ("Octaves that are not turned, beside FastNoise2", "FastNoise2 does not turn the octaves of a sum. Here "
                "they are not turned either: each is a grid of the noise, twice as dense as the one before and with a "
                "seed of its own, and the grids are added up. There is no aim."),
    "strict fixed": ("HN_FIXED beside FastNoise2 by strict floats", "FastNoise2 was built with FASTNOISE2_STRICT_FP: "
                     "then all its sets of instructions give the same values, as those of HN_FIXED and HN_PRECISE do. "
                     "There is no aim."),
    "strict precise": ("HN_PRECISE beside FastNoise2 by strict floats", "The same with HN_PRECISE. There is no aim."),
    "fixed": ("HN_FIXED beside HN_FAST", "How many times as fast as with HN_FAST a grid is filled with HN_FIXED. The aim "
              "is 0.6."),
    "precise": ("HN_PRECISE beside HN_FAST", "The same with HN_PRECISE. There is no aim."),
    "tiles": ("Tiles beside grids without a period", "How many times as fast as without a period a grid with one of "
              "1000 cells is filled. There is no aim."),
    "lists": ("Lists of points beside grids", "How many times as fast as a grid a list of the same points is computed. "
              "The aim is 0.5."),
    "threads": ("Two threads beside one", "How many times as fast as by one thread a grid is filled by two. There is no "
                "aim."),
}
RATE = " million/s"
PYTHON = {"Python with out=": "with an array of the caller (`out=`)",
          "Python with a new array": "with a new array each time"}
Row = Mapping[str, str]


def aim_of(what: str, noise: str) -> float | None:
    return GRIDS.get(noise, 1.0) if what == "grids" else AIMS.get(what)


def found(row: Row, what: str) -> Quantity | None:
    value, spread = record.number(row[what]), record.number(row[f"{what} spread"])
    return None if value is None or spread is None else Quantity(value, spread)


def of_python(facts: Mapping[str, str]) -> dict[str, Quantity]:
    return {name: Quantity(*map(float, facts[name].split(" ± "))) for name in PYTHON if name in facts}


def missed(of: Record) -> list[str]:
    """"perlin2, avx2: grids 0.93 ± 0.02, which is to be 1"."""
    lines = []
    for row in of.rows:
        for what in SECTIONS:
            one, aim = found(row, what), aim_of(what, row["noise"])
            if one and aim and one.value < aim:
                lines.append(f"{row['noise']}, {row['instructions']}: {what} {one}, which is to be {aim:g}")
    return lines + [f"{name}: {one}, which is to be {PYTHON_AIM}" for name, one in of_python(of.facts).items()
                    if one.value < PYTHON_AIM]


def cell(one: Quantity | None, aim: float | None) -> str:
    if one is None:
        return "cannot be told"
    return f"**{one}** missed" if aim and one.value < aim else str(one)


def section(of: Record, what: str) -> str:
    there = [row for row in of.rows if row[what]]
    sets = list(dict.fromkeys(row["instructions"] for row in there))
    if not sets:
        return ""
    lines = []
    for noise in dict.fromkeys(row["noise"] for row in there):
        aim = aim_of(what, noise)
        by_set = {row["instructions"]: cell(found(row, what), aim) for row in there if row["noise"] == noise}
        lines.append([f"`{noise}`", *([f"{aim:g}"] if what == "grids" else []), *(by_set.get(name, "") for name in sets)])
    title, text = SECTIONS[what]
    return f"## {title}\n\n{text}\n\n" + table(["noise", *(["aim"] if what == "grids" else []), *sets], lines) + "\n"


def page(of: Record) -> str:
    facts = of.facts
    python = [(PYTHON[name], cell(one, PYTHON_AIM)) for name, one in of_python(facts).items()]
    rates = [name for name in of.rows[0] if name.endswith(RATE)]

    def rate(row: Row, name: str) -> str:
        number = record.number(row[name])
        return "" if number is None else three_digits(number)

    return (
        f"# hashnoise::grid on a CPU, compiled by {facts['compiler']}\n\n{facts['processor']}, "
        f"{facts['compiler']}, hashnoise {facts['library']} of the text {facts['text']}, {facts['date']}."
        f"{facts['note'] and ' '}{facts['note']} By `{facts['command']}`.\n\nEach "
        f"number is a quotient of speeds that were measured in the same {facts['rounds']} rounds, in turns, and what "
        "stands behind ± is half the distance between the quartiles of the rounds. A grid has 1024 x 1024 or 128 x 128 x "
        f"64 points, {facts['step']} cells from each other, and sums have six octaves. A number that is less than its "
        "aim is bold, with \"missed\".\n\n" + "".join(section(of, what) for what in SECTIONS) +
        ("## Python beside C++\n\nHow many times as fast as C++ `hashnoise.perlin` computes a million points in 2D, by "
         f"one thread. The aim is {PYTHON_AIM}.\n\n{table(('call', 'ratio'), python)}\n" if python else "") +
        "## Million points a second\n\nThese are of this machine and this run, and nothing is to be compared with "
        "numbers from elsewhere. `cellular` has two distances at each point, and FastNoise2 one.\n\n" +
        table(["noise", "instructions", *(name.removesuffix(RATE) for name in rates)],
              [[f"`{row['noise']}`", row["instructions"], *(rate(row, name) for name in rates)] for row in of.rows]))


def main(arguments: Sequence[str]) -> int:
    parser = Parser("tools/measure cpu", __doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "measured" / "results" / "cpu")
    program, *others = arguments
    options, others = argparse.ArgumentParser.parse_known_args(parser, others)
    status = conform.run([program, "--out", str(options.out), *others])
    if status:
        return status
    newest = max((path for name in ("gcc", "clang") if (path := options.out / f"{name}.csv").is_file()),
                 key=lambda path: path.stat().st_mtime_ns)
    of = record.read(newest)
    of.facts.update({"library": stamps.of_library(), stamps.TEXT: stamps.of_grid({}, GLSL)})
    newest.with_suffix(".md").write_text(page(of), encoding="utf-8")
    lines = missed(of)
    for line in lines:
        print(f"MISSED {line}")
    print(f"{len(lines)} aims missed: {newest.with_suffix('.md')}")
    return 0
