"""Weighs hashes and gradients for the default: writes docs/default-hash.md."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import page
from candidates import GRADIENTS, HASHES
from measure import NotMeasured, library, measure


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="tools/default-hash", description=__doc__)
    parser.add_argument("--program", type=Path, required=True, help="hn-conform (the command fills it in)")
    parser.add_argument("--out", type=Path, default=library.ROOT / "docs", metavar="DIR", help="for the page")
    parser.add_argument("--only", action="append", metavar="NAME", help="only this candidate, to the terminal "
                        "(repeatable)")
    parser.add_argument("--section", choices=("hashes", "gradients"), help="only these, and only their part of the page")
    parser.add_argument("--rounds", type=int, default=15, metavar="N", help="samples of each time")
    options = parser.parse_args(arguments)
    names = [candidate.name for candidate in HASHES + GRADIENTS]
    unknown = set(options.only or ()) - set(names)
    if unknown:
        parser.error(f"there is no candidate {', '.join(sorted(unknown))}; there are {', '.join(names)}")
    return options


def main(arguments: list[str]) -> int:
    options = parse(arguments)
    results = {}
    sections = {"hashes": HASHES, "gradients": GRADIENTS}
    for section, candidates in sections.items():
        for candidate in candidates:
            if options.section not in (None, section):
                continue
            if options.only and candidate.name not in options.only:
                continue
            try:
                results[candidate.name] = measure(candidate, options.program, options.rounds,
                                                   section == "gradients")
            except (NotMeasured, library.NotBuilt) as error:
                print(f"tools/default-hash: {error}", file=sys.stderr)
                return 1
            print(page.line(results[candidate.name]), flush=True)
    if not options.only:
        page.write(options.out, *([results[c.name] for c in sections[s] if c.name in results] for s in sections))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
