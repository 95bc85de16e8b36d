// Bugs of floating-point arithmetic, of built-in functions and of conversions.
#include <cmath>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using uint = std::uint32_t;

// Vulkan's bound for sin and cos in [-pi, pi].
constexpr double kSineError = 0x1p-11;
constexpr std::string_view kSineReports =
    "taisei-project/taisei 189 (Intel, above 1e4); doitsujin/dxvk 4866 (Intel, near pi/2)";
constexpr Rule kSineBound = defined(
    "OpenGL 4.6 section 2.3.4.1 requires about 1 part in 10^5 of every operation, Vulkan and WGSL (Accuracy of "
    "Concrete "
    "Floating Point Expressions) 2^-11 in [-pi, pi], Metal (section 8.4) less; this is the widest",
    kSineError);
constexpr Rule kSineInHlsl = defined("Direct3D 11.3, sincos: an error of 0.0008 at most", 0.0008);
float sine(float x) { return static_cast<float>(std::sin(static_cast<double>(x))); }

constexpr std::string_view kFractReports = "fract that returns 1.0, seen on several drivers (llvmpipe among them)";
constexpr std::string_view kFloorReports =
    "WebGL conformance/glsl/bugs/floored-division-accuracy and floor-div-cos-should-not-truncate";
constexpr std::string_view kModReports =
    "WebGL conformance/glsl/bugs/modulo-arithmetic-accuracy; Kenix3/libultraship 1096 (PowerVR, at integers)";
constexpr Rule kQuotientOpen = left_open(
    "GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place, and so land below a whole number; "
    "here it is exact");
// So much is less than 2^-10 of quotients below 4096.
constexpr double kQuotientError = 0x1p-10;
constexpr Rule quotient(double allowed) {
  return defined(
      "GLSL 4.60 section 4.7.1: a quotient is off by 2.5 units in the last place at most (in WGSL as well, in Direct3D "
      "and Metal less), and these are far from whole numbers",
      allowed);
}

constexpr std::string_view kContractionReports = "visgl/luma.gl 1764 (Apple, ANGLE); RADV does it by default";
// A product less itself is 0 however it is rounded, unless one of the two is not; (a + b) - a differs from b, where b
// is too small for a, in every rounding mode.
Bug contraction(std::string_view id, std::string_view body, const Rule& rule, std::string_view profiles) {
  return bug(id, {{"x", f32}, {"y", f32}, {"large", f32}}, {{"residue", f32}, {"lost", u32}}, body, kContractionReports,
             rule,
             points<float, float, float>({{1.1f, 1.3f, 1e8f}, {0.7f, 3.3f, 3e9f}, {-2.7f, 0.3f, 1e8f}},
                                         [](float, float, float) { return words(0.0f, 1); }),
             profiles);
}

constexpr std::string_view kDenormalReports =
    "denormals flushed: allowed, and seen on several drivers (llvmpipe among them)";
constexpr std::string_view kProductAndSum =
    "hn_float x = float_of(a.x);\nhn_float y = float_of(a.y);\n"
    "return uvec4(bits_of(x * y), bits_of(x * y + x * y), 0u, 0u);";
constexpr std::string_view kConversionReports =
    "uint to float rounded wrongly, seen on several drivers; NVIDIA 580 in ES, in default precision";

constexpr Rule kConstructors = defined(
    "GLSL 4.60 section 5.4.1: a constructor keeps an int's value in a float, and its bits in a uint. So WGSL (f32, "
    "u32), "
    "HLSL's itof, utof and ftoi, and C++14 [conv] (Metal)");

// Positions that a server and a client compute from whole numbers, each for itself (docs/guide/same-bits.md).
constexpr std::string_view kPositionReports =
    "hashnoise docs/guide/same-bits.md (ANGLE on SwiftShader, where sevenths differ)";

// Whole numbers near 0, and some of 20 bits on both sides.
template <typename Expected>
Points whole_points(Expected expected) {
  Points all;
  for (int i = -64; i < 64; ++i) {
    for (const int units : {i, i * 16381}) all.push_back({words(units), expected(units)});
  }
  return all;
}

}  // namespace

std::vector<Bug> float_bugs() {
  const auto product_and_sum = [](float x, float y) { return words(x * y, x * y + x * y); };
  return {
      but_in(kHlsl, kSineInHlsl,
             bug("bugs.sin_within_a_turn", {{"x", f32}}, {{"sine", f32}},
                 "return uvec4(bits_of(sin(float_of(a.x))), 0u, 0u, 0u);", kSineReports, kSineBound,
                 points<float>({0.0f, 0.001f, 0.01f, 0.1f, 0.5f,       1.0f,   1.5f,  1.55f,       1.5707963f, 1.58f,
                                1.6f, 2.0f,   2.5f,  3.0f, 3.1415925f, -0.25f, -1.0f, -1.5707963f, -1.6f,      -3.0f},
                               [](float x) { return words(sine(x)); }))),
      bug("bugs.sin_of_large", {{"x", f32}}, {{"sine", f32}}, "return uvec4(bits_of(sin(float_of(a.x))), 0u, 0u, 0u);",
          kSineReports,
          left_open("GLSL states no bound for sin, and Vulkan and WGSL only within [-pi, pi]", kSineError),
          points<float>({4.0f, 100.0f, 9999.0f, 10001.0f, 12345.67f, 1e5f, 1e6f, 1e8f},
                        [](float x) { return words(sine(x)); })),
      bug("bugs.sin_of_small", {{"x", f32}}, {{"sine_over_x", f32}},
          "hn_float x = float_of(a.x);\nreturn uvec4(bits_of(sin(x) / x), 0u, 0u, 0u);", kSineReports,
          left_open(
              "GLSL states no bound for sin, and Vulkan's is absolute, so no digit of a small value need be right",
              kSineError),
          points<float>({0x1p-12f, 0x1p-16f, 0x1p-20f, 1e-9f, 1e-20f}, [](float) { return words(1.0f); })),
      bug("bugs.fract_of_sin", {{"x", f32}}, {{"noise", f32}},
          "return uvec4(bits_of(fract(sin(float_of(a.x)) * 43758.547f)), 0u, 0u, 0u);",
          "gfx-rs/wgpu 9561 (Apple A12, A14); godotengine/godot 106210; mrdoob/three.js 33467",
          left_open("GLSL states no bound for sin, and 43758 times it has no certain digit; here within 1/64 of the "
                    "exact one",
                    0x1p-6),
          points<float>({0.5f, 1.25f, 12.9898f, 78.233f, 1234.5f},
                        [](float x) {
                          const double product = std::sin(static_cast<double>(x)) * static_cast<double>(43758.547f);
                          return words(static_cast<float>(product - std::floor(product)));
                        })),
      but_in(kHlsl, kSineInHlsl,
             bug("bugs.cos_of_floor_quotient", {{"x", f32}, {"y", f32}}, {{"cosine", f32}},
                 "return uvec4(bits_of(cos(floor(float_of(a.x)) / float_of(a.y))), 0u, 0u, 0u);",
                 "WebGL conformance/glsl/bugs/floor-div-cos-should-not-truncate", kSineBound,
                 points<float, float>({{100000.5f, 159154.953f}, {250000.75f, 159154.953f}, {2.5f, 3.0f}},
                                      [](float x, float y) {
                                        const double quotient =
                                            std::floor(static_cast<double>(x)) / static_cast<double>(y);
                                        return words(static_cast<float>(std::cos(quotient)));
                                      }))),

      bug("bugs.fract_of_small_negative", {{"x", f32}}, {{"fraction", f32}},
          "return uvec4(bits_of(fract(float_of(a.x))), 0u, 0u, 0u);", kFractReports,
          left_open(
              "GLSL 4.60 section 8.3: fract is x - floor(x), which rounds to 1 here; here the largest float below 1"),
          points<float>({-1e-9f, -2e-10f, -1e-20f}, [](float) { return words(0x1.fffffep-1f); })),
      bug("bugs.fract_of_exact", {{"x", f32}}, {{"fraction", f32}, {"rest", f32}},
          "hn_float x = float_of(a.x);\n"
          "return uvec4(bits_of(fract(x)), bits_of(x - floor(x)), 0u, 0u);",
          kFractReports,
          defined(
              "GLSL 4.60 section 8.3: fract is x - floor(x), and these differences are floats. So WGSL's fract, HLSL's "
              "frac, and Metal's (section 6.5)"),
          points<float>({0.0f, 1.0f, 3.0f, -2.0f, 2.25f, -1.25f, 8388607.0f, 4194303.5f},
                        [](float x) { return words(x - std::floor(x), x - std::floor(x)); })),
      bug("bugs.quotient_of_floor", {{"x", f32}, {"y", f32}}, {{"quotient", f32}},
          "return uvec4(bits_of(floor(float_of(a.x)) / float_of(a.y)), 0u, 0u, 0u);", kFloorReports,
          quotient(kQuotientError),
          points<float, float>({{7.75f, 2.0f}, {-7.25f, 3.0f}, {1023.5f, 4.0f}},
                               [](float x, float y) { return words(std::floor(x) / y); })),
      bug("bugs.floor_of_quotient", {{"x", f32}, {"y", f32}}, {{"floor", f32}},
          "return uvec4(bits_of(floor(float_of(a.x) / float_of(a.y))), 0u, 0u, 0u);", kFloorReports, quotient(0.0),
          points<float, float>({{7.0f, 4.0f}, {255.0f, 256.0f}, {-5.0f, 2.0f}, {1000.5f, 7.0f}},
                               [](float x, float y) { return words(std::floor(x / y)); })),
      bug("bugs.floor_of_whole_quotient", {{"x", f32}, {"y", f32}}, {{"floor", f32}},
          "return uvec4(bits_of(floor(float_of(a.x) / float_of(a.y))), 0u, 0u, 0u);", kFloorReports, kQuotientOpen,
          points<float, float>({{6.0f, 3.0f}, {33.0f, 11.0f}, {343.0f, 49.0f}, {65535.0f, 255.0f}},
                               [](float x, float y) { return words(x / y); })),
      // No other language has mod.
      bug("bugs.mod_of_multiple", {{"x", f32}, {"y", f32}}, {{"remainder", f32}},
          "return uvec4(bits_of(mod(float_of(a.x), float_of(a.y))), 0u, 0u, 0u);", kModReports, kQuotientOpen,
          points<float, float>({{6.0f, 3.0f}, {33.0f, 11.0f}, {343.0f, 49.0f}, {-22.0f, 11.0f}},
                               [](float, float) { return words(0.0f); }),
          kInGlsl),
      bug("bugs.mod_between_multiples", {{"x", f32}, {"y", f32}}, {{"remainder", f32}},
          "return uvec4(bits_of(mod(float_of(a.x), float_of(a.y))), 0u, 0u, 0u);", kModReports, quotient(0.0),
          points<float, float>({{7.0f, 4.0f}, {255.0f, 256.0f}, {257.0f, 256.0f}, {-5.0f, 3.0f}, {11.5f, 4.0f}},
                               [](float x, float y) { return words(x - y * std::floor(x / y)); }),
          kInGlsl),

      contraction("bugs.contracted_despite_precise",
                  "precise hn_float x = float_of(a.x);\n"
                  "precise hn_float y = float_of(a.y);\n"
                  "precise hn_float large = float_of(a.z);\n"
                  "precise hn_float product = x * y;\n"
                  "precise hn_float residue = x * y + (-product);\n"
                  "precise hn_float rest = (large + x) - large;\n"
                  "return uvec4(bits_of(residue), rest != x ? 1u : 0u, 0u, 0u);",
                  defined("GLSL 4.00 section 4.9 (4.60 section 4.12), GLSL ES 3.20 section 4.9: with precise, "
                          "operations are neither fused nor reassociated; so HLSL's precise"),
                  "gl400 es320 vulkan hlsl60"),
      contraction("bugs.contracted",
                  "hn_float x = float_of(a.x);\n"
                  "hn_float y = float_of(a.y);\n"
                  "hn_float large = float_of(a.z);\n"
                  "hn_float product = x * y;\n"
                  "hn_float residue = x * y + (-product);\n"
                  "hn_float rest = (large + x) - large;\n"
                  "return uvec4(bits_of(residue), rest != x ? 1u : 0u, 0u, 0u);",
                  left_open("GLSL 4.60 section 4.7.1: a * b + c may round once or twice, and without precise sums may "
                            "be reassociated; here as written"),
                  kEverywhere),
      bug("bugs.denormals_kept", {{"x", f32}, {"y", f32}}, {{"product", f32}, {"sum", f32}}, kProductAndSum,
          kDenormalReports,
          left_open("GLSL 4.60 section 4.7.1: any denormalized value, input or output, may be flushed to 0"),
          points<float, float>({{0x1p-126f, 0.5f}, {0x1p-100f, 0x1p-40f}}, product_and_sum)),
      bug("bugs.small_normals_kept", {{"x", f32}, {"y", f32}}, {{"product", f32}, {"sum", f32}}, kProductAndSum,
          kDenormalReports,
          defined("GLSL 4.60 section 4.7.1, WGSL (Floating Point Evaluation), Direct3D 11.3 section 3.1.3 and Metal "
                  "section "
                  "8.1: only denormals may be flushed, and these products and sums are exact"),
          points<float, float>({{0x1p-126f, 2.0f}, {0x1p-60f, 0x1.8p-60f}, {0x1.4p-100f, 1.0f}, {0x1p-120f, 0x1p-6f}},
                               product_and_sum)),

      bug("bugs.uint_to_float_exact", {{"x", u32}}, {{"converted", f32}, {"as_int", f32}},
          "return uvec4(bits_of(float(a.x)), bits_of(float(int(a.x >> 8))), 0u, 0u);", kConversionReports,
          defined(
              "GLSL 4.60 section 4.7.1: float has a 24-bit significand, which these integers fit. So WGSL (Floating "
              "Point Conversion), Direct3D's itof and utof, and Metal (section 8.6)"),
          points<uint>({0u, 1u, 65537u, 16777215u, 16777216u, 0xFFFFFF00u, 0x80000000u, 0x7FFFFF80u, 12345679u},
                       [](uint x) { return words(static_cast<float>(x), static_cast<float>(x >> 8)); })),
      bug("bugs.uint_to_float_rounded", {{"x", u32}}, {{"converted", f32}},
          "return uvec4(bits_of(float(a.x)), 0u, 0u, 0u);", kConversionReports,
          left_open("GLSL 4.60 section 4.7.1 leaves the rounding mode open; here to nearest, ties to even"),
          points<uint>({16777217u, 16777219u, 0xFFFFFFFFu, 0x80000081u, 0x7FFFFFFFu},
                       [](uint x) { return words(static_cast<float>(x)); })),
      bug("bugs.uint_of_negative_float", {{"x", f32}}, {{"converted", u32}},
          "return uvec4(uint(float_of(a.x)), 0u, 0u, 0u);", "KhronosGroup/WebGL 3101",
          left_open("GLSL 4.60 and GLSL ES 3.00 section 5.4.1: converting a negative float to uint is undefined; here "
                    "by way of int"),
          points<float>({-1.0f, -2.75f, -65536.0f}, [](float x) { return words(static_cast<int>(x)); }), kInGlsl),
      bug("bugs.int_of_float", {{"x", f32}}, {{"converted", i32}, {"floored", i32}},
          "hn_float x = float_of(a.x);\n"
          "return uvec4(uint(int(x)), uint(int(floor(x))), 0u, 0u);",
          "Kenix3/libultraship 1096 (PowerVR, at integers)",
          defined("GLSL 4.60 section 5.4.1, WGSL (i32), Direct3D's ftoi, and C++14 [conv.fpint] (Metal): the "
                  "fractional part "
                  "is dropped; floor of a whole number is itself"),
          points<float>({-1.5f, -1.0f, 1.75f, -8388607.0f, 8388607.0f, -0.25f, 63.999996f},
                        [](float x) { return words(static_cast<int>(x), static_cast<int>(std::floor(x))); })),
      bug("bugs.folded_floats", {{"x", f32}, {"y", f32}},
          {{"constant", f32}, {"variable", f32}, {"product", f32}, {"variable_product", f32}},
          "hn_float x = float_of(a.x);\nhn_float y = float_of(a.y);\n"
          "hn_float difference = 3.0f - 0.0000152587890625f;\n"
          "hn_float product = 4095.5f * 0.75f;\n"
          "return uvec4(bits_of(difference), bits_of(x - 0.0000152587890625f), bits_of(product), bits_of(y * 0.75f));",
          "constant folding that differs from run time, seen on several drivers",
          defined("GLSL 4.60 section 4.3.3, and every other language: constants fold to the value of run time; these "
                  "results are floats, so nothing is rounded"),
          points<float, float>(
              {{3.0f, 4095.5f}},
              [](float x, float y) { return words(x - 0x1p-16f, x - 0x1p-16f, y * 0.75f, y * 0.75f); })),
      bug("bugs.highp_beside_mediump", {{"x", f32}, {"y", u32}}, {{"sum", f32}, {"product", f32}, {"word", u32}},
          "hn_float x = float_of(a.x);\n"
          "mediump float one = 1.0;\nmediump uint three = 3u;\n"
          "return uvec4(bits_of((x + one) - 1.0f), bits_of(x * one), a.y * three, 0u);",
          "ashima/webgl-noise 25 (iOS); stegu/webgl-noise 11",
          defined("GLSL ES 3.00 section 4.5.2: an operation has the highest precision of its operands, and literals "
                  "have none; highp has 24 and 32 bits"),
          points<float, uint>({{0x1.00002p-1f, 0x12345677u}, {0x1.555554p-1f, 65537u}, {0x1.0002p-2f, 0x80000001u}},
                              [](float x, uint y) { return words((x + 1.0f) - 1.0f, x, y * 3u); }),
          "es300"),
      bug("bugs.int_of_uint_vector", {{"x", u32}, {"y", u32}, {"z", f32}, {"w", f32}},
          {{"x", f32}, {"y", f32}, {"z", u32}, {"w", u32}},
          "hn_vec2 f = vec2(ivec2(uvec2(a.x, a.y)));\n"
          "hn_uvec4 u = uvec4(ivec4(vec4(float_of(a.z), float_of(a.w), -3.0f, 2.0f)));\n"
          "return uvec4(bits_of(f.x), bits_of(f.y), u.x, u.y);",
          "microsoft/DirectXShaderCompiler 3396 and 6975 (DXC to SPIR-V)", kConstructors,
          points<uint, uint, float, float>(
              {{0xFFFFFFFFu, 0xFFFFFFFEu, -5.0f, -10.0f}, {7u, 0x80000000u, 3.75f, -65536.5f}},
              [](uint x, uint y, float z, float w) {
                return words(static_cast<float>(static_cast<int>(x)), static_cast<float>(static_cast<int>(y)),
                             static_cast<int>(z), static_cast<int>(w));
              })),
      bug("bugs.float_beside_uint", {{"x", i32}}, {{"as_int", f32}, {"bits", u32}, {"as_uint", f32}, {"half", u32}},
          "hn_int x = int(a.x);\n"
          "return uvec4(bits_of(float(x)), uint(x), bits_of(float(uint(x))), uint(x) >> 1u);",
          "hashnoise docs/measured/faults.md (vkd3d takes float(x) and uint(x) for one conversion)", kConstructors,
          points<int>({-256, 5, -2147483647 - 1, -1073741824},
                      [](int x) {
                        const uint bits = word(x);
                        return words(static_cast<float>(x), bits, static_cast<float>(bits), bits >> 1);
                      })),
      // A translation would have f32, and the bug is in numbers of no type.
      in_wgsl(
          "let product = i32(0.0 * 1048576.0);\n"
          "return vec4u(u32(i32(1048576.0)) + a.x, u32(product) + a.x, u32(16777216.0), bitcast<u32>(f32(1048576)));",
          bug("bugs.literals_converted", {{"x", u32}}, {{"int", i32}, {"product", i32}, {"uint", u32}, {"float", f32}},
              "hn_int product = int(0.0 * 1048576.0);\n"
              "return uvec4(uint(int(1048576.0)) + a.x, uint(product) + a.x, uint(16777216.0), "
              "bits_of(float(1048576)));",
              "gfx-rs/wgpu 7312 (naga 22.0.0 refuses int(1048576.0))", kConstructors,
              points<uint>({1u, 0xFFFFFFFFu}, [](uint x) { return words(1048576u + x, x, 16777216u, 1048576.0f); }))),
      bug("bugs.vector_of_constants", {{"x", f32}, {"y", f32}}, {{"x", f32}, {"y", f32}, {"z", f32}, {"w", f32}},
          "hn_vec4 v = vec4(0.5f, float_of(a.x), 2.0f, -1.0f) * float_of(a.y);\n"
          "return uvec4(bits_of(v.x), bits_of(v.y), bits_of(v.z), bits_of(v.w));",
          "flightlessmango/MangoHud 2081 (RADV of Mesa 26.0 on GFX11)",
          defined(
              "GLSL 4.60 section 5.9, and every other language: a scalar multiplies each component; these products are "
              "exact"),
          points<float, float>({{3.0f, 1.5f}, {-0.125f, 8.0f}, {1.0f, 1.0f}},
                               [](float x, float y) { return words(0.5f * y, x * y, 2.0f * y, -y); })),
      bug("bugs.position_of_cell", {{"units", i32}}, {{"cell", i32}, {"fraction", f32}, {"eighths", f32}},
          "hn_int units = int(a.x);\n"
          "hn_float fraction = float(units & 1023) * 0.0009765625f;\n"
          "return uvec4(uint(units >> 10), bits_of(fraction), bits_of(float(units) * 0.125f), 0u);",
          kPositionReports,
          defined("GLSL 4.60 sections 5.9 and 4.7.1, and every other language: >> repeats the sign, and a product that "
                  "is a "
                  "float is exact"),
          whole_points([](int units) {
            return words(units >> 10, static_cast<float>(units & 1023) * 0x1p-10f, static_cast<float>(units) * 0.125f);
          })),
      bug("bugs.position_in_eighths", {{"units", i32}}, {{"position", f32}},
          "return uvec4(bits_of(float(int(a.x)) / 8.0f), 0u, 0u, 0u);", kPositionReports,
          left_open("GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place, even this one"),
          whole_points([](int units) { return words(static_cast<float>(units) / 8.0f); })),
      bug("bugs.position_in_sevenths", {{"units", i32}}, {{"position", f32}},
          "return uvec4(bits_of(float(int(a.x)) / 7.0f), 0u, 0u, 0u);", kPositionReports,
          left_open("GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place"),
          whole_points([](int units) { return words(static_cast<float>(units) / 7.0f); })),
  };
}

}  // namespace hn
