"""Evaluates GLSL at many places, by Mesa's software renderer."""

from __future__ import annotations

import os
from array import array

try:
    import moderngl
except ImportError:
    moderngl = None

SIDE = 512  # so a quarter of a million places: deviations and sizes of other seeds differ by less than 1%
LIBRARIES = {"libegl": "libEGL.so.1", "libgl": "libGL.so.1"}  # without the names that only developers have
MESA = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/usr/share/glvnd/egl_vendor.d/50_mesa.json"}  # beside other drivers
# One triangle that covers every pixel. uv goes from 0 to 1, for shaders of pages.
CORNERS = """
out vec2 uv;
void main() {
  uv = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * uv - 1.0, 0.0, 1.0);
}
"""


class NoRenderer(OSError):
    pass


class NotCompiled(ValueError):
    pass


class Renderer:
    """A context that draws into a square of pixels, which keep the four floats that a shader writes, unclamped."""

    def __init__(self, side: int = SIDE) -> None:
        if not moderngl:
            raise NoRenderer("this Python has no moderngl: Debian's package is python3-moderngl")
        os.environ |= {"EGL_PLATFORM": "surfaceless", "LIBGL_ALWAYS_SOFTWARE": "1", **MESA}
        try:
            self._context = moderngl.create_context(require=450, standalone=True, backend="egl", **LIBRARIES)
        except Exception as error:  # moderngl's is no class of its own
            raise NoRenderer(f"EGL makes no context of OpenGL 4.5: {error}") from None
        self._pixels = self._context.simple_framebuffer((side, side), dtype="f4")

    def program(self, fragment: str) -> moderngl.Program:
        """Compiles a fragment shader; NotCompiled has the log of the driver. Below `#version 300 es` the driver computes
        mediump with 16 bits, as a phone does."""
        with self._context:
            try:
                return self._context.program(vertex_shader=fragment.splitlines()[0] + CORNERS, fragment_shader=fragment)
            except moderngl.Error as error:
                raise NotCompiled(str(error)) from None

    def draw(self, program: moderngl.Program, rows: int | None = None, **uniforms: tuple[float, float, float, float]
             ) -> array[float]:
        """The pixels, from the left and from below: of all rows, or of so many."""
        with self._context:
            for name in uniforms.keys() & {*program}:  # the driver drops what the shader does not use
                program[name].value = uniforms[name]
            self._pixels.use()
            self._pixels.scissor = part = (0, 0, self._pixels.width, rows or self._pixels.height)
            square = self._context.vertex_array(program, [])
            square.render(moderngl.TRIANGLES, vertices=3)
            square.release()
            return array("f", self._pixels.read(part, components=4, dtype="f4"))

    @property
    def version(self) -> str:
        """The renderer and its driver, in its own words."""
        with self._context:
            return ", ".join(self._context.info[name] for name in ("GL_RENDERER", "GL_VERSION"))
