// Bugs of floating-point arithmetic, of built-in functions and of conversions.
#include <cmath>

#include "cases/bugs/tables.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

// --- sin ---

// Vulkan's bound for sin and cos in [-pi, pi].
constexpr double kSineError = 0x1p-11;
constexpr std::string_view kSineReports =
    "taisei-project/taisei 189 (Intel, above 1e4); doitsujin/dxvk 4866 (Intel, near pi/2)";
constexpr std::string_view kSineBound =
    "OpenGL 4.6 section 2.3.4.1 requires about 1 part in 10^5 of every operation, Vulkan 2^-11 in [-pi, pi]; this "
    "is the wider";

void add_sine(std::vector<Bug>& bugs) {
  bugs.push_back({.function = bug_function("bugs.sin_within_a_turn", {{"x", f32}}, {{"sine", f32}},
                                           "return uvec4(bits_of(sin(float_of(a.x))), 0u, 0u, 0u);"),
                  .reference = kSineReports,
                  .specification = kSineBound,
                  .defined = true,
                  .allowed = kSineError,
                  .points = points_of<float>(
                      {0.0f, 0.001f, 0.01f, 0.1f, 0.5f,       1.0f,   1.5f,  1.55f,       1.5707963f, 1.58f,
                       1.6f, 2.0f,   2.5f,  3.0f, 3.1415925f, -0.25f, -1.0f, -1.5707963f, -1.6f,      -3.0f},
                      [](float x) { return Words{word(static_cast<float>(std::sin(static_cast<double>(x))))}; })});
  bugs.push_back(
      {.function = bug_function("bugs.sin_of_large", {{"x", f32}}, {{"sine", f32}},
                                "return uvec4(bits_of(sin(float_of(a.x))), 0u, 0u, 0u);"),
       .reference = kSineReports,
       .specification = "GLSL states no bound for sin, and Vulkan only within [-pi, pi]",
       .defined = false,
       .allowed = kSineError,
       .points = points_of<float>({4.0f, 100.0f, 9999.0f, 10001.0f, 12345.67f, 1e5f, 1e6f, 1e8f}, [](float x) {
         return Words{word(static_cast<float>(std::sin(static_cast<double>(x))))};
       })});
  bugs.push_back(
      {.function = bug_function("bugs.sin_of_small", {{"x", f32}}, {{"sine_over_x", f32}},
                                "hn_float x = float_of(a.x);\nreturn uvec4(bits_of(sin(x) / x), 0u, 0u, 0u);"),
       .reference = kSineReports,
       .specification =
           "GLSL states no bound for sin, and Vulkan's is absolute, so no digit of a small value need be right",
       .defined = false,
       .allowed = kSineError,
       .points =
           points_of<float>({0x1p-12f, 0x1p-16f, 0x1p-20f, 1e-9f, 1e-20f}, [](float) { return Words{word(1.0f)}; })});
  bugs.push_back(
      {.function = bug_function("bugs.fract_of_sin", {{"x", f32}}, {{"noise", f32}},
                                "return uvec4(bits_of(fract(sin(float_of(a.x)) * 43758.547)), 0u, 0u, 0u);"),
       .reference = "gfx-rs/wgpu 9561 (Apple A12, A14); godotengine/godot 106210; mrdoob/three.js 33467",
       .specification =
           "GLSL states no bound for sin, and 43758 times it has no certain digit; here within 1/64 of the exact one",
       .defined = false,
       .allowed = 0x1p-6,
       .points = points_of<float>({0.5f, 1.25f, 12.9898f, 78.233f, 1234.5f}, [](float x) {
         const double product = std::sin(static_cast<double>(x)) * static_cast<double>(43758.547f);
         return Words{word(static_cast<float>(product - std::floor(product)))};
       })});
  bugs.push_back(
      {.function = bug_function("bugs.cos_of_floor_quotient", {{"x", f32}, {"y", f32}}, {{"cosine", f32}},
                                "return uvec4(bits_of(cos(floor(float_of(a.x)) / float_of(a.y))), 0u, 0u, 0u);"),
       .reference = "WebGL conformance/glsl/bugs/floor-div-cos-should-not-truncate",
       .specification = kSineBound,
       .defined = true,
       .allowed = kSineError,
       .points = points(
           {{word(100000.5f), word(159154.953f)}, {word(250000.75f), word(159154.953f)}, {word(2.5f), word(3.0f)}},
           [](const Words& in) {
             const double quotient =
                 std::floor(static_cast<double>(as_float(in[0]))) / static_cast<double>(as_float(in[1]));
             return Words{word(static_cast<float>(std::cos(quotient)))};
           })});
}

// --- fract, floor, mod ---

// A quotient of 2.5 units in the last place: for those below 4096 that is less than 2^-10.
constexpr double kQuotientError = 0x1p-10;
constexpr std::string_view kQuotientOpen =
    "GLSL 4.60 section 4.7.1: a quotient may be off by 2.5 units in the last place, and so land below a whole number; "
    "here it is exact";
constexpr std::string_view kQuotientDefined =
    "GLSL 4.60 section 4.7.1: a quotient is off by 2.5 units in the last place at most, and these are far from whole "
    "numbers";

void add_fract(std::vector<Bug>& bugs) {
  constexpr std::string_view kFract = "fract that returns 1.0, seen on several drivers (llvmpipe among them)";
  bugs.push_back(
      {.function = bug_function("bugs.fract_of_small_negative", {{"x", f32}}, {{"fraction", f32}},
                                "return uvec4(bits_of(fract(float_of(a.x))), 0u, 0u, 0u);"),
       .reference = kFract,
       .specification =
           "GLSL 4.60 section 8.3: fract is x - floor(x), which rounds to 1 here; here the largest float below 1",
       .defined = false,
       .points = points_of<float>({-1e-9f, -2e-10f, -1e-20f}, [](float) { return Words{word(0x1.fffffep-1f)}; })});
  bugs.push_back(
      {.function = bug_function("bugs.fract_of_exact", {{"x", f32}}, {{"fraction", f32}, {"rest", f32}},
                                "hn_float x = float_of(a.x);\n"
                                "return uvec4(bits_of(fract(x)), bits_of(x - floor(x)), 0u, 0u);"),
       .reference = kFract,
       .specification = "GLSL 4.60 section 8.3: fract is x - floor(x), and these differences are floats",
       .defined = true,
       .points = points_of<float>({0.0f, 1.0f, 3.0f, -2.0f, 2.25f, -1.25f, 8388607.0f, 4194303.5f}, [](float x) {
         const float rest = x - std::floor(x);
         return Words{word(rest), word(rest)};
       })});
}

void add_quotients(std::vector<Bug>& bugs) {
  constexpr std::string_view kFloorReports =
      "WebGL conformance/glsl/bugs/floored-division-accuracy and floor-div-cos-should-not-truncate";
  bugs.push_back(
      {.function = bug_function("bugs.quotient_of_floor", {{"x", f32}, {"y", f32}}, {{"quotient", f32}},
                                "return uvec4(bits_of(floor(float_of(a.x)) / float_of(a.y)), 0u, 0u, 0u);"),
       .reference = kFloorReports,
       .specification = kQuotientDefined,
       .defined = true,
       .allowed = kQuotientError,
       .points = points({{word(7.75f), word(2.0f)}, {word(-7.25f), word(3.0f)}, {word(1023.5f), word(4.0f)}},
                        [](const Words& in) { return Words{word(std::floor(as_float(in[0])) / as_float(in[1]))}; })});
  bugs.push_back(
      {.function = bug_function("bugs.floor_of_quotient", {{"x", f32}, {"y", f32}}, {{"floor", f32}},
                                "return uvec4(bits_of(floor(float_of(a.x) / float_of(a.y))), 0u, 0u, 0u);"),
       .reference = kFloorReports,
       .specification = kQuotientDefined,
       .defined = true,
       .points = points({{word(7.0f), word(4.0f)},
                         {word(255.0f), word(256.0f)},
                         {word(-5.0f), word(2.0f)},
                         {word(1000.5f), word(7.0f)}},
                        [](const Words& in) { return Words{word(std::floor(as_float(in[0]) / as_float(in[1])))}; })});
  bugs.push_back({.function = bug_function("bugs.floor_of_whole_quotient", {{"x", f32}, {"y", f32}}, {{"floor", f32}},
                                           "return uvec4(bits_of(floor(float_of(a.x) / float_of(a.y))), 0u, 0u, 0u);"),
                  .reference = kFloorReports,
                  .specification = kQuotientOpen,
                  .defined = false,
                  .points = points({{word(6.0f), word(3.0f)},
                                    {word(33.0f), word(11.0f)},
                                    {word(343.0f), word(49.0f)},
                                    {word(65535.0f), word(255.0f)}},
                                   [](const Words& in) { return Words{word(as_float(in[0]) / as_float(in[1]))}; })});
}

void add_mod(std::vector<Bug>& bugs) {
  constexpr std::string_view kModReports =
      "WebGL conformance/glsl/bugs/modulo-arithmetic-accuracy; Kenix3/libultraship 1096 (PowerVR, at integers)";
  bugs.push_back({.function = bug_function("bugs.mod_of_multiple", {{"x", f32}, {"y", f32}}, {{"remainder", f32}},
                                           "return uvec4(bits_of(mod(float_of(a.x), float_of(a.y))), 0u, 0u, 0u);"),
                  .reference = kModReports,
                  .specification = kQuotientOpen,
                  .defined = false,
                  .points = points({{word(6.0f), word(3.0f)},
                                    {word(33.0f), word(11.0f)},
                                    {word(343.0f), word(49.0f)},
                                    {word(-22.0f), word(11.0f)}},
                                   [](const Words&) { return Words{word(0.0f)}; })});
  bugs.push_back({.function = bug_function("bugs.mod_between_multiples", {{"x", f32}, {"y", f32}}, {{"remainder", f32}},
                                           "return uvec4(bits_of(mod(float_of(a.x), float_of(a.y))), 0u, 0u, 0u);"),
                  .reference = kModReports,
                  .specification = kQuotientDefined,
                  .defined = true,
                  .points = points({{word(7.0f), word(4.0f)},
                                    {word(255.0f), word(256.0f)},
                                    {word(257.0f), word(256.0f)},
                                    {word(-5.0f), word(3.0f)},
                                    {word(11.5f), word(4.0f)}},
                                   [](const Words& in) {
                                     const float x = as_float(in[0]);
                                     const float y = as_float(in[1]);
                                     return Words{word(x - y * std::floor(x / y))};
                                   })});
}

// --- Contraction and reassociation ---

constexpr std::string_view kContractionReports = "visgl/luma.gl 1764 (Apple, ANGLE); RADV does it by default";
constexpr std::string_view kPrecise =
    "GLSL 4.00 section 4.9 (4.60 section 4.12), GLSL ES 3.20 section 4.9: with precise, operations are neither fused "
    "nor reassociated";
constexpr std::string_view kImprecise =
    "GLSL 4.60 section 4.7.1: a * b + c may round once or twice, and without precise sums may be reassociated; here as "
    "written";

// A product less itself is 0 however it is rounded, unless one of the two is not; (a + b) - a differs from b, where b
// is too small for a, in every rounding mode.
Function contraction(std::string_view id, std::string_view body) {
  return bug_function(id, {{"x", f32}, {"y", f32}, {"large", f32}}, {{"residue", f32}, {"lost", u32}}, body);
}

Words contraction_expected(const Words&) { return {word(0.0f), 1u}; }

std::vector<BugPoint> contraction_points() {
  return points({{word(1.1f), word(1.3f), word(1e8f)},
                 {word(0.7f), word(3.3f), word(3e9f)},
                 {word(-2.7f), word(0.3f), word(1e8f)}},
                contraction_expected);
}

void add_contraction(std::vector<Bug>& bugs) {
  bugs.push_back({.function = contraction("bugs.contracted_despite_precise",
                                          "precise hn_float x = float_of(a.x);\n"
                                          "precise hn_float y = float_of(a.y);\n"
                                          "precise hn_float large = float_of(a.z);\n"
                                          "precise hn_float product = x * y;\n"
                                          "precise hn_float residue = x * y + (-product);\n"
                                          "precise hn_float rest = (large + x) - large;\n"
                                          "return uvec4(bits_of(residue), rest != x ? 1u : 0u, 0u, 0u);"),
                  .reference = kContractionReports,
                  .specification = kPrecise,
                  .defined = true,
                  .profiles = "gl400 es320",
                  .points = contraction_points()});
  bugs.push_back({.function = contraction("bugs.contracted",
                                          "hn_float x = float_of(a.x);\n"
                                          "hn_float y = float_of(a.y);\n"
                                          "hn_float large = float_of(a.z);\n"
                                          "hn_float product = x * y;\n"
                                          "hn_float residue = x * y + (-product);\n"
                                          "hn_float rest = (large + x) - large;\n"
                                          "return uvec4(bits_of(residue), rest != x ? 1u : 0u, 0u, 0u);"),
                  .reference = kContractionReports,
                  .specification = kImprecise,
                  .defined = false,
                  .points = contraction_points()});
}

// --- Denormals, conversions, folding ---

void add_denormals(std::vector<Bug>& bugs) {
  constexpr std::string_view kReports = "denormals flushed: allowed, and seen on several drivers (llvmpipe among them)";
  bugs.push_back(
      {.function = bug_function("bugs.denormals_kept", {{"x", f32}, {"y", f32}}, {{"product", f32}, {"sum", f32}},
                                "hn_float x = float_of(a.x);\nhn_float y = float_of(a.y);\n"
                                "return uvec4(bits_of(x * y), bits_of(x * y + x * y), 0u, 0u);"),
       .reference = kReports,
       .specification = "GLSL 4.60 section 4.7.1: any denormalized value, input or output, may be flushed to 0",
       .defined = false,
       .points = points({{word(0x1p-126f), word(0.5f)}, {word(0x1p-100f), word(0x1p-40f)}}, [](const Words& in) {
         const float product = as_float(in[0]) * as_float(in[1]);
         return Words{word(product), word(product + product)};
       })});
  bugs.push_back(
      {.function = bug_function("bugs.small_normals_kept", {{"x", f32}, {"y", f32}}, {{"product", f32}, {"sum", f32}},
                                "hn_float x = float_of(a.x);\nhn_float y = float_of(a.y);\n"
                                "return uvec4(bits_of(x * y), bits_of(x * y + x * y), 0u, 0u);"),
       .reference = kReports,
       .specification = "GLSL 4.60 section 4.7.1: only denormals may be flushed, and these products and sums are exact",
       .defined = true,
       .points = points({{word(0x1p-126f), word(2.0f)},
                         {word(0x1p-60f), word(0x1.8p-60f)},
                         {word(0x1.4p-100f), word(1.0f)},
                         {word(0x1p-120f), word(0x1p-6f)}},
                        [](const Words& in) {
                          const float product = as_float(in[0]) * as_float(in[1]);
                          return Words{word(product), word(product + product)};
                        })});
}

void add_conversions(std::vector<Bug>& bugs) {
  constexpr std::string_view kReports =
      "uint to float rounded wrongly, seen on several drivers; NVIDIA 580 in ES, in default precision";
  bugs.push_back(
      {.function = bug_function("bugs.uint_to_float_exact", {{"x", u32}}, {{"converted", f32}, {"as_int", f32}},
                                "return uvec4(bits_of(float(a.x)), bits_of(float(int(a.x >> 8))), 0u, 0u);"),
       .reference = kReports,
       .specification = "GLSL 4.60 section 4.7.1: float has a 24-bit significand, which these integers fit",
       .defined = true,
       .points = points_of<std::uint32_t>(
           {0u, 1u, 65537u, 16777215u, 16777216u, 0xFFFFFF00u, 0x80000000u, 0x7FFFFF80u, 12345679u},
           [](std::uint32_t x) {
             return Words{word(static_cast<float>(x)), word(static_cast<float>(x >> 8))};
           })});
  bugs.push_back(
      {.function = bug_function("bugs.uint_to_float_rounded", {{"x", u32}}, {{"converted", f32}},
                                "return uvec4(bits_of(float(a.x)), 0u, 0u, 0u);"),
       .reference = kReports,
       .specification = "GLSL 4.60 section 4.7.1 leaves the rounding mode open; here to nearest, ties to even",
       .defined = false,
       .points = points_of<std::uint32_t>({16777217u, 16777219u, 0xFFFFFFFFu, 0x80000081u, 0x7FFFFFFFu},
                                          [](std::uint32_t x) { return Words{word(static_cast<float>(x))}; })});
  bugs.push_back(
      {.function = bug_function("bugs.uint_of_negative_float", {{"x", f32}}, {{"converted", u32}},
                                "return uvec4(uint(float_of(a.x)), 0u, 0u, 0u);"),
       .reference = "KhronosGroup/WebGL 3101",
       .specification =
           "GLSL 4.60 and GLSL ES 3.00 section 5.4.1: converting a negative float to uint is undefined; here by way "
           "of int",
       .defined = false,
       .points = points_of<float>({-1.0f, -2.75f, -65536.0f},
                                  [](float x) { return Words{word(static_cast<std::int32_t>(x))}; })});
  bugs.push_back(
      {.function = bug_function("bugs.int_of_float", {{"x", f32}}, {{"converted", i32}, {"floored", i32}},
                                "hn_float x = float_of(a.x);\n"
                                "return uvec4(uint(int(x)), uint(int(floor(x))), 0u, 0u);"),
       .reference = "Kenix3/libultraship 1096 (PowerVR, at integers)",
       .specification = "GLSL 4.60 section 5.4.1: the fractional part is dropped; floor of a whole number is itself",
       .defined = true,
       .points = points_of<float>({-1.5f, -1.0f, 1.75f, -8388607.0f, 8388607.0f, -0.25f, 63.999996f}, [](float x) {
         return Words{word(static_cast<std::int32_t>(x)), word(static_cast<std::int32_t>(std::floor(x)))};
       })});
}

void add_folding(std::vector<Bug>& bugs) {
  bugs.push_back(
      {.function = bug_function(
           "bugs.folded_floats", {{"x", f32}, {"y", f32}},
           {{"constant", f32}, {"variable", f32}, {"product", f32}, {"variable_product", f32}},
           "hn_float x = float_of(a.x);\nhn_float y = float_of(a.y);\n"
           "hn_float difference = 3.0 - 0.0000152587890625;\n"
           "hn_float product = 4095.5 * 0.75;\n"
           "return uvec4(bits_of(difference), bits_of(x - 0.0000152587890625), bits_of(product), bits_of(y * 0.75));"),
       .reference = "constant folding that differs from run time, seen on several drivers",
       .specification = "GLSL 4.60 section 4.3.3: constants fold to the value of run time; these results are floats, "
                        "so nothing is rounded",
       .defined = true,
       .points = points({{word(3.0f), word(4095.5f)}}, [](const Words&) {
         const std::uint32_t difference = word(3.0f - 0x1p-16f);
         const std::uint32_t product = word(4095.5f * 0.75f);
         return Words{difference, difference, product, product};
       })});
  bugs.push_back(
      {.function = bug_function("bugs.highp_beside_mediump", {{"x", f32}, {"y", u32}},
                                {{"sum", f32}, {"product", f32}, {"word", u32}},
                                "hn_float x = float_of(a.x);\n"
                                "mediump float one = 1.0;\nmediump uint three = 3u;\n"
                                "return uvec4(bits_of((x + one) - 1.0), bits_of(x * one), a.y * three, 0u);"),
       .reference = "ashima/webgl-noise 25 (iOS); stegu/webgl-noise 11",
       .specification = "GLSL ES 3.00 section 4.5.2: an operation has the highest precision of its operands, and "
                        "literals have none; highp has 24 and 32 bits",
       .defined = true,
       .profiles = "es300",
       .points = points(
           {{word(0x1.00002p-1f), 0x12345677u}, {word(0x1.555554p-1f), 65537u}, {word(0x1.0002p-2f), 0x80000001u}},
           [](const Words& in) {
             const float x = as_float(in[0]);
             return Words{word((x + 1.0f) - 1.0f), in[0], in[1] * 3u};
           })});
}

}  // namespace

void add_float_bugs(std::vector<Bug>& bugs) {
  add_sine(bugs);
  add_fract(bugs);
  add_quotients(bugs);
  add_mod(bugs);
  add_contraction(bugs);
  add_denormals(bugs);
  add_conversions(bugs);
  add_folding(bugs);
}

}  // namespace hn
