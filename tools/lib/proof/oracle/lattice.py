"""The lattice under a noise: its points with a seed, with periods and with a phase (docs/reference/contract.md, 6, 13,
14 and 16), and the choices of a caller of cellular noise (16) and of phasor noise (23) chooses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from proof.oracle import gradients, integers, ramps, rotation
from proof.oracle.gradients import Knobs, Real
from proof.oracle.hashes import component_word, lattice, point_word

EUCLIDEAN = 1  # HN_METRIC_EUCLIDEAN


def repeated(coordinate: int, period: int) -> int:
    """A coordinate of a lattice point, an exact integer, moved into [0, period) if there is a period."""
    return coordinate - period * (coordinate // period) if period > 0 else coordinate


@dataclass(frozen=True)
class Choice:
    """A caller's choices: for cellular noise the jitter and the metric (section 16), for phasor noise a wave and a
    bandwidth (23)."""
    jitter: Real = 1
    metric: int = EUCLIDEAN
    wave: tuple[Real, ...] = ()  # one number for each axis
    bandwidth: Real | None = None  # None: in the form without one


@dataclass(frozen=True)
class Lattice:
    knobs: Knobs
    seed: int = 0
    periods: tuple[int, ...] = ()  # one for each axis, 0 and less for none; or empty, for none at all
    phase: Real | None = None  # by which octahedral gradients are rotated, and feature points go round
    choice: Choice = Choice()
    component: int = 0  # of a vector, whose noises have words of their own (section 22)
    others: bool = False  # with HN_FIXED: the vectors beside the gradients, whose sum is n' of section 14

    def point(self, corner: Sequence[int]) -> list[int]:
        """The hash of a corner of a cell."""
        if not self.periods:
            return list(corner)
        return [repeated(c, period) for c, period in zip(corner, self.periods, strict=True)]

    @property
    def of_triangles(self) -> Lattice:
        """The lattice of section 13, whose points are half a cell apart along each axis."""
        return replace(self, periods=tuple(2 * period for period in self.periods))

    def word(self, corner: Sequence[int], centre: bool = False) -> int:
        """The word of a corner, or of the centre of the cell behind this first corner."""
        return component_word(point_word(self.knobs.hash, self.point(corner), self.seed, centre), self.component)

    def hash(self, corner: Sequence[int]) -> int:
        """hn_lattice of a corner."""
        return lattice(self.knobs.hash, self.point(corner), self.seed)

    def gradient(self, corner: Sequence[int]) -> tuple[Real, ...]:
        """By HN_GRADIENT."""
        if self.knobs.sine_in(len(corner)):
            self.check_phase()
            return gradients.gradient(self.knobs, self.point(corner), self.seed)
        return self.octahedral(self.word(corner), len(corner))

    def check_phase(self) -> None:
        if self.phase is not None:
            raise ValueError("sine gradients do not rotate")

    def octahedral(self, word: int, n: int) -> tuple[Real, ...]:
        """The gradient of a word in n dimensions, whatever HN_GRADIENT."""
        g = gradients.OCTAHEDRAL[n](word)
        return g if self.phase is None else rotation.rotated(g, word, self.phase)

    def fixed_sine_gradient(self, corner: Sequence[int]) -> tuple[int, ...]:
        """In units of 2^-16."""
        self.check_phase()
        return integers.sine_gradient(self.knobs, self.point(corner), self.seed)

    def fixed_sums(self, n: int, of_gradients: Callable[[Lattice], Sequence[int]]) -> list[int]:
        """The sums over gradients in n dimensions that fixed arithmetic scales. With a phase, each of two."""
        if self.phase is None:
            return list(of_gradients(self))
        rotation_, still = rotation.rotation_of(self.phase, n), replace(self, phase=None)
        return [rotation_.of(a, b) for a, b in zip(of_gradients(still), of_gradients(replace(still, others=True)),
                                                   strict=True)]

    def whole_gradient(self, word: int, n: int) -> tuple[int, ...]:
        g = ramps.whole_gradient(word, n)
        return rotation.other(g, word) if self.others else g

    def fixed_ramp(self, word: int, d: Sequence[int]) -> int:
        """The octahedral ramp of a word at the offset d, in the units of ramps."""
        return ramps.ramp(self.whole_gradient(word, len(d)), d)

    def fixed_octahedral(self, word: int, n: int) -> tuple[int, ...]:
        """The components of the gradient, in units four times as large."""
        return ramps.components(self.whole_gradient(word, n))
