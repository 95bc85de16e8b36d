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

const Rules::Names kArithmetic = {{"+", "hn_fault_add"}, {"-", "hn_fault_subtract"}, {"*", "hn_fault_multiply"}};

// + - and * of every type, where int and uint results go through these functions of x.
std::string arithmetic(const ShimLanguage& language, std::string_view ints, std::string_view uints) {
  std::string text;
  for (const auto& [symbol, name] : kArithmetic) {
    text += binary_shim(language, name, "float", fmt::format("return a {} b;", symbol));
    text +=
        binary_shim(language, name, "int", fmt::format("{}int x = a {} b; return {};", language.highp(), symbol, ints));
    text += binary_shim(language, name, "uint",
                        fmt::format("{}uint x = a {} b; return {};", language.highp(), symbol, uints));
  }
  return text;
}

void add_arithmetic(std::vector<Fault>& faults) {
  faults.push_back({.name = "modulo_sign",
                    .fault = "negative `%` folded as unsigned, or differing between constant and variable",
                    .reported = "gfx-rs/wgpu 9687 (NVIDIA); godot 78429; dolphin 3509",
                    .injected = "`%` treats an int as a uint, and a uint as an int",
                    .remark = "`%` of a negative int is undefined and only a warning; `%` of a large uint is defined",
                    .shim =
                        [](const ShimLanguage& language) {
                          return binary_shim(language, "hn_fault_modulo", "int", "return int(uint(a) % uint(b));") +
                                 binary_shim(language, "hn_fault_modulo", "uint",
                                             "return a >= 0x80000000u ? 0u - ((0u - a) % b) : a % b;");
                        },
                    .rules = {.operators = {{"%", "hn_fault_modulo"}}}});
  faults.push_back(
      {.name = "integers_16_bits",
       .fault = "32-bit integers truncated to 16 bits",
       .reported = "hrydgard/ppsspp 11480, wgpu 5318 (Adreno); WebGL `precision-side-effects-bug`",
       .injected = "`+`, `-`, `*` of integers keep the low 16 bits",
       .remark = "",
       .shim = [](const ShimLanguage& language) { return arithmetic(language, "(x << 16) >> 16", "x & 0xFFFFu"); },
       .rules = {.operators = kArithmetic}});
  faults.push_back({.name = "integers_saturated",
                    .fault = "32-bit integers saturated at 65536",
                    .reported = "hrydgard/ppsspp 11480",
                    .injected = "`+`, `-`, `*` of integers stop at 65536",
                    .remark = "",
                    .shim =
                        [](const ShimLanguage& language) {
                          return arithmetic(language, "min(max(x, -65536), 65536)", "min(x, 65536u)");
                        },
                    .rules = {.operators = kArithmetic}});
}

void add_shifts(std::vector<Fault>& faults) {
  faults.push_back({.name = "uint_of_int_shift",
                    .fault = "`uint(int) >> 31` wrong",
                    .reported = "KhronosGroup/WebGL 2989 (Adreno 5xx, 6xx)",
                    .injected = "`uint(x) >> n` shifts the sign of x in",
                    .remark = "",
                    .shim = [](const ShimLanguage&) { return std::string(); },
                    .rules = {.pattern = shift_keeps_sign}});
  faults.push_back({.name = "uint_shifted_by_int",
                    .fault = "uint shifted by an int operand",
                    .reported = "ppsspp 16710",
                    .injected = "a uint shifted by an int stays as it is",
                    .remark = "",
                    .shim =
                        [](const ShimLanguage& language) {
                          return shift_shim(language, "hn_fault_left", "<<", "return a;") +
                                 shift_shim(language, "hn_fault_right", ">>", "return a;");
                        },
                    .rules = {.operators = {{"<<", "hn_fault_left"}, {">>", "hn_fault_right"}}}});
  faults.push_back({.name = "shifts_merged",
                    .fault = "shift by 32 or more folded",
                    .reported = "GraphicsFuzz `cov-fold-shift-gte32`",
                    .injected = "two shifts by constants become one by their sum modulo 32",
                    .remark = "a single shift by 32 is undefined: a warning",
                    .shim = [](const ShimLanguage&) { return std::string(); },
                    .rules = {.pattern = shifts_merge}});
}

void add_functions(std::vector<Fault>& faults) {
  faults.push_back({.name = "abs_int",
                    .fault = "abs(int) wrong",
                    .reported = "ANGLE emulate_abs_int_function (crbug 642227)",
                    .injected = "abs returns an int as it is",
                    .remark = "",
                    .shim =
                        [](const ShimLanguage& language) {
                          return unary_shim(language, "hn_fault_abs", "float", "return abs(a);") +
                                 unary_shim(language, "hn_fault_abs", "int", "return a;");
                        },
                    .rules = {.functions = {{"abs", "hn_fault_abs"}}}});
  faults.push_back({.name = "negative_lost",
                    .fault = "the largest of three integers, one the negative of another",
                    .reported = "NVIDIA 580 on an H100 (docs/measured/results/h100)",
                    .injected = "`max(max(x, -x), y)` is max(x, y), and so is min",
                    .remark = "",
                    .shim =
                        [](const ShimLanguage& language) {
                          std::string text;
                          for (const std::string_view function : {"max", "min"}) {
                            const std::string name = fmt::format("hn_fault_{}", function);
                            const std::string right = fmt::format("return {}(a, b);", function);
                            text += binary_shim(language, name, "float", right) +
                                    binary_shim(language, name, "uint", right) +
                                    binary_shim(language, name, "int", "return a;");
                          }
                          return text;
                        },
                    .rules = {.pattern = negative_lost}});
  faults.push_back(
      {.name = "bit_casts_flat",
       .fault = "bit-cast hash goes flat",
       .reported = "Intel UHD 620 (goban 35)",
       .injected = "floatBitsToUint loses the low 16 bits, but not where the suite itself looks at results",
       .remark = "",
       .shim =
           [](const ShimLanguage& language) {
             return unary_shim(language, "hn_fault_bits", "uint", "return a & 0xFFFF0000u;");
           },
       .rules = {
           .pattern = [](const Expression& node, const Rules::Render& render, Place&) -> std::optional<std::string> {
             if (called_with_one(node) != "floatBitsToUint") return std::nullopt;
             return fmt::format("hn_fault_bits(floatBitsToUint({}))", render(node.parts[1]).whole());
           },
           .in_macros = false}});
}

}  // namespace

void add_integer_faults(std::vector<Fault>& faults) {
  add_arithmetic(faults);
  add_shifts(faults);
  add_functions(faults);
}

}  // namespace hn
