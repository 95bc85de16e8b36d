"""Texts of tools/pick, of several functions at once, and of each alone: the compiler and the linters of each language are
silent.

    python3 -m translate.pick.combinations_test PACKAGES       the folder that lib/base/javascript/environment.py makes, for TypeScript

By default some functions of different noises at once, and the two that were wrong. In a thorough run each function
alone, all functions of a noise at once, each two of them in languages by turns, and all functions at once; and OSL,
which Blender compiles, of a package of 374 MB.

Exit status: 0 all is right, 1 not, 77 all that could be tried is right, but a compiler is not installed.
"""

from __future__ import annotations

import functools
import itertools
import re
import sys
import tempfile
import unittest
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple, Protocol

from base.debian import SKIPPED, Missing
from base.javascript.environment import NODE
from base.thorough import THOROUGH
from base.tree import GLSL, ROOT
from translate.pick import command
from translate.pick.gdscript_runner import GDScriptRunner
from translate.pick.osl_runner import OslRunner
from translate.pick.program import read
from translate.pick.runners import ARRAYS, RUNNERS, NotRun, Runner, ran, written_to
from translate.pick.shading_runners import device, pairs_of

ARITHMETICS = ("fast", "fixed")
OF_PROGRAMS = {"osl": OslRunner, "gdscript": GDScriptRunner}  # of packages that are downloaded
# Locals had the names of parameters in these.
PAIRS = (("hn_cellular3_nearest", "hn_cell_border3_nearest"),)
SHADING = ("glsl", "hlsl", "wgsl", "metal", "godot")
LANGUAGES = (*command.SYNTAXES, *SHADING)
# Kinds of languages: languages of a kind are made of the same program, which takes longest.
OF_NUMBERS = tuple(language for language, syntax in command.SYNTAXES.items() if not syntax.library)

PICK = command.picker()

Names = tuple[str, ...]


# The functions, together.

@functools.cache
def all_names() -> dict[str, list[str]]:
    """By their noises: the first word of the name."""
    families: dict[str, list[str]] = {}
    for name in read(GLSL, command.settings("fast", "lattice"), splits=True).forms:
        families.setdefault(re.match(r"hn_[a-z]+?(?=ular|\d|_|$)", name)[0], []).append(name)
    return families


def groups() -> Iterator[tuple[str, Names]]:
    """The functions written at once, with an arithmetic."""
    if not THOROUGH:
        yield from (("fast", pair) for pair in PAIRS)
        yield "fixed", tuple(names[-1] for names in list(all_names().values())[::8])
        return
    for arithmetic in ARITHMETICS:
        yield from ((arithmetic, (name,)) for names in all_names().values() for name in names)
        yield from ((arithmetic, tuple(names)) for names in all_names().values())
        yield arithmetic, tuple(itertools.chain(*all_names().values()))


def pairs() -> Iterator[tuple[str, Names, str]]:
    """Pairs of functions of a noise, each in an arithmetic and a language by turns; in the same dimensions in each
    shading language."""
    found = (pair for names in all_names().values() for pair in itertools.combinations(names, 2))
    yield from ((ARITHMETICS[turn % 2], pair, LANGUAGES[turn // 2 % len(LANGUAGES)]) for turn, pair in enumerate(found))
    alike = pairs_of(itertools.chain(*all_names().values()))
    yield from (("fast", pair, language) for pair in alike for language in SHADING)


class Text(NamedTuple):
    language: str
    arithmetic: str
    names: Names
    shown: str


@functools.lru_cache(maxsize=64)
def picked(names: Names, language: str, arithmetic: str = "fast") -> str:
    return PICK(names, command.Choice(language, arithmetic))


def in_all(names: Names, arithmetic: str = "fast") -> Iterator[Text]:
    """In each language: languages of a kind come together, since a program is made once for them."""
    for language in sorted(LANGUAGES, key=lambda one: (one not in OF_NUMBERS, one in SHADING)):
        yield Text(language, arithmetic, names, picked(names, language, arithmetic))


@functools.cache
def all_texts() -> list[Text]:
    found = [text for arithmetic, names in groups() for text in in_all(names, arithmetic)]
    return found + [Text(language, arithmetic, names, PICK(names, command.Choice(language, arithmetic)))
                    for arithmetic, names, language in (pairs() if THOROUGH else ())]


# Compilers.

class Compiler(Protocol):
    def lint(self, texts: Sequence[str], folder: Path) -> None:
        """Raises NotRun."""


class GlslCompiler:
    """glslang, behind the versions that the page promises, and a user's precision, which no number may have."""
    MEDIUMP = "es\nprecision mediump float;\nprecision mediump int;\n"
    HEADS = {"glsl": ("#version 330\n", f"#version 300 {MEDIUMP}", f"#version 310 {MEDIUMP}"),
             "godot": ("#version 300 es\nprecision highp float;\nprecision highp int;\n",)}

    def __init__(self, language: str):
        self.heads = self.HEADS[language]

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        names = written_to(folder, {f"m{i}_{j}.frag": f"{head}{text}void main() {{}}\n"
                                    for i, text in enumerate(texts) for j, head in enumerate(self.heads)})
        shown = ran(folder, "glslangValidator", *names)
        for name in names[2::3] if len(self.heads) == 3 else ():
            shown += ran(folder, "glslangValidator", "-V", "-H", "--keep-uncalled", "-o", "spirv", name)
        if re.search("WARNING|ERROR|RelaxedPrecision", shown):
            raise NotRun(shown)


class HlslCompiler:
    def lint(self, texts: Sequence[str], folder: Path) -> None:
        main = "float4 main() : SV_Target { return float4(0, 0, 0, 0); }\n"
        for name in written_to(folder, {f"m{i}.frag": f"{text}{main}" for i, text in enumerate(texts)}):
            if re.search("WARNING|ERROR", shown := ran(folder, "glslangValidator", "-D", "-V", "-e", "main", "-o", "out",
                                                       name)):
                raise NotRun(shown)


class WgslCompiler:
    def lint(self, texts: Sequence[str], folder: Path) -> None:
        for text in texts:
            try:
                device().compile(text)
            except Missing:
                raise
            except Exception as error:  # what wgpu raises has no common type
                raise NotRun(str(error)) from error


class MetalCompiler:
    """Metal's language as C++, with the suite's stand-in for <metal_stdlib>."""

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        (folder / "metal_stdlib").write_bytes((ROOT / "conformance" / "gpu" / "metal" / "metal_stdlib.hpp").read_bytes())
        opening = "#include <metal_stdlib>\nusing namespace metal;\n\n"
        parts = "".join(f"namespace text{i} {{\n{text.replace(opening, '')}}}\n" for i, text in enumerate(texts))
        written_to(folder, {"main.cpp": f"{opening}{parts}"})
        ran(folder, "clang++", "-std=c++14", "-Wall", "-Wextra", "-Wno-unused-function", "-Werror", "-fsyntax-only", "-I.",
            "main.cpp")


class TypeScriptCompiler:
    packages = Path()
    suffix = "ts"
    options: Sequence[str] = ()

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        names = written_to(folder, {f"m{i}.{self.suffix}": text for i, text in enumerate(texts)})
        ran(self.packages, NODE, "npx", "--no-install", "tsc", "--ignoreConfig", "--noEmit", "--strict",
            "--noUnusedLocals", "--noUnusedParameters", "--noImplicitReturns", "--target", "es2020", "--module",
            "es2020", *self.options, *(folder / name for name in names))


class JavaScriptCompiler(TypeScriptCompiler):
    """Node.js, and the compiler of TypeScript, by the types in the comments."""
    suffix = "js"
    options = ("--allowJs", "--checkJs")

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        RUNNERS["javascript"]().lint(texts, folder)
        super().lint(texts, folder)


def compiler(language: str) -> Compiler:
    """The compiler of a language; raises Missing if it is not there."""
    if language in ("typescript", "javascript"):
        RUNNERS["javascript"]().check()
        if not (TypeScriptCompiler.packages / "made").exists():
            raise Missing("TypeScript is not there: name the folder that lib/base/javascript/environment.py makes")
        return TypeScriptCompiler() if language == "typescript" else JavaScriptCompiler()
    if language == "wgsl":
        device()
        return WgslCompiler()
    if language in GlslCompiler.HEADS:
        return GlslCompiler(language)
    if language in ("hlsl", "metal"):
        return HlslCompiler() if language == "hlsl" else MetalCompiler()
    runner: Runner = {**RUNNERS, **ARRAYS, **OF_PROGRAMS}[language]()
    runner.check(lints=True)
    return runner


# Compilers and linters must refuse this: a change of the text of hn_perlin2.
REFUSED: Mapping[str, Sequence[tuple[str, str]]] = {
    "rust": (("-> f32 {", "-> f32 {\n    let unused = 1.0;"), ("seed: u32", "seed: u32, _a: u32, _b: u32, _c: u32, "
             "_d: u32, _e: u32, _f: u32"), (".wrapping_add(", ".wrapping_add(1 - 1 + ")),
    "go": (("\treturn ", "\tseed = seed\n\treturn "), ("seed uint32", "seed, seed uint32")),
    "csharp": (("uint seed) {", "uint seed) {\nint unused = 1;"),
               ("#pragma warning disable 1591\n\n/// <summary>Procedural noise.</summary>\n", "")),
    "c": (("uint32_t seed)", "uint32_t seed, int unused)"), ("float y,", "double y,")),
    "typescript": (("seed: number", "seed: number, unused: number"), ("{\n", "{\n  const unused = 1;\n")),
    "javascript": (("seed)", "seed, seed)"), ("@param {number} seed", "@param {string} seed"),
                   ("@returns {number} [", "@returns {Vector2} [")),
    "java": (("int seed) {", "int seed) {\nint unused = (int) 1;\n"), ("<p>Example", "<p><p>Example")),
    "python": (("seed=0)", "seed=0, seed=0)"), ("return _called(", "return (_called(")),
    "gdscript": (("noise_seed: int)", "noise_seed: int, unused: int)"), ("-> float:", "-> Vector2:")),
    "osl": (("int seed)", "int seed, int seed)"),),
    "glsl": (("uint seed) {", "uint seed, highp uint seed) {"), ("highp float n_x =", "float n_x =")),
    "godot": (("return ", "return seed + "),), "hlsl": (("uint seed) {", "uint seed, uint seed) {"),),
    "wgsl": (("-> f32 {", "-> u32 {"),), "metal": (("uint seed) {", "uint seed, uint unused) {"),)}


class Compiled(unittest.TestCase):
    language: str
    compiler: Compiler

    def lint(self, shown: Sequence[str]) -> None:
        with tempfile.TemporaryDirectory() as folder:
            self.compiler.lint(shown, Path(folder))

    def test_the_compiler_is_silent(self) -> None:
        shown = [text.shown for text in all_texts() if text.language == self.language]
        self.assertGreater(len(shown), 1)
        for begin in range(0, len(shown), 100):
            self.lint(shown[begin:begin + 100])

    def test_what_is_wrong_is_refused(self) -> None:
        right = picked(("hn_perlin2",), self.language)
        self.lint([right])
        for old, new in REFUSED[self.language]:
            with self.subTest(new):
                self.assertIn(old, right)
                with self.assertRaises(NotRun):
                    self.lint([right.replace(old, new, 1)])


if __name__ == "__main__":
    TypeScriptCompiler.packages = Path(sys.argv[1]).resolve()
    suite = unittest.TestSuite()
    absent: list[str] = []
    for name in LANGUAGES if THOROUGH else [one for one in LANGUAGES if one not in OF_PROGRAMS]:
        try:
            of_language = type(f"Compiled_{name}", (Compiled,), {"language": name, "compiler": compiler(name)})
            suite.addTests(unittest.defaultTestLoader.loadTestsFromTestCase(of_language))
        except Missing as reason:
            absent.append(f"skipped: {name}: {reason}")
    right = unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful()
    print("\n".join(absent))
    sys.exit(1 if not right else SKIPPED if absent else 0)
