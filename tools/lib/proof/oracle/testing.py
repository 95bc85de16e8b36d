"""The common parts of the oracle's tests: positions, and difference quotients."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
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


def moved(p: Sequence[Fraction], axis: int, step: Fraction) -> list[Fraction]:
    return [x + step * (i == axis) for i, x in enumerate(p)]


def quotient(f: Callable[[Fraction], Fraction], step: Fraction = Fraction(1, 2**26)) -> Fraction:
    """The slope of f at 0: the limit of the exact difference quotients, but for the fourth power of the step."""
    def central(h: Fraction) -> Fraction:
        return (f(h) - f(-h)) / (2 * h)

    return (4 * central(step) - central(2 * step)) / 3
