"""Tests of the proofs for hex tiling: the text of the library over floats of any rounding mode stays within the
bounds, and reaches a part of them. A wrong constant is noticed."""

import functools
import unittest

import numpy as np

from proof.bounds.noises import hex_tiling
from proof.bounds.rounded import Rounding, Text, along_axes, roundings
from proof.bounds.table import bounds_of

COUNT = 4_000
CLEAR = 2.0**-20  # how far X and Y are from whole numbers: there the corners change
VECTORS = ("hex_x", "hex_y")


@functools.cache
def text():
    return Text([f"noise2d.{name}" for name in ("hex_weights", *VECTORS)])


def random_floats(rng, low=0.0):
    """In [low, 1], often near the ends, and many near the seam between two triangles."""
    x, y = rng.uniform(low, 1, (2, COUNT)).astype(np.float32).astype(float)
    near = np.abs(y / 2 + rng.integers(-20, 21, COUNT) * 2.0**-25).astype(np.float32).astype(float)
    x = np.where(rng.random(COUNT) < 0.3, near, x)
    skewed = np.array([2 * x + y, 2 * y])
    kept = (abs(skewed - np.rint(skewed)) > CLEAR).all(axis=0)
    return x[kept], y[kept]


def skewed_parts(x, y):
    """u and v, which doubles hold nearly exactly."""
    return (2 * x + y) % 1, 2 * y % 1


def weights(x, y):
    u, v = skewed_parts(x, y)
    return np.where(u > v, [1 - u, u - v, v], [1 - v, v - u, u])


def vectors(x, y):
    """Along x and along y, from the first corner, from that along X or Y, and from the last."""
    u, v = skewed_parts(x, y)
    along_x = u - v / 2
    return (np.array([along_x, np.where(u > v, along_x - 1, along_x + 0.5), along_x - 0.5]) / 2,
            np.array([v, np.where(u > v, v, v - 1), v - 1]) / 2)


class Floats(unittest.TestCase):
    def largest(self, simulated, low=0.0):
        """The largest error of a weight, and from a cell of a component of a vector where its corners are clear."""
        rng, errors = np.random.default_rng(1), [0.0, 0.0]
        for rounding in simulated:
            x, y = random_floats(rng, low)
            found = text()("noise2d.hex_weights", rounding, x=x, y=y, seed=7)
            errors[0] = max(errors[0], abs(np.array(found) - weights(x, y)).max())
            if low < 0:
                continue
            u, v = skewed_parts(x, y)
            clear = abs(u - v) > CLEAR
            place = along_axes("c", (5, -3)) | along_axes("f", (x[clear], y[clear])) | along_axes("p", (0, 0))
            for name, exactly in zip(VECTORS, vectors(x[clear], y[clear])):
                found = text()(f"noise2d.{name}", rounding, **place, seed=7)
                errors[1] = max(errors[1], abs(np.array(found) - exactly).max())
        return errors

    def test_simulated(self):
        of_weights, of_vectors = self.largest(roundings(1))
        bound = bounds_of("hex_tiling", 2, "none")
        self.assertTrue(bound.cell_error / 2 < of_weights < bound.cell_error, of_weights)
        vector = hex_tiling.offset_error(2, False) - 2.0**-24  # from a cell
        self.assertTrue(vector / 2 < of_vectors < vector, of_vectors)
        self.assertLess(vector, bound.cell_error)
        from_position = self.largest(roundings(2), -1.0)[0]
        self.assertTrue(bound.error / 3 < from_position < bound.error, from_position)

    def test_fails_with_fewer_bits(self):
        of_weights, of_vectors = self.largest([Rounding("nearest", lost_bits=2)])
        self.assertGreater(of_weights, hex_tiling.weight_error())
        self.assertGreater(of_vectors, hex_tiling.offset_error(2, False))

    def test_to_nearest_it_is_half(self):
        self.assertLess(self.largest([Rounding("nearest")])[0], hex_tiling.weight_error(0.5))

    def test_weights_are_in_their_range(self):
        rng = np.random.default_rng(3)
        for rounding in roundings(4):
            x, y = random_floats(rng, -1.0)
            found = np.array(text()("noise2d.hex_weights", rounding, x=x, y=y, seed=7))
            self.assertTrue(found.min() >= 0 and found.max() <= 1)
            self.assertLess(abs(found.sum(axis=0) - 1).max(), 2.0**-22)


if __name__ == "__main__":
    unittest.main()
