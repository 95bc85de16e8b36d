// Faults of integers.
#include <fmt/format.h>

#include "fault/faults.hpp"

namespace hn {
namespace {

using Kind = Expression::Kind;

// A uint shift whose operand is uint(int): an arithmetic shift. Vectors were not affected.
std::optional<std::string> shift_keeps_sign(const Expression& node, const Rules::Render& render, Place&) {
  if (!node.is(Kind::binary, ">>")) return std::nullopt;
  const Expression& operand = bare(node.parts[0]);
  if (called_with_one(operand) != "uint") return std::nullopt;
  return fmt::format("uint(int({}){}>>{})", render(operand.parts[1]).whole(), node.token.space,
                     render(node.parts[1]).whole());
}

// Two shifts by numbers become one by their sum, and hardware shifts by the low five bits of that.
std::optional<std::string> shifts_merge(const Expression& node, const Rules::Render& render, Place&) {
  if (!node.is(Kind::binary, ">>") && !node.is(Kind::binary, "<<")) return std::nullopt;
  const Expression& inner = bare(node.parts[0]);
  const bool both =
      inner.is(Kind::binary, node.token.text) && is_constant(inner.parts[1]) && is_constant(node.parts[1]);
  if (!both) return std::nullopt;
  return fmt::format("({}{}{} ((int({}) + int({})) & 31))", render(inner.parts[0]).code, node.token.space,
                     node.token.text, render(inner.parts[1]).whole(), render(node.parts[1]).whole());
}

// A call of a function with two arguments.
bool is_pair(const Expression& node, std::string_view function) {
  return node.kind == Kind::call && node.parts[0].token.text == function && node.parts.size() == 2 &&
         node.parts[1].kind == Kind::comma && node.parts[1].parts[0].kind != Kind::comma;
}

// In max(max(x, -x), y), and in min, -x is lost.
std::optional<std::string> negative_lost(const Expression& node, const Rules::Render& render, Place&) {
  for (const std::string_view function : {"max", "min"}) {
    if (!is_pair(node, function)) continue;
    const Expression& arguments = node.parts[1];
    const Expression& inner = bare(arguments.parts[0]);
    if (!is_pair(inner, function) || bare(inner.parts[1].parts[1]).token.text != "-") continue;
    return fmt::format("{0}(hn_fault_{0}({1}), {2})", function, render(inner.parts[1]).whole(),
                       render(arguments.parts[1]).whole());
  }
  return std::nullopt;
}

std::optional<std::string> bits_lost(const Expression& node, const Rules::Render& render, Place&) {
  if (called_with_one(node) != "floatBitsToUint") return std::nullopt;
  return fmt::format("hn_fault_bits(floatBitsToUint({}))", render(node.parts[1]).whole());
}

// (-x) / n becomes x / (-n), and so does -(x / n).
std::optional<std::string> negation_moved(const Expression& node, const Rules::Render& render, Place&) {
  const bool outside = node.is(Kind::prefix, "-");
  const Expression& quotient = outside ? bare(node.parts[0]) : node;
  if (!quotient.is(Kind::binary, "/") || !is_constant(quotient.parts[1])) return std::nullopt;
  const Expression& dividend = bare(quotient.parts[0]);
  if (dividend.is(Kind::prefix, "-") == outside) return std::nullopt;
  return fmt::format("({} / (-({})))", render(outside ? dividend : dividend.parts[0]).code,
                     render(quotient.parts[1]).whole());
}

// x + n > x becomes true.
std::optional<std::string> overflow_ignored(const Expression& node, const Rules::Render& render, Place&) {
  if (!node.is(Kind::binary, ">") || !bare(node.parts[0]).is(Kind::binary, "+")) return std::nullopt;
  if (render(bare(node.parts[0]).parts[0]).code != render(node.parts[1]).code) return std::nullopt;
  return "true";
}

// An int that becomes a float counts as a uint.
std::optional<std::string> int_as_uint(const Expression& node, const Rules::Render& render, Place&) {
  const std::string_view outer = called_with_one(node);
  if (outer == "float") return fmt::format("hn_fault_float({})", render(node.parts[1]).whole());
  if (!outer.starts_with("vec") || called_with_one(bare(node.parts[1])) != fmt::format("i{}", outer))
    return std::nullopt;
  return fmt::format("{}(u{})", outer, render(node.parts[1]).code.substr(1));
}

// The conversion of numbers to an int is one too large.
std::optional<std::string> literal_converted(const Expression& node, const Rules::Render& render, Place&) {
  if (called_with_one(node) != "int" || !is_constant(node.parts[1])) return std::nullopt;
  return fmt::format("(int({}) + 1)", render(node.parts[1]).whole());
}

// The carry of a sum, uint(low < x), is lost.
std::optional<std::string> carry_lost(const Expression& node, const Rules::Render&, Place&) {
  if (called_with_one(node) != "uint" || !bare(node.parts[1]).is(Kind::binary, "<")) return std::nullopt;
  return "0u";
}

}  // namespace

std::vector<Fault> integer_faults() {
  return {
      {.name = "modulo_sign",
       .fault = "negative `%` folded as unsigned, or differing between constant and variable",
       .reported = "gfx-rs/wgpu 9687 (NVIDIA); godot 78429; dolphin 3509",
       .injected = "`%` treats an int as a uint, and a uint as an int",
       .remark = "`%` of a negative int is undefined and only a warning; `%` of a large uint is defined",
       .shims = {{"hn_fault_modulo", {"int", "int"}, "return int(uint(a) % uint(b));"},
                 {"hn_fault_modulo", {"uint", "uint"}, "return a >= 0x80000000u ? 0u - ((0u - a) % b) : a % b;"}},
       .rules = {.operators = {{"%", "hn_fault_modulo"}}}},
      {.name = "integers_16_bits",
       .fault = "32-bit integers truncated to 16 bits",
       .reported = "hrydgard/ppsspp 11480, wgpu 5318 (Adreno); WebGL `precision-side-effects-bug`",
       .injected = "`+`, `-`, `*` of integers keep the low 16 bits",
       .shims = arithmetic("x", "(x << 16) >> 16", "x & 0xFFFFu"),
       .rules = {.operators = kArithmetic}},
      {.name = "integers_saturated",
       .fault = "32-bit integers saturated at 65536",
       .reported = "hrydgard/ppsspp 11480",
       .injected = "`+`, `-`, `*` of integers stop at 65536",
       .shims = arithmetic("x", "min(max(x, -65536), 65536)", "min(x, 65536u)"),
       .rules = {.operators = kArithmetic}},
      {.name = "uint_of_int_shift",
       .fault = "`uint(int) >> 31` wrong",
       .reported = "KhronosGroup/WebGL 2989 (Adreno 5xx, 6xx)",
       .injected = "`uint(x) >> n` shifts the sign of x in",
       .rules = {.pattern = shift_keeps_sign}},
      {.name = "uint_shifted_by_int",
       .fault = "uint shifted by an int operand",
       .reported = "ppsspp 16710",
       .injected = "a uint shifted by an int stays as it is",
       .shims = {{"hn_fault_left", {"int", "int"}, "return a << b;"},
                 {"hn_fault_left", {"int", "uint"}, "return a << b;"},
                 {"hn_fault_left", {"uint", "int"}, "return a;"},
                 {"hn_fault_left", {"uint", "uint"}, "return a << b;"},
                 {"hn_fault_right", {"int", "int"}, "return a >> b;"},
                 {"hn_fault_right", {"int", "uint"}, "return a >> b;"},
                 {"hn_fault_right", {"uint", "int"}, "return a;"},
                 {"hn_fault_right", {"uint", "uint"}, "return a >> b;"}},
       .rules = {.operators = {{"<<", "hn_fault_left"}, {">>", "hn_fault_right"}}}},
      {.name = "shifts_merged",
       .fault = "shift by 32 or more folded",
       .reported = "GraphicsFuzz `cov-fold-shift-gte32`",
       .injected = "two shifts by constants become one by their sum modulo 32",
       .remark = "a single shift by 32 is undefined: a warning",
       .rules = {.pattern = shifts_merge}},
      {.name = "abs_int",
       .fault = "abs(int) wrong",
       .reported = "ANGLE emulate_abs_int_function (crbug 642227)",
       .injected = "abs returns an int as it is",
       .shims = {{"hn_fault_abs", {"float"}, "return abs(a);"}, {"hn_fault_abs", {"int"}, "return a;"}},
       .rules = {.functions = {{"abs", "hn_fault_abs"}}}},
      {.name = "negative_lost",
       .fault = "the largest of three integers, one the negative of another",
       .reported = "NVIDIA 580 on an H100 (docs/measured/results/h100)",
       .injected = "`max(max(x, -x), y)` is max(x, y), and so is min",
       .shims = {{"hn_fault_max", {"float", "float"}, "return max(a, b);"},
                 {"hn_fault_max", {"uint", "uint"}, "return max(a, b);"},
                 {"hn_fault_max", {"int", "int"}, "return a;"},
                 {"hn_fault_min", {"float", "float"}, "return min(a, b);"},
                 {"hn_fault_min", {"uint", "uint"}, "return min(a, b);"},
                 {"hn_fault_min", {"int", "int"}, "return a;"}},
       .rules = {.pattern = negative_lost}},
      {.name = "bit_casts_flat",
       .fault = "bit-cast hash goes flat",
       .reported = "Intel UHD 620 (goban 35)",
       .injected = "floatBitsToUint loses the low 16 bits, but not where the suite itself looks at results",
       .shims = {{"hn_fault_bits", {"uint"}, "return a & 0xFFFF0000u;"}},
       .rules = {.pattern = bits_lost, .in_macros = false}},
      {.name = "vectors_anded",
       .fault = "`&` of integer vectors wrong",
       .reported = "dolphin 9636 (Mali)",
       .injected = "`&` of integer vectors returns the first one",
       .declared = by_shape("hn_fault_and", {"int", "uint"}, "return a & b;", "return a;", "return a;"),
       .rules = {.operators = {{"&", "hn_fault_and"}}}},
      {.name = "literals_multiplied",
       .fault = "a product of two literals near 2^31 wrong",
       .reported = "found here, in FXC",
       .injected = "a product of two numbers loses its highest bit",
       .shims = {{"hn_fault_product", {"float", "float"}, "return a * b;"},
                 {"hn_fault_product", {"int", "int"}, "return a * b;"},
                 {"hn_fault_product", {"uint", "uint"}, "return (a * b) & 0x7FFFFFFFu;"}},
       .rules = {.operators = {{"*", "hn_fault_product"}}, .only_constants = true}},
      {.name = "modulo_by_large",
       .fault = "`%` by a large constant folded wrong",
       .reported = "SPIRV-Tools 5499",
       .injected = "`%` by more than 10^9 is too large by the divisor",
       .shims = {{"hn_fault_modulo", {"int", "int"}, "return b > 1000000000 ? a % b + b : a % b;"},
                 {"hn_fault_modulo", {"uint", "uint"}, "return b > 1000000000u ? a % b + b : a % b;"}},
       .rules = {.operators = {{"%", "hn_fault_modulo"}}}},
      {.name = "negation_moved",
       .fault = "a negation moved across a division",
       .reported = "SPIRV-Tools 4456, 4487 and 5822; DXC 8094",
       .injected = "-(x / n) and (-x) / n are x / (-n)",
       .rules = {.pattern = negation_moved}},
      {.name = "int_as_uint",
       .fault = "an int taken for a uint in a conversion",
       .reported = "DXC 3396 and 6975; SPIRV-Tools 6377; found here, in vkd3d",
       .injected = "an int that becomes a float counts as a uint",
       .declared = "highp float hn_fault_float(highp float a) { return a; }\n"
                   "highp float hn_fault_float(highp int a) { return float(uint(a)); }\n"
                   "highp float hn_fault_float(highp uint a) { return float(a); }\n"
                   "highp float hn_fault_float(bool a) { return float(a); }\n",
       .rules = {.pattern = int_as_uint}},
      {.name = "unary_minus",
       .fault = "unary minus ignored",
       .reported = "yuzu 7629 (NVIDIA 495)",
       .injected = "-x of an int is x",
       .shims = {{"hn_fault_minus", {"float"}, "return -a;"},
                 {"hn_fault_minus", {"int"}, "return a;"},
                 {"hn_fault_minus", {"uint"}, "return 0u - a;"}},
       .rules = {.minus = "hn_fault_minus"}},
      {.name = "negative_shifted_left",
       .fault = "a negative int shifted to the left",
       .reported = "SPIRV-Cross 1947 (Metal leaves it open)",
       .injected = "a negative int shifted to the left stays as it is",
       .shims = {{"hn_fault_left", {"int", "int"}, "return a < 0 ? a : a << b;"},
                 {"hn_fault_left", {"int", "uint"}, "return a < 0 ? a : a << b;"},
                 {"hn_fault_left", {"uint", "int"}, "return a << b;"},
                 {"hn_fault_left", {"uint", "uint"}, "return a << b;"}},
       .rules = {.operators = {{"<<", "hn_fault_left"}}}},
      {.name = "overflow_ignored",
       .fault = "overflow of ints taken for impossible",
       .reported = "wgpu 6666 (Metal leaves it open)",
       .injected = "x + n > x is true",
       .rules = {.pattern = overflow_ignored}},
      {.name = "literal_converted",
       .fault = "int(1048576.0) refused",
       .reported = "wgpu 7312 (naga 22)",
       .injected = "int of a number is one too large",
       .rules = {.pattern = literal_converted}},
      {.name = "carry_lost",
       .fault = "a hash of pairs of words wrong under register pressure",
       .reported = "intel-graphics-compiler 416 (Arc B580)",
       .injected = "the carry of a sum, uint(low < x), is 0",
       .rules = {.pattern = carry_lost}},
  };
}

}  // namespace hn
