"""The files of the npm package that are made of the library: GLSL and WGSL as modules of JavaScript, with their types.

A text stands in one module, and others import it, so a bundler keeps each used text once.
"""

from __future__ import annotations

import base64
import json
import re
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from base.tree import GLSL, ROOT, glsl_files
from catalog.javascript import as_packed
from catalog.tables.glsl import public_files
from ship.npm.twin import Failed, compiled
from ship.packing import Files, of_npm, own_files, put
from ship.page import of_package
from translate.names import is_public
from translate.settings import Settings
from translate.single_file.files import in_order, minified, parts, text
from translate.wgsl.module import Module
from translate.wgsl.writer import Definition

PACKAGE = ROOT / "packages" / "npm"
MADE = "// Made by tools/pack npm. Copyright (c) 2026 The hashnoise authors; MIT License.\n"
# WGSL has no HN_PRECISE. The folder of each, and what users call it.
ARITHMETICS = {"fast": "HN_FAST", "fixed": "HN_FIXED"}
STRING = "declare const text: string;\nexport default text;\n"
# The types of TSL: those of GLSL, by the names of WGSL. Numbers may also be JavaScript's own.
SCALARS = {"f32": "float", "i32": "int", "u32": "uint"}
TYPES = {**SCALARS, **{f"hn_place{n}": f"hn_place{n}" for n in (1, 2, 3, 4)},
         **{f"vec{n}{letter}": f"{prefix}vec{n}" for n in (2, 3, 4) for letter, prefix in
            (("f", ""), ("i", "i"), ("u", "u"))}}
SIGNATURE = re.compile(r"fn (?P<name>\w+)\((?P<parameters>[^)]*)\) -> (?P<type>\w+) \{")


def quoted(value: str) -> str:
    return json.dumps(value, ensure_ascii=True)


# ---------------------------------------------------------------------------------------------------------------------
# GLSL.


def glsl_modules() -> dict[str, str]:
    """The plain files, the text of each without comments as a module, and strings that stand alone, made of those."""
    found = {f"glsl/{name}": path.read_text(encoding="ascii") for name, path in glsl_files().items()}
    found["hashnoise.glsl"] = text(["hashnoise.glsl"], minify=True)
    all_parts = parts()
    for name, part in all_parts.items():
        stem = Path(name).stem
        lines = list(minified(part.lines))
        found[f"glsl/text/{stem}.js"] = f"{MADE}export default {quoted(''.join(f'{line}' + chr(10) for line in lines))};\n"
        if name.startswith("detail/"):
            continue
        needed = [Path(need).stem for need in in_order(name, all_parts)]
        imports = "".join(f'import {need} from "./text/{need}.js";\n' for need in needed)
        found[f"glsl/{stem}.js"] = f"{MADE}{imports}\nexport default {' + '.join(needed)};\n"
        found[f"glsl/{stem}.d.ts"] = STRING
    names = [Path(name).stem for name in all_parts if not name.startswith("detail/")]
    found["glsl/all.js"] = MADE + "".join(f'export {{ default as {name} }} from "./{name}.js";\n' for name in names)
    return found


# ---------------------------------------------------------------------------------------------------------------------
# WGSL.


def comment(definition: Definition) -> str:
    block: list[str] = []
    for line in reversed(definition.comments):
        if not line.startswith("//"):
            break
        block.insert(0, line.removeprefix("//").rstrip())
    return "".join(f" *{line}\n" for line in block).replace("*/", "* /").replace("; 0 if left out", "")


def documented(definition: Definition, line: str) -> str:
    said = comment(definition)
    return f"/**\n{said} */\n{line}" if said else line


def wgsl_files(modules: dict[str, list[Definition]]) -> dict[str, str]:
    """A module for each arithmetic, in which each definition is a constant that names those it needs."""
    found = {}
    for folder, definitions in modules.items():
        lines = [MADE, 'import { definition } from "./wgsl.js";\n', 'export { wgsl } from "./wgsl.js";\n\n']
        types = ['import type { Definition } from "./wgsl.js";\n', 'export { wgsl } from "./wgsl.js";\n\n']
        for item in definitions:
            code = "".join(f"{line}\n" for line in minified(item.lines))
            needs = "".join(f", {need}" for need in item.needs)
            export = "export " if is_public(item.name) else ""
            lines.append(f"{export}const {item.name} = /*#__PURE__*/ definition({quoted(code)}{needs});\n")
            if export:
                types.append(documented(item, f"export declare const {item.name}: Definition;\n"))
        found[f"wgsl/{folder}.js"] = "".join(lines)
        found[f"wgsl/{folder}.d.ts"] = "".join(types)
    return found


# ---------------------------------------------------------------------------------------------------------------------
# TSL.


class InGlsl(NamedTuple):
    name: str
    file: str  # that defines it
    may_lack_seed: bool


def in_glsl(module: Module) -> dict[tuple[str, tuple[str, ...]], InGlsl]:
    """The function with this name and these types in WGSL."""
    functions = module.library.functions

    def file_of(path: str) -> str:
        return Path(public_files().get(path, path)).stem

    return {(new, types): InGlsl(old, file_of(functions[old, types].at.path),
                                 types[-1:] == ("uint",) and (old, types[:-1]) in functions)
            for (old, types), new in module.names().items()}


def tsl_files(modules: dict[str, list[Definition]],
              names: dict[tuple[str, tuple[str, ...]], InGlsl]) -> dict[str, str]:
    """A node for each function whose result is all that it sets, and is a number, a vector or a place, and which takes
    no other structs: octaves are for loops of one's own."""
    found = {}
    for folder, definitions in modules.items():
        imported, nodes, types, needed = [], [], [], set()
        for item in definitions:
            signature = SIGNATURE.match(" ".join(line.strip() for line in item.lines))
            if not is_public(item.name) or not signature or "ptr<" in signature["parameters"]:
                continue
            if signature["type"] not in TYPES:
                continue
            parameters = [one.split(": ") for one in signature["parameters"].split(", ")]
            if not all(type_ in TYPES for _, type_ in parameters):
                continue
            glsl_types = tuple(TYPES[type_] for _, type_ in parameters)
            glsl, file, may_lack_seed = names[item.name, glsl_types]
            needed.add(file)
            imported.append(item.name)
            declared = ", ".join(f"{type_} {name}" for (name, _), type_ in zip(parameters, glsl_types))
            nodes.append(f"export const {item.name} = /*#__PURE__*/ node({quoted(item.name)}, "
                         f"{quoted(TYPES[signature['type']])}, {quoted(declared)}, {quoted(glsl)}, {file}, "
                         f"wgsl_{item.name}, {quoted(ARITHMETICS[folder])}{', true' * may_lack_seed});\n")
            taken = ", ".join(f"{name}{'?' if name == 'seed' and may_lack_seed else ''}: {accepted(type_)}"
                              for (name, _), type_ in zip(parameters, glsl_types))
            types.append(documented(item, f"export declare function {item.name}({taken}): "
                                          f"Node<\"{TYPES[signature['type']]}\">;\n"))
        found[f"tsl/{folder}.js"] = "".join([
            MADE, *(f'import {file} from "../glsl/{file}.js";\n' for file in sorted(needed)),
            f"import {{ {', '.join(f'{name} as wgsl_{name}' for name in imported)} }} from \"../wgsl/{folder}.js\";\n",
            'import { node } from "./node.js";\n\n', *nodes])
        found[f"tsl/{folder}.d.ts"] = "".join(['import type { Node } from "three/webgpu";\n\n', *types])
    return found


def accepted(type_: str) -> str:
    return f'Node<"{type_}">' + " | number" * (type_ in SCALARS.values())


# ---------------------------------------------------------------------------------------------------------------------


def checked_names(found: Iterable[str]) -> None:
    folded = [name.lower() for name in found]
    if len(set(folded)) != len(folded):
        raise ValueError("two files of the package have one name")


def package(module: bytes) -> Files:
    """All files, by their paths; `module` is the twin in WebAssembly."""
    settings = {folder: Settings(arithmetic) for folder, arithmetic in ARITHMETICS.items()}
    modules = {folder: Module(GLSL, '#include "hashnoise.glsl"\n', one) for folder, one in settings.items()}
    definitions = {folder: one.definitions() for folder, one in modules.items()}
    found = {name: as_packed(text) for name, text in own_files(PACKAGE / "src").items()}
    found["package.json"] = of_npm((PACKAGE / "package.json").read_text(encoding="utf-8"), "hashnoise")
    found["LICENSE"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    found["README.md"] = of_package(ROOT / "docs" / "guide" / "javascript.md")
    found["field.wasm"] = module  # for hosts that compile no module while they run
    packed = base64.b64encode(module).decode("ascii")
    found["twin.js"] = f"""{MADE}// The twin in WebAssembly, {len(module):,} bytes.
const packed = "{packed}";

export const bytes = () => Uint8Array.from(atob(packed), (character) => character.charCodeAt(0));
"""
    for files in (glsl_modules(), wgsl_files(definitions), tsl_files(definitions, in_glsl(modules["fast"]))):
        checked_names([*found, *files])
        found.update(files)
    return found


if __name__ == "__main__":  # pack.sh calls it: python3 -m ship.npm.files FOLDER
    try:
        put(Path(sys.argv[1]), package(compiled()))
    except Failed as error:
        sys.exit(str(error))
