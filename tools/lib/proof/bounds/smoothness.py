"""Measures how smooth slopes are with HN_FIXED, at random points; nothing here is proven. The slope of a pixel differs
from its neighbour's because the noise bends, and because both are rounded."""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from catalog.tables.markdown import table
from proof.bounds import exact_model as exact
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.rounded import FIXED, Rounding, Text, along_axes

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
def text() -> Text:
    return Text([f"noise{dims}d.{noise}{form}_cell" for noise, dims in CASES for form in ("", "_d")], FIXED)


def measure(noise: str, dims: int, pitch: int) -> tuple[Steps, Steps]:
    """The steps of slopes that are differences of neighbouring pixels, and of the derivative that is returned."""
    rng = np.random.default_rng(1)
    cells = list(rng.integers(-2**31, 2**31, (dims, POINTS)))
    words_of = exact.words_at(OCTAHEDRAL, cells)
    pixels = pitch * rng.uniform(0.9, 1.1, POINTS)
    along, *across = rng.random((dims, POINTS)) * (ONE - 2 * ONE / (0.9 * min(PITCHES)))
    values, slopes, exact_values, exact_slopes = [], [], [], []
    for pixel in range(3):
        places = [along + pixel * ONE / pixels, *across]
        fractions, exactly = [x.astype(np.int64) for x in places], [x / ONE for x in places]
        columns = along_axes("c", cells) | along_axes("f", [f / ONE for f in fractions]) | {"seed": 0}
        value, = text()(f"noise{dims}d.{noise}_cell", Rounding("nearest"), **columns)
        _, slope, *_ = text()(f"noise{dims}d.{noise}_d_cell", Rounding("nearest"), **columns)
        right, slopes_there = (exact.perlin(OCTAHEDRAL, words_of, exactly) if noise == "perlin"
                               else exact.value(words_of, exactly))
        values.append(value - right)
        slopes.append(slope - slopes_there[0])
        exact_values.append(right)
        exact_slopes.append(slopes_there[0])
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
