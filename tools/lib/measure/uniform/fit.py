"""Fits the spreads of noises.

The distribution of a sum is that of independent octaves: the product of their characteristic functions. Of each noise
and a few sums of it the fit makes the largest difference small; the ends of a spread are ordered, so that its tail
rises. A power of the differences, which grows from step to step, stands for the largest."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares

from measure.uniform.model import SPAN, SUBJECTS, UNITS, Bell, rho, shape_of_sum, uniform, variance, weights

SUMS = ((1, 0.5), (2, 0.5), (3, 0.5), (4, 0.5), (8, 0.5), (2, 0.7), (4, 0.7), (2, 1.0), (3, 0.3), (8, 0.8))
FOURTH = np.array([rho(*sum_, 4) for sum_ in SUMS])[:, None]
EIGHTH = np.array([rho(*sum_, 8) for sum_ in SUMS])[:, None]
# In deviations: denser near 0, where noise that is 0 at lattice points has a crease.
AT = np.concatenate([np.arange(0.0, 0.2, 0.02), np.arange(0.2, 4.0, 0.04)])
COARSE = 1 << 12  # bins of the characteristic functions
SCALE = 0.002  # differences of this size count as 1
STEPS = (1.0, 2.0, 4.0, 6.0)
# The gain of a spread that rises from each coefficient to the next, beside its fit.
ORDER = 300.0
MARGIN = 0.001


def deviation(density: np.ndarray) -> float:
    at = (np.arange(len(density)) + 0.5) * (SPAN / len(density)) - SPAN / 2
    return float(np.sqrt((density * at**2).sum()))


def distributions(density: np.ndarray) -> np.ndarray:
    """How many values are between 0 and AT deviations, for each of SUMS."""
    coarse = density.reshape(COARSE, -1).sum(1)
    step = SPAN / COARSE
    # The characteristic function of the coarse values, which are symmetrical about 0, at steps that a spline follows.
    padded = np.zeros(8 * COARSE)
    padded[:COARSE] = coarse
    frequencies = np.fft.rfftfreq(8 * COARSE, d=step) * 2 * np.pi
    of_noise = (np.fft.rfft(padded) * np.exp(1j * frequencies * (SPAN / 2 - step / 2))).real
    spline = CubicSpline(np.concatenate([-frequencies[:0:-1], frequencies]),
                         np.concatenate([of_noise[:0:-1], of_noise]))
    wanted = np.fft.rfftfreq(2 * COARSE, d=step) * 2 * np.pi
    found = []
    for octaves, gain in SUMS:
        of_octaves = weights(octaves, gain)
        of_sum = np.prod([spline(wanted * weight) for weight in of_octaves / of_octaves.sum()], axis=0)
        summed = np.fft.irfft(of_sum * np.exp(-1j * wanted * (SPAN / 2 - step / 2)), 2 * COARSE)[:COARSE]
        summed = (summed + summed[::-1]) / (2.0 * summed.sum())
        cumulated = np.concatenate([[0.0], np.cumsum(summed)])
        edges = np.arange(COARSE + 1) * step - SPAN / 2
        found.append(np.interp(AT * deviation(summed), edges, cumulated) - 0.5)
    return np.array(found)


def of_model(spread: np.ndarray, bell: Bell) -> np.ndarray:
    """The same by the model; the reach of the spread is in deviations."""
    shape = spread[1:]
    shapes = shape_of_sum(shape, bell, FOURTH, EIGHTH)
    reaches = spread[0] * np.sqrt(variance(shape) / variance(shapes))
    return uniform(AT[None], reaches[:, None], shapes[:, None, :]) - 0.5


def disorder(spread: np.ndarray) -> np.ndarray:
    return np.maximum(np.diff(np.concatenate([[0.0], spread[1:], [1.0]])) * -1.0 + MARGIN, 0.0)


def differences(spread: np.ndarray, bell: Bell, wanted: np.ndarray, power: float) -> np.ndarray:
    found = (of_model(spread, bell) - wanted).ravel() / SCALE
    return np.concatenate([np.sign(found) * np.abs(found) ** power, ORDER * 4.0**power * disorder(spread)])


def fitted(wanted: np.ndarray, bell: Bell, start: np.ndarray) -> np.ndarray:
    spread = start
    for power in STEPS:
        spread = least_squares(differences, spread, x_scale=0.1, max_nfev=150, args=(bell, wanted, power)).x
    return spread


START = np.array([2.7, 0.1, 0.45, 0.72])


def spreads(densities: Mapping[int, np.ndarray], bell: Bell) -> dict[str, tuple[float, ...]]:
    """By the names of the noises, in multiples of 1 / UNITS."""
    found = {}
    for subject in SUBJECTS:
        density = densities[subject.number]
        spread = fitted(distributions(density), bell, START)
        spread[0] *= deviation(density)
        found[subject.name] = tuple(np.round(spread * UNITS) / UNITS)
    return found
