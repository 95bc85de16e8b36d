// Here is what the sections of the report measure with, and what they hand over.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "bench/sampler.hpp"
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

// A section of the report: its numbers for paper.json, the same as text for the page, and as CSV files.
struct Section {
  struct Csv {
    std::string name;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
  };
  nlohmann::json data;
  nlohmann::json page;
  std::vector<Csv> csv;
  bool complete = true;  // else something that was to be measured could not be; the page says what
};

Result<Section> measure_table(Laboratory& laboratory);
Result<Section> draw_figures(Laboratory& laboratory);
Result<Section> measure_statistics(Laboratory& laboratory);
Result<Section> measure_periods(Laboratory& laboratory);
Result<Section> measure_bandwidth(Laboratory& laboratory);

}  // namespace hn
