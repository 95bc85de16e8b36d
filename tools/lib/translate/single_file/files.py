"""The files of glsl/hashnoise/ put together, as text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from base.tree import GLSL, glsl_files, included_from
from translate.single_file import godot

# Where the file belongs.
PLACES = {"glsl": "Put it below your #version and #extension lines.", "hlsl": "Include it once in a shader.",
          "slang": "Save it as hashnoise.slang on a path of imports, and import hashnoise.",
          "metal": "Include it once in a file, below <metal_stdlib>.",
          "godot": "Save it as a .gdshaderinc, and include it once in a shader."}
INCLUDE = re.compile(r'^#include "([^"]+)"$')
# An include that a knob decides on. Without it the file changes nothing, so that it may be there with any knob.
CHOSEN = re.compile(r'^#if .*\n((?:#include .*\n)+)#endif\n', re.MULTILINE)
PASSED = re.compile(r"#define (HN_(?:METRIC|DISTRIBUTION)_\w+) (\d+)")


@dataclass(frozen=True)
class Part:
    """A file of the library, apart: the files that have to stand before it, and its own lines with its guard."""
    includes: tuple[str, ...]
    lines: tuple[str, ...]


def lines_of(path: Path) -> list[str]:
    """The lines of a file, which includes all that it includes with some knob."""
    return CHOSEN.sub(r"\1", path.read_text(encoding="ascii")).splitlines()


def parts(strip: bool = False) -> dict[str, Part]:
    """All of the GLSL, by the names of the files. In a file, includes stand above the code, so they may come first."""
    found = {}
    for name, path in glsl_files().items():
        lines = lines_of(path)
        own = [line for line in lines if not INCLUDE.match(line)]
        found[name] = Part(tuple(included_from(name, match[1]) for line in lines if (match := INCLUDE.match(line))),
                           tuple(stripped(own) if strip else own))
    return found


def in_order(name: str, library: dict[str, Part]) -> list[str]:
    """The files that a file needs, and last itself, each once and behind those that it includes."""
    found: dict[str, None] = {}  # a set that keeps the order

    def take(needed: str) -> None:
        if needed not in found:
            for included in library[needed].includes:
                take(included)
            found[needed] = None

    take(name)
    return list(found)


def flatten(name: str, done: set[str]) -> list[str]:
    """The lines of a file with its includes in place; nothing for a file that is already in."""
    if name in done:
        return []
    done.add(name)
    lines = []
    for line in lines_of(GLSL / name):
        included = INCLUDE.match(line)
        lines += flatten(included_from(name, included[1]), done) if included else [line]
    return lines


def stripped(lines: Iterable[str]) -> Iterator[str]:
    """The lines without comments and indentation; none that would be empty. The library has no other comments than //."""
    for line in lines:
        code = line.partition("//")[0].strip()
        if code:
            yield code


# Blanks that a tokenizer does not need: those beside a sign that is neither a word nor a sign that would join another.
BLANK = re.compile(r"(?<=[\w.]) (?=[^\w.])|(?<=[^\w.]) (?=[\w.])|(?<=[][(){},;]) | (?=[][(){},;])")


MACRO = re.compile(r"(#define \w+(?:\([^)]*\))?)( |$)(.*)")


def minified(lines: Iterable[str]) -> Iterator[str]:
    """The lines without blanks that mean nothing, so an error names the line that it named in the stripped file.
    The one behind a macro's name stays: it separates a macro without arguments from one with."""
    for line in stripped(lines):
        if macro := MACRO.fullmatch(line):
            yield macro[1] + macro[2] + BLANK.sub("", macro[3])
        else:
            yield line if line.startswith("#") else BLANK.sub("", line)


DEFAULT = re.compile(r"(#define HN_(?!I_)\w+ )(HN_\w+)")
NUMBER = re.compile(r"#define (HN_\w+) (\d+)")


def with_numbers(lines: Sequence[str]) -> list[str]:
    """The lines with a number where a macro of users is another one that stands for a number, as the default of a knob
    is: PlayCanvas' preprocessor compares texts, and does not look up a macro's value."""
    numbers = dict(match.groups() for line in lines if (match := NUMBER.match(line)))
    return [f"{match[1]}{numbers[match[2]]}  // {match[2]}"
            if (match := DEFAULT.fullmatch(line)) and match[2] in numbers else line for line in lines]


def text(names: Sequence[str], language: str = "glsl", strip: bool = False, minify: bool = False) -> str:
    """The files, with all that they include, as one."""
    # Slang is HLSL with modules, whose names may be overloaded, and whose macros stay inside.
    ending = "hlsl" if language == "slang" else language
    between = (f"begin.{ending}", f"end.{ending}") if ending in ("hlsl", "metal") else ()
    done: set[str] = set()
    lines = [line for part in (*between[:1], *names, *between[1:]) for line in flatten(part, done)]
    if language == "glsl":
        lines = with_numbers(lines)
        lines += ["// So that errors in your own shader, below, have the numbers of its lines.", "#line 1"]
    elif language == "godot":
        lines = godot.expanded(lines)
    elif language == "slang":
        # Numbers that users pass are constants in a module, since macros stay inside.
        for name, value in [found.groups() for line in lines if (found := PASSED.match(line))]:
            lines += [f"#undef {name}", f"static const int {name} = {value};"]
        lines += ["#if HN_ARITHMETIC == HN_PRECISE",
                  "#error Slang's compiler leaves precise out of SPIR-V: take HN_FIXED, whose bits are the same everywhere",
                  "#endif"]
    header = [f"// Generated by tools/pick whole from {', '.join(names)}. {PLACES[language]}",
              "// Copyright (c) 2026 The hashnoise authors; MIT License.", ""]
    shortened = minified if minify else stripped if strip else iter
    return "\n".join([*header, *shortened(lines)]) + "\n"
