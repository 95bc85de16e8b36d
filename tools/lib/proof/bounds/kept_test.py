"""Tests of kept.csv: no noise changes faster than its Lipschitz constant, by the text in doubles at random places, and some
place comes near to it."""

import functools
import math
import unittest

import numpy as np

from proof.bounds.kept import Kept, kept, read
from proof.bounds.rounded import EXACT, Text
from proof.errors.record import CELL, DERIVATIVE, POSITION, VALUE
from proof.errors.results import functions, kind_of, usual

POINTS, STEP = 20_000, 2.0**-18
NEAR = 0.24  # of a constant: the least that these places reach
# Its direction turns ever faster near its point, and the constant is that of the derivative times the distance.
NOT_COMPARED = {("cellular_d", DERIVATIVE)}


@functools.cache
def text():
    return Text([])


def drawn(spec, rng):
    """Numbers of an argument of results.usual."""
    kind, *ends = spec.split(":")
    if kind == "any":
        return rng.integers(0, 2**32, POINTS)
    low, high = map(float, ends)
    return rng.integers(int(low), int(high) + 1, POINTS) if kind == "word" else rng.uniform(low, high, POINTS)


@functools.cache
def change(name, dims, kind):
    """The largest of a result, for a step whose components are STEP in size."""
    rng = np.random.default_rng(5)
    function = next(functions()[name, dims, form, kind][0] for form in (CELL, POSITION) if (name, dims, form, kind) in functions())
    columns = {column.name: drawn(usual(column.name), rng) for column in function.inputs}
    places = [f"f{axis}" if f"f{axis}" in columns else axis for axis in "xyzw"[:dims]]
    columns["metric"] = rng.integers(1, 6, POINTS)
    if "jitter" in columns:
        columns["jitter"] = 1.0
    if "bandwidth" in columns:
        columns["bandwidth"] = rng.uniform(0, 16, POINTS)
    columns = {column.name: columns[column.name] for column in function.inputs}
    moved = {place: columns[place] + STEP * rng.choice((-1, 1), POINTS) for place in places}
    outputs = [i for i, column in enumerate(function.outputs) if kind_of(column.name) == kind]
    before, after = (text()(function.id, EXACT, **of) for of in (columns, columns | moved))
    return max(abs(after[i] - before[i]).max() for i in outputs) / STEP


def wrong(name, dims, kind, constant):
    """A message where the constant is less than a change, or far from it."""
    found = change(name, dims, kind)
    if not NEAR * constant < found < constant * (1 + 1e-6):
        return f"{name}, {dims}D, {kind}: L is {constant:g}, and places have {found:.4g}"
    return ""


class Constants(unittest.TestCase):
    def test_each(self):
        rows = {key: one for key, one in read().items() if math.isfinite(one.lipschitz) and key[2] != "sine"
                and (key[0], key[3]) not in NOT_COMPARED}
        self.assertGreater(len(rows), 80)
        for (name, dims, _, kind), one in rows.items():
            with self.subTest(name, dims=dims, kind=kind):
                self.assertEqual(wrong(name, dims, kind, one.lipschitz), "")

    def test_wrong_ones_are_noticed(self):
        constant = kept("perlin", 2, "octahedral", VALUE).lipschitz
        self.assertIn("perlin, 2D, value: L is", wrong("perlin", 2, VALUE, constant / 3))
        self.assertIn("perlin, 2D, value: L is", wrong("perlin", 2, VALUE, constant * 5))
        with self.assertRaisesRegex(LookupError, "kept.csv has no row of merlin, 2D, none, value: write one"):
            kept("merlin", 2, "none", VALUE)


class Limits(unittest.TestCase):
    def test_they_are_between_the_range_and_its_error(self):
        for limit, found in ((None, 1.5), (1.25, 1.25), (100.0, 1.5)):
            self.assertEqual(Kept(1.0, limit, None).limits("merlin", 1.0, 0.0, (0.5, 0.25)), (found, 1.25))
        self.assertEqual(Kept(1.0, None, None).limits("merlin", 1.0, 2.0, (0.5, 0.25)), (2.0, 2.0))
        with self.assertRaisesRegex(LookupError, "merlin has the limit 0.9, which is less than its range, 1"):
            Kept(1.0, 0.9, None).limits("merlin", 1.0, 0.0, (0.5, 0.25))
