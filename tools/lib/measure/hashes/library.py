"""The hashes that are judged: the library's C++ twin, built once per setting of its knobs, for numpy arrays."""

from __future__ import annotations

import re
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from base.twin import NotBuilt, compile_program

SOURCE = Path(__file__).resolve().parent / "lattice.cpp"
AXES = "xyzw"
WORDS = ("word", "further")  # quantities that are no floats
# Factors with which hashes of a lattice often multiply the coordinates: the first primes of xxHash, in this order. They
# are tried where a library does not state what it takes.
USUAL_STEPS = ((0x9E3779B1,), (0x85EBCA77,), (0xC2B2AE3D,), (0x27D4EB2F,))
STAGE_PROBES = 4096  # words
LEAST_CHANGED = 1 / 16  # of them, whose gradient a consumed bit changes


def hash_names(include: Path) -> dict[str, int]:
    """The hashes that a library offers, by their numbers in its config.glsl; without the user's own."""
    config = include.parent / "glsl" / "hashnoise" / "config.glsl"
    try:
        text = config.read_text(encoding="utf-8")
    except OSError as error:
        raise NotBuilt(f"{include} is not a library: {error}") from error
    names = {name: int(number) for name, number in re.findall(r"^#define HN_HASH_(\w+) (\d+)\b", text, re.MULTILINE)}
    names.pop("CUSTOM", None)
    if not names:
        raise NotBuilt(f"{config} names no hash")
    return names


def default_hash(include: Path) -> str:
    """The hash that is used if HN_HASH is not defined."""
    config = include.parent / "glsl" / "hashnoise" / "config.glsl"
    found = re.search(r"^#define HN_HASH HN_HASH_(\w+)", config.read_text(encoding="utf-8"), re.MULTILINE)
    if not found:
        raise NotBuilt(f"{config} names no default for HN_HASH")
    return found[1]


def steps_of(include: Path) -> tuple[tuple[int, ...], ...]:
    """For each axis the constants that spread its coordinates: by HN_I_STEP_X in detail/word.glsl and so on, or by
    names that have more before the axis. Where there are none, usual ones."""
    text = (include.parent / "glsl" / "hashnoise" / "detail" / "word.glsl").read_text(encoding="utf-8")
    steps = []
    for axis, usual in zip(AXES.upper(), USUAL_STEPS):
        found = re.findall(rf"^#define (HN_I_STEP\w*_{axis}) (\w+?)u?\b", text, re.MULTILINE)
        for name, value in found:
            if int(value, 0) % 2 == 0:
                raise NotBuilt(f"{include}: {name} is {value}, which is even: it would not distinguish cells")
        steps.append(tuple(dict.fromkeys(int(value, 0) for _, value in found)) or usual)
    return tuple(steps)


@dataclass
class Twin:
    """The library with one setting of its knobs."""
    name: str
    program: Path
    bits: dict[int, np.ndarray] = field(default_factory=dict)
    steps: tuple[tuple[int, ...], ...] = field(default=USUAL_STEPS, kw_only=True)  # that spread coordinates, by axis

    def evaluate(self, quantity: str, dimensions: int, points: np.ndarray) -> np.ndarray:
        # A file, since subprocess writes into a pipe by 512 bytes, which takes longer than the program does.
        with tempfile.TemporaryFile() as given:
            given.write(np.ascontiguousarray(points))
            given.seek(0)
            done = subprocess.run([self.program, quantity, str(dimensions)], stdin=given, stdout=subprocess.PIPE,
                                  check=True)
        return np.frombuffer(done.stdout, np.uint32 if quantity in WORDS else np.float32)

    def words(self, cells: np.ndarray, seeds) -> np.ndarray:
        """hn_i_point of cells (rows of integers), with one seed or one for each."""
        return self.evaluate("word", cells.shape[1], _points(cells, seeds))

    def gradients(self, cells: np.ndarray, seeds) -> np.ndarray:
        return self.evaluate("gradient", cells.shape[1], _points(cells, seeds)).reshape(cells.shape)

    def noise(self, positions: np.ndarray, seed: int) -> np.ndarray:
        return self.evaluate("noise", positions.shape[1], _points(positions.astype(np.float32).view(np.uint32), seed))

    def further(self, words: np.ndarray, dimensions: int) -> list[np.ndarray]:
        """The words of the components of a vector but the first, which has the given ones."""
        found = self.evaluate("further", dimensions, words).reshape(*words.shape, dimensions - 1)
        return [np.ascontiguousarray(component) for component in np.moveaxis(found, -1, 0)]

    def vectors(self, name: str, positions: np.ndarray, seed: int) -> np.ndarray:
        """hn_<name>_vector: a row for each position."""
        points = _points(positions.astype(np.float32).view(np.uint32), seed)
        return self.evaluate(f"{name}_vector", positions.shape[1], points).reshape(positions.shape)

    def tile(self, name: str, positions: np.ndarray, period: int, seed: int, phase: float | None = None) -> np.ndarray:
        """hn_<name> with a period, the same along each axis, and with a phase in turns."""
        phases = () if phase is None else (np.float32(phase).view(np.uint32),)
        points = np.empty((len(positions), positions.shape[1] + len(phases) + 2), np.uint32)
        points[:, :positions.shape[1]] = positions.astype(np.float32).view(np.uint32)
        points[:, positions.shape[1]:] = *phases, period, seed
        return self.evaluate(f"{name}_phase" if phases else name, positions.shape[1], points)

    def phasor(self, positions: np.ndarray, period: int, wave, seed: int) -> np.ndarray:
        """hn_phasor with a period, the same along each axis: the value and its quadrature as complex numbers."""
        n = positions.shape[1]
        points = np.empty((len(positions), 2 * n + 2), np.uint32)
        points[:, :n] = positions.astype(np.float32).view(np.uint32)
        points[:, n:] = [period, *np.array(wave, np.float32).view(np.uint32), seed]
        return self.evaluate("phasor", n, points).view(np.complex64)

    def octave_sum(self, positions: np.ndarray, octaves: int, lacunarity: float, gain: float, seed: int,
                   period: int | None = None) -> np.ndarray:
        """hn_fbm from cells and fractions, where its octaves are at exact positions; with a period, the same along each
        axis."""
        n = positions.shape[1]
        cells = np.floor(positions)
        options = [octaves, *np.array([lacunarity, gain], np.float32).view(np.uint32)]
        options += [seed] if period is None else [period, seed]
        points = np.empty((len(positions), 2 * n + len(options)), np.uint32)
        points[:, :n] = cells.astype(np.int64) & 0xFFFFFFFF
        points[:, n:2 * n] = (positions - cells).astype(np.float32).view(np.uint32)
        points[:, 2 * n:] = options
        return self.evaluate("sum" if period is None else "tiled_sum", n, points)

    def stage(self, words: np.ndarray, dimensions: int) -> np.ndarray:
        """hn_gradient2 or hn_gradient3 of words."""
        return self.evaluate("stage", dimensions, words).reshape(*words.shape, dimensions)

    def consumed(self, dimensions: int) -> np.ndarray:
        """The bits of a word that the gradient stage uses, highest first: found by changing each. In space the size of
        a word chooses axes: bit 31 decides all of these choices, and each lower bit half as many as the one above."""
        if dimensions not in self.bits:
            words = np.random.default_rng(0).integers(0, 1 << 32, STAGE_PROBES, np.uint32)
            before = self.stage(words, dimensions)
            changed = [(self.stage(words ^ np.uint32(1 << bit), dimensions) != before).any(axis=-1).mean()
                       for bit in range(32)]
            self.bits[dimensions] = np.flatnonzero(np.array(changed) >= LEAST_CHANGED)[::-1]
        return self.bits[dimensions]


def _points(cells: np.ndarray, seeds) -> np.ndarray:
    points = np.empty((cells.shape[0], cells.shape[1] + 1), np.uint32)
    points[:, :-1] = cells.astype(np.int64, copy=False) & 0xFFFFFFFF
    points[:, -1] = seeds
    return points


def build(name: str, macros: list[str], include: Path, folder: Path) -> Twin:
    """Compiles a twin into a folder; macros are like HN_HASH=1."""
    program = folder / re.sub(r"\W", "_", name)
    compile_program(name, SOURCE, program, include=include, macros=macros)
    return Twin(name, program, steps=steps_of(include))
