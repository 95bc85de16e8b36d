"""three.js's shading language: a module whose functions make nodes, with the text of both languages of its renderers."""

from __future__ import annotations

import re
from collections.abc import Sequence

from base.tree import ROOT
from translate.names import wgsl_name
from translate.parsing.syntax import Function
from translate.parsing.tokens import Unknown
from translate.pick import comments
from translate.pick.comments import Facts
from translate.pick.program import Program
from translate.pick.shading import LANGUAGES

NODES = ROOT / "packages" / "npm" / "src" / "tsl" / "function.js"
TYPES = re.compile(r"float|u?int|[iu]?vec[234]|hn_place[1-4]")


def signature(function: Function) -> str:
    """The parameters as in GLSL."""
    is_node = all(map(TYPES.fullmatch, (function.type, *function.types)))
    if not is_node or not function.parameters or any(one.is_set for one in function.parameters):
        raise Unknown(f"three.js has no nodes for {function.name}({', '.join(function.types)}), which returns "
                      f"{function.type}: take functions of numbers, vectors and places")
    return ", ".join(f"{one.type} {one.at.text}" for one in function.parameters)


def quoted(text: str) -> str:
    """As a template of JavaScript."""
    return "`" + text.replace("\\", r"\\").replace("`", r"\`").replace("${", r"\${") + "`"


def text(program: Program, known: Sequence[Facts], heading: Sequence[str]) -> str:
    functions = [root.function for root in program.roots]
    signatures = [signature(function) for function in functions]
    opening, nodes = NODES.read_text(encoding="ascii").split("\n\n", 1)
    imports = opening.splitlines()[-1]
    for used in ("glsl", "wgsl"):
        imports = imports.replace(f" {used}Fn", f" {used}, {used}Fn")
    written = ["".join(f"//{line}\n" for line in heading), f"{imports}\n", nodes.replace("export ", ""),
               f"const textOfGlsl = glsl({quoted(program.text(LANGUAGES['glsl'], False))});\n",
               f"const textOfWgsl = wgsl({quoted(program.text(LANGUAGES['wgsl'], False))});\n"]
    for function, declared, facts in zip(functions, signatures, known):
        name, seed = wgsl_name(function), ", true" * program.may_lack_seed(function)
        lines = comments.lines(facts, str, f"{name}({', '.join(one.at.text for one in function.parameters)})")
        written.append("".join(f"//{line}\n" for line in (f" {name}({declared})", *lines)) +
                       f'export const {name} = nodesOf("{name}", "{function.type}", "{declared}",\n'
                       f'  "{function.name}", () => textOfWgsl, () => textOfGlsl{seed});\n')
    return "\n".join(written)
