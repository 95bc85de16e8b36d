"""Tests of sums with slopes over noises of the library: loops over any that fits have the contract's values, and no
noise reaches the end at which derivatives are cut off."""

import functools
import itertools
import re
import unittest
from unittest import mock

import numpy as np

from base.tree import GLSL, ROOT
from catalog.tables import glsl
from proof.bounds import jacobians
from proof.bounds.rounded import FIXED, NEAREST, Body, Text, along_axes
from proof.bounds.table import bounds_of, read, slope_bounds_of
from proof.oracle import jacobians as oracle
from proof.oracle import noises
from proof.oracle import sums as oracle_sums
from proof.oracle.gradients import Knobs

DIMS = (2, 3)

# Noises that fit a loop with slopes, and their arguments behind the place.
FITTING = {name: "0.375f, " if name.endswith("_phase") else "" for name in jacobians.FITTING}
NO_NOISES = {"hn_fbm_d", "hn_uniform_d"}  # functions that end in _d: a sum, and one of a value
CUTS = {ROOT / "docs" / "reference" / "contract.md": r"`g = trunc\(clamp\(g, -(\d+), (\d+)\) \* 2\^19\)`",
        GLSL / "detail" / "jacobian.glsl": r"min\(max\(-(\d+)\.0f, g\), (\d+)\.0f\) \* HN_I_FLOAT_UNITS_SLOPE"}


def to_float(x):
    return float(np.float32(x))


def steeper(cut):
    """Noises of the library with derivatives; one of them is beyond the cut."""
    return {(of.noise, of.dimensions) for of in read(macro="SLOPE_BOUNDS") if max(of.limit, of.fixed_limit) > cut}


def value_of(name):
    """The row of bounds.inc of the value of a noise with derivatives."""
    return name.replace("_d", "", 1)


class Cut(unittest.TestCase):
    """Derivatives of an octave are cut off at the two ends of a range, which no noise of the library must reach."""

    def test_it_is_the_same_everywhere(self):
        for path, pattern in CUTS.items():
            self.assertEqual(re.findall(pattern, path.read_text()), [(f"{jacobians.SLOPE_LIMIT:g}",) * 2], path)
        self.assertEqual(oracle.LARGEST_SLOPE * jacobians.SLOPE_UNIT, jacobians.SLOPE_LIMIT)

    def test_no_noise_reaches_it(self):
        self.assertEqual(steeper(jacobians.SLOPE_LIMIT), set())
        self.assertGreaterEqual(steeper(4.0), {(name, dims) for name in ("simplex_d", "simplex_d_phase", "phasor_d")
                                               for dims in DIMS})
        self.assertGreaterEqual(steeper(16.0), {("phasor_d", dims) for dims in DIMS})

    def test_nothing_wraps(self):
        """Where the errors are promised; with a gradient that is longer, or that is cut off later, something does."""
        for dims in DIMS:
            self.assertLess(max(jacobians.largest_intermediates(dims).values()), 2**31)
            self.assertLess(max(jacobians.largest_words(dims).values()), 2**32)
        with mock.patch.object(jacobians, "LARGEST_RISE", 4100.0):
            self.assertGreater(jacobians.largest_intermediates(3)["sum of slopes"], 2**31)
        with mock.patch.object(jacobians, "FALL_LIMIT", 16.0):
            self.assertGreater(jacobians.largest_words(3)["squares"], 2**32)

    def test_all_noises_with_derivatives_are_looked_at(self):
        functions = {f"{function.name}" for function in glsl.declarations() if function.name.endswith("_d")}
        known = {f"hn_{of.noise.removesuffix('_phase').removesuffix('_bandwidth')}" for of in read(macro="SLOPE_BOUNDS")}
        self.assertEqual(functions - NO_NOISES, known - {"hn_curl"})

    def test_a_sum_over_any_that_fits_may_grow_as_far_as_one_over_perlin_noise(self):
        for name, dims in itertools.product(FITTING, DIMS):
            noise, slope = bounds_of(value_of(name), dims, "octahedral"), slope_bounds_of(name, dims)
            longest = jacobians.longest_gradient(noise, slope)
            self.assertLess(longest, 10, (name, dims))  # as in the contract
            self.assertLess(jacobians.LARGEST_GROWTH * longest, jacobians.LARGEST_RISE)


def loop(dims, name):
    """The value and the derivatives of hn_fbm_d over a noise; and hn_eroded's value over it."""
    p, noise = f"vec{dims}({', '.join(f'float_of(a.{axis})' for axis in 'xyz'[:dims])})", name.removesuffix("_phase")
    start = (f"hn_octaves{dims} o = hn_octaves(int(b.w) > 0 ? hn_tile({p}, ivec{dims}(int(b.w))) : hn_place({p}), int(b.z), "
             f"float_of(a.w), float_of(b.x), c.x); hn_slopes{dims} s = hn_slopes(o); ")
    of_octave = f"hn_{noise}(o.place, {FITTING[name]}o.seed)"
    ends = {"fbm_d": (f"do hn_add(o, s, {of_octave}); while (hn_next(o)); const vec{dims + 1} n = hn_mean(o, s); ",
                      [f"n.{axis}" for axis in "xyzw"[:dims + 1]]),
            "eroded": (f"do hn_add_eroded(o, s, {of_octave}, float_of(b.y)); while (hn_next(o)); ", ["hn_mean(o)"])}
    for kind, (steps, outputs) in ends.items():
        words = [f"bits_of({output})" for output in outputs] + ["0u"] * (4 - len(outputs))
        yield f"{kind} {dims} {name}", Body.of(
            "x:f32 y:f32 z:f32 lacunarity:f32 gain:f32 strength:f32 octaves:i32 period:i32 seed:u32",
            " ".join(f"n{i}:f32" for i in range(len(outputs))), f"{start}{steps}return uvec4({', '.join(words)});")


# The call that adds one octave, the expression of its value, and its result for a noise of 1.25 and of 2.
AS_IT_IS, NEARER_END = (1.25, 2.0), (1.0, 1.0)
STEPS = {"hn_add(o, n)": ("hn_mean(o)", AS_IT_IS), "hn_add_turbulence(o, -n)": ("hn_mean(o)", AS_IT_IS),
         "hn_add_detail(o, n)": ("hn_mean(o)", AS_IT_IS), "hn_add_footprint(o, n)": ("hn_mean(o)", AS_IT_IS),
         "hn_add(o, s, vec3(n, 1.0f, 1.0f))": ("hn_mean(o, s).x", AS_IT_IS),
         "hn_add_eroded(o, s, vec3(n, 0.0f, 0.0f), 1.0f)": ("hn_mean(o)", AS_IT_IS),
         "hn_add_ridged(o, n)": ("hn_mean(o) + 1.0f", NEARER_END),
         "hn_add_hybrid(o, n)": ("hn_mean(o)", NEARER_END),
         "hn_add_ping_pong(o, n, 0.5f)": ("hn_mean(o)", NEARER_END),
         "hn_add_weighted(o, n, 1.0f)": ("hn_mean(o)", NEARER_END),
         "hn_add(o, w, vec2(n, 0.0f))": ("hn_mean(o, w).x", NEARER_END),
         "hn_add_progressive(o, w, vec2(n, 0.0f))": ("hn_mean(o, w).x", NEARER_END)}


@functools.cache
def text(*macros):
    steps = {step: Body.of("n:f32", "value:f32", (
        "hn_octaves2 o = hn_octaves(vec2(0.5f, 0.5f), 1, 2.0f, 0.5f, 7u); hn_slopes2 s = hn_slopes(o); "
        f"hn_shifts2 w = hn_shifts(o, 1.0f); hn_float n = float_of(a.x); {step}; return uvec4(bits_of({value}), 0u, 0u, 0u);"))
        for step, (value, _) in STEPS.items()}
    loops = [loop(dims, name) for dims, name in itertools.product(DIMS, FITTING)] if macros else []
    return Text([], *macros, **steps, **dict(itertools.chain(*loops)))


class Loops(unittest.TestCase):
    """Loops over noises of the library, with HN_FIXED, against the oracle."""

    @staticmethod
    def answers(name, p, seed, of, period):
        """The value and the derivatives of hn_fbm_d, and the value of hn_eroded."""
        columns = along_axes("", (*p, 0.0)[:3]) | {"seed": seed, "period": period, **{
            option: getattr(of, option) for option in ("lacunarity", "gain", "strength", "octaves")}}
        return [float(n[0]) for kind in ("fbm_d", "eroded")
                for n in text(FIXED)(f"{kind} {len(p)} {name}", NEAREST, **columns)]

    @staticmethod
    def noise(name):
        found = noises.find(name)
        return found.rotated(0.375) if name.endswith("_phase") else found

    def check(self, count, names=tuple(FITTING)):
        rng, steepest = np.random.default_rng(6), 0.0
        for dims, name, _ in itertools.product(DIMS, names, range(count)):
            p = [to_float(x) for x in rng.uniform(-40, 40, dims)]
            options = oracle_sums.Options(int(rng.integers(1, 4)), to_float(rng.uniform(0.5, 3)),
                                          to_float(rng.uniform(0, 1)), to_float(rng.uniform(0, 16)))
            seed, period = int(rng.integers(0, 2**32)), int(rng.choice((0, 5, 8)))
            found = self.answers(name, p, seed, options, period)
            noise, periods = self.noise(name), (period,) * len(p) if period else ()
            arguments = (noise, Knobs("lattice"), oracle_sums.fixed_at_position(p), options, seed, periods)
            expected = (*oracle.fixed("fbm_d", *arguments), *oracle.fixed("eroded", *arguments))
            self.assertEqual(found, [float(x) for x in expected], (name, p, seed, options, period))
            # From a place: the lacunarity that is used is the one that is cut.
            exactly = oracle.exact("fbm_d", noise, Knobs("lattice"), oracle_sums.at_position(p), options, seed, periods)
            slope, lacunarity = slope_bounds_of(name, dims), float(oracle_sums.lacunarity_of(options, periods))
            # A slope's own error, and its cut: an octave has as much as its factor.
            tolerance = 2 * sum((options.gain * lacunarity)**i for i in range(options.octaves)) * (slope.fixed_error + 2**-18 * slope.limit)
            if name.startswith("cellular"):  # its error is divided by the distance of a point, which can be any
                continue
            for a, b in zip(found[1:-1], exactly[1:]):
                self.assertLess(abs(a - b), tolerance, (name, p, seed, options, period))
                steepest = max(steepest, abs(b))
        return steepest

    def test_they_are_those_of_the_contract(self):
        self.assertGreater(self.check(12), 4.0)

    def test_steep_simplex_noise(self):
        """Where dx was cut off to 4."""
        options, place = oracle_sums.Options(1, 2.0, 0.5), (-11.5, 18.5, -17.5)
        steep = noises.find("simplex_d").exact(Knobs("lattice"), place, 7)[1:]
        self.assertGreater(max(map(abs, steep)), 4.5)
        for p, exactly in (((143.5, 71.75), (6.387922, -0.759859)), (place, steep)):
            _, *found, _ = self.answers("simplex_d", p, 7, options, 0)
            for slope, x in zip(found, exactly, strict=True):
                self.assertLess(abs(slope - x), slope_bounds_of("simplex_d", len(p)).fixed_error)

    def test_a_noise_beyond_its_range(self):
        """Counts as the contract and docs/reference/fractals.md state."""
        beyond = np.array(AS_IT_IS)
        for macros, most in (((), np.inf), ((FIXED,), 1.5)):
            for step, (_, expected) in STEPS.items():
                found, = text(*macros)(step, NEAREST, n=beyond)
                self.assertEqual(found.tolist(), [min(number, most) for number in expected], (step, macros))
        contract = (ROOT / "docs" / "reference" / "contract.md").read_text()
        sentence, = re.findall(r"^A noise beyond \[-1, 1\] counts as it is in (.*?);", contract, re.MULTILINE)
        as_it_is = {step.partition("(")[0] for step, (_, numbers) in STEPS.items() if numbers == AS_IT_IS}
        self.assertEqual(set(re.findall(r"`(hn_\w+)`", sentence)), as_it_is)

    def test_a_cut_that_a_noise_reaches_is_noticed(self):
        with mock.patch.object(oracle, "LARGEST_SLOPE", 4 * oracle.SLOPE_UNIT), self.assertRaises(AssertionError):
            self.check(12, ("simplex_d",))
