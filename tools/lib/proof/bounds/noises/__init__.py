"""The bounds of each noise. Each module has the proofs of noises that are alike, in PROOFS by their names. A noise that
no module has gets all of its bounds from its text."""

from __future__ import annotations

import functools
import importlib
import math
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass, replace

import catalog.model
from catalog.model import Noise
from catalog.tables.functions import Function, read_functions
from proof.bounds.boxes import SAFE
from proof.bounds.floats import position_error
from proof.bounds.gradients import SINE, Gradient
from proof.bounds.table import Bounds, shortest


@dataclass(frozen=True)
class ProvenBounds:
    """The bounds of a noise in a number of dimensions, with a kind of gradient, as they come out. A number that
    the text proves (text.py) is None."""
    promise: float  # of the contract: the range of |noise|
    range: float | None  # of the exact noise
    lipschitz: float | None
    cell_error: float | None
    error: float | None
    largest: float | None  # computed in floats
    fixed_error: float | None
    fixed_largest: float | None
    fixed_parts: dict[str, float]  # of fixed_error, each at its largest
    slope: ProvenBounds | None = None  # the same of each of its derivatives, if it returns them; they have no promise
    fixed_intermediate: float = 0.0  # the largest number on the way to it

    def bounds(self, noise: str, dimensions: int, gradient: Gradient | None) -> Bounds:
        """Its row of the table. A limit is the contract's promise, unless rounding takes a value beyond."""
        return Bounds(noise, dimensions, gradient.name if gradient else "none", self.cell_error, self.error,
                      self.lipschitz, max(self.promise, self.largest), self.fixed_error,
                      max(self.promise, self.fixed_largest))


def derived(promise: float, exact: float, lipschitz: float, cell_error: float | None = None,
            parts: dict[str, float] | None = None,
            fixed_error: float | None = None, fixed_largest: float | None = None) -> ProvenBounds:
    """Bounds of a noise with a fixed error that is the sum of its parts, unless it is known to be less; the cut takes no
    value out of its range."""
    error = None if cell_error is None else position_error(cell_error, lipschitz)
    if parts:
        total = sum(parts.values())
        fixed_error = total * SAFE if fixed_error is None else fixed_error
        fixed_largest = exact + (total - parts["cut"]) * SAFE if fixed_largest is None else fixed_largest
    return ProvenBounds(promise, exact, lipschitz, cell_error, error, None if error is None else exact + error,
                        fixed_error, fixed_largest, parts or {})


def listed(ranges: list[float]) -> str:
    """As prose states them: 0.5, 0.6 and 0.7."""
    texts = [shortest(of_noise, 5) for of_noise in ranges]
    return f"{', '.join(texts[:-1])} and {texts[-1]}"


@dataclass(frozen=True)
class Proof:
    """The proofs of a noise: functions of a number of dimensions, and of a kind of gradient."""
    cases: tuple[tuple[int, Gradient | None], ...]  # in which it exists: both, None if it has no gradient
    derive: Callable[[int, Gradient | None], ProvenBounds]
    # Of fixed arithmetic, if its text does not prove it: by name, bounds of the magnitudes that must stay below 2^31.
    largest_intermediates: Callable[[int, Gradient | None], dict[str, float]] = lambda dims, gradient: {}
    # Of a number of dimensions: the ends of ranges in the order in which the comments state them, and the least value.
    ends: Callable[[int], list[float]] | None = None
    least: Callable[[int], float] | None = None
    offset_error: Callable[[int, bool], float] | None = None  # of a component of an offset, in floats or in integers
    moved_by_sines: Callable[[int], float] | None = None  # in cells: by sines and cosines that are not exact
    # The largest distance, in cells; the text has half cells. Derivatives are a vector over its length, which is a distance,
    # and their errors are times that.
    length: Callable[[int], float] | None = None
    # Numbers in prose: pairs of a file and a text that must stand in it
    quotes: Callable[[], list[tuple[str, str]]] = list
    is_of_text: bool = False  # there is no module of it


def of_components(proof: Proof) -> Proof:
    """The proof of vectors whose components are the noise with other hashes."""
    return replace(proof, cases=tuple(case for case in proof.cases if case[0] in (2, 3) and case[1] is not SINE),
                   quotes=list)


@functools.cache  # prose and comments are searched for them thousands of times
def proofs() -> dict[str, Proof]:
    modules = [importlib.import_module(f"{__name__}.{module.name}") for module in pkgutil.iter_modules(__path__)]
    every = {name: proof for module in modules for name, proof in module.PROOFS.items()}
    every |= {name: of_text(name, functions) for name, functions in without_module({*every}).items()}
    return {name: every[name] for name in sorted(every)}


def without_module(known: set[str]) -> dict[str, list[Function]]:
    """The functions of each noise of the catalog that no module has: their text proves all of their bounds."""
    found: dict[str, list[Function]] = {}
    for function in read_functions():
        if function.bound not in known and function.bound.removesuffix("_phase") in catalog_noises():
            found.setdefault(function.bound, []).append(function)
    return found


@functools.cache
def catalog_noises() -> dict[str, Noise]:
    return {noise.name: noise for noise in catalog.model.read().noises}


def of_text(name: str, functions: list[Function]) -> Proof:
    """The proof of a noise from its text alone."""
    noise = catalog_noises()[name.removesuffix("_phase")]
    jumps = math.inf if noise.jumps else None
    has_slope = noise.shape == "slopes"
    nothing = ProvenBounds(0.0, None, jumps, None, None, None, None, None, {})

    def derive(dims: int, _: Gradient | None) -> ProvenBounds:
        pair = noise.all_ranges["value"][dims - noise.first]
        return replace(nothing, promise=float(max(map(abs, pair))), slope=nothing if has_slope else None)

    dims = sorted({function.axes for function in functions})
    return replace(Proof(tuple((n, None) for n in dims), derive, lambda *_: {}), is_of_text=True)


def names() -> list[str]:
    return list(proofs())


def find(name: str) -> Proof:
    if name not in names():
        raise LookupError(f"there are no bounds of {name}, which is no noise of the catalog")
    return proofs()[name]
