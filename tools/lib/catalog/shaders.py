"""GLSL of sums from the catalog: their loops and forms, and the public steps in loops.

tools/make dimensions makes the other dimensions from this text for the plane.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from pathlib import Path

from base.tree import GLSL
from catalog.model import Catalog, CatalogError, Sum
from catalog.python import WIDTH
from catalog.sections import with_section

SUMS, STEPS = "glsl/hashnoise/fbm2d.glsl", "glsl/hashnoise/octaves2d.glsl"
OCTAVE = "hn_perlin(o.place, o.seed)"
PLACES = ("hn_place2 place", "hn_vec2 p")
SETTINGS = ("hn_int octaves", "hn_float lacunarity", "hn_float gain")


def sums_of_values(catalog: Catalog) -> list[Sum]:
    """The steps in fbm2d.glsl."""
    return [sum_ for sum_ in catalog.sums if sum_.is_of_values]


def check_steps(sums: Sequence[Sum]) -> None:
    """A step may also exist for a detail or a footprint, which add a part of an octave: no sum has such a one."""
    text = (GLSL / "detail" / "octave.glsl").read_text(encoding="utf-8")
    steps = set(re.findall(r"\bhn_i_add_(\w+)\(hn_i_octave_sum s, hn_float n[,)]", text)) - {"detail", "footprint"}
    for sum_ in sums:
        if sum_.step not in steps:
            raise CatalogError(f"catalog/sums.toml: {sum_.name}: step is {sum_.step!r}, and has to be one of "
                               f"{', '.join(sorted(steps))}, or a new hn_i_add_{sum_.step}(s, n) in "
                               "glsl/hashnoise/detail/octave.glsl")


def named(text: str) -> str:
    """A text of the catalog in a comment: `fbm` is hn_fbm."""
    return re.sub(r"`(\w+)`", r"hn_\1", text)


def commented(text: str, heading: str = "") -> str:
    """A paragraph, or the text behind a heading."""
    first, rest = (f"//   {heading:<11} ", "//" + 15 * " ") if heading else ("// ", "// ")
    return "".join(f"{line}\n" for line in textwrap.wrap(text, WIDTH, initial_indent=first, subsequent_indent=rest,
                                                         break_long_words=False, break_on_hyphens=False))


def function(head: str, parameters: Sequence[str], body: str) -> str:
    """A function, its parameters in as many lines as they need."""
    one = f"{head}({', '.join(parameters)}) {{ {body} }}"
    if len(one) <= WIDTH:
        return f"{one}\n"
    indent = " " * (len(head) + 1)
    whole = [parameter.replace(" ", "\0") for parameter in parameters]
    lines = textwrap.wrap(", ".join(whole), WIDTH - len(") {"), initial_indent=indent, subsequent_indent=indent)
    return f"{head}({chr(10).join(lines).lstrip()}) {{\n  {body}\n}}\n".replace("\0", " ")


def loop(sum_: Sum) -> str:
    strength = ["strength"] if sum_.strength else []
    if sum_.mean in ("", "density"):
        mean = f"hn_{sum_.mean or 'mean'}(o)"
    else:
        mean = f"hn_i_value({sum_.makes('hn_i_mean(o.sum)')})"
    parameters = ", ".join(["hn_octaves2 o", *(f"hn_float {name}" for name in strength)])
    return (f"HN_FN hn_float hn_i_{sum_.name}({parameters}) {{\n"
            f"  do {sum_.adds_to('o', OCTAVE)};\n  while (hn_next(o));\n  return {mean};\n}}\n")


def comment(sum_: Sum) -> str:
    about = re.sub(r",? \{dimensions\}", "", f"{sum_.about} {sum_.more}".strip())
    if sum_.strength:
        settings = [commented(named(sum_.strength.about), "strength"),
                    "//   (other parameters, period and cost as for hn_fbm; the strength stands behind the gain, and "
                    "the seed cannot be\n//   left out)\n"]
    else:
        settings = ["//   (parameters, period and cost as for hn_fbm)\n"]
    strength = f", {sum_.strength.default:.1f}" if sum_.strength else ""
    example = f"//   {'example':<11} float n = hn_{sum_.name}(uv * 8.0, 6, 2.0, 0.5{strength}, 7u);\n"
    return "".join([commented(named(about)), *settings, example, commented(named(sum_.returns), "returns"),
                    commented(named(sum_.error), "error"), commented(named(sum_.source), "source")])


def forms(sum_: Sum) -> str:
    """At a place and at a position with a seed, and at a position without. A sum with a strength has no form without a
    seed: whoever forgot the strength there would have passed the seed for it."""
    strength = ["strength"] if sum_.strength else []
    settings = [*SETTINGS, *(f"hn_float {name}" for name in strength)]
    names = [setting.split()[1] for setting in settings]
    head = f"HN_FN hn_float hn_{sum_.name}"

    def of_octaves(place: str) -> str:
        octaves = f"hn_octaves({', '.join([place.split()[1], 'octaves', 'lacunarity', 'gain', 'seed'])})"
        return function(head, [place, *settings, "hn_uint seed"],
                        f"return hn_i_{sum_.name}({', '.join([octaves, *strength])});")

    without = function(head, [PLACES[1], *settings], f"return hn_{sum_.name}({', '.join(['p', *names, '0u'])});")
    return "".join([*map(of_octaves, PLACES), *([] if sum_.strength else [without])])


def public_steps(sums: Sequence[Sum]) -> str:
    """Each once, with the sums that are made of it."""
    owners: dict[str, list[Sum]] = {}
    for sum_ in sums:
        if sum_.public_step:
            owners.setdefault(sum_.public_step, []).append(sum_)
    kinds = [f"{of[0].adds_words} ({', '.join(f'hn_{sum_.name}' for sum_ in of)})" for of in owners.values()]
    head = commented(f"Add the noise of an octave: {'; '.join(kinds)}.")
    return head + """\
//   o         the octaves
//   n         the noise at o.place with o.seed, in [-1, 1]. hn_add and hn_add_turbulence take values beyond (HN_FIXED
//             up to 3/2), others cut them off. hn_add takes whole octaves: of hn_octaves(p, 4.5, ...) it adds 5, and
//             hn_add_detail half of the last
//   strength  of hn_ping_pong, usually 2, in [0, 64]; of hn_weighted, usually 1, in [0, 1]
//   example   do hn_add(o, hn_value(o.place, o.seed)); while (hn_next(o));
//   returns   nothing: the octaves hold the result so far
//   error     as of the fractals in fbm2d.glsl
//   cost      1 to 10 operations
//   source    docs/reference/contract.md, section 7
""" + "".join(function(f"HN_FN void {step}",
                       ["HN_I_INOUT(hn_octaves2) o", "hn_float n", *(["hn_float strength"] if of[0].strength else [])],
                       f"o.sum = {of[0].adds('o.sum', 'n', 'strength')};") for step, of in owners.items())


def files(catalog: Catalog) -> dict[Path, str]:
    sums = sums_of_values(catalog)
    check_steps(sums)
    with_loops = with_section(SUMS, "loops", "".join(map(loop, sums)))[1]
    # fBm's are written by hand there, with the parts that all others take from it.
    others = "\n".join(comment(sum_) + forms(sum_) for sum_ in sums if sum_.name != "fbm")
    # A comment that stood under the mark without a blank line would take it for its first line, and show it to users.
    return dict([with_section(SUMS, "forms", f"\n{others}", with_loops),
                 with_section(STEPS, "steps", f"\n{public_steps(sums)}")])
