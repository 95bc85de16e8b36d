"""Makes a package by its recipe: a folder with its files, or one zip file of it."""

from __future__ import annotations

import argparse
import importlib
import json
import os
import shutil
import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path

from base.tree import ROOT, address, version
from base.twin import NotBuilt
from base.usage import Parser
from ship.page import of_package
from ship.recipes import RECIPES, Recipe
from ship.zips import zipped

Files = Mapping[str, "str | bytes"]


def own_files(folder: Path) -> dict[str, str]:
    """The files that a package takes from a folder, by the paths there: all but its tests."""
    return {path.relative_to(folder).as_posix():
            of_package(path) if path.suffix == ".md" else path.read_text(encoding="utf-8")
            for path in sorted(folder.rglob("*")) if path.is_file() and path.name != "tests.cmake"}


def of_npm(manifest: str, name: str) -> str:
    """A package.json, which has no name, no version and no address of its own."""
    where = {"homepage": address(), "repository": {"type": "git", "url": f"git+{address()}.git"},
             "bugs": f"{address()}/issues"} if address() else {}
    return json.dumps({"name": name, "version": version(), **json.loads(manifest), **where}, indent=2) + "\n"


def of_cargo(manifest: str) -> str:
    """A Cargo.toml, which has no version and no address of its own."""
    where = f'repository = "{address()}"\n' if address() else ""
    return manifest.replace("[package]\n", f'[package]\nversion = "{version()}"\n{where}', 1)


def papers(package: Path) -> dict[str, str]:
    """The page of a package, and the license, by their paths."""
    return {"README.md": of_package(package / "README.md"),
            "LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8")}


class Refused(Exception):
    """A fault of the arguments of a package."""


def encoded(content: str | bytes) -> bytes:
    return content.encode("utf-8") if isinstance(content, str) else content


def described(name: str, recipe: Recipe) -> str:
    """The help of a package, but for its options."""
    place = f"in FOLDER, which is build/{name} unless you name one"
    where = (f"It is {recipe.name}-VERSION.zip {place}." if recipe.is_zip else
             f"It is {recipe.name}-VERSION/ {place}; what was there is replaced. With --zip it is "
             f"{recipe.zip_name}-VERSION.zip in its place.")
    paragraphs = (f"Makes {recipe.line}, and prints where it is.",
                  f"{where} {recipe.more} {recipe.needs}",
                  "The same tree makes the same bytes; the times in a zip are SOURCE_DATE_EPOCH's, or of 1980.",
                  f"Exit status: 0 done, 2 bad usage{', 4 it could not be made' if recipe.has_vectors else ''}.")
    return "\n\n".join(textwrap.fill(text, 120, break_on_hyphens=False) for text in paragraphs)


def add_folder(parser: Parser, folder: str) -> None:
    parser.add_argument("folder", nargs="?", default=str(ROOT / folder), metavar="FOLDER",
                        help=f"where it goes (default: {folder})")


def checked_folder(parser: Parser, given: argparse.Namespace) -> Path:
    """The path in the arguments, which need not exist yet."""
    if not given.folder:
        parser.error("the folder has no name")
    folder = Path(given.folder)
    if folder.exists() and not folder.is_dir():
        parser.error(f"{folder} is a file; it must be a folder, or a name for a new one")
    return folder


def make_folder(parser: Parser, folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        parser.error(f"the folder {folder} cannot be made: {error.strerror}")


def files_of(name: str, **options: str) -> Files:
    """All files of a package, by their paths."""
    return importlib.import_module(f"ship.{name.replace('-', '_')}.files").package(**options)


def beside(name: str) -> Files:
    """Files for a registry that stand beside the package, by the ends of their names."""
    return getattr(importlib.import_module(f"ship.{name.replace('-', '_')}.files"), "beside", dict)()


def pack(name: str, arguments: Sequence[str]) -> int:
    """The command of a package that has no other. It refuses wrong arguments before it makes anything."""
    recipe = RECIPES[name]
    parser = Parser(f"tools/pack {name}", described(name, recipe))
    add_folder(parser, f"build/{name}")
    if recipe.has_folder:
        parser.add_argument("--zip", action="store_true", help="one file, for a release")
    for option, of in recipe.options.items():
        parser.add_argument(f"--{option}", metavar=of.metavar, help=of.help)
    given = parser.parse_args(arguments)
    folder = checked_folder(parser, given)
    seconds = os.environ.get("SOURCE_DATE_EPOCH", "0")
    if not seconds.isdigit():
        parser.error(f"SOURCE_DATE_EPOCH is a number of seconds, not {seconds}")
    try:
        files = files_of(name, **{option: value for option in recipe.options
                                  if (value := getattr(given, option)) is not None})
    except Refused as error:
        parser.error(str(error))
    except NotBuilt as error:
        parser.exit(4, f"tools/pack {name}: {error}\n")
    make_folder(parser, folder)
    top = f"{recipe.name}-{version()}"
    is_zip = recipe.is_zip or given.zip
    made = folder / (f"{recipe.zip_name}-{version()}.zip" if is_zip else top)
    try:
        if is_zip:
            inside = "" if recipe.is_zip else f"{top}/"
            packed = {f"{inside}{path}": encoded(content) for path, content in files.items()}
            made.write_bytes(zipped(packed, int(seconds)))
        else:
            put(made, files)
        for end, content in beside(name).items():
            made.with_name(f"{made.name.removesuffix('.zip')}{end}").write_bytes(encoded(content))
    except OSError as error:
        parser.error(f"cannot write {error.filename or made}: {error.strerror}")
    print(made)
    return 0


def put(folder: Path, files: Files) -> None:
    """The files, and no others that an earlier run left. cargo's files stay."""
    for path in folder.glob("*"):
        if path.name not in ("target", "Cargo.lock"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(encoded(content))
