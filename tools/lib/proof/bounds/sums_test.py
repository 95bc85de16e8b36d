"""The text of the library stays within the bounds of sums, and reaches a part of them: over floats that round in any
direction and over integers, beside the same text over doubles. A sum of the catalog is tested as soon as it has
bounds."""

import functools
import itertools
import math
import unittest
from dataclasses import fields, replace
from unittest import mock

import numpy as np

from base.thorough import THOROUGH, some
from catalog.tables.functions import read_functions
from proof.bounds import gullies, jacobians, sums, text_test
from proof.bounds.floats import to_float
from proof.bounds.gradients import OCTAHEDRAL, SINE
from proof.bounds.rounded import EXACT, FIXED, NEAREST, SINES, Rounding, Text, along_axes, roundings
from proof.bounds.sums import CATALOG, FLOWS, KINDS, SHIFTS, SLOPED, Sum
from proof.bounds.table import bounds_of, read_gullies, slope_bounds_of

ALL = (*KINDS, *SLOPED, *SHIFTS, *FLOWS)
COUNT = 200  # places


# --- Functions and their arguments ------------------------------------------------------------------------------------

@functools.cache
def rows():
    """From a position, from a cell, and in a tile. (The place of a position in a tile is a cell's.)"""
    return {function.id: function for function in read_functions() if function.form == "sum" and function.bound in ALL
            and (function.has_cell or not function.has_period)}


@functools.cache
def text(gradient, *macros):
    macros += (SINES,) * (gradient is SINE)
    return Text([id for id, function in rows().items() if has(function, gradient)], *macros, optimized=True)


def has(function, gradient):
    return gradient is OCTAHEDRAL or function.axes in (2, 3) and function.bound in KINDS


def at_position(function):
    """The function from a position, beside which one from a cell has more roundings; in a tile it has none."""
    return next((other for other in rows().values() if not other.has_cell and not function.has_period
                 and (other.bound, other.axes, other.settings) == (function.bound, function.axes, function.settings)),
                function)


def random_sum(rng, function, fixed, **others):
    """One in the domain of the bounds. A lacunarity is what the function takes from its place."""
    low = 0 if fixed or function.has_cell else -3
    octaves = int(rng.integers(1, 7))
    arguments = {"p_max": 2.0**rng.integers(0, 8), "octaves": octaves,
                 "gain": to_float(rng.uniform(0, 1 if fixed else 2)),
                 "lacunarity": float(rng.integers(0, 4)) if function.has_period else to_float(rng.uniform(low, 3)),
                 **others}
    if "detail" in function.settings:
        arguments["octaves"] = to_float(arguments["octaves"] - rng.choice((0.0, 1 - 2.0**-19, 0.5, rng.random())))
    if "footprint" in function.settings:
        arguments["footprint"] = to_float(rng.random() * 2.0**-rng.integers(-1, 8))
    if "phase" in function.settings:
        arguments["phase"] = to_float(rng.random())
    if CATALOG[function.bound].strength:
        most = float(CATALOG[function.bound].strength.most)
        name = "amplitude" if function.bound in SHIFTS else "strength"
        arguments.setdefault(name, to_float(rng.choice((most, rng.uniform(0, min(most, 4)), rng.random()))))
    s = Sum(function.bound, rotates=not function.has_period, from_cell=function.has_cell, **arguments)
    bounded = function.bound in KINDS + FLOWS or jacobians.is_bounded(s)
    return s if bounded else random_sum(rng, function, fixed, **others)


def columns_of(function, s, p):
    """At places whose cells and fractions are floats, too."""
    place = along_axes("", p)
    if function.has_cell:
        place = along_axes("c", np.floor(p)) | along_axes("f", p - np.floor(p))
    settings = {name: getattr(s, "octaves" if name == "detail" else name) for name in function.settings}
    return place | along_axes("p", [0] * (function.axes * function.has_period)) | settings | {"seed": 0}


# --- Errors -----------------------------------------------------------------------------------------------------------

def tolerances(s, dims, gradient, fixed):
    """Of each result."""
    if s.kind in FLOWS:
        return sums.tolerances(s, bounds_of("curl" if s.phase is None else "curl_phase", dims, "none"), None, fixed)
    noise = CATALOG[s.kind].noise
    own = bounds_of(noise, dims, gradient.name)
    if s.kind in KINDS:
        return sums.tolerances(s, own, None, fixed)
    slope = slope_bounds_of(f"{noise.removesuffix('_d').removesuffix('_vector')}_d", dims)
    return jacobians.fixed_tolerances(s, own, slope) if fixed else sums.tolerances(s, own, slope)


def ratios(kinds, simulated, *macros, forms=lambda function: True, gradient=OCTAHEDRAL, seed=2, **others):
    """The largest error of a sum over its tolerance, by its kind."""
    rng, worst, fixed = np.random.default_rng(seed), dict.fromkeys(kinds, 0.0), FIXED in macros
    functions = [function for function in rows().values() if function.bound in kinds and has(function, gradient)]
    for function, rounding in itertools.product(filter(forms, functions), simulated):
        s = random_sum(rng, function, fixed, **others)
        p = rng.integers(-2**23, 2**23, (function.axes, COUNT)) * (s.p_max / 2**23)
        exact = at_position(function)
        found = zip(text(gradient, *macros)(function.id, rounding, **columns_of(function, s, p)),
                    text(gradient)(exact.id, EXACT, **columns_of(exact, s, p)),
                    tolerances(s, function.axes, gradient, fixed), strict=True)
        worst[s.kind] = max(worst[s.kind], *(abs(one - right).max() / tolerance for one, right, tolerance in found))
    return worst


class Sums(unittest.TestCase):
    def within(self, least, *arguments, kinds=ALL, **others):
        for gradient in (OCTAHEDRAL, SINE) if THOROUGH else (OCTAHEDRAL,):
            some_kinds = [kind for kind in kinds if gradient is OCTAHEDRAL or kind in KINDS]
            for kind, ratio in ratios(some_kinds, *arguments, gradient=gradient, **others).items():
                with self.subTest(kind, gradient=gradient.name):
                    self.assertTrue(least < ratio <= 1, ratio)

    def test_floats(self):
        for turn in range(8 if THOROUGH else 1):
            self.within(1 / 200, some(roundings(turn), turn, 2), seed=turn)

    def test_floats_of_an_octave(self):
        """Where positions are exact, so that only the steps of the sum are left."""
        self.within(1 / 60, some(roundings(3), 1, 2), octaves=1)

    def test_integers(self):
        for turn in range(8 if THOROUGH else 1):
            self.within(1 / 60, [NEAREST] * 2, FIXED, seed=turn)

    def test_integers_of_an_octave(self):
        self.within(1 / 15, [NEAREST], FIXED, octaves=1)

    def test_integers_at_the_ends_of_the_domain(self):
        """Results of 8 and more, which lose bits, and Jacobians and steps that are as large as they may be."""
        for gain, lacunarity, octaves in ((1.0, 1.0, 32), (1.0, 4.0, 3), (0.25, 252.0, 2), (0.75, 1.25, 20)):
            self.within(0, [NEAREST], FIXED, octaves=octaves, gain=gain, lacunarity=lacunarity, p_max=4.0,
                        kinds=SLOPED + SHIFTS, forms=lambda function: not function.has_period,
                        amplitude=64.0 / max(1, gain * lacunarity))

    def test_without_octaves(self):
        for kind, octaves, fixed in itertools.product(ALL, (0, -1), (False, True)):
            if CATALOG[kind].mean in ("", "bounded"):  # else it is not 0
                found = tolerances(Sum(kind, 1.0, octaves, 2.0, 0.5, 1.0, 1.0), 2, OCTAHEDRAL, fixed)
                self.assertEqual({*found}, {0.0}, kind)

    def test_the_domain(self):
        """Outside of it there is no bound, or that of the range."""
        def last(kind, *arguments, fixed=False, **others):
            s = Sum(kind, 1.0, *arguments, **({"strength": 1.0, "amplitude": 1.0} | others))
            return tolerances(s, 2, OCTAHEDRAL, fixed)[-1]
        for kind, arguments in itertools.product(ALL, ((33, 1.0, 0.5), (2, -1.0, 0.5), (2, 256.0, 0.1), (2, 2.0, 1.5))):
            self.assertEqual(last(kind, *arguments, fixed=True), math.inf, (kind, arguments))
        for kind in ALL:
            self.assertEqual(last(kind, 2, 256.0, 1.0, from_cell=True), math.inf)
        for kind, arguments in itertools.product(SLOPED + SHIFTS, ((6, 1e20, 1.0), (20, 2.0, 1e20))):
            self.assertEqual(last(kind, *arguments), math.inf, (kind, arguments))
        for kind, most in (("fbm", 2.001), ("billow", 2.001), ("ridged", 1.001), ("ping_pong", 2.002),
                           ("weighted", 3.01)):
            self.assertLess(last(kind, 200, 2.0, 0.5), most)
        self.assertEqual(last("fbm", 20, 2.0, 1e20), math.inf)
        self.assertGreaterEqual(last("warp", 3, 2.0, 0.5, amplitude=2.0**-98), 2.0**-98)  # HN_PRECISE: 0
        for kind, arguments, amplitude, bounded in (
                ("fbm_d", (6, 2.0, 1.0), 0, True), ("fbm_d", (7, 2.0, 1.0), 0, False),
                ("fbm_d", (2, 63.0, 1.0), 0, True), ("fbm_d", (2, 64.0, 1.0), 0, False), ("warp_progressive", (6, 2.0, 1.0), 8.0, True),
                ("warp_progressive", (6, 2.0, 1.0), 8.1, False), ("warp", (6, 2.0, 1.0), 64.0, True)):
            self.assertEqual(jacobians.is_bounded(Sum(kind, 1.0, *arguments, amplitude=amplitude)), bounded)
        with self.assertRaisesRegex(LookupError, "no proof of the sum fog"):
            Sum("fog", 1.0, 1, 2.0, 0.5)
        with self.assertRaisesRegex(LookupError, "bounds of derivatives"):
            sums.octave_tolerance(Sum("eroded", 1.0, 1, 2.0, 0.5), bounds_of("perlin", 2, "octahedral"))


# --- Gullies ----------------------------------------------------------------------------------------------------------

GULLIES = "noise2d.gullies_cell_period_footprint"


@functools.cache
def text_of_gullies(*macros):
    return Text([GULLIES], *macros, optimized=True)


def of_gullies(octaves, lacunarity=2.0, gain=0.5, footprint=None):
    return Sum("fbm", 0.0, octaves, lacunarity, gain, footprint=footprint, rotates=False, from_cell=True)


CASES = tuple((s, depth, steep) for i, (s, depth, steep) in enumerate(itertools.product(
    (of_gullies(1), of_gullies(2), of_gullies(3), of_gullies(5), of_gullies(3, 3.0, 0.25), of_gullies(2, 1.0, 1.0),
     of_gullies(3, footprint=1 / 16)), (0.01, 0.1, 0.5), (0.0, 0.125, 1.0, 3.0, 8.0))) if i % 3 == 0)


def ratios_of_gullies(rounding, tolerance_of, bounds, *macros):
    """The largest errors of the height and of a slope, over their tolerances; slopes are about as long as that, or
    short."""
    rng, worst = np.random.default_rng(7), np.zeros(2)
    for s, depth, steep in CASES:
        angle, size = rng.uniform(0, 2 * np.pi, COUNT), steep * rng.uniform(0.99, 1, COUNT) + 1e-3 * (steep == 0)
        slope = (size * [np.cos(angle), np.sin(angle)]).astype(np.float32).astype(float)
        f = np.where(rng.random(COUNT) < 0.5, rng.random((2, COUNT)), rng.integers(0, 65, (2, COUNT)) / 64)
        columns = (along_axes("c", rng.integers(-2**20, 2**20, (2, COUNT))) | along_axes("f", f)
                   | along_axes("p", (0, 0)) | along_axes("e", slope) | {"footprint": s.footprint or 0.0, "octaves": s.octaves, "seed": 0,
                                               "lacunarity": s.lacunarity, "gain": s.gain, "depth": depth})
        found, exact = (np.array(of(GULLIES, how, **columns)) for of, how in (
            (text_of_gullies(*macros), rounding), (text_of_gullies(), EXACT)))
        errors = abs(found - exact)
        for i in (errors[0].argmax(), errors[1:].max(axis=0).argmax()):
            height, added = tolerance_of(s, np.hypot(*np.clip(slope[:, i], -8, 8)), depth, bounds)
            worst = np.maximum(worst, [errors[0, i] / height, errors[1:, i].max() / added])
    return worst


class Gullies(unittest.TestCase):
    def test_floats_and_integers(self):
        in_floats = [(rounding, gullies.float_tolerance, ()) for rounding in some(roundings(7), 0, 2)]
        for rounding, tolerance, macros in (*in_floats, (NEAREST, gullies.fixed_tolerance, (FIXED,))):
            worst = ratios_of_gullies(rounding, tolerance, read_gullies(), *macros)
            self.assertTrue((worst < 1).all() and (worst > 1 / 30).all(), (rounding, worst))

    def test_smaller_bounds_are_noticed(self):
        """Must-fail checks."""
        proven = read_gullies()
        smaller = replace(proven, **{field.name: getattr(proven, field.name) / 32 for field in fields(proven)})
        for rounding, tolerance, macros in ((Rounding("random", 9), gullies.float_tolerance, ()),
                                            (NEAREST, gullies.fixed_tolerance, (FIXED,))):
            self.assertGreater(ratios_of_gullies(rounding, tolerance, smaller, *macros).max(), 1, (rounding, macros))

    def test_of_waves(self):
        """None at random places is steeper, or changes faster, than proven; and some come near."""
        rng, bounds, function = np.random.default_rng(1), read_gullies(), text_test.rows()["phasor_d", 2, "cell", "d"]
        columns = text_test.columns_of(function)
        angle, other = rng.uniform(0, 2 * np.pi, (2, len(columns["cx"])))
        k, step = 1.5 * np.array([np.cos(angle), np.sin(angle)]), 1e-6 * np.array([np.cos(other), np.sin(other)])
        (v, *g), (turned_v, *turned_g) = (np.array(text_test.text(OCTAHEDRAL)(
            function.id, EXACT, **columns | along_axes("k", wave))) for wave in (k, k + step))
        for seen, bound in ((np.hypot(*g), bounds.steepest), (abs(turned_v - v) / 1e-6, bounds.wave_rate),
                            (np.hypot(*np.subtract(turned_g, g)) / 1e-6, bounds.slope_wave_rate)):
            self.assertTrue(0.4 * bound < seen.max() < bound, (seen.max(), bound))

    def test_growth_and_domain(self):
        """From octave to octave, by less on steep ground; and no further than to the ends."""
        bounds = read_gullies()

        def floats(octaves, slope, depth):
            return gullies.float_tolerance(of_gullies(octaves), slope, depth, bounds)
        steep, flat = ([floats(n, r, 0.1) for n in range(1, 12)] for r in (3.0, 0.0))
        for a, b in itertools.chain(itertools.pairwise(steep), itertools.pairwise(flat)):
            self.assertTrue(a[0] <= b[0] and a[1] <= b[1])
        height, added = floats(30, 1.0, 8.0)
        self.assertTrue(height <= 2 * 8 * 2.00001 and added <= 16.00001)
        self.assertEqual([floats(5, 1.0, 0.0), floats(0, 1.0, 1.0)], [(0, 0)] * 2)
        for s, depth, bounded in ((of_gullies(33), 0.1, False), (of_gullies(3, 300.0), 0.1, False),
                                  (of_gullies(3, gain=1.5), 0.1, False), (of_gullies(7, 2.0, 1.0), 2.0, False),
                                  (of_gullies(6, 2.0, 1.0), 2.0, True)):
            self.assertEqual(gullies.fixed_tolerance(s, 1.0, depth, bounds)[0] < math.inf, bounded)


# --- Steps ------------------------------------------------------------------------------------------------------------

class Steps(unittest.TestCase):
    def test_nothing_wraps(self):
        for dims in (2, 3):
            self.assertLess(max(jacobians.largest_intermediates(dims).values()), 2**31)
            self.assertLess(max(jacobians.largest_words(dims).values()), 2**32)
        for limit, factor in (("LARGEST_GROWTH", 8), ("LARGEST_SHIFT", 8), ("LARGEST_RISE", 1.01)):
            with mock.patch.object(jacobians, limit, factor * getattr(jacobians, limit)):
                self.assertGreater(max(jacobians.largest_intermediates(3).values()), 2**31)

    def test_the_slope_limit(self):
        """Derivatives of an octave are cut off at the two ends of a range: beyond it there is no bound."""
        noise, slope = bounds_of("phasor_d", 2, "none"), slope_bounds_of("phasor_d", 2)
        for octaves, limit, bounded in ((4, 128.0, True), (32, 128.0, False), (4, 100.0, False)):
            with mock.patch.object(jacobians, "SLOPE_LIMIT", limit):
                tolerance = jacobians.largest_tolerance(Sum("fbm_d", 1.0, octaves, 2.0, 0.5), noise, slope, True)
                self.assertEqual(tolerance < 2.0, bounded)

    def test_errors_of_waves_that_the_text_does_not_prove(self):
        smaller = replace(read_gullies(), value=1e-6)
        with mock.patch.object(gullies, "read_gullies", return_value=smaller):
            (message,) = gullies.wrong_errors()
        self.assertRegex(message, r"^GULLIES_BOUNDS .* noise2d\.phasor_cell_period proves 5\.\d+e-06, and not 1e-06$")
