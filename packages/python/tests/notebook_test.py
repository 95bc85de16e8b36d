"""The cells of the pages, by Jupyter's own kernel: they run, and show the pictures that stand below them."""

from __future__ import annotations

import io
import unittest

import nbclient
import notebook
import numpy
from documents_test import FENCE, PAGE
from PIL import Image

OF_PAGE = 120_000  # bytes of all pictures together
NEAR = 1.0  # of 255, on the mean of all numbers: rounding may colour a few pixels otherwise on another machine


def difference(one: Image.Image, other: Image.Image) -> float:
    """How far the colours of two pictures are from each other, on the mean."""
    if one.size != other.size:
        return 255.0
    a, b = (numpy.asarray(picture.convert("RGB"), float) for picture in (one, other))
    return float(abs(a - b).mean())


class Notebook(unittest.TestCase):
    def test_it_shows_a_picture(self):
        code, = (block for block in FENCE.findall(PAGE.read_text(encoding="utf-8")) if "matplotlib" in block)
        (picture,), = notebook.pictures(code)
        self.assertGreater(len(picture), 20_000)  # a single colour has a tenth of that

    def test_a_cell_that_fails_is_noticed(self):
        with self.assertRaisesRegex(nbclient.exceptions.CellExecutionError, "there is no"):
            notebook.pictures("import hashnoise\nhashnoise.grid('fmb', (8, 8), step=1)\n")

    def test_pictures_of_the_page_are_those_of_its_cells(self):
        made = notebook.made()
        self.assertGreaterEqual(len(made), 4)
        for name, picture in made.items():
            with self.subTest(name):
                self.assertLess(difference(Image.open(notebook.PAGE.parent / name), picture), NEAR)
        self.assertEqual({(notebook.PAGE.parent / name).resolve() for name in made},
                         {*(notebook.PAGE.parents[1] / "images").glob("notebook-*.png")})
        self.assertLess(sum((notebook.PAGE.parent / name).stat().st_size for name in made), OF_PAGE)

    def test_another_picture_is_noticed(self):
        code = ("import hashnoise\nimport matplotlib.pyplot as plt\n"
                "plt.imshow(hashnoise.grid('fbm', (64, 64), step=1 / 16, {}))\n")
        these, others, alone = notebook.pictures(code.format("seed=1"), code.format("seed=2"), "1 + 1\n")
        self.assertGreater(difference(notebook.small(these[0]), notebook.small(others[0])), 5 * NEAR)
        self.assertEqual(alone, [])
        part = Image.open(io.BytesIO(these[0])).crop((0, 0, 9, 9))
        self.assertEqual(difference(notebook.small(these[0]), part), 255.0)
