"""Statistics of the noise itself: values, spectrum, directions. Reported; most of them have no right value."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import stats

from measure.hashes.library import Twin

SIDE = 1024          # samples along a picture
PER_CELL = 8         # so that what is above 2 cycles per cell, half of what samples show, is still seen
POINTS = 1 << 22     # random points for the attained range
SPAN = 1 << 16       # cells over which these lie; a float has still 7 bits for the place in the cell
SEEDS = tuple(range(8))
BAND = (0.3, 1.2)    # cycles per cell in which the noise has most of its power
SECTORS = 18         # of 10 degrees, over the half circle
WEDGE = np.pi / 18   # on either side of an axis or a diagonal
CHUNK = 1 << 20


@dataclass
class Measured:
    """Means over the seeds of each number, with their standard errors, and the curves."""
    numbers: dict[str, tuple[float, float]]
    radius: np.ndarray   # cycles per cell
    radial: np.ndarray   # power density there
    angular: np.ndarray  # power in BAND by sectors, of mean 1


def picture(twin: Twin, dimensions: int, seed: int) -> np.ndarray:
    """A square of noise, sampled beside the lattice points; in space a slice, another with each seed."""
    along = (np.arange(SIDE) + 0.5) / PER_CELL - SIDE / PER_CELL / 2
    x, y = np.meshgrid(along, along, indexing="ij")
    axes = [x, y] + [np.full_like(x, 16 * seed + 0.37)] * (dimensions - 2)  # a height beside the lattice as well
    return twin.noise(np.stack(axes, axis=-1).reshape(-1, dimensions), seed).reshape(SIDE, SIDE).astype(float)


def spectrum(field: np.ndarray) -> np.ndarray:
    """The power of each frequency, below a Hann window, which keeps the edges out of it."""
    window = np.hanning(len(field))
    return np.abs(np.fft.fft2((field - field.mean()) * np.outer(window, window))) ** 2


def frequencies() -> tuple[np.ndarray, np.ndarray]:
    """The cycles per cell of each entry of a spectrum, and its direction in [0, pi)."""
    f = np.fft.fftfreq(SIDE, 1 / PER_CELL)
    fx, fy = np.meshgrid(f, f, indexing="ij")
    return np.hypot(fx, fy), np.arctan2(fy, fx) % np.pi


def measure(twin: Twin, dimensions: int, points: int = POINTS) -> Measured:
    radius, angle = frequencies()
    band = (radius > BAND[0]) & (radius < BAND[1])
    sector = (angle[band] / np.pi * SECTORS).astype(int) % SECTORS
    to_axis = np.abs((angle + np.pi / 4) % (np.pi / 2) - np.pi / 4)
    axis, diagonal = band & (to_axis < WEDGE), band & (to_axis > np.pi / 4 - WEDGE)
    rings = np.arange(0, PER_CELL / 2, PER_CELL / SIDE * 4)  # four frequencies wide, as the Hann window blurs
    ring = np.digitize(radius.reshape(-1), rings) - 1
    rows: dict[str, list[float]] = {}
    radial, angular = np.zeros(len(rings)), np.zeros(SECTORS)
    for seed in SEEDS:
        field = picture(twin, dimensions, seed)
        power = spectrum(field)
        sectors = np.bincount(sector, power[band], SECTORS) / np.bincount(sector, minlength=SECTORS)
        radial += np.bincount(ring, power.reshape(-1) / power.sum(), len(rings)) / np.bincount(ring,
                                                                                               minlength=len(rings))
        angular += sectors / sectors.mean() / len(SEEDS)
        for name, value in (("mean", field.mean()), ("variance", field.var()),
                            ("excess kurtosis", stats.kurtosis(field, axis=None)),
                            ("power below 0.2 cycles per cell", power[radius < 0.2].sum() / power.sum()),
                            ("power above 2 cycles per cell", power[radius > 2].sum() / power.sum()),
                            ("strongest against weakest direction", sectors.max() / sectors.min()),
                            ("axes against diagonals, dB", 10 * np.log10(power[axis].mean() / power[diagonal].mean()))):
            rows.setdefault(name, []).append(value)
    numbers = {name: (float(np.mean(v)), float(np.std(v, ddof=1) / np.sqrt(len(v)))) for name, v in rows.items()}
    low, high = attained(twin, dimensions, points)
    numbers |= {"lowest value": (low, 0.0), "highest value": (high, 0.0)}
    return Measured(numbers, rings, radial / len(SEEDS), angular)


def attained(twin: Twin, dimensions: int, points: int) -> tuple[float, float]:
    """The extreme values over random points."""
    rng = np.random.default_rng(128 + dimensions)
    low, high = 0.0, 0.0
    for _ in range(0, points, CHUNK):
        values = twin.noise(rng.uniform(-SPAN / 2, SPAN / 2, (CHUNK, dimensions)), 0)
        low, high = min(low, float(values.min())), max(high, float(values.max()))
    return low, high
