#include "bench_cpu/subjects.hpp"

#include <fmt/format.h>

namespace hn {

std::vector<Subject> subjects() {
  struct Row {
    std::string_view noise, sum, node, fractal;
    double aims[2];  // on the plane and in space
  };
  constexpr Row kRows[] = {
      {"value", "", "Value", "", {1.0, 1.0}},
      {"perlin", "", "Perlin", "", {1.2, 1.1}},
      {"simplex", "", "Simplex", "", {1.1, 1.1}},
      {"simplex_smooth", "", "SuperSimplex", "", {1.0, 1.0}},
      {"cellular", "", "CellularDistance", "", {2.0, 2.0}},
      {"perlin", "fbm", "Perlin", "FractalFBm", {1.0, 1.0}},
      {"simplex", "fbm", "Simplex", "FractalFBm", {1.0, 1.0}},
      {"perlin", "ridged", "Perlin", "FractalRidged", {1.0, 1.0}},
      {"simplex", "ridged", "Simplex", "FractalRidged", {1.0, 1.0}},
  };
  std::vector<Subject> all;
  for (const Row& row : kRows) {
    for (const int dimensions : {2, 3}) {
      all.push_back({fmt::format("{}{}{}{}", row.sum, row.sum.empty() ? "" : "_", row.noise, dimensions),
                     std::string(row.noise), std::string(row.sum), dimensions, std::string(row.node),
                     std::string(row.fractal), row.aims[dimensions - 2]});
    }
  }
  return all;
}

hashnoise::Settings settings_of(const Subject& subject, hashnoise::Arithmetic arithmetic,
                                hashnoise::InstructionSet set) {
  hashnoise::Settings settings;
  settings.noise = subject.noise;
  settings.sum = subject.sum;
  settings.arithmetic = arithmetic;
  settings.seed = 7;
  if (!subject.sum.empty()) settings.octaves = kOctaves;
  settings.instruction_set = set;
  return settings;
}

}  // namespace hn
