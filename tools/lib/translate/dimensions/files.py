"""Which texts are made of those of the plane, and where they stand.

A file may be made as a whole. In others a line marks where made text begins: it is made of the text in the file of the
plane below the same line, as far as the next line that marks text by hand. Where a file has several dimensions, the
line names them. Where it has all of them, a line marks that the text below it is made of the text above it, each as far
as an empty line or a directive.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from base.tree import included_from
from translate.dimensions.layout import joined, with_short_lines
from translate.dimensions.numbers import IN_SPACE
from translate.dimensions.rule import WHERE, Unclear, in_dimension

WHOLE = {"cellular2d.glsl": (3,), "cellular_phase2d.glsl": (3,), "fbm2d.glsl": (1, 3, 4), "fbm_d2d.glsl": (3,),
         "random2d.glsl": (1, 3, 4), "warp2d.glsl": (3,)}
WITHOUT_PAPERS_GRADIENT = (1, 4)  # the paper has Perlin noise in 2D and 3D
RESULTS_STAY = ("cellular2d.glsl", "cellular_phase2d.glsl", "cellular_three2d.glsl")  # as many distances everywhere

BY_HAND = "// By hand in each dimension.\n"
OF_FILE = r"// The same [^\n]*: tools/make writes it of [\w/]+2d\.glsl\.\n"
IN_SEVERAL = re.compile(r"// The same in ([134](?:, [134])*(?: and [134])?) dimensions:")
OF_ABOVE = r"// The same in ([134](?:, [134])*(?: and [134])?) dimensions: tools/make writes it\.\n"
MARK = re.compile(rf"^({BY_HAND}|{OF_FILE})", re.MULTILINE)
BELOW = re.compile(rf"^{OF_ABOVE}", re.MULTILINE)
NO_MARK = re.compile(rf"^(?!{OF_FILE}|{OF_ABOVE})[^\n]*tools/make writes it[^\n]*", re.MULTILINE)
END = re.compile(r"^(?=\n|#)", re.MULTILINE)  # of what is made of the lines above, and of these
ITEM = re.compile(r"^(?:HN_FN|struct) (?:.*\}\n|(?:.*\n)*?\};?\n)", re.MULTILINE)
OF_THE_PLANE = re.compile(r"\b(?:[iu]?vec|hn_\w*[a-z])2\b")


def transformed(source: str, plane: str, n: int) -> str:
    """The text in n dimensions of what stands in a file of the plane."""
    name = source.rpartition("/")[2]
    try:
        text = in_dimension(n, plane, name not in RESULTS_STAY)
    except Unclear as unclear:
        raise Unclear(f"{source}, in {n} dimensions: {unclear}") from None
    for on_the_plane, in_space in IN_SPACE.get(name, {}).items() if n == 3 else ():
        text = re.sub(rf"(?<![\d.]){re.escape(on_the_plane)}", in_space, text)
    return with_short_lines(joined(text) if n == 1 else text)


def zones(text: str, first: str) -> list[tuple[str, str]]:
    """The parts of a file, each with the line that names its source, or marks it as by hand."""
    parts = [first, *MARK.split(text)]
    return list(zip(parts[::2], parts[1::2]))


def of_whole(source: str, n: int, texts: Mapping[str, str]) -> str:
    """A file that is made, but for what is by hand in each dimension."""
    file = source.replace("2d.", f"{n}d.")
    by_hand = [text for mark, text in zones(texts.get(file, ""), "") if mark == BY_HAND]
    parts = zones(texts[source], "")
    if [mark for mark, _ in parts].count(BY_HAND) != len(by_hand):
        raise Unclear(f"{file} needs as many lines `{BY_HAND.strip()}` as {source}, with what is by hand below each")
    text = "".join(mark + (by_hand.pop(0) if mark == BY_HAND else transformed(source, part, n)) for mark, part in parts)
    note = " On the line nothing can rotate." if (source, n) == ("fbm2d.glsl", 1) else ""
    note += " Parts by hand are marked." if BY_HAND in text else ""
    note += " tools/lib/translate/dimensions/numbers.py has its numbers." if n == 3 and source in IN_SPACE else ""
    head, blank, rest = text.partition("\n\n")
    if source == "fbm2d.glsl" and n in WITHOUT_PAPERS_GRADIENT:
        includes, include, code = rest.rpartition(f'#include "perlin{n}d.glsl"\n')
        rest = (f"{includes}{include}\n// The paper's gradient has no noise {WHERE[n]}.\n"
                f"#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL\n{code}#endif\n")
    return f"{head}\n//\n// Made from {source} by tools/make.{note}{blank}{rest}"


def of_zone(file: str, mark: str, source: str, plane: str) -> str:
    """The text made of a part of the file of the plane. Where it is in several dimensions, each of its functions is in
    all of them, below the same comment."""
    if several := IN_SEVERAL.match(mark):
        return ITEM.sub(lambda item: "".join(transformed(source, item[0], int(n)) for n in re.findall(r"\d", several[1])),
                        plane)
    return transformed(source, plane, int(file[-len("2d.glsl")]))


def of_zones(file: str, texts: Mapping[str, str]) -> str:
    """A file with what is made in it of the file of the plane."""
    first, *others = zones(texts[file], BY_HAND)
    made, marks = first[1], [mark for mark, _ in others]
    for at, (mark, text) in enumerate(others):
        if mark != BY_HAND:
            source = included_from(file, mark.split()[-1].removesuffix("."))
            same = [part for other, part in zones(texts.get(source, ""), BY_HAND) if other == mark]
            if len(same) != marks.count(mark):
                raise Unclear(f"{file} needs as many lines `{mark.strip()}` as {source}")
            text = of_zone(file, mark, source, same[marks[:at].count(mark)])
        made += mark + text
    return made


def of_lines_above(file: str, text: str) -> str:
    """A file for all dimensions, with what is made in it."""
    made = ""
    while mark := BELOW.search(text):
        above, below = text[:mark.start()], text[mark.end():]
        lines = above[[end.start() for end in END.finditer(f"\n{above}")][-1]:]
        plane = [item for item in ITEM.findall(lines) if OF_THE_PLANE.search(item)]
        if not plane:
            raise Unclear(f"{file} has nothing of the plane above `{mark[0].strip()}`")
        made += above + mark[0] + "".join(transformed(file, item, int(n)) for n in re.findall(r"\d", mark[1])
                                          for item in plane)
        end = END.search(below)
        text = below[end.start():] if end else ""
    return made + text


def made(texts: Mapping[str, str]) -> dict[str, str]:
    """The text of each file in which something is made, given the texts of all."""
    for source, numbers in IN_SPACE.items():
        for number in numbers:
            if source in texts and number not in texts[source]:
                raise Unclear(f"{source} does not state `{number}`, as "
                              "tools/lib/translate/dimensions/numbers.py has it")
    found = {source.replace("2d.", f"{n}d."): of_whole(source, n, texts)
             for source, dimensions in WHOLE.items() if source in texts for n in dimensions}
    for file, text in texts.items():
        if unknown := NO_MARK.search(text):
            raise Unclear(f"{file} has `{unknown[0]}`, which is not a line that tools/make umbrella knows")
        if file not in found and BELOW.search(text):
            found[file] = of_lines_above(file, text)
        elif file not in found and not file.endswith("2d.glsl") and re.search(OF_FILE, text):
            found[file] = of_zones(file, texts)
    return found
