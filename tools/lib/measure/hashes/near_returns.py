"""Tests at the distances after which a coordinate, spread by a constant, is nearly what it was.

A hash of the lattice multiplies each coordinate by an odd constant K, modulo 2^32. So for every number d there is a
lag L, d / K, after which the product is d further; and where d is a small number or a power of two, few bits of the
product are others. The following steps must separate such cells as well as neighbours. Most of these lags are wider
than any window, so no test of a window sees them.
"""

from __future__ import annotations

import numpy as np

from measure.hashes.judgement import Finding, normal, poisson
from measure.hashes.lattice import varying_bits
from measure.hashes.library import AXES, Twin

REACH = 23       # hn_perlin takes positions below 2^23 in magnitude
BATCH = 1 << 18  # pairs of cells at a time
NEAR = 16        # a product is near what it was if it is no more than 2^16 further: a 65,536th of a turn
TURN = 1 << 32   # coordinates are modulo this


def signed(value: int) -> int:
    """The number of the least magnitude that is the same modulo 2^32."""
    return (value + TURN // 2) % TURN - TURN // 2


def denominators(step: int) -> list[int]:
    """The denominators of the continued fraction of step / 2^32 up to 2^31: no lag below the next of them brings a
    coordinate that is multiplied by step as near to what it was. (After 2^31 the same pairs of cells come again.)"""
    found, before, numerator, denominator = [1], 0, step, TURN
    while numerator:
        part, rest = divmod(denominator, numerator)
        found.append(found[-1] * part + before)
        before, numerator, denominator = found[-2], rest, numerator
    return sorted({lag for lag in found if lag <= TURN // 2})


def powers(step: int) -> list[int]:
    """The lags after which the product is 2^k further, for k = 0, 1, ... NEAR."""
    return [signed(pow(step, -1, TURN) << k) for k in range(NEAR + 1)]


def lags_of(steps: tuple[tuple[int, ...], ...], dimensions: int) -> tuple[np.ndarray, list[str]]:
    """All lags for the constants that each axis may be multiplied by, as rows, and what to call them. Along an axis:
    denominators and powers. Along two axes: the same power of two further in both, or further in one and back in the
    other, which leaves the sum of the products as it was, and their exclusive or often, too."""
    rows: dict[tuple[int, ...], str] = {}

    def add(parts: dict[int, int], what: str) -> None:
        row = tuple(parts.get(axis, 0) for axis in range(dimensions))
        rows.setdefault(row, f"lag {','.join(map(str, row))} ({what})")

    for axis in range(dimensions):
        for step in steps[axis]:
            for lag in denominators(step):
                add({axis: lag}, f"{AXES[axis]} times {step:#x} {signed(lag * step):+}")
            for k, lag in enumerate(powers(step)):
                add({axis: lag}, f"{AXES[axis]} times {step:#x} +2^{k}")
    for a in range(dimensions):
        for b in range(a + 1, dimensions):
            for first in steps[a]:
                for second in steps[b]:
                    for k, (one, other) in enumerate(zip(powers(first), powers(second))):
                        for sign in (1, -1):
                            add({a: one, b: signed(sign * other)}, f"{AXES[a]} times {first:#x} +2^{k}, {AXES[b]} "
                                f"times {second:#x} {'+' if sign > 0 else '-'}2^{k}")
    return np.array(list(rows)), list(rows.values())


def places(dimensions: int, count: int) -> dict[str, np.ndarray]:
    """Cells to start from: of the whole domain, and as near to the origin as positions are, where high bits of
    coordinates are alike. They are drawn: the cells of a window share their coordinates, so that they are not
    independent, and their sum is not normal."""
    rng = np.random.default_rng(48 + dimensions)
    return {where: rng.integers(-reach, reach, (count, dimensions))
            for where, reach in (("anywhere", 1 << 31), ("as positions", 1 << REACH))}


def near_returns(twin: Twin, dimensions: int, seed: int, count: int) -> list[Finding]:
    """Cells, as many in each place, against those at each lag: bits that agree, gradients that correlate, and equal
    words."""
    lags, names = lags_of(twin.steps, dimensions)
    bits = twin.consumed(dimensions)
    starts = places(dimensions, count)
    cells = np.concatenate(list(starts.values()))
    before = twin.words(cells, seed)
    gradients = twin.stage(before, dimensions).reshape(len(starts), count, dimensions)
    # The product of two components has the product of their variances.
    deviation = np.sqrt(((gradients.astype(float) ** 2).mean(axis=(0, 1)) ** 2).sum())
    agreement, products, equal = [], [], 0
    for some in np.array_split(lags, -(-len(lags) * len(cells) // BATCH)):
        words = twin.words((cells + some[:, None]).reshape(-1, dimensions), seed)
        others = twin.stage(words, dimensions).reshape(len(some), len(starts), count, dimensions)
        changed = (before ^ words.reshape(len(some), -1)).reshape(len(some), len(starts), count)
        agreement.append(np.stack([_agreement(changed, bit) for bit in bits], axis=-1))
        dots = np.einsum("pci,lpci->lp", gradients, others, dtype=float)
        products.append(dots / (deviation * np.sqrt(count)))
        equal += int(np.count_nonzero(changed == 0))
    where = list(starts)

    def named(lag: int, place: int) -> str:
        return f"{names[lag]}, {where[place]}"

    pairs = len(lags) * len(cells)
    scale = 1 / np.sqrt(count)
    return [normal("near returns", np.concatenate(agreement), count,
                   lambda lag, place, bit: f"bit {bits[bit]}, {named(lag, place)}", scale),
            # Over a gradient's product with itself, which is as many times the variance as there are components.
            normal("near returns: gradients", np.concatenate(products), count, named, scale / np.sqrt(dimensions)),
            poisson("near returns: equal words", equal, pairs * 2.0 ** -varying_bits(before), pairs)]


def _agreement(changed: np.ndarray, bit: int) -> np.ndarray:
    """How many standard deviations a bit agrees too often, over the last axis."""
    count = changed.shape[-1]
    return (count - 2 * np.count_nonzero(changed & np.uint32(1 << int(bit)), axis=-1)) / np.sqrt(count)
