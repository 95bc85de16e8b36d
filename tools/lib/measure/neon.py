"""Counts what hashnoise::grid costs with NEON, in instructions, on a machine that need not have it.

    tools/measure neon [--against fastnoise2=FILE] [--filter GLOB]... [--note TEXT] [--out DIR]

The library is compiled for ARM, which takes minutes, and fills the grids of tools/measure cpu. The emulator QEMU executes
that, and a plugin of it counts the instructions. FILE is the shared library of FastNoise2, compiled for ARM as well.
neon.csv goes into DIR: instructions a point of each noise. docs/measured/results/cpu has such a file; tools/make pages
makes the table of docs/measured/measuring.md of it.

It needs, of Debian 12: cmake, ninja-build, gcc, g++-aarch64-linux-gnu and qemu-user. tools/test installs them.

Exit status: 0 done, 1 something could not be counted, 2 bad usage, 4 it could not be built.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from base.cross_build import NEON, Failed, output_of
from base.tree import ROOT
from base.usage import Parser
from base.versions import version_of
from catalog.tables.markdown import table
from measure import fills, record, stamps

FOLDER = ROOT / "build" / "bench-neon"
COLUMNS = ("fast", "fixed", "precise", "FastNoise2")


class Counter:
    """Makes QEMU's plugin in a folder, where it leaves its numbers."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        output_of("gcc", "-std=c99", "-O1", "-shared", "-fPIC", fills.SOURCES / "count.c", "-o", folder / "count.so")

    def instructions(self, *command: str | Path) -> int:
        """All that a program executes from its start to its end."""
        number = self.folder / "number"
        number.unlink(missing_ok=True)
        qemu, *options = NEON.runner
        # By short names: a comma in a longer one would end it.
        done = subprocess.run([qemu, *options, "-plugin", f"./count.so,out={number.name}", *command], cwd=self.folder,
                              capture_output=True, text=True, check=False)
        if done.returncode or not number.is_file():
            raise Failed(done.stderr.strip() or f"{command[0]} ended with status {done.returncode}, without a number")
        return int(number.read_text(encoding="ascii"))

    def of_a_fill(self, filler: Path, *words: str) -> float:
        """For each point. The program fills a grid once, and twice. The rest of its instructions cancels."""
        once, twice = (self.instructions(filler, times, *words) for times in "12")
        if twice <= once:
            raise Failed(f"{' '.join(words)}: {once} instructions fill a grid once, and {twice} twice")
        return (twice - once) / fills.POINTS


def page_table(rows: Sequence[Mapping[str, str]]) -> str:
    """Instructions a point, and how many times those of hashnoise FastNoise2 needs."""
    columns = [name for name in COLUMNS if name in rows[0]]  # without --against there is no FastNoise2
    lines = [[f"`{row['noise']}`", *(record.three_digits(float(row[name])) for name in columns),
              *(f"{float(row[name]) / float(row['fast']):.2f}" for name in columns if name == "FastNoise2")]
             for row in rows if not row["noise"].startswith("ridged")]
    return table(("noise", *columns, *("fast : FastNoise2" for name in columns if name == "FastNoise2")), lines)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure neon", __doc__)
    fills.add_options(parser)
    options = parser.parse_args(arguments)
    try:
        filler = fills.built(NEON, FOLDER, "fill.cpp")
    except (Failed, OSError) as error:
        print(f"{parser.prog}: it could not be built: {error}", file=sys.stderr)
        return 4
    try:
        with TemporaryDirectory() as folder:
            counter = Counter(Path(folder))
            rows = [{"noise": noise} | {fill: f"{counter.of_a_fill(filler, fill, noise, *options.against):.4g}"
                                        for fill in COLUMNS if fill != "FastNoise2" or options.against}
                    for noise in fills.subjects(options, *NEON.runner, filler)]
    except Failed as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    emulator = re.search(r"version ([\d.]+)", output_of(NEON.runner[0], "--version"))
    stamps.keep(options.out / "neon.csv", rows, f"{version_of(NEON.compiler)}, QEMU {emulator[1] if emulator else ''}",
                {"note": options.note})
    return 0
