#include "expected/tolerance.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace hn {
namespace {

constexpr double kSineError = 0x1p-19;  // of a component of the sine gradient
constexpr double kUnit = 0x1p-23;       // the largest relative error of one operation, in any rounding mode
constexpr double kTiny = 0x1p-126;      // the largest error of flushing a subnormal to 0
// The components of the shift between octaves (docs/contract.md); 2D uses the first two.
constexpr std::array kShift = {11.0 / 32.0, 19.0 / 32.0, 23.0 / 32.0};

double float_input(std::span<const std::uint32_t> inputs, int word) {
  return static_cast<double>(std::bit_cast<float>(inputs[static_cast<std::size_t>(word)]));
}

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

// Whether every product and every sum on the way to the last octave's position is a float. Products of two floats and
// their sums with the shift are exact in a double as long as they are near a float, so the test is, too.
bool positions_are_exact(std::span<const double> position, int octaves, double lacunarity) {
  for (std::size_t axis = 0; axis < position.size(); ++axis) {
    double q = position[axis];
    for (int i = 1; i < octaves; ++i) {
      const double product = q * lacunarity;
      q = product + kShift[axis];
      if (!is_float(product) || !is_float(q)) return false;
    }
  }
  return true;
}

double octave_sum_tolerance(OctaveSum kind, const Function& function, Gradient gradient,
                            std::span<const std::uint32_t> inputs) {
  const int octaves_word = function.input("octaves");
  const int dimensions = octaves_word;  // the coordinates come first
  std::array<double, 3> position{};
  double largest = 0.0;
  for (int axis = 0; axis < dimensions; ++axis) {
    position[static_cast<std::size_t>(axis)] = float_input(inputs, axis);
    largest = std::max(largest, std::fabs(float_input(inputs, axis)));
  }
  const double lacunarity = float_input(inputs, function.input("lacunarity"));
  const int octaves = static_cast<int>(inputs[static_cast<std::size_t>(octaves_word)]);
  const std::span<const double> coordinates(position.data(), static_cast<std::size_t>(dimensions));
  return octave_tolerance(kind, dimensions,
                          {largest, octaves, lacunarity, float_input(inputs, function.input("gain")),
                           positions_are_exact(coordinates, octaves, lacunarity)},
                          gradient);
}

}  // namespace

NoiseBounds noise_bounds(int dimensions, Gradient gradient) {
  if (gradient == Gradient::sine) {
    return dimensions == 2 ? NoiseBounds{4.36e-6, 4.58e-6, 3.76, 1.00001}
                           : NoiseBounds{7.79e-6, 8.20e-6, 6.94, 1.50001};
  }
  return dimensions == 2 ? NoiseBounds{3.24e-6, 3.51e-6, 4.57, 1.0} : NoiseBounds{5.18e-6, 5.54e-6, 6.18, 1.0};
}

double octave_tolerance(OctaveSum kind, int dimensions, const OctaveArguments& arguments, Gradient gradient) {
  const NoiseBounds noise = noise_bounds(dimensions, gradient);
  const double lacunarity = std::fabs(arguments.lacunarity);
  const double shift = dimensions == 2 ? kShift[1] : kShift[2];
  double position = arguments.largest_coordinate;
  double position_error = 0.0;
  double amplitude = 1.0;
  double amplitude_error = 0.0;
  double total = 0.0;
  double total_error = 0.0;
  double sum_error = 0.0;
  for (int i = 0; i < arguments.octaves; ++i) {
    const double noise_error = std::min(noise.lipschitz * position_error + noise.error, 2.0 * noise.range);
    sum_error +=
        (amplitude + amplitude_error) * (noise_error + kUnit * noise.range) + noise.range * amplitude_error + kTiny;
    total_error = arguments.gain * (total_error + kUnit * (total + total_error)) + kTiny;
    total = 1.0 + arguments.gain * total;
    sum_error += kUnit * (noise.range * total + sum_error);
    total_error += kUnit * (total + total_error);
    const double product_error = lacunarity * (position_error + kUnit * (position + position_error) + kTiny) + kTiny;
    position = lacunarity * position + shift;
    position_error = arguments.exact_positions ? 0.0 : product_error + kUnit * (position + product_error);
    amplitude_error = arguments.gain * (amplitude_error + kUnit * (amplitude + amplitude_error)) + kTiny;
    amplitude *= arguments.gain;
  }
  if (total > 0x1p126) return std::numeric_limits<double>::infinity();
  double error = 0.0;
  if (arguments.octaves > 0) {
    error = (sum_error + noise.range * total_error) / (total - total_error);
    error += 2.5 * kUnit * (noise.range + error) + kTiny;
  }
  return kind == OctaveSum::clouds ? 1.5 * (2.0 * error + kUnit) + 3.001 * kUnit : error;
}

double tolerance(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs) {
  if (has_exact_values(function, configuration)) return 0.0;
  const Gradient gradient = configuration.sine() ? Gradient::sine : Gradient::octahedral;
  switch (function.accuracy) {
    case Accuracy::exact:
      return 0.0;
    case Accuracy::sine:
      return kSineError;
    case Accuracy::perlin2_cell:
      return noise_bounds(2, gradient).cell_error;
    case Accuracy::perlin2:
      return noise_bounds(2, gradient).error;
    case Accuracy::perlin3_cell:
      return noise_bounds(3, gradient).cell_error;
    case Accuracy::perlin3:
      return noise_bounds(3, gradient).error;
    case Accuracy::fbm2:
    case Accuracy::fbm3:
      return octave_sum_tolerance(OctaveSum::fbm, function, gradient, inputs);
    case Accuracy::turbulence2:
    case Accuracy::turbulence3:
      return octave_sum_tolerance(OctaveSum::turbulence, function, gradient, inputs);
    case Accuracy::clouds2:
    case Accuracy::clouds3:
      return octave_sum_tolerance(OctaveSum::clouds, function, gradient, inputs);
  }
  return 0.0;
}

}  // namespace hn
