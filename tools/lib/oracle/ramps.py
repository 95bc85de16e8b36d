"""Ramps and gradients in fixed arithmetic: sections 8 and 14 of docs/contract.md."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from oracle import gradients, turning
from oracle.integers import signed
from oracle.turning import Turn

# By the number of dimensions: the unit of the ramps, and of the gradients' components.
RAMP_UNITS = {1: 2**29, 2: 2**29, 3: 2**29, 4: 2**28}


def sign_of(h: int, m: int) -> int:
    """m, negated if bit 31 of h is set."""
    return -m if h >> 31 else m


@dataclass(frozen=True)
class Lengthening:
    """How much longer a direction is made: L, and the steps of fixed arithmetic for it."""
    length: float
    shift: int
    times: int

    def of(self, r: int, e: int) -> int:
        """The ramp of a direction, made longer by e, in units of 2^-9 and not yet with L."""
        return signed(r + signed((r >> self.shift) * (self.times * e)))


# That of section 4, and those of simplex noise (section 13).
WHOLE, THREE_EIGHTHS, TWICE = Lengthening(1, 9, 1), Lengthening(0.375, 12, 3), Lengthening(2, 9, 2)


def ramp1(h: int, d: Sequence[int]) -> int:
    """The ramp on a line, of the word h of a lattice point at the offset d from it."""
    a = 2 * (h >> 14 & 511) - 511
    return signed(a * d[0])


def ramp2(h: int, d: Sequence[int], turn: Turn | None = None, lengthening: Lengthening = WHOLE) -> int:
    """The octahedral ramp in the plane, likewise."""
    a = 2 * (h >> 14 & 511) - 511
    m = sign_of(h, 512 - abs(a))
    e = min(abs(a), abs(m))
    r = signed(signed(a * d[0]) + signed(m * d[1]))
    if turn:
        r = turn.of(r, signed(signed(a * d[1]) - signed(m * d[0])))
    return lengthening.of(r, e)


def cross(a: Sequence[int], b: Sequence[int], axis: int) -> int:
    """The component of the cross product a x b along an axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    return signed(signed(a[i] * b[j]) - signed(a[j] * b[i]))


def ramp3(h: int, d: Sequence[int], turn: Turn | None = None, lengthening: Lengthening = WHOLE) -> int:
    """The octahedral ramp in space, likewise."""
    p = 2 * (h >> 23 & 255) - 255
    q = 2 * (h >> 15 & 255) - 255
    m = sign_of(h, 256 - max(abs(p), abs(q)))
    e = min(512 - abs(p) - abs(q), 512 - 2 * abs(m))
    flat = signed(signed(p * (d[0] + d[1])) + signed(q * (d[0] - d[1])))
    r = signed(flat + signed(m * 2 * d[2]))
    if turn:
        g = (p + q, p - q, 2 * m)
        r = turn.of(r, cross(g, d, turning.still_axis(g)))
    return lengthening.of(r, e)


def ramp4(h: int, d: Sequence[int]) -> int:
    """The ramp in four dimensions."""
    return signed(256 * signed(sum(int(g) * x for g, x in zip(gradients.gradient4(h), d))))


OCTAHEDRAL_RAMPS = {1: ramp1, 2: ramp2, 3: ramp3, 4: ramp4}


def octahedral_ramp(h: int, d: Sequence[int], turn: Turn | None = None, lengthening: Lengthening = WHOLE) -> int:
    n = len(d)
    if n in turning.DIMENSIONS:
        return OCTAHEDRAL_RAMPS[n](h, d, turn, lengthening)
    if turn:
        turning.check(n)
    return OCTAHEDRAL_RAMPS[n](h, d)


def octahedral_gradient(h: int, n: int, turn: Turn | None = None, lengthening: Lengthening = WHOLE) -> tuple[int, ...]:
    """The components of the gradient of a word in n dimensions, in the units of the ramps."""
    # Exact: the units are fine enough.
    g = tuple(int(x * RAMP_UNITS[n]) for x in gradients.octahedral(h, n, lengthening.length))
    return tuple(map(turn.of, g, turning.quarter_turned(g))) if turn else g


def sine_ramp(components: Sequence[int], d: Sequence[int]) -> int:
    """The ramp of a sine gradient, in units of 2^-28."""
    return signed(sum(signed((g >> 8) * x) + (signed((g & 255) * x) >> 8) for g, x in zip(components, d)))


def scaled(n: int, factor: int) -> int:
    """A weighted sum of octahedral ramps in units of 2^-21, with the contract's S: 1024 times the scale."""
    return signed(signed((signed(n + 256) >> 9) * factor) + 256) >> 9
