"""Java 17 and later, where each float is rounded as in IEEE 754: a class of static methods."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping, Sequence

from translate.pick.printer import STRENGTH, UNARY
from translate.pick.scalars import Facts, Part, Piece, Syntax, Taken, block_comment, indented, pascal, record_of
from translate.pick.values import AXES, SIZES, scalar_of

UNSIGNED = {"/": "divideUnsigned", "%": "remainderUnsigned"}
RECORD = re.compile(r"public record (\w+)\(")


class Java(Syntax):
    word = "int"
    name = "HashNoise"  # of the class
    example_of = "{}."
    passed = "public static final int {} = {};"
    types = {"float": "float", "int": "int", "uint": "int", "bool": "boolean"}
    reserved = frozenset("""abstract assert boolean break byte case catch char class const continue default do
        double else enum extends final finally float for goto if implements import instanceof
        int interface long native new package private protected public return short static
        strictfp super switch synchronized this throw throws transient try void volatile while
        true false null var record yield""".split())
    index, vector_of, struct_of = ".{axis}()", "new {type}({parts})", "new {type}({parts})"
    word_end = ""
    names_components = True
    builtins = {"uintBitsToFloat": "Float.intBitsToFloat", "floatBitsToUint": "Float.floatToRawIntBits", "abs": "Math.abs",
                **{f"{name} {type_}": called for name in ("min", "max")
                   for type_, called in (("int", f"Math.{name}"), ("uint", f"{name}Word"))}}
    own_helpers = {
        "floor": "private static float floor(float x) { return (float) Math.floor(x); }\n",
        "trunc": "private static float trunc(float x) { return (float) (x < 0f ? Math.ceil(x) : Math.floor(x)); }\n",
        "sqrt": "private static float sqrt(float x) { return (float) Math.sqrt(x); }\n",
        "min": "private static float min(float a, float b) { return b < a ? b : a; }\n",
        "max": "private static float max(float a, float b) { return a < b ? b : a; }\n",
        "minWord": "private static int minWord(int a, int b) { return Integer.compareUnsigned(b, a) < 0 ? b : a; }\n",
        "maxWord": "private static int maxWord(int a, int b) { return Integer.compareUnsigned(a, b) < 0 ? b : a; }\n",
        "toWord": """\
private static int toWord(float x) {
    return (int) Math.min(Math.max((long) x, 0L), 0xFFFFFFFFL);
}
"""}

    def __init__(self, precise: bool = False):
        super().__init__(precise)
        self.records: dict[str, str] = {}  # that the functions need

    @property
    def helpers(self) -> Mapping[str, str]:
        return self.records | self.own_helpers

    def _record(self, name: str, types: Sequence[str], parts: Sequence[str]) -> str:
        inside = ", ".join(f"{type_} {self.variable(part)}" for type_, part in zip(types, parts))
        self.records.setdefault(name, f"public record {name}({inside}) {{}}\n")
        return self.helper(name)

    def vector(self, type_: str) -> str:
        scalar, size = scalar_of(type_), SIZES[type_]
        return self._record(f"{'Float' if scalar == 'float' else 'Int'}{size}", [self.type(scalar)] * size, AXES)

    def returned_type(self, result: Part) -> str:
        """Users get a record with the names of the components, also where these are no axes."""
        axes = self.axes(result)
        if not self.is_public_now or axes[0] in AXES or SIZES.get(result.type, 1) < 2:
            return self.type(result.type)
        return self._record(record_of(axes), ["float"] * len(axes), axes)

    # Expressions.

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if type_ == "uint" and sign in UNSIGNED:
            return self.call(f"Integer.{UNSIGNED[sign]}", [left, right])
        if type_ == "uint" and sign[0] in "<>" and sign not in ("<<", ">>"):
            return self.infix(sign, self.call("Integer.compareUnsigned", [left, right]), Piece("0"))
        made = super().binary(sign, type_, left, right)
        if type_ == "uint" and sign == ">>":
            return made._replace(text=f"{self._operand(left)} >>> {self._operand(right)}")
        return made

    def _operand(self, piece: Piece) -> str:
        return piece.within(STRENGTH[">>"]) if piece.sign == "" else f"({piece.text})"

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if {to, of} == {"int", "uint"}:
            return piece
        if to == "uint":
            return self.call(self.helper("toWord"), [piece])
        if of == "uint" and piece.sign != ">>":  # a shifted number is not negative
            piece = self.infix("&", piece, Piece("0xFFFFFFFFL"))
        return Piece(f"({to}) {piece.within(UNARY - 1)}", UNARY)

    def make_results(self, results: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        return self.call(f"new {self._results(self.function_now, results)}", parts)

    # Functions.

    def returned(self, results: Sequence[Part], pieces: Sequence[Piece]) -> list[str]:
        return super().returned(results, [self._named(*one) for one in zip(results, pieces)])

    def _named(self, result: Part, piece: Piece) -> Piece:
        """A vector as the record that users get."""
        record, vector = self.returned_type(result), self.type(result.type)
        if record == vector:
            return piece
        if piece.text.startswith(begin := f"new {vector}("):
            return Piece(f"new {record}({piece.text[len(begin):]}")
        parts = ", ".join(f"v.{axis}()" for axis in AXES[:SIZES[result.type]])
        self.records[record] = self.records[record].replace("{}", f"{{ {record}({vector} v) {{ this({parts}); }} }}")
        return self.call(f"new {record}", [piece])

    def _results(self, name: str, results: Sequence[Part]) -> str:
        if len(results) > 1:
            types = [self.returned_type(part) for part in results]
            return self._record(f"{pascal(name)}Result", types, [part.name for part in results])
        return self.returned_type(results[0]) if results else "void"

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = ", ".join(f"{self.type(one.type)} {one.name}" for one in parameters)
        return f"{'public' if is_public else 'private'} static {self._results(name, results)} {name}({taken}) {{"

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        typed = [f"{self.type(field.type)} {self.field_name(field.name)}" for field in fields]
        names = [self.field_name(field.name) for field in fields]
        parts = [*(f"public {one};\n" for one in typed),
                 f"\npublic {self.type_name(name)}({', '.join(typed)}) {{\n",
                 *(f"    this.{one} = {one};\n" for one in names), "}\n"]
        return f"public static final class {self.type_name(name)} {{\n{textwrap.indent(''.join(parts), ' ' * 4)}}}\n"

    def documented(self, name: str, facts: Facts) -> list[str]:
        """A returned word may be negative, so h % n would be, too."""
        word = "any int: its 32 bits, so Integer.remainderUnsigned(h, n) is a number from 0 to n - 1"
        return block_comment(facts._replace(returns=re.sub("^any int\\b", word, facts.returns)), "@return", "<p>")

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        """Records that users do not get are private, and those that nothing uses are left out: vectors that became the
        records of results."""
        records = {found[1]: part for part in parts if (found := RECORD.match(part))}
        others = "".join(part for part in parts if not RECORD.match(part))
        heads = " ".join(re.findall(r"(?s)(?:^|\n)public static [^{;]*\(.*?\{", others))
        for name, part in reversed(records.items()):  # a record has those before it
            heads += part.partition(")")[0] if re.search(rf"\b{name}\b", heads) else ""
        written = []
        for part in parts:
            found = RECORD.match(part)
            is_public = not found or re.search(rf"\b{found[1]}\b", heads)
            if is_public or any(re.search(rf"\b{found[1]}\b", other) for other in parts if other is not part):
                written.append(part if is_public else part.replace("public", "private", 1))
        about = "/** Procedural noise. */\n"
        return super().file(heading, names, [f"{about}public final class {self.name} {{\n{indented(written)}}}\n"])
