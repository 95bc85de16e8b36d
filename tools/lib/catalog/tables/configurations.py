"""The settings of the knobs under test, and which functions have values with each: configurations.inc."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from base.tree import CONFIGURATIONS
from catalog.tables.functions import FAMILIES, Function
from catalog.tables.inc import Row, read_rows

GRADIENTS = ("octahedral", "sine")
ARITHMETICS = ("fast", "precise", "fixed")


@dataclass(frozen=True)
class Configuration:
    """A row of the table. Words are in lower case: `lattice` for HN_HASH_LATTICE."""
    row: Row
    name: str
    hash: str
    gradient: str
    arithmetic: str
    families: tuple[str, ...]
    further: tuple[str, ...] = ()  # ids of functions that have values with it besides

    @property
    def fixed(self) -> bool:
        return self.arithmetic == "fixed"

    @property
    def has_golden_values(self) -> bool:
        """Of its own: HN_PRECISE has the exact values of HN_FAST."""
        return self.arithmetic != "precise"

    def covers(self, function: Function) -> bool:
        return function.family in self.families or function.id in self.further


def _one_of(row: Row, index: int, choices: tuple[str, ...]) -> str:
    word = row.word(index).lower()
    if word not in choices:
        raise row.error(f"{row.word(index)} is none of {', '.join(choices).upper()}")
    return word


def _configuration(row: Row) -> Configuration:
    families = tuple(family.strip() for family in row.arguments[4].split("|"))
    for family in families:
        if family not in FAMILIES:
            raise row.error(f"{family} is not a family; there are {', '.join(FAMILIES)}")
    configuration = Configuration(row, row.text(0), row.word(1).lower(), _one_of(row, 2, GRADIENTS),
                                  _one_of(row, 3, ARITHMETICS), families)
    name = configuration.hash + "+sine" * (configuration.gradient == "sine")
    name += f"+{configuration.arithmetic}" * (configuration.arithmetic != "fast")
    if configuration.name != name:
        raise row.error(f"{configuration.name} should be {name}, after its settings")
    return configuration


def read_configurations(path: Path = CONFIGURATIONS) -> list[Configuration]:
    configurations = [_configuration(row) for row in read_rows(path, "CONFIGURATION", 5, frozenset({"VALUES"}))]
    further = read_further(path)
    return [replace(configuration, further=tuple(row.text(1) for row in further if row.text(0) == configuration.name))
            for configuration in configurations]


def read_further(path: Path = CONFIGURATIONS) -> list[Row]:
    """The rows of VALUES: a configuration, and a function that has values with it besides those of its families."""
    return read_rows(path, "VALUES", 2, frozenset({"CONFIGURATION"}), at_least=0)
