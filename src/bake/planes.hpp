// The values of a field at the points of a picture or a volume.
#pragma once

#include <array>
#include <functional>
#include <hashnoise/field.hpp>
#include <span>
#include <string>
#include <vector>

#include "bake/options.hpp"

namespace hn {

struct Plane {
  std::string component;
  std::vector<float> values;  // x fastest, then y, z and w
  hashnoise::Range range;
};

struct Planes {
  std::vector<Plane> planes;                    // those of the options, in the order of the field
  hashnoise::InstructionSet instruction_set{};  // by which they were computed
};

// Called from several threads while the work goes on, with the number of rows that are done.
using RowsDone = std::function<void(std::size_t rows)>;

// Which of these the options choose, by their numbers. Throws std::invalid_argument for a name that is not there.
std::vector<std::size_t> chosen_components(const std::vector<std::string>& names, const BakeOptions& options);

// The least and the greatest; what is no number does not count.
hashnoise::Range range_of(std::span<const float> values);

// Of a function of the library. Throws std::invalid_argument for settings that no field has, and for a component that
// this one has not.
std::vector<std::string> component_names(const BakeOptions& options);

// Throws std::bad_alloc if so many values do not fit.
Planes compute(const BakeOptions& options, const RowsDone& rows_done);

}  // namespace hn
