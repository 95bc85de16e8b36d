"""hashnoise::grid as other machines and compilers have it: compiled into a folder, which is kept, with programs over
it, and what runs these here."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.tree import ROOT


class Failed(Exception):
    """A program does not do its work; the text has its own words."""


class Place(NamedTuple):
    compiler: str
    runner: tuple[str, ...]  # what runs a program, and its options
    system: str = os.uname().sysname  # as CMake calls it
    flags: tuple[str, ...] = ()
    linked: tuple[str, ...] = ("-pthread",)
    configure: tuple[str, ...] = ("cmake",)

    def missing(self) -> list[str]:
        """The programs that are not here."""
        return [program for program in (self.compiler, *self.runner[:1]) if shutil.which(program) is None]


# With Debian's cross compiler, in Debian's emulator.
NEON = Place("aarch64-linux-gnu-g++", ("qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"), "Linux")


def output_of(*command: object, environment: Mapping[str, str] | None = None) -> str:
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, env=environment)
    if done.returncode != 0:
        raise Failed(f"{command[0]} ended with {done.returncode}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


class Build:
    def __init__(self, place: Place, folder: Path) -> None:
        self.place, self.folder = place, folder

    def library(self) -> None:
        """Compiles the library, as users get it, by as many jobs as this process may have cores."""
        print(f"{self.place.compiler} compiles hashnoise::grid: minutes, unless it has done so before", file=sys.stderr,
              flush=True)
        self.folder.mkdir(parents=True, exist_ok=True)
        # Read after CMake has found out which compiler it has; to that the flags are unknown. CMake compiles its checks
        # with the first, and with the second the flags are behind those of a build type.
        flags = self.folder / "flags.cmake"
        text = ' '.join(self.place.flags)
        flags.write_text(f'string(APPEND CMAKE_CXX_FLAGS " {text}")\nadd_compile_options({text})\n', encoding="utf-8")
        output_of(*self.place.configure, "-S", ROOT, "-B", self.folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                  f"-DCMAKE_SYSTEM_NAME={self.place.system}", f"-DCMAKE_CXX_COMPILER={self.place.compiler}",
                  f"-DCMAKE_PROJECT_hashnoise_INCLUDE={flags}", "-DHASHNOISE_CONFORMANCE=OFF", "-DHASHNOISE_TESTS=OFF",
                  "-DHASHNOISE_INSTALL=OFF")
        output_of("cmake", "--build", self.folder, "--target", "hashnoise-grid", "--parallel",
                  len(os.sched_getaffinity(0)))

    def program(self, *sources: Path, options: Sequence[str | Path] = ()) -> Path:
        """Compiles a program over the library, which has the name of its first source."""
        program = self.folder / f"{sources[0].stem}.{'js' if self.place.system == 'Emscripten' else 'exe'}"
        output_of(self.place.compiler, *self.place.flags, "-std=c++20", "-O1", "-I", ROOT / "include", *options,
                  *sources, self.folder / "src/grid/libhashnoise-grid.a", "-o", program, *self.place.linked)
        return program
