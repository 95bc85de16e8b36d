"""Compares what each noise shows of its lattice: the directions of its structures, its spectrum, its slices."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import fft

from measure.hashes import isotropy
from measure.hashes.lattice import cells_of
from measure.hashes.library import Twin

SEEDS = range(8)  # a block of its own each
HEIGHTS = 8  # of slices, in a cell
PLACES = 1 << 16  # in a slice
SIDES = {2: 256, 3: 32}  # steps of the lattice along an axis of a block
# The orders of the harmonics in the plane: of one axis, of the axes of squares, of the sides of triangles, of the axes
# and the diagonals of squares alike.
ORDERS = (2, 4, 6, 8)


@dataclass(frozen=True)
class Noise:
    name: str  # of the function, without hn_
    dimensions: int
    steps: int = 1  # of its lattice, in a cell: so that all are sampled alike
    phase: float | None = None  # turns

    @property
    def title(self) -> str:
        phase = "" if self.phase is None else f", a phase of {self.phase} turns"
        return f"`hn_{self.name}` {self.dimensions}D{phase}"

    @property
    def judged(self) -> bool:
        return self.name == "perlin_worley"


EIGHTH = 1 / 8  # of a turn, where gradients on the plane differ the most from those without a phase
NOISES = (Noise("perlin", 2), Noise("simplex", 2, 2), Noise("simplex_smooth", 2, 2), Noise("value", 2),
          Noise("value_cubic", 2), Noise("perlin", 2, phase=EIGHTH), Noise("simplex", 2, 2, EIGHTH),
          Noise("perlin", 3), Noise("simplex", 3), Noise("simplex_smooth", 3), Noise("value", 3),
          Noise("value_cubic", 3), Noise("perlin", 3, phase=EIGHTH), Noise("simplex", 3, phase=EIGHTH),
          Noise("perlin_worley", 3))
# How much Perlin-Worley noise may show of its lattice: the aim that isotropy.py has in the plane for structures, what
# octaves.py allows for waves, and slices as unlike as those of Perlin noise in space. Distances to the points of cells
# have another mean at another place of a cell; that mean may make this part of the variance, and is left out of the
# waves.
STRUCTURES, WAVES, SLICES, FIXED = isotropy.AIM[2], 0.03, 0.85, 0.1


@dataclass(frozen=True)
class Look:
    """Each is a value for each seed. Harmonics are 0 if all directions are alike, and 1 if there is one alone."""
    noise: Noise
    structures: dict[int, list[float]]  # by order
    spectrum: dict[int, list[float]]
    slices: list[float]  # of noise in space: the least deviation of a slice over the greatest
    fixed: list[float]  # of noise that is judged: the part of its variance that is the same in each cell
    rest: list[float]  # the spectrum of what is left without that

    @property
    def problems(self) -> list[str]:
        """Where noise that is judged shows more of its lattice than it may."""
        if not self.noise.judged:
            return []
        wrong = {"structures": abs(np.mean(self.structures[4])) > STRUCTURES, "fixed": np.mean(self.fixed) > FIXED,
                 "rest": abs(np.mean(self.rest)) > WAVES, "slices": np.mean(self.slices) < SLICES}
        return [name for name, is_wrong in wrong.items() if is_wrong]


def block(twin: Twin, noise: Noise, seed: int) -> np.ndarray:
    """A field that wraps, with PER_CELL samples to a step of the lattice."""
    side = SIDES[noise.dimensions]
    shape = (side * isotropy.PER_CELL,) * noise.dimensions
    places = (cells_of((0,) * noise.dimensions, shape) + 0.5) / (isotropy.PER_CELL * noise.steps)
    return twin.tile(noise.name, places, side // noise.steps, seed, noise.phase).reshape(shape)


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
    values = twin.tile(noise.name, places.reshape(-1, 3), SIDES[3], seed, noise.phase).reshape(HEIGHTS, PLACES)
    deviations = values.astype(float).std(axis=1)
    return float(deviations.min() / deviations.max())


def fixed_part(field: np.ndarray) -> np.ndarray:
    """The mean over all cells at each of the samples of one, in each cell."""
    cells = field.shape[0] // isotropy.PER_CELL
    by_cell = field.reshape((cells, isotropy.PER_CELL) * field.ndim)
    mean = by_cell.mean(axis=tuple(range(0, by_cell.ndim, 2)), keepdims=True)
    return np.broadcast_to(mean, by_cell.shape).reshape(field.shape)


def look(twin: Twin, noise: Noise) -> Look:
    structures: dict[int, list[float]] = {order: [] for order in orders(noise.dimensions)}
    spectrum: dict[int, list[float]] = {order: [] for order in orders(noise.dimensions)}
    fixed, rest = [], []
    for seed in SEEDS:
        field = block(twin, noise, seed)
        if noise.judged:
            part = fixed_part(field.astype(float))
            fixed.append(float(part.var() / field.var()))
            rest.append(harmonic(*waves(field - part), 4))
        across = isotropy.across(isotropy.structure(field))
        of_waves = waves(field)
        for order in orders(noise.dimensions):
            structures[order].append(harmonic(*across, order))
            spectrum[order].append(harmonic(*of_waves, order))
    return Look(noise, structures, spectrum,
                [slices(twin, noise, seed) for seed in SEEDS] if noise.dimensions == 3 else [], fixed, rest)


def looks(twin: Twin) -> list[Look]:
    return [look(twin, noise) for noise in NOISES]


def mean_and_error(values: list[float]) -> tuple[float, float]:
    return float(np.mean(values)), float(np.std(values, ddof=1) / len(values) ** 0.5)
