"""Tests of the proofs for the derivatives of phasor noise: the text of the library stays within the bounds, and
reaches a part of them. A wrong constant is noticed."""

import unittest
from unittest import mock

import numpy as np

from proof.bounds import kernel_model
from proof.bounds.bounds_phasor_test import AXES, MIDDLE, agreeing_words, below_zero, random_case, text
from proof.bounds.boxes import Boxes
from proof.bounds.kernels import Offsets
from proof.bounds.noises import phasor, phasor_d
from proof.bounds.noises.phasor import KERNELS, WAVES
from proof.bounds.rounded import FIXED, Rounding, along_axes, roundings
from proof.bounds.table import bounds_of


def proven(dims):
    return bounds_of("phasor_d", dims, "none", "SLOPE_BOUNDS")


def exactly(dims, cells, f, wave, phase):
    """The derivatives, and the same of the quadrature: axes by 2 by places."""
    kernel = KERNELS[dims]
    results = kernel_model.phasor_d(kernel, kernel_model.words_at(kernel, cells), f, wave, phase)
    return np.array([[n.real, n.imag] for n in results[1:]])


# --- The text of the library ------------------------------------------------------------------------------------------

def derivatives(form, dims, rounding, columns, *macros):
    return np.array([text(*macros)(f"{form}{dims}d{axis}", rounding, **columns) for axis in AXES[dims]])


def columns_of(cells, f, wave, phase):
    return along_axes("c", cells) | along_axes("f", f) | along_axes("k", wave) | {"phase": phase}


class Exact(unittest.TestCase):
    def test_model_is_the_derivative(self):
        rng, step = np.random.default_rng(1), 1e-6
        for dims, kernel in KERNELS.items():
            words = {tuple(kernel_model.halves(point)): rng.integers(0, 2**32, 500)
                     for point in kernel_model.points(kernel)}
            f, wave, phase = rng.random((dims, 500)), rng.uniform(-20, 20, (dims, 500)), rng.random(500)
            _, *slopes = kernel_model.phasor_d(kernel, lambda point: words[tuple(point)], f, wave, phase)
            for axis, slope in enumerate(slopes):
                moved = step * np.eye(dims)[axis][:, None]
                ends = [kernel_model.phasor(kernel, lambda point: words[tuple(point)], f + sign * moved, wave, phase)
                        for sign in (1, -1)]
                self.assertLess(abs((ends[0] - ends[1]) / (2 * step) - slope).max(), 1e-5)

    def test_range_is_reached(self):
        """In the middle of two lattice points the sum of the weights is largest, and all waves may agree."""
        for dims, kernel in KERNELS.items():
            f, wave = np.array(MIDDLE[dims])[:, None], np.full((dims, 1), float(WAVES))
            words = agreeing_words(kernel, wave[:, 0])
            slope = kernel_model.phasor_d(kernel, lambda point: np.array([words(point)]), f, wave, np.zeros(1))[1]
            self.assertTrue(0.999 < abs(slope).max() / phasor_d.range_of(kernel) <= 1)

    def test_steepest(self):
        """A derivative of the steepest waves, where they agree and weigh most, nearly reaches the constant."""
        rng, step = np.random.default_rng(2), 1e-7
        for dims, kernel in KERNELS.items():
            words = {tuple(kernel_model.halves(point)): rng.integers(0, 2**32, 2000)
                     for point in kernel_model.points(kernel)}
            f, wave = rng.random((dims, 2000)), rng.choice([-WAVES, WAVES], (dims, 2000))
            f[:, 0] = MIDDLE[dims]
            for point, of_point in words.items():
                of_point[0] = agreeing_words(kernel, wave[:, 0])(point)
            ends = [kernel_model.phasor_d(kernel, lambda point: words[tuple(point)], f + sign * step * np.sign(wave),
                                          wave, np.zeros(2000))[1:] for sign in (1, -1)]
            slopes = abs(np.array(ends[0]).real - np.array(ends[1]).real) / (2 * step)
            bound = phasor_d.lipschitz_of(kernel)
            self.assertTrue(0.95 * bound < slopes.max() < bound, (slopes.max(), bound))

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


class Fixed(unittest.TestCase):
    COUNT = 8000

    def errors(self, dims):
        case = random_case(4, dims, self.COUNT)
        found = derivatives("cell", dims, Rounding("nearest"), columns_of(*case), FIXED)
        self.assertLessEqual(abs(found).max(), proven(dims).fixed_limit)
        return abs(found - exactly(dims, *case)).max()

    def test_random_points(self):
        for dims in KERNELS:
            bound, seen = proven(dims).fixed_error, self.errors(dims)
            self.assertTrue(bound / 4 < seen < bound, (dims, seen, bound))

    def test_fails_with_fewer_bits(self):
        """Must-fail checks: exact waves, and weights with their falls, that are a little other ones."""
        phasor_d_of, weight = kernel_model.phasor_d, kernel_model.weight
        for name, other in (("phasor_d", lambda kernel, words, f, wave, phase: phasor_d_of(
                                kernel, words, f, np.floor(np.clip(wave, -WAVES, WAVES) * 2**11) / 2**11, phase)),
                            ("weight", lambda kernel, t: [(1 + 2**-8) * n for n in weight(kernel, t)])):
            with mock.patch.object(kernel_model, name, other):
                for dims in KERNELS:
                    self.assertGreater(self.errors(dims), proven(dims).fixed_error, (dims, name))

    def test_no_product_overflows(self):
        """The largest wave and the ends of values and of offsets nearly reach the bounds."""
        turns = phasor_d.whole_turns(KERNELS[2])
        self.assertLess(abs(turns).max(), 2**20)
        for dims in KERNELS:
            largest = phasor_d.largest_intermediates(dims, None)
            self.assertLess(max(largest.values()), 2**31)
            high = abs(np.array([-2**29, 2**29]) >> 9) * (abs(turns).max() >> 9)
            self.assertTrue(0.99 < high.max() / largest["rotated"] <= 1)


class Floats(unittest.TestCase):
    """The text of the library over floats of any rounding mode."""

    def test_from_a_cell(self):
        for dims in KERNELS:
            case, bound = random_case(6, dims, 3000), proven(dims)
            found = [derivatives("cell", dims, rounding, columns_of(*case)) for rounding in roundings(7)]
            seen = max(abs(n - exactly(dims, *case)).max() for n in found)
            self.assertTrue(bound.cell_error / 8 < seen < bound.cell_error, (dims, seen, bound.cell_error))
            self.assertLessEqual(max(abs(n).max() for n in found), bound.limit)

    def test_from_a_position(self):
        """Below 0, where the fraction rounds most, and where the noise is steepest."""
        for dims in KERNELS:
            bound, (_, f, wave, phase) = proven(dims), random_case(8, dims, 3000)
            p = below_zero(dims, f)
            expected = exactly(dims, [np.full(3000, -1)] * dims, 1 + p, wave, phase)
            columns = along_axes("", p) | along_axes("k", wave) | {"phase": phase}
            seen = max(abs(derivatives("position", dims, rounding, columns) - expected).max()
                       for rounding in roundings(10))
            self.assertTrue(bound.cell_error / 3 < seen < bound.error, (dims, seen, bound.error))

    def test_the_value_is_that_of_phasor(self):
        """So it has the same bounds."""
        for dims in KERNELS:
            of_value, bound = phasor.derive(dims, None), bounds_of("phasor_d", dims, "none")
            self.assertEqual(of_value.bounds("phasor_d", dims, None).rounded(), bound)
            case = random_case(6, dims, 500)
            kernel = KERNELS[dims]
            value = kernel_model.phasor(kernel, kernel_model.words_at(kernel, case[0]), *case[1:])
            found = text()(f"cell{dims}value", Rounding("nearest"), **columns_of(*case))
            self.assertLess(abs(found[0] + 1j * found[1] - value).max(), 2 * bound.cell_error)

    def test_fails_with_fewer_bits(self):
        """A must-fail check: a mantissa without 4 of its bits."""
        for dims in KERNELS:
            case = random_case(6, dims, 3000)
            found = derivatives("cell", dims, Rounding("nearest", lost_bits=4), columns_of(*case))
            self.assertGreater(abs(found - exactly(dims, *case)).max(), proven(dims).cell_error)


if __name__ == "__main__":
    unittest.main()
