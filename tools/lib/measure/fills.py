"""Fills of grids and lists by hashnoise::grid and by FastNoise2: for tools/measure cpu."""

from __future__ import annotations

import argparse
import fnmatch
import sys
from collections.abc import Iterator
from pathlib import Path

from base.cross_build import Build, Failed, Place, output_of
from base.tree import ROOT

RESULTS = ROOT / "docs" / "measured" / "results" / "cpu"
SOURCES = Path(__file__).with_name("grid")
POINTS = 1 << 20  # of a fill


def built(place: Place, folder: Path, source: str, *options: str) -> Path:
    """A program of SOURCES over the library, which is compiled into the folder."""
    build = Build(place, folder)
    build.library()
    return build.program(*(SOURCES / name for name in (source, "fills.cpp", "fast_noise.cpp")), options=options)


def library_named(word: str) -> str:
    """fastnoise2=FILE, with the whole path."""
    name, _, path = word.partition("=")
    if name not in ("fastnoise2", "strict") or not Path(path).is_file():
        raise argparse.ArgumentTypeError(f"{word} is not fastnoise2=FILE or strict=FILE, a shared library of FastNoise2")
    return f"{name}={Path(path).resolve()}"


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--against", type=library_named, action="append", default=[], metavar="fastnoise2=FILE",
                        help="also measure FastNoise2, in its shared library")
    parser.add_argument("--filter", action="append", default=[], metavar="GLOB",
                        help="only noises of these names, as in perlin2 or fbm_*; may be repeated")
    parser.add_argument("--note", default="", metavar="TEXT", help="for the record, such as the commit of FastNoise2")
    parser.add_argument("--out", type=Path, default=RESULTS, metavar="DIR", help="(docs/measured/results/cpu)")


def subjects(options: argparse.Namespace, *program: str | Path) -> Iterator[str]:
    """The wanted ones of a program's, each printed before it is measured."""
    names = output_of(*program).split()
    wanted = [name for name in names if not options.filter or any(fnmatch.fnmatchcase(name, glob) for glob in options.filter)]
    if not wanted:
        raise Failed(f"--filter leaves no noise; there are {', '.join(names)}")
    for name in wanted:
        print(name, file=sys.stderr, flush=True)
        yield name
