"""Arrays of all kinds: the values are those of float32 arrays that lie in a row, whatever arrays are passed."""

from __future__ import annotations

import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import hashnoise
import numpy

SHAPE = (390, 710)  # more points than are copied at a time


def words(values, least, greatest):
    """The nearest of 65,536 numbers, as `--range` of tools/bake has them."""
    inside = numpy.clip(values.astype(float), least, greatest)
    return numpy.floor((inside - least) / (greatest - least) * 65535 + 0.5).astype(numpy.uint16)


class Arrays(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        self.x, self.y = random.uniform(-50, 50, (2, *SHAPE)).astype(numpy.float32)
        self.values = hashnoise.perlin(self.x, self.y, seed=3)
        self.planes = hashnoise.perlin_d(self.x, self.y, seed=3)

    def assert_same(self, got, expected):
        self.assertEqual((got.dtype, got.shape), (numpy.float32, expected.shape))
        self.assertEqual(got.tobytes(), numpy.ascontiguousarray(expected).tobytes())

    def test_a_result_lies_as_the_coordinates_do(self):
        for name, x, y, is_transposed in (("transposed", self.x.T, self.y.T, True),
                                          ("as in Fortran", *map(numpy.asfortranarray, (self.x, self.y)), True),
                                          ("beside a number", self.x.T, 0.5, True), ("as usual", self.x, self.y, False),
                                          ("one of each", numpy.asfortranarray(self.x), self.y, False)):
            with self.subTest(name):
                values, planes = hashnoise.perlin(x, y, seed=3), hashnoise.perlin_d(x, y, seed=3)
                self.assertEqual(values.flags.f_contiguous, is_transposed)
                self.assertTrue(all(plane.flags.f_contiguous == is_transposed for plane in planes))
                usual = [numpy.ascontiguousarray(coordinate) for coordinate in numpy.broadcast_arrays(x, y)]
                self.assert_same(values, hashnoise.perlin(*usual, seed=3))
                self.assert_same(planes, hashnoise.perlin_d(*usual, seed=3))
        volume = numpy.random.default_rng(5).uniform(-9, 9, (3, 20, 30, 40)).astype(numpy.float32)
        expected = hashnoise.perlin(*volume)
        for order in ((2, 1, 0), (1, 0, 2), (0, 2, 1)):
            self.assert_same(hashnoise.perlin(*(axis.transpose(order) for axis in volume)), expected.transpose(order))

    def test_broadcasting(self):
        random = numpy.random.default_rng(2)
        for shapes in (((130,), (90, 1)), ((90, 1), (130,)), ((90, 130), ()), ((), (90, 130)), ((1,), (130,)),
                       ((1, 1), (90, 130)), ((70, 1, 20), (9, 1)), ((3, 1, 1, 1), (1, 40, 1, 9), (5, 1)),
                       ((2, 1, 1, 1), (1, 3, 1, 1), (1, 1, 50, 1), (1, 1, 1, 70)), ((5000, 1), (3,)), ((0, 1), (5,))):
            with self.subTest(shapes):
                arrays = [random.uniform(-9, 9, shape).astype(numpy.float32) for shape in shapes]
                whole = [numpy.ascontiguousarray(array) for array in numpy.broadcast_arrays(*arrays)]
                self.assert_same(hashnoise.perlin(*arrays), hashnoise.perlin(*whole))
                self.assert_same(hashnoise.perlin_d(*arrays), hashnoise.perlin_d(*whole))

    def test_points(self):
        """Their last axis has the coordinates; of numbers on a line it has one."""
        random = numpy.random.default_rng(6)
        for name in hashnoise.noises(3) + hashnoise.fractals(3):
            function = getattr(hashnoise, name)
            for axes in range(1, 5):
                if name not in hashnoise.noises(axes) + hashnoise.fractals(axes):
                    continue
                for shape in ((), (7,), (axes,), (axes, axes) if axes > 1 else (1,), (7, 3, 6), (0,)):
                    with self.subTest(name, axes=axes, shape=shape):
                        points = random.uniform(0, 1, (*shape, axes)).astype(numpy.float32)
                        cells = random.integers(-2**31, 2**31, (*shape, axes))
                        columns = [points[..., axis].copy() for axis in range(axes)]
                        expected = function(*columns)
                        lists = [points.tolist()] if points.size else []  # of none the axis is not known
                        for same in (points, *lists, points.astype(float), numpy.asfortranarray(points)):
                            self.assertTrue(numpy.array_equal(function(points=same), expected))
                        of_axes = tuple(cells[..., axis] for axis in range(axes))
                        self.assertTrue(numpy.array_equal(function(points=points, cell=cells, arithmetic="fixed"),
                                                          function(*columns, cell=of_axes, arithmetic="fixed")))
        self.assert_same(hashnoise.fbm(points=self.x[..., numpy.newaxis]), hashnoise.fbm(self.x))
        self.assertIs(type(hashnoise.fbm(points=[0.5, 0.25, 0.75])), float)
        self.assertEqual(hashnoise.fbm(points=[0.5, 0.25], cell=3), hashnoise.fbm(0.5, 0.25, cell=3))
        self.assertEqual(hashnoise.fbm(points=[[0.5, 0.25]], cell=(3, 4))[0], hashnoise.fbm(0.5, 0.25, cell=(3, 4)))
        masked = hashnoise.fbm(points=numpy.ma.array([[1.5, 2], [3, 4]], mask=[[True, False], [False, False]]))
        self.assertEqual(masked.mask.tolist(), [True, False])
        self.assertEqual(masked[1], hashnoise.fbm(3, 4))
        points = numpy.stack([self.x, self.y], axis=-1)
        out = numpy.empty(SHAPE, numpy.float32)
        self.assertIs(hashnoise.perlin(points=points, seed=3, out=out), out)
        self.assert_same(out, self.values)
        self.assert_same(hashnoise.perlin_d(points=points, seed=3), self.planes)


class Cells(unittest.TestCase):
    def test_kinds_of_numbers(self):
        """Cells along two axes are broadcast to a plane."""
        cells = numpy.random.default_rng(3).integers(0, 2**31, 600)
        expected = hashnoise.perlin_d(0.5, 0.25, cell=(cells, -cells[:, None]), seed=4)
        for kind in ("i4", "i8", ">i8", "u4", "u8"):
            with self.subTest(kind):
                found = hashnoise.perlin_d(0.5, 0.25, cell=(cells.astype(kind), -cells[:, None]), seed=4)
                self.assertEqual(found.tobytes(), expected.tobytes())
        one = hashnoise.perlin_d(0.5, 0.25, cell=(int(cells[5]), -int(cells[7])), seed=4)
        self.assertEqual(one.tobytes(), expected[:, 7, 5].tobytes())

    def test_near_the_origin_they_are_positions(self):
        x = numpy.arange(-40, 40, 0.25, dtype=numpy.float32)
        cell = numpy.floor(x)
        values = hashnoise.fbm(x - cell, 0.5, cell=(cell.astype(int), -3), arithmetic="fixed")
        self.assertEqual(values.tobytes(), hashnoise.fbm(x, -2.5, arithmetic="fixed").tobytes())

    def test_one_axis_needs_no_tuple(self):
        self.assertEqual(hashnoise.perlin(0.5, cell=7), hashnoise.perlin(0.5, cell=(7,)))
        self.assertEqual(hashnoise.perlin(0.5, cell=[7, 8]).shape, (2,))


class Out(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        self.x, self.y = random.uniform(-50, 50, (2, *SHAPE)).astype(numpy.float32)
        self.planes = hashnoise.perlin_d(self.x, self.y, seed=3)

    def test_strides(self):
        large = numpy.full((3, 800, 1500), 7, numpy.float32)
        for name, cut in (("every second", numpy.s_[10:790:2, 10:1430:2]), ("backwards", numpy.s_[389::-1, 710:0:-1])):
            with self.subTest(name):
                hashnoise.perlin_d(self.x, self.y, seed=3, out=large[(slice(None), *cut)])
                self.assertEqual(large[(slice(None), *cut)].tobytes(), self.planes.tobytes())
                large[(slice(None), *cut)] = 7
                self.assertTrue((large == 7).all(), "something beside it was written")
        pixels = numpy.empty((*SHAPE, 3), numpy.float32)
        hashnoise.perlin_d(self.x, self.y, seed=3, out=pixels.transpose(2, 0, 1))
        self.assertEqual(pixels.transpose(2, 0, 1).tobytes(), self.planes.tobytes())

    def test_it_may_be_a_coordinate(self):
        for name, first, second in (("the same", numpy.s_[:], numpy.s_[:]), ("shifted", numpy.s_[:-1], numpy.s_[1:])):
            with self.subTest(name):
                x = self.x.copy()
                expected = hashnoise.perlin(x[first], self.y[first], seed=3)
                hashnoise.perlin(x[first], self.y[first], seed=3, out=x[second])
                self.assertEqual(x[second].tobytes(), expected.tobytes())

    def test_grids_in_any_order(self):
        for size in ((400, 300), (3, 500), (500, 3), (1, 1), (130,), (40, 30, 20), (9, 8, 7, 6)):
            expected, extent = hashnoise.grid("perlin_d", size, step=0.1, return_range=True)
            large = numpy.full((len(size) + 1, *(2 * n + 3 for n in size[::-1])), 7, numpy.float32)
            cut = (slice(None), *(slice(1, 2 * n + 1, 2) for n in size[::-1]))
            for name, out in (("as usual", numpy.empty(expected.shape, numpy.float32)),
                              ("transposed", numpy.empty(expected.shape[::-1], numpy.float32).T),
                              ("pixels", numpy.moveaxis(numpy.empty((*size[::-1], len(size) + 1), "f4"), -1, 0)),
                              ("backwards", numpy.empty(expected.shape, numpy.float32)[..., ::-1]),
                              ("every second", large[cut]),
                              ("at odd bytes", numpy.zeros(expected.shape, [("kind", "u1"), ("n", "f4")])["n"])):
                for threads in (1, 3):
                    with self.subTest(name, size=size, threads=threads):
                        out[...] = 0
                        found = hashnoise.grid("perlin_d", size, step=0.1, out=out, return_range=True, threads=threads)
                        self.assertIs(found[0], out)
                        self.assertEqual(out.tobytes(), expected.tobytes())
                        self.assertEqual(found[1], extent)
            large[cut] = 7
            self.assertTrue((large == 7).all(), "something beside it was written")
        wrong = numpy.empty((30, 40), numpy.float32).T
        with self.assertRaisesRegex(ValueError, "finite"):
            hashnoise.grid("perlin", (30, 40), step=1e38, origin=3e38, out=wrong, threads=3)


class Grids(unittest.TestCase):
    def test_order_of_the_axes(self):
        """Along x the second axis of a picture runs, and the third of a volume."""
        step = numpy.float32(0.1)
        x, y, z = (numpy.float32(first) + numpy.arange(points) * step.astype(float) for first, points in
                   ((1, 7), (2, 5), (3, 4)))
        self.assertEqual(hashnoise.grid("perlin", 7, step=0.1, origin=1, arithmetic="precise").tobytes(),
                         hashnoise.perlin(x, arithmetic="precise").tobytes())
        self.assertEqual(hashnoise.grid("perlin", (7, 5), step=0.1, origin=(1, 2), arithmetic="precise").tobytes(),
                         hashnoise.perlin(x, y[:, None], arithmetic="precise").tobytes())
        self.assertEqual(hashnoise.grid("perlin_d", (7, 5, 4), step=(0.1, 0.1, 0.1), origin=(1, 2, 3),
                                        arithmetic="precise").tobytes(),
                         hashnoise.perlin_d(x, y[:, None], z[:, None, None], arithmetic="precise").tobytes())

    def test_cells(self):
        near = hashnoise.grid("fbm", (65, 33), step=1 / 16, arithmetic="fixed", cell=(-2, 3), origin=(0.5, 0.25))
        same = hashnoise.grid("fbm", (65, 33), step=1 / 16, arithmetic="fixed", origin=(-1.5, 3.25))
        self.assertEqual(near.tobytes(), same.tobytes())
        far = hashnoise.grid("perlin", (65, 33), step=1 / 16, cell=2**31 - 2)
        self.assertEqual(far[32:, 32:].tobytes(), hashnoise.grid("perlin", (33, 1), step=1 / 16, cell=-2**31).tobytes())
        self.assertGreater(numpy.abs(numpy.diff(far)).min(), 0)

    def test_steps_that_need_no_rounding(self):
        """Such a grid with a cell has the points of tools/bake, i * cells / size, and repeats bit for bit."""
        step, size = 8 / 256, 300
        places = numpy.arange(size) * step + 0.5
        cell = numpy.floor(places).astype(int)
        exact = hashnoise.fbm(places - cell, (places - cell)[:, None], cell=(cell + 5, cell[:, None] - 3), period=8,
                              arithmetic="fixed")
        whole = hashnoise.grid("fbm", (size, size), step=step, origin=0.5, cell=(5, -3), period=8, arithmetic="fixed")
        self.assertEqual(whole.tobytes(), exact.tobytes())
        self.assertEqual(whole[256:, 256:].tobytes(), whole[:44, :44].tobytes())
        rounded = hashnoise.grid("fbm", (size, size), step=8 / 250, period=8, arithmetic="fixed")
        self.assertNotEqual(rounded[250:, 250:].tobytes(), rounded[:50, :50].tobytes())

    def test_parts(self):
        for where in ({"step": 0.0371, "origin": (0.1, -50)}, {"step": 0.01, "cell": (2**31 - 3, -9), "origin": 0.3}):
            for arithmetic in ("fast", "precise", "fixed"):
                for name in ("perlin_d", "fbm"):
                    options = {**where, "arithmetic": arithmetic, "seed": 3}
                    whole = hashnoise.grid(name, (301, 203), **options)
                    for first, size in (((0, 0), (301, 203)), ((37, 101), (64, 50)), ((300, 202), (1, 1)),
                                        ((5, 7), (3, 0))):
                        with self.subTest(name, first=first, **options):
                            part = hashnoise.grid(name, size, first=first, **options)
                            there = (..., *(slice(begin, begin + n) for begin, n in zip(first[::-1], size[::-1])))
                            self.assertEqual(part.shape, whole[there].shape)
                            self.assertEqual(part.tobytes(), whole[there].tobytes())
                    left = hashnoise.grid(name, (21, 12), first=(-20, -11), **options)  # it ends at point 0
                    self.assertEqual(left[..., -1, -1].tobytes(), whole[..., 0, 0].tobytes())
        # Far away, where a step that was added up would be wrong.
        far = hashnoise.grid("perlin", 2, step=0.01, cell=0, first=536870909)
        at = (round(0.01 * 2**32) * 536870909, round(0.01 * 2**32) * 536870910)
        self.assertEqual(far.tolist(), [hashnoise.perlin((n & 0xFFFFFF00) / 2**32, cell=n >> 32) for n in at])

    def test_types(self):
        for dtype in (numpy.float16, "float16", numpy.dtype("f2"), "uint16", numpy.uint16, "H"):
            values = hashnoise.grid("fbm", (301, 203), step=0.05, seed=3)
            found = hashnoise.grid("fbm", (301, 203), step=0.05, seed=3, dtype=dtype)
            self.assertEqual(found.dtype, numpy.dtype(dtype))
            expected = words(values, -1, 1) if found.dtype == numpy.uint16 else values.astype(numpy.float16)
            self.assertEqual(found.tobytes(), expected.tobytes())
            out = numpy.zeros((301, 203), dtype).T
            self.assertIs(hashnoise.grid("fbm", (301, 203), step=0.05, seed=3, out=out), out)
            self.assertEqual(out.tobytes(), expected.tobytes())
        planes = hashnoise.grid("perlin_d", (31, 23), step=0.05)
        self.assertEqual(hashnoise.grid("perlin_d", (31, 23), step=0.05, dtype="float16").tobytes(),
                         planes.astype(numpy.float16).tobytes())
        self.assertEqual(hashnoise.grid("fbm", (9, 0), step=0.05, dtype="uint16").shape, (0, 9))

    def test_words(self):
        for name, dimensions, least, greatest in (("ridged", 2, 0, 1), ("perlin", 3, -1, 1), ("value", 1, -1, 1)):
            size = (41, 31, 21)[:dimensions]
            values = hashnoise.grid(name, size, step=0.07)
            found, extent = hashnoise.grid(name, size, step=0.07, dtype="uint16", return_range=True)
            self.assertEqual(found.tobytes(), words(values, least, greatest).tobytes())
            self.assertEqual(extent, (values.min(), values.max()))
        values = hashnoise.grid("perlin", (301, 203), step=0.05)
        for ends in ((-0.25, 0.5), (0.1, 0.11), [-3, 1e6]):
            found = hashnoise.grid("perlin", (301, 203), step=0.05, dtype="uint16", range=ends)
            self.assertEqual(found.tobytes(), words(values, *ends).tobytes())
        # Each plane by its own range: derivatives are larger.
        planes = hashnoise.grid("perlin_d", (31, 23), step=0.05, dtype="uint16")
        alone = hashnoise.grid("perlin", (31, 23), step=0.05, dtype="uint16")
        self.assertEqual(planes[0].tobytes(), alone.tobytes())
        self.assertLess(numpy.ptp(planes[1].astype(int)), 65535)

    def test_range(self):
        values, (least, greatest) = hashnoise.grid("perlin_d", (64, 48), step=0.1, return_range=True)
        self.assertEqual((least, greatest), (values[0].min(), values[0].max()))
        self.assertEqual((type(least), type(greatest)), (float, float))

    def test_options_have_the_defaults_of_the_function(self):
        for name in ("fbm", "fbm_d", "eroded", "warp", "ping_pong", "weighted", "cellular"):
            with self.subTest(name):
                x = numpy.arange(9) * 0.25
                self.assertEqual(hashnoise.grid(name, (9, 9), step=0.25, arithmetic="fixed").tobytes(),
                                 getattr(hashnoise, name)(x, x[:, None], arithmetic="fixed").tobytes())


class Threads(unittest.TestCase):
    def test_values_do_not_depend_on_them(self):
        random = numpy.random.default_rng(4)
        x, y = random.uniform(-50, 50, (2, 300_001)).astype(numpy.float32)
        for name, arguments in (("in a row", (x, y)), ("every second", (x[::2], y[::2])),
                                ("broadcast", (x[:901], y[:300, None]))):
            one = hashnoise.perlin_d(*arguments, threads=1).tobytes()
            for threads in (None, 2, 3, 16):
                with self.subTest(name, threads=threads):
                    self.assertEqual(hashnoise.perlin_d(*arguments, threads=threads).tobytes(), one)
        for cell in (None, (5, 10**9)):
            one = hashnoise.grid("fbm", (700, 300), step=0.01, cell=cell, threads=1).tobytes()
            for threads in (None, 2, 3, 16):
                with self.subTest("grid", threads=threads, cell=cell):
                    self.assertEqual(
                        hashnoise.grid("fbm", (700, 300), step=0.01, cell=cell, threads=threads).tobytes(), one)

    def test_other_threads_of_python_run_meanwhile(self):
        x = numpy.linspace(0, 50, 2_000_000, dtype=numpy.float32)
        for name, compute in (("points", lambda: hashnoise.fbm(x, x, threads=1, octaves=32)),
                              ("copies", lambda: hashnoise.fbm(x[::2], 0.5, threads=1, octaves=32)),
                              ("grid", lambda: hashnoise.grid("fbm", (1500, 1500), step=0.1, threads=1, octaves=32))):
            with self.subTest(name):
                self.assertTrue(any(self.runs_meanwhile(compute) for _ in range(5)))  # the machine may be busy
        with self.subTest("what holds the GIL is noticed"):
            self.assertFalse(any(self.runs_meanwhile(lambda: sum(range(5_000_000))) for _ in range(5)))

    def runs_meanwhile(self, compute):
        """Whether this thread does anything in the middle half of the time that another takes to compute."""
        begin = end = None

        def other():
            nonlocal begin, end
            begin = time.perf_counter()
            compute()
            end = time.perf_counter()

        moments = []
        thread = threading.Thread(target=other)
        thread.start()
        while thread.is_alive():
            time.sleep(0)
            moments.append(time.perf_counter())
        quarter = (end - begin) / 4
        return any(begin + quarter < moment < end - quarter for moment in moments)

    def test_many_threads_of_python(self):
        expected = hashnoise.grid("simplex", (200, 200), step=0.1).tobytes()
        with ThreadPoolExecutor(4) as pool:
            found = set(pool.map(lambda _: hashnoise.grid("simplex", (200, 200), step=0.1).tobytes(), range(80)))
        self.assertEqual(found, {expected})
