"""The library's comment of a function, so that it stands alone: where it refers to another comment, the text of that
stands in its place, and nothing names a file or a page of the library."""

from __future__ import annotations

import functools
import re
import textwrap
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from catalog.tables.glsl import Declaration, declarations
from translate.names import OF_AXES
from translate.parsing.syntax import Function, Parameter
from translate.pick.values import SIZES, scalar_of
from translate.settings import NO_SETTINGS, Settings

HEADING = re.compile(r" {3}(\w+(?:, \w+)*) {2,}(\S.*)")
OF_ABOVE = re.compile(r"\bas above\b")
FOR_ANOTHER = re.compile(r"as for (hn_\w+)")
LIKE_ANOTHER = re.compile(r"(This form|The same|Add the noise of an octave as it is, and)\b")
REFERENCE = re.compile(r"docs/|\.glsl")
TYPES = re.compile(": (?:int, ivec2, ivec3 or ivec4|uint, uvec2, uvec3 or uvec4)")  # of overloads, where a function that stands alone has one
IN_PLACE = re.compile(r"in place of (?:p|the cell)\b")  # begins a comment's lines on a place, for who may pass either
PLACE = ("a place, that is a cell and a position in it, in cells{0}: hn_place and hn_tile make one (tools/pick writes "
         "hn_place_in_cell{1} and hn_tile{1})")
LEFT_OUT = "; 0 if left out"
METRIC = ". This is with the Euclidean metric and a jitter of 1"


class Facts(NamedTuple):
    """Paragraphs. The parameters are GLSL's, or by their names in a language, a position's together."""
    what: str = ""
    parameters: Mapping[str, str] = {}
    returns: str = ""
    error: str = ""
    call: str = ""
    sets: Sequence[str] = ()  # its results beside the first: the outputs' names in GLSL

    @property
    def all_returns(self) -> str:
        """With the other results behind it."""
        described = (f"{one}, {self.parameters.get(one, '').removeprefix('set to ')}".rstrip(", ") for one in self.sets)
        return "; then ".join(filter(None, [self.returns, *described]))


class Block(NamedTuple):
    what: str
    entries: Mapping[str, str]
    notes: str  # taken from others


def block(lines: Sequence[str]) -> Block:
    entries: dict[str, str] = {"": "", "(": ""}
    heading: tuple[str, ...] = ("",)
    for line in lines:
        if found := HEADING.fullmatch(line):
            heading, line = tuple(found[1].split(", ")), found[2]
            entries.update(dict.fromkeys(heading, ""))
        elif line.startswith("   ("):
            heading = ("(",)
        elif heading == ("",) and (line.startswith("  ") or line.startswith(" --")):
            continue  # lines of code
        for name in heading:
            entries[name] = f"{entries[name]} {line.strip()}".strip()
    what = re.sub(r":( |$)", lambda found: f".{found[1]}", entries.pop("")) if any(
        line.startswith("   hn_") or line.startswith("   vec") for line in lines) else entries.pop("")
    return Block(what, entries, entries.pop("("))


@functools.cache
def _declared(library: Path) -> tuple[dict[tuple[str, tuple[str, ...]], Declaration], list[Declaration]]:
    found = declarations(library)
    return {(one.name, tuple(type_.removeprefix("out ") for type_ in one.types)): one for one in found}, found


def _other(declared: Declaration, own: Block, library: Path) -> Declaration | None:
    """The function whose comment this one's comment refers to."""
    _, found = _declared(library)
    if name := FOR_ANOTHER.search(own.notes):
        size = re.search(r"\dd", declared.path.name)
        others = [one for one in found if one.name == name[1] and one.comment]
        return next((one for one in others if size and size[0] in one.path.name), others[0])
    refers = LIKE_ANOTHER.match(own.what) or any(map(OF_ABOVE.search, (own.what, own.notes, *own.entries.values())))
    before = [one for one in found if one.path == declared.path and one.comment
              and one.comment.line < declared.comment.line]
    return before[-1] if refers and before else None


def _whole(declared: Declaration, library: Path) -> Block:
    """The comment, with its lines from another one."""
    own = block(declared.comment.lines)
    other = _other(declared, own, library)
    if other is None:
        return own
    base = _whole(other, library)
    entries = {**base.entries, **own.entries}
    if "error" not in own.entries and "error" not in own.notes:
        entries.pop("error", "")
    for name, text in own.entries.items():
        if OF_ABOVE.search(text):
            of_base = base.entries.get(name, "").rstrip(".")
            if ", in the metric" in text:
                text, of_base = text.replace(", in the metric", ""), of_base.removesuffix(METRIC) + METRIC
            entries[name] = OF_ABOVE.sub(lambda _, shown=of_base: shown, text)
    what = own.what
    of_base = re.split(" ?This form", base.what)[0] if what.startswith("This form") else base.what
    if "The value is as above." in what:
        what = what.replace(" The value is as above.", "")
        entries["returns"] = f"{own.entries['returns']}. The value: {base.entries['returns']}"
        entries["error"] = f"{own.entries['error']}. Of the value {base.entries['error']}"
    if LIKE_ANOTHER.match(what):
        what = f"{of_base} {re.sub('^The same', 'This is the same', what)}"
    return Block(what, entries, base.notes)


def without_references(text: str) -> str:
    """Without what names a page or a file of the library."""
    text = re.sub(r" ?\([^()]*(?:docs/|\.glsl)[^()]*\)", "", text)
    text = re.sub(r" in \w+\.glsl", "", text)
    clauses = re.split(r"(?<=[.;:]) ", text)
    if REFERENCE.search(clauses[0]):
        return ""
    kept = " ".join(clause for clause in clauses if not REFERENCE.search(clause))
    return kept if kept == text else re.sub(r"[;:]$", ".", kept)


def _parameter(parameter: Parameter, text: str, may_be_left_out: bool) -> str:
    name, size = parameter.at.text, parameter.type[-1]
    text = TYPES.sub("", without_references(text))
    if name == "place" and IN_PLACE.match(text):
        of_octave = " of the first octave" if "first octave" in text else ""
        rest = text.partition(". ")[2]
        text = PLACE.format(of_octave, size) + (f". {rest}" if rest else "")
    return text if may_be_left_out else text.replace(LEFT_OUT, "")


def facts(function: Function, library: Path, has_overloads: bool, knobs: Settings = NO_SETTINGS) -> Facts:
    """With knobs those of a text that has no others."""
    types = tuple(type_.removeprefix("hn_") for type_ in function.types)
    declared = _declared(library)[0].get((function.name, types))
    if declared is None or declared.comment is None:
        return Facts()
    found = _whole(declared, library)
    seedless = has_overloads and (function.name, types[:-1]) in _declared(library)[0]
    returns = "" if function.type == "void" else found.entries.get("returns", "")
    what, error = found.what, found.entries.get("error", "")
    if knobs.arithmetic == "HN_FIXED" and (limits := found.entries.get("HN_FIXED", "")):
        what = f"{what} It {limits.partition('. ')[0]}."
        error = NO_GROWTH_OF.sub(NO_GROWTH, error)  # hn_fbm states it, and is hn_octaves at the same position
    return Facts(of_knobs(without_references(what), knobs),
                 {one.at.text: of_knobs(_parameter(one, found.entries.get(one.at.text, ""), seedless), knobs)
                  for one in function.parameters},
                 *(of_knobs(without_references(text).rstrip("."), knobs) for text in (returns, error)))


# In a text of one arithmetic, the patterns of text on others, and the text in its place with floats and with HN_FIXED.
# None leaves it.
OF_BOUND = r"(?: against the exact \w+| divided by the distance| / reach)?"
OF_ONE = (
    (r"less than \S+ \(HN_FIXED: (\S+)\)", None, r"less than \1"),
    (r" \(HN_FIXED: ([^()]*)\)", "", r" (\1)"),
    (r" \(HN_FIXED up to ([^()]*)\)", "", r" (up to \1)"),
    (rf"\bat most \S+({OF_BOUND})(?:(, in any metric)? and rounding mode|, in any rounding mode)?"
     r"\. HN_FIXED (\S+e-\d+)(?: divided by it| / reach)?", None, r"at most \3\1\2"),
    (r"\. HN_FIXED \S+e-\d+(?: divided by it| / reach)?", "", None),
    (r"\. From a cell at most \S+e-\d+(?: divided by it)?", None, ""),
    (r"\S+e-\d+ \(HN_FIXED (\S+)\)", None, r"\1"),
    (r" \(HN_FIXED \S+\)", "", None),
    (r"\. With HN_FIXED a(.*?)(?=\. |$)", "", r". A\1"),
    (r"\. HN_FIXED has the same bits everywhere", "", ". The bits are the same everywhere"),
    (r" \(with HN_FIXED; (roundings) of floats( [^()]*)\)", r" (\1\2)", ""),
    (r"outside of it HN_FIXED and fractals (take the nearer end), and for floats of other noises (no value is defined)",
     r"outside of it fractals \1, and for other noises \2", r"outside of it noises \1"),
    (r"\. HN_FIXED (cuts off .*?)\. Floats cut off neither", "", r". The function \1"),
    (r"; not negative, and the sum of its powers below 2\^126", None, ""),
)
OF_SINE = (
    (r"\S+e-\d+([^.;]*); HN_GRADIENT_SINE (\S+e-\d+)", r"\2\1"),
    (r"^none; with HN_GRADIENT_SINE ", ""),
    (r"^\S+ \S+ \(proven bound \S+\)(.*); with HN_GRADIENT_SINE, (which is not scaled), (\[.*?\]) and the rest alike",
     r"\3, \2\1"),
    (r"; with HN_GRADIENT_SINE, ", "; "),
)
NO_SINE = ((r"; (?:with )?HN_GRADIENT_SINE.*?(?=;|\. |$)", ""),)
NO_GROWTH = "it does not grow with the coordinates"
NO_GROWTH_OF = re.compile(r"at a position it grows with (?=\|p\|).*")


def of_knobs(text: str, knobs: Settings) -> str:
    """The part that holds with these alone."""
    if not knobs.arithmetic:
        return text
    for pattern, by in OF_SINE if knobs.gradient == "SINE" else NO_SINE:
        text = re.sub(pattern, by, text)
    text = re.sub(r"2\^126 \(HN_PRECISE: (\S+)\)", r"\1" if knobs.arithmetic == "HN_PRECISE" else "2^126", text)
    text = re.sub(r" \(HN_PRECISE: [^()]*\)", "", text)
    for pattern, with_floats, with_integers in OF_ONE:
        by = with_integers if knobs.arithmetic == "HN_FIXED" else with_floats
        text = text if by is None else re.sub(pattern, by, text)
    return text


def first_sentence(function: Function, library: Path) -> str:
    return re.split(r"\.(?: |$)", facts(function, library, False).what)[0] + "."


# Structs that users see, by how their names begin: {} stands for the functions that make one.
STRUCTS = {
    "hn_place": "Where noise is evaluated, made by {} and others. Later versions keep the cell of these fields.",
    "hn_i_octave_sum": "A part of octaves, whose fields later versions may change.",
    "hn_octaves": "The octaves of a loop, made by {} and others. Later versions keep the place and the seed of these "
                  "fields.",
    "hn_slopes": "The sum of the derivatives of a loop, made by {}, whose fields later versions may change.",
    "hn_shifts": "The sum of the displacements of a loop, made by {}, whose fields later versions may change.",
    "hn_flows": "The sum of the velocities of a loop, made by {}, whose fields later versions may change.",
    "hn_derivatives": "A result and its derivatives.",
    "hn_hexes": "The three hexagons that overlap at a position, a component for each."}
MAKERS = {"place": "in_cell", "octaves": "of", "slopes": "of", "shifts": "of", "flows": "of"}


def of_struct(name: str, called: Callable[[str], str]) -> str:
    """The comment of a struct. `called` writes the name of a function."""
    text = next((text for begin, text in STRUCTS.items() if name.startswith(begin)), "")
    found = OF_AXES.fullmatch(name)
    return text.format(called(f"hn_{found[1]}_{MAKERS[found[1]]}{found[2]}")) if found else text


# Examples of arguments, a number for each component; where there is no number, a variable of that name.
ARGUMENTS: Mapping[str, tuple[float, ...]] = {
    "octaves": (6,), "lacunarity": (2,), "gain": (0.5,), "seed": (7,), "jitter": (1,), "metric": (1,), "phase": (0.25,),
    "strength": (1,), "amplitude": (1,), "detail": (3.5,), "footprint": (0.125,), "wave": (4, 0, 0),
    "bandwidth": (1,), "radius": (0.75,), "depth": (0.125,), "slope": (0.5, 0), "period": (8, 8, 8, 8), "cell": (3, -5, 2, 0), "f": (0.25, 0.75, 0.5, 0),
    "position": (640, -320, 100, 0), "cells": (1,), "units": (64,), "h": (12345,), "k": (5,), "x": (12345,),
    "v": (12, 34, 56, 78), "i": (3,), "n": (0.25, 0.5, -0.5, 0), "kind": (2,), "value": (0.25,)}
# Functions with one name, by the type.
OTHER_ARGUMENTS = {("n", "uint"): (52,), ("v", "float"): (0.25, -0.5, 0.5)}


def arguments_of(function: Function, argument: Callable[[Parameter, Sequence[float] | None], str]) -> list[str]:
    """The arguments of a call. `argument` writes one, of a number for each component; without them it is a variable, or
    a position."""
    written = []
    for one in function.parameters:
        numbers = ARGUMENTS.get(one.at.text) if one.type in SIZES and not one.is_set else None
        numbers = OTHER_ARGUMENTS.get((one.at.text, scalar_of(one.type)), numbers)
        written.append(argument(one, numbers[:SIZES[one.type]] if numbers else None))
    return written


def lines(facts: Facts, variable: Callable[[str], str], call: str) -> list[str]:
    """The lines of a comment, without the slashes, in the library's order. The names of the parameters
    are what `variable` makes of them."""
    rows = {**{variable(name): text for name, text in facts.parameters.items()}, "example": call,
            "returns": facts.returns, "error": facts.error}
    return laid_out(facts.what, rows)


def laid_out(what: str, rows: Mapping[str, str], columns: int = 117) -> list[str]:
    """A paragraph, and behind it the rows that have a text."""
    width = max(map(len, rows))
    written = textwrap.wrap(what, columns, initial_indent=" ", subsequent_indent=" ")
    for name, text in rows.items():
        written += textwrap.wrap(text, columns, initial_indent=f"   {name:{width}}  ", subsequent_indent=" " * (width + 5))
    return written
