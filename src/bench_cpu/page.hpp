// A run leaves this behind: a page for people, and the same as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench_cpu/measure.hpp"
#include "bench_cpu/python.hpp"

namespace hn {

struct CpuRun {
  std::string date;      // UTC, ISO 8601
  std::string command;   // without the folders of this machine
  std::string compiler;  // "g++ 12.2.0"
  std::string processor;
  int rounds = 0;
  std::string note;
  std::vector<Measurement> measurements;
  std::optional<PythonMeasurement> python;
};

std::string compiler_name();  // of this program: "gcc" or "clang"
std::string compiler_version();
std::string processor_name();

nlohmann::ordered_json to_json(const CpuRun& run);
std::string page_of(const CpuRun& run);

// The aims that are missed, one a line: "perlin2, avx2: grids 0.93 ± 0.02, which is to be 1".
std::vector<std::string> missed_aims(const CpuRun& run);

}  // namespace hn
