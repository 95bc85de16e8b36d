"""The recipes of the gallery: they compile in a shader, their pictures are theirs, and loops are closed."""

import pathlib
import shutil
import tempfile
import unittest

from readme import gallery
from readme.readme_test import compile_glsl


class Gallery(unittest.TestCase):
    def test_each_recipe_is_a_part_of_a_shader(self):
        self.assertGreaterEqual(len(gallery.recipes()), 10)
        for recipe in gallery.recipes():
            with self.subTest(recipe=recipe.name):
                done = compile_glsl(recipe.shader)
                self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_recipe_that_does_not_compile_is_found(self):
        recipe = gallery.recipes()[0]
        self.assertNotEqual(compile_glsl(recipe.shader.replace("hn_", "hm_")).returncode, 0)

    def test_the_pictures_are_those_of_the_code(self):
        self.assertEqual(gallery.draw(check=True), 0)

    def test_another_picture_is_found(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for path in gallery.PAGE.parent.glob("*.png"):
                shutil.copy(path, folder)
            shutil.copy(folder / "wood.png", folder / "marble.png")
            self.assertEqual(gallery.draw(check=True, folder=folder), 1)

    def test_loops_end_where_they_begin(self):
        loops = [recipe for recipe in gallery.recipes() if recipe.loops]
        self.assertGreaterEqual(len(loops), 2)
        functions = "\n".join(recipe.cpp for recipe in gallery.recipes())
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name, "loops.png")
            gallery.picture.draw([recipe.call("0.0") for recipe in loops], path, functions=functions)
            self.assertEqual(gallery.picture.draw([recipe.call("1.0") for recipe in loops], path, True, functions), 0)
            self.assertEqual(gallery.picture.draw([recipe.call("0.5") for recipe in loops], path, True, functions), 1)

    def test_code_without_a_picture_is_an_error(self):
        with tempfile.TemporaryDirectory() as name:
            page = pathlib.Path(name, "README.md")
            page.write_text("![A](a.png)\n\n```glsl\nvec3 b(vec2 uv) { return vec3(0.0); }\n```\n")
            self.assertRaisesRegex(ValueError, "must define vec3 a", gallery.recipes, page)
            page.write_text("```glsl\nvec3 b(vec2 uv) { return vec3(0.0); }\n```\n")
            self.assertRaisesRegex(ValueError, "below its picture", gallery.recipes, page)


if __name__ == "__main__":
    unittest.main()
