"""HN_FIXED has the same bits however floats round, and whether products are fused with sums or not: of every function,
over floats that do so."""

import unittest

import numpy as np

from bounds.rounded import Rounding, Text, roundings, table

COUNT = 200


def column(rng, name, type_):
    """Random arguments, by their names in the table; of words all."""
    within = {"f": (0, 1), "phase": (-3, 3), "jitter": (0, 1), "metric": (1, 6), "octaves": (1, 6), "detail": (0, 5),
              "footprint": (0, 1), "lacunarity": (0, 4), "gain": (0, 1), "strength": (0, 4), "amplitude": (0, 2),
              "p": (-2, 9), "cells": (1, 100), "units": (1, 100)} | {f"k{axis}": (-20, 20) for axis in "xyz"}
    low, high = within.get(name) or within.get(name[0] if len(name) == 2 else "", (-1000, 1000))
    if type_ == "f32":
        return rng.uniform(low, high, COUNT).astype(np.float32)
    return rng.integers(-2**31, 2**31, COUNT) if (low, high) == (-1000, 1000) else rng.integers(low, high, COUNT)


def columns_of(id, seed=1):
    rng = np.random.default_rng(seed)
    return {name: column(rng, name, type_) for name, type_ in (one.split(":") for one in table()[id].inputs.split())}


class Fixed(unittest.TestCase):
    @staticmethod
    def differing(text, ids, others):
        """The functions whose bits are others than those of floats that round to nearest."""
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
        text = Text(ids, "HN_ARITHMETIC=HN_FIXED", optimized=True)
        self.assertEqual(self.differing(text, ids, roundings(2)), [])

    def test_floats_have_others(self):
        """A must-fail check."""
        ids = ("noise2d.perlin", "fbm.fbm3")
        self.assertEqual(self.differing(Text(ids), ids, roundings(2)), list(ids))


if __name__ == "__main__":
    unittest.main()
