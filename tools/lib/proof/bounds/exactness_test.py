"""HN_FIXED has the same bits however floats round, and whether products are fused with sums or not: of every function,
over floats that do so. The floats of its ramps are exact in any order of their sums."""

import itertools
import unittest

import numpy as np

from proof.bounds.features import METRICS
from proof.bounds.rounded import FIXED, Rounding, Text, roundings, table

COUNT = 200


def column(rng, name, type_):
    """Random arguments, by their names in the table; of words all."""
    within = {"f": (0, 1), "phase": (-3, 3), "jitter": (0, 1), "metric": (1, 1 + len(METRICS)), "octaves": (1, 6), "detail": (0, 5),
              "footprint": (0, 1), "lacunarity": (0, 4), "gain": (0, 1), "strength": (0, 4), "amplitude": (0, 2),
              "p": (-2, 9), "cells": (1, 100), "units": (1, 100)} | {f"k{axis}": (-20, 20) for axis in "xyz"}
    low, high = within.get(name) or within.get(name[0] if len(name) == 2 else "", (-1000, 1000))
    if type_ == "f32":
        ends = rng.choice((low, high), COUNT)
        return np.where(rng.random(COUNT) < 0.2, ends, rng.uniform(low, high, COUNT)).astype(np.float32)
    return rng.integers(-2**31, 2**31, COUNT) if (low, high) == (-1000, 1000) else rng.integers(low, high, COUNT)


def columns_of(id, seed=1):
    rng = np.random.default_rng(seed)
    return {one.name: column(rng, one.name, one.type) for one in table()[id].inputs}


class Fixed(unittest.TestCase):
    @staticmethod
    def differing(text, ids, others):
        """The functions with other bits than floats that round to nearest."""
        found = []
        for id in ids:
            columns = columns_of(id)
            nearest = text.words(id, Rounding("nearest"), **columns)
            if not all(np.array_equal(nearest, text.words(id, rounding, **columns)) for rounding in others):
                found.append(id)
        return found

    def test_bits_are_the_same_in_every_rounding(self):
        ids = [id for id in table() if not id.startswith("hash.") and "sine" not in id]
        self.assertGreater(len(ids), 300)
        text = Text(ids, FIXED)
        self.assertEqual(self.differing(text, ids, roundings(2)), [])

    def test_floats_have_others(self):
        """A must-fail check."""
        ids = ("noise2d.perlin", "fbm.fbm3")
        self.assertEqual(self.differing(Text(ids), ids, roundings(2)), list(ids))


class Ramps(unittest.TestCase):
    """The floats of HN_FIXED (direction.glsl and direction3d.glsl of glsl/hashnoise/detail/) at the extremes: 0, the
    ends, the middle, and the multiples of their units beside these. A double holds all sums."""

    PLANE = [(a * x / 4, b * y / 4) for x, y in ((3, 1), (1, 3)) for a in (1, -1) for b in (1, -1)]
    SPACE = [g for g in itertools.product((1, 0, -1), repeat=3) if g.count(0) == 1]

    @staticmethod
    def extremes(unit, largest=1.0):
        """On both sides of 0."""
        near = [x + k * unit for x in (0.0, largest / 3 // unit * unit, largest / 2, largest) for k in (-1, 0, 1)]
        return sorted({sign * x for x in near if 0 <= x <= largest for sign in (1, -1)})

    def wrong(self, terms, start, unit):
        """Which sums of some of the terms and the start are no floats, whether the sum of all is beyond the floats that
        have this unit, and whether its bits are another integer than that of the terms."""
        every = [*terms, start]
        sums = [sum(some) for count in range(1, len(every) + 1) for some in itertools.combinations(every, count)]
        found = [x for x in sums if float(np.float32(x)) != x]
        bits = np.array([sum(every), start], np.float32).view(np.int32)
        return found or bits[0] - bits[1] != sum(terms) / unit

    def check(self, cases, start, unit):
        self.assertEqual([terms for terms in cases if self.wrong(terms, start, unit)], [])

    def test_on_the_plane(self):
        offsets = self.extremes(2.0**-20)
        self.check([(g * x, h * y) for g, h in self.PLANE for x in offsets for y in offsets], 3.0, 2.0**-22)

    def test_in_space(self):
        """Simplex noise has offsets up to 3/2 from points that have no weight."""
        offsets = self.extremes(2.0**-20, 1.5)
        self.check([(g * x, h * y) for g in (1, -1) for h in (1, -1) for x in offsets for y in offsets], 12.0, 2.0**-20)
        self.check([(-x,) for x in offsets], 12.0, 2.0**-20)

    def test_components(self):
        """Between two gradients, also as h t - g t + g, and times a weight."""
        for some in (self.PLANE, self.SPACE):
            components = sorted({float(x) for g in some for x in g})
            pairs = list(itertools.product(components, repeat=2))
            for t in (t for t in self.extremes(2.0**-18) if t >= 0):
                self.check([((h - g) * t, g) for g, h in pairs], 3.0, 2.0**-22)
                self.check([(h * t, -g * t, g) for g, h in pairs], 3.0, 2.0**-22)
                self.check([(g * t,) for g in components], 3.0, 2.0**-22)

    def test_others_are_noticed(self):
        """Must-fail checks: a finer offset, a start behind which floats are coarser, and a sum that leaves its
        range."""
        for terms, start, unit in (((0.75 * 2.0**-21, 0.25), 3.0, 2.0**-22), ((0.75, 2.0**-22), 7.0, 2.0**-22),
                                   ((0.75, 0.75), 3.0, 2.0**-22), ((2.5, 2.5), 12.0, 2.0**-20)):
            self.assertTrue(self.wrong(terms, start, unit), (terms, start))
