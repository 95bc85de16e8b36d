// Fills that are measured: of a grid or of a list of points, by hashnoise::grid and by FastNoise2.
#pragma once

#include <functional>
#include <hashnoise/field.hpp>
#include <span>
#include <string>
#include <vector>

namespace hn {

inline constexpr float kStep = 0.0371f;  // cells from point to point; no multiple of it is a lattice point for long
inline constexpr int kPoints = 1 << 20;  // of a grid, and of a list
inline constexpr int kOctaves = 6;       // of a sum
inline constexpr int kSeed = 7;

struct Subject {
  std::string id;  // "fbm_simplex3": the sum, the noise, and how many dimensions
  std::string noise;
  std::string sum;  // empty for the noise alone
  int dimensions;
  std::string node;     // FastNoise2's name of the noise
  std::string fractal;  // and of the sum
};

std::vector<Subject> subjects();

// A grid of kPoints points.
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

struct Fill {
  std::string name;  // "avx2/fast"
  std::function<void()> run;
};

// The fills of a subject, by each set of instructions: "fast", "fixed" and "precise" by arithmetic; with HN_FAST
// "points" of a list, "tiles" with a period, "octaves" that are not turned, and by "two threads"; and "FastNoise2",
// "FastNoise2 points" and "FastNoise2 strict" where the words name its libraries. The words are SUBJECT
// [fastnoise2=FILE] [strict=FILE]. Throws std::invalid_argument for other words, and what FastNoise throws.
std::vector<Fill> fills(std::span<const char* const> words);

}  // namespace hn
