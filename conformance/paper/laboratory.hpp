// What the sections of the report measure with, and what they hand over.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "bench/workbench.hpp"
#include "paper/algorithm.hpp"

namespace hn {

struct Position {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

class Laboratory : public Workbench {
 public:
  Laboratory(const Context& context, const SourceSet& sources, const ReferenceCompiler& reference,
             std::filesystem::path out, int rounds, bool dump);

  // The subject's values at at most 2^20 positions, as the driver computes them.
  Result<std::vector<float>> values(const Subject& subject, std::span<const Position> positions);
  // The same with a program of value_shader, for those who ask more than once.
  Result<std::vector<float>> values(const Program& program, std::span<const Position> positions);

  const ReferenceCompiler& reference;
  const std::filesystem::path out;
  const int rounds;
  const bool dump;
  Stopwatch stopwatch;

 private:
  GridRenderer grid_;
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
