"""Evaluates GLSL at many places, by Mesa's software renderer: libOSMesa, through ctypes."""

from __future__ import annotations

import ctypes
from array import array

LIBRARIES = ("libOSMesa.so.8", "libOSMesa.so.6")  # both are names of Mesa's; Debian has the first
RGBA, FLOAT = 0x1908, 0x1406
FRAGMENT, VERTEX = 0x8B30, 0x8B31
COMPILED, LINKED = 0x8B81, 0x8B82
TRIANGLES = 4
RENDERER, VERSION = 0x1F01, 0x1F02
SIDE = 512  # so a quarter of a million places: deviations and sizes of other seeds differ by less than 1%
# OSMesaCreateContextAttribs takes pairs, ended by a 0: pixels of four floats, in a core profile of OpenGL 4.5,
# the newest that this renderer has.
CONTEXT = (0x22, RGBA, 0x33, 0x34, 0x36, 4, 0x37, 5, 0)
# One triangle that covers every pixel.
CORNERS = """
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
"""


class NoRenderer(OSError):
    pass


class NotCompiled(ValueError):
    pass


class Renderer:
    """A context that draws into a square of pixels, which keep the four floats that a shader writes, unclamped."""

    def __init__(self, side: int = SIDE) -> None:
        self.side = side
        self._mesa = _library()
        attributes = (ctypes.c_int * len(CONTEXT))(*CONTEXT)
        self._context = _function(self._mesa.OSMesaCreateContextAttribs, ctypes.c_void_p)(attributes, None)
        self._pixels = (ctypes.c_float * (4 * side * side))()
        self._make_current()
        self._program = 0
        self._call("glGenVertexArrays", 1, vertices := (ctypes.c_uint * 1)())
        self._call("glBindVertexArray", vertices[0])
        self._call("glViewport", 0, 0, side, side)

    def program(self, fragment: str) -> int:
        """Compiles a fragment shader, in place of the one before; NotCompiled has the log of the driver. Below
        `#version 300 es` the driver computes mediump with 16 bits, as a phone does."""
        self._make_current()
        version = fragment.splitlines()[0]
        self._call("glDeleteProgram", self._program)
        self._program = program = self._call("glCreateProgram")
        for kind, text in ((VERTEX, version + CORNERS), (FRAGMENT, fragment)):
            shader = self._call("glCreateShader", kind)
            self._call("glShaderSource", shader, 1, (ctypes.c_char_p * 1)(text.encode()), None)
            self._call("glCompileShader", shader)
            self._check("Shader", shader, COMPILED)
            self._call("glAttachShader", program, shader)
            self._call("glDeleteShader", shader)  # it goes with the program
        self._call("glLinkProgram", program)
        self._check("Program", program, LINKED)
        return program

    def draw(self, program: int, **uniforms: tuple[float, float, float, float]) -> array[float]:
        """The pixels, from the left and from below."""
        self._make_current()
        self._call("glUseProgram", program)
        for name, vector in uniforms.items():
            place = self._call("glGetUniformLocation", program, name.encode())
            self._call("glUniform4f", place, *(ctypes.c_float(number) for number in vector))
        self._call("glDrawArrays", TRIANGLES, 0, 3)
        self._call("glFinish")
        return array("f", bytes(self._pixels))

    @property
    def version(self) -> str:
        """The renderer and its driver, in its own words."""
        self._make_current()
        words = (self._call("glGetString", name, result=ctypes.c_char_p) for name in (RENDERER, VERSION))
        return ", ".join(word.decode() for word in words)

    def _make_current(self) -> None:
        """Before each use, since another renderer may have been made meanwhile."""
        context = ctypes.c_void_p(self._context)
        if not self._context or not self._mesa.OSMesaMakeCurrent(context, self._pixels, FLOAT, self.side, self.side):
            raise NoRenderer("libOSMesa makes no context of OpenGL 4.5")

    def _check(self, kind: str, name: int, what: int) -> None:
        self._call(f"glGet{kind}iv", name, what, done := (ctypes.c_int * 1)())
        if not done[0]:
            self._call(f"glGet{kind}InfoLog", name, 4000, None, log := ctypes.create_string_buffer(4000))
            raise NotCompiled(log.value.decode(errors="replace"))

    def _call(self, name: str, *arguments: object, result: type = ctypes.c_int) -> int:
        address = _function(self._mesa.OSMesaGetProcAddress, ctypes.c_void_p)(name.encode())
        return ctypes.CFUNCTYPE(result)(address)(*arguments)


def _function(function: ctypes._CFuncPtr, result: type) -> ctypes._CFuncPtr:
    function.restype = result
    return function


def _library() -> ctypes.CDLL:
    for name in LIBRARIES:
        try:
            return ctypes.CDLL(name)
        except OSError:
            pass
    raise NoRenderer("libOSMesa is not here: Debian's package is libosmesa6")
