"""Tests of the proofs for the steps of fixed arithmetic, and that nothing wraps: the integers of the proofs are
those of the library's text."""

import functools
import math
import re
import unittest
from unittest import mock

import numpy as np

from base.thorough import THOROUGH
from proof.bounds import command, integers, noises, rotations, sine
from proof.bounds.boxes import Boxes, corners, fade, fade_derivative
from proof.bounds.engine_test import mistaken
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.noises import perlin
from proof.bounds.prover import ENGINE, Job, Prover
from proof.bounds.rounded import EXACT, FIXED, SINES, Body, Rounding, along_axes, table
from proof.bounds.rounded import Text as RoundedText
from proof.bounds.text import cases, provers_of, usual_lines

ONE = 2**20  # of fractions
# Steps of the library, by their arguments.
STEPS = {"fade": "hn_i_fade(int(a.x))", "slope": "hn_i_d_fade(int(a.x))", "sine": "hn_i_sine(a.x)",
         "lerp": "hn_i_lerp(int(a.x), int(a.y), int(a.z))"}


@functools.cache
def text():
    return RoundedText([], FIXED, SINES, optimized=True, **{
        name: Body.of("x:u32 y:u32 z:u32", "n:i32", f"return uvec4(uint({step}), 0u, 0u, 0u);")
        for name, step in STEPS.items()})


def step(name, x, y=0, z=0):
    found, = text().words(name, Rounding("nearest"), x=x, y=y, z=z)
    return found.view(np.int32).astype(np.int64)


def changes(fractions):
    """From a corner to what the errors of the fades and of the first slope change its weight by, and the derivative of
    its weight along the first axis."""
    f = [x / ONE for x in fractions]
    t, slope = [integers.fades()[x] / 2**18 for x in fractions], integers.slopes()[fractions[0]] / 2**18

    def of_corner(corner):
        def weight(fades):
            return [x if o else 1 - x for x, o in zip(fades, corner)]
        off, exactly = weight(t), weight([fade(x) for x in f])
        sign = 2 * corner[0] - 1
        return (math.prod(off) - math.prod(exactly),
                sign * (slope * math.prod(off[1:]) - fade_derivative(1, f[0]) * math.prod(exactly[1:])))
    return of_corner


class Integers(unittest.TestCase):
    def test_fade_and_slope(self):
        f = np.arange(ONE + 1, dtype=np.int64)
        self.assertTrue(np.array_equal(step("fade", f), integers.fades()))
        self.assertTrue(np.array_equal(step("slope", f), integers.slopes()))
        self.assertEqual([integers.fades()[i] for i in (0, 2**19, ONE)], [0, 2**17 - 4, 2**18])
        self.assertEqual([integers.slopes()[i] for i in (0, ONE)], [0, 0])

    def test_halves_are_mirrored(self):
        """Half of the cell is enough for FADE."""
        errors = np.delete(integers.fade_errors() + integers.fade_errors()[::-1], ONE // 2)
        self.assertLess(abs(errors).max(), 1e-15)
        self.assertTrue(np.array_equal(integers.slopes(), integers.slopes()[::-1]))

    def test_lerp_roundings(self):
        rng = np.random.default_rng(7)
        a, b = rng.integers(-2**29, 2**29, (2, 300_000))
        f = rng.integers(0, ONE + 1, 300_000)
        t = integers.fades()[f]
        error = a + (b - a) * t / 2**18 - step("lerp", a, b, t)
        allowed = integers.lerp_roundings()[f]
        self.assertTrue((error <= allowed + 1e-6).all() and (error >= -1e-6 - (t < 0) * allowed).all())
        self.assertGreater((error / np.maximum(allowed, 1)).max(), 0.95)

    def test_effects_hold_in_boxes(self):
        """FADE of random fractions with their errors, against the bounds of the boxes that they are in."""
        rng = np.random.default_rng(11)
        for dims, level in ((1, 6), (2, 5), (3, 4), (4, 4)):
            fractions = rng.integers(0, ONE // 2 + 1, (dims, 2000))
            boxes = Boxes(level, np.minimum(fractions >> (20 - level), 2 ** (level - 1) - 1))
            change = changes(list(fractions))
            offsets = {corner: fractions / ONE - np.array(corner)[:, None] for corner in corners(dims)}
            first = np.eye(dims)[0][:, None]
            slope = sum(OCTAHEDRAL.support(change(corner)[1] * d + change(corner)[0] * first)
                        for corner, d in offsets.items())
            bound = integers.slope_fade_effect(boxes, OCTAHEDRAL)
            self.assertLess((slope - bound).max(), 0)
            self.assertGreater((slope / bound).max(), 0.3)
            self.assertLess(slope.max(), integers.largest_slope_fade_effect(dims, OCTAHEDRAL))

    def test_nothing_wraps(self):
        """By default of two noises: docs/measured/accuracy.md quotes the largest of all noises, which tools/make bounds
        --check compares."""
        for key in command.keys() if THOROUGH else [("perlin_d_phase", 3, OCTAHEDRAL), ("cellular", 3, None)]:
            for name, value in noises.find(key[0]).largest_intermediates(*key[1:]).items():
                self.assertLess(value, 2**31, (key, name))
        largest = perlin.largest_slope_intermediates(3, 4.0)
        self.assertGreater(largest["derivative's lerp"], 0.9 * 2**31)  # not absurdly far

    def test_wrapping_is_noticed(self):
        with self.assertRaises(OverflowError):
            integers.signed(np.array([2**31]))
        with self.assertRaises(OverflowError):
            integers.word(np.array([-1]))
        with mock.patch.dict(integers.RAMP_ONE, {4: 2**30}):
            self.assertGreater(perlin.largest_slope_intermediates(4, 4.0)["derivative's difference"], 2**31)

    def test_differences_reach_their_bound(self):
        """Ramps in space, and their interpolation along x, at places that are whole along z."""
        rng = np.random.default_rng(13)
        x, y = rng.random((2, 100_000))
        x[0], y[0] = 0.5, 0.0
        ones = np.ones(len(x))

        def both(a):
            return OCTAHEDRAL.support([a, y, ones]) + OCTAHEDRAL.support([a, 1 - y, ones])
        seen, bound = 15 / 8 * (both(x) + both(1 - x)) + 2, perlin.LARGEST_DERIVATIVES_DIFFERENCE[3]
        self.assertTrue(0.99 * bound < seen.max() <= bound + 1e-12, (seen.max(), bound))

    def test_sine(self):
        w = np.random.default_rng(8).integers(0, 2**32, 1_000_000)
        value = step("sine", w) / 2**16
        error = abs(value - np.sin(w.astype(np.int32).astype(np.float32).astype(float))).max()
        self.assertTrue(0.9 * sine.fixed_sine_error() < error < sine.fixed_sine_error())
        self.assertLessEqual(abs(value).max(), sine.fixed_sine_largest())


OF_SIXTHS = 2**17 * (2 / 3**0.5 - 1)
# Texts of fractions f and g, a phase, a word h and its highest bits k, in units of values, and what the prover must find.
UNIT = 2.0**-21
PLANTED = {
    "rounds": ("f >> 1", 0.5), "rounds to nearest": ("(f + 2) >> 2", 0.5),
    "is exact": ("(f * 8) >> 3", 0.0), "is beyond an int": ("(f * 4096) >> 12", math.inf),
    "falls below a uint": ("int((uint(f) - 8u) >> 3u)", math.inf),
    "is a square beyond a uint": ("int((uint(f) * uint(f)) >> 20u)", math.inf),
    # Steps of several places.
    "rounds a sum": ("(f + g) >> 4", 15 / 16), "rounds a sum to nearest": ("(f + g + 8) >> 4", 0.5),
    "saturates": ("int(min(uint(f + g + 4) >> 3u, 262143u))", 1.375),
    "a least one": ("int(min(uint(f + g) >> 1u, 900000u))", 0.5),
    "a square": ("int(hn_i_square(f, g) >> 10u)", 1.0), "a whole part": ("hn_i_floor(f + g) * 8 + hn_i_fract(f + g)", 0.0),
    "a constant of sixths": ("((hn_i_rotation(phase).x >> 2) * 20277) >> 15",
                             1 + 2 * (20277 - OF_SIXTHS) + 2 * OF_SIXTHS * (sine.fixed_sine_error() + rotations.ANGLE_CUT)),
    # Steps of a phase and of words.
    "a turn": ("hn_i_rotation(phase).x", 2**18 * (sine.fixed_sine_error() + rotations.ANGLE_CUT)),
    "a product by low bits": ("(k >> 2) * f + (((k & 3) * f) >> 2)", 0.75),
    "a product by others": ("(k >> 2) * f + (((k & 3) * f) >> 1)", math.inf),
    "a turn of a hash": ("(k * (hn_i_rotation(phase).x >> 2)) >> 4",
                         15 / 16 + 15 * 2**12 * (sine.fixed_sine_error() + rotations.ANGLE_CUT)),
    "a sine of a hash": ("hn_i_whole_wave(h, 0u)", 2**16 * sine.fixed_sine_error()),
}
MISTAKES = (
    ("counts.hpp", "constant(half), -1)", "constant(0), -1)"),
    ("counts.hpp", "add_error(g, {half + std::ldexp(1.0, x.grid - k) - 1, half})", "add_error(g, {half - 0.5, half})"),
    ("counts.hpp", "f.terms.push_back({symbol(kError, {-1, 0}), {1, 1}});", ""),
    ("counts.hpp", "add_error(f, point(computed) - exact);", ""),
    ("counts.hpp", "if (x.range.hi <= most) return a;", "if (x.range.lo <= most) return a;"),
    ("counts.hpp", "g.shift != y.shift ||", ""),
    ("stated.hpp", "shifted(Float::of(sum), 10)", "shifted(Float::of(sum), 9)"),
    ("stated.hpp", "kOne * (PROVER_FIXED_SINE + kTurn * 0x1p-30)", "kOne * PROVER_FIXED_SINE / 2"),
    ("tables.hpp", "constant == 20277 ? about(kOfSixths) : ", ""),
    ("linear.hpp", "sum = sum + point(d * e.lo);", ""),
)


BODIES = {name: Body.of(
    "f:f32 g:f32 phase:f32 h:u32", "n:f64", "hn_int f = hn_i_to_num(float_of(a.x)), g = hn_i_to_num(float_of(a.y)); "
    f"float phase = float_of(a.z); uint h = a.w; hn_int k = int(h >> 28u); return uvec4(bits_of(hn_i_value({code})), 0u, 0u, 0u);")
    for name, (code, _) in PLANTED.items()}


def wrong_planted(prover: Prover) -> list[str]:
    jobs = [Job(name, ("n",), {column: "float:0.0" for column in ("f", "g", "phase") if not re.search(rf"\b{column}\b", code)}, most=40)
            for name, (code, _) in PLANTED.items()]
    return [f"{name}: {proven}" for (name, (_, right)), proven in zip(PLANTED.items(), prover.prove(jobs))
            if not 0.97 * right * UNIT <= proven.bound <= 1.01 * right * UNIT]


class FixedText(unittest.TestCase):
    """The prover runs the text of HN_FIXED."""
    def test_planted_steps(self):
        """And another bound of one of them is noticed."""
        prover = Prover(BODIES, FIXED)
        self.assertEqual([], wrong_planted(prover))
        for right in (0.49, 0.53):
            with mock.patch.dict(PLANTED, {"rounds": ("f >> 1", right)}):
                self.assertRegex("\n".join(wrong_planted(prover)), "^rounds: .*$")

    def test_mistakes(self):
        """The same steps notice a mistake that is planted in the engine."""
        for file, old, _ in MISTAKES:
            self.assertEqual(1, (ENGINE / file).read_text(encoding="utf-8").count(old), f"{file}: {old}")
        for mistake in MISTAKES if THOROUGH else ():  # engine_test has one of each run
            with self.subTest(mistake), mistaken(*mistake):
                self.assertNotEqual([], wrong_planted(Prover(BODIES, FIXED, options=("-O0",))))

    def test_no_run_leaves_a_box(self):
        rng, id = np.random.default_rng(21), "noise2d.perlin_d_cell"
        prover, fixed, exact = provers_of(cases(usual_lines()))[FIXED,], RoundedText([id], FIXED), RoundedText([id])
        outputs = [column.name for column in table()[id].outputs]
        for _ in range(6):
            lo = rng.integers(0, 15, 2) / 16
            # 1/2 belongs to the lower half.
            ends = {f"f{axis}": f"box:{x + 2.0**-20}:{x + 1 / 16}" for axis, x in zip("xy", lo)}
            point = rng.integers(1, 2**16 + 1, (2, 3000)) / 2**20 + lo[:, None]
            columns = along_axes("c", rng.integers(-2**31, 2**31, (2, 3000))) | along_axes("f", point) | {
                "seed": rng.integers(0, 2**32, 3000)}
            runs, right = fixed(id, Rounding("nearest"), **columns), exact(id, EXACT, **columns)
            for output, run, truth in zip(outputs, runs, right):
                proven, = prover.prove([Job(id, (output,), ends, most=1)])
                self.assertTrue(0.3 * proven.bound < abs(run - truth).max() <= proven.bound, (output, ends))
