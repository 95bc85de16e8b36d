"""The noises. Each module has noises that are alike, in NOISES, each with its two definitions side by side:

    exact(lattice, cell, f) -> tuple[Fraction, ...]         docs/reference/contract.md, sections 6, 9 to 11, 13, 14, 16
                                                            and 22; f are fractions
    fixed(lattice, cell, fraction) -> tuple[int, ...]       with HN_FIXED; fractions in units of 2^-20

They return the value, and after it the derivatives along x, y, z, w of a noise that has them, unless it names other
results. A fixed value is in units of 2^-21, a fixed derivative in units of 2^-19.
"""

from __future__ import annotations

import functools
import importlib
import math
import pkgutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from proof.oracle.gradients import Knobs, Real
from proof.oracle.integers import NOISE_UNIT, SLOPE_UNIT, cell_and_fraction, fraction_of
from proof.oracle.lattice import Choice, Lattice

OUTPUTS = ("value", "dx", "dy", "dz", "dw")
UNITS = (NOISE_UNIT, *(SLOPE_UNIT,) * 4)
VECTOR = ("vx", "vy", "vz")  # the outputs of what returns a vector


@dataclass(frozen=True)
class Noise:
    """A noise at a position, and from a cell and a fraction, in exact and in fixed arithmetic."""
    name: str
    exact_in_cell: Callable[[Lattice, Sequence[int], Sequence[Fraction]], tuple[Fraction, ...]]
    fixed_in_cell: Callable[[Lattice, Sequence[int], Sequence[int]], tuple[int, ...]]
    outputs: tuple[str, ...] = OUTPUTS  # the names of its results; as many as it has dimensions
    units: tuple[int, ...] = UNITS
    phase: Real | None = None
    choice: Choice = Choice()  # of cellular noise, and of phasor noise
    rotates: bool = False  # whether it may have a phase

    def rotated(self, phase: Real) -> Noise:
        """The noise with its gradients, or its feature points, rotated."""
        if not self.rotates:
            raise ValueError(f"the gradients of {self.name} do not rotate")
        return replace(self, phase=phase)

    def chosen(self, choice: Choice) -> Noise:
        """The noise with its caller's choices."""
        return replace(self, choice=choice)

    def lattice(self, knobs: Knobs, seed: int, periods: Sequence[int]) -> Lattice:
        return Lattice(knobs, seed, tuple(periods), self.phase, self.choice)

    def in_units(self, numbers: Sequence[int]) -> tuple[Fraction, ...]:
        """The numbers of fixed arithmetic. The name of a cell is a whole number."""
        return tuple(number if unit == 1 else Fraction(number, unit) for number, unit in zip(numbers, self.units))

    def exact(self, knobs: Knobs, p: Sequence[Real], seed: int = 0,
              periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
        cell = [math.floor(x) for x in p]
        return self.exact_cell(knobs, cell, [Fraction(x) - c for x, c in zip(p, cell)], seed, periods)

    def exact_cell(self, knobs: Knobs, cell: Sequence[int], f: Sequence[Real], seed: int = 0,
                   periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
        return self.exact_in_cell(self.lattice(knobs, seed, periods), cell, list(map(Fraction, f)))

    def fixed(self, knobs: Knobs, p: Sequence[Real], seed: int = 0,
              periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
        cell, fraction = zip(*map(cell_and_fraction, p))
        return self.in_units(self.fixed_in_cell(self.lattice(knobs, seed, periods), cell, fraction))

    def fixed_cell(self, knobs: Knobs, cell: Sequence[int], f: Sequence[Real], seed: int = 0,
                   periods: Sequence[int] = ()) -> tuple[Fraction, ...]:
        return self.in_units(self.fixed_in_cell(self.lattice(knobs, seed, periods), cell, list(map(fraction_of, f))))


def rotating(noise: Noise, name: str) -> Noise:
    """The noise with gradients that rotate, or feature points that go round, by a phase."""
    return replace(noise, name=name, phase=Fraction(0), rotates=True)


@functools.cache  # golden files ask for thousands of noises
def every() -> dict[str, Noise]:
    modules = [importlib.import_module(f"{__name__}.{module.name}") for module in pkgutil.iter_modules(__path__)
               if not module.name.endswith("_test")]
    return {noise.name: noise for module in modules for noise in module.NOISES}


def names() -> list[str]:
    return sorted(every())


def find(name: str) -> Noise:
    if name not in every():
        raise LookupError(f"the oracle has no {name}: write it in tools/lib/proof/oracle/noises from "
                          "docs/reference/contract.md, and name it in NOISES")
    return every()[name]
