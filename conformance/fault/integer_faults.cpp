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
  };
}

}  // namespace hn
