"""Starts hn-conform for commands that make something of its records."""

from __future__ import annotations

import argparse
import signal
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from base.tree import GLSL
from measure import record, stamps

BENCH = "bench.csv"
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def run(command: Sequence[str]) -> int:
    """The exit status. A signal ends the program, and not the command that waits for its last words."""
    with subprocess.Popen(command) as process:
        # A terminal sends Ctrl-C to both.
        handlers = [signal.signal(number, signal.SIG_IGN if number == signal.SIGINT else
                                  lambda number, _: process.send_signal(number)) for number in SIGNALS]
        try:
            status = process.wait()
        finally:
            for number, handler in zip(SIGNALS, handlers):
                signal.signal(number, handler)
    return status if status >= 0 else 128 - status


def library(options: Sequence[str]) -> Path:
    """The copy of glsl/hashnoise/ that these options name; that here if they name none."""
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--glsl", type=Path, default=GLSL)
    return parser.parse_known_args(options)[0].glsl


def bench(program: str, out: Path, options: Sequence[str]) -> tuple[int, Mapping[str, str]]:
    """Leaves bench.csv. The status of hn-conform bench, and all that it states of this machine."""
    status = run([program, "bench", "--out", str(out), *options])
    if status not in (0, 1) or not (out / BENCH).is_file():
        return status, {}
    facts = record.read(out / BENCH).facts
    stamps.stamp(out / BENCH, library=library(options))
    return status, facts
