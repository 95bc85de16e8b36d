#include "bake/ranges.hpp"

#include <algorithm>
#include <array>

#include "grid/functions.hpp"

namespace hn {
namespace {

constexpr Interval kSigned = {-1.0, 1.0};
constexpr Interval kUnsigned = {0.0, 1.0};

// Of a component, by the number of dimensions from 1 to 4. Empty intervals are not of this library.
struct Row {
  std::string_view noise;
  std::string_view component;  // "d": each derivative
  std::array<Interval, 4> by_dimensions;
};
constexpr Interval kNone = {0.0, 0.0};
constexpr Interval around_0(double greatest) { return {-greatest, greatest}; }
constexpr std::array<Row, 16> kRows = {{
    {"cellular", "f1", {{kNone, {0.0, 1.1181}, {0.0, 1.2248}, kNone}}},
    {"cellular", "f2", {{kNone, {0.0, 1.5001}, {0.0, 1.5001}, kNone}}},
    {"cellular_three", "f1", {{kNone, {0.0, 1.1181}, {0.0, 1.2248}, kNone}}},
    {"cellular_three", "f2", {{kNone, {0.0, 1.5001}, {0.0, 1.5001}, kNone}}},
    {"cellular_three", "f3", {{kNone, {0.0, 1.5812}, {0.0, 1.5812}, kNone}}},
    {"cellular_d", "f1", {{kNone, {0.0, 1.1181}, {0.0, 1.2248}, kNone}}},
    {"cellular_d", "d", {{kNone, kSigned, kSigned, kNone}}},
    {"cellular_smooth", "value", {{kNone, {-0.1937, 0.875}, {-0.198, 0.875}, kNone}}},
    {"cell_border", "value", {{kNone, {0.0, 0.844}, {0.0, 0.883}, kNone}}},
    {"curl", "", {{kNone, around_0(8.36), around_0(46.2), kNone}}},
    {"value_d", "d", {{around_0(3.76), around_0(3.76), around_0(3.76), around_0(3.76)}}},
    {"perlin_d", "d", {{around_0(2.69), around_0(2.78), around_0(3.38), around_0(3.62)}}},
    {"simplex_d", "d", {{kNone, around_0(8.36), around_0(6.42), around_0(6.06)}}},
    // With a phase.
    {"perlin_d_phase", "d", {{kNone, around_0(2.93), around_0(3.55), kNone}}},
    {"simplex_d_phase", "d", {{kNone, around_0(8.63), around_0(6.79), kNone}}},
    {"", "", {}},
}};

bool is_derivative(std::string_view component) { return component.size() == 2 && component.front() == 'd'; }

// A noise alone.
std::optional<Interval> range_of_noise(std::string_view noise, int dimensions, std::string_view component) {
  for (const Row& row : kRows) {
    const bool is_it =
        row.component.empty() || row.component == component || (row.component == "d" && is_derivative(component));
    if (row.noise.empty() || row.noise != noise || !is_it) continue;
    const Interval range = row.by_dimensions[static_cast<std::size_t>(dimensions - 1)];
    return range == kNone ? std::nullopt : std::optional(range);
  }
  return component == "value" ? std::optional(kSigned) : std::nullopt;
}

}  // namespace

std::optional<Interval> documented_range(const hashnoise::Settings& settings, int dimensions,
                                         std::string_view component) {
  const std::string& sum = settings.sum;
  if (sum == "turbulence" || sum == "clouds" || sum == "ridged") return kUnsigned;
  if (sum == "warp" || sum == "warp_progressive") {
    const hashnoise::grid::SumRow& warp = hashnoise::grid::kSumRows[hashnoise::grid::kWarp];
    const double amplitude = static_cast<double>(settings.amplitude.value_or(warp.usual_strength));
    return amplitude == 0.0 ? std::nullopt : std::optional(around_0(amplitude));
  }
  // These are means of the noise, and of values that lie nearer to 0.
  if (sum == "fbm" || sum == "weighted") return range_of_noise(settings.noise, dimensions, component);
  if (!sum.empty()) return component == "value" ? std::optional(kSigned) : std::nullopt;
  const bool has_metric = settings.noise == "cellular" || settings.noise == "cellular_three";
  if (has_metric && settings.metric.value_or(hashnoise::Metric::kEuclidean) != hashnoise::Metric::kEuclidean)
    return std::nullopt;
  return range_of_noise(settings.phase ? settings.noise + "_phase" : settings.noise, dimensions, component);
}

}  // namespace hn
