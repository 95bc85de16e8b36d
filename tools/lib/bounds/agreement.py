"""Some sums and what is proven of them, which the suite's C++ has to say, too: conformance/expected/sum_tolerances.inc."""

from __future__ import annotations

import itertools

from bounds import sums
from bounds.documents import NOISE_OF_SUMS, Everything
from bounds.gradients import GRADIENTS
from bounds.sums import Sum

TRIED = (  # arguments of the sums that C++ is held against
    {"turns": False, "exact_positions": True}, {"turns": False}, {}, {"from_cell": True}, {"strength": 2.0},
    {"lacunarity": 1.9, "gain": 0.6, "strength": 0.7},
    {"lacunarity": 1.9, "gain": 0.6, "strength": 0.7, "from_cell": True},
    {"p_max": 1024.0, "octaves": 8}, {"p_max": 1e6, "lacunarity": 0.7, "from_cell": True}, {"octaves": 4.5},
    {"footprint": 0.0625})
HEAD = """\
// What tools/lib/bounds/sums.py says of some sums, which tolerance.cpp has to say, too. Written by tools/bounds --write.
//
//   {kind, dimensions, gradient, OctaveArguments, tolerance}

"""


def tolerances(derived: Everything) -> str:
    """Every kind with all of these; a detail and a footprint are those of an fBm."""
    rows = []
    for key in ((NOISE_OF_SUMS, dims, gradient) for dims in (2, 3) for gradient in GRADIENTS):
        for kind, tried in itertools.product(sums.KINDS, TRIED):
            s = Sum(kind, **{"p_max": 16.0, "octaves": 5, "lacunarity": 2.0, "gain": 0.5} | tried)
            if kind != "fbm" and (s.footprint is not None or isinstance(s.octaves, float)):
                continue
            tolerance = sums.octave_tolerance(s, derived[key].bounds(*key).rounded())
            arguments = [s.p_max, float(s.octaves), s.lacunarity, s.gain, s.exact_positions, s.strength,
                         "{}" if s.footprint is None else s.footprint, s.turns, s.from_cell, isinstance(s.octaves, float)]
            shown = ", ".join(str(x).lower() if isinstance(x, bool) else str(x) for x in arguments)
            rows.append(f"{{OctaveSum::{kind}, {key[1]}, Gradient::{key[2].name}, {{{shown}}}, {tolerance:.6e}}},\n")
    return HEAD + "".join(rows)
