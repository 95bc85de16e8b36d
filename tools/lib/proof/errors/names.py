"""The names of GLSL that a text of a user's may have, and those that are refused, each with its reason."""

from __future__ import annotations

import re

SCALARS = {"float": 1, "int": 1, "uint": 1, "bool": 1}
VECTORS = {f"{kind}vec{n}": n for kind in ("", "i", "u") for n in (2, 3, 4)}
MATRICES = {f"mat{n}{times}": f"mat{n}" for n in (2, 3, 4) for times in ("", f"x{n}")}
# As the text in C++ has them: without macros, so that the errors of a compiler have their places.
TYPES = {name: name for name in VECTORS} | MATRICES | {"float": "Float", "int": "Int", "uint": "Uint", "bool": "bool"}
NO_TYPES = re.compile(r"[iud]?(?:sampler|image|texture|subpassInput)\w*|bvec[234]|d(?:vec|mat)\w+|double|mat[234]x[234]")
# own.hpp has them.
TAKEN = set("""floor ceil trunc round fract abs sign min max clamp mix step smoothstep mod sqrt inversesqrt radians degrees fma dot
length distance normalize cross reflect faceforward transpose floatBitsToUint floatBitsToInt uintBitsToFloat
intBitsToFloat""".split())
NO_ERROR = set("sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh".split())
OTHERS = set("""pow exp log exp2 log2 roundEven modf isnan isinf frexp ldexp refract outerProduct determinant inverse
matrixCompMult lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual any all not bitfieldExtract
bitfieldInsert bitfieldReverse bitCount findLSB findMSB uaddCarry usubBorrow umulExtended imulExtended packUnorm2x16
packSnorm2x16 packUnorm4x8 packSnorm4x8 unpackUnorm2x16 unpackSnorm2x16 unpackUnorm4x8 unpackSnorm4x8 packHalf2x16
unpackHalf2x16 packDouble2x32 unpackDouble2x32""".split())
SHADER = re.compile(r"texture\w*|texel\w*|image[A-Z]\w*|dFd[xy]\w*|fwidth\w*|interpolateAt\w*|noise[1-4]|discard|gl_\w+"
                    r"|barrier|memoryBarrier\w*|atomic\w+|EmitVertex|EndPrimitive|ftransform|shadow[12]D\w*")
STORAGE = {"uniform", "in", "out", "varying", "attribute", "buffer", "shared"}
COARSE = {"mediump", "lowp"}
QUALIFIERS = {"const", "highp", "precise", "invariant", "flat", "smooth", "noperspective", "centroid", "sample", "layout",
              "coherent", "volatile", "restrict", "readonly", "writeonly", *COARSE, *STORAGE, "inout"}
KEYWORDS = {"if", "else", "for", "while", "do", "switch", "case", "default", "break", "continue", "return", "discard",
            "struct", "true", "false", "void", "precision"}
SETS = ("xyzw", "rgba", "stpq")
# Words that GLSL leaves to users, and C++ does not: as members of structs; other names get a prefix.
OF_CPP = set("""alignas alignof and and_eq auto bitand bitor catch char compl concept const_cast constexpr decltype delete
dynamic_cast explicit friend mutable new noexcept not not_eq nullptr operator or or_eq private protected register
reinterpret_cast requires signed static_assert static_cast throw try typeid typename virtual wchar_t xor xor_eq""".split())


def refusal(name: str) -> str:
    """The reason why a name of GLSL is refused, or nothing."""
    if name in NO_ERROR:
        return f"GLSL states no error of {name}"
    if SHADER.fullmatch(name):
        return f"{name} needs a shader that runs"
    if name in OTHERS or NO_TYPES.fullmatch(name):
        return f"the search does not take {name}"
    return ""


def axes_of(name: str) -> list[int]:
    """The axes of .xy and the like."""
    if not 1 <= len(name) <= 4:
        return []
    return next(([axes.index(letter) for letter in name] for axes in SETS if {*name} <= {*axes}), [])
