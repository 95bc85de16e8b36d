"""Whether the structures of the noise prefer the axes of the lattice, or its diagonals."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy import fft, stats

from measure.hashes.judgement import ALPHA, Finding
from measure.hashes.lattice import Lattice, cells_of
from measure.hashes.library import Twin

PER_CELL = 4      # samples along an axis; twice as many change no value by more than 0.004
SMOOTHING = 0.75  # cells, the deviation of the Gaussian: about the size of a blob
SIDES = {2: 256, 3: 32}  # cells of a block
BLOCKS = 4        # of each window

# The preference that is allowed. All structures across an axis would have 1. In the plane gradients of length 1 in
# uniform directions have -0.09, and in space the 12 edges of "Improving noise" (Perlin 2002) -0.103. Both are the usual
# choice where directions must not show: ours may have about as much.
AIM = {2: 0.1, 3: 0.11}
# The standard deviation of the statistic of a block on a random lattice, over 64 of them.
SPREAD = {2: 0.013, 3: 0.011}


def fade(t: np.ndarray) -> np.ndarray:
    return t * t * t * (t * (6 * t - 15) + 10)


def noise(gradients: np.ndarray, per_cell: int = PER_CELL) -> np.ndarray:
    """Perlin noise of the gradients of a window that wraps, before it is scaled; the samples are beside the lattice
    points."""
    f = ((np.arange(per_cell) + 0.5) / per_cell).astype(np.float32)
    t = fade(f)
    parts = list(np.moveaxis(gradients.astype(np.float32), -1, 0))
    # Along one axis after another: the sum of the ramps along the axes before is interpolated, and the ramp along this
    # one is added.
    total = np.float32(0)
    for axis, part in enumerate(parts):
        ramps = _between(part, axis, (1 - t) * f, t * (f - 1))
        total = ramps + (_between(total, axis, 1 - t, t) if axis else 0)
        parts[axis + 1:] = [_between(later, axis, 1 - t, t) for later in parts[axis + 1:]]
    return total


def _between(values: np.ndarray, axis: int, near: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Samples along an axis: each value times `near`, and the next one times `far`."""
    weights = [np.expand_dims(w, tuple(range(1, values.ndim - axis))) for w in (near, far)]
    samples = sum(np.expand_dims(v, axis + 1) * w for v, w in zip((values, np.roll(values, -1, axis)), weights))
    shape = list(values.shape)
    shape[axis] *= len(near)
    return samples.reshape(shape)


def structure(field: np.ndarray, per_cell: int = PER_CELL) -> np.ndarray:
    """The structure tensor of a field that wraps: the products of its derivatives, smoothed; a matrix for a
    place in each cell. The derivatives are exact: differences of neighbours would favour the diagonals by 0.04."""
    n = field.ndim
    axes = [fft.fftfreq(side, 1 / per_cell) for side in field.shape]
    axes[-1] = fft.rfftfreq(field.shape[-1], 1 / per_cell)
    waves = [2 * np.pi * f.astype(np.float32) for f in np.meshgrid(*axes, indexing="ij", sparse=True)]
    blur = np.exp(-SMOOTHING ** 2 / 2 * sum(w * w for w in waves))
    spectrum = fft.rfftn(field)
    slopes = [fft.irfftn(1j * w * spectrum, s=field.shape) for w in waves]
    tensor = np.empty((*(side // per_cell for side in field.shape), n, n), np.float32)
    for i in range(n):
        for j in range(i, n):
            smooth = fft.irfftn(fft.rfftn(slopes[i] * slopes[j]) * blur, s=field.shape)
            tensor[..., i, j] = tensor[..., j, i] = smooth[(slice(None, None, per_cell),) * n]
    return tensor.reshape(-1, n, n)


def across(tensor: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The directions across the strongest structures, and their weights: of the half of all places where the slopes are
    steepest, by the cube of how much the steepest direction exceeds the next one."""
    sizes, directions = np.linalg.eigh(tensor)
    energy = sizes.sum(axis=-1)
    strong = energy > np.median(energy)
    return directions[strong, :, -1], ((sizes[:, -1] - sizes[:, -2]) / energy)[strong] ** 3


def preference(vectors: np.ndarray) -> np.ndarray:
    """The first harmonic that a cube has: 1 along the axes, and of mean 0 over all directions. In the plane it is the
    cosine of four times the angle, and -1 along the diagonals; in space -2/3 along those of the cube."""
    n = vectors.shape[-1]
    return ((n + 2) * (vectors ** 4).sum(axis=-1) - 3) / (n - 1)


def of_gradients(gradients: np.ndarray) -> float:
    """The mean preference in the noise of a block of gradients."""
    return mean_preference(*across(structure(noise(gradients))))


def mean_preference(vectors: np.ndarray, weights: np.ndarray) -> float:
    return float(np.average(preference(vectors), weights=weights))


def blocks(gradients: np.ndarray) -> Iterator[np.ndarray]:
    """The first blocks of a window. Each is taken as one that wraps."""
    n = gradients.shape[-1]
    side = SIDES[n]
    for corner in list(np.ndindex(*(length // side for length in gradients.shape[:-1])))[:BLOCKS]:
        yield gradients[tuple(slice(c * side, (c + 1) * side) for c in corner)]


def of_window(lattice: Lattice) -> list[float]:
    return [of_gradients(block) for block in blocks(lattice.gradients)]


def judge(values: list[float], dimensions: int) -> Finding:
    """A verdict on the blocks of all windows: is it improbable if what they scatter about is within the aim?"""
    null = stats.norm(AIM[dimensions], SPREAD[dimensions] / len(values) ** 0.5)
    mean = float(np.mean(values))
    limit = float(null.isf(ALPHA))
    cells = len(values) * SIDES[dimensions] ** dimensions
    return Finding("isotropy", mean, AIM[dimensions], limit, float(null.sf(abs(mean))), cells, 1,
                   f"{'axes' if mean > 0 else 'diagonals'} preferred; {len(values)} blocks together", -limit)


def same_noise(twin: Twin, dimensions: int, seed: int) -> Finding:
    """The library's noise is that of its gradients, scaled, or else the test proves nothing about it."""
    side = {2: 64, 3: 16}[dimensions]
    ours = noise(twin.gradients(cells_of((0,) * dimensions, (side,) * dimensions), seed)
                 .reshape(*[side] * dimensions, dimensions))
    inside = (slice(0, (side - 1) * PER_CELL),) * dimensions  # the last cell has its far corners on the other side
    places = (cells_of((0,) * dimensions, ours.shape) + 0.5) / PER_CELL
    theirs = twin.noise(places, seed).reshape(ours.shape)[inside].astype(float)
    ours = ours[inside].astype(float)
    away = float(np.abs(theirs - ours * (theirs * ours).sum() / (ours * ours).sum()).max())
    return Finding("noise of the gradients", away, 0.0, ROUNDING, float(away <= ROUNDING), ours.size, 1, f"seed {seed}")


# Each of the two is the sum of at most 24 terms below 1, scaled by less than 2: some 2^-24 for each.
ROUNDING = 2.0 ** -18
