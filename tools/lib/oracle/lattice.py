"""The lattice under a noise: its points with a seed and with periods (docs/contract.md, 6)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from oracle import gradients, integers
from oracle.gradients import Knobs, Real
from oracle.words import point_word


def repeated(coordinate: int, period: int) -> int:
    """A coordinate of a lattice point, an exact integer, moved into [0, period) if there is a period."""
    return coordinate - period * (coordinate // period) if period > 0 else coordinate


@dataclass(frozen=True)
class Lattice:
    knobs: Knobs
    seed: int = 0
    periods: tuple[int, ...] = ()  # one for each axis, 0 and less for none; or empty, for none at all

    def point(self, corner: Sequence[int]) -> list[int]:
        """What is hashed for a corner of a cell."""
        if not self.periods:
            return list(corner)
        return [repeated(c, period) for c, period in zip(corner, self.periods, strict=True)]

    def word(self, corner: Sequence[int]) -> int:
        return point_word(self.knobs.hash, self.point(corner), self.seed)

    def gradient(self, corner: Sequence[int]) -> tuple[Real, ...]:
        return gradients.gradient(self.knobs, self.point(corner), self.seed)

    def fixed_sine_gradient(self, corner: Sequence[int]) -> tuple[int, ...]:
        """In units of 2^-16."""
        return integers.sine_gradient(self.knobs, self.point(corner), self.seed)
