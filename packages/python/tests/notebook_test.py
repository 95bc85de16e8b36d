"""The page's notebook, by Jupyter's own kernel: it shows a picture."""

from __future__ import annotations

import base64
import unittest

import nbclient
import nbformat
from documents_test import FENCE, PAGE


def pictures(code: str) -> list[bytes]:
    """The PNGs that a cell shows."""
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    return [base64.b64decode(output.data["image/png"]) for output in notebook.cells[0].outputs
            if "image/png" in output.get("data", {})]


class Notebook(unittest.TestCase):
    def test_it_shows_a_picture(self):
        code, = (block for block in FENCE.findall(PAGE.read_text(encoding="utf-8")) if "matplotlib" in block)
        picture, = pictures(code)
        self.assertGreater(len(picture), 20_000)  # a single colour has a tenth of that

    def test_a_cell_that_fails_is_noticed(self):
        with self.assertRaisesRegex(nbclient.exceptions.CellExecutionError, "there is no"):
            pictures("import hashnoise\nhashnoise.grid('fmb', (8, 8), step=1)\n")


if __name__ == "__main__":
    unittest.main()
