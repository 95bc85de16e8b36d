"""What each noise shows of its lattice, side by side: the directions of its structures, its spectrum, its slices."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import fft

from quality import isotropy
from quality.lattice import cells_of
from quality.library import Twin

SEEDS = range(8)  # a block of its own each
HEIGHTS = 8  # of slices, in a cell
PLACES = 1 << 16  # in a slice
SIDES = {2: 256, 3: 32}  # steps of the lattice along an axis of a block
# Of the harmonics in the plane: of one axis, of the axes of squares, of the sides of triangles, of the axes and the
# diagonals of squares alike.
ORDERS = (2, 4, 6, 8)


@dataclass(frozen=True)
class Noise:
    name: str  # of the function, without hn_
    dimensions: int
    steps: int = 1  # of its lattice, in a cell: so that all are sampled alike

    @property
    def title(self) -> str:
        return f"`hn_{self.name}` {self.dimensions}D"


NOISES = (Noise("perlin", 2), Noise("simplex", 2, 2), Noise("simplex_smooth", 2, 2), Noise("value", 2),
          Noise("value_cubic", 2), Noise("perlin", 3), Noise("simplex", 3), Noise("simplex_smooth", 3),
          Noise("value", 3), Noise("value_cubic", 3))


@dataclass(frozen=True)
class Look:
    """Each is a value for each seed. Harmonics are 0 if all directions are alike, and 1 if there is one alone."""
    noise: Noise
    structures: dict[int, list[float]]  # by order
    spectrum: dict[int, list[float]]
    slices: list[float]  # of noise in space: the least deviation of a slice over the greatest


def block(twin: Twin, noise: Noise, seed: int) -> np.ndarray:
    """A field that wraps, with PER_CELL samples to a step of the lattice."""
    side = SIDES[noise.dimensions]
    shape = (side * isotropy.PER_CELL,) * noise.dimensions
    places = (cells_of((0,) * noise.dimensions, shape) + 0.5) / (isotropy.PER_CELL * noise.steps)
    return twin.tile(noise.name, places, side // noise.steps, seed).reshape(shape)


def harmonic(vectors: np.ndarray, weights: np.ndarray, order: int) -> float:
    """The mean of cos(order * angle) in the plane; in space, for order 4, the first harmonic that a cube has."""
    if vectors.shape[-1] == 3:
        return isotropy.mean_preference(vectors, weights)
    return float(np.average(np.cos(order * np.arctan2(vectors[:, 1], vectors[:, 0])), weights=weights))


def orders(dimensions: int) -> tuple[int, ...]:
    return ORDERS if dimensions == 2 else (4,)


def waves(field: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The directions of the waves that a field is made of, and their power."""
    frequencies = np.meshgrid(*[fft.fftfreq(side) for side in field.shape], indexing="ij")
    vectors = np.stack([f.ravel() for f in frequencies], -1)
    power = (np.abs(fft.fftn(field)) ** 2).ravel()
    lengths = np.linalg.norm(vectors, axis=-1)
    # Only whole spheres of frequencies: the corners of the cube beyond them would count as diagonals.
    inside = (lengths > 0) & (lengths < 0.5)
    return vectors[inside] / lengths[inside, None], power[inside]


def slices(twin: Twin, noise: Noise, seed: int) -> float:
    """How much slices across the last axis differ: the least deviation over the greatest, at heights in a cell."""
    rng = np.random.default_rng(seed)
    places = rng.uniform(0, SIDES[3], (HEIGHTS, PLACES, 3))
    places[..., 2] = np.arange(HEIGHTS)[:, None] / HEIGHTS + rng.integers(0, SIDES[3], (1, PLACES))
    values = twin.tile(noise.name, places.reshape(-1, 3), SIDES[3], seed).reshape(HEIGHTS, PLACES)
    deviations = values.astype(float).std(axis=1)
    return float(deviations.min() / deviations.max())


def look(twin: Twin, noise: Noise) -> Look:
    structures: dict[int, list[float]] = {order: [] for order in orders(noise.dimensions)}
    spectrum: dict[int, list[float]] = {order: [] for order in orders(noise.dimensions)}
    for seed in SEEDS:
        field = block(twin, noise, seed)
        across = isotropy.across(isotropy.structure(field))
        of_waves = waves(field)
        for order in orders(noise.dimensions):
            structures[order].append(harmonic(*across, order))
            spectrum[order].append(harmonic(*of_waves, order))
    return Look(noise, structures, spectrum,
                [slices(twin, noise, seed) for seed in SEEDS] if noise.dimensions == 3 else [])


def looks(twin: Twin) -> list[Look]:
    return [look(twin, noise) for noise in NOISES]


def mean_and_error(values: list[float]) -> tuple[float, float]:
    return float(np.mean(values)), float(np.std(values, ddof=1) / len(values) ** 0.5)
