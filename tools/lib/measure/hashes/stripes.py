"""Compares phasor noise with the wave that it was given, and measures traces of its lattice.

To have a direction is no fault of stripes: it is chosen. So the spectrum is compared with that wave, around which the
power of a sum of waves lies as the weight of a point has it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import fft, special

from measure.hashes.fields import SEEDS, Measure
from measure.hashes.windows import cells_of

# Positions, a period, a wave and a seed, to the value and its quadrature as complex numbers: Twin.phasor.
Field = Callable[[np.ndarray, int, Sequence[float], int], np.ndarray]


@dataclass(frozen=True)
class Effort:
    seeds: Sequence[int]
    side: int        # cells of a tile
    per_cell: int    # samples along a cell
    grid: int        # places along a cell, all compared with each other
    per_place: int   # cells in which each of these is looked at, with each seed


EFFORTS = {2: Effort(SEEDS, 64, 16, 16, 1 << 12), 3: Effort(SEEDS, 16, 8, 4, 1 << 12)}
# Along an axis and across all, in waves per cell: multiples of one in a tile, so that the spectrum has a line there.
WAVES = ((3.0, 0.0), (2.5, 1.5), (2.0, 0.0, 0.0), (1.5, 1.0, 0.75))
# So far may the centre of the spectrum be from the wave, in cycles per cell. The random phases of all seeds leave it to
# chance by a fourth of that at most.
AWAY = 0.02
# So far may the width be from that of the weight, as a part of it: samples show what is beyond their reach as nearer.
OF_WIDTH = 0.05
# A little less than the library's own weights have: a weight that falls sooner leaves larger gaps.
EVEN = {2: 0.75, 3: 0.64}


def own_width(dimensions: int, reach: float) -> float:
    """The deviation along an axis of the power of the weight (docs/reference/contract.md, section 23), in cycles per
    cell, of the frequencies that are no longer than `reach`: the weight is steep, so that some of its power is
    beyond."""
    end = {2: (819 / 1024) ** 0.5 / 2, 3: 0.5 ** 0.5}[dimensions]
    r = (np.arange(1 << 10) + 0.5) / (1 << 10) * end  # from the point, in cells
    t = 819 / 1024 - 4 * r * r if dimensions == 2 else 1 - 2 * r * r
    w = t ** 3 * (1 + 15 * (1 - t) ** 2)
    k = (np.arange(1 << 10) + 0.5) / (1 << 10) * reach
    wave = special.j0(2 * np.pi * np.outer(k, r)) if dimensions == 2 else np.sinc(2 * np.outer(k, r))
    power = (wave @ (w * r ** (dimensions - 1))) ** 2 * k ** (dimensions - 1)
    return float(((power * k * k).sum() / power.sum() / dimensions) ** 0.5)


def reach_of(wave: Sequence[float], per_cell: int) -> float:
    """How far from the wave, in cycles per cell, samples show its surroundings whole."""
    return per_cell / 2 - max(map(abs, wave))


def around(field: Field, wave: Sequence[float], seed: int, effort: Effort) -> tuple[np.ndarray, np.ndarray]:
    """The frequencies of a tile less the wave, in cycles per cell, and their power, in a circle or a sphere that
    samples show whole."""
    shape = (effort.side * effort.per_cell,) * len(wave)
    tile = field(cells_of((0,) * len(wave), shape) / effort.per_cell, effort.side, wave, seed).reshape(shape)
    axes = [fft.fftfreq(side, 1 / effort.per_cell) - k for side, k in zip(shape, wave)]
    away = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(wave))
    inside = np.linalg.norm(away, axis=-1) < reach_of(wave, effort.per_cell)
    return away[inside], (np.abs(fft.fftn(tile)) ** 2).reshape(-1)[inside]


def even(field: Field, wave: Sequence[float], effort: Effort) -> float:
    """The least deviation at a place of a cell over the greatest: 1 if the lattice does not show."""
    n = len(wave)
    within = cells_of((0,) * n, (effort.grid,) * n)[:, None] / effort.grid
    power = 0.0
    for seed in effort.seeds:
        cells = np.random.default_rng((seed, n)).integers(0, effort.side, (len(within), effort.per_place, n))
        values = field((cells + within).reshape(-1, n), effort.side, wave, seed)
        power = power + (np.abs(values) ** 2).reshape(cells.shape[:2]).mean(axis=1)
    return float((power.min() / power.max()) ** 0.5)


def measure(field: Field, wave: Sequence[float], effort: Effort | None = None) -> Iterator[Measure]:
    n = len(wave)
    effort = effort or EFFORTS[n]
    centres, widths = [], {"along": [], "across": []}
    ahead = np.array(wave) / np.linalg.norm(wave)
    for seed in effort.seeds:
        away, power = around(field, wave, seed, effort)
        centres.append(np.average(away, axis=0, weights=power))
        forth = np.average((away @ ahead) ** 2, weights=power)
        beside = (np.average((away ** 2).sum(axis=-1), weights=power) - forth) / (n - 1)
        for name, square in (("along", forth), ("across", beside)):
            widths[name].append(float(square ** 0.5))
    own = own_width(n, reach_of(wave, effort.per_cell))
    of = f", wave ({', '.join(f'{k:g}' for k in wave)})"
    yield Measure("hn_phasor", n, "centre" + of, [float(np.linalg.norm(np.mean(centres, axis=0)))], AWAY)
    for name, found in widths.items():
        yield Measure("hn_phasor", n, f"error of the width {name}{of}", [width / own - 1 for width in found], OF_WIDTH)
    yield Measure("hn_phasor", n, "even" + of, [even(field, wave, effort)], EVEN[n], True)
