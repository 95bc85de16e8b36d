"""Go: a package of functions, whose vectors are arrays."""

from __future__ import annotations

import re
from collections.abc import Sequence

from translate.pick.gofmt import formatted
from translate.pick.printer import PRIMARY, STRENGTH
from translate.pick.scalars import Facts, Part, Piece, Syntax, Taken, bare, camel, pascal
from translate.pick.values import AXES, SIZES, scalar_of

PRODUCT = "float32(*)"  # the sign of a product that is rounded
NUMBERS = re.compile(r"(?:0x[\dA-F]+|[\d.]+|[-+*/ ()])+")  # no type follows from these


class Go(Syntax):
    item = "  - "  # as gofmt has it
    name = "hashnoise"  # of the package
    example_of, example_struct = "{}.", "&{}"
    passed = "const {} = {}"
    end = ""
    head = "{}"
    types = {"float": "float32", "int": "int32", "uint": "uint32", "bool": "bool"}
    reserved = frozenset("""break case chan const continue default defer else fallthrough for func go goto if import
        interface map package range return select struct switch type var any append bool byte
        cap clear close complex copy delete error false float32 float64 imag int int32 iota len
        make math max min new nil panic print println real recover rune string true uint uint32
        uint64""".split())
    component = re.compile(r"(?P<space> *)(?P<name>(?P<base>\w*[a-z])(?P<axis>[WXYZ])(?P<number>\d*))"
                           r" := (?P<value>.*[^{])")
    components = "{}{} := {}"
    helpers = {
        "choose": """\
func choose[T any](condition bool, yes, no T) T {
    if condition {
        return yes
    }
    return no
}
""",
        "floor": "func floor(x float32) float32 { return float32(math.Floor(float64(x))) }\n",
        "trunc": "func trunc(x float32) float32 { return float32(math.Trunc(float64(x))) }\n",
        "sqrt": "func sqrt(x float32) float32 { return float32(math.Sqrt(float64(x))) }\n",
        "abs": "func abs(x float32) float32 { return float32(math.Abs(float64(x))) }\n",
        "minFloat": "func minFloat(a, b float32) float32 { return choose(b < a, b, a) }\n",
        "maxFloat": "func maxFloat(a, b float32) float32 { return choose(a < b, b, a) }\n",
        "minInt": "func minInt(a, b int32) int32 { return choose(b < a, b, a) }\n",
        "maxInt": "func maxInt(a, b int32) int32 { return choose(a < b, b, a) }\n",
        "minWord": "func minWord(a, b uint32) uint32 { return choose(b < a, b, a) }\n",
        "maxWord": "func maxWord(a, b uint32) uint32 { return choose(a < b, b, a) }\n",
        "toInt": """\
// toInt gives the nearest int32, where Go leaves open what the value is.
func toInt(x float32) int32 {
    if x >= 2147483648 {
        return math.MaxInt32
    }
    if x < -2147483648 {
        return math.MinInt32
    }
    if x != x {
        return 0
    }
    return int32(x)
}
""",
        "toWord": """\
func toWord(x float32) uint32 {
    if x >= 4294967296 {
        return math.MaxUint32
    }
    if x > 0 {
        return uint32(x)
    }
    return 0
}
"""}
    needs = {name: ("choose",) for name in ("minFloat", "maxFloat", "minInt", "maxInt", "minWord", "maxWord")}

    def function_name(self, name: str, is_public: bool) -> str:
        return re.sub(r"_(?=\d)", "", (pascal if is_public else camel)(bare(name)))

    def constant_name(self, name: str) -> str:
        return pascal(super().constant_name(name).lower())

    def field_name(self, name: str) -> str:
        return pascal(name)

    def vector(self, type_: str) -> str:
        return f"[{SIZES[type_]}]{self.type(scalar_of(type_))}"

    # Expressions.

    def float(self, text: str) -> str:
        return text

    def uint(self, value: int) -> str:
        return f"0x{value:X}" if value > 9999 else str(value)

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if type_ == "float" and sign == "*":
            if left.sign == PRODUCT:
                left = Piece(left.text[len("float32("):-1], STRENGTH["*"], "*")
            made = self.infix(sign, left, right)
            return Piece(f"float32({made.text})", PRIMARY, PRODUCT) if self.precise else made
        return super().binary(sign, type_, left, right)

    def choice(self, condition: Piece, yes: Piece, no: Piece, type_: str) -> Piece:
        if NUMBERS.fullmatch(yes.text) and NUMBERS.fullmatch(no.text):
            yes = Piece(f"{self.type(type_)}({yes.text})")
        return self.call(self.helper("choose"), [condition, yes, no])

    def member(self, of: Piece, axis: str) -> Piece:
        return Piece(f"{of.within(PRIMARY - 1)}[{AXES.index(axis)}]")

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if of == "float":
            return self.call(self.helper("toInt" if to == "int" else "toWord"), [piece])
        return Piece(f"{self.type(to)}({piece.text})")

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        as_bits = {"uintBitsToFloat": "math.Float32frombits", "floatBitsToUint": "math.Float32bits"}
        if name in as_bits:
            return self.call(as_bits[name], arguments)
        kinds = {"float": "Float", "int": "Int", "uint": "Word"} if name in ("min", "max") else {}
        return self.call(self.helper(f"{name}{kinds.get(type_, '')}"), arguments)

    def make_vector(self, type_: str, parts: Sequence[Piece]) -> Piece:
        return Piece(f"{self.vector(type_)}{{{', '.join(piece.text for piece in parts)}}}")

    def make_struct(self, type_: str, fields: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        written = ", ".join(f"{self.field_name(field.name)}: {piece.text}" for field, piece in zip(fields, parts))
        return Piece(f"{self.type_name(type_)}{{{written}}}")

    def make_results(self, results: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        return Piece(", ".join(piece.text for piece in parts))

    # Statements.

    def declare(self, type_: str, name: str, value: str | None, changes: bool) -> str:
        if value is None:
            return f"var {name} {self.type(type_)}"
        if type_ != "bool" and NUMBERS.fullmatch(value):
            return f"var {name} {self.type(type_)} = {value}"
        return f"{name} := {value}"

    def do(self, body: list[str], condition: Piece, negated: str) -> list[str]:
        return ["for {", *body, f"    if {negated} {{", "        break", "    }", "}"]

    def while_(self, condition: str) -> str:
        return f"for {condition} {{"

    def forever(self) -> str:
        return "for {"

    def loop(self, type_: str, name: str, start: str, condition: Piece, step: str, is_read: bool) -> str:
        return f"for {name} := {self.type(type_)}({start}); {condition.text}; {step} {{"

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = ", ".join(f"{one.name} {'*' if one.is_set else ''}{self.type(one.type)}" for one in parameters)
        types = ", ".join(self.type(part.type) for part in results)
        return f"func {name}({taken}) {f'({types})' if len(results) > 1 else types}".rstrip() + " {"

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        inside = "".join(f"    {self.field_name(field.name)} {self.type(field.type)}\n" for field in fields)
        return f"type {self.type_name(name)} struct {{\n{inside}}}\n"

    def documented(self, name: str, facts: Facts) -> list[str]:
        paragraphs = self.paragraphs(facts._replace(what=f"{name}: {facts.what}" if facts.what else ""))
        return [f"// {line}".rstrip() for line in paragraphs]

    def joined(self, lines: Sequence[str], space: str) -> list[str]:
        """Long lines are broken when they are formatted."""
        return self._with_components(lines)

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        imports = '\nimport "math"\n' if any("math." in part for part in parts) else ""
        text = super().file(heading, names, [f"package {self.name}\n{imports}", *parts])
        return formatted(re.sub(r"^( {4})+", lambda found: "\t" * (len(found[0]) // 4), text, flags=re.MULTILINE))
