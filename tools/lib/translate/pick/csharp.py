"""C#: a static class, for Unity and .NET, which allocates nothing."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence

from translate.pick.printer import UNARY
from translate.pick.scalars import (
    Facts,
    Part,
    Piece,
    Syntax,
    Taken,
    bare,
    indented,
    paragraph_lines,
    pascal,
)
from translate.pick.values import AXES, SIZES, scalar_of


class CSharp(Syntax):
    name = "HashNoise"  # of the class
    example_of, example_struct = "{}.", "ref {}"
    passed = "public const int {} = {};"
    types = {"float": "float", "int": "int", "uint": "uint", "bool": "bool"}
    reserved = frozenset("""abstract as base bool break byte case catch char checked class const continue decimal
        default delegate do double else enum event explicit extern false finally fixed float for
        foreach goto if implicit in int interface internal is lock long namespace new null
        object operator out override params private protected public readonly ref return sbyte
        sealed short sizeof stackalloc static string struct switch this throw true try typeof
        uint ulong unchecked unsafe ushort using var virtual void volatile while""".split())
    shifts_by_int = names_components = True
    struct_form, field_form = "public struct {name} {{\n{fields}}}\n", "    public {type} {name};\n"
    vector_of, struct_of, field_of = "({parts})", "new {type} {{ {parts} }}", "{name} = {value}"
    builtins = {**{name: name.capitalize() for name in ("floor", "trunc", "sqrt", "min", "max")},
                **{f"{name} {type_}": f"System.Math.{name.capitalize()}" for name in ("min", "max") for type_ in ("int", "uint")},
                "abs": "System.Math.Abs", "uintBitsToFloat": "AsFloat", "floatBitsToUint": "AsUint"}
    needs = {"AsFloat": ("Bits",), "AsUint": ("Bits",)}
    helpers = {
        "Floor": "private static float Floor(float x) { return (float)System.Math.Floor(x); }\n",
        "Trunc": "private static float Trunc(float x) { return (float)System.Math.Truncate(x); }\n",
        "Sqrt": "private static float Sqrt(float x) { return (float)System.Math.Sqrt(x); }\n",
        "Min": "private static float Min(float a, float b) { return b < a ? b : a; }\n",
        "Max": "private static float Max(float a, float b) { return a < b ? b : a; }\n",
        "ToInt": """\
// The nearest int, where C# leaves open what the value is.
private static int ToInt(float x) {
    if (x >= -2147483648f && x < 2147483648f) return (int)x;
    return x > 0f ? int.MaxValue : x < 0f ? int.MinValue : 0;
}
""",
        "ToUint": """\
private static uint ToUint(float x) {
    return x >= 4294967296f ? uint.MaxValue : x > 0f ? (uint)x : 0u;
}
""",
        "AsFloat": """\
private static float AsFloat(uint bits) {
    Bits same = default(Bits);
    same.Word = bits;
    return same.Number;
}
""",
        "AsUint": """\
private static uint AsUint(float x) {
    Bits same = default(Bits);
    same.Number = x;
    return same.Word;
}
""",
        "Bits": """\
[System.Runtime.InteropServices.StructLayout(System.Runtime.InteropServices.LayoutKind.Explicit)]
private struct Bits {
    [System.Runtime.InteropServices.FieldOffset(0)] public float Number;
    [System.Runtime.InteropServices.FieldOffset(0)] public uint Word;
}
"""}

    def function_name(self, name: str, is_public: bool) -> str:
        return re.sub(r"_(?=\d)", "", pascal(bare(name)))

    def constant_name(self, name: str) -> str:
        return pascal(super().constant_name(name).lower())

    def field_name(self, name: str) -> str:
        return pascal(name)

    def vector(self, type_: str, axes: Sequence[str] = AXES) -> str:
        return f"({', '.join(f'{self.type(scalar_of(type_))} {pascal(axis)}' for axis in axes[:SIZES[type_]])})"

    def returned_type(self, result: Part, is_public: bool) -> str:
        is_vector = is_public and SIZES.get(result.type, 1) > 1
        return self.vector(result.type, self.axes(result)) if is_vector else self.type(result.type)

    def __init__(self, precise: bool = False):
        super().__init__(precise)
        self.wraps = False  # whether the function that is written computes with words that do

    # Expressions.

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        self.wraps |= type_ == "uint" and sign in "+-*"
        return super().binary(sign, type_, left, right)

    def unary(self, sign: str, type_: str, operand: Piece) -> Piece:
        if sign == "-" and type_ == "uint":  # where the sign makes a long
            self.wraps = True
            return self.infix("-", Piece("0u"), operand)
        return super().unary(sign, type_, operand)

    def rounded(self, piece: Piece) -> Piece:
        """A cast makes it a float where a runtime computes with more."""
        return Piece(f"(float)({piece.text})", UNARY) if self.precise else piece

    def member(self, of: Piece, axis: str) -> Piece:
        return super().member(of, pascal(axis))

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if of == "float" and to in ("int", "uint"):
            return self.call(self.helper(f"To{pascal(to)}"), [piece])
        self.wraps |= {of, to} == {"int", "uint"}
        return Piece(f"({to}){piece.within(UNARY - 1)}", UNARY)

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = ", ".join(f"{'ref ' if one.is_set else ''}{self.type(one.type)} {one.name}" for one in parameters)
        types = [self.returned_type(one, is_public) for one in results]
        parts = ", ".join(f"{of} {pascal(one.name)}" for of, one in zip(types, results))
        given = f"({parts})" if len(types) > 1 else types[0] if types else "void"
        return f"{'public' if is_public else 'private'} static {given} {name}({taken}) {{"

    def body(self, lines: Sequence[str]) -> Sequence[str]:
        """Words wrap, also with a compiler option that checks all other integers."""
        wraps, self.wraps = self.wraps, False
        return ["    unchecked {", *(f"    {line}" for line in lines), "    }"] if wraps else lines

    def documented(self, name: str, facts: Facts) -> list[str]:
        returns = facts.all_returns[:1].upper() + facts.all_returns[1:]
        tags = [("summary", facts.what), *((f'param name="{one}"', text) for names, text in facts.parameters.items()
                                           for one in names.split(", ") if one not in facts.sets),
                ("example", facts.call and f"<code>{facts.call}</code>"), ("returns", returns),
                ("remarks", f"Error: {facts.error}" if facts.error else "")]
        lines = [line for tag, shown in tags if shown for line in paragraph_lines(
            f"<{tag}>{shown if tag == 'example' else f'{html.escape(shown, quote=False)}.'}</{tag.split()[0]}>")]
        return [f"/// {line}" for line in lines]

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        """With -doc compilers want a comment for each public member, also for constants and fields."""
        quiet = "#pragma warning disable 1591\n\n"
        about = "/// <summary>Procedural noise.</summary>\n"
        written = super().file(heading, names, [
            f"{quiet}{about}public static class {self.name} {{\n{indented(parts)}}}\n"])
        return f"// <auto-generated/>\n{written}"
