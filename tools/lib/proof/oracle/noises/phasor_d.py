"""Section 23 of docs/reference/contract.md, derivatives: phasor noise with the slopes of its value and its
quadrature."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from proof.oracle import gradients, ramps
from proof.oracle.integers import NOISE_UNIT, part, signed
from proof.oracle.lattice import Lattice
from proof.oracle.noises import Noise, phasor, rotating
from proof.oracle.noises.phasor import KERNELS

# A pair for the noise, and one along each axis: of the value, then of the quadrature.
OUTPUTS = ("value", "quadrature", "dx", "qx", "dy", "qy", "dz", "qz")
UNITS = (NOISE_UNIT,) * 2 + (2**16,) * 6

TWO_PI = Fraction(2 * gradients.PI, 2**gradients.SINE_BITS)
FIXED_TWO_PI = 205887  # in units of 2^-15


# --- Exact ------------------------------------------------------------------------------------------------------


def exact(lattice: Lattice, cell: Sequence[int], f: Sequence[Fraction]) -> tuple[Fraction, ...]:
    kernel = KERNELS[len(cell)]
    points = [(-2 * kernel.m * kernel.steps * kernel.weight.slope(t), TWO_PI * kernel.weight.exact(t), d, *around)
              for d, t, *around in phasor.waves(lattice, cell, f)]
    found = [*phasor.exact(lattice, cell, f)]
    for axis in range(len(cell)):
        along = [(fall * d[axis], turn * k[axis], *wave) for fall, turn, d, wave, k in points]
        found += [Fraction(kernel.scale, 1024) * sum(fall * cosine - turn * sine for fall, turn, cosine, sine in along),
                  Fraction(kernel.scale, 1024) * sum(fall * sine + turn * cosine for fall, turn, cosine, sine in along)]
    return tuple(found)


# --- Fixed ------------------------------------------------------------------------------------------------------


def of_weights(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> list[tuple[int, int]]:
    """A_j and B_j along each axis: the parts by the weights, in units of 2^-24."""
    kernel = KERNELS[len(cell)]
    totals = [[0, 0] for _ in cell]
    for offset, powers, wave, _ in phasor.fixed_waves(lattice, cell, fraction):
        falls = [part(x, kernel.weight.fall(*powers)) for x in wave]
        for of_axis, d in zip(totals, offset, strict=True):
            for i, fall in enumerate(falls):
                of_axis[i] = signed(of_axis[i] - signed(2 * part(fall, d >> 2)))
    unit = 2**5 * kernel.steps
    return [tuple(signed(unit * ramps.scaled(total, kernel.scale)) for total in of_axis) for of_axis in totals]


def of_one_wave(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> list[tuple[int, int]]:
    """2 pi k_j times the value and times the quadrature along each axis, in units of 2^-24, where all points have the
    wave."""
    value, quadrature = phasor.fixed(lattice, cell, fraction)
    turns = map(fixed_turn, phasor.fixed_wave(lattice.choice.wave))
    return [(part(signed(2**8 * value), turn), part(signed(2**8 * quadrature), turn)) for turn in turns]


def of_waves(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> list[tuple[int, int]]:
    """2 pi k_ij times them, where each point has a wave of its own: V_j and Z_j, scaled."""
    kernel = KERNELS[len(cell)]
    totals = [[0, 0] for _ in cell]
    for _, powers, wave, k in phasor.fixed_waves(lattice, cell, fraction):
        parts = [part(x, kernel.weight.of_square(*powers)) >> 1 for x in wave]
        for of_axis, turn in zip(totals, map(fixed_turn, k), strict=True):
            for i, x in enumerate(parts):
                of_axis[i] = signed(of_axis[i] + part(x, turn))
    return [tuple(signed((signed(total + 2**8) >> 9) * kernel.scale) for total in of_axis) for of_axis in totals]


def fixed_turn(k: int) -> int:
    """T_j, which is 2 pi k_j in units of 2^-13, of K_j."""
    return part(signed(2**9 * k), FIXED_TWO_PI) >> 9


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    found = [*phasor.fixed(lattice, cell, fraction)]
    turned = (of_one_wave if lattice.choice.bandwidth is None else of_waves)(lattice, cell, fraction)
    for (a, b), (value, quadrature) in zip(of_weights(lattice, cell, fraction), turned, strict=True):
        found += [signed(signed(a - quadrature) + 2**7) >> 8, signed(signed(b + value) + 2**7) >> 8]
    return tuple(found)


NOISES = tuple(rotating(Noise("", exact, fixed, OUTPUTS, UNITS), name) for name in ("phasor_d", "phasor_d_bandwidth"))
