"""Measures how smooth slopes are with HN_FIXED, at random points; nothing here is proven. The slope of a pixel differs
from its neighbour's because the noise bends, and because both are rounded."""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from catalog.tables.markdown import table
from proof.bounds.rounded import EXACT, FIXED, NEAREST, Rounding, Text, along_axes

PITCHES = (60, 250, 1000)  # pixels to a cell, within a tenth: of some numbers all pixels are cut off alike
CASES = (("perlin", 2), ("perlin", 3), ("value", 2), ("value", 3))
POINTS = 1 << 13
ONE = 2**20  # of the fractions of fixed arithmetic


class Steps(NamedTuple):
    """From pixel to pixel: of the roundings, the root mean square and the largest; of the exact slope, the former."""
    rms: float
    largest: float
    own: float


def of(steps: np.ndarray, own: np.ndarray) -> Steps:
    return Steps(float(np.sqrt((steps**2).mean())), float(abs(steps).max()), float(np.sqrt((own**2).mean())))


@functools.cache
def text(*macros: str) -> Text:
    return Text([f"noise{dims}d.{noise}_d_cell" for noise, dims in CASES], *macros)


def measure(noise: str, dims: int, pitch: int) -> tuple[Steps, Steps]:
    """The steps of slopes that are differences of neighbouring pixels, and of the derivative that is returned."""
    rng = np.random.default_rng(1)
    cells = along_axes("c", rng.integers(-2**31, 2**31, (dims, POINTS))) | {"seed": 0}
    pixels = pitch * rng.uniform(0.9, 1.1, POINTS)
    along, *across = rng.random((dims, POINTS)) * (ONE - 2 * ONE / (0.9 * min(PITCHES)))

    def at(pixel: int, how: Rounding, *macros: str) -> list[np.ndarray]:
        places = [along + pixel * ONE / pixels, *across]
        f = [x / ONE for x in (places if how == EXACT else map(np.floor, places))]
        return text(*macros)(f"noise{dims}d.{noise}_d_cell", how, **cells, **along_axes("f", f))[:2]

    exact = np.array([at(pixel, EXACT) for pixel in range(3)])
    values, slopes = (np.array([at(pixel, NEAREST, FIXED) for pixel in range(3)]) - exact).transpose(1, 0, 2)
    exact_values, exact_slopes = exact.transpose(1, 0, 2)
    return (of(np.diff(values, 2, axis=0) * pixels, np.diff(exact_values, 2, axis=0) * pixels),
            of(np.diff(slopes[:2], axis=0), np.diff(exact_slopes[:2], axis=0)))


@functools.cache
def steps_table() -> str:
    def text_of(steps: Steps) -> str:
        return f"{steps.rms:.0e}, {steps.largest:.0e}; {steps.own:.0e}".replace("e-0", "e-")

    rows = []
    for noise, dims in CASES:
        by_pitch = [measure(noise, dims, pitch) for pitch in PITCHES]
        rows.append([f"`hn_{noise}(vec{dims})`", *(text_of(differences) for differences, _ in by_pitch)])
        rows.append([f"`hn_{noise}_d(vec{dims})`", *(text_of(returned) for _, returned in by_pitch)])
    return table(("", *(f"{pitch} pixels to a cell" for pitch in PITCHES)), rows)
