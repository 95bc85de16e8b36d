"""The hashes that are judged: the library's C++ twin, built once per setting of its knobs, for numpy arrays."""

from __future__ import annotations

import ctypes
import functools
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from base.tree import ROOT
from base.twin import compile_program

SOURCE = Path(__file__).resolve().parent / "lattice.cpp"
INCLUDE = ROOT / "include"
WORDS = ("word", "further")  # quantities that are no floats
# Factors with which hashes of a lattice often multiply the coordinates: the first primes of xxHash, in this order. They
# are tried where a library does not name its own.
USUAL_STEPS = ((0x9E3779B1,), (0x85EBCA77,), (0xC2B2AE3D,))


def _text_of(name: str, include: Path = INCLUDE) -> str:
    return (include.parent / "glsl" / "hashnoise" / name).read_text(encoding="utf-8")


def hash_names() -> dict[str, int]:
    """The hashes that the library offers, by their numbers; without the user's own."""
    found = re.findall(r"^#define HN_HASH_(\w+) (\d+)\b", _text_of("config.glsl"), re.MULTILINE)
    return {name: int(number) for name, number in found if name != "CUSTOM"}


def default_hash() -> str:
    """The hash that is used if HN_HASH is not defined."""
    return re.search(r"^#define HN_HASH HN_HASH_(\w+)", _text_of("config.glsl"), re.MULTILINE)[1]


def steps_of(include: Path = INCLUDE) -> tuple[tuple[int, ...], ...]:
    """For each axis the constants that spread its coordinates: by HN_I_STEP_X in detail/word.glsl and so on, or
    by names that have more before the axis. Where there are none, usual ones."""
    text = _text_of("detail/word.glsl", include)
    return tuple(tuple(int(value, 0) for value in
                       re.findall(rf"^#define HN_I_STEP\w*_{axis} (\w+?)u?\b", text, re.MULTILINE)) or usual
                 for axis, usual in zip("XYZ", USUAL_STEPS))


@dataclass
class Twin:
    """The library with one setting of its knobs."""
    name: str
    program: Path  # a shared library
    steps: tuple[tuple[int, ...], ...] = USUAL_STEPS  # that spread coordinates, by axis

    def evaluate(self, quantity: str, points: np.ndarray, *options) -> np.ndarray:
        """The quantity at points, which are rows of integers or of floats; the options are numbers behind each of them,
        or arrays of one for each."""
        n = points.shape[1]
        rows = np.concatenate([_bits(points), *(np.broadcast_to(_bits(np.asarray(option)), (len(points),))[:, None]
                                                for option in options)], axis=1)
        return self._run(quantity, n, rows)

    def _run(self, quantity: str, dimensions: int, rows: np.ndarray) -> np.ndarray:
        rows = np.ascontiguousarray(rows, np.uint32)
        numbers = {"further": dimensions - 1, "phasor": 2}.get(quantity, 1)  # of a value
        values = np.empty(len(rows) * numbers, np.uint32 if quantity in WORDS else np.float32)
        evaluate = _loaded(self.program)[f"{quantity}{dimensions}"]
        evaluate(ctypes.c_void_p(rows.ctypes.data), ctypes.c_void_p(values.ctypes.data), ctypes.c_size_t(len(rows)))
        return values

    def words(self, cells: np.ndarray, seeds) -> np.ndarray:
        """hn_i_point of cells (rows of integers), with one seed or one for each."""
        return self.evaluate("word", cells, seeds)

    def further(self, words: np.ndarray, dimensions: int) -> list[np.ndarray]:
        """The words of the components of a vector but the first, which has the given ones."""
        return [*self._run("further", dimensions, words).reshape(-1, dimensions - 1).T]

    def tile(self, name: str, positions: np.ndarray, period: int, seed: int, phase: float | None = None) -> np.ndarray:
        """hn_<name> with a period, the same along each axis, and with a phase in turns."""
        phases = [] if phase is None else [float(phase)]
        return self.evaluate(name + "_phase" * len(phases), positions, *phases, period, seed)

    def phasor(self, positions: np.ndarray, period: int, wave: Sequence[float], seed: int) -> np.ndarray:
        """hn_phasor with a period, the same along each axis: the value and its quadrature as complex numbers."""
        return self.evaluate("phasor", positions, period, *map(float, wave), seed).view(np.complex64)

    def octave_sum(self, positions: np.ndarray, octaves: int, seed: int, period: int | None = None) -> np.ndarray:
        """hn_fbm from cells and fractions, where its octaves are at exact positions."""
        cells = np.floor(positions)
        fractions = [*(positions - cells).T]
        tiled = [] if period is None else [period]
        return self.evaluate("tiled_" * len(tiled) + "fbm", cells.astype(np.int64), *fractions, octaves, *tiled, seed)


@functools.cache
def _loaded(library: Path) -> ctypes.CDLL:
    return ctypes.CDLL(str(library))


def _bits(numbers: np.ndarray) -> np.ndarray:
    """Integers modulo 2^32, or the bits of floats."""
    if numbers.dtype.kind == "f":
        return numbers.astype(np.float32).view(np.uint32)
    return (numbers.astype(np.int64, copy=False) & 0xFFFFFFFF).astype(np.uint32)


def build(name: str, macros: list[str], folder: Path, include: Path = INCLUDE) -> Twin:
    """Compiles a twin into a folder; macros are like HN_HASH=1."""
    program = folder / re.sub(r"\W", "_", name)
    compile_program(name, SOURCE, program, "-shared", "-fPIC", include=include, macros=macros)
    return Twin(name, program, steps_of(include))
