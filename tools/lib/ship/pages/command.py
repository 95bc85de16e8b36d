"""Makes the pages' parts from the library: their pictures, the table of typical values, the tables of costs, which
file has which function, the size of all of them in one, and what packages for other programs have.

    tools/make pages            writes them
    tools/make pages --check    whether they are up to date, and the README states the costs

A picture is drawn from the code below it, which the C++ twin evaluates at each pixel of a tile; so are those of
docs/guide/gallery, and the sheet of the tutorial. The typical values are those of 2^16 points. Costs and randomness are
from the records of docs/measured/results, by the tables() of tools/lib/measure/tables.py.

Exit status: 0 all is as it should be, 1 something is not: prose is for you to mend; 2 bad usage, the code does not
compile, or a page cannot be read.
"""

from __future__ import annotations

import importlib
import re
import sys
from collections.abc import Iterable, Iterator, Sequence

from base.pieces import is_deleted
from base.tree import ROOT
from base.usage import Parser
from catalog.tables.markdown import with_section
from ship.pages import files, gallery, numbers, picture
from ship.website import live, pages

README = "README.md"
NOISES = "docs/reference/noises.md"
SUMS = "docs/reference/fractals.md"
LANGUAGES = "docs/guide/languages.md"
ENGINES = "docs/guide/engines.md"
SIZE = re.compile(r"(--strip --out noise\.glsl`, )\d+ kB")  # of the whole library, in the README


def of_measuring(part: str) -> Iterable:
    """The tables of records, or the quotes of them."""
    if is_deleted("measuring"):
        return ()
    from measure import tables as of_records
    return getattr(of_records, part)()


def of_packages() -> Iterator[tuple[str, str, str]]:
    """The tables of nodes on the pages of packages."""
    for path in sorted((ROOT / "tools" / "lib" / "ship").glob("*/files.py")):
        module = importlib.import_module(f"ship.{path.parent.name}.files")
        if hasattr(module, "node_table"):
            yield f"packages/{path.parent.name}/README.md", "tools/make pages: nodes", module.node_table()


def tables() -> list[tuple[str, str, str]]:
    """Made parts of pages: the page, the name of the marks, and the table."""
    typical = numbers.typical()
    return [("docs/README.md", "tools/make pages: index", pages.index()),
            (NOISES, "tools/make pages: values", numbers.typical_table(typical, numbers.COMMON)),
            (SUMS, "tools/make pages: typical values of sums", numbers.typical_table(typical, numbers.SUMS)),
            (SUMS, "tools/make pages: typical values of sums in 1D and 4D",
             numbers.typical_table(typical, numbers.PLAIN_SUMS, (1, 4))),
            (SUMS, "tools/make pages: footprint", numbers.footprint_quote(numbers.footprint())),
            (LANGUAGES, "tools/make pages: files", files.files_table()),
            (ENGINES, "tools/make pages: nodes", files.nodes_table()),
            *of_packages(), *of_measuring("tables")]


def problems(check: bool) -> list[str]:
    """Faults, after the tables are written, or with check as they are."""
    found = []
    for path, name, table in tables():
        page = (ROOT / path).read_text(encoding="utf-8")
        right = with_section(path, page, name, table)
        if not check:
            (ROOT / path).write_text(right, encoding="utf-8")
        elif page != right:
            found.append(f"{path}: the table of `{name}` is not what it should be; run tools/make pages")
    readme = (ROOT / README).read_text(encoding="utf-8")
    right = SIZE.sub(rf"\g<1>{files.size('hashnoise.glsl')}", readme)
    if not check:
        (ROOT / README).write_text(right, encoding="utf-8")
    elif right != readme:
        found.append(f"{README}: the size of the single file is not what it should be; run tools/make pages")
    found += [f"{README}: it must state {quote!r}"
              for quote in (numbers.golden_quote(), *of_measuring("quotes"))
              if quote not in readme]
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make pages", __doc__)
    parser.add_argument("--check", action="store_true", help="write nothing")
    options = parser.parse_args(arguments)
    try:
        found = problems(options.check)
        for problem in found:
            print(problem, file=sys.stderr)
        steps = live.in_cpp(live.PAGE.read_text(encoding="utf-8"))
        sheets = [*picture.of_pages(), *gallery.sheets(), live.sheet(steps)]
        return picture.draw(sheets, options.check, "\n".join([gallery.functions(), *steps.values()])) or bool(found)
    except (OSError, LookupError, ValueError) as error:
        parser.exit(2, f"tools/make pages: {error}\n")


if __name__ == "__main__":
    sys.exit(main())
