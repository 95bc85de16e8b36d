"""tools/pack glsl-noise: what stands in for glsl-noise, its values, and its command line."""

from __future__ import annotations

import contextlib
import io
import json
import shutil
import tempfile
import unittest
from pathlib import Path

from base import glslang
from base.renderer import NoRenderer, Renderer
from base.thorough import THOROUGH, in_thorough_runs
from base.tree import version
from ship import command
from ship.glsl_noise import files
from ship.glsl_noise.files import File
from translate.single_file.files import text

SIDE = 64
NEAR = 1e-5  # the two are compiled otherwise, and floats may be contracted
CHOSEN = files.FILES if THOROUGH else files.FILES[::3]  # those of the plane


class Package(unittest.TestCase):
    def test_it_has_the_names_and_the_factors_of_the_page(self) -> None:
        self.assertEqual([(file.path, file.head, files.call(file)) for file in (*files.FILES[:2], *files.FILES[4::4])], [
            ("simplex/2d", "float snoise(vec2 p)", "1.24 * hn_simplex(0.72 * p, 0u)"),
            # Its text is older than that of webgl-noise, and has larger features.
            ("simplex/3d", "float snoise(vec3 p)", "hn_simplex(0.92 * p, 0u)"),
            ("classic/3d", "float cnoise(vec3 p)", "1.14 * hn_perlin(p, 0u)"),
            ("periodic/4d", "float pnoise(vec4 p, vec4 rep)", "1.31 * hn_perlin(hn_tile(p, ivec4(rep)), 0u)")])

    @in_thorough_runs
    def test_it_has_all_files_and_tells_them(self) -> None:
        with tempfile.TemporaryDirectory() as scratch, contextlib.redirect_stdout(io.StringIO()) as out:
            command.main(["glsl-noise", scratch])
            folder = Path(out.getvalue().strip())
            made = {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*.*")}
        self.assertEqual(folder.name, f"hashnoise-glsl-noise-{version()}")
        self.assertEqual({path for path in made if path.endswith(".glsl")}, {
            f"{folder}/{axes}d.glsl" for folder in ("simplex", "classic", "periodic") for axes in (2, 3, 4)})
        self.assertEqual(json.loads(made["package.json"])["version"], version())
        for file in files.FILES:
            text_of_module = made[f"{file.path}.js"].removeprefix("export default ").removesuffix(";\n")
            self.assertEqual(json.loads(text_of_module), made[f"{file.path}.glsl"])
            self.assertIn(f"`{file.head}`", made["README.md"])

    def test_glslify_sees_no_name_that_it_changes(self) -> None:
        text = "uvec2 a = uvec2(0x7FC000u, b0u); uint c = floatBitsToUint(d) + 12u;\n"
        self.assertEqual(files.for_glslify(text, "hn_"),
                         "#define hn_uvec2 uvec2\n#define hn_floatBitsToUint floatBitsToUint\n"
                         "hn_uvec2 a = hn_uvec2(uint(0x7FC000), b0u); uint c = hn_floatBitsToUint(d) + uint(12);\n")

    @unittest.skipUnless(shutil.which("glslangValidator"), "Debian's package glslang-tools is missing")
    def test_a_shader_may_have_several(self) -> None:
        all_of_them = "".join(map(files.glsl, CHOSEN))
        calls = " + ".join(f"{file.function}({', '.join([f'vec{file.axes}(1.5)'] * file.head.count('vec'))})"
                           for file in CHOSEN)
        shader = (f"#version 300 es\nprecision mediump float;\nout vec4 color;\n{all_of_them}"
                  f"void main() {{ color = vec4({calls}); }}\n")
        for given, status in ((shader, 0), (shader.replace("highp float pnoise", "highp float other", 1), 2)):
            done = glslang.compiled(given)
            self.assertEqual(done.returncode, status, done.stdout)


class Values(unittest.TestCase):
    """Beside the call of the library, at places that no cell has alike."""

    @classmethod
    def setUpClass(cls) -> None:
        try:
            cls.renderer = Renderer(SIDE)
        except NoRenderer as reason:
            raise unittest.SkipTest(str(reason)) from reason

    def differences(self, file: File) -> tuple[float, float]:
        """How far the two are from each other at most in a picture, and how far with another seed."""
        noise = "simplex" if file.folder == "simplex" else "perlin"
        library = text([f"{noise}{file.axes}d.glsl"], strip=True)
        period = f"vec{file.axes}(7.0)"
        own = files.call(file).replace("rep", period)
        passed = f"p, {period}" if file.folder == "periodic" else "p"
        pixels = self.renderer.draw(self.renderer.program(f"""#version 450
{library}
{files.glsl(file)}
out vec4 color;
void main() {{
  vec{file.axes} p = vec4(gl_FragCoord.xy * 0.37 - 9.0, gl_FragCoord.yx * 0.21 - 3.0).{'xyzw'[:file.axes]};
  float seeds[2];
  for (uint seed = 0u; seed < 2u; seed++) seeds[seed] = {own.replace('0u', 'seed')};
  color = vec4({file.function}({passed}), seeds[0], seeds[1], 0.0);
}}
"""))
        self.assertGreater(max(pixels[0::4]), 0.6)
        return tuple(max(abs(one - other) for one, other in zip(pixels[0::4], pixels[i::4])) for i in (1, 2))

    def test_they_are_those_of_the_library(self) -> None:
        for file in CHOSEN if THOROUGH else CHOSEN[2:]:
            with self.subTest(file.path):
                same, other = self.differences(file)
                self.assertLess(same, NEAR)
                self.assertGreater(other, 0.5)


if __name__ == "__main__":
    unittest.main()
