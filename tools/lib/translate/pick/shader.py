"""Prints a shader of the suite in which evaluate has all that it calls inside, as tools/pick writes functions.

hn-conform runs this where a case fails, and shows the text if it fails, too.

Exit status: 0 done, 2 it is no such shader.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from base.tree import GLSL
from base.usage import Parser
from translate.parsing.preprocessor import Preprocessor
from translate.parsing.syntax import Function, definitions
from translate.parsing.tokens import Unknown
from translate.pick.evaluate import Module
from translate.pick.program import Program
from translate.pick.shading import LANGUAGES

# The lines above the functions, these, and main with its variables.
PARTS = re.compile(r"((?:(?:[#/]|precision )[^\n]*\n)*)(.*)(^uniform .*)", re.DOTALL | re.MULTILINE)
WRITTEN_ANEW = re.compile(r"\bprecision \w+ \w+;|\bhighp\b|\bprecise\b")


def shortened(shader: str) -> str:
    parts = PARTS.fullmatch(shader)
    if not parts:
        raise Unknown("it has no point to evaluate")
    head, functions, main = parts.groups()
    preprocessor = Preprocessor(GLSL, {})
    preprocessor.read(WRITTEN_ANEW.sub("", functions), "the shader")
    tree = definitions(preprocessor.items)
    # evaluate, and where hn-conform injects a fault also the functions that have it.
    roots = [one for one in tree if isinstance(one, Function) and re.search(rf"\b{one.name}\(", main)]
    program = Program(Module(tree, preprocessor.constants), roots)
    language = LANGUAGES["glsl" if " es\n" in head else "glsl-desktop"]
    return head + program.text(language, precise="precise " in functions) + main


def main(arguments: Sequence[str]) -> int:
    parser = Parser("tools/pick shader", __doc__)
    parser.add_argument("file", type=Path, metavar="FILE")
    given = parser.parse_args(arguments)
    try:
        print(shortened(given.file.read_text("utf-8")), end="")
    except (Unknown, OSError) as error:
        parser.exit(2, f"tools/pick shader: {error}\n")
    return 0
