// Faults of floats, of built-in functions and of conversions.
#include <fmt/format.h>

#include <algorithm>

#include "fault/faults.hpp"

namespace hn {
namespace {

using Kind = Expression::Kind;

// floor(x) / y becomes floor(x / y).
std::optional<std::string> floor_divide(const Expression& node, const Rules::Render& render, Place&) {
  if (!node.is(Kind::binary, "/")) return std::nullopt;
  const Expression& dividend = bare(node.parts[0]);
  if (called_with_one(dividend) != "floor") return std::nullopt;
  return fmt::format("floor(({}){}/{})", render(dividend.parts[1]).whole(), node.token.space,
                     render(node.parts[1]).whole());
}

// a * b + c becomes one operation.
std::optional<std::string> contract(const Expression& node, const Rules::Render& render, Place&) {
  if (!node.is(Kind::binary, "+")) return std::nullopt;
  const Expression& product = bare(node.parts[0]);
  if (!product.is(Kind::binary, "*")) return std::nullopt;
  return fmt::format("hn_fault_fma({},{}{},{}{})", render(product.parts[0]).code, product.token.space,
                     render(product.parts[1]).whole(), node.token.space, render(node.parts[1]).whole());
}

// (x + y) - z becomes y + (x - z).
std::optional<std::string> reassociate(const Expression& node, const Rules::Render& render, Place&) {
  if (!node.is(Kind::binary, "-") || node.parts[0].kind != Kind::paren) return std::nullopt;
  const Expression& sum = bare(node.parts[0]);
  if (!sum.is(Kind::binary, "+")) return std::nullopt;
  return fmt::format("({} + ({}{} -{}))", render(sum.parts[1]).whole(), render(sum.parts[0]).whole(), node.token.space,
                     render(node.parts[1]).whole());
}

// A product and a sum that are rounded together: Dekker's and Knuth's exact products and sums. (The driver's fma may
// round twice.)
constexpr std::string_view kFused =
    "precise highp float p = a * b, s = a * 4097.0, ah = s - (s - a), al = a - ah, t = b * 4097.0, bh = t - (t - b), "
    "bl = b - bh, e = ((ah * bh - p) + ah * bl + al * bh) + al * bl, r = p + c, v = r - p, "
    "d = (p - (r - v)) + (c - v), x = r + (d + e); return x;";

// The constructor of a float; where a function sets the precision of its scope the argument's does not count.
std::optional<std::string> converted(const Expression& node, const Rules::Render& render, Place& place) {
  if (called_with_one(node) != "float" || place.highp_by_default) return std::nullopt;
  return fmt::format("hn_fault_float({})", render(node.parts[1]).whole());
}

bool has_constant(const Expression& arguments) {
  return is_constant(arguments) ||
         (arguments.kind == Kind::comma && std::ranges::any_of(arguments.parts, has_constant));
}

// A vec4 of numbers and others that is multiplied has its first component everywhere.
std::optional<std::string> constants_spread(const Expression& node, const Rules::Render& render, Place&) {
  if (!node.is(Kind::binary, "*")) return std::nullopt;
  const Expression& vector = bare(node.parts[0]);
  const bool concerned = vector.kind == Kind::call && vector.parts[0].token.text == "vec4" &&
                         vector.parts.size() == 2 && vector.parts[1].kind == Kind::comma &&
                         has_constant(vector.parts[1]);
  if (!concerned) return std::nullopt;
  return fmt::format("{}.xxxx{}*{}", render(vector).code, node.token.space, render(node.parts[1]).whole());
}

// hn_fault_float: what stands for the constructor of a float, with that result of an argument a.
std::string constructor(std::string_view before, std::string_view result, std::string_view of_uint) {
  std::string text;
  for (const std::string_view type : {"highp float", "highp int", "highp uint", "bool"}) {
    text += fmt::format("highp float hn_fault_float({} a) {{ {}return {}; }}\n", type, before,
                        type == "highp uint" ? of_uint : result);
  }
  return text;
}

constexpr std::string_view kHalf = "unpackHalf2x16(packHalf2x16(vec2(a, 0.0))).x";

std::vector<Shim> folded_coarsely() {
  std::vector<Shim> shims = arithmetic("HN_FAULT_COARSE(x)", "x", "x");
  for (Shim& shim : shims) {
    if (shim.name == "hn_fault_multiply" && shim.operands[0] == "uint") shim.code = "return (a * b) & 0xFFFFFFF8u;";
  }
  return shims;
}

bool is_es(const Profile& profile) { return profile.es; }
bool has_precise(const Profile& profile) { return profile.has_precise(); }

}  // namespace

std::vector<Shim> arithmetic(std::string_view floats, std::string_view ints, std::string_view uints) {
  std::vector<Shim> shims;
  for (const auto& [symbol, name] : kArithmetic) {
    for (const auto& [type, result] : {std::pair{"float", floats}, {"int", ints}, {"uint", uints}}) {
      shims.push_back({name, {type, type}, fmt::format("highp {} x = a {} b; return {};", type, symbol, result)});
    }
  }
  return shims;
}

std::vector<Fault> float_faults() {
  return {
      {.name = "sin_imprecise",
       .fault = "sin wrong for large, small and near-pi/2 arguments",
       .reported = "taisei 189 (Intel above 1e4); dxvk 4866",
       .injected = "sin is 0 above 10^4, 0 below 2^-10, and 2^-9 too large near pi/2",
       .remark = "GLSL states no bound for sin: only an error beyond OpenGL's and Vulkan's bounds within a turn fails",
       .shims = {{"hn_fault_sin",
                  {"float"},
                  "return abs(a) > 1e4 || abs(a) < 0.0009765625 ? 0.0 : "
                  "sin(a) + (abs(sin(a)) > 0.999 ? 0.001953125 : 0.0);"}},
       .rules = {.functions = {{"sin", "hn_fault_sin"}}}},
      {.name = "sin_by_table",
       .fault = "fract(sin(x)) differing by GPU",
       .reported = "wgpu 9561 (Apple A12/A14); godot 106210; three.js 33467",
       .injected = "sin has steps of 2^-7",
       .remark = "GLSL bounds no digit of the fract of a large multiple of sin: a warning; steps beyond 2^-11 fail",
       .shims = {{"hn_fault_sin", {"float"}, "return floor(sin(a) * 128.0) / 128.0;"}},
       .rules = {.functions = {{"sin", "hn_fault_sin"}}}},
      {.name = "fract_returns_one",
       .fault = "fract returns 1.0",
       .reported = "seen on several; llvmpipe, for fract(-2e-10)",
       .injected = "fract of a whole number is 1",
       .remark = "for a tiny negative number 1 is x - floor(x), rounded: a warning",
       .shims = {{"hn_fault_fract", {"float"}, "return a == floor(a) ? 1.0 : fract(a);"}},
       .rules = {.functions = {{"fract", "hn_fault_fract"}}}},
      {.name = "floor_divide_merged",
       .fault = "floor then divide merged",
       .reported = "WebGL `floored-division-accuracy`, `floor-div-cos-should-not-truncate`",
       .injected = "`floor(x) / y` is floor(x / y)",
       .remark = "a quotient may be 2.5 ULP off, so floor of a whole quotient is a warning",
       .rules = {.pattern = floor_divide}},
      {.name = "mod_at_integers",
       .fault = "mod wrong at integers",
       .reported = "WebGL `modulo-arithmetic-accuracy`; libultraship 1096 (PowerVR)",
       .injected = "mod multiplies by a reciprocal that is 2^-7 too large",
       .remark = "at multiples of y both 0 and y are within the bound of a quotient: a warning",
       .shims = {{"hn_fault_mod", {"float", "float"}, "return a - b * floor(a * (1.0078125 / b));"}},
       .rules = {.functions = {{"mod", "hn_fault_mod"}}}},
      {.name = "contracted",
       .fault = "a*b+c contracted",
       .reported = "luma.gl 1764 (Apple, ANGLE); RADV by default",
       .injected = "`a * b + c` is rounded once although it is precise (GLSL 4.00, ES 3.20)",
       .remark = "without precise it is allowed, and the library's bounds hold with and without",
       .shims = {{"hn_fault_fma", {"float", "float", "float"}, std::string(kFused)},
                 {"hn_fault_fma", {"int", "int", "int"}, "return a * b + c;"},
                 {"hn_fault_fma", {"uint", "uint", "uint"}, "return a * b + c;"}},
       .rules = {.pattern = contract},
       .concerns = has_precise},
      {.name = "reassociated",
       .fault = "sums reassociated",
       .reported = "luma.gl 1764 (Apple, ANGLE)",
       .injected = "`(x + y) - z` is y + (x - z) although it is precise",
       .remark = "without precise it is allowed: a warning, which llvmpipe and softpipe give as they are",
       .rules = {.pattern = reassociate}},
      {.name = "mediump_everywhere",
       .fault = "mediump hash",
       .reported = "ashima/webgl-noise 25 (iOS); stegu/webgl-noise 11",
       .injected = "in ES, highp is treated as mediump: `+`, `-`, `*` keep 16 bits of integers and 11 of floats",
       .remark = "a hash in mediump variables may lose its bits: a warning",
       .shims = arithmetic("unpackHalf2x16(packHalf2x16(vec2(x, 0.0))).x", "(x << 16) >> 16", "x & 0xFFFFu"),
       .rules = {.operators = kArithmetic},
       .concerns = is_es},
      {.name = "small_flushed",
       .fault = "denormals flushed",
       .reported = "allowed; seen on several (llvmpipe flushes, softpipe does not)",
       .injected = "results of `+`, `-`, `*` below 2^-80 become 0, normal ones as well",
       .remark = "denormals themselves may be flushed anywhere: a warning",
       .shims = arithmetic("abs(x) < 8.271806125530277e-25 ? 0.0 : x", "x", "x"),
       .rules = {.operators = kArithmetic}},
      {.name = "mediump_conversions",
       .fault = "a constructor has the default precision, not that of its argument",
       .reported = "NVIDIA 580; KhronosGroup/glslang 999, 1087",
       .injected = "in ES, a float made of an integer or a float keeps 11 bits, unless the function begins with "
                   "`precision highp float`",
       .declared = constructor("precision highp float; ", kHalf, kHalf),
       .rules = {.pattern = converted},
       .concerns = is_es},
      {.name = "uint_to_float",
       .fault = "uint to float rounded wrongly",
       .reported = "seen on several",
       .injected = "float(uint) keeps 23 bits of numbers beyond 2^23",
       .remark = "beyond 24 bits any rounding is allowed: a warning",
       .declared = constructor("", "float(a)", "float(a >= 0x800000u ? a & 0xFFFFFFFEu : a)"),
       .rules = {.functions = {{"float", "hn_fault_float"}}}},
      {.name = "constants_folded_coarsely",
       .fault = "constant folding that differs from run time",
       .reported = "seen on several",
       .injected = "an operation of numbers is folded to 11 bits of a float (where GLSL has bit casts), and a product "
                   "of uints without its low 3 bits",
       .declared = "#if __VERSION__ >= 330 || defined(GL_ES)\n"
                   "#define HN_FAULT_COARSE(x) uintBitsToFloat(floatBitsToUint(x) & 0xFFFFE000u)\n"
                   "#else\n#define HN_FAULT_COARSE(x) (x)\n#endif\n",
       .shims = folded_coarsely(),
       .rules = {.operators = kArithmetic, .only_constants = true}},
      {.name = "constants_spread",
       .fault = "a vec4 of constants and one value wrong behind a product",
       .reported = "MangoHud 2081 (RADV of Mesa 26.0)",
       .injected = "a vec4 with numbers among its components has the first in all, where it is multiplied",
       .rules = {.pattern = constants_spread}},
  };
}

}  // namespace hn
