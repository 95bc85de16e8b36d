"""The text as Godot takes it: conditions and macros without a knob are expanded.

Godot's preprocessor looks for every macro in every line, so that hundreds of them take seconds; and behind a second
include it leaves macros with parameters in place. Its compiler for Vulkan
takes a parameter or a variable of a function for the uniform that has the same name, if there is one, such as "seed"
(https://github.com/godotengine/godot/issues/90933). So these get names here that nobody else has.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from base.tree import GLSL
from translate.parsing import tokens
from translate.parsing.preprocessor import CONDITIONAL, DEFINE, DIRECTIVE, Conditions, Preprocessor

# Functions that Godot does not define. Its language has the built-in functions of GLSL ES 3.00.
UNDEFINED = ("__cplusplus", "HN_I_HLSL", "HN_I_FXC", "HN_I_METAL", "HN_I_OWN_SQUARES", "GL_ES",
             "GL_GOOGLE_cpp_style_line_directive", "__GNUC__", "__VERSION__", "_MSC_VER", "VULKAN")
# It has no `precise` either, whatever its version is.
NO_PRECISE = "HN_I_HAS_PRECISE"
# The macros of the library's own. Macros that users write stay: knobs, their values, metrics.
OWN = re.compile(r"(?!HN_\w+_GLSL)(HN_I_\w+|HN_FN|hn_\w+)")
GUARD = re.compile(r"HN_\w+_GLSL")
WORD = re.compile(rf"\b{tokens.WORD}\b")
# A name of a parameter or a variable: no member, no function, nothing with the library's prefix.
LOCAL = re.compile(rf"(?<![.\w])(?!hn_|HN_){tokens.WORD}\b(?!\s*\()")
WORDS_OF_THE_LANGUAGE = frozenset(
    "bool break const continue do else false float for if in inout int out precise return struct true uint void while "
    "bvec2 bvec3 bvec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 vec2 vec3 vec4".split())
SUFFIX = "_hn"


def expanded(lines: Iterable[str]) -> list[str]:
    """The lines without the conditions and macros whose meaning no knob decides."""
    return with_own_names(_without_macros(_without_conditions(lines)))


def _code(line: str) -> str:
    return line.partition("//")[0].rstrip()


def _directive(line: str) -> tuple[str, str]:
    """The name of a directive and the text behind it; two empty texts for any other line."""
    match = DIRECTIVE.fullmatch(_code(line).strip())
    return (match[1], match[2]) if match else ("", "")


def _without_conditions(lines: Iterable[str]) -> list[str]:
    conditions, known = Conditions(), Preprocessor(GLSL, {})

    def value(name: str, condition: str) -> bool | None:
        """Whether a condition holds; None if a knob decides."""
        if name in ("ifdef", "ifndef"):
            return name == "ifndef" if condition in UNDEFINED else None
        if not set(WORD.findall(condition)) - {"defined"} <= {*UNDEFINED, *known.macros}:
            return None
        return known.holds(condition)

    left = []
    for line in lines:
        name, rest = _directive(line)
        if name in CONDITIONAL:
            if not conditions.take(name, rest, value) and conditions.active():
                left.append(line)
            continue
        if not conditions.active():
            continue
        if name == "define":
            if rest.split()[0] == NO_PRECISE:
                line, rest = f"#define {NO_PRECISE} 0", f"{NO_PRECISE} 0"
            is_certain = all(branch.decided or GUARD.fullmatch(branch.condition) for branch in conditions.open)
            if OWN.match(rest) and is_certain and "(" not in rest.split()[0]:
                known.define(rest)
        left.append(line)
    return left


def _without_macros(lines: list[str]) -> list[str]:
    definitions: dict[str, set[str]] = {}
    for line in lines:
        name, rest = _directive(line)
        if name == "define":
            definitions.setdefault(DEFINE.fullmatch(rest)[1], set()).add(rest)
    single = {name: next(iter(texts)) for name, texts in definitions.items()
              if len(texts) == 1 and OWN.fullmatch(name)}
    left = []
    for line in lines:
        name, rest = _directive(line)
        if name == "define" and DEFINE.fullmatch(rest)[1] in single:
            continue
        code = _code(line)
        left.append(_replaced(code, single) + line[len(code):])
    return left


def _replaced(code: str, single: dict[str, str]) -> str:
    """The code with its macros expanded, and all else as it stands."""
    while True:
        for name in WORD.findall(code):
            if name in single:
                _, inner, parameters, body = DEFINE.fullmatch(single[name]).groups()
                if inner:
                    call, arguments = _call(code, name)
                    values = dict(zip((part.strip() for part in parameters.split(",")), arguments))
                    body = WORD.sub(lambda word: values.get(word[0], word[0]), body)
                    code = code.replace(call, body, 1)
                else:
                    code = re.sub(rf"\b{name}\b ?" if not body else rf"\b{name}\b", body, code)
                break
        else:
            return code


def _call(code: str, name: str) -> tuple[str, list[str]]:
    """The first call of a macro, which is on one line, and its arguments."""
    start = re.search(rf"\b{name}\(", code)
    arguments, depth = [""], 1
    for at in range(start.end(), len(code)):
        depth += {"(": 1, ")": -1}.get(code[at], 0)
        if depth == 0:
            return code[start.start():at + 1], [part.strip() for part in arguments]
        if code[at] == "," and depth == 1:
            arguments.append("")
        else:
            arguments[-1] += code[at]
    raise ValueError(f"a call of {name} does not end in its line: {code}")


def with_own_names(lines: list[str]) -> list[str]:
    left = []
    in_struct = False
    for line in lines:
        code = _code(line)
        in_struct = in_struct or code.startswith("struct ")
        if code and not code.lstrip().startswith("#") and not in_struct:
            line = LOCAL.sub(lambda name: name[0] + SUFFIX * (name[0] not in WORDS_OF_THE_LANGUAGE), code) + line[len(code):]
        in_struct = in_struct and not code.startswith("};")
        left.append(line)
    return left
