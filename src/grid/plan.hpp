// A plan is a checked field: its settings, and the kernels for them.
#pragma once

#include <hashnoise/field.hpp>
#include <string>
#include <vector>

#include "functions.hpp"
#include "kernel.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

// The sets that this library was compiled for, the widest first, whether the processor has them or not.
std::vector<InstructionSet> compiled_instruction_sets();

// The kernels for instructions and an arithmetic that instruction_sets() lists.
const Kernels& kernels_for(InstructionSet set, Arithmetic arithmetic);

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
Plan plan_of(int dimensions, const Settings& settings, const MoreSettings& more);

// The names of the numbers at a point.
std::vector<std::string> components_of(Shape shape, int dimensions);

}  // namespace hashnoise::grid
