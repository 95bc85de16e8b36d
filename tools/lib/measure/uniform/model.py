"""The noises that have distributions, the model of docs/reference/contract.md, section 21, on arrays, and the program that
samples."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np

from base.tree import GLSL, ROOT
from base.twin import compile_program

HERE = Path(__file__).resolve().parent
LIMIT = 3.0  # of the reach
UNITS = 4096  # spreads are multiples of 1 / UNITS
PARTS = 1024  # and the bell and the way of 1 / PARTS
BINS = 1 << 16
SPAN = 3.0  # the histograms of the sampler are over [-SPAN / 2, SPAN / 2]

SUBJECT = re.compile(r"^(SINE_)?SUBJECT\((\d+), (\w+), (\d), (\w+)\)$", re.MULTILINE)
OF_SUM = re.compile(r"hn_i_of_sum\(\w, (\d+), (\d+), d,")
SPREAD = re.compile(r"HN_DISTRIBUTION_(\w+)\) return hn_i_distribution\((\d+), (\d+), (\d+), (\d+)\);")
LAST = re.compile(r"^  return hn_i_distribution\((\d+), (\d+), (\d+), (\d+)\);", re.MULTILINE)


@dataclass(frozen=True)
class Subject:
    number: int
    name: str
    axes: int
    function: str
    is_sine: bool

    @property
    def title(self) -> str:
        vector = f"vec{self.axes}" if self.axes > 1 else "float"
        return f"`{self.function}({vector})`{', sine' if self.is_sine else ''}"


SUBJECTS = tuple(Subject(int(number), name, int(axes), function, bool(sine))
                 for sine, number, name, axes, function in SUBJECT.findall((HERE / "subjects.inc").read_text("utf-8")))


class Bell:
    """Limits of sums, and their rates: two columns of three numbers."""

    def __init__(self, numbers: np.ndarray) -> None:
        self.end, self.way = numbers

    @staticmethod
    def of(text: str) -> Bell:
        found = OF_SUM.findall(text)
        if len(found) != 3:
            raise ValueError("uniform.glsl: three calls of hn_i_of_sum were expected")
        return Bell(np.array(found, dtype=float).T / PARTS)


def spreads_of(text: str) -> dict[str, tuple[float, ...]]:
    """By their names, as uniform.glsl has them."""
    found = {name: numbers for name, *numbers in SPREAD.findall(text)}
    last = LAST.search(text)
    missing = {subject.name for subject in SUBJECTS} - set(found) - {"PERLIN2"}
    if missing or last is None:
        raise ValueError(f"uniform.glsl: hn_distribution has no line of {', '.join(sorted(missing)) or 'PERLIN2'}")
    found["PERLIN2"] = list(last.groups())
    return {name: tuple(int(number) / UNITS for number in numbers) for name, numbers in found.items()}


def library_text(library: Path = GLSL) -> str:
    return (library / "uniform.glsl").read_text(encoding="utf-8")


def variance(shape: np.ndarray) -> np.ndarray:
    """Of values, divided by the square of the reach. The last axis of a shape has a, b and c."""
    return (shape @ np.array([65.0, 33.0, 17.0]) + 7.0) / 315.0


def weights(octaves: float, gain: float) -> np.ndarray:
    count = max(int(np.ceil(octaves)), 1)
    found = gain ** np.arange(count)
    if count > 1:
        found[-1] *= octaves - (count - 1)
    return found


def rho(octaves: float, gain: float, power: int) -> float:
    of_octaves = weights(octaves, gain)
    return float((of_octaves ** power).sum() / (of_octaves ** 2).sum() ** (power / 2))


def shape_of_sum(shape: np.ndarray, bell: Bell, fourth: np.ndarray, eighth: np.ndarray) -> np.ndarray:
    h = (shape[..., 2:] - bell.end[2]) * bell.way
    return np.clip(bell.end + fourth * h + eighth * (shape - bell.end - h), 0.0, 1.0)


def uniform(values: np.ndarray, reach: np.ndarray, shape: np.ndarray) -> np.ndarray:
    """Of values from 0 on."""
    a, b, c = np.moveaxis(shape, -1, 0)
    y = np.maximum(1.0 - values / reach, 0.0) ** 2
    rest = 1.0 - y
    return 1.0 - 0.5 * (4 * a * y * rest**3 + 6 * b * (y * rest) ** 2 + 4 * c * y**3 * rest + y**4)


class Sampler:
    """The library, with each gradient when it is first used; `include` is the header's folder, and `macros` are knobs."""

    def __init__(self, folder: Path, include: Path = ROOT / "include", macros: Sequence[str] = ()) -> None:
        self.folder, self.include, self.macros = folder, include, macros
        self.libraries: dict[bool, ctypes.CDLL] = {}

    def library(self, is_sine: bool = False) -> ctypes.CDLL:
        if is_sine not in self.libraries:
            made = self.folder / f"sampler{'_sine' * is_sine}"
            compile_program("the sampler", HERE / "sampler.cpp", made, "-shared", "-fPIC", include=self.include,
                            macros=[*self.macros, *["HN_GRADIENT=2"] * is_sine])
            self.libraries[is_sine] = ctypes.CDLL(str(made))
        return self.libraries[is_sine]

    def densities(self, points: int) -> dict[int, np.ndarray]:
        """Of each noise, by number: symmetrical, since the noises are."""
        found = {}
        for subject in SUBJECTS:
            bins = np.zeros(BINS, ctypes.c_long)
            self.library(subject.is_sine).values(subject.number, ctypes.c_long(points), _at(bins))
            bins += bins[::-1]
            found[subject.number] = bins / bins.sum()
        return found

    def errors(self, points: int, spreads: Mapping[str, Sequence[float]], sums: Sequence[tuple[float, float]],
               subjects: Sequence[Subject] = SUBJECTS) -> dict[tuple[str, float, float], float]:
        """The largest errors of the distribution, by noise, octaves and gain."""
        found, edges = {}, np.arange(1, BINS + 1) / BINS
        for subject, (octaves, gain) in product(subjects, sums):
            bins, spread = np.zeros(BINS, ctypes.c_long), np.array(spreads[subject.name], np.float32)
            self.library(subject.is_sine).uniforms(subject.number, ctypes.c_float(octaves), ctypes.c_float(gain), _at(spread),
                                                   ctypes.c_long(points), _at(bins))
            found[subject.name, octaves, gain] = float(np.abs(bins.cumsum() / points - edges).max())
        return found


def _at(numbers: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(numbers.ctypes.data)
