#include "expected/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "expected/cellular.hpp"

namespace hn {
namespace {

constexpr double kUnit = 0x1p-23;   // the largest relative error of one operation, in any rounding mode
constexpr double kTiny = 0x1p-126;  // the largest error of flushing a subnormal to 0
// The words of bounds.inc.
constexpr std::optional<Gradient> octahedral = Gradient::octahedral;
constexpr std::optional<Gradient> sine = Gradient::sine;
[[maybe_unused]] constexpr std::optional<Gradient> none = std::nullopt;
const std::vector<NoiseBounds> kNoiseBounds = {
#define NOISE_BOUNDS(...) NoiseBounds{__VA_ARGS__},
#define SLOPE_BOUNDS(...)
#define SINE_BOUNDS(error, fixed_error)
#include "expected/bounds.inc"
#undef NOISE_BOUNDS
#undef SLOPE_BOUNDS
#undef SINE_BOUNDS
};
const std::vector<NoiseBounds> kSlopeBounds = {
#define NOISE_BOUNDS(...)
#define SLOPE_BOUNDS(...) NoiseBounds{__VA_ARGS__},
#define SINE_BOUNDS(error, fixed_error)
#include "expected/bounds.inc"
#undef NOISE_BOUNDS
#undef SLOPE_BOUNDS
#undef SINE_BOUNDS
};
#define NOISE_BOUNDS(...)
#define SLOPE_BOUNDS(...)
#define SINE_BOUNDS(error, fixed_error) constexpr double kSineError = error;
#include "expected/bounds.inc"
#undef NOISE_BOUNDS
#undef SLOPE_BOUNDS
#undef SINE_BOUNDS

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

const NoiseBounds& bounds_in(const std::vector<NoiseBounds>& table, std::string_view noise, int axes,
                             Gradient gradient) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const NoiseBounds& bounds) {
    return bounds.noise == noise && bounds.axes == axes && bounds.gradient.value_or(gradient) == gradient;
  });
  if (found == table.end()) {
    throw std::logic_error(fmt::format("bounds.inc has no bounds of {} with {} axes", noise, axes));
  }
  return *found;
}

double octave_sum_tolerance(const Function& function, Gradient gradient, std::span<const std::uint32_t> inputs) {
  std::array<double, 4> position{};
  const auto axes = static_cast<std::size_t>(function.axes);
  double largest = 0.0;
  for (int axis = 0; axis < function.axes; ++axis) {
    position[static_cast<std::size_t>(axis)] = float_input(inputs, axis);
    largest = std::max(largest, std::fabs(float_input(inputs, axis)));
  }
  double lacunarity = float_input(inputs, function.input("lacunarity"));
  if (function.takes_period()) lacunarity = std::floor(std::clamp(lacunarity, 0.0, 255.0));  // a tile stays a tile
  const int octaves = static_cast<int>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  return octave_tolerance(octave_sum_of(function), function.axes,
                          {largest, octaves, lacunarity, float_input(inputs, function.input("gain")),
                           positions_are_exact(std::span(position).first(axes), octaves, lacunarity)},
                          gradient);
}

}  // namespace

const NoiseBounds& noise_bounds(std::string_view noise, int axes, Gradient gradient) {
  return bounds_in(kNoiseBounds, noise, axes, gradient);
}

const NoiseBounds& slope_bounds(std::string_view noise, int axes, Gradient gradient) {
  return bounds_in(kSlopeBounds, noise, axes, gradient);
}

const NoiseBounds& bounds_of(const Function& function, const Configuration& configuration, std::size_t output) {
  if (function.is_octave_sum()) return noise_bounds("perlin", function.axes, configuration.gradient);
  const auto& table = function.is_slope(output) ? kSlopeBounds : kNoiseBounds;
  // A component of the vector to a point is as exact as the Manhattan distance, of which it is a part.
  const std::string_view bound = function.is_cellular() && function.is_offset(output) ? "cellular" : function.bound;
  return bounds_in(table, bound, function.axes, configuration.gradient);
}

double error_of(const Function& function, const Configuration& configuration, std::size_t output) {
  const NoiseBounds& bounds = bounds_of(function, configuration, output);
  if (configuration.arithmetic == Arithmetic::fixed) return bounds.fixed_error;
  return function.starts_from_integers() ? bounds.cell_error : bounds.error;
}

OctaveSum octave_sum_of(const Function& function) {
  if (function.bound == "fbm") return OctaveSum::fbm;
  if (function.bound == "turbulence") return OctaveSum::turbulence;
  if (function.bound == "clouds") return OctaveSum::clouds;
  throw std::logic_error(fmt::format("{}: '{}' is not an octave sum", function.id, function.bound));
}

double octave_tolerance(OctaveSum kind, int axes, const OctaveArguments& arguments, Gradient gradient) {
  const NoiseBounds& noise = noise_bounds("perlin", axes, gradient);
  const double lacunarity = std::fabs(arguments.lacunarity);
  const double shift = axes == 2 ? kShift[1] : kShift[2];  // the largest
  double position = arguments.largest_coordinate;
  double position_error = 0.0;
  double amplitude = 1.0;
  double amplitude_error = 0.0;
  double total = 0.0;
  double total_error = 0.0;
  double sum_error = 0.0;
  for (int i = 0; i < arguments.octaves; ++i) {
    const double noise_error = std::min(noise.lipschitz * position_error + noise.error, 2.0 * noise.limit);
    sum_error +=
        (amplitude + amplitude_error) * (noise_error + kUnit * noise.limit) + noise.limit * amplitude_error + kTiny;
    total_error = arguments.gain * (total_error + kUnit * (total + total_error)) + kTiny;
    total = 1.0 + arguments.gain * total;
    sum_error += kUnit * (noise.limit * total + sum_error);
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
    error = (sum_error + noise.limit * total_error) / (total - total_error);
    error += 2.5 * kUnit * (noise.limit + error) + kTiny;
  }
  return kind == OctaveSum::clouds ? 1.5 * (2.0 * error + kUnit) + 3.001 * kUnit : error;
}

double tolerance(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs,
                 std::size_t output) {
  if (has_exact_values(function, configuration)) return 0.0;
  if (function.family == Family::sine_gradient) return kSineError;
  if (function.is_octave_sum()) return octave_sum_tolerance(function, configuration.gradient, inputs);
  if (function.is_cellular()) return cellular_tolerance(function, configuration, inputs, output);
  return error_of(function, configuration, output);
}

double cellular_tolerance(const Function& function, const Configuration& configuration,
                          std::span<const std::uint32_t> inputs, std::size_t output) {
  if (function.is_name(output)) return 0.0;
  const double error = error_of(function, configuration, output);
  if (!function.is_slope(output)) return error;
  const double distance = nearest_distance(function, configuration, inputs);
  return error < 2.0 * distance ? error / distance : 2.0;
}

}  // namespace hn
