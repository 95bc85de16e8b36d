"""A module of WGSL, made of the text of the library."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from translate.library import Key, Library
from translate.names import is_passed, is_public, wgsl_name
from translate.parsing.preprocessor import Constant, Preprocessor
from translate.parsing.syntax import Call, Function, Name, Number, Return, Struct, definitions
from translate.parsing.tokens import Unknown
from translate.settings import NO_PRECISE, Settings
from translate.wgsl.writer import LANGUAGE, Definition, FunctionWriter

# Sentences of comments on overloads, which WGSL does not have.
LEFT_OUT = "; 0 if left out"


class Module:
    """The definitions of a text, which may include files of the library. Each is translated when it is first used."""

    def __init__(self, library: Path, text: str, settings: Settings = Settings(), path: str = "the text",
                 writer: type[FunctionWriter] = FunctionWriter):
        self._writer = writer
        preprocessor = Preprocessor(library, settings.macros())
        preprocessor.read(text, path)
        if preprocessor.stands_for("HN_ARITHMETIC", "HN_PRECISE"):
            raise Unknown(NO_PRECISE)
        self.library = Library(definitions(preprocessor.items), preprocessor.constants, settings.own_functions())
        for function in self.library.functions.values():
            if seeded := self.library.seeded(function):
                _check_seedless(function, seeded)
        # By name, constants first.
        self.items: dict[str, Constant | Struct | Function] = dict(self.library.constants)
        names = {id(function): name for name, function in self.library.named.items()}
        for item in self.library.tree:
            name = item.name if isinstance(item, Struct) else names.get(id(item))
            if name:
                self.items[name] = item
        self._definitions: dict[str, Definition] = {}

    def names(self) -> dict[Key, str]:
        """The name in WGSL of each function; one without a seed has the name of that with one."""
        return {key: wgsl_name(self.library.seeded(function) or function)
                for key, function in self.library.functions.items()}

    def public(self) -> list[str]:
        """The names of what users call or pass."""
        return [name for name, item in self.items.items()
                if (is_passed(name) if isinstance(item, Constant) else isinstance(item, Function) and is_public(item.name))]

    def all_but_constants(self) -> list[str]:
        return [name for name, item in self.items.items() if not isinstance(item, Constant)]

    def definition(self, name: str) -> Definition:
        if name not in self._definitions:
            item = self.items[name]
            if isinstance(item, Constant):
                made = self._writer(self.library).constant(name)
            else:
                made = self._struct(item) if isinstance(item, Struct) else self._writer(self.library, item).definition()
            self._definitions[name] = made
        return self._definitions[name]

    def _struct(self, struct: Struct) -> Definition:
        lines, needs = [f"struct {struct.name} {{"], []
        for name, type_, comments in struct.fields:
            lines += [f"  {line}" for line in comments.before if line]
            field = LANGUAGE.pair(LANGUAGE.field_name(name), LANGUAGE.type(type_))
            lines.append(f"  {field},{comments.after and f'  {comments.after}'}")
            needs += [type_] * (type_ in self.library.structs)
        return Definition(struct.name, struct.comments.before, [*lines, "}"], needs)

    def definitions(self) -> list[Definition]:
        """Public functions, and all that they need. A file without a public function is there as a whole."""
        return self._definitions_of(self.public() or self.all_but_constants())

    def _definitions_of(self, names: Iterable[str]) -> list[Definition]:
        needed: set[str] = set()
        pending = list(names)
        while pending:
            name = pending.pop()
            if name not in self.items:
                raise Unknown(f"there is no {name} in this module")
            if name not in needed:
                needed.add(name)
                pending += self.definition(name).needs
        return [self.definition(name) for name in self.items if name in needed]

    def text(self, only: Iterable[str] = (), strip: bool = False) -> str:
        """The module, or its part that these functions need."""
        return "".join(self.pieces(only, strip))

    def pieces(self, only: Iterable[str] = (), strip: bool = False) -> list[str]:
        """The texts of the definitions, in the order of the library."""
        definitions = self._definitions_of(only) if only else self.definitions()
        return [_text(definition, previous, strip) for previous, definition in zip([None, *definitions], definitions)]


def _text(definition: Definition, previous: Definition | None, strip: bool) -> str:
    if strip:
        lines = [code for line in definition.lines if (code := line.partition("//")[0].strip())]
    else:
        comments: list[str] = []
        for line in definition.comments:
            if line or (comments and comments[-1]):
                comments.append(line.replace(LEFT_OUT, ""))
        short = previous is not None and not comments and len(definition.lines) == len(previous.lines) == 1
        joined = previous is None or (short and previous.is_constant == definition.is_constant)
        lines = [*([] if joined else [""]), *comments, *definition.lines]
    return "\n".join(lines) + "\n"


def _check_seedless(function: Function, seeded: Function) -> None:
    """Whether it calls the one with a seed with the seed 0, and does nothing else."""
    body = function.body.statements
    call = body[0].value if len(body) == 1 and isinstance(body[0], Return) else None
    passed = [argument.at.text if isinstance(argument, (Name, Number)) else None
              for argument in (call.arguments if isinstance(call, Call) else ())]
    expected = [parameter.at.text for parameter in seeded.parameters]
    expected[expected.index("seed")] = "0u"
    if passed != expected or call.at.text != function.name:
        raise function.at.error(f"{function.name} without a seed must be {function.name} with the seed 0u")
