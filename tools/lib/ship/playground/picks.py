"""Every function that a picture may call, as tools/pick writes it in each language: pieces that the page composes.

A program of tools/pick has all functions of one dimension at once, so that they share their helpers. The page takes
the pieces that a picture needs. Pieces of one name stand beside each other, whatever their dimension and language: zlib
looks back 32 kB for what they have in common, and lines that are the same farther back are written once. All of it takes
20 seconds, so build/picks keeps it until one of its sources changes."""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

from base import modules
from base.cache import cached
from base.tree import GLSL, ROOT, glsl_files
from catalog.javascript import drawn
from catalog.model import read
from ship.playground import glue
from translate.names import wgsl_name
from translate.pick import program as of_pick
from translate.pick import scalars, tsl
from translate.pick.command import SYNTAXES, Choice
from translate.pick.evaluate import Module
from translate.pick.program import Program
from translate.pick.shading import LANGUAGES

FOLDER = ROOT / "build" / "picks"
SHADING = ("glsl", "hlsl", "metal", "godot", "wgsl")
# These have the bits of HN_FIXED, as docs/snippets have: on a CPU floats are not faster by much.
CPU = ("c", "java", "csharp", "javascript", "go", "rust", "osl")
DIMENSIONS = (1, 2, 3, 4)
# The page has the other hashes for shading languages. They differ in one function, which is the same in a small program
# of any dimension and arithmetic.
OTHER_HASHES = ("fnv1", "partial_fnv1", "jenkins", "partial_jenkins", "murmur", "pcg", "xxhash32")
MARK = "~"  # begins a line that is none of a text
LEAST_REPEATED = 30  # letters
PLACES = 8  # of a line that are compared: 32 make the page shorter by 0.2%
COMMENT = re.compile(r"^\s*//.*\n", re.MULTILINE)
BLOCK = re.compile(r"^/\*\*\n(?: \*.*\n)+", re.MULTILINE)


class Piece(NamedTuple):
    """A function or a struct, by the name by which others need it."""
    name: str
    text: str


class Setting(NamedTuple):
    languages: tuple[str, ...]
    arithmetic: str
    hash: str
    dimensions: int
    is_small: bool = False

    def key(self, language: str) -> str:
        return f"{language} {self.arithmetic} {self.hash} {self.dimensions}"


def small_roots(n: int) -> list[str]:
    return [f"hn_perlin{n}", f"hn_value{n}", f"hn_lattice{n}"]


def roots(module: Module, n: int, of_cpu: bool) -> list[str]:
    """The names of the page's calls. A jitter and a metric are always passed, and sums over other noises are loops, and
    on a CPU also those in tiles, so that there is less text."""
    noises, sums = drawn(read())
    with_jitter = [noise.name for noise in noises if f"hn_{noise.name}{n}_jitter" in module.forms]
    plain = [noise.name for noise in noises if noise.name not in with_jitter]
    places = ("", "_place")
    if of_cpu:  # these have longer texts, so they have fewer functions
        names = [f"hn_perlin{n}", f"hn_value{n}", f"hn_simplex{n}"]
        places = ("_place",)
    else:
        names = []
    names += [f"hn_{name}{n}{place}" for name in plain for place in places]
    names += [f"hn_{name}{n}{place}_phase" for name in plain for place in places]
    names += [f"hn_{name}{n}{place}_jitter" for name in with_jitter for place in places]
    names += [f"hn_{total.name}{n}" for total in sums]
    names += [f"hn_{step}{n}" for step in ("octaves_of", "next", "mean", "density", "add", "slopes_of")]
    names += [f"hn_octaves_of{n}_place"]
    names += [f"{total.step_of_loops}{n}" for total in sums if total.step_of_loops]
    names += [wgsl_name(function) for (name, _), function in module.functions.items() if name.startswith(glue.PREFIX)]
    if not of_cpu:
        names += [f"hn_{noise.name}_d{n}_place" for noise in noises]
        names += [f"hn_cellular{n}_nearest", f"hn_cellular{n}_place_nearest", f"hn_lattice{n}", "hn_unorm"]
        names += [f"hn_{warp}{n}{place}" for warp in ("warp", "warp_progressive") for place in places]
        names += [f"hn_tile{n}", f"hn_tile{n}_place", f"hn_place_in_cell{n}", f"hn_mean{n}_slopes"]
    return [name for name in dict.fromkeys(names) if module.form(name) is not None]


def base_of_hashes(n: int) -> str:
    """The hash whose program becomes those of the others. In four dimensions that of the lattice is so short that it
    stands in line."""
    return "pcg" if n == 4 else "lattice"


def settings() -> list[Setting]:
    """The longest first."""
    order = sorted(DIMENSIONS, key=lambda n: abs(n - 3.4))
    return [*(Setting(CPU, "fixed", "lattice", n) for n in order),
            *(Setting(SHADING, arithmetic, hash_, n) for n in order for hash_ in sorted({"lattice", base_of_hashes(n)})
              for arithmetic in ("fixed", "fast")),
            *(Setting(SHADING, "fast", hash_, 2, is_small=True) for hash_ in OTHER_HASHES)]


def program_of(setting: Setting) -> Program:
    of_cpu = setting.languages[0] in SYNTAXES
    choice = Choice(setting.languages[0], setting.arithmetic, setting.hash)
    language = SYNTAXES[choice.language] if of_cpu else LANGUAGES[choice.language]
    macros = {**choice.knobs.macros(), **language.library}
    n = setting.dimensions
    own = glue.text_of_cpu(n) if of_cpu else glue.text_of_shaders(n, setting.arithmetic, drawn(read())[1])
    module = of_pick.read(GLSL, macros, of_cpu, below=own)
    names = small_roots(n) if setting.is_small else roots(module, n, of_cpu)
    return Program(module, of_pick.chosen(module, names), calls_first=not setting.is_small)


def pieces_of(setting: Setting) -> tuple[Setting, dict[str, list[Piece]]]:
    program = program_of(setting)
    found = {}
    for language in setting.languages:
        if language in SYNTAXES:
            made = scalars.pieces(program, SYNTAXES[language](False))
        else:
            made = program.pieces(LANGUAGES[language])
        found[setting.key(language)] = [Piece(name, COMMENT.sub("", text)) for name, text in made]
    return setting, found


def own_pieces(small: Sequence[list[Piece]]) -> list[list[Piece]]:
    """The pieces that not all programs with different hashes have: a function, and before it its helpers."""
    common = set.intersection(*map(set, small))
    own = [[piece for piece in pieces if piece not in common] for pieces in small]
    if set.intersection(*({piece.name for piece in pieces} for pieces in own)) != {own[0][-1].name}:
        raise ValueError("hashes differ in more than one function")
    return own


def with_hash(base: list[Piece], own: list[Piece]) -> list[Piece]:
    """The pieces of a program with one hash, with the pieces of another in their place."""
    at, = (i for i, piece in enumerate(base) if piece.name == own[-1].name)
    return [*base[:at], *own, *base[at + 1:]]


def every_module(made: Iterable[tuple[Setting, dict[str, list[Piece]]]]) -> dict[str, list[Piece]]:
    made = list(made)
    small = {setting.hash: found.values() for setting, found in made if setting.is_small}
    own = [dict(zip(small, own_pieces(programs))) for programs in zip(*small.values())]  # by the hash, in each language
    every: dict[str, list[Piece]] = {}
    for setting, found in made:
        if setting.is_small:
            continue
        every.update(found)
        if setting.languages == SHADING and setting.hash == base_of_hashes(setting.dimensions):
            for language, pieces, by_hash in zip(SHADING, found.values(), own):
                for hash_, new in by_hash.items():
                    every[setting._replace(hash=hash_).key(language)] = with_hash(pieces, new)
    return every


def shells() -> dict[str, list[str]]:
    """The lines in front of the pieces of a language and behind them."""
    found = {language: [LANGUAGES[language].opening, ""] for language in SHADING}
    for language in CPU:
        if language != "osl":  # whose shader the page writes
            syntax = SYNTAXES[language]()
            syntax.is_fixed = True
            before, after = syntax.file([], ["pattern"], ["\0math.\n"]).split("\0math.\n")
            found[language] = [before.lstrip("\n").rstrip(" \t"), after]
    opening, nodes = tsl.NODES.read_text(encoding="ascii").split("\n\n", 1)
    imports = opening.splitlines()[-1].replace(" glslFn", " glsl, glslFn").replace(" wgslFn", " wgsl, wgslFn")
    return {**found, "osl": ["", ""], "tsl": [f"{imports}\n\n{BLOCK.sub('', nodes.replace('export ', ''))}", ""]}


def data(modules_: dict[str, list[Piece]]) -> dict:
    """Each piece once, and which of them each module has, in their order: how much further each is than the one before,
    which packs to half as much as their numbers."""
    every = {piece for pieces in modules_.values() for piece in pieces}
    order = {language: at for at, language in enumerate((*SHADING, *CPU))}
    languages = {piece: order[key.split()[0]] for key, pieces in modules_.items() for piece in pieces}

    def place(piece: Piece) -> tuple:
        of_cpu = languages[piece] >= len(SHADING)
        return of_cpu, re.sub(r"\d", "", piece.name), piece.name, languages[piece], piece.text

    numbers = {piece: at for at, piece in enumerate(sorted(every, key=place))}
    lines = [line for name, text in numbers for line in (MARK + name, *text.removesuffix("\n").split("\n"))]
    return {"pieces": "\n".join(without_repeats(lines)), "shells": shells(),
            "modules": {key: steps([numbers[piece] for piece in pieces]) for key, pieces in modules_.items()}}


def without_repeats(lines: Sequence[str]) -> list[str]:
    """The lines; "~12 3" in place of three that are the same as those from twelve lines before them on."""
    if wrong := [line for line in lines if re.match(rf"{MARK}\d", line)]:
        raise ValueError(f"a line of a text begins with {MARK} and a number: {wrong[0]}")
    found: list[str] = []
    places: dict[str, list[int]] = {}
    at = 0
    while at < len(lines):
        count, first = max(((alike(lines, before, at), before) for before in places.get(lines[at], [])[-PLACES:]), default=(0, 0))
        if sum(map(len, lines[at:at + count])) < LEAST_REPEATED:
            count = 1
            found.append(lines[at])
        else:
            found.append(f"{MARK}{at - first} {count}")
        for place in range(at, at + count):
            places.setdefault(lines[place], []).append(place)
        at += count
    return found


def alike(lines: Sequence[str], before: int, at: int) -> int:
    """How many lines from `before` on, up to `at`, are those from `at` on."""
    count = 0
    while at + count < len(lines) and before + count < at and lines[before + count] == lines[at + count]:
        count += 1
    return count


def steps(numbers: Sequence[int]) -> list[int]:
    return [number - before for before, number in zip((0, *numbers), numbers)]


def compressed(text: str) -> str:
    return base64.b64encode(zlib.compress(text.encode(), 9)).decode("ascii")


def texts(tell: Callable[[str], None] = lambda _: None) -> dict[str, str]:
    """JSON, compressed."""
    tell(f"Picking what pictures call, in {len(SHADING) + len(CPU)} languages: about 20 seconds of a processor core ...")
    with ProcessPoolExecutor() as pool:
        every = every_module(pool.map(pieces_of, settings()))
    return {"pieces": compressed(json.dumps(data({key: every[key] for key in sorted(every)}), separators=(",", ":")))}


def kept(tell: Callable[[str], None] = lambda _: None) -> Path:
    """The folder of the texts."""
    sources = [*glsl_files().values(), *(ROOT / "catalog").glob("*.toml"), *modules.files_of([Path(__file__)])]
    return cached(FOLDER, sources, partial(texts, tell))


def kept_text(tell: Callable[[str], None] = lambda _: None) -> str:
    return (kept(tell) / "pieces").read_text(encoding="ascii")
