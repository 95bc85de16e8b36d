"""Measures how random the hashes are, and what the noise shows of its lattice.

    tools/measure hashes                       every hash, every control, and noises, in minutes: writes quality.csv and
                                               directions.csv; tools/make pages makes docs/measured/quality.md of them
    tools/measure hashes --hash LATTICE --quick    one hash, in minutes: prints the verdict
    tools/measure hashes --against 'mine=noise.glsl:hash(p)'    a hash of a shader; with --out DIR writes hashes.csv

Exit status: 0 every hash passes, 1 one does not, 2 bad usage, 4 something could not be built or is not installed.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import chain
from pathlib import Path
from typing import NamedTuple

import numpy
import scipy

from base.renderer import Renderer
from base.tree import ROOT
from base.twin import NotBuilt
from base.usage import Parser
from measure import record, stamps
from measure.hashes import controls, fields, gate, library, others, streams, stripes
from measure.hashes.judgement import Finding, worst

RESULTS = ROOT / "docs" / "measured" / "results"
DIMENSIONS = (2, 3)


class Task(NamedTuple):
    """A hash in the plane or in space, for a process of its own."""
    hash: library.Twin | controls.Control
    dimensions: int
    effort: gate.Effort


def row(name: str, dimensions: int, part: str, findings: Sequence[Finding]) -> dict[str, str]:
    """Of a record: how many tests fail, and the most improbable one."""
    first = min(findings, key=lambda finding: finding.p)
    return {"hash": name, "dimensions": str(dimensions), "part": part,
            "failed": str(sum(not finding.passed for finding in findings)), "of": str(len(findings)),
            "worst": first.test, "statistic": f"{first.statistic:.4g}", "allowed": f"{first.limit:.4g}",
            "p": f"{first.p:.3g}"}


def measure(task: Task) -> tuple[Task, dict[str, list[Finding]]]:
    return task, dict(gate.judge(*task))


def measured(tasks: Iterable[Task]) -> Iterable[tuple[Task, dict[str, list[Finding]]]]:
    with ProcessPoolExecutor() as pool:
        for task, parts in pool.map(measure, tasks):
            findings = [*chain.from_iterable(parts.values())]
            print(verdict(f"{task.hash.name} {task.dimensions}D", findings), flush=True)
            yield task, parts


def verdict(head: str, findings: Sequence[Finding]) -> str:
    """Lines for the terminal: each test that fails, or the one that came nearest."""
    wrong = [finding for finding in worst(findings) if not finding.passed]
    if not wrong:
        return f"{head}: passes {len(findings)} tests; the nearest is {min(findings, key=lambda f: f.p)}"
    return "\n".join(f"{head}: FAILS {finding}" for finding in wrong)


def judge_others(options) -> int:
    """Judges hashes from shaders."""
    given = [(other.name, n) for other in options.against for n in other.dimensions]
    twice = next((each for each in given if given.count(each) > 1), None)
    if twice:
        name, n = twice
        options.parser.error(f"--against names {name} twice in {n}D: write {name}/2=... and {name}/3=...")
    renderer, rows = Renderer(others.SIDE), []
    for other in options.against:
        try:
            for n, origin, findings in others.judge(other, renderer):
                print(verdict(f"{other.name} {n}D at {origin}", findings), flush=True)
                rows.append(row(other.name, n, origin, findings))
        except others.BadExpression as error:
            options.parser.error(str(error))
    if options.out:
        write(options.out / "hashes.csv", rows, renderer.version)
    return int(any(one["failed"] != "0" for one in rows))


def write(path: Path, rows: Sequence[dict[str, str]], by: str) -> None:
    record.write(path, rows)
    stamps.stamp(path, by)


def twins(options, folder: Path) -> list[library.Twin]:
    names = library.hash_names()
    if unknown := {*options.hash} - {*names}:
        options.parser.error(f"there is no hash {', '.join(sorted(unknown))}; the library has {', '.join(names)}")
    macros = {name: [f"HN_HASH={names[name]}"] for name in options.hash or ([] if options.hash_fn else names)}
    if options.hash_fn:
        macros["CUSTOM"] = ["HN_HASH=HN_HASH_CUSTOM", f"HN_HASH_FN(k)=({options.hash_fn})"]
    return [library.build(name, some, folder) for name, some in macros.items()]


def traces(twin: library.Twin, subject: fields.Noise | tuple[float, ...] | str) -> list[fields.Measure]:
    """Of a noise, of the wave of stripes, or of a cut through octave sums."""
    if isinstance(subject, fields.Noise):
        return [*fields.look(twin, subject)]
    return [*(fields.sums(twin, subject) if isinstance(subject, str) else stripes.measure(twin.phasor, subject))]


def noises(twin: library.Twin) -> list[fields.Measure]:
    with ProcessPoolExecutor() as pool:
        return [*chain.from_iterable(pool.map(partial(traces, twin), (*fields.NOISES, *stripes.WAVES, *fields.CUTS)))]


def measure_all(options, every: Sequence[library.Twin]) -> int:
    """Writes the records."""
    tasks = [Task(twin, n, gate.FULL) for twin in every for n in DIMENSIONS]
    tasks += [Task(control, control.dimensions, gate.QUICK) for control in (controls.GOOD, *controls.CONTROLS)]
    rows, passed = [], True
    for task, parts in measured(tasks):
        if isinstance(task.hash, library.Twin):
            rows += [row(task.hash.name, task.dimensions, part, findings) for part, findings in parts.items()]
        else:
            findings = [*chain.from_iterable(parts.values())]
            rows.append(row(task.hash.about, task.dimensions, "all", findings))
            passed &= task.hash.rejected_as_meant(findings)
    default = next(twin for twin in every if twin.name == library.default_hash())
    shown = noises(default)
    for found in shown:
        if not found.passed:
            print(f"{found.noise} {found.dimensions}D FAILS {found.name}: {found.mean:.4f} (allowed {found.limit:g})")
    out = options.out or RESULTS
    write(out / "quality.csv", rows, versions())
    write(out / "directions.csv", [{"noise": one.noise, "dimensions": str(one.dimensions), "measure": one.name,
                                    "mean": f"{one.mean:.4f}", "error": f"{one.error:.4f}",
                                    "allowed": "" if one.limit is None else f"{one.limit:g}"} for one in shown],
          versions())
    hashes = [one for one in rows if one["part"] != "all"]
    return int(not passed or any(one["failed"] != "0" for one in hashes) or not all(one.passed for one in shown))


def versions() -> str:
    printed = subprocess.run([streams.PROGRAM, "-l"], capture_output=True, text=True, check=False).stdout
    tester = re.search(r"version ([0-9.]+)", printed)[1]
    return f"dieharder {tester}, numpy {numpy.__version__}, scipy {scipy.__version__}"


def run(options, folder: Path) -> int:
    every = twins(options, folder)
    if not (options.hash or options.hash_fn or options.quick):
        return measure_all(options, every)
    effort = gate.QUICK if options.quick else gate.FULL
    found = measured([Task(twin, n, effort) for twin in every for n in DIMENSIONS])
    return int(not all([finding.passed for _, parts in found for finding in chain.from_iterable(parts.values())]))


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = Parser("tools/measure hashes", __doc__)
    parser.add_argument("--hash", action="append", default=[], metavar="NAME",
                        help="a hash of the library (repeatable)")
    parser.add_argument("--hash-fn", metavar="EXPR", help="your own hash: an expression of the uint k")
    parser.add_argument("--quick", action="store_true", help="fewer windows, distances and numbers")
    parser.add_argument("--against", type=others.Other.parse, action="append", metavar="NAME[/2|/3]=FILE:EXPRESSION",
                        help="a hash of a shader: a uint, or a float in [0, 1), of c, an ivec2 and an ivec3, or of p, "
                        "the same as floats; with /2 or /3 only in the plane or in space (repeatable)")
    parser.add_argument("--out", type=Path, metavar="DIR", help="where records are written")
    options = parser.parse_args(arguments)
    options.parser = parser
    of_ours = options.hash or options.hash_fn or options.quick
    if options.against and of_ours:
        parser.error("--against goes without --hash, --hash-fn and --quick, which are for hashes of this library")
    if options.out and of_ours:
        parser.error("--out goes with --against, or alone: a record has every hash")
    return options


def main(arguments: list[str]) -> int:
    options = parse(arguments)
    if options.against:
        return judge_others(options)
    try:
        with tempfile.TemporaryDirectory() as folder:
            return run(options, Path(folder))
    except NotBuilt as error:
        print(f"{options.parser.prog}: {error}", file=sys.stderr)
        return 4


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
