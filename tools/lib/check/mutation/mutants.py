"""The mutants of the library: copies of it with one change in one place."""

from __future__ import annotations

import random
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from check.mutation import rules

Sources = dict[str, str]  # the text of each file of the library, by its name


@dataclass(frozen=True)
class Mutant:
    number: int
    file: str
    rule: str
    original: str  # the whole file
    start: int  # the change
    end: int
    new: str

    @property
    def old(self) -> str:
        return self.original[self.start:self.end]

    @property
    def source(self) -> str:
        """The whole file, changed."""
        return self.original[:self.start] + self.new + self.original[self.end:]

    @property
    def line(self) -> int:
        return self.original.count("\n", 0, self.start) + 1

    def __str__(self) -> str:
        where = f"{self.file}:{self.line}:{self.start - self.original.rfind(chr(10), 0, self.start)}"
        return f"{self.number:4}  {where:<20}  {self.change()}"

    def change(self) -> str:
        """In one line. An insertion is shown before the word that follows it."""
        old, new = " ".join(self.old.split()), " ".join(self.new.split())
        if not old:
            word = re.match(r"\w*", self.original[self.end:])
            old, new = word[0], new + word[0]
        return f"{old} -> {new or 'nothing'}"


def all_mutants(sources: Sources) -> list[Mutant]:
    return _mutants_of(tuple(sorted(sources.items())))


@cache  # making them takes longer than all else that a test of this command does
def _mutants_of(sources: tuple[tuple[str, str], ...]) -> list[Mutant]:
    found = ((file, source, rule, change) for file, source in sources
             for rule, change in rules.changes(source))
    return [Mutant(number, file, rule, source, change.start, change.end, change.new)
            for number, (file, source, rule, change) in enumerate(found, 1)]


def sample(mutants: Sequence[Mutant], count: int, seed: int) -> list[Mutant]:
    """One from each of `count` equal parts, so that no file and no function is missed by chance."""
    count = min(count, len(mutants))
    generator = random.Random(seed)
    return [mutants[generator.randrange(i * len(mutants) // count, (i + 1) * len(mutants) // count)]
            for i in range(count)]
