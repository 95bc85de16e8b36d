// The divergence of a field of velocities, by differences on the same driver.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "cases/places.hpp"
#include "cases/value_checks.hpp"

namespace hn {
namespace {

constexpr std::size_t kDivergencePoints = 2048;
constexpr std::uint32_t kFurthestCurlCell = 1024;
constexpr std::uint32_t kFurthestSummedCell = 64;  // floats round the positions of later octaves
constexpr double kStep = 0x1p-8;
// The measure goes from 0 to 1. With the twin hn_curl comes to 0.0005 in floats and to 0.0014 with fixed arithmetic, by
// the roundings of values and by kinks of the derivatives within a step. With a wrong sign it comes to 1, and
// normalised to 0.5.
constexpr double kLimit = 0.01;

}  // namespace

// At each point the differences of the components, each along its own axis, sum to 0; so the sums are small in all when
// compared with what they are made of.
Judged check_divergence(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const auto axes = static_cast<std::size_t>(function.axes);
  const std::size_t points = std::max<std::size_t>(1, std::min(kDivergencePoints, session.most_points / (2 * axes)));
  Random random(session.seed, "divergence");
  Words centres = random_points(function, points, random);
  const bool is_sum = function.is_sum_of_flows();
  // A step is at most a 64th of a cell of the finest octave.
  for (std::size_t i = 0; is_sum && i < centres.size(); i += kInputWords) {
    centres[i + static_cast<std::size_t>(function.input("octaves"))] = 1 + random.below(3);
    centres[i + static_cast<std::size_t>(function.input("lacunarity"))] = std::bit_cast<std::uint32_t>(2.0f);
  }
  Words inputs;  // of each point two along each axis: before it and after it
  for (std::size_t i = 0; i < points; ++i) {
    std::vector<Place> places;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::uint32_t cell = random_cell_of(function, is_sum ? kFurthestSummedCell : kFurthestCurlCell, random);
      places.push_back({cell, static_cast<double>(random.below(1024)) / 1024.0});
    }
    for (std::size_t moves = 0; moves < 2 * axes; ++moves) {
      inputs.insert(inputs.end(), point(centres, i).begin(), point(centres, i).end());
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const double by = axis != moves / 2 ? 0.0 : moves % 2 == 0 ? -kStep : kStep;
        put(function, std::span(inputs).last(kInputWords), axis, moved(places[axis], by));
      }
    }
  }
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  double divergences = 0.0;
  double differences = 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    double divergence = 0.0;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::size_t before = 2 * (i * axes + axis);
      const double term = number_of(result(outputs, before + 1)[axis]) - number_of(result(outputs, before)[axis]);
      divergence += term;
      differences += std::fabs(term);
    }
    divergences += std::fabs(divergence);
  }
  Comparison comparison(function, inputs);
  const double share = divergences / differences;
  comparison.require(differences > 0.0 && share < kLimit, point(inputs, 0), static_cast<float>(share),
                     fmt::format("sums of less than {} of the differences that they are made of", kLimit));
  return comparison.finish();
}

}  // namespace hn
