"""Tests of own.py: the functions of users have the values that GLSL gives them, each lane goes its own way, and other text
is refused at its line."""

import contextlib
import functools
import io
import math
import re
import tempfile
import unittest
import unittest.mock
from pathlib import Path

from proof.errors import own

HEAD = """\ufeff// A file of somebody else.
#version 460
#extension GL_ARB_something : enable
#include "noise2d.glsl"
#include <hashnoise/hash.glsl>
#include "beside.glsl"
#ifdef GL_ES
precision mediump float;
#endif
precision highp float;
#define SQUARE(x) ((x) * (x))
#define PI 3.14159
uniform float time;
const float QUARTER = 1.0 / 4.0, HALF = QUARTER * 2.0;
const int N = 3;
const float WEIGHTS[] = float[](1.0, 2.0, 4.0);
float counter = 0.5;
struct Ray { vec2 o; vec2 d; float t; int st; };
float bump() { counter += 1.0; return counter; }
void sets(in float x, out float a, inout vec2 v) { a = x * 2.0; v.x += a; v = v.yx; }
void twice(inout float x, inout float y, out float z) { x += 1.0; y += 10.0; z = x; }
float sum(float a[3]) { a[0] = 100.0; float s = 0.; for (int i = 0; i < a.length(); i++) s += a[i]; return s; }
Ray moved(Ray r, float t) { r.o += r.d * t; return r; }
float thrice(float p) { return p * 3.0; }
"""
BESIDE = """#ifndef BESIDE
#define BESIDE
#include "beside.glsl"
float beside(vec2 p) { return p.x * 2.0; }
#endif
"""
# Bodies of functions of a float p, which is 1, and their values. Nothing in them rounds.
VALUES = {
    "return HALF + float(N);": 3.5,
    "bump(); bump(); return counter;": 2.5,
    "float a; vec2 v = vec2(1, 2); sets(3.0, a, v); return a * 100.0 + v.x * 10.0 + v.y;": 627,
    "float a[3] = float[3](1.0, 2.0, 3.0); float s = sum(a); return s + a[0] * 1000.0;": 1105,
    "float s = 0.0; for (int i = 0; i < N; ++i) { s += WEIGHTS[i]; } return s;": 7,
    "Ray r = Ray(vec2(1.0), vec2(2.0, 3.0), 4.0, 5); Ray q = moved(r, 2.0);"
    " return q.o.x + 10. * q.o.y + 100. * r.o.x + float(q.st) * 1000.;": 5175,
    "int i = int(p) * 7; uint u = uint(p) * 3u - 4u; float x = 1; x += 2; return float(i / 2) + float(u >> 31u) * 10.0"
    " + x * 100.0 + float(-i / 2) * 1000.0;": -2687,
    "vec4 v = vec4(1.0, 2.0, 3.0, 4.0); v.yx += 10.0; v.zw = v.xy; v.xy = v.yx; return v.x + v.z * 100.0"
    " + v.wzyx.y * 10000.0;": 12 + 1100 + 110000,
    "mat2 m = mat2(1, 2, 3, 4); vec2 v = m * vec2(1.0, 10.0); vec2 w = vec2(1.0, 10.0) * m; mat2 q = m * m; m[0].x = 9.0;"
    " return v.x + v.y * 100.0 + w.x * 1e4 + q[1][0] + m[0][0] * 0.25;": 31 + 4200 + 210000 + 15 + 2.25,
    "mat3 m = mat3(2.0); m[1] = vec3(1, 2, 3); mat4 n = mat4(m); return (m * vec3(1.0, 1.0, 1.0)).x + n[3][3] * 10.0"
    " + transpose(m)[0].y * 100.0;": 113,
    "float x = 1.0; { float x = x + 1.0; x *= 10.0; if (x != 20.0) return -1.0; } return x;": 1,
    "float thrice = thrice(2.0); return thrice;": 6,
    "int i = 0; float s = float(i++); s += 10.0 * float(++i); i--; --i; float x = 1.0; x++; return s + float(i) * 100.0"
    " + x * 1000.0;": 2020,
    "int i = 0; while (true) { i++; if (i > 10) break; if (i % 2 == 0) continue; } do { i += 100; } while (i < 300);"
    " return float(i);": 311,
    "bool a = p > 0.5, b = !a; int k; float w[2]; w[0] = 1.0; w[1] = 2.0; for (k = 0; k < 2 && w[k] < 10.0; ++k) ;"
    " return float(a) + float(b) * 10.0 + (a || b ? 100.0 : 200.0) + (a && !b ? 1000. : 2000.) + float(k) * 1e4"
    " + (b == a ? 1e6 : 0.0);": 21101,
    "int i = int(p * 4.0); switch (i) { case 0: return 1.0; case N + 1: return 2.0; default: return 3.0; }": 2,
    "float h = p * 2.5; return floor(h) + ceil(h) * 10.0 + fract(h - 0.25) + abs(h - 5.5) * 100.0 + sign(-h) * 1000.0 + trunc(-h)"
    " + clamp(h * 2.0, 0.0, 2.0) * 1e5 + round(h + 0.25) + max(0, h - 0.5) * 1e4;": 2 + 30 + .25 + 300 - 1000 - 2 + 200000 + 3 + 20000,
    "ivec2 i = ivec2(vec2(3.75, -3.75) * p); uvec2 u = uvec2(7u, 9u) / uint(p * 2.0); i /= 2; int zero = 0; zero = 1 / zero;"
    " return float(i.x) + float(i.y) * 10.0 + float(u.x) * 100.0 + float(u.y) * 1000.0;": 4291,
    "int i = -8, one = int(p), six = 6; uint u = 0x80000000u; return float(i >> 1u) + float(u >> 31) * 10.0"
    " + float(one << 4) * 100.0 + float(~(one - 1)) * 1000.0 + float(six & 3) * 1e4 + float(six ^ 3) * 1e5;": 520606,
    "uvec2 u = uvec2(1u, 2u); u ^= u << 4u; u.x += u.y % 5u; ivec3 i = ivec3(7, -8, 9) % 4; i.xz = (i.xz | 8) >> ivec2(1, 2);"
    " ivec2 z = ivec2(4, 6) / ivec2(2, 0); return float(u.x) + float(u.y) * 100.0 + float(i.x) * 1e4 + float(i.z) * 1e5"
    " + float((~z).x) * 1e6;": 21 + 3400 + 50000 + 200000 - 3e6,
    "uint u = uint(p) - 2u; switch (u) { case 0xffffffffu: return 1.0; default: return 2.0; }": 1,
    "return SQUARE(p + 2.0) + step(0.5, p);": 10,
    "return p < 0.0 ? 1.0 : p < 2.0 ? 2.0 : 3.0;": 2,
    "vec3 v = vec3(1.0, 2.0, 3.0); for (int i = 0; i < 3; i++) v[i] *= 2.0; return v[0] + v[1] * 10. + v[2] * 100.0;": 642,
    "vec2 a = vec2(1.0, 2.0); return (a == vec2(1, 2) ? 1.0 : 0.0) + (a != vec2(1.0) ? 10.0 : 0.0);": 11,
    "return uintBitsToFloat(floatBitsToUint(p) + 0x00800000u);": 2,
    "vec3 v = vec3(1.0, 2.0, 3.0); float a; sets(3.0, v.z, v.xy); twice(v.x, v.x, a); return v.x + v.y * 10.0 + v.z * 100.0"
    " + a * 1000.0;": 3682,
    "bvec2 b = lessThan(vec2(1.0, 3.0), vec2(2.0)); mat2x3 m = mat2x3(1, 2, 3, 4, 5, 6); uint carry; return float(any(b))"
    " + float(all(b)) * 10.0 + (m * vec2(1.0, 10.0)).z * 100.0 + outerProduct(vec2(1.0, 2.0), vec2(3.0, 4.0))[1][0] * 1e5;":
        1 + 6300 + 400000,
    "vec3 v = vec3(p, 2., 3.), c = cross(v, vec3(4., 5., 7.)); return dot(v, vec3(1.)) + c.x * 10. + c.y * 100. + c.z * 1000.\n"
    " + reflect(vec2(p, -1.), vec2(0., 1.)).y * 1e4 + mix(p, 3.0, 0.5) * 1e5 + faceforward(v, v, -v).y * 1e6;":
        6 - 10 + 500 - 3000 + 1e4 + 2e5 + 2e6,
    "return fma(p, 2.0, 3.0) + mod(p * 5.0, 3.0) * 10.0 + min(p, 2.0) * 100.0 + float(abs(int(-p)) + clamp(int(p), 3, 4)) * 1e3"
    " + length(-p) * 1e5 + distance(p, 3.0) * 1e6;": 25 + 100 + 4e3 + 1e5 + 2e6,
    "return radians(p * 180.0);": 3.14159265,
    "return degrees(p);": 57.2957795,
    "bvec2 b = lessThan(vec2(p, 3.0), vec2(2.0)); return mix(vec2(1.0), vec2(5.0), b).x + (mat3x2(p, 2, 3, 4, 5, 6) * vec3(1.0)).y"
    " * 10.0;": 125,
    "float a[2][3]; a[1][2] = 4.0; float[2] b = float[2](1.0, 2.0); return a[1][2] + b[1];": 6,
    "vec2 uv = vec2(1.0, 2.0); Ray r; r.st = 4; return uv.st.y + float(r.st) * 10.0;": 42,
    "vec2 new = vec2(p, 4.0); float and = new.y; return and + smoothstep(0.0, 2.0, p) * 2.0;": 5,
}
# The least and the greatest error that the search may find, and the values.
CLAIMS = {
    "float written(vec2 q) { vec2 v = fract(q); v.xy = v.xy * 100.0; return v.x; }": (1e-6, 1e-4, 0, 100),
    "float decides(vec2 q) { float n = floor(hn_perlin(q, 1u) * 40.0); if (n == 0.0) return 1.0; return 0.0; }": (1, 1, 0, 1),
    "float whole(vec2 r) { return floor(r.x); }": (0, 0, 0, 0),  # r is in [0, 0.5]
    "float root(vec2 q) { vec2 v = normalize(q); return sqrt(1.0 - v.x * v.x); }": (math.inf, math.inf, 0, 1),
    "float tenth(vec2 q) { return 0.1; }": (1e-9, 2e-9, 0.1, 0.1),  # a literal that is no float
    "float far(vec2 r) { vec2 v = vec2(3.0, 4.0) * step(r.x, 1.0); return length(v) + inversesqrt(distance(v, -v)); }":
        (1e-7, 1e-5, 5.3, 5.4),
    "float rest(vec2 q) { return q.x - trunc(q.x); }": (0, 0, -1, 1),
    "float other(vec2 q) { return beside(q) * PI; }": (1e-5, 1e-3, -403, 403),
    "float place(hn_place2 at, uint seed) { return hn_perlin(at, seed); }": (1e-7, 3e-6, -1, 1),
}
# The number n differs from lane to lane. Each returns 0, if each lane goes its own way: behind the minus nothing is decided.
WAYS = """float n_of(vec2 q) { return fract(hn_perlin(q, 1u) * 1e6); }
float some(float n) { if (n < 0.5) { if (n < 0.25) return 1.0; else return 2.0; } return n < 0.75 ? 3.0 : 4.0; }
float way_if(vec2 q) { float n = n_of(q); return some(n) - (1.0 + step(0.25, n) + step(0.5, n) + step(0.75, n)); }
float way_while(vec2 q) {
  float n = n_of(q) * 8.0, i = 0.0, other = 0.0;
  while (true) { if (i > n) { break; } i += 1.0; if (i >= 8.0) break; }
  for (int k = 0; k < 8; k++) other += step(float(k), n);
  return i - other;
}
float way_index(vec2 q) {
  int i = int(n_of(q) * 4.0);
  float w[4] = float[](1.0, 2.0, 3.0, 4.0);
  w[i] = 10.0;
  return w[0] + w[1] + w[2] + w[3] - (19.0 - float(i));
}
float way_logic(vec2 q) {
  float n = n_of(q);
  bool a = n > 0.5 && n * 2.0 < 1.5 || n < 0.125;
  return float(a) - ((1.0 - step(n, 0.5)) * (1.0 - step(1.5, n * 2.0)) + (1.0 - step(0.125, n)));
}
float way_continue(vec2 q) {
  float n = n_of(q) * 8.0, s = 0.0, other = 0.0;
  for (int k = 0; k < 8; k++) { if (float(k) < n) continue; s += 1.0; }
  for (int k = 0; k < 8; k++) other += step(n, float(k));
  return s - other;
}
float way_switch(vec2 q) {
  int i = int(n_of(q) * 4.0);
  switch (i) { case 0: return 0.0; case 1: return 1.0 - float(i); default: return float(i) - floor(float(i)); }
}
"""
# With the line of each refusal, from 1 on; "ok" are measured all the same.
REFUSED = (
    ("float ok(vec2 p) { return p.x; }", ""),
    ("uniform float time; uniform sampler2D picture;", ""),
    ("float timed(vec2 p) { return p.x * time; }", "time is a uniform of a shader"),
    ("float pictured(vec2 p) { return texture(picture, p).x; }", "picture is a uniform of a shader"),
    ("float coarse(vec2 p) { mediump float x = p.x; return x; }", "mediump: such floats may have 10 bits"),
    ("float slope(vec2 p) { return dFdx(p.x); }", "dFdx needs a shader that runs"),
    ("float wave(vec2 p) { return sin(p.x); }", "GLSL states no error of sin"),
    ("float power(vec2 p) { return pow(p.x, 2.0); }", "the search does not take pow"),
    ("float unknown(vec2 p) { return hidden(p); }", "hidden: no matching overloaded function found"),
    ("float undeclared(vec2 p) { return p.x + q; }", "q: undeclared identifier"),
    ("float wrong(vec2 p) { return mix(p.x, 1.0); }", "mix: no matching overloaded function found"),
    ("float half_of(vec2 p) { int i = 1.5; return p.x; }", "=: cannot convert from 'float' to 'int'"),
    ("float endless(vec2 p, int n) { for (int i = 0; i < n; i++) p.x += 1.0; return p.x; }", "a loop has more than 100,000 rounds"),
    ("float drawn(vec2 p, mat2 m) { return p.x; }", "the search draws no mat2, as m"),
    ("float sets(vec2 p, out float m) { m = 1.0; return p.x; }", "m is an out parameter"),
    ("vec2 last(vec2 p) { return p; }", ""),
    ("float again(vec2 p) { return p.x > 0.0 ? again(p - 1.0) : 0.0; }", "again calls itself"),
    ("varying vec2 uv; out vec4 color; void main() { color = vec4(ok(gl_FragCoord.xy)); }", ""),
    ("float none(vec2 p) { return float(p.xy == p.yx) + 1.0 + vec2(1.0); }", "return: cannot convert return value"),
)
CALLER = "\nfloat bad(vec2 p) { return sin(p.x); } float bad(float x) { return x; }\nfloat caller(vec2 p) { return bad(p); }\n"
CALLERS = "float deep(vec2 p) { return cos(p.x); }\nfloat middle(vec2 p) { return deep(p); }\nfloat top(vec2 p) { return middle(p); }\n"


@contextlib.contextmanager
def file_of(text):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "beside.glsl").write_text(BESIDE, encoding="utf-8")
        path = Path(folder, "own.glsl")
        path.write_text(text, encoding="utf-8")
        yield path


def printed(text, wanted=(), within=None):
    """The exit status, and the printed text."""
    shown = io.StringIO()
    with file_of(text) as path, contextlib.redirect_stdout(shown), contextlib.redirect_stderr(shown):
        status = own.report(path, wanted, within or {})
    return status, shown.getvalue().replace(str(path), "FILE")


def quick():
    return unittest.mock.patch.multiple(own, LEAST=2000, MOST=2000)


@functools.cache
def of_all():
    """The results of the functions that are taken, by their names."""
    functions = [f"float value{i}(float p) {{ {body} }}" for i, body in enumerate(VALUES)]
    text = f"{HEAD}{chr(10).join(functions)}\n{chr(10).join(CLAIMS)}\n{WAYS}"
    with quick(), file_of(text) as path:
        found = own.results(path, [], {"p": "1", "r": "0:0.5"})
    return {result.function.name: result for result in found}


class Taken(unittest.TestCase):
    def test_the_values_are_those_of_glsl(self):
        for number, (body, value) in enumerate(VALUES.items()):
            with self.subTest(body):
                result = of_all()[f"value{number}"]
                self.assertEqual(result.function.refused, "")
                one, = result.found
                self.assertEqual((one.least, one.most), (value, value))
                self.assertLessEqual(one.error, 3e-7 * value if re.search("HALF|smooth|radians|degrees", body) else 0)

    def test_functions_on_one_line(self):
        shown = printed("#define F(name, k) float name(vec2 p) { return p.x * k; }\nF(one, 1.0) F(two, 2.0)", within={"p": "-1:1"})[1]
        self.assertRegex(shown, r"one\(vec2 p\)\n  value   error 0; values in \[-1, 1\]")
        self.assertRegex(shown, r"two\(vec2 p\)\n  value   error 0; values in \[-2, 2\]")

    def test_the_errors_are_found(self):
        for text, (least, most, low, high) in CLAIMS.items():
            with self.subTest(text):
                one, = of_all()[re.match(r"float (\w+)", text)[1]].found
                self.assertTrue(least <= one.error <= most, one)
                self.assertTrue(low <= one.least <= one.most <= high, one)

    def test_the_printed_place_gives_the_error_again(self):
        result = of_all()["decides"]
        place = own.place_of(result.measured, result.found[0].words)
        self.assertRegex(place, r"^q=\(-?[\d.e-]+, -?[\d.e-]+\)$")
        numbers = re.findall(r"-?[\d.]+(?:e-?\d+)?", place)
        again, = result.program.search(
            result.function.id, [f"float:{x}:{x}" for x in numbers], ["0:inf:one"], 200)
        self.assertEqual(again.error, 1)


class Ways(unittest.TestCase):
    NAMES = tuple(re.findall(r"float (way_\w+)", WAYS))

    def test_each_lane_goes_its_own_way(self):
        for name in self.NAMES:
            one, = of_all()[name].found
            self.assertEqual((one.error, one.least, one.most), (0, 0, 0), name)

    def test_one_way_for_all_is_found_wrong(self):
        """A must-fail check of the one above: with the answer of the first lane."""
        with quick(), file_of(f"{HEAD}{WAYS}") as path:
            found = own.results(path, [], {}, "HN_I_DECIDED(answers)=((answers)[0]!=0)")
        for result in found:
            if result.function.name in ("way_if", "way_while", "way_logic", "way_continue"):
                self.assertGreater(result.found[0].error, 0, result.function.name)


class Refusals(unittest.TestCase):
    def test_each_at_its_line_and_the_others_are_measured(self):
        with quick():
            status, shown = printed("\n".join(line for line, _ in REFUSED) + CALLER)
        self.assertEqual(status, 1)
        for number, (line, reason) in enumerate(REFUSED, 1):
            name = re.match(r"\w+ (\w+)\(", line)
            if name:
                expected = rf"refused: FILE:{number}: .*{re.escape(reason)}" if reason else r"\w* +error 0; values in"
                self.assertRegex(shown, rf"FILE:{number}: \w+ {name[1]}\(.*\)\n  {expected}")
        self.assertRegex(shown, r"caller\(vec2 p\)\n  refused: .*GLSL states no error of sin")
        self.assertNotIn("proven", shown)

    def test_callers_are_refused_without_a_compiler(self):
        status, shown = printed(CALLERS)
        self.assertEqual((status, shown.splitlines()[:2]),
                         (1, ["FILE:3: float top(vec2 p)", "  refused: FILE:1: GLSL states no error of cos"]))

    def test_requests_that_do_not_fit(self):
        file = "float f(vec2 p) { return p.x; }"
        for text, wanted, within, expected in (
                (file, ["g"], {}, "--function g: the file has no such function"),
                (file, [], {"q": "0:1"}, "--within q: no function that is measured has such an argument"),
                (file, [], {"p": "1:0"}, "--within p=1:0: the first number is greater"),
                (file, [], {"p": "a"}, "--within p=a: write NAME=LO:HI"),
                ("float f(uint i) { return 0.0; }", [], {}, "no function takes a position"),
                ("#include \"missing.glsl\"\n" + file, [], {}, "missing.glsl: No such file"),
                ("#error no\n", [], {}, "FILE:1: #error no"),
                ("float f(vec2 p) { return p.x; ", [], {}, "FILE:1: a { has no }")):
            with self.subTest(text=text, within=within):
                status, shown = printed(text, wanted, within)
                self.assertEqual(status, 2)
                self.assertIn(expected, shown)
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(own.report(Path("/there/is/none.glsl"), [], {}), 2)

    def test_without_its_programs(self):
        with unittest.mock.patch.object(own.shutil, "which", return_value=None):
            self.assertEqual(printed(""), (4, "tools/make errors FILE.glsl needs Debian's packages g++, glslang-tools, spirv-tools\n"))

    def test_variables_of_a_file(self):
        """Where one of them cannot be set, functions that use any are refused."""
        text = "uniform float t; float k = t * 2.0;\nfloat bad(vec2 p) { return k; }\nfloat good(vec2 p) { return 2.0; }"
        with quick():
            shown = printed(text)[1]
        self.assertRegex(shown, r"bad\(vec2 p\)\n  refused: FILE:1: t is a uniform of a shader")
        self.assertRegex(shown, r"good\(vec2 p\)\n  value   error 0; values in \[2, 2\]")

    def test_the_exact_noise_is_in_floats(self):
        """Also where the text has it in integers, with an error of 2^-15 or so."""
        text = "#define HN_ARITHMETIC HN_FIXED\n#include <hashnoise/noise2d.glsl>\nfloat f(vec2 q) { return hn_perlin(q, 1u); }"
        with quick(), file_of(text) as path:
            result, = own.results(path, [], {})
        self.assertTrue(5e-6 < result.found[0].error < 1e-4, result.found)

    def test_a_precision_of_all_floats(self):
        self.assertIn("mediump: such floats may have 10 bits", printed("precision mediump float;\nfloat f(vec2 p) { return p.x; }")[1])


class Text(unittest.TestCase):
    def test_numbers_are_shown_so_that_they_are_read_again(self):
        self.assertEqual([own.shown_word(word, kind) for word, kind in (
            (0x3f800000, "float"), (0x3dcccccd, "float"), (0xffffffff, "int"), (0xffffffff, "uint"), (1, "bool"))],
            ["1", "0.1", "-1", "4294967295", "true"])


if __name__ == "__main__":
    unittest.main()
