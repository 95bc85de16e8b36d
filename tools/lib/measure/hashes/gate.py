"""The gate lists the measurements of a hash: which windows, distances and streams, with which seeds."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from measure.hashes import lags, streams, windows
from measure.hashes.judgement import Finding
from measure.hashes.windows import Window, cells_of

# Around the origin, where people look, and where a hash may mirror; negative; at the end of what hn_perlin takes; and
# near the ends of int.
ORIGINS = {
    2: ((-512, -512), (-3000000, -70000), (8387584, 8387584), (2000000011, -1900000007)),
    3: ((-64, -64, -64), (-3000000, -70000, -12345), (8388480, 8388480, 8388480), (2000000011, -1900000007, 30000001)),
}
SIDES = {2: 1024, 3: 128}
# Consecutive; what octaves are apart (docs/reference/contract.md, section 7); any.
SEEDS = (0, 1, 0x9E3779B9, 0xDEADBEEF)
LONG = {2: (1024, 1024), 3: (32, 32, 1024)}  # windows for copies: a short line that is a copy of another shows little


@dataclass(frozen=True)
class Effort:
    origins: int = 4
    seeds: tuple[int, ...] = SEEDS
    samples: int = 1 << 15  # pairs of cells, in each place and at each distance
    windows: int = 12       # anywhere, in which only copied lines are looked for
    streams: int = 10       # p-values of each of dieharder's tests: of fewer than seven it finds nothing improbable


FULL = Effort()
QUICK = Effort(1, (0, 0xDEADBEEF), 1 << 14, 2, 8)


def sample(hash_, dimensions: int, origin: tuple[int, ...], seed: int, shape: tuple[int, ...] = ()) -> Window:
    shape = shape or (SIDES[dimensions],) * dimensions
    return Window(hash_.words(cells_of(origin, shape), seed).reshape(shape),
                  f"origin {','.join(map(str, origin))}, seed {seed}")


def of_windows(hash_, dimensions: int, effort: Effort) -> Iterator[Finding]:
    """Windows, each alone; and those of other seeds and of the components of vectors against the first."""
    together = []
    for origin, seed in zip(ORIGINS[dimensions][:effort.origins], effort.seeds):
        window = sample(hash_, dimensions, origin, seed)
        yield from windows.judge(window)
        together = together or [window]
    first, = together
    for seed in effort.seeds[1:]:
        together.append(sample(hash_, dimensions, ORIGINS[dimensions][0], seed))
        yield windows.crossed("seeds", first, together[-1])
    components = [Window(words.reshape(first.words.shape), f"component {axis}")
                  for axis, words in zip("yz", hash_.further(first.words.reshape(-1), dimensions))]
    for component in components:
        yield windows.crossed("components", first, component)
    yield windows.parities([first, *components])
    together += components
    yield from windows.placed([windows.copied_runs(together)], "seeds and components together")
    rng = np.random.default_rng(64 + dimensions)
    for _ in range(effort.windows):
        origin = tuple(map(int, rng.integers(-(1 << 31), (1 << 31) - 1024, dimensions)))
        window = sample(hash_, dimensions, origin, 0, LONG[dimensions])
        yield from windows.placed([windows.copied_lines(window)], window.place)


def judge(hash_, dimensions: int, effort: Effort) -> Iterator[tuple[str, list[Finding]]]:
    """The parts of the gate, and what each finds of a hash in the plane or in space."""
    yield "windows", [*of_windows(hash_, dimensions, effort)]
    yield "distances", [*lags.judge(hash_, dimensions, effort.samples)]
    for order in streams.ORDERS:
        yield f"dieharder, {order}", streams.judge(hash_, dimensions, order, effort.streams)
