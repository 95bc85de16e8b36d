// Bugs in statements, functions and types that one language alone has.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using uint = std::uint32_t;

// A bug in WGSL alone.
Bug wgsl(std::string_view id, std::vector<Column> inputs, std::vector<Column> outputs, std::string_view body,
         std::string_view reference, const Rule& rule, Points points, std::string_view declarations = "") {
  return in_wgsl(body, bug(id, std::move(inputs), std::move(outputs), "", reference, rule, std::move(points), "wgsl"),
                 declarations);
}

constexpr int kLowest = std::numeric_limits<int>::min();

// The quotient and the remainder of WGSL.
std::vector<std::uint32_t> divided(int x, int y) {
  const bool open = y == 0 || (x == kLowest && y == -1);
  const uint u = word(x);
  const uint v = word(y);
  return words(open ? x : x / y, open ? 0 : x % y, v == 0 ? u : u / v, v == 0 ? 0 : u % v);
}

// So many ones from the lowest bit on.
uint ones(uint count) { return count >= 32 ? 0xFFFFFFFFu : (1u << count) - 1u; }

}  // namespace

std::vector<Bug> language_bugs() {
  return {
      wgsl("bugs.zeroed_in_loop", {{"count", u32}, {"x", u32}}, {{"scalar", u32}, {"vector", u32}, {"element", u32}},
           "var last = vec3u();\n"
           "for (var i = 0u; i < min(a.x, 16u); i += 1u) {\n"
           "  var s: u32;\n  var v: vec2u;\n  var t: array<u32, 2>;\n"
           "  s += a.y;\n  v.y += a.y;\n  t[i & 1u] += a.y;\n  last = vec3u(s, v.y, t[i & 1u]);\n}\n"
           "return vec4u(last, 0u);",
           "gfx-rs/wgpu 9489; Tint of Chromium 156 as well, found here",
           defined(
               "WGSL, Variable and Value Declarations: a variable without an initial value is zero each time that its "
               "declaration is executed"),
           points<uint, uint>({{3, 5}, {1, 5}, {16, 7}, {0, 9}},
                              [](uint count, uint x) { return count == 0 ? words(0, 0, 0) : words(x, x, x); })),
      wgsl("bugs.call_changes_operand", {{"x", u32}}, {{"sum", u32}, {"element", u32}},
           "hn_bug_k = a.x;\nhn_bug_k += hn_bug_changed();\n"
           "hn_bug_t = array<u32, 2>(a.x, 3u);\nhn_bug_t[0] -= hn_bug_element();\n"
           "return vec4u(hn_bug_k, hn_bug_t[0], 0u, 0u);",
           "gfx-rs/wgpu 9181 (pull request)",
           defined("WGSL, Compound Assignment: e1 += e2 reads what e1 refers to before it evaluates e2"),
           points<uint>({5u, 0xFFFFFFFFu}, [](uint x) { return words(x + 1u, x - 2u); }),
           "var<private> hn_bug_k: u32;\nvar<private> hn_bug_t: array<u32, 2>;\n"
           "fn hn_bug_changed() -> u32 {\n  hn_bug_k += 10u;\n  return 1u;\n}\n"
           "fn hn_bug_element() -> u32 {\n  hn_bug_t[0] = 50u;\n  return 2u;\n}\n"),
      wgsl("bugs.float_to_int_saturates", {{"x", f32}}, {{"uint", u32}, {"int", i32}, {"vector", i32}},
           "let x = bitcast<f32>(a.x);\nlet v = vec2i(vec2f(-x, x));\n"
           "return vec4u(u32(x), bitcast<u32>(i32(x)), bitcast<u32>(v.y), 0u);",
           "gfx-rs/wgpu 6057",
           defined(
               "WGSL, Floating Point Conversion: beyond the integers, the result is the value closest to truncate(x) "
               "that is also a float"),
           points<float>({-5.0f, 1e6f, 3e9f, -3e9f, 1e20f, -1e20f, 2.75f},
                         [](float x) {
                           const double number = static_cast<double>(x);
                           const auto held = [&](double least, double most) {
                             return static_cast<uint>(
                                 static_cast<std::int64_t>(std::min(std::max(number, least), most)));
                           };
                           const uint whole = held(-2147483648.0, 2147483520.0);
                           return words(held(0.0, 4294967040.0), whole, whole);
                         })),
      wgsl("bugs.division_by_zero", {{"x", i32}, {"y", i32}},
           {{"quotient", i32}, {"remainder", i32}, {"uint_quotient", u32}, {"uint_remainder", u32}},
           "let x = bitcast<i32>(a.x);\nlet y = bitcast<i32>(a.y);\n"
           "return vec4u(bitcast<u32>(x / y), bitcast<u32>(x % y), a.x / a.y, a.x % a.y);",
           "gfx-rs/wgpu 4385",
           defined(
               "WGSL, Arithmetic Expressions: x / 0 is x and x % 0 is 0; the lowest int / -1 is itself, and % -1 is 0"),
           points<int, int>({{7, 0}, {-7, 0}, {kLowest, -1}, {kLowest, 0}, {0, 0}, {-7, 3}, {7, -2}}, divided)),
      wgsl("bugs.bits_out_of_range", {{"x", u32}, {"offset", u32}, {"count", u32}},
           {{"extracted", u32}, {"inserted", u32}, {"signed", i32}},
           "return vec4u(extractBits(a.x, a.y, a.z), insertBits(a.x, 0u, a.y, a.z),\n"
           "             bitcast<u32>(extractBits(bitcast<i32>(a.x), a.y, a.z)), 0u);",
           "gfx-rs/wgpu before 0.16; gpuweb/gpuweb 288",
           defined("WGSL, extractBits: o is min(offset, 32) and c is min(count, 32 - o); no bits are 0"),
           points<uint, uint, uint>({{0xDEADBEEFu, 4, 32},
                                     {0xDEADBEEFu, 0, 32},
                                     {0xDEADBEEFu, 40, 8},
                                     {0xDEADBEEFu, 31, 7},
                                     {0xDEADBEEFu, 8, 0},
                                     {0xDEADBEEFu, 5, 0xFFFFFFFFu}},
                                    [](uint x, uint offset, uint count) {
                                      const uint o = std::min(offset, 32u);
                                      const uint c = std::min(count, 32u - o);
                                      const uint bits = c == 0 ? 0 : x >> o & ones(c);
                                      const bool negative = c > 0 && (bits >> (c - 1u) & 1u) != 0;
                                      const uint kept = c == 0 ? x : x & ~(ones(c) << o);
                                      return words(bits, kept, negative ? bits | ~ones(c) : bits);
                                    })),
      wgsl(
          "bugs.remainder_of_negative", {{"x", f32}, {"y", f32}, {"m", i32}, {"n", i32}},
          {{"float", f32}, {"int", i32}, {"vector", i32}},
          "let v = bitcast<vec2i>(a.zw) % bitcast<vec2i>(a.wz);\n"
          "return vec4u(bitcast<u32>(bitcast<f32>(a.x) % bitcast<f32>(a.y)),\n"
          "             bitcast<u32>(bitcast<i32>(a.z) % bitcast<i32>(a.w)), bitcast<u32>(v.y), 0u);",
          "gfx-rs/wgpu 9687 (naga to GLSL ES)",
          defined("WGSL, Arithmetic Expressions: x % y is x - y * truncate(x / y), of floats as well; these are exact"),
          points<float, float, int, int>(
              {{-5.5f, 2.0f, -7, 3}, {5.5f, -2.0f, 7, -3}, {-0.75f, 0.5f, -1, 2}, {7.0f, 4.0f, 8, 5}},
              [](float x, float y, int m, int n) { return words(std::fmod(x, y), m % n, n % m); })),
      bug("bugs.highest_bit", {{"x", i32}, {"y", i32}}, {{"x", i32}, {"y", i32}, {"word", i32}},
          "hn_ivec2 v = firstbithigh(ivec2(int(a.x), int(a.y)));\n"
          "return uvec4(uint(firstbithigh(int(a.x))), uint(v.y), uint(firstbithigh(a.x)), 0u);",
          "microsoft/DirectXShaderCompiler 5665 (pull request)",
          defined("Direct3D 11.3, firstbit_shi: the highest bit that is not the sign, and -1 where there is none; HLSL "
                  "counts from the lowest bit"),
          points<int, int>({{-256, -2}, {5, 256}, {-65537, 0}, {-1, 2147483647}},
                           [](int x, int y) {
                             const auto highest = [](uint bits) { return 31 - std::countl_zero(bits); };
                             return words(highest(word(x < 0 ? ~x : x)), highest(word(y < 0 ? ~y : y)),
                                          highest(word(x)));
                           }),
          kHlsl),
      bug("bugs.enum_constant", {{"x", f32}}, {{"product", f32}, {"int", i32}},
          "return uvec4(bits_of(HN_BUG_REST * float_of(a.x)), uint(int(HN_BUG_REST)), 0u, 0u);",
          "microsoft/DirectXShaderCompiler 6884",
          defined("HLSL 2017: a constant of an enum becomes a float as an int does"),
          points<float>({3.0f, -0.5f}, [](float x) { return words(49400.0f * x, 49400); }), "hlsl2021",
          "enum : int { HN_BUG_ALL = 50000, HN_BUG_PART = 600, HN_BUG_REST = (HN_BUG_ALL - HN_BUG_PART) };\n"),
      bug("bugs.int_of_byte", {{"x", u32}}, {{"int", i32}, {"float", f32}},
          "uint8_t byte = uint8_t(a.x);\nreturn uvec4(uint(int(byte)), bits_of(float(byte)), 0u, 0u);",
          "shader-slang/slang 7035",
          defined("Slang's language reference, Scalar Types: uint8_t is unsigned, and an int keeps its value"),
          points<uint>({0xC8u, 0x7Fu, 0xFFu}, [](uint x) { return words(x, static_cast<float>(x)); }), "slang"),
  };
}

}  // namespace hn
