"""The shading languages, by the names that tools/pick has for them."""

from __future__ import annotations

from pick.printer import Language
from pick.values import PREFIXES
from pick.wgsl import Wgsl
from wgsl.module import NO_PRECISE

HLSL_NAMES = {f"{prefix}vec{size}": f"{scalar}{size}" for scalar, prefix in PREFIXES.items() for size in (2, 3, 4)} | {
    "uintBitsToFloat": "asfloat", "intBitsToFloat": "asfloat", "floatBitsToUint": "asuint", "floatBitsToInt": "asint"}
GLSL_ES = Language(qualifier="highp ", no_precise="GLSL ES has `precise` from 3.20 on, and what this writes is for "
                   "3.00, too: take --arithmetic fixed, whose bits are the same everywhere")
LANGUAGES = {"glsl": Language(), "glsl-es": GLSL_ES,
             "hlsl": Language(fills=False, names=HLSL_NAMES), "wgsl": Wgsl(no_precise=NO_PRECISE)}
# For tests: over include/hashnoise/glsl.hpp, which has no operators of a number and a vector, and with its structs.
CPP = Language(float_suffix="f", function="inline ", out="{}&", inout="{}&", splats=False, fills=False, structs=False,
               no_precise="it always is")
