"""Tests of the steps by which sums add octaves: what conformance/sums/bounds.cpp proves of a step holds for what the
oracle computes, and for the roundings of the library's text. A proof that somebody copied from a step with smaller
slopes or fewer roundings fails here, by its name."""

import functools
import itertools
import unittest
from fractions import Fraction

import numpy as np

from proof.bounds.claims import exact_sum
from proof.bounds.floats import to_float
from proof.bounds.rounded import EXACT, FIXED, NEAREST, Body, Text, roundings
from proof.bounds.sums import CATALOG, KINDS, Sum, fixed_octave_tolerance, octave_tolerance, steps_of
from proof.bounds.table import Bounds
from proof.oracle.integers import NOISE_UNIT
from proof.oracle.sums import SUMS, Terms, fixed_mean, fixed_within, in_weights, mean, within_one

LARGEST = NOISE_UNIT * 5 // 4  # of the noise, in the units of fixed arithmetic: beyond what steps clamp it to
ERROR = 8191  # of the noise, in these units: little beside what a step folds, and much beside roundings
STEP = {1: ERROR, 2: 32 * ERROR}  # between the noises that are tried, of one octave and of two


def exact(oracle, noises, strength):
    return exact_sum(oracle[0], [Fraction(n, NOISE_UNIT) for n in noises], Fraction(strength))


def fixed(oracle, noises, strength):
    ones = [2**18] * len(noises)
    return Fraction(oracle[1](Terms(list(noises), ones, ones, 2**18, in_weights(strength, 64))), NOISE_UNIT)


def largest_errors(oracle, count, strength):
    """How far noises that are off move the exact sum, and how far they and roundings move that of fixed arithmetic."""
    errors = [Fraction(0)] * 2
    for noises in itertools.product(range(-LARGEST, LARGEST + 1, STEP[count]), repeat=count):
        value, whole = exact(oracle, noises, strength), fixed(oracle, noises, strength)
        for signs in itertools.product((-1, 1), repeat=count):
            off = exact(oracle, [n + sign * ERROR for n, sign in zip(noises, signs)], strength)
            errors = list(map(max, errors, (abs(off - value), abs(off - whole))))
    return errors


def strengths(name):
    strength = CATALOG[name].strength
    return sorted({strength.default, strength.most}) if strength else [0]


def ratios(name, oracle=None):
    """Of the errors of a sum to those that its proofs allow, by what it is of: beyond 1 they are wrong."""
    error, limit = ERROR / NOISE_UNIT, LARGEST / NOISE_UNIT
    for count, strength in itertools.product(STEP, strengths(name)):
        s = Sum(name, 0.0, count, 1.0, 1.0, float(strength), rotates=False, from_cell=True, exact_positions=True)
        noise = Bounds("any", 1, "none", error, error, 0.0, limit, error, limit)
        proofs = (("floats", octave_tolerance), ("integers", fixed_octave_tolerance))
        for (numbers, proof), seen in zip(proofs, largest_errors(oracle or SUMS[name], count, strength)):
            yield (f"{name}, octaves {count}, strength {strength}: step {CATALOG[name].step} in {numbers}",
                   float(seen) / proof(s, noise))


def cubes(of):
    return mean(of, [n**3 for n in within_one(of)])


def fixed_cubes(of):
    return fixed_mean(of, [round(Fraction(v**3, NOISE_UNIT**2)) for v in fixed_within(of, 1)])


def steep_ridges(of):
    """Of ridges, with what is left of an octave four times, and not twice, in the next."""
    ridges, factor = [], Fraction(1)
    for n in within_one(of):
        ridges.append((1 - abs(n)) ** 2 * factor)
        factor = min(4 * ridges[-1], Fraction(1))
    return mean(of, ridges)


@functools.cache
def text(*macros):
    """Two octaves: the number that each adds, and the factor that the first leaves of the next weight."""
    body = ("hn_i_octave_sum s = hn_i_empty_sum(2, 1.0f); s = {}; hn_i_octave_sum t = s; t.value = HN_I_NO_WEIGHT; "
            "t.weight = HN_I_WEIGHT_ONE; t = {}; return uvec4(bits_of(hn_float(s.value)), bits_of(hn_float(t.value)), "
            "bits_of(hn_float(s.weight)), 0u);")
    return Text([], *macros, **{name: Body.of("a:f32 b:f32 strength:f32", "first:f32 second:f32 factor:f32", body.format(
        *(CATALOG[name].adds(sum_, f"float_of(a.{n})", "float_of(a.z)") for sum_, n in (("s", "x"), ("t", "y")))))
        for name in KINDS})


def near_ends(rng, count):
    ends = rng.choice((-1, 0, 1), count) - 2.0**-rng.integers(0, 30, count) * rng.choice((-1, 1), count)
    return np.where(rng.random(count) < 0.5, rng.uniform(-1, 1, count), ends.clip(-1, 1)).astype(np.float32).astype(float)


def of_roundings(name, strength, fixed):
    """The largest errors of the text's roundings alone, for both octaves and the factor, and their proven bounds."""
    a, b = near_ends(np.random.default_rng(1), (2, 20_000))
    if fixed:
        a, b = (np.trunc(n * NOISE_UNIT) / NOISE_UNIT for n in (a, b))
    columns, seen = {"a": a, "b": b, "strength": strength}, np.zeros(3)
    for rounding in [NEAREST] if fixed else roundings(3):
        found = np.array(text(*(FIXED,) * fixed)(name, rounding, **columns))
        if fixed:
            found /= np.array([[NOISE_UNIT, NOISE_UNIT, 2**18]]).T
        seen = np.maximum(seen, abs(found - text()(name, EXACT, **columns)).max(axis=1))
    proven = steps_of(Sum(name, 0.0, 2, 1.0, 1.0, strength), [0.0, 0.0], fixed)
    return seen, [*proven.errors, proven.factor_errors[0]]


class Steps(unittest.TestCase):
    def test_each_proof_holds(self):
        """And is not much more than what is seen, but for ridges on ridges."""
        for name in KINDS:
            for what, ratio in ratios(name):
                with self.subTest(what):
                    self.assertLessEqual(ratio, 1)
                    self.assertGreater(ratio, 0.9 if "octaves 1" in what else 0.7)

    def test_roundings_of_each_are_counted(self):
        """Where the noise has no error. None is left out, and few are counted that do not occur."""
        for name, fixed in itertools.product(KINDS, (False, True)):
            some = (*map(float, strengths(name)), *([to_float(0.3)] if CATALOG[name].strength else []))
            seen, proven = np.array([of_roundings(name, strength, fixed) for strength in some]).transpose(1, 0, 2)
            with self.subTest(name, fixed=fixed):
                self.assertTrue((seen <= proven).all(), (seen, proven))
                self.assertTrue((seen >= proven / 5).any(axis=0).all(), (seen, proven))

    def test_a_copied_proof_fails(self):
        for name, oracle, wrong in (
                ("weighted", (cubes, fixed_cubes), "weighted, octaves 1, strength 1: step weighted in floats"),
                ("weighted", (cubes, fixed_cubes), "weighted, octaves 1, strength 1: step weighted in integers"),
                ("fbm", SUMS["ridged"], "fbm, octaves 1, strength 0: step noise in floats"),
                ("hybrid", SUMS["ridged"], "hybrid, octaves 1, strength 0: step hybrid in integers"),
                ("ridged", (steep_ridges, SUMS["ridged"][1]),
                 "ridged, octaves 2, strength 0: step ridged in floats")):
            with self.subTest(wrong):
                self.assertIn(wrong, [what for what, ratio in ratios(name, oracle) if ratio > 1])
