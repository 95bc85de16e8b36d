"""Bounds are quoted in tables in docs/measured/accuracy.md, which are written from here, and as numbers in prose and in
the comments of the library, which are compared."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

from base.tree import ROOT
from catalog.tables import glsl
from catalog.tables.functions import BANDWIDTH
from catalog.tables.markdown import table, with_section
from proof.bounds import jacobians, noises, smoothness, sums
from proof.bounds.gradients import GRADIENTS, SINE, Gradient
from proof.bounds.noises import ProvenBounds
from proof.bounds.table import bounds_of, rounded_up, scientific, shortest, slope_bounds_of
from proof.errors import record
from proof.errors.record import CELL, DERIVATIVE, FIXED, FLOATS, OFFSET, POSITION, VALUE
from proof.errors.results import SETTINGS, Setting

ACCURACY = "docs/measured/accuracy.md"
KNOBS = "docs/reference/knobs.md"
SUMS = "docs/reference/fractals.md"
Key = tuple[str, int, Gradient | None]  # a noise, the number of its dimensions, a kind of gradient
Everything = dict[Key, ProvenBounds]
PHASE = "_phase"  # ends the name of a noise with the forms that take one
FORMS = {PHASE: "with a phase", BANDWIDTH: "with a bandwidth"}
OF_A_NAME = ("cellular_phase",)  # with which the function's name ends, too
NOISE_OF_SUMS = "perlin"  # unless the user names another

# --- Tables -----------------------------------------------------------------------------------------------------------


def name_of(key: Key) -> str:
    noise, dims, gradient = key
    position = f"vec{dims}" if dims > 1 else "float"
    form = next((form for form in FORMS if noise.endswith(form) and noise not in OF_A_NAME), "")
    kind = FORMS.get(form) or (gradient and gradient.name)
    return f"`hn_{noise.removesuffix(form)}({position})`" + (f", {kind}" if kind else "")


def values_of(derived: Everything) -> Everything:
    """Without the noises that return derivatives, with values of another, or only what derivatives make."""
    return {key: of_noise for key, of_noise in derived.items() if of_noise.promise and not of_noise.slope}


def slopes_of(derived: Everything) -> Everything:
    """The derivatives, and results made of them."""
    return {key: of_noise.slope or of_noise for key, of_noise in derived.items()
            if of_noise.slope or not of_noise.promise}


def bounds_table(derived: Everything) -> str:
    rows = []
    for key, of_noise in derived.items():
        row = of_noise.bounds(*key).rounded()
        if math.isinf(row.lipschitz) or "_vector" in key[0]:
            continue  # a sentence has random numbers, and that each component of a vector is such a noise
        rows.append([name_of(key), shortest(of_noise.range, 6), f"{row.lipschitz:.2f}", scientific(of_noise.cell_error),
                     scientific(of_noise.error), scientific(of_noise.fixed_error)])
    return table(("", "range", "L", "floats: from a cell", "from a position", "fixed"), rows)


JACOBIANED = sums.SLOPED + sums.SHIFTS + sums.FLOWS  # sums with a table of their own


def title_of(setting: Setting, dims: int, place: str = POSITION) -> str:
    """Of a row: the tables keep them, since frozen bounds have these names."""
    if setting.is_own:
        return f"the same over `hn_simplex_d(vec{dims})`, in a loop"
    type_ = f"hn_place{dims}" if place == CELL else f"vec{dims}" if dims > 1 else "float"
    words = "a derivative" if setting.sum == "fbm_d" else setting.words
    return f"`hn_{setting.sum}({type_})`" + (" " if words == "further out" else ", ") * bool(words) + words


def error_of(setting: Setting, dims: int, gradient: str, place: str, arithmetic: str, result: str = VALUE) -> str:
    return scientific(record.published(setting.sum, dims, gradient, result, place, arithmetic, setting.words), 2)


def sums_table() -> str:
    head = [f"{gradient.name}, {arithmetic}" for gradient in GRADIENTS for arithmetic in ("fast and precise", "fixed")]
    rows = []
    for setting in SETTINGS:
        for dims, place in ((dims, place) for dims in setting.dims for place in setting.places if setting.sum in sums.KINDS):
            errors = [error_of(setting, dims, gradient, of_place, arithmetic) for gradient in setting.gradients_in(dims)
                      for of_place, arithmetic in ((place, FLOATS), (setting.places[-1], FIXED))]
            rows.append([title_of(setting, dims, place), *errors, *[""] * (len(head) - len(errors))])
    return table(("", *head), rows)


def jacobians_table() -> str:
    rows = []
    for dims in (2, 3):
        for setting in (setting for setting in SETTINGS if setting.sum in JACOBIANED):
            result = DERIVATIVE if setting.sum == "fbm_d" else VALUE
            rows.append([title_of(setting, dims), *(error_of(setting, dims, setting.gradients[0], place, arithmetic, result)
                                                    for place, arithmetic in ((POSITION, FLOATS), (CELL, FLOATS), (CELL, FIXED)))])
    return table(("", "fast and precise: from a position", "from a cell", "fixed"), rows)


def gullies_table() -> str:
    rows = [[setting.words, *(error_of(setting, 2, "none", CELL, arithmetic, result)
                              for arithmetic in (FLOATS, FIXED) for result in (VALUE, DERIVATIVE))]
            for setting in SETTINGS if setting.sum == "gullies"]
    return table(("", "fast and precise: height", "a slope", "fixed: height", "a slope"), rows)


TABLES: dict[str, Callable[[Everything], str]] = {
    "noises": lambda derived: bounds_table(values_of(derived)),
    "derivatives": lambda derived: bounds_table(slopes_of(derived)), "sums": lambda _: sums_table(),
    "Jacobians": lambda _: jacobians_table(), "gullies": lambda _: gullies_table(), "steps": lambda _: smoothness.steps_table()}


def with_tables(text: str, derived: Everything) -> str:
    """The page with its tables written anew."""
    for name, write in TABLES.items():
        text = with_section(ACCURACY, text, f"tools/make bounds: {name}", write(derived))
    return text


# --- Prose ------------------------------------------------------------------------------------------------------------


def jacobians_overflow() -> float:
    """The largest of sums with slopes and of warps, in the domain of their bounds."""
    return float(rounded_up(max(jacobians.largest_intermediates(3).values()) / 2**31, 3))


def quotes(derived: Everything) -> list[tuple[str, str]]:
    """Pairs of a file and a text that must stand in it."""
    plane, space = (derived[NOISE_OF_SUMS, dims, GRADIENTS[0]] for dims in (2, 3))
    stated = [(KNOBS, f"| {scientific(plane.error)} | {scientific(space.error)} |"),
              (KNOBS, f"| {scientific(plane.fixed_error)} | {scientific(space.fixed_error)} |"),
              (KNOBS, f"with `HN_FIXED` within {scientific(of_sine(True), 2)}")]
    steepest = [shortest(jacobians.longest_gradient(bounds_of(NOISE_OF_SUMS, dims, GRADIENTS[0].name),
                                                    slope_bounds_of(f"{NOISE_OF_SUMS}_d", dims)), 3) for dims in (2, 3)]
    stated.append((ACCURACY, f"no longer than {steepest[0]} in 2D and {steepest[1]} in 3D"))
    steepest_component = max(bounds_of_slopes.limit for bounds_of_slopes in jacobians.fitting_slopes())
    stated.append((SUMS, f"has slopes up to {shortest(steepest_component, 3)}"))
    limits = [f"{derived[NOISE_OF_SUMS, dims, SINE].bounds('', dims, SINE).rounded().limit:g} in {dims}D"
              for dims in (2, 3)]
    stated += [(ACCURACY, text) for text in (
        f"in floats at most {limits[0]}, {limits[1]}",
        f"{jacobians_overflow():g} * 2^31 in a sum of slopes")]
    return stated + [quote for name in noises.names() for quote in noises.find(name).quotes()]


def of_sine(fixed: bool) -> float:
    """The error of a component of the sine gradient."""
    return record.published("sine", 0, "sine", arithmetic=FIXED if fixed else FLOATS)


def missing_quotes(derived: Everything, root: Path = ROOT) -> list[str]:
    texts: dict[str, str] = {}
    messages = []
    for path, text in quotes(derived):
        if path not in texts:
            texts[path] = (root / path).read_text(encoding="utf-8")
        if text not in texts[path]:
            messages.append(f"{path}: it must state {text.strip()!r}")
    return messages


# --- The comments of the library --------------------------------------------------------------------------------------

# The kind of a number, in reading order: a heading, a knob, or a number.
# The range of a derivative has few decimals, and is known by its brackets. "of the offset": the errors after it are
# for the out parameter. "From a cell": those after it are for places that hn_place makes of a cell and a fraction,
# and smaller than for positions. Under `error` any other number with a point or a power is an error as well, but not a
# position "2^-20 below" another.
WORD = re.compile(r"^   ?(?P<heading>[a-z]+)  |HN_FIXED|HN_GRADIENT_SINE|(?P<offset>of the offset)"
                  r"|(?P<cell>[Ff]rom a cell)|(?P<error>\d\.\d+e-\d+)"
                  r"|(?P<range>\d\.\d{3,}|(?<=\[-)\d+\.\d+|\d+\.\d+(?=\]))"
                  r"|(?P<other>\d+\^-\d+\b(?! below)|[\d.]+e-\d+|\d+\.\d+)", re.MULTILINE)
NO_ERROR = re.compile(r"^   ?error  +none", re.MULTILINE)
REFERS = re.compile(r"^   ?error  +as ", re.MULTILINE)  # to another comment, instead of a number


def dimensions_of(function: glsl.Declaration) -> int:
    position = function.types[0]
    return int(position[-1]) if position[-1].isdigit() else 1


def takes_phase(function: glsl.Declaration) -> bool:
    """On the line a float is a position. Octave sums take floats, too; they are no noises. The float of hn_cellular is
    the jitter, for which one bound holds."""
    with_phase = function.name.removeprefix("hn_") + PHASE
    return (dimensions_of(function) > 1 and "float" in function.types and with_phase not in OF_A_NAME
            and with_phase in noises.names())


def noise_of(function: glsl.Declaration) -> str:
    name = function.name.removeprefix("hn_")
    takes_bandwidth = f"{name}{BANDWIDTH}" in noises.names() and function.types.count("float") > 1
    return name + BANDWIDTH * takes_bandwidth + PHASE * takes_phase(function)


def of_function(function: glsl.Declaration, gradient: Gradient, derived: Everything) -> ProvenBounds:
    noise, dims = noise_of(function), dimensions_of(function)
    return derived.get((noise, dims, gradient)) or derived[noise, dims, None]


# The comments of these functions state the errors of these numbers.
UNIFORM = {"hn_uniform": "value", "hn_uniform_d": "slope", "hn_distribution_fbm": "coefficient"}


def derived_for(function: glsl.Declaration, kind: str, fixed: bool, gradient: Gradient,
                derived: Everything, place: int = 0) -> float | None:
    """The right value of a number in the comment of a function, rounded up: an "error", that "in a cell", that of an
    "offset", or the end of a "range". Where there are several ends, they have a place."""
    if noise_of(function) in noises.names():
        proof, dims = noises.find(noise_of(function)), dimensions_of(function)
        if kind == "offset":
            return offset_error(noise_of(function), dims, fixed)
        if kind == "range" and proof.ends:
            ends = proof.ends(dims)
            return ends[place] if place < len(ends) else None
        of_noise = of_function(function, gradient, derived)
        of_noise = of_noise.slope or of_noise  # the value is another noise's
        if kind == "range":
            return of_noise.range if of_noise.promise else max(of_noise.largest, of_noise.fixed_largest)
        return of_noise.fixed_error if fixed else of_noise.cell_error if kind == "in a cell" else of_noise.error
    if function.name == "hn_gradient" and kind == "error":
        return of_sine(fixed)
    if function.name == "hn_clouds" and kind == "error":
        return record.published("clouds", 0, "none", "density", arithmetic=FIXED if fixed else FLOATS)
    if function.name == "hn_fraction" and kind == "error":
        return 2.0**-24  # to which it is cut off
    if function.name == "hn_fbm_d" and kind == "range":
        return sums.ROTATIONS[0]  # by which a derivative's range grows
    if function.name in UNIFORM and kind == "error":
        return record.published("uniform", 0, "none", UNIFORM[function.name], arithmetic=FIXED if fixed else FLOATS)
    return None


def offset_error(noise: str, dims: int, fixed: bool) -> float | None:
    """In floats the larger one of those from a position and from a cell."""
    found = [entry.published for key, entry in record.read().items() if (key.name, key.dims, key.result) == (noise, dims, OFFSET)
             and (key.arithmetic == FIXED) == fixed]
    return max(found, default=None)


def wrong_numbers(function: glsl.Declaration, derived: Everything) -> dict[tuple, str]:
    """The faults of the comment over a function, by the line, the number and the right value."""
    messages, heading, fixed, gradient, offset_next, in_cell, ends = {}, "", False, GRADIENTS[0], False, False, 0
    text = "\n".join(function.comment.lines)
    if (noise_of(function) in noises.names() and not REFERS.search(text)
            and not (NO_ERROR.search(text) and of_function(function, gradient, derived).error == 0)
            and not any(word["error"] for word in WORD.finditer(text))):
        place = f"{function.path}:{function.comment.line}"
        messages[place, "", ""] = f"{place}: the comment over {function} states no error"
    for offset, text in enumerate(function.comment.lines):
        for word in WORD.finditer(text):
            if word["heading"]:
                heading, fixed, gradient, offset_next, in_cell = word["heading"], False, GRADIENTS[0], False, False
            elif word["cell"]:
                fixed, gradient, in_cell = False, GRADIENTS[0], True
            elif word["offset"]:
                fixed, offset_next = False, True
            elif word[0] == "HN_FIXED":
                fixed, gradient = True, GRADIENTS[0]
            elif word[0] == "HN_GRADIENT_SINE":
                gradient = SINE
            elif heading == "error" or not word["other"]:
                kind = ("range" if word["range"] else "offset" if offset_next else "in a cell" if in_cell
                        else "error")
                value = derived_for(function, kind, fixed, gradient, derived, ends)
                ends, digits = ends + (kind == "range"), len(_significant(word[0]))
                right = value and (shortest(value, digits) if kind == "range" else
                                   f"2^{math.ceil(math.log2(value))}" if "^" in word[0] else scientific(value, digits))
                if word[0] != right:
                    place = f"{function.path}:{function.comment.line + offset}"
                    messages[place, word[0], right] = (f"{place}: {word[0]} of {function} "
                                                       + (f"should be {right}" if right else "is derived nowhere"))
    return messages


def _significant(number: str) -> str:
    return number.partition("e")[0].replace(".", "").lstrip("0")


def wrong_comments(derived: Everything, library: Path = glsl.LIBRARY) -> list[str]:
    messages: dict[tuple, str] = {}  # overloads share a comment
    for function in glsl.declarations(library):
        if function.comment:
            messages = wrong_numbers(function, derived) | messages
    return list(messages.values())
