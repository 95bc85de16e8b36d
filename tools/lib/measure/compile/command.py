"""Times how long shaders take to compile: a noise with the whole library before it, with the file of it, and as
tools/pick prints it, with floats and with HN_FIXED; and the same noise of other libraries.

    tools/measure compile [--compiler NAME]... [--rounds N] [--fastnoiselite FILE] [--out FILE]

Each time is the least of the rounds, in milliseconds, less that of an empty shader. llvmpipe and Chromium (angle, tint)
are timed by a clock, and the others by the time of the processor. The command names each shader that is refused and
each compiler that is missing; the record has no row of them. tools/make pages makes of
docs/measured/results/llvmpipe/compile.csv, which is such a record, the table of docs/measured/measuring.md.

radv, turnip, nvk and llvmpipe need hn-conform (tools/measure clock builds it), and the first three the drivers of
tools/measure gpu --get-drivers. dxc and fxc come from PyPI. The others are programs of the PATH.

Exit status: 0 done, 1 a shader of the library is refused, 2 bad usage, 3 a compiler is missing.
"""

from __future__ import annotations

import math
import sys
from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from base.debian import Missing
from base.tree import ROOT
from base.usage import Parser, whole
from catalog.tables.markdown import table
from measure import record as records
from measure import stamps
from measure.compile.compilers import COMPILERS, Compiler, Failed, Place
from measure.compile.texts import EMPTY, FIXED, OTHERS, SUBJECTS, WAYS, Job
from measure.gpu.command import DRIVERS
from measure.peers import add_options, given

RECORD = ROOT / "docs" / "measured" / "results" / "llvmpipe" / "compile.csv"
COLUMNS = ("noise", "way", "compiler", "bytes", "ms")
Rows = Sequence[Mapping[str, str]]


def measured(compiler: Compiler, place: Place, rounds: int) -> dict[Job, float]:
    """The shaders that it takes."""
    least: dict[Job, float] = defaultdict(lambda: math.inf)
    for _, times in zip(range(rounds), compiler.rounds(place)):
        for job, milliseconds in times.items():
            if not math.isnan(milliseconds):
                least[job] = min(least[job], milliseconds)
    empty = next((found for job, found in least.items() if job.way == EMPTY), math.nan)
    return {job: max(found - empty, 0.0) for job, found in least.items() if job.way != EMPTY}


def page_table(rows: Rows) -> str:
    """Of a record: for each compiler and noise the milliseconds of each way, and of other libraries."""
    cells: dict[tuple[str, str], dict[str, str]] = defaultdict(dict)
    for row in rows:
        cells[row["compiler"], row["noise"]][row["way"]] = _number(row["ms"])

    def shown(compiler: str, noise: str) -> str:
        if not (found := cells[compiler, noise]):
            return "missing"
        ours = [" / ".join(found[way + suffix] for way in WAYS) for suffix in ("", FIXED)]
        return "; ".join([*ours, *(f"{way} {ms}" for way, ms in found.items() if len(way) == 1)])

    noises = [subject.noise for subject in SUBJECTS if not subject.noise.startswith("fBm 3D")]
    return table(("", *noises), [[compiler.title, *(shown(name, noise) for noise in noises)]
                                 for name, compiler in COMPILERS.items()]) + _sums(rows)


def _sums(rows: Rows) -> str:
    """A sentence on fBm in space."""
    whole, pick, theirs = (float(next(row["ms"] for row in rows if row["way"] == way and row["compiler"] == "radv" and
                                      row["noise"].startswith("fBm 3D"))) for way in ("whole", "pick", "F"))
    return (f"\nA first compile for AMD of six octaves in 3D takes {whole:.0f} ms, as one function {pick:.0f} ms, and of "
            f"FastNoiseLite's file {theirs / 1e3:.1f} s.\n")


def _number(milliseconds: str) -> str:
    return "< 1" if float(milliseconds) < 1 else f"{float(milliseconds):,.0f}"


def record() -> list[dict[str, str]]:
    return records.read(RECORD, COLUMNS, "tools/measure compile", across="compiler").rows


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure compile", __doc__)
    parser.add_argument("--compiler", action="append", choices=tuple(COMPILERS), metavar="NAME",
                        help=f"only this one: {', '.join(COMPILERS)}; may be repeated")
    parser.add_argument("--rounds", type=whole, default=5, metavar="N", help="(default: %(default)s)")
    add_options(parser, OTHERS)
    parser.add_argument("--drivers", type=Path, metavar="DIR", default=DRIVERS,
                        help="where tools/measure gpu has put them (build/gpu-drivers)")
    parser.add_argument("--out", type=Path, default=Path("compile.csv"), metavar="FILE",
                        help="the record (default: %(default)s)")
    options = parser.parse_args(arguments)
    rows, used, status = [], [], 0
    try:
        peers = {name: path.absolute() for name, path in given(options, OTHERS).items()}
        for name in options.compiler or COMPILERS:
            print(f"{name}: {options.rounds} rounds", file=sys.stderr, flush=True)
            with TemporaryDirectory() as folder:
                place = Place(Path(folder), peers, options.drivers.absolute())
                try:
                    times = measured(COMPILERS[name], place, options.rounds)
                    used.append(COMPILERS[name].version(place))
                except Missing as why:
                    print(f"{name} is missing: {why}", flush=True)
                    status = status or 3
                    continue
            rows += [{"noise": job.noise, "way": job.way, "compiler": name, "bytes": str(len(job.library.encode())),
                      "ms": f"{milliseconds:.1f}"} for job, milliseconds in times.items()]
            if sum(not job.is_foreign for job in times) < 2 * len(WAYS) * len(SUBJECTS):
                status = 1
        if rows:
            rows = records.beside(rows, ("noise", "way"), "compiler")
            stamps.keep(options.out, rows, "; ".join(dict.fromkeys(used)), {"rounds": options.rounds}, kind=RECORD.name)
    except Failed as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    except (OSError, ValueError) as error:
        parser.error(str(error))
    return status
