// Fills fields for the tests.
// SPDX-License-Identifier: MIT

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

#include "compare.hpp"
#include "hashnoise/field.hpp"
#include "places.hpp"
#include "twin.hpp"

namespace hashnoise::twin {

// Calls `each` with the dimensions, as a type.
template <typename Each>
void in_dimensions(int dimensions, const Each& each) {
  switch (dimensions) {
    case 1:
      return each(std::integral_constant<int, 1>{});
    case 2:
      return each(std::integral_constant<int, 2>{});
    case 3:
      return each(std::integral_constant<int, 3>{});
    default:
      return each(std::integral_constant<int, 4>{});
  }
}

struct FieldValues {
  std::vector<float> values;
  Range range;
};

// Numbers in front of the values and behind them must stay. In front there is an odd number, so that the values begin
// where no vector does.
template <typename AnyField, typename Places>
FieldValues fill(const AnyField& field, const Places& places, std::size_t points, const Executor& executor = {}) {
  constexpr std::size_t kBefore = 37;
  constexpr std::size_t kBehind = 64;
  constexpr float kUntouched = -12345.0f;
  const std::size_t numbers = points * static_cast<std::size_t>(field.component_count());
  std::vector<float> memory(kBefore + numbers + kBehind, kUntouched);
  const std::span<float> values = std::span(memory).subspan(kBefore, numbers);
  FieldValues filled;
  filled.range = field.fill(places, values, executor);
  filled.values.assign(values.begin(), values.end());
  const auto is_untouched = [](float number) { return number == kUntouched; };
  EXPECT_TRUE(std::all_of(memory.begin(), memory.begin() + kBefore, is_untouched)) << "written in front of the values";
  EXPECT_TRUE(std::all_of(memory.end() - kBehind, memory.end(), is_untouched)) << "written behind the values";
  return filled;
}

struct AnyProcessor {};

// A field has the bits of the twin, with every instruction set. While it is filled there is a Processor.
template <int D, typename Processor = AnyProcessor, typename Places>
void expect_bits(Settings settings, const Places& where) {
  const auto places = places_of(where);
  const Function<D> twin = function<D>(settings);
  const std::vector<float> expected = planes_of(twin, places);
  const Range range = range_of(expected, places.size());
  for (const InstructionSet set : instruction_sets()) {
    settings.instruction_set = set;
    const Field<D> field(settings);
    ASSERT_EQ(field.component_count(), twin.components) << settings;
    const FieldValues filled = [&] {
      [[maybe_unused]] const Processor processor;
      return fill(field, where, places.size());
    }();
    EXPECT_TRUE(same_bits(filled.values, expected, places.size())) << settings;
    EXPECT_EQ(filled.range, range) << settings;
  }
}

}  // namespace hashnoise::twin
