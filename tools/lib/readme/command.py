"""Makes what the pages show of the library: the README's picture, its table of typical values, and the table of costs.

    tools/readme            writes them
    tools/readme --check    whether they are what they should be, and the README states the costs

The picture is drawn from the code below it, which the C++ twin evaluates at each pixel of a tile. The typical values are
those of a million points. The costs are those of docs/results/llvmpipe/bench.csv, which hn-conform bench writes.

Exit status: 0 all is as it should be, 1 something is not: prose is for you to mend; 2 bad usage, the code does not
compile, or a page cannot be read.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from readme import numbers, picture
from tables.markdown import with_section
from tree import ROOT

README = "README.md"
MEASURING = "docs/measuring.md"


def pages() -> dict[str, str]:
    """What should be in each page, by its path."""
    texts = {path: (ROOT / path).read_text(encoding="utf-8") for path in (README, MEASURING)}
    typical, costs = numbers.typical_table(numbers.typical()), numbers.cost_table(numbers.costs())
    return {README: with_section(README, texts[README], "tools/readme: typical values", typical),
            MEASURING: with_section(MEASURING, texts[MEASURING], "tools/readme: costs", costs)}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="tools/readme", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args(arguments)
    try:
        wrong = []
        for path, text in pages().items():
            if options.check and (ROOT / path).read_text(encoding="utf-8") != text:
                wrong.append(f"{path}: a table is not what it should be; run tools/readme")
            elif not options.check:
                (ROOT / path).write_text(text, encoding="utf-8")
        readme = (ROOT / README).read_text(encoding="utf-8")
        quote = numbers.cost_quote(numbers.costs())
        if quote not in readme:
            wrong.append(f"{README}: it must state {quote!r}")
        print("\n".join(wrong), end="\n" if wrong else "", file=sys.stderr)
        return max(picture.draw(picture.tiles(readme), check=options.check), 1 if wrong else 0)
    except (OSError, LookupError, ValueError) as error:
        parser.exit(2, f"tools/readme: {error}\n")


if __name__ == "__main__":
    sys.exit(main())
