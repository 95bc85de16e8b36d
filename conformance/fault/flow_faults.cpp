// Faults of loops, and of assignments to parts of vectors and arrays; and the table of all faults.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "fault/faults.hpp"

namespace hn {
namespace {

using Kind = Expression::Kind;

// In a loop, v += s goes through a function.
std::optional<std::string> add_in_loop(const Expression& node, const Rules::Render& render, Place& place) {
  if (!place.in_loop || !node.is(Kind::assign, "+=")) return std::nullopt;
  const Rewriting target = render(node.parts[0]);
  return fmt::format("{0} = hn_fault_added({0},{1}{2})", target.code, node.token.space, render(node.parts[1]).whole());
}

// Whether a member has the letters of components, and is not one of a structure, as `part` is.
bool is_swizzle(std::string_view member) {
  return std::ranges::any_of(std::array<std::string_view, 3>{"xyzw", "rgba", "stpq"}, [&](std::string_view letters) {
    return member.find_first_not_of(letters) == std::string_view::npos;
  });
}

// Only the first of a function's assignments to swizzles of a variable stores.
std::optional<std::string> swizzle_once(const Expression& node, const Rules::Render& render, Place& place) {
  if (!node.is(Kind::assign, "=") || node.parts[0].kind != Kind::member) return std::nullopt;
  const Expression& target = node.parts[0];
  const bool swizzle =
      is_swizzle(target.close.text) && target.close.text.size() > 1 && target.parts[0].kind == Kind::leaf;
  if (!swizzle || place.swizzled.insert(target.parts[0].token.text).second) return std::nullopt;
  return fmt::format("({}{},{})", render(target).code, node.token.space, render(node.parts[1]).whole());
}

// In a loop, an element of an array gets 0.
std::optional<std::string> array_in_loop(const Expression& node, const Rules::Render& render, Place& place) {
  if (!place.in_loop || !node.is(Kind::assign, "=") || node.parts[0].kind != Kind::index) return std::nullopt;
  return fmt::format("{}{}= hn_fault_nothing({})", render(node.parts[0]).code, node.token.space,
                     render(node.parts[1]).whole());
}

// The inner one of two nested ?: gives its first expression.
std::optional<std::string> selection_nested(const Expression& node, const Rules::Render& render, Place&) {
  if (node.kind != Kind::ternary || bare(node.parts[2]).kind != Kind::ternary) return std::nullopt;
  return fmt::format("{} ?{} :{}", render(node.parts[0]).code, render(node.parts[1]).whole(),
                     render(bare(node.parts[2]).parts[1]).whole());
}

}  // namespace

std::string by_shape(std::string_view name, std::initializer_list<std::string_view> types, std::string_view scalars,
                     std::string_view vectors, std::string_view mixed) {
  std::string text;
  for (const std::string_view type : types) {
    const std::string_view prefix = type == "float" ? "" : type.substr(0, 1);
    text += fmt::format("highp {0} {1}(highp {0} a, highp {0} b) {{ {2} }}\n", type, name, scalars);
    for (int size = 2; size <= 4; ++size) {
      const std::string vector = fmt::format("{}vec{}", prefix, size);
      text += fmt::format("highp {0} {1}(highp {0} a, highp {0} b) {{ {2} }}\n", vector, name, vectors);
      text += fmt::format("highp {0} {1}(highp {0} a, highp {2} b) {{ {3} }}\n", vector, name, type, mixed);
    }
  }
  return text;
}

std::vector<Fault> flow_faults() {
  return {
      {.name = "unary_minus_in_loop",
       .fault = "unary minus dropped in a dynamic loop",
       .reported = "WebGL `unary-minus-operator-in-dynamic-loop`; ANGLE rewriteUnaryMinusOperator",
       .injected = "in a loop, and in what it calls, -x is x",
       .declared = "bool hn_fault_in_loop = false;\n",
       .shims = {{"hn_fault_minus", {"float"}, "return hn_fault_in_loop ? a : -a;"},
                 {"hn_fault_minus", {"int"}, "return hn_fault_in_loop ? a : -a;"},
                 {"hn_fault_minus", {"uint"}, "return hn_fault_in_loop ? a : 0u - a;"}},
       .rules = {.minus = "hn_fault_minus",
                 .in_loop = "hn_fault_in_loop = true;",
                 .after_loop = "hn_fault_in_loop = false;"}},
      {.name = "loop_condition",
       .fault = "loop condition miscompiled",
       .reported = "ANGLE add_and_true_to_loop_condition",
       .injected = "a loop ends after three turns",
       .declared = "highp int hn_fault_turns = 0;\n",
       .rules = {.before_loop = "hn_fault_turns = 0;", .condition = "&& hn_fault_turns++ < 3"}},
      {.name = "loop_initializer",
       .fault = "loop initialiser miscompiled",
       .reported = "ANGLE dont_use_loops_to_initialize_variables",
       .injected = "a for loop starts one late",
       .rules = {.initializer = " + 1"}},
      {.name = "array_in_loop",
       .fault = "loop initialiser miscompiled: variables that a loop initialises",
       .reported = "ANGLE dont_use_loops_to_initialize_variables",
       .injected = "elements of an array that a loop assigns are 0",
       .shims = {{"hn_fault_nothing", {"float"}, "return 0.0;"},
                 {"hn_fault_nothing", {"int"}, "return 0;"},
                 {"hn_fault_nothing", {"uint"}, "return 0u;"}},
       .rules = {.pattern = array_in_loop}},
      {.name = "vector_plus_scalar_in_loop",
       .fault = "vector += scalar in a loop",
       .reported = "crbug 772651",
       .injected = "in a loop, a scalar is added to the first component alone",
       .declared = by_shape("hn_fault_added", {"float", "int", "uint"}, "return a + b;", "return a + b;",
                            "a.x += b; return a;"),
       .rules = {.pattern = add_in_loop}},
      {.name = "swizzle_written_twice",
       .fault = "swizzle written twice in a function",
       .reported = "crbug 798117",
       .injected = "of the assignments to swizzles of a variable in a function, only the first stores",
       .rules = {.pattern = swizzle_once}},
      {.name = "third_nested_loop",
       .fault = "three nested loops give 4 of 8 steps",
       .reported = "wgpu 5067 (Metal on AMD); gpuweb/cts 3063 (Intel, DXC)",
       .injected = "a loop within two others ends after a turn",
       .declared = "highp int hn_fault_depth = 0;\nhighp int hn_fault_inner_turns = 0;\n",
       .rules = {.before_loop = "++hn_fault_depth; hn_fault_inner_turns = 0;",
                 .after_loop = "--hn_fault_depth;",
                 .condition = "&& (hn_fault_depth < 3 || hn_fault_inner_turns++ < 1)"}},
      {.name = "selection_nested",
       .fault = "nested selections wrong",
       .reported = "Halide 7072 (FXC)",
       .injected = "`a ? b : (c ? d : e)` is `a ? b : d`",
       .rules = {.pattern = selection_nested}},
      {.name = "switch_default",
       .fault = "the default of a switch skipped, or taken where a later case has the value",
       .reported = "SPIRV-Cross 1402, SPIRV-Tools 3445 and wgpu 5656 (FXC); naga 2181",
       .injected = "the default of a switch does nothing",
       .rules = {.behind_default = " break;"}},
  };
}

std::span<const Fault> all_faults() {
  static const std::vector<Fault> kFaults = [] {
    std::vector<Fault> all;
    for (const auto& part : {integer_faults(), float_faults(), flow_faults()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return kFaults;
}

}  // namespace hn
