"""Keeps what never changes: names, parameters and defaults, bounds, and checksums of a million values of each function
with HN_FIXED, and of each hash. docs/reference/frozen.md states the promise.

    tools/make freeze                        adds missing entries, and freezes functions that are no longer experimental
    tools/make freeze --check [--all]        holds the library to the table, at 2,048 points of each function, or at
                                             all
    tools/make freeze --provisional NAME...  makes the entries of these experimental functions anew

The table of values is conformance/expected/frozen.csv. An entry that exists is never written again, and where one is
wrong nothing is written. Only --provisional replaces entries, and it is refused for all functions but those that
catalog/functions.toml calls experimental. A NAME is that of functions in the table, such as 'noise2d.gullies*'. The
values are those of hn-frozen, which tools/test builds. After a change of glsl/ check with --all: the 2,048 points may
have none that the change touches.

The table of everything else is conformance/expected/interface.csv. Its rows stay, too; only a bound may become smaller.

All entries take about eight minutes of processor time.

Exit status: 0 written, or all is as it was; 1 something is not, and nothing is written; 2 bad usage, or the program or
the table cannot be read.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path

from base.tree import FROZEN, INTERFACE, ROOT, version
from base.usage import Parser
from catalog.tables.functions import read_functions
from check.frozen import interface, table
from check.frozen.table import ALL, FIRST, PROVISIONAL, Entry, Key, Sums

PROGRAM = ROOT / "build" / "conformance" / "hn-frozen"


class NoProgram(Exception):
    """The file that computes the values does not."""


def sums_of(program: Path, count: int, functions: Sequence[str] = ()) -> dict[Key, Sums]:
    """The library's values, as hn-frozen computes them."""
    try:
        done = subprocess.run([program, str(count), *functions], capture_output=True, text=True, check=False)
    except OSError as error:
        raise NoProgram(f"{program} does not run: {error.strerror}; tools/test -N builds it") from error
    if done.returncode != 0:
        raise NoProgram(f"{program} ended with status {done.returncode}: {done.stderr.strip()}")
    return table.parse_sums(done.stdout)


def new_entries(program: Path, keys: set[Key], since: str) -> dict[Key, Entry]:
    """One function at a time, so that whoever waits sees how far it is."""
    made = {}
    functions = sorted({function for function, _ in keys})
    for number, function in enumerate(functions, 1):
        print(f"\r{number} of {len(functions)}: {function:40}", end="" if number < len(functions) else "\n",
              file=sys.stderr, flush=True)
        first, every = (sums_of(program, count, [function]) for count in (FIRST, ALL))
        made |= {key: Entry(since, {FIRST: first[key], ALL: every[key]}) for key in first if key in keys}
    return made


def experimental() -> frozenset[str]:
    """The functions whose values may change from 1.0 on, too."""
    return frozenset(function.id for function in read_functions() if function.experimental)


def added(entries: Mapping[Key, Entry], program: Path, of: str) -> tuple[dict[Key, Entry], list[str]]:
    """The entries with those that are missing, and what hinders that."""
    first = sums_of(program, FIRST)
    stays = {key for key in first.keys() | entries.keys() if key[0] not in experimental()}
    settled = {key for key, entry in entries.items() if key in stays and not entry.is_frozen}
    wrong = [*table.changed(entries, first, FIRST), *table.gone(entries, first)]
    if wrong:
        return {}, wrong
    missing = first.keys() - entries.keys()
    made = new_entries(program, settled | (missing & stays), of) | new_entries(program, missing - stays, PROVISIONAL)
    anew = {key: made[key].sums[ALL] for key in settled}
    return {**entries, **made}, list(table.changed(entries, anew, ALL))


def is_named(key: Key, names: Sequence[str]) -> bool:
    return any(fnmatchcase(key[0], name) for name in names)


def replaced(entries: Mapping[Key, Entry], program: Path,
             names: Sequence[str]) -> tuple[dict[Key, Entry], list[str]]:
    """The entries with those of some functions made anew; and which names there are not."""
    known = set(sums_of(program, 1))
    unknown = [f"there is no function {name}" for name in names
               if not any(fnmatchcase(function, name) for function, _ in known | entries.keys())]
    if unknown:
        return {}, unknown
    kept = {key: entry for key, entry in entries.items() if not is_named(key, names)}
    return kept | new_entries(program, {key for key in known if is_named(key, names)}, PROVISIONAL), []


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make freeze", __doc__)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="print what is not as it was")
    what.add_argument("--provisional", action="store_true", help="make entries of experimental functions anew")
    parser.add_argument("--all", action="store_true", help="with --check: at all points")
    parser.add_argument("--program", type=Path, default=PROGRAM, metavar="PATH",
                        help="hn-frozen (default: %(default)s)")
    parser.add_argument("--table", type=Path, default=FROZEN, metavar="PATH",
                        help="the table (default: %(default)s)")
    parser.add_argument("names", nargs="*", metavar="NAME", help="with --provisional: functions of the table")
    given = parser.parse_args(arguments)
    if given.all and not given.check:
        parser.error("--all goes with --check")
    if bool(given.names) != given.provisional:
        parser.error("a NAME goes with --provisional, and --provisional with a NAME")
    try:
        missing = [path for path in (given.table, INTERFACE) if not path.exists()]
        if given.check and missing:
            raise ValueError(f"there is no {missing[0]}; tools/make freeze writes it")
        entries = {} if given.table in missing else table.read(given.table)
        rows, names = interface.library(), {} if INTERFACE in missing else interface.read(INTERFACE)
        stay = sorted({key[0] for key in entries if is_named(key, given.names)} - experimental())
        if stay:
            parser.error(f"the values of {stay[0]} stay, since it is not experimental. docs/reference/frozen.md describes "
                         "how a mistake is corrected")
        if given.check:
            count = ALL if given.all else FIRST
            wrong = table.problems(entries, sums_of(given.program, count), count, version(), experimental())
        elif given.provisional:
            entries, wrong = replaced(entries, given.program, given.names)
        else:
            entries, wrong = added(entries, given.program, version())
        wrong += interface.changed(names, rows)
        wrong += interface.stale(names, rows) if given.check else []
        for message in wrong:
            print(message, file=sys.stderr)
        if wrong:
            return 1
        if not given.check:
            given.table.write_text(table.text_of(entries), encoding="ascii")
            INTERFACE.write_text(interface.text_of(rows), encoding="utf-8")
    except (NoProgram, ValueError, OSError) as error:
        parser.exit(2, f"tools/make freeze: {error}\n")
    print(f"{len(entries)} entries are {'right' if given.check else f'in {given.table}'}, and {len(rows)} names")
    return 0


if __name__ == "__main__":
    sys.exit(main())
