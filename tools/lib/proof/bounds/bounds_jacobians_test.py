"""Tests of the bounds of octave sums with slopes, and of warps: the library's text stays within the bounds, and reaches
a
part of them. A missing part of a bound, or of a sum, is noticed."""

import functools
import itertools
import math
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from base.thorough import in_thorough_runs
from base.tree import GLSL, ROOT
from base.twin import SOON, compile_program
from catalog.tables import glsl
from proof.bounds import exact_model as exact
from proof.bounds import jacobians, jacobians_model, sums
from proof.bounds.float_sums import octave_tolerance
from proof.bounds.floats import to_float
from proof.bounds.gradients import OCTAHEDRAL
from proof.bounds.integers import SLOPE_UNIT
from proof.bounds.rounded import FIXED, Rounding, Text, along_axes, roundings
from proof.bounds.sums import SHIFTS, SLOPED, Sum
from proof.bounds.table import bounds_of, read, slope_bounds_of
from proof.oracle import jacobians as oracle
from proof.oracle import noises
from proof.oracle import sums as oracle_sums
from proof.oracle.gradients import Knobs

DIMS = (2, 3)
KINDS = SLOPED + SHIFTS


def proven(kind, dims):
    """The bounds of the noise of a sum in bounds.inc, and of its derivatives."""
    noise = "value" if kind in SHIFTS else "perlin"
    return bounds_of(noise, dims, "octahedral"), slope_bounds_of(f"{noise}_d", dims)


def tolerances(s, dims, is_fixed):
    noise, slope = proven(s.kind, dims)
    own = jacobians.TOLERANCES[s.kind][is_fixed](s, noise, slope)
    of_value = (octave_tolerance, sums.fixed_octave_tolerance)[is_fixed]
    if s.kind == "fbm_d":
        return [of_value(s, noise)] + [own] * dims
    return [own] if s.kind == "eroded" else [own] * dims


def random_sum(rng, kind, **others):
    """One within the domain of the bounds."""
    s = Sum(kind, **({"p_max": 2.0 ** rng.integers(0, 6), "octaves": int(rng.integers(1, 8)),
                      "lacunarity": to_float(rng.uniform(0, 3)), "gain": to_float(rng.uniform(0, 1)),
                      "strength": to_float(rng.choice((1.0, 16.0, rng.random()))),
                      "amplitude": to_float(rng.choice((0.25, 64.0, rng.random())))} | others))
    return s if jacobians.is_bounded(s) else random_sum(rng, kind, **others)


@functools.cache
def text(*macros):
    """The calls of the library."""
    return Text((row_of(kind, dims, form) for kind in KINDS for dims in DIMS for form in ("", "_cell", "_cell_period")),
                *macros)


def row_of(kind, dims, form):
    return f"{'warp' if kind in SHIFTS else 'fbm_d'}.{kind}{dims}{form}"


class Errors:
    """The errors of the library's text with these macros."""
    MACROS: tuple[str, ...] = ()
    SIMULATED = roundings(3)

    def computed(self, rounding, s, p):
        """In a tile without a period nothing rotates."""
        places, form = along_axes("", p), ""
        if s.from_cell:
            places, form = along_axes("c", map(np.floor, p)) | along_axes("f", [x - np.floor(x) for x in p]), "_cell"
        if not s.rotates:
            places, form = places | along_axes("p", [0] * len(p)), "_cell_period"
        settings = {"octaves": s.octaves, "lacunarity": s.lacunarity, "gain": s.gain, "seed": 0}
        if s.kind in SHIFTS:
            settings["amplitude"] = s.amplitude
        elif s.kind == "eroded":
            settings["strength"] = s.strength
        return text(*self.MACROS)(row_of(s.kind, len(p), form), rounding, **places, **settings)

    def check(self, kinds=KINDS, count=100, seed=2, simulated=None, arguments=None, **others):
        rng, worst = np.random.default_rng(seed), dict.fromkeys(kinds, 0.0)
        for kind, dims, rounding in itertools.product(kinds, DIMS, simulated or self.SIMULATED):
            s = random_sum(rng, kind, **(arguments(rng) if arguments else {}), **others)
            p = rng.uniform(-s.p_max, s.p_max, (dims, count))
            p = list(np.floor(p) + (p - np.floor(p)).astype(np.float32) if s.from_cell
                     else p.astype(np.float32).astype(float))
            result = self.computed(rounding, s, p)
            for computed, x, tolerance in zip(result, jacobians_model.exact_sum(s, p), tolerances(s, dims, bool(self.MACROS)),
                                              strict=True):
                error = abs(computed - x).max()
                self.assertLess(error, tolerance, (s, dims))
                worst[kind] = max(worst[kind], error / tolerance)
            if kind in SHIFTS:
                self.assertLessEqual(np.abs(result).max(), s.amplitude)
        return worst

    def assert_near(self, worst, least):
        self.assertTrue(all(ratio > least for ratio in worst.values()), worst)


class Floats(Errors, unittest.TestCase):
    """Floats in any rounding mode."""

    @in_thorough_runs
    def test_simulated(self):
        self.assert_near(self.check(), 1 / 60)

    def test_first_octave(self):
        self.assert_near(self.check(octaves=1), 1 / 60)

    @in_thorough_runs
    def test_with_a_period(self):
        self.assert_near(self.check(arguments=lambda rng: {"lacunarity": float(rng.integers(0, 4))}, rotates=False,
                                    from_cell=True), 1 / 100)

    @in_thorough_runs
    def test_from_a_cell(self):
        self.assert_near(self.check(from_cell=True, p_max=2.0**16), 1 / 60)

    def test_fails_with_fewer_bits(self):
        fewer = [Rounding("nearest", lost_bits=10)]
        for kind, rotates in itertools.product(KINDS, (True, False)):
            with self.subTest(kind=kind, rotates=rotates), self.assertRaises(AssertionError):
                self.check((kind,), simulated=fewer, octaves=2, lacunarity=2.0, gain=0.5, strength=1.0, amplitude=0.25,
                           p_max=4.0, rotates=rotates, from_cell=not rotates)

    def test_tiny_results(self):
        """HN_PRECISE replaces them by 0."""
        s = Sum("warp", 1.0, 3, 2.0, 0.5, amplitude=2.0**-98)
        self.assertGreaterEqual(tolerances(s, 2, False)[0], 2.0**-98)

    def test_the_domain(self):
        for arguments in ({"lacunarity": 1e20, "octaves": 6}, {"lacunarity": 2.0, "octaves": 20, "gain": 1e20},
                          {"lacunarity": 256.0, "octaves": 2, "from_cell": True}):
            for kind in KINDS:
                s = Sum(kind, 1.0, **({"gain": 1.0, "strength": 1.0, "amplitude": 1.0} | arguments))
                self.assertEqual(tolerances(s, 2, False)[-1], math.inf)


class Fixed(Errors, unittest.TestCase):
    MACROS = (FIXED,)
    SIMULATED = 6 * [Rounding("nearest")]

    @in_thorough_runs
    def test_simulated(self):
        self.assert_near(self.check(count=2000), 1 / 15)

    def test_first_octave(self):
        self.assert_near(self.check(octaves=1), 1 / 8)

    @in_thorough_runs
    def test_usual_arguments(self):
        """Sums have 6 octaves, as in the tables. The worst case of a progressive warp is rare."""
        for kind, least, others in (("fbm_d", 1 / 12, {}), ("eroded", 1 / 20, {"strength": 1.0}),
                                    ("warp", 1 / 8, {"amplitude": 0.5}),
                                    ("warp_progressive", 1 / 30, {"amplitude": 0.25}),
                                    ("warp_progressive", 1 / 150, {"amplitude": 0.5})):
            usual = self.check(kinds=(kind,), octaves=6, lacunarity=2.0, gain=0.5, p_max=16.0, count=4000, **others)
            self.assert_near(usual, least)

    def test_with_a_period(self):
        self.assert_near(self.check(arguments=lambda rng: {"lacunarity": float(rng.integers(0, 4))}, rotates=False,
                                    from_cell=True), 1 / 20)

    def test_from_a_cell(self):
        self.assert_near(self.check(from_cell=True), 1 / 15)

    @in_thorough_runs
    def test_at_the_ends_of_the_domain(self):
        """Results of 8 and more, which lose bits, and Jacobians and steps that are as large as they may be."""
        for gain, lacunarity, octaves in ((1.0, 1.0, 32), (1.0, 4.0, 3), (0.25, 252.0, 2), (0.75, 1.25, 20)):
            self.check(octaves=octaves, gain=gain, lacunarity=lacunarity, amplitude=64.0 / max(1, gain * lacunarity),
                       p_max=4.0)
        self.check(kinds=("warp",), amplitude=64.0)

    def test_without_octaves(self):
        for kind, octaves in itertools.product(KINDS, (0, -1)):
            s = Sum(kind, 1.0, octaves, 2.0, 0.5, 1.0, 1.0)
            for is_fixed in (False, True):
                self.assertEqual(tolerances(s, 2, is_fixed), [0.0] * len(tolerances(s, 2, is_fixed)))
            result = self.computed(Rounding("nearest"), s, [np.array([0.3]), np.array([0.4])])
            self.assertEqual([float(x[0]) for x in result], [0.0] * len(result))

    def test_the_domain(self):
        def bounded(kind, *arguments, **others):
            return jacobians.is_bounded(Sum(kind, 1.0, *arguments, **others))
        self.assertTrue(bounded("fbm_d", 6, 2.0, 1.0) and not bounded("fbm_d", 7, 2.0, 1.0))
        self.assertTrue(bounded("fbm_d", 2, 63.0, 1.0) and not bounded("fbm_d", 2, 64.0, 1.0))
        self.assertTrue(bounded("warp_progressive", 6, 2.0, 1.0, amplitude=8.0))
        self.assertFalse(bounded("warp_progressive", 6, 2.0, 1.0, amplitude=8.1))
        self.assertTrue(bounded("warp", 6, 2.0, 1.0, amplitude=64.0))
        for arguments in ((33, 1.0, 0.5), (2, -1.0, 0.5), (2, 256.0, 0.1), (2, 2.0, 1.5)):
            for kind in KINDS:
                self.assertEqual(tolerances(Sum(kind, 1.0, *arguments, 1.0, 1.0), 2, True)[-1], math.inf)

    def must_fail(self, name, replacement, kinds, **others):
        with mock.patch.object(jacobians, name, replacement), self.assertRaises(AssertionError):
            self.check(kinds, **others)

    def test_what_is_left_out_is_noticed(self):
        self.must_fail("fixed_effects", lambda s, *_: [0.0] * s.count, ("fbm_d",))
        self.must_fail("fixed_fall_errors", lambda s, *_: [0.0] * s.count, ("eroded",), strength=16.0)
        self.must_fail("fixed_shift_effects", lambda s, *_: [0.0] * s.count, ("warp_progressive",))

    def test_other_sums_are_noticed(self):
        """Must-fail checks: exact sums with a fault, as one of the library would be."""
        times, words_of_components = jacobians_model.times, jacobians_model.words_of_components
        for module, name, fault, kinds in (
                (jacobians_model, "times", lambda matrix, vector: times(np.array(matrix).T, vector),
                 ("fbm_d", "warp_progressive")),
                (jacobians_model, "words_of_components", lambda cells, seed: words_of_components(cells, seed)[:1] * len(cells),
                 ("warp",)),
                (exact, "rotate", list, ("eroded",))):
            for kind in kinds:
                with mock.patch.object(module, name, fault), self.assertRaises(AssertionError):
                    self.check((kind,), octaves=4, lacunarity=2.0, gain=0.5, strength=1.0, amplitude=1.0)


class Steps(unittest.TestCase):
    def test_the_longest_gradient(self):
        """Random ones, and those that are sought near the steepest place, the middle of a cell."""
        rng = np.random.default_rng(4)
        for dims in DIMS:
            f = 0.5 + rng.uniform(-0.5, 0.5, (dims, 200_000)) * rng.random(200_000)
            words = rng.integers(0, 2**32, (2**dims, 200_000))
            of_corner = dict(zip(itertools.product((0, 1), repeat=dims), words))
            for kind, found in (("fbm_d", exact.perlin(OCTAHEDRAL, of_corner.__getitem__, list(f))),
                                ("warp", exact.value(of_corner.__getitem__, list(f)))):
                seen, bound = np.linalg.norm(found[1], axis=0).max(), jacobians.longest_gradient(*proven(kind, dims))
                self.assertTrue(bound / 2.5 < seen < bound, (dims, kind, seen, bound))

    def test_the_steepest_fall(self):
        r = np.linspace(0, 14, 140_001)
        for strength, reach in itertools.product((0.0, 0.001, 0.3, 1.0, 16.0), (0.1, 1.0, 13.9)):
            inside = r[r <= reach]
            fall = 1 / (1 + strength * inside**2)
            seen, bound = abs(np.diff(fall)).max() / r[1], jacobians.steepest_fall(strength, reach)
            self.assertTrue(0.99 * bound <= seen <= bound * (1 + 1e-9), (strength, reach, seen, bound))
        self.assertAlmostEqual(jacobians.steepest_fall(1.0, 9.0), 0.6495, delta=1e-4)

    def test_jacobians(self):
        """The integers of the bounds are near the exact numbers."""
        rng = np.random.default_rng(5)
        for dims, rotates in itertools.product(DIMS, (True, False)):
            s = random_sum(rng, "fbm_d", octaves=7, rotates=rotates)
            for rounded, exactly in jacobians.jacobians(s, dims):
                self.assertLess(abs(rounded - exactly).max(), 1e-3)

    def test_nothing_wraps(self):
        for dims in DIMS:
            for name, value in jacobians.largest_intermediates(dims).items():
                self.assertLess(value, 2**31, (dims, name))
            for name, value in jacobians.largest_words(dims).items():
                self.assertLess(value, 2**32, (dims, name))
        for limit, factor in (("LARGEST_GROWTH", 8), ("LARGEST_SHIFT", 8), ("LARGEST_RISE", 1.01)):
            with mock.patch.object(jacobians, limit, factor * getattr(jacobians, limit)):
                self.assertGreater(max(jacobians.largest_intermediates(3).values()), 2**31)


# Noises that fit a loop with slopes, and their arguments behind the place.
FITTING = {name: "0.375f, " if name.endswith("_phase") else "" for name in jacobians.FITTING}
NO_NOISES = {"hn_fbm_d", "hn_uniform_d"}  # functions that end in _d: a sum, and one of a value
CUTS = {ROOT / "docs" / "reference" / "contract.md": r"`g = trunc\(clamp\(g, -(\d+), (\d+)\) \* 2\^19\)`",
        GLSL / "detail" / "jacobian.glsl": r"min\(max\(-(\d+)\.0f, g\), (\d+)\.0f\) \* HN_I_FLOAT_UNITS_SLOPE"}


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
        self.assertEqual(oracle.LARGEST_SLOPE * SLOPE_UNIT, jacobians.SLOPE_LIMIT)

    def test_no_noise_reaches_it(self):
        self.assertEqual(steeper(jacobians.SLOPE_LIMIT), set())
        self.assertGreaterEqual(steeper(4.0), {(name, dims) for name in ("simplex_d", "simplex_d_phase", "phasor_d")
                                               for dims in DIMS})
        self.assertGreaterEqual(steeper(16.0), {("phasor_d", dims) for dims in DIMS})

    def test_all_noises_with_derivatives_are_looked_at(self):
        functions = {f"{function.name}" for function in glsl.declarations() if function.name.endswith("_d")}
        known = {f"hn_{of.noise.removesuffix('_phase')}" for of in read(macro="SLOPE_BOUNDS")}
        self.assertEqual(functions - NO_NOISES, known - {"hn_curl"})

    def test_a_sum_over_any_that_fits_may_grow_as_far_as_one_over_perlin_noise(self):
        for name, dims in itertools.product(FITTING, DIMS):
            noise, slope = bounds_of(value_of(name), dims, "octahedral"), slope_bounds_of(name, dims)
            longest = jacobians.longest_gradient(noise, slope)
            self.assertLess(longest, 10, (name, dims))  # as in the contract
            self.assertLess(jacobians.LARGEST_GROWTH * longest, jacobians.LARGEST_RISE)

    def test_beyond_it_there_is_no_bound(self):
        noise, slope = bounds_of("phasor_d", 2, "none"), slope_bounds_of("phasor_d", 2)
        steep = jacobians.longest_gradient(noise, slope)
        self.assertLess(jacobians.fixed_slope_tolerance(Sum("fbm_d", 1.0, 4, 2.0, 0.5), noise, slope), 2.0)
        self.assertTrue(4000 / 64 < steep < 4000 / 16)
        self.assertEqual(jacobians.fixed_slope_tolerance(Sum("fbm_d", 1.0, 32, 2.0, 0.5), noise, slope), math.inf)
        with mock.patch.object(jacobians, "SLOPE_LIMIT", 100.0):
            self.assertEqual(jacobians.fixed_slope_tolerance(Sum("fbm_d", 1.0, 4, 2.0, 0.5), noise, slope), math.inf)


class Loops(unittest.TestCase):
    """Loops over noises of the library, with HN_FIXED as C++, against the oracle and the bounds."""

    STEEP = (-11.5, 18.5, -17.5)

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.own = cls.program("own")

    @classmethod
    def program(cls, name, include=ROOT / "include", noises_of=tuple(FITTING)):
        """It answers lines of a number of dimensions, a noise, a seed, octaves, lacunarity, gain, strength, a period
        and a position with the value and the derivatives of hn_fbm_d, and the value of hn_eroded."""
        cases = []
        for dims, of in itertools.product(DIMS, noises_of):
            p, noise = f"vec{dims}(p.x, p.y{', p.z' * (dims - 2)})", of.removesuffix("_phase")
            cases.append(f"""
  if (dims == {dims} && noise == {list(FITTING).index(of)}) {{
    hn_octaves{dims} o = hn_octaves(period > 0 ? hn_tile({p}, ivec{dims}(period)) : hn_place({p}), octaves, lacunarity,
                                    gain, seed);
    hn_octaves{dims} e = o;
    hn_slopes{dims} s = hn_slopes(o);
    hn_slopes{dims} fall = s;
    do hn_add(o, s, hn_{noise}(o.place, {FITTING[of]}o.seed)); while (hn_next(o));
    do hn_add_eroded(e, fall, hn_{noise}(e.place, {FITTING[of]}e.seed), strength); while (hn_next(e));
    const vec{dims + 1} n = hn_mean(o, s);
    std::printf("{'%.17g ' * (dims + 2)}\\n", n.x, n.y, n.z, {"n.w, " * (dims - 2)}hn_mean(e));
  }}""")
        source = cls.folder / f"{name}.cpp"
        source.write_text(f"""#define HN_ARITHMETIC HN_FIXED
#include <cstdio>
#include <hashnoise/hashnoise.hpp>
using namespace hashnoise;
void answer(int dims, int noise, unsigned seed, int octaves, float lacunarity, float gain, float strength, int period,
            vec3 p) {{{''.join(cases)}
}}
int main() {{
  int dims, noise, octaves, period;
  unsigned seed;
  float lacunarity, gain, strength;
  vec3 p;
  while (std::scanf("%d %d %u %d %f %f %f %d %f %f %f", &dims, &noise, &seed, &octaves, &lacunarity, &gain, &strength,
                    &period, &p.x, &p.y, &p.z) == 11)
    answer(dims, noise, seed, octaves, lacunarity, gain, strength, period, p);
}}
""")
        compile_program("loops over noises", source, cls.folder / name, SOON, include=include)
        return cls.folder / name

    @staticmethod
    def answers(program, rows):
        """A row has the name of a noise, a position, a seed, the options of a sum, and a period or 0."""
        lines = "".join(f"{len(p)} {list(FITTING).index(name)} {seed} {of.octaves} {of.lacunarity!r} {of.gain!r} "
                        f"{of.strength!r} {period} {' '.join(map(repr, (*p, 0.0)[:3]))}\n"
                        for name, p, seed, of, period in rows)
        done = subprocess.run([program], input=lines, capture_output=True, text=True, check=True)
        return [list(map(float, line.split())) for line in done.stdout.splitlines()]

    @staticmethod
    def noise(name):
        found = noises.find(name)
        return found.rotated(0.375) if name.endswith("_phase") else found

    def check(self, program, count, names=tuple(FITTING)):
        rng, rows = np.random.default_rng(6), []
        for dims, name, _ in itertools.product(DIMS, names, range(count)):
            p = [to_float(x) for x in rng.uniform(-40, 40, dims)]
            options = oracle_sums.Options(int(rng.integers(1, 4)), to_float(rng.uniform(0.5, 3)),
                                          to_float(rng.uniform(0, 1)), to_float(rng.uniform(0, 16)))
            rows.append((name, p, int(rng.integers(0, 2**32)), options, int(rng.choice((0, 5, 8)))))
        steepest = 0.0
        for (name, p, seed, options, period), found in zip(rows, self.answers(program, rows), strict=True):
            dims, noise, periods = len(p), self.noise(name), (period,) * len(p) if period else ()
            arguments = (noise, Knobs("lattice"), oracle_sums.fixed_at_position(p), options, seed, periods)
            expected = (*oracle.fixed("fbm_d", *arguments), *oracle.fixed("eroded", *arguments))
            self.assertEqual(found, [float(x) for x in expected], (name, p, seed, options, period))
            # From a place: the lacunarity that is used is the one that is cut.
            exactly = oracle.exact("fbm_d", noise, Knobs("lattice"), oracle_sums.at_position(p), options, seed, periods)
            s = Sum("fbm_d", 40.0, options.octaves, float(oracle_sums.lacunarity_of(options, periods)), options.gain,
                    rotates=not period)
            tolerance = jacobians.fixed_slope_tolerance(s, bounds_of(value_of(name), dims, "octahedral"),
                                                     slope_bounds_of(name, dims))
            for a, b in zip(found[1:-1], exactly[1:]):
                self.assertLess(abs(a - b), tolerance, (name, p, seed, options, period))
                steepest = max(steepest, abs(b))
        return steepest

    def test_they_are_those_of_the_contract(self):
        self.assertGreater(self.check(self.own, 12), 4.0)

    def test_steep_simplex_noise(self):
        """Where dx was cut off to 4."""
        options = oracle_sums.Options(1, 2.0, 0.5)
        (_, dx, dy, _), (_, *steep, _) = self.answers(self.own, [
            ("simplex_d", [143.5, 71.75], 7, options, 0), ("simplex_d", self.STEEP, 7, options, 0)])
        for found, exactly in ((dx, 6.387922), (dy, -0.759859)):
            self.assertLess(abs(found - exactly), slope_bounds_of("simplex_d", 2).fixed_error)
        exactly = noises.find("simplex_d").exact(Knobs("lattice"), self.STEEP, 7)[1:]
        self.assertGreater(max(map(abs, exactly)), 4.5)
        for found, x in zip(steep, exactly, strict=True):
            self.assertLess(abs(found - x), slope_bounds_of("simplex_d", 3).fixed_error)

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

    def beyond(self, arithmetic):
        """The result of the octave for both noises, by the step."""
        lines = "".join(f"""  for (float n : {{1.25f, 2.0f}}) {{
    hn_octaves2 o = hn_octaves(vec2(0.5f, 0.5f), 1, 2.0f, 0.5f, 7u);
    [[maybe_unused]] hn_slopes2 s = hn_slopes(o);
    [[maybe_unused]] hn_shifts2 w = hn_shifts(o, 1.0f);
    {step};
    std::printf("%.9g ", {value});
  }}
""" for step, (value, _) in self.STEPS.items())
        source = self.folder / f"{arithmetic}.cpp"
        source.write_text("#include <cstdio>\n#include <initializer_list>\n#include <hashnoise/hashnoise.hpp>\n"
                          f"using namespace hashnoise;\nint main() {{\n{lines}}}\n")
        program = source.with_suffix("")
        compile_program("steps of loops", source, program, SOON, macros=(f"HN_ARITHMETIC={arithmetic}",))
        numbers = list(map(float, subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()))
        return dict(zip(self.STEPS, zip(numbers[::2], numbers[1::2]), strict=True))

    def test_a_noise_beyond_its_range(self):
        """Counts as the contract and docs/reference/fractals.md state."""
        expected = {step: numbers for step, (_, numbers) in self.STEPS.items()}
        self.assertEqual(self.beyond("HN_FAST"), expected)
        self.assertEqual(self.beyond("HN_FIXED"), {step: tuple(min(number, 1.5) for number in numbers)
                                                   for step, numbers in expected.items()})
        text = (ROOT / "docs" / "reference" / "contract.md").read_text()
        sentence, = re.findall(r"^A noise beyond \[-1, 1\] counts as it is in (.*?);", text, re.MULTILINE)
        as_it_is = {step.partition("(")[0] for step, numbers in expected.items() if numbers == self.AS_IT_IS}
        self.assertEqual(set(re.findall(r"`(hn_\w+)`", sentence)), as_it_is)

    def test_a_cut_that_a_noise_reaches_is_noticed(self):
        library = self.folder / "library"
        for part in ("include", "glsl"):
            (library / part).parent.mkdir(exist_ok=True)
            shutil.copytree(ROOT / part, library / part)
        jacobian = library / "glsl" / "hashnoise" / "detail" / "jacobian.glsl"
        jacobian.write_text(jacobian.read_text().replace("128.0f", "4.0f"))
        with self.assertRaises(AssertionError):
            self.check(self.program("cut", library / "include", ("simplex_d",)), 12, ("simplex_d",))
