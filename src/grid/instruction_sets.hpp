// Which instructions the processor has, and the kernels for them.
#pragma once

#include <hashnoise/field.hpp>

#include "kernel.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

// The sets that this library was compiled for, the widest first, whether the processor has them or not.
std::vector<InstructionSet> compiled_instruction_sets();

// The kernels for instructions and an arithmetic that instruction_sets() lists.
const Kernels& kernels_for(InstructionSet set, Arithmetic arithmetic);

}  // namespace hashnoise::grid
