"""A text of the library as its functions, structs and constants, and the forms by which users ask for its functions."""

from __future__ import annotations

import functools

from translate.names import is_public, wgsl_name
from translate.parsing.preprocessor import Constant
from translate.parsing.syntax import Expression, Function, Parser, Struct
from translate.parsing.tokens import Token

Key = tuple[str, tuple[str, ...]]  # of a function: its name, and the types of its parameters


class Library:
    """`own` are functions of the user's, which the text calls. A function is read when it is first used, which is
    seldom where only few are picked."""

    def __init__(self, tree: list[Function | Struct], constants: dict[str, Constant], own: list[Function]):
        self.tree = tree
        self.constants = constants
        self.own = {(function.name, function.types): function for function in own}
        self.structs = {item.name: item for item in tree if isinstance(item, Struct)}
        self._by_name: dict[str, list[Function]] = {}
        for item in tree:
            if isinstance(item, Function):
                self._by_name.setdefault(item.name, []).append(item)
        self._found: dict[Key, Function | None] = {}
        self._trees: dict[str, Expression] = {}

    @functools.cached_property
    def functions(self) -> dict[Key, Function]:
        found: dict[Key, Function] = {}
        for item in self.tree:
            if isinstance(item, Function):
                key = (item.name, item.types)
                known = self.own.get(key) or found.setdefault(key, item)
                if known is not item:
                    raise item.at.error(f"{item.name} is there already, in {known.at.path}:{known.at.line}")
        return found

    def overload(self, name: str, types: tuple[str, ...]) -> Function | None:
        key = (name, types)
        if key not in self._found:
            self._found[key] = next((one for one in self._by_name.get(name, ()) if one.types == types), None)
        return self._found[key]

    def constant(self, name: str) -> Expression:
        if name not in self._trees:
            self._trees[name] = Parser(list(self.constants[name].body)).expression()
        return self._trees[name]

    def function(self, at: Token, types: tuple[str, ...]) -> Function:
        function = self.overload(at.text, types)
        if function is None:
            overloads = [", ".join(other.types) for other in self._by_name.get(at.text, ())]
            known = f"; there are ({'), ('.join(overloads)})" if overloads else ""
            raise at.error(f"there is no function {at.text}({', '.join(types)}){known}")
        return function

    def seeded(self, function: Function) -> Function | None:
        """The overload that has a seed, for a public function without one."""
        if not is_public(function.name) or any(one.at.text == "seed" for one in function.parameters):
            return None
        ins, outs = ([one.type for one in function.parameters if one.is_set == is_set] for is_set in (False, True))
        other = self.overload(function.name, (*ins, "uint", *outs))
        return other if other and other.parameters[len(ins)].at.text == "seed" else None

    @functools.cached_property
    def named(self) -> dict[str, Function]:
        """The functions by their names in WGSL. One without a seed has no name of its own."""
        found: dict[str, Function] = {}
        for function in self.functions.values():
            if self.seeded(function) is None:
                other = found.setdefault(wgsl_name(function), function)
                if other is not function:
                    raise function.at.error(f"{wgsl_name(function)} is the name of another function in WGSL, too: that of "
                                            f"{other.at.path}:{other.at.line}. tools/lib/translate/names.py has the rule")
        return found

    @functools.cached_property
    def forms(self) -> dict[str, Function]:
        return {name: function for name, function in self.named.items() if is_public(function.name)}

    def form(self, name: str) -> Function | None:
        """One of them. Its name begins as the library calls it."""
        return next((one for called, overloads in self._by_name.items() if is_public(called) and name.startswith(called)
                     for one in overloads if wgsl_name(one) == name and self.seeded(one) is None), None)
