"""Tests over all distances at once, by Fourier transforms: of a window with itself, and with another."""

from __future__ import annotations

import numpy as np
from scipy import fft, stats

from measure.hashes.judgement import Finding, normal, peak
from measure.hashes.lattice import Lattice

WORKERS = 1  # the processes share the cores already


def self_inverse(shape: tuple[int, ...]) -> np.ndarray:
    """Where -i = i modulo the size along every axis: there a transform of real numbers is real."""
    inverse = np.ones(shape, bool)
    for axis, n in enumerate(shape):
        i = np.arange(n)
        inverse &= (2 * i % n == 0).reshape([-1 if a == axis else 1 for a in range(len(shape))])
    return inverse


def power(field: np.ndarray) -> np.ndarray:
    """The periodogram of a real field, of mean 1."""
    spectrum = np.abs(fft.fftn(field, workers=WORKERS)) ** 2
    return spectrum / spectrum.mean()


def correlation(spectrum: np.ndarray) -> np.ndarray:
    """The autocorrelation at all lags of the wrapping window (1 at lag 0), from the periodogram."""
    lags = fft.ifftn(spectrum, workers=WORKERS).real
    return lags / lags.flat[0]


def lag_scores(lags: np.ndarray) -> np.ndarray:
    """Autocorrelations as standard normal values. A lag that is its own opposite has each product twice."""
    z = lags * np.sqrt(lags.size)
    z[self_inverse(z.shape)] /= np.sqrt(2)
    z.flat[0] = 0
    return z


def ordinate_scores(spectrum: np.ndarray) -> np.ndarray:
    """Periodogram ordinates as exponential values of mean 1. Where the transform is real they are chi-square with one
    degree of freedom, and are replaced by the exponential value as improbable."""
    scores = spectrum.copy()
    real = self_inverse(spectrum.shape)
    scores[real] = -stats.chi2.logsf(spectrum[real], 1)
    return scores


def component(lattice: Lattice, axis: int) -> np.ndarray:
    return lattice.gradients[..., axis]


def autocorrelation(lattice: Lattice) -> list[Finding]:
    """The autocorrelation of each gradient component, and their spectral peaks."""
    spectra = [power(component(lattice, axis)) for axis in range(lattice.dimensions)]
    size = lattice.words.size
    z = np.stack([lag_scores(correlation(s)) for s in spectra])
    scores = np.stack([ordinate_scores(s) for s in spectra])
    at = np.unravel_index(np.argmax(scores), scores.shape)
    # Opposite lags and opposite frequencies have the same values: half of them count, and Bonferroni may count all.
    return [normal("autocorrelation", z, size, lambda axis, *lag: f"{'xyz'[axis]}, lag {signed(lag, z.shape[1:])}",
                   1 / np.sqrt(size)),
            peak("spectral peak", scores[at], stats.expon(), size, scores.size // 2,
                 f"{'xyz'[at[0]]}, frequency {signed(at[1:], z.shape[1:])}")]


def signed(index, shape) -> str:
    return ",".join(str(int(i) - n if 2 * i > n else int(i)) for i, n in zip(index, shape))


def bit_autocorrelation(lattice: Lattice) -> list[Finding]:
    """The correlation of each consumed bit over all lags, and of each with the next one: two at a time, as the real and
    the imaginary part of a field."""
    size = lattice.words.size
    axes = tuple(range(lattice.dimensions))
    worst: Finding | None = None
    pairs = [(int(a), int(b)) for a, b in zip(lattice.bits, np.roll(lattice.bits, -1))][::2]
    for a, b in pairs:
        field = (signs(lattice.words, a) + 1j * signs(lattice.words, b)).astype(np.complex64)
        spectrum = fft.fftn(field, workers=WORKERS)
        # The spectra of both: the one of a real field at -k is the conjugate of that at k.
        mirrored = np.conj(np.roll(np.flip(spectrum, axes), 1, axes))
        first, second = (spectrum + mirrored) / 2, (spectrum - mirrored) / 2j
        alone = fft.ifftn(np.abs(first) ** 2 + 1j * np.abs(second) ** 2, workers=WORKERS)
        crossed = fft.ifftn(np.conj(first) * second, workers=WORKERS)
        z = np.stack([alone.real, alone.imag, crossed.real]) / np.sqrt(size)
        z[:2, self_inverse(lattice.words.shape)] /= np.sqrt(2)  # there each product is in the sum twice
        z[:2, *([0] * lattice.dimensions)] = 0
        names = (f"bit {a}", f"bit {b}", f"bits {a} and {b}")
        one = normal("", z, size, lambda part, *lag: f"{names[part]}, lag {signed(lag, lattice.words.shape)}", pool=False)
        if worst is None or one.statistic > worst.statistic:
            worst = one
    return [peak("autocorrelation of bits", worst.statistic, stats.norm(), size, worst.comparisons * len(pairs),
                 worst.where, two_sided=True)]


def signs(words: np.ndarray, bit: int) -> np.ndarray:
    """1 where a bit is clear, -1 where it is set."""
    return 1 - 2 * (words >> np.uint32(bit) & 1).astype(np.float32)


def cross_correlation(a: Lattice, b: Lattice) -> Finding:
    """The correlation of two windows over all shifts: gradient against gradient, and against the reflected window."""
    return crossed("seeds: correlation", a.gradients, b.gradients)


def crossed(test: str, a: np.ndarray, b: np.ndarray) -> Finding:
    """The same of vectors in the cells of two windows, which the last axis has."""
    shape = a.shape[:-1]
    size, axes = int(np.prod(shape)), tuple(range(len(shape)))
    of_a = fft.fftn(a, axes=axes, workers=WORKERS)
    of_b = fft.fftn(b, axes=axes, workers=WORKERS)
    # A sum over the components of products of independent values whose variances are those of the components.
    variance = float(((a.astype(float) ** 2).mean(axis=axes) * (b.astype(float) ** 2).mean(axis=axes)).sum())
    z = np.stack([fft.ifftn((of_a * other).sum(axis=-1), workers=WORKERS).real
                  for other in (of_b.conj(), of_b)]) / np.sqrt(size * variance)
    return normal(test, z, size, lambda mirrored, *lag: f"{'mirrored, ' * mirrored}lag {signed(lag, shape)}",
                  1 / np.sqrt(size), pool=False)
