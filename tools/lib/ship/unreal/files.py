"""The files of the plugin for Unreal: what tools/pick writes in HLSL, and custom nodes, as text of Unreal's clipboard."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import cache

from base.tree import ROOT, address, version
from ship.hlsl_nodes import ARITHMETICS, NODES, PORTS, alone, call, forms, guid, inputs, shader, title, width
from ship.packing import Refused, own_files
from translate.pick.scalars import bare

PACKAGE = ROOT / "packages" / "unreal"
DESCRIPTION = "HashNoise.uplugin"
# A node in a graph, and the expression in it.
NODE = """\
Begin Object Class=/Script/UnrealEd.MaterialGraphNode Name="MaterialGraphNode_{number}"
   Begin Object Class=/Script/Engine.MaterialExpression{kind} Name="MaterialExpression{kind}_{number}"
   End Object
   Begin Object Name="MaterialExpression{kind}_{number}"
{members}\
      MaterialExpressionEditorX={x}
      MaterialExpressionEditorY={y}
      MaterialExpressionGuid={expression_guid}
   End Object
   MaterialExpression="/Script/Engine.MaterialExpression{kind}'MaterialExpression{kind}_{number}'"
   NodePosX={x}
   NodePosY={y}
   NodeGuid={node_guid}
{pins}\
End Object
"""
INPUT, OUTPUT = 'PinType.PinCategory="required"', 'Direction="EGPD_Output"'
CONSTANTS = {1: ("Constant", "R={}"), 2: ("Constant2Vector", "R={}\n      G={}"),
             3: ("Constant3Vector", "Constant=(R={},G={},B={},A=1.0)")}
PASTED = """\
// {called} of hashnoise {version}, by tools/pack unreal
// Copyright (c) 2026 The hashnoise authors; MIT License.
{structs}struct HashNoise {{
{functions}}};
HashNoise noise;
return noise.{call};"""


def code(form: str, arithmetic: str = "fast") -> str:
    """The text of a custom node."""
    return f"return {call(form, arithmetic)};"


def output(form: str) -> str:
    return f"CMOT Float {width(PORTS[forms()[form].type])}"


def struct(form: str, arithmetic: str) -> str:
    """The text of a custom node that includes nothing. Unreal puts it into a function, where HLSL takes other functions in
    a struct alone."""
    is_struct = re.compile(r"(?ms)^struct .*?^};\n")
    text, of = alone(form, "hlsl", arithmetic), call(form, arithmetic)
    return PASTED.format(called=title(form, arithmetic), version=version(), structs="".join(is_struct.findall(text)),
                         functions=is_struct.sub("", text), call=of.replace("(hn_", "(noise.hn_"))


def pasted(form: str, arithmetic: str) -> str:
    """A text that Unreal pastes as nodes: a custom node, and a constant for each input but the position."""
    called, inner, pins, constants = title(form, arithmetic), [], [], ""

    def of(part: str) -> str:
        return guid(f"hashnoise-unreal/{called}/{part}").upper()

    def pin(name: str, own: str, more: str, number: int | None = None, other: str = "") -> str:
        linked = "" if number is None else f"LinkedTo=(MaterialGraphNode_{number} {of(other)},),"
        return f'CustomProperties Pin (PinId={of(own)},PinName="{name}",{more},{linked})'

    def node(number: int, kind: str, at: tuple[int, int], members: list[str], of_node: list[str]) -> str:
        return NODE.format(number=number, kind=kind, x=at[0], y=at[1], members="".join(f"      {one}\n" for one in members),
                           pins="".join(f"   {one}\n" for one in of_node), node_guid=of(f"node {number}"),
                           expression_guid=of(f"expression {number}"))
    for number, one in enumerate(inputs(form)):
        if not one.default:
            inner.append(f'Inputs({number})=(InputName="{one.name}")')
            pins.append(pin(one.name, one.name, INPUT))
            continue
        kind, text = CONSTANTS[len(one.default)]
        inner.append(f'Inputs({number})=(InputName="{one.name}",Input=(Expression="/Script/Engine.MaterialExpression{kind}\''
                     f'MaterialGraphNode_{number}.MaterialExpression{kind}_{number}\'"))')
        pins.append(pin(one.name, one.name, INPUT, number, f"constant {one.name}"))
        constants += node(number, kind, (-300, 80 * number), [text.format(*map(float, one.default))],
                          [pin("Output", f"constant {one.name}", OUTPUT, 0, one.name)])
    text = struct(form, arithmetic).replace("\n", "\\r\\n")
    members = [f'Code="{text}"', f"OutputType=CMOT_Float{width(PORTS[forms()[form].type])}", f'Description="{called}"', *inner]
    return node(0, "Custom", (0, 0), members, [*pins, pin("Output", "Output", OUTPUT)]) + constants


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    return ((f"{bare(form)} {arithmetic}", f"{code(form, arithmetic)} {output(form)}")
            for form in NODES for arithmetic in ARITHMETICS)


@cache
def package(engine: str | None = None) -> dict[str, str]:
    """All files, by their paths. Fab wants a zip file for each version of the engine."""
    if engine is not None and not re.fullmatch(r"5\.\d+", engine):
        raise Refused(f"--engine {engine}: write a version of Unreal such as 5.6")
    found = own_files(PACKAGE)
    own = {"VersionName": version()} | ({"CreatedByURL": address()} if address() else {}) | (
        {"EngineVersion": f"{engine}.0"} if engine else {})
    found[DESCRIPTION] = json.dumps({**json.loads(found[DESCRIPTION]), **own}, indent=2) + "\n"
    found["LICENSE"] = (ROOT / "LICENSE").read_text(encoding="utf-8")
    for arithmetic, suffix in ARITHMETICS.items():
        found[f"Shaders/HashNoise{suffix}.ush"] = shader(arithmetic)
        found |= {f"Nodes/{title(form, arithmetic)}.txt": pasted(form, arithmetic) for form in NODES}
    return found
