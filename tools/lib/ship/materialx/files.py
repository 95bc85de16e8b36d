"""The files of the library of nodes for MaterialX: what tools/pick writes for each of its targets, and definitions."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple
from xml.sax.saxutils import quoteattr

from base.tree import GLSL, ROOT, version
from catalog import parameters, popular
from catalog.tables.markdown import table
from ship.packing import papers
from translate.parsing.syntax import Function
from translate.pick.command import SYNTAXES, Choice, picker, read_library
from translate.pick.comments import first_sentence
from translate.pick.osl import without_shader
from translate.pick.shading import LANGUAGES

PACKAGE = ROOT / "packages" / "materialx"
LIBRARY = "hashnoise"  # the folder that MaterialX loads
FORMS = popular.nodes("materialx")  # all with HN_FIXED
# The targets of MaterialX, with the languages of tools/pick. The generators for OpenGL, WebGL, Vulkan and WebGPU share
# the first. Metal and Slang would take it, too, if they had none of their own.
TARGETS = {"genglsl": "glsl", "genmsl": "metal", "genslang": "slang", "genosl": "osl"}
METRICS = ("Euclidean", "Squared", "Manhattan", "Chebyshev", "Hybrid")  # HN_METRIC_..., from 1 on
OSL_TYPES = {"float": "float", "int": "int", "vec2": "vector2", "vec3": "vector"}
TYPES = {"float": "float", "int": "integer", "uint": "integer", "vec2": "vector2", "vec3": "vector3"}


class Input(NamedTuple):
    name: str
    type: str  # in GLSL
    said: str  # the other attributes


AMPLITUDE = Input("amplitude", "float", 'value="1.0" uiname="Amplitude" doc="A factor of the noise: any number."')
PIVOT = Input("pivot", "float", 'value="0.0" uiname="Pivot" doc="A summand, behind the factor."')
# By the names and the types of the parameters that they are for. MaterialX's own noises have the same names.
INPUTS = {
    ("p", "vec2"): Input("texcoord", "vec2", 'defaultgeomprop="UV0" uiname="Texture Coordinates" '
                         'doc="The position, in cells."'),
    ("p", "vec3"): Input("position", "vec3", 'defaultgeomprop="Pobject" uiname="Position" '
                         'doc="The position, in cells."'),
    ("octaves", "int"): Input("octaves", "int", 'value="6" uisoftmax="8" uiname="Octaves"'),
    ("lacunarity", "float"): Input("lacunarity", "float", 'value="2.0" uiname="Lacunarity"'),
    ("gain", "float"): Input("diminish", "float", 'value="0.5" uiname="Diminish"'),
    ("amplitude", "float"): Input("amplitude", "float", 'value="1.0" uiname="Amplitude"'),
    ("wave", "vec2"): Input("wave", "vec2", 'value="3.0, 0.0" uiname="Wave"'),
    ("wave", "vec3"): Input("wave", "vec3", 'value="3.0, 0.0, 0.0" uiname="Wave"'),
    ("bandwidth", "float"): Input("bandwidth", "float", 'value="0.0" uiname="Bandwidth"'),
    ("phase", "float"): Input("phase", "float", 'value="0.0" uiname="Phase"'),
    ("jitter", "float"): Input("jitter", "float", 'value="1.0" uiname="Jitter"'),
    ("metric", "int"): Input("metric", "int", f'value="1" enum="{",".join(METRICS)}" enumvalues="'
                             f'{",".join(str(i + 1) for i in range(len(METRICS)))}" uiname="Metric" '
                             'doc="The distance: Squared is the square of the Euclidean one, Manhattan the sum of the '
                             'sizes along the axes, Chebyshev the largest of them, and Hybrid the sum of Manhattan and '
                             'Squared."'),
    ("seed", "uint"): Input("seed", "int", 'value="0" uiname="Seed"'),
}
PERIOD = Input("period", "vec2", 'value="8.0, 8.0" uimin="0.0, 0.0" uiname="Period" '
               'doc="After how many cells it repeats along each axis: whole numbers; 0 is never."')
TILE_LACUNARITY = Input("lacunarity", "float", 'value="2.0" uimin="1.0" uimax="255.0" uiname="Lacunarity" '
                        'doc="How much finer each octave is than the one before: a whole number from 1 to 255, since '
                        'octaves have to fit into the period. Other numbers are rounded down."')


@cache
def forms() -> dict[str, Function]:
    return read_library(GLSL, Choice("glsl", "fixed")).forms


@cache
def pick():
    return picker()


def node(form: str) -> str:
    """The name of the node: hn_perlin2d of hn_perlin2, and hn_perlin2d_tile of hn_perlin2_place."""
    return re.sub(r"(\d)$", r"\1d", popular.ENDS.sub("", form.replace("2_place", "2d_tile")))


def inputs(form: str) -> list[Input]:
    """In the order in which the function of the node takes them."""
    function = forms()[form]
    found = []
    for one in function.parameters:
        if one.type == "hn_place2":
            found += [INPUTS["p", "vec2"], PERIOD]
        elif one.at.text == "lacunarity" and PERIOD in found:
            found.append(TILE_LACUNARITY)
        else:
            found.append(described(INPUTS[one.at.text, one.type], form, one.at.text))
    names = {one.name for one in found}
    # As MaterialX's own have it: what sums octaves has no pivot, and distances and random numbers have neither.
    if function.type == "float" and function.name not in ("hn_random", "hn_cell_border"):
        found = [*((AMPLITUDE,) if "octaves" in names else (AMPLITUDE, PIVOT)), *found]
    return found


def described(given: Input, form: str, parameter: str) -> Input:
    """With the catalog's text and ends. An enumeration shows both by its names."""
    about = parameters.about(form, parameter, is_fixed=True)
    if about is None or "enum=" in given.said:
        return given
    write = float if given.type == "float" else int
    ends = "".join(f' {end}="{write(value)}"' for end, value in (("uimin", about.least), ("uimax", about.most))
                   if value is not None and given.type in ("float", "int"))
    return given._replace(said=f'{given.said}{ends} doc="{about.what[0].upper()}{about.what[1:]}."')


def scaled(form: str, value: str) -> str:
    given = inputs(form)
    return value + " * amplitude" * (AMPLITUDE in given) + " + pivot" * (PIVOT in given)


def wrapper(form: str, language: str) -> str:
    """The function that MaterialX calls, in a shading language."""
    function, of = forms()[form], LANGUAGES[language]
    taken = ", ".join(f"{of.type(one.type)} {one.name}" for one in inputs(form))
    passed = []
    for one in function.parameters:
        if one.type == "hn_place2":
            passed.append(f"hn_tile(texcoord, {of.named('ivec2')}(period))")
        else:
            given = INPUTS[one.at.text, one.type]
            passed.append(f"uint({given.name})" if one.type == "uint" else given.name)
    call = scaled(form, f"{function.name}({', '.join(passed)})")
    result = f"{of.out.format(of.type(function.type))} result"
    return f"{of.function}void {node(form)}({taken}, {result}) {{\n  result = {call};\n}}\n"


def osl_wrapper(form: str) -> str:
    function = forms()[form]
    taken = ", ".join(f"{OSL_TYPES[one.type]} {one.name}" for one in inputs(form))
    passed, before = [], ""
    for one in function.parameters:
        if one.type == "hn_place2":
            before = "  hn_place2 place = hn_tile2(texcoord.x, texcoord.y, (int)period.x, (int)period.y);\n"
            passed.append("place")
        else:
            given = INPUTS[one.at.text, one.type]
            passed += ({"vec2": [f"{given.name}.x", f"{given.name}.y"],
                        "vec3": [f"{given.name}[{axis}]" for axis in range(3)]}.get(one.type, [given.name]))
    call = f"{form}({', '.join(passed)})"
    # Cycles takes no component of a function's result.
    body = {"float": f"  result = {scaled(form, call)};\n",
            "vec2": f"  hn_vec2 n = {call};\n  result = vector2(n.x, n.y);\n",
            "vec3": f"  hn_vec3 n = {call};\n  result = vector(n.x, n.y, n.z);\n"}[function.type]
    type_ = OSL_TYPES[function.type]
    return f"void {node(form)}({taken}, output {type_} result) {{\n{before}{body}}}\n"


def source(form: str, target: str) -> str:
    """The text of a node. Its names are its own, since a shader may have other nodes of the library."""
    language = TARGETS[target]
    names = ("hn_tile2", form) if form.endswith("_place") else (form,)
    text = pick()(names, Choice(language, "fixed"))
    is_osl = language in SYNTAXES
    text = without_shader(text) + osl_wrapper(form) if is_osl else text + wrapper(form, language)
    # MaterialX itself writes the head of a shader, and comments would be in every shader.
    text = re.sub(r"(?m)^ *//.*\n|^#.*\n|^using .*\n", "", text).lstrip()
    own = node(form)
    text = re.sub(rf"\bhn_(?!{own.removeprefix('hn_')}\b)", f"{own}_", re.sub(r"\n{2,}", "\n", text))
    return (f"// {forms()[form].name} of hashnoise {version()} with HN_FIXED, by tools/pack materialx\n"
            "// Copyright (c) 2026 The hashnoise authors; MIT License.\n" + text)


def doc(form: str) -> str:
    """The first sentence about the function, with the name of the input for the gain."""
    if form.endswith("_place"):
        return popular.TILE_DOCS[form]
    return first_sentence(forms()[form], GLSL).replace("by the gain", "by diminish")


def definition(form: str) -> str:
    """The name of the nodedef. As in MaterialX's own it ends with the type, which leaves room for other types."""
    return f"ND_{node(form)}_{TYPES[forms()[form].type]}"


def declared(form: str) -> str:
    function, name = forms()[form], node(form)
    group = "procedural3d" if "3d" in name else "procedural2d"
    rows = "".join(f'    <input name="{one.name}" type="{TYPES[one.type]}" {one.said} />\n' for one in inputs(form))
    zero = ", ".join(["0.0"] * (int(function.type[-1]) if function.type[-1].isdigit() else 1))
    return (f'  <nodedef name="{definition(form)}" node="{name}" nodegroup="{group}" doc={quoteattr(doc(form))}>\n{rows}'
            f'    <output name="out" type="{TYPES[function.type]}" default="{zero}" />\n  </nodedef>\n')


def document(inside: str) -> str:
    return ('<?xml version="1.0"?>\n<materialx version="1.39">\n'
            f"  <!-- Of hashnoise {version()}, by tools/pack materialx.\n"
            f"       Copyright (c) 2026 The hashnoise authors; MIT License. -->\n{inside}</materialx>\n")


def implementations(target: str) -> str:
    return document("".join(
        f'  <implementation name="{definition(form).replace("ND_", "IM_", 1)}_{target}" nodedef="{definition(form)}" '
        f'file="{node(form)}.{TARGETS[target]}" function="{node(form)}" target="{target}" />\n' for form in FORMS))


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    for form in FORMS:
        for one in inputs(form):
            usual = re.search(r'(?:value|defaultgeomprop)="([^"]*)"', one.said)
            yield f"{node(form)}.{one.name}", f"{TYPES[one.type]} {usual[1]}"
        output = re.search(r'<output name="(\w+)" type="(\w+)"', declared(form))
        yield f"{node(form)}.{output[1]}", f"output {output[2]}"


def node_table() -> str:
    return table(("node", "inputs", "`out`"),
                 [(f"`{node(form)}`", ", ".join(f"`{one.name}`" for one in inputs(form)), TYPES[forms()[form].type])
                  for form in FORMS])


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    found = {**papers(PACKAGE), f"{LIBRARY}/hashnoise_defs.mtlx": document("".join(map(declared, FORMS)))}
    for target in TARGETS:
        found[f"{LIBRARY}/{target}/hashnoise_{target}_impl.mtlx"] = implementations(target)
        for form in FORMS:
            found[f"{LIBRARY}/{target}/{node(form)}.{TARGETS[target]}"] = source(form, target)
    return found
