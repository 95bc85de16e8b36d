"""Compares phasor noise with the wave that it was given, and measures traces of its lattice.

To have a direction is no fault of stripes: it is chosen. So the directions of their spectrum are those from the wave
that was given, around which the power of a sum of waves lies as the weight of a point has it, the same all around.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy import fft, special, stats

from measure.hashes import fields
from measure.hashes.judgement import Finding, peak
from measure.hashes.lattice import cells_of

# Positions, a period, a wave and a seed, to the value and its quadrature as complex numbers: Twin.phasor.
Field = Callable[[np.ndarray, int, Sequence[float], int], np.ndarray]


@dataclass(frozen=True)
class Effort:
    seeds: Sequence[int]
    side: int        # cells of a tile
    per_cell: int    # samples along a cell
    grid: int        # places along a cell, all compared with each other
    per_place: int   # cells in which each of these is looked at, with each seed


EFFORTS = {2: Effort(range(8), 64, 16, 16, 1 << 12), 3: Effort(range(8), 16, 8, 4, 1 << 12)}
# Along an axis and across all, in waves per cell: multiples of one in a tile, so that the spectrum has a line there.
WAVES = {2: ((3.0, 0.0), (2.5, 1.5)), 3: ((2.0, 0.0, 0.0), (1.5, 1.0, 0.75))}
STEP = 1 / 16    # cells along the wave, over which stripes are followed

# So far may the centre of the spectrum be from the wave, in cycles per cell. The random phases of all seeds leave it to
# chance by a fourth of that at most.
AWAY = 0.02
# So far may the width be from that of the weight, as a part of it: samples show what is beyond their reach as nearer.
OF_WIDTH = 0.05
# Harmonics: the aim of isotropy.py is 0.1 for directions of structures, and this is what octaves.py allows for waves.
ROUND = 0.03
# These are a little less than the library's own weights have: a weight that falls sooner leaves larger gaps.
EVEN = {2: 0.75, 3: 0.64}


@dataclass(frozen=True)
class Stripes:
    """Numbers by seed, but for those of all seeds together."""
    wave: tuple[float, ...]
    own: float                     # the width that the weight has
    centres: np.ndarray            # of the spectrum, less the wave: a row for each seed
    along: list[float]             # the width of the spectrum, as a deviation
    across: list[float]
    harmonics: dict[int, list[float]]  # of the directions from the wave, by order
    even: float    # the least deviation at a place of a cell over the greatest
    steady: float  # the least agreement of stripes with the wave, at such a place: 1 if they follow it
    seeds: Finding  # the largest correlation of fields of two seeds, at all shifts

    @property
    def dimensions(self) -> int:
        return len(self.wave)

    @property
    def away(self) -> float:
        return float(np.linalg.norm(self.centres.mean(axis=0)))

    @property
    def problems(self) -> list[str]:
        """The statistics that are not as they should be."""
        wrong = {"centre": self.away > AWAY,
                 "width": any(abs(np.mean(width) / self.own - 1) > OF_WIDTH for width in (self.along, self.across)),
                 "round": any(abs(np.mean(values)) > ROUND for values in self.harmonics.values()),
                 "even": self.even < EVEN[self.dimensions], "seeds": not self.seeds.passed}
        return [name for name, is_wrong in wrong.items() if is_wrong]


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


def tile(field: Field, wave: Sequence[float], seed: int, effort: Effort) -> np.ndarray:
    shape = (effort.side * effort.per_cell,) * len(wave)
    return field(cells_of((0,) * len(wave), shape) / effort.per_cell, effort.side, wave, seed).reshape(shape)


def around(spectrum: np.ndarray, wave: Sequence[float], per_cell: int) -> tuple[np.ndarray, np.ndarray]:
    """The frequencies of a spectrum less the wave, in cycles per cell, and their power, in a circle or a sphere that
    samples show whole."""
    axes = [fft.fftfreq(side, 1 / per_cell) - k for side, k in zip(spectrum.shape, wave)]
    away = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(wave))
    inside = np.linalg.norm(away, axis=-1) < reach_of(wave, per_cell)
    return away[inside], (np.abs(spectrum) ** 2).reshape(-1)[inside]


def places(field: Field, wave: Sequence[float], effort: Effort) -> tuple[float, float]:
    """How even the deviation is over places in a cell, and how steady stripes are where they are least so."""
    n = len(wave)
    within = cells_of((0,) * n, (effort.grid,) * n)[:, None] / effort.grid
    half = STEP / 2 * np.array(wave) / np.linalg.norm(wave)
    turn = np.exp(-2j * np.pi * STEP * np.linalg.norm(wave))  # back by what a wave goes on in a step
    powers, agreements = 0.0, 0.0
    for seed in effort.seeds:
        cells = np.random.default_rng((seed, n)).integers(0, effort.side, (len(within), effort.per_place, n))
        before, after = (field((cells + within + move).reshape(-1, n), effort.side, wave, seed)
                         for move in (-half, half))
        powers = powers + (np.abs(before) ** 2 + np.abs(after) ** 2).reshape(cells.shape[:2]).mean(axis=1)
        angles = np.exp(1j * (np.angle(after) - np.angle(before)))
        agreements = agreements + (angles * turn).real.reshape(cells.shape[:2]).mean(axis=1)
    return float((powers.min() / powers.max()) ** 0.5), float(agreements.min() / len(effort.seeds))


def measure(field: Field, wave: Sequence[float], effort: Effort | None = None) -> Stripes:
    effort = effort or EFFORTS[len(wave)]
    spectra = [fft.fftn(tile(field, wave, seed, effort)) for seed in effort.seeds]
    centres, along, across = [], [], []
    harmonics: dict[int, list[float]] = {order: [] for order in fields.orders(len(wave))}
    ahead = np.array(wave) / np.linalg.norm(wave)
    for spectrum in spectra:
        away, power = around(spectrum, wave, effort.per_cell)
        centres.append(np.average(away, axis=0, weights=power))
        lengths = np.linalg.norm(away, axis=-1)
        forth = np.average((away @ ahead) ** 2, weights=power)
        along.append(float(forth ** 0.5))
        across.append(float(((np.average(lengths ** 2, weights=power) - forth) / (len(wave) - 1)) ** 0.5))
        moved = lengths > 0
        for order, values in harmonics.items():
            values.append(fields.harmonic(away[moved] / lengths[moved, None], power[moved], order))
    own = own_width(len(wave), reach_of(wave, effort.per_cell))
    return Stripes(tuple(wave), own, np.array(centres), along, across, harmonics, *places(field, wave, effort),
                   independence(spectra, effort))


def independence(spectra: Sequence[np.ndarray], effort: Effort) -> Finding:
    """The largest correlation of neighbouring seeds' fields, over all shifts. Its square is exponential where phases
    are random. Its mean over the shifts that differ by whole cells, after which the lattice is the same, is the
    scale."""
    ratios = []
    for a, b in pairwise(spectra):
        power = np.abs(fft.ifftn(a * b.conj())) ** 2
        by_cell = power.reshape((effort.side, effort.per_cell) * power.ndim)
        ratios.append(float((by_cell / by_cell.mean(axis=tuple(range(0, by_cell.ndim, 2)), keepdims=True)).max()))
    return peak("seeds", max(ratios), stats.expon(), spectra[0].size, spectra[0].size * len(ratios))


def shown(field: Field) -> list[Stripes]:
    return [measure(field, wave) for waves in WAVES.values() for wave in waves]
