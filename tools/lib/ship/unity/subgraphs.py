"""Subgraphs of Unity's Shader Graph, one for each node: inputs with defaults, and a Custom Function node that calls the
package's HLSL.

A file has several objects of JSON and an empty line after each, as Shader Graph writes it from version 10 on. The first
object is the graph, which names the others by their m_ObjectId.
"""

from __future__ import annotations

import json
import uuid
from typing import Any

from ship.hlsl_nodes import ARITHMETICS, PORTS, Input, forms, guid, inputs, title, width
from ship.recipes import RECIPES

NAME = RECIPES["unity"].name
SHADER_GRAPH = "UnityEditor.ShaderGraph."
# Numbers that Shader Graph has for choices: of nodes, of graphs, of slots, of properties.
SINGLE, GRAPH_OF_SINGLE, PREVIEW_2D, OUTPUT, ALL_STAGES, INTEGER = 1, 0, 1, 1, 3, 2
Reference = dict[str, str]


def own_guid(path: str) -> str:
    """The GUID of a file, or of a part of it."""
    return guid(f"{NAME}/{path}")


def file(form: str, arithmetic: str) -> str:
    return f"Graphs/{title(form, arithmetic)}.shadersubgraph"


class Objects:
    """The objects of a file."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.found: list[dict[str, Any]] = []

    def add(self, type_: str, name: str, version: int = 0, **members: Any) -> Reference:
        self.found.append({"m_SGVersion": version, "m_Type": f"{SHADER_GRAPH}{type_}",
                           "m_ObjectId": own_guid(f"{self.path}/{name}"), **members})
        return {"m_Id": self.found[-1]["m_ObjectId"]}

    def slot(self, node: str, number: int, name: str, type_: str, default: tuple[float, ...] = (), kind: int = 0) -> Reference:
        same = value(type_, default)
        return self.add(f"Vector{width(type_)}MaterialSlot", f"{node}/{name}", m_Id=number, m_DisplayName=name,
                        m_SlotType=kind, m_Hidden=False, m_ShaderOutputName=name, m_StageCapability=ALL_STAGES,
                        m_Value=same, m_DefaultValue=same, m_Labels=[])

    def node(self, type_: str, name: str, version: int, shown: str, place: tuple[int, int], slots: list[Reference],
             **members: Any) -> Reference:
        at = {"serializedVersion": "2", "x": float(place[0]), "y": float(place[1]), "width": 200.0, "height": 40.0}
        return self.add(type_, name, version, **{
            "m_Group": {"m_Id": ""}, "m_Name": shown, "m_DrawState": {"m_Expanded": True, "m_Position": at},
            "m_Slots": slots, "synonyms": [], "m_Precision": SINGLE, "m_PreviewExpanded": False, "m_DismissedVersion": 0,
            "m_PreviewMode": 0, "m_CustomColors": {"m_SerializableColors": []}, **members})

    def property(self, one: Input) -> Reference:
        type_ = PORTS[one.type]
        of_float = {"m_FloatType": INTEGER * (one.type in ("int", "uint")), "m_RangeValues": {"x": 0.0, "y": 1.0}}
        return self.add(f"Internal.Vector{width(type_)}ShaderProperty", f"property/{one.name}", 1, **{
            "m_Guid": {"m_GuidSerialized": str(uuid.UUID(own_guid(f"{self.path}/input/{one.name}")))}, "m_Name": one.name,
            "m_DefaultRefNameVersion": 1, "m_RefNameGeneratedByDisplayName": one.name,
            "m_DefaultReferenceName": f"_{one.name}", "m_OverrideReferenceName": "", "m_GeneratePropertyBlock": True,
            "m_UseCustomSlotLabel": False, "m_CustomSlotLabel": "", "m_DismissedVersion": 0, "m_Precision": SINGLE,
            "overrideHLSLDeclaration": False, "hlslDeclarationOverride": 0, "m_Hidden": False,
            "m_Value": value(type_, one.default, axes=4), **(of_float if type_ == "float" else {})})


def value(type_: str, numbers: tuple[float, ...], axes: int = 0) -> float | dict[str, float]:
    """A number, or one for each axis."""
    first, *others = map(float, (*numbers, 0, 0, 0, 0))
    return first if type_ == "float" else dict(zip("xyzw"[:axes or width(type_)], (first, *others)))


def edge(output: Reference, number: int, input_: Reference, of_input: int) -> dict[str, Any]:
    return {"m_OutputSlot": {"m_Node": output, "m_SlotId": number}, "m_InputSlot": {"m_Node": input_, "m_SlotId": of_input}}


def subgraph(form: str, arithmetic: str) -> str:
    """The text of a file. An input and the slot of the function have the same number, since Shader Graph passes slots in
    their order."""
    objects, suffix, called = Objects(file(form, arithmetic)), ARITHMETICS[arithmetic], title(form, arithmetic)
    given, result = inputs(form), PORTS[forms()[form].type]
    function = objects.node(
        "CustomFunctionNode", "function", 1, f"{called} (Custom Function)", (0, 0),
        [*(objects.slot("function", i, one.name, PORTS[one.type], one.default) for i, one in enumerate(given)),
         objects.slot("function", len(given), "Out", result, kind=OUTPUT)],
        m_SourceType=0, m_FunctionName=called, m_FunctionSource=own_guid(f"Shaders/HashNoise{suffix}.hlsl"),
        m_FunctionSourceUsePragmas=True, m_FunctionBody="")
    properties = [objects.property(one) for one in given]
    nodes = [objects.node("PropertyNode", f"node/{one.name}", 0, "Property", (-300, 50 * i),
                          [objects.slot(f"node/{one.name}", 0, one.name, PORTS[one.type], kind=OUTPUT)], m_Property=property_)
             for i, (one, property_) in enumerate(zip(given, properties))]
    output = objects.node("SubGraphOutputNode", "output", 0, "Output", (300, 0), [objects.slot("output", 1, "Out", result)],
                          IsFirstSlotValid=True)
    category = objects.add("CategoryData", "category", m_Name="", m_ChildObjectList=properties)
    context = {"m_Position": {"x": 0.0, "y": 0.0}, "m_Blocks": []}
    objects.add("GraphData", "graph", 3, **{
        "m_Properties": properties, "m_Keywords": [], "m_Dropdowns": [], "m_CategoryData": [category],
        "m_Nodes": [output, function, *nodes], "m_GroupDatas": [], "m_StickyNoteDatas": [],
        "m_Edges": [*(edge(node, 0, function, i) for i, node in enumerate(nodes)), edge(function, len(given), output, 1)],
        "m_VertexContext": context, "m_FragmentContext": context,
        "m_PreviewData": {"serializedMesh": {"m_SerializedMesh": '{"mesh":{"instanceID":0}}', "m_Guid": ""},
                          "preventRotation": False},
        "m_Path": f"hashnoise/{suffix}".rstrip("/"), "m_GraphPrecision": GRAPH_OF_SINGLE, "m_PreviewMode": PREVIEW_2D,
        "m_OutputNode": output, "m_SubDatas": [], "m_ActiveTargets": []})
    graph, *others = reversed(objects.found)
    return "".join(f"{json.dumps(one, indent=4)}\n\n" for one in (graph, *sorted(others, key=lambda one: one["m_ObjectId"])))
