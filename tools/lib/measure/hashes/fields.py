"""Measures what noises show of their lattices: the directions of their structures and of their waves, how much slices
differ, and the directions of octave sums."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import fft

from measure.hashes.library import Twin
from measure.hashes.windows import cells_of

SEEDS = range(8)
PER_CELL = 4      # samples along an axis; twice as many change no value by more than 0.004
SMOOTHING = 0.75  # cells, the deviation of a Gaussian: about the size of a blob
SIDES = {2: 256, 3: 32}  # steps of the lattice along an axis of a block
HEIGHTS = 8       # of slices, in a cell
PLACES = 1 << 16  # in a slice
# The orders of the harmonics in the plane: of one axis, of the axes of squares, of the sides of triangles, of the axes
# and the diagonals of squares alike. In space there is one, which a cube has.
ORDERS = {2: (2, 4, 6, 8), 3: (4,)}
EIGHTH = 1 / 8    # of a turn, where gradients on the plane differ the most from those without a phase


@dataclass(frozen=True)
class Noise:
    name: str  # of the function, without hn_
    dimensions: int
    steps: int = 1  # of its lattice, in a cell: so that all are sampled alike
    phase: float | None = None  # turns

    @property
    def title(self) -> str:
        return f"hn_{self.name}" + f", a phase of {self.phase} turns" * (self.phase is not None)


NOISES = (Noise("perlin", 2), Noise("simplex", 2, 2), Noise("simplex_smooth", 2, 2), Noise("value", 2),
          Noise("value_cubic", 2), Noise("perlin", 2, phase=EIGHTH), Noise("simplex", 2, 2, EIGHTH),
          *(Noise(name, 3) for name in ("perlin", "simplex", "simplex_smooth", "value", "value_cubic")),
          Noise("perlin", 3, phase=EIGHTH), Noise("simplex", 3, phase=EIGHTH), Noise("perlin_worley", 3))
# In the plane gradients of length 1 in uniform directions have -0.09, and in space the 12 edges of "Improving noise"
# (Perlin 2002) -0.103. Both are the usual choice where directions must not show: ours may have about as much. WAVES is
# half of what octaves have that do not turn. No other measure of a noise has a limit.
WAVES = 0.03
LIMITS = {("hn_perlin", 2, "structures, 4"): 0.1, ("hn_perlin", 3, "structures, 4"): 0.11,
          ("hn_perlin_worley", 3, "structures, 4"): 0.1, ("hn_perlin_worley", 3, "the same in each cell"): 0.1,
          ("hn_perlin_worley", 3, "waves without that"): WAVES, ("hn_perlin_worley", 3, "slices"): 0.85}


@dataclass(frozen=True)
class Measure:
    noise: str
    dimensions: int
    name: str
    values: Sequence[float]  # by seed
    limit: float | None = None  # of the magnitude of the mean
    least: bool = False  # whether the limit is the least that is allowed

    @property
    def mean(self) -> float:
        return float(np.mean(self.values))

    @property
    def error(self) -> float:
        return float(np.std(self.values, ddof=1) / len(self.values) ** 0.5) if len(self.values) > 1 else 0.0

    @property
    def passed(self) -> bool:
        return self.limit is None or (abs(self.mean) >= self.limit if self.least else abs(self.mean) <= self.limit)


# --- Directions -------------------------------------------------------------------------------------------------------

def harmonic(vectors: np.ndarray, weights: np.ndarray, order: int) -> float:
    """The mean of cos(order * angle) in the plane; in space, for order 4, the first harmonic that a cube has: 1 along
    the axes, and of mean 0 over all directions."""
    if vectors.shape[-1] == 3:
        return float(np.average((5 * (vectors ** 4).sum(axis=-1) - 3) / 2, weights=weights))
    return float(np.average(np.cos(order * np.arctan2(vectors[:, 1], vectors[:, 0])), weights=weights))


def waves(field: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The directions of the waves that a field is made of, and their power."""
    frequencies = np.meshgrid(*[fft.fftfreq(side) for side in field.shape], indexing="ij")
    vectors = np.stack([f.ravel() for f in frequencies], -1)
    power = (np.abs(fft.fftn(field)) ** 2).ravel()
    lengths = np.linalg.norm(vectors, axis=-1)
    # Only whole spheres of frequencies: the corners of the cube beyond them would count as diagonals.
    inside = (lengths > 0) & (lengths < 0.5)
    return vectors[inside] / lengths[inside, None], power[inside]


def structures(field: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The directions across the structures of a field that wraps, and their weights: by the structure tensor, the
    smoothed products of the derivatives, at a place in each cell. Of the half of all places where the slopes are
    steepest, by the cube of how much the steepest direction exceeds the next one."""
    n = field.ndim
    # The derivatives are exact: differences of neighbours would favour the diagonals by 0.04.
    axes = [2 * np.pi * fft.fftfreq(side, 1 / PER_CELL) for side in field.shape]
    axes[-1] = 2 * np.pi * fft.rfftfreq(field.shape[-1], 1 / PER_CELL)
    frequencies = np.meshgrid(*axes, indexing="ij", sparse=True)
    blur = np.exp(-SMOOTHING ** 2 / 2 * sum(w * w for w in frequencies))
    spectrum = fft.rfftn(field)
    slopes = [fft.irfftn(1j * w * spectrum, s=field.shape) for w in frequencies]
    tensor = np.empty((*(side // PER_CELL for side in field.shape), n, n), np.float32)
    for i in range(n):
        for j in range(i, n):
            smooth = fft.irfftn(fft.rfftn(slopes[i] * slopes[j]) * blur, s=field.shape)
            tensor[..., i, j] = tensor[..., j, i] = smooth[(slice(None, None, PER_CELL),) * n]
    sizes, directions = np.linalg.eigh(tensor.reshape(-1, n, n))
    energy = sizes.sum(axis=-1)
    strong = energy > np.median(energy)
    return directions[strong, :, -1], ((sizes[:, -1] - sizes[:, -2]) / energy)[strong] ** 3


# --- Noises -----------------------------------------------------------------------------------------------------------

def block(twin: Twin, noise: Noise, seed: int) -> np.ndarray:
    """A field that wraps, with PER_CELL samples to a step of the lattice."""
    side, n = SIDES[noise.dimensions], noise.dimensions
    shape = (side * PER_CELL,) * n
    places = (cells_of((0,) * n, shape) + 0.5) / (PER_CELL * noise.steps)
    return twin.tile(noise.name, places, side // noise.steps, seed, noise.phase).reshape(shape).astype(float)


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
    cells = field.shape[0] // PER_CELL
    by_cell = field.reshape((cells, PER_CELL) * field.ndim)
    mean = by_cell.mean(axis=tuple(range(0, by_cell.ndim, 2)), keepdims=True)
    return np.broadcast_to(mean, by_cell.shape).reshape(field.shape)


def look(twin: Twin, noise: Noise) -> Iterator[Measure]:
    """Harmonics are 0 if all directions are alike, and 1 if there is one alone."""
    found: dict[str, list[float]] = {}
    for seed in SEEDS:
        field = block(twin, noise, seed)
        for name, vectors in (("structures", structures(field)), ("waves", waves(field))):
            for order in ORDERS[noise.dimensions]:
                found.setdefault(f"{name}, {order}", []).append(harmonic(*vectors, order))
        if noise.dimensions == 3:
            found.setdefault("slices", []).append(slices(twin, noise, seed))
        if noise.name == "perlin_worley":
            # Distances to the points of cells have another mean at another place of a cell.
            part = fixed_part(field)
            found.setdefault("the same in each cell", []).append(float(part.var() / field.var()))
            found.setdefault("waves without that", []).append(harmonic(*waves(field - part), 4))
    for name, values in found.items():
        yield Measure(noise.title, noise.dimensions, name, values,
                      LIMITS.get((noise.title, noise.dimensions, name)), name == "slices")


# --- Octave sums ------------------------------------------------------------------------------------------------------

SIDE = 1024       # samples along a picture
STEP = 2.0 ** -10  # cells: differences over it are slopes, as the cells of the finest octave are 2^-4
OCTAVES = 5       # so few that the samples show all of their waves
WAVES_PER_CELL = 40  # samples
LEAST_WAVES = 3.0  # cycles per cell: of longer waves a picture has too few
FAR = 1 << 20     # a period that no picture reaches: nothing turns with it
CUTS = {"": (0, 1), ", slices across z": (0, 1), ", slices across x": (1, 2), ", slices across y": (0, 2)}


def slopes(twin: Twin, dimensions: int, axes: Sequence[int], seed: int, period: int | None) -> Iterator[np.ndarray]:
    """Of a picture that does not wrap, anywhere in the plane or in space."""
    along = np.zeros((SIDE, SIDE, dimensions))
    along[..., list(axes)] = cells_of((0, 0), (SIDE, SIDE)).reshape(SIDE, SIDE, 2) / WAVES_PER_CELL
    places = (along + np.random.default_rng((seed, dimensions)).uniform(-500, 500, dimensions)).reshape(-1, dimensions)
    here, *moved = (twin.octave_sum(at, OCTAVES, seed, period).reshape(SIDE, SIDE).astype(float)
                    for at in (places, *(places + STEP * np.eye(dimensions)[axis] for axis in axes)))
    for there in moved:
        yield (there - here) / STEP


def wave_harmonic(along: Iterator[np.ndarray]) -> float:
    """The mean of cos(4 * angle) of the waves that slopes are made of, weighted by their power."""
    frequencies = np.meshgrid(*[np.fft.fftfreq(SIDE, 1 / WAVES_PER_CELL)] * 2, indexing="ij")
    length, window = np.hypot(*frequencies), np.outer(*[np.hanning(SIDE)] * 2)
    power = sum(np.abs(np.fft.fft2(slope * window)) ** 2 for slope in along)
    # Whole circles of frequencies: the corners of the square beyond them would count as diagonals.
    inside = (length > LEAST_WAVES) & (length < WAVES_PER_CELL / 2)
    return harmonic(np.stack(frequencies, -1)[inside], power[inside], 4)


def sums(twin: Twin, cut: str) -> Iterator[Measure]:
    """With a period octaves do not turn, for comparison."""
    n = 3 if cut else 2
    for period, name, limit in ((None, "waves, 4", WAVES), (FAR, "waves without rotation, 4", None)):
        yield Measure("hn_fbm", n, name + cut, [wave_harmonic(slopes(twin, n, CUTS[cut], seed, period))
                                                for seed in SEEDS], limit)
