"""Rust: text that core alone is enough for."""

from __future__ import annotations

import math
import re
import struct
from collections.abc import Sequence
from decimal import Decimal

from translate.names import OF_AXES
from translate.pick.printer import CHOICE, PRIMARY, UNARY, Declaration
from translate.pick.scalars import Part, Piece, Syntax, Taken
from translate.pick.values import SIZES, Operation, scalar_of

CAST = UNARY - 0.5  # `as` binds more strongly than *, and more weakly than an operator before its operand
WRAPPING = {"+": "add", "-": "sub", "*": "mul"}
LIKE_A_GENERIC = ("<", "<=", "<<")  # behind a cast they would be taken for the arguments of its type


def _constants() -> dict[float, str]:
    """The constants of core, which clippy wants, by their values as f32."""
    values = {"E": math.e, "PI": math.pi, "TAU": math.tau, "SQRT_2": math.sqrt(2), "LN_2": math.log(2),
              "LN_10": math.log(10), "LOG2_E": math.log2(math.e), "LOG10_E": math.log10(math.e),
              "LOG2_10": math.log2(10), "LOG10_2": math.log10(2), "FRAC_1_PI": 1 / math.pi, "FRAC_2_PI": 2 / math.pi,
              "FRAC_1_SQRT_2": math.sqrt(0.5), "FRAC_2_SQRT_PI": 2 / math.sqrt(math.pi),
              **{f"FRAC_PI_{n}": math.pi / n for n in (2, 3, 4, 6, 8)}}
    return {single(value): f"core::f32::consts::{name}" for name, value in values.items()}


def single(value: float) -> float:
    """The f32 that is nearest."""
    return struct.unpack("f", struct.pack("f", value))[0]


CONSTANTS = _constants()
MADE_BY = "Only functions that return one make a valid one: with other fields an addition may overflow."
NEGATIVE_ONE = ("-1", "-1.0")
MOST_ARGUMENTS = 7  # before clippy complains
ROTATED = re.compile(r"(\S.*) (<<|>>) (\d+)")  # half of a rotation
LIMITED = re.compile(r"(.*)\.(min|max)\((-?\d+)\)")


def is_number(piece: Piece) -> bool:
    return re.fullmatch(r"-?\d[\w.]*", piece.text) is not None


def typed(piece: Piece, type_: str) -> str:
    """The receiver of a method: a literal has no type of its own."""
    if not is_number(piece):
        return piece.within(UNARY)
    number = f"{piece.text}_{Rust.types[type_]}"
    return f"({number})" if number.startswith("-") else number


def rotated(left: Piece, right: Piece) -> Piece | None:
    """h << 13 | h >> 19, as the method that does it."""
    halves = [ROTATED.fullmatch(piece.text) for piece in (left, right) if piece.sign in ("<<", ">>")]
    if len(halves) != 2 or not all(halves):
        return None
    one, other = sorted(halves, key=lambda half: half[2])
    if (one[2], other[2]) != ("<<", ">>") or one[1] != other[1] or int(one[3]) + int(other[3]) != 32:
        return None
    return Piece(f"{one[1]}.rotate_left({one[3]})")


class Rust(Syntax):
    word = "u32"
    example_struct = "&mut {}"
    passed = "#[allow(dead_code)] pub const {}: i32 = {};"
    condition, forever = "{}", "loop {"
    struct_form, field_form = "pub struct {name} {{\n{fields}}}\n", "    pub {name}: {type},\n"
    cased = staticmethod(str)
    index, vector_of, struct_of = "[{number}]", "[{parts}]", "{type} {{ {parts} }}"
    word_end = ""
    counts_a_range = True
    branches_are_values = True
    joins = False
    component = re.compile(r"(?:mut )?(\w+)_([wxyz])(\d*)")
    components = "let ({}) = ({});"
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

    def __init__(self, precise: bool = False):
        super().__init__(precise)
        self.whole: set[str] = set()  # structs without floats
        self.chains = False           # whether the function that is written compares the same twice
        self.decides = False          # whether a variable ends a loop, for which its first value does not count

    def field_name(self, name: str) -> str:
        return self.variable(name)

    def vector(self, type_: str) -> str:
        return f"[{self.type(scalar_of(type_))}; {SIZES[type_]}]"

    # Expressions.

    def float(self, text: str) -> str:
        """With no digits that an f32 does not keep, and a constant of core by its name: the same bits."""
        value = single(float(text))
        if abs(value) in CONSTANTS:
            return f"{'-' * (value < 0)}{CONSTANTS[abs(value)]}"
        if value.is_integer():
            return text
        short = next(shown for digits in range(1, 10) if single(float(shown := f"{value:.{digits}g}")) == value)
        return min(text, format(Decimal(short), "f"), key=lambda shown: len(shown.lstrip("-0.")))

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if type_ == "uint" and sign in WRAPPING:
            if is_number(left) and sign != "-":
                left, right = right, left
            return Piece(f"{typed(left, type_)}.wrapping_{WRAPPING[sign]}({right.text})")
        if sign == "*" and right.text in NEGATIVE_ONE:
            return self.unary("-", type_, left)
        if (type_, sign) == ("uint", "|") and (rotation := rotated(left, right)):
            return rotation
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
        self.chains |= f"{other} ".startswith(f"if {condition.text.replace('<', '>')} ")
        return Piece(f"if {condition.text} {{ {yes.text} }} else {other}", CHOICE, "if")

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        return Piece(f"{piece.within(CAST - 0.25)} as {self.type(to)}", CAST, "as")

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        if name in ("uintBitsToFloat", "intBitsToFloat"):
            return self.call("f32::from_bits", arguments)
        if name == "floatBitsToUint":
            return Piece(f"{typed(arguments[0], 'float')}.to_bits()")
        if name in ("min", "max") and type_ != "float":
            first, second = sorted(arguments, key=is_number)
            inner = LIMITED.fullmatch(first.text) if first.binds == PRIMARY and is_number(second) else None
            if inner and inner[2] != name:  # from a number to a larger one
                low, high = sorted((int(inner[3]), int(second.text)))
                if (low, high) == ((int(inner[3]), int(second.text)) if name == "min" else
                                   (int(second.text), int(inner[3]))):
                    return Piece(f"{inner[1]}.clamp({low}, {high})")
            return Piece(f"{typed(first, type_)}.{name}({second.text})")
        return self.call(self.helper(name), arguments)

    def make_struct(self, type_: str, fields: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        written = [name if name == piece.text else f"{name}: {piece.text}"
                   for (name, _), piece in zip(((self.field_name(field.name), field.type) for field in fields), parts)]
        return Piece(f"{self.type_name(type_)} {{ {', '.join(written)} }}")

    # Statements.

    def declare(self, type_: str, name: str, value: str | None, changes: bool) -> str:
        if value is None:
            return f"let {name}: {self.type(type_)};"
        return Declaration("let", f"{'mut ' if changes else ''}{name}", f" = {value};")

    def declare_all(self, names: Sequence[str]) -> str:
        return f"let {names[0] if len(names) == 1 else '(' + ', '.join(names) + ')'} = "

    def change(self, type_: str, name: str, sign: str, by: str) -> str | None:
        return None if type_ == "uint" and sign in WRAPPING else f"{name} {sign}= {by}"

    def returned(self, results: Sequence[Part], pieces: Sequence[Piece]) -> list[str]:
        return [line.removeprefix("return ").removesuffix(";") for line in super().returned(results, pieces)]

    def do(self, body: list[str], condition: Piece, negated: str) -> list[str]:
        self.decides |= condition.text.isidentifier()
        return ["loop {", *body, f"    if {negated} {{", "        break;", "    }", "}"]

    def loop(self, type_: str, name: str, start: str, condition: Piece, step: str, is_read: bool) -> str:
        return f"for {name if is_read else '_'} in {start}..{condition.text.removeprefix(f'{name} < ')} {{"

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = ", ".join(f"{'mut ' if one.changes else '' if one.is_read else '_'}{one.name}: "
                          f"{'&mut ' if one.is_set else ''}{self.type(one.type)}" for one in parameters)
        types = [self.type(one.type) for one in results]
        given = f" -> {types[0]}" if len(types) == 1 else f" -> ({', '.join(types)})" if types else ""
        allowed = "#[allow(clippy::too_many_arguments)]\n" * (len(parameters) > MOST_ARGUMENTS)
        allowed += "#[allow(clippy::comparison_chain)]\n" * self.chains  # which would be longer as a `match`
        allowed += "#[allow(unused_assignments)]\n" * self.decides
        self.chains = self.decides = False
        return f"{allowed}{'pub ' if is_public else ''}fn {name}({taken}){given} {{"

    def struct_comment(self, name: str) -> str:
        made = f"///\n/// {MADE_BY}\n" if OF_AXES.fullmatch(name) else ""
        return f"{super().struct_comment(name)}{made}"

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        if all(field.type in ("int", "uint", "bool", *self.whole) for field in fields):
            self.whole.add(name)
        equal = "PartialEq, Eq" if name in self.whole else "PartialEq"
        return f"#[derive(Clone, Copy, Debug, Default, {equal})]\n{super().struct(name, fields)}"
