"""Compiles programs that call the C++ twin."""

from __future__ import annotations

import subprocess
from collections.abc import Iterable
from pathlib import Path

from base.tree import ROOT

# As the test suite builds the twin: without contraction, so that floats are the same on every machine.
COMPILER = ("g++", "-std=c++20", "-O2", "-ffp-contract=off")
SOON = ("-O1", "-Dalways_inline=unused")  # options for what is compiled longer than it runs, which then is about as fast


class NotBuilt(ValueError):
    pass


def compile_program(what: str, source: Path, program: Path, *options: str, include: Path = ROOT / "include",
                    macros: Iterable[str] = ()) -> None:
    """what: how messages call it; macros are like HN_HASH=1; options stand last, where libraries must."""
    command = [*COMPILER, *(f"-D{macro}" for macro in macros), "-I", str(include), str(source), "-o", str(program),
               *options]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise NotBuilt(f"g++ did not run: {error}") from error
    if done.returncode != 0:
        raise NotBuilt(f"{what} does not compile: {' '.join(command)}\n{done.stderr}")
