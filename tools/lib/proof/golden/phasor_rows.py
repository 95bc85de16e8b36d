"""The waves and the bandwidths of phasor noise, in rows of simplex noise with phases: none, along axes and diagonals,
too long, any."""

from __future__ import annotations

import math
from collections.abc import Sequence

from proof.golden.generator import Generator, Row, to_f32

# No stripes, numbers that nobody may distinguish from 0, whole and other numbers of waves, the most that there may be,
# its neighbours, and numbers that count as them.
EDGES = tuple(map(to_f32, (
    0.0, -0.0, 2.0**-149, -2.0**-149, 1e-40, -2.0**-126, 2.0**-24, 0.5, -1 / 3, 1.0, -1.0, math.sqrt(2), -math.pi, 8.0,
    -12.25, 16 - 2.0**-20, 16.0, -16.0, 16 + 2.0**-19, -16 - 2.0**-19, -17.0, 3e38, -3e38)))
# Numbers that fixed arithmetic cuts to a multiple of 2^-16, on either side of 0.
CUT = (2.0**-17, -2.0**-17, 2.0**-16, -2.0**-16, 2.0**-16 - 2.0**-40, -3 * 2.0**-17, 1 + 2.0**-17, -1 - 2.0**-17,
       1 - 2.0**-24, to_f32(0.1), -5 + 2.0**-18, 16 - 2.0**-20, -16 + 2.0**-20)

# As far as they are no waves; also numbers with which a component of some points' waves goes beyond the limit.
BANDWIDTHS = (*EDGES[:7], 2.0**-16 - 2.0**-40, 1 + 2.0**-17, 0.5, 1.0,
              to_f32(math.sqrt(2)), 8.0, 16 - 2.0**-20, 16.0, 17.0, -1.0, to_f32(3e38))


def wave(index: int, n: int, edges: Sequence[float], generator: Generator) -> tuple[float, ...]:
    """The wave in a row by its number: as many kinds as go with every phase, which has kinds by the same number."""
    kind, turn = index % 5, index // 5
    edge, axis = edges[turn % len(edges)], turn % n
    if kind == 0:    # along an axis, the next time along another: there are odd numbers of edges, no multiples of 3
        return tuple(edge if i == axis else 0.0 for i in range(n))
    if kind == 1:    # along a diagonal
        return tuple(generator.pick((edge, -edge)) for _ in range(n))
    if kind == 2:    # edges with each other
        return tuple(generator.pick(edges) for _ in range(n))
    most = 4 if kind == 3 else 16
    return tuple(generator.uniform(-most, most) for _ in range(n))


def with_waves(rows: Sequence[Row], n: int, edges: Sequence[float], generator: Generator) -> list[Row]:
    """The rows of the form with a phase alone, with a wave before it."""
    return [(*row[:-2], *wave(index, n, edges, generator), *row[-2:]) for index, row in enumerate(rows)]


def with_bandwidths(rows: Sequence[Row], generator: Generator) -> list[Row]:
    """The rows of the form with a wave and a phase, with a bandwidth between them. Each kind of wave has each edge."""
    def bandwidth(index: int) -> float:
        if index % 2:
            return BANDWIDTHS[index // 2 % len(BANDWIDTHS)]
        return to_f32(generator.uniform(0, 16) / 4**(index % 3))

    return [(*row[:-2], bandwidth(index), *row[-2:]) for index, row in enumerate(rows)]
