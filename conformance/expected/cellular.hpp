// Cellular noise by a search of all cells around a place: in doubles, and in integers for fixed arithmetic. It follows
// docs/reference/contract.md, section 16, and has no code and no order of cells from the library.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "library/functions.hpp"

namespace hn {

// The metrics of the catalog, and how many they are. Any other number counts as Euclidean.
enum class Metric {
#define METRIC(name, number) name = number,
#include "library/metrics.inc"
};
inline constexpr std::uint32_t kMetrics = 0
#define METRIC(name, number) +1
#include "library/metrics.inc"
    ;

// How many cells a search goes to each side: far more than could matter.
inline constexpr int kSearchReach = 3;

// A feature point, in cells from the corner of the cell of a place, and its cell.
struct FeaturePoint {
  std::array<double, 3> at;
  std::array<std::int64_t, 3> cell;  // from the cell of the place
};

// The right values of a row of cellular noise at a point.
struct CellularValue {
  // For each output the exact value, or with fixed arithmetic the value that the contract defines.
  std::array<double, kOutputWords> values;
  // In the metric of the row. For rows that name the nearest point or lead to it this is how clear it is which one that
  // is.
  double first;
  double second;
  double third;
  FeaturePoint nearest;
  FeaturePoint next;
};
CellularValue searched(const Function& function, const Configuration& configuration,
                       std::span<const std::uint32_t> inputs, int reach = kSearchReach);

// All points that the search sees from the cell of a point with these inputs, with a jitter of 1 if the function takes
// none.
std::vector<FeaturePoint> feature_points(const Function& function, const Configuration& configuration,
                                         std::span<const std::uint32_t> inputs);

// The least that two distances must differ by for it to be clear, with rounded floats, which is the smaller one. It is
// a hundred times the error of a distance.
inline constexpr double kClearMargin = 0x1p-12;

// Whether a point is so near a place where outputs of the function jump that two ways of rounding need not agree on
// them. No point is where every bit counts.
bool is_undecided(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs);

// The exact distance to the nearest point, in the metric of the row.
double nearest_distance(const Function& function, const Configuration& configuration,
                        std::span<const std::uint32_t> inputs);

}  // namespace hn
