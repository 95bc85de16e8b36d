"""Injects every fault that drivers have had, and writes down which cases notice: docs/measured/faults.md.

    tools/make faults [--check] [--rows] [--program PATH] [--out FILE] [--jobs N] [NAME]...

First the healthy driver must pass the cases, or else everything would count as noticed. Then hn-conform runs them with
--inject for each fault (or for those named; then the file stays). A fault is noticed if the run is red, exit status 1,
and a case failed because a value is wrong; a shader that does not compile notices nothing. Each fault prints a line.

--check compares with the file instead of writing it. With names it injects these faults, and takes from the file what
the others turned red. With --rows it injects none, and compares what hn-conform prints of each without a run.

Exit status: 0 all were noticed (and the file is up to date), 1 some were not (or it is not), 2 bad usage, 3 the
unchanged driver does not pass, or hn-conform did not run.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from base.tree import HN_CONFORM as PROGRAM
from base.tree import ROOT
from base.usage import Parser

TABLE = ROOT / "docs" / "measured" / "faults.md"
TIMEOUT = 600  # seconds; a run takes a few

# Every bug, and every function with the default hash where it depends on one, in the version that most use; the
# octave sums in space stand for those in the plane, and the exact functions alone in ES, which has precisions. Cellular
# noise is left out: it takes as long as all others together, and has no step that they lack but the square root.
FILTERS = ("bugs*", "hash.*.lattice.*.gl330.golden", "hash.*.any.*.gl330.golden", "gradient.*.lattice*.gl330.golden",
           "noise?d.perlin*.lattice.*.gl330.golden", "noise?d.value*.lattice.*.gl330.golden",
           "noise?d.simplex*.lattice.*.gl330.golden", "fbm.fbm3.lattice.*.gl330.golden",
           "hash.lattice2.lattice.*.es300.golden", "hash.unorm.any.*.es300.golden",
           "noise2d.perlin.lattice.*.es300.golden")

HEAD = """# Faults of drivers, and what notices them

`tools/make faults` writes this page, but for sections below its table. It makes a healthy driver (llvmpipe, by OSMesa)
behave as if it had each fault that drivers have had: `hn-conform run --inject NAME` rewrites the code of every shader,
but not `glsl/`. Each fault fails the run, and the table names the functions whose cases fail. If only cases of `bugs`
fail, the library avoids the faulty operation on purpose.

A case gives a warning where a specification leaves the result open; the last column has those that warn here but not on
the healthy driver. If a specification allows the fault as it was reported, a worse fault is injected.

`hn-conform list --about --filter 'bugs*'` prints where each case of `bugs` was reported, and its specification.

"""


class NotRun(Exception):
    pass


@dataclass
class Told:
    name: str
    facts: dict[str, str] = field(default_factory=dict)


@dataclass
class Verdict:
    status: int
    failed: list[str]   # ids of cases in which a value is wrong
    broken: list[str]   # ids of cases that failed for another reason, with it
    warned: list[str]
    run: list[str]      # ids of all cases


def entries(program: Path, *arguments: str) -> list[Told]:
    """hn-conform's output: names, and below each indented lines such as "  injected: this"."""
    listed = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        raise NotRun(listed.stderr)
    names: list[Told] = []
    for line in listed.stdout.splitlines():
        if not line.startswith(" "):
            names.append(Told(line))
        else:
            key, _, value = line.strip().partition(": ")
            names[-1].facts[key] = value
    return names


def judge(program: Path, name: str) -> Verdict:
    """Runs the cases with a fault, or with none if the name is empty."""
    with tempfile.TemporaryDirectory() as out:
        command = [program, "run", "--driver", "osmesa", "--thorough", "--out", out]
        for glob in FILTERS:
            command += ["--filter", glob]
        if name:
            command += ["--inject", name]
        # One thread each (llvmpipe's own): the pictures are small, and several runs share the machine.
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=TIMEOUT,
                              env={**os.environ, "LP_NUM_THREADS": "0"})
        if done.returncode not in (0, 1):
            raise NotRun(f"status {done.returncode}: {done.stderr}")
        run, = json.loads((Path(out) / "results.json").read_text(encoding="utf-8"))["runs"]
    verdict = Verdict(done.returncode, [], [], [], [case["id"] for case in run["cases"]])
    for case in run["cases"]:
        if case["status"] == "warning":
            verdict.warned.append(case["id"])
        elif case["status"] == "fail" and case["mismatches"]:
            verdict.failed.append(case["id"])
        elif case["status"] not in ("pass", "unsupported"):
            verdict.broken.append(f"{case['id']}: {case['message']}")
    return verdict


def functions(ids: list[str]) -> str:
    """The functions of cases by their file: "**hash** word, vec2; **bugs** abs_of_int"."""
    files: dict[str, dict[str, None]] = {}
    for case in ids:
        file, function = case.split(".")[:2]
        files.setdefault(file, {})[function] = None
    return "; ".join(f"**{file}** {', '.join(names)}" for file, names in files.items())


def named(cell: str) -> set[str]:
    """The functions of a cell, as `functions` writes them: "hash.word", "bugs.abs_of_int"."""
    files = re.findall(r"\*\*(\w+)\*\* ([^;|]+)", cell)
    return {f"{file}.{name}" for file, names in files for name in names.strip().split(", ")}


def start_of_row(fault: Told) -> str:
    """The cells that hn-conform prints without a run."""
    injected = fault.facts["injected"]
    if "remark" in fault.facts:
        injected += f" ({fault.facts['remark']})"
    return f"| `{fault.name}`: {fault.facts['fault']} | {fault.facts['reported in']} | {injected} |"


def row(fault: Told, verdict: Verdict, healthy: Verdict) -> str:
    warned = functions([case for case in verdict.warned if case not in healthy.warned])
    return f"{start_of_row(fault)} {functions(verdict.failed)} | {warned} |\n"


def table(rows: list[str], warned: str) -> str:
    text = HEAD + "| fault | reported in | injected | what fails | what else warns |\n| --- | --- | --- | --- | --- |\n"
    text += "".join(rows)
    return text + f"\nOn the healthy driver, warnings are given by {warned}.\n"


def noticed(verdict: Verdict) -> bool:
    return verdict.status == 1 and bool(verdict.failed) and not verdict.broken


def describe(fault: Told, verdict: Verdict) -> str:
    if noticed(verdict):
        return f"{fault.name}: {functions(verdict.failed).replace('*', '')}"
    if verdict.broken:
        return f"{fault.name}: NOT JUDGED: {verdict.broken[0]}"
    return f"{fault.name}: NOT NOTICED"


def kept_row(fault: Told, path: Path) -> str:
    """The row of a fault that is not injected, as the file has it; none if it differs otherwise."""
    lines = path.read_text(encoding="utf-8").splitlines(keepends=True) if path.exists() else []
    return next((line for line in lines if line.startswith(start_of_row(fault))), f"| `{fault.name}` has no row |\n")


def by_hand(path: Path) -> str:
    """The text below the table: finds in translators, which nothing here makes."""
    found = re.search(r"\n## .*", path.read_text(encoding="utf-8"), re.DOTALL) if path.exists() else None
    return found[0] if found else ""


HEALTHY = re.compile(r"^On the healthy driver, warnings are given by (.*)\.$", re.MULTILINE)


def warnings_of_some_machine(healthy: Verdict, path: Path) -> str:
    """The functions that warn here without a fault, and those of the file that ran. Warnings are what specifications
    leave open, and llvmpipe compiles for the processor that it runs on: on some a negative float becomes another uint.
    So a machine that warns of less changes nothing; a warning that the file lacks is a difference."""
    kept = HEALTHY.search(path.read_text(encoding="utf-8")) if path.exists() else None
    before, here = named(kept[1]) if kept else set(), named(functions(healthy.warned))
    return functions([case for case in healthy.run if named(functions([case])) <= here | before])


def settle(text: str, path: Path, check: bool) -> int:
    """Writes the table, or returns whether the file is it."""
    if not check:
        path.write_text(text, encoding="utf-8")
        return 0
    if path.exists() and text == path.read_text(encoding="utf-8"):
        return 0
    print(f"{path} is not what tools/make faults writes now: run it", file=sys.stderr)
    return 1


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make faults", __doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="only these faults; the file stays")
    parser.add_argument("--check", action="store_true", help="compare with the file instead of writing it")
    parser.add_argument("--rows", action="store_true", help="with --check: inject none, compare what needs no run")
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--out", type=Path, default=TABLE)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args(arguments)
    if options.rows and (not options.check or options.names):
        parser.error("--rows goes with --check, and without names")
    try:
        faults = entries(options.program, "run", "--inject", "list")
        unknown = set(options.names) - {fault.name for fault in faults}
        if unknown:
            parser.error(f"there is no fault {', '.join(sorted(unknown))}; hn-conform run --inject list prints them")
        chosen = [fault for fault in faults if not options.names or fault.name in options.names]
        kept = {fault.name: kept_row(fault, options.out) for fault in faults}
        if options.rows:
            missing = [name for name, text in kept.items() if "has no row" in text]
            print(f"{options.out} lacks the rows of {missing}: run tools/make faults" * bool(missing))
            return int(bool(missing))
        with ThreadPoolExecutor(max(1, options.jobs)) as pool:
            healthy, *verdicts = pool.map(lambda name: judge(options.program, name),
                                          ["", *(fault.name for fault in chosen)])
    except (NotRun, OSError, subprocess.TimeoutExpired) as error:
        print(f"tools/make faults: hn-conform did not run: {error}", file=sys.stderr)
        return 3
    if healthy.status != 0:
        print(f"tools/make faults: without a fault, too, these fail: {healthy.failed + healthy.broken}",
              file=sys.stderr)
        return 3
    for fault, verdict in zip(chosen, verdicts):
        print(describe(fault, verdict))
    if not all(noticed(verdict) for verdict in verdicts):
        return 1
    if options.names and not options.check:
        return 0
    rows = {fault.name: row(fault, verdict, healthy) for fault, verdict in zip(chosen, verdicts)}
    text = table([rows.get(fault.name) or kept[fault.name] for fault in faults],
                 warnings_of_some_machine(healthy, options.out)) + by_hand(options.out)
    return settle(text, options.out, options.check)


if __name__ == "__main__":
    sys.exit(main())
