"""Measures what octave sums show of their lattices: directions, since the axes of unturned octaves add up, and copies
in a tile, where octaves would repeat sooner than the tile does."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from measure.hashes.library import Twin

LACUNARITY, GAIN = 2.0, 0.5
SEEDS = range(8)

SIDE = 1024       # samples along a picture
STEP = 2.0 ** -10  # cells: differences over it are slopes, as the cells of the finest octave are 2^-5 at least

# The spectrum is that of few octaves, so that the samples show all of their waves.
WAVE_OCTAVES = 5
WAVES_PER_CELL = 40
LEAST_WAVES = 3.0  # cycles per cell: of longer waves a picture has too few

# For structures the samples do not fall on the same places of finer cells.
OCTAVES = 6
PER_CELL = 17.3
SMOOTHINGS = (0.5, 1.0)  # cells of the first octave, the deviations of Gaussians
MARGIN = 2        # deviations, which are left out at the edges

# Half of what octaves have that do not turn: 0.063 in the plane, and 0.051 in slices of space.
LIMIT = 0.03

PERIOD = 16       # cells of a tile
PLACES = 1 << 14  # in a tile
PARTS = (2, 4, 8)  # of the period, after which octaves could repeat
# A correlation is off by about 0.03 with each seed, since the coarsest octave that counts has 32^2 cells in a tile. If
# the octaves repeat alike, it is 1 at one half.
REPEAT_LIMIT = 0.05


@dataclass(frozen=True)
class Cut:
    """A plane of pictures, in which two of the axes lie."""
    dimensions: int
    axes: tuple[int, int]

    @property
    def title(self) -> str:
        across = [axis for axis in range(self.dimensions) if axis not in self.axes]
        return f"{self.dimensions}D" + "".join(f", slices across {'xyzw'[axis]}" for axis in across)


FAR = 1 << 20  # a period that no picture reaches: nothing turns with it

CUTS = (Cut(2, (0, 1)), Cut(3, (0, 1)), Cut(3, (1, 2)), Cut(3, (0, 2)))
# Two of the six in 4D. The page leaves them out; the tests do not.
CUTS_4D = (Cut(4, (0, 2)), Cut(4, (2, 3)))


@dataclass(frozen=True)
class Directions:
    """Fourth harmonics, a value for each seed: 0 if all directions are alike, 1 if there are only axes."""
    cut: Cut
    period: int | None
    spectrum: list[float]
    structures: dict[float, list[float]]  # by what they are smoothed over

    @property
    def passed(self) -> bool:
        return abs(float(np.mean(self.spectrum))) <= LIMIT


@dataclass(frozen=True)
class Repeats:
    """The largest correlation of a tile with itself, moved by a part of the period, of all octaves but the first."""
    dimensions: int
    correlation: float

    @property
    def passed(self) -> bool:
        return self.correlation <= REPEAT_LIMIT


def slopes(twin: Twin, cut: Cut, octaves: int, per_cell: float, seed: int,
           period: int | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Of a picture that does not wrap, anywhere in the plane or in space."""
    rng = np.random.default_rng((seed, cut.dimensions))
    places = np.broadcast_to(rng.uniform(-500, 500, cut.dimensions), (SIDE, SIDE, cut.dimensions)).copy()
    along = np.arange(SIDE) / per_cell
    places[..., cut.axes[0]] += along[:, None]
    places[..., cut.axes[1]] += along
    places = places.reshape(-1, cut.dimensions)

    def values(at: np.ndarray) -> np.ndarray:
        return twin.octave_sum(at, octaves, LACUNARITY, GAIN, seed, period).reshape(SIDE, SIDE).astype(float)
    here = values(places)
    moved = [places + STEP * (np.arange(cut.dimensions) == axis) for axis in cut.axes]
    return tuple((values(at) - here) / STEP for at in moved)


def spectrum_harmonic(along: Iterable[np.ndarray], per_cell: float = WAVES_PER_CELL) -> float:
    """The mean of cos(4 * angle) of the waves that slopes are made of, weighted by their power."""
    frequencies = np.meshgrid(*[np.fft.fftfreq(SIDE, 1 / per_cell)] * 2, indexing="ij")
    length, angle = np.hypot(*frequencies), np.arctan2(frequencies[1], frequencies[0])
    window = np.outer(*[np.hanning(SIDE)] * 2)
    power = sum(np.abs(np.fft.fft2(slope * window)) ** 2 for slope in along)
    # Whole circles of frequencies: the corners of the square beyond them would count as diagonals.
    inside = (length > LEAST_WAVES) & (length < per_cell / 2)
    return float(np.average(np.cos(4 * angle[inside]), weights=power[inside]))


def structure_harmonic(along: tuple[np.ndarray, np.ndarray], smoothing: float, per_cell: float = PER_CELL) -> float:
    """The same of the direction across the structures of slopes, weighted by the cube of how much it exceeds the other
    one."""
    margin = int(np.ceil(MARGIN * smoothing * per_cell))
    inside = (slice(margin, -margin),) * 2
    xx, xy, yy = (ndimage.gaussian_filter(a * b, smoothing * per_cell, truncate=MARGIN)[inside]
                  for a, b in (along[:1] * 2, along, along[1:] * 2))
    angle = np.arctan2(2 * xy, xx - yy) / 2
    return float(np.average(np.cos(4 * angle), weights=(np.hypot(xx - yy, 2 * xy) / (xx + yy)) ** 3))


def directions(twin: Twin, cut: Cut, seeds: Iterable[int] = SEEDS, with_structures: bool = True,
               period: int | None = None) -> Directions:
    spectrum: list[float] = []
    structures: dict[float, list[float]] = {smoothing: [] for smoothing in SMOOTHINGS if with_structures}
    for seed in seeds:
        spectrum.append(spectrum_harmonic(slopes(twin, cut, WAVE_OCTAVES, WAVES_PER_CELL, seed, period)))
        along = slopes(twin, cut, OCTAVES, PER_CELL, seed, period) if structures else ()
        for smoothing, values in structures.items():
            values.append(structure_harmonic(along, smoothing))
    return Directions(cut, period, spectrum, structures)


def finer(twin: Twin, places: np.ndarray, seed: int) -> np.ndarray:
    """A tile without its first octave."""
    total = sum(GAIN ** i for i in range(OCTAVES))
    return (total * twin.octave_sum(places, OCTAVES, LACUNARITY, GAIN, seed, PERIOD).astype(float)
            - twin.octave_sum(places, 1, LACUNARITY, GAIN, seed, PERIOD))


def correlation(twin: Twin, dimensions: int, move: np.ndarray, seeds: Iterable[int] = SEEDS) -> float:
    """Of a tile with itself, moved."""
    values = []
    for seed in seeds:
        places = np.random.default_rng((seed, dimensions)).uniform(0, PERIOD, (PLACES, dimensions))
        values.append(np.corrcoef(finer(twin, places, seed), finer(twin, places + move, seed))[0, 1])
    return float(np.mean(values))


def repeats(twin: Twin, dimensions: int, seeds: Iterable[int] = SEEDS) -> Repeats:
    moves = [PERIOD / part * np.array(along) for part in PARTS for along in (*np.eye(dimensions), np.ones(dimensions))]
    return Repeats(dimensions, max(correlation(twin, dimensions, move, seeds) for move in moves))


@dataclass(frozen=True)
class Shown:
    """The page on sums: their directions, those of sums that do not turn, and whether tiles repeat."""
    turned: list[Directions]
    unturned: list[Directions]
    repeats: list[Repeats]

    @property
    def passed(self) -> bool:
        return all(found.passed for found in (*self.turned, *self.repeats))


def shown(twin: Twin) -> Shown:
    return Shown([directions(twin, cut) for cut in CUTS], [directions(twin, cut, period=FAR) for cut in CUTS],
                 [repeats(twin, n) for n in (2, 3)])
