"""JavaScript and TypeScript: modules whose numbers are floats and words where the library's are.

A word is any number that is the same modulo 2^32; where its size counts, `>>> 0` makes it one from 0 on. Each float is
rounded where it is computed.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Sequence

from translate.pick.printer import STRENGTH, Declaration
from translate.pick.scalars import Facts, Part, Piece, Syntax, Taken, block_comment
from translate.pick.values import SIZES

LOOSE = "| 0"  # the operator of a sum that is made a word
COMPARED = ("<", ">", "<=", ">=", "==", "!=")
BITS_OF_FLOATS = """\
const numbers = new Float32Array(1), words = new Int32Array(numbers.buffer);
"""


def inside(piece: Piece) -> Piece:
    """A sum before it is made a word, for code that does so itself."""
    return Piece(piece.text[1:-len(f") {LOOSE}")], STRENGTH["+"], "+") if piece.sign == LOOSE else piece


def counted(piece: Piece) -> Piece:
    """A word from 0 on."""
    if re.fullmatch(r"\w+", piece.text) and piece.text[0].isdigit():
        return piece
    return Piece(f"{inside(piece).within(STRENGTH['+'])} >>> 0", STRENGTH[">>"], ">>")


class JavaScript(Syntax):
    word = "whole number from 0 to 2^32 - 1"
    indent = 2
    index, vector_of, word_end = "[{number}]", "[{parts}]", ""
    passed = "export const {} = {};"
    types = {"float": "number", "int": "number", "uint": "number", "bool": "boolean"}
    reserved = frozenset("""arguments await break case catch class const continue debugger default delete do else
        enum eval export extends false finally for function if implements import in instanceof
        interface let new null package private protected public return static super switch this
        throw true try typeof var void while with yield fround imul numbers words NaN Infinity
        undefined""".split())
    is_typed = False
    struct_form, field_form = " * @typedef {{object}} {name}\n{fields} */\n", " * @property {{{type}}} {name}\n"
    needs = {"asFloat": ("numbers",), "asUint": ("numbers",)}

    @property
    def helpers(self) -> dict[str, str]:
        one, two, word = self._head("x"), self._head("a", "b"), self._head("word")
        of_one, of_two, of_word = (self._typed_head(names, ["number"] * len(names), "number")
                                   for names in (("x",), ("a", "b"), ("word",)))
        return {
            "fround": "const fround = Math.fround;\n",
            "imul": "const imul = Math.imul;\n",
            "numbers": BITS_OF_FLOATS,
            **{f"Vector{size}": (f"export type Vector{size} = {of};\n" if self.is_typed else
                                 f"/** @typedef {{{of}}} Vector{size} */\n")
               for size in (2, 3, 4) for of in [f"[{', '.join(['number'] * size)}]"]},
            "min": f"{of_two}function min{two} {{ return b < a ? b : a; }}\n",
            "max": f"{of_two}function max{two} {{ return a < b ? b : a; }}\n",
            "toInt": f"// The nearest int.\n{of_one}function toInt{one} {{\n"
                     "  return x >= 2147483648 ? 2147483647 : x > -2147483648 ? x | 0 : x < 0 ? -2147483648 : 0;\n}\n",
            "toUint": f"{of_one}function toUint{one} "
                      "{ return x >= 4294967296 ? 4294967295 : x > 0 ? x >>> 0 : 0; }\n",
            "asFloat": f"{of_word}function asFloat{word} {{\n  words[0] = word;\n  return numbers[0];\n}}\n",
            "asUint": f"{of_one}function asUint{one} {{\n  numbers[0] = x;\n  return words[0];\n}}\n"}

    def __init__(self, precise: bool = False):
        super().__init__(precise)
        self.types_now: dict[str, str] = {}  # of the parameters of the last function, and by "" of its result

    def _head(self, *names: str) -> str:
        of = self._of("number")
        return f"({', '.join(f'{name}{of}' for name in names)}){of}"

    def _typed_head(self, names: Sequence[str], types: Sequence[str], given: str) -> str:
        """Above a function that users do not call: the types, for compilers that check JavaScript."""
        parameters = "".join(f"@param {{{type_}}} {name} " for name, type_ in zip(names, types))
        return "" if self.is_typed else f"/** {parameters}@returns {{{given}}} */\n"

    def _of(self, type_: str) -> str:
        return f": {type_}" if self.is_typed else ""

    def vector(self, type_: str) -> str:
        return self.helper(f"Vector{SIZES[type_]}")

    # Expressions.

    def float(self, text: str) -> str:
        value = float(text)
        is_float = struct.unpack("f", struct.pack("f", value))[0] == value
        return text.removesuffix(".0") if is_float else self.call(self.helper("fround"), [Piece(text)]).text

    def rounded(self, piece: Piece) -> Piece:
        return self.call(self.helper("fround"), [piece])

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if type_ == "uint":
            return self._word(sign, left, right)
        if type_ == "int" and sign == "*":
            return self.call(self.helper("imul"), [left, right])
        if type_ == "int" and sign in "/%":
            return Piece(f"({self.infix(sign, left, right).text}) | 0", STRENGTH["|"], "|")
        return super().binary(sign, type_, left, right)

    def infix(self, sign: str, left: Piece, right: Piece) -> Piece:
        made = super().infix(sign, left, right)
        return made._replace(text=made.text.replace(f" {sign} ", f" {sign}= ")) if sign in ("==", "!=") else made

    def _word(self, sign: str, left: Piece, right: Piece) -> Piece:
        if sign in COMPARED and not (sign in ("==", "!=") and right.text == "0"):
            return self.infix(sign, counted(left), counted(right))
        left, right = inside(left), inside(right)
        if sign in ("+", "-"):
            return Piece(f"({self.infix(sign, left, right).text}) {LOOSE}", STRENGTH["|"], LOOSE)
        if sign == "*":
            return self.call(self.helper("imul"), [left, right])
        if sign in ("/", "%"):
            return counted(self.infix(sign, counted(left), counted(right)))
        made = self.infix(sign, left, right)
        return made._replace(text=made.text.replace(" >> ", " >>> ")) if sign == ">>" else made

    def unary(self, sign: str, type_: str, operand: Piece) -> Piece:
        if sign == "-" and type_ in ("int", "uint"):  # there is no -0
            return self.binary("-", type_, Piece("0"), operand)
        return super().unary(sign, type_, operand)

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if of == "float":
            return self.call(self.helper("toInt" if to == "int" else "toUint"), [piece])
        if to == "float":
            return self.rounded(counted(piece) if of == "uint" else piece)
        if to == "uint" or piece.sign == LOOSE:
            return piece
        return Piece(f"{inside(piece).within(STRENGTH['+'])} | 0", STRENGTH["|"], "|")

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        if name in ("min", "max") and type_ != "float":
            return self.call(f"Math.{name}", [counted(one) for one in arguments] if type_ == "uint" else arguments)
        if name == "sqrt":
            return self.rounded(self.call("Math.sqrt", arguments))
        if name in ("floor", "trunc", "abs"):
            return self.call(f"Math.{name}", arguments)
        as_bits = {"uintBitsToFloat": "asFloat", "floatBitsToUint": "asUint"}
        return self.call(self.helper(as_bits.get(name, name)), [inside(one) for one in arguments])

    def make_struct(self, type_: str, fields: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        return self._object([self.field_name(field.name) for field in fields],
                            [counted(piece) if field.type == "uint" else piece for field, piece in zip(fields, parts)])

    def make_results(self, results: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        return self._object([self.variable(part.name) for part in results], parts)

    def _object(self, names: Sequence[str], parts: Sequence[Piece]) -> Piece:
        written = (name if name == piece.text else f"{name}: {piece.text}" for name, piece in zip(names, parts))
        return Piece(f"{{ {', '.join(written)} }}")

    # Statements.

    def declare(self, type_: str, name: str, value: str | None, changes: bool) -> str:
        of = self.type(type_)
        if value is None:
            made = Declaration("let", name, f"{self._of(of)};")
            return made if SIZES.get(type_) == 1 or not self.is_typed else str(made)
        before = "let" if changes else "const"
        if "vec" not in type_ or not value.startswith("["):
            return Declaration(before, name, f" = {value};")
        return f"{before} {name}{self._of(of)} = {value};" if self.is_typed else f"{before} /** @type {{{of}}} */ {name} = {value};"

    def change(self, type_: str, name: str, sign: str, by: str) -> str | None:
        if type_ == "float" or sign in "*/%" or type_ == "uint" and sign in ("+", "-", ">>"):
            return None
        return super().change(type_, name, sign, by)

    def returned(self, results: Sequence[Part], pieces: Sequence[Piece]) -> list[str]:
        return super().returned(results, [counted(piece) if part.type == "uint" else piece
                                          for part, piece in zip(results, pieces)])

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        of = [self.type(one.type) for one in parameters]
        written = [f"{'' if one.is_read else '_'}{one.name}" for one in parameters]
        taken = ", ".join(f"{one}{self._of(type_)}" for one, type_ in zip(written, of))
        types = "; ".join(f"{self.variable(part.name)}: {self.type(part.type)}" for part in results)
        given = self.type(results[0].type) if len(results) == 1 else f"{{ {types} }}" if results else "void"
        self.types_now = {} if self.is_typed else {
            **{one.name: f"{{{type_}}} " for one, type_ in zip(parameters, of)}, "": f"{{{given}}} "}
        typed = "" if is_public else self._typed_head(written, of, given)
        return f"{typed}{'export ' if is_public else ''}function {name}({taken}){self._of(given)} {{"

    def beginning(self, parameters: Sequence[Taken], is_public: bool) -> list[str]:
        """Users' numbers need not be floats."""
        if not is_public:
            return []
        return [f"{one.name} = {self.helper('fround')}({one.name});" for one in parameters
                if one.type == "float" and one.is_read]

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        about = "" if self.is_typed else super().struct_comment(name).removesuffix(" */\n") or "/**\n"
        return about + super().struct(name, fields)

    def documented(self, name: str, facts: Facts) -> list[str]:
        return block_comment(facts, "@returns", types=self.types_now)

    def struct_comment(self, name: str) -> str:
        """In JavaScript the definition is a comment itself."""
        self.types_now = {}
        return super().struct_comment(name) if self.is_typed else ""

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        begins = ("const ", "export type ", "/** @typedef {[")
        first = [part for part in parts if part.startswith(begins)]
        return super().file(heading, names, [*first, *(part for part in parts if not part.startswith(begins))])


class TypeScript(JavaScript):
    is_typed = True
    struct_form, field_form = "export interface {name} {{\n{fields}}}\n", "  {name}: {type};\n"
