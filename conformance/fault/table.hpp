// The parts of the table of faults.
#pragma once

#include <vector>

#include "fault/faults.hpp"

namespace hn {

void add_integer_faults(std::vector<Fault>& faults);
void add_float_faults(std::vector<Fault>& faults);
void add_flow_faults(std::vector<Fault>& faults);

}  // namespace hn
