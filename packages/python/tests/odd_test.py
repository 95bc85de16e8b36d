"""Odd inputs, of every function: NaN, huge, masked, of another type or another kind of array."""

from __future__ import annotations

import itertools
import unittest
import warnings
from fractions import Fraction

import hashnoise
import numpy

ARITHMETICS = ("fast", "precise", "fixed")
FUNCTIONS = [(name, axes) for axes in range(1, 5) for name in hashnoise.noises(axes) + hashnoise.fractals(axes)]
USUAL = numpy.array([0.375, 7.25, -3.5, 0.0, 100.125])
NONE = (numpy.nan, numpy.inf, -numpy.inf)
# A value that a setting of floats may have. Where a function has it, others of the kind are tried.
FLOATS = {"lacunarity": 2.0, "gain": 0.5, "strength": 1.0, "amplitude": 1.0, "detail": 3.5, "footprint": 0.25,
          "phase": 0.25, "jitter": 0.5}


def called(name, coordinates, **options):
    return getattr(hashnoise, name)(*coordinates, **options)


def places(axes, *, values=USUAL):
    """As many coordinates, each another."""
    return [numpy.roll(values, axis) for axis in range(axes)]


def planes(values):
    """With an axis for the components always."""
    return values if values.ndim > 1 else values[numpy.newaxis]


class NoNumbers(unittest.TestCase):
    def expect(self, name, coordinates, none, **options):
        """Points are NaN where `none` has them, in all planes; others are as without them."""
        values = planes(called(name, coordinates, **options))
        self.assertTrue(numpy.isnan(values[:, none]).all(), values)
        right = planes(called(name, [numpy.where(none, 0.5, array) for array in coordinates], **options))
        self.assertEqual(values[:, ~none].tobytes(), right[:, ~none].tobytes())
        self.assertTrue(numpy.isfinite(right).all())

    def test_numbers(self):
        for wrong in (*NONE, 1e300):  # which is infinite as a float32
            self.assertTrue(numpy.isnan(hashnoise.perlin(wrong, 0.5)))

    def test_a_number_out_of_none_is_noticed(self):
        for none in ([], [1, 3], [1]):
            with self.subTest(none), self.assertRaises(AssertionError):
                self.expect("perlin", [numpy.where(numpy.arange(5) == 2, numpy.nan, USUAL)],
                            numpy.isin(numpy.arange(5), none), arithmetic="fixed")

    def test_arrays(self):
        for (name, axes), arithmetic in itertools.product(FUNCTIONS, ARITHMETICS):
            for axis, wrong in itertools.product(range(axes), NONE):
                for dtype in ("f4", "f8"):
                    with self.subTest(name, axes=axes, arithmetic=arithmetic, axis=axis, wrong=wrong, dtype=dtype):
                        coordinates = [array.astype(dtype) for array in places(axes)]
                        coordinates[axis][[1, 4]] = wrong
                        none = numpy.isin(numpy.arange(5), (1, 4))
                        self.expect(name, coordinates, none, arithmetic=arithmetic)

    def test_forms(self):
        """Each has kernels of its own."""
        for arithmetic in ARITHMETICS:
            for name, options in (("perlin", {"phase": 0.25}), ("perlin", {"period": 5}),
                                  ("cellular", {"metric": "hybrid"}), ("cellular", {"phase": 0.5, "period": 3}),
                                  ("phasor", {"wave": (3, -2)}),
                                  ("fbm", {"detail": 2.5}), ("fbm", {"footprint": 0.1}), ("fbm", {"period": 4}),
                                  ("ridged", {"noise": "cellular_smooth"}), ("clouds", {"noise": "random"}),
                                  ("warp_progressive", {"noise": "curl"})):
                with self.subTest(name, arithmetic=arithmetic, **options):
                    x = numpy.where(numpy.arange(5) == 3, numpy.nan, USUAL)
                    self.expect(name, [x, USUAL], numpy.arange(5) == 3, arithmetic=arithmetic, **options)

    def test_many_points(self):
        """By several threads, with and without copies."""
        x = numpy.linspace(-50, 50, 300_001, dtype=numpy.float32)
        x[::997] = numpy.nan
        right = numpy.isnan(x)
        for arithmetic, threads in itertools.product(ARITHMETICS, (1, 3)):
            for name, array in (("as it is", x), ("float64", x.astype(float)), ("backwards", x[::-1])):
                with self.subTest(name, arithmetic=arithmetic, threads=threads):
                    found = hashnoise.fbm(array, 0.5, octaves=2, arithmetic=arithmetic, threads=threads)
                    self.assertTrue((numpy.isnan(found) == (right[::-1] if name == "backwards" else right)).all())

    def test_settings(self):
        """A setting that is none is an error, of a function and of a grid."""
        for name, axes in FUNCTIONS:
            function = getattr(hashnoise, name)
            for setting, wrong in itertools.product(function.__kwdefaults__, NONE):
                if setting in FLOATS:
                    with self.subTest(name, axes=axes, setting=setting, wrong=wrong):
                        with self.assertRaisesRegex(ValueError, rf"^{name}: {setting} must be finite, not "):
                            function(*places(axes), **{setting: wrong})
                        with self.assertRaisesRegex(ValueError, rf"^grid: {setting} must be finite, not "):
                            hashnoise.grid(name, (3,) * axes, step=0.1, **{setting: wrong})


class Large(unittest.TestCase):
    """Finite positions give numbers of the documented range, or none where floats overflow; never garbage."""

    def test_positions(self):
        x = numpy.array([2**22 + 0.5, 2.0**23, -2.0**24, 2.0**31, -2.0**31, 2.0**31 + 256, 1e12, -1e20, 3e38])
        for (name, axes), arithmetic in itertools.product(FUNCTIONS, ARITHMETICS):
            with self.subTest(name, axes=axes, arithmetic=arithmetic):
                options = {"octaves": 3} if name in hashnoise.fractals(axes) else {}
                values = planes(called(name, [x] * axes, arithmetic=arithmetic, **options))
                self.assertFalse((numpy.abs(values) > 64).any(), values)
                self.assertTrue(numpy.isfinite(values[:, :5]).all(), values)

    def test_settings_at_the_ends_of_what_is_allowed(self):
        for (name, axes), arithmetic in itertools.product(FUNCTIONS, ARITHMETICS):
            options = getattr(hashnoise, name).__kwdefaults__
            for setting, value in (("lacunarity", 8.5), ("lacunarity", -8.5), ("gain", 4.2), ("gain", 0),
                                   ("phase", 1e30), ("phase", -3e38), ("footprint", 3e38), ("detail", 0),
                                   ("detail", 32), ("jitter", 0)):
                if setting not in options or (setting == "phase" and axes not in (2, 3)):
                    continue
                if arithmetic == "fixed" and (setting, value) in (("lacunarity", -8.5), ("gain", 4.2)):
                    continue
                given = {"octaves": 32} if "octaves" in options and setting != "detail" else {}
                with self.subTest(name, axes=axes, arithmetic=arithmetic, setting=setting, value=value):
                    values = called(name, places(axes), arithmetic=arithmetic, **{setting: value}, **given)
                    self.assertTrue(numpy.isfinite(values).all(), values)

    def test_fractions_beyond_a_cell(self):
        with self.assertRaisesRegex(ValueError, "^perlin: with a cell the coordinates are the fractions in it, and "
                                                "must be from 0 to 1; x is 20.5$"):
            hashnoise.perlin(20.5, -30.25, cell=(0, 0))
        for name, axes in FUNCTIONS:
            for wrong in (-1e-9, 1.0001, 20.5, -numpy.inf, 3e38):
                with self.subTest(name, axes=axes, wrong=wrong):
                    coordinates = [0.5] * (axes - 1) + [numpy.array([0.25, wrong, numpy.nan])]
                    with self.assertRaisesRegex(ValueError, f"must be from 0 to 1; {'xyzw'[axes - 1]} is from "):
                        called(name, coordinates, cell=(0,) * axes)
            called(name, [0.0] * axes, cell=(0,) * axes)
            called(name, [numpy.ones(2)] * axes, cell=(0,) * axes)

    def test_whole_numbers(self):
        self.assertEqual(hashnoise.value(2**70 + 1), hashnoise.value(2.0**70))
        self.assertEqual(hashnoise.perlin(True), hashnoise.perlin(1.0))
        self.assertEqual(hashnoise.value([[2**70, 3], [7, -2**80]], 0).tolist(),
                         hashnoise.value([[2.0**70, 3.0], [7.0, -2.0**80]], 0).tolist())
        for wrong in (10**400, [10**400]):
            with self.assertRaisesRegex(ValueError, "^perlin: x must be finite, and is too large"):
                hashnoise.perlin(wrong)
        with self.assertRaisesRegex(ValueError, "^perlin: the cells along x must be from -2147483648 to 2147483647, "):
            hashnoise.perlin(0.5, cell=([2**70, 3],))


class Masks(unittest.TestCase):
    def test_every_function(self):
        for name, axes in FUNCTIONS:
            with self.subTest(name, axes=axes):
                coordinates = places(axes)
                mask = numpy.arange(5) == 1
                other = numpy.arange(5) == 3
                masked = [numpy.ma.array(array, mask=mask) for array in coordinates]
                masked[-1] = numpy.ma.array(coordinates[-1], mask=other)
                found = called(name, masked)
                right = called(name, coordinates)
                self.assertIs(type(found), numpy.ma.MaskedArray)
                union = numpy.broadcast_to(other if axes == 1 else mask | other, right.shape)
                self.assertEqual(numpy.ma.getmaskarray(found).tolist(), union.tolist())
                self.assertEqual(found.compressed().tolist(), right[~union].tolist())

    def test_broadcasting(self):
        x = numpy.ma.array([0.5, 0.75], mask=[True, False])
        y = numpy.array([[0.25], [1.5], [2.5]])
        found = hashnoise.perlin_d(x, y)
        self.assertEqual(found.shape, (3, 3, 2))
        self.assertTrue(found.mask[..., 0].all() and not found.mask[..., 1].any())
        y = numpy.ma.array(y, mask=[[False], [False], [True]])
        self.assertEqual(hashnoise.perlin(x, y).mask.tolist(), [[True, False], [True, False], [True, True]])

    def test_what_is_masked_is_not_looked_at(self):
        bad = numpy.ma.array([0.5, numpy.nan, 1e30, -5.0], mask=[False, True, True, True])
        self.assertEqual(hashnoise.perlin(bad, cell=0).compressed().tolist(), [hashnoise.perlin(0.5, cell=0)])
        cells = numpy.ma.array([3, 2**40], mask=[False, True])
        self.assertEqual(hashnoise.perlin(0.5, cell=cells).tolist(), [hashnoise.perlin(0.5, cell=3), None])

    def test_numbers(self):
        self.assertIs(hashnoise.perlin(numpy.ma.masked, 0.5), numpy.ma.masked)
        self.assertEqual(hashnoise.perlin(numpy.ma.array(0.5), 0.5), hashnoise.perlin(0.5, 0.5))
        self.assertTrue(hashnoise.perlin_d(numpy.ma.masked, 0.5).mask.all())
        unmasked = hashnoise.perlin(numpy.ma.array(USUAL))
        self.assertIs(type(unmasked), numpy.ma.MaskedArray)
        self.assertEqual(unmasked.compressed().tolist(), hashnoise.perlin(USUAL).tolist())

    def test_out(self):
        x = numpy.ma.array(USUAL, mask=[True, False, False, False, True])
        out = numpy.ma.zeros(5, numpy.float32)
        self.assertIs(hashnoise.perlin(x, out=out), out)
        self.assertEqual(out.tolist(), hashnoise.perlin(x).tolist())
        self.assertIs(hashnoise.perlin(USUAL, out=out), out)  # now nothing is masked
        self.assertEqual(out.tolist(), hashnoise.perlin(USUAL).tolist())
        with self.assertRaisesRegex(TypeError, "^perlin: out must be a masked array, since a coordinate is one"):
            hashnoise.perlin(x, out=numpy.zeros(5, numpy.float32))
        grid = numpy.ma.array(numpy.zeros((3, 4), numpy.float32), mask=True)
        self.assertIs(hashnoise.grid("perlin", (4, 3), step=0.1, out=grid), grid)
        self.assertEqual(grid.tolist(), hashnoise.grid("perlin", (4, 3), step=0.1).tolist())

    def test_a_mask_is_not_shared(self):
        x = numpy.ma.array(USUAL, mask=[True, False, False, False, False])
        found = hashnoise.perlin(x)
        found[0] = 1
        found[1] = numpy.ma.masked
        self.assertEqual(x.mask.tolist(), [True, False, False, False, False])


class Kinds(unittest.TestCase):
    def test_types_of_numbers(self):
        for dtype in ("f2", "f4", "f8", "g", ">f4", ">f8", "i1", "u2", "i8", "u8", ">i4", "?"):
            with self.subTest(dtype):
                x = (numpy.arange(-700, 700) / 97).astype(dtype)
                self.assertEqual(hashnoise.value(x).tobytes(), hashnoise.value(x.astype("f4")).tobytes())
        self.assertEqual(hashnoise.value(numpy.array([1, 2], "M8[s]").astype("i8")).shape, (2,))
        for wrong in (numpy.array([1j]), numpy.array(["a"]), numpy.array([None]), numpy.array([1, 2], "M8[s]"),
                      numpy.array([1, 2], "m8[s]"), numpy.zeros(2, [("x", "f4")]), object(), b"x", "0.5", {}, {1.5},
                      Fraction(1, 2), numpy.ma.array(["a"], mask=[True]), numpy.ma.zeros(2, [("x", "f4")])):
            with self.subTest(wrong):
                with self.assertRaisesRegex(TypeError, "^value: x must be a number or an array of numbers, not of "):
                    hashnoise.value(wrong)

    def test_subclasses(self):
        """An array that is no masked one gives a plain one."""
        class Own(numpy.ndarray):
            pass

        for x in (USUAL.view(Own), USUAL.view(numpy.recarray), memoryview(USUAL)):
            self.assertIs(type(hashnoise.perlin(x)), numpy.ndarray)
            self.assertEqual(hashnoise.perlin(x).ravel().tolist(), hashnoise.perlin(USUAL).tolist())

    def test_shapes(self):
        for name, axes in FUNCTIONS:
            components = len(hashnoise.components(name, axes))
            front = (components,) if components > 1 else ()
            for shape in ((), (0,), (6, 0, 5), (1,), (1, 1, 1), (6, 3, 2, 5)):
                with self.subTest(name, axes=axes, shape=shape):
                    values = called(name, [numpy.full(shape, 0.375)] * axes)
                    one = called(name, [0.375] * axes)
                    self.assertEqual(numpy.shape(values), front + shape)
                    self.assertIs(type(values), float if front + shape == () else numpy.ndarray)
                    self.assertTrue((numpy.asarray(values).T == numpy.asarray(one)).all())

    def test_memory(self):
        """In any order, with gaps, at odd bytes, read-only."""
        whole = numpy.arange(200, dtype=numpy.float32).reshape(10, 20) * numpy.float32(0.173)
        read_only = whole.copy()
        read_only.flags.writeable = False
        odd = numpy.zeros(whole.shape, [("kind", "u1"), ("n", "f4")])["n"]
        odd[...] = whole
        for name, axes in FUNCTIONS:
            right = called(name, [whole[::2, ::-3]] * axes)
            for kind, array in (("cut", whole[::2, ::-3]), ("read-only", read_only[::2, ::-3]), ("odd", odd[::2, ::-3]),
                                ("Fortran", numpy.asfortranarray(whole[::2, ::-3])),
                                ("float64", whole.astype(float)[::2, ::-3]), ("list", whole[::2, ::-3].tolist())):
                with self.subTest(name, axes=axes, kind=kind):
                    self.assertTrue((called(name, [array] * axes) == right).all())
                    self.assertFalse(numpy.isnan(right).any())

    def test_no_warnings(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            hashnoise.fbm(numpy.array([numpy.nan, numpy.inf, 1e300, 1e38]), arithmetic="fixed")
            hashnoise.perlin(numpy.array([numpy.nan, 0.5]), cell=3)
            hashnoise.perlin(numpy.ma.array([numpy.nan, 0.5], mask=[True, False]), cell=3)
