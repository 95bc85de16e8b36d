"""The recipes of the gallery: they compile in a shader, and loops are closed. Their pictures are a test of tools/make pages."""

import pathlib
import tempfile
import unittest

from ship.pages import gallery
from ship.pages.pages_test import compile_glsl


class Gallery(unittest.TestCase):
    def test_each_recipe_is_a_part_of_a_shader(self):
        self.assertGreaterEqual(len(gallery.recipes()), 10)
        for recipe in gallery.recipes():
            with self.subTest(recipe=recipe.name):
                done = compile_glsl(recipe.shader)
                self.assertEqual(done.returncode, 0, done.stdout)

    def test_loops_end_where_they_begin(self):
        loops = [recipe for recipe in gallery.recipes() if recipe.loops]
        self.assertGreaterEqual(len(loops), 2)
        with tempfile.TemporaryDirectory() as name:
            def sheet(time, file):
                return gallery.picture.Sheet(pathlib.Path(name, file), [recipe.call(time) for recipe in loops])

            begin, end, middle = (sheet("0.0", "begin.png"), sheet("1.0", "end.png"), sheet("0.5", "middle.png"))
            self.assertEqual(gallery.picture.draw([begin, end, middle], functions=gallery.functions()), 0)
            self.assertEqual(begin.path.read_bytes(), end.path.read_bytes())
            self.assertNotEqual(begin.path.read_bytes(), middle.path.read_bytes())

    def test_code_without_a_picture_is_an_error(self):
        with tempfile.TemporaryDirectory() as name:
            page = pathlib.Path(name, "README.md")
            page.write_text('<img src="a.png" width="256" alt="A">\n\n```glsl\nvec3 b(vec2 uv) { return vec3(0.0); }\n```\n')
            self.assertRaisesRegex(ValueError, "must define vec3 a", gallery.recipes, page)
            page.write_text("```glsl\nvec3 b(vec2 uv) { return vec3(0.0); }\n```\n")
            self.assertRaisesRegex(ValueError, "below its picture", gallery.recipes, page)
