"""The command line of tools/pack: the name of a package, then its recipe's options."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence

from base.usage import near
from ship import packing
from ship.recipes import RECIPES

WIDTH = max(map(len, RECIPES))
HELP = f"""Makes a package, and prints where it is.

    tools/pack NAME [options] [FOLDER]

{"".join(f"  {name:{WIDTH}}  {recipe.line}{chr(10)}" for name, recipe in RECIPES.items())}
tools/pack NAME --help prints the options of one.

Exit status: 0 done, 1 the wheel computes wrong values, or there is no release, 2 bad usage, 4 it could not be made."""


def main(arguments: Sequence[str] | None = None) -> int:
    name, *others = (sys.argv[1:] if arguments is None else arguments) or [""]
    if name in ("-h", "--help", "help"):
        print(HELP)
        return 0
    if name not in RECIPES:
        wrong = f"there is no package {name}{near(name, RECIPES)}" if name else "the name of a package is missing"
        print(f"tools/pack: {wrong}; tools/pack --help lists them", file=sys.stderr)
        return 2
    recipe = RECIPES[name]
    if others == ["help"]:
        others = ["--help"]
    if recipe.command:
        return importlib.import_module(recipe.command).main(others)
    return packing.pack(name, others)
