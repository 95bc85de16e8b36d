"""Grids on a cluster whose workers are killed, with coordinates, and in files of Zarr: the same bits."""

from __future__ import annotations

import contextlib
import doctest
import importlib.util
import io
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import distributed
import golden
import hashnoise
import hashnoise.dask
import numpy
import xarray
from distributed.client import futures_of
from documents_test import FENCE

SIZE = (1500, 1100)
OPTIONS = {"step": 0.0371, "octaves": 32, "seed": 7}  # so that computing takes long beside sending the task
PAGE = golden.ROOT / "docs" / "guide" / "dask.md"
EXAMPLE = golden.ROOT / "examples" / "dask" / "terrain.py"


def example():
    specification = importlib.util.spec_from_file_location("terrain", EXAMPLE)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def files(folder: Path) -> list[Path]:
    """The blocks of an array."""
    return [path for path in (folder / "fbm").rglob("*") if path.is_file()]


class Cluster(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = hashnoise.grid("fbm", SIZE, **OPTIONS, arithmetic="fixed")

    def setUp(self):
        self.scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.cluster = self.enterContext(distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50))
        self.client = self.enterContext(distributed.Client(self.cluster))

    def processes(self) -> dict[str, int]:
        """The processes of the workers, by their addresses."""
        return self.client.run(os.getpid)

    def test_blocks_of_killed_workers_are_the_same_again(self):
        computed = self.client.persist(hashnoise.dask.grid("fbm", SIZE, **OPTIONS, chunks=100))
        futures = futures_of(computed)
        processes = self.processes()
        for number, future in enumerate(distributed.as_completed(futures)):
            if number == 10:
                break
        holder, *_ = next(iter(self.client.who_has([future]).values()))
        self.assertTrue(any(other.status == "pending" for other in futures), "all blocks were there already")
        os.kill(processes[holder], signal.SIGKILL)  # which has this block, and others
        values = computed.compute()
        self.assertNotIn(processes[holder], self.processes().values())
        self.assertEqual(values.tobytes(), self.whole.tobytes())

    def test_a_file_that_a_killed_worker_wrote_to(self):
        path = self.scratch / "land.zarr"
        land = hashnoise.dask.data_array("fbm", SIZE, **OPTIONS, chunks=100)
        processes = self.processes()
        written = self.client.compute(land.to_zarr(path, compute=False, consolidated=False))
        while len(files(path)) < 10 and not written.done():
            time.sleep(0.01)
        self.assertFalse(written.done(), "all of it was written already")
        killed = min(processes.values())
        os.kill(killed, signal.SIGKILL)
        written.result()
        self.assertNotIn(killed, self.processes().values())
        with xarray.open_dataarray(path, engine="zarr", consolidated=False) as found:
            self.assertEqual(found.values.tobytes(), self.whole.tobytes())

    def test_a_worker_that_computes_otherwise_is_noticed(self):
        array = hashnoise.dask.grid("fbm", SIZE, **OPTIONS, chunks=500)

        def spoil():
            import hashnoise.dask
            hashnoise.dask._grid = lambda *arguments, **options: 2 * hashnoise.grid(*arguments, **options)
        self.client.run(spoil)
        self.assertNotEqual(array.compute().tobytes(), self.whole.tobytes())


class Coordinates(unittest.TestCase):
    def test_positions_are_those_of_the_points(self):
        for where in ({"step": (0.0371, 0.05), "origin": (0.1, -50.0)}, {"step": 0.01, "cell": (7, -9)},
                      {"step": (1 / 3, -0.17), "cell": (-5, 10**6), "origin": (0.25, 0.1)}):
            with self.subTest(where):
                land = hashnoise.dask.data_array("perlin", (50, 30), **where, seed=3)
                x, y = land.x.values, land.y.values[:, numpy.newaxis]
                cell = numpy.floor(x).astype(int), numpy.floor(y).astype(int)
                values = hashnoise.perlin(x - cell[0], y - cell[1], cell=cell, seed=3, arithmetic="fixed")
                numpy.testing.assert_allclose(land.values, values, atol=1e-4)  # a grid rounds its points

    def test_positions_are_the_numbers_that_users_write(self):
        """So that `sel` finds them: 1 / 100 rounded to a float32 or to 2^-32 is less."""
        for cell in (None, (0, 0), numpy.array([3, 5])):
            land = hashnoise.dask.data_array("fbm", (1000, 200), step=1 / 100, cell=cell, cell_size=100, unit="m")
            first = 0 if cell is None else 100 * int(cell[0])
            self.assertEqual(land.x.values.tolist(), [first + i for i in range(1000)])
            self.assertEqual(land.sel(x=slice(first + 10, first + 19)).shape, (200, 10))
            self.assertEqual(land.sel(x=first + 29).shape, (200,))
        for parts in (3, 49, 2999):  # 1 / 49 * 49 is less than 1
            land = hashnoise.dask.data_array("fbm", (5000, 1), step=1 / parts, cell_size=parts)
            self.assertEqual(land.x.values.tolist(), list(range(5000)), parts)
        tenths = hashnoise.dask.data_array("fbm", (9, 9), step=(0.1, -0.7), cell=(0, 2**31 - 1))
        self.assertEqual(tenths.x.values.tolist(), [i / 10 for i in range(9)])
        self.assertEqual(tenths.y.values.tolist(), [2**31 - 1 - 7 * i / 10 for i in range(9)])
        odd = hashnoise.dask.data_array("fbm", (9, 9), step=numpy.pi, origin=0.5)
        self.assertEqual(odd.x.values.tolist(), [0.5 + numpy.pi * i for i in range(9)])

    def test_units_and_names(self):
        land = hashnoise.dask.data_array("fbm", (1000, 600), step=1 / 256, cell=(0, 2), cell_size=256, unit="m")
        self.assertEqual(land.dims, ("y", "x"))
        self.assertEqual((land.x[10], land.y[10], land.x.units), (10.0, 522.0, "m"))
        self.assertEqual(land.name, "fbm")
        planes = hashnoise.dask.data_array("perlin_d", (9, 8, 7), step=0.1)
        self.assertEqual(planes.dims, ("component", "z", "y", "x"))
        self.assertEqual(planes.component.values.tolist(), ["value", "dx", "dy", "dz"])
        self.assertEqual(planes.sel(component="dy").values.tobytes(),
                         hashnoise.grid("perlin_d", (9, 8, 7), step=0.1, arithmetic="fixed")[2].tobytes())

    def test_attributes_make_it_again(self):
        land = hashnoise.dask.data_array("fbm", (30, 20), step=(0.1, 0.2), cell=(3, 4), octaves=3, seed=numpy.uint32(5),
                                         dtype=numpy.uint16, range=(-0.5, 0.5), chunks=16)
        made = dict(land.attrs)
        self.assertEqual(made.pop("hashnoise"), hashnoise.__version__)
        self.assertEqual((made.pop("scale_factor"), made.pop("add_offset")), (1 / 65535, -0.5))
        again = hashnoise.grid(made.pop("function"), (30, 20), **made)
        self.assertEqual(again.tobytes(), land.values.tobytes())

    def test_wrong(self):
        for kind, options, said in ((ValueError, {"cell_size": 0}, "cell_size must be more than 0, not 0.0"),
                                    (TypeError, {"cell_size": "m"}, "cell_size must be a number"),
                                    (ValueError, {"octaves": 0}, "octaves must be from 1 to 32, not 0"),
                                    (ValueError, {"size": (9, -9)}, "size must be from 0 to 536870911, not -9"),
                                    (ValueError, {"chunks": 0}, "chunks must be .*; not 0$"),
                                    (TypeError, {"first": 0}, "first is an option of hashnoise.grid alone"),
                                    (TypeError, {"unit": 3}, 'unit must be a name, as in "m", not 3'),
                                    (ValueError, {"name": "cellular", "dtype": "uint16"},
                                     r"the planes of cellular have .* by range=\(least, greatest\)")):
            with self.assertRaisesRegex(kind, f"^dask.data_array: {said}"):
                hashnoise.dask.data_array(**{"name": "fbm", "size": (9, 9), "step": 0.1, **options})


class Files(unittest.TestCase):
    def setUp(self):
        self.scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_words_are_read_as_values(self):
        for name, options in (("fbm", {}), ("cellular", {"range": (0, 2)}), ("phasor", {})):  # the latter in planes
            path = self.scratch / name
            land = hashnoise.dask.data_array(name, (300, 200), step=0.05, dtype="uint16", chunks=64, **options)
            land.to_zarr(path, consolidated=False)
            with xarray.open_dataarray(path, engine="zarr", consolidated=False) as found:
                values = hashnoise.grid(name, (300, 200), step=0.05, arithmetic="fixed")
                self.assertLess(numpy.abs(found.values - values).max(), 1.01 / 65535, name)
            with xarray.open_dataarray(path, engine="zarr", consolidated=False, mask_and_scale=False) as found:
                self.assertEqual(found.values.tobytes(), land.values.tobytes(), name)


class Example(unittest.TestCase):
    def setUp(self):
        self.scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.example = example()

    def test_a_small_terrain(self):
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(self.example.main(["--size", "700", "--out", str(self.scratch / "small.zarr")]), 0)
        with xarray.open_dataarray(self.scratch / "small.zarr", engine="zarr", consolidated=False,
                                   mask_and_scale=False) as found:
            whole = hashnoise.grid("fbm", (700, 700), step=1 / 4096, cell=(0, 0), octaves=11, seed=7, dtype="uint16",
                                   arithmetic="fixed")
            self.assertEqual(found.values.tobytes(), whole.tobytes())

    def test_the_large_one_is_a_description(self):
        land = self.example.terrain(200_000)
        self.assertEqual((land.shape, land.dtype, land.data.chunksize), ((200_000, 200_000), "uint16", (2048, 2048)))
        self.assertEqual((land.x[-1], land.x.units), (199_999.0, "m"))
        part = land.sel(x=slice(150_000, 150_009), y=slice(199_990, 199_999))
        expected = hashnoise.grid("fbm", (10, 10), step=1 / 4096, cell=(0, 0), first=(150_000, 199_990), octaves=11,
                                  seed=7, dtype="uint16", arithmetic="fixed")
        self.assertEqual(part.values.tobytes(), expected.tobytes())

    def test_memory_does_not_grow_with_the_terrain(self):
        printed = [subprocess.run([sys.executable, "-B", EXAMPLE, "--size", str(size), "--out", self.scratch / "of.zarr"],
                                  check=True, capture_output=True, text=True).stdout for size in (4096, 8192)]
        small, large = (float(re.search(r"(\d+) MB of memory$", text.rstrip())[1]) for text in printed)
        self.assertGreater(small, 50)
        self.assertLess(large, 1.25 * small + 50)


class Page(unittest.TestCase):
    def test_code_runs(self):
        blocks = FENCE.findall(PAGE.read_text(encoding="utf-8"))
        self.assertGreater(len(blocks), 2)
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.enterContext(tempfile.TemporaryDirectory()))
        for block in blocks:
            with self.subTest(block):
                # The large terrain is written small.
                exec(compile(block.replace("200_000", "2_000"), PAGE.name, "exec"), {"__name__": "__main__"})

    def test_examples_of_docstrings(self):
        results = doctest.testmod(hashnoise.dask, extraglobs={"hashnoise": hashnoise, "numpy": numpy})
        self.assertGreater(results.attempted, 8)
        self.assertEqual(results.failed, 0)


class Types(unittest.TestCase):
    def compare(self, folder: Path) -> subprocess.CompletedProcess[str]:
        """The stub with the code; a package in the folder stands before the installed one."""
        (folder / "mypy.ini").write_text("[mypy]\nignore_missing_imports = True\nfollow_imports = silent\n")
        return subprocess.run([sys.executable, "-B", "-m", "mypy.stubtest", "hashnoise.dask", "--mypy-config-file",
                               "mypy.ini"], cwd=folder, capture_output=True, text=True, check=False)

    def test_the_stub_has_what_the_code_has(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        done = self.compare(folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        shutil.copytree(Path(hashnoise.__file__).parent, folder / "hashnoise")
        stub = folder / "hashnoise" / "dask.pyi"
        stub.write_text(stub.read_text().replace("cell_size: _Number = 1.0", "cell_side: _Number = 1.0"))
        done = self.compare(folder)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("error: hashnoise.dask.data_array ", done.stdout)
