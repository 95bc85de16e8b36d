"""Tests of the proofs for uniform values and spreads of sums: the text of the library over floats of any rounding
mode, and fixed arithmetic, stay within the bounds, and reach a part of them. Fewer bits are noticed."""

import functools
import unittest
from dataclasses import astuple
from unittest import mock

import numpy as np

from proof.bounds import uniform
from proof.bounds.rounded import Rounding, Text, roundings
from proof.bounds.table import UniformBounds, read_uniform
from proof.oracle import uniform as oracle

COUNT, FIXED_COUNT = 3_000, 400
VALUE, SUM = "uniform.uniform_d", "uniform.spread_fbm"


@functools.cache
def text():
    return Text([VALUE, SUM])


def some_spreads(rng, count):
    """Some of the least reach or the largest, and some whose numbers are the same, or as far apart as can be."""
    reach = np.where(rng.random(count) < 0.2, rng.choice([0.0625, 3.0], count), rng.uniform(0.0625, 3, count))
    numbers = np.sort(rng.random((3, count)), axis=0)
    ends = rng.choice([[0, 0, 0], [0, 0, 1], [0, 1, 1], [1, 1, 1]], count).T
    numbers = np.where(rng.random(count) < 0.4, ends, numbers)
    return dict(zip(("reach", "a", "b", "c"), np.array([reach, *numbers]).astype(np.float32).astype(float)))


def some_values(rng, count):
    spreads = some_spreads(rng, count)
    noise = spreads["reach"] * rng.uniform(-1.01, 1.01, count) * 2.0**-rng.choice([0, 0, 0, 3, 20], count)
    return {"noise": noise.astype(np.float32).astype(float)} | spreads


def some_sums(rng, count):
    """Many octaves, and all but the first hardly count: a float that rounds up counts each."""
    octaves = np.choose(rng.integers(0, 3, count), [rng.integers(1, 33, count), np.full(count, 32),
                                                    1 + rng.choice([1, 4, 31], count) * rng.random(count)])
    gain = np.choose(rng.integers(0, 5, count), [np.full(count, 0.5), rng.random(count), rng.uniform(0.9, 1, count),
                                                 rng.random(count)**6, 2.0**-rng.integers(8, 40, count)])
    settings = {"detail": octaves, "gain": gain}
    return some_spreads(rng, count) | {name: x.astype(np.float32).astype(float) for name, x in settings.items()}


def value_and_slope(noise, reach, a, b, c):
    """As the contract has it, which doubles hold nearly exactly."""
    w = 1 - np.minimum(abs(noise) / reach, 1)
    y = w**2
    x = 1 - y
    half = (4 * a * y * x**3 + 6 * b * y**2 * x**2 + 4 * c * y**3 * x + y**4) / 2
    slope = 4 * w * (a * x**3 + 3 * (b - a) * y * x**2 + 3 * (c - b) * y**2 * x + (1 - c) * y**3) / reach
    return np.where(noise >= 0, 1 - half, half), slope


def spread_of_sum(reach, a, b, c, detail, gain):
    k = np.ceil(detail)
    weights = [gain**i * np.where(i == k - 1, detail - (k - 1), i < k) for i in range(32)]
    s1, s2, s4, s8 = (sum(x**power for x in weights) for power in (1, 2, 4, 8))
    d = c - oracle.BELL[2] / 1024
    of_sum = []
    for x, bell, way in zip((a, b, c), oracle.BELL, oracle.WAY):
        at, moved = bell / 1024, way / 1024 * d
        of_sum.append(np.clip(at + s4 / s2**2 * moved + s8 / s2**4 * (x - at - moved), 0, 1))
    variance = [65 * p + 33 * q + 17 * r + 7 for p, q, r in ((a, b, c), of_sum)]
    return reach * np.sqrt(s2 * variance[0] / variance[1]) / s1, *of_sum


def in_units(errors_of_value, errors_of_sum, value_reach, sum_reach):
    """Each error as the bounds have it: the largest of all points."""
    (value, slope), (reach, *others) = errors_of_value, errors_of_sum
    return UniformBounds(*(float(np.max(x)) for x in (value, slope * value_reach, reach / sum_reach, others)))


def in_floats(simulated, seed=1):
    """The largest errors."""
    rng, found = np.random.default_rng(seed), []
    for rounding in simulated:
        values, sums = some_values(rng, COUNT), some_sums(rng, COUNT)
        errors = [[abs(x - right) for x, right in zip(text()(id, rounding, **of), exact(**of))]
                  for id, of, exact in ((VALUE, values, value_and_slope), (SUM, sums, spread_of_sum))]
        found.append(astuple(in_units(*errors, values["reach"], sums["reach"])))
    return np.max(found, axis=0)


def in_integers(seed=2):
    rng, errors = np.random.default_rng(seed), []
    values, sums = some_values(rng, FIXED_COUNT), some_sums(rng, FIXED_COUNT)
    for of, exact, fixed in ((values, value_and_slope, oracle.fixed_uniform_d),
                             (sums, spread_of_sum, oracle.fixed_spread_fbm)):
        found = np.array([[float(x) for x in fixed(*row)] for row in zip(*of.values())]).T
        errors.append([abs(x - right) for x, right in zip(found, exact(**of))])
    return np.array(astuple(in_units(*errors, values["reach"], sums["reach"])))


class Floats(unittest.TestCase):
    def test_simulated(self):
        found, bounds = in_floats(roundings(1)), np.array(astuple(uniform.errors(False)))
        self.assertTrue((found < bounds).all(), (found, bounds))
        # The bounds of sums are far above their errors: they add all errors of a noise whose numbers are all 0.
        self.assertTrue((found > bounds * [1 / 4, 1 / 8, 1 / 100, 1 / 20]).all(), found / bounds)

    def test_to_nearest_it_is_half(self):
        found = in_floats([Rounding("nearest")])
        self.assertTrue((found < astuple(uniform.errors(False, 0.5))).all(), found)

    def test_fails_with_fewer_bits(self):
        found = in_floats([Rounding("nearest", lost_bits=11)])
        self.assertTrue((found > np.array(astuple(uniform.errors(False)))).all(), found)

    def test_the_table(self):
        for row, of in zip(read_uniform(), (uniform.errors(False), uniform.errors(True))):
            for rounded, derived in zip(astuple(row), astuple(of)):
                self.assertTrue(derived <= rounded < derived * 1.01)

    def test_a_formula_of_the_test_is_that_of_the_oracle(self):
        rng = np.random.default_rng(3)
        for of, exact, right in ((some_values(rng, 30), value_and_slope, oracle.uniform_d),
                                 (some_sums(rng, 30), spread_of_sum, oracle.spread_fbm)):
            for found, row in zip(np.array(exact(**of)).T, zip(*of.values())):
                np.testing.assert_allclose(found, [float(x) for x in right(*row)], 1e-9, 1e-9)


class Integers(unittest.TestCase):
    def test_fixed(self):
        found, bounds = in_integers(), np.array(astuple(uniform.errors(True)))
        self.assertTrue((found < bounds).all(), (found, bounds))
        self.assertTrue((found > bounds / 40).all(), found / bounds)

    def test_coarser_units_are_noticed(self):
        bounds = np.array(astuple(uniform.errors(True)))
        coarse = mock.patch.object(oracle, "quotient", lambda x, t: x * 2**9 // t << 9)
        with mock.patch.object(oracle, "UNIT", 2**12), coarse:
            found = in_integers()
        self.assertTrue((found > bounds).all(), found / bounds)


if __name__ == "__main__":
    unittest.main()
