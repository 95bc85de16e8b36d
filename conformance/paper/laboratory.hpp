// Here is what the sections measure with, and what they hand over.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "bench/workbench.hpp"
#include "paper/algorithm.hpp"

namespace hn {

class Laboratory : public Sampler {
 public:
  Laboratory(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference,
             std::filesystem::path out, int rounds, bool dump);

  const ReferenceCompiler& reference;
  const std::filesystem::path out;
  const int rounds;
  const bool dump;
  Stopwatch stopwatch;
};

// The result for a part of the paper: a record, NAME.csv.
struct Section {
  std::string name;
  Facts facts;  // beside those of the run
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows = {};
  bool complete = true;  // else something that was to be measured could not be; its row has the problem
};

Result<Section> measure_table(Laboratory& laboratory);
// It also writes files of floats, which the rows name.
Result<Section> write_values(Laboratory& laboratory);
Result<Section> measure_periods(Laboratory& laboratory);
Result<Section> measure_bandwidth(Laboratory& laboratory);

}  // namespace hn
