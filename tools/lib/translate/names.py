"""The names that functions and variables have in WGSL, which has no overloads. They follow from one function alone, so
they do not move when others are added.

A public function has its name in GLSL, and behind it:

  1 to 4      its dimensions: of the position, the place, the cell or the words that it takes
  _place      if it takes a place
  _phase      if it takes a phase, which it need not: hn_phasor and hn_cellular_phase always do
  _jitter     if it takes a jitter and no phase: of all the settings of cellular noise, there are forms without
  _nearest    as _jitter, if it also sets the nearest point
  _detail, _footprint, _bandwidth    if it takes that

So hn_perlin(hn_place2 place, uint seed) is hn_perlin2_place. Functions of words or distributions that are not overloaded
keep their names: hn_hash_pcg, hn_unorm, hn_gradient2, hn_shuffle. So do the hashes of several words that have a name, such
as hn_hash_pcg2d. So hn_gradient of a cell is hn_gradient_lattice2. A struct that users know keeps its name, too. So
a function that makes a hn_place2 is hn_place_of2 of a position, hn_place_in_cell2 of a cell and a fraction,
hn_place_at_cell2 of a cell, and hn_place_of_units2.

An internal function has the types of its parameters behind its name: hn_i_lerp_f32_f32_f32. A struct is called there as
it is, without the hn_ or hn_i_.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from translate.parsing.syntax import Function

# The argument of a function of hashes, or of distributions, without overloads; and hashes by name.
NOT_OVERLOADED = (("h",), ("k",), ("h", "k"), ("i", "n", "seed"), ("i", "seed"), ("zero",), ("kind",),
                  ("value", "distribution"), ("distribution", "detail", "gain"))
OF_A_NAME = "hn_hash_"
# Functions with other names, where another function or a struct has the name; by its first parameter.
OTHERS = {("hn_gradient", "cell"): "hn_gradient_lattice", ("hn_place", "p"): "hn_place_of",
          ("hn_place", "cell"): "hn_place_in_cell", ("hn_place", "position"): "hn_place_of_units",
          ("hn_octaves", "p"): "hn_octaves_of", ("hn_octaves", "place"): "hn_octaves_of",
          ("hn_slopes", "o"): "hn_slopes_of", ("hn_shifts", "o"): "hn_shifts_of",
          ("hn_flows", "o"): "hn_flows_of"}
ALONE = {("hn_place", "cell"): "hn_place_at_cell"}  # of these parameters alone
ALWAYS_OF_A_PLACE = ("hn_position",)
PLACE = re.compile(r"hn_place([1-4])")
OF_AXES = re.compile(r"hn_(place|octaves|slopes|shifts|flows)([1-4])")  # structs
WITH_VECTORS = ("hn_add", "hn_mean")  # beside the octaves they may take a sum of slopes, shifts or flows

# How the constants begin that users pass, by the name of the parameter.
PASSED = {"metric": "HN_METRIC_", "kind": "HN_DISTRIBUTION_"}

# Names of variables that WGSL reserves, or that the module calls.
RESERVED = frozenset("""
    NULL Self abstract active alignas alignof as asm asm_fragment async attribute auto await become cast catch class
    co_await co_return co_yield coherent column_major common compile compile_fragment concept const_cast consteval
    constexpr constinit crate debugger decltype delete demote demote_to_helper do dynamic_cast enum explicit export
    extends extern external fallthrough filter final finally friend from fxgroup get goto groupshared highp impl
    implements import inline instanceof interface layout lowp macro macro_rules match mediump meta mod module move mut
    mutable namespace new nil noexcept noinline nointerpolation non_coherent noncoherent noperspective null nullptr of
    operator package packoffset partition pass patch pixelfragment precise precision premerge priv protected pub public
    readonly ref regardless register reinterpret_cast require resource restrict self set shared sizeof smooth snorm
    static static_assert static_cast std subroutine super target template this thread_local throw trait try type
    typedef typeid typename typeof union unless unorm unsafe unsized use using varying virtual volatile wgsl where with
    writeonly yield
    alias break case const const_assert continue continuing default diagnostic discard else enable false fn for if let
    loop override requires return struct switch true var while
    abs bitcast floor f32 i32 max min select sqrt trunc u32 bool vec2f vec3f vec4f vec2i vec3i vec4i vec2u vec3u vec4u
    """.split())

WGSL_SCALARS = {"float": "f32", "int": "i32", "uint": "u32", "bool": "bool"}
WGSL_LETTERS = {"": "f", "i": "i", "u": "u"}


def wgsl_type(glsl: str) -> str:
    """vec2f for vec2; a struct keeps its name."""
    if glsl in WGSL_SCALARS:
        return WGSL_SCALARS[glsl]
    element, bracket, size = glsl.rstrip("]").partition("[")
    if bracket:
        return f"array<{wgsl_type(element)}, {size}>"
    prefix, vec, size = glsl.partition("vec")
    if vec and prefix in WGSL_LETTERS and size in ("2", "3", "4"):
        return f"vec{size}{WGSL_LETTERS[prefix]}"
    return glsl


def components(glsl: str) -> int:
    return int(glsl[-1]) if "vec" in glsl or OF_AXES.fullmatch(glsl) else 1


def variable(name: str, reserved: Collection[str] = RESERVED) -> str:
    return f"{name}_" if name in reserved else name


def is_public(name: str) -> bool:
    return name.startswith("hn_") and not name.startswith("hn_i_")


def is_passed(constant: str) -> bool:
    """Whether users pass it. (Knobs and versions are the preprocessor's own.)"""
    return constant.startswith(tuple(PASSED.values()))


def wgsl_name(function: Function) -> str:
    return _public(function) if is_public(function.name) else _internal(function)


def _internal(function: Function) -> str:
    if not function.name.startswith("hn_"):
        return function.name  # the user's own
    return "_".join((function.name, *(re.sub("^hn_(i_)?", "", wgsl_type(type_)) for type_ in function.types)))


def _public(function: Function) -> str:
    takes = [parameter.at.text for parameter in function.parameters]
    if tuple(takes) in NOT_OVERLOADED or function.name.startswith(OF_A_NAME):
        return function.name
    name = ALONE.get((function.name, *takes)) or OTHERS.get((function.name, takes[0]), function.name)
    parts = [f"{name}{components(function.types[0])}"]
    if PLACE.fullmatch(function.types[0]) and name not in ALWAYS_OF_A_PLACE:
        parts.append("place")
    if function.name in WITH_VECTORS and len(function.types) > 1 and (other := OF_AXES.fullmatch(function.types[1])):
        parts.append(other[1])
    is_phase_chosen = "phase" in takes and "wave" not in takes and not function.name.endswith("_phase")
    parts += ["phase"] * is_phase_chosen
    if "nearest" in takes:
        parts.append("nearest")
    elif "jitter" in takes and "phase" not in takes:
        parts.append("jitter")
    parts += [word for word in ("detail", "footprint", "bandwidth") if word in takes]
    return "_".join(parts)
