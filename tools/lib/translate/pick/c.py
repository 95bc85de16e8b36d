"""C99: a header of inline functions, which is C++, CUDA, HIP and OpenCL C as well."""

from __future__ import annotations

from collections.abc import Sequence

from translate.parsing.lines import wrapped
from translate.pick.printer import UNARY, Notation, guard
from translate.pick.scalars import Part, Piece, Syntax, Taken
from translate.pick.values import AXES, PREFIXES

TYPES = {"float": "float", "int": "int32_t", "uint": "uint32_t", "bool": "int"}
# Who compiles: GPUs' languages have no headers, and a function of CUDA is the host's alone unless it is marked.
HEAD = """\
#if defined(__OPENCL_VERSION__) || defined(__OPENCL_C_VERSION__)
#define HN_OPENCL
typedef int int32_t;
typedef uint uint32_t;
#define floorf floor
#define truncf trunc
#define sqrtf sqrt
#define fabsf fabs
#elif defined(__CUDACC_RTC__) || defined(__HIPCC_RTC__)
typedef int int32_t;
typedef unsigned int uint32_t;
#elif !defined(WP_NO_CRT)  // Warp's wp.func_native has them
#include <math.h>
#include <stdint.h>
#endif
#if defined(__CUDACC_RTC__)  // it warns of functions that nothing calls
#define HN_INLINE static __attribute__((unused)) __host__ __device__ inline
#elif defined(__CUDACC__) || defined(__HIP__)
#define HN_INLINE static __host__ __device__ inline
#else
#define HN_INLINE static inline
#endif
"""
FIXED = "// -ffast-math, -use_fast_math and -cl-fast-relaxed-math keep the bits at finite coordinates.\n"
FLOATS = """\
// -ffast-math, -use_fast_math and -cl-fast-relaxed-math change values, by more than the errors below. GCC vectorizes a
// loop over most functions with -O3 -march=native -fno-trapping-math -fno-math-errno.
"""
CONTRACTION = """\
// Products are rounded before they are added to. GCC does not know the pragma: compile with -ffp-contract=off. OpenCL
// rounds roots and quotients with -cl-fp32-correctly-rounded-divide-sqrt alone.
#if defined(HN_OPENCL)
#pragma OPENCL FP_CONTRACT OFF
#elif defined(__HIP__)
#pragma clang fp contract(off)
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#elif !defined(WP_NO_CRT) && (!defined(__GNUC__) || defined(__clang__))
#pragma STDC FP_CONTRACT OFF
#endif
#ifdef __CUDA_ARCH__
#define HN_PRODUCT(a, b) __fmul_rn(a, b)
#else
#define HN_PRODUCT(a, b) ((a) * (b))
#endif
"""
# A second text would define the same functions, perhaps with other bits. Each function of Warp has a text of its own.
BEGIN = """\
#if !defined({0}) || defined(WP_NO_CRT)
#define {0}

#if defined(HN_PICKED) && !defined(WP_NO_CRT)
#error "two texts of tools/pick in one file: name all functions in one call"
#endif
#define HN_PICKED
"""


def _of_two(name: str, sign: str) -> dict[str, str]:
    """A function of two numbers, for each type."""
    return {f"hn_i_{name}_{letter}": f"HN_INLINE {type_} hn_i_{name}_{letter}({type_} a, {type_} b) "
            f"{{ return {'b < a' if sign == '<' else 'a < b'} ? b : a; }}\n"
            for letter, type_ in (("f", "float"), ("i", "int32_t"), ("u", "uint32_t"))}


def _made(name: str, fields: Sequence[tuple[str, str]]) -> str:
    """A function that makes a struct: C++ has no compound literals."""
    taken = ", ".join(f"{type_} {field.replace('.', '_')}" for field, type_ in fields)
    given = ", ".join(field.replace(".", "_") for field, _ in fields)
    lines = [f"HN_INLINE {name} {name}_of({taken}) {{", f"  {name} made = {{{given}}};", "  return made;", "}"]
    return "".join(f"{part}\n" for line in lines for part in wrapped(line.lstrip(), len(line) - len(line.lstrip())))


class C(Syntax):
    word = "uint32_t"
    example_struct = example_set = "&{}"
    passed = "#define {} {}"
    indent = 2
    keeps_names, cased = True, staticmethod(str)
    struct_of = "{type}_of({parts})"
    least_int, bools, forever = Notation.least_int, ("0", "1"), "while (1) {"
    struct_form = "typedef struct {{\n{fields}}} {name};\n"
    types = TYPES
    reserved = frozenset("""auto break case char const continue default do double else enum extern float for goto if
        inline int long register restrict return short signed sizeof static struct switch
        typedef union unsigned void volatile while bool true false asm near far j0 j1 jn y0 y1
        yn gamma and and_eq bitand bitor catch class compl concept constexpr decltype delete explicit export friend
        mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public requires template
        this thread_local throw try typeid typename using virtual wchar_t xor xor_eq kernel global local constant generic
        pipe uniform half quad uchar ushort uint ulong""".split())
    helpers_first = True
    sets_parameters, set_to = True, "*{}"
    helpers = {
        **{name: f"typedef struct {{ {TYPES[scalar]} {', '.join(AXES[:size])}; }} {name};\n"
           for scalar, prefix in PREFIXES.items() for size in (2, 3, 4) for name in [f"hn_{prefix}vec{size}"]},
        **{f"hn_{prefix}vec{size}_of": _made(f"hn_{prefix}vec{size}", [(axis, TYPES[scalar]) for axis in AXES[:size]])
           for scalar, prefix in PREFIXES.items() for size in (2, 3, 4)},
        **_of_two("min", "<"), **_of_two("max", ">"),
        "hn_i_to_int": """\
// The nearest int, where C leaves open what the value is.
HN_INLINE int32_t hn_i_to_int(float x) {
  if (x >= -2147483648.0f && x < 2147483648.0f) return (int32_t)x;
  return x > 0.0f ? 2147483647 : x < 0.0f ? -2147483647 - 1 : 0;
}
""",
        "hn_i_to_uint": """\
HN_INLINE uint32_t hn_i_to_uint(float x) {
  return x >= 4294967296.0f ? 0xFFFFFFFFu : x > 0.0f ? (uint32_t)x : 0u;
}
""",
        "hn_i_as_float": """\
HN_INLINE float hn_i_as_float(uint32_t bits) {
  union { uint32_t word; float number; } same = {bits};
  return same.number;
}
""",
        "hn_i_as_uint": """\
HN_INLINE uint32_t hn_i_as_uint(float x) {
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
        if self.precise and (type_, sign) == ("float", "*"):
            return self.call("HN_PRODUCT", [left, right])
        if (type_, sign) != ("int", "<<"):
            return super().binary(sign, type_, left, right)
        shifted = self.infix(sign, self.convert("uint", "int", left), right)  # where a negative number may be shifted
        return self.convert("int", "uint", shifted)

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if of == "float" and to in ("int", "uint"):
            return self.call(self.helper(f"hn_i_to_{to}"), [piece])
        return Piece(f"({self.type(to)}){piece.within(UNARY - 1)}", UNARY)

    def make_vector(self, type_: str, parts: Sequence[Piece]) -> Piece:
        return self.call(self.helper(f"{self.vector(type_)}_of"), parts)

    def make_struct(self, type_: str, fields: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        self.used.add(f"{type_}_of")
        return super().make_struct(type_, fields, parts)

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = [f"{self.type(one.type)} {'*' if one.is_set else ''}{one.name}" for one in parameters]
        taken += [f"{self.type(part.type)} *{self.variable(part.name)}" for part in results if part.name != "value"]
        given = next((self.type(part.type) for part in results if part.name == "value"), "void")
        return f"HN_INLINE {given} {name}({', '.join(taken)}) {{"

    def beginning(self, parameters: Sequence[Taken], is_public: bool) -> list[str]:
        """Compilers may require unread names."""
        return [f"(void){one.name};" for one in parameters if not one.is_read]

    def change(self, type_: str, name: str, sign: str, by: str) -> str | None:
        return None if self.precise and (type_, sign) == ("float", "*") else super().change(type_, name, sign, by)

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        made = _made(name, [(field.name, self.type(field.type)) for field in fields])
        return super().struct(name, fields) + made * (f"{name}_of" in self.used)

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        contraction = [CONTRACTION] if self.precise else []
        name = guard(names[0], "\n".join([*contraction, *parts]))
        begin = [BEGIN.format(name), FIXED if self.is_fixed else FLOATS, HEAD]
        return super().file(heading, names, [*begin, *contraction, *parts, "#endif\n"])
