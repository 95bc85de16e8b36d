"""Tests of cells against those at chosen distances, wider than any window: where a bit of a coordinate or of the seed
is another, and where a coordinate, spread by a constant, is nearly what it was.

A hash of the lattice multiplies each coordinate by an odd constant K, modulo 2^32. So for every number d there is a
lag L, d / K, after which the product is d further; and where d is a small number or a power of two, few bits of the
product are others. The following steps must separate such cells as well as neighbours.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

import numpy as np

from measure.hashes.judgement import Finding, normal
from measure.hashes.windows import AXES, BITS

REACH = 23        # hn_perlin takes positions below 2^23 in magnitude
NEAR = 16         # a product is near what it was if it is no more than 2^16 further: a 65,536th of a turn
TURN = 1 << 32    # coordinates are modulo this
PLACES = {"near": 12, "as positions": REACH, "anywhere": 31}  # cells are below a power of two in magnitude


def signed(value: int) -> int:
    """The number of the least magnitude that is the same modulo 2^32."""
    return (value + TURN // 2) % TURN - TURN // 2


def denominators(step: int) -> list[int]:
    """The denominators of the continued fraction of step / 2^32 up to 2^31: no lag below the next of them brings a
    coordinate that is multiplied by step as near to what it was."""
    found, before, numerator, denominator = [1], 0, step, TURN
    while numerator:
        part, rest = divmod(denominator, numerator)
        found.append(found[-1] * part + before)
        before, numerator, denominator = found[-2], rest, numerator
    return sorted({lag for lag in found if lag <= TURN // 2})


def powers(step: int) -> list[int]:
    """The lags after which the product is 2^k further, for k = 0, 1, ... NEAR."""
    return [signed(pow(step, -1, TURN) << k) for k in range(NEAR + 1)]


def near_returns(steps: tuple[tuple[int, ...], ...], dimensions: int) -> list[tuple[int, ...]]:
    """The lags for the constants that each axis may be multiplied by. Along an axis: denominators and powers. Along two
    axes: the same power of two further in both, or further in one and back in the other, which leaves the sum of the
    products as it was, and their exclusive or often, too."""
    def along(parts: dict[int, int]) -> tuple[int, ...]:
        return tuple(parts.get(axis, 0) for axis in range(dimensions))

    found = [along({axis: lag}) for axis in range(dimensions) for step in steps[axis]
             for lag in (*denominators(step), *powers(step))]
    for a, b in combinations(range(dimensions), 2):
        for first, second in product(steps[a], steps[b]):
            found += [along({a: one, b: signed(sign * other)}) for one, other in zip(powers(first), powers(second))
                      for sign in (1, -1)]
    return [*dict.fromkeys(found)]


def judge(hash_, dimensions: int, count: int) -> Iterator[Finding]:
    """Cells and seeds, as many in each place, against the others: how often each bit agrees."""
    rng = np.random.default_rng(48 + dimensions)
    points = [rng.integers(-(1 << bits), 1 << bits, (count, dimensions)) for bits in PLACES.values()]
    cells, seeds = np.concatenate(points), rng.integers(0, TURN, count * len(PLACES), np.uint32)
    before = hash_.words(cells, seeds)

    def compared(test: str, changes: list) -> Finding:
        z = []
        for moved, reseeded, _ in changes:
            changed = (before ^ hash_.words(moved(cells), reseeded(seeds))).reshape(len(PLACES), count)
            z.append([[_agreement(place, bit) for bit in BITS] for place in changed])
        return normal(test, np.array(z), lambda change, place, bit: f"bit {BITS[bit]}, {changes[change][2]}, "
                                                                    f"{[*PLACES][place]}")

    flips = [(lambda c, a=axis, b=bit: c ^ (np.arange(dimensions) == a) * (1 << b), lambda s: s,
              f"{AXES[axis]} bit {bit}")
             for axis in range(dimensions) for bit in range(REACH + 1)]
    flips += [(lambda c: c, lambda s, b=bit: s ^ np.uint32(1 << b), f"seed bit {bit}") for bit in range(32)]
    yield compared("avalanche", flips)
    yield compared("near returns", [(lambda c, by=lag: c + by, lambda s: s, f"lag {','.join(map(str, lag))}")
                                    for lag in near_returns(hash_.steps, dimensions)])


def _agreement(changed: np.ndarray, bit: int) -> float:
    """How many standard deviations a bit agrees too often."""
    return (changed.size - 2 * np.count_nonzero(changed & np.uint32(1 << bit))) / changed.size ** 0.5
