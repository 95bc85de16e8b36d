// Bugs of integer arithmetic.
#include <algorithm>
#include <cstdlib>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

std::int32_t as_int(std::uint32_t value) { return static_cast<std::int32_t>(value); }

constexpr std::string_view kModuloReports =
    "gfx-rs/wgpu 9687 (NVIDIA folds it as unsigned); godotengine/godot 78429; dolphin-emu/dolphin 3509";
constexpr std::string_view kModuloOpen =
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: the result of % is undefined if an operand is negative; here that of C++, "
    "with the sign of the dividend";

void add_modulo(std::vector<Bug>& bugs) {
  bugs.push_back({.function = bug_function("bugs.modulo_of_negative", {{"x", i32}, {"y", i32}}, {{"remainder", i32}},
                                           "return uvec4(uint(int(a.x) % int(a.y)), 0u, 0u, 0u);"),
                  .reference = kModuloReports,
                  .specification = kModuloOpen,
                  .defined = false,
                  .points = points({{word(-1), 7}, {word(-7), 3}, {7, word(-3)}, {word(-2147483647), 48}},
                                   [](const Words& in) { return Words{word(as_int(in[0]) % as_int(in[1]))}; })});
  bugs.push_back({.function = bug_function("bugs.modulo_of_negative_constant", {{"x", i32}},
                                           {{"constant", i32}, {"variable", i32}},
                                           "hn_int constant = (-7) % 3;\n"
                                           "return uvec4(uint(constant), uint(int(a.x) % 3), 0u, 0u);"),
                  .reference = kModuloReports,
                  .specification = kModuloOpen,
                  .defined = false,
                  .points = points_of<std::int32_t>({-7}, [](std::int32_t x) {
                    return Words{word(-7 % 3), word(x % 3)};
                  })});
  bugs.push_back(
      {.function = bug_function("bugs.modulo_of_non_negative", {{"x", i32}, {"y", i32}},
                                {{"remainder", i32}, {"quotient", i32}},
                                "return uvec4(uint(int(a.x) % int(a.y)), uint(int(a.x) / int(a.y)), 0u, 0u);"),
       .reference = kModuloReports,
       .specification = "GLSL 4.60 section 5.9: % of integers that are not negative is the remainder of their division",
       .defined = true,
       .points = points({{0, 7}, {6, 7}, {7, 7}, {2147483647, 48}, {2147483647, 65537}, {65535, 2147483647}},
                        [](const Words& in) {
                          return Words{in[0] % in[1], in[0] / in[1]};
                        })});
  bugs.push_back(
      {.function =
           bug_function("bugs.modulo_of_large_word", {{"x", u32}, {"y", u32}},
                        {{"remainder", u32}, {"constant_divisor", u32}}, "return uvec4(a.x % a.y, a.x % 48u, 0u, 0u);"),
       .reference = kModuloReports,
       .specification = "GLSL 4.60 section 5.9: a uint is never negative, so its % is defined whatever its highest bit",
       .defined = true,
       .points = points({{0x80000000u, 48}, {0xFFFFFFFFu, 7}, {0x80000005u, 0x80000003u}, {5, 0xFFFFFFFFu}},
                        [](const Words& in) {
                          return Words{in[0] % in[1], in[0] % 48u};
                        })});
}

constexpr std::string_view kShiftDefined =
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: >> of an unsigned integer shifts in zeros, of a signed one its sign; a "
    "uint may be shifted by an int";
constexpr std::string_view kShiftOpen =
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: a shift by 32 or more is undefined; here by the count modulo 32, as "
    "Direct3D and most hardware do";

void add_shifts(std::vector<Bug>& bugs) {
  constexpr std::string_view kUintOfInt =
      "KhronosGroup/WebGL 2989 (Adreno 5xx and 6xx), its test conformance2/glsl3/uint-int-shift-bug";
  bugs.push_back({.function = bug_function("bugs.uint_of_int_shifted_by_31", {{"x", i32}}, {{"sign", u32}},
                                           "hn_int x = int(a.x);\nreturn uvec4(uint(x) >> 31, 0u, 0u, 0u);"),
                  .reference = kUintOfInt,
                  .specification = kShiftDefined,
                  .defined = true,
                  .points = points_of<std::uint32_t>({0xFFFFFFFFu, 0x80000000u, 0u, 1u, 0x7FFFFFFFu},
                                                     [](std::uint32_t x) { return Words{x >> 31}; })});
  bugs.push_back(
      {.function = bug_function("bugs.uint_of_int_shifted", {{"x", i32}, {"count", u32}}, {{"shifted", u32}},
                                "hn_int x = int(a.x);\nreturn uvec4(uint(x) >> a.y, 0u, 0u, 0u);"),
       .reference = kUintOfInt,
       .specification = kShiftDefined,
       .defined = true,
       .points = points({{word(-1), 1}, {word(-1), 16}, {0x80000001u, 30}, {0x7FFFFFFFu, 7}, {0xC0000000u, 0}},
                        [](const Words& in) { return Words{in[0] >> in[1]}; })});
  bugs.push_back(
      {.function = bug_function("bugs.int_shift_extends_sign", {{"x", i32}, {"count", i32}},
                                {{"shifted", i32}, {"by_constant", i32}},
                                "hn_int x = int(a.x);\n"
                                "return uvec4(uint(x >> int(a.y)), uint(x >> 4), 0u, 0u);"),
       .reference = kUintOfInt,
       .specification = kShiftDefined,
       .defined = true,
       .points = points({{word(-16), 2}, {0x80000000u, 31}, {0x7FFFFFFFu, 15}, {word(-1), 31}}, [](const Words& in) {
         return Words{word(as_int(in[0]) >> in[1]), word(as_int(in[0]) >> 4)};
       })});
  bugs.push_back({.function = bug_function("bugs.uint_shifted_by_int", {{"x", u32}, {"count", i32}},
                                           {{"left", u32}, {"right", u32}, {"right_15", u32}},
                                           "return uvec4(a.x << int(a.y), a.x >> int(a.y), a.x >> 15, 0u);"),
                  .reference = "hrydgard/ppsspp 16710 (Adreno)",
                  .specification = kShiftDefined,
                  .defined = true,
                  .points = points({{0xDEADBEEFu, 0}, {0xDEADBEEFu, 1}, {0x80000001u, 31}, {0xFFFFFFFFu, 17}},
                                   [](const Words& in) {
                                     return Words{in[0] << in[1], in[0] >> in[1], in[0] >> 15};
                                   })});
  constexpr std::string_view kFolded = "GraphicsFuzz cov-fold-shift-gte32";
  bugs.push_back(
      {.function = bug_function("bugs.shift_by_32", {{"x", u32}, {"count", u32}}, {{"left", u32}, {"right", u32}},
                                "return uvec4(a.x << a.y, a.x >> a.y, 0u, 0u);"),
       .reference = kFolded,
       .specification = kShiftOpen,
       .defined = false,
       .points = points({{0xDEADBEEFu, 32}, {0xDEADBEEFu, 33}, {1, 63}}, [](const Words& in) {
         return Words{in[0] << (in[1] & 31u), in[0] >> (in[1] & 31u)};
       })});
  bugs.push_back({.function = bug_function("bugs.shift_by_constant_32", {{"x", u32}}, {{"left", u32}, {"right", u32}},
                                           "hn_uint n = 32u;\nreturn uvec4(a.x << n, a.x >> n, 0u, 0u);"),
                  .reference = kFolded,
                  .specification = kShiftOpen,
                  .defined = false,
                  .points = points_of<std::uint32_t>({0xDEADBEEFu, 1u}, [](std::uint32_t x) {
                    return Words{x, x};
                  })});
  bugs.push_back(
      {.function = bug_function("bugs.shifted_twice_by_16", {{"x", u32}}, {{"left", u32}, {"right", u32}},
                                "return uvec4((a.x << 16) << 16, (a.x >> 16) >> 16, 0u, 0u);"),
       .reference = kFolded,
       .specification =
           "GLSL 4.60 section 5.9: each of the two shifts is by less than 32, so nothing is left of the word",
       .defined = true,
       .points = points_of<std::uint32_t>({0xDEADBEEFu, 1u, 0xFFFFFFFFu}, [](std::uint32_t) {
         return Words{0, 0};
       })});
}

constexpr std::string_view kAdrenoIntegers =
    "hrydgard/ppsspp 11480 and gfx-rs/wgpu 5318 (Adreno: the high 16 bits are lost, or values stop at 65536)";
constexpr std::string_view kWrap =
    "GLSL 4.60 section 4.1.3, GLSL ES 3.00 section 4.5.1: integers (in ES, highp ones) have 32 bits, and +, - and * "
    "keep the low 32 bits";

void add_widths(std::vector<Bug>& bugs) {
  bugs.push_back(
      {.function = bug_function("bugs.words_wrap_at_32_bits", {{"x", u32}, {"y", u32}},
                                {{"sum", u32}, {"difference", u32}, {"product", u32}, {"negated", u32}},
                                "return uvec4(a.x + a.y, a.x - a.y, a.x * a.y, -a.x);"),
       .reference = kAdrenoIntegers,
       .specification = kWrap,
       .defined = true,
       .points = points({{1, 2}, {0xFFFFFFFFu, 2}, {0x9E3779B1u, 0x85EBCA77u}, {0x10000u, 0x10000u}, {65535, 65537}},
                        [](const Words& in) {
                          return Words{in[0] + in[1], in[0] - in[1], in[0] * in[1], 0u - in[0]};
                        })});
  bugs.push_back({.function = bug_function("bugs.ints_beyond_65536", {{"x", i32}},
                                           {{"next", i32}, {"twice", i32}, {"scaled", i32}},
                                           "hn_int x = int(a.x);\n"
                                           "return uvec4(uint(x + 1), uint(x * 2), uint(x * 1000 - 7), 0u);"),
                  .reference = kAdrenoIntegers,
                  .specification = kWrap,
                  .defined = true,
                  .points = points_of<std::int32_t>({32767, 65535, 65536, 100000, -65537, 2000000}, [](std::int32_t x) {
                    return Words{word(x + 1), word(x * 2), word(x * 1000 - 7)};
                  })});
  bugs.push_back({.function = bug_function("bugs.high_half_of_word", {{"x", u32}},
                                           {{"half", u32}, {"highest_bit", u32}, {"flag", u32}},
                                           "return uvec4((a.x >> 16) & 0xFFFFu, (a.x & 0x80000000u) != 0u ? 1u : 0u,\n"
                                           "             (a.x & 0x00020000u) != 0u ? 1u : 0u, 0u);"),
                  .reference = kAdrenoIntegers,
                  .specification = kWrap,
                  .defined = true,
                  .points = points_of<std::uint32_t>({0u, 0x80000000u, 0x00020000u, 0xFFFDFFFFu, 0x7FFFFFFFu},
                                                     [](std::uint32_t x) {
                                                       return Words{x >> 16, x >> 31, x >> 17 & 1u};
                                                     })});
  bugs.push_back(
      {.function =
           bug_function("bugs.precision_side_effects", {{"x", u32}, {"y", u32}}, {{"flag", i32}, {"product", i32}},
                        "hn_int flag = int(a.x == a.x);\n"
                        "hn_int x = int(a.y);\n"
                        "return uvec4(uint(0 | (flag * 0x8000)), uint(0 | (x * 0x8000)), 0u, 0u);"),
       .reference =
           "KhronosGroup/WebGL 3192, its test conformance2/glsl3/precision-side-effects-bug (Adreno, crbug 1155942)",
       .specification = kWrap,
       .defined = true,
       .points = points({{0, 1}, {7, 3}}, [](const Words& in) {
         return Words{0x8000u, in[1] * 0x8000u};
       })});
  bugs.push_back({.function = bug_function(
                      "bugs.mediump_hash", {{"x", u32}}, {{"hash", u32}},
                      "mediump uint h = a.x;\nmediump uint m = 26219u;\n"
                      "h = (h ^ (h >> 5)) * m;\nh = h ^ (h >> 7);\nreturn uvec4(h & 0xFFFFu, h >> 16, 0u, 0u);"),
                  .reference = "ashima/webgl-noise 25 (iOS); stegu/webgl-noise 11",
                  .specification = "GLSL ES 3.00 section 4.5.1: mediump integers need only have 16 bits",
                  .defined = false,
                  .profiles = "es300",
                  .points = points_of<std::uint32_t>({1u, 12345u, 54321u}, [](std::uint32_t x) {
                    std::uint32_t h = (x ^ (x >> 5)) * 26219u;
                    h ^= h >> 7;
                    return Words{h & 0xFFFFu};
                  })});
}

void add_others(std::vector<Bug>& bugs) {
  bugs.push_back({.function = bug_function("bugs.abs_of_int", {{"x", i32}}, {{"magnitude", i32}, {"of_constant", i32}},
                                           "return uvec4(uint(abs(int(a.x))), uint(abs(-12345)), 0u, 0u);"),
                  .reference = "ANGLE emulate_abs_int_function (crbug 642227)",
                  .specification = "GLSL 4.60 section 8.3: abs is x where x >= 0, else -x, of integers as well",
                  .defined = true,
                  .points = points_of<std::int32_t>({0, 5, -5, -65537, 2147483647, -2147483647}, [](std::int32_t x) {
                    return Words{word(std::abs(x)), 12345u};
                  })});
  bugs.push_back(
      {.function = bug_function("bugs.larger_size", {{"x", i32}, {"y", i32}}, {{"larger", i32}, {"smaller", i32}},
                                "hn_int x = int(a.x);\nhn_int y = int(a.y);\n"
                                "return uvec4(uint(max(max(x, -x), y)), uint(min(min(x, -x), y)), 0u, 0u);"),
       .reference = "hashnoise docs/measured/results/h100 (NVIDIA 580 takes max(max(x, -x), y) for max(x, y))",
       .specification = "GLSL 4.60 section 8.3: max is the larger of two integers, and min the smaller one",
       .defined = true,
       .points = points({{word(-199), 35}, {word(-199), word(-35)}, {199, 35}, {7, 65537}, {word(-7), word(-65537)}},
                        [](const Words& in) {
                          const int size = std::abs(as_int(in[0]));
                          return Words{word(std::max(size, as_int(in[1]))), word(std::min(-size, as_int(in[1])))};
                        })});
  bugs.push_back(
      {.function = bug_function("bugs.bit_cast_hash", {{"x", f32}, {"y", f32}}, {{"hash", u32}},
                                "hn_uint h = floatBitsToUint(float_of(a.x) + float_of(a.y));\n"
                                "h = h * 747796405u + 2891336453u;\nreturn uvec4(h ^ (h >> 16), 0u, 0u, 0u);"),
       .reference = "popojan/goban 35 (Intel UHD 620 on Windows: the noise goes flat)",
       .specification =
           "GLSL 4.60 section 8.3: floatBitsToUint keeps the floating-point value's bit-level representation",
       .defined = true,
       .points = points({{word(1.0f), word(0x1p-23f)},
                         {word(1.0f), word(0x1p-22f)},
                         {word(0.25f), word(0.5f)},
                         {word(-3.0f), word(0.625f)},
                         {word(1000.0f), word(0.0078125f)}},
                        [](const Words& in) {
                          const float sum = std::bit_cast<float>(in[0]) + std::bit_cast<float>(in[1]);
                          const std::uint32_t h = word(sum) * 747796405u + 2891336453u;
                          return Words{h ^ (h >> 16)};
                        })});
  bugs.push_back(
      {.function = bug_function("bugs.folded_words", {{"x", u32}, {"y", u32}},
                                {{"constant", u32}, {"variable", u32}, {"shifted", u32}, {"shifted_variable", u32}},
                                "hn_uint constant = (2166136261u * 16777619u) ^ 97u;\n"
                                "hn_uint shifted = (0xDEADBEEFu << 7) | (0xDEADBEEFu >> 25);\n"
                                "return uvec4(constant, (a.x * 16777619u) ^ 97u, shifted, (a.y << 7) | (a.y >> 25));"),
       .reference = "constant folding that differs from run time, seen on several drivers",
       .specification =
           "GLSL 4.60 section 4.3.3: a constant expression has the value that it has at run time; integers wrap",
       .defined = true,
       .points = points({{2166136261u, 0xDEADBEEFu}}, [](const Words& in) {
         const std::uint32_t product = (in[0] * 16777619u) ^ 97u;
         const std::uint32_t rotated = (in[1] << 7) | (in[1] >> 25);
         return Words{product, product, rotated, rotated};
       })});
}

}  // namespace

void add_integer_bugs(std::vector<Bug>& bugs) {
  add_modulo(bugs);
  add_shifts(bugs);
  add_widths(bugs);
  add_others(bugs);
}

}  // namespace hn
