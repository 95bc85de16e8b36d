"""The shading languages, by the names that tools/pick has for them."""

from __future__ import annotations

from dataclasses import replace

from translate.pick.printer import Language
from translate.pick.typer import CASTS
from translate.pick.values import PREFIXES
from translate.pick.wgsl import Wgsl
from translate.settings import NO_PRECISE
from translate.single_file.godot import SUFFIX

HLSL_NAMES = {f"{prefix}vec{size}": f"{scalar}{size}" for scalar, prefix in PREFIXES.items() for size in (2, 3, 4)} | {
    "uintBitsToFloat": "asfloat", "intBitsToFloat": "asfloat", "floatBitsToUint": "asuint", "floatBitsToInt": "asint"}


class Metal(Language):
    def called(self, name: str, type_: str) -> str:
        return f"as_type<{self.type(type_)}>" if name in CASTS else name


class Godot(Language):
    def variable(self, name: str) -> str:
        """One that is no uniform's, since Godot may take it for that (single_file.godot)."""
        return f"{name}{SUFFIX}"


# In a fragment shader of GLSL ES numbers have 16 bits unless a declaration sets more, whatever the user's own
# precision is. Elsewhere `highp` means nothing. A constructor should have the precision of its argument; NVIDIA's
# driver gives it the scope's, where float(100000) is infinite. And in a loop SwiftShader, on which browsers draw
# without a GPU, compiles twice as long for each branch, so that there may be no thirty.
GLSL = Language(qualifier="highp ", scope="precision highp float;", names_choices=True)
DESKTOP = replace(GLSL, qualifier="", scope="")  # naga refuses `highp` before a parameter
NO_PRECISE_IN_METAL = ("Metal's language has no `precise`, and its compiler computes by fast math unless an option "
                       "turns it off: take --arithmetic fixed, whose bits are the same everywhere")
HLSL = Language(fills=False, is_included=True, names=HLSL_NAMES, library={"HN_I_FXC": "1"})
# Slang does not find a variable that was declared before it in the same statement, if `<` stands behind its name.
SLANG = replace(HLSL, is_included=False, joins=False, no_precise="Slang's compiler leaves `precise` out of SPIR-V: "
                "take --arithmetic fixed, whose bits are the same everywhere")
METAL = Metal(opening="#include <metal_stdlib>\nusing namespace metal;\n\n", is_included=True, float_end="f",
              function="inline ", out="thread {}&", inout="thread {}&", no_precise=NO_PRECISE_IN_METAL,
              names=HLSL_NAMES)
# Its operators are used as the text of the library uses them, which Godot has compiled: of two vectors.
GODOT = Godot(splats=False, names_choices=True, no_precise="Godot's language has no `precise`: take --arithmetic "
              "fixed, whose bits are the same everywhere")
LANGUAGES = {"glsl": GLSL, "glsl-desktop": DESKTOP, "hlsl": HLSL, "slang": SLANG, "metal": METAL, "godot": GODOT,
             "wgsl": Wgsl(passed="&{}", no_precise=NO_PRECISE, joins=False)}
