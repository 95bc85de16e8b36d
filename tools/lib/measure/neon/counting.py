"""Counts the instructions that a program for ARM executes, and those of a fill."""

from __future__ import annotations

import subprocess
from pathlib import Path

from measure.elsewhere import NEON, Failed, output_of

PLUGIN = Path(__file__).resolve().with_name("count.c")
BAD_USAGE = 2  # the status of hn-fill for a file that is no FastNoise2


class Refused(Exception):
    """The file is no FastNoise2 for ARM; the text is hn-fill's own."""


class Counter:
    """Makes QEMU's plugin in a folder, where it leaves its numbers."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        output_of("gcc", "-std=c99", "-O1", "-shared", "-fPIC", PLUGIN, "-o", folder / "count.so")

    def instructions(self, program: Path, *arguments: str) -> int:
        """All that a program executes from its start to its end."""
        number = self.folder / "number"
        number.unlink(missing_ok=True)
        qemu, *options = NEON.runner
        # By short names: a comma in a longer one would end it.
        done = subprocess.run([qemu, *options, "-plugin", f"./count.so,out={number.name}", program, *arguments],
                              cwd=self.folder, capture_output=True, text=True, check=False)
        if done.returncode:
            raise (Refused if done.returncode == BAD_USAGE else Failed)(
                done.stderr.strip() or f"{program.name} ended with status {done.returncode}")
        try:
            return int(number.read_text(encoding="ascii"))
        except (OSError, ValueError) as error:
            raise Failed(f"{qemu} ran {program.name}, and its plugin left no number: {error}") from error


def of_a_fill(counter: Counter, program: Path, what: str, subject: str) -> int:
    """The program fills a grid once, and twice. The rest of its instructions is the same, and cancels."""
    once, twice = (counter.instructions(program, what, subject, times) for times in "12")
    if twice <= once:
        raise Failed(f"{subject}, {what}: {once} instructions fill a grid once, and {twice} twice")
    return twice - once
