"""The common parts of the oracle's tests."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from catalog.model import read
from proof.golden.generator import generator_of, to_f32
from proof.oracle.gradients import Knobs
from proof.oracle.integers import UNIT

KNOBS = Knobs("lattice")
FORMS = ("exact", "fixed")  # the two arithmetics, by the names of a noise's methods
METRICS = tuple(range(1, len(read().metrics) + 1))
# Whole turns and quarters, numbers that are cut off, the step of 2^-30 and the end of a turn, and phases far from 0.
PHASES = tuple(map(to_f32, (
    0.0, -0.0, 0.25, 0.5, 0.75, 1.0, -0.25, -0.5, -1.0, 1 / 3, -1 / 3, 0.125, 2.0**-30, -2.0**-30, 2.0**-31, -2.0**-31,
    3 * 2.0**-31, 1e-40, 1 - 2.0**-24, -1 + 2.0**-24, 0.25 - 2.0**-26, 1000.125, -1000.125, 2.0**21 + 0.25,
    2.0**23 - 0.5, 2.0**24, -3e38)))

Place = tuple[list[Fraction], int]


def places(name: str, n: int, count: int, size: int = 64) -> Iterator[Place]:
    """Positions that fixed arithmetic does not cut, and seeds."""
    numbers = generator_of(f"{name}{n}")
    for _ in range(count):
        yield [Fraction(numbers.integer(-size * UNIT, size * UNIT), UNIT) for _ in range(n)], numbers.word()
