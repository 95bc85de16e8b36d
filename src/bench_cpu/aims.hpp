// Aims are what this library is to reach. A page states each beside the number, met or missed.
#pragma once

#include <optional>
#include <string_view>

#include "bench_cpu/subjects.hpp"

namespace hn {

// What is compared. Every number is a quotient of speeds: how many times as fast the first is as the second.
enum class Comparison {
  grids,    // ours over FastNoise2's
  points,   // the same at a list of points
  octaves,  // ours over FastNoise2's, where the octaves of ours are grids that are not turned
  fixed,    // HN_FIXED over HN_FAST
  precise,  // HN_PRECISE over HN_FAST
  tiles,    // with a period over without
  lists,    // at points over on a grid
  threads,  // by two threads over by one
};
inline constexpr std::size_t kComparisons = 8;
std::string_view name_of(Comparison comparison);

// How large it is to be, or nothing if nobody has said.
std::optional<double> aim_of(Comparison comparison, const Subject& subject);
inline constexpr double kPythonAim = 0.9;  // over C++ at as many points

}  // namespace hn
