"""Finds stale parts, and makes them: ninja walks the graph, which is written for it into build/make/.

    python3 -m check.make.graph look|make PART    what ninja runs, in tools/lib

The times of a checkout mean nothing, so contents count. PART.made records the checksums of all that a part has, as they
were when it was made or found right. PART.look is written when they are others: then PART.made is older than what it is
made of.
"""

from __future__ import annotations

import hashlib
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from base import modules
from base.tree import ROOT, TOOLS
from check.make.parts import PARTS, Part

NOTHING_OF_IT = ("needs.py", "tree.py", "usage.py")  # no product depends on these modules
STATE = ROOT / "build" / "make"
GRAPH = """\
# Made by tools/make: its parts, in order.
rule look
  command = cd {lib} && {python} -B -m check.make.graph look $part
  restat = 1
rule make
  command = cd {lib} && {python} -B -m check.make.graph make $part
  pool = console
build always: phony
"""


class NotBuilt(Exception):
    """A program that a part runs is not there, or could not be built."""


# --- Properties of a part ---

def found(patterns: Sequence[str]) -> set[Path]:
    return {path for pattern in patterns for path in ROOT.glob(pattern) if path.is_file() and "_test." not in path.name}


def inputs(part: Part) -> set[Path]:
    given = found(part.inputs)
    code = {path for path in given if path.suffix == ".py"} | {modules.path_of(part.module)}
    return given | {path for path in modules.files_of(code) if path.name not in NOTHING_OF_IT}


def own(part: Part, text: bytes) -> bytes:
    """The part of a product that this part writes: the text between its marks, or all of it."""
    mark = rf"tools/make {part.name}: ".encode()
    between = re.findall(mark + rb"(?!end\b)[^\n]*\n(.*?)(?:<!-- end -->|" + mark + rb"end\b)", text, re.DOTALL)
    return b"".join(between) or text


def products(part: Part) -> dict[str, str]:
    return {path.relative_to(ROOT).as_posix(): hashlib.sha256(own(part, path.read_bytes())).hexdigest()
            for path in found(part.products)}


def state(part: Part) -> dict[str, str]:
    """The checksum of each file that the part is made of, or that it makes."""
    given = {path.relative_to(ROOT).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in inputs(part)}
    return {**products(part), **given}


def needs(parts: Sequence[Part]) -> dict[str, list[Part]]:
    """For each part the ones above it that write its inputs or outputs."""
    above: list[tuple[Part, set[Path]]] = []
    needed = {}
    for part in parts:
        written = found(part.products)
        reads = inputs(part) | written
        needed[part.name] = [other for other, files in above if files & reads]
        above.append((part, written))
    return needed


# --- The record of right products ---

def path(part: Part, ending: str) -> Path:
    return STATE / f"{part.name}.{ending}"


def text_of(sums: dict[str, str]) -> str:
    return "".join(f"{value} {name}\n" for name, value in sorted(sums.items()))


def recorded(part: Part) -> dict[str, str] | None:
    try:
        lines = path(part, "made").read_text(encoding="utf-8").splitlines()
    except FileNotFoundError:
        return None
    return {name: value for value, _, name in (line.partition(" ") for line in lines)}


def record(part: Part) -> None:
    STATE.mkdir(parents=True, exist_ok=True)
    path(part, "made").write_text(text_of(state(part)), encoding="utf-8")


def changed(part: Part) -> list[str]:
    """The files that are not as recorded, in words; none if there is no record."""
    before, now = recorded(part), state(part)
    if before is None:
        return []
    how = {name: "is new" if name not in before else "is gone" if name not in now else "changed"
           for name in sorted({*before, *now}) if before.get(name) != now.get(name)}
    return [f"{name} {word}" for name, word in how.items()]


def few(items: Sequence[str], count: int = 1) -> str:
    more = len(items) - count
    return ", ".join(items[:count]) + (f", and {more} more" if more > 0 else "")


# --- To look, and to make ---

def call(part: Part, *options: str, quiet: bool = False) -> tuple[int, str]:
    """The exit status of the part's own command, and, if it is quiet, its output."""
    done = subprocess.run([TOOLS / "make", part.name, *options], cwd=ROOT, text=True, check=False,
                          stdout=subprocess.PIPE if quiet else None, stderr=subprocess.STDOUT if quiet else None)
    return done.returncode, done.stdout or ""


def build(part: Part, anew: bool = True) -> None:
    """Brings the program that a part runs up to date."""
    folder = ROOT / "build"
    if not part.program:
        return
    if not (folder / "CMakeCache.txt").is_file():
        if anew:
            print(f"{part.name}: it runs {part.program}; tools/test -N builds that and all else first", flush=True)
        if not anew or subprocess.run([TOOLS / "test", "-N"], stdout=subprocess.DEVNULL, check=False).returncode != 0:
            raise NotBuilt(f"it runs {part.program}, which tools/test -N builds")
    done = subprocess.run(["cmake", "--build", folder, "--target", part.program], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise NotBuilt(f"{part.program} could not be built: {(done.stdout + done.stderr).strip()}")


def look(part: Part) -> None:
    """Asks ninja for the part if something is not as recorded."""
    now = text_of(state(part))
    if not path(part, "look").is_file() or recorded(part) is None or text_of(recorded(part)) != now:
        path(part, "look").write_text(now, encoding="utf-8")


def make(part: Part) -> int:
    """Makes a part that differs from its record. Where there is no record, as in a new clone, its check decides
    first."""
    why, before = changed(part), products(part)
    try:
        if recorded(part) is None:
            build(part)
            status, said = call(part, *part.check, quiet=True)
            if status == 0:
                record(part)
                print(f"{part.name}: it is as it should be", flush=True)
                return 0
            why = said.strip().splitlines() or [f"its check ended with status {status}"]
            if "Traceback (most recent call last)" in said:
                why = why[-1:]  # the error
        elif not why:
            record(part)
            return 0
        print(f"{part.name}: {few(why)}. It takes {part.takes}", flush=True)
        build(part)
    except NotBuilt as reason:
        print(f"tools/make: {part.name}: {reason}", file=sys.stderr)
        return 4
    status, _ = call(part, *part.options)
    if status == 0:
        record(part)
        now = products(part)
        written = sorted(name for name in {*before, *now} if before.get(name) != now.get(name))
        print(f"{part.name}: it wrote {few(written, 5)}" if written else f"{part.name}: nothing changed", flush=True)
    return status


def check(parts: Sequence[Part]) -> int:
    """Prints which parts are stale; 1 if one is."""
    stale = 0
    for part in parts:
        if recorded(part) is not None and not changed(part):
            continue
        print(f"{part.name}: comparing; to make it takes {part.takes}", file=sys.stderr, flush=True)
        try:
            build(part, anew=False)
        except NotBuilt as reason:
            print(f"{part.name}: nobody looked: {reason}", file=sys.stderr)
            continue
        status, said = call(part, *part.check, quiet=True)
        if status != 0:
            stale = 1
            print(f"{part.name} is stale:", *(f"  {line}" for line in said.strip().splitlines()), sep="\n")
        elif not part.sample:
            record(part)
    return stale


# --- The graph ---

def graph(parts: Sequence[Part]) -> str:
    def word(text: object) -> str:
        return shlex.quote(str(text)).replace("$", "$$")

    text = GRAPH.format(lib=word(modules.LIB), python=word(sys.executable))
    needed, by_program = needs(parts), {part.name for part in parts if part.program}
    # Parts that need a build come last: ninja begins with the first of the file.
    for name, others in sorted(needed.items(), key=lambda item: item[0] in by_program):
        before = " ".join(f"{other.name}.made" for other in others)
        text += (f"build {name}.look: look always{' || ' + before if before else ''}\n  part = {name}\n"
                 f"build {name}.made: make {name}.look\n  part = {name}\n")
    return text


def walk(parts: Sequence[Part]) -> int:
    """Makes the stale parts, each behind those that it needs."""
    ninja = shutil.which("ninja")
    if ninja is None:
        print("tools/make: there is no ninja; Debian's package is ninja-build", file=sys.stderr)
        return 4
    STATE.mkdir(parents=True, exist_ok=True)
    file = STATE / "build.ninja"
    text = graph(parts)
    if not file.is_file() or file.read_text(encoding="utf-8") != text:
        file.write_text(text, encoding="utf-8")
    status = subprocess.run([ninja, "--quiet", "-k", "0", "-C", STATE], check=False).returncode
    left = [part.name for part in parts if recorded(part) is None or changed(part)]
    if status == 0 and not left:
        print("Everything is as it should be.")
        return 0
    print(f"tools/make: these are not made: {', '.join(left)}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    step, name = sys.argv[1:]
    chosen = next(part for part in PARTS if part.name == name)
    sys.exit(look(chosen) if step == "look" else make(chosen))
