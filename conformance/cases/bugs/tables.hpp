// The parts of the table of bugs, and helpers to write them.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "cases/bugs/bugs.hpp"

namespace hn {

void add_integer_bugs(std::vector<Bug>& bugs);
void add_float_bugs(std::vector<Bug>& bugs);
void add_flow_bugs(std::vector<Bug>& bugs);
void add_position_bugs(std::vector<Bug>& bugs);

inline float as_float(std::uint32_t value) { return std::bit_cast<float>(value); }

// The function of a bug. It needs only the library's names of types.
using enum WordType;
inline Function bug_function(std::string_view id, std::vector<Column> inputs, std::vector<Column> outputs,
                             std::string_view body) {
  return {.id = id,
          .file = "config.glsl",
          .call = {},
          .body = body,
          .inputs = std::move(inputs),
          .outputs = std::move(outputs),
          .plain = {}};
}

constexpr std::uint32_t word(std::uint32_t value) { return value; }
constexpr std::uint32_t word(std::int32_t value) { return static_cast<std::uint32_t>(value); }
constexpr std::uint32_t word(float value) { return std::bit_cast<std::uint32_t>(value); }

// A point for each of the inputs, with what expected makes of its words.
template <typename Expected>
std::vector<BugPoint> points(std::initializer_list<std::vector<std::uint32_t>> inputs, Expected expected) {
  std::vector<BugPoint> all;
  for (const auto& words : inputs) all.push_back({words, expected(words)});
  return all;
}

// For a single float input or a single integer, which are written as such.
template <typename Value, typename Expected>
std::vector<BugPoint> points_of(std::initializer_list<Value> inputs, Expected expected) {
  std::vector<BugPoint> all;
  for (const Value value : inputs) all.push_back({{word(value)}, expected(value)});
  return all;
}

}  // namespace hn
