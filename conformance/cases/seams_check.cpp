// Jumps of a noise: pairs of points beside the walls of cells, and beside the planes where other lattice points begin
// to count.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "cases/places.hpp"
#include "cases/value_checks.hpp"
#include "expected/cellular.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

constexpr std::size_t kSeamPoints = 4096;
constexpr std::uint32_t kFurthestSeamCell = 64;
// The unit of places, which positions of this size, their fractions and fixed arithmetic hold exactly.
constexpr double kUnit = 0x1p-16;
constexpr std::uint32_t kUnits = 65536;

using Fractions = std::array<double, 4>;

// A plane that goes through the fractions, and the axis along which to cross it.
struct Crossing {
  Fractions fractions;
  std::size_t axis;
};

double rest_of(double x) { return x - std::floor(x); }

// The seams of the triangles are the lines where u, v or u - v are whole, with u = 2 x + y and v = 2 y.
Crossing crossing_of_triangles(Fractions f, Random& random) {
  const double y = 2.0 * kUnit * std::floor(f[1] / kUnit / 2.0);  // so that its half is exact
  const double half = random.below(2) == 0 ? 0.0 : 0.5;
  switch (random.below(3)) {
    case 0:
      return {{rest_of(half - y / 2.0), y}, 0};
    case 1:
      return {{rest_of(half + y / 2.0), y}, 0};
    default:
      return {{f[0], half}, 1};
  }
}

// In smooth noise a row has its points at multiples of 1/2 along x, or between them.
Crossing crossing_of_rows(Fractions f, Random& random) {
  if (random.below(2) == 0) return {{f[0], random.below(2) == 0 ? 0.0 : 0.5}, 1};
  return {{static_cast<double>(random.below(4)) / 4.0, f[1]}, 0};
}

double from_nearest_end(double f) { return std::min(f, 1.0 - f); }
double at_distance(double distance, Random& random) { return random.below(2) == 0 ? distance : 1.0 - distance; }

// The seams of the centred lattice are in the middle of a cell, and where two axes are as far from their nearest ends.
Crossing crossing_of_centred(Fractions f, std::size_t axes, Random& random) {
  const std::size_t axis = random.below(static_cast<std::uint32_t>(axes));
  const std::size_t other = (axis + 1 + random.below(static_cast<std::uint32_t>(axes - 1))) % axes;
  f[axis] = random.below(2) == 0 ? 0.5 : at_distance(from_nearest_end(f[other]), random);
  return {f, axis};
}

// Smooth noise in space has seams in the middle of a cell, and where both ends of a diagonal of the cube are as near.
// With the distances a, b and c from the nearest ends the latter are where a + b - c is 0 or 1/2.
Crossing crossing_of_diagonals(Fractions f, Random& random) {
  const std::size_t axis = random.below(3);
  const double b = from_nearest_end(f[(axis + 1) % 3]);
  const double c = from_nearest_end(f[(axis + 2) % 3]);
  const std::array<double, 4> distances = {c - b, b - c, 0.5 + c - b, b + c};
  const double distance = distances[random.below(4)];
  const bool there = distance >= 0.0 && distance <= 0.5;
  f[axis] = there ? at_distance(distance, random) : 0.5;
  return {f, axis};
}

// Cellular noise has seams at a wall, where the searched cells change, and in the middle, where the cells beyond
// change.
Crossing crossing_of_cells(Fractions f, std::size_t axes, Random& random) {
  const std::size_t axis = random.below(static_cast<std::uint32_t>(axes));
  f[axis] = random.below(2) == 0 ? 0.0 : 0.5;
  return {f, axis};
}

Crossing random_crossing(const Function& function, Random& random) {
  const auto axes = static_cast<std::size_t>(function.axes);
  Fractions f{};
  for (double& fraction : f) fraction = static_cast<double>(random.below(kUnits)) * kUnit;
  if (function.is_cellular()) return crossing_of_cells(f, axes, random);
  const bool wall = !function.is_simplex_noise() || random.below(4) == 0;
  if (wall) {
    const std::size_t axis = random.below(static_cast<std::uint32_t>(axes));
    f[axis] = 0.0;
    return {f, axis};
  }
  const bool smooth = function.bound == "simplex_smooth";
  if (axes == 2) return smooth ? crossing_of_rows(f, random) : crossing_of_triangles(f, random);
  return smooth ? crossing_of_diagonals(f, random) : crossing_of_centred(f, axes, random);
}

// The largest allowed change of an output between two points this far apart, or nullopt where it may jump. The
// derivatives of a distance r rotate by less than the way divided by r.
std::optional<double> largest_change(const Function& function, const Configuration& configuration,
                                     std::span<const std::uint32_t> inputs, std::size_t word, double distance) {
  if (!function.is_cellular() || !function.is_slope(word)) {
    return bounds_of(function, configuration, word).lipschitz * distance +
           2.0 * error_of(function, configuration, word);
  }
  const CellularValue all = searched(function, configuration, inputs);
  if (all.second - all.first < 4.0 * distance || all.first < 0x1p-6) return std::nullopt;
  return (distance + 2.0 * error_of(function, configuration, word)) / (all.first - distance);
}

}  // namespace

// The points of a pair are two units apart, one on each side, or one unit and one of them on the plane. The largest
// change of a noise or a derivative in between is proven (bounds.inc).
Judged check_seams(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const Configuration& configuration = evaluation.configuration;
  const auto axes = static_cast<std::size_t>(function.axes);
  Random random(session.seed, "seams");
  Words before = random_points(function, std::min(kSeamPoints, session.most_points), random);
  Words after = before;
  std::vector<double> distances;
  for (std::size_t i = 0; i < before.size(); i += kInputWords) {
    const Crossing crossing = random_crossing(function, random);
    const std::uint32_t sides = random.below(3);  // 0: both
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const Place place{random_cell_of(function, kFurthestSeamCell, random), crossing.fractions[axis]};
      const bool crosses = axis == crossing.axis;
      const auto put_into = [&](Words& words, double by) {
        put(function, std::span(words).subspan(i, kInputWords), axis, moved(place, crosses ? by : 0.0));
      };
      put_into(before, sides == 2 ? 0.0 : -kUnit);
      put_into(after, sides == 1 ? 0.0 : kUnit);
    }
    distances.push_back(sides == 0 ? 2.0 * kUnit : kUnit);
  }
  HN_TRY(const auto expected, evaluate(session, evaluation, before));
  HN_TRY(const auto got, evaluate(session, evaluation, after));
  Comparison comparison(function, after);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    for (std::size_t word = 0; word < function.outputs.size(); ++word) {
      const auto change = largest_change(function, configuration, point(after, i), word, distances[i]);
      if (!change) continue;
      comparison.number(point(after, i), std::bit_cast<float>(result(got, i)[word]),
                        number_of(result(expected, i)[word]), *change, word);
    }
  }
  return comparison.finish();
}

}  // namespace hn
