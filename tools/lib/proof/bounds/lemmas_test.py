"""Tests of conformance/sums: the text is as near to the number of each lemma as that promises, roundings are counted, and
mistakes that somebody plants in the numbers are found."""

import functools
import itertools
import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from base.thorough import in_thorough_runs
from proof.bounds import answers, own
from proof.bounds.answers import Sums
from proof.bounds.rounded import EXACT, FIXED, NEAREST, Body, Text, along_axes, roundings
from proof.bounds.table import bounds_of

COUNT = 20_000
ONE = 2.0**18  # of weights
# A step of integers, the ends of its arguments, and the number that it rounds. Arguments are near the ends, too.
STEPS = {
    "hn_i_weight_times(int(a.x), int(a.y))": (((0, 2**18),) * 2, lambda a, b: a * b / ONE),
    "hn_i_summed(int(a.x), int(a.y), int(a.z))": (((-2**26, 2**26), (-2**21, 2**21), (0, 2**18)), lambda s, n, w: s + n * w / ONE),
    "hn_i_mean(int(a.x), int(a.y))": (((-2**26, 2**26), (2**18, 2**23)), lambda s, total: s * ONE / total),
    "hn_i_density(int(a.x))": (((-2**21, 2**21),), lambda mean: smoothstep(np.clip(2 * mean / 2**21 + 0.25, 0, 1)) * 2**21),
    "hn_i_folds(int(a.x), int(a.y))": (((-2**21, 2**21), (0, 2**24)),
                                       lambda n, strength: wave((n / 2**21 + 1) * strength / ONE) * 2**21),
    "hn_i_wide_times(int(a.x), int(a.y))": (((-2**24, 2**24), (-2**23, 2**23)), lambda a, b: a * b / ONE),
    "hn_i_rotated_by(int(a.x), int(a.y), 25, -20)": (((-2**25, 2**25),) * 2, lambda a, b: (25 * a - 20 * b) / 32),
    "hn_i_coarse(int(a.x))": (((-2**27, 2**27),), lambda n: n),
    "hn_i_magnitude(int(a.x))": (((-2**30, 2**30),), abs)}


def smoothstep(t):
    return t * t * (3 - 2 * t)


def wave(t):
    folded = t - 2 * np.floor(t / 2)
    return 2 * np.minimum(folded, 2 - folded) - 1


def body(step):
    """The result in halves, since a float may not hold it."""
    return Body.of("a:i32 b:i32 c:i32", "high:f32 low:f32",
                   f"hn_int n = {step}; return uvec4(bits_of(hn_i_float(n >> 12)), bits_of(hn_i_float(n - ((n >> 12) << 12))), 0u, 0u);")


def of_number(step):
    """The error alone."""
    return Body.of("a:i32 b:i32 c:i32", "n:f32", f"hn_int n = {step}; return uvec4(uint(n), 0u, 0u, 0u);")


class Lemmas(unittest.TestCase):
    @staticmethod
    @functools.cache
    def text():
        return Text([], FIXED, **{step: body(step) for step in STEPS})

    def ratio(self, step, sums):
        """The ratio of the largest error that is seen to the proven one."""
        rng, (ends, exact) = np.random.default_rng(1), STEPS[step]
        some = [np.where(rng.random(COUNT) < 0.9, rng.integers(lo, hi + 1, COUNT), rng.choice((lo, hi, hi - 1, lo + 1), COUNT))
                for lo, hi in ends]
        high, low = self.text()(step, NEAREST, **dict(itertools.zip_longest("abc", some, fillvalue=0)))
        seen = abs(high * 2**12 + low - exact(*(column.astype(float) for column in some))).max()
        proven, = sums.errors(step, dict(itertools.zip_longest("abc", (f"int:{lo}:{hi}" for lo, hi in ends), fillvalue="word:0")))
        return seen / proven if proven else float(seen > 0) * np.inf if seen else 1.0

    def test_steps_round_as_their_lemmas_promise(self):
        sums = Sums(FIXED, bodies={step: of_number(step) for step in STEPS})
        for step in STEPS:
            with self.subTest(step):
                self.assertTrue(1 / 3 <= (ratio := self.ratio(step, sums)) <= 1, ratio)


# Three octaves of exact noises, so that only the roundings of steps and means are left.
OCTAVES = {"fbm": ("hn_add(o, {})", "hn_mean(o)"), "turbulence": ("hn_add_turbulence(o, {})", "hn_mean(o)"),
           "ridged": ("hn_add_ridged(o, {})", "hn_mean(o)"), "hybrid": ("hn_add_hybrid(o, {})", "hn_mean(o)"),
           "ping_pong": ("hn_add_ping_pong(o, {}, 2.0f)", "hn_mean(o)"), "clouds": ("hn_add(o, {})", "hn_density(o)"),
           "weighted": ("hn_add_weighted(o, {}, 1.0f)", "hn_mean(o)")}


def of_octaves(add, end):
    steps = " hn_next(o); ".join(f"{add.format(f'float_of(a.{axis})')};" for axis in "xyz")
    return Body.of("x:f32 y:f32 z:f32", "value:f32", "hn_octaves2 o = hn_octaves(vec2(0.5f, 0.5f), 3, 2.0f, 0.7f, 7u); "
                   f"{steps} return uvec4(bits_of({end}), 0u, 0u, 0u);")


BODIES = {name: of_octaves(*of) for name, of in OCTAVES.items()}
LOOPS = {  # the number of octaves, and the noise
    "four": (4, "hn_perlin(o.place, o.seed)"), "five": (5, "hn_perlin(o.place, o.seed)"),
    "sine": (4, "sin(hn_perlin(o.place, o.seed))"), "fraction": (4, "o.place.fraction.x"),
    "bits": (4, "hn_i_float(o.place.cell.x & 7)")}
LOOP = ("hn_octaves2 o = hn_octaves(vec2(float_of(a.x), 0.5f), {}, 2.0f, 0.5f, 7u); do hn_add(o, {}); while (hn_next(o)); "
        "return uvec4(bits_of(hn_mean(o)), 0u, 0u, 0u);")


# A file of somebody else: two octaves of curl with a phase.
FLOW = "vec2 flow(vec2 p) { return hn_curl(p, 0.25, 7u) + 0.5 * hn_curl(p * 2.0, 0.25, 8u); }"
OF_FLOW = Body.of("x:f32 y:f32", "x:f32 y:f32", "hn_vec2 v = own::flow(vec2(float_of(a.x), float_of(a.y))); "
                  "return uvec4(bits_of(v.x), bits_of(v.y), 0u, 0u);")


@functools.cache
def in_floats():
    loops = {name: Body.of("x:f32", "value:f32", LOOP.format(*of)) for name, of in LOOPS.items()}
    return Sums(bodies=BODIES | loops | {"flow": OF_FLOW}, own="".join(own.plain(own.tokens_of(FLOW))))


class Roundings(unittest.TestCase):
    def ratio(self, name, sums):
        """The ratio of the largest error that is seen to the proven one."""
        rng, text = np.random.default_rng(2), self.text()
        noises = along_axes("", rng.uniform(-1, 1, (3, COUNT)).astype(np.float32).astype(float))
        exact, = text(name, EXACT, **noises)
        seen = max(abs(text(name, rounding, **noises)[0] - exact).max() for rounding in roundings(4))
        return seen / sums.errors(name, dict.fromkeys("xyz", "float:-1:1"))[0]

    @staticmethod
    @functools.cache
    def text():
        return Text([], **BODIES)

    def test_roundings_of_each_step_are_counted(self):
        """None is left out, and few are counted that do not occur."""
        for name in BODIES:
            with self.subTest(name):
                self.assertTrue(1 / 10 < (ratio := self.ratio(name, in_floats())) <= 1, ratio)


def planted(changes, *arguments, **others):
    """Numbers with a mistake."""
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copytree(answers.SOURCE.parent, Path(folder, "sums"))
        content = (copy / "numbers.hpp").read_text()
        for right, wrong in changes.items():
            if right not in content:
                raise LookupError(right)
            content = content.replace(right, wrong)
        (copy / "numbers.hpp").write_text(content)
        options = [f"-I{folder}" if option == f"-I{answers.CONFORMANCE}" else option for option in answers.OPTIONS]
        with mock.patch.multiple(answers, SOURCE=copy / "answers.cpp", OPTIONS=options):
            return Sums(*arguments, **others)


@in_thorough_runs
class Planted(unittest.TestCase):
    def test_a_rounding_that_is_left_out_is_found(self):
        floats = planted({"error = ulp(size)": "error = 0", "2.5 * ulp": "0 * ulp"}, bodies={"ridged": BODIES["ridged"]})
        self.assertGreater(Roundings().ratio("ridged", floats), 1)
        step = "hn_i_wide_times(int(a.x), int(a.y))"
        integers = planted({"-part, 0);\n    y.grid": "0, 0);\n    y.grid"}, FIXED, bodies={step: of_number(step)})
        self.assertGreater(Lemmas().ratio(step, integers), 1)


class Noises(unittest.TestCase):
    def test_an_own_sum_over_curl_with_a_phase_has_its_error(self):
        noise = bounds_of("curl_phase", 2, "none")
        for error in in_floats().errors("flow", {"x": "float:-16:16", "y": "float:-16:16"}):
            self.assertTrue(1.5 * noise.cell_error < error < 10 * noise.error, error)


class Unseen(unittest.TestCase):
    def test_a_step_that_nobody_has_proven_is_named(self):
        (four,), (five,) = (in_floats().errors(name, {"x": "float:-16:16"}) for name in ("four", "five"))
        self.assertTrue(1.2 * four < five < 2.5 * four, (four, five))  # an octave more
        for name, reason in (("sine", "a sine"), ("fraction", "a fraction of a number that rounds"), ("bits", "bits of an integer")):
            with self.assertRaisesRegex(LookupError, f"no proof of {reason}"):
                in_floats().errors(name, {"x": "float:-16:16"})
