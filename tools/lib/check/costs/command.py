"""Measures what tests cost, and checks the table of it: tools/test --record calls this, and so does the test
costs.table.

    python3 -B -m check.costs.command record BUILD [options of ctest that choose tests]
    python3 -B -m check.costs.command check BUILD

Each test runs alone, and its processor time counts, with that of all processes that it starts. A machine that others
share is not always as fast: its speed is measured before and after each test that takes long. A record of all tests
makes this machine the one that the table speaks of. The tests should have run before, since what one makes another may
use. Exit status: 0 done, 1 a test failed and its row is as it was, or the
table is not right, 2 bad usage.
"""

from __future__ import annotations

import ctypes
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from base import costs
from base.tree import ROOT, TOOLS

TABLE = TOOLS / "costs.csv"
BUDGET = 900  # two cores, eleven minutes: two tests at a time take longer than one alone
# Programs that run without options, by its program in the build.
RUNS = {"conform": ("conformance/hn-conform", "run"), "bench": ("conformance/hn-conform", "bench"),
        "paper": ("conformance/hn-conform", "paper")}
OWN_TEST = "costs.table"
STEADY = 4.0  # seconds for which a measurement of the machine's speed holds
PR_SET_CHILD_SUBREAPER = 36  # of linux/prctl.h
LEFT = 5.0  # seconds that a process may take to end behind the test that started it


def listed(build: Path, *options: str) -> list[dict]:
    """The tests of a default run, by ctest. Tests that make fixtures come first."""
    command = ["ctest", "--test-dir", str(build), "--show-only=json-v1", *options]
    tests = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["tests"]
    # A program of gtest that is not built has none; and the test of the table fails until all others have their rows.
    known = [test for test in tests if "command" in test and test["name"] != OWN_TEST]

    def order(test: dict) -> tuple[bool, bool]:
        return "FIXTURES_SETUP" not in properties(test), "FIXTURES_REQUIRED" in properties(test)

    return sorted(known, key=order)


def properties(test: dict) -> dict:
    return {entry["name"]: entry["value"] for entry in test["properties"]}


def row_of(test: dict) -> str:
    """Its row: a program of gtest has one for all of its tests."""
    if any(argument.startswith("--gtest_filter=") for argument in test["command"]):
        return Path(test["command"][0]).name
    return test["name"]


def time_of_children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def calibration(loops: int = 1) -> float:
    """The processor time of the loop of tools/lib/base/progress.sh, of so many at a time; the least of some, because
    others may disturb it."""
    command = ["bash", "-c", 'root=$1; build=; log=; source "$root/tools/lib/base/progress.sh"; calibration "$2"', "bash", str(ROOT),
               str(loops)]
    return min(float(subprocess.run(command, capture_output=True, text=True, check=True).stdout) for _ in range(5))


class Clock:
    """Processor time on a machine whose speed drifts, as seconds on the machine of the table."""

    def __init__(self, there: float) -> None:
        self.there = there
        self.here = calibration()
        self.passed = 0.0

    def scaled(self, seconds: float) -> float:
        before, after = self.here, self.here
        self.passed += seconds
        if self.passed > STEADY:
            after = self.here = calibration()
            self.passed = 0.0
        return seconds * self.there / ((before + after) / 2)


def children() -> list[int]:
    return [int(pid) for pid in Path("/proc/thread-self/children").read_text(encoding="ascii").split()]


def wait_for_what_is_left() -> None:
    """Waits until no process is left of the test before: they are children of this one now."""
    end = time.monotonic() + LEFT
    while left := children():
        if time.monotonic() > end:
            for pid in left:
                os.kill(pid, signal.SIGKILL)
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            return
        time.sleep(0.02)


def with_interrupts() -> None:
    """ctest starts tests so. A job in the background of a shell ignores SIGINT, and so would all that it starts."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def cost_of(command: list[str], folder: str | None, environment: dict[str, str], log: Path) -> tuple[int, float]:
    """The status of a command, and its processor time."""
    before = time_of_children()
    with log.open("w", encoding="utf-8") as out:
        try:
            status = subprocess.run(command, cwd=folder, env={**os.environ, **environment}, stdout=out,
                                    stderr=subprocess.STDOUT, preexec_fn=with_interrupts, check=False).returncode
        except OSError as error:
            out.write(f"{command[0]}: {error.strerror}\n")
            status = 1
    wait_for_what_is_left()
    return status, time_of_children() - before


def kept_rows(build: Path, there: float) -> dict[tuple[str, str], float]:
    """The measurements of tools/lib/base/setup.sh and tools/test: installation, build from nothing, all tests; with
    how fast the machine was then, if it matters. In a folder of 0.3.0 the speed is missing, and no row counts."""
    path = build / "measured.csv"
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    rows = [row for row in (line.split(",") for line in lines) if len(row) == 4]
    return {(kind, name): float(value) * (there / float(here) if here else 1) for kind, name, value, here in rows}


def record(build: Path, path: Path, options: list[str]) -> int:
    table = costs.read_file(path)
    table.setdefault(("budget", "tests"), costs.Row(BUDGET))
    busy = calibration(os.cpu_count() or 1)  # as a build is; and so are two tests at a time, though one runs alone here
    if not options:
        table = costs.rebased(table, busy)
    there = table.setdefault(("speed", "loop"), costs.Row(busy)).value
    measured = kept_rows(build, there)
    tests = [] if "-N" in options else listed(build, *options)
    # Chromium's processes end behind that which started them, and nobody else counts their time.
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    failed = []
    log = build / "recorded.log"
    clock = Clock(there)
    for number, test in enumerate(tests):
        of_test = properties(test)
        environment = dict(entry.split("=", 1) for entry in of_test.get("ENVIRONMENT", []))
        status, seconds = cost_of(test["command"], of_test.get("WORKING_DIRECTORY"), environment, log)
        seconds = clock.scaled(seconds)
        skipped = status != 0 and status == of_test.get("SKIP_RETURN_CODE")
        print(f"[{number + 1}/{len(tests)}] {seconds:7.1f} s  {test['name']}"
              f"{' was skipped' if skipped else ' FAILED' if status else ''}", flush=True)
        key = ("test", row_of(test))
        if status and not skipped:
            failed.append(test["name"])
        elif not skipped or key not in table:  # what was measured elsewhere is more than nothing
            measured[key] = measured.get(key, 0) + seconds
    if not options:
        for name, (program, *arguments) in RUNS.items():
            with tempfile.TemporaryDirectory() as folder:
                command = [str(build / program), *arguments, "--out", f"{folder}/out"]
                # As on a machine that has run none before.
                status, seconds = cost_of(command, folder, {"MESA_SHADER_CACHE_DISABLE": "true"}, log)
            if status == 0:
                measured["run", name] = clock.scaled(seconds)
            else:
                failed.append(f"{program} {' '.join(arguments)}")
    everything = Counter(row_of(test) for test in listed(build))
    parts = [name for name, count in Counter(row_of(test) for test in tests).items() if count < everything[name]]
    for name in parts:  # of a program of gtest some tests are no measure of it
        measured.pop(("test", name), None)
    table = costs.updated(table, measured, everything)
    path.write_text(costs.written(table), encoding="utf-8")
    total = sum(row.value for row in costs.tests_of(table).values())
    print(f"The tests of a default run take {total:.0f} s of processor time; {table['budget', 'tests'].value:.0f} is the "
          f"budget. The table is {path}.")
    for name in parts:
        print(f"Only some tests of {name} were measured, and what it costs is not written.")
    for name in failed:
        print(f"{name} failed, and what it costs is not written.", file=sys.stderr)
    return 1 if failed else 0


def check(build: Path, path: Path) -> int:
    found = costs.problems(costs.read_file(path), {row_of(test) for test in listed(build)})
    for problem in found:
        print(f"{path}: {problem}", file=sys.stderr)
    return 1 if found else 0


def main(arguments: list[str]) -> int:
    if len(arguments) < 2 or arguments[0] not in ("record", "check"):
        print(__doc__, file=sys.stderr)
        return 2
    build = Path(arguments[1]).resolve()
    return record(build, TABLE, arguments[2:]) if arguments[0] == "record" else check(build, TABLE)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
