"""Checks digests of results, which people send of their devices, and makes the page of them.

    tools/make results [PATH...]              checks files, or folders of nothing else (default:
                                              docs/measured/results/devices), and writes build/results/index.html
    tools/make results --page DIR [PATH...]   the same, but it writes DIR/index.html
    tools/make results --check [PATH...]      checks them
    tools/make results --freeze               before a release: keeps the checksums of this version in
                                              docs/measured/results/devices/versions/, by which its digests are checked
                                              when the golden files are others

docs/reference/formats.md defines a digest. Its checksums are computed once more from the golden files. With --earlier a
digest may be of other golden files of the same version, as those are that were sent before the last change of values;
the page leaves it out.

Exit status: 0 all are right, 1 one is refused, 2 bad usage, or a file cannot be written.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from base.tree import GOLDEN, ROOT, version
from base.usage import Parser
from measure.results import page
from measure.results.digest import Digest, Earlier, Refused, read, shown
from measure.results.sets import FrozenSets, GoldenSets, Sets, write

RESULTS = ROOT / "docs" / "measured" / "results" / "devices"
VERSIONS = RESULTS / "versions"
OTHERS = ("README.md", "versions")  # of the folder of results
PAGE = ROOT / "build" / "results"


def known_versions(folder: Path = VERSIONS) -> dict[str, Sets]:
    """The frozen versions, and this one."""
    versions: dict[str, Sets] = {path.stem: FrozenSets(path) for path in sorted(folder.glob("*.csv"))}
    return {**versions, version(): GoldenSets(GOLDEN)}


def files_in(path: Path) -> Iterator[Path]:
    if path.is_symlink() or not path.is_dir():
        yield path
        return
    own = path.resolve() == RESULTS
    yield from (entry for entry in sorted(path.iterdir()) if not (own and entry.name in OTHERS))


def read_all(paths: Sequence[Path], versions: Mapping[str, Sets],
             earlier: bool) -> tuple[list[Digest], list[str], list[str]]:
    """The digests; why others are refused; and which are of other golden files, if that is allowed."""
    digests, refused, left_out = [], [], []
    for path in (file for path in paths for file in files_in(path)):
        # Somebody else named it, so it is shown with care.
        where = f"{path.parent}/{shown(path.name)[1:-1]}"
        try:
            digests.append(read(path, versions))
        except Earlier as error:
            (left_out if earlier else refused).append(f"{where}: {error}")
        except Refused as error:
            refused.append(f"{where}: {error}")
    return digests, refused, left_out


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make results", __doc__)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true", help="print which digests are refused, and why")
    what.add_argument("--page", type=Path, default=PAGE, metavar="DIR",
                      help="where index.html goes (default: build/results)")
    what.add_argument("--freeze", action="store_true", help="keep the checksums of this version")
    parser.add_argument("--earlier", action="store_true", help="take digests of earlier golden files of a version")
    parser.add_argument("paths", nargs="*", type=Path, metavar="PATH", help="digests, or folders of them")
    given = parser.parse_args(arguments)
    versions = known_versions()
    if given.freeze:
        if given.paths or given.earlier:
            parser.error("--freeze takes nothing else")
        path = VERSIONS / f"{version()}.csv"
        write(path, versions[version()])
        print(f"{len(versions[version()])} checksums written to {path}")
        return 0
    for path in given.paths:
        if not path.is_symlink() and not path.exists():
            parser.error(f"there is no {path}; name digests, or folders of them")
    digests, refused, left_out = read_all(given.paths or [RESULTS], versions, given.earlier)
    for message in left_out:
        print(f"left out: {message}")
    for message in refused:
        print(f"refused: {message}", file=sys.stderr)
    if refused:
        return 1
    if given.check:
        print(f"{len(digests)} digests are right")
        return 0
    try:
        given.page.mkdir(parents=True, exist_ok=True)
        (given.page / "index.html").write_text(page.page(digests), encoding="utf-8")
    except OSError as error:
        parser.exit(2, f"tools/make results: cannot write {given.page / 'index.html'}: {error.strerror}\n")
    print(f"{given.page / 'index.html'}: {len(digests)} digests")
    return 0


if __name__ == "__main__":
    sys.exit(main())
