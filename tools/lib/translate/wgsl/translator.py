"""Writes the tree of GLSL as WGSL. It derives the type of each expression, since GLSL chooses overloads by types."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from translate.parsing.lines import WIDTH, wrapped
from translate.parsing.preprocessor import Constant
from translate.parsing.syntax import (
    SCALARS,
    VECTORS,
    Assign,
    Binary,
    Block,
    Break,
    Call,
    Choice,
    Comments,
    Declare,
    DoLoop,
    Evaluate,
    Expression,
    Function,
    If,
    Loop,
    Member,
    Name,
    Number,
    Parameter,
    Parentheses,
    Parser,
    Return,
    Statement,
    Struct,
    Truth,
    Unary,
)
from translate.parsing.tokens import Token, Unknown
from translate.names import components, is_passed, is_public, variable, wgsl_name, wgsl_type

FLOATS = ("float", "vec2", "vec3", "vec4")
INTS = ("int", "ivec2", "ivec3", "ivec4")
UINTS = ("uint", "uvec2", "uvec3", "uvec4")
OF_KIND = {kind: dict(zip((1, 2, 3, 4), types)) for kind, types in (("float", FLOATS), ("int", INTS), ("uint", UINTS))}
KIND = {type_: kind for kind, types in OF_KIND.items() for type_ in types.values()} | {"bool": "bool"}

# Functions that both languages have, by how many arguments, all of one type, which is that of the result, too.
COMMON = {"abs": (1, ("float", "int")), "floor": (1, ("float",)), "trunc": (1, ("float",)), "sqrt": (1, ("float",)),
          "min": (2, ("float", "int", "uint")), "max": (2, ("float", "int", "uint"))}
CASTS = {"uintBitsToFloat": ("uint", "float"), "floatBitsToUint": ("float", "uint"),
         "intBitsToFloat": ("int", "float"), "floatBitsToInt": ("float", "int")}

# How WGSL's operators bind. It wants parentheses where readers would.
PRIMARY, UNARY, PRODUCT, SUM, SHIFT, RELATION, BITS, LOGIC = range(8)
LEVELS = {**dict.fromkeys("*/%", PRODUCT), **dict.fromkeys("+-", SUM), **dict.fromkeys(("<<", ">>"), SHIFT),
          **dict.fromkeys(("==", "!=", "<", ">", "<=", ">="), RELATION), **dict.fromkeys("&|^", BITS),
          **dict.fromkeys(("&&", "||"), LOGIC)}


@dataclass(frozen=True)
class Code:
    """An expression in WGSL, its type in GLSL's words, and what holds it together."""
    text: str
    type: str
    level: int = PRIMARY
    sign: str = ""  # of a chain of && or of &

    def within(self, level: int) -> str:
        return self.text if self.level <= level else f"({self.text})"


@dataclass
class Definition:
    """A function, a struct or a constant of the module, and what it needs of the others."""
    name: str
    comments: tuple[str, ...]
    lines: list[str]
    needs: list[str] = field(default_factory=list)
    is_constant: bool = False


class Translator:
    """Definitions of a module, in the order of the text; each is translated when it is asked for. `others` are functions
    that the user has."""

    def __init__(self, tree: list[Function | Struct], constants: dict[str, Constant], others: Sequence[Function] = ()):
        self.structs = {item.name: item for item in tree if isinstance(item, Struct)}
        self.functions: dict[tuple[str, tuple[str, ...]], Function] = {}
        self.others = {(function.name, function.types) for function in others}
        self.constants = constants
        self._constant_codes: dict[str, Code] = {}
        for function in [*others, *(item for item in tree if isinstance(item, Function))]:
            known = self.functions.setdefault((function.name, function.types), function)
            if known is not function:
                raise function.at.error(f"{function.name} is there already, in {known.at.path}:{known.at.line}")
        self._without_seed = {key: seeded for key in self.functions if (seeded := self._seeded(key))}
        self._check_names()
        # By name, constants first.
        self.items: dict[str, Constant | Struct | Function] = dict(constants)
        for item in tree:
            if isinstance(item, Struct):
                self.items[item.name] = item
            elif (item.name, item.types) not in self._without_seed:
                self.items[wgsl_name(item)] = item
        self._definitions: dict[str, Definition] = {}

    def definition(self, name: str) -> Definition:
        if name not in self._definitions:
            item = self.items[name]
            if isinstance(item, Constant):
                made = self._constant(item)
            elif isinstance(item, Struct):
                made = self._struct(item)
            else:
                made = FunctionWriter(self, item).definition()
            self._definitions[name] = made
        return self._definitions[name]

    def public(self) -> list[str]:
        """The names of what users call or pass."""
        return [name for name, item in self.items.items()
                if (is_passed(name) if isinstance(item, Constant) else isinstance(item, Function) and is_public(item.name))]

    def all_but_constants(self) -> list[str]:
        return [name for name, item in self.items.items() if not isinstance(item, Constant)]

    def needed_by(self, names: Iterable[str]) -> set[str]:
        """These names, and those of all that they need."""
        found: set[str] = set()
        pending = list(names)
        while pending:
            name = pending.pop()
            if name not in self.items:
                raise Unknown(f"there is no {name} in this module")
            if name not in found:
                found.add(name)
                pending += self.definition(name).needs
        return found

    def names(self) -> dict[tuple[str, tuple[str, ...]], str]:
        """The name in WGSL of each function; one without a seed has the name of that with one."""
        return {key: wgsl_name(self.functions[self._without_seed.get(key, key)]) for key in self.functions}

    def _seeded(self, key: tuple[str, tuple[str, ...]]) -> tuple[str, tuple[str, ...]] | None:
        """The overload with a seed of one that calls it with the seed 0 and does nothing else."""
        function = self.functions[key]
        if not is_public(function.name) or "seed" in [parameter.at.text for parameter in function.parameters]:
            return None
        ins = [parameter for parameter in function.parameters if not parameter.is_set]
        outs = [parameter for parameter in function.parameters if parameter.is_set]
        seeded = (function.name, (*(p.type for p in ins), "uint", *(p.type for p in outs)))
        other = self.functions.get(seeded)
        if other is None or other.parameters[len(ins)].at.text != "seed":
            return None
        body = function.body.statements
        call = body[0].value if len(body) == 1 and isinstance(body[0], Return) else None
        passed = [argument.at.text if isinstance(argument, (Name, Number)) else None
                  for argument in (call.arguments if isinstance(call, Call) else ())]
        if passed != [*(p.at.text for p in ins), "0u", *(p.at.text for p in outs)] or call.at.text != function.name:
            raise function.at.error(f"{function.name} without a seed must be {function.name} with the seed 0u")
        return seeded

    def _check_names(self) -> None:
        taken: dict[str, Function] = {}
        for key, function in self.functions.items():
            if key in self._without_seed:
                continue
            name = wgsl_name(function)
            other = taken.setdefault(name, function)
            if other is not function:
                raise function.at.error(f"{name} is the name of another function in WGSL, too: that of "
                                        f"{other.at.path}:{other.at.line}. tools/lib/translate/names.py has the rule")

    def resolve(self, at: Token, types: tuple[str, ...]) -> tuple[Function, bool]:
        """The function that is called, and whether a seed of 0 has to be put in."""
        function = self.functions.get((at.text, types))
        if function is None:
            called = f"{at.text}({', '.join(types)})"
            overloads = [", ".join(other) for name, other in self.functions if name == at.text]
            known = f"; there are ({'), ('.join(overloads)})" if overloads else ""
            raise at.error(f"there is no function {called}{known}")
        seeded = self._without_seed.get((at.text, types))
        return (self.functions[seeded], True) if seeded else (function, False)

    def constant(self, at: Token) -> Code:
        if at.text not in self._constant_codes:
            tokens = list(self.constants[at.text].body)
            parser = Parser(tokens)
            tree = parser._expression()
            if parser._next.kind != "end":
                raise parser._next.error(f"{parser._next} is not expected in {at.text}")
            writer = FunctionWriter(self, None)
            self._constant_codes[at.text] = writer.expression(tree)
        return self._constant_codes[at.text]

    def _constant(self, constant: Constant) -> Definition:
        code = self.constant(constant.body[0]._replace(text=constant.name))
        needs = [token.text for token in constant.body if token.text in self.constants]
        comment = f"  {constant.comment}" if constant.comment else ""
        lines = [f"const {constant.name}: {wgsl_type(code.type)} = {code.text};{comment}"]
        return Definition(constant.name, (), lines, needs, is_constant=True)

    def _struct(self, struct: Struct) -> Definition:
        lines, needs = [f"struct {struct.name} {{"], []
        for name, type_, comments in struct.fields:
            lines += [f"  {line}" for line in comments.before if line]
            lines.append(f"  {variable(name)}: {wgsl_type(type_)}," + (f"  {comments.after}" if comments.after else ""))
            needs += [type_] * (type_ in self.structs)
        return Definition(struct.name, struct.comments.before, [*lines, "}"], needs)


class FunctionWriter:
    """Writes one function."""

    def __init__(self, translator: Translator, function: Function | None):
        self.translator = translator
        self.function = function
        self.changed: set[str] = set()   # variables that do not keep their first value
        self.needs: dict[str, None] = {}
        self.scopes: list[dict[str, str]] = []  # the types of variables
        self.pointers: set[str] = set()

    def definition(self) -> Definition:
        function = self.function
        # Twice: what is changed is known behind the first.
        for _ in range(2):
            self.scopes = [{parameter.at.text: parameter.type for parameter in function.parameters}]
            self.pointers = {parameter.at.text for parameter in function.parameters if parameter.is_set}
            copies = [parameter for parameter in function.parameters
                      if not parameter.is_set and parameter.at.text in self.changed]
            body = [line for parameter in copies for line in self._copy(parameter)]
            body += self._block(function.body, 2)
        head = f"fn {wgsl_name(function)}({', '.join(self._parameter(parameter) for parameter in function.parameters)})"
        if function.type != "void":
            head += f" -> {wgsl_type(function.type)}"
        for type_ in (function.type, *function.types):
            self._need_type(type_)
        after = function.body.comments.after
        if len(body) == 1 and not after and len(head) + len(body[0].strip()) + 5 <= WIDTH and "//" not in body[0]:
            lines = [f"{head} {{ {body[0].strip()} }}"]
        else:
            lines = wrapped(f"{head} {{", 0)
            lines += [f"  {after}"] * bool(after)
            lines += [*body, "}"]
        return Definition(wgsl_name(function), function.comments.before, lines, list(self.needs))

    def _parameter(self, parameter: Parameter) -> str:
        name, type_ = variable(parameter.at.text), wgsl_type(parameter.type)
        if parameter.is_set:
            return f"{name}: ptr<function, {type_}>"
        return f"{parameter.at.text}_in: {type_}" if parameter.at.text in self.changed else f"{name}: {type_}"

    @staticmethod
    def _copy(parameter: Parameter) -> list[str]:
        return [f"  var {variable(parameter.at.text)} = {parameter.at.text}_in;"]

    def _need_type(self, type_: str) -> None:
        if type_ in self.translator.structs:
            self.needs[type_] = None

    # Statements.

    def _block(self, block: Block, indent: int) -> list[str]:
        self.scopes.append({})
        lines = [line for statement in block.statements for line in self._statement(statement, indent)]
        self.scopes.pop()
        return lines

    def _statement(self, statement: Statement, indent: int) -> list[str]:
        comments = statement.comments
        lines = [" " * indent + line if line else "" for line in comments.before]
        if isinstance(statement, Block):
            return [*lines, " " * indent + "{", *self._block(statement, indent + 2), " " * indent + "}"]
        if isinstance(statement, If):
            return lines + self._if(statement, indent)
        if isinstance(statement, Loop):
            return lines + self._loop(statement, indent)
        if isinstance(statement, DoLoop):
            return lines + self._do_loop(statement, indent)
        code = wrapped(self._simple(statement) + ";", indent)
        if comments.after:
            if len(code[-1]) + len(comments.after) + 2 <= WIDTH:
                code[-1] += f"  {comments.after}"
            else:
                code.insert(0, " " * indent + comments.after)
        return lines + code

    def _if(self, statement: If, indent: int) -> list[str]:
        space = " " * indent
        condition = self._of_type(statement.condition, "bool").text
        yes = self._block(statement.yes, indent + 2)
        if statement.no is None and len(yes) == 1 and "//" not in yes[0]:
            short = f"{space}if ({condition}) {{ {yes[0].strip()} }}"
            if len(short) <= WIDTH:
                return [short]
        lines = [*wrapped(f"if ({condition}) {{", indent), *yes]
        if isinstance(statement.no, If):
            rest = self._if(statement.no, indent)
            return [*lines, f"{space}}} else {rest[0].strip()}", *rest[1:]]
        if statement.no is not None:
            lines += [f"{space}}} else {{", *self._block(statement.no, indent + 2)]
        return [*lines, f"{space}}}"]

    def _loop(self, loop: Loop, indent: int) -> list[str]:
        if loop.start is None and loop.condition is None and loop.step is None:
            return [" " * indent + "loop {", *self._block(loop.body, indent + 2), " " * indent + "}"]
        self.scopes.append({})
        start = self._simple(loop.start) if loop.start else ""
        condition = self._of_type(loop.condition, "bool").text if loop.condition else ""
        step = self._simple(loop.step) if loop.step else ""
        lines = wrapped(f"for ({start}; {condition}; {step}) {{", indent)
        lines += [*self._block(loop.body, indent + 2), " " * indent + "}"]
        self.scopes.pop()
        return lines

    def _do_loop(self, loop: DoLoop, indent: int) -> list[str]:
        body = self._block(loop.body, indent + 2)
        condition = self._of_type(loop.condition, "bool")
        return [" " * indent + "loop {", *body, " " * (indent + 2) + "continuing {",
                *wrapped(f"break if !({condition.text});", indent + 4), " " * (indent + 2) + "}", " " * indent + "}"]

    def _simple(self, statement: Statement) -> str:
        if isinstance(statement, Declare):
            return self._declaration(statement)
        if isinstance(statement, Assign):
            return self._assignment(statement)
        if isinstance(statement, Evaluate):
            return self.expression(statement.call).text
        if isinstance(statement, Break):
            return "break"
        if statement.value is None:
            return "return"
        return f"return {self._of_type(statement.value, self.function.type).text}"

    def _declaration(self, statement: Declare) -> str:
        name, type_ = statement.at.text, statement.type
        value = f" = {self._of_type(statement.value, type_).text}" if statement.value else ""
        if name in self.scopes[-1] or (len(self.scopes) == 2 and name in self.scopes[0]):
            raise statement.at.error(f"{name} is a variable already")
        self.scopes[-1][name] = type_
        self._need_type(type_)
        keyword = "let" if statement.value and name not in self.changed else "var"
        return f"{keyword} {variable(name)}: {wgsl_type(type_)}{value}"

    def _assignment(self, statement: Assign) -> str:
        self._change(statement.target)
        target = self.expression(statement.target)
        if statement.value is None:
            if target.type != "int":
                raise statement.at.error(f"{statement.at} changes a {target.type} instead of an int")
            return f"{target.text}{statement.at}"
        operator = statement.at.text.removesuffix("=")
        if not operator:
            return f"{target.text} = {self._of_type(statement.value, target.type).text}"
        value = self.expression(statement.value)
        result, _, right = self._operation(statement.at, operator, target, value)
        if result != target.type:
            raise statement.at.error(f"{statement.at} makes a {result} of a {target.type}")
        return f"{target.text} {statement.at} {right.text}"

    def _change(self, target: Expression) -> None:
        while isinstance(target, Member):
            target = target.of
        if not isinstance(target, Name):
            raise target.at.error(f"{target.at} cannot be assigned to")
        self.changed.add(target.at.text)

    # Expressions.

    def _of_type(self, expression: Expression, type_: str) -> Code:
        code = self.expression(expression)
        if code.type != type_:
            raise expression.at.error(f"this is a {code.type} where a {type_} is expected")
        return code

    def expression(self, expression: Expression) -> Code:
        if isinstance(expression, Number):
            return self._number(expression.at)
        if isinstance(expression, Truth):
            return Code(expression.at.text, "bool")
        if isinstance(expression, Name):
            return self._name(expression.at)
        if isinstance(expression, Parentheses):
            inside = self.expression(expression.inside)
            return Code(inside.text if inside.level == PRIMARY else f"({inside.text})", inside.type)
        if isinstance(expression, Member):
            return self._member(expression)
        if isinstance(expression, Unary):
            return self._unary(expression)
        if isinstance(expression, Binary):
            return self._binary(expression)
        if isinstance(expression, Choice):
            return self._choice(expression)
        return self._call(expression)

    @staticmethod
    def _number(at: Token) -> Code:
        text = at.text
        if text[-1] in "uU":
            if int(text[:-1], 0) > 0xFFFFFFFF:
                raise at.error(f"{text} does not fit a uint")
            return Code(f"{text[:-1]}u", "uint")
        if text[:2] not in ("0x", "0X") and (text[-1] in "fF" or re.search(r"[.eE]", text)):
            if text[-1] not in "fF":
                raise at.error(f"{text} has no f: C++ takes it for a double")
            return Code(text, "float")
        if int(text, 0) > 0x7FFFFFFF:
            raise at.error(f"{text} does not fit an int")
        return Code(text, "int")

    def _name(self, at: Token) -> Code:
        for scope in reversed(self.scopes):
            if at.text in scope:
                name = variable(at.text)
                return Code(f"(*{name})" if at.text in self.pointers else name, scope[at.text])
        if at.text in self.translator.constants:
            self.needs[at.text] = None
            return Code(at.text, self.translator.constant(at).type)
        raise at.error(f"{at} is no variable, and no macro that stands for a number")

    def _member(self, expression: Member) -> Code:
        of, name = self.expression(expression.of), expression.at.text
        if of.type in VECTORS:
            if name not in ("x", "y", "z", "w")[:components(of.type)]:
                raise expression.at.error(f".{name} of a {of.type}: the translator knows .x, .y, .z and .w")
            return Code(f"{of.within(PRIMARY)}.{name}", KIND[of.type])
        struct = self.translator.structs.get(of.type)
        types = {field_name: type_ for field_name, type_, _ in struct.fields} if struct else {}
        if name not in types:
            raise expression.at.error(f"a {of.type} has no .{name}")
        return Code(f"{of.within(PRIMARY)}.{variable(name)}", types[name])

    def _unary(self, expression: Unary) -> Code:
        operand = self.expression(expression.operand)
        sign = expression.at.text
        kind = KIND.get(operand.type)
        if (sign == "-" and kind not in ("float", "int")) or (sign == "!" and operand.type != "bool"):
            raise expression.at.error(f"the translator does not know {sign} of a {operand.type}")
        text = operand.text if operand.level == PRIMARY else f"({operand.text})"
        return Code(f"{sign}{text}", operand.type, UNARY)

    def _binary(self, expression: Binary) -> Code:
        sign = expression.at.text
        left, right = self.expression(expression.left), self.expression(expression.right)
        type_, left, right = self._operation(expression.at, sign, left, right)
        level = LEVELS[sign]
        if level in (BITS, LOGIC):
            chain = left.level == level and left.sign == sign
            below = RELATION if level == LOGIC else UNARY
            text = f"{left.text if chain else left.within(below)} {sign} {right.within(below)}"
            return Code(text, type_, level, sign)
        if level == RELATION:
            return Code(f"{left.within(SHIFT)} {sign} {right.within(SHIFT)}", type_, level)
        if level == SHIFT:
            return Code(f"{left.within(UNARY)} {sign} {right.within(UNARY)}", type_, level)
        return Code(f"{left.within(level)} {sign} {right.within(level - 1)}", type_, level)

    @staticmethod
    def _operation(at: Token, sign: str, left: Code, right: Code) -> tuple[str, Code, Code]:
        """The type of a result, and the operands as WGSL wants them."""
        unknown = at.error(f"the translator does not know {left.type} {sign} {right.type}")
        kinds, sizes = (KIND.get(left.type), KIND.get(right.type)), (_size(left.type), _size(right.type))
        if sign in ("&&", "||"):
            if kinds != ("bool", "bool"):
                raise unknown
            return "bool", left, right
        if sign in ("==", "!=", "<", ">", "<=", ">="):
            ordered = sign not in ("==", "!=")
            if left.type != right.type or left.type not in SCALARS or (ordered and left.type == "bool"):
                raise unknown
            return "bool", left, right
        if kinds[0] not in OF_KIND or kinds[1] not in OF_KIND:
            raise unknown
        if sign in ("<<", ">>"):
            return left.type, left, _shift_count(left, right, unknown)
        if kinds[0] != kinds[1] or (sizes[0] != sizes[1] and 1 not in sizes):
            raise unknown
        if sign in "&|^%" and kinds[0] == "float":
            raise unknown
        type_ = OF_KIND[kinds[0]][max(sizes)]
        if sign in "&|^":
            # WGSL has only the arithmetic operators of a vector and a scalar.
            left, right = (Code(f"{wgsl_type(type_)}({code.text})", type_) if code.type != type_ else code
                           for code in (left, right))
        return type_, left, right

    def _choice(self, expression: Choice) -> Code:
        condition = self._of_type(expression.condition, "bool")
        yes, no = self.expression(expression.yes), self.expression(expression.no)
        if yes.type != no.type or yes.type not in SCALARS:
            raise expression.at.error(f"the translator does not know ? of a {yes.type} and a {no.type}")
        return Code(f"select({no.text}, {yes.text}, {condition.text})", yes.type)

    def _call(self, expression: Call) -> Code:
        name = expression.at.text
        if name in SCALARS or name in VECTORS:
            return self._construction(expression)
        arguments = [self.expression(argument) for argument in expression.arguments]
        types = tuple(code.type for code in arguments)
        if name in CASTS or name in COMMON:
            return self._builtin(expression.at, arguments)
        function, without_seed = self.translator.resolve(expression.at, types)
        passed = [self._passed(parameter, argument, code) for parameter, argument, code in zip(
            [p for p in function.parameters if not (without_seed and p.at.text == "seed")], expression.arguments,
            arguments)]
        if without_seed:
            seed = [parameter.at.text for parameter in function.parameters].index("seed")
            passed.insert(seed, "0u")
        if (function.name, function.types) not in self.translator.others:
            self.needs[wgsl_name(function)] = None
        return Code(f"{wgsl_name(function)}({', '.join(passed)})", function.type)

    def _passed(self, parameter: Parameter, argument: Expression, code: Code) -> str:
        if not parameter.is_set:
            return code.text
        if not isinstance(argument, Name):
            raise argument.at.error(f"what {parameter.at} is set to must be a variable")
        name = argument.at.text
        if name in self.pointers:
            return variable(name)
        self.changed.add(name)
        return f"&{variable(name)}"

    @staticmethod
    def _builtin(at: Token, arguments: list[Code]) -> Code:
        types = [code.type for code in arguments]
        texts = ", ".join(code.text for code in arguments)
        unknown = at.error(f"the translator does not know {at.text}({', '.join(types)})")
        if at.text in CASTS:
            source, target = CASTS[at.text]
            if len(types) != 1 or KIND.get(types[0]) != source:
                raise unknown
            type_ = OF_KIND[target][_size(types[0])]
            return Code(f"bitcast<{wgsl_type(type_)}>({texts})", type_)
        count, kinds = COMMON[at.text]
        if len(types) != count or len(set(types)) != 1 or KIND.get(types[0]) not in kinds:
            raise unknown
        return Code(f"{at.text}({texts})", types[0])

    def _construction(self, expression: Call) -> Code:
        type_ = expression.at.text
        arguments = [self.expression(argument) for argument in expression.arguments]
        sizes = [_size(code.type) for code in arguments]
        unknown = expression.at.error(f"the translator does not know {type_}({', '.join(c.type for c in arguments)})")
        if any(KIND.get(code.type) not in (*OF_KIND, "bool") for code in arguments) or not arguments:
            raise unknown
        kinds = {KIND[code.type] for code in arguments}
        texts = ", ".join(code.text for code in arguments)
        if len(arguments) == 1 and sizes[0] in (1, _size(type_)):
            # A conversion, or all components alike. WGSL does not convert and repeat at once.
            text = texts
            if sizes[0] == 1 and _size(type_) > 1 and kinds != {KIND[type_]}:
                text = f"{wgsl_type(KIND[type_])}({text})"
            return Code(f"{wgsl_type(type_)}({text})", type_)
        if sum(sizes) != _size(type_):
            raise unknown
        if kinds == {KIND[type_]}:
            return Code(f"{wgsl_type(type_)}({texts})", type_)
        if len(kinds) > 1 or "bool" in kinds:
            raise unknown
        joined = OF_KIND[kinds.pop()][_size(type_)]
        return Code(f"{wgsl_type(type_)}({wgsl_type(joined)}({texts}))", type_)


def _size(type_: str) -> int:
    return components(type_)


def _shift_count(left: Code, right: Code, unknown: Unknown) -> Code:
    """WGSL shifts by unsigned counts, and vectors by vectors."""
    if right.type == "int":
        if not re.fullmatch(r"\d+", right.text):
            raise unknown
        right = Code(f"{right.text}u", "uint")
    if right.type != "uint" or KIND[left.type] == "float":
        raise unknown
    size = _size(left.type)
    return Code(f"vec{size}u({right.text})", OF_KIND["uint"][size]) if size > 1 else right
