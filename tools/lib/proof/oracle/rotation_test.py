"""Tests of rotation.py, and of the noises whose gradients rotate: by hand, whole turns and quarters, and linearity."""

from __future__ import annotations

import itertools
import math
import unittest
from fractions import Fraction
from unittest import mock

from proof.golden.generator import generator_of
from proof.golden.simplex_rows import PHASES
from proof.oracle import gradients, noises, rotation, words
from proof.oracle.gradients import Knobs
from proof.oracle.lattice import Lattice
from proof.oracle.rotation import Rotation

KNOBS = Knobs("lattice")
POINT = (Fraction(-2611, 1024), Fraction(5003, 1024), Fraction(777, 1024))


def some_words(count: int) -> list[int]:
    numbers = generator_of("turning")
    return [0, words.MASK, 0x55555555, 0xAAAAAAAA, 0x80400000] + [numbers.word() for _ in range(count)]


class SineOfTurns(unittest.TestCase):
    def test_quarters_are_exact(self) -> None:
        for quarters, sine in ((0, 0), (1, 1), (2, 0), (3, -1), (-1, -1), (4001, 1), (2**150, 0)):
            self.assertEqual(gradients.sine_of_turns(Fraction(quarters, 4)), sine)

    def test_is_as_exact_as_it_says(self) -> None:
        # The angles of 3/8 and 1/8 by the root of 1/2, and by what the sine of twice an angle is.
        half = Fraction(1, 2)
        for turns in (Fraction(1, 8), Fraction(3, 8), Fraction(-7, 8)):
            self.assertLess(abs(gradients.sine_of_turns(turns)**2 - half), 2 * gradients.SINE_ERROR)
        numbers = generator_of("double")
        for turns in [*map(Fraction, PHASES), *(Fraction(numbers.integer(-2**40, 2**40), 2**38) for _ in range(50))]:
            sine, cosine, twice = (gradients.sine_of_turns(x) for x in (turns, turns + Fraction(1, 4), 2 * turns))
            self.assertLess(abs(sine**2 + cosine**2 - 1), 4 * gradients.SINE_ERROR)
            self.assertLess(abs(2 * sine * cosine - twice), 5 * gradients.SINE_ERROR)

    def test_the_smallest_ones(self) -> None:
        tiny = Fraction(1, 2**149)
        self.assertAlmostEqual(float(gradients.sine_of_turns(tiny) / tiny), 2 * math.pi)


class Quarters(unittest.TestCase):
    def test_by_hand(self) -> None:
        self.assertEqual(rotation.quarter_rotated((3, -5)), (5, 3))
        # An axis without a component keeps none.
        for g, expected in (((1, 1, 0), (-1, 1, 0)), ((1, -1, 0), (1, 1, 0)), ((-1, 0, 1), (-1, 0, -1)),
                            ((1, 0, 1), (-1, 0, 1)), ((0, 1, 1), (0, -1, 1)), ((0, -1, -1), (0, 1, -1))):
            self.assertEqual(rotation.quarter_rotated(g), expected, g)


class Rotated(unittest.TestCase):
    def test_by_quarters(self) -> None:
        for n, h in itertools.product((2, 3), some_words(20)):
            g = gradients.OCTAHEDRAL[n](h)
            quarter = rotation.quarter_rotated(g)
            for phase, expected in ((0.0, g), (1.0, g), (-3e38, g), (0.25, quarter), (-0.75, quarter),
                                    (1000.25, quarter), (0.5, [-x for x in g]), (-0.25, [-x for x in quarter])):
                self.assertEqual(rotation.rotated(g, phase), tuple(expected))

    def test_by_an_eighth(self) -> None:
        for x, expected in zip(rotation.rotated((1.0, 0.0), 0.125), (0.5**0.5, 0.5**0.5)):
            self.assertAlmostEqual(float(x), expected)


class Fixed(unittest.TestCase):
    def test_angles(self) -> None:
        table = {0.0: 0, -0.0: 0, 0.25: 2**30, 1.25: 2**30, -0.25: 3 * 2**30, -1.0: 0, 2.0**-30: 4, 2.0**-31: 0,
                 -2.0**-31: 0, -2.0**-30: 2**32 - 4, 3 * 2.0**-31: 4, 1e-40: 0, 3e38: 0, 1 - 2.0**-24: 2**32 - 2**8,
                 1000.125: 2**29}
        for phase, expected in table.items():
            self.assertEqual(rotation.angle(phase), expected, phase)

    def test_turns_by_hand(self) -> None:
        # The sine of a quarter is that of x = 65535: 65535 in units of 2^-16.
        for phase, expected in ((0, Rotation(262140, 0)), (0.25, Rotation(0, 262140)), (0.5, Rotation(-262140, 0)),
                                (-0.25, Rotation(0, -262140)), (7, Rotation(262140, 0))):
            self.assertEqual(rotation.rotation_of(phase), expected)
        # x = 2^15, u = 2^14, y = 102943 - 10261: 46341 in units of 2^-16 is the root of 1/2, cut.
        self.assertEqual(rotation.rotation_of(0.125), Rotation(4 * 46341, 4 * 46341))

    def test_turns_are_near(self) -> None:
        numbers = generator_of("turns")
        for phase in [*PHASES, *(numbers.uniform(-2, 2) for _ in range(300))]:
            turn, turns = rotation.rotation_of(phase), Fraction(phase)
            for found, exact in ((turn.sine, turns), (turn.cosine, turns + Fraction(1, 4))):
                self.assertLess(abs(Fraction(found, 2**18) - gradients.sine_of_turns(exact)), 3.7e-5, phase)

    def test_both_quarters_by_hand(self) -> None:
        # Of a rotation 2^18 is 1.
        self.assertEqual(Rotation(2**17, -2**17).of(2**20, 2**19), 2**18)
        with mock.patch.object(rotation, "rotation_of", return_value=Rotation(2**17, 2**17)):
            sums = Lattice(KNOBS, phase=0.3).fixed_sums(lambda still: [2**20 + still.quarter * 2**19, 2**10])
        self.assertEqual(sums, [2**19 + 3 * 2**18, 2**10])
        self.assertEqual(Lattice(KNOBS).fixed_sums(lambda still: [still.quarter]), [False])

    def test_gradients_of_both_quarters(self) -> None:
        # (1, 3) / 4 becomes (-3, 1) / 4, and (-1, 0, 1) becomes (-1, 0, -1).
        still, quarter = Lattice(KNOBS), Lattice(KNOBS, quarter=True)
        h, d = 2 << 21, (3 * 2**10, 5 * 2**10)
        self.assertEqual(still.fixed_ramp(h, d), 128 * (3072 + 15360))
        self.assertEqual(quarter.fixed_ramp(h, d), 128 * (5120 - 9216))
        self.assertEqual(quarter.fixed_octahedral(h, 2), (-3 * 2**25, 2**25))
        h, d = 0x60400000, (3 * 2**10, 5 * 2**10, 7 * 2**10)
        self.assertEqual(still.fixed_ramp(h, d), 512 * (7168 - 3072))
        self.assertEqual(quarter.fixed_ramp(h, d), 512 * (-3072 - 7168))
        self.assertEqual(quarter.fixed_octahedral(h, 3), (-2**27, 0, -2**27))


class Noises(unittest.TestCase):
    def test_a_quarter_uses_the_rotated_gradient(self) -> None:
        # A derivative at a lattice point of Perlin noise is the component of its gradient.
        for n in (2, 3):
            point = (5, -6, 7)[:n]
            g = rotation.quarter_rotated(gradients.gradient(KNOBS, point, 9))
            value, *slopes = noises.find("perlin_d_phase").rotated(0.25).exact(KNOBS, point, 9)
            scale = {2: Fraction(1831, 1024), 3: Fraction(985, 1024)}[n]
            self.assertEqual((value, slopes), (0, [scale * Fraction(x) for x in g]))

    def test_what_does_not_rotate(self) -> None:
        with self.assertRaisesRegex(ValueError, "the gradients of value do not rotate"):
            noises.find("value").rotated(0.5)
        for form, name, n in itertools.product(("exact", "fixed"), ("perlin_phase", "perlin_d_phase"), (2, 3)):
            with self.assertRaises(ValueError):
                getattr(noises.find(name), form)(Knobs("lattice", sine=True), POINT[:n])
        for form, n in itertools.product(("exact", "fixed"), (1, 4)):
            with self.assertRaisesRegex(ValueError, "two and three"):
                getattr(noises.find("perlin_phase").rotated(0.3), form)(KNOBS, (0.3,) * n)


class Words(unittest.TestCase):
    def test_the_lattice_hands_its_phase_on(self) -> None:
        lattice = Lattice(KNOBS, 3, (), 0.25)
        h = lattice.word((1, 2))
        self.assertEqual(lattice.gradient((1, 2)), rotation.quarter_rotated(gradients.gradient2(h)))
