"""Tests of rotation.py: by hand, by whole turns, sixths and quarters. (vectors_test.py has noises that rotate.)"""

from __future__ import annotations

import unittest
from collections.abc import Sequence
from fractions import Fraction

from proof.golden.generator import generator_of
from proof.oracle import gradients, hashes, noises, rotation
from proof.oracle.gradients import SINE_ERROR, Knobs, sine_of_turns
from proof.oracle.testing import FORMS, KNOBS, PHASES

# By hand: in space the gradient of a word, and the edge that it is after a sixth of a turn.
PAIRS = {0x00000000: ((1, 1, 0), (0, 1, 1)), 0x00100000: ((1, 1, 0), (0, 1, -1)),
         0x00700000: ((-1, -1, 0), (0, -1, -1)), 0x55555554: ((-1, 1, 0), (0, 1, -1)),
         0x55555555: ((-1, 0, 1), (-1, -1, 0)), 0x80200000: ((1, 0, -1), (1, 1, 0)),
         0xAAAAAAA9: ((1, 0, -1), (1, 1, 0)), 0xAAAAAAAA: ((0, 1, -1), (1, 0, -1)),
         0xC0500000: ((0, -1, 1), (-1, 0, 1)), hashes.MASK: ((0, -1, -1), (-1, 0, -1))}


class Exact(unittest.TestCase):
    """A sine that is less exact than it should be, or a gradient that turns in another plane or another way."""

    def near(self, found: Sequence[Fraction], expected: Sequence[float | Fraction]) -> None:
        for x, y in zip(found, expected, strict=True):
            self.assertLess(abs(x - Fraction(y)), 6 * SINE_ERROR)

    def test_sine_of_turns(self) -> None:
        for quarters, sine in ((0, 0), (1, 1), (2, 0), (3, -1), (-1, -1), (2**150, 0)):
            self.assertEqual(sine_of_turns(Fraction(quarters, 4)), sine)
        # The angle of 1/8 by the root of 1/2, and others by the sine of twice an angle.
        self.assertLess(abs(sine_of_turns(Fraction(1, 8))**2 - Fraction(1, 2)), 2 * SINE_ERROR)
        numbers = generator_of("double")
        for turns in [*map(Fraction, PHASES), *(Fraction(numbers.integer(-2**40, 2**40), 2**38) for _ in range(20))]:
            sine, cosine, twice = (sine_of_turns(x) for x in (turns, turns + Fraction(1, 4), 2 * turns))
            self.near((sine**2 + cosine**2, 2 * sine * cosine), (1, twice))

    def test_by_parts_of_a_turn(self) -> None:
        root = rotation.INVERSE_ROOT
        self.assertTrue(3 * root**2 < 1 < 3 * (root + Fraction(1, 2**gradients.SINE_BITS))**2)
        for h, (g, e) in PAIRS.items():
            self.assertEqual((gradients.gradient3(h), rotation.other(g, h)), (g, e), hex(h))
            third, quarter = [y - x for x, y in zip(g, e)], [(2 * y - x) * root for x, y in zip(g, e)]
            for phase, expected in ((0, g), (Fraction(1, 6), e), (Fraction(1, 3) - 7, third), (0.25, quarter),
                                    # Half of the way to e: g + e, as long as g.
                                    (Fraction(1, 12), [(x + y) * root for x, y in zip(g, e)])):
                self.near(rotation.rotated(g, h, phase), expected)
                self.near(rotation.rotated(g, h, phase + Fraction(1, 2)), [-x for x in expected])
            x, y = plane = gradients.gradient2(h)
            for phase, expected in ((-3e38, plane), (0.25, (-y, x)), (0.5, (-x, -y)), (-0.25, (y, -x))):
                self.assertEqual(rotation.rotated(plane, h, phase), expected)


class Fixed(unittest.TestCase):
    """An angle of fixed arithmetic that is cut in another place, and what has no rotation."""

    def test_angles(self) -> None:
        for phase, expected in ((1.25, 2**30), (-0.25, 3 * 2**30), (2.0**-30, 4), (2.0**-31, 0), (-2.0**-31, 0),
                                (-2.0**-30, 2**32 - 4), (3 * 2.0**-31, 4), (3e38, 0), (1 - 2.0**-24, 2**32 - 2**8)):
            self.assertEqual(rotation.angle(phase), expected, phase)

    def test_what_does_not_rotate(self) -> None:
        with self.assertRaisesRegex(ValueError, "the gradients of value do not rotate"):
            noises.find("value").rotated(0.5)
        for form in FORMS:
            with self.assertRaises(ValueError):
                getattr(noises.find("perlin_phase"), form)(Knobs("lattice", sine=True), (0.3, 0.7))
            with self.assertRaisesRegex(ValueError, "two and three"):
                getattr(noises.find("perlin_phase").rotated(0.3), form)(KNOBS, (0.3,))
