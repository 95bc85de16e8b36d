"""Writes playground/picks.json: what tools/pick writes of the functions that pictures call. That takes a minute, so the
page of the playground has this file inside.

    tools/make picks [--check]

Exit status: 0 done, or the file is what it should be; 1 (--check) it is not, or a text cannot be picked; 2 bad usage,
or it cannot be written.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Collection, Mapping, Sequence

from base.tree import GLSL, ROOT
from base.usage import Parser
from catalog.javascript import dimensions_of, drawn, may_draw
from catalog.model import read
from translate.parsing.tokens import Unknown
from translate.pick.command import Choice, command_of, picker, read_library

FILE = ROOT / "playground" / "picks.json"
# In the order of which gzip leaves least.
CHOICES = [Choice(language, arithmetic) for arithmetic in ("fixed", "fast") for language in ("wgsl", "glsl", "hlsl")]
FORMS = ("", "_phase", "_full")
COMMAND = "{command}"  # stands in a text for the command that writes it, so that more lines are alike


def calls() -> list[list[str]]:
    """The functions of each picture that has no tile, no warp, and no sum over another noise than Perlin's."""
    noises, sums = drawn(read())
    names = [f"hn_{function.name}{n}{form}" for function in (*noises, *sums) for n in dimensions_of(function, 4)
             for form in FORMS if form != "_phase" or may_draw(function, "phase")]
    known = read_library(GLSL, Choice()).forms
    cells = [[f"hn_cellular{n}_nearest", f"hn_lattice{n}", "hn_unorm"] for n in (2, 3)]
    return [*([name] for name in names if name in known), *cells]


def texts(of: Collection[Sequence[str]], tell: Callable[[str], None] = lambda _: None) -> dict[str, str]:
    """By the command that writes it. `tell` takes a sentence before what takes long."""
    tell(f"Picking what {len(of)} pictures call, in {len(CHOICES)} texts each ...")
    pick = picker()
    commands = {command_of(names, choice): (names, choice) for names in of for choice in CHOICES}
    return {command: pick(*asked).replace(command, COMMAND) for command, asked in commands.items()}


def woven(named: Mapping[str, str]) -> tuple[list[str], dict[str, list[int]]]:
    """Lines, and of each text its spans of them: where one begins, and how many lines it has. Most lines stand in many
    texts, further apart than gzip looks."""
    lines: list[str] = []
    places: dict[str, list[int]] = {}
    spans: dict[str, list[int]] = {}

    def alike(place: int, rest: Sequence[str]) -> int:
        return next((i for i, line in enumerate(rest) if lines[place + i:place + i + 1] != [line]), len(rest))

    for name, text in named.items():
        rest = text.splitlines()
        of_text = spans[name] = []
        while rest:
            if rest[0] not in places:
                places[rest[0]] = [len(lines)]
                lines.append(rest[0])
            place = max(places[rest[0]], key=lambda one: alike(one, rest))
            count = alike(place, rest)
            if of_text and sum(of_text[-2:]) == place:
                of_text[-1] += count
            else:
                of_text += [place, count]
            rest = rest[count:]
    return lines, spans


def written(named: Mapping[str, str]) -> str:
    """The file, of which a change shows the lines that changed."""
    lines, spans = woven(named)
    rows = [json.dumps(line) for line in lines], [f"{json.dumps(name)}: {of}" for name, of in spans.items()]
    return '{{"lines": [\n{}\n], "texts": {{\n{}\n}}}}\n'.format(*map(",\n".join, rows))


def unwoven(file: str) -> dict[str, str]:
    """The texts that written() wrote."""
    made = json.loads(file)
    return {command: "".join(f"{line}\n" for place, count in zip(spans[::2], spans[1::2])
                             for line in made["lines"][place:place + count])
            for command, spans in made["texts"].items()}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make picks", __doc__)
    parser.add_argument("--check", action="store_true", help="write nothing")
    check = parser.parse_args(arguments).check
    try:
        text = written(texts(calls(), lambda step: print(step, file=sys.stderr, flush=True)))
    except Unknown as error:
        parser.exit(1, f"tools/make picks: {error}\n")
    if not check:
        try:
            FILE.write_text(text, encoding="utf-8")
        except OSError as error:
            parser.exit(2, f"tools/make picks: cannot write {FILE}: {error.strerror}\n")
        print(FILE.resolve())
    elif not FILE.is_file() or FILE.read_text(encoding="utf-8") != text:
        print(f"{FILE}: it is not what tools/make picks writes", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
