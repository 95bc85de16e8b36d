// Derivatives against those of the noise itself, on the same driver.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "cases/places.hpp"
#include "cases/value_checks.hpp"
#include "expected/cellular.hpp"
#include "expected/pairing.hpp"
#include "expected/points.hpp"
#include "expected/simplex.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

constexpr std::size_t kDerivativePoints = 512;
// Positions go no further, so that they have 10 bits of a fraction.
constexpr std::uint32_t kFurthestDerivativeCell = 1024;

// The derivative at a place is the sum of values of the noise at others times their weights, but for an error.
struct Stencil {
  std::vector<Place> nodes;
  std::vector<double> weights;
  double error;
};

// Along an axis a lattice noise is a polynomial within a cell: of degree 5 from the fade curve, and 6 with the ramp of
// a gradient. So seven values in the cell determine it, and its derivative anywhere in it, without an error of the
// method. These places are near those where a polynomial of that degree depends the least on errors of its values, and
// they are multiples of 1/64, which positions of this size hold exactly.
constexpr std::array<double, 7> kNodes = {0.0, 4.0 / 64, 16.0 / 64, 32.0 / 64, 48.0 / 64, 60.0 / 64, 1.0};

// By how much the derivative at t of the polynomial through the nodes grows with the value at node k.
double weight(std::size_t k, double t) {
  double sum = 0.0;
  for (std::size_t without = 0; without < kNodes.size(); ++without) {
    if (without == k) continue;
    double product = 1.0 / (kNodes[k] - kNodes[without]);
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      if (i != k && i != without) product *= (t - kNodes[i]) / (kNodes[k] - kNodes[i]);
    }
    sum += product;
  }
  return sum;
}

Stencil polynomial_through_cell(const Place& place) {
  Stencil stencil{{}, {}, 0.0};
  for (std::size_t k = 0; k < kNodes.size(); ++k) {
    stencil.nodes.push_back({place.cell, kNodes[k]});
    stencil.weights.push_back(weight(k, place.fraction));
  }
  return stencil;
}

// Simplex noise has a polynomial for each set of points that count, and they begin to count anywhere. Its difference to
// both sides is off by no more than the third derivative times the square of the step over 6: that needs a second
// derivative that changes no faster, and no third one. At the step of cbrt(3 error / third) this and the errors of the
// values, over the step, are the least together. It is a multiple of 2^-12, which positions of this size hold exactly.
Stencil difference_to_both_sides(const Place& place, double third, double value_error) {
  const double step = std::max(std::round(std::cbrt(3.0 * value_error / third) * 0x1p12), 1.0) * 0x1p-12;
  return {{moved(place, -step), moved(place, step)}, {-0.5 / step, 0.5 / step}, third * step * step / 6.0};
}

// Along an axis. With a bandwidth a point may have so many more waves.
double third_derivative(const Function& function, std::span<const std::uint32_t> inputs, std::size_t axis) {
  if (!function.takes_wave()) return simplex_third_derivative(function.axes);
  const std::size_t word = static_cast<std::size_t>(function.input("kx")) + axis;
  const int bandwidth = function.input("bandwidth");
  const double more = bandwidth < 0 ? 0.0 : std::max(number_of(inputs[static_cast<std::size_t>(bandwidth)]), 0.0);
  return phasor_third_derivative(function.axes, std::fabs(number_of(inputs[word])) + more);
}

// The third derivative of a distance r along an axis is 3 (1 - c^2) c / r^2 at most, where c is the cosine of the angle
// to it: below 1.16 / r^2. Between the places of the difference r is not below what it is at the point less the step.
constexpr double kCellularStep = 0x1p-7;
Stencil difference_of_distances(const Place& place, double distance) {
  const double nearest = distance - kCellularStep;
  const double step = kCellularStep;
  return {{moved(place, -step), moved(place, step)},
          {-0.5 / step, 0.5 / step},
          1.16 / (nearest * nearest) * step * step / 6.0};
}

// The nearest point is the same all around and no nearer than 1/8: closer to it the difference is of no use.
bool is_clear(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs) {
  const CellularValue all = searched(function, configuration, inputs);
  return all.first >= 0.125 && all.second - all.first > 4.0 * kCellularStep;
}

// Fractions are multiples of 1/1024, from one end of the cell to the other.
Place random_place(const Function& function, Random& random) {
  const std::uint32_t cell = random_cell_of(function, kFurthestDerivativeCell, random);
  // Each end, where derivatives of this cell and of the next meet, is as likely as a quarter of the inside.
  const std::uint32_t end = random.below(6);
  return {cell, end < 2 ? static_cast<double>(end) : static_cast<double>(random.below(1025)) / 1024.0};
}

// The points of the noise without derivatives: for each point, axis and node one.
Words nodes_of(const Function& function, const Function& plain, const Words& inputs,
               const std::vector<std::vector<Stencil>>& stencils) {
  Words words;
  for (std::size_t i = 0; i < stencils.size(); ++i) {
    for (std::size_t axis = 0; axis < stencils[i].size(); ++axis) {
      for (const Place& node : stencils[i][axis].nodes) {
        Words at(point(inputs, i).begin(), point(inputs, i).end());
        put(function, at, axis, node);
        const Words of_plain = inputs_for(plain, function, at);
        words.insert(words.end(), of_plain.begin(), of_plain.end());
      }
    }
  }
  return words;
}

}  // namespace

// Both the derivative and the values may be off by the arithmetic's bound.
Judged check_derivative(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const Configuration& configuration = evaluation.configuration;
  const Function& plain = find_function(function.plain);
  const auto axes = static_cast<std::size_t>(function.axes);
  const double error = error_of(plain, configuration, 0);
  const std::size_t points =
      std::max<std::size_t>(1, std::min(kDerivativePoints, session.most_points / (kNodes.size() * axes)));
  Random random(session.seed, "derivative");
  Words inputs = random_points(function, points, random);
  std::vector<std::vector<Stencil>> stencils(points);
  for (std::size_t i = 0; i < points; ++i) {
    const auto words = std::span(inputs).subspan(i * kInputWords, kInputWords);
    std::vector<Place> places;
    do {
      places.clear();
      for (std::size_t axis = 0; axis < axes; ++axis) {
        places.push_back(random_place(function, random));
        put(function, words, axis, places.back());
      }
    } while (function.is_cellular() && !is_clear(function, configuration, words));
    for (const Place& place : places) {
      stencils[i].push_back(
          function.is_cellular() ? difference_of_distances(place, searched(function, configuration, words).first)
          : function.is_simplex_noise()
              ? difference_to_both_sides(place, third_derivative(function, words, stencils[i].size()), error)
              : polynomial_through_cell(place));
    }
  }
  HN_TRY(const auto derivatives, evaluate(session, evaluation, inputs));
  const Words nodes = nodes_of(function, plain, inputs, stencils);
  HN_TRY(const auto values, evaluate(session, {plain, configuration, evaluation.profile, {}, evaluation.stage}, nodes));
  Comparison comparison(function, inputs);
  const auto own_error = [&](std::size_t i, std::size_t column) {
    return function.is_cellular() ? cellular_tolerance(function, configuration, point(inputs, i), column)
                                  : error_of(function, configuration, column);
  };
  std::size_t node = 0;
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      double expected = 0.0;
      double weights = 0.0;
      for (const double by : stencils[i][axis].weights) {
        expected += by * number_of(result(values, node++)[0]);
        weights += std::fabs(by);
      }
      // The columns of derivatives come last.
      const std::size_t column = function.outputs.size() - axes + axis;
      comparison.number(point(inputs, i), std::bit_cast<float>(result(derivatives, i)[column]), expected,
                        own_error(i, column) + weights * error + stencils[i][axis].error, column);
    }
    if (!function.is_cellular()) continue;
    const std::size_t first = function.outputs.size() - axes;
    double square = 0.0;
    for (std::size_t column = first; column < function.outputs.size(); ++column) {
      const double slope = number_of(result(derivatives, i)[column]);
      square += slope * slope;
    }
    comparison.number(point(inputs, i), static_cast<float>(std::sqrt(square)), 1.0,
                      static_cast<double>(axes) * own_error(i, first));
  }
  return comparison.finish();
}

}  // namespace hn
