// The subjects are fields of this library, and what does the same in FastNoise2.
#pragma once

#include <hashnoise/field.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hn {

inline constexpr float kStep = 0.0371f;  // cells from point to point; no multiple of it is a lattice point for long
inline constexpr int kPoints = 1 << 20;  // of a grid, and of a list

struct Subject {
  std::string id;  // "fbm_simplex3": the sum, the noise, and how many dimensions
  std::string noise;
  std::string sum;  // of six octaves; empty for the noise alone
  int dimensions;
  std::string node;     // FastNoise2's name of the noise
  std::string fractal;  // and of the sum
};

std::vector<Subject> subjects();
inline constexpr int kOctaves = 6;

hashnoise::Settings settings_of(const Subject& subject, hashnoise::Arithmetic arithmetic,
                                hashnoise::InstructionSet set);

// The grid of a fill: kPoints points, kStep apart.
template <int D>
hashnoise::Grid<D> grid() {
  hashnoise::Grid<D> all;
  all.step.fill(kStep);
  if constexpr (D == 2) {
    all.size = {1024, 1024};
  } else {
    all.size = {128, 128, 64};
  }
  return all;
}

}  // namespace hn
