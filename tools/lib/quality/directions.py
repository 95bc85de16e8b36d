"""Tests of the gradients: where they point, and how long they are, held against the shape that they should have."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy import special, stats

from quality.judgement import Finding, normal, peak
from quality.lattice import Lattice

ORDERS = {2: 16, 3: 8}  # harmonics up to this order
CHUNK = 1 << 15  # vectors at a time, so that their harmonics stay in the cache
# Parts of a side for the numerical integration; in space a face has the square of them. Twice as many change no mean by
# more than 3e-6, a hundredth of the standard error of the 2^24 gradients of eight windows.
STEPS = {2: 1 << 16, 3: 1 << 8}

def lengthened(points: np.ndarray) -> np.ndarray:
    """The gradients that the library makes of points of |x| + |y| (+ |z|) = 1: docs/contract.md, section 4."""
    return points * (2 - np.abs(points).max(axis=-1, keepdims=True))


def shortened(gradients: np.ndarray) -> np.ndarray:
    """The points of |x| + |y| (+ |z|) = 1 in the same directions."""
    return gradients / np.abs(gradients).sum(axis=-1, keepdims=True)


def shape_points(dimensions: int) -> np.ndarray:
    """Gradients that stand for equal parts of the surface |x| + |y| (+ |z|) = 1."""
    t = (np.arange(STEPS[dimensions]) + 0.5) / STEPS[dimensions]
    if dimensions == 2:
        side = np.stack([t, 1 - t], axis=-1)
    else:
        # The centres of the small triangles into which parallels to the sides cut a face; both kinds of them.
        k = STEPS[3]
        i, j = np.meshgrid(np.arange(k), np.arange(k), indexing="ij")
        upright = np.stack([i, j], axis=-1)[i + j < k] + 1 / 3
        turned = np.stack([i, j], axis=-1)[i + j < k - 1] + 2 / 3
        ab = np.concatenate([upright, turned]) / k
        side = np.concatenate([ab, 1 - ab.sum(axis=-1, keepdims=True)], axis=-1)
    corners = np.stack(np.meshgrid(*[[1, -1]] * dimensions, indexing="ij"), axis=-1).reshape(-1, 1, dimensions)
    return lengthened((corners * side).reshape(-1, dimensions))


def harmonics(vectors: np.ndarray) -> dict[int, np.ndarray]:
    """For each order the harmonics of the vectors' directions, one per column, each of mean square 1 on the circle or
    the sphere."""
    unit = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    # Powers of x + i y: cosines and sines of multiples of the angle, times a power of its distance from the axis.
    around = [np.ones(len(unit), unit.dtype), unit[:, 0] + 1j * unit[:, 1]]
    while len(around) <= ORDERS[vectors.shape[-1]]:
        around.append(around[-1] * around[1])
    if vectors.shape[-1] == 2:
        return {m: 2 ** 0.5 * np.stack([around[m].real, around[m].imag], axis=-1) for m in range(1, ORDERS[2] + 1)}
    columns: dict[int, list[np.ndarray]] = {order: [] for order in range(1, ORDERS[3] + 1)}
    for m in range(ORDERS[3] + 1):
        for order, legendre in _legendre(unit[:, 2], m).items():
            # A Python float, which leaves 32-bit arrays what they are.
            scale = float(np.sqrt((2 * order + 1) * (1 if m == 0 else 2) * special.poch(order + m + 1, -2 * m)))
            columns[order] += [scale * legendre] if m == 0 else [scale * legendre * around[m].real,
                                                                 scale * legendre * around[m].imag]
    return {order: np.stack(some, axis=-1) for order, some in columns.items()}


def _legendre(z: np.ndarray, m: int) -> dict[int, np.ndarray]:
    """The associated Legendre functions of degrees 1 and up and order m, without their factor (1 - z^2)^(m/2), which is
    in the powers of x + i y; by the recurrence over the degree, which is much faster than scipy's function."""
    below, here = np.zeros_like(z), np.full_like(z, special.factorial2(2 * m - 1) if m else 1)
    table = {}
    for degree in range(m, ORDERS[3] + 1):
        if degree:
            table[degree] = here
        below, here = here, ((2 * degree + 1) * z * here - (degree + m) * below) / (degree + 1 - m)
    return table


@lru_cache(maxsize=None)
def shape_harmonics(dimensions: int) -> dict[int, tuple[np.ndarray, np.ndarray]]:
    """For each order the means of the harmonics on the shape, and the inverse of their covariance."""
    return {order: (h.mean(axis=0), np.linalg.inv(np.cov(h, rowvar=False)))
            for order, h in harmonics(shape_points(dimensions)).items()}


@lru_cache(maxsize=None)
def shape_moments(dimensions: int) -> tuple[np.ndarray, np.ndarray]:
    powers = _powers(shape_points(dimensions))
    return powers.mean(axis=0), powers.std(axis=0)


def _powers(g: np.ndarray) -> np.ndarray:
    """The first, second and fourth powers of the components, and their products in pairs."""
    products = [g[:, a] * g[:, b] for a in range(g.shape[1]) for b in range(a + 1, g.shape[1])]
    return np.stack([*g.T, *(g.T ** 2), *(g.T ** 4), *products], axis=-1)


def uniformity(lattice: Lattice) -> list[Finding]:
    """The harmonics of the directions against those of the shape, order by order; and moments of the components."""
    g = lattice.gradients.reshape(-1, lattice.dimensions)
    n = len(g)
    sums: dict[int, np.ndarray] = {}
    powers = 0.0
    for start in range(0, n, CHUNK):
        part = g[start:start + CHUNK]
        # In 32-bit floats: their errors, 2^-24 of each value, are far below 1 / sqrt(n), and it takes half the time.
        for order, found in harmonics(part).items():
            sums[order] = sums.get(order, 0) + found.sum(axis=0, dtype=float)
        powers = powers + _powers(part).sum(axis=0, dtype=float)
    tails = {}
    for order, total in sums.items():
        mean, inverse = shape_harmonics(lattice.dimensions)[order]
        away = total / n - mean
        tails[order] = stats.chi2.logsf(n * away @ inverse @ away, len(mean))
    worst = min(tails, key=lambda order: tails[order])
    mean, deviation = shape_moments(lattice.dimensions)
    # -log of a tail probability is exponential, whatever the degrees of freedom: so that orders compare.
    return [peak("directions: harmonics", -tails[worst], stats.expon(), n, len(tails), f"order {worst}"),
            normal("directions: moments", (powers / n - mean) / deviation * np.sqrt(n), n,
                   lambda i: MOMENTS[lattice.dimensions][i])]


MOMENTS = {2: ["x", "y", "x^2", "y^2", "x^4", "y^4", "xy"],
           3: ["x", "y", "z", "x^2", "y^2", "z^2", "x^4", "y^4", "z^4", "xy", "xz", "yz"]}


def on_shape(lattice: Lattice) -> Finding:
    """How far a gradient is from the one that the shape has in its direction, but for the rounding of floats."""
    gradients = lattice.gradients.astype(float)
    away = np.abs(gradients - lengthened(shortened(gradients))).max(axis=-1)
    return Finding("directions: on the shape", float(away.max()), 0.0, ROUNDING, float(away.max() <= ROUNDING),
                   lattice.words.size, 1)


# Three components of at most 1 are each rounded to a float, with an error of at most 2^-25. Their sum has three of
# these errors, a component of the point one more, and lengthening at most doubles the four. The gradient has the ninth.
ROUNDING = 9 * 2.0 ** -25
