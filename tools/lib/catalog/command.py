"""Makes the tables of noises, sums and settings that the parts of the project have, from the one table of them,
catalog/.

    tools/make catalog            writes it
    tools/make catalog --check    whether it is up to date

A noise or a sum is one entry of catalog/noises.toml or sums.toml; the comments at their top state what the keys mean.
Files that are made state it at their top, and others have the made text between two marks. Text there that somebody
changed by hand is replaced, and the command prints its lines. It also writes the
version and the address of the project into the files that repeat them, which catalog/copies.py lists.

Exit status: 0 all is as it should be, 1 (--check) a file is not, 2 bad usage, or an entry that is wrong.
"""

from __future__ import annotations

import difflib
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from base.tree import ROOT
from base.usage import Parser
from catalog import copies, grid, javascript, pages, python, shaders
from catalog.model import CatalogError, read


def files() -> dict[Path, str]:
    """All that is made, by its path."""
    catalog = read()
    made = {**grid.files(catalog), **python.files(catalog), **javascript.files(catalog), **shaders.files(catalog),
            **pages.files(catalog)}
    return made | {ROOT / name: copies.made(name, made.get(ROOT / name) or (ROOT / name).read_text(encoding="utf-8"))
                   for name in copies.LINES}


def source(path: Path) -> str:
    """The file to change in place of a made one."""
    if path in (ROOT / shaders.SUMS, ROOT / shaders.STEPS):
        return "catalog/sums.toml"
    return "catalog/, or for the version and the address the file that has it" if (
        path.relative_to(ROOT).as_posix() in copies.LINES) else "catalog/"


def places(path: Path, made: str) -> Iterator[str]:
    """The lines of a file that were edited by hand, such as "glsl/hashnoise/fbm2d.glsl:130-132"."""
    name = path.relative_to(ROOT).as_posix()
    if not path.is_file():
        yield name
        return
    found = path.read_text(encoding="utf-8").splitlines(keepends=True)
    for change, first, last, *_ in difflib.SequenceMatcher(None, found, made.splitlines(keepends=True)).get_opcodes():
        if change != "equal":
            yield f"{name}:{first + 1}" + (f"-{last}" if last > first + 1 else "")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make catalog", __doc__)
    parser.add_argument("--check", action="store_true", help="write nothing")
    check = parser.parse_args(arguments).check
    try:
        made = files()
    except (CatalogError, LookupError, OSError) as error:
        parser.exit(2, f"tools/make catalog: {error}\n")
    other = [path for path, text in made.items() if not path.is_file() or path.read_text(encoding="utf-8") != text]
    for path in other:
        for place in places(path, made[path]):
            if check:
                print(f"{place}: it is not what the catalog makes; run tools/make catalog, or if it was edited by hand "
                      f"change {source(path)}: tools/make catalog replaces it", file=sys.stderr)
            else:
                print(f"{place}: replaced by what the catalog makes")
        if not check:
            path.write_text(made[path], encoding="utf-8")
    return 1 if check and other else 0


if __name__ == "__main__":
    sys.exit(main())
