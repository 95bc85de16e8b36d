"""Calls of picked functions in shading languages, for tests: they read the words of arguments from `inputs`;
a point's begin `at`, and write the words of results to `outputs`, from `to` on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from translate.parsing.syntax import Function
from translate.pick.evaluate import Module
from translate.pick.printer import Language


@dataclass(frozen=True)
class Form:
    """A language's syntax for it. {} stands for a word, or for what becomes one."""
    language: Language
    read: Mapping[str, str]
    write: Mapping[str, str]
    declare: str = "{type} {name}{value};"
    struct: str = "{{{fields}}}"
    passed: str = "{}"  # the function's outputs
    result: str = "{type} result = "

    def call(self, module: Module, function: Function) -> tuple[list[str], int, int]:
        """The lines, and how many words there are in and out. The module is split: a vector is its components."""
        count = 0
        lines: list[str] = []
        arguments: list[str] = []
        outputs: list[str] = []

        def made(type_: str) -> str:
            nonlocal count
            if type_ in module.structs:
                fields = ", ".join(made(of_field) for _, of_field, _ in module.structs[type_].fields)
                return self.struct.format(type=type_, fields=fields)
            parts: list[str] = []
            for _, scalar in module.parts(type_):
                parts.append(self.read[scalar].format(f"inputs[at + {count}u]"))
                count += 1
            return parts[0] if len(parts) == 1 else f"{self.language.named(type_)}({', '.join(parts)})"

        for i, parameter in enumerate(function.parameters):
            value = f" = {made(parameter.type)}" if module.passed(parameter) else ""
            lines.append(self.declare.format(type=self.language.type(parameter.type), name=f"v{i}", value=value))
            arguments.append(self.passed.format(f"v{i}") if parameter.is_set else f"v{i}")
            outputs += self._written(module, f"v{i}", parameter.type) if parameter.is_set else []
        call = f"{self.language.public_name(function)}({', '.join(arguments)});"
        if function.type == "void":
            lines.append(call)
        else:
            lines.append(self.result.format(type=self.language.type(function.type)) + call)
            outputs = [*self._written(module, "result", function.type), *outputs]
        lines += [f"outputs[to + {i}u] = {value};" for i, value in enumerate(outputs)]
        return lines, count, len(outputs)

    def _written(self, module: Module, name: str, type_: str) -> Sequence[str]:
        return [self.write[scalar].format(".".join((name, *(part.removeprefix("_") for part in path))))
                for path, scalar in module.parts(type_)]
