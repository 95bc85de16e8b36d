"""Tests of rotation.py, and of the noises whose gradients rotate: by hand, whole turns, sixths and quarters, and what
stays at each phase."""

from __future__ import annotations

import itertools
import math
import unittest
from collections.abc import Sequence
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


# By hand: in space the gradient of a word, and the edge that it is after a sixth of a turn.
PAIRS = {0x00000000: ((1, 1, 0), (0, 1, 1)), 0x00100000: ((1, 1, 0), (0, 1, -1)),
         0x00700000: ((-1, -1, 0), (0, -1, -1)), 0x55555554: ((-1, 1, 0), (0, 1, -1)),
         0x55555555: ((-1, 0, 1), (-1, -1, 0)), 0x80200000: ((1, 0, -1), (1, 1, 0)),
         0xAAAAAAA9: ((1, 0, -1), (1, 1, 0)), 0xAAAAAAAA: ((0, 1, -1), (1, 0, -1)),
         0xC0500000: ((0, -1, 1), (-1, 0, 1)), words.MASK: ((0, -1, -1), (-1, 0, -1))}


def some_words(count: int) -> list[int]:
    numbers = generator_of("turning")
    return [*PAIRS, *(numbers.word() for _ in range(count))]


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


class Others(unittest.TestCase):
    def test_by_hand(self) -> None:
        self.assertEqual(rotation.other((3, -5), 0), (5, 3))
        for h, (g, e) in PAIRS.items():
            self.assertEqual(gradients.gradient3(h), g, hex(h))
            self.assertEqual(rotation.other(g, h), e, hex(h))

    def test_every_edge_goes_along_two_circles(self) -> None:
        """In either way round; each gradient with one half of its words along each."""
        found = {(g, rotation.edge(g, h)) for h in range(0, 2**32, 2**20) for g in [gradients.gradient3(h)]}
        self.assertEqual(len(found), 24)
        for g, e in found:
            self.assertEqual(sum(x * y for x, y in zip(g, e)), 1)
        self.assertEqual(sorted(g for g, _ in found), sorted(2 * [*{g for g, _ in found}]))
        self.assertEqual(sorted(e for _, e in found), sorted(g for g, _ in found))


class Rotated(unittest.TestCase):
    def near(self, found: Sequence[Fraction], expected: Sequence[float | Fraction]) -> None:
        for x, y in zip(found, expected, strict=True):
            self.assertLess(abs(x - Fraction(y)), 6 * gradients.SINE_ERROR)

    def test_by_halves(self) -> None:
        for n, h in itertools.product((2, 3), some_words(20)):
            g = gradients.OCTAHEDRAL[n](h)
            for phase, expected in ((0.0, g), (1.0, g), (-3e38, g), (0.5, [-x for x in g]), (-1000.5, [-x for x in g])):
                self.assertEqual(rotation.rotated(g, h, phase), tuple(expected))

    def test_by_quarters_of_the_plane(self) -> None:
        for h in some_words(20):
            g = gradients.gradient2(h)
            for phase, (x, y) in ((0.25, (-g[1], g[0])), (-0.75, (-g[1], g[0])), (1000.25, (-g[1], g[0])),
                                  (-0.25, (g[1], -g[0]))):
                self.assertEqual(rotation.rotated(g, h, phase), (x, y))

    def test_by_sixths_and_quarters_of_space(self) -> None:
        root = rotation.INVERSE_ROOT
        for h, (g, e) in PAIRS.items():
            third, quarter = [y - x for x, y in zip(g, e)], [(2 * y - x) * root for x, y in zip(g, e)]
            for sixths, expected in enumerate((g, e, third)):
                for phase, sign in ((Fraction(sixths, 6), 1), (Fraction(sixths, 6) - 7, 1),
                                    (Fraction(sixths + 3, 6), -1)):
                    self.near(rotation.rotated(g, h, phase), [sign * x for x in expected])
            self.near(rotation.rotated(g, h, 0.25), quarter)
            self.near(rotation.rotated(g, h, -1000.25), [-x for x in quarter])
            # Half of the way to e: g + e, as long as g.
            self.near(rotation.rotated(g, h, Fraction(1, 12)), [(x + y) * root for x, y in zip(g, e)])

    def test_by_an_eighth(self) -> None:
        for x, expected in zip(rotation.rotated((1.0, 0.0), 0, 0.125), (0.5**0.5, 0.5**0.5)):
            self.assertAlmostEqual(float(x), expected)

    def test_the_root_is_as_exact_as_it_says(self) -> None:
        low, high = rotation.INVERSE_ROOT, rotation.INVERSE_ROOT + Fraction(1, 2**gradients.SINE_BITS)
        self.assertTrue(3 * low**2 < 1 < 3 * high**2)

    def test_the_length_and_in_space_the_fourth_powers_stay(self) -> None:
        for n, h, phase in itertools.product((2, 3), some_words(10), (*PHASES, Fraction(1, 8), Fraction(1, 12))):
            g = gradients.OCTAHEDRAL[n](h)
            now = rotation.rotated(g, h, phase)
            self.assertLess(abs(sum(x**2 for x in now) - sum(Fraction(x)**2 for x in g)), 2**-200)
            if n == 3:
                self.assertLess(abs(sum(x**4 for x in now) - 2), 2**-200)
                self.assertLess(abs(sum(x * s for x, s in zip(now, self.diagonal(g, rotation.edge(g, h))))), 2**-200)

    def diagonal(self, g: Sequence[float], e: Sequence[float]) -> list[int]:
        """It is perpendicular to both: a component is 1 or -1 along each axis."""
        found = [int(g[i - 2] * e[i - 1] - g[i - 1] * e[i - 2]) for i in range(3)]
        self.assertEqual([abs(x) for x in found], [1, 1, 1])
        return found

    def test_the_sums_over_all_gradients_stay(self) -> None:
        """The sums of section 4 of the contract: of components, of products of two and of three."""
        some = [(g, h) for h in range(0, 2**32, 2**20) for g in [gradients.gradient3(h)]]
        one_each = {(g, rotation.edge(g, h)): h for g, h in some}.items()
        for phase in (0, Fraction(1, 8), Fraction(1, 4), Fraction(0.3)):
            now = [rotation.rotated(g, h, phase) for (g, _), h in one_each]
            for x, y in itertools.product(range(3), repeat=2):
                self.assertLess(abs(sum(v[x] for v in now)), 2**-200)
                self.assertLess(abs(sum(v[x] * v[y] for v in now) - 16 * (x == y)), 2**-200)
                for z in range(3):
                    self.assertLess(abs(sum(v[x] * v[y] * v[z] for v in now)), 2**-200)


class Fixed(unittest.TestCase):
    def test_angles(self) -> None:
        table = {0.0: 0, 0.25: 2**30, 1.25: 2**30, -0.25: 3 * 2**30, -1.0: 0, 2.0**-30: 4, 2.0**-31: 0,
                 -2.0**-31: 0, -2.0**-30: 2**32 - 4, 3 * 2.0**-31: 4, 1e-40: 0, 3e38: 0, 1 - 2.0**-24: 2**32 - 2**8,
                 1000.125: 2**29}
        for phase, expected in (*table.items(), (-0.0, 0)):  # as a key it is 0.0
            self.assertEqual(rotation.angle(phase), expected, phase)

    def test_turns_by_hand(self) -> None:
        # The sine of a quarter is that of x = 65535: 65535 in units of 2^-16.
        for phase, expected in ((0, Rotation(262140, 0)), (0.25, Rotation(0, 262140)), (0.5, Rotation(-262140, 0)),
                                (-0.25, Rotation(0, -262140)), (7, Rotation(262140, 0))):
            self.assertEqual(rotation.rotation_of(phase, 2), expected)
        # x = 2^15, u = 2^14, y = 102943 - 10261: 46341 in units of 2^-16 is the root of 1/2, cut.
        self.assertEqual(rotation.rotation_of(0.125, 2), Rotation(4 * 46341, 4 * 46341))

    def test_turns_in_space_by_hand(self) -> None:
        # 65535 * 20277 = 32768 * 40553 + 12491: B is 262140 + 40553, and -262140 - 40554 with the other sign.
        for phase, expected in ((0, Rotation(262140, 0)), (0.5, Rotation(-262140, 0)), (7, Rotation(262140, 0)),
                                (0.25, Rotation(-151346, 302693)), (-0.25, Rotation(151347, -302694)),
                                # 46341 * 20277 = 32768 * 28676 + 1289
                                (0.125, Rotation(185364 - 107020, 214040)),
                                (-0.125, Rotation(185364 + 107021, -214041))):
            self.assertEqual(rotation.rotation_of(phase, 3), expected)

    def test_turns_are_near(self) -> None:
        numbers = generator_of("turns")
        for n, phase in itertools.product((2, 3), [*PHASES, *(numbers.uniform(-2, 2) for _ in range(300))]):
            turn, exact = rotation.rotation_of(phase, n), rotation.shares(phase, n)
            for found, share in zip((turn.of_gradients, turn.of_others), exact):
                # In space A has the errors of a cosine and of a sine; B rounds down, and its half to the other side.
                self.assertLess(abs(Fraction(found, 2**18) - share), 3.7e-5 if n == 2 else 1.6 * 3.7e-5 + 1.2 * 2**-18)

    def test_both_sums_by_hand(self) -> None:
        # Of a rotation 2^18 is 1.
        self.assertEqual(Rotation(2**17, -2**17).of(2**20, 2**19), 2**18)
        with mock.patch.object(rotation, "rotation_of", return_value=Rotation(2**17, 2**17)):
            sums = Lattice(KNOBS, phase=0.3).fixed_sums(3, lambda still: [2**20 + still.others * 2**19, 2**10])
        self.assertEqual(sums, [2**19 + 3 * 2**18, 2**10])
        self.assertEqual(Lattice(KNOBS).fixed_sums(3, lambda still: [still.others]), [False])

    def test_gradients_of_both_sums(self) -> None:
        # (1, 3) / 4 becomes (-3, 1) / 4, and beside (-1, 0, 1) with a bit 20 that is 1 there is (-1, -1, 0).
        still, others = Lattice(KNOBS), Lattice(KNOBS, others=True)
        h, d = 2 << 21, (3 * 2**10, 5 * 2**10)
        self.assertEqual(still.fixed_ramp(h, d), 128 * (3072 + 15360))
        self.assertEqual(others.fixed_ramp(h, d), 128 * (5120 - 9216))
        self.assertEqual(others.fixed_octahedral(h, 2), (-3 * 2**25, 2**25))
        h, d = 0x60500000, (3 * 2**10, 5 * 2**10, 7 * 2**10)
        self.assertEqual(still.fixed_ramp(h, d), 512 * (7168 - 3072))
        self.assertEqual(others.fixed_ramp(h, d), 512 * (-3072 - 5120))
        self.assertEqual(others.fixed_octahedral(h, 3), (-2**27, -2**27, 0))


class Noises(unittest.TestCase):
    def test_a_derivative_at_a_lattice_point_is_a_component_of_the_rotated_gradient(self) -> None:
        scales = {"perlin_d_phase": {2: Fraction(1831, 1024), 3: Fraction(879, 1024)},
                  "simplex_d_phase": {3: Fraction(4902, 1024)}}
        for name, n, seed, phase in itertools.product(scales, (2, 3), range(9, 15), (0.25, Fraction(1, 6), -0.3)):
            if n in scales[name]:
                point, scale = (5, -6, 7)[:n], scales[name][n]
                noise, h = noises.find(name).rotated(phase), Lattice(KNOBS, seed).word(point)
                g = rotation.rotated(gradients.OCTAHEDRAL[n](h), h, phase)
                value, *slopes = noise.exact(KNOBS, point, seed)
                self.assertEqual((value, slopes), (0, [scale * x for x in g]))
                value, *slopes = noise.fixed(KNOBS, point, seed)
                self.assertEqual(value, 0)
                for found, x in zip(slopes, g, strict=True):
                    self.assertLess(abs(found - scale * x), scale * 2**-12)

    def test_without_a_turn_it_is_the_noise_with_another_scale(self) -> None:
        ratios = {"perlin": Fraction(879, 985), "simplex": Fraction(4902, 4918)}
        for (name, ratio), n, with_slopes in itertools.product(ratios.items(), (2, 3), ("", "_d")):
            still, turned = (noises.find(f"{name}{with_slopes}{phase}").exact(KNOBS, POINT[:n], 9)
                             for phase in ("", "_phase"))
            self.assertEqual(turned, tuple(x * (ratio if n == 3 else 1) for x in still))

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
        x, y = gradients.gradient2(h)
        self.assertEqual(lattice.gradient((1, 2)), (-y, x))
