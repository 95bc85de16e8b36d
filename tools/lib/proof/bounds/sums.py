"""Octave sums, and how far they may be off, from the bounds of their noise. The steps by which they add an octave, and
all of floats, are proven in conformance/sums."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

import catalog.model
from proof.bounds.answers import MOST_OCTAVES, answer
from proof.bounds.boxes import SAFE
from proof.bounds.integers import DOUBLE, FADE_ONE, UNIT, checked, signed, word
from proof.bounds.table import Bounds
from proof.oracle import sums as oracle

CATALOG = {sum_.name: sum_ for sum_ in catalog.model.read().sums}
KINDS = tuple(name for name, sum_ in CATALOG.items() if sum_.is_of_values)
SLOPED, SHIFTS = ("fbm_d", "eroded"), ("warp", "warp_progressive")  # sums with slopes, and of vectors: jacobians.py
SHIFT_MAX = {dims: float(max(oracle.SHIFT[:dims])) for dims in (1, 2, 3, 4)}
# By how much each rotation of a position makes a length larger at most, which stays along other axes.
ROTATIONS = tuple(max(math.hypot(*rotation) / 32, 1.0) for rotation in oracle.ROTATIONS)
WHOLE = 2.0**-24  # the unit of fixed-point positions
WEIGHT_UNIT = 1 / FADE_ONE


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
    rotates: bool = True  # it does not with a period
    from_cell: bool = False
    exact_positions: bool = False  # the caller's promise that every q is computed without rounding

    def __post_init__(self):
        if self.kind not in KINDS + SLOPED + SHIFTS:
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


def doubled(s: Sum) -> Sum:
    """With twice the footprint, as gullies have it."""
    return s if s.footprint is None else replace(s, footprint=2 * s.footprint)


LARGEST_STRENGTH = {name: float(sum_.strength.most) for name, sum_ in CATALOG.items() if sum_.strength}


def clamped_strength(s: Sum) -> float:
    """0 if it has none."""
    return min(max(s.strength, 0.0), LARGEST_STRENGTH[s.kind]) if s.kind in LARGEST_STRENGTH else 0.0


class Steps(NamedTuple):
    """The errors of octaves before their weights, and of the factors of the weights behind them."""
    clamps: bool  # whether a noise beyond [-1, 1] counts as the nearer end
    errors: list[float]
    factor_errors: list[float]


def steps_of(s: Sum, noise_errs: list[float], fixed: bool) -> Steps:
    """Given the errors of the noises."""
    strength, cut = fixed_strength(s) if fixed else (clamped_strength(s), 0.0)
    rest = [0.0] * (MOST_OCTAVES - len(noise_errs))
    clamps, *found = answer("terms", s.kind, [fixed, strength, cut, *noise_errs, *rest])
    return Steps(bool(clamps), *(found[start:start + len(noise_errs)] for start in (0, MOST_OCTAVES)))


# --- In floats --------------------------------------------------------------------------------------------------------

def numbers_of(s: Sum) -> list[float]:
    return [s.p_max, s.octaves, s.lacunarity, s.gain, s.exact_positions, s.strength,
            -1.0 if s.footprint is None else s.footprint, s.rotates, s.from_cell, isinstance(s.octaves, float),
            s.amplitude]


def tolerance_of(what: str, s: Sum, *bounds: Bounds) -> float:
    of_noise = [x for b in bounds for x in (b.dimensions, b.cell_error, b.error, b.lipschitz, b.limit)]
    return answer(what, s.kind, [*numbers_of(s), *of_noise])[0]


def octave_tolerance(s: Sum, noise: Bounds, slope: Bounds | None = None) -> float:
    """The largest error of an octave sum over a noise, or of a component of a warp. An erosion and a warp need what is
    proven of the derivatives of the noise."""
    if slope is None and s.kind not in (*KINDS, "fbm_d"):
        raise LookupError(f"the bound of {s.kind} follows from the bounds of derivatives, too")
    return tolerance_of("value", s, noise, slope or noise)


# --- Positions --------------------------------------------------------------------------------------------------------

def lengths(s: Sum, dims: int) -> float:
    """How much longer a vector is than its largest coordinate, where lengths are bounded."""
    return math.sqrt(dims) if s.rotates else 1.0


def fixed_positions(s: Sum, dims: int) -> Iterator[float]:
    """The largest errors of each octave's position, as a length, or without rotations of a coordinate. A coordinate is
    cut to a multiple of 2^-24, and the lacunarity of 2^-23; the product is rounded down, and so are both coordinates
    after each rotation."""
    position, error = first_fixed_position(s, dims)
    while True:
        yield error
        position, error = next_fixed_position(s, dims, position, error)
        error = 0.0 if s.exact_positions else error


def first_fixed_position(s: Sum, dims: int) -> tuple[float, float]:
    """How long it is, or without rotations how large its coordinates, and the same of its error."""
    return lengths(s, dims) * s.p_max, 0.0 if s.exact_positions else lengths(s, dims) * WHOLE


def next_fixed_position(s: Sum, dims: int, position: float, error: float) -> tuple[float, float]:
    """The bounds of the next octave from those of one."""
    ratio, shift = math.trunc(s.lacunarity * 2**23) / 2**23, SHIFT_MAX[dims]
    axes, rotations = lengths(s, dims), ROTATIONS[:dims - 1] if s.rotates else ()
    error = ratio * error + (s.lacunarity - ratio) * position + axes * WHOLE
    for stretch in rotations:
        error = stretch * error + math.sqrt(2) * WHOLE
    return s.lacunarity * math.prod(rotations) * position + axes * shift, error


# --- In integers ------------------------------------------------------------------------------------------------------

def fixed_weights(s: Sum) -> list[int]:
    """A_i of the contract, in units of 2^-18."""
    return oracle.fixed_weights(s.options)


def fixed_fades(s: Sum) -> list[int]:
    """The part of each octave that a footprint leaves, in units of 2^-18."""
    return list(itertools.islice(oracle.fixed_visible(s.options), s.count))


@functools.cache
def cloud_error():
    """The largest |density - t t (3 - 2 t)| of all t."""
    t = np.arange(2**21 + 1, dtype=np.int64)
    c = (t - 2**20) >> 5
    density = 2**20 + (signed(c * (word(0xC0000000 - word(c * c)) >> 16)) >> 10)
    checked(density, 0, 2**21 + 1)
    exact = (t / 2**21) ** 2 * (3 - 2 * (t / 2**21))
    return np.abs(density * UNIT - exact).max() * SAFE + DOUBLE


def fixed_strength(s: Sum) -> tuple[float, float]:
    """As it is cut to 2^-18, and by how much."""
    strength = clamped_strength(s)
    cut = math.trunc(strength * FADE_ONE) / FADE_ONE
    return cut, strength - cut


def changes_by_steps(s: Sum, factor_errs: list[float]) -> list[float]:
    """How far the weights of octaves are off where the noises before them count, beyond the contract's product of exact
    factors: both products round down."""
    total, exact_total = sum(fixed_weights(s)) / FADE_ONE, sum(s.weights)
    g, err, weight, changes = math.trunc(s.gain * FADE_ONE) / FADE_ONE, 0.0, 1.0, []
    for exact, factor_err in zip(s.weights, factor_errs):
        changes.append(exact * abs(1 / total - 1 / exact_total) + err / total)
        gained = weight * s.gain
        err = min(g * (err + weight * factor_err + WEIGHT_UNIT) + (s.gain - g) * weight + WEIGHT_UNIT, gained)
        weight = gained
    return changes


def weight_changes(s: Sum) -> list[tuple[float, float]]:
    """The weight of each octave in the mean, and its distance from the exact one."""
    all_of_them, exact = fixed_weights(s), s.weights
    total, exact_total = sum(all_of_them), sum(exact)
    used = [oracle.product(a, fade) for a, fade in zip(all_of_them, fixed_fades(s))]
    exact_used = [a * fade for a, fade in zip(exact, s.fades)]
    return [(a / total, abs(a / total - b / exact_total)) for a, b in zip(used, exact_used)]


def fixed_mean_error(s: Sum, limit: float, term_errs: list[float], changes: list[float] | None = None) -> float:
    """The error of the mean of terms that are at most `limit`, with the weights of an fBm, or with others that are off
    by `changes`."""
    weights = weight_changes(s)
    changes = changes or [change for _, change in weights]
    error = sum(a * err + limit * change for (a, _), err, change in zip(weights, term_errs, changes))
    return error + (2 * s.count * FADE_ONE / sum(fixed_weights(s)) + 1) * UNIT + DOUBLE


def fixed_octave_tolerance(s: Sum, noise: Bounds) -> float:
    """The largest error against the exact sums of docs/reference/contract.md at the same floats, for lacunarity in [0,
    255], gain in [0, 1] and at most 32 octaves, which it does not cut.

    A noise is off by L times its position's error and by fixed_error (the cut to 2^-20 is in that). The weights are
    compared with the exact ones as they are: a change of weights by c_i, whose exact sum is 1, moves the mean by at
    most limit * sum |c_i|; the changes of weighted depend on the noise, and are bounded. A product v A / 2^18 is
    rounded down by less than 2 units of 2^-21, and so is their sum by less than 2 an octave; the division by less than
    1."""
    if not (0 <= s.lacunarity <= 255 and 0 <= s.gain <= 1 and s.octaves <= 32):
        return math.inf
    limit, error = min(noise.fixed_limit, 1.0) if steps_of(s, [], True).clamps else noise.fixed_limit, 0.0
    if s.count:
        noise_errs = [min(noise.lipschitz * position_err + noise.fixed_error, 2 * limit)
                      for _, position_err in zip(range(s.count), fixed_positions(s, noise.dimensions))]
        of = steps_of(s, noise_errs, True)
        changes = changes_by_steps(s, of.factor_errors) if any(of.factor_errors) else None
        error = fixed_mean_error(s, limit, of.errors, changes)
    mean = CATALOG[s.kind].mean
    if mean not in MEANS:
        raise LookupError(f"tools/lib/proof/bounds/sums.py has no proof of the mean {mean}, by which {s.kind} ends")
    return MEANS[mean](error)


MEANS = {  # of a sum: what becomes of the error of the mean. A clamp brings no two values further apart
    "": lambda error: error, "bounded": lambda error: error, "billows": lambda error: 2 * error,
    # The clamp and the doubling are exact, the smoothstep has slopes up to 3/2.
    "density": lambda error: 1.5 * 2 * error + cloud_error()}


def largest_octave_intermediates(limit: float) -> dict[str, float]:
    """By name, bounds of the magnitudes that must stay below 2^31, for a noise of at most `limit`: of
    v * (A >> 9) + (v >> 9) * (A & 511), A <= 2^18. Where A & 511 is not 0, A >> 9 is at most 511. In a rotation, the
    parts of fixed-point positions that are multiplied have 24 bits, and a fraction of 1 is 2^24."""
    noise = limit * 2**21
    return {"octave": noise * 2**9 + (noise / 2**9 + 1) * 511, "sum of 32 octaves": 32 * (noise + 2),
            "product": 2**9 * FADE_ONE + FADE_ONE, "part of a product": 511 * FADE_ONE, "doubled ridge": 2 * FADE_ONE,
            "part of ping-pong's t": 2**22 * 511, "rotation": (20 + 25) * 2**24, "rest of a rotation": (20 + 25) * 31,
            "billow": 2 * 2**21 + 2**21}
