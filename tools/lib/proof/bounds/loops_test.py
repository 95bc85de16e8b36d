"""Tests of sums with slopes over noises of the library: loops over any that fits have the contract's values, and no
noise reaches the end at which derivatives are cut off."""

import itertools
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

from base.tree import GLSL, ROOT
from base.twin import SOON, compile_program
from catalog.tables import glsl
from proof.bounds import jacobians
from proof.bounds.floats import to_float
from proof.bounds.integers import SLOPE_UNIT
from proof.bounds.sums import Sum
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
