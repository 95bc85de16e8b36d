"""The package's documentation: examples run, and numbers are those of the GLSL's comments."""

from __future__ import annotations

import doctest
import importlib.util
import inspect
import re
import unittest

import golden
import hashnoise
import numpy
from hashnoise import _grids, _noises, _sums

PAGE = golden.ROOT / "docs" / "guide" / "python.md"
GLSL = golden.ROOT / "glsl" / "hashnoise"
FENCE = re.compile(r"^```python\n(.*?)^```$", re.M | re.S)
ELSEWHERE = re.compile("import (matplotlib|jax|torch)")  # notebook_test.py and libraries_test.py run these
NUMBER = re.compile(r"-?\d+\.\d{2,}")


def functions():
    return [getattr(hashnoise, name) for name in hashnoise.__all__]


class Docstrings(unittest.TestCase):
    def test_examples(self):
        self.assertEqual([one.__name__ for one in functions() if f"hashnoise.{one.__name__}(" not in one.__doc__], [])
        names = {"hashnoise": hashnoise, "numpy": numpy}
        for module in (hashnoise, _grids, _noises, _sums):
            results = doctest.testmod(module, extraglobs=names)
            self.assertGreater(results.attempted, 3, module.__name__)
            self.assertEqual(results.failed, 0, module.__name__)

    def test_each_function_says_what_it_returns_and_whence_it_comes(self):
        for function in (*_noises.NOISES.values(), *_sums.SUMS.values()):
            with self.subTest(function.__name__):
                self.assertRegex(function.__doc__, r"(?m)^ *returns +\S")
                self.assertRegex(function.__doc__, r"(?m)^ *source +\S")
                dimensions = [axes for axes in range(1, 5)
                              if function.__name__ in hashnoise.noises(axes) + hashnoise.fractals(axes)]
                said = f"{dimensions[0]}D"
                if len(dimensions) > 1:
                    said += f" {'and' if len(dimensions) == 2 else 'to'} {dimensions[-1]}D"
                self.assertIn(f"in {said}", function.__doc__.partition("\n")[0])

    def test_each_option_is_explained(self):
        common = hashnoise.__doc__
        for function in (*_noises.NOISES.values(), *_sums.SUMS.values()):
            for option in function.__kwdefaults__:
                with self.subTest(function.__name__, option=option):
                    self.assertRegex(function.__doc__ + common, rf"(?m)^ *{option} +\S")
        for option in inspect.signature(hashnoise.grid).parameters:
            with self.subTest("grid", option=option):
                self.assertRegex("".join(other.__doc__ for other in functions()) + common, rf"(?m)^ *{option} +\S")

    def test_numbers_are_those_of_the_glsl(self):
        seen = 0
        for name, function in _noises.NOISES.items():
            text = function.__doc__.partition(">>>")[0]
            comments = "".join(line for path in GLSL.glob(f"{name}*d.glsl")
                               for line in path.read_text(encoding="ascii").splitlines() if line.startswith("//"))
            comments = re.sub(r"//\s*", " ", comments)
            for number in NUMBER.findall(text):
                with self.subTest(name, number=number):
                    self.assertRegex(comments, rf"(?<![\d.]){re.escape(number)}(?!\d)")
                    seen += 1
        self.assertGreater(seen, 20)


class Page(unittest.TestCase):
    def test_code_runs(self):
        blocks = FENCE.findall(PAGE.read_text(encoding="utf-8"))
        self.assertGreaterEqual(len(blocks), 3)
        self.assertEqual(len(blocks), PAGE.read_text(encoding="utf-8").count("```python"))
        here = [block for block in blocks if not ELSEWHERE.search(block)]
        self.assertEqual(len(blocks) - len(here), 3)
        names = [run(block) for block in here]
        self.assertEqual(names[0]["image"].shape, (1024, 1024))
        self.assertEqual([names[1][name].shape for name in ("heights", "value", "dz")], [(1000,)] * 3)
        self.assertTrue((names[1]["heights"] == names[1]["again"]).all())
        self.assertEqual(names[2]["terrain"].shape, (1080, 1920))
        self.assertEqual(names[2]["volume"].shape, (64, 64, 64))
        self.assertEqual((names[2]["least"], names[2]["greatest"]),
                         (names[2]["volume"].min(), names[2]["volume"].max()))
        self.assertTrue(names[3]["same"])
        self.assertEqual(names[4]["line"].shape, (1024,))
        self.assertEqual(names[5]["heights"].mask.tolist(), [False, True, False])

    def test_code_for_users_of_other_packages_runs(self):
        page = PAGE.with_name("moving.md").read_text(encoding="utf-8")
        (block,) = FENCE.findall(page)
        names = run(block)
        self.assertEqual((names["heights"].shape, names["waves"].shape), ((256, 512), (256, 512)))
        table = page.partition("| Python | hashnoise |")[2].partition("\n## ")[0]
        called = re.findall(r"`(\w+)\(", "".join(row.split(" | ")[1] for row in table.splitlines() if " | " in row))
        self.assertEqual(set(called), {"perlin", "simplex", "fbm"})

    def test_code_that_fails_is_noticed(self):
        with self.assertRaises(TypeError):
            run("import hashnoise\nhashnoise.perlin(0.5, octaves=3)\n")

    def test_the_table_has_every_option(self):
        text = PAGE.read_text(encoding="utf-8")
        rows = [row.split(" | ")[0] for row in re.findall(r"^\| (`.*)$", text, re.M)]
        documented = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
        options = {option for function in (*_noises.NOISES.values(), *_sums.SUMS.values())
                   for option in function.__kwdefaults__}
        self.assertEqual(documented, options)

    def test_errors_far_from_the_origin(self):
        """The page has them: positions are rounded to float32, and those of the octaves with them."""
        fractions = numpy.random.default_rng(7).random((2, 100_000))
        for far, most in ((10_000, 0.006), (500_000, 0.2)):
            self.assertRegex(PAGE.read_text(encoding="utf-8"), f"by up to {most} at {far:,}")
            places = far + 50 * fractions
            cells = numpy.floor(places)
            self.assertLess(numpy.abs(places - places.astype(numpy.float32)).max(), (far + 50) * 2.0**-24)
            exact = hashnoise.fbm(*(places - cells), cell=tuple(cells.astype(int)))
            error = numpy.abs(hashnoise.fbm(*places) - exact).max()
            self.assertTrue(0.75 * most < error < most, error)

    def test_it_names_the_oldest_versions(self):
        project = (golden.ROOT / "pyproject.toml").read_text(encoding="utf-8")
        python = re.search(r'^requires-python = ">=(.*)"$', project, re.M)[1]
        numpys = re.search(r'^dependencies = \["numpy>=(.*)"\]$', project, re.M)[1]
        self.assertIn(f"Python {python} or later, and NumPy {numpys} or later", PAGE.read_text(encoding="utf-8"))

    def test_functions_that_it_names_exist(self):
        for name in re.findall(r"hashnoise\.(\w+)", PAGE.read_text(encoding="utf-8")):
            self.assertTrue(hasattr(hashnoise, name) or importlib.util.find_spec(f"hashnoise.{name}"), name)


def run(code: str) -> dict:
    names: dict = {}
    exec(compile(code, PAGE.name, "exec"), names)
    return names
