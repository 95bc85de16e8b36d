"""Shaders by a chip's compiler, in a process that may die of them."""

from __future__ import annotations

import json
import signal
import subprocess
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.debian import Missing

LIMIT = 120.0  # seconds without a new result


class Compiled(NamedTuple):
    """A compiled shader: its statistics, or the error."""
    statistics: Mapping[str, float]
    seconds: float  # of the processor
    problem: str = ""


class Device(NamedTuple):
    name: str
    driver: str


def compile_all(command: Sequence[str], environment: Mapping[str, str], files: Sequence[Path],
                done: Callable[[], None] = lambda: None, limit: float = LIMIT) -> tuple[Device, list[Compiled]]:
    """One result for each file, in order. A process that ends costs the shader where it ended; the next one goes on.

    The command is that of hn-conform shader-statistics, without the files.
    """
    results: list[Compiled] = []
    device = None
    while len(results) < len(files):
        # The first file stands before what is left to wake the driver, whose first shader takes longer.
        left = [files[0], *files[len(results):]]
        found, end, log = _one_process([*command, *map(str, left)], environment, done, limit)
        if len(found) < 2 or "error" in found[0] or "error" in found[1]:
            errors = [report["error"].splitlines()[0] for report in found if "error" in report]
            why = errors[0] if errors else f"the compiler {end}"
            if device is None:
                raise Missing(f"{why}{_last_line(log)}")
            results += [Compiled({}, 0.0, f"{why}{_last_line(log)}")] * (len(files) - len(results))
            break
        device = device or Device(found[0]["device"].strip(), found[0].get("driver", ""))
        results += [_compiled(report) for report in found[2:]]
        if len(results) < len(files):
            results.append(Compiled({}, 0.0, f"the compiler {end}{_last_line(log)}"))
    return device, results


def _compiled(report: Mapping) -> Compiled:
    if "error" in report:
        return Compiled({}, 0.0, report["error"].splitlines()[0])
    return Compiled(report["statistics"], report["seconds"])


def _one_process(command: Sequence[str], environment: Mapping[str, str], done: Callable[[], None],
                 limit: float) -> tuple[list[dict], str, str]:
    """Its report, its status, and its other output."""
    reports, killed = [], threading.Event()

    def kill() -> None:
        killed.set()
        process.kill()

    with (tempfile.TemporaryFile("w+", errors="replace") as log,
          subprocess.Popen(command, env=dict(environment), stdout=subprocess.PIPE, stderr=log, text=True,
                           errors="replace") as process):
        try:
            line = "\n"
            while line:
                timer = threading.Timer(limit, kill)
                timer.start()
                line = process.stdout.readline()
                timer.cancel()
                if (report := _report_in(line)) is not None:
                    reports.append(report)
                    if len(reports) > 2:
                        done()
        except BaseException:
            kill()
            timer.cancel()
            raise
        process.wait()
        log.seek(0)
        said = log.read()
    return reports, f"gave no answer for {limit:g} s" if killed.is_set() else end(process.returncode), said


def _report_in(line: str) -> dict | None:
    """Nothing if it is a line of the driver's own, or half of one that the end of the process cut off."""
    try:
        found = json.loads(line)
    except ValueError:
        return None
    return found if isinstance(found, dict) else None


def end(status: int) -> str:
    return f"ended by {signal.Signals(-status).name}" if status < 0 else f"ended with status {status}"


def _last_line(log: str) -> str:
    lines = [line.strip() for line in log.splitlines() if line.strip()]
    return f" ({lines[-1][:200]})" if lines else ""
