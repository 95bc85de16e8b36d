"""The steps by which sums add an octave (glsl/hashnoise/detail/octave.glsl): what each does to the noise, and by how much that may be off.

A step is what the library's text does, in floats and in integers, beside the errors that are proven of it: the tests
compute the one with adverse roundings and hold it against the other.
"""

from __future__ import annotations

import math

import numpy as np

from bounds.floats import TINY
from bounds.floats import UNIT as FLOAT_UNIT
from bounds.integers import FADE_ONE, UNIT

WEIGHT_UNIT = 1 / FADE_ONE


class Step:
    """A step that adds the noise as it is. What a step leaves of the next octave is 1/2 before the first."""
    clamps = True  # a noise beyond [-1, 1] counts as the nearer end

    def term(self, floats, n, before, strength):
        """What an octave adds, and what it leaves of the next; `floats` rounds, and may fuse a product with a sum."""
        return n, before

    def fixed_term(self, ints, v, before, strength):
        """The same in integers, which are in units of 2^-21, and of 2^-18 between octaves."""
        return v, before

    def float_errors(self, errs: list[float], limit: float, strength: float) -> tuple[list[float], float]:
        """The errors of what octaves add, before their weights, given those of the noise; and the largest that it can be
        as computed."""
        return errs, limit

    def fixed_errors(self, errs: list[float], strength: float, cut: float) -> list[float]:
        """The same in integers, where the strength is cut by so much."""
        return errs


class Noise(Step):
    clamps = False


class Size(Step):
    """Its absolute value, which is exact and brings no two values further apart."""
    clamps = False

    def term(self, floats, n, before, strength):
        return abs(n), before

    def fixed_term(self, ints, v, before, strength):
        return abs(v), before


class BoundedSize(Size):
    clamps = True


class Ridge(Step):
    """d = 1 - |n|;  r = d*d*min(2*r, 1). In integers d is rounded down to 2^-18, and so is each product."""

    def term(self, floats, n, before, strength):
        d = floats.round(1 - abs(n))
        r = floats.round(floats.round(d * d) * np.minimum(2 * before, 1))
        return r, r

    def fixed_term(self, ints, v, before, strength):
        d = (2**21 - abs(v)) >> 3
        ridge = ints.product(ints.product(d, d), np.minimum(2 * before, 2**18))
        return ridge << 3, ridge

    def float_errors(self, errs, limit, strength):
        return ridges([e + FLOAT_UNIT for e in errs], FLOAT_UNIT, 2 * TINY), 1.0

    def fixed_errors(self, errs, strength, cut):
        return ridges([e + WEIGHT_UNIT for e in errs], 0.0, WEIGHT_UNIT)


def ridges(noise_errs: list[float], unit: float, lost: float) -> list[float]:
    """The errors of r_i = d^2 min(2 r, 1), from those of d = 1 - |n|, of which each product errs by a part of `unit`
    and loses up to `lost` beside.

    A root g = sqrt(r) follows from d min(sqrt(2) g, 1). So an error of d moves g by as much, what was there before by
    sqrt(2) times that, and r by twice what g is moved by: it grows as sqrt(2)^i, and not as 2^i. Relative errors of r
    move g by half of them. What is lost does not depend on r, and is counted with r: it doubles."""
    errs, root, falls = [], 0.0, 0.0
    for i, noise_err in enumerate(noise_errs):
        products = 1 + (i > 0)
        root = noise_err + math.sqrt(2) * root + products * unit * (1 + unit) / 2
        falls = 2 * falls + products * lost
        errs.append(min(2 * root + falls, 1.0))
    return errs


class Height(Step):
    """d = (1 + n)/2;  t = d*min(2*t, 1). Both factors are at most 1, so an error of t doubles. In integers d is rounded
    down to 2^-18, and so is the product, but the first one, which is exact."""

    def term(self, floats, n, before, strength):
        t = floats.round(floats.mad(0.5, n, 0.5) * np.minimum(2 * before, 1))
        return t, t

    def fixed_term(self, ints, v, before, strength):
        height = ints.product((2**21 + v) >> 4, np.minimum(2 * before, 2**18))
        return height << 3, height

    def float_errors(self, errs, limit, strength):
        return heights([e / 2 + FLOAT_UNIT for e in errs], FLOAT_UNIT + TINY), 1.0

    def fixed_errors(self, errs, strength, cut):
        return heights([e / 2 + WEIGHT_UNIT for e in errs], WEIGHT_UNIT)


def heights(errs: list[float], of_product: float) -> list[float]:
    """The errors of t_i = d min(2 t, 1), from those of d."""
    terms, before = [], 0.0
    for i, err in enumerate(errs):
        before = err + 2 * before + (i > 0) * of_product
        terms.append(min(before, 1.0))
    return terms


class Wave(Step):
    """t = (n + 1)*strength;  t = t - 2*floor(t/2);  z = min(t, 2 - t);  2*z - 1

    Of t only n + 1 and the product round: 2 - t is exact for t from 1 on. The difference may be fused with the product,
    so that t is less than 0 or more than 2 by the rounding of the product; this counts twice, then. In integers t is
    rounded down to 2^-30, the term to 2^-21."""

    def term(self, floats, n, before, strength):
        """floor takes the product as it is rounded."""
        more = floats.round(n + 1)
        t = floats.mad(more, strength, -2 * np.floor(floats.round(more * strength) / 2))
        return floats.mad(2.0, np.minimum(t, floats.round(2 - t)), -1.0), before

    def fixed_term(self, ints, v, before, strength):
        return ints.ping_pong(v, strength), before

    def float_errors(self, errs, limit, strength):
        terms = []
        for noise_err in errs:
            product_err = strength * (noise_err + FLOAT_UNIT * (2 + noise_err))
            t_err = product_err + 2 * (FLOAT_UNIT * (2 * strength + product_err) + TINY)
            terms.append(min(2 * t_err + FLOAT_UNIT * (1 + 2 * t_err), 2.001))
        return terms, 1.001

    def fixed_errors(self, errs, strength, cut):
        return [min(2 * (strength * e + 2 * cut + 2.0**-30) + UNIT, 2.0) for e in errs]


class Bent(Step):
    """The noise as it is; what it makes of the next octave's weight is in sums.py."""


STEPS: dict[str, Step] = {"noise": Noise(), "size": Size(), "bounded_size": BoundedSize(), "ridge": Ridge(),
                          "height": Height(), "wave": Wave(), "bent": Bent()}
