"""Open Shading Language, for Blender's Cycles and other renderers: functions, and a shader of the first one.

An int has 32 bits and a sign there, and wraps, so it is a word as well. There are no bits of floats: the library is
taken as it is written for GLSL 1.30, where there are none, either.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from catalog import parameters as known
from translate.parsing.lines import wrapped
from translate.pick.printer import UNARY
from translate.pick.scalars import Part, Piece, Syntax, Taken, bare
from translate.pick.values import AXES, PREFIXES, SIZES

MASKED = re.compile(r"(\(\w+ >> \d+\)) & (0x[0-9A-F]+)")
COMPARED = {"<": ("hn_i_less", "{0}, {1}"), ">": ("hn_i_less", "{1}, {0}")}
UNSIGNED = {"/": "hn_i_quotient", "%": "hn_i_rest"}
VECTORS = {f"hn_{prefix}vec{size}": ("float" if scalar == "float" else "int", AXES[:size])
           for scalar, prefix in PREFIXES.items() for size in (2, 3, 4)}
# A component of a function's result: the language takes components of variables alone.
COMPONENTS = {f"hn_i_{axis}_of_{name.removeprefix('hn_')}": (axis, name)
              for name, (_, axes) in VECTORS.items() for axis in axes}


class Osl(Syntax):
    example_set = "{}"
    passed = "#define {} {}"
    indent = 2
    keeps_names, cased = True, staticmethod(str)
    float_end = word_end = ""
    forever = "while (1) {"
    least_int, bools = "0x80000000", ("0", "1")
    builtins = {"min uint": "hn_i_smaller", "max uint": "hn_i_larger"}
    library = {"__VERSION__": "130"}
    no_precise = ("a renderer may reorder what OSL computes with floats: take --arithmetic fixed, whose bits are the same "
                  "everywhere")
    types = dict.fromkeys(("int", "uint", "bool"), "int") | {"float": "float"}
    # The language's own words, its global variables, and a function that is overloaded.
    reserved = frozenset("""and break closure color continue do else emit float for if illuminance illuminate int matrix
        normal not or output point public return string struct vector void while bool case char class const default
        double enum extern false friend inline long private protected short signed sizeof static template this true
        typedef uniform union unsigned varying virtual volatile shader surface displacement volume u v P N I Ng Ps Ci
        time dtime dPdu dPdv dPdtime noise""".split())
    helpers_first = True
    sets_parameters = True
    needs = {**{name: (vector,) for name, (_, vector) in COMPONENTS.items()}, "hn_i_quotient": ("hn_i_less",),
             "hn_i_rest": ("hn_i_quotient",), "hn_i_smaller": ("hn_i_less",),
             "hn_i_larger": ("hn_i_less",)}
    helpers = {
        **{name: f"struct {name} {{ {' '.join(f'{scalar} {axis};' for axis in axes)} }};\n"
           for name, (scalar, axes) in VECTORS.items()},
        **{name: f"{VECTORS[vector][0]} {name}({vector} a) {{ return a.{axis}; }}\n"
           for name, (axis, vector) in COMPONENTS.items()},
        "hn_i_shifted": """\
// Without the sign.
int hn_i_shifted(int a, int n) { return n == 0 ? a : (a >> n) & (0x7FFFFFFF >> (n - 1)); }
""",
        "hn_i_less": "// Words.\nint hn_i_less(int a, int b) { return (a ^ 0x80000000) < (b ^ 0x80000000); }\n",
        "hn_i_smaller": "int hn_i_smaller(int a, int b) { return hn_i_less(b, a) ? b : a; }\n",
        "hn_i_larger": "int hn_i_larger(int a, int b) { return hn_i_less(a, b) ? b : a; }\n",
        "hn_i_quotient": """\
int hn_i_quotient(int a, int b) {
  if (b < 0) return !hn_i_less(a, b);
  int q = (((a >> 1) & 0x7FFFFFFF) / b) << 1;
  return q + !hn_i_less(a - q * b, b);
}
""",
        "hn_i_rest": "int hn_i_rest(int a, int b) { return a - hn_i_quotient(a, b) * b; }\n",
        "hn_i_from_word": """\
// The last bit of a half decides how it is rounded.
float hn_i_from_word(int a) { return a >= 0 ? (float)a : 2.0 * (float)(((a >> 1) & 0x7FFFFFFF) | (a & 1)); }
""",
        "hn_i_to_int": """\
int hn_i_to_int(float x) {
  if (x >= -2147483648.0 && x < 2147483648.0) return (int)x;
  return x > 0.0 ? 0x7FFFFFFF : x < 0.0 ? 0x80000000 : 0;
}
""",
        "hn_i_to_word": """\
int hn_i_to_word(float x) {
  if (x >= 2147483648.0) return x < 4294967296.0 ? (int)(x - 2147483648.0) ^ 0x80000000 : 0xFFFFFFFF;
  return x > 0.0 ? (int)x : 0;
}
"""}

    def __init__(self, precise: bool = False):
        super().__init__(precise)
        self.public: list[tuple[str, Sequence[Taken], Sequence[Part]]] = []

    def vector(self, type_: str) -> str:
        return self.helper(f"hn_{type_}")

    # Expressions.

    def binary(self, sign: str, type_: str, left: Piece, right: Piece) -> Piece:
        if type_ == "uint" and sign == ">>":
            if right.text.isdigit() and 0 < int(right.text) < 32:
                mask = Piece(f"0x{(1 << 32 - int(right.text)) - 1:X}")
                return self.infix("&", self.infix(">>", left, right), mask)
            return self.call(self.helper("hn_i_shifted"), [left, right])
        if type_ == "uint" and sign in UNSIGNED:
            return self.call(self.helper(UNSIGNED[sign]), [left, right])
        if type_ == "uint" and sign[0] in COMPARED and sign not in ("<<", ">>"):
            negated = sign in ("<=", ">=")
            name, arguments = COMPARED[{"<=": ">", ">=": "<"}.get(sign, sign)]
            return Piece(f"{'!' * negated}{self.helper(name)}({arguments.format(left.text, right.text)})",
                         UNARY if negated else Piece("").binds)
        if type_ == "uint" and sign == "&" and (found := MASKED.fullmatch(left.text)) and right.text.isalnum():
            asked, kept = int(right.text, 0), int(found[2], 0)
            if asked & kept == asked:  # masked already
                left = Piece(found[1])
        return super().binary(sign, type_, left, right)

    def component_of(self, of: Piece, axis: str, type_: str) -> Piece:
        if re.fullmatch(r"[\w.]+", of.text):
            return super().component_of(of, axis, type_)
        return self.call(self.helper(f"hn_i_{axis}_of_{type_}"), [of])

    def convert(self, to: str, of: str, piece: Piece) -> Piece:
        if of == to or "float" not in (to, of):
            return piece
        if of == "float":
            return self.call(self.helper("hn_i_to_int" if to == "int" else "hn_i_to_word"), [piece])
        if of == "uint" and not re.search(r" & 0x[0-7]?[0-9A-F]{1,7}$", piece.text):
            return self.call(self.helper("hn_i_from_word"), [piece])
        return Piece(f"(float){piece.within(UNARY - 1)}", UNARY)

    def make_struct(self, type_: str, fields: Sequence[Part], parts: Sequence[Piece]) -> Piece:
        return self.call(self._maker(type_) if self._is_nested(fields) else type_, parts)

    def _is_nested(self, fields: Sequence[Part]) -> bool:
        """Whether structs are in a struct: its constructor loses those, in OSL 1.14."""
        return any(self.type(field.type) not in ("int", "float") for field in fields)

    def _maker(self, type_: str) -> str:
        return f"hn_i_made_{bare(type_)}"

    # Statements.

    def change(self, type_: str, name: str, sign: str, by: str) -> str | None:
        return None if type_ == "uint" and sign in (">>", *UNSIGNED) else super().change(type_, name, sign, by)

    # Functions.

    def function(self, name: str, parameters: Sequence[Taken], results: Sequence[Part], is_public: bool) -> str:
        if is_public:
            self.public.append((name, parameters, results))
        # A parameter can be changed only if it is an output.
        taken = [f"{'output ' * one.is_set}{self.type(one.type)} {one.name}{'_0' * (one.changes and not one.is_set)}"
                 for one in parameters]
        taken += [f"output {self.type(part.type)} {self.variable(part.name)}" for part in results
                  if part.name != "value"]
        given = next((self.type(part.type) for part in results if part.name == "value"), "void")
        return f"{given} {name}({', '.join(taken)}) {{"

    def beginning(self, parameters: Sequence[Taken], is_public: bool) -> list[str]:
        return [f"{self.type(one.type)} {one.name} = {one.name}_0;" for one in parameters
                if one.changes and not one.is_set]

    def struct(self, name: str, fields: Sequence[Part]) -> str:
        made = ""
        if self._is_nested(fields):
            names = [self.field_name(field.name) for field in fields]
            taken = ", ".join(f"{self.type(field.type)} {one}" for field, one in zip(fields, names))
            head = "\n".join(wrapped(f"{name} {self._maker(name)}({taken}) {{", 0))
            sets = "".join(f"  made.{one} = {one};\n" for one in names)
            made = f"\n{head}\n  {name} made;\n{sets}  return made;\n}}\n"
        return super().struct(name, fields) + made

    def file(self, heading: Sequence[str], names: Sequence[str], parts: Sequence[str]) -> str:
        return super().file(heading, names, [*parts, *shader(self, *self.public[0])])


def shader(syntax: Osl, name: str, parameters: Sequence[Taken], results: Sequence[Part]) -> list[str]:
    """The shader for a node of a renderer; nothing for a function that takes or sets a struct, or returns one."""
    if any(one.type not in SIZES for one in (*parameters, *results)):
        return []
    axes = [one.name for one in parameters if one.name in AXES]
    inputs = ["point p = P"] if len(axes) > 1 else []
    passed = []
    for one in parameters:
        if len(axes) > 1 and one.name in axes[:3]:
            passed.append(f"p[{axes.index(one.name)}]")
        else:
            inputs.append(declared(syntax, name, one))
            passed.append(one.name)
    before, after = [], []
    outputs = []
    renamed = {"value": "result"} if "value" in passed else {}  # an input has the name
    results = [part._replace(name=renamed.get(part.name, part.name)) for part in results]
    returned = renamed.get("value", "value")
    for part in results:
        size, local = SIZES[part.type], f"{part.name}_n"
        if size == 1:
            outputs.append(f"output {syntax.type(part.type)} {part.name} = 0")
            local = part.name
        else:
            before.append(f"{syntax.type(part.type)} {local};")
            outputs.append(f"output vector {part.name} = 0")
            three = [*(f"{local}.{axis}" for axis in AXES[:min(size, 3)]), "0", "0"][:3]
            after.append(f"{part.name} = vector({', '.join(three)});")
            if size == 4:
                outputs.append(f"output float {part.name}_w = 0")
                after.append(f"{part.name}_w = {local}.w;")
        if part.name != returned:
            passed.append(local)
    call = f"{name}({', '.join(passed)});"
    if value := next((part for part in results if part.name == returned), None):
        call = f"{returned}{'_n' * (SIZES[value.type] > 1)} = {call}"
    body = "".join(f"  {line}\n" for line in (*before, call, *after))
    taken = ",\n    ".join([*inputs, *outputs])
    return [f"shader {syntax.name or f'hashnoise_{bare(name)}'}(\n    {taken}) {{\n{body}}}\n"]


def declared(syntax: Osl, function: str, one: Taken) -> str:
    """An input with its default, the text that a renderer shows of it, and the range of its slider."""
    scalar = syntax.type(one.type)
    about = known.about(function, one.name, syntax.is_fixed)
    head = f"{scalar} {one.name} = {default_of(about, scalar)}"
    if not about:
        return head
    ends = ", ".join(f"{scalar} {end} = {float(value) if scalar == 'float' else int(value)}"
                     for end, value in (("min", about.least), ("max", about.most)) if value is not None)
    joined = ",\n           ".join(filter(None, (f'string help = "{about.what}"', ends)))
    return f"{head}\n        [[ {joined} ]]"


def default_of(about: known.About | None, type_: str) -> float:
    value = about.default or 0 if about else 0
    return float(value) if type_ == "float" else int(value)


def without_shader(text: str) -> str:
    """The functions alone: the shader is the last thing in a text."""
    return re.sub(r"(?ms)^shader .*", "", text)
