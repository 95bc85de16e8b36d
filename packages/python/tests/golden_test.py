"""The golden files through the functions of the package: bit for bit, and within the error."""

from __future__ import annotations

import contextlib
import dataclasses
import importlib.resources
import io
import re
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import golden
import hashnoise
import numpy
from hashnoise import check

from base.tree import VECTORS  # (golden.py names the folder of base)


class Fixed(unittest.TestCase):
    """arithmetic="fixed" has the bits of HN_FIXED: each function in each dimension and form."""

    def test_bits(self):
        tested, turning = set(), set()
        for name in golden.names("lattice+fixed"):
            with self.subTest(name):
                file = golden.read(name, "lattice+fixed")
                self.assertGreater(len(file.arguments["seed"]), 60)
                self.assertEqual(golden.different_bits(file, golden.computed(file, "fixed"))[:5], [])
                tested.add((file.function, file.axes))
                if "phase" in file.arguments:
                    turning.add((file.function, file.axes))
        everything = {(name, axes) for axes in range(1, 5) for name in hashnoise.noises(axes) + hashnoise.fractals(axes)}
        self.assertEqual(tested, everything)
        with_phase = ("perlin", "perlin_d", "simplex", "simplex_d", "cellular", "curl", "curl_fbm", "phasor")
        self.assertEqual(turning, {(name, axes) for name in with_phase for axes in (2, 3)})

    def test_grids(self):
        """A grid has the values of the points, which golden files have."""
        for axes, name in ((1, "value_cubic"), (2, "cellular_three"), (3, "perlin_d"), (4, "simplex_d"), (2, "ridged"),
                           (2, "phasor"), (3, "perlin_worley")):
            with self.subTest(name):
                size = (7, 5, 3, 2)[:axes]
                along = [0.375 * numpy.arange(points) - 1.25 for points in size]
                points = numpy.meshgrid(*along, indexing="ij")
                function = getattr(hashnoise, name)
                expected = function(*points, seed=9, arithmetic="fixed")
                planes = expected.ndim - axes
                expected = expected.transpose(*range(planes), *reversed(range(planes, planes + axes)))
                grid = hashnoise.grid(name, size, step=0.375, origin=-1.25, seed=9, arithmetic="fixed")
                self.assertEqual(grid.shape, expected.shape)
                self.assertEqual(grid.tobytes(), numpy.ascontiguousarray(expected).tobytes())
                far = hashnoise.grid(name, size, step=0.375, origin=0.75, cell=(-2,) * axes, seed=9, arithmetic="fixed")
                self.assertEqual(far.tobytes(), grid.tobytes())


class Vectors(unittest.TestCase):
    """The package's golden files are the library's, and it has their values."""

    def test_they_are_there(self):
        folder = importlib.resources.files(hashnoise) / "vectors"
        self.assertEqual({path.name for path in folder.iterdir()}, {path.name for path in VECTORS.iterdir()})

    def checked(self, status: int) -> str:
        with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(out):
            self.assertEqual(check.main(), status)
        return out.getvalue()

    def test_one_wrong_number_is_noticed_and_no_vectors(self):
        scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))
        with mock.patch.object(check, "files", return_value=scratch):
            self.assertIn("without vectors", self.checked(2))
            (scratch / "vectors").mkdir()
            text = (VECTORS / "noise2d.perlin.json").read_text()
            copy, fixed = scratch / "vectors" / "noise2d.perlin.json", text.index('"lattice+fixed"')
            copy.write_text(text)
            self.assertRegex(self.checked(0), r"\A\d+ values of 1 vectors have their bits with \w+")
            with mock.patch.object(hashnoise, "instruction_sets", return_value=()):
                self.assertIn("this processor has no instruction set", self.checked(1))
            copy.write_text(text[:fixed] + re.sub(r'"out":\[-?0\.', r"\g<0>9", text[fixed:], count=1))
            self.assertRegex(self.checked(1), r"\A\S+: noise2d\.perlin, row \d+: value is ")


class Fast(unittest.TestCase):
    """The other arithmetics are as near to the exact values as the noises promise."""

    def test_error(self):
        for arithmetic in ("fast", "precise"):
            for name in golden.names("lattice"):
                file = golden.read(name, "lattice")
                if file.function in hashnoise.fractals(file.axes):
                    continue  # what is promised of a sum depends on its positions; the compiled library's tests know it
                with self.subTest(name, arithmetic=arithmetic):
                    self.assertEqual(golden.too_far(file, golden.computed(file, arithmetic))[:5], [])

    def test_precise_is_the_same_everywhere(self):
        x = numpy.linspace(-40, 40, 10001, dtype=numpy.float32)
        expected = hashnoise.fbm(x, 0.3, seed=5, arithmetic="precise").tobytes()
        for instruction_set in hashnoise.instruction_sets():
            values = hashnoise.fbm(x, 0.3, seed=5, arithmetic="precise", instruction_set=instruction_set)
            self.assertEqual(values.tobytes(), expected, instruction_set)


class Reported(unittest.TestCase):
    """The comparisons notice faults."""

    def setUp(self):
        self.file = golden.read("noise2d.perlin_d", "lattice+fixed")
        self.results = golden.computed(self.file, "fixed")

    def test_each_wrong_number(self):
        bit, nothing, zero = (self.results.copy() for _ in range(3))
        bit.view(numpy.uint32)[1, 7] ^= 1
        nothing[2, 3] = numpy.nan
        zero[0, numpy.flatnonzero(self.file.results["value"] == 0)[0]] *= -1  # the sign of a zero
        for results, said in ((bit, ["row 8: dx"]), (nothing, ["row 4: dy"]), (zero, ["value"]), (self.results, [])):
            found = golden.different_bits(self.file, results)
            self.assertEqual(len(found), len(said))
            for one, words in zip(found, said):
                self.assertIn(words, one)
        self.assertEqual(len(golden.too_far(self.file, nothing)), 1)
        self.assertGreater(len(golden.different_bits(self.file, self.results[::-1])), 100)

    def test_a_component_that_is_missing(self):
        with self.assertRaises(ValueError):
            golden.different_bits(self.file, self.results[:2])

    def test_another_seed_axis_and_arithmetic(self):
        for wrong in ({"seed": self.file.arguments["seed"] + numpy.uint32(1)},
                      {"x": self.file.arguments["y"], "y": self.file.arguments["x"]}):
            other = dataclasses.replace(self.file, arguments={**self.file.arguments, **wrong})
            self.assertGreater(len(golden.different_bits(self.file, golden.computed(other, "fixed"))), 100)
        self.assertGreater(len(golden.different_bits(self.file, golden.computed(self.file, "fast"))), 100)

    def test_too_far(self):
        file = golden.read("noise2d.perlin_d", "lattice")
        results = golden.computed(file, "fast")
        for column, plane in (("value", 0), ("dy", 2)):
            for factor, errors in ((0.5, 0), (3, 1)):
                changed = results.copy()
                changed[plane, 5] = file.results[column][5] + factor * golden.bound(file, column)
                self.assertEqual(len(golden.too_far(file, changed)), errors, (column, factor))

    def test_a_file_that_is_cut_off(self):
        name = "noise1d.perlin.golden"
        lines = (golden.GOLDEN / name).read_text(encoding="ascii").splitlines(keepends=True)
        with tempfile.TemporaryDirectory() as scratch:
            (Path(scratch) / name).write_text("".join(lines[:-1]), encoding="ascii")
            with self.assertRaisesRegex(ValueError, "the head states"):
                golden.read("noise1d.perlin", "lattice", Path(scratch))
