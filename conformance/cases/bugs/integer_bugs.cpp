// Bugs of integer arithmetic.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <string>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using uint = std::uint32_t;

constexpr std::string_view kModuloReports =
    "gfx-rs/wgpu 9687 (NVIDIA folds it as unsigned); godotengine/godot 78429; dolphin-emu/dolphin 3509";
constexpr Rule kModuloOpen = left_open(
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: the result of % is undefined if an operand is negative; here that of C++, "
    "with the sign of the dividend. HLSL's documentation: % needs both sides positive or both negative");
constexpr Rule kModuloTruncates = defined(
    "WGSL, Arithmetic Expressions: x % y is x - y * truncate(x / y); C++14 [expr.mul] (Metal): (x / y) * y + x % y is "
    "x, "
    "and / truncates");
constexpr std::string_view kShiftReports =
    "KhronosGroup/WebGL 2989 (Adreno 5xx and 6xx), its test conformance2/glsl3/uint-int-shift-bug";
constexpr Rule kShiftDefined = defined(
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: >> of an unsigned integer shifts in zeros, of a signed one its sign; a "
    "uint may be shifted by an int. So WGSL, Bit Expressions, Direct3D's ushr and ishr, and C++14 [expr.shift] "
    "(Metal)");
constexpr std::string_view kFoldedShiftReports = "GraphicsFuzz cov-fold-shift-gte32";
constexpr Rule kShiftOpen = left_open(
    "GLSL 4.60 and GLSL ES 3.00 section 5.9: a shift by 32 or more is undefined; here by the count modulo 32, as "
    "Direct3D and most hardware do");
constexpr Rule kShiftModulo = defined("WGSL, Bit Expressions: a shift is by the count modulo 32");
constexpr std::string_view kAdrenoIntegers =
    "hrydgard/ppsspp 11480 and gfx-rs/wgpu 5318 (Adreno: the high 16 bits are lost, or values stop at 65536)";
constexpr Rule kWrap = defined(
    "GLSL 4.60 section 4.1.3, GLSL ES 3.00 section 4.5.1: integers (in ES, highp ones) have 32 bits, and +, - and * "
    "keep the low 32 bits. So WGSL, Arithmetic Expressions, Direct3D's iadd and imul, and C++14 [basic.fundamental] of "
    "unsigned ones (Metal)");

constexpr Rule kBits = defined(
    "GLSL 4.60 section 5.9, and every other language: & acts on each bit of each component, and a scalar on those of "
    "all");
constexpr Rule kModuloDefined = defined(
    "GLSL 4.60 section 5.9, and every other language: % of integers that are not negative is the remainder of their "
    "division");

// So many pairs are in registers at a time.
constexpr int kPairs = 48;
constexpr int kRounds = 3;

// Each pair of words is a number of 64 bits. In each round it is increased by the next one, which is turned by 13 bits.
std::string_view hash_of_pairs() {
  static const std::string kText = [] {
    std::string text;
    for (int i = 0; i < kPairs; ++i) text += fmt::format("hn_uvec2 p{0} = uvec2(a.x + {0}u, a.y ^ {0}u);\n", i);
    for (int i = 0; i < kPairs * kRounds; ++i) {
      const int one = i % kPairs;
      const int other = (i + 1) % kPairs;
      text += fmt::format("p{0} = hn_bug_sum(p{0}, p{1}); p{1} = hn_bug_turned(p{1}) ^ p{0};\n", one, other);
    }
    return text + "return uvec4(p0.x, p0.y, 0u, 0u);";
  }();
  return kText;
}

std::vector<std::uint32_t> hashed_pairs(uint x, uint y) {
  std::array<std::uint64_t, kPairs> numbers;
  for (uint i = 0; i < kPairs; ++i) numbers[i] = (static_cast<std::uint64_t>(y ^ i) << 32) + (x + i);
  for (std::size_t i = 0; i < kPairs * kRounds; ++i) {
    std::uint64_t& one = numbers[i % kPairs];
    std::uint64_t& other = numbers[(i + 1) % kPairs];
    one += other;
    other = std::rotl(other, 13) ^ one;
  }
  return words(static_cast<uint>(numbers[0]), static_cast<uint>(numbers[0] >> 32));
}

}  // namespace

std::vector<Bug> integer_bugs() {
  return {
      but_in("msl wgsl", kModuloTruncates,
             bug("bugs.modulo_of_negative", {{"x", i32}, {"y", i32}}, {{"remainder", i32}},
                 "return uvec4(uint(int(a.x) % int(a.y)), 0u, 0u, 0u);", kModuloReports, kModuloOpen,
                 points<int, int>({{-1, 7}, {-7, 3}, {7, -3}, {-2147483647, 48}},
                                  [](int x, int y) { return words(x % y); }))),
      but_in("msl wgsl", kModuloTruncates,
             bug("bugs.modulo_of_negative_constant", {{"x", i32}}, {{"constant", i32}, {"variable", i32}},
                 "hn_int folded = (-7) % 3;\n"
                 "return uvec4(uint(folded), uint(int(a.x) % 3), 0u, 0u);",
                 kModuloReports, kModuloOpen, points<int>({-7}, [](int x) { return words(-7 % 3, x % 3); }))),
      bug("bugs.modulo_of_non_negative", {{"x", i32}, {"y", i32}}, {{"remainder", i32}, {"quotient", i32}},
          "return uvec4(uint(int(a.x) % int(a.y)), uint(int(a.x) / int(a.y)), 0u, 0u);", kModuloReports, kModuloDefined,
          points<int, int>({{0, 7}, {6, 7}, {7, 7}, {2147483647, 48}, {2147483647, 65537}, {65535, 2147483647}},
                           [](int x, int y) { return words(x % y, x / y); })),
      bug("bugs.modulo_of_large_word", {{"x", u32}, {"y", u32}}, {{"remainder", u32}, {"constant_divisor", u32}},
          "return uvec4(a.x % a.y, a.x % 48u, 0u, 0u);", kModuloReports,
          defined(
              "GLSL 4.60 section 5.9, and every other language: a uint is never negative, so its % is defined whatever "
              "its highest bit"),
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
      but_in("wgsl", kShiftModulo,
             bug("bugs.shift_by_32", {{"x", u32}, {"count", u32}}, {{"left", u32}, {"right", u32}},
                 "return uvec4(a.x << a.y, a.x >> a.y, 0u, 0u);", kFoldedShiftReports, kShiftOpen,
                 points<uint, uint>({{0xDEADBEEFu, 32}, {0xDEADBEEFu, 33}, {1, 63}},
                                    [](uint x, uint count) { return words(x << (count & 31u), x >> (count & 31u)); }),
                 kWithoutMetal)),
      but_in("wgsl", kShiftModulo,
             bug("bugs.shift_by_constant_32", {{"x", u32}}, {{"left", u32}, {"right", u32}},
                 "hn_uint n = 32u;\nreturn uvec4(a.x << n, a.x >> n, 0u, 0u);", kFoldedShiftReports, kShiftOpen,
                 points<uint>({0xDEADBEEFu, 1u}, [](uint x) { return words(x, x); }), kWithoutMetal)),
      bug("bugs.shifted_twice_by_16", {{"x", u32}}, {{"left", u32}, {"right", u32}},
          "return uvec4((a.x << 16) << 16, (a.x >> 16) >> 16, 0u, 0u);", kFoldedShiftReports,
          defined("GLSL 4.60 section 5.9, and every other language: each of the two shifts is by less than 32, so "
                  "nothing is left of the word"),
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
          defined("GLSL 4.60 section 8.3: abs is x where x >= 0, else -x, of integers as well; so WGSL's, HLSL's and "
                  "Metal's "
                  "(section 6.4)"),
          points<int>({0, 5, -5, -65537, 2147483647, -2147483647}, [](int x) { return words(std::abs(x), 12345); })),
      bug("bugs.larger_size", {{"x", i32}, {"y", i32}}, {{"larger", i32}, {"smaller", i32}},
          "hn_int x = int(a.x);\nhn_int y = int(a.y);\n"
          "return uvec4(uint(max(max(x, -x), y)), uint(min(min(x, -x), y)), 0u, 0u);",
          "hashnoise docs/measured/results/h100 (NVIDIA 580 takes max(max(x, -x), y) for max(x, y))",
          defined(
              "GLSL 4.60 section 8.3, WGSL's and HLSL's max, and Metal's (section 6.4): the larger of two integers; "
              "min is the smaller one"),
          points<int, int>({{-199, 35}, {-199, -35}, {199, 35}, {7, 65537}, {-7, -65537}},
                           [](int x, int y) { return words(std::max(std::abs(x), y), std::min(-std::abs(x), y)); })),
      bug("bugs.bit_cast_hash", {{"x", f32}, {"y", f32}}, {{"hash", u32}},
          "hn_uint h = floatBitsToUint(float_of(a.x) + float_of(a.y));\n"
          "h = h * 747796405u + 2891336453u;\nreturn uvec4(h ^ (h >> 16), 0u, 0u, 0u);",
          "popojan/goban 35 (Intel UHD 620 on Windows: the noise goes flat)",
          defined(
              "GLSL 4.60 section 8.3: floatBitsToUint keeps the floating-point value's bit-level representation. So "
              "HLSL's asuint, WGSL's bitcast, and Metal's as_type (section 2.21)"),
          points<float, float>(
              {{1.0f, 0x1p-23f}, {1.0f, 0x1p-22f}, {0.25f, 0.5f}, {-3.0f, 0.625f}, {1000.0f, 0.0078125f}},
              [](float x, float y) {
                const uint h = word(x + y) * 747796405u + 2891336453u;
                return words(h ^ (h >> 16));
              })),
      // In WGSL the constant that loses bits by its shift is an error.
      bug("bugs.folded_words", {{"x", u32}, {"y", u32}},
          {{"constant", u32}, {"variable", u32}, {"shifted", u32}, {"shifted_variable", u32}},
          "hn_uint folded = (2166136261u * 16777619u) ^ 97u;\n"
          "hn_uint shifted = (0xDEADBEEFu << 7) | (0xDEADBEEFu >> 25);\n"
          "return uvec4(folded, (a.x * 16777619u) ^ 97u, shifted, (a.y << 7) | (a.y >> 25));",
          "constant folding that differs from run time, seen on several drivers",
          defined("GLSL 4.60 section 4.3.3: a constant expression has the value that it has at run time; integers "
                  "wrap. HLSL and "
                  "C++14 [expr.const] (Metal) know no other value"),
          points<uint, uint>({{2166136261u, 0xDEADBEEFu}},
                             [](uint x, uint y) {
                               const uint product = (x * 16777619u) ^ 97u;
                               const uint rotated = (y << 7) | (y >> 25);
                               return words(product, product, rotated, rotated);
                             }),
          "gl330 es300 vulkan hlsl60 hlsl50 msl"),
      bug("bugs.and_of_vectors", {{"x", i32}, {"y", i32}, {"z", i32}, {"w", i32}},
          {{"ints", i32}, {"by_one", i32}, {"by_constants", i32}, {"words", u32}},
          "hn_ivec2 v = ivec2(int(a.x), int(a.y));\n"
          "hn_ivec2 ints = v & ivec2(int(a.z), int(a.w));\nhn_ivec2 by_one = v & int(a.z);\n"
          "hn_ivec2 by_constants = v & ivec2(65535, 255);\nhn_uvec3 words = uvec3(a.x, a.y, a.z) & uvec3(a.y, a.z, "
          "a.w);\n"
          "return uvec4(uint(ints.x ^ ints.y), uint(by_one.x ^ by_one.y), uint(by_constants.x ^ by_constants.y),\n"
          "             words.x ^ words.y ^ words.z);",
          "dolphin-emu/dolphin 9636 (Mali: & of integer vectors is wrong if one is no constant)", kBits,
          points<int, int, int, int>(
              {{0x12345678, -1, 0x0F0F0F0F, 0x00FF00FF}, {-2, 0x7FFFFFFF, -65536, 1}, {-1, -3, -5, -9}, {5, 3, 6, 12}},
              [](int x, int y, int z, int w) {
                return words((x & z) ^ (y & w), (x & z) ^ (y & z), (x & 65535) ^ (y & 255),
                             (x & y) ^ (y & z) ^ (z & w));
              })),
      bug("bugs.products_of_literals", {{"x", u32}},
          {{"beyond", u32}, {"power", u32}, {"square", u32}, {"variable", u32}},
          "return uvec4(0x00E6133Eu * 8194u, 65536u * 32768u, 46341u * 46341u, a.x * 8194u);",
          "hashnoise docs/measured/faults.md (FXC: a product of two literals near 2^31)", kWrap,
          points<uint>({0x00E6133Eu, 262081u},
                       [](uint x) { return words(0xC433E67Cu, 0x80000000u, 0x80001219u, x * 8194u); })),
      bug("bugs.remainder_of_constant", {{"x", i32}},
          {{"constant", u32}, {"parity", u32}, {"variable", i32}, {"word", u32}},
          "hn_int t = 300000000;\nhn_uint x = uint(t % 2000000001);\n"
          "return uvec4(x, x % 2u, uint(int(a.x) % 2000000001), a.x % 4000000001u);",
          "KhronosGroup/SPIRV-Tools 5499", kModuloDefined,
          points<int>({300000000, 5, 2147483647, 2000000001},
                      [](int x) { return words(300000000, 0, x % 2000000001, static_cast<uint>(x) % 4000000001u); })),
      bug("bugs.negated_quotient", {{"x", u32}}, {{"quotient", u32}, {"dividend", u32}, {"product", u32}},
          "hn_uint t = min(4u, a.x);\nreturn uvec4(-(t / 4u), (-a.x) / 2u, -(a.x * 3u), 0u);",
          "KhronosGroup/SPIRV-Tools 5822 and 4456", kWrap,
          points<uint>({5u, 3u, 0u, 0x80000000u, 0xFFFFFFFFu},
                       [](uint x) { return words(x < 4u ? 0u : 0xFFFFFFFFu, (0u - x) / 2u, 0u - x * 3u); })),
      // Quotients that are whole or positive: GLSL leaves open which way others round.
      bug("bugs.division_by_large_negative", {{"x", i32}, {"count", u32}},
          {{"negated", i32}, {"by_constant", i32}, {"by_shifted", i32}},
          "hn_int x = int(a.x);\nhn_int lowest = -2147483647 - 1;\n"
          "return uvec4(uint(-(-x / -2018396466)), uint(x / -1073741824), uint(10 / (lowest >> a.y)), 0u);",
          "KhronosGroup/SPIRV-Tools 4487; microsoft/DirectXShaderCompiler 8094",
          defined(
              "GLSL 4.60 section 5.9, and every other language: / of ints divides them with their signs; 4.1.3: the "
              "negative of the lowest int is itself"),
          points<int, uint>({{-2147483647 - 1, 31}, {-1073741824, 30}, {-2018396466, 31}, {0, 30}},
                            [](int x, uint count) {
                              const auto wide = static_cast<std::int64_t>(x);
                              const bool lowest = wide == -2147483648LL;
                              return words(static_cast<int>(-((lowest ? wide : -wide) / -2018396466)),
                                           static_cast<int>(wide / -1073741824), count == 31 ? -10 : -5);
                            }),
          kWithoutMetal),
      bug("bugs.bits_of_constants", {{"x", u32}}, {{"negative", u32}, {"sign", i32}, {"float", f32}, {"same", u32}},
          "hn_ivec3 v = ivec3(-32768, -2147483647, 65535);\nhn_uvec3 u = uvec3(v);\n"
          "hn_int large = int(0xFFFFFF00u);\n"
          "return uvec4(u.x ^ u.y ^ u.z, uint(int(0x80000005u) >> 1), bits_of(float(large)), (u.x == a.x) ? 1u : 0u);",
          "KhronosGroup/SPIRV-Tools 6377 and 6378",
          defined(
              "GLSL 4.60 section 5.4.1: a constructor keeps the bits of an int that becomes a uint, and of a uint that "
              "becomes an int. So WGSL (u32), HLSL, and C++14 [conv.integral] with two's complement (Metal)"),
          points<uint>({0xFFFF8000u, 5u},
                       [](uint x) {
                         const uint bits = 0xFFFF8000u ^ 0x80000001u ^ 0x0000FFFFu;
                         return words(bits, word(0xC0000002u), -256.0f, x == 0xFFFF8000u ? 1u : 0u);
                       })),
      bug("bugs.unary_minus", {{"x", i32}, {"y", f32}},
          {{"negated", i32}, {"bits", u32}, {"float", f32}, {"product", f32}},
          "hn_int x = int(a.x);\nhn_float y = float_of(a.y);\n"
          "return uvec4(uint(-x), uint(x), bits_of(-y), bits_of(-(y * 2.0f)));",
          "yuzu-emu/yuzu 7629 (NVIDIA 495: - is ignored, and the bits of an int are 0)",
          defined("GLSL 4.60 section 5.9, and every other language: - negates"),
          points<int, float>({{5, 1.5f}, {-7, -0.25f}, {2147483647, 1e30f}, {-65536, 3.0f}},
                             [](int x, float y) { return words(-x, x, -y, -(y * 2.0f)); })),
      bug("bugs.negative_shifted_left", {{"x", i32}, {"count", u32}},
          {{"shifted", i32}, {"by_3", i32}, {"there_and_back", i32}},
          "hn_int x = int(a.x);\nreturn uvec4(uint(x << a.y), uint(x << 3u), uint((x << 16u) >> 16u), 0u);",
          "KhronosGroup/SPIRV-Cross 1947",
          defined(
              "GLSL 4.60 section 5.9: << shifts the bits of a signed integer as well. So WGSL, Bit Expressions, and "
              "Direct3D's ishl; C++14 (Metal) leaves it open"),
          points<int, uint>({{-1, 4}, {-65537, 1}, {-5, 31}, {0x12345678, 8}, {-32769, 0}},
                            [](int x, uint count) {
                              const uint bits = word(x);
                              const int back = static_cast<std::int16_t>(bits & 0xFFFFu);
                              return words(bits << count, bits << 3, back);
                            }),
          kWithoutMetal),
      bug("bugs.ints_overflow", {{"x", i32}, {"y", i32}},
          {{"sum", i32}, {"product", i32}, {"larger", u32}, {"difference", i32}},
          "hn_int x = int(a.x);\nhn_int y = int(a.y);\n"
          "return uvec4(uint(x + y), uint(x * y), x + 1 > x ? 1u : 0u, uint(-x - y));",
          "gfx-rs/wgpu 6666 (naga to Metal, which leaves it open)", kWrap,
          points<int, int>({{2147483647, 1}, {-2147483647 - 1, -1}, {65537, 65537}, {5, -7}},
                           [](int x, int y) {
                             const uint u = word(x);
                             const uint v = word(y);
                             return words(u + v, u * v, x == 2147483647 ? 0u : 1u, 0u - u - v);
                           }),
          kWithoutMetal),
      bug("bugs.hash_of_pairs", {{"x", u32}, {"y", u32}}, {{"low", u32}, {"high", u32}}, hash_of_pairs(),
          "intel/intel-graphics-compiler 416 (Arc B580, under register pressure)", kWrap,
          points<uint, uint>({{1, 2}, {0xFFFFFFFFu, 0xFFFFFFFFu}, {0x9E3779B9u, 0x80000000u}}, hashed_pairs),
          kEverywhere,
          "hn_uvec2 hn_bug_sum(hn_uvec2 p, hn_uvec2 q) {\n"
          "  hn_uint low = p.x + q.x;\n  return uvec2(low, p.y + q.y + uint(low < p.x));\n}\n"
          "hn_uvec2 hn_bug_turned(hn_uvec2 p) {\n"
          "  return uvec2((p.x << 13u) | (p.y >> 19u), (p.y << 13u) | (p.x >> 19u));\n}\n"),
  };
}

}  // namespace hn
