"""Which texts are generated from the plane's, and where they stand.

A file may be generated as a whole. In others two lines mark where generated text begins and ends, and the same lines
mark its source in the file of the plane; they name all files. Where a file has several dimensions, the lines name them.
Where it has all of them, one line marks that the text below it is generated from the text above it, each as far as an
empty line or a directive.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Mapping

from base.tree import included_from
from catalog.popular import snippets
from translate.dimensions.layout import joined, with_short_lines
from translate.dimensions.numbers import IN_SPACE
from translate.dimensions.rule import WHERE, Unclear, in_dimension

WHOLE = {"cellular2d.glsl": (3,), "cellular_phase2d.glsl": (3,), "curl_fbm2d.glsl": (3,), "fbm2d.glsl": (1, 3, 4), "fbm_d2d.glsl": (3,),
         "random2d.glsl": (1, 3, 4), "warp2d.glsl": (3,)}
WITHOUT_PAPERS_GRADIENT = (1, 4)  # the paper has Perlin noise in 2D and 3D
RESULTS_STAY = ("cellular2d.glsl", "cellular_phase2d.glsl", "cellular_three2d.glsl")  # as many distances everywhere

SEVERAL = r"([134](?:, [134])*(?: and [134])?) dimensions"
BOUND = re.compile(r"^(// (?:From|To) here [^\n]*\n)", re.MULTILINE)
ZONE = re.compile(rf"(?<=^// From here )(?P<what>[\w.,/ ]+ generated from (?P<source>[\w/]+2d\.glsl)(?:, in {SEVERAL})?\.)\n"
                  r"(?P<text>.*?)(?=^// To here (?P=what)\n)", re.MULTILINE | re.DOTALL)
BELOW = re.compile(rf"^// Generated for {SEVERAL} from the lines above\.\n", re.MULTILINE)
ANY_MARK = re.compile(r"^// (?:(?:From|To) here|Generated for) .*", re.MULTILINE)
TO_READ = re.compile(r"^// To read it in one piece: docs/reference/snippets/(\w+)\.md\n", re.MULTILINE)
END = re.compile(r"^(?=\n|#)", re.MULTILINE)  # of text made of the lines above, and of these
ITEM = re.compile(r"^(?:HN_FN|struct) (?:.*\}\n|(?:.*\n)*?\};?\n)", re.MULTILINE)
OF_THE_PLANE = re.compile(r"\b(?:[iu]?vec|hn_\w*[a-z])2\b")


def transformed(source: str, plane: str, n: int) -> str:
    """The text in n dimensions of text in a file of the plane."""
    name = source.rpartition("/")[2]
    try:
        text = in_dimension(n, plane, name not in RESULTS_STAY)
    except Unclear as unclear:
        raise Unclear(f"{source}, in {n} dimensions: {unclear}") from None
    for on_the_plane, in_space in IN_SPACE.get(name, {}).items() if n == 3 else ():
        text = re.sub(rf"(?<![\d.]){re.escape(on_the_plane)}", in_space, text)
    return with_short_lines(joined(text) if n == 1 else text)


def of_whole(source: str, n: int, texts: Mapping[str, str]) -> str:
    """A file that is generated."""
    text = "".join(part if BOUND.match(part) else transformed(source, part, n) for part in BOUND.split(texts[source]))
    note = " On the line nothing can rotate." if (source, n) == ("fbm2d.glsl", 1) else ""
    note += " tools/lib/translate/dimensions/numbers.py has its numbers." if n == 3 and source in IN_SPACE else ""
    head, blank, rest = TO_READ.sub(lambda line: line[0] if line[1] in snippets() else "", text).partition("\n\n")
    if source == "fbm2d.glsl" and n in WITHOUT_PAPERS_GRADIENT:
        includes, include, code = rest.rpartition(f'#include "perlin{n}d.glsl"\n')
        rest = (f"{includes}{include}\n// The paper's gradient has no noise {WHERE[n]}.\n"
                f"#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL\n{code}#endif\n")
    return f"{head}\n//\n// Made from {source} by tools/make.{note}{blank}{rest}"


def of_zones(file: str, texts: Mapping[str, str]) -> str:
    """A file with its parts generated from the file of the plane. Where a part is in several dimensions, each of its
    functions is in all of them, below the same comment."""
    seen: Counter[str] = Counter()

    def made_zone(zone: re.Match[str]) -> str:
        what, source = zone["what"], included_from(file, zone["source"])
        same = [one["text"] for one in ZONE.finditer(texts.get(source, "")) if one["what"] == what]
        if len(same) != sum(one["what"] == what for one in ZONE.finditer(texts[file])):
            raise Unclear(f"{file} needs as many lines `// From here {what}` as {source}")
        plane, several = same[seen[what]], zone[3]
        seen[what] += 1
        dimensions = re.findall(r"\d", several) if several else [file[-len("2d.glsl")]]
        made = (ITEM.sub(lambda item: "".join(transformed(source, item[0], int(n)) for n in dimensions), plane)
                if several else transformed(source, plane, int(dimensions[0])))
        return f"{what}\n{made}"
    return ZONE.sub(made_zone, texts[file])


def of_lines_above(file: str, text: str) -> str:
    """A file for all dimensions, with its generated parts."""
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
    for file, text in texts.items():
        marks = [*ANY_MARK.findall(text)]
        known = [f"// {bound} here {zone['what']}" for zone in ZONE.finditer(text) for bound in ("From", "To")]
        if unknown := [mark for mark in marks if mark not in known and not BELOW.match(f"{mark}\n")]:
            raise Unclear(f"{file} has `{unknown[0]}`, which tools/make dimensions does not know, or only one end of it")
    found = {source.replace("2d.", f"{n}d."): of_whole(source, n, texts)
             for source, dimensions in WHOLE.items() if source in texts for n in dimensions}
    for file, text in texts.items():
        if file not in found and BELOW.search(text):
            found[file] = of_lines_above(file, text)
        elif file not in found and not file.endswith("2d.glsl") and ZONE.search(text):
            found[file] = of_zones(file, texts)
    owners: defaultdict[str, set[str]] = defaultdict(set)
    for file, text in {**texts, **found}.items():
        for zone in ZONE.finditer(text):
            owners[zone["what"]].add(file.rpartition("/")[2])
    for what, files in owners.items():
        if files != set(re.findall(r"\w+\.glsl", what)):
            raise Unclear(f"`// From here {what}` is in {', '.join(sorted(files))}: it must name all of them")
    return found
