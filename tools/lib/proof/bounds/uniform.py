"""Uniform values and spreads (docs/reference/contract.md, section 21), in floats and in integers: how far they are off,
proven.

A spread is in its range: taking it there is exact, and errors are for the numbers in range.

VALUES AND SLOPES, of a box of s at a time. In floats, with a quotient within QUOTIENT_ULPS (distances.py):

    s = abs(value) / reach;  w = 1 - s;  y = w*w
    four rounds of mix(p, q) = p + (q - p)*y from 0, a, b, c, 1 to t_0 and t_1, then to T
    1 - T/2;  4*((t_1 - t_0)*w) / reach

An error of y moves T by 4 times that and (t_1 - t_0), which is at most the largest of the Bernstein polynomials of
degree 3 at y, since it is their mean weighted with a, b - a, c - b and 1 - c. Likewise the numbers of a round before it
differ by no more than the largest ones of a lower degree. In integers a number rounds down by less than 1 unit of
2^-21 where it is cut, and in each round. (reach is at least 1/16, so that s is off by 2^-17 for that, and 2^-18.)

SPREADS OF SUMS, of a box at a time: octaves, gain, how much of the last octave counts, and a, b and c. A weight in
floats is off by as many roundings as it has factors, and a sum by one more with each number; products and sums of
positive numbers have the relative errors of their parts. In integers each weight rounds down. Then

    x' = B + rho_4 H d + rho_8 (x - B - H d)     is off by |H d| and |x - B - H d| times the errors of rho_4 and rho_8
    reach' = reach sqrt(S_2 V / V') / S_1        relatively by half of what S_2, V and V' are off by, and as S_1

and both by what their own operations round. The error of V' is 65, 33 and 17 times the errors of a', b' and c'.
"""

from __future__ import annotations

import functools
import itertools
import math
from dataclasses import astuple, dataclass

import numpy as np

from proof.bounds.boxes import SAFE
from proof.bounds.distances import QUOTIENT_ULPS, ROOT_ULPS
from proof.bounds.floats import UNIT, Approx, rounding
from proof.bounds.table import UniformBounds, scientific
from proof.oracle.uniform import BELL, LARGEST_REACH, LEAST_REACH, MOST_OCTAVES, PARTS, VARIANCE, WAY

FINE, COARSE = 2.0**-21, 2.0**-18  # the units of values and their spreads, and of sums
LEAST, LARGEST = float(LEAST_REACH), float(LARGEST_REACH)
BOXES = 4096  # of s
GAINS, COEFFICIENTS = 128, 10  # boxes along each axis


# --- Values and slopes ------------------------------------------------------------------------------------------------


def highest(degree, low, high, slope=False):
    """The largest of the Bernstein polynomials of a degree between low and high, or of the magnitudes of their
    derivatives. A polynomial is off the straight line between the ends by less than its curvature allows."""
    def at(y):
        if slope:
            lower = [math.comb(degree - 1, i) * y**i * (1 - y)**(degree - 1 - i) for i in range(degree)]
            return degree * np.max(np.abs([a - b for a, b in zip([*lower, 0 * y], [0 * y, *lower])]), axis=0)
        return np.max([math.comb(degree, i) * y**i * (1 - y)**(degree - i) for i in range(degree + 1)], axis=0)
    # Polynomials of degree 3 have second derivatives below 18, and third ones of at most 18.
    return np.maximum(at(low), at(high)) + 18 / 8 * (high - low)**2


def boxes_of_s():
    ends = np.linspace(0, 1, BOXES + 1)
    return ends[:-1], ends[1:]


def float_values():
    """The errors of T/2 or 1 - T/2, and of a slope times the reach."""
    low, high = boxes_of_s()
    s = Approx(low, high, rounding(high, QUOTIENT_ULPS))
    w = Approx(1 - high, 1 - low, s.err).rounded()
    y = w.times(w)
    least, most = np.maximum(y.lo - y.err, 0), np.minimum(y.hi + y.err, 1)

    def mixed(err, degree, largest):
        """The error of mixing numbers that are off by err and differ by no more than those of the round."""
        apart = np.minimum(highest(degree, least, most), 1) if degree else 1 + 0 * y.hi
        apart_error = 2 * err + rounding(apart + 2 * err)
        product = most * (apart + apart_error)
        own = y.err * apart + most * rounding(apart + 2 * err) + rounding(product)
        return err + own + rounding(largest + err + own), apart, apart_error

    err = 0 * y.hi
    for degree in range(4):
        # The last is at most as for three numbers of 1.
        largest = 1 - (1 - most)**4 if degree == 3 else 1.0
        err, apart, apart_error = mixed(err, degree, largest)
    slope = Approx(0 * apart, apart, apart_error).times(w)
    # The quotient has another unit than the dividend, if the reach is no power of 2.
    of_slope = 4 * slope.err + 2 * rounding(4 * (slope.hi + slope.err), QUOTIENT_ULPS)
    return float((err / 2 + rounding(1 - 2.0**-24)).max()) * SAFE, float(of_slope.max()) * SAFE


def fixed_values():
    low, high = boxes_of_s()
    cut = FINE / LEAST
    s_down, s_up = cut + COARSE, high * cut * (1 + 2 * cut)
    w_low, w_high = np.maximum(1 - high - s_up, 0), np.minimum(1 - low + s_down, 1)
    w_err = np.maximum(s_down, s_up)
    y_err = 2 * w_high * w_err + COARSE
    least, most = np.maximum(w_low**2 - COARSE, 0), w_high**2
    apart = np.minimum(highest(3, least, most), 1)
    err = 4 * apart * y_err + 5 * FINE
    apart_error = highest(3, least, most, slope=True) * y_err + 4 * FINE
    slope = 4 * (apart_error * w_high + (apart + apart_error) * w_err + FINE)
    of_slope = (slope + 4 * apart * w_high * cut) * (1 + 2 * cut) + COARSE * LARGEST
    return float(err.max()) / 2 * SAFE, float(of_slope.max()) * SAFE


# --- Spreads of sums --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Weights:
    """Boxes of gains and last octaves, for a number of octaves: at the lower and at the higher ends."""
    octaves: int
    gain: np.ndarray
    low: list[np.ndarray]
    high: list[np.ndarray]

    def sums(self, power):
        return sum(a**power for a in self.low), sum(a**power for a in self.high)


@dataclass(frozen=True)
class Ratios:
    """rho_4 and rho_8 with their errors, S_2 / S_1^2, and the error of its root, relative to that."""
    rho4: tuple[np.ndarray, np.ndarray]
    rho8: tuple[np.ndarray, np.ndarray]
    share: tuple[np.ndarray, np.ndarray]  # N
    error4: np.ndarray
    error8: np.ndarray
    error_share: np.ndarray  # of N, absolute in integers; of sqrt(S_2) / S_1, relative in floats


def weights_of(octaves):
    if octaves == 1:
        one = np.ones(1)
        return Weights(1, one, [one], [one])
    parts = max(16 // octaves, 1)  # the fewer octaves there are, the more the last one matters
    gains, last = np.linspace(0, 1, GAINS + 1), np.linspace(0, 1, parts + 1)
    boxes = list(itertools.product(range(GAINS), range(parts)))
    ends = []
    for up in (0, 1):
        gain, part = (np.array([axis[box[i] + up] for box in boxes]) for i, axis in enumerate((gains, last)))
        ends.append([gain**i * (part if i == octaves - 1 else 1) for i in range(octaves)])
    return Weights(octaves, gain, *ends)


def ranges(weights):
    """The ranges of rho_4, rho_8 and N: each is at most 1."""
    (s1, t1), (s2, t2), (s4, t4), (s8, t8) = (weights.sums(power) for power in (1, 2, 4, 8))
    return [(low, np.minimum(high, 1)) for low, high in
            ((s4 / t2**2, t4 / s2**2), (s8 / t2**4, t8 / s2**4), (s2 / t1**2, t2 / s1**2))]


def float_ratios(weights):
    def relative(power):
        """Roundings of the sum of powers: a later octave has more, so that they are most at the higher end."""
        terms = [a**power for a in weights.high]
        factors = [power * (i + (i == weights.octaves - 1)) + power - 1 for i in range(weights.octaves)]
        factors[0] = 0  # 1 and its powers
        return sum(n * term for n, term in zip(factors, terms)) / sum(terms) + weights.octaves - 1

    unit = UNIT * (1 + 2.0**-10)  # for the products of errors, which are hundreds of roundings at most
    rho4, rho8, share = ranges(weights)
    error4 = rho4[1] * unit * (relative(4) + 2 * relative(2) + 1 + QUOTIENT_ULPS)
    error8 = rho8[1] * unit * (relative(8) + 4 * relative(2) + 3 + QUOTIENT_ULPS)
    return Ratios(rho4, rho8, share, error4, error8, unit * (relative(2) / 2 + relative(1)))


def fixed_ratios(weights):
    u, largest = COARSE, weights.high
    errors, error, exact = [], 0 * weights.gain, 1 + 0 * weights.gain
    for i in range(weights.octaves):
        last = i == weights.octaves - 1 > 0
        errors.append(np.minimum(error + exact * u + u if last else error, largest[i]))
        error, exact = error * weights.gain + exact * u + u, exact * weights.gain
    sums = {}
    for power in (1, 2, 4, 8):
        if power > 1:
            errors = [np.minimum(2 * a**(power // 2) * error + u, a**power) for a, error in zip(largest, errors)]
        errors[0] = 0 * weights.gain  # the first octave has 1 and all powers of that
        sums[power] = sum(errors)

    def reciprocal(power):
        """The largest, and its error."""
        low = weights.sums(power)[0]
        off = np.maximum(sums[power], 0)
        least = np.maximum(low - off, 1)
        return 1 / low, np.maximum(off / (low * least), u)

    def product(a, a_err, b, b_err):
        return a_err * b + a * b_err + a_err * b_err + u

    high = {power: weights.sums(power)[1] for power in (1, 2, 4, 8)}
    rho4, rho8, share = ranges(weights)

    def twice(power, factor, error):
        once = product(high[power], sums[power], factor, error)
        return product(high[power] * factor, once, factor, error)

    r, r_err = reciprocal(2)
    q, q_err = r * r, product(r, r_err, r, r_err)
    return Ratios(rho4, rho8, share, twice(4, r, r_err), twice(8, q, q_err), twice(2, *reciprocal(1)))


def boxes_of_coefficients():
    """Lower and higher ends of a, b and c, each at least the one before. Boxes are smaller near 0, as V' is there."""
    low = np.array(list(itertools.combinations_with_replacement(range(COEFFICIENTS), 3))).T
    return (low / COEFFICIENTS)**2, ((low + 1) / COEFFICIENTS)**2


def spread_errors(ratios, fixed):
    """The errors of reach' and of a', b' and c': the largest over all boxes. The first axis is the weights'."""
    u, factors = COARSE, [float(x) for x in VARIANCE[:3]]
    low, high = (end[:, None, :] for end in boxes_of_coefficients())
    rho4, rho8, share = ([end[:, None] for end in ends] for ends in (ratios.rho4, ratios.rho8, ratios.share))
    error4, error8 = ratios.error4[:, None], ratios.error8[:, None]
    bell = [x / PARTS for x in BELL]
    d = low[2] - bell[2], high[2] - bell[2]
    between = np.maximum(rho4[0] - rho8[1], 0), rho4[1] - rho8[0]  # rho_8 is the smaller one
    errors, ends = [], []
    for i, way in enumerate(x / PARTS for x in WAY):
        h = np.maximum(abs(d[0]), abs(d[1])) * way
        rest = np.maximum(abs(low[i] - bell[i] - way * d[1]), abs(high[i] - bell[i] - way * d[0]))
        if fixed:
            h_err = way * u + u
            err = h * error4 + (rho4[1] + error4) * h_err + u + rest * error8 + (rho8[1] + error8) * (u + h_err) + u
        else:
            h_err = way * rounding(np.maximum(abs(d[0]), abs(d[1]))) + rounding(h) * 1.001
            above = np.maximum(abs(low[i] - bell[i]), abs(high[i] - bell[i]))
            rest_err = h_err + rounding(above) + rounding(rest) * 1.001
            err = (h * error4 + rho4[1] * h_err + rounding(rho4[1] * h * 1.001)
                   + rest * error8 + rho8[1] * rest_err + rounding(rho8[1] * rest * 1.001)
                   + rounding((bell[i] + rho4[1] * h) * 1.001) + rounding(1.001)) * 1.001
        # Exactly: B (1 - rho_8) + (rho_4 - rho_8) H d + rho_8 x.
        least = bell[i] * (1 - rho8[1]) + way * np.minimum(between[0] * d[0], between[1] * d[0]) + rho8[0] * low[i]
        most = bell[i] * (1 - rho8[0]) + way * np.maximum(between[0] * d[1], between[1] * d[1]) + rho8[1] * high[i]
        errors.append(np.minimum(err, 1))
        ends.append((np.clip(least, 0, 1), np.clip(most, 0, 1)))
    one = float(VARIANCE[3])
    v_low, v_high = (sum(f * x for f, x in zip(factors, end)) + one for end in (low, high))
    of_sum = [sum(f * end[side] for f, end in zip(factors, ends)) + one for side in (0, 1)]
    v_err = sum(f * err for f, err in zip(factors, errors))
    p_low, p_high = share[0] * v_low / of_sum[1], share[1] * v_high / of_sum[0]
    if not fixed:
        unit = UNIT * 1.001
        least = np.maximum(of_sum[0] - v_err, one)
        relative = v_err / least / 2 + unit * ((4 + 4 + 2 + QUOTIENT_ULPS) / 2 + ROOT_ULPS + 1 + QUOTIENT_ULPS)
        of_reach = np.sqrt(p_high) * (relative + ratios.error_share[:, None]) * 1.001
    else:
        v_err, given = v_err + 8 * u, sum(factors) * u + 8 * u
        least = np.maximum(of_sum[0] - v_err, one)
        share_err = ratios.error_share[:, None]
        top = v_high * share_err + (share[1] + share_err) * given + 8 * u
        p_err = top / least + p_high * v_err / least + u
        # The root of a number that is off by e is off by at most the root of e.
        root_err = np.minimum(p_err / np.sqrt(p_low) / (1 + np.sqrt(np.maximum(1 - p_err / p_low, 0))),
                              np.sqrt(p_err)) + u
        of_reach = root_err + (np.sqrt(p_high) + 1) * u / LEAST
    return float(of_reach.max()) * SAFE, float(np.max([err.max() for err in errors])) * SAFE


def sum_errors(fixed):
    found = []
    for octaves in range(1, MOST_OCTAVES + 1):
        weights = weights_of(octaves)
        ratios = fixed_ratios(weights) if fixed else float_ratios(weights)
        found.append(spread_errors(ratios, fixed))
    return tuple(map(max, zip(*found)))


@functools.cache
def errors(fixed):
    return UniformBounds(*(fixed_values() if fixed else float_values()), *sum_errors(fixed))


def quotes() -> list[str]:
    """The numbers that prose must state."""
    floats, integers = (tuple(map(scientific, astuple(errors(fixed)))) for fixed in (False, True))
    return ["`hn_uniform` is within {} and a slope of `hn_uniform_d` within {} / r".format(*floats[:2]),
            "a reach within {} r, and other numbers within {},".format(*floats[2:]),
            "A value is within {}, and a slope within {} / r.".format(*integers[:2]),
            "the reach is within {} r, and another number within {}.".format(*integers[2:])]
