"""A text of the library as its functions, structs and constants, and the forms by which users ask for its functions."""

from __future__ import annotations

import functools

from translate.names import is_public, wgsl_name
from translate.parsing.preprocessor import Constant
from translate.parsing.syntax import Expression, Function, Parser, Struct
from translate.parsing.tokens import Token

Key = tuple[str, tuple[str, ...]]  # of a function: its name, and the types of its parameters


class Library:
    """`own` are functions of the user's, which the text calls."""

    def __init__(self, tree: list[Function | Struct], constants: dict[str, Constant], own: list[Function]):
        self.tree = tree
        self.constants = constants
        self.own = {(function.name, function.types): function for function in own}
        self.structs = {item.name: item for item in tree if isinstance(item, Struct)}
        self.functions: dict[Key, Function] = {}
        for item in tree:
            if isinstance(item, Function):
                known = self.own.get((item.name, item.types)) or self.functions.setdefault((item.name, item.types), item)
                if known is not item:
                    raise item.at.error(f"{item.name} is there already, in {known.at.path}:{known.at.line}")
        self._trees: dict[str, Expression] = {}

    def constant(self, name: str) -> Expression:
        if name not in self._trees:
            self._trees[name] = Parser(list(self.constants[name].body)).expression()
        return self._trees[name]

    def function(self, at: Token, types: tuple[str, ...]) -> Function:
        function = self.functions.get((at.text, types))
        if function is None:
            overloads = [", ".join(other) for name, other in self.functions if name == at.text]
            known = f"; there are ({'), ('.join(overloads)})" if overloads else ""
            raise at.error(f"there is no function {at.text}({', '.join(types)}){known}")
        return function

    @functools.cached_property
    def seeded(self) -> dict[Key, Key]:
        """The overload with a seed of each public function without one that has it."""
        found = {}
        for (name, types), function in self.functions.items():
            ins = [parameter.type for parameter in function.parameters if not parameter.is_set]
            key = (name, (*ins, "uint", *(parameter.type for parameter in function.parameters if parameter.is_set)))
            other = self.functions.get(key)
            if is_public(name) and other and other.parameters[len(ins)].at.text == "seed" and not any(
                    parameter.at.text == "seed" for parameter in function.parameters):
                found[name, types] = key
        return found

    @functools.cached_property
    def named(self) -> dict[str, Function]:
        """The functions by their names in WGSL. One without a seed has no name of its own."""
        found: dict[str, Function] = {}
        for key, function in self.functions.items():
            if key not in self.seeded:
                other = found.setdefault(wgsl_name(function), function)
                if other is not function:
                    raise function.at.error(f"{wgsl_name(function)} is the name of another function in WGSL, too: that of "
                                            f"{other.at.path}:{other.at.line}. tools/lib/translate/names.py has the rule")
        return found

    @functools.cached_property
    def forms(self) -> dict[str, Function]:
        """The public functions."""
        return {name: function for name, function in self.named.items() if is_public(function.name)}
