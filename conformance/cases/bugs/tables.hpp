// The parts of the table of bugs, and helpers to write them.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "cases/bugs/bugs.hpp"

namespace hn {

// The parts of all_bugs().
std::vector<Bug> integer_bugs();
std::vector<Bug> float_bugs();
std::vector<Bug> flow_bugs();
std::vector<Bug> language_bugs();

constexpr Rule defined(std::string_view text, double allowed = 0.0) { return {text, true, allowed}; }
constexpr Rule left_open(std::string_view text, double allowed = 0.0) { return {text, false, allowed}; }

using enum WordType;
using Points = std::vector<BugPoint>;
// OpenGL, and all other languages; and those in which a name or a statement of GLSL alone has its meaning.
constexpr std::string_view kEverywhere = "gl330 es300 vulkan hlsl60 hlsl50 msl wgsl";
constexpr std::string_view kInGlsl = "gl330 es300 vulkan";
constexpr std::string_view kWithoutMetal = "gl330 es300 vulkan hlsl60 hlsl50 wgsl";
constexpr std::string_view kHlsl = "hlsl60 hlsl50";

// A bug, whose function needs only the library's names of types.
inline Bug bug(std::string_view id, std::vector<Column> inputs, std::vector<Column> outputs, std::string_view body,
               std::string_view reference, const Rule& rule, Points points, std::string_view profiles = kEverywhere,
               std::string_view declarations = "") {
  return {.function = {.id = id,
                       .file = "config.glsl",
                       .call = {},
                       .body = body,
                       .inputs = std::move(inputs),
                       .outputs = std::move(outputs),
                       .plain = {}},
          .reference = reference,
          .rule = rule,
          .profiles = profiles,
          .declarations = declarations,
          .points = std::move(points)};
}

// The bug with another rule in these profiles.
inline Bug but_in(std::string_view profiles, const Rule& rule, Bug bug) {
  bug.exceptions = profiles;
  bug.exception = rule;
  return bug;
}

// The bug with a text of its own in WGSL.
inline Bug in_wgsl(std::string_view body, Bug bug, std::string_view declarations = "") {
  bug.wgsl = body;
  bug.wgsl_declarations = declarations;
  return bug;
}

constexpr std::uint32_t word(std::uint32_t value) { return value; }
constexpr std::uint32_t word(std::int32_t value) { return static_cast<std::uint32_t>(value); }
constexpr std::uint32_t word(float value) { return std::bit_cast<std::uint32_t>(value); }

// The words of values of several types.
template <typename... Values>
std::vector<std::uint32_t> words(Values... values) {
  return {word(values)...};
}

// A point for each of the inputs, which have these types, with what expected makes of them.
template <typename... Inputs, typename Expected>
Points points(std::type_identity_t<std::initializer_list<std::tuple<Inputs...>>> inputs, Expected expected) {
  Points all;
  for (const auto& values : inputs) all.push_back({std::apply(words<Inputs...>, values), std::apply(expected, values)});
  return all;
}

}  // namespace hn
