"""Compiles the program that searches for errors: search.cpp, with the text over lanes that round and in doubles."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from base.tree import CONFORMANCE, GLSL
from base.twin import compile_program
from proof.bounds import rounded
from proof.bounds.rounded import FIXED, Body, made, write_literal_text

HERE = Path(__file__).parent
DOUBLES = Path(rounded.__file__).with_suffix(".cpp")
# The functions need not be inlined, which takes long; the widest vectors of this machine do not change a bit.
SHARED = ("-O1", "-w", "-c", "-Dalways_inline=unused", f"-I{CONFORMANCE}", f"-I{HERE}")
LANES = ("-march=native", "-ffp-contract=off", "-frounding-math", "-Wno-psabi", f"-I{GLSL}", f"-I{GLSL / 'hashnoise'}")


@dataclass(frozen=True)
class Found:
    """The error that some outputs have in common."""
    error: float
    random: float  # the error of random places and roundings
    least: float  # of the exact values
    most: float
    words: tuple[int, ...]  # of the place


class Stopped(Exception):
    """The search ended early, and why."""


def search_object() -> Path:
    """search.cpp, which is the same for all."""
    source = HERE / "search.cpp"
    return made("search.o", SHARED, [*HERE.glob("*.hpp"), source, CONFORMANCE / "roundings" / "ways.hpp"],
                lambda folder: compile_program("the search of errors", source, folder / "new", *SHARED, "-O2"))


class Program:
    """Functions with these bodies; `text` is a file of a user's, for lanes and for doubles."""

    def __init__(self, bodies: Mapping[str, Body], *macros: str, text: str = ""):
        self.ids = list(bodies)
        code = "".join(f"FUNCTION({body.code})\n" for body in bodies.values())
        exact = [macro for macro in macros if macro != FIXED]

        def make(folder: Path) -> None:
            (folder / "rounded.inc").write_text(code, encoding="utf-8")
            (folder / "own.inc").write_text(text, encoding="utf-8")
            write_literal_text(folder / "doubles")
            parts = ((HERE / "lanes.cpp", LANES, macros), (DOUBLES, (f"-I{folder / 'doubles'}", "-fwrapv"), exact))
            with ThreadPoolExecutor() as pool:
                list(pool.map(lambda part: compile_program(
                    f"the search of errors ({part[0].name})", part[0], folder / f"{part[0].stem}.o", *SHARED, *part[1],
                    f"-I{folder}", macros=part[2]), parts))
            subprocess.run(["g++", *(folder / f"{part[0].stem}.o" for part in parts), search_object(), "-o", folder / "new"],
                           check=True)

        sources = [*HERE.glob("*.[ch]pp"), DOUBLES, Path(__file__), Path(rounded.__file__),
                   *(CONFORMANCE / "roundings").glob("*.hpp")]
        self.path = made("search", [*macros, code, text], sources, make)

    def search(self, id: str, inputs: Sequence[str], outputs: Sequence[str], effort: int, seed: int = 1) -> list[Found]:
        """Inputs and outputs as at the top of search.cpp."""
        found = []
        for line in self.run(id, inputs, outputs, effort, seed)[:-1]:
            error, random, least, most, *words = line.split()
            found.append(Found(float(error), float(random), float(least), float(most), tuple(map(int, words))))
        return found

    def operations(self, id: str, inputs: Sequence[str], outputs: Sequence[str], effort: int) -> int:
        """The most that round, in so short a search."""
        return int(self.run(id, inputs, outputs, effort, 1)[-1].split()[0])

    def run(self, id: str, inputs: Sequence[str], outputs: Sequence[str], effort: int, seed: int) -> list[str]:
        """The lines of search.cpp."""
        done = subprocess.run([self.path, str(self.ids.index(id)), str(seed), str(effort), *inputs, "/", *outputs],
                              capture_output=True, text=True, check=False)
        if done.returncode == 3:  # own.hpp
            raise Stopped("a loop has more than 100,000 rounds; --within NAME=LO:HI states the range of an argument")
        if done.returncode != 0:
            raise Stopped(f"the search ended with status {done.returncode}")
        return done.stdout.splitlines()
