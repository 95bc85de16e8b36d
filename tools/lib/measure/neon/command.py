"""The command line of tools/measure neon, which describes it."""

from __future__ import annotations

import argparse
import fnmatch
import re
import shlex
import shutil
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from base.tree import GLSL, ROOT
from base.usage import Parser
from measure import record, stamps
from measure.elsewhere import NEON, Build, Failed, output_of
from measure.neon.counting import Counter, Refused, of_a_fill
from measure.neon.record import ARITHMETICS, OTHER, page

DESCRIPTION = """\
Counts what hashnoise::grid costs with NEON, in instructions, on a machine that need not have it.

    tools/measure neon [--against fastnoise2=FILE] [--filter GLOB]... [--note TEXT] [--out DIR] [--build DIR]

The library is compiled for ARM, which takes minutes, and fills the grids of tools/measure cpu with the same noises and
sums. The emulator QEMU executes that, and a plugin of it counts the instructions. FILE is the shared library of
FastNoise2, compiled for ARM as well. docs/measured/results/cpu/neon.md is such a page; neon.csv has the numbers.

It needs, of Debian 12: cmake, ninja-build, gcc, g++-aarch64-linux-gnu, qemu-user, libfmt-dev, libexpected-dev and
nlohmann-json3-dev. tools/test installs them.

Exit status: 0 done, 1 something could not be counted, 2 bad usage, 4 it could not be built, or a package is missing."""

FOLDER = ROOT / "build" / "bench-neon"
# The packages by their programs, and by their headers, which are the same for every processor.
PROGRAMS = {"cmake": "cmake", "ninja": "ninja-build", "gcc": "gcc", NEON.compiler: "g++-aarch64-linux-gnu",
            NEON.runner[0]: "qemu-user"}
HEADERS = {"fmt/format.h": "libfmt-dev", "tl/expected.hpp": "libexpected-dev",
           "nlohmann/json.hpp": "nlohmann-json3-dev"}
INCLUDE = Path("/usr/include")
SOURCES = ("src/bench_cpu/hn_fill.cpp", "src/bench_cpu/fast_noise.cpp", "src/bench_cpu/subjects.cpp",
           "src/base/text.cpp")


def missing() -> list[str]:
    """Packages that are to be installed."""
    return [*(package for program, package in PROGRAMS.items() if shutil.which(program) is None),
            *(package for header, package in HEADERS.items() if not (INCLUDE / header).is_file())]


def build(folder: Path) -> Path:
    """The program that fills grids, for ARM."""
    made = Build(NEON, folder)
    made.library()
    return made.program(*(ROOT / source for source in SOURCES),
                        options=("-DFMT_HEADER_ONLY", "-I", ROOT / "src"))


def command_of(options: argparse.Namespace) -> str:
    """As somebody else would call it: a file by its name, and not where it is here."""
    words = ["tools/measure", "neon"]
    if options.against:
        words += ["--against", f"fastnoise2={options.against.name}"]
    for glob in options.filter:
        words += ["--filter", glob]
    return shlex.join(words)


def library_named(word: str) -> Path:
    name, equals, path = word.partition("=")
    if name != "fastnoise2" or not equals or not path:
        raise argparse.ArgumentTypeError(f"{word}: it wants fastnoise2=FILE, the shared library of FastNoise2; there "
                                         "is no other library that it knows")
    if not Path(path).is_file():
        raise argparse.ArgumentTypeError(f"{path} is no file")
    return Path(path).resolve()


def count(program: Path, options: argparse.Namespace) -> record.Record | None:
    """Nothing if no subject is wanted."""
    first, *all_subjects = output_of(*NEON.runner, program, "--list").splitlines()
    points, step = first.split()
    subjects = [subject for subject in all_subjects
                if not options.filter or any(fnmatch.fnmatchcase(subject, glob) for glob in options.filter)]
    if not subjects:
        return None
    whats = {name: name for name in ARITHMETICS} | ({OTHER: f"fastnoise2={options.against}"} if options.against else {})
    rows = []
    with TemporaryDirectory() as folder:
        counter = Counter(Path(folder))
        for number, subject in enumerate(subjects):
            print(f"[{number}/{len(subjects)}] {subject}", file=sys.stderr, flush=True)
            rows.append({"noise": subject, **{name: str(of_a_fill(counter, program, what, subject))
                                              for name, what in whats.items()}})
    emulator = re.search(r"version ([\d.]+)", output_of(NEON.runner[0], "--version"))
    facts = {"date": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()), "command": command_of(options),
             "compiler": f"GCC {output_of(NEON.compiler, '-dumpfullversion').strip()}",
             "emulator": f"QEMU {emulator[1] if emulator else 'of an unknown version'}", "library": stamps.of_library(),
             stamps.TEXT: stamps.of_grid({}, GLSL),
             "note": options.note, "points": points, "step": step}
    return record.Record(facts, rows)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure neon", DESCRIPTION)
    parser.add_argument("--against", type=library_named, metavar="fastnoise2=FILE",
                        help="also count FastNoise2, in its shared library for ARM")
    parser.add_argument("--filter", action="append", default=[], metavar="GLOB",
                        help="only the subjects whose id matches this glob, as in perlin2 or fbm_*; may be repeated")
    parser.add_argument("--note", default="", metavar="TEXT",
                        help="a sentence for the page, such as the commit of FastNoise2")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "measured" / "results" / "cpu", metavar="DIR",
                        help="the folder for neon.md and neon.csv (default: docs/measured/results/cpu)")
    parser.add_argument("--build", type=Path, default=FOLDER, metavar="DIR",
                        help="where the library is built, and kept (default: build/bench-neon)")
    options = parser.parse_args(arguments)
    packages = missing()
    if packages:
        print(f"{parser.prog}: missing Debian packages: {' '.join(packages)}", file=sys.stderr)
        return 4
    try:
        options.out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        parser.error(f"--out: {error}")
    print(f"{parser.prog} compiles hashnoise::grid for ARM, unless it has done so before", file=sys.stderr,
          flush=True)
    try:
        program = build(options.build.resolve())
    except (Failed, OSError) as error:
        print(f"{parser.prog}: it could not be built: {error}", file=sys.stderr)
        return 4
    try:
        run = count(program, options)
    except Refused as error:
        parser.error(f"{error}; and it has to be compiled for ARM")
    except Failed as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    if run is None:
        parser.error("no subject matches --filter; the ids are like perlin2, cellular3 and fbm_simplex2, and * stands "
                     "for any part")
    try:
        record.write(options.out / "neon.csv", run.rows, facts=run.facts)
        (options.out / "neon.md").write_text(page(run), encoding="utf-8")
    except OSError as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 1
    print(f"{len(run.rows)} subjects counted: {options.out / 'neon.md'}")
    return 0
