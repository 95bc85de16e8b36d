"""The library as the page has it inside: the text of glsl/hashnoise/, and its translation to WGSL for every setting."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from single_file.files import INCLUDE, stripped
from tree import GLSL, glsl_files, included_from, version
from wgsl.module import ARITHMETICS, HASHES, Module, Settings
from wgsl.translator import Definition

# The user's own hash is no choice in the page.
CHOSEN_HASHES = tuple(name for name in HASHES if name != "CUSTOM")
EVERYTHING = "hashnoise.glsl"
# The file to which a hash makes a difference. What others call of it has the same name with every hash but LATTICE.
OF_THE_HASH = "hash.glsl"
# What other files have of the library's own kind: languages that need names of their own.
OTHERS = ("begin.hlsl", "end.hlsl", "detail/vectors_begin.h", "detail/vectors_end.h")


def glsl() -> dict[str, list[str]]:
    """The lines of the files, without comments. What they include has its name in the library."""
    paths = glsl_files() | {name: GLSL / name for name in OTHERS}
    return {name: [named_include(name, line) for line in stripped(path.read_text(encoding="ascii").splitlines())]
            for name, path in sorted(paths.items())}


def named_include(name: str, line: str) -> str:
    return INCLUDE.sub(lambda include: f'#include "{included_from(name, include[1])}"', line)


def definitions(file: str, arithmetic: str, name: str) -> dict[str, Definition]:
    found = Module(GLSL, f'#include "{file}"\n', Settings(arithmetic, name)).definitions()
    return {definition.name: definition for definition in found}


def modules(tell: Callable[[str], None]) -> Iterator[tuple[str, dict[str, Definition]]]:
    """The definitions of everything with each setting, which is called "fast lattice" and so on. To translate all of
    the library takes long, so hashes but the first differ in their own file alone; a test compares them with the whole.
    `tell` takes a sentence before each long step."""
    for number, arithmetic in enumerate(ARITHMETICS, 1):
        tell(f"Translating the library to WGSL with {arithmetic}, {number} of {len(ARITHMETICS)} ...")
        first: dict[str, Definition] = {}
        for name in CHOSEN_HASHES:
            if name == "LATTICE" or not first:
                found = definitions(EVERYTHING, arithmetic, name)
            else:
                found = {**first, **definitions(OF_THE_HASH, arithmetic, name)}
            first = first or found
            yield f"{arithmetic.removeprefix('HN_')} {name}".lower(), found


def written(definition: Definition) -> dict:
    return {"name": definition.name, "text": "\n".join(stripped(definition.lines)), "needs": definition.needs}


def wgsl(tell: Callable[[str], None]) -> dict:
    """Each definition once, and which of them a setting has."""
    numbers: dict[tuple, int] = {}
    texts: list[dict] = []
    settings = {}
    for setting, found in modules(tell):
        chosen = []
        for definition in found.values():
            entry = written(definition)
            key = (entry["name"], entry["text"], tuple(entry["needs"]))
            if key not in numbers:
                numbers[key] = len(texts)
                texts.append(entry)
            chosen.append(numbers[key])
        settings[setting] = chosen
    return {"definitions": texts, "settings": settings}


def library(tell: Callable[[str], None]) -> dict:
    return {"version": version(), "glsl": glsl(), "wgsl": wgsl(tell)}
