"""Octave sums, and how far they may be off, from the bounds of their noise: conformance/sums runs their text over numbers
that count how far they are off."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import catalog.model
from catalog.tables.functions import Function, read_functions
from proof.bounds.answers import library, summary
from proof.bounds.integers import FADE_ONE
from proof.bounds.table import Bounds
from proof.oracle import sums as oracle

CATALOG = {sum_.name: sum_ for sum_ in catalog.model.read().sums}
KINDS = tuple(name for name, sum_ in CATALOG.items() if sum_.is_of_values)
SLOPED, SHIFTS = ("fbm_d", "eroded"), ("warp", "warp_progressive")  # sums with slopes, and of vectors: jacobians.py
FLOWS = ("curl_fbm",)  # with or without a phase
# By how much each rotation of a position makes a length larger at most, which stays along other axes.
ROTATIONS = tuple(max(math.hypot(*rotation) / 32, 1.0) for rotation in oracle.ROTATIONS)
WHOLE = 2.0**-24  # the unit of fixed-point positions
WEIGHT_UNIT = 1 / FADE_ONE
LARGEST_STRENGTH = {name: float(sum_.strength.most) for name, sum_ in CATALOG.items() if sum_.strength}


@dataclass(frozen=True)
class Sum:
    """An octave sum and its arguments, in the range that the contract takes them in: a period has made the lacunarity a
    whole number. A float of octaves is a detail; gain is not negative."""
    kind: str
    p_max: float  # the largest |p_i|; from a cell, |cell + f|
    octaves: float
    lacunarity: float
    gain: float
    strength: float = 0.0
    amplitude: float = 0.0
    footprint: float | None = None
    phase: float | None = None  # of a sum of flows
    rotates: bool = True  # it does not with a period
    from_cell: bool = False
    exact_positions: bool = False  # from a corner of a cell: in a tile no position rounds

    def __post_init__(self):
        if self.kind not in KINDS + SLOPED + SHIFTS + FLOWS:
            raise LookupError(f"tools/lib/proof/bounds has no proof of the sum {self.kind}")
        if not self.rotates and self.lacunarity % 1:
            raise ValueError(f"with a period a lacunarity is a whole number, and {self.lacunarity} is none")

    @property
    def options(self) -> oracle.Options:
        return oracle.Options(self.octaves, self.lacunarity, self.gain, footprint=self.footprint or 0)

    @property
    def count(self) -> int:
        return oracle.count_of(self.options)

    @property
    def weights(self) -> list[float]:
        return list(map(float, oracle.weights(self.options)))

    @property
    def fades(self) -> list[float]:
        """The part of each octave that a footprint leaves."""
        return [float(oracle.visible(self.options, i)) for i in range(self.count)]

    @property
    def settings(self) -> set[str]:
        """Names of columns that few rows have."""
        return ({"detail"} if isinstance(self.octaves, float) else {"octaves"}) | {
            name for name in ("footprint", "phase") if getattr(self, name) is not None}


def function_of(s: Sum, dims: int) -> Function:
    """The row of the suite's table with it; if there is none from such a place, one from a cell, where a fixed-point
    position is as in a tile of floats."""
    rows = [function for function in read_functions() if function.form == "sum" and function.axes == dims
            and function.bound == s.kind and s.settings == set(function.settings) & {"detail", "octaves", "footprint", "phase"}]
    return min(rows, key=lambda row: (row.has_period == s.rotates, row.has_cell != s.from_cell))


def arguments_of(s: Sum, function: Function) -> dict[str, str]:
    """As answers.py takes them."""
    most = s.p_max
    place = "float:0" if s.exact_positions else f"float:{-most}:{most}"
    of = {"seed": "any", "octaves": f"word:{s.octaves}", "detail": f"float:{s.octaves}", "lacunarity": f"float:{s.lacunarity}",
          "gain": f"float:{s.gain}", "strength": f"float:{s.strength}", "amplitude": f"float:{s.amplitude}",
          "footprint": f"float:{s.footprint}", "phase": f"float:{s.phase}"}
    for axis in "xyzw":
        of |= {axis: place, f"c{axis}": f"int:{-most}:{most}", f"f{axis}": "float:0" if s.exact_positions else "float:0:1",
               f"p{axis}": "word:0"}
    return {column.name: of[column.name] for column in function.inputs}


def tolerances(s: Sum, noise: Bounds, slope: Bounds | None = None, fixed: bool = False) -> list[float]:
    """The largest error of each result of an octave sum over a noise, against the exact sums of docs/reference/contract.md
    at the same floats. An erosion and a warp need the bounds of the noise's derivatives. With HN_FIXED for
    lacunarity in [0, 255], gain in [0, 1] and at most 32 octaves, which it does not cut."""
    if slope is None and s.kind not in KINDS + FLOWS:
        raise LookupError(f"the bound of {s.kind} follows from the bounds of derivatives, too")
    function = function_of(s, noise.dimensions)
    if (fixed or s.from_cell) and not 0 <= s.lacunarity <= 255 or fixed and not (0 <= s.gain <= 1 and s.octaves <= 32):
        return [math.inf] * len(function.outputs)
    return library(fixed).errors(function.id, arguments_of(s, function), summary(noise, slope, fixed))


def octave_tolerance(s: Sum, noise: Bounds, slope: Bounds | None = None) -> float:
    """For the value in floats, or for a component of a warp."""
    return max(tolerances(s, noise, slope)[:1 if s.kind == "fbm_d" else 3])


def fixed_octave_tolerance(s: Sum, noise: Bounds, slope: Bounds | None = None) -> float:
    """In fixed arithmetic."""
    return max(tolerances(s, noise, slope, True)[:1 if s.kind == "fbm_d" else 3])


def cloud_error() -> float:
    """The largest error of the density of a sky in fixed arithmetic, from an exact mean."""
    return fixed_octave_tolerance(Sum("clouds", 0.0, 0, 2.0, 0.5), Bounds("any", 2, "none", *[0.0] * 6))


# --- Parts of gullies -------------------------------------------------------------------------------------------------

def doubled(s: Sum) -> Sum:
    """With twice the footprint, as gullies have it."""
    return s if s.footprint is None else replace(s, footprint=2 * s.footprint)


def fixed_weights(s: Sum) -> list[int]:
    """A_i of the contract, in units of 2^-18."""
    return oracle.fixed_weights(s.options)


def fixed_fades(s: Sum) -> list[int]:
    """The part of each octave that a footprint leaves, in units of 2^-18."""
    return [fade for _, fade in zip(range(s.count), oracle.fixed_visible(s.options))]


def tile_positions(s: Sum) -> Iterator[float]:
    """The largest error of a coordinate of each octave, with a whole lacunarity: it is cut to a multiple of 2^-24."""
    error = 0.0 if s.exact_positions else WHOLE
    while True:
        yield error
        error *= s.lacunarity
