"""Searches for the largest errors of noises and octave sums: their text under other roundings.

    tools/make errors            searches for some 25 minutes, and writes tools/lib/proof/errors/record.csv; then run
                                 tools/make bounds, which takes the published errors from it
    tools/make errors --check    a search with a twentieth of the effort: no error is larger than a published one, or
                                 far from what the record has of this search
    tools/make errors FILE.glsl  measures functions of a file of yours that take a position or a place: the largest error
                                 that it found, where, and the values that it saw

results.py has what is searched, and search.cpp how.

Exit status: 0 all is as recorded, or measured; 1 something is not, or a function has a step that GLSL states no error of;
2 bad usage, or a file that cannot be read; 4 numpy, or a program that reads your file, is missing.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base.usage import Parser
from proof.errors import own, record, results
from proof.errors.program import Found, Program
from proof.errors.record import Entry, Key
from proof.errors.results import Search, is_kept

LONG, SHORT = 300_000, 15_000  # runs of 16 lanes for a function
SEEDS = (1, 3)  # of both long searches; the short one has 2
ALIKE = 0.8  # of what was recorded, this search finds at least


def programs(searches: Iterable[Search]) -> dict[tuple[str, ...], Program]:
    """One for each set of macros."""
    functions: dict[tuple[str, ...], dict[str, None]] = {}
    for search in searches:
        functions.setdefault(search.macros, {})[search.function] = None
    bodies = results.bodies()
    return {macros: Program({id: bodies[id] for id in some}, *macros) for macros, some in functions.items()}


def found_by(of_macros: Mapping[tuple[str, ...], Program], searches: Sequence[Search], effort: int, seed: int) -> dict[Key, float]:
    """The largest error of each key, on all cores."""
    bodies, largest = results.bodies(), {}

    def one(search: Search) -> list[Found]:
        body = bodies[search.function]
        return of_macros[search.macros].search(search.function, search.inputs(body), search.outputs(body), effort, seed)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for search, found in zip(searches, pool.map(one, searches)):
            for key, of_key in zip(search.groups, found):
                largest[key] = max(largest.get(key, 0.0), of_key.error)
    return largest


def searched() -> list[Search]:
    return [search for search in results.searches() if not any(key and is_kept(key) for key in search.keys)]


def new_record(long: Mapping[Key, float], short: Mapping[Key, float], old: Mapping[Key, Entry]) -> list[Entry]:
    """With the proven numbers of the old one."""
    kept = [key for key in old if is_kept(key)]
    return [Entry(key, old[key].proven if key in old else math.inf, long.get(key, math.nan), short.get(key, math.nan))
            for key in [*long, *kept]]


def wrong(short: Mapping[Key, float], entries: Mapping[Key, Entry]) -> list[str]:
    """A message for each key that the record lacks, or that has another error there than this search finds."""
    messages = [f"{key}: {record.PATH.name} has no row of it" for key in short if key not in entries]
    messages += [f"{key}: {record.PATH.name} has a row, and nothing searches it" for key in entries
                 if key not in short and not is_kept(key)]
    for key, error in short.items():
        entry = entries.get(key)
        if not entry:
            continue
        if error > entry.published:
            messages.append(f"{key}: an error of {error:.3g}, and the published one is {entry.published:.3g}")
        elif error < ALIKE * entry.short or ALIKE * error > max(entry.short, entry.found):
            messages.append(f"{key}: this search found {entry.short:.3g} when it was recorded, and finds {error:.3g}: the text "
                            "has changed, so run tools/make errors")
        if entry.found > entry.proven:
            messages.append(f"{key}: an error of {entry.found:.3g}, and 1.1.0 proved {entry.proven:.3g}")
    return messages


def run(options: argparse.Namespace) -> int:
    searches = searched()
    of_macros = programs(searches)
    short, entries = found_by(of_macros, searches, SHORT, 2), record.read()
    if not options.check:
        both = [found_by(of_macros, searches, LONG, seed) for seed in SEEDS]
        long = {key: max(found[key] for found in both) for key in short}
        record.PATH.write_text(record.text_of(new_record(long, short, entries)), encoding="utf-8")
        record.read.cache_clear()
        entries = record.read()
    if messages := wrong(short, entries):
        print("\n".join(messages))
        return 1
    near = sum(short[key] >= 0.8 * entries[key].found for key in short)
    print(f"{len(entries)} errors are as recorded; a twentieth of the effort finds 0.8 of {near} of {len(short)}")
    return 0


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make errors", __doc__)
    parser.add_argument("--check", action="store_true", help="write nothing, and compare with the record")
    parser.add_argument("file", nargs="?", type=Path, metavar="FILE.glsl", help="a file of yours")
    parser.add_argument("--function", action="append", default=[], metavar="NAME",
                        help="in place of those that no other function of the file calls; may be repeated")
    parser.add_argument("--within", action="append", default=[], metavar="NAME=LO:HI",
                        help="the range of an argument, or its value; else a position is in [-64, 64], another float in "
                             "[0, 1], and an integer any; may be repeated")
    options = parser.parse_args(arguments)
    if not options.file and (options.function or options.within) or options.file and options.check:
        parser.error("--function and --within are for a file of yours, and it takes no other option")
    within = dict(one.partition("=")[::2] for one in options.within)
    return own.report(options.file, options.function, within) if options.file else run(options)


if __name__ == "__main__":
    sys.exit(main())
