// Which instructions the processor has, and the kernels for them.
#pragma once

#include <hashnoise/field.hpp>

#include "kernel.hpp"

namespace hashnoise::grid {

// The kernels for instructions and an arithmetic that instruction_sets() lists.
const Kernels& kernels_for(InstructionSet set, Arithmetic arithmetic);

}  // namespace hashnoise::grid
