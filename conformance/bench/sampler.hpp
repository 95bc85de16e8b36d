// The values of subjects, beside what they cost.
#pragma once

#include <span>
#include <vector>

#include "bench/workbench.hpp"

namespace hn {

struct Position {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

class Sampler : public Workbench {
 public:
  Sampler(const Context& context, const SourceSet& sources);

  // The subject's values at at most 2^20 positions, as the driver computes them.
  Result<std::vector<float>> values(const Subject& subject, std::span<const Position> positions);
  // The same with a program of value_shader, for those who ask more than once.
  Result<std::vector<float>> values(const Program& program, std::span<const Position> positions);

 private:
  GridRenderer grid_;
};

}  // namespace hn
