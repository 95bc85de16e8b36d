"""The files of the package for WESL: the library in WGSL, with names for a module, for npm and for cargo."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from functools import cache

from base.tree import GLSL, ROOT, version
from ship.packing import of_cargo, of_npm, papers
from ship.recipes import RECIPES
from translate.names import RESERVED
from translate.settings import Settings
from translate.wgsl.module import Module
from translate.wgsl.writer import Definition

PACKAGE = ROOT / "packages" / "wesl"
NAME = RECIPES["wesl"].name  # by which it is imported, and what npm and cargo call it
# The module at the root, and the other one. Each has a name in npm's bundle, and a file in the crate.
MODULES = {"package": "HN_FAST", "fixed": "HN_FIXED"}
FILES = ("Cargo.toml", "package.json", "src/lib.rs", "weslBundle.d.ts")
MADE = "// Of hashnoise {}, by tools/pack wesl. Copyright (c) 2026 The hashnoise authors; MIT License.\n"
OF_USERS = re.compile(r"\bhn_(?!i_)(\w+)|\bHN_(?!I_)(\w+)")
# Without a word before it a declaration is that of its package alone, in the WESL of cargo.
DECLARED = re.compile(r"^(?=(?:fn|struct|const) (?!hn_i_|HN_I_))", re.MULTILINE)


@cache
def definitions(arithmetic: str) -> list[Definition]:
    return Module(GLSL, '#include "hashnoise.glsl"\n', Settings(arithmetic)).definitions()


@cache
def structs() -> frozenset[str]:
    return frozenset(item.name for item in definitions("HN_FAST") if item.lines[0].startswith("struct "))


def renamed(code: str) -> str:
    """With the names of a module, whose path has hashnoise's name: perlin2, Place2, METRIC_EUCLIDEAN. Two of
    them would be reserved words, so there is a line behind those: unorm_, snorm_."""
    def name(found: re.Match[str]) -> str:
        bare = found[1] or found[2]
        if found[0] in structs():
            return bare[0].upper() + bare[1:]
        return f"{bare}_" if bare in RESERVED else bare

    return OF_USERS.sub(name, code)


def module(arithmetic: str) -> str:
    lines = (code for item in definitions(arithmetic) for line in item.lines
             if (code := line.partition("//")[0].strip()))
    return MADE.format(version()) + "".join(f"{renamed(line)}\n" for line in lines)


def imported(names: Iterable[str], arithmetic: str = "HN_FAST") -> str:
    """The statement that imports definitions, which then have their names in WGSL."""
    path = NAME if arithmetic == "HN_FAST" else f"{NAME}::fixed"
    return f"import {path}::{{{', '.join(f'{renamed(name)} as {name}' for name in names)}}};\n"


def bundle(modules: dict[str, str]) -> str:
    """As npm's wesl takes a package."""
    named = {("lib" if name == "package" else name) + ".wesl": text for name, text in modules.items()}
    content = json.dumps({"name": NAME, "edition": "2026_pre", "modules": named}, indent=2)
    return f"{MADE.format(version())}export const weslBundle = {content};\nexport default weslBundle;\n"


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    modules = {name: module(arithmetic) for name, arithmetic in MODULES.items()}
    found = {**papers(PACKAGE), **{name: (PACKAGE / name).read_text(encoding="utf-8") for name in FILES}}
    found["Cargo.toml"] = of_cargo(found["Cargo.toml"])
    found["package.json"] = of_npm(found["package.json"], NAME)
    found["weslBundle.js"] = bundle(modules)
    for name, text in modules.items():
        found[f"shaders/{name}.wesl"] = DECLARED.sub("public ", text)
    return found
