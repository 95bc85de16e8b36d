"""Grids as Dask arrays: the bits of one grid, however it is cut, and errors before anything is computed."""

from __future__ import annotations

import pickle
import re
import subprocess
import sys
import unittest
from unittest import mock

import dask
import golden
import hashnoise
import hashnoise.dask
import numpy

SIZE = (151, 103)
# Each has SIZE points; blocks begin anywhere.
CHUNKS = {"one": -1, "squares": 64, "odd": (37, 101), "rows": (9, -1), "columns": (-1, 17),
          "uneven": ((100, 3), (1, 149, 1)), "auto": "auto", "by bytes": "20kiB"}
# Steps that are no power of two, also where floats round each position.
PLACES = {"positions": {"step": (0.0371, 0.05), "origin": (0.1, -50.0)}, "cells": {"step": 0.01, "cell": (7, -9)},
          "places in cells": {"step": (1 / 3, -0.17), "cell": (2**31 - 9, -(2**31)), "origin": (0.25, 0.1)}}


class Bits(unittest.TestCase):
    def assert_same(self, array, expected):
        self.assertEqual((array.shape, array.dtype), (expected.shape, expected.dtype))
        values = array.compute(scheduler="synchronous")
        self.assertEqual((values.shape, values.dtype), (expected.shape, expected.dtype))
        self.assertEqual(values.tobytes(), expected.tobytes())

    def test_however_it_is_cut(self):
        for place, where in PLACES.items():
            for arithmetic in ("fast", "fixed"):
                whole = hashnoise.grid("fbm", SIZE, **where, octaves=3, seed=7, arithmetic=arithmetic)
                for cut, chunks in CHUNKS.items():
                    with self.subTest(place=place, arithmetic=arithmetic, cut=cut):
                        self.assert_same(hashnoise.dask.grid("fbm", SIZE, **where, octaves=3, seed=7,
                                                             arithmetic=arithmetic, chunks=chunks), whole)

    def test_a_part_of_it(self):
        whole = hashnoise.grid("perlin", SIZE, step=0.05, arithmetic="fixed")
        self.assert_same(hashnoise.dask.grid("perlin", SIZE, step=0.05, chunks=50)[40:61, 120:], whole[40:61, 120:])

    def test_planes_are_not_cut(self):
        whole = hashnoise.grid("perlin_d", SIZE, step=0.05, arithmetic="fixed", phase=0.25)
        array = hashnoise.dask.grid("perlin_d", SIZE, step=0.05, chunks=(100, 64), phase=0.25)
        self.assertEqual(array.chunks[0], (3,))
        self.assert_same(array, whole)

    def test_dimensions(self):
        for size in ((1000,), (30, 20, 10), (9, 8, 7, 6)):
            with self.subTest(size):
                whole = hashnoise.grid("perlin", size, step=0.05, arithmetic="fixed")
                self.assert_same(hashnoise.dask.grid("perlin", size, step=0.05, chunks=7), whole)
        self.assert_same(hashnoise.dask.grid("perlin", 1000, step=0.05, chunks=70),
                         hashnoise.grid("perlin", 1000, step=0.05, arithmetic="fixed"))

    def test_types(self):
        for dtype in ("float32", "float16", "uint16"):
            with self.subTest(dtype):
                whole = hashnoise.grid("ridged", SIZE, step=0.05, arithmetic="fixed", dtype=dtype)
                self.assert_same(hashnoise.dask.grid("ridged", SIZE, step=0.05, chunks=64, dtype=dtype), whole)

    def test_no_points(self):
        array = hashnoise.dask.grid("perlin", (0, 5), step=0.05)
        self.assertEqual(array.compute().shape, (5, 0))

    def test_another_grid_is_noticed(self):
        """Blocks that would each begin at the origin."""
        whole = hashnoise.grid("perlin", SIZE, step=0.05, arithmetic="fixed")
        with mock.patch.object(hashnoise.dask, "_grid", lambda *arguments, first, **options: hashnoise.grid(
                *arguments, **options)):
            with self.assertRaises(AssertionError):
                self.assert_same(hashnoise.dask.grid("perlin", SIZE, step=0.05, chunks=64), whole)


class Arrays(unittest.TestCase):
    def test_fixed_by_default(self):
        """With "fast" the bits would be those of the worker's processor."""
        values = hashnoise.dask.grid("fbm", SIZE, step=0.05).compute()
        self.assertEqual(values.tobytes(), hashnoise.grid("fbm", SIZE, step=0.05, arithmetic="fixed").tobytes())

    def test_usual_blocks(self):
        for size, chunks in (((10**5, 10**5), (2048, 2048)), ((10**5, 4), (4, 10**5)), ((10**7, 4), (4, 2**20)),
                             ((10**7, 5), (5, 2**19)), ((500, 500, 500), (256, 128, 128)), ((10**7,), (2**22,)),
                             ((10**7, 1), (1, 2**22))):
            with self.subTest(size):
                self.assertEqual(hashnoise.dask.grid("perlin", size, step=1 / 256).chunksize, chunks)

    def test_a_usual_block_is_a_grid_from_a_cell(self):
        array = hashnoise.dask.grid("fbm", (5000, 3000), step=1 / 256, cell=(7, 10**9), octaves=2)
        block = hashnoise.grid("fbm", (50, 30), step=1 / 256, cell=(7 + 2048 // 256, 10**9), octaves=2,
                               arithmetic="fixed")
        self.assertEqual(array.blocks[0, 1][:30, :50].compute().tobytes(), block.tobytes())

    def test_names_are_those_of_the_values(self):
        def name(**options):
            return hashnoise.dask.grid(**{"name": "fbm", "size": SIZE, "step": 0.05, "chunks": 64, **options}).name
        self.assertEqual(name(), name())
        for other in ({"seed": 3}, {"step": 0.06}, {"size": (151, 104)}, {"chunks": 65}, {"octaves": 3},
                      {"name": "ridged"}):
            self.assertNotEqual(name(), name(**other), other)
        with mock.patch.object(hashnoise.dask, "__version__", "0.0.0"):
            other = name()
        self.assertNotEqual(name(), other)

    def test_large_ones_are_lazy(self):
        array = hashnoise.dask.grid("fbm", (2**29 - 1, 2**29 - 1), step=1 / 256, cell=(0, 0), chunks=2**26)
        self.assertEqual(array.nbytes, 4 * (2**29 - 1)**2)
        self.assertEqual(hashnoise.dask.grid("fbm", (200_000, 200_000), step=1 / 256).npartitions, 98**2)

    def test_tasks_can_be_sent(self):
        array = hashnoise.dask.grid("fbm", SIZE, step=0.05, chunks=64)
        again = pickle.loads(pickle.dumps(array))
        self.assertEqual(again.compute(scheduler="synchronous").tobytes(), array.compute().tobytes())

    def test_another_version_is_an_error(self):
        array = hashnoise.dask.grid("fbm", SIZE, step=0.05, chunks=64)
        with mock.patch.object(hashnoise.dask, "__version__", "0.0.0"):
            with self.assertRaisesRegex(RuntimeError, "^this worker has hashnoise 0.0.0, and the array was made with "):
                array.compute(scheduler="synchronous")


class Wrong(unittest.TestCase):
    def test_arguments(self):
        for kind, options, said in (
                (ValueError, {"chunks": 0}, r"chunks must be a number of points of 1 or more, .* of the "
                                            r"axes y, x, along which there are \(103, 151\) points; not 0$"),
                (ValueError, {"chunks": -5}, "chunks must be .*; not -5$"),
                (ValueError, {"chunks": 2.5}, "chunks must be .*; not 2.5$"),
                (ValueError, {"chunks": "many"}, "chunks must be .*; not 'many'$"),
                (ValueError, {"chunks": None}, "chunks must be .*; not None$"),
                (ValueError, {"chunks": (64, 64, 64)}, r"chunks must be .*; not \(64, 64, 64\)$"),
                (ValueError, {"chunks": ((100, 4), (151,))}, r"chunks must be .*; not \(\(100, 4\), \(151,\)\)$"),
                (TypeError, {"out": numpy.zeros(3)}, "out is an option of hashnoise.grid alone; cut the "),
                (TypeError, {"first": (1, 2)}, "first is an option of hashnoise.grid alone"),
                (TypeError, {"return_range": True}, "return_range is an option of hashnoise.grid alone"),
                (ValueError, {"size": (2**29, 5)}, "size must be from 0 to 536870911, not 536870912"),
                (TypeError, {"size": "large"}, "size must be a whole number"),
                (ValueError, {"name": "fbn"}, r"there is no function 'fbn' \(did you mean fbm\?\)"),
                (ValueError, {"octaves": 0}, "octaves must be from 1 to 32, not 0"),
                (TypeError, {"jitter": 0.5}, "fbm has no option jitter"),
                (TypeError, {"frequency": 1}, "step is the frequency"),
                (ValueError, {"arithmetic": "exact"}, "arithmetic must be one of fast, precise, fixed"),
                (ValueError, {"dtype": "int8"}, "dtype must be float32, float16 or uint16, not 'int8'"),
                # The last point alone is too far out.
                (ValueError, {"step": 1e36, "size": (1000, 3)}, "finite")):
            with self.subTest(options):
                with self.assertRaisesRegex(kind, f"^dask.grid: .*{said}") as caught:
                    hashnoise.dask.grid(**{"name": "fbm", "size": SIZE, "step": 0.05, **options})
                self.assertIs(type(caught.exception), kind)

    def test_without_dask(self):
        """In a Python of its own, where it cannot be imported."""
        program = "import sys; sys.modules['dask'] = None; import hashnoise; import hashnoise.dask"
        done = subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"\nImportError: hashnoise\.dask wants Dask, which cannot be imported \(.*\): "
                                      r"pip install dask distributed xarray zarr\n$")
        # These are what the package's own list names, and none is the package itself: nobody has that from PyPI.
        project = (golden.ROOT / "pyproject.toml").read_text(encoding="utf-8")
        listed = re.findall(r'"(\w+)(?:\[\w+\])?>=', re.search(r"^dask = \[.*\]$", project, re.M)[0])
        self.assertEqual(listed, ["dask", "distributed", "xarray", "zarr"])

    def test_without_xarray(self):
        with mock.patch.dict(sys.modules, {"xarray": None}):
            with self.assertRaisesRegex(ImportError, r"^hashnoise\.dask\.data_array wants xarray, which cannot be "):
                hashnoise.dask.data_array("fbm", SIZE, step=0.05)


if __name__ == "__main__":
    dask.config.set(scheduler="synchronous")
    unittest.main()
