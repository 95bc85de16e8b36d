"""Tests of the proofs for phasor noise and its derivatives: bounds hold in boxes, the steps from t to a weight are
within theirs, and no word overflows."""

import functools
import unittest
from dataclasses import replace

import numpy as np

from proof.bounds.boxes import Boxes
from proof.bounds.kernels import Offsets
from proof.bounds.noises import phasor, phasor_d
from proof.bounds.noises.phasor import KERNELS, OWN, WAVES
from proof.bounds.rounded import FIXED, NEAREST, Body, Text
from proof.bounds.sine import fixed_sines
from proof.bounds.table import bounds_of

MIDDLE = {2: (0.25, 0.0), 3: (0.25, 0.25, 0.25)}  # of two lattice points, in cells: where the weights sum to most


def weight(t):
    """w and its derivative, as the contract has them."""
    return t**3 * (1 + 15 * (1 - t)**2), 3 * (4 * t - 5 * t**2)**2


class Exact(unittest.TestCase):
    def test_scales_leave_little_room(self):
        for dims, kernel in KERNELS.items():
            for derive in (phasor.derive, phasor.derive_own):
                self.assertTrue(0.9985 < phasor.length(derive(dims, None)) < 1)
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
            self.assertTrue(0.999 < slope / phasor_d.range_of(kernel) <= 1)
            self.assertTrue(0.99 < slope * dims / phasor.lipschitz_of(kernel) <= 1)
            self.assertTrue(0.95 < (2 * np.pi * WAVES)**2 * dims * reached / phasor_d.lipschitz_of(kernel) <= 1)

    def test_shorter_waves(self):
        """The claim of docs/measured/accuracy.md."""
        for kernel in KERNELS.values():
            slower = replace(kernel, waves=WAVES / 4)
            self.assertTrue(0.999 < 4 * phasor.lipschitz_of(slower) / phasor.lipschitz_of(kernel) < 1.004)

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

    def test_first_derivatives(self):
        """Second derivatives of waves at random angles, in small boxes, are within the assumptions."""
        rng, step = np.random.default_rng(3), 1e-5
        for dims, kernel in KERNELS.items():
            boxes, angle = Boxes(5, rng.integers(0, 16, (dims, 200))), rng.uniform(0, 2 * np.pi, 200)
            u, s, m = (1.0,) + (0.0,) * (dims - 1), (1.0,) * dims, kernel.fall
            rates = phasor.rate_along(kernel, 1), -phasor.rate_along(kernel, dims)
            for point in kernel.points:
                def bend(d):
                    t = np.maximum(kernel.radius - m * (d * d).sum(axis=0), 0)
                    w, dw, ddw = (kernel.weight.derivative(order, t) for order in range(3))
                    real = -2 * m * dw + 4 * m * m * ddw * d[0] * d.sum(axis=0) - rates[0] * rates[1] * w
                    return np.cos(angle) * real + np.sin(angle) * 2 * m * dw * (
                        rates[0] * d.sum(axis=0) + rates[1] * d[0])
                middle, offsets = (boxes.lo + boxes.hi) / 2 - np.array(point)[:, None], Offsets.of(kernel, boxes, point)
                for axis, unit in enumerate(np.eye(dims)):
                    moved = step * unit[:, None]
                    first = (bend(middle + moved) - bend(middle - moved)) / (2 * step)
                    bound = phasor_d.slope_along(kernel, u, s, rates, offsets, axis)
                    self.assertLess((abs(first) - bound).max(), 1e-3)


@functools.cache
def text():
    """A weight and its fall, by t; in their units."""
    steps = {"weight": "hn_i_weight_wave(int(a.x))", "fall": "hn_i_d_weight_wave(int(a.x), int(a.y))"}
    return Text([], FIXED, **{name: Body.of("t:i32 m:i32", "n:i32", f"return uvec4(uint({step}), 0u, 0u, 0u);")
                              for name, step in steps.items()})


class OwnWaves(unittest.TestCase):
    """The component of the wave of a point, of the wave, the bandwidth and the direction."""

    def test_integers(self):
        rng, own = np.random.default_rng(14), OWN[2]
        k, b = rng.uniform(-18, 18, 20_000).astype(np.float32), rng.uniform(-1, 18, 20_000).astype(np.float32)
        u = rng.integers(-2**16, 2**16 + 1, 20_000)
        exactly = np.clip(np.clip(k.astype(float), -16, 16) + np.clip(b.astype(float), 0, 16) * u / 2**16, -16, 16)
        text_ = Text([], FIXED, wave=Body.of("k:f32 b:f32 u:i32", "n:i32", (
            "return uvec4(uint(hn_i_own_wave(hn_i_waves(float_of(a.x)), hn_i_bandwidth(float_of(a.y)), int(a.z))), 0u, 0u, 0u);")))
        (found,) = text_.words("wave", NEAREST, k=k, b=b, u=u)
        ratio = (abs(found.astype(np.uint32).view(np.int32) * 2.0**-16 - exactly) / own.wave_cut).max()
        self.assertTrue(0.4 < ratio < 1, ratio)


class Weights(unittest.TestCase):
    """The bounds of the steps from t to a weight and its fall: t is off, and steps round."""
    def test_integers(self):
        """Every t, which may be off by a half of its unit: on the way to the weight all are words."""
        t = np.arange(2**16)
        for kernel in KERNELS.values():
            w, fall = (text().words(name, NEAREST, t=t, m=kernel.fall)[0].astype(np.int64) for name in ("weight", "fall"))
            for move in (-0.5, -0.25, 0.0, 0.25, 0.5):
                exactly = np.maximum(t + move, 0) / 2**16
                exact_w, exact_slope = weight(exactly)
                off = abs(move) / 2**16
                ratios = [(abs(w / 2**18 - exact_w) / kernel.weight.fixed(exactly, exactly, off)).max(),
                          (abs(fall / 2**18 - kernel.fall / 4 * exact_slope)
                           / kernel.weight.fixed_fall(exactly, exactly, off, kernel.fall)).max()]
                self.assertTrue(0.5 < min(ratios) and max(ratios) < 1, (kernel.dims, move, ratios))
        words = phasor.largest_words()
        self.assertTrue(0.99 * 2**32 < max(words.values()) < 2**32)
        self.assertEqual(words["of H"], 65530**2 + 2**15)


class Fixed(unittest.TestCase):
    def test_no_product_overflows(self):
        """The largest wave, the ends of offsets and all sines reach the sizes that are proven."""
        k, d = int(WAVES * 2**16), np.array([-2**20, -1, 2**20 - 1, 2**20])
        ramp = fixed_sines().max() * 2**13
        for dims in KERNELS:
            largest = phasor.largest_intermediates(dims, None)
            self.assertLess(max(largest.values()), 2**31)
            reached = [abs(k * (d >> 10)).max(), abs(k * (d & 1023)).max(), ramp]
            self.assertEqual(reached, [largest[name] for name in (
                "wave times the high bits", "wave times the low bits", "ramp")])

    def test_no_product_of_derivatives_overflows(self):
        """The largest wave and the ends of values and of offsets nearly reach the bounds."""
        turns = phasor_d.whole_turns(KERNELS[2])
        self.assertLess(abs(turns).max(), 2**20)
        for dims in KERNELS:
            largest = phasor_d.largest_intermediates(dims, None)
            self.assertLess(max(largest.values()), 2**31)
            high = abs(np.array([-2**29, 2**29]) >> 9) * (abs(turns).max() >> 9)
            self.assertTrue(0.99 < high.max() / largest["rotated"] <= 1)
            self.assertLess(max(phasor_d.largest_own_intermediates(dims, None).values()), 2**31)
