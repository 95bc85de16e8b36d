"""Writes functions of the library with their helpers, and nothing else, to paste into a shader, or into a program for
the CPU.

    tools/pick hn_perlin2                              GLSL, HN_FAST, the default hash
    tools/pick hn_fbm3 hn_cellular2 --arithmetic fixed --out noise.glsl
    tools/pick hn_perlin2 --language wgsl --out noise.wgsl
    tools/pick hn_fbm2 --language wgsl --import-path hashnoise    a module for Bevy: #import hashnoise::hn_fbm2
    tools/pick hn_simplex3 --language rust --out noise.rs
    tools/pick hn_fbm3 --language python --out noise.py   functions of arrays: NumPy, PyTorch, JAX, CuPy
    tools/pick hn_fbm2 --language gdscript --arithmetic fixed --out hn_fbm2.gd    for collisions in Godot
    tools/pick hn_fbm2 --language osl --out fbm2.osl   a node for Blender's Cycles
    tools/pick hn_fbm2 --language tsl --out noise.js   nodes for three.js
    tools/pick hn_fbm3 --noise hn_simplex3 --arithmetic fixed --language rust --out noise.rs
    tools/pick hn_simplex2 --language verilog --out simplex2.v     a circuit: a value at each clock
    tools/pick hn_fbm2_tile                            hn_tile2, and hn_fbm2_place, which takes what that makes
    tools/pick 'hn_fbm(hn_tile(vec2))'                 the same
    tools/pick --list                                  which functions there are, by noise
    tools/pick '#sum=ridged&seed=42' --language rust   what the playground copies: its links have a #

A function is called by its form: hn_perlin2 is hn_perlin(vec2 p, uint seed), and hn_perlin2_place is
hn_perlin(hn_place2 place, uint seed). The functions that it calls are inlined; a function that is called more than once
stays a function. Constants are folded, and unused code is removed. The values are the library's. In the text its
name is the library's where the language has overloads, and its form's elsewhere: hn_perlin2 in WGSL and C,
perlin2 in Rust and Python, Perlin2 in C# and Go.

Ask for all functions of a shader or program at once: two texts may have the same function. In HLSL, C#, Java and Go
--name gives a second text names of its own, in OSL it is the shader, and in GDScript the class_name.

tools/pick whole writes files of the library with all that they include, as one: tools/pick whole --help.

Exit status: 0 done, 2 bad usage, or the text cannot be written.
"""

from __future__ import annotations

import argparse
import functools
import importlib
import re
import shlex
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path

from base.tree import GLSL
from translate.library_file import ARITHMETICS, IMPORT_PATH_HELP, add_options, import_path, imported_as, write
from translate.names import wgsl_name
from translate.parsing.tokens import Unknown
from translate.pick import scalars, tsl
from translate.pick.evaluate import Module
from translate.pick.printer import guard
from translate.pick.program import Program, check_sums, chosen, expanded, facts, heading, listed, origin, over, read
from translate.pick.scalars import Syntax
from translate.pick.shading import LANGUAGES
from translate.settings import Settings, settings_of

# The languages of the CPU by their names, as far as their files are here.
SYNTAXES: dict[str, type[Syntax]] = {
    language: getattr(importlib.import_module(f"translate.pick.{module}"), name) for language, module, name in (
        ("rust", "rust", "Rust"), ("csharp", "csharp", "CSharp"), ("c", "c", "C"),
        ("typescript", "javascript", "TypeScript"), ("javascript", "javascript", "JavaScript"),
        ("java", "java", "Java"), ("go", "go", "Go"), ("python", "python", "Python"), ("gdscript", "gdscript", "GDScript"),
        ("osl", "osl", "Osl"))
    if Path(__file__).with_name(f"{module}.py").is_file()}
# One text is for all of these.
ALIASES = {"glsl-es": "glsl", "cuda": "c", "hip": "c", "opencl": "c"}
MANY = 50  # functions; hashnoise.arrays has up to 58 in a text, and packages up to 37
VERILOG = "verilog"  # modules for programs that make circuits; verilog.py can be deleted
OTHERS = [VERILOG] if Path(__file__).with_name("verilog.py").is_file() else []
OF_VERILOG = ("constants", "clock", "stages", "multipliers")
TSL = "tsl"  # three.js's, which is none: a module with the text of two of the shading languages
# The languages in which --name names something, and what.
NAMED = {language: what for language, what in {
    "csharp": "the class", "java": "the class", "go": "the package", "osl": "the shader", "gdscript": "the class_name",
    "hlsl": "names, which begin with it in place of hn"}.items() if language in (*SYNTAXES, "hlsl")}
COMMENT = re.compile(r"//.*|(?m:^\s*##? .*)|(?s:/\*.*?\*/)")
NO_PRECISE = "three.js passes `precise` to no shader: take --arithmetic fixed, whose bits are the same everywhere"


@dataclass(frozen=True)
class Choice:
    """The arguments, by the names of the options."""
    language: str = "glsl"
    arithmetic: str = "fast"
    hash: str = "lattice"
    hash_function: str = ""
    gradient: str = "octahedral"
    noise: str = ""
    import_path: str = ""
    name: str = ""
    constants: str = ""
    clock: str = ""
    stages: str = ""
    multipliers: str = ""

    @property
    def knobs(self) -> Settings:
        return settings_of(self.arithmetic, self.hash, self.gradient, self.hash_function)

    def options(self) -> list[str]:
        """The options that are given, and the arithmetic in any case: a review has to see that it is the server's."""
        given = ((field.name, getattr(self, field.name), field.default) for field in fields(self))
        return [word for name, value, default in given if value != default or name == "arithmetic"
                for word in (f"--{name.replace('_', '-')}", value)]

    @property
    def taken(self) -> str:
        return f"--name {self.name} is a word of the language, or a name in the text: take another name"

    def check(self) -> None:
        if self.name and self.language not in NAMED:
            raise Unknown(f"--name is of --language {', '.join(NAMED)}. A text in Rust, TypeScript, JavaScript or "
                          "Python is a module of any name; elsewhere name all functions in one call of tools/pick")
        if self.name and self.language in SYNTAXES and self.name in SYNTAXES[self.language].reserved:
            raise Unknown(self.taken)
        of_verilog = next((name for name in OF_VERILOG if getattr(self, name)), None)
        if self.language == VERILOG:
            if self.arithmetic != "fixed":
                raise Unknown("a circuit has no floats: take --arithmetic fixed, whose bits are the same everywhere")
            if self.clock and self.stages:
                raise Unknown("--clock and --stages both set the length of a pipeline: give one of them")
            return
        if of_verilog:
            raise Unknown(f"--{of_verilog} is of --language verilog")
        shading = LANGUAGES.get(self.language)
        if self.arithmetic == "precise" and (no_precise := NO_PRECISE if self.language == TSL else (
                shading or SYNTAXES[self.language]).no_precise):
            raise Unknown(no_precise)
        if self.import_path and self.language != "wgsl":
            raise Unknown("--import-path is of --language wgsl")
        if self.hash_function and not shading:
            raise Unknown(f"--hash-function is of shading languages: {', '.join(LANGUAGES)}")


def settings(arithmetic: str, hash_: str = "lattice", gradient: str = "octahedral") -> dict[str, str]:
    return Choice(arithmetic=arithmetic, hash=hash_, gradient=gradient).knobs.macros()


def read_library(library: Path, choice: Choice) -> Module:
    language = LANGUAGES.get(choice.language) or (SYNTAXES[choice.language] if choice.language in SYNTAXES else None)
    macros = {**choice.knobs.macros(), **(language.library if language else {})}
    if choice.language == VERILOG:
        macros["__VERSION__"] = "130"  # without bits of floats
    module = read(library, macros, choice.language in (*SYNTAXES, VERILOG), choice.knobs.own_functions())
    return over(module, choice.noise) if choice.noise else module


def renaming(code: str, choice: Choice) -> Callable[[str], str]:
    """Writes the name that was chosen in place of hn where the code has names."""
    names = {*re.findall(r"\bhn_\w+", code)} - {choice.hash_function}
    return lambda text: re.sub(r"\bhn(_\w+)", lambda found: f"{choice.name or 'hn'}{found[1]}" if found[0] in names else
                               found[0], text)


def command_of(names: Sequence[str], choice: Choice) -> str:
    return shlex.join(["tools/pick", *dict.fromkeys(names), *choice.options()])


def picker(library: Path = GLSL) -> Callable[[Sequence[str], Choice], str]:
    """Makes many texts: the library is read once for each setting and kind of language, and functions that are
    written in one language after the other are evaluated once."""
    kinds: dict[tuple[object, ...], Choice] = {}  # the first choice that is read and evaluated in the same way
    module = functools.cache(functools.partial(read_library, library))

    @functools.lru_cache(maxsize=4)
    def program(names: tuple[str, ...], choice: Choice) -> Program:
        made = Program(module(choice), chosen(module(choice), names), calls_first=len(names) > MANY)
        if made.module.summed:
            check_sums(made, made.module.summed)
        return made

    def pick(names: Sequence[str], choice: Choice) -> str:
        choice.check()
        if choice.language == VERILOG:
            from translate.pick import verilog
            return verilog.text(verilog.circuits(names, choice, module(choice), library), origin(command_of(names, choice)))
        syntax = SYNTAXES[choice.language] if choice.language in SYNTAXES else None
        language = LANGUAGES.get(choice.language)
        macros = (syntax or language or LANGUAGES["glsl"]).library
        alike = replace(choice, language="", import_path="")
        made = program(tuple(names), kinds.setdefault((alike, syntax is None, *macros.items()), choice))
        command, precise = command_of(names, choice), choice.arithmetic == "precise"
        if syntax:
            written = syntax(precise)
            written.name = choice.name or written.name
            written.is_fixed = choice.arithmetic == "fixed"
            text = scalars.text(made, written, facts(made, library, False, choice.knobs), origin(command))
            if choice.name and len(re.findall(rf"\b{choice.name}\b", COMMENT.sub("", text))) > 1:
                raise Unknown(choice.taken)
            return text
        if choice.language == TSL:
            return tsl.text(made, facts(made, library, True, choice.knobs), origin(command))
        code = made.text(language, precise, with_seedless=True)
        renamed = renaming(code, choice)
        words = {*re.findall(r"\w+", code)}
        if choice.name and any(renamed(word) in words - {word} for word in words):
            raise Unknown(choice.taken)
        code = renamed(code)
        if language.is_included:
            name = guard(wgsl_name(made.roots[0].function), code)
            code = f"#ifndef {name}\n#define {name}\n{code}#endif\n"
        return imported_as(choice.import_path) + heading(made, language, command, library, choice.knobs, renamed) + code

    return pick


def picked(names: Sequence[str], choice: Choice = Choice(), library: Path = GLSL) -> str:
    return picker(library)(names, choice)


def count(text: str) -> str:
    """A whole number, as it is written."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"{text} is not a whole number, such as 28")
    return text


def own_name(text: str) -> str:
    """An identifier, which GLSL's rule for underscores does not reserve either."""
    if not re.fullmatch(r"[A-Za-z](_?[A-Za-z0-9])*", text):
        raise argparse.ArgumentTypeError("a name is made of letters, digits and single underscores, such as Terrain, "
                                         f"not {text!r}")
    return text


def positive(text: str) -> str:
    if not count(text).strip("0"):
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return text


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="tools/pick", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="FUNCTION", help="such as hn_perlin2")
    parser.add_argument("--language", choices=(*LANGUAGES, *ALIASES, *SYNTAXES, TSL, *OTHERS), default="glsl",
                        help="glsl (the default, and glsl-es is the same) is for 3.30 and later, GLSL ES 3.00 and WebGL2, "
                        "and with precise for 4.00 and ES 3.20; glsl-desktop is without highp, which naga refuses; "
                        "hlsl is for the shader models 5 and 6; precise is for glsl, hlsl and the languages of the CPU; "
                        "rust needs core alone; csharp is a static class; c is a header of C99, C++, CUDA, "
                        "HIP and OpenCL C, and cuda, hip and opencl are the same; typescript and javascript are modules; "
                        "java is for 17 and later; go for 1.18 and later; python is for arrays of NumPy, PyTorch, JAX and such; gdscript is a script of static functions; osl is a shader of the first function, too; tsl is a module of nodes for "
                        "three.js; verilog is a pipeline for each function, of integers")
    add_options(parser, ARITHMETICS, None, "default: fast, and of verilog fixed")
    parser.add_argument("--noise", metavar="FORM", help="what sums are over, in place of hn_perlin: such as "
                        "hn_simplex3, or for sums with derivatives hn_simplex_d3")
    parser.add_argument("--name", metavar="NAME", type=own_name, help="for a program that has another text of "
                        f"tools/pick: {', '.join(f'of {language} {what}' for language, what in NAMED.items())}")
    parser.add_argument("--constants", metavar="NAME=VALUE,...", help="verilog: parameters that are constant, such as "
                        "octaves=6,lacunarity=2,gain=0.5; seed=7 leaves out the port of the seed")
    parser.add_argument("--clock", metavar="MHZ", type=positive, help="verilog: where registers stand: as many as this clock "
                        "takes on an ECP5, by a simple model (default: 100)")
    parser.add_argument("--stages", metavar="N", type=positive, help="verilog: the same by how many there may be")
    parser.add_argument("--multipliers", metavar="N", type=count, help="verilog: how many multipliers of 18 bits there are; "
                        "other products are sums (default: any number)")
    parser.add_argument("--import-path", metavar="NAME", type=import_path, help=IMPORT_PATH_HELP)
    parser.add_argument("--list", action="store_true", help="write the names of the functions, and what they take")
    parser.add_argument("--glsl", type=Path, default=GLSL, metavar="DIR", help="another copy of the library")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the file to write (default: standard output)")
    given = parser.parse_intermixed_args(arguments)
    given.language = ALIASES.get(given.language, given.language)
    given.arithmetic = given.arithmetic or ("fixed" if given.language == VERILOG else "fast")
    if bool(given.names) == given.list:
        parser.error("name functions, such as hn_perlin2, or ask for --list")
    if given.language == "java" and given.out and given.out.suffix == ".java" and (
            given.out.stem != (given.name or SYNTAXES["java"].name)):
        parser.exit(2, f"tools/pick: {given.out.name} has to have a public class of its name: "
                    f"add --name {given.out.stem}\n")
    choice = Choice(**{field.name: getattr(given, field.name) or field.default for field in fields(Choice)})
    try:
        if given.list:
            written = listed(read_library(given.glsl, replace(choice, language="glsl")), given.glsl)
        else:
            written = picked(expanded(given.names), choice, given.glsl)
    except (Unknown, OSError) as error:
        parser.exit(2, f"tools/pick: {error}\n")
    write(parser, written, given.out)
    if choice.language == "osl" and "\nshader " not in written:
        print(f"tools/pick: the text has functions, but no shader: the first one, {expanded(given.names)[0]}, takes or "
              "returns a type that no parameter of a shader has. docs/guide/engines.md has a shader to write below them",
              file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
