"""Tests of the steps by which sums add octaves: what steps.py and conformance/sums/bounds.cpp prove of a step holds
for what the oracle computes. A proof that somebody copied from a step with smaller slopes fails here, by its name."""

import itertools
import unittest
from fractions import Fraction

from proof.bounds.float_sums import octave_tolerance
from proof.bounds.sums import CATALOG, KINDS, Sum, fixed_octave_tolerance
from proof.bounds.table import Bounds
from proof.oracle.integers import NOISE_UNIT
from proof.oracle.sums import SUMS, Terms, fixed_mean, fixed_within, in_weights, mean, within_one

LARGEST = NOISE_UNIT * 5 // 4  # of the noise, in the units of fixed arithmetic: beyond what steps clamp it to
ERROR = 8191  # of the noise, in these units: little beside what a step folds, and much beside roundings
STEP = {1: ERROR, 2: 32 * ERROR}  # between the noises that are tried, of one octave and of two


def exact(oracle, noises, strength):
    ones = [Fraction(1)] * len(noises)
    return oracle[0](Terms([Fraction(n, NOISE_UNIT) for n in noises], ones, ones, Fraction(1), Fraction(strength)))


def fixed(oracle, noises, strength):
    ones = [2**18] * len(noises)
    return Fraction(oracle[1](Terms(list(noises), ones, ones, 2**18, in_weights(strength, 64))), NOISE_UNIT)


def largest_errors(oracle, count, strength):
    """How far noises that are off move the exact sum; how far they and roundings move that of fixed arithmetic; and how
    far roundings alone."""
    errors = [Fraction(0)] * 3
    for noises in itertools.product(range(-LARGEST, LARGEST + 1, STEP[count]), repeat=count):
        value, whole = exact(oracle, noises, strength), fixed(oracle, noises, strength)
        for signs in itertools.product((-1, 1), repeat=count):
            off = exact(oracle, [n + sign * ERROR for n, sign in zip(noises, signs)], strength)
            errors = list(map(max, errors, (abs(off - value), abs(off - whole), abs(value - whole))))
    return errors


def strengths(name):
    strength = CATALOG[name].strength
    return sorted({strength.default, strength.most}) if strength else [0]


def ratios(name, oracle=None):
    """Of the errors of a sum to those that its proofs allow, by what it is of: beyond 1 they are wrong."""
    error, limit = ERROR / NOISE_UNIT, LARGEST / NOISE_UNIT
    for count, strength in itertools.product(STEP, strengths(name)):
        s = Sum(name, 0.0, count, 1.0, 1.0, float(strength), rotates=False, from_cell=True, exact_positions=True)
        proofs = (("bounds.cpp", octave_tolerance, error), ("steps.py", fixed_octave_tolerance, error),
                  ("steps.py, roundings", fixed_octave_tolerance, 0.0))
        for (where, proof, of_noise), seen in zip(proofs, largest_errors(oracle or SUMS[name], count, strength)):
            noise = Bounds("any", 1, "none", of_noise, of_noise, 0.0, limit, of_noise, limit)
            yield (f"{name}, octaves {count}, strength {strength}: step {CATALOG[name].step} in {where}",
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


def coarse(of):
    return fixed_mean(of, [v >> 12 << 12 for v in fixed_within(of, Fraction(3, 2))])


class Steps(unittest.TestCase):
    def test_each_proof_holds(self):
        """And is not much more than what is seen, but for roundings, and ridges on ridges."""
        for name in KINDS:
            for what, ratio in ratios(name):
                with self.subTest(what):
                    self.assertLessEqual(ratio, 1)
                    self.assertGreater(ratio, -1 if "roundings" in what else 0.9 if "octaves 1" in what else 0.7)

    def test_a_copied_proof_fails(self):
        for name, oracle, wrong in (
                ("weighted", (cubes, fixed_cubes), "weighted, octaves 1, strength 1: step weighted in bounds.cpp"),
                ("weighted", (cubes, fixed_cubes), "weighted, octaves 1, strength 1: step weighted in steps.py"),
                ("fbm", SUMS["ridged"], "fbm, octaves 1, strength 0: step noise in bounds.cpp"),
                ("hybrid", SUMS["ridged"], "hybrid, octaves 1, strength 0: step hybrid in steps.py"),
                ("ridged", (steep_ridges, SUMS["ridged"][1]),
                 "ridged, octaves 2, strength 0: step ridged in bounds.cpp"),
                ("fbm", (SUMS["fbm"][0], coarse), "fbm, octaves 1, strength 0: step noise in steps.py, roundings")):
            with self.subTest(wrong):
                self.assertIn(wrong, [what for what, ratio in ratios(name, oracle) if ratio > 1])
