"""Makes the files that a change made stale.

    tools/make                    all that is stale, in order; it prints what and why
    tools/make --check            makes nothing, and prints the stale parts
    tools/make PART PART...       these parts, in order, whether they are stale or not; with --check, which are stale
    tools/make PART [OPTION...]   a part, with options of its own, which tools/make PART --help lists

A part is stale if a file that it is made of, the code that makes it, or its product is not as it was when it was last
made; build/make/ records that. Where there is no record, as in a new clone, the part itself compares the file with
its own text. For golden, freeze and faults that is a sample, as in tools/test, so --check takes six
minutes at first, and seconds when it is run again. Parts that run a program of build/ are left out of --check where
there is none.

{parts}

Exit status: 0 done, or nothing is stale; 1 a part could not be made, or (--check) one is stale; 2 bad usage; 4 there is
no ninja. With one part it is the part's, which its --help lists.
"""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
from collections.abc import Iterable, Sequence

from base.tree import TOOLS
from base.usage import near
from check.make import graph
from check.make.parts import PARTS, Part

NAMES = {part.name: part for part in PARTS}
CHECK = "--check"


def described() -> str:
    notes = {True: "; only where it is named", False: ""}
    return "\n".join(f"    {part.name:11}{part.what}{notes[part.by_name]}" for part in PARTS)


def refused(kind: str, word: str, known: Iterable[str]) -> int:
    print(f"tools/make: there is no {kind} {word}{near(word, known)}; tools/make --help lists them", file=sys.stderr)
    return 2


def run(part: Part, options: Sequence[str]) -> int:
    """The part's own command."""
    if part.scientific:
        status = subprocess.run([TOOLS / "lib" / "base" / "scientific-python", "-m", part.module, *options], check=False,
                                env={**os.environ, "HN_COMMAND": f"make {part.name}"}).returncode
    else:
        status = importlib.import_module(part.module).main(options)
    if status == 0 and tuple(options) == part.options and not part.by_name:
        graph.record(part)
    return status


def named(parts: Sequence[Part]) -> int:
    for part in parts:
        print(f"{part.name}: it takes {part.takes}", flush=True)
        if graph.call(part, *part.options)[0] != 0:
            return 1
    return 0


def main(arguments: Sequence[str] | None = None) -> int:
    words = list(sys.argv[1:] if arguments is None else arguments)
    others = [word for word in words if word != CHECK]
    if words and words[0] in NAMES and not (len(others) > 1 and all(word in NAMES for word in others)):
        return run(NAMES[words[0]], words[1:])
    if words and words[0] in ("--help", "-h", "help"):
        print(__doc__.format(parts=described()).strip())
        return 0
    for word in others:
        if word not in NAMES:
            is_option = word.startswith("-")
            return refused("option" if is_option else "part", word, (CHECK, "--help") if is_option else NAMES)
    parts = [part for part in PARTS if not others or part.name in others]
    if CHECK in words:
        return graph.check([part for part in parts if part.check])
    return named(parts) if others else graph.walk([part for part in parts if not part.by_name])


if __name__ == "__main__":
    sys.exit(main())
