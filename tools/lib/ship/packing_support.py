"""Shared parts of the packages' tests."""

from __future__ import annotations

import contextlib
import io
import os
import posixpath
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Iterable, Mapping
from pathlib import Path

from base.testing import SKIPPED
from base.tree import address
from ship import command
from translate.hlsl.compilers import missing as missing_compilers

# The defaults of nodes: usual values of docs/reference/frozen.md, and 8 by 8 cells as the period. A position has none.
DEFAULTS: dict[str, tuple[float, ...]] = {
    "Position": (), "Octaves": (6,), "Lacunarity": (2,), "Gain": (0.5,), "Jitter": (1,), "Metric": (1,), "Amplitude": (1,),
    "Seed": (0,), "Period": (8, 8), "Wave": (3, 0, 0), "Bandwidth": (0,), "Phase": (0,)}


def made(case: type[unittest.TestCase], name: str, *options: str) -> tuple[Path, Path]:
    """A folder for all tests of a class, and the package that tools/pack has made in it."""
    scratch = tempfile.TemporaryDirectory()
    case.addClassCleanup(scratch.cleanup)
    with contextlib.redirect_stdout(io.StringIO()) as out:
        command.main([name, *options, scratch.name])
    return Path(scratch.name), Path(out.getvalue().strip())


def lost_links(pages: Mapping[str, str], names: Iterable[str]) -> list[str]:
    """Links of these pages of a package that lead to no file in it, of those that lead nowhere else."""
    there = {posixpath.normpath(name) for name in names}
    found = []
    for path, page in pages.items():
        prose = re.sub(r"(?ms)^```.*?^```$|`[^`\n]*`", "", page)
        for link in re.findall(r"\]\(([^)#]+)[^)]*\)", prose):
            if "://" not in link and posixpath.normpath(posixpath.join(posixpath.dirname(path), link)) not in there:
                found.append(f"{path}: {link}")
    return found


def refusals(crate: Path, *words: str, path: str | None = None) -> list[str]:
    """Why crates.io would not take the crate of a folder: the faults that cargo package or cargo publish --dry-run
    reports, and the rules for keywords, which the server checks."""
    cargo = shutil.which("cargo", path=path)
    environment = {**os.environ, "PATH": path or os.environ["PATH"], "CARGO_TERM_COLOR": "never"}
    done = subprocess.run([cargo, *words, "--allow-dirty", "--no-verify"], cwd=crate, env=environment, capture_output=True,
                          text=True, check=False)
    found = [fault for fault in re.findall("(?m)^(?:error|warning: manifest has no).*", done.stderr)
             if address() or not fault.rstrip(".").endswith("has no documentation, homepage or repository")]
    keywords = re.search(r"(?m)^keywords = \[(.*)\]", (crate / "Cargo.toml").read_text(encoding="utf-8"))[1].split(", ")
    return found + [f"keyword {number}: {word}" for number, word in enumerate(keywords, 1)
                    if number > 5 or not re.fullmatch(r'"[A-Za-z][\w-]{,19}"', word)]


def run_with_compilers(test: str, needed: Mapping[str, str]) -> None:
    """Runs a class of tests of HLSL as a program: skipped without programs, which Debian's packages have, and with
    glslang alone without Microsoft's compilers."""
    if absent := [package for program, package in needed.items() if not shutil.which(program)]:
        print(f"skipped: Debian's packages {', '.join(absent)} are missing")
        sys.exit(SKIPPED)
    done = unittest.main(defaultTest=test, exit=False, verbosity=2).result
    if done.wasSuccessful() and missing_compilers():
        print(f"skipped, but for glslang: {missing_compilers()}")
        sys.exit(SKIPPED)
    sys.exit(not done.wasSuccessful())
