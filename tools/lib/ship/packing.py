"""Commands that make a package have this in common: a folder with its files, or one zip file of it."""

from __future__ import annotations

import argparse
import os
import shutil
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from ship.zips import zipped
from tree import ROOT, version


def add_arguments(parser: argparse.ArgumentParser, folder: str) -> None:
    parser.add_argument("folder", nargs="?", default=str(ROOT / folder), metavar="FOLDER",
                        help=f"where it goes (default: {folder})")
    parser.add_argument("--zip", action="store_true", help="one file, for a release")


def papers(package: Path) -> dict[str, str]:
    """The page of a package, and the license, by their paths."""
    return {"README.md": (package / "README.md").read_text(encoding="utf-8"),
            "LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8")}


class Refused(Exception):
    """What is wrong with a file that a package should have."""


def encoded(content: str | bytes) -> bytes:
    return content.encode("utf-8") if isinstance(content, str) else content


class Destination:
    """Where a package goes, as the arguments say; what is wrong with them is told before anything is made."""

    def __init__(self, parser: argparse.ArgumentParser, given: argparse.Namespace):
        self.parser = parser
        self.is_zip = given.zip
        seconds = os.environ.get("SOURCE_DATE_EPOCH", "0")
        if not given.folder:
            parser.error("the folder has no name")
        if not seconds.isdigit():
            parser.error(f"SOURCE_DATE_EPOCH is a number of seconds, not {seconds}")
        self.seconds = int(seconds)
        self.folder = Path(given.folder)
        if self.folder.exists() and not self.folder.is_dir():
            parser.error(f"{self.folder} is a file; it must be a folder, or a name for a new one")

    def write(self, name: str, archive: str, files: Mapping[str, str | bytes]) -> Path:
        """The folder of that name, or the zip file in which it is."""
        made = self.folder / (archive if self.is_zip else name)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            if self.is_zip:
                packed = {f"{name}/{path}": encoded(content) for path, content in files.items()}
                made.write_bytes(zipped(packed, self.seconds))
            else:
                put(made, files)
        except OSError as error:
            self.parser.error(f"cannot write {error.filename or made}: {error.strerror}")
        return made


def command(tool: str, help_: str | None, name: str, package: Callable[..., Mapping[str, str | bytes]],
            arguments: Sequence[str] | None, **files: str) -> int:
    """A command that makes one package, NAME-VERSION, and prints where it is. `files` are options, each with its help:
    the package takes the file that one names."""
    parser = argparse.ArgumentParser(prog=f"tools/{tool}", description=help_,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser, f"build/{tool}")
    for option, said in files.items():
        parser.add_argument(f"--{option}", metavar="FILE", help=said)
    given = parser.parse_args(arguments)
    destination = Destination(parser, given)
    made = f"{name}-{version()}"
    try:
        content = package(**{option: path for option in files if (path := getattr(given, option)) is not None})
    except Refused as error:
        parser.error(str(error))
    print(destination.write(made, f"{made}.zip", content))
    return 0


def put(folder: Path, files: Mapping[str, str | bytes]) -> None:
    """The files, and no others that an earlier run left. What cargo made stays."""
    for path in folder.glob("*"):
        if path.name not in ("target", "Cargo.lock"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(encoded(content))
