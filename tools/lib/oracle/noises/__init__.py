"""The noises. Each is a module of this package, under its name, with its two definitions side by side:

    exact(knobs, cell, f, seed) -> Fraction             sections 5 to 7 of docs/contract.md; f are fractions
    fixed(knobs, cell, fraction, seed) -> int           section 8; fractions in units of 2^-20, in units of 2^-21
"""

from __future__ import annotations

import importlib
import math
import pkgutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from oracle.gradients import Knobs, Real
from oracle.integers import NOISE_UNIT, cell_and_fraction, fraction_of


@dataclass(frozen=True)
class Noise:
    """A noise at a position, and from a cell and a fraction, in exact and in fixed arithmetic."""
    name: str
    exact_in_cell: Callable[[Knobs, Sequence[int], Sequence[Fraction], int], Fraction]
    fixed_in_cell: Callable[[Knobs, Sequence[int], Sequence[int], int], int]

    def exact(self, knobs: Knobs, p: Sequence[Real], seed: int = 0) -> Fraction:
        cell = [math.floor(x) for x in p]
        return self.exact_in_cell(knobs, cell, [Fraction(x) - c for x, c in zip(p, cell)], seed)

    def exact_cell(self, knobs: Knobs, cell: Sequence[int], f: Sequence[Real], seed: int = 0) -> Fraction:
        return self.exact_in_cell(knobs, cell, list(map(Fraction, f)), seed)

    def fixed(self, knobs: Knobs, p: Sequence[Real], seed: int = 0) -> Fraction:
        cell, fraction = zip(*map(cell_and_fraction, p))
        return Fraction(self.fixed_in_cell(knobs, cell, fraction, seed), NOISE_UNIT)

    def fixed_cell(self, knobs: Knobs, cell: Sequence[int], f: Sequence[Real], seed: int = 0) -> Fraction:
        return Fraction(self.fixed_in_cell(knobs, cell, list(map(fraction_of, f)), seed), NOISE_UNIT)


def names() -> list[str]:
    return [module.name for module in pkgutil.iter_modules(__path__) if not module.name.endswith("_test")]


def find(name: str) -> Noise:
    if name not in names():
        raise LookupError(f"the oracle has no {name}: write tools/lib/oracle/noises/{name}.py from docs/contract.md")
    module = importlib.import_module(f"{__name__}.{name}")
    return Noise(name, module.exact, module.fixed)
