"""Tests of own.py: functions that people write are proven, or the step is named that cannot be seen through, with its
line."""

import contextlib
import io
import re
import tempfile
import unittest
import unittest.mock
from pathlib import Path

import numpy as np

from base.thorough import in_thorough_runs, some
from proof.bounds import command, own
from proof.bounds.rounded import EXACT, Body, Text, roundings
from proof.bounds.table import bounds_of

# A lattice noise with ramps along a diagonal and a smoothstep, as floats and vectors of the library.
LATTICE = """
  hn_vec2 cell = floor(p);
  hn_vec2 f = p - cell;
  hn_ivec2 i = ivec2(cell);
  hn_vec2 t = f * f * (f * -2.0f + 3.0f);
  hn_float v[4];
  for (int k = 0; k < 4; ++k) {
    hn_float dx = f.x - float(k & 1);
    hn_float dy = f.y - float(k >> 1);
    hn_uint h = hn_lattice(i + ivec2(k & 1, k >> 1), seed);
    v[k] = float(h >> 8u) * 5.9604644775390625e-8f * (dx * dx + dy) - dy * 0.3f;
  }
  hn_float low = v[0] + t.x * (v[1] - v[0]);
  hn_float high = v[2] + t.x * (v[3] - v[2]);
  hn_float n = low + t.y * (high - low);
"""
FILE = f"""// A file of somebody else.
#version 460
#include "hash.glsl"
#include "random2d.glsl"
precision highp float;
const float THIRD = 1.0 / 3.0;
float ramps(vec2 p, uint seed) {{{LATTICE}  return n; }}
float wave(vec2 p) {{ return sin(p.x); }}
float pole(vec2 p, float a) {{ return 1.0 / (fract(p.x) - a); }}
float below(float x) {{
  return x < 0.5 ? hn_random(x) : x * THIRD;
}}
float grows(vec2 p) {{
  float x = p.x + 100.0;
  for (int k = 0; k < 8; ++k) x *= x;
  return x;
}}
vec2 saws(vec2 p) {{ return fract(p.yx) * vec2(0.5, THIRD); }}
float tiles(hn_place2 place) {{ return hn_random(place, 3u) * 0.5; }}
"""
SHOWN = (  # for each function
    r"ramps\(vec2 p, uint seed\)\n  value        in \[-0\.\d+, 0\.\d+\], .* error \d\.\d\de-\d from a position \(\d+ boxes,",
    r"wave\(vec2 p\)\n  value +cannot be proven: GLSL states no error of sin at FILE:23",
    r"pole\(vec2 p, float a\)\n  value +cannot be proven: a quotient by what may be 0 at FILE:24, for fractions in \[.*\] x",
    r"grows\(vec2 p\)\n  value +cannot be proven: a number beyond floats at FILE:30",
    r"saws\(vec2 p\)\n  x +in \[.*, 0.5\], .* error 2\.99e-8 from a position.*\n  y +in \[.*, 0\.333",
    r"tiles\(place2 place\)\n  value +in \[0, 0\.5\], .* error 0\.0 from a cell .*\n +error 0\.0 from a position")


def of_file(text, *options):
    """The exit status, and the printed text."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "own.glsl")
        path.write_text(text, encoding="utf-8")
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown), contextlib.redirect_stderr(shown):
            status = command.main([str(path), *options])
    return status, shown.getvalue().replace(str(path), "FILE")


class Files(unittest.TestCase):
    @unittest.mock.patch.object(own, "SECONDS", 0.4)
    def test_each_function_is_proven_or_its_step_is_named(self):
        status, shown = of_file(FILE)
        self.assertEqual(status, 1)
        for expected in SHOWN:
            self.assertRegex(shown, expected)

    def test_a_file_that_does_not_compile(self):
        self.assertEqual(of_file("float f(vec2 p) {\n  return hn_worley(p);\n}\n"),
                         (2, "FILE:2: ‘hn_worley’ was not declared in this scope\n"))

    def test_requests_that_do_not_fit(self):
        self.assertEqual(of_file("float f(vec2 p) { return p.x; }", "--function", "g"),
                         (2, "--function g: the file has no such function\n"))
        self.assertEqual(of_file("float f(uint i) { return 0.0; }")[0], 2)
        with self.assertRaises(SystemExit) as stopped, contextlib.redirect_stderr(io.StringIO()):
            command.main(["own.glsl", "--within", "a=b"])
        self.assertEqual(stopped.exception.code, 2)

    @in_thorough_runs
    def test_a_bound_holds(self):
        """Beside runs with bad roundings, and is no more than some of them times 10."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "own.glsl")
            path.write_text(f'#include "hash.glsl"\nfloat ramps(vec2 p, uint seed) {{{LATTICE}  return n; }}')
            (result,), _ = own.prove(path, [], {})
        code = (f"hn_vec2 p = vec2(float_of(a.x), float_of(a.y)); hn_uint seed = a.z; {LATTICE} "
                "return uvec4(bits_of(n), 0u, 0u, 0u);")
        text = Text([], ramps=Body.of("x:f32 y:f32 seed:u32", "value:f64", code))
        rng = np.random.default_rng(5)
        columns = {axis: (rng.integers(-64, 64, 20_000) + rng.random(20_000)).astype(np.float32).astype(float)
                   for axis in "xy"}
        columns["seed"] = rng.integers(0, 2**32, 20_000)
        exact, = text("ramps", EXACT, **columns)
        worst = max(abs(text("ramps", rounding, **columns)[0] - exact).max() for rounding in some(roundings(1), 1, 3))
        self.assertTrue(result.proven["error"].bound / 10 < worst < result.proven["error"].bound, (worst, result.proven["error"].bound))
        self.assertTrue(-result.proven["least"].bound <= exact.min() and exact.max() <= result.proven["most"].bound)

    @in_thorough_runs
    def test_a_fractal_of_the_librarys_noises(self):
        """Two octaves, and the same without the error of a place: must-fail checks of what adds up."""
        octave = "s += {}.5 * hn_simplex(p, {}u); p = p * {} + vec2(17.0, 5.0);"
        file = ('#include "simplex2d.glsl"\n' + "".join(
            f"float f{turn}(vec2 p) {{ float s = 0.0; {octave.format(0, 1, by)} {octave.format(0, 2, by)} return s; }}\n"
            for turn, by in enumerate(("2.0", "2.03"))))
        with unittest.mock.patch.object(own, "SECONDS", 1):
            status, shown = of_file(file)
        self.assertEqual(status, 0)
        exact, rounded = (float(error) for error in re.findall(r"error (\S+), as a sum", shown))
        one = bounds_of("simplex", 2, "none")
        self.assertTrue(one.error < exact < rounded < 0.01, shown)
        self.assertGreater(rounded - exact, 0.5 * one.lipschitz * 130 * 2**-24)


class Transformation(unittest.TestCase):
    def test_what_cpp_does_not_know(self):
        for glsl, cpp in (
                ("return a < b ? x : y;", "return choice( a < b , [&] { return  x ; }, [&] { return  y; });"),
                ("f(a ? 1 : p, c ? d ? q : r : 5u)", "f( choice(a , [&] { return  Int(1) ; }, [&] { return  p; }), choice( c , "
                 "[&] { return  choice( d , [&] { return  q ; }, [&] { return  r ; }); }, [&] { return  Uint(5u); }))"),
                ("p.yx * g(p, v[1], w[i]).xxz", "swizzled<1, 0>(p) * swizzled<0, 0, 2>(g(p, v[1], w[element(i)]))"),
                ("void f(in highp vec2 p, out float q)", "void f(  vec2 p, float& q)"),
                ("x.y = 1. + .5e1f;", "x.y = 1._f + .5e1_f;")):
            self.assertEqual("".join(own.plain(own.tokens_of(glsl))), cpp)

    def test_functions(self):
        text = "float a(vec2 p) { return b(p.x); }\nfloat b(float x) { return x; }\nfloat a(hn_place2 p, uint s) { return 0.0; }"
        self.assertEqual([str(one) for one in own.functions_of(text, [])], ["float a(vec2 p)", "float a(place2 p, uint s)"])
        self.assertEqual([one.name for one in own.functions_of(text, ["b"])], ["b"])
