"""The settings of the knobs under test, and which functions have values with each: catalog/configurations.toml."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from catalog.model import CATALOG, CatalogError, Entry, tables

if TYPE_CHECKING:
    from catalog.tables.functions import Function

FILE = "configurations.toml"
GRADIENTS = ("octahedral", "sine")
ARITHMETICS = ("fast", "precise", "fixed")
DEFAULT_HASH = "lattice"


@functools.cache
def families() -> tuple[str, ...]:
    return tuple(tables(CATALOG, FILE)["families"])


@dataclass(frozen=True)
class Configuration:
    """A setting. Words are in lower case: `lattice` for HN_HASH_LATTICE."""
    hash: str
    gradient: str
    arithmetic: str
    families: tuple[str, ...]
    further: tuple[str, ...] = ()  # ids of functions that have values with it besides

    @property
    def name(self) -> str:
        """As in golden files: the hash, and what differs from the default."""
        parts = [self.hash, *["sine"] * (self.gradient == "sine"), *[self.arithmetic] * (self.arithmetic != "fast")]
        return "+".join(parts)

    @property
    def macros(self) -> list[str]:
        """The definitions of what differs from the default."""
        defined = {f"HN_HASH=HN_HASH_{self.hash.upper()}": self.hash != DEFAULT_HASH,
                   f"HN_GRADIENT=HN_GRADIENT_{self.gradient.upper()}": self.gradient != "octahedral",
                   f"HN_ARITHMETIC=HN_{self.arithmetic.upper()}": self.arithmetic != "fast"}
        return [macro for macro, differs in defined.items() if differs]

    @property
    def fixed(self) -> bool:
        return self.arithmetic == "fixed"

    @property
    def has_golden_values(self) -> bool:
        """HN_PRECISE has none: it has the exact values of HN_FAST."""
        return self.arithmetic != "precise"

    def covers(self, function: Function) -> bool:
        return function.family in self.families or function.id in self.further


def _some(entry: Entry, key: str, names: tuple[str, ...], *default: Any) -> tuple[str, ...]:
    some = tuple(entry.take(key, list, *default))
    for name in some:
        if name not in names:
            raise CatalogError(f"{entry.where}: {key} has {name!r}, which is none of {', '.join(names)}")
    return some


def _group(name: str, keys: Any, families: tuple[str, ...], further: dict[str, tuple[str, ...]]) -> Iterator[Configuration]:
    entry = Entry(FILE, name, keys)
    gradient, arithmetics = entry.one_of("gradient", GRADIENTS), _some(entry, "arithmetics", ARITHMETICS)
    hashes, of_each = entry.take("hashes", list), _some(entry, "families", families)
    left_out = _some(entry, "all_but", families, families)
    default = {*of_each, *_some(entry, "default", families, ()), *{*families} - {*left_out}}
    entry.end()
    for arithmetic in arithmetics:
        for hash_ in hashes:
            made = Configuration(hash_, gradient, arithmetic, tuple(
                family for family in families if family in (default if hash_ == DEFAULT_HASH else of_each)))
            yield replace(made, further=further.pop(made.name, ()))


@functools.cache
def _read(folder: Path) -> tuple[Configuration, ...]:
    groups = tables(folder, FILE)
    families = tuple(groups.pop("families"))
    further = {name: tuple(id_ for ids in of.values() for id_ in ids) for name, of in groups.pop("further", {}).items()}
    found = [configuration for name, keys in groups.items() for configuration in _group(name, keys, families, further)]
    if further:
        raise CatalogError(f"catalog/{FILE}: further has {min(further)}, which is no configuration")
    return tuple(sorted(found, key=lambda one: ARITHMETICS.index(one.arithmetic)))


def read_configurations(folder: Path = CATALOG) -> list[Configuration]:
    return list(_read(folder))
