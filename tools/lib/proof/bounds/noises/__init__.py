"""The ranges of each noise and of its derivatives. Each module has the proofs of noises that are alike, in PROOFS by their
names."""

from __future__ import annotations

import functools
import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass, replace

from proof.bounds.gradients import SINE, Gradient
from proof.bounds.table import Bounds, shortest


@dataclass(frozen=True)
class ProvenBounds:
    """The bounds of a noise in a number of dimensions, with a kind of gradient, as they come out. command.py adds the rest,
    which is None here: errors are measured (errors/record.py), and kept.csv has what 1.1.0 derived."""
    promise: float  # of the contract: the range of |noise|
    range: float  # of the exact noise
    lipschitz: float | None = None
    cell_error: float | None = None
    error: float | None = None
    largest: float | None = None  # computed in floats
    fixed_error: float | None = None
    fixed_largest: float | None = None
    slope: ProvenBounds | None = None  # the same of each of its derivatives, if it returns them; they have no promise

    def bounds(self, noise: str, dimensions: int, gradient: Gradient | None) -> Bounds:
        """Its row of the table. A limit is the contract's promise, unless rounding takes a value beyond."""
        return Bounds(noise, dimensions, gradient.name if gradient else "none", self.cell_error, self.error,
                      self.lipschitz, max(self.promise, self.largest), self.fixed_error,
                      max(self.promise, self.fixed_largest))


def listed(ranges: list[float]) -> str:
    """As prose states them: 0.5, 0.6 and 0.7."""
    texts = [shortest(of_noise, 5) for of_noise in ranges]
    return f"{', '.join(texts[:-1])} and {texts[-1]}"


@dataclass(frozen=True)
class Proof:
    """The proofs of a noise: functions of a number of dimensions, and of a kind of gradient."""
    cases: tuple[tuple[int, Gradient | None], ...]  # in which it exists: both, None if it has no gradient
    derive: Callable[[int, Gradient | None], ProvenBounds]
    # Of a number of dimensions: the ends of ranges in the order in which the comments state them, and the least value.
    ends: Callable[[int], list[float]] | None = None
    least: Callable[[int], float] | None = None
    # Numbers in prose: pairs of a file and a text that must stand in it
    quotes: Callable[[], list[tuple[str, str]]] = list


def of_components(proof: Proof) -> Proof:
    """The proof of vectors whose components are the noise with other hashes."""
    return replace(proof, cases=tuple(case for case in proof.cases if case[0] in (2, 3) and case[1] is not SINE),
                   quotes=list)


@functools.cache  # prose and comments are searched for them thousands of times
def proofs() -> dict[str, Proof]:
    modules = [importlib.import_module(f"{__name__}.{module.name}") for module in pkgutil.iter_modules(__path__)]
    every = {name: proof for module in modules for name, proof in module.PROOFS.items()}
    return {name: every[name] for name in sorted(every)}


def names() -> list[str]:
    return list(proofs())


def find(name: str) -> Proof:
    if name not in names():
        raise LookupError(f"there are no bounds of {name}, which is no noise of the catalog")
    return proofs()[name]
