// A run leaves this behind.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/csv.hpp"
#include "bench_cpu/measure.hpp"
#include "bench_cpu/python.hpp"

namespace hn {

std::string compiler_name();  // of this program: "gcc" or "clang"
std::string compiler_version();
std::string processor_name();

// A row for each subject and instruction set, with the speeds and the quotients of kFills and kComparisons.
std::string record_of(Facts facts, const std::vector<Measurement>& measurements,
                      const std::optional<PythonMeasurement>& python);

}  // namespace hn
