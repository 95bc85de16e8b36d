"""The bounds of each noise. A noise is a module of this package, under its name, with

    CASES               in which it exists: pairs of a number of dimensions and a kind of gradient, None if it has none
    derive(dimensions, gradient) -> ProvenBounds
    largest_intermediates(dimensions, gradient) -> dict
                        of fixed arithmetic: by name, bounds of the magnitudes that must stay below 2^31

and, if there is more to it,

    quotes()            numbers in prose: pairs of a file and a text that must stand in it
    describe(dimensions, gradient) -> dict    more numbers for the reader of tools/make bounds
    ends(dimensions)    the ends of ranges, in the order in which the comments state them
    offset_error(dimensions, fixed)    of each component of an offset
"""

from __future__ import annotations

import functools
import importlib
import pkgutil
from dataclasses import dataclass
from types import ModuleType

from proof.bounds.boxes import SAFE
from proof.bounds.floats import position_error
from proof.bounds.gradients import Gradient
from proof.bounds.table import Bounds, shortest


@dataclass(frozen=True)
class ProvenBounds:
    """The bounds of a noise in a number of dimensions, with a kind of gradient, as they come out."""
    promise: float  # of the contract: the range of |noise|
    range: float  # of the exact noise
    lipschitz: float
    cell_error: float
    error: float
    largest: float  # computed in floats
    fixed_error: float
    fixed_largest: float
    fixed_parts: dict[str, float]  # of fixed_error, each at its largest
    slope: ProvenBounds | None = None  # the same of each of its derivatives, if it returns them; they have no promise
    fixed_intermediate: float = 0.0  # the largest number on the way to it

    def bounds(self, noise: str, dimensions: int, gradient: Gradient | None) -> Bounds:
        """Its row of the table. A limit is the contract's promise, unless rounding takes a value beyond."""
        return Bounds(noise, dimensions, gradient.name if gradient else "none", self.cell_error, self.error,
                      self.lipschitz, max(self.promise, self.largest), self.fixed_error,
                      max(self.promise, self.fixed_largest))


def derived(promise: float, exact: float, lipschitz: float, cell_error: float, parts: dict[str, float]) -> ProvenBounds:
    """Bounds of a noise with a fixed error that is the sum of its parts; the cut takes no value out of its range."""
    error, fixed = position_error(cell_error, lipschitz), sum(parts.values()) * SAFE
    return ProvenBounds(promise, exact, lipschitz, cell_error, error, exact + error, fixed,
                   exact + (sum(parts.values()) - parts["cut"]) * SAFE, parts)


def listed(ranges: list[float]) -> str:
    """As prose states them: 0.5, 0.6 and 0.7."""
    texts = [shortest(of_noise, 5) for of_noise in ranges]
    return f"{', '.join(texts[:-1])} and {texts[-1]}"


@functools.cache  # prose and comments are searched for them thousands of times
def names() -> tuple[str, ...]:
    return tuple(module.name for module in pkgutil.iter_modules(__path__))


def find(name: str) -> ModuleType:
    if name not in names():
        raise LookupError(f"there are no bounds of {name}: write tools/lib/proof/bounds/noises/{name}.py")
    return importlib.import_module(f"{__name__}.{name}")
