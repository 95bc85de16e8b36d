"""Bounds are quoted in tables in docs/measured/accuracy.md, which are written from here, and as numbers in prose and in
the comments of the library, which are compared."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from base.tree import ROOT
from catalog.tables import glsl
from catalog.tables.functions import BANDWIDTH
from catalog.tables.markdown import table, with_section
from proof.bounds import gullies, jacobians, noises, own, rotations, rounded, sine, smoothness, sums, uniform
from proof.bounds.gradients import GRADIENTS, SINE, Gradient
from proof.bounds.integers import fade_errors, slope_errors
from proof.bounds.noises import ProvenBounds
from proof.bounds.prover import Job, Prover
from proof.bounds.sums import Sum
from proof.bounds.table import Bounds, bounds_of, closer, rounded_up, scientific, shortest, slope_bounds_of

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


def _bounds_table(derived: Everything, largest: str) -> str:
    rows = []
    for key, of_noise in derived.items():
        row = of_noise.bounds(*key).rounded()
        if math.isinf(row.lipschitz) or "_vector" in key[0]:
            continue  # a sentence has random numbers, and that each component of a vector is such a noise
        rows.append([name_of(key), shortest(of_noise.range, 6), f"{row.lipschitz:.2f}", scientific(of_noise.cell_error),
                     scientific(of_noise.error), f"{row.limit:g}", scientific(of_noise.fixed_error),
                     f"{row.fixed_limit:g}"])
    return table(("", "range, exact", "L", "fast and precise: from a cell", "from a position", largest,
                  "fixed: error", largest), rows)


def noise_table(derived: Everything) -> str:
    return _bounds_table(values_of(derived), "largest value")


def slope_table(derived: Everything) -> str:
    return _bounds_table(slopes_of(derived), "largest derivative")


EXAMPLES = (  # of octave sums: a title, the number of dimensions, the sum
    ("`hn_fbm(hn_place2)`, a tile, exact positions", 2,
     Sum("fbm", 16.0, 5, 2.0, 0.5, rotates=False, from_cell=True, exact_positions=True)),
    ("`hn_fbm(hn_place2)`, a tile", 2, Sum("fbm", 16.0, 5, 2.0, 0.5, rotates=False, from_cell=True)),
    ("`hn_fbm(float)`", 1, Sum("fbm", 16.0, 5, 2.0, 0.5)),
    ("`hn_fbm(vec2)`", 2, Sum("fbm", 16.0, 5, 2.0, 0.5)),
    ("`hn_fbm(vec3)`", 3, Sum("fbm", 16.0, 5, 2.0, 0.5)),
    ("`hn_fbm(vec4)`", 4, Sum("fbm", 16.0, 5, 2.0, 0.5)),
    ("`hn_fbm(vec3)` further out", 3, Sum("fbm", 1024.0, 8, 2.0, 0.5)),
    ("`hn_fbm(hn_place3)` further out", 3, Sum("fbm", 1024.0, 8, 2.0, 0.5, from_cell=True)),
    ("`hn_fbm(vec2)`, 4.5 octaves", 2, Sum("fbm", 16.0, 4.5, 2.0, 0.5)),
    ("`hn_fbm(vec2)`, a footprint of 1/16", 2, Sum("fbm", 16.0, 5, 2.0, 0.5, footprint=1 / 16)),
    ("`hn_turbulence(vec2)`", 2, Sum("turbulence", 16.0, 5, 2.0, 0.5)),
    ("`hn_clouds(vec2)`", 2, Sum("clouds", 16.0, 5, 2.0, 0.5)),
    ("`hn_billow(vec2)`", 2, Sum("billow", 16.0, 5, 2.0, 0.5)),
    ("`hn_ridged(vec2)`", 2, Sum("ridged", 16.0, 5, 2.0, 0.5)),
    ("`hn_ping_pong(vec2)`, strength 2", 2, Sum("ping_pong", 16.0, 5, 2.0, 0.5, strength=2.0)),
    ("`hn_weighted(vec2)`, strength 1", 2, Sum("weighted", 16.0, 5, 2.0, 0.5, strength=1.0)))


def sum_tolerances(derived: Everything, dims: int, octave_sum: Sum) -> list[float]:
    """In floats and fixed, for each kind of gradient that has a noise."""
    keys = [(NOISE_OF_SUMS, dims, gradient) for gradient in GRADIENTS if (NOISE_OF_SUMS, dims, gradient) in derived]
    return [tolerance(octave_sum, closer(derived[key].bounds(*key).rounded())) for key in keys
            for tolerance in (sums.octave_tolerance, sums.fixed_octave_tolerance)]


def sums_table(derived: Everything) -> str:
    head = [f"{gradient.name}, {arithmetic}" for gradient in GRADIENTS for arithmetic in ("fast and precise", "fixed")]
    rows = [[title] + [scientific(tolerance, 2) for tolerance in sum_tolerances(derived, *arguments)]
            for title, *arguments in EXAMPLES]
    return table(("", *head), [row + [""] * (1 + len(head) - len(row)) for row in rows])


JACOBIAND = (  # of sums with slopes, and of warps: a title, the sum, and a noise if it is not the sum's own
    ("`hn_fbm_d(vec{})`, a derivative", Sum("fbm_d", 16.0, 5, 2.0, 0.5)),
    ("the same over `hn_simplex_d(vec{})`, in a loop", Sum("fbm_d", 16.0, 5, 2.0, 0.5), "simplex"),
    ("`hn_eroded(vec{})`, strength 1", Sum("eroded", 16.0, 5, 2.0, 0.5, strength=1.0)),
    ("`hn_eroded(vec{})`, strength 16", Sum("eroded", 16.0, 5, 2.0, 0.5, strength=16.0)),
    ("`hn_warp(vec{})`, amplitude 1/2", Sum("warp", 16.0, 5, 2.0, 0.5, amplitude=0.5)),
    ("`hn_warp_progressive(vec{})`, amplitude 1/4", Sum("warp_progressive", 16.0, 5, 2.0, 0.5, amplitude=0.25)),
    ("`hn_warp_progressive(vec{})`, amplitude 1/2", Sum("warp_progressive", 16.0, 5, 2.0, 0.5, amplitude=0.5)),
    ("`hn_warp_progressive(vec{})`, amplitude 1", Sum("warp_progressive", 16.0, 5, 2.0, 0.5, amplitude=1.0)),
    ("`hn_curl_fbm(vec{})`", Sum("curl_fbm", 16.0, 5, 2.0, 0.5), "curl"),
    ("`hn_curl_fbm(vec{})`, with a phase", Sum("curl_fbm", 16.0, 5, 2.0, 0.5, phase=0.25), "curl_phase"))


def noises_of_jacobians(derived: Everything, dims: int, kind: str, other: str = "") -> tuple[Bounds, ...]:
    """The bounds of the noise that such a sum is over, its own or another, and of its derivatives if these count."""
    if kind in sums.FLOWS:
        key = (other, dims, None)
        return (derived[key].bounds(*key).rounded() if key in derived else bounds_of(other, dims, "none"),)
    noise, gradient = (NOISE_OF_SUMS, GRADIENTS[0]) if not other and kind not in sums.SHIFTS else (other or "value", None)
    if (noise, dims, gradient) not in derived:
        return bounds_of(noise, dims, "none"), slope_bounds_of(f"{noise}_d", dims)
    value, slope = derived[noise, dims, gradient], derived[f"{noise}_d", dims, gradient].slope
    return (value.bounds(noise, dims, gradient).rounded(), slope.bounds(f"{noise}_d", dims, gradient).rounded())


def jacobian_tolerances(derived: Everything, dims: int, s: Sum, other: str = "") -> list[float]:
    """In floats from a position, in floats from a cell, and fixed."""
    bounds = noises_of_jacobians(derived, dims, s.kind, other)
    floats, fixed = jacobians.TOLERANCES[s.kind]
    return [floats(s, *bounds), floats(replace(s, from_cell=True), *bounds), fixed(s, *bounds)]


def jacobians_table(derived: Everything) -> str:
    rows = [[title.format(dims)] + [scientific(tolerance, 2) for tolerance in jacobian_tolerances(derived, dims, *of)]
            for dims in (2, 3) for title, *of in JACOBIAND]
    return table(("", "fast and precise: from a position", "from a cell", "fixed"), rows)


CUT = tuple(  # of gullies: a title, the sum, the length of the slope, the depth
    (f"{count} octaves, depth {depth:g}, a slope of {slope:g}",
     Sum("fbm", 16.0, count, 2.0, 0.5, rotates=False, from_cell=True), slope, depth)
    for count, slope, depth in ((2, 1.0, 0.1), (3, 1.0, 0.05), (3, 1.0, 0.1), (3, 3.0, 0.1), (5, 1.0, 0.05),
                                (5, 3.0, 0.05), (5, 1.0, 0.1), (5, 3.0, 0.1), (5, 3.0, 0.2)))


def gullies_table(_: Everything) -> str:
    bounds = gullies.bounds().rounded()
    rows = [[title, *(scientific(error, 2) for of in (gullies.float_tolerance, gullies.fixed_tolerance)
                      for error in of(s, slope, depth, bounds))] for title, s, slope, depth in CUT]
    return table(("", "fast and precise: height", "a slope", "fixed: height", "a slope"), rows)


TABLES: dict[str, Callable[[Everything], str]] = {
    "noises": noise_table, "derivatives": slope_table, "sums": sums_table, "Jacobians": jacobians_table,
    "gullies": gullies_table, "steps": lambda _: smoothness.steps_table()}


EXAMPLE = "noise2d.perlin_cell"


def example() -> str:
    """The parts of a bound by the lines of the text that round, in the box where it is largest."""
    prover = Prover({EXAMPLE: rounded.table()[EXAMPLE]}, "PROVER_TRACE", options=own.OPTIONS)
    proven, = prover.prove([Job(EXAMPLE, ("value",), {}, tolerance=1e-4)])
    found: dict[str, list[float]] = {}
    for size, frames in proven.parts:
        found.setdefault(own.place_of(frames, prover), []).append(size)
    rows = []
    for place, sizes in found.items():
        name, line = (ROOT / place).resolve().relative_to(ROOT).as_posix().rsplit(":", 1)
        code = (ROOT / name).read_text(encoding="utf-8").splitlines()[int(line) - 1].split("= ", 1)[1]
        rows.append([f"`{code}`", f"`{name.removeprefix('glsl/hashnoise/')}:{line}`", str(len(sizes)), scientific(sum(sizes))])
    ends = " and ".join(f"[{lo:.5f}, {hi:.5f}]" for lo, hi in proven.box)
    text = table(("step", "where", "numbers that err", "adds"), rows)
    return f"{text}\nThe fractions are in {ends}, and the sum is {scientific(proven.bound, 4)}: one of {proven.boxes} boxes.\n"


def with_tables(text: str, derived: Everything, *more: str) -> str:
    """The page with its tables written anew, and the example if `more` names it."""
    for name, write in [*TABLES.items(), *((name, lambda _: example()) for name in more)]:
        text = with_section(ACCURACY, text, f"tools/make bounds: {name}", write(derived))
    return text


# --- Prose ------------------------------------------------------------------------------------------------------------


def overflow(derived: Everything) -> float:
    """How much of 2^31 the largest of the intermediates that are not checked as evaluated takes."""
    return float(rounded_up(max(of_noise.fixed_intermediate for of_noise in derived.values()) / 2**31, 2))


def jacobians_overflow() -> float:
    """The largest of sums with slopes and of warps, in the domain of their bounds."""
    return float(rounded_up(max(jacobians.largest_intermediates(3).values()) / 2**31, 3))


def quotes(derived: Everything) -> list[tuple[str, str]]:
    """Pairs of a file and a text that must stand in it."""
    plane, space = (derived[NOISE_OF_SUMS, dims, GRADIENTS[0]] for dims in (2, 3))
    stated = [(KNOBS, f"| {scientific(plane.error)} | {scientific(space.error)} |"),
              (KNOBS, f"| {scientific(plane.fixed_error)} | {scientific(space.fixed_error)} |"),
              (KNOBS, f"with `HN_FIXED` within {scientific(sine.fixed_sine_error(), 2)}")]
    steepest = [shortest(jacobians.longest_gradient(*noises_of_jacobians(derived, dims, "fbm_d")), 3) for dims in (2, 3)]
    stated.append((ACCURACY, f"no longer than {steepest[0]} in 2D and {steepest[1]} in 3D"))
    steepest_component = max(bounds_of_slopes.limit for bounds_of_slopes in jacobians.fitting_slopes())
    stated.append((SUMS, f"has slopes up to {shortest(steepest_component, 3)}"))
    limits = [f"{derived[NOISE_OF_SUMS, dims, SINE].bounds('', dims, SINE).rounded().limit:g} in {dims}D"
              for dims in (2, 3)]
    stated.append((ACCURACY, f"in floats at most {limits[0]}, {limits[1]}"))
    stated += [(ACCURACY, text) for text in (
        f"by -{scientific(-slope_errors().min())} to {scientific(slope_errors().max())},",
        f"in 3D: {overflow(derived):g} * 2^31",
        f"{jacobians_overflow():g} * 2^31 in a sum of slopes",
        f"{scientific(-fade_errors().min())} too small",
        f"{scientific(fade_errors().max())} too large",
        f"|s - sin| <= {scientific(sine.sine_bound())}",
        f"2^-19 = {scientific(SINE.component_error)}", f"which is {scientific(sine.fixed_sine_error())}:",
        f"at most 1 - {math.floor((1 - sine.sine_largest()) * 1e9) / 1e9:.2e}".replace("e-0", "e-"),
        f"adds {scientific(sums.cloud_error())} ",
        f"within {scientific(rotations.float_error())} of those of the phase",
        f"which adds {scientific(rotations.fixed_rounding(3))} for each unit")]
    stated += [(ACCURACY, text) for text in (*uniform.quotes(), *gullies.quotes())]
    return stated + [quote for name in noises.names() for quote in noises.find(name).quotes()]


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
            return proof.offset_error(dims, fixed) if proof.offset_error else None
        if kind == "range" and proof.ends:
            ends = proof.ends(dims)
            return ends[place] if place < len(ends) else None
        of_noise = of_function(function, gradient, derived)
        of_noise = of_noise.slope or of_noise  # the value is another noise's
        if kind == "range":
            return of_noise.range if of_noise.promise else max(of_noise.largest, of_noise.fixed_largest)
        return of_noise.fixed_error if fixed else of_noise.cell_error if kind == "in a cell" else of_noise.error
    if function.name == "hn_gradient" and kind == "error":
        return sine.fixed_sine_error() if fixed else SINE.component_error
    if function.name == "hn_clouds" and kind == "error":
        return sums.cloud_error() if fixed else beyond_fbm("clouds")
    if function.name == "hn_fraction" and kind == "error":
        return 2.0**-24  # to which it is cut off
    if function.name == "hn_fbm_d" and kind == "range":
        return sums.ROTATIONS[0]  # by which a derivative's range grows
    if function.name in UNIFORM and kind == "error":
        return getattr(uniform.errors(fixed), UNIFORM[function.name])
    return None


def beyond_fbm(kind: str) -> float:
    """The error of a sum beyond an fBm's: the error of no octaves."""
    return sums.octave_tolerance(Sum(kind, 0.0, 0, 2.0, 0.5), Bounds(NOISE_OF_SUMS, 2, "none", *[0.0] * 6))


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
