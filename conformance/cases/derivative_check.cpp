// Derivatives against those of the noise itself, on the same driver.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "cases/value_checks.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

constexpr std::size_t kPoints = 512;

// Along an axis a noise is a polynomial within a cell: of degree 5 from the fade curve, and 6 with the ramp of a
// gradient. So seven values in the cell determine it, and its derivative anywhere in it, without an error of the
// method. These places are near those where a polynomial of that degree depends the least on errors of its values, and
// they are multiples of 1/64, which positions of this size hold exactly.
constexpr std::array<double, 7> kNodes = {0.0, 4.0 / 64, 16.0 / 64, 32.0 / 64, 48.0 / 64, 60.0 / 64, 1.0};
// Of positions: they have 10 bits of a fraction.
constexpr std::uint32_t kFurthestCell = 1024;

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

// Where a point lies along an axis. Fractions are multiples of 1/1024, from one end of the cell to the other.
struct Place {
  std::uint32_t cell;
  double fraction;
};

Place random_place(const Function& function, Random& random) {
  const bool far = function.takes_cell() && random.below(2) == 0;
  const std::uint32_t cell = far ? random.word() : random.below(2 * kFurthestCell) - kFurthestCell;
  // Each end, where derivatives of this cell and of the next meet, is as likely as a quarter of the inside.
  const std::uint32_t end = random.below(6);
  return {cell, end < 2 ? static_cast<double>(end) : static_cast<double>(random.below(1025)) / 1024.0};
}

// Writes a place into the words of a point.
void put(const Function& function, std::span<std::uint32_t> words, std::size_t axis, const Place& place) {
  const auto bits = [](double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); };
  if (function.takes_cell()) {
    words[axis] = place.cell;
    words[static_cast<std::size_t>(function.axes) + axis] = bits(place.fraction);
  } else {
    words[axis] = bits(static_cast<double>(static_cast<std::int32_t>(place.cell)) + place.fraction);
  }
}

double number(std::span<const std::uint32_t> words, std::size_t word) {
  return static_cast<double>(std::bit_cast<float>(words[word]));
}

// The points of the noise without derivatives: for each point, axis and node one.
Words nodes_of(const Function& function, const Function& plain, const Words& inputs,
               const std::vector<std::vector<Place>>& places) {
  Words words;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t axis = 0; axis < places[i].size(); ++axis) {
      for (const double node : kNodes) {
        Words at(point(inputs, i).begin(), point(inputs, i).end());
        put(function, at, axis, {places[i][axis].cell, node});
        for (std::size_t column = 0; column < plain.inputs.size(); ++column) {
          words.push_back(at[static_cast<std::size_t>(function.input(plain.inputs[column].name))]);
        }
        words.resize(words.size() + kInputWords - plain.inputs.size());
      }
    }
  }
  return words;
}

}  // namespace

// Both the derivative and the values may be off by what the arithmetic allows.
Outcome check_derivative(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  const Function& plain = plain_noise_of(function);
  const auto axes = static_cast<std::size_t>(function.axes);
  const std::size_t points = std::max<std::size_t>(1, std::min(kPoints, session.most_points / (kNodes.size() * axes)));
  Random random(session.seed, "derivative");
  Words inputs = random_points(function, points, random);
  std::vector<std::vector<Place>> places(points, std::vector<Place>(axes));
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      places[i][axis] = random_place(function, random);
      put(function, std::span(inputs).subspan(i * kInputWords, kInputWords), axis, places[i][axis]);
    }
  }
  const auto derivatives = evaluate(session, evaluation, inputs);
  if (!derivatives) return derivatives.error();
  const Words nodes = nodes_of(function, plain, inputs, places);
  const auto values = evaluate(session, {plain, configuration, profile, {}, stage}, nodes);
  if (!values) return values.error();
  const double error = error_of(plain, configuration, 0);
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      double expected = 0.0;
      double weights = 0.0;
      for (std::size_t k = 0; k < kNodes.size(); ++k) {
        const double by = weight(k, places[i][axis].fraction);
        expected += by * number(result(*values, (i * axes + axis) * kNodes.size() + k), 0);
        weights += std::fabs(by);
      }
      // The columns of derivatives come last.
      const std::size_t column = function.outputs.size() - axes + axis;
      comparison.number(point(inputs, i), std::bit_cast<float>(result(*derivatives, i)[column]), expected,
                        error_of(function, configuration, column) + weights * error, column);
    }
  }
  return comparison.finish();
}

}  // namespace hn
