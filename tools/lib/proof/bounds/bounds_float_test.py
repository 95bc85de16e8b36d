"""Tests of the proofs for floats, of the noises, their derivatives, the sine and the sums: the text of the library
over floats of any rounding mode stays within the bounds."""

import functools
import itertools
import math
import unittest
from unittest import mock

import numpy as np

from base.thorough import in_thorough_runs, some
from proof.bounds import exact_model as exact
from proof.bounds import float_sums, noises, sine, sums
from proof.bounds.floats import to_float
from proof.bounds.gradients import OCTAHEDRAL, SINE
from proof.bounds.noises import value as value_noise
from proof.bounds.noises import value_cubic
from proof.bounds.noises.perlin import floats as perlin
from proof.bounds.rounded import MODES, Body, Rounding, Text, along_axes, roundings, table
from proof.bounds.table import bounds_of, slope_bounds_of

CASES = noises.find("perlin").CASES
DIMS = (1, 2, 3, 4)
COUNT = {1: 20_000, 2: 10_000, 3: 4_000, 4: 2_000}
QUARTER_SINE = Body.of("q:u32", "sine:f32", "return uvec4(bits_of(hn_i_quarter_sine(a.x)), 0u, 0u, 0u);")


@functools.cache
def text(kind, *macros):
    """The calls of the library with a kind of gradient."""
    if kind is SINE:
        ids = [f"noise{dims}d.perlin{form}" for dims in (2, 3) for form in ("", "_cell")]
        ids += [f"fbm.{name}{dims}{form}" for dims in (2, 3) for name in sums.KINDS for form in FORMS]
        return Text([id for id in ids if id in table()], "HN_GRADIENT=HN_GRADIENT_SINE", *macros, optimized=True)
    ids = [f"noise{dims}d.{name}{form}" for dims in DIMS
           for name in ("perlin", "value", "perlin_d", "value_d", "value_cubic") for form in ("", "_cell")]
    ids += [f"fbm.{name}{dims}{form}" for dims in DIMS for name in sums.KINDS for form in FORMS]
    ids += [vector_row(name, dims) for name in VECTORS for dims in (2, 3)]
    return Text([id for id in ids if id in table()], *macros, optimized=True,
                **({} if macros else {"quarter_sine": QUARTER_SINE}))


def vector_row(name, dims):
    return f"{name}_vector.{name}_vector{dims}_cell"


VECTORS = {"value": exact.value, "perlin": functools.partial(exact.perlin, OCTAHEDRAL)}
FORMS = ("", "_cell", "_cell_period", "_detail", "_footprint")


def proven(kind, dims):
    """The bounds of hn_perlin in bounds.inc."""
    return bounds_of("perlin", dims, kind.name)


def random_fractions(rng, dims, count):
    """Floats in [0, 1], often near its ends."""
    near = rng.random((dims, count)) * 2.0 ** -rng.integers(0, 26, (dims, count))
    choice = rng.integers(0, 6, (dims, count))
    fractions = np.choose(choice, [rng.random((dims, count)), near, 1 - near, 1 - 2.0**-24, 1.0, 0.5])
    return list(fractions.astype(np.float32).astype(float))


class Errors:
    """Noises from a cell and a fraction, as the text computes them with these macros."""
    MACROS: tuple[str, ...] = ()

    def computed(self, name, dims, kind, rounding, cells, fractions):
        """The value and the derivatives of a noise; in 4D they are rows of their own."""
        columns = along_axes("c", cells) | along_axes("f", fractions) | {"seed": 0}
        out = text(kind, *self.MACROS)(f"noise{dims}d.{name}_cell", rounding, **columns)
        slopes = out if dims == 4 and name.endswith("_d") else out[1:]
        return out[0], slopes

    def largest(self, name, dims, kind, exactly, seed=1, simulated=None):
        """The largest error of a noise, and of its derivatives."""
        rng, errors = np.random.default_rng(seed), [0.0, 0.0]
        with_slopes = f"noise{dims}d.{name}_d_cell" in table() and kind is not SINE
        for rounding in simulated or roundings(seed):
            f = random_fractions(rng, dims, COUNT[dims])
            cells = list(rng.integers(-2**31, 2**31, (dims, COUNT[dims])))
            value, slopes = exactly(exact.words_at(kind, cells), f)
            found, _ = self.computed(name, dims, kind, rounding, cells, f)
            errors[0] = max(errors[0], abs(found - value).max())
            if with_slopes:
                _, found = self.computed(f"{name}_d", dims, kind, rounding, cells, f)
                errors[1] = max(errors[1], *(abs(d - e).max() for d, e in zip(found, slopes, strict=True)))
        return errors


class FloatError(Errors, unittest.TestCase):
    """Random points hardly ever make errors add up. They see about 1/3 of the bound in 1D, and of derivatives in 4D,
    which have the loosest bound, 1/12."""

    def every_noise(self):
        """Each with its exact values, and its bounds of values and derivatives for a rounding of so many ulps."""
        for dims, kind in CASES:
            def bounds(ulps, dims=dims, kind=kind):
                return (perlin.error_bound(dims, kind, ulps),
                        perlin.slope_error_bound(dims, ulps) if kind is OCTAHEDRAL else None)
            yield ("perlin", dims, kind, functools.partial(exact.perlin, kind)), bounds
        for dims in DIMS:
            yield ("value", dims, OCTAHEDRAL, exact.value), lambda ulps, dims=dims: (
                value_noise.error_bound(dims, ulps), value_noise.slope_error_bound(dims, ulps))
        for dims in DIMS[:3]:
            yield (("value_cubic", dims, OCTAHEDRAL, lambda words_of, f: (exact.value_cubic(words_of, f), [])),
                   lambda ulps, dims=dims: (value_cubic.error_bound(dims, ulps), None))

    @in_thorough_runs
    def test_simulated_from_cell(self):
        for noise, bounds in self.every_noise():
            for seen, bound in zip(self.largest(*noise), bounds(1.0)):
                if bound:
                    self.assertTrue(bound / 20 < seen < bound, (noise, seen, bound))

    def test_simulated_to_nearest(self):
        for noise, bounds in self.every_noise():
            for seen, bound in zip(self.largest(*noise, 6, [Rounding("nearest")]), bounds(0.5)):
                if bound:
                    self.assertTrue(bound / 30 < seen < bound, (noise, seen, bound))

    def test_fails_with_fewer_bits(self):
        for noise, bounds in self.every_noise():
            for seen, bound in zip(self.largest(*noise, 8, [Rounding("nearest", lost_bits=7)]), bounds(1.0)):
                if bound:
                    self.assertGreater(seen, bound, noise)

    def test_limits(self):
        """Derivatives, and value noise where the fade is computed above 1."""
        for dims in DIMS:
            rng = np.random.default_rng(9)
            f = random_fractions(rng, dims, COUNT[dims])
            cells = list(rng.integers(-2**31, 2**31, (dims, COUNT[dims])))
            for rounding in roundings(10):
                value, _ = self.computed("value", dims, OCTAHEDRAL, rounding, cells, f)
                self.assertLessEqual(abs(value).max(), bounds_of("value", dims, "none").limit)
                for name in ("value_d", "perlin_d"):
                    _, derivatives = self.computed(name, dims, OCTAHEDRAL, rounding, cells, f)
                    self.assertLessEqual(abs(np.array(derivatives)).max(), slope_bounds_of(name, dims).limit)

    def test_simulated_from_position(self):
        """Also the negative positions whose fraction is rounded, up to 1."""
        rng = np.random.default_rng(9)
        for (dims, kind), rounding in ((case, rounding) for case in CASES for rounding in roundings(11)):
            reach = 2.0 ** rng.integers(-40, 12, (dims, 2000))
            p = list((rng.uniform(-1, 1, (dims, 2000)) * reach).astype(np.float32).astype(float))
            found, = text(kind)(f"noise{dims}d.perlin", rounding, **along_axes("", p), seed=0)
            self.assertLess(abs(found - exact.perlin_at(kind, p)[0]).max(), proven(kind, dims).error)


class Vectors(unittest.TestCase):
    """Each component of a vector is the noise with other words, and within its bounds."""

    def largest(self, name, dims, simulated):
        """The largest error of each component."""
        rng, errors = np.random.default_rng(16), [0.0] * dims
        for rounding in simulated:
            f = random_fractions(rng, dims, COUNT[dims])
            cells = list(rng.integers(-2**31, 2**31, (dims, COUNT[dims])))
            columns = along_axes("c", cells) | along_axes("f", f) | {"seed": 0}
            found = text(OCTAHEDRAL)(vector_row(name, dims), rounding, **columns)
            words = exact.words_at(OCTAHEDRAL, cells)
            for axis, component in enumerate(found):
                value = VECTORS[name](exact.words_of_component(words, axis), f)[0]
                errors[axis] = max(errors[axis], abs(component - value).max())
        return errors

    def test_simulated_from_cell(self):
        for name, dims in itertools.product(VECTORS, (2, 3)):
            bound = bounds_of(f"{name}_vector", dims, "octahedral").cell_error
            for seen in self.largest(name, dims, some(roundings(17), dims, 2)):
                self.assertTrue(bound / 20 < seen < bound, (name, dims, seen, bound))

    def test_fails_with_fewer_bits(self):
        for name, dims in itertools.product(VECTORS, (2, 3)):
            bound = bounds_of(f"{name}_vector", dims, "octahedral").cell_error
            self.assertGreater(min(self.largest(name, dims, [Rounding("nearest", lost_bits=6)])), bound)


class Sine(unittest.TestCase):
    def largest_error(self, rounding, count=20000):
        """Over arguments that the reduction and the shift have moved as far as they may."""
        rng = np.random.default_rng(14)
        near = rng.integers(0, 2**20, count)
        q = np.choose(rng.integers(0, 3, count), [rng.integers(0, 2**30 + 1, count), near, 2**30 - near])
        q = np.minimum(np.where(rng.random(count) < 0.5, q, q | 63), 2**30)
        value, = text(OCTAHEDRAL)("quarter_sine", rounding, q=q)
        self.assertTrue((value >= 0).all() and (value <= 1).all())
        return abs(value - np.sin(np.pi / 2**31 * (q + rng.choice((-3, 0, 3), count)))).max()

    def test_within_the_contract(self):
        self.assertLess(sine.sine_bound(), 2**-19)
        self.assertEqual(SINE.component_error, 2**-19)
        self.assertLess(sine.sine_largest(), 1)

    def test_simulated(self):
        for ulps, modes in ((1.0, MODES), (0.5, ("nearest",))):
            bound = sine.sine_bound(ulps)
            seen = max(self.largest_error(Rounding(mode, 15, fuse)) for mode in modes for fuse in (0.0, 0.5))
            self.assertTrue(bound / 2 < seen < bound)

    def test_polynomial(self):
        seen = sine.sine_truncation(np.linspace(0, 1, 20001)[None]).max()
        self.assertTrue(seen < sine.sine_truncation_bound() < 1.05 * seen)

    def test_fails_with_fewer_bits(self):
        self.assertGreater(self.largest_error(Rounding("nearest", lost_bits=4)), 2**-19)

    def test_fails_with_another_coefficient(self):
        """One that is off in its last digits is refused by the proof."""
        c1, *others = sine.SINE_COEFFICIENTS
        for offset, too_large in ((3e-6, True), (-3e-6, False)):
            with mock.patch.object(sine, "SINE_COEFFICIENTS", (c1 + offset, *others)):
                self.assertGreater(sine.sine_bound(), 2**-19)
                self.assertEqual(sine.sine_largest() > 1, too_large)

    def test_coefficients_are_floats(self):
        for coefficient in sine.SINE_COEFFICIENTS:
            self.assertEqual(coefficient, to_float(coefficient))


class OctaveErrors:
    """Octave sums, as the text computes them with these macros."""
    NOISES = tuple((kind, dims) for dims, kind in CASES)
    MACROS: tuple[str, ...] = ()
    tolerance = staticmethod(float_sums.octave_tolerance)

    def check(self, arguments, kinds=sums.KINDS, spread=None, seed=10, simulated=None):
        """Computes at random points; the largest ratio of an error to its tolerance, which it must not exceed, of each
        kind. `arguments` draws those of a Sum, `spread` points."""
        rng, worst = np.random.default_rng(seed), dict.fromkeys(kinds, 0.0)
        for kind, dims in self.NOISES:
            for turn, name in enumerate(kinds, dims):
                for rounding in simulated or some(roundings(12), turn, 2):
                    s = sums.Sum(name, **arguments(rng, name))
                    if self.row_of(s, dims) not in table():
                        continue  # on the line and in 4D not every sum has all forms
                    p = (spread or self.spread)(rng, dims, s)
                    tolerance = self.tolerance(s, proven(kind, dims))
                    error = abs(self.computed(rounding, kind, s, p) - exact.octaves(kind, s, p)).max()
                    self.assertLessEqual(error, tolerance, s)
                    worst[name] = max(worst[name], error / tolerance)
        return worst

    @staticmethod
    def spread(rng, dims, s):
        """Positions; from a cell, a fraction that is a float is added to an integer."""
        p = rng.uniform(-s.p_max, s.p_max, (dims, 200))
        return list(np.floor(p) + (p - np.floor(p)).astype(np.float32) if s.from_cell
                    else p.astype(np.float32).astype(float))

    @staticmethod
    def row_of(s, dims):
        """In a tile without a period nothing rotates."""
        form = ("_detail" if isinstance(s.octaves, float) else "_footprint" if s.footprint is not None
                else "_cell_period" if not s.rotates else "_cell" if s.from_cell else "")
        return f"fbm.{s.kind}{dims}{form}"

    def computed(self, rounding, kind, s, p):
        columns = {"lacunarity": s.lacunarity, "gain": s.gain, "seed": 0}
        columns |= (along_axes("c", map(np.floor, p)) | along_axes("f", [x - np.floor(x) for x in p]) if s.from_cell
                    else along_axes("", p))
        columns |= {} if s.rotates else along_axes("p", [0] * len(p))
        columns |= {"detail" if isinstance(s.octaves, float) else "octaves": s.octaves}
        columns |= {} if s.footprint is None else {"footprint": s.footprint}
        columns |= {"strength": s.strength} if s.kind in sums.LARGEST_STRENGTH else {}
        value, = text(kind, *self.MACROS)(self.row_of(s, len(p)), rounding, **columns)
        return value

    @staticmethod
    def strength(rng, name):
        return to_float(rng.choice((2.0, 64.0, rng.uniform(0, 4))) if name == "ping_pong" else rng.random())

    def random_sum(self, rng, name, **others):
        return {"p_max": 2.0 ** rng.integers(0, 8), "octaves": int(rng.integers(1, 7)),
                "lacunarity": to_float(rng.uniform(-3, 3)), "gain": to_float(rng.uniform(0, 2)),
                "strength": self.strength(rng, name)} | others

    def assert_near(self, worst, least):
        self.assertTrue(all(ratio > least for ratio in worst.values()), worst)


class Octaves(OctaveErrors, unittest.TestCase):
    @in_thorough_runs
    def test_simulated(self):
        self.assert_near(self.check(self.random_sum), 1 / 100)

    def test_first_octave(self):
        """Where positions are exact: only the steps of the sum are left. A single octave hardly has any."""
        self.assert_near(self.check(lambda rng, name: self.random_sum(rng, name, octaves=1)), 1 / 15)

    @in_thorough_runs
    def test_with_a_period(self):
        def arguments(rng, name):
            return self.random_sum(rng, name, lacunarity=float(rng.integers(0, 4)), rotates=False, from_cell=True)
        self.assert_near(self.check(arguments), 1 / 60)

    @in_thorough_runs
    def test_from_a_cell(self):
        def arguments(rng, name):
            return self.random_sum(rng, name, p_max=2.0**20, lacunarity=to_float(rng.uniform(0, 3)), from_cell=True)
        self.assert_near(self.check(arguments), 1 / 60)

    def test_details_and_footprints(self):
        """Octaves that are about to vanish, too."""
        def details(rng, name):
            near = rng.integers(1, 6) + rng.choice((0.0, 2.0**-20, 0.5, rng.random()))
            return self.random_sum(rng, name, octaves=to_float(near))

        def footprints(rng, name):
            return self.random_sum(rng, name, footprint=to_float(rng.random() * 2.0 ** -rng.integers(-1, 8)))
        for arguments in (details, footprints):
            self.assert_near(self.check(arguments, ("fbm",)), 1 / 100)

    @in_thorough_runs
    def test_simulated_with_exact_positions(self):
        def arguments(rng, name):
            return self.random_sum(rng, name, p_max=16.0, lacunarity=2.0, gain=0.5, rotates=False, from_cell=True,
                                   exact_positions=True)

        def spread(rng, dims, s):
            return list(rng.integers(-s.p_max * 256, s.p_max * 256, (dims, 200)) / 256)
        self.assert_near(self.check(arguments, spread=spread), 1 / 60)

    def must_fail(self, **others):
        """Arguments for which the tolerance of others is taken."""
        with self.assertRaises(AssertionError):
            self.check(lambda rng, name: self.random_sum(rng, name, **others))

    def test_exact_positions_do_not_hide_inexact_ones(self):
        """A must-fail check: positions that round, promised exact, exceed the tolerance."""
        self.must_fail(p_max=4096.0, octaves=6, lacunarity=to_float(2.1), gain=0.5, exact_positions=True)

    def test_fails_with_fewer_bits(self):
        """For each kind, in one of its forms, or in a thorough run in each."""
        fewer = [Rounding("nearest", lost_bits=9)]
        forms = ({"rotates": False, "from_cell": True, "lacunarity": 2.0}, {"from_cell": True, "lacunarity": 2.0}, {})
        for turn, name in enumerate(sums.KINDS):
            for others in some(forms, turn):
                with self.subTest(name=name, **others), self.assertRaises(AssertionError):
                    self.check(lambda rng, name: self.random_sum(rng, name, gain=0.5, p_max=4.0, octaves=3, **others),
                               (name,), simulated=fewer)

    def test_edges(self):
        def tolerance(octaves, gain=0.5, dims=2, gradient=OCTAHEDRAL, kind="fbm", **others):
            return float_sums.octave_tolerance(sums.Sum(kind, 1.0, octaves, 2.0, gain, **others), proven(gradient, dims))
        self.assertEqual([tolerance(octaves) for octaves in (0, -1, 0.0, -0.5)], [0] * 4)
        self.assertLess(tolerance(200), 2.001)
        self.assertEqual(tolerance(20, 1e20, 3), math.inf)
        self.assertLess(tolerance(200, dims=3, gradient=SINE), 3.001)
        for kind, largest in (("billow", 2.001), ("ridged", 1.001), ("ping_pong", 2.002), ("weighted", 3.01)):
            self.assertLess(tolerance(200, dims=3, gradient=SINE, kind=kind, strength=1.0), largest)
        self.assertEqual(float_sums.octave_tolerance(sums.Sum("fbm", 1.0, 1, 256.0, 0.5, from_cell=True),
                                               proven(OCTAHEDRAL, 2)), math.inf)
        with self.assertRaisesRegex(LookupError, "no proof of the sum fog"):
            tolerance(1, kind="fog")
        with self.assertRaisesRegex(LookupError, "bounds of derivatives"):
            tolerance(1, kind="eroded")
