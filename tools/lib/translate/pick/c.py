"""C99: a header of inline functions."""

from __future__ import annotations

from collections.abc import Sequence

from translate.pick.printer import UNARY, Notation, guard
from translate.pick.scalars import Part, Piece, Syntax, Taken
from translate.pick.values import AXES, PREFIXES

TYPES = {"float": "float", "int": "int32_t", "uint": "uint32_t", "bool": "int"}
CONTRACTION = """\
// Products are rounded before they are added to. GCC does not know the pragma: compile with -ffp-contract=off.
#if defined(_MSC_VER)
#pragma fp_contract(off)
#elif !defined(__GNUC__) || defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif
"""
# A second text would define the same functions, perhaps with other bits.
ALONE = """\
#ifdef HN_PICKED
#error "two texts of tools/pick in one file: name all functions in one call"
#endif
#define HN_PICKED
"""


def _of_two(name: str, sign: str) -> dict[str, str]:
    """A function of two numbers, for each type."""
    return {f"hn_i_{name}_{letter}": f"static inline {type_} hn_i_{name}_{letter}({type_} a, {type_} b) "
            f"{{ return {'b < a' if sign == '<' else 'a < b'} ? b : a; }}\n"
            for letter, type_ in (("f", "float"), ("i", "int32_t"), ("u", "uint32_t"))}


class C(Syntax):
    word = "uint32_t"
    example_struct = example_set = "&{}"
    passed = "#define {} {}"
    indent = 2
    keeps_names, cased = True, staticmethod(str)
    vector_of, struct_of, field_of = "({type}){{{parts}}}", "({type}){{{parts}}}", ".{name} = {value}"
    least_int, bools = Notation.least_int, ("0", "1")
    struct_form = "typedef struct {{\n{fields}}} {name};\n"
    types = TYPES
    reserved = frozenset("""auto break case char const continue default do double else enum extern float for goto if
        inline int long register restrict return short signed sizeof static struct switch
        typedef union unsigned void volatile while bool true false asm near far j0 j1 jn y0 y1
        yn gamma""".split())
    helpers_first = True
    sets_parameters, set_to = True, "*{}"
    helpers = {
        **{name: f"typedef struct {{ {TYPES[scalar]} {', '.join(AXES[:size])}; }} {name};\n"
           for scalar, prefix in PREFIXES.items() for size in (2, 3, 4) for name in [f"hn_{prefix}vec{size}"]},
        **_of_two("min", "<"), **_of_two("max", ">"),
        "hn_i_to_int": """\
// The nearest int, where C leaves open what the value is.
static inline int32_t hn_i_to_int(float x) {
  if (x >= -2147483648.0f && x < 2147483648.0f) return (int32_t)x;
  return x > 0.0f ? INT32_MAX : x < 0.0f ? INT32_MIN : 0;
}
""",
        "hn_i_to_uint": """\
static inline uint32_t hn_i_to_uint(float x) {
  return x >= 4294967296.0f ? UINT32_MAX : x > 0.0f ? (uint32_t)x : 0u;
}
""",
        "hn_i_as_float": """\
static inline float hn_i_as_float(uint32_t bits) {
  union { uint32_t word; float number; } same = {bits};
  return same.number;
}
""",
        "hn_i_as_uint": """\
static inline uint32_t hn_i_as_uint(float x) {
  union { float number; uint32_t word; } same = {x};
  return same.word;
}
"""}

    builtins = {"floor": "floorf", "trunc": "truncf", "sqrt": "sqrtf", "abs": "fabsf", "uintBitsToFloat": "hn_i_as_float",
                "floatBitsToUint": "hn_i_as_uint", **{f"{name} {type_}": f"hn_i_{name}_{type_[0]}"
                                                      for name in ("min", "max") for type_ in ("float", "int", "uint")}}

    def path(self, name: str) -> str:
        first, point, rest = super().path(name).partition(".")
        return f"{first}{'->' if point and first in self.set_structs else point}{rest}"

    def vector(self, type_: str) -> str:
        return self.helper(f"hn_{type_}")

    # Expressions.

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if (type_, sign) != ("int", "<<"):
            return super().binary(sign, type_, left, right)
        shifted = self.infix(sign, self.convert("uint", "int", left), right)  # where a negative number may be shifted
        return self.convert("int", "uint", shifted)

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if of == "float" and to in ("int", "uint"):
            return self.call(self.helper(f"hn_i_to_{to}"), [piece])
        return Piece(f"({self.type(to)}){piece.within(UNARY - 1)}", UNARY)

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = [f"{self.type(one.type)} {'*' if one.is_set else ''}{one.name}" for one in parameters]
        taken += [f"{self.type(part.type)} *{self.variable(part.name)}" for part in results if part.name != "value"]
        given = next((self.type(part.type) for part in results if part.name == "value"), "void")
        return f"static inline {given} {name}({', '.join(taken)}) {{"

    def beginning(self, parameters: Sequence[Taken], is_public: bool) -> list[str]:
        """Compilers may require unread names."""
        return [f"(void){one.name};" for one in parameters if not one.is_read]

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        contraction = [CONTRACTION] if self.precise else []
        code = "\n".join([*contraction, *parts])
        name = guard(names[0], code)
        begin = f"#ifndef {name}\n#define {name}\n\n{ALONE}\n#include <math.h>\n#include <stdint.h>\n"
        return super().file(heading, names, [begin, *contraction, *parts, "#endif\n"])
