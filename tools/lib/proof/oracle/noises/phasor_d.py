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
    value, quadrature = phasor.exact(lattice, cell, f)
    falls = [(-2 * kernel.m * kernel.steps * kernel.weight.slope(t), d, wave)
             for d, t, wave in phasor.waves(lattice, cell, f)]
    found = [value, quadrature]
    for axis, k in enumerate(phasor.clamped(lattice.choice.wave)):
        of_weights = [Fraction(kernel.scale, 1024) * sum(fall * d[axis] * wave[i] for fall, d, wave in falls)
                      for i in range(2)]
        found += [of_weights[0] - TWO_PI * k * quadrature, of_weights[1] + TWO_PI * k * value]
    return tuple(found)


# --- Fixed ------------------------------------------------------------------------------------------------------


def of_weights(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> list[tuple[int, int]]:
    """A_j and B_j along each axis: the parts by the weights, in units of 2^-24."""
    kernel = KERNELS[len(cell)]
    totals = [[0, 0] for _ in cell]
    for offset, powers, wave in phasor.fixed_waves(lattice, cell, fraction):
        falls = [part(x, kernel.weight.fall(*powers)) for x in wave]
        for of_axis, d in zip(totals, offset, strict=True):
            for i, fall in enumerate(falls):
                of_axis[i] = signed(of_axis[i] - signed(2 * part(fall, d >> 2)))
    unit = 2**5 * kernel.steps
    return [tuple(signed(unit * ramps.scaled(total, kernel.scale)) for total in of_axis) for of_axis in totals]


def fixed_turn(k: int) -> int:
    """T_j, which is 2 pi k_j in units of 2^-13, of K_j."""
    return part(signed(2**9 * k), FIXED_TWO_PI) >> 9


def fixed(lattice: Lattice, cell: Sequence[int], fraction: Sequence[int]) -> tuple[int, ...]:
    value, quadrature = phasor.fixed(lattice, cell, fraction)
    found = [value, quadrature]
    along_axes = zip(of_weights(lattice, cell, fraction), phasor.fixed_wave(lattice.choice.wave), strict=True)
    for (a, b), k in along_axes:
        turn = fixed_turn(k)
        found += [signed(signed(a - part(signed(2**8 * quadrature), turn)) + 2**7) >> 8,
                  signed(signed(b + part(signed(2**8 * value), turn)) + 2**7) >> 8]
    return tuple(found)


NOISES = (rotating(Noise("", exact, fixed, OUTPUTS, UNITS), "phasor_d"),)
