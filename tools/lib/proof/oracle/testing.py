"""The common parts of the oracle's tests."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from proof.golden.generator import generator_of
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT

KNOBS = Knobs("lattice")
FORMS = ("exact", "fixed")  # the two arithmetics, by the names of a noise's methods

Place = tuple[list[Fraction], int]


def places(name: str, n: int, count: int, size: int = 64) -> Iterator[Place]:
    """Positions that fixed arithmetic does not cut, and seeds."""
    numbers = generator_of(f"{name}{n}")
    for _ in range(count):
        yield [Fraction(numbers.integer(-size * UNIT, size * UNIT), UNIT) for _ in range(n)], numbers.word()
