"""The common parts of the oracle's tests: positions, difference quotients, faults that checks have to notice, and
whether random numbers come as often as they should."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from unittest import mock

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


# --- Faults ------------------------------------------------------------------------------------------------------


class FaultChecks:
    """Stands before unittest.TestCase among the bases of a class that has a method check_NAME for each of CHECKS. Each
    check must notice faults, too: of FAULTS the module, the class or the dictionary that has the fault, its name there,
    the fault itself, and the checks that notice it."""
    CHECKS: tuple[str, ...]
    FAULTS: Sequence[tuple[object, str, object, tuple[str, ...]]] = ()
    NOTICED: type[Exception] | tuple[type[Exception], ...] = AssertionError  # raised by a check at a fault

    def test_every_check_passes(self) -> None:
        for check in self.CHECKS:
            with self.subTest(check):
                getattr(self, f"check_{check}")()

    def test_every_fault_is_noticed(self) -> None:
        for where, name, fault, noticing in self.FAULTS:
            patch = (mock.patch.dict(where, {name: fault}) if isinstance(where, dict) else
                     mock.patch.object(where, name, fault))
            for check in noticing:
                with self.subTest(name=name, check=check), patch, self.assertRaises(self.NOTICED):
                    getattr(self, f"check_{check}")()

    def test_every_check_notices_a_fault(self) -> None:
        self.assertEqual({check for *_, noticing in self.FAULTS for check in noticing}, {*self.CHECKS})


# --- Evenness ----------------------------------------------------------------------------------------------------

# Chi-square has the mean and half the variance of its degrees of freedom. By chance it is so many deviations above the
# mean in fewer than one of a thousand samples, if there are five degrees or more; what is not uniform is far above.
LIMIT = 5


def unevenness(found: Iterable[Hashable], chances: Mapping[Hashable, float]) -> float:
    """By how many deviations chi-square is above its mean."""
    counts = Counter(found)
    if not counts.keys() <= chances.keys():
        raise ValueError(f"no chance for {counts.keys() - chances.keys()}")
    total, freedom = counts.total(), len(chances) - 1
    square = sum((counts[cell] - total * chance)**2 / (total * chance) for cell, chance in chances.items())
    return (square - freedom) / math.sqrt(2 * freedom)


def equal_chances(cells: Iterable[Hashable]) -> dict[Hashable, float]:
    cells = list(cells)
    return {cell: 1 / len(cells) for cell in cells}
