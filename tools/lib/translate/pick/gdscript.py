"""GDScript, for Godot 4: static functions, whose integers have 64 bits and whose floats are doubles.

A word is any number that is the same modulo 2^32; where its size counts, and where it gets a name, a mask makes it one
from 0 on. An integer with a sign does not leave 32 bits, so it needs none. A call takes as long as ten operations, so
what the language lacks stands in its place as far as it is short.
"""

from __future__ import annotations

import functools
import struct
from collections.abc import Sequence

from translate.names import wgsl_name
from translate.parsing.lines import without_braces
from translate.pick.printer import STRENGTH_OF_PYTHON
from translate.pick.program import Evaluated, Program
from translate.pick.scalars import NEGATED, Facts, Hoisting, Part, Piece, Syntax, Taken, bare, pascal
from translate.pick.spans import EXACT, INT, LONG, UINT, Spans, fits, is_within
from translate.pick.statements import Return, Statement, values_of
from translate.pick.values import PREFIXES, SIZES, WORD, Constant, Node, Operation, Variable, operation, scalar_of

MASK = Piece("0xFFFFFFFF")
SIGN = Piece("0x80000000")
DIVIDED = " // "  # an operator between integers, until the line is written
SIZED = ("<", ">", "<=", ">=", "==", "!=", "/", "%", ">>")  # operators for which the size of a word counts


class Body(Hoisting):
    """Writes the body of a function."""
    language: GDScript

    def lines(self) -> list[str]:
        self._spans = Spans(lambda node: node in self.called)
        # HN_FIXED rounds no float, but in sums with a whole number that may be too large: in hn_position.
        sums = [one for one in values_of(self.block) if isinstance(one, Operation) and one.type == "float" and (
            one.name in ("+", "-"))]
        self._inexact = {node for one in sums for wide in filter(self._is_wide, one.arguments) for node in (one, wide)}
        return super().lines()

    def _is_wide(self, node: Node) -> bool:
        return isinstance(node, Operation) and node.kind == "construct" and node.type == "float" and not is_within(
            self._spans.of(node.arguments[0]), EXACT)

    def _held(self, node: Node) -> Piece:
        """The value in 32 bits."""
        piece = self._piece(node)
        return piece if node.type != "uint" or is_within(self._spans.of(node), UINT) else self.language.masked(piece)

    def _text(self, node: Node) -> str:
        return self._held(node).text

    def _returned(self, value: Node) -> list[str]:
        is_whole = isinstance(value, Operation) and value.kind == "results"
        return self.language.returned(self.results, [*map(self._held, value.arguments if is_whole else (value,))])

    def _negated(self, condition: Node) -> str:
        if isinstance(condition, Operation) and condition.kind == "binary" and condition not in self.called and (
                condition.name in NEGATED and condition.arguments[0].type != "float"):
            return self._text(operation("binary", NEGATED[condition.name], "bool", condition.arguments))
        return super()._negated(condition)

    def _piece(self, node: Node) -> Piece:
        if not isinstance(node, Operation) or node in self.called:
            return super()._piece(node)
        made = self._made(node)
        return self.language.single(made) if self.language.is_fixed and node in self._inexact else made

    def _made(self, node: Operation) -> Piece:
        if node.kind == "binary" and node.arguments[0].type in ("int", "uint"):
            return self._of_integers(node)
        if node.kind == "construct" and len(node.arguments) == 1 and node.type in (*PREFIXES, "bool"):
            return self._converted(node)
        return self._called(node) if node.kind in ("call", "struct", "builtin", "construct") else super()._piece(node)

    def _of_integers(self, node: Operation) -> Piece:
        left, right = node.arguments
        sign, binary = node.name, functools.partial(self.language.binary, node.name, left.type)
        if sign == "&" and (mask := next((one for one in node.arguments if isinstance(one, Constant)), None)) and mask.value >= 0:
            return binary(*(self._last_bits(one, int(mask.value)) for one in node.arguments))
        if sign == "<<" and node.type == "int":
            low, high = (end * (1 << int(right.value)) for end in self._spans.of(left))
            made = self._shifted(node)
            return made if is_within((low, high), INT) else self.language.signed(made)
        if sign in SIZED or sign == "<<" and self._spans.of(left)[0] < 0:
            return binary(self._held(left), self._held(right))
        return binary(self._piece(left), self._piece(right))

    def _shifted(self, node: Operation) -> Piece:
        """An integer with a sign to the left: by a product, since Godot refuses some shifts of negative numbers."""
        left, right = node.arguments
        return self.language.binary("*", "int", self._piece(left), Piece(str(1 << int(right.value))))

    def _last_bits(self, node: Node, mask: int) -> Piece:
        """A number for who reads the bits of a mask alone: others may be any."""
        if isinstance(node, Operation) and node not in self.called:
            if node.kind == "construct" and node.type == "int" and node.arguments[0].type == "uint":
                return self._piece(node.arguments[0])
            if node.name == "<<" and node.type == "int":
                return self._shifted(node)
            if node.name == ">>" and node.type == "uint" and isinstance(by := node.arguments[1], Constant) and (
                    mask < 1 << 32 - int(by.value)):
                return self.language.binary(">>", "uint", self._piece(node.arguments[0]), self._piece(by))
        return self._piece(node)

    def _converted(self, node: Operation) -> Piece:
        of = node.arguments[0]
        span, to = self._spans.of(of), node.type
        if {to, of.type} == {"int", "uint"}:
            piece = self._piece(of)
            return piece if to == "uint" or is_within(span, INT) else self.language.signed(piece, is_within(span, UINT))
        if to == "float":
            made = self.language.call("float", [self._held(of)])
            return self.language.rounded(made) if self._is_wide(node) else made
        if of.type == "float" and not self.language.is_fixed and not fits(span, to):
            return self.language.call(self.language.helper(f"_to_{to}"), [self._piece(of)])
        if isinstance(of, Operation) and of.name == "trunc" and of not in self.called:
            of = of.arguments[0]
        return self.language.call("bool" if to == "bool" else "int", [self._piece(of)])

    def _called(self, node: Operation) -> Piece:
        if node.kind == "construct":  # a vector cuts its integers off to 32 bits with a sign
            return self.language.make_vector(node.type, [self._last_bits(one, WORD) for one in node.arguments])
        if node.name == "trunc" and self.language.is_fixed and is_within(self._spans.of(node.arguments[0]), LONG):
            return Piece(f"float(int({self._text(node.arguments[0])}))")
        pieces = [*map(self._held, node.arguments)]
        if node.kind == "struct":
            return self.language.make_struct(node.type, self.structs[node.type], pieces)
        if node.kind == "builtin":
            return self.language.builtin(node.name, node.type, pieces)
        return self.language.call(self.names.get(node.name, node.name), pieces)


class GDScript(Syntax):
    word = "int from 0 to 2^32 - 1"
    name = ""  # of the class
    library = {"__VERSION__": "130"}  # without bits of floats, which would take calls
    strength = STRENGTH_OF_PYTHON
    cased = staticmethod(str)
    indent = 4
    end = float_end = word_end = ""
    condition, forever = "{}", "while true {"
    counts_a_range, joins = True, False
    least_int = "-2147483648"
    vector_of, struct_of = "{type}({parts})", "{type}.new({parts})"
    passed = "const {} := {}"
    types = {"float": "float", "int": "int", "uint": "int", "bool": "bool"}
    writer = Body
    reserved = frozenset("""and as assert await break breakpoint case catch class class_name const continue default do elif
        else enum extends false finally for func if in is master match namespace not null or pass preload private protected
        public puppet remote return self set get setget signal static super switch throw trait true try tool typeof unless
        until var void when while with yield PI TAU INF NAN
        abs absf absi acos acosh angle_difference asin asinh atan atan2 atanh bezier_derivative bezier_interpolate
        bytes_to_var ceil ceilf ceili char clamp clampf clampi convert cos cosh cubic_interpolate db_to_linear deg_to_rad
        ease error_string exp floor floorf floori fmod fposmod get_stack hash inst_to_dict instance_from_id inverse_lerp
        is_equal_approx is_finite is_inf is_instance_of is_nan is_same is_zero_approx len lerp lerp_angle lerpf
        linear_to_db load log max maxf maxi min minf mini move_toward nearest_po2 pingpong posmod pow print rad_to_deg
        rand_from_seed randf randf_range randfn randi randi_range randomize range remap rid_allocate_id rotate_toward
        round roundf roundi seed sign signf signi sin sinh smoothstep snapped snappedf snappedi sqrt step_decimals str
        str_to_var tan tanh type_convert type_exists type_string var_to_bytes var_to_str weakref wrap wrapf wrapi
        free new script notification int float bool String Color Vector2 Vector3 Vector4 Vector2i Vector3i Vector4i
        _init _get _set""".split())
    builtins = {"floor": "floorf", "abs float": "absf", "abs int": "absi", "sqrt": "sqrt", "trunc": "_trunc"}
    helpers = {
        "_trunc": "static func _trunc(x: float) -> float:\n    return ceilf(x) if x < 0.0 else floorf(x)\n",
        "_to_int": """\
## The nearest int of 32 bits.
static func _to_int(x: float) -> int:
    if x >= -2147483648.0 and x < 2147483648.0:
        return int(x)
    return 2147483647 if x > 0.0 else -2147483648 if x < 0.0 else 0
""",
        "_to_uint": """\
static func _to_uint(x: float) -> int:
    return 4294967295 if x >= 4294967296.0 else int(x) if x > 0.0 else 0
""",
        "_float_of_bits": """\
static func _float_of_bits(word: int) -> float:
    return PackedInt32Array([word]).to_byte_array().decode_float(0)
""",
        "_bits_of_float": """\
static func _bits_of_float(x: float) -> int:
    return PackedFloat32Array([x]).to_byte_array().decode_u32(0)
"""}

    def __init__(self, precise: bool = False):
        super().__init__(precise)
        self.results: dict[str, str] = {}  # classes of several results

    @property
    def example_of(self) -> str:
        return "{}." if self.name else ""

    def begin(self, program: Program) -> None:
        """No variable has the name of a function that users call."""
        names = (self.function_name(wgsl_name(root.function), is_public=True) for root in program.roots)
        self.reserved = GDScript.reserved | {*names}

    # Names.

    def field_name(self, name: str) -> str:
        return self.variable(name)

    def function_name(self, name: str, is_public: bool) -> str:
        return bare(name) if is_public else f"_{bare(name)}"

    def variable(self, name: str) -> str:
        return "noise_seed" if name == "seed" else super().variable(name)

    def block(self, evaluated: Evaluated) -> list[Statement]:
        """The high word of a product is in one of 64 bits, also where that wraps around."""
        if evaluated.function.name != "hn_i_multiply_high":
            return evaluated.block
        factors = (Variable("uint", one.at.text, is_parameter=True) for one in evaluated.parameters)
        return [Return(operation("builtin", "multiply_high", "uint", tuple(factors)))]

    def vector(self, type_: str) -> str:
        return f"Vector{SIZES[type_]}{'' if scalar_of(type_) == 'float' else 'i'}"

    # Expressions.

    def masked(self, piece: Piece) -> Piece:
        """The word from 0 on. (Tests leave it out.)"""
        return self.binary("&", "mask", piece, MASK)

    def signed(self, piece: Piece, is_word: bool = False) -> Piece:
        """The integer with a sign that has the last 32 bits of a number."""
        turned = self.infix("^", piece if is_word else self.masked(piece), SIGN)
        return self.infix("-", turned, SIGN)

    def rounded(self, piece: Piece) -> Piece:
        return piece if self.is_fixed else self.single(piece)

    def single(self, piece: Piece) -> Piece:
        """A component of a color is a float of 32 bits in each Godot; a vector's has 64 in some."""
        return Piece(f"Color({piece.text}, 0.0, 0.0).r")

    def float(self, text: str) -> str:
        value, = struct.unpack("f", struct.pack("f", float(text)))
        return text if value == float(text) else repr(value)

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        made = super().binary(sign, type_, left, right)
        return made._replace(text=made.text.replace(" / ", DIVIDED)) if sign == "/" and type_ != "float" else made

    def infix(self, sign: str, left: Piece, right: Piece) -> Piece:
        made = super().infix(sign, left, right)
        worded = {"&&": "and", "||": "or"}.get(sign)
        return made._replace(text=made.text.replace(f" {sign} ", f" {worded} ")) if worded else made

    def unary(self, sign: str, type_: str, operand: Piece) -> Piece:
        if sign == "!":
            return Piece(f"not {operand.within(self.strength['<'])}", self.strength["<"] - 0.5)
        return super().unary(sign, type_, operand)

    def choice(self, condition: Piece, yes: Piece, no: Piece, type_: str) -> Piece:
        return Piece(f"{yes.within(0)} if {condition.within(0)} else {no.within(0)}", 0)

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        raise NotImplementedError  # Body does

    def builtin(self, name: str, type_: str, arguments: Sequence[Piece]) -> Piece:
        if name in ("min", "max") and type_ == "float":  # of no number, too, as the library has it
            return self.call(f"{name}f", arguments[::-1])
        if name in ("min", "max"):
            return self.call(f"{name}i", arguments)
        if name == "multiply_high":
            return self.masked(self.infix(">>", self.infix("*", *arguments), Piece("32")))
        if name in ("uintBitsToFloat", "floatBitsToUint"):
            return self.call(self.helper("_float_of_bits" if type_ == "float" else "_bits_of_float"), arguments)
        made = super().builtin(name, type_, arguments)
        return self.rounded(made) if name == "sqrt" else made

    def make_results(self, results: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        return self.call(f"{self._results(results)}.new", parts)

    def _results(self, results: Sequence[Part]) -> str:
        name = f"{pascal(self.function_now)}Result"
        self.results[name] = self.struct(name, [part._replace(name=self.variable(part.name)) for part in results])
        return name

    # Statements.

    def declare(self, type_: str, name: str, value: str | None, changes: bool) -> str:
        return f"var {name}: {self.type(type_)}" if value is None else f"var {name} := {value}"

    def change(self, type_: str, name: str, sign: str, by: str) -> str | None:
        if type_ == "uint" and sign not in "&|^" and sign != ">>" or type_ == "float" and not self.is_fixed or sign == "<<":
            return None
        return f"{name} {sign}= {by}"

    def do(self, body: list[str], condition: Piece, negated: str) -> list[str]:
        return ["while true {", *body, f"    if {negated} {{", "        break", "    }", "}"]

    def loop(self, type_: str, name: str, start: str, condition: Piece, step: str, is_read: bool) -> str:
        limit = condition.text.split(" < ", 1)[1]
        return f"for {'' if is_read else '_'}{name} in range({limit if start == '0' else f'{start}, {limit}'}) {{"

    def joined(self, lines: Sequence[str], indent: int) -> list[str]:
        return [f"{' ' * indent}{line}" for line in lines]

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        taken = ", ".join(f"{'' if one.is_read else '_'}{one.name}: {self.type(one.type)}" for one in parameters)
        given = self._results(results) if len(results) > 1 else self.type(results[0].type) if results else "void"
        return f"static func {name}({taken}) -> {given}:"

    def beginning(self, parameters: Sequence[Taken], is_public: bool) -> list[str]:
        """Users' numbers as a shader has them."""
        if not is_public:
            return []
        return [f"{one.name} = Color({one.name}, 0.0, 0.0).r" if one.type == "float" else f"{one.name} &= {MASK.text}"
                for one in parameters if one.type in ("float", "uint") and one.is_read]

    def body(self, lines: Sequence[str]) -> Sequence[str]:
        """The editor warns of each division of integers."""
        shown: list[str] = []
        for line in lines:
            if DIVIDED in line:
                shown.append(f'{" " * (len(line) - len(line.lstrip()))}@warning_ignore("integer_division")')
            shown.append(line.replace(DIVIDED, " / "))
        return without_braces(shown)

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        known = [(self.field_name(field.name), self.type(field.type)) for field in fields]
        taken = ", ".join(f"p_{one}: {type_}" for one, type_ in known)
        lines = [f"class {self.type_name(name)}:", *(f"    var {one}: {type_}" for one, type_ in known), "",
                 *without_braces([f"    func _init({taken}) -> void:"]), *(f"        {one} = p_{one}" for one, _ in known)]
        return "\n".join(lines) + "\n"

    def documented(self, name: str, facts: Facts) -> list[str]:
        return [f"## {line}".rstrip() for line in self.paragraphs(facts)]

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        head = [*(f"#{line}" for line in heading), *([f"class_name {self.name}"] if self.name else []),
                "extends RefCounted"]
        written = [part.removesuffix("}\n") for part in [*parts, *self.results.values()]]
        constants = [part for part in written if part.startswith("const ")]
        text = "\n\n\n".join(part.strip("\n") for part in written if not part.startswith("const "))
        lines = "\n".join(["\n".join(head), *(["", *constants] if constants else []), "", "", text]).split("\n")
        return "\n".join("\t" * ((len(line) - len(line.lstrip(" "))) // 4) + line.lstrip(" ") for line in lines) + "\n"
