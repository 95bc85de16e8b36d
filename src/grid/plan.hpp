// A plan is a checked field: its settings, and the kernels for them.
#pragma once

#include <hashnoise/field.hpp>
#include <stdexcept>

#include "functions.hpp"
#include "kernel.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

struct Plan {
  int dimensions;
  Shape shape;
  int components;
  InstructionSet set;
  bool may_fuse;  // products with sums: kernels of one function may then differ in their last bits
  Options options;
  bool takes_positions;  // a sum at positions; a noise takes cells always
  Loops at;              // at positions; null for a noise
  Loops in;              // in cells; null for a sum that has no such form
  Octave octave;
  const Kernels* kernels;
};

// Throws std::invalid_argument.
Plan plan_of(int dimensions, const Settings& settings);

inline int components_of(Shape shape, int dimensions) {
  switch (shape) {
    case Shape::kValue:
      return 1;
    case Shape::kTwoDistances:
    case Shape::kValueAndQuadrature:
      return 2;
    case Shape::kThreeDistances:
      return 3;
    case Shape::kVector:
      return dimensions;
    case Shape::kWithSlopes:
    case Shape::kDistanceWithSlopes:
      return dimensions + 1;
  }
  throw std::logic_error("a shape that there is not");
}

}  // namespace hashnoise::grid
