"""hashnoise.arrays: the same numbers in NumPy, JAX and PyTorch, and derivatives. Each class wants its library."""

from __future__ import annotations

import functools
import importlib
import types
import unittest
import unittest.mock
import warnings
from collections.abc import Callable, Iterable

import documents_test
import golden
import hashnoise
import hashnoise.arrays
import numpy

FUNCTIONS = [(name, axes) for axes in range(1, 5) for name in hashnoise.noises(axes) + hashnoise.fractals(axes)]
FORMS = {"period": [{"period": 5}], "cell": [{"cell": -7}], "phase": [{"phase": 0.3}, {"phase": 0.75, "period": 3}],
         "metric": [{"metric": "hybrid", "jitter": 0.5}], "wave": [{"wave": (1.5, -3, 2), "phase": 0.1}, {"wave": (1.5, -3, 2), "bandwidth": 0.75}],
         "noise": [{"octaves": 3, "lacunarity": 3.0, "gain": 0.75}],
         "detail": [{"detail": 3.5}, {"footprint": 0.3}, {"noise": "cell_border"}]}


def places(axes: int, count: int = 40) -> list[numpy.ndarray]:
    """Points anywhere, at whole positions, and at the borders of cells."""
    random = numpy.random.default_rng(axes)
    points = random.uniform(-20, 20, (axes, count))
    points[:, ::4] = numpy.floor(points[:, ::4])
    points[0, 1::4] = numpy.floor(points[0, 1::4])
    return [*points.astype(numpy.float32)]


def forms(name: str, axes: int) -> list[dict]:
    """Options for each form of a function."""
    options = getattr(hashnoise, name).__kwdefaults__
    found = [{}, *(form for option, some in FORMS.items() if option in options for form in some)]
    found = [form for form in found if "phase" not in form or axes in (2, 3)]
    found = [form for form in found if form.get("noise") not in hashnoise.noises(2) or axes in (2, 3)]
    return [{**form, **({"wave": form["wave"][:axes]} if "wave" in form else {})} for form in found]


class Library:
    """The tests that all libraries have."""

    def made(self, array: numpy.ndarray) -> object:
        """An array of the library."""
        return array

    def compare(self, name: str, axes: int, **options: object) -> None:
        coordinates = places(axes)
        if "cell" in options:
            coordinates = [values - numpy.floor(values) for values in coordinates]
        expected = getattr(hashnoise, name)(*coordinates, seed=9, **options)
        found = numpy.asarray(getattr(hashnoise.arrays, name)(*map(self.made, coordinates), seed=9, **options))
        self.assertEqual((found.dtype, found.shape), (expected.dtype, expected.shape))
        if options["arithmetic"] == "fixed":
            self.assertEqual(found.tobytes(), expected.tobytes())
        elif name in hashnoise.fractals(axes):  # whose positions C++ may fuse in fast floats
            expected = getattr(hashnoise, name)(*coordinates, seed=9, **{**options, "arithmetic": "precise"})
            self.assertLess(numpy.abs(found - expected).max(), 1e-5)
        else:
            bounds = [golden.bound(golden.Golden(name + "_phase" * ("phase" in options), name, axes, {}, {}), column)
                      for column in ("value", "dx") if column == "value" or name.endswith("_d")]
            self.assertLessEqual(numpy.abs(found - expected).max(), 2 * max(bounds))

    def test_bits(self):
        for name, axes in self.functions:
            with self.subTest(name, axes=axes):
                self.compare(name, axes, arithmetic="fixed")

    def check_slopes(self, slopes: Callable, functions: Iterable[tuple[str, int]], count: int) -> None:
        """By differentiation they are those of the functions that compute them."""
        for name, axes in functions:
            with self.subTest(name, axes=axes):
                def sum_of(*arrays):
                    values = getattr(hashnoise.arrays, name)(*arrays, seed=9)
                    return (values[0] if name == "cellular" else values).sum()

                coordinates = places(axes, count)
                expected = getattr(hashnoise, f"{name}_d")(*coordinates, seed=9)[1:]
                found = numpy.stack(slopes(sum_of, [*map(self.made, coordinates)]))
                # The slope of cellular noise jumps where two points are as near.
                wrong = numpy.abs(found - expected) > (2e-3 if name == "fbm" else 1e-5)
                self.assertLessEqual(wrong.sum(), count // 5000 if name == "cellular" else 0)

    def of_page(self, word: str) -> dict:
        blocks = documents_test.FENCE.findall(documents_test.PAGE.read_text(encoding="utf-8"))
        block, = (block for block in blocks if f"import {word}\n" in block)
        return documents_test.run(block)


class Numpy(Library, unittest.TestCase):
    functions = FUNCTIONS[:1]  # the rest is below

    def test_every_form(self):
        for name, axes in FUNCTIONS:
            for options in forms(name, axes):
                for arithmetic in ("fixed", "fast"):
                    with self.subTest(name, axes=axes, arithmetic=arithmetic, **options):
                        self.compare(name, axes, arithmetic=arithmetic, **options)

    def test_another_bit_is_noticed(self):
        with self.assertRaises(AssertionError), unittest.mock.patch.object(
                hashnoise.arrays, "perlin", lambda *_, **options: hashnoise.perlin(*places(2), seed=8)):
            self.compare("perlin", 2, arithmetic="fixed")

    def test_arrays_as_settings(self):
        x = places(1)[0]
        settings = {"gain": numpy.linspace(0, 1, x.size), "seed": numpy.arange(x.size) + 2**32 - 9}
        found = hashnoise.arrays.fbm(x, **settings, arithmetic="fixed")
        self.assertEqual([hashnoise.fbm(at, gain=gain, seed=seed % 2**32, arithmetic="fixed")
                          for at, gain, seed in zip(x, *settings.values())], found.tolist())

    def test_kinds_of_arrays(self):
        x = places(1)[0]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for array in (x.astype(float) + 1e-12, x.reshape(5, 8)[:, None], numpy.arange(9), numpy.array(0.5),
                          numpy.array([0.5, numpy.nan, numpy.inf])):
                for arithmetic, most in (("fixed", 0), ("fast", 1e-6)):
                    numpy.testing.assert_allclose(hashnoise.arrays.perlin(array, 0.25, arithmetic=arithmetic),
                                                  hashnoise.perlin(array, 0.25, arithmetic=arithmetic), 0, most)
        points = numpy.stack(places(3), axis=-1)
        for options in ({}, {"cell": numpy.floor(points).astype(int)}):
            inside = points - numpy.floor(points)
            numpy.testing.assert_array_equal(hashnoise.arrays.value(points=inside, arithmetic="fixed", **options),
                                             hashnoise.value(points=inside, arithmetic="fixed", **options))

    def test_bad_input(self):
        x, points = numpy.linspace(0, 1, 9), numpy.zeros((9, 3))
        other = types.SimpleNamespace(dtype="float32", ndim=1, __array_namespace__=lambda: types.ModuleType("other"))
        for kind, arguments, options, printed in (
                (TypeError, (0.5,), {}, "x must be an array, of PyTorch, JAX, CuPy or NumPy; of numbers alone hashnoise.fbm"),
                (TypeError, (), {}, "x is missing"), (TypeError, (x * 1j,), {}, "x must be of real numbers, not of complex128"),
                (TypeError, (x,), {"seed": x}, "seed must be of whole numbers, not of float64"),
                (TypeError, (x,), {"out": x}, "there is no option out"),
                (ValueError, (points,), {}, r"may have points.* arrays.fbm\(points=x\)"),
                (ValueError, (), {"points": x}, r"as in shape \(N, 3\), not the shape \(9,\)"),
                (TypeError, (), {"points": [[1, 2]]}, "points must be an array, not list"),
                (ValueError, (x,), {"arithmetic": "precise"}, "arithmetic must be one of fast, fixed; not 'precise'"),
                (ValueError, (x,), {"octaves": 40}, "octaves must be from 1 to 32, not 40"),
                (ValueError, (x,), {"noise": "perlim"}, "did you mean perlin"),
                (ValueError, (x,), {"gain": numpy.nan}, "gain must be finite"),
                (ValueError, (x,), {"detail": 2, "cell": 1}, "detail and footprint need positions"),
                (TypeError, (x, other), {}, "arrays of numpy and other do not go together")):
            with self.subTest(printed), self.assertRaisesRegex(kind, printed):
                hashnoise.arrays.fbm(*arguments, **options)

    def test_help_and_names(self):
        self.assertEqual({*hashnoise.arrays.__all__}, {*hashnoise.__all__} - {
            "components", "fractals", "grid", "instruction_sets", "noises"})
        for name in hashnoise.arrays.__all__:
            function, usual = getattr(hashnoise.arrays, name), getattr(hashnoise, name)
            self.assertEqual(function.__doc__.partition("\n")[0], usual.__doc__.partition("\n")[0])
            self.assertIn("help(hashnoise.arrays)", function.__doc__)
            self.assertEqual({**usual.__kwdefaults__, **function.__kwdefaults__}, usual.__kwdefaults__)


class Jax(Library, unittest.TestCase):
    functions = [*dict(reversed(FUNCTIONS)).items()]  # each in its least dimensions, which take the least time

    def setUp(self):
        self.made = importlib.import_module("jax.numpy").asarray

    def test_compiled(self):
        import jax
        coordinates = places(2)
        for name in ("perlin", "cellular"):
            function = functools.partial(getattr(hashnoise.arrays, name), seed=9, arithmetic="fixed")
            expected = getattr(hashnoise, name)(*coordinates, seed=9, arithmetic="fixed")
            self.assertEqual(jax.jit(jax.vmap(function, out_axes=-1))(*coordinates).tolist(), expected.tolist())
        far = [self.made(50 * values) for values in places(3)]  # where a position that XLA fuses would be another
        self.assertLess(abs(jax.jit(hashnoise.arrays.fbm)(*far) - hashnoise.arrays.fbm(*far)).max(), 3e-7)

    def test_slopes(self):
        import jax
        self.check_slopes(lambda function, arrays: jax.grad(function, tuple(range(len(arrays))))(*arrays),
                          (("perlin", 2), ("simplex", 3)), 400)
        fixed = jax.grad(lambda x: hashnoise.arrays.perlin(x, 0.25, arithmetic="fixed"))
        self.assertEqual(fixed(0.375), 0)
        x = self.made(0.375)
        self.assertEqual(jax.grad(lambda phase: hashnoise.arrays.perlin(x, 0.25, phase=phase))(0.3), 0)

    def test_page(self):
        fitted = self.of_page("jax")
        self.assertLess(fitted["value"], 1e-4)
        self.assertLess(numpy.abs(fitted["settings"] - numpy.array([2.0, 0.4, 0.3])).max(), 0.05)


class Torch(Library, unittest.TestCase):
    functions = FUNCTIONS

    def setUp(self):
        self.made = importlib.import_module("torch").from_numpy

    def test_compiled(self):
        import torch
        for name, axes in (("perlin", 2), ("fbm", 1)):
            coordinates = places(axes)
            function = torch.compile(functools.partial(getattr(hashnoise.arrays, name), seed=9, arithmetic="fixed"))
            expected = getattr(hashnoise, name)(*coordinates, seed=9, arithmetic="fixed")
            self.assertEqual(function(*map(self.made, coordinates)).numpy().tobytes(), expected.tobytes())

    def test_slopes(self):
        import torch

        def slopes(function, arrays):
            arrays = [array.requires_grad_() for array in arrays]
            return [slope.numpy() for slope in torch.autograd.grad(function(*arrays), arrays)]

        self.check_slopes(slopes, [(name, axes) for name in ("perlin", "value", "simplex", "cellular", "fbm")
                                   for axes in (2, 3)], 100_000)
        x = torch.zeros(3, requires_grad=True)
        self.assertFalse(hashnoise.arrays.perlin(x, 0.25, arithmetic="fixed").requires_grad)

    def test_mixed_kinds(self):
        x = numpy.zeros(3, numpy.float32)
        with self.assertRaisesRegex(TypeError, "^arrays.perlin: arrays of numpy and torch do not go together"):
            hashnoise.arrays.perlin(x, self.made(x))

    def test_page(self):
        names = self.of_page("torch")
        x = names["x"].numpy()
        self.assertLess(numpy.abs(names["heights"].numpy() - hashnoise.fbm(x, x[:, None], octaves=6, seed=7)).max(), 1e-4)
        self.assertEqual(names["slopes"].shape, (1000, 3))
