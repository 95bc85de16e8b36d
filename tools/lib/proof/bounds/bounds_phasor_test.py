"""Tests of the proofs for phasor noise and its derivatives: bounds are reached, and hold in boxes."""

import unittest

import numpy as np

from proof.bounds.boxes import Boxes
from proof.bounds.kernels import Offsets
from proof.bounds.noises import phasor
from proof.bounds.noises.phasor import KERNELS, WAVES
from proof.bounds.table import bounds_of

MIDDLE = {2: (0.25, 0.0), 3: (0.25, 0.25, 0.25)}  # of two lattice points, in cells: where the weights sum to most


def weight(t):
    """w and its derivative, as the contract has them."""
    return t**3 * (1 + 15 * (1 - t)**2), 3 * (4 * t - 5 * t**2)**2


class Exact(unittest.TestCase):
    def test_scales_leave_little_room(self):
        for dims, kernel in KERNELS.items():
            self.assertTrue(0.9985 < phasor.range_of(kernel) < 1)
            self.assertGreater(phasor.range_of(kernel) * (kernel.scale + 1) / kernel.scale, 1)
            for noise in ("phasor", "phasor_bandwidth"):
                self.assertEqual((bounds_of(noise, dims, "none").limit, bounds_of(noise, dims, "none").fixed_limit), (1, 1))

    def test_range_is_reached(self):
        """In the middle of two lattice points, where all waves may agree. Derivatives along an axis reach theirs there,
        too, where both the noise and its slope are the sums of the weights."""
        for dims, kernel in KERNELS.items():
            middle = np.array(MIDDLE[dims])[:, None] * kernel.steps
            reached = kernel.scale / 1024 * phasor.attained(kernel, (0.0,) * dims, 1.0, middle)[0]
            self.assertTrue(0.99999 * phasor.range_of(kernel) < reached <= phasor.range_of(kernel))
            slope = 2 * np.pi * WAVES * reached
            self.assertTrue(0.999 < slope / phasor.slope_of(kernel) <= 1)

    def test_weight_by_its_slope(self):
        """The slope is the weight's, and both are within the ends for each range of t."""
        rng, step, own = np.random.default_rng(11), 1e-6, KERNELS[3].weight
        low, high = np.sort(rng.uniform(0, 1, (2, 4000)), axis=0)
        between = low + (high - low) * np.linspace(0, 1, 65)[:, None]
        (w, slope), (after, _), (before, _) = (weight(between + move) for move in (0, step, -step))
        self.assertLess(abs((after - before) / (2 * step) - slope).max(), 1e-8)
        for order, values in enumerate((w, slope)):
            self.assertLess(abs(own.derivative(order, between) - values).max(), 1e-13)
            least, largest = own.ends(order, low, high)
            self.assertTrue((values > least - 1e-13).all() and (values < largest + 1e-13).all())
            self.assertLess(np.mean(largest - least) / np.mean(values.max(axis=0) - values.min(axis=0)), 1.001)

    def test_second_derivatives(self):
        """Waves at random angles, in small boxes, are within the assumptions."""
        rng, step = np.random.default_rng(3), 1e-4
        for dims, kernel in KERNELS.items():
            boxes, angle = Boxes(5, rng.integers(0, 16, (dims, 200))), rng.uniform(0, 2 * np.pi, 200)
            u, rate = (1.0,) * dims, phasor.rate_along(kernel, dims)
            for point in kernel.points:
                def rise(d):
                    t = np.maximum(kernel.radius - kernel.fall * (d * d).sum(axis=0), 0)
                    w, dw = weight(t)
                    return np.cos(angle) * 2 * kernel.fall * dw * d.sum(axis=0) + np.sin(angle) * rate * w
                middle, offsets = (boxes.lo + boxes.hi) / 2 - np.array(point)[:, None], Offsets.of(kernel, boxes, point)
                for axis, unit in enumerate(np.eye(dims)):
                    moved = step * unit[:, None]
                    second = (rise(middle + moved) + rise(middle - moved) - 2 * rise(middle)) / step**2
                    bound = phasor.second_derivative(kernel, u, rate, offsets, axis)
                    self.assertLess((abs(second) - bound).max(), 1e-3)
