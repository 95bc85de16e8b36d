"""Rust: text that core alone is enough for."""

from __future__ import annotations

import re
from collections.abc import Sequence

from pick.printer import CHOICE, UNARY
from pick.scalars import Part, Piece, Syntax, Taken, bare, pascal
from pick.values import AXES, SIZES, Operation, scalar_of

CAST = UNARY - 0.5  # `as` binds more strongly than *, and more weakly than an operator before its operand
WRAPPING = {"+": "add", "-": "sub", "*": "mul"}
LIKE_A_GENERIC = ("<", "<=", "<<")  # behind a cast they would be taken for the arguments of its type


def is_number(piece: Piece) -> bool:
    return re.fullmatch(r"-?\d[\w.]*", piece.text) is not None


def typed(piece: Piece, type_: str) -> str:
    """What has a method: a number has no type of its own."""
    if not is_number(piece):
        return piece.within(UNARY)
    number = f"{piece.text}_{Rust.types[type_]}"
    return f"({number})" if number.startswith("-") else number


class Rust(Syntax):
    example_struct = "&mut {}"
    head = "{}"
    counts_a_range = True
    branches_are_values = True
    component = re.compile(r"(?P<space> *)let (?P<name>(?:mut )?(?P<base>\w+)_(?P<axis>[wxyz])(?P<number>\d*))"
                           r" = (?P<value>.*[^{]);")
    components = "{}let ({}) = ({});"
    types = {"float": "f32", "int": "i32", "uint": "u32", "bool": "bool"}
    reserved = frozenset("""as async await break const continue crate dyn else enum extern false fn for if impl in
        let loop match mod move mut pub ref return self static struct super trait true type
        unsafe use where while abstract become box do final macro override priv try typeof
        unsized virtual yield gen f32 i32 u32 core std""".split())
    needs = {"floor": ("trunc",), "trunc": ("abs",)}
    helpers = {
        "sqrt": """\
/// x.sqrt() of std, for x that is not negative: the same bits. After four of Heron's steps an f64 is nearer to the
/// root than to where an f32 would be rounded the other way.
fn sqrt(x: f32) -> f32 {
    if !(x > 0.0 && x < f32::INFINITY) {
        return x;
    }
    let wide = f64::from(x);
    let mut root = f64::from_bits((wide.to_bits() >> 1) + 0x1FF8_0000_0000_0000);
    for _ in 0..4 {
        root = 0.5 * (root + wide / root);
    }
    root as f32
}
""",
        "floor": """/// x.floor() of std: the same bits.
fn floor(x: f32) -> f32 {
    let whole = trunc(x);
    if whole > x {
        whole - 1.0
    } else {
        whole
    }
}
""",
        "trunc": """/// x.trunc() of std: the same bits. From 2^23 on an f32 is whole.
fn trunc(x: f32) -> f32 {
    if abs(x) < 8388608.0 {
        f32::from_bits((x as i32 as f32).to_bits() | (x.to_bits() & 0x8000_0000))
    } else {
        x
    }
}
""",
        "abs": """/// x.abs() of std.
fn abs(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0x7FFF_FFFF)
}
""",
        "min": """fn min(a: f32, b: f32) -> f32 {
    if b < a {
        b
    } else {
        a
    }
}
""",
        "max": """fn max(a: f32, b: f32) -> f32 {
    if a < b {
        b
    } else {
        a
    }
}
"""}

    def function_name(self, name: str, is_public: bool) -> str:
        return bare(name)

    def field_name(self, name: str) -> str:
        return self.variable(name)

    def variable(self, name: str) -> str:
        return f"{name}_" if name in self.reserved else name

    def vector(self, type_: str) -> str:
        return f"[{self.type(scalar_of(type_))}; {SIZES[type_]}]"

    # Expressions.

    def float(self, text: str) -> str:
        return text

    def uint(self, value: int) -> str:
        return f"0x{value:X}" if value > 9999 else str(value)

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if type_ == "uint" and sign in WRAPPING:
            if is_number(left) and sign != "-":
                left, right = right, left
            return Piece(f"{typed(left, type_)}.wrapping_{WRAPPING[sign]}({right.text})")
        if sign in LIKE_A_GENERIC and re.search(r" as \w+$", left.text):
            left = Piece(f"({left.text})")
        return self.infix(sign, left, right)

    def overhead(self, node: Operation) -> int:
        wraps = node.kind == "binary" and node.type == "uint" and node.name in WRAPPING
        return len(".wrapping_add") if wraps else 0

    def unary(self, sign: str, type_: str, operand: Piece) -> Piece:
        if sign == "-" and type_ == "uint":
            return Piece(f"{typed(operand, type_)}.wrapping_neg()")
        return super().unary(sign, type_, operand)

    def choice(self, condition: Piece, yes: Piece, no: Piece, type_: str) -> Piece:
        other = no.text if no.sign == "if" else f"{{ {no.text} }}"
        return Piece(f"if {condition.text} {{ {yes.text} }} else {other}", CHOICE, "if")

    def member(self, of: Piece, axis: str) -> Piece:
        return Piece(f"{of.within(UNARY)}[{AXES.index(axis)}]")

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        return Piece(f"{piece.within(CAST - 0.25)} as {self.type(to)}", CAST, "as")

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        if name in ("uintBitsToFloat", "intBitsToFloat"):
            return self.call("f32::from_bits", arguments)
        if name == "floatBitsToUint":
            return Piece(f"{typed(arguments[0], 'float')}.to_bits()")
        if name in ("min", "max") and type_ != "float":
            first, second = sorted(arguments, key=is_number)
            return Piece(f"{typed(first, type_)}.{name}({second.text})")
        return self.call(self.helper(name), arguments)

    def make_vector(self, type_: str, parts: Sequence[Piece]) -> Piece:
        return Piece(f"[{', '.join(piece.text for piece in parts)}]")

    def make_struct(self, type_: str, fields: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        written = [name if name == piece.text else f"{name}: {piece.text}"
                   for (name, _), piece in zip(((self.field_name(field.name), field.type) for field in fields), parts)]
        return Piece(f"{self.type_name(type_)} {{ {', '.join(written)} }}")

    def make_results(self, results: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        return Piece(f"({', '.join(piece.text for piece in parts)})")

    # Statements.

    def declare(self, type_: str, name: str, value: str | None, changes: bool) -> str:
        if value is None:
            return f"let {name}: {self.type(type_)};"
        return f"let {'mut ' if changes else ''}{name} = {value};"

    def declare_all(self, names: Sequence[str]) -> str:
        return f"let {names[0] if len(names) == 1 else '(' + ', '.join(names) + ')'} = "

    def change(self, type_: str, name: str, sign: str, by: str) -> str | None:
        return None if type_ == "uint" and sign in WRAPPING else f"{name} {sign}= {by}"

    def returned(self, results: Sequence[Part], pieces: Sequence[Piece]) -> list[str]:
        return [line.removeprefix("return ").removesuffix(";") for line in super().returned(results, pieces)]

    def do(self, body: list[str], condition: Piece, negated: str) -> list[str]:
        return ["loop {", *body, f"    if {negated} {{", "        break;", "    }", "}"]

    def forever(self) -> str:
        return "loop {"

    def loop(self, type_: str, name: str, start: str, condition: Piece, step: str, is_read: bool) -> str:
        return f"for {name if is_read else '_'} in {start}..{condition.text.removeprefix(f'{name} < ')} {{"

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = ", ".join(f"{'mut ' if one.changes else '' if one.is_read else '_'}{one.name}: "
                          f"{'&mut ' if one.is_set else ''}{self.type(one.type)}" for one in parameters)
        types = [self.type(one.type) for one in results]
        given = f" -> {types[0]}" if len(types) == 1 else f" -> ({', '.join(types)})" if types else ""
        return f"{'pub ' if is_public else ''}fn {name}({taken}){given} {{"

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        inside = "".join(f"    pub {self.field_name(field.name)}: {self.type(field.type)},\n" for field in fields)
        return f"#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct {pascal(bare(name))} {{\n{inside}}}\n"
