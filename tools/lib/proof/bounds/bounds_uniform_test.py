"""Tests of the proofs for uniform values and spreads of sums: the text of the library over floats of any rounding
mode, and fixed arithmetic, stay within the bounds, and reach a part of them."""

import functools
import unittest
from dataclasses import astuple

import numpy as np

from proof.bounds import uniform
from proof.bounds.rounded import EXACT, FIXED, NEAREST, Text, roundings
from proof.bounds.table import UniformBounds

COUNT = 3_000
VALUE, SUM = "uniform.uniform_d", "uniform.spread_fbm"


@functools.cache
def text(*macros):
    return Text([VALUE, SUM], *macros)


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


def in_units(errors_of_value, errors_of_sum, value_reach, sum_reach):
    """Each error as the bounds have it: the largest of all points."""
    (value, slope), (reach, *others) = errors_of_value, errors_of_sum
    return UniformBounds(*(float(np.max(x)) for x in (value, slope * value_reach, reach / sum_reach, others)))


def largest_errors(simulated, *macros):
    """Beside the text in doubles."""
    rng, found = np.random.default_rng(1), []
    for rounding in simulated:
        values, sums = some_values(rng, COUNT), some_sums(rng, COUNT)
        errors = [[abs(x - right) for x, right in zip(text(*macros)(id, rounding, **of), text()(id, EXACT, **of))]
                  for id, of in ((VALUE, values), (SUM, sums))]
        found.append(astuple(in_units(*errors, values["reach"], sums["reach"])))
    return np.max(found, axis=0)


class Bounds(unittest.TestCase):
    def test_floats(self):
        found, bounds = largest_errors(roundings(1)), np.array(astuple(uniform.errors(False)))
        self.assertTrue((found < bounds).all(), (found, bounds))
        # The bounds of sums are far above their errors: they add all errors of a noise whose numbers are all 0.
        self.assertTrue((found > bounds * [1 / 4, 1 / 8, 1 / 100, 1 / 20]).all(), found / bounds)

    def test_integers(self):
        found, bounds = largest_errors([NEAREST], FIXED), np.array(astuple(uniform.errors(True)))
        self.assertTrue((found < bounds).all() and (found > bounds / 40).all(), (found, bounds))
