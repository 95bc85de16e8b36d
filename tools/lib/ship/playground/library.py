"""The library as the page has it inside, as far as pictures take it: its text, and the translation to WGSL for every
setting."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from base.tree import GLSL, glsl_files, included_from, version
from catalog.javascript import drawn, may_draw
from catalog.model import read
from translate.settings import ARITHMETICS, HASHES, Settings
from translate.single_file.files import INCLUDE, lines_of, stripped, with_numbers
from translate.wgsl.module import Module
from translate.wgsl.writer import Definition

# The user's own hash is no choice in the page.
CHOSEN_HASHES = tuple(name for name in HASHES if name != "CUSTOM")
# The files of sums, and of what moves positions. A sum that is added has none of its own.
OF_SUMS = ("octaves", "fbm", "fbm_d", "warp")
# The file to which a hash makes a difference. Its functions that others call have the same name with every hash but
# LATTICE.
OF_THE_HASH = "hash.glsl"
# Other files of the library's kind: languages that need names of their own.
OTHERS = ("begin.hlsl", "end.hlsl", "detail/vectors_begin.h", "detail/vectors_end.h")


def glsl() -> dict[str, list[str]]:
    """The lines of the files and of what they include, without comments. An included file has its name in the
    library."""
    found: dict[str, list[str]] = {}
    wanted = [*of_pictures(), OF_THE_HASH, *OTHERS]
    while wanted:
        name = wanted.pop()
        if name not in found:
            lines = stripped(with_numbers(lines_of(GLSL / name)))
            found[name] = [named_include(name, line) for line in lines]
            wanted += [include[1] for line in found[name] if (include := INCLUDE.match(line))]
    return dict(sorted(found.items()))


def of_pictures() -> list[str]:
    """The files that pictures are made of: of the noises that can be chosen there, of the same with slopes and with a
    phase, and of sums, in each dimension. Everybody loads the page, so it has no others."""
    noises = [noise.name + form for noise in drawn(read())[0] for form in ("", "_d", "_phase")
              if form != "_phase" or may_draw(noise, "phase")]
    files = re.compile(rf"(?:{'|'.join([*noises, *OF_SUMS])})[1-4]d\.glsl")
    return [name for name in glsl_files() if files.fullmatch(name)]


def named_include(name: str, line: str) -> str:
    return INCLUDE.sub(lambda include: f'#include "{included_from(name, include[1])}"', line)


def definitions(files: list[str], arithmetic: str, name: str) -> dict[str, Definition]:
    text = "".join(f'#include "{file}"\n' for file in files)
    return {found.name: found for found in Module(GLSL, text, Settings(arithmetic, name)).definitions()}


def modules(tell: Callable[[str], None]) -> Iterator[tuple[str, dict[str, Definition]]]:
    """The definitions of these files with each setting, which is called "fast lattice" and so on. To translate them
    takes long, so hashes but the first differ in their own file alone; a test compares them with the whole. `tell`
    takes a sentence before each long step."""
    for number, arithmetic in enumerate(ARITHMETICS, 1):
        tell(f"Translating the library to WGSL with {arithmetic}, {number} of {len(ARITHMETICS)} ...")
        first: dict[str, Definition] = {}
        for name in CHOSEN_HASHES:
            if name == "LATTICE" or not first:
                found = definitions(of_pictures(), arithmetic, name)
            else:
                others = definitions([OF_THE_HASH], arithmetic, name)
                found = {name: others.get(name, same) for name, same in first.items()}
            first = first or found
            yield f"{arithmetic.removeprefix('HN_')} {name}".lower(), found


def written(definition: Definition) -> dict:
    return {"name": definition.name, "text": "\n".join(stripped(definition.lines)), "needs": definition.needs}


def wgsl(tell: Callable[[str], None]) -> dict:
    """Each definition once, and which of them a setting has."""
    texts: dict[tuple, dict] = {}
    settings: dict[str, list[tuple]] = {}
    for setting, found in modules(tell):
        entries = [written(definition) for definition in found.values()]
        settings[setting] = [(entry["name"], entry["text"], tuple(entry["needs"])) for entry in entries]
        texts.update(zip(settings[setting], entries))
    # By name, since then those of all dimensions are neighbours, which packs well.
    numbers = {key: number for number, key in enumerate(sorted(texts))}
    return {"definitions": [texts[key] for key in numbers],
            "settings": {setting: [numbers[key] for key in keys] for setting, keys in settings.items()}}


def library(tell: Callable[[str], None]) -> dict:
    return {"version": version(), "glsl": glsl(), "wgsl": wgsl(tell)}
