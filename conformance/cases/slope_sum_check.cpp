// Derivatives of octave sums against differences of the sums without them, on the same driver.
#include <algorithm>
#include <bit>
#include <cmath>

#include "cases/places.hpp"
#include "cases/value_checks.hpp"
#include "expected/pairing.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

constexpr std::size_t kSlopeSumPoints = 2048;
// Few octaves near the origin, so that differences mean something: those of values are off by the errors of these.
constexpr std::uint32_t kMostOctaves = 3;
constexpr std::uint32_t kFurthestSlopeSumCell = 16;

// Fractions are multiples of 1/1024, a step from the ends of the cell.
Place random_place(Random& random) {
  return {random.below(2 * kFurthestSlopeSumCell) - kFurthestSlopeSumCell,
          (64.0 + static_cast<double>(random.below(897))) / 1024.0};
}

// How fast a derivative along an axis changes along it. Along a step of the length l, which rotations may lay into any
// direction, a derivative of the noise changes by no more than its Lipschitz constant times l, since no component is
// longer; and the magnitudes of the components, by which the derivatives count, sum to no more than sqrt(n) l.
double bend_of(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs) {
  const NoiseBounds& slope = bounds_of(function, configuration, function.outputs.size() - 1);
  const double gain = number_of(function, inputs, "gain");
  double lacunarity = number_of(function, inputs, "lacunarity");
  if (function.takes_period()) lacunarity = std::floor(lacunarity);
  constexpr double kStretch = 1.001;
  const auto octaves = static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  double sum = 0.0;
  double total = 0.0;
  for (int i = 0; i < octaves; ++i) {
    const double length = std::pow(lacunarity * kStretch, i);
    sum += std::pow(gain, i) * length * length;
    total += std::pow(gain, i);
  }
  return std::sqrt(function.axes) * slope.lipschitz * sum / total;
}

}  // namespace

// The difference to both sides is the mean of the derivative between them, which differs from that in the middle by
// half of the step times how fast it changes. The step is the power of two at which this and the errors of the values,
// over the step, are about the least together.
Judged check_slope_sum(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const Function& plain = find_function(function.plain);
  const auto axes = static_cast<std::size_t>(function.axes);
  const std::size_t points = std::max<std::size_t>(1, std::min(kSlopeSumPoints, session.most_points / (2 * axes)));
  Random random(session.seed, "slope sum");
  Words inputs = random_points(function, points, random);
  Words sides;                  // of the plain sum: for each point and axis, before and behind
  std::vector<double> steps;    // for each point
  std::vector<double> allowed;  // for each point and axis
  for (std::size_t i = 0; i < points; ++i) {
    const auto words = std::span(inputs).subspan(i * kInputWords, kInputWords);
    words[static_cast<std::size_t>(function.input("octaves"))] = 1 + random.below(kMostOctaves);
    std::vector<Place> places;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      places.push_back(random_place(random));
      put(function, words, axis, places.back());
    }
    const double bend = bend_of(function, configuration, words);
    const double error = tolerance(plain, configuration, inputs_for(plain, function, words), 0);
    const double best = std::sqrt(2.0 * error / bend);
    const double step = std::ldexp(1.0, std::clamp(static_cast<int>(std::round(std::log2(best))), -16, -5));
    steps.push_back(step);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      double errors = 0.0;
      for (const double by : {-step, step}) {
        Words at(words.begin(), words.end());
        put(function, at, axis, moved(places[axis], by));
        const Words side = inputs_for(plain, function, at);
        errors += tolerance(plain, configuration, side, 0);
        sides.insert(sides.end(), side.begin(), side.end());
      }
      allowed.push_back(tolerance(function, configuration, words, 1 + axis) + bend * step / 2.0 +
                        errors / (2.0 * step));
    }
  }
  HN_TRY(const auto derivatives, evaluate(session, evaluation, inputs));
  HN_TRY(const auto values, evaluate(session, {plain, configuration, profile, {}, stage}, sides));
  const auto value = [&](std::size_t i) { return number_of(result(values, i)[0]); };
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::size_t side = 2 * (i * axes + axis);
      const double expected = (value(side + 1) - value(side)) / (2.0 * steps[i]);
      const float got = std::bit_cast<float>(result(derivatives, i)[1 + axis]);
      comparison.number(point(inputs, i), got, expected, allowed[i * axes + axis], 1 + axis);
    }
  }
  return comparison.finish();
}

}  // namespace hn
