"""Lags after which both joins of a lattice point are what they were (docs/reference/contract.md, section 3), for many
points: there words come again, with every hash.

The first join is the exclusive or of high bits of spread coordinates. It is what it was where as many axes change each
of its bits as cancel: none, or two, or four. The second is the low bits of a sum of spread coordinates, each times a
factor. After a lag it is what it was everywhere or nowhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from proof.oracle import words

BATCH = 1 << 20  # lags at a time
TURN = 1 << 32   # coordinates are modulo this
BITS = 32


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


def steps_of(lags: np.ndarray, joins: Joins = Joins()) -> np.ndarray:
    """How much further spread coordinates are after lags, which are rows; modulo 2^32."""
    primes = np.array(joins.primes[:lags.shape[1]], np.uint64)
    return (lags.astype(np.int64) % TURN).astype(np.uint64) * primes % np.uint64(TURN)


def keeps_the_sum(steps: np.ndarray, joins: Joins = Joins()) -> np.ndarray:
    """Whether the second join is what it was after each of these rows."""
    factors = np.array(joins.factors[:steps.shape[1]], np.uint64)
    return (steps * factors).sum(axis=1) % np.uint64(1 << joins.sum_bits) == 0


def shares(steps: np.ndarray, least: float = 0.0, joins: Joins = Joins()) -> np.ndarray:
    """The share of all points whose first join is as before, after each of these rows. It is exact, but 0 where it
    is `least` at most. From the lowest bit to the highest, it counts by which axes change a bit. Axis a does so where
    the bit of the step is not the carry from below; then the carry to the next bit is 0 or 1 as often."""
    axes = steps.shape[1]
    sets = np.arange(1 << axes)  # of axes, as bits
    sizes = np.array([int(s).bit_count() for s in sets])
    # From the set that changes a bit, which must be even, to that of the axes whose carry is not the step's bit.
    to = np.where((sets[:, None] & sets == sets) & (sizes % 2 == 0)[:, None], 0.5 ** sizes[:, None], 0.0)
    chance = np.ones((len(steps), 1))
    for axis in range(axes):
        part = (steps[:, axis] % np.uint64(1 << joins.shifts[axis])).astype(float) / (1 << joins.shifts[axis])
        chance = np.concatenate([chance * (1 - part)[:, None], chance * part[:, None]], axis=1)
    before = np.zeros(len(steps), np.int64)
    found, rows = np.zeros(len(steps)), np.arange(len(steps))
    for bit in range(BITS - min(joins.shifts[:axes])):
        now = np.zeros(len(steps), np.int64)
        for axis in range(axes):
            if joins.shifts[axis] + bit < BITS:
                now |= (steps[:, axis] >> np.uint64(joins.shifts[axis] + bit) & np.uint64(1)).astype(np.int64) << axis
            else:  # it has no such bit: what would change it is lost
                for s in sets[sets >> axis & 1 == 1]:
                    chance[:, s ^ 1 << axis] += chance[:, s]
                    chance[:, s] = 0
                before &= ~(1 << axis)
        chance = np.take_along_axis(chance, sets ^ (before ^ now)[:, None], axis=1) @ to
        keep = chance.sum(axis=1) > least
        chance, before, steps, rows = chance[keep], now[keep], steps[keep], rows[keep]
    found[rows] = chance.sum(axis=1)
    return found


def _best(lags: np.ndarray, least: float, joins: Joins) -> list[Repeat]:
    lags = lags[lags.any(axis=1)]
    found = shares(steps_of(lags, joins), least, joins)
    return [Repeat(tuple(map(int, lags[i])), float(found[i])) for i in np.flatnonzero(found)]


def on_the_plane(reach: int, least: float, joins: Joins = Joins()) -> Iterator[Repeat]:
    """All lags of at most `reach` cells along each axis (a power of two, above the second join) after which more than
    that share of words comes again; one of each opposite pair."""
    modulus = 1 << joins.sum_bits
    back = -joins.primes[1] * joins.factors[1] * pow(joins.primes[0], -1, modulus) % modulus
    for start in range(0, reach + 1, BATCH):
        along_y = np.arange(start, min(start + BATCH, reach + 1), dtype=np.int64)
        for turn in range(-reach, reach, modulus):  # the lags along x that keep the sum
            yield from _best(np.column_stack([along_y * back % modulus + turn, along_y]), least, joins)


def of_one_change(dimensions: int, reach: int, least: float, joins: Joins = Joins()) -> Iterator[Repeat]:
    """Lags of at most `reach` cells along each axis after which more than that share of words comes again, and the high
    bits of each spread coordinate grow or fall by one power of two, or not at all, and by half a turn beside it or not:
    the highest bit always changes then, and nothing else. There are others, of more changes."""
    sides = []
    for axes in np.array_split(np.arange(dimensions), 2):
        lags, sums = np.zeros((1, 0), np.int64), np.zeros(1, np.int64)
        for axis in axes:
            some = _along(axis, reach, joins)
            further = some * joins.primes[axis] % TURN * joins.factors[axis]
            lags = np.concatenate([np.repeat(lags, len(some), axis=0), np.tile(some, len(lags))[:, None]], axis=1)
            sums = (np.repeat(sums, len(some)) + np.tile(further, len(sums))) % (1 << joins.sum_bits)
        sides.append((lags, sums))
    (first, sums), (second, wanted) = sides
    order = np.argsort(wanted)
    second, wanted = second[order], wanted[order]
    for start in range(0, len(first), BATCH):
        need = -sums[start:start + BATCH] % (1 << joins.sum_bits)
        at = np.searchsorted(wanted, need)
        count = np.searchsorted(wanted, need, side="right") - at
        row = np.repeat(np.arange(len(need)), count)
        other = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(at, count)
        yield from _best(np.concatenate([first[start + row], second[other]], axis=1), least, joins)


def _along(axis: int, reach: int, joins: Joins) -> np.ndarray:
    """The lags along an axis after which its high bits change so."""
    span = 1 << joins.shifts[axis]
    powers = [0, *(sign << bit for bit in range(joins.shifts[axis], BITS) for sign in (1, -1))]
    near = np.add.outer(powers, np.arange(1 - span, span)).reshape(-1)
    steps = np.unique(np.concatenate([near, near + TURN // 2]) % TURN).astype(np.uint64)
    lags = steps * np.uint64(pow(joins.primes[axis], -1, TURN)) % np.uint64(TURN)
    lags = (lags.astype(np.int64) + TURN // 2) % TURN - TURN // 2
    return lags[np.abs(lags) <= reach]
