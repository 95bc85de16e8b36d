"""The steps by which sums add an octave (glsl/hashnoise/detail/octave.glsl): the effect of each on the noise, and by
how much the integers of it may be off."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from proof.bounds.integers import FADE_ONE, UNIT

WEIGHT_UNIT = 1 / FADE_ONE


class Step(Protocol):
    """Before the first octave the rest of a step is 1/2."""
    clamps: bool  # whether a noise beyond [-1, 1] counts as the nearer end

    def term(self, n, before, strength):
        """The number that an octave adds, and the rest for the next."""

    def fixed_errors(self, errs: list[float], strength: float, cut: float) -> list[float]:
        """The errors of octaves in integers, before their weights, given the noise's; the strength is cut by so
        much. The errors of floats are in conformance/sums/bounds.cpp."""


class Noise:
    """The noise as it is."""
    clamps = False

    def term(self, n, before, strength):
        return n, before

    def fixed_errors(self, errs, strength, cut):
        return errs


class Turbulence(Noise):
    """Its absolute value, which is exact and brings no two values further apart."""

    def term(self, n, before, strength):
        return abs(n), before


class Billow(Turbulence):
    clamps = True


class Ridged:
    """d = 1 - |n|;  r = d*d*min(2*r, 1). In integers d is rounded down to 2^-18, and so is each product."""
    clamps = True

    def term(self, n, before, strength):
        r = (1 - abs(n)) ** 2 * np.minimum(2 * before, 1)
        return r, r

    def fixed_errors(self, errs, strength, cut):
        """A root g = sqrt(r) follows from d min(sqrt(2) g, 1). So an error of d moves g by as much, what was there
        before by sqrt(2) times that, and r by twice what g is moved by: it grows as sqrt(2)^i, and not as 2^i. What
        products lose does not depend on r, and is counted with r: it doubles."""
        terms, root, lost = [], 0.0, 0.0
        for i, err in enumerate(errs):
            root = err + WEIGHT_UNIT + math.sqrt(2) * root
            lost = 2 * lost + (1 + (i > 0)) * WEIGHT_UNIT
            terms.append(min(2 * root + lost, 1.0))
        return terms


class Hybrid:
    """d = (1 + n)/2;  t = d*min(2*t, 1). Both factors are at most 1, so an error of t doubles. In integers d is rounded
    down to 2^-18, and so is the product, but the first one, which is exact."""
    clamps = True

    def term(self, n, before, strength):
        t = (1 + n) / 2 * np.minimum(2 * before, 1)
        return t, t

    def fixed_errors(self, errs, strength, cut):
        terms, before = [], 0.0
        for i, err in enumerate(errs):
            before = err / 2 + WEIGHT_UNIT + 2 * before + (i > 0) * WEIGHT_UNIT
            terms.append(min(before, 1.0))
        return terms


class PingPong:
    """t = (n + 1)*strength;  t = t - 2*floor(t/2);  z = min(t, 2 - t);  2*z - 1

    In integers t is rounded down to 2^-30, the term to 2^-21."""
    clamps = True

    def term(self, n, before, strength):
        t = (n + 1) * strength
        t = t - 2 * np.floor(t / 2)
        return 2 * np.minimum(t, 2 - t) - 1, before

    def fixed_errors(self, errs, strength, cut):
        return [min(2 * (strength * e + 2 * cut + 2.0**-30) + UNIT, 2.0) for e in errs]


class Weighted(Noise):
    """The noise as it is; its effect on the next octave's weight is in sums.py."""
    clamps = True


STEPS: dict[str, Step] = {"noise": Noise(), "turbulence": Turbulence(), "billow": Billow(), "ridged": Ridged(),
                          "hybrid": Hybrid(), "ping_pong": PingPong(), "weighted": Weighted()}
