"""A module of WGSL, made of the text of the library."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from translate.parsing.preprocessor import Preprocessor
from translate.parsing.syntax import Function, Parser
from translate.parsing.tokens import Unknown, tokens_of
from translate.wgsl.translator import Definition, Translator

HASHES = ("FNV1", "PARTIAL_FNV1", "JENKINS", "PARTIAL_JENKINS", "MURMUR", "PCG", "XXHASH32", "LATTICE", "CUSTOM")
GRADIENTS = ("OCTAHEDRAL", "SINE")
ARITHMETICS = ("HN_FAST", "HN_FIXED")
NO_PRECISE = ("HN_PRECISE is not possible in WGSL, which has no precise: a compiler may join or reorder operations on "
              "floats. Take HN_FIXED, whose bits are the same everywhere")
# What a comment says about overloads that WGSL does not have.
LEFT_OUT = "; 0 if left out"


@dataclass(frozen=True)
class Settings:
    """The knobs."""
    arithmetic: str = "HN_FAST"
    hash: str = "LATTICE"
    gradient: str = "OCTAHEDRAL"
    hash_function: str = ""  # with CUSTOM: the name of the user's function, which takes and returns a u32

    def macros(self) -> dict[str, str]:
        if self == NO_SETTINGS:
            return {}
        if (self.hash == "CUSTOM") != bool(self.hash_function):
            raise Unknown("the hash CUSTOM and the name of your own belong together: "
                          "--hash CUSTOM --hash-function my_hash")
        macros = {"HN_ARITHMETIC": self.arithmetic, "HN_HASH": f"HN_HASH_{self.hash}",
                  "HN_GRADIENT": f"HN_GRADIENT_{self.gradient}"}
        return macros | ({"HN_HASH_FN(k)": f"{self.hash_function}(k)"} if self.hash_function else {})

    def own_functions(self) -> list[Function]:
        """The user's, which the text calls."""
        if not self.hash_function:
            return []
        return Parser(list(tokens_of(f"uint {self.hash_function}(uint k) {{ return k; }}", "the options", 1))).parse()

    def __str__(self) -> str:
        return f"{self.arithmetic}, HN_HASH_{self.hash} and HN_GRADIENT_{self.gradient}"


NO_SETTINGS = Settings("", "", "")


class Module:
    """The definitions of a text, which may include files of the library."""

    def __init__(self, library: Path, text: str, settings: Settings = Settings(), path: str = "the text"):
        preprocessor = Preprocessor(library, settings.macros())
        preprocessor.read(text, path)
        if preprocessor.stands_for("HN_ARITHMETIC", "HN_PRECISE"):
            raise Unknown(NO_PRECISE)
        self.translator = Translator(Parser(preprocessor.tokens).parse(), preprocessor.constants,
                                     settings.own_functions())

    def names(self) -> dict[tuple[str, tuple[str, ...]], str]:
        """The name in WGSL of each function, by its name in GLSL and the types of its parameters."""
        return self.translator.names()

    def definitions(self) -> list[Definition]:
        """Of public functions, and of all that they need. A file without a public function is there as a whole."""
        return self._definitions_of(self.translator.public() or self.translator.all_but_constants())

    def _definitions_of(self, names: Iterable[str]) -> list[Definition]:
        needed = self.translator.needed_by(names)
        return [self.translator.definition(name) for name in self.translator.items if name in needed]

    def text(self, only: Iterable[str] = (), strip: bool = False) -> str:
        """The module, or what these functions of it need."""
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
