"""Measures what hashnoise::grid costs on this processor, by each of its instruction sets, beside FastNoise2.

    tools/measure cpu [--compiler PROGRAM]... [--against fastnoise2=FILE] [--against strict=FILE] [--filter GLOB]...
                      [--rounds N] [--note TEXT] [--out DIR]

The library is compiled with each compiler, which takes minutes, and fills grids of 1024 x 1024 and 128 x 128 x 64 points
and lists of the same points. FILE is the shared library of FastNoise2; strict is one that was built with
FASTNOISE2_STRICT_FP. Google Benchmark times all fills of a noise in random order. gcc.csv or clang.csv goes into DIR: for
each noise and instruction set how many times as fast one fill is as another, with the spread of this quotient, half the
distance between its quartiles over pairs of samples, and millions of points a second. Nothing else should run meanwhile.
tools/make pages makes tables of docs/measured/measuring.md of docs/measured/results/cpu, which has such files.

It needs, of Debian 12: cmake, ninja-build, libbenchmark-dev and the compilers. tools/test installs them.

Exit status: 0 done, 1 something could not be measured, 2 bad usage, 4 it could not be built.
"""

from __future__ import annotations

import json
import re
import statistics
import sys
from collections import defaultdict
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

from base.cross_build import Failed, Place, output_of
from base.tree import ROOT
from base.usage import Parser, whole
from base.versions import version_of
from catalog.tables.markdown import table
from measure import fills, record, stamps

FILLS = ("fast", "fixed", "precise", "tiles", "points", "two threads", "FastNoise2", "FastNoise2 points",
         "FastNoise2 strict")
THREADS = "two threads"
SETS = ("generic", "neon", "sse4.1", "avx2", "avx512")
# By their columns: how many times as fast the first is as the second.
COMPARED = {"grids": ("fast", "FastNoise2"), "points": ("points", "FastNoise2 points"), "octaves": ("octaves", "FastNoise2"),
            "strict fixed": ("fixed", "FastNoise2 strict"), "strict precise": ("precise", "FastNoise2 strict"),
            "fixed": ("fixed", "fast"), "precise": ("precise", "fast"), "tiles": ("tiles", "fast"),
            "lists": ("points", "fast"), "threads": ("two threads", "fast")}
ON_THE_PAGE = [*COMPARED][:7]
Row = Mapping[str, str]


def rows_of(noise: str, report: str) -> list[dict[str, str]]:
    """By the JSON of Google Benchmark: times of the processor, and of a clock by two threads; the narrowest instructions
    first."""
    nanoseconds: dict[str, dict[str, list[float]]] = defaultdict(lambda: defaultdict(list))
    for one in json.loads(report)["benchmarks"]:
        if one["run_type"] == "iteration":
            instructions, fill = one["run_name"].split("/")
            nanoseconds[instructions][fill].append(one["real_time" if fill == THREADS else "cpu_time"])
    rows = []
    for instructions, times in sorted(nanoseconds.items(), key=lambda one: SETS.index(one[0])):
        row = {"noise": noise, "instructions": instructions}
        for name, (first, second) in COMPARED.items():
            found = record.ratio(times[second], times[first]) if times.keys() >= {first, second} else ("", "")
            row |= zip((name, f"{name} spread"), (f"{one:.4g}" if one != "" else "" for one in found))
        rows.append(row | {f"{fill} million/s": f"{1e3 * fills.POINTS / statistics.median(times[fill]):.4g}"
                           if fill in times else "" for fill in FILLS})
    return rows


def page_table(rows: Sequence[Row]) -> str:
    """A line for each noise, with numbers by instruction sets."""
    heads = [" : ".join(COMPARED[name]) for name in ON_THE_PAGE]
    lines = []
    for noise in dict.fromkeys(row["noise"] for row in rows if not row["noise"].startswith("ridged")):
        of = [row for row in rows if row["noise"] == noise]
        cells = [[f"{float(row[name]):.2f}" for row in of if row[name]] for name in ON_THE_PAGE]
        rates = [record.three_digits(float(row["fast million/s"])) for row in of]
        lines.append([f"`{noise}`", *map(" / ".join, (*cells, rates))])
    return table(("noise", *heads, "million points a second"), lines)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure cpu", __doc__)
    parser.add_argument("--compiler", action="append", metavar="PROGRAM", help="g++ or clang++ (g++); may be repeated")
    parser.add_argument("--rounds", type=partial(whole, least=3), default=15, metavar="N", help="samples of each time (15)")
    fills.add_options(parser)
    options = parser.parse_args(arguments)
    processor = re.search(r"^model name\s*: (.*)", Path("/proc/cpuinfo").read_text("utf-8"), re.MULTILINE)
    for compiler in options.compiler or ["g++"]:
        try:
            program = fills.built(Place(compiler, (), linked=("-pthread", "-lbenchmark")),
                                  ROOT / "build" / f"bench-cpu-{Path(compiler).name}", "bench.cpp", "-O3")
        except (Failed, OSError) as error:
            print(f"{parser.prog}: it could not be built: {error}", file=sys.stderr)
            return 4
        try:
            rows = [row for noise in fills.subjects(options, program) for row in rows_of(noise, output_of(
                program, noise, *options.against, f"--benchmark_repetitions={options.rounds}", "--benchmark_min_time=0.006",
                "--benchmark_enable_random_interleaving=true", "--benchmark_format=json"))]
        except Failed as error:
            print(f"{parser.prog}: {error}", file=sys.stderr)
            return 1
        stamps.keep(options.out / f"{'clang' if 'clang' in compiler else 'gcc'}.csv", rows,
                    f"{processor[1].strip() if processor else 'an unknown processor'}, {version_of(compiler)}",
                    {"note": options.note, "rounds": options.rounds})
    return 0
