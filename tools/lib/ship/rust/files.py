"""The files of the Rust crate: modules that tools/pick writes, and how the vectors call them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from typing import NamedTuple

from base.tree import GLSL, ROOT, version
from base.usage import near
from catalog import popular
from catalog.tables.functions import Function, read_functions
from proof.vectors.files import vectors_folder
from ship.packing import Refused, of_cargo, own_files
from translate.parsing.syntax import Function as Declared
from translate.pick import command
from translate.pick.comments import Facts
from translate.pick.evaluate import Module
from translate.pick.program import Program, facts, name_of, names, read
from translate.pick.rust import Rust
from translate.pick.scalars import Part, bare, text

PACKAGE = ROOT / "packages" / "rust"
ARITHMETICS = ("fast", "fixed")
AXES = "xyzw"
MODULES = popular.modules()  # of each arithmetic
ALL = (*MODULES, "hash")
NEEDED = ("place", "hash")
HASHES = (("hn_hash", "hn_lattice", "hn_unorm", "hn_snorm"), 4)  # of every arithmetic
STRUCT = re.compile(r"#\[derive\([^\n]*\)\]\npub struct (Place[1-4]) \{\n.*?\n\}\n\n?", re.DOTALL)
OF_A_POSITION = re.compile(r"hn_tile\d")  # which a place has no method for: it takes Place2::of(p).tile(period)
# A lint of clippy before Rust 1.66, by default: OfCrate.struct leaves Eq out.
ALIKE = "#![allow(clippy::derive_partial_eq_without_eq)]\n\n"
PLACE = "/// Where noise is evaluated: a cell, the fraction in it, and periods.\n"
MAKERS = re.compile(r": hn_place and hn_tile make one \(tools/pick writes [^)]*\)")  # in the comment of a place
MADE = "// Of hashnoise {}, by tools/pack rust. Copyright (c) 2026 The hashnoise authors; MIT License.\n"


class OfCrate(Rust):
    """Fields are the crate's own, so that a later version may have others, and no caller makes a place that overflows.
    A place can be compared alike with floats and with integers."""
    passed = "/// A metric of cellular noise.\npub const {}: i32 = {};"

    def struct_comment(self, name: str) -> str:
        return ""

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        shown = super().struct(name, fields)
        return shown.replace("    pub ", "    pub(crate) ").replace(", Eq)]", ")]")


class Made(NamedTuple):
    arithmetic: str
    module: str


@cache
def library(arithmetic: str) -> Module:
    return read(GLSL, command.settings(arithmetic, "lattice"), splits=True)


def of_module(known: dict[str, Declared], functions: Sequence[str], most: int) -> list[str]:
    """The names of the forms of functions, in so many dimensions at most."""
    found = []
    for name, function in known.items():
        size = re.search(r"(\d)(_|$)", name)
        if function.name in functions and (not size or int(size[1]) <= most):
            found.append(name)
    return found


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    for module in (*MODULES.values(), HASHES):
        yield from ((bare(form), "") for form in of_module(library("fixed").forms, *module))


def marked(shown: str) -> str:
    """Nothing in the crate has an effect beside its result. A loop over points whose calls are inline becomes one over
    vectors: noise then takes half of the time, and with AVX-512 a fifth."""
    return re.sub(r"(?m)^( *)((?:pub )?)fn", lambda found: f"{found[1]}#[inline]\n" + (
        f"{found[1]}#[must_use]\n" if found[2] else "") + found[0], shown)


def facts_of(program: Program, arithmetic: str) -> list[Facts]:
    """The library's comments, as they are for a crate with an arithmetic: by the names of its functions."""
    known = program.module.forms

    def texts(function: Declared, text: str) -> str:
        n = next(filter(None, (re.search(r"\d", type_) for type_ in function.types)), ["1"])[0]

        def named(found: re.Match[str]) -> str:
            return bare(next((one for one in (f"{found[0]}{n}", found[0]) if one in known), found[0]))

        text = MAKERS.sub("", text)
        return re.sub(r"\bhn_[a-z_]\w*", named, text.replace("hn_place(", f"Place{n}::in_cell("))

    knobs = command.Choice(arithmetic=arithmetic).knobs
    return [Facts(texts(root.function, one.what), {name: texts(root.function, text) for name, text in one.parameters.items()},
                  texts(root.function, one.returns), texts(root.function, one.error))
            for root, one in zip(program.roots, facts(program, GLSL, False, knobs))]


def written(made: Made) -> str:
    """The text of a module. Places are those of the module `place`, so that all modules have the same."""
    of = library(made.arithmetic)
    known = of.forms
    names = of_module(known, *(HASHES if made.module == "hash" else MODULES[made.module]))
    is_of_places = made.module == "place"
    functions = [known[name] for name in names if not (is_of_places and OF_A_POSITION.fullmatch(name))]
    program = Program(of, functions)
    shown = text(program, OfCrate(), [] if is_of_places else facts_of(program, made.arithmetic), [])
    structs = sorted(set(STRUCT.findall(shown)))
    if is_of_places:
        shown = STRUCT.sub(lambda found: PLACE + found[0], re.sub("(?m)^pub fn", "fn", shown))
        return MADE.format(version()) + ALIKE + shown.lstrip("\n") + marked("".join(methods(n) for n in range(1, 5)))
    used = f"use super::place::{{{', '.join(structs)}}};\n\n" if structs else ""
    return MADE.format(version()) + "\n" + used + marked(STRUCT.sub("", shown)).lstrip("\n")


def methods(n: int) -> str:
    """The methods of a place, by vectors: the library's functions, which are the module's own."""
    def all_of(of: str) -> str:
        return ", ".join(f"{of}[{i}]" for i in range(n))

    cell = "self.cell" if n == 1 else ", ".join(f"self.cell_{axis}" for axis in AXES[:n])
    position = f"[position{n}(self)]" if n == 1 else f"position{n}(self)"
    return f"""
impl Place{n} {{
    /// The place of a position, in cells: a coordinate times a frequency. Floats from 2^23 on have no fraction.
    pub fn of(p: [f32; {n}]) -> Self {{
        place_of{n}({all_of("p")})
    }}

    /// A cell, and a position in it from 0 to 1. It names cells exactly where a float no longer can. Cells wrap at 2^32.
    pub fn in_cell(cell: [i32; {n}], fraction: [f32; {n}]) -> Self {{
        place_in_cell{n}({all_of("cell")}, {all_of("fraction")})
    }}

    /// The first corner of a cell.
    pub fn at_cell(cell: [i32; {n}]) -> Self {{
        place_at_cell{n}({all_of("cell")})
    }}

    /// The place of whole units, exactly; `units` of them make so many `cells`. Both are from 1 to 65536.
    pub fn of_units(position: [i32; {n}], cells: i32, units: i32) -> Self {{
        place_of_units{n}({all_of("position")}, cells, units)
    }}

    /// The place in a tile: the field repeats after its period, in cells. 0 is none.
    pub fn tile(self, period: [i32; {n}]) -> Self {{
        tile{n}_place(self, {all_of("period")})
    }}

    /// The cell in which it is.
    pub fn cell(self) -> [i32; {n}] {{
        [{cell}]
    }}

    /// Its cell and its fraction in one float along each axis, which far out rounds them.
    pub fn position(self) -> [f32; {n}] {{
        {position}
    }}
}}
"""


def module_file(arithmetic: str, modules: Sequence[str]) -> str:
    """The crate's file for an arithmetic, with the names of all its modules."""
    what = {"fast": "`HN_FAST`: floats, within the error that each function states.",
            "fixed": "`HN_FIXED`: integers, so the bits are the same everywhere."}[arithmetic]
    return (f"//! {what}\n" + MADE.format(version()) + "\n" +
            "".join(f"#[rustfmt::skip]\nmod {module};\n" for module in modules) + "\n" +
            "".join(f"pub use {module}::*;\n" for module in sorted(modules)))


def argument(kind: str, word: int) -> str:
    return {"f32": f"f32::from_bits(w[{word}])", "i32": f"w[{word}] as i32", "u32": f"w[{word}]"}[kind]


def call(function: Function, name: str, module: str) -> str:
    """The expression that calls a function with the words of a row."""
    words = {column.name: argument(column.type, i) for i, column in enumerate(function.inputs)}
    n = function.axes

    def along(prefix: str) -> str:
        return f"[{', '.join(words.pop(f'{prefix}{axis}') for axis in AXES[:n])}]"

    def called(made: str, *arguments: str) -> str:
        return f"{module}::{made}({', '.join(arguments)})"

    if function.has_place:
        if function.has_cell:
            place = called(f"Place{n}::in_cell", along("c"), along("f"))
        elif function.form == "place_of_noise":
            place = called(f"Place{n}::of_units", along(""), words.pop("cells"), words.pop("units"))
        else:
            place = called(f"Place{n}::of", along(""))
        arguments = [f"{place}.tile({along('p')})" if function.has_period else place]
        arguments += words.values()
    else:
        arguments = list(words.values())
    part = {"": "", "nearest": ".1", "offset": ".2"}[function.sets]
    return f"{called(bare(name), *arguments)}{part}.numbers()"


def calls(modules: Sequence[str]) -> tuple[str, list[str]]:
    """The table of the tests, and the functions whose vectors it needs."""
    known, declared, rows, needed = names(), library("fixed").forms, [], []
    of_hash = of_module(declared, *HASHES)
    of_noise = {name for module in modules if module in MODULES for name in of_module(declared, *MODULES[module])}
    for function in read_functions():
        name = name_of(function, known)
        where = []
        if name in of_hash and "hash" in modules:
            where = [("hash", "any" if function.family == "independent" else "lattice")]
        elif name in of_noise and not function.exact:
            where = [("fast", "lattice"), ("fixed", "lattice+fixed")]
        for module, setting in where:
            rows.append(f'    Call {{\n        file: "{function.id}",\n        setting: "{setting}",\n'
                        f"        function: |w| {call(function, name, module)},\n    }},\n")
        needed += [function.id] if where else []
    used = ", ".join([*ARITHMETICS] * bool(of_noise) + sorted({"hash"} & set(modules)))
    used = f"{{{used}}}" if "," in used else used
    return (MADE.format(version()) + f"\nuse super::{{Call, Numbers}};\nuse hashnoise::{used};\n\n"
            f"#[rustfmt::skip]\npub const CALLS: &[Call] = &[\n{''.join(rows)}];\n"), needed


def chosen(only: str) -> list[str]:
    """The modules that are named, with commas between."""
    modules = [*dict.fromkeys(name.strip() for name in only.split(","))]
    for name in modules:
        if name not in ALL:
            raise Refused(f"there is no module {name}{near(name, ALL) or '; there are ' + ', '.join(ALL)}")
    for name in NEEDED:
        if name not in modules:
            raise Refused(f"the others need the module {name}")
    return modules


def package(only: str = ",".join(ALL)) -> dict[str, str]:
    """All files, by their paths. With some of the modules it is a crate for tests."""
    modules = chosen(only)
    found = {path: text for path, text in own_files(PACKAGE).items() if path.endswith((".md", ".rs", ".toml"))}
    found["Cargo.toml"] = of_cargo(found["Cargo.toml"])
    found["LICENSE"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    of_arithmetic = [module for module in MODULES if module in modules]
    made = [Made(arithmetic, module) for arithmetic in ARITHMETICS for module in of_arithmetic]
    with ProcessPoolExecutor() as pool:
        for one, shown in zip([*made, Made("fixed", "hash")], pool.map(written, [*made, Made("fixed", "hash")])):
            path = "src/hash.rs" if one.module == "hash" else f"src/{one.arithmetic}/{one.module}.rs"
            found[path] = shown
    found["src/hash.rs"] = f"//! Hashed words and cells, which every arithmetic has alike.\n{found['src/hash.rs']}"
    for arithmetic in ARITHMETICS:
        found[f"src/{arithmetic}.rs"] = module_file(arithmetic, of_arithmetic)
    found["tests/vectors/calls.rs"], needed = calls(modules)
    vectors = vectors_folder()
    for id in needed:
        found[f"vectors/{id}.json"] = (vectors / f"{id}.json").read_text(encoding="ascii")
    return found
