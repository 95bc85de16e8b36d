"""Options, and messages for wrong ones: the fault, its place, and the right values."""

from __future__ import annotations

import inspect
import pickle
import re
import unittest

import golden
import hashnoise
import numpy

X = numpy.linspace(0, 9, 100, dtype=numpy.float32)
EXACT = ("random",)  # the same numbers with every arithmetic
SETS = hashnoise.instruction_sets()
OF_SHAPES = {"perlin_d": "simplex_d", "value_vector": "perlin_vector"}  # noises that a fractal may take in place of one


class Options(unittest.TestCase):
    def test_version_is_that_of_the_shaders(self):
        text = (golden.ROOT / "glsl" / "hashnoise" / "config.glsl").read_text(encoding="ascii")
        numbers = re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text, re.M)
        self.assertEqual(hashnoise.__version__, ".".join(numbers))

    def test_every_name_is_a_function(self):
        names = {name for axes in range(1, 5) for name in hashnoise.noises(axes) + hashnoise.fractals(axes)}
        others = {"components", "fractals", "grid", "instruction_sets", "noises"}
        self.assertEqual(set(hashnoise.__all__), names | others)
        for axes in range(1, 5):
            for name in names:
                with self.subTest(name, axes=axes):
                    if name in hashnoise.noises(axes) + hashnoise.fractals(axes):
                        getattr(hashnoise, name)(*[X] * axes)
                    else:
                        with self.assertRaises((TypeError, ValueError)):
                            getattr(hashnoise, name)(*[X] * axes)

    def test_each_option_counts(self):
        """An option that differs from its default changes the values."""
        changed = {"seed": 5, "period": 3, "wave": (2.5, -1.5), "bandwidth": 0.5, "phase": 0.25, "jitter": 0.5,
                   "metric": "manhattan", "noise": "simplex",
                   "octaves": 3, "lacunarity": 3.0, "gain": 0.25, "strength": 0.5, "amplitude": 0.5, "detail": 2.5,
                   "footprint": 0.25, "arithmetic": "fixed", "cell": (3, 4)}
        same = {"points", "out", "threads", "instruction_set"}
        for name in hashnoise.noises(2) + hashnoise.fractals(2):
            function = getattr(hashnoise, name)
            for option in function.__kwdefaults__:
                if option in same or (option == "arithmetic" and name in EXACT):
                    continue
                value = changed[option]
                if option == "noise":
                    value = OF_SHAPES.get(function.__kwdefaults__["noise"], value)
                with self.subTest(name, option=option):
                    x, y = (X % 1, X[::-1] % 1) if option == "cell" else (X, X[::-1])
                    self.assert_other(function(x, y, **{option: value}), function(x, y))
                    grid = {"name": name, "size": (40, 30), "step": 0.17, "origin": 0.05}
                    self.assert_other(hashnoise.grid(**grid, **{option: value}), hashnoise.grid(**grid))

    def test_each_option_counts_of_what_is_in_space_alone(self):
        usual = hashnoise.perlin_worley(X, X[::-1], 0.5)
        for option, value in {"seed": 5, "octaves": 3, "lacunarity": 3.0, "gain": 0.25, "period": 3}.items():
            with self.subTest(option):
                self.assert_other(hashnoise.perlin_worley(X, X[::-1], 0.5, **{option: value}), usual)

    def assert_other(self, values, others):
        self.assertEqual(values.shape, others.shape)
        self.assertFalse((values == others).all())

    def test_default_options(self):
        """Defaults in signatures are the library's."""
        self.assertEqual(hashnoise.fbm(X, seed=0, octaves=6, lacunarity=2.0, gain=0.5, noise="perlin").tobytes(),
                         hashnoise.fbm(X).tobytes())
        self.assertEqual(hashnoise.warp(X, X, noise="value_vector").tobytes(), hashnoise.warp(X, X).tobytes())
        for name in hashnoise.fractals(3):
            function = getattr(hashnoise, name)
            none = dict.fromkeys(option for option in function.__kwdefaults__ if option != "arithmetic")
            self.assertEqual(function(X, X, X, **none).tobytes(), function(X, X, X).tobytes(), name)
            self.assertEqual(hashnoise.grid(name, (9, 9, 9), step=0.1, noise=None).tobytes(),
                             hashnoise.grid(name, (9, 9, 9), step=0.1).tobytes(), name)
        self.assertEqual(hashnoise.phasor(X, X, X, wave=(3, 0, 0), phase=0.0).tobytes(),
                         hashnoise.phasor(X, X, X).tobytes())

    def test_kinds_of_numbers(self):
        for seed in (numpy.uint32(7), numpy.int64(7), True + 6):
            self.assertEqual(hashnoise.perlin(X, seed=seed).tobytes(), hashnoise.perlin(X, seed=7).tobytes())
        self.assertEqual(hashnoise.fbm(X, gain=numpy.float32(0.25)).tobytes(), hashnoise.fbm(X, gain=0.25).tobytes())
        self.assertEqual(hashnoise.fbm(X, X, period=numpy.array([3, 5])).tobytes(),
                         hashnoise.fbm(X, X, period=(3, 5)).tobytes())
        self.assertEqual(hashnoise.fbm(X, X, period=[4, 4]).tobytes(), hashnoise.fbm(X, X, period=4).tobytes())
        hashnoise.perlin(X, seed=2**32 - 1)
        for cell in (3, numpy.int8(3), numpy.array(3)):
            self.assertEqual(hashnoise.fbm(X % 1, X % 1, cell=cell).tobytes(),
                             hashnoise.fbm(X % 1, X % 1, cell=(3, 3)).tobytes())
        for wave in ([2, -1], numpy.array([2, -1]), numpy.array([2, -1], numpy.float32), (numpy.float64(2), -1)):
            self.assertEqual(hashnoise.phasor(X, X, wave=wave).tobytes(),
                             hashnoise.phasor(X, X, wave=(2.0, -1.0)).tobytes())

    def test_names_of_planes(self):
        self.assertEqual(hashnoise.components("cellular_three", 3), ("f1", "f2", "f3"))
        self.assertEqual(hashnoise.components("simplex_d", 4), ("value", "dx", "dy", "dz", "dw"))
        self.assertEqual(hashnoise.components("warp", 2, noise="perlin_vector"), ("x", "y"))
        self.assertEqual(hashnoise.components("eroded", 2), ("value",))
        self.assertEqual(hashnoise.components("phasor", 3), ("value", "quadrature"))

    def test_instruction_sets(self):
        sets = hashnoise.instruction_sets()
        self.assertLessEqual(set(sets), {"sse4.1", "avx2", "avx512", "neon", "generic"})
        self.assertNotEqual(sets, ())
        for name in sets:
            hashnoise.perlin(X, instruction_set=name)

    def test_ends_of_ranges(self):
        """Options beyond them are wrong; these are right."""
        for options in ({"octaves": 1}, {"octaves": 32}, {"period": 0}, {"period": 2**31 - 1}, {"seed": 2**32 - 1},
                        {"cell": (-2**31, 2**31 - 1)}, {"cell": (numpy.array([2**31 - 1], numpy.uint32), 0)},
                        {"cell": (numpy.array([], numpy.int64), 0)}, {"detail": 0}, {"detail": 32}):
            with self.subTest(options):
                hashnoise.fbm(0.5, 0.5, **options)
        hashnoise.grid("perlin", (3, 4), step=0.1, cell=(-2**31, 2**31 - 1))
        self.assertEqual(*(hashnoise.grid("perlin", 1, first=2**28, step=step, cell=0) for step in (2**-33, 2**-32)))
        hashnoise.grid("perlin", 3, step=0, cell=0)


class Wrong(unittest.TestCase):
    def assert_told(self, kind, said, call):
        with self.assertRaisesRegex(kind, said) as caught:
            call()
        self.assertIs(type(caught.exception), kind)

    def test_options(self):
        for kind, options, said in (
                (ValueError, {"seed": -1}, "seed must be from 0 to 4294967295, not -1"),
                (ValueError, {"seed": 2**32}, "seed must be from 0 to 4294967295, not 4294967296"),
                (TypeError, {"seed": 1.5}, r"seed must be a whole number, not 1.5 \(float\)"),
                (TypeError, {"seed": "7"}, r"seed must be a whole number, not '7' \(str\)"),
                (TypeError, {"seed": True}, r"seed must be a whole number, not True \(bool\)"),
                (TypeError, {"octaves": numpy.True_}, "octaves must be a whole number, not "),
                (TypeError, {"gain": True}, r"gain must be a number, not True \(bool\)"),
                (TypeError, {"gain": numpy.True_}, "gain must be a number, not "),
                (TypeError, {"gain": numpy.array([0.5])}, r"gain must be a number, not array\(\[0.5\]\)"),
                (TypeError, {"gain": [[1], [1, 2]]}, "gain must be a number, not "),
                (TypeError, {"gain": [0.5]}, r"gain must be a number, not \[0.5\]"),
                (ValueError, {"period": (1, 2, 3)}, r"period must have a value for each of the 2 axes"),
                (TypeError, {"period": (1, 0.5)}, r"period must be a whole number, not 0.5"),
                (ValueError, {"period": 2**31}, "period must be from 0 to 2147483647, not 2147483648"),
                (ValueError, {"period": -1}, "period must be from 0 to 2147483647, not -1"),
                (ValueError, {"period": (4, -2**31)}, "period must be from 0 to 2147483647, not -2147483648"),
                (ValueError, {"arithmetic": "exact"}, "arithmetic must be one of fast, precise, fixed; not 'exact'"),
                (ValueError, {"threads": 0}, "threads must be from 1 to 1024, not 0"),
                (TypeError, {"threads": 1.5}, "threads must be a whole number"),
                (ValueError, {"instruction_set": "mmx"}, "instruction_set must be one of this processor's, .*; not 'mmx'"),
                (ValueError, {"instruction_set": SETS[0] + "x"}, f"did you mean {re.escape(SETS[0])}"),
                (TypeError, {"octaves": 2.5}, "octaves must be a whole number, not 2.5"),
                (ValueError, {"octaves": 0}, "octaves must be from 1 to 32, not 0"),
                (ValueError, {"octaves": -1}, "octaves must be from 1 to 32, not -1"),
                (ValueError, {"octaves": 33}, "octaves must be from 1 to 32, not 33"),
                (ValueError, {"octaves": 2**70}, "octaves must be from 1 to 32, not 1180591620717411303424"),
                (ValueError, {"gain": -0.5}, "gain is -0.5, and has to be a finite number of 0 or more"),
                (ValueError, {"detail": 33}, "detail is 33, and has to be from 0 to 32"),
                (ValueError, {"detail": 2.5, "octaves": 6}, "detail stands in place of octaves"),
                (ValueError, {"footprint": -1}, "footprint is -1, and has to be a finite number of 0 or more"),
                (TypeError, {"gain": "0.5"}, "gain must be a number, not '0.5'"),
                (TypeError, {"gain": X}, "gain must be a number, not array"),
                (ValueError, {"gain": float("nan")}, "gain must be finite, not nan"),
                (ValueError, {"lacunarity": float("inf")}, "lacunarity must be finite, not inf"),
                (TypeError, {"noise": 3}, "noise must be a name, not 3"),
                (ValueError, {"noise": ""}, "noise must be a name, not ''; leave it out"),
                (ValueError, {"noise": "no_such"}, "no_such"),
                (ValueError, {"noise": "perlim"},
                 r'there is no noise "perlim" in 2D \(did you mean perlin\?\); there are: perlin, '),
                (ValueError, {"arithmetic": "fixde"}, r"not 'fixde' \(str\) \(did you mean fixed\?\)"),
                (ValueError, {"noise": "perlin_d"}, "perlin"),
                (ValueError, {"gain": 1e39}, r"gain must be at most 3.4e38, as a float32 is, not 1e\+39"),
                (ValueError, {"detail": 2.0, "period": 4}, "detail"),
                # The compiled part has more of these.
                (ValueError, {"lacunarity": 1e30, "octaves": 32}, r"lacunarity is 1e\+30, and with 32 octaves"),
                (ValueError, {"lacunarity": 2.5, "period": 4}, "lacunarity is 2.5, and has to be a whole number"),
                (ValueError, {"gain": 1.5, "arithmetic": "fixed"}, "gain is 1.5, and has to be from 0 to 1 with fixed"),
                (ValueError, {"cell": (3,)}, "cell must be a whole number, or a tuple of 2: the cells along x, y"),
                (ValueError, {"cell": 2**31}, "cell must be from -2147483648 to 2147483647, not 2147483648"),
                (TypeError, {"cell": 0.5}, "the cells along x must be whole numbers, not float64"),
                (TypeError, {"cell": "3"}, "the cells along x must be whole numbers, not <U1"),
                (ValueError, {"cell": (2**31, 1)}, "cell must be from -2147483648 to 2147483647, not 2147483648"),
                (ValueError, {"cell": (1, -2**31 - 1)}, "cell must be from -2147483648 to 2147483647, not -2147483649"),
                (ValueError, {"cell": (2**70, 1)}, "cell must be from -2147483648 to 2147483647, not 11805916207"),
                (ValueError, {"cell": (1, numpy.array([-5, 2**31]))},
                 "the cells along y must be from -2147483648 to 2147483647, and are from -5 to 2147483648"),
                (ValueError, {"cell": (numpy.array([2**64 - 1], numpy.uint64), 1)}, "the cells along x must be from"),
                (ValueError, {"cell": (numpy.uint32(2**31), 1)}, "the cells along x must be from"),
                (TypeError, {"cell": (0.5, 1)}, "the cells along x must be whole numbers, not float64")):
            with self.subTest(options):
                self.assert_told(kind, f"^fbm: (?!fbm).*{said}", lambda: hashnoise.fbm(X, X, **options))

    def test_waves(self):
        for kind, wave, said in (
                (TypeError, 2.5, r"wave must be a number for each of the 2 axes, as in \(2.5, 1.5\), not 2.5"),
                (TypeError, "xy", r"wave must be a number for each of the 2 axes, as in .*, not 'xy' \(str\)"),
                (ValueError, (), r"wave must have a number for each of the 2 axes, not 0; it is \(\)"),
                (ValueError, (2.5,), "wave must have a number for each of the 2 axes, not 1"),
                (ValueError, [2.5, 1.5, 0], "wave must have a number for each of the 2 axes, not 3"),
                (TypeError, (2.5, "1"), "wave must be a number, not '1'"),
                (ValueError, (2.5, float("nan")), "wave must be finite, not nan"),
                (ValueError, (2.5, float("-inf")), "wave must be finite, not -inf"),
                (ValueError, (2.5, 16.25), "wave is 16.25, and has to be from -16 to 16"),
                (ValueError, (-1e300, 0), r"wave must be at most 3.4e38, as a float32 is, not -1e\+300")):
            with self.subTest(wave=wave):
                self.assert_told(kind, f"^phasor: .*{said}", lambda: hashnoise.phasor(X, X, wave=wave))
                self.assert_told(kind, f"^grid: .*{said}",
                                 lambda: hashnoise.grid("phasor", (9, 9), step=0.1, wave=wave))
        self.assert_told(TypeError, "^grid: fbm has no option wave",
                         lambda: hashnoise.grid("fbm", 9, step=0.1, wave=(1,)))
        self.assert_told(TypeError, "^grid: perlin_worley has no option noise",
                         lambda: hashnoise.grid("perlin_worley", (9, 9, 9), step=0.1, noise="value"))

    def test_options_that_there_are_not(self):
        said = r"there is no option octave \(did you mean octaves\?\)$"
        self.assert_told(TypeError, f"^fbm: {said}", lambda: hashnoise.fbm(X, octave=3))
        self.assert_told(TypeError, f"^grid: {said}", lambda: hashnoise.grid("fbm", 9, step=0.1, octave=3))
        self.assert_told(TypeError, "did you mean dtype", lambda: hashnoise.grid("fbm", 9, step=0.1, dtpye="uint16"))
        self.assert_told(TypeError, "did you mean step", lambda: hashnoise.grid("fbm", 9, stp=0.1))
        self.assert_told(TypeError, "did you mean noise", lambda: hashnoise.components("warp", 2, niose="value"))
        self.assert_told(TypeError, "^value: there is no option no_such; the options are points, seed, period, cell, "
                                    "arithmetic, out, threads, instruction_set$", lambda: hashnoise.value(X, no_such=3))
        self.assert_told(TypeError, "^grid: fbm has no option wave; phasor has that$",
                         lambda: hashnoise.grid("fbm", 9, step=0.1, wave=[3]))
        self.assert_told(ValueError, "phase", lambda: hashnoise.perlin(X, phase=0.5))

    def test_options_of_other_libraries(self):
        for option, of_points, of_grids in (
                ("frequency", "multiply the coordinates by the frequency", "step is the frequency"),
                ("scale", "divide the coordinates by the scale, .*; if you multiply by it, multiply$",
                 "step is 1 / scale, .*; if you multiply by it, step is the scale$"),
                ("persistence", "gain is the persistence, of fractals such as fbm", "gain is the persistence"),
                ("fractal_type", "the fractals are functions, such as fbm", "the first argument names the fractal"),
                ("noise_type", "the noises are functions", "the first argument names the noise"),
                ("distance_function", "metric is the distance function", "metric is"),
                ("cellular_jitter", "jitter is that, of cellular noises", "jitter is"),
                ("ping_pong_strength", "strength is that, of the functions ping_pong", "strength is"),
                ("domain_warp_amp", "amplitude is that in cells", "amplitude is"),
                ("tileable", "period is after how many cells the field repeats", "period is after"),
                ("offset", "add the offset to the coordinates", "origin is the first point, in cells"),
                ("start", "the coordinates begin where", r"first is the number of the first point \(did you mean first"),
                ("base", "seed takes the place of the base", "seed takes the place"),
                ("repeaty", "period is after how many cells the field repeats", "period is after"),
                ("x", "coordinates have no names: pass them first", "size, step and origin set the coordinates"),
                ("shape", "the result has the shape of the coordinates", r"size is \(width, height\)")):
            with self.subTest(option):
                said = f"there is no option {option}; "
                self.assert_told(TypeError, said + of_points, lambda: hashnoise.fbm(X, **{option: 4}))
                self.assert_told(TypeError, said + of_points, lambda: hashnoise.perlin(X, **{option: 4}))
                self.assert_told(TypeError, said + of_grids, lambda: hashnoise.grid("fbm", 9, **{option: 4}))
                self.assert_told(TypeError, said + of_grids, lambda: hashnoise.grid("fbm", 9, step=1, **{option: 4}))

    def test_options_of_other_functions(self):
        for option, said in (("octaves", "fractals such as fbm have that, over any noise"),
                             ("strength", "ping_pong, weighted and eroded have that"),
                             ("amplitude", "warp and warp_progressive have that"),
                             ("jitter", "cellular, cellular_three, cellular_d, cellular_smooth and cell_border have that"),
                             ("metric", "cellular and cellular_three have ")):
            with self.subTest(option):
                self.assert_told(TypeError, f"^perlin: there is no option {option}; {said}",
                                 lambda: hashnoise.perlin(X, **{option: 1}))
                self.assert_told(TypeError, f"^grid: perlin has no option {option}; {said}",
                                 lambda: hashnoise.grid("perlin", 9, step=0.1, **{option: 1}))

    def test_names_of_other_libraries(self):
        for names, meant in ((("pnoise2", "cnoise", "PerlinNoise"), r" \(here it is perlin\)"),
                             (("snoise2", "snoise4", "noise2", "noise3", "OpenSimplex"), r" \(here it is simplex\)"),
                             (("worley", "Voronoi"), r" \(here it is cellular\)"),
                             (("FBM", "HN_FBM"), r" \(did you mean fbm\?\)")):
            for name in names:
                with self.subTest(name):
                    self.assert_told(AttributeError, f"{meant}$", lambda: getattr(hashnoise, name))
                    self.assert_told(ValueError, f"there is no function '{name}'{meant}",
                                     lambda: hashnoise.grid(name, 9, step=0.1))
        self.assert_told(AttributeError, r" \(here it is grid\)$", lambda: hashnoise.noise2array)
        self.assert_told(AttributeError, "; call a function such as fbm", lambda: hashnoise.FastNoiseLite)
        for noise, said in (("OpenSimplex2S", r"there is no noise .* \(here it is simplex_smooth\); there are"),
                            ("worley", r'there is no noise "worley" in 2D; there are: perlin, '),
                            ("OpenSimplex2", r'there is no noise "OpenSimplex2" in 2D \(here it is simplex\); there are'),
                            ("PERLIN", r'there is no noise "PERLIN" in 2D \(did you mean perlin\?\); there are'),
                            ("None", "noise must be a name, not 'None'; leave it out for the usual one")):
            self.assert_told(ValueError, f"^fbm: {said}", lambda: hashnoise.fbm(X, X, noise=noise))

    def test_functions_that_there_are_not(self):
        for name, said in (("hn_fbm", r" \(did you mean fbm\?\)"), ("fmb", r" \(did you mean fbm\?\)"),
                           ("hn_perlim", r" \(did you mean perlin\?\)"), ("dask", "; import hashnoise.dask"),
                           ("hn_cellular_phase", "; cellular has the option phase"),
                           ("gird", r" \(did you mean grid\?\)"), ("no_such_function", "")):
            with self.subTest(name):
                self.assert_told(AttributeError, f"^module 'hashnoise' has no attribute '{name}'{said}$",
                                 lambda: getattr(hashnoise, name))
        self.assertFalse(hasattr(hashnoise, "__wrapped__"))
        with self.assertRaisesRegex(ImportError, "cannot import name 'fmb'"):
            from hashnoise import fmb  # noqa: F401

    def test_functions_are_themselves_elsewhere(self):
        """A wrapper that names the nearest option stands around each function; functions can still be pickled."""
        for name in hashnoise.__all__:
            function = getattr(hashnoise, name)
            self.assertIs(pickle.loads(pickle.dumps(function)), function)
        self.assertIn("lacunarity=2.0", str(inspect.signature(hashnoise.fbm)))
        self.assertEqual(hashnoise.fbm.__name__, "fbm")

    def test_coordinates(self):
        for kind, coordinates, said in (
                (TypeError, (), "^perlin: x is missing, .* of points .*, pass points="),
                (TypeError, (X, None, X), "^perlin: y is left out, but a later coordinate is not"),
                (TypeError, (None,), "^perlin: x is missing"),
                (TypeError, ("a",), "^perlin: x must be a number or an array of numbers"),
                (TypeError, (X, 1j), "^perlin: y must be a number or an array of numbers, not of complex128"),
                (ValueError, (X, [[1], [1, 2]]), "^perlin: y makes no array"),
                (ValueError, (X, X[:5]),
                 r"^perlin: the coordinates have shapes that do not go together: \(100,\), \(5,\)"),
                (TypeError, (X, X, X, X, X), "positional arguments")):
            with self.subTest(coordinates):
                self.assert_told(kind, said, lambda: hashnoise.perlin(*coordinates))
        self.assert_told(TypeError, "^simplex: y is missing, ", lambda: hashnoise.simplex(X))
        self.assert_told(ValueError, "do not go together", lambda: hashnoise.perlin(X, cell=(numpy.arange(5),)))

    def test_an_array_that_may_have_points_is_none_of_numbers(self):
        """An error has the right calls, and these have the values of each point alone."""
        random = numpy.random.default_rng(3)
        three, two = random.uniform(-9, 9, (5, 3)), random.uniform(0, 9, (6, 2))
        ask = r"has the shape .*, and may have points, or numbers on a line\. Of points pass "
        line = r", and of numbers on a line fbm\(points=x\[\.\.\., numpy\.newaxis\]\)$"
        for x, calls in ((three, r"fbm\(points=x\)"), (three.tolist(), r"fbm\(points=x\)"), (three.T, r"fbm\(\*x\)"),
                         (two, r"fbm\(points=x\)"), (two[:2], r"fbm\(points=x\) or fbm\(\*x\)"),
                         (three[:1], r"fbm\(points=x\)"), (three[:0], r"fbm\(points=x\)"), ([*three.T], r"fbm\(\*x\)"),
                         (numpy.zeros((9, 9, 4)), r"fbm\(points=x\)"), (numpy.mgrid[:9, :9], r"fbm\(\*x\)"),
                         (numpy.ma.array(three, mask=three > 5), r"fbm\(points=x\)")):
            with self.subTest(numpy.shape(x)):
                self.assert_told(ValueError, f"^fbm: x {ask}{calls}{line}", lambda: hashnoise.fbm(x))
        self.assert_told(TypeError, "^simplex: y is missing, .* pass points=", lambda: hashnoise.simplex(two))
        self.assert_told(ValueError, f"^fbm: cell {ask}", lambda: hashnoise.fbm(0.5, cell=numpy.ones((5, 3), int)))
        for x in (X, numpy.zeros((30, 40)), numpy.zeros((9, 2, 9)), numpy.zeros((1, 1)), numpy.zeros(3), [0.5, 0.25]):
            self.assertEqual(hashnoise.fbm(x).shape, numpy.shape(x))  # which are not in doubt
        self.assertEqual(hashnoise.fbm(two, 0.5).shape, (6, 2))
        for cells in (numpy.ones((2, 2), int), [[1, 2], [3, 4]]):
            self.assert_told(ValueError, "^fbm: cell has 2 rows of 2 numbers, .* pass cell=tuple.cell., and of points",
                             lambda: hashnoise.fbm(0.5, 0.5, cell=cells))
            hashnoise.fbm(0.5, 0.5, cell=tuple(cells))

    def test_points(self):
        for kind, arguments, options, said in (
                (TypeError, (0.5,), {"points": [0.5]}, "pass coordinates or points, not both"),
                (ValueError, (), {"points": 0.5}, r"the last axis, as in shape \(N, 3\), not the shape \(\)$"),
                (ValueError, (), {"points": X}, r"not the shape \(100,\)$"),
                (ValueError, (), {"points": numpy.zeros((3, 9))}, r"\(3, 9\); .* along the first: perlin\(\*points\)$"),
                (ValueError, (), {"points": numpy.zeros((100, 5))}, r"not the shape \(100, 5\)$"),
                (ValueError, (), {"points": [[1], [1, 2]]}, "points makes no array"),
                (ValueError, (), {"points": "a"}, ""), (TypeError, (), {"points": [[1j, 2]]}, "not of complex128"),
                (ValueError, (), {"points": [[1.5, 0]], "cell": 1}, "must be from 0 to 1; x is 1.5"),
                (ValueError, (), {"points": [[0.5, 0]], "cell": [1, 2, 3]}, r"each of the 2 .* of the shape \(3,\)"),
                (TypeError, (), {"points": [[0.5, 0]], "cell": [[1, 0.5]]}, "must be whole numbers"),
                (TypeError, (), {"points": [[0, 0], [1, 1]], "cell": (X, X)}, r"numpy.stack\(cell, axis=-1\)")):
            with self.subTest(arguments=arguments, **options):
                self.assert_told(kind, f"^perlin: .*{said}", lambda: hashnoise.perlin(*arguments, **options))
        self.assert_told(ValueError, "simplex", lambda: hashnoise.simplex(points=[[0.5], [0.25]]))
        self.assert_told(TypeError, r"^grid: there is no option points; a grid has none; .* hashnoise.fbm\(points=",
                         lambda: hashnoise.grid("fbm", 9, step=1, points=X))

    def test_out(self):
        read_only = numpy.zeros(100, numpy.float32)
        read_only.flags.writeable = False
        for kind, out, said in (
                (TypeError, [0.0], "out must be an array of float32"),
                (ValueError, numpy.zeros(100), r"of the shape \(100,\), not a writeable one of float64"),
                (ValueError, numpy.zeros(100, ">f4"), "not a writeable one of >f4"),
                (ValueError, numpy.zeros(99, "f4"), r"of the shape \(99,\)"),
                (ValueError, numpy.zeros((1, 100), "f4"), r"of the shape \(1, 100\)"),
                (ValueError, read_only, "not a read-only one")):
            with self.subTest(said):
                self.assert_told(kind, f"^perlin: .*{said}", lambda: hashnoise.perlin(X, out=out))
        self.assert_told(ValueError, r"of the shape \(2, 100\)",
                         lambda: hashnoise.perlin_d(X, out=numpy.zeros(100, "f4")))

    def test_grids(self):
        for kind, arguments, said in (
                (ValueError, {"name": "no_such"}, "there is no function 'no_such'; there are perlin, "),
                (ValueError, {"name": 3}, "there is no function 3"),
                (ValueError, {"name": "fbn"}, r"there is no function 'fbn' \(did you mean fbm\?\); there are perlin, "),
                (ValueError, {"name": "Worley"}, r"there is no function 'Worley' \(here it is cellular\)"),
                (ValueError, {"name": "hn_fbm"}, r"there is no function 'hn_fbm' \(did you mean fbm\?\)"),
                (ValueError, {"first": (0, -2**29)}, "first must be from -536870911 to 536870911, not -536870912"),
                (TypeError, {"first": 0.5}, "first must be a whole number"),
                (ValueError, {"first": (1, 2, 3)}, "first must have a value for each of the 2 axes"),
                (ValueError, {"first": (0, 536870908)},
                 "first [+] size must be at most 536870911, and is 536870912 along y"),
                (ValueError, {"dtype": "float64"}, r"dtype must be float32, float16 or uint16, not 'float64' \(str\)"),
                (ValueError, {"dtype": "no_such"}, r"must be float32, float16 or uint16, not 'no_such' \(str\)$"),
                (ValueError, {"dtype": "unit16"}, r"not 'unit16' \(str\) \(did you mean uint16\?\)$"),
                (ValueError, {"dtype": "flaot32"}, r"\(did you mean float32\?\)$"),
                (ValueError, {"dtype": ">f2"}, "dtype must be float32, float16 or uint16, not '>f2'"),
                (ValueError, {"dtype": "float16", "out": numpy.zeros((4, 3), "f4")}, "array of float16 of the shape"),
                (ValueError, {"range": (0, 1)}, "a range .* is for dtype=\"uint16\" alone, not for float32"),
                (TypeError, {"range": 1, "dtype": "uint16"}, r"range must be a pair, \(least, greatest\), not 1"),
                (TypeError, {"range": (0, 1, 2), "dtype": "uint16"}, "range must be a pair"),
                (ValueError, {"range": (1, 1), "dtype": "uint16"}, "range must have a least end below its greatest"),
                (ValueError, {"range": (0, float("inf")), "dtype": "uint16"}, "range must be finite, not inf"),
                (ValueError, {"range": (-1e308, 1e308), "dtype": "uint16"}, "the ends of range are too far apart"),
                (ValueError, {"name": "fbm_d", "dtype": "uint16"},
                 r"fbm_d documents no range of its plane 'dx'; name what .* by range=\(least, greatest\)"),
                (ValueError, {"name": "grid"}, "there is no function 'grid'"),
                (ValueError, {"size": (3, -1)}, "size must be from 0 to 536870911, not -1"),
                (ValueError, {"size": 2**29}, "size must be from 0 to 536870911"),
                (TypeError, {"size": 2.5}, "size must be a whole number"),
                (ValueError, {"size": ()}, "size must have 1 to 4 numbers, not 0"),
                (ValueError, {"size": (1,) * 5}, "size must have 1 to 4 numbers, not 5"),
                (ValueError, {"step": (1, 2, 3)}, "step must have a value for each of the 2 axes"),
                (ValueError, {"step": float("nan")}, "step must be finite"),
                (TypeError, {"step": "a"}, "step must be a number"),
                (ValueError, {"origin": (0.0,)}, "origin must have a value for each of the 2 axes"),
                (TypeError, {"cell": 0.5}, "cell must be a whole number"),
                (ValueError, {"cell": 2**31}, "cell must be from -2147483648 to 2147483647, not 2147483648"),
                (ValueError, {"cell": (0, -2**31 - 1)}, "cell must be from -2147483648 to 2147483647"),
                (ValueError, {"name": "fbm", "octaves": 0}, "octaves must be from 1 to 32, not 0"),
                (TypeError, {"octaves": 3}, "perlin has no option octaves"),
                (ValueError, {"period": -4}, "period must be from 0 to 2147483647, not -4"),
                (ValueError, {"cell": 3, "step": 2.0**31}, "step"),
                (ValueError, {"cell": 3, "step": (0.1, -1e-12)},
                 "steps are rounded to multiples of 2.-32 of a cell, and a step of -1e-12 would be 0"),
                (ValueError, {"cell": 3, "origin": (0.5, 1.5)}, "origin is the fraction in it and must be from 0 to 1"),
                (ValueError, {"step": 1e38, "origin": 3e38}, ""),
                (ValueError, {"origin": 1e39}, "origin must be at most 3.4e38"),
                (ValueError, {"out": numpy.zeros((3, 4), "f4")}, r"of the shape \(4, 3\)")):
            with self.subTest(arguments):
                self.assert_told(kind, f"^grid: .*{said}", lambda: hashnoise.grid(
                    **{"name": "perlin", "size": (3, 4), "step": 0.1, **arguments}))
        self.assert_told(TypeError, "step", lambda: hashnoise.grid("perlin", 3))
        self.assert_told(ValueError, "^grid: noise must be a name, not ''",
                         lambda: hashnoise.grid("fbm", 3, step=0.1, noise=""))

    def test_dimensions(self):
        for ask in (hashnoise.noises, hashnoise.fractals, lambda dimensions: hashnoise.components("perlin", dimensions)):
            self.assert_told(ValueError, "dimensions must be from 1 to 4, not 5", lambda: ask(5))
            self.assert_told(TypeError, "dimensions must be a whole number", lambda: ask("2"))
        self.assert_told(ValueError, "^components: .*cellular", lambda: hashnoise.components("cellular", 4))
