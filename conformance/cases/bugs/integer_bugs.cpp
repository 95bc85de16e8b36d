// Bugs of integer arithmetic.
#include <algorithm>
#include <cstdlib>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using uint = std::uint32_t;

constexpr std::string_view kModuloReports =
    "gfx-rs/wgpu 9687 (NVIDIA folds it as unsigned); godotengine/godot 78429; dolphin-emu/dolphin 3509";
constexpr Rule kModuloOpen = left_open(
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: the result of % is undefined if an operand is negative; here that of C++, "
    "with the sign of the dividend");
constexpr std::string_view kShiftReports =
    "KhronosGroup/WebGL 2989 (Adreno 5xx and 6xx), its test conformance2/glsl3/uint-int-shift-bug";
constexpr Rule kShiftDefined = defined(
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: >> of an unsigned integer shifts in zeros, of a signed one its sign; a "
    "uint may be shifted by an int");
constexpr std::string_view kFoldedShiftReports = "GraphicsFuzz cov-fold-shift-gte32";
constexpr Rule kShiftOpen = left_open(
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: a shift by 32 or more is undefined; here by the count modulo 32, as "
    "Direct3D and most hardware do");
constexpr std::string_view kAdrenoIntegers =
    "hrydgard/ppsspp 11480 and gfx-rs/wgpu 5318 (Adreno: the high 16 bits are lost, or values stop at 65536)";
constexpr Rule kWrap = defined(
    "GLSL 4.60 section 4.1.3, GLSL ES 3.00 section 4.5.1: integers (in ES, highp ones) have 32 bits, and +, - and * "
    "keep the low 32 bits");

}  // namespace

std::vector<Bug> integer_bugs() {
  return {
      bug("bugs.modulo_of_negative", {{"x", i32}, {"y", i32}}, {{"remainder", i32}},
          "return uvec4(uint(int(a.x) % int(a.y)), 0u, 0u, 0u);", kModuloReports, kModuloOpen,
          points<int, int>({{-1, 7}, {-7, 3}, {7, -3}, {-2147483647, 48}}, [](int x, int y) { return words(x % y); })),
      bug("bugs.modulo_of_negative_constant", {{"x", i32}}, {{"constant", i32}, {"variable", i32}},
          "hn_int constant = (-7) % 3;\n"
          "return uvec4(uint(constant), uint(int(a.x) % 3), 0u, 0u);",
          kModuloReports, kModuloOpen, points<int>({-7}, [](int x) { return words(-7 % 3, x % 3); })),
      bug("bugs.modulo_of_non_negative", {{"x", i32}, {"y", i32}}, {{"remainder", i32}, {"quotient", i32}},
          "return uvec4(uint(int(a.x) % int(a.y)), uint(int(a.x) / int(a.y)), 0u, 0u);", kModuloReports,
          defined("GLSL 4.60 section 5.9: % of integers that are not negative is the remainder of their division"),
          points<int, int>({{0, 7}, {6, 7}, {7, 7}, {2147483647, 48}, {2147483647, 65537}, {65535, 2147483647}},
                           [](int x, int y) { return words(x % y, x / y); })),
      bug("bugs.modulo_of_large_word", {{"x", u32}, {"y", u32}}, {{"remainder", u32}, {"constant_divisor", u32}},
          "return uvec4(a.x % a.y, a.x % 48u, 0u, 0u);", kModuloReports,
          defined("GLSL 4.60 section 5.9: a uint is never negative, so its % is defined whatever its highest bit"),
          points<uint, uint>({{0x80000000u, 48}, {0xFFFFFFFFu, 7}, {0x80000005u, 0x80000003u}, {5, 0xFFFFFFFFu}},
                             [](uint x, uint y) { return words(x % y, x % 48u); })),

      bug("bugs.uint_of_int_shifted_by_31", {{"x", i32}}, {{"sign", u32}},
          "hn_int x = int(a.x);\nreturn uvec4(uint(x) >> 31, 0u, 0u, 0u);", kShiftReports, kShiftDefined,
          points<uint>({0xFFFFFFFFu, 0x80000000u, 0u, 1u, 0x7FFFFFFFu}, [](uint x) { return words(x >> 31); })),
      bug("bugs.uint_of_int_shifted", {{"x", i32}, {"count", u32}}, {{"shifted", u32}},
          "hn_int x = int(a.x);\nreturn uvec4(uint(x) >> a.y, 0u, 0u, 0u);", kShiftReports, kShiftDefined,
          points<uint, uint>(
              {{0xFFFFFFFFu, 1}, {0xFFFFFFFFu, 16}, {0x80000001u, 30}, {0x7FFFFFFFu, 7}, {0xC0000000u, 0}},
              [](uint x, uint count) { return words(x >> count); })),
      bug("bugs.int_shift_extends_sign", {{"x", i32}, {"count", i32}}, {{"shifted", i32}, {"by_constant", i32}},
          "hn_int x = int(a.x);\n"
          "return uvec4(uint(x >> int(a.y)), uint(x >> 4), 0u, 0u);",
          kShiftReports, kShiftDefined,
          points<int, int>({{-16, 2}, {-2147483647 - 1, 31}, {0x7FFFFFFF, 15}, {-1, 31}},
                           [](int x, int count) { return words(x >> count, x >> 4); })),
      bug("bugs.uint_shifted_by_int", {{"x", u32}, {"count", i32}}, {{"left", u32}, {"right", u32}, {"right_15", u32}},
          "return uvec4(a.x << int(a.y), a.x >> int(a.y), a.x >> 15, 0u);", "hrydgard/ppsspp 16710 (Adreno)",
          kShiftDefined,
          points<uint, int>({{0xDEADBEEFu, 0}, {0xDEADBEEFu, 1}, {0x80000001u, 31}, {0xFFFFFFFFu, 17}},
                            [](uint x, int count) { return words(x << count, x >> count, x >> 15); })),
      bug("bugs.shift_by_32", {{"x", u32}, {"count", u32}}, {{"left", u32}, {"right", u32}},
          "return uvec4(a.x << a.y, a.x >> a.y, 0u, 0u);", kFoldedShiftReports, kShiftOpen,
          points<uint, uint>({{0xDEADBEEFu, 32}, {0xDEADBEEFu, 33}, {1, 63}},
                             [](uint x, uint count) { return words(x << (count & 31u), x >> (count & 31u)); })),
      bug("bugs.shift_by_constant_32", {{"x", u32}}, {{"left", u32}, {"right", u32}},
          "hn_uint n = 32u;\nreturn uvec4(a.x << n, a.x >> n, 0u, 0u);", kFoldedShiftReports, kShiftOpen,
          points<uint>({0xDEADBEEFu, 1u}, [](uint x) { return words(x, x); })),
      bug("bugs.shifted_twice_by_16", {{"x", u32}}, {{"left", u32}, {"right", u32}},
          "return uvec4((a.x << 16) << 16, (a.x >> 16) >> 16, 0u, 0u);", kFoldedShiftReports,
          defined("GLSL 4.60 section 5.9: each of the two shifts is by less than 32, so nothing is left of the word"),
          points<uint>({0xDEADBEEFu, 1u, 0xFFFFFFFFu}, [](uint) { return words(0, 0); })),

      bug("bugs.words_wrap_at_32_bits", {{"x", u32}, {"y", u32}},
          {{"sum", u32}, {"difference", u32}, {"product", u32}, {"negated", u32}},
          "return uvec4(a.x + a.y, a.x - a.y, a.x * a.y, -a.x);", kAdrenoIntegers, kWrap,
          points<uint, uint>(
              {{1, 2}, {0xFFFFFFFFu, 2}, {0x9E3779B1u, 0x85EBCA77u}, {0x10000u, 0x10000u}, {65535, 65537}},
              [](uint x, uint y) { return words(x + y, x - y, x * y, 0u - x); })),
      bug("bugs.ints_beyond_65536", {{"x", i32}}, {{"next", i32}, {"twice", i32}, {"scaled", i32}},
          "hn_int x = int(a.x);\n"
          "return uvec4(uint(x + 1), uint(x * 2), uint(x * 1000 - 7), 0u);",
          kAdrenoIntegers, kWrap,
          points<int>({32767, 65535, 65536, 100000, -65537, 2000000},
                      [](int x) { return words(x + 1, x * 2, x * 1000 - 7); })),
      bug("bugs.high_half_of_word", {{"x", u32}}, {{"half", u32}, {"highest_bit", u32}, {"flag", u32}},
          "return uvec4((a.x >> 16) & 0xFFFFu, (a.x & 0x80000000u) != 0u ? 1u : 0u,\n"
          "             (a.x & 0x00020000u) != 0u ? 1u : 0u, 0u);",
          kAdrenoIntegers, kWrap,
          points<uint>({0u, 0x80000000u, 0x00020000u, 0xFFFDFFFFu, 0x7FFFFFFFu},
                       [](uint x) { return words(x >> 16, x >> 31, x >> 17 & 1u); })),
      bug("bugs.precision_side_effects", {{"x", u32}, {"y", u32}}, {{"flag", i32}, {"product", i32}},
          "hn_int flag = int(a.x == a.x);\n"
          "hn_int x = int(a.y);\n"
          "return uvec4(uint(0 | (flag * 0x8000)), uint(0 | (x * 0x8000)), 0u, 0u);",
          "KhronosGroup/WebGL 3192, its test conformance2/glsl3/precision-side-effects-bug (Adreno, crbug 1155942)",
          kWrap, points<uint, uint>({{0, 1}, {7, 3}}, [](uint, uint y) { return words(0x8000u, y * 0x8000u); })),
      bug("bugs.mediump_hash", {{"x", u32}}, {{"hash", u32}},
          "mediump uint h = a.x;\nmediump uint m = 26219u;\n"
          "h = (h ^ (h >> 5)) * m;\nh = h ^ (h >> 7);\nreturn uvec4(h & 0xFFFFu, h >> 16, 0u, 0u);",
          "ashima/webgl-noise 25 (iOS); stegu/webgl-noise 11",
          left_open("GLSL ES 3.00 section 4.5.1: mediump integers need only have 16 bits"),
          points<uint>({1u, 12345u, 54321u},
                       [](uint x) {
                         const uint h = (x ^ (x >> 5)) * 26219u;
                         return words((h ^ (h >> 7)) & 0xFFFFu);
                       }),
          "es300"),

      bug("bugs.abs_of_int", {{"x", i32}}, {{"magnitude", i32}, {"of_constant", i32}},
          "return uvec4(uint(abs(int(a.x))), uint(abs(-12345)), 0u, 0u);",
          "ANGLE emulate_abs_int_function (crbug 642227)",
          defined("GLSL 4.60 section 8.3: abs is x where x >= 0, else -x, of integers as well"),
          points<int>({0, 5, -5, -65537, 2147483647, -2147483647}, [](int x) { return words(std::abs(x), 12345); })),
      bug("bugs.larger_size", {{"x", i32}, {"y", i32}}, {{"larger", i32}, {"smaller", i32}},
          "hn_int x = int(a.x);\nhn_int y = int(a.y);\n"
          "return uvec4(uint(max(max(x, -x), y)), uint(min(min(x, -x), y)), 0u, 0u);",
          "hashnoise docs/measured/results/h100 (NVIDIA 580 takes max(max(x, -x), y) for max(x, y))",
          defined("GLSL 4.60 section 8.3: max is the larger of two integers, and min the smaller one"),
          points<int, int>({{-199, 35}, {-199, -35}, {199, 35}, {7, 65537}, {-7, -65537}},
                           [](int x, int y) { return words(std::max(std::abs(x), y), std::min(-std::abs(x), y)); })),
      bug("bugs.bit_cast_hash", {{"x", f32}, {"y", f32}}, {{"hash", u32}},
          "hn_uint h = floatBitsToUint(float_of(a.x) + float_of(a.y));\n"
          "h = h * 747796405u + 2891336453u;\nreturn uvec4(h ^ (h >> 16), 0u, 0u, 0u);",
          "popojan/goban 35 (Intel UHD 620 on Windows: the noise goes flat)",
          defined("GLSL 4.60 section 8.3: floatBitsToUint keeps the floating-point value's bit-level representation"),
          points<float, float>(
              {{1.0f, 0x1p-23f}, {1.0f, 0x1p-22f}, {0.25f, 0.5f}, {-3.0f, 0.625f}, {1000.0f, 0.0078125f}},
              [](float x, float y) {
                const uint h = word(x + y) * 747796405u + 2891336453u;
                return words(h ^ (h >> 16));
              })),
      bug("bugs.folded_words", {{"x", u32}, {"y", u32}},
          {{"constant", u32}, {"variable", u32}, {"shifted", u32}, {"shifted_variable", u32}},
          "hn_uint constant = (2166136261u * 16777619u) ^ 97u;\n"
          "hn_uint shifted = (0xDEADBEEFu << 7) | (0xDEADBEEFu >> 25);\n"
          "return uvec4(constant, (a.x * 16777619u) ^ 97u, shifted, (a.y << 7) | (a.y >> 25));",
          "constant folding that differs from run time, seen on several drivers",
          defined(
              "GLSL 4.60 section 4.3.3: a constant expression has the value that it has at run time; integers wrap"),
          points<uint, uint>({{2166136261u, 0xDEADBEEFu}},
                             [](uint x, uint y) {
                               const uint product = (x * 16777619u) ^ 97u;
                               const uint rotated = (y << 7) | (y >> 25);
                               return words(product, product, rotated, rotated);
                             })),
  };
}

}  // namespace hn
