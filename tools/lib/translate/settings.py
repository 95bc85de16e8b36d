"""The knobs of the library, as users choose them."""

from __future__ import annotations

from dataclasses import dataclass

from translate.parsing.syntax import Function, Parser
from translate.parsing.tokens import Unknown, tokens_of

HASHES = ("FNV1", "PARTIAL_FNV1", "JENKINS", "PARTIAL_JENKINS", "MURMUR", "PCG", "XXHASH32", "LATTICE", "CUSTOM")
GRADIENTS = ("OCTAHEDRAL", "SINE")
ARITHMETICS = ("HN_FAST", "HN_FIXED")
NO_PRECISE = ("HN_PRECISE is not possible in WGSL, which has no precise: a compiler may join or reorder operations on "
              "floats. Take HN_FIXED (--arithmetic fixed), whose bits are the same everywhere")


@dataclass(frozen=True)
class Settings:
    arithmetic: str = "HN_FAST"
    hash: str = "LATTICE"
    gradient: str = "OCTAHEDRAL"
    hash_function: str = ""  # with CUSTOM: the name of the user's function, which takes and returns a u32

    def macros(self) -> dict[str, str]:
        if self == NO_SETTINGS:
            return {}
        if (self.hash == "CUSTOM") != bool(self.hash_function):
            raise Unknown("the hash custom and the name of your function belong together: "
                          "--hash custom --hash-function my_hash")
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


def settings_of(arithmetic: str, hash_: str, gradient: str, hash_function: str = "") -> Settings:
    """By the words that the options take."""
    return Settings(f"HN_{arithmetic.upper()}", hash_.upper(), gradient.upper(), hash_function)
