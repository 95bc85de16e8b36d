"""Proofs for hn_random, from docs/reference/contract.md, section 17.

RANGE. A word's upper 24 bits, divided by 2^24: from 0 to 1 - 2^-24.

LIPSCHITZ. None: it jumps between cells.

FLOATS. A float holds 24 bits, so there is no error. The cell is floor(p), which is exact. (A number so small that
HN_PRECISE or a driver takes it for 0 counts to the cell 0.)

FIXED. There is no error either where the cell is the same. A coordinate is cut to a multiple of 2^-20 towards 0, so one
that is negative and less than that below a whole number counts to the cell above: the number of that cell may be any.
"""

from __future__ import annotations

import math

from proof.bounds.gradients import Gradient
from proof.bounds.noises import Proof, ProvenBounds

LARGEST = 1 - 2.0**-24


def derive(_: int, __: Gradient | None) -> ProvenBounds:
    return ProvenBounds(1.0, LARGEST, math.inf)


# The number is an integer of 24 bits before it is a float.
PROOFS = {"random": Proof(tuple((dims, None) for dims in (1, 2, 3, 4)), derive, lambda *_: {"number": 2.0**24},
                          least=lambda _: 0.0)}
