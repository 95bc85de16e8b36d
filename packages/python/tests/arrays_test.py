"""Arrays of all kinds: the values are those of float32 arrays that lie in a row, whatever arrays are passed."""

from __future__ import annotations

import threading
import time
import unittest

import hashnoise
import numpy

SHAPE = (90, 130)  # more points than are copied at a time


class Arrays(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        self.x, self.y = random.uniform(-50, 50, (2, *SHAPE)).astype(numpy.float32)
        self.values = hashnoise.perlin(self.x, self.y, seed=3)
        self.planes = hashnoise.perlin_d(self.x, self.y, seed=3)

    def assert_same(self, got, expected):
        self.assertEqual((got.dtype, got.shape), (numpy.float32, expected.shape))
        self.assertEqual(got.tobytes(), numpy.ascontiguousarray(expected).tobytes())

    def test_each_point_alone(self):
        for row, column in ((0, 0), (17, 3), (89, 129)):
            x, y = self.x[row, column], self.y[row, column]
            self.assertEqual(hashnoise.perlin(x, y, seed=3), self.values[row, column])
            self.assertEqual(hashnoise.perlin_d(x, y, seed=3).tolist(), self.planes[:, row, column].tolist())

    def test_strides(self):
        for name, cut in (("columns", numpy.s_[:, ::3]), ("rows", numpy.s_[::2]), ("backwards", numpy.s_[::-1, ::-1]),
                          ("a corner", numpy.s_[5:80, 7:99]), ("a column", numpy.s_[:, 4])):
            with self.subTest(name):
                self.assert_same(hashnoise.perlin(self.x[cut], self.y[cut], seed=3), self.values[cut])
                self.assert_same(hashnoise.perlin_d(self.x[cut], self.y[cut], seed=3), self.planes[(slice(None), *
                                 (cut if isinstance(cut, tuple) else (cut,)))])

    def test_order(self):
        self.assert_same(hashnoise.perlin(self.x.T, self.y.T, seed=3), self.values.T)
        self.assert_same(hashnoise.perlin_d(self.x.T, self.y.T, seed=3), self.planes.transpose(0, 2, 1))
        self.assert_same(hashnoise.perlin(numpy.asfortranarray(self.x), self.y, seed=3), self.values)

    def test_fields_of_records(self):
        """Their numbers are at any byte."""
        records = numpy.zeros(SHAPE, [("kind", "u1"), ("x", "f4"), ("y", "f8")])
        records["x"], records["y"] = self.x, self.y
        self.assert_same(hashnoise.perlin(records["x"], records["y"], seed=3), self.values)

    def test_kinds_of_numbers(self):
        for kind in ("f8", ">f4", ">f8", "g"):
            with self.subTest(kind):
                self.assert_same(hashnoise.perlin(self.x.astype(kind), self.y.astype(kind), seed=3), self.values)
        whole = numpy.arange(-60, 60)
        expected = hashnoise.value(whole.astype(numpy.float32), 0.5, seed=3)
        for kind in ("i1", "i2", "i4", "i8", "f2", ">i4"):
            with self.subTest(kind):
                self.assert_same(hashnoise.value(whole.astype(kind), 0.5, seed=3), expected)
        for kind in ("u1", "u2", "u4", "u8"):
            with self.subTest(kind):
                self.assert_same(hashnoise.value(whole[60:].astype(kind), 0.5, seed=3), expected[60:])
        self.assert_same(hashnoise.value([True, False], 0.5, seed=3), expected[[61, 60]])
        self.assert_same(hashnoise.value(whole.tolist(), 0.5, seed=3), expected)

    def test_float64_is_rounded_to_the_nearest(self):
        x = numpy.linspace(0, 9, 5001)
        self.assert_same(hashnoise.perlin(x), hashnoise.perlin(x.astype(numpy.float32)))
        self.assert_same(hashnoise.perlin(x, x[:30, None]),
                         hashnoise.perlin(x.astype(numpy.float32), x[:30, None].astype(numpy.float32)))

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

    def test_views_of_broadcast_arrays(self):
        x = numpy.broadcast_to(self.x[0], SHAPE)
        self.assertFalse(x.flags.writeable)
        self.assert_same(hashnoise.perlin(x, self.y, seed=3), hashnoise.perlin(x.copy(), self.y, seed=3))

    def test_numbers(self):
        for x, y in ((0.5, 0.25), (1, 0.25), (numpy.float32(0.5), numpy.int16(2)), (numpy.array(0.5), 0.25)):
            with self.subTest(x=x, y=y):
                value = hashnoise.perlin(x, y, seed=3)
                self.assertIs(type(value), float)
                self.assertEqual(value, hashnoise.perlin([x], y, seed=3)[0])
                self.assertEqual(hashnoise.perlin_d(x, y, seed=3).shape, (3,))
        out = numpy.empty((), numpy.float32)
        self.assertIs(hashnoise.perlin(0.5, 0.25, seed=3, out=out), out)
        self.assertEqual(out, hashnoise.perlin(0.5, 0.25, seed=3))

    def test_no_points(self):
        for shape in ((0,), (3, 0), (0, 3)):
            self.assertEqual(hashnoise.perlin(numpy.zeros(shape), 0.5).shape, shape)
            self.assertEqual(hashnoise.perlin_d(numpy.zeros(shape), 0.5).shape, (3, *shape))
        self.assertEqual(hashnoise.grid("perlin", (0, 5), step=1).shape, (5, 0))
        self.assertEqual(hashnoise.grid("perlin_d", (5, 0), step=1).shape, (3, 0, 5))

    def test_planes_can_be_unpacked(self):
        value, dx, dy = hashnoise.perlin_d(self.x, self.y, seed=3)
        self.assert_same(value, self.values)
        self.assertEqual(hashnoise.components("perlin_d", 2), ("value", "dx", "dy"))
        step = numpy.float32(1 / 1024)
        slope = (hashnoise.perlin(self.x + step, self.y, seed=3) - self.values) / step
        self.assertLess(numpy.abs(slope - dx).max(), 0.05)
        self.assertEqual(dy.shape, SHAPE)

    def test_one_to_four_coordinates(self):
        for axes in range(1, 5):
            self.assertEqual(hashnoise.perlin_d(*[self.x] * axes).shape, (axes + 1, *SHAPE))


class Cells(unittest.TestCase):
    def test_kinds_of_numbers(self):
        random = numpy.random.default_rng(3)
        cells = random.integers(-2**31, 2**31, (2, 9000))
        places = random.uniform(0, 1, (2, 9000)).astype(numpy.float32)
        expected = hashnoise.perlin_d(*places, cell=tuple(cells.astype(numpy.int32)), seed=4)
        for name, other in (("int64", cells), ("big-endian", cells.astype(">i8")),
                            ("columns", numpy.asfortranarray(cells))):
            with self.subTest(name):
                values = hashnoise.perlin_d(*places, cell=tuple(other), seed=4)
                self.assertEqual(values.tobytes(), expected.tobytes())
        positive = cells & (2**31 - 1)
        expected_of_positive = hashnoise.perlin_d(*places, cell=tuple(positive), seed=4)
        for kind in (numpy.uint32, numpy.uint64):
            with self.subTest(kind.__name__):
                values = hashnoise.perlin_d(*places, cell=tuple(positive.astype(kind)), seed=4)
                self.assertEqual(values.tobytes(), expected_of_positive.tobytes())
        halves = hashnoise.perlin_d(*places[:, ::2], cell=tuple(cells[:, ::2]), seed=4)
        self.assertEqual(halves.tobytes(), expected[:, ::2].tobytes())

    def test_near_the_origin_they_are_positions(self):
        x = numpy.arange(-40, 40, 0.25, dtype=numpy.float32)
        cell = numpy.floor(x)
        values = hashnoise.fbm(x - cell, 0.5, cell=(cell.astype(int), -3), arithmetic="fixed")
        self.assertEqual(values.tobytes(), hashnoise.fbm(x, -2.5, arithmetic="fixed").tobytes())

    def test_broadcasting(self):
        cells = numpy.arange(70)
        values = hashnoise.perlin(0.5, numpy.float32(0.25), cell=(cells, cells[:, None] - 2**31), seed=4)
        whole = numpy.meshgrid(cells, cells - 2**31)
        self.assertEqual(values.tobytes(), hashnoise.perlin(
            numpy.full((70, 70), 0.5), numpy.full((70, 70), 0.25), cell=tuple(whole), seed=4).tobytes())

    def test_one_axis_needs_no_tuple(self):
        self.assertEqual(hashnoise.perlin(0.5, cell=7), hashnoise.perlin(0.5, cell=(7,)))
        self.assertEqual(hashnoise.perlin(0.5, cell=[7, 8]).shape, (2,))


class Out(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        self.x, self.y = random.uniform(-50, 50, (2, *SHAPE)).astype(numpy.float32)
        self.values = hashnoise.perlin(self.x, self.y, seed=3)
        self.planes = hashnoise.perlin_d(self.x, self.y, seed=3)

    def test_it_is_filled_and_returned(self):
        out = numpy.empty(SHAPE, numpy.float32)
        self.assertIs(hashnoise.perlin(self.x, self.y, seed=3, out=out), out)
        self.assertEqual(out.tobytes(), self.values.tobytes())

    def test_strides(self):
        large = numpy.full((3, 200, 300), 7, numpy.float32)
        for name, cut in (("a corner", numpy.s_[:90, :130]), ("every second", numpy.s_[10:190:2, 10:270:2]),
                          ("backwards", numpy.s_[89::-1, 130:0:-1])):
            with self.subTest(name):
                large[...] = 7
                hashnoise.perlin(self.x, self.y, seed=3, out=large[1][cut])
                self.assertEqual(large[1][cut].tobytes(), self.values.tobytes())
                large[1][cut] = 7
                self.assertTrue((large == 7).all(), "something beside it was written")
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

    def test_grids(self):
        expected = hashnoise.grid("perlin_d", (40, 30), step=0.1)
        out = numpy.empty((3, 30, 40), numpy.float32)
        self.assertIs(hashnoise.grid("perlin_d", (40, 30), step=0.1, out=out), out)
        self.assertEqual(out.tobytes(), expected.tobytes())
        pixels = numpy.empty((30, 40, 3), numpy.float32)
        hashnoise.grid("perlin_d", (40, 30), step=0.1, out=pixels.transpose(2, 0, 1))
        self.assertEqual(pixels.transpose(2, 0, 1).tobytes(), expected.tobytes())


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
        wrong = []

        def compute():
            for _ in range(20):
                if hashnoise.grid("simplex", (200, 200), step=0.1).tobytes() != expected:
                    wrong.append(True)

        threads = [threading.Thread(target=compute) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
