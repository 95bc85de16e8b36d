#include "bench_cpu/subjects.hpp"

#include <fmt/format.h>

namespace hn {

std::vector<Subject> subjects() {
  struct Row {
    std::string_view noise, sum, node, fractal;
  };
  constexpr Row kRows[] = {
      {"value", "", "Value", ""},
      {"perlin", "", "Perlin", ""},
      {"simplex", "", "Simplex", ""},
      {"simplex_smooth", "", "SuperSimplex", ""},
      {"cellular", "", "CellularDistance", ""},
      {"perlin", "fbm", "Perlin", "FractalFBm"},
      {"simplex", "fbm", "Simplex", "FractalFBm"},
      {"perlin", "ridged", "Perlin", "FractalRidged"},
      {"simplex", "ridged", "Simplex", "FractalRidged"},
  };
  std::vector<Subject> all;
  for (const Row& row : kRows) {
    for (const int dimensions : {2, 3}) {
      all.push_back({fmt::format("{}{}{}{}", row.sum, row.sum.empty() ? "" : "_", row.noise, dimensions),
                     std::string(row.noise), std::string(row.sum), dimensions, std::string(row.node),
                     std::string(row.fractal)});
    }
  }
  return all;
}

hashnoise::Settings settings_of(const Subject& subject, hashnoise::Arithmetic arithmetic,
                                hashnoise::InstructionSet set) {
  hashnoise::Settings settings;
  settings.noise = subject.noise;
  settings.fractal = subject.sum;
  settings.arithmetic = arithmetic;
  settings.seed = 7;
  if (!subject.sum.empty()) settings.octaves = kOctaves;
  settings.instruction_set = set;
  return settings;
}

}  // namespace hn
