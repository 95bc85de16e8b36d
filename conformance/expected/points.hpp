// Points at which the cases evaluate functions, reproducible from a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "expected/cellular.hpp"
#include "library/functions.hpp"

namespace hn {

// SplitMix64 (Steele, Lea, Flood 2014): enough for test points, and the same on every machine.
class Random {
 public:
  // Streams of different names are independent.
  Random(std::uint64_t seed, std::string_view name);
  std::uint64_t next();
  std::uint32_t word() { return static_cast<std::uint32_t>(next() >> 32); }
  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>((std::uint64_t{word()} * bound) >> 32); }
  float uniform(float low, float high);  // [low, high)
  template <typename T, std::size_t count>
  T one_of(const T (&some)[count]) {
    return some[below(count)];
  }

 private:
  std::uint64_t state_;
};

// The points besides those at which every arithmetic must be near a defined value.
enum class Extremes {
  none,
  // Coordinates that are subnormal, tiny, -0 or huge, or where HN_PRECISE begins to see them. For octave sums they are
  // below 2^96, so that no float overflows, and some of the tiny ones come with a huge lacunarity. For Perlin noise in
  // four dimensions the first points have results where HN_PRECISE begins to see those.
  floats,
  integers,  // also places beyond a cell, and settings of octave sums that are cut off: only integers have values there
};
// The special points at which the bits of a configuration's results are defined.
Extremes defined_extremes(const Configuration& configuration);

// count points for a function, kInputWords words each. Words: edge values and random ones. Cells: near, negative, far
// and anywhere. Positions: near, negative, at 2^20 cells and more, on lattice lines and next to them. For octave sums
// also small whole numbers of octaves, lacunarities with and without rounding of the positions, details that are whole
// or nearly so, footprints from none to more than a cell, and strengths, amplitudes and depths in their range, at its
// ends and beyond. Slopes: flat, of hills, at an end and beyond. Phases: none, quarters, tiny, negative, large and any.
// Periods: none, small, large and odd ones, and then half of the cells and positions lie beside a multiple of theirs.
// Coordinates of cellular noise are also in the middle of a cell, and beside it. Jitters: 0, 1, between, and rarely
// beyond; metrics: the first so many, and rarely none. Numbers of items: none, few, powers of two and those beside
// them, and any up to 2^31; half of the items are among them.
std::vector<std::uint32_t> random_points(const Function& function, std::size_t count, Random random,
                                         Extremes extremes = Extremes::none, std::uint32_t metrics = kMetrics);

}  // namespace hn
