"""The faults that tools/test mutants plants, one place at a time: from a piece of GLSL to the changes of it worth
trying.

A rule is a function from Code, which is the body of a function, the value of a macro or the condition of an #if, to
Changes. It looks at tokens, so it needs no grammar, and it avoids changes that would not compile: such a mutant proves
nothing about the suite. A rule tries where it cannot know.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from translate.parsing.tokens import NUMBER, SIGN, WORD

# --- Reading GLSL -----------------------------------------------------------------------------------------------

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:\\\n|[^\n])*", re.MULTILINE)
CONDITIONAL = re.compile(r"[ \t]*#[ \t]*(if\w*|el\w+|endif)\b[ \t]*([^\n]*)")
TYPE = re.compile(r"(?:hn_(?:i_)?)?(float|int|uint|bool|[iu]?vec[234]|num[234]?)")  # without its prefix
TOKEN = re.compile(rf"(?P<number>{NUMBER})|(?P<name>{WORD})|(?P<operator>{SIGN}|[^\w\s])")


def blank(text: str) -> str:
    """As many blanks, in as many lines: every offset and line stays."""
    return re.sub(r"[^\n]", " ", text)


def without_comments(source: str) -> str:
    return COMMENT.sub(lambda match: blank(match[0]), source)


def without_cpp(source: str) -> str:
    """Blanks what only C++ sees. The program has its twin compiled in, so a change there is none to it."""
    lines = source.split("\n")
    only_cpp: list[bool] = []  # of each #if around the line
    for i, line in enumerate(lines):
        conditional = CONDITIONAL.match(line)
        is_start = conditional is not None and conditional[1].startswith("if")
        # The text around a conditional stays around it, whether it opens, goes on or closes.
        if any(only_cpp[:-1] if conditional and not is_start else only_cpp):
            lines[i] = blank(line)
        if is_start:
            only_cpp.append(conditional[0].split() == ["#ifdef", "__cplusplus"])
        elif conditional and conditional[1] == "endif":
            only_cpp.pop()
        elif conditional:
            only_cpp[-1] = False
    return "\n".join(lines)


def without_directives(source: str) -> str:
    return DIRECTIVE.sub(lambda match: blank(match[0]), source)


@dataclass(frozen=True)
class Token:
    kind: str  # "number", "name" or "operator"
    text: str
    start: int
    end: int

    def ends_operand(self) -> bool:
        return self.kind == "number" or self.text in (")", "]") or self.kind == "name" and self.text != "return"


NONE = Token("operator", "", 0, 0)  # before the first token, and behind the last


def tokens_of(text: str) -> list[Token]:
    return [Token(match.lastgroup or "", match[0], match.start(), match.end()) for match in TOKEN.finditer(text)]


def variables_of(tokens: Sequence[Token]) -> Iterator[tuple[int, str, str]]:
    """The variables that are declared: the index of the name, the name and the type."""
    for i, (kind, name) in enumerate(zip(tokens, tokens[1:]), 1):
        following = tokens[i + 1].text if i + 1 < len(tokens) else ""
        kind_name = TYPE.fullmatch(kind.text)
        if kind_name and name.kind == "name" and following != "(":
            yield i, name.text, kind_name[1]


@dataclass(frozen=True)
class Code:
    """Code without comments. For a function it is the body; the head, up to the brace, has the parameters."""
    text: str
    head: str = ""

    @cached_property
    def tokens(self) -> list[Token]:
        return tokens_of(self.text)

    def token(self, i: int) -> Token:
        return self.tokens[i] if 0 <= i < len(self.tokens) else NONE

    @cached_property
    def variables(self) -> list[tuple[int, str, str]]:
        """From which token on each can be named, its name and its type."""
        declared = [(0, name, kind) for _, name, kind in variables_of(tokens_of(self.head))]
        for i, name, kind in variables_of(self.tokens):
            end = next((k for k in range(i, len(self.tokens)) if self.tokens[k].text == ";"), i)
            declared.append((end, name, kind))
        return declared

    def is_target(self, i: int) -> bool:
        """Whether the name at token i is declared or assigned to there."""
        following = self.token(i + 1).text
        return bool(TYPE.fullmatch(self.token(i - 1).text)) or following in ASSIGNMENTS

    def type_of(self, i: int) -> str:
        """The type of the variable at token i; empty if it is none, or not known."""
        token = self.token(i)
        if token.kind != "name" or self.token(i - 1).text == ".":
            return ""
        return next((kind for start, name, kind in reversed(self.variables) if name == token.text and start <= i), "")

    def close(self, i: int) -> int:
        """The token that closes the bracket at token i; the last one if none does."""
        depth = 0
        for k in range(i, len(self.tokens)):
            depth += {"(": 1, ")": -1}.get(self.tokens[k].text, 0)
            if depth == 0:
                return k
        return len(self.tokens) - 1

    def arguments(self, i: int) -> list[tuple[int, int]]:
        """The first and the last token of each argument of the call whose "(" is token i."""
        found, first, k, end = [], i + 1, i + 1, self.close(i)
        while k < end:
            if self.tokens[k].text == "(":
                k = self.close(k)
            elif self.tokens[k].text == ",":
                found.append((first, k - 1))
                first = k + 1
            k += 1
        return found + [(first, end - 1)] if end > first else found

    def calls(self) -> Iterator[int]:
        """The tokens that are the name of something called: a function, a constructor or a macro."""
        for i, token in enumerate(self.tokens):
            if token.kind == "name" and self.token(i + 1).text == "(" and token.text not in KEYWORDS:
                yield i


def functions(code: str) -> Iterator[tuple[int, Code]]:
    """The functions of code without directives, each by where its body starts: outermost braces, for the library
    declares no structures."""
    depth = start = head = 0
    for brace in re.finditer(r"[{}]", code):
        if brace[0] == "{" and depth == 0:
            start = brace.end()
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            yield start, Code(code[start:brace.start()], code[head:start - 1])
            head = brace.end()
    if depth != 0:
        raise ValueError("braces do not match; the branches of an #if must each be balanced")


# --- Changes ----------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Change:
    start: int  # in the text
    end: int
    new: str


Rule = Callable[[Code], Iterator[Change]]

KEYWORDS = ("for", "if", "while", "return", "defined")
ASSIGNMENTS = ("=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=")


def replaced(token: Token, new: str) -> Change:
    return Change(token.start, token.end, new)


# --- Constants ---

def other_integers(value: int, is_shift: bool) -> list[int]:
    """Neighbours of a small number; of a large one those with the lowest and with the highest of its bits flipped."""
    if value > 0xFFFF:
        # The highest of its own bits: one above could be masked away wherever the number is a mask.
        return [value ^ 1, value ^ 1 << value.bit_length() - 1]
    highest = 31 if is_shift else 0xFFFFFFFF  # a shift of a whole word is undefined
    return [other for other in (value + 1, value - 1) if 0 <= other <= highest]


def other_float(value: float, in_quotient: bool) -> float:
    """A number near by. A term of a quotient stays an integer; a large one moves so far that no rounding hides it."""
    if in_quotient and abs(value) < 4096:
        return value + 1
    return value + max(abs(value), 1) / 64


def other_literals(digits: str, before: str, after: str) -> list[str]:
    if digits[:2] in ("0x", "0X"):
        return [f"0x{other:0{len(digits) - 2}X}" for other in other_integers(int(digits, 16), before[:2] in SHIFTS)]
    if digits.isdigit():
        return [str(other) for other in other_integers(int(digits), before[:2] in SHIFTS)]
    return [repr(other_float(float(digits), "/" in (before, after)))]


SHIFTS = ("<<", ">>")


def change_constants(code: Code) -> Iterator[Change]:
    for i, token in enumerate(code.tokens):
        if token.kind == "number":
            suffix = token.text[-1] if token.text[-1] in ("uU" if token.text[:2] in ("0x", "0X") else "uUfF") else ""
            digits = token.text.removesuffix(suffix)
            for other in other_literals(digits, code.token(i - 1).text, code.token(i + 1).text):
                yield replaced(token, other + suffix)
        elif token.text in ("true", "false"):
            yield replaced(token, "false" if token.text == "true" else "true")


# --- Operators ---

# With | for a ^ only the bits in common change, with + only their carries: to notice takes more than a few points.
OTHER_OPERATORS = {
    "+": ("-",), "-": ("+",), "*": ("+",), "/": ("*",), "%": ("/",), "&": ("|",), "|": ("&",), "^": ("|", "+"),
    "+=": ("-=", "="), "-=": ("+=", "="), "*=": ("+=", "="), "/=": ("*=", "="), "&=": ("|=", "="),
    "|=": ("&=", "="), "^=": ("|=", "+=", "="), "++": ("--",), "--": ("++",), "&&": ("||",), "||": ("&&",),
}
OTHER_SHIFTS = {"<<": (">>",), ">>": ("<<",), "<<=": (">>=", "="), ">>=": ("<<=", "=")}
OTHER_COMPARISONS = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",),
                     "!=": ("==",)}


def change_by(table: dict[str, tuple[str, ...]], code: Code) -> Iterator[Change]:
    for i, token in enumerate(code.tokens):
        if token.text in ("++", "--") or code.token(i - 1).ends_operand():
            yield from (replaced(token, other) for other in table.get(token.text, ()))


def change_operators(code: Code) -> Iterator[Change]:
    yield from change_by(OTHER_OPERATORS, code)


def change_shifts(code: Code) -> Iterator[Change]:
    yield from change_by(OTHER_SHIFTS, code)


def change_comparisons(code: Code) -> Iterator[Change]:
    yield from change_by(OTHER_COMPARISONS, code)


# --- Signs ---

def change_signs(code: Code) -> Iterator[Change]:
    """Drops each unary minus and "!", and negates the first operand of an expression; elsewhere the operator changes.

    Words have no sign, so only a function's result is negated.
    """
    for i, token in enumerate(code.tokens):
        before, following = code.token(i - 1).text, code.token(i + 1).text
        if token.text in ("-", "!") and not code.token(i - 1).ends_operand():
            yield replaced(token, "")
        kind = "" if code.is_target(i) else code.type_of(i)
        if kind and kind[0] != "u" and before in ("(", ",", "=", "return", "?", ":"):
            yield Change(token.start, token.start, "!" if kind == "bool" else "-")
        elif token.kind == "name" and following == "(" and before in ("=", "return", "?", ":"):
            yield Change(token.start, token.start, "-")


# --- Calls ---

# In the first two arguments.
COMMUTATIVE = ("min", "max", "hn_i_plus", "hn_i_times", "hn_i_multiply_add", "hn_i_weight_times", "hn_i_wide_plus",
               "hn_i_wide_times")


def is_condition(code: Code, first: int, last: int) -> bool:
    """Whether an expression compares, outside of brackets."""
    depth = 0
    for token in code.tokens[first:last + 1]:
        depth += {"(": 1, ")": -1}.get(token.text, 0)
        if depth == 0 and (token.text in OTHER_COMPARISONS or token.text in ("&&", "||")):
            return True
    return False


def kind_of(code: Code, first: int, last: int) -> str:
    """The type of an expression, by its first operand; empty if that leaves it open."""
    if is_condition(code, first, last):
        return "bool"
    while code.token(first).text == "(":
        first += 1
    token, following = code.token(first), code.token(first + 1).text
    if token.kind == "number":
        return {"u": "uint", "f": "float"}.get(token.text[-1].lower(), "int")
    if following == "(":
        return token.text if TYPE.fullmatch(token.text) else ""
    kind = code.type_of(first)
    if following == "." and first < last:
        return {"i": "int", "u": "uint", "n": "num"}.get(kind[:1], "float") if kind else ""
    return kind


def swap_arguments(code: Code) -> Iterator[Change]:
    """Swaps adjacent arguments, unless they are alike, or of different types, or it does not matter."""
    for i in code.calls():
        name = code.token(i).text
        arguments = code.arguments(i + 1)[name in COMMUTATIVE:]
        for (first, first_end), (second, second_end) in zip(arguments, arguments[1:]):
            start, end = code.token(first).start, code.token(second_end).end
            one = code.text[start:code.token(first_end).end]
            gap = code.text[code.token(first_end).end:code.token(second).start]
            other = code.text[code.token(second).start:end]
            kinds = kind_of(code, first, first_end), kind_of(code, second, second_end)
            # The type that a function returns is not known. A constructor most likely gets it beside numbers, which it
            # is, too.
            same = kinds[0] == kinds[1] or "" in kinds and bool(TYPE.fullmatch(name) or name == "hn_i_vector")
            if one != other and same:
                yield Change(start, end, other + gap + one)


OTHER_FUNCTIONS = {
    "min": ("max",), "max": ("min",), "floor": ("ceil", "trunc"),
    "hn_hash_fnv1": ("hn_hash_partial_fnv1",), "hn_hash_partial_fnv1": ("hn_hash_fnv1",),
    "hn_hash_jenkins": ("hn_hash_partial_jenkins",), "hn_hash_partial_jenkins": ("hn_hash_jenkins",),
    "hn_hash_murmur": ("hn_hash_pcg",), "hn_hash_pcg": ("hn_hash_xxhash32",), "hn_hash_xxhash32": ("hn_hash_murmur",),
    "hn_gradient2": ("hn_gradient3",), "hn_gradient3": ("hn_gradient2",),
    "hn_i_plus": ("hn_i_minus",), "hn_i_minus": ("hn_i_plus",),
    "hn_i_scaled2": ("hn_i_scaled3",), "hn_i_scaled3": ("hn_i_scaled2",),
}
# Functions that return their argument's type, so that it may stand for them.
STEPS = ("abs", "floor", "trunc", "hn_i_scramble", "hn_i_hash", "hn_i_spread", "hn_i_high", "hn_i_odd", "hn_i_wrap",
         "hn_i_next", "hn_hash", "hn_i_to_num", "hn_i_minus_one", "hn_i_density", "hn_i_excess_bits")


def change_calls(code: Code) -> Iterator[Change]:
    """Calls another function of the same kind, or none."""
    for i in code.calls():
        token = code.token(i)
        yield from (replaced(token, other) for other in OTHER_FUNCTIONS.get(token.text, ()))
        if token.text in STEPS and len(code.arguments(i + 1)) == 1:
            yield replaced(token, "")


# --- Names ---

OTHER_COMPONENTS = {"x": "y", "y": "x", "z": "x", "w": "x"}


def change_components(code: Code) -> Iterator[Change]:
    for i, token in enumerate(code.tokens):
        if code.token(i - 1).text == "." and token.text in OTHER_COMPONENTS:
            yield replaced(token, OTHER_COMPONENTS[token.text])


def change_variables(code: Code) -> Iterator[Change]:
    """Takes another variable of the same type: the one declared before it, or else the next."""
    for i, token in enumerate(code.tokens):
        kind = code.type_of(i)
        if not kind or code.is_target(i):
            continue
        alike = [name for start, name, other in code.variables if other == kind and start <= i]
        if len(alike) > 1:
            at = alike.index(token.text)
            yield replaced(token, alike[at - 1 if at > 0 else 1])


# --- Statements ---

def drop_statements(code: Code) -> Iterator[Change]:
    """Drops assignments, also those to a component or a member. Without a declaration or a return nothing would
    compile."""
    for i, token in enumerate(code.tokens):
        starts = code.token(i - 1).text in ("", ";", "{", "}")
        behind = code.token(i + 3 if code.token(i + 1).text == "." else i + 1).text
        if starts and token.kind == "name" and behind in ASSIGNMENTS:
            end = next(k for k in range(i, len(code.tokens)) if code.tokens[k].text == ";")
            yield Change(token.start, code.token(end).end, "")


RULES: dict[str, Rule] = {
    "constant": change_constants, "operator": change_operators, "shift": change_shifts,
    "comparison": change_comparisons, "sign": change_signs, "argument": swap_arguments, "call": change_calls,
    "component": change_components, "variable": change_variables, "statement": drop_statements,
}

# --- The preprocessor ---

MACRO = re.compile(r"(?P<keyword>[ \t]*#[ \t]*define[ \t]+)(?P<name>\w+(?:\([^)]*\))?)(?P<value>[^\n]*)")
CONDITION = re.compile(r"[ \t]*#[ \t]*(?:el)?if\b")
OTHER_KEYWORDS = {"ifdef": "ifndef", "ifndef": "ifdef"}
# Values of macros: the numbers of the knobs, each with the next, and a precision.
OTHER_VALUES = {"HN_HASH_" + one: "HN_HASH_" + other for one, other in zip(
    ("FNV1", "PARTIAL_FNV1", "JENKINS", "PARTIAL_JENKINS", "MURMUR", "PCG", "XXHASH32", "LATTICE", "CUSTOM"),
    ("PARTIAL_FNV1", "JENKINS", "PARTIAL_JENKINS", "MURMUR", "PCG", "XXHASH32", "LATTICE", "CUSTOM", "FNV1"))}
OTHER_VALUES |= {"HN_GRADIENT_OCTAHEDRAL": "HN_GRADIENT_SINE", "HN_GRADIENT_SINE": "HN_GRADIENT_OCTAHEDRAL",
                 "highp": "mediump"}


def change_directive(line: str) -> Iterator[Change]:
    """The argument of an #include, #define or #error; the condition of an #if. The line has no comment."""
    keyword = line.split("#")[1].split()[0]
    macro, condition = MACRO.match(line), CONDITION.match(line)
    if keyword in ("include", "define", "error"):
        yield Change(len(line) - len(line.lstrip()), len(line), "")
    if keyword in OTHER_KEYWORDS:
        start = line.index(keyword)
        yield Change(start, start + len(keyword), OTHER_KEYWORDS[keyword])
    if not macro and not condition:
        return
    start = macro.start("value") if macro else condition.end()
    code = Code(line[start:])
    for change in change_expression(code, is_condition=not macro):
        yield Change(start + change.start, start + change.end, change.new)


def change_expression(code: Code, is_condition: bool) -> Iterator[Change]:
    for rule in (change_constants, change_operators, change_shifts, change_comparisons):
        yield from rule(code)
    for i, token in enumerate(code.tokens):
        if token.text in OTHER_VALUES:
            yield replaced(token, OTHER_VALUES[token.text])
        if token.text == "!":
            yield replaced(token, "")
        if token.text == "defined" and code.token(i - 1).text != "!" or is_condition and len(code.tokens) == 1:
            yield Change(token.start, token.start, "!")


def changes(source: str) -> Iterator[tuple[str, Change]]:
    """Every change of a file with the name of its rule: function by function, then the directives."""
    seen = without_cpp(without_comments(source))
    for start, function in functions(without_directives(seen)):
        for name, rule in RULES.items():
            for change in rule(function):
                yield name, Change(start + change.start, start + change.end, change.new)
    for line in DIRECTIVE.finditer(seen):
        for change in change_directive(line[0].rstrip()):
            yield "directive", Change(line.start() + change.start, line.start() + change.end, change.new)
