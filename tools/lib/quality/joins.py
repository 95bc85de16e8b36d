"""Lags after which both joins of a lattice point are what they were (docs/contract.md, section 3), found by enumeration.

The first join is made of the high bits of spread coordinates. The second is the low bits of a sum of them, each times a
factor. A lag that takes the spread coordinates further by small numbers, whose weighted sum is 0 in those low bits,
leaves both joins alone wherever none of the high bits change: there words come again, with every hash.

On the plane no such lag exists. In space and in 4D the first join drops more bits than the sum has, so there must be
some. What matters is how far they are.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from oracle import words

BATCH = 1 << 20  # lags at a time
TURN = 1 << 32   # coordinates are modulo this


@dataclass(frozen=True)
class Joins:
    """The constants of section 3, by axis."""
    primes: tuple[int, ...] = words.PRIMES[:4]
    shifts: tuple[int, ...] = words.SHIFTS  # of the first join
    factors: tuple[int, ...] = (1, *words.FACTORS)  # of the second
    sum_bits: int = 23  # that the second join takes


@dataclass(frozen=True)
class Repeat:
    lag: tuple[int, ...]  # in cells
    share: float          # of the cells that have the same joins there

    @property
    def reach(self) -> int:
        """How far it is along the axis along which it is farthest."""
        return max(map(abs, self.lag))


def nearest_repeat(dimensions: int, share: float, joins: Joins = Joins()) -> Repeat | None:
    """The lag with the least reach after which more than that share of cells have the joins that they had."""
    modulus = 1 << joins.sum_bits
    spans = [1 << shift for shift in joins.shifts]
    # How much further the spread coordinates but the first two are: every combination.
    others, sums, shares = np.zeros((1, 0), np.int64), np.zeros(1, np.int64), np.ones(1)
    for axis in range(2, dimensions):
        steps = _steps(spans[axis])
        others = np.concatenate([np.repeat(others, len(steps), axis=0), np.tile(steps, len(others))[:, None]], axis=1)
        sums = (np.repeat(sums, len(steps)) + np.tile(steps * joins.factors[axis], len(sums))) % modulus
        shares = np.repeat(shares, len(steps)) * np.tile(1 - np.abs(steps) / spans[axis], len(shares))
    # The second is looked up among all, such that the first is small.
    second = np.concatenate([_steps(spans[1])] * 3)
    weighted = (second * joins.factors[1]) % modulus + np.repeat([-modulus, 0, modulus], len(second) // 3)
    order = np.argsort(weighted)
    second, weighted = second[order], weighted[order]
    best = None
    for at in range(0, len(sums), BATCH):
        wanted = -sums[at:at + BATCH] % modulus
        first_found = np.searchsorted(weighted, wanted - spans[0], side="right")
        count = np.searchsorted(weighted, wanted + spans[0]) - first_found
        row = np.repeat(np.arange(len(wanted)), count)
        found = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first_found, count)
        steps = np.column_stack([wanted[row] - weighted[found], second[found], others[at:at + BATCH][row]])
        shared = shares[at:at + BATCH][row] * np.prod(1 - np.abs(steps[:, :2]) / spans[:2], axis=1)
        chosen = (shared > share) & steps.any(axis=1)
        if not chosen.any():
            continue
        inverses = np.array([pow(prime, -1, TURN) for prime in joins.primes[:dimensions]], np.uint64)
        lags = (steps[chosen] % TURN).astype(np.uint64) * inverses % np.uint64(TURN)
        lags = (lags.astype(np.int64) + TURN // 2) % TURN - TURN // 2
        nearest = np.abs(lags).max(axis=1).argmin()
        repeat = Repeat(tuple(map(int, lags[nearest])), float(shared[chosen][nearest]))
        best = repeat if best is None or repeat.reach < best.reach else best
    return best


def _steps(span: int) -> np.ndarray:
    return np.arange(1 - span, span)
