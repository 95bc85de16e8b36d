"""tools/pick's texts of the functions that pictures call, which the page of the playground contains. They take a
minute, so build/picks keeps it until something changes that it is made of."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

from base import modules
from base.kept import kept
from base.tree import GLSL, ROOT, glsl_files
from catalog.javascript import dimensions_of, drawn, may_draw
from catalog.model import read
from translate.pick.command import Choice, command_of, picker, read_library

FOLDER = ROOT / "build" / "picks"
NAME = "picks.json"
# In the order that gzip compresses best.
CHOICES = [Choice(language, arithmetic) for arithmetic in ("fixed", "fast") for language in ("wgsl", "glsl", "hlsl")]
FORMS = ("", "_phase", "_jitter")
COMMAND = "{command}"  # stands in a text for the command that writes it, so that more lines are alike


def calls() -> list[list[str]]:
    """The functions of each picture that has no tile, no warp, and no sum over another noise than Perlin's."""
    noises, sums = drawn(read())
    names = [f"hn_{function.name}{n}{form}" for function in (*noises, *sums) for n in dimensions_of(function, 4)
             for form in FORMS if form != "_phase" or may_draw(function, "phase")]
    known = read_library(GLSL, Choice()).forms
    cells = [[f"hn_cellular{n}_nearest", f"hn_lattice{n}", "hn_unorm"] for n in (2, 3)]
    return [*([name] for name in names if name in known), *cells]


def picked(choice: Choice, of: Collection[Sequence[str]]) -> dict[str, str]:
    """By the command that writes it."""
    pick = picker()
    commands = {command_of(names, choice): names for names in of}
    return {command: pick(names, choice).replace(command, COMMAND) for command, names in commands.items()}


def texts(of: Collection[Sequence[str]], tell: Callable[[str], None] = lambda _: None) -> dict[str, str]:
    """The picks of all choices. `tell` takes a sentence before each long step."""
    tell(f"Picking what {len(of)} pictures call, in {len(CHOICES)} texts each, which takes a minute at first ...")
    with ProcessPoolExecutor() as pool:
        found = {command: text for part in pool.map(partial(picked, of=of), CHOICES) for command, text in part.items()}
    return {command: found[command] for names in of for command in (command_of(names, choice) for choice in CHOICES)}


def woven(named: Mapping[str, str]) -> dict:
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
    return {"lines": lines, "texts": spans}


def data(tell: Callable[[str], None] = lambda _: None) -> dict:
    """The texts, woven, as library.js of the playground reads them."""
    def made() -> dict[str, str]:
        return {NAME: json.dumps(woven(texts(calls(), tell)))}

    sources = [*glsl_files().values(), *(ROOT / "catalog").glob("*.toml"), *modules.files_of([Path(__file__)])]
    return json.loads((kept(FOLDER, sources, made) / NAME).read_text(encoding="utf-8"))
