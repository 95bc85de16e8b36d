#include "expected/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
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
// The turns between octaves, in the plane of x and y and then in that of y and z; they stretch, too.
constexpr double kCosine = 25.0 / 32.0;
constexpr double kSine = 20.0 / 32.0;
constexpr double kSecondCosine = 29.0 / 32.0;
constexpr double kSecondSine = 13.0 / 32.0;
constexpr double kWhole = 0x1p-24;  // the unit of whole positions

double float_input(std::span<const std::uint32_t> inputs, int word) {
  return static_cast<double>(std::bit_cast<float>(inputs[static_cast<std::size_t>(word)]));
}

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

// Whether terms that are floats have a sum that is exact in whatever order they are added: they are multiples of some
// power of two, of which a float holds as many as their magnitudes sum to.
bool is_exact_sum(std::span<const double> terms) {
  int lowest = std::numeric_limits<int>::max();  // set bit
  double magnitudes = 0.0;
  for (const double term : terms) {
    if (!is_float(term)) return false;
    if (term == 0.0) continue;
    int exponent = 0;
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(term), &exponent), 53));
    lowest = std::min(lowest, exponent - 53 + std::countr_zero(mantissa));
    magnitudes += std::fabs(term);
  }
  return magnitudes == 0.0 || magnitudes <= std::ldexp(1.0, lowest + 24);
}

using Position = std::array<double, 3>;

// One coordinate of a turn, a*x + b*y + shift. Products of two floats are exact in a double. Whether the result is,
// too.
bool turn_is_exact(double a, double x, double b, double y, double shift, double& result) {
  const std::array terms = {a * x, b * y, shift};
  result = terms[0] + terms[1] + terms[2];
  return is_exact_sum(terms);
}

// The next octave's position, if every step to it is exact. Without a period it is turned: in the plane of x and y, and
// then in that of y and z.
bool next_is_exact(Position& q, std::size_t axes, double lacunarity, bool turns) {
  if (!turns) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      if (!turn_is_exact(q[axis], lacunarity, 0.0, 0.0, kShift[axis], q[axis])) return false;
    }
    return true;
  }
  const double c = lacunarity * kCosine;
  const double s = lacunarity * kSine;
  if (!is_float(c) || !is_float(s)) return false;
  const auto [x, y, z] = q;
  if (!turn_is_exact(c, x, -s, y, kShift[0], q[0])) return false;
  if (axes == 2) return turn_is_exact(s, x, c, y, kShift[1], q[1]);
  const double second_c = lacunarity * kSecondCosine;
  const double second_s = lacunarity * kSecondSine;
  if (!is_float(second_c) || !is_float(second_s)) return false;
  double v = 0.0;
  return turn_is_exact(s, x, c, y, 0.0, v) && turn_is_exact(kSecondCosine, v, -second_s, z, kShift[1], q[1]) &&
         turn_is_exact(kSecondSine, v, second_c, z, kShift[2], q[2]);
}

bool positions_are_exact(Position q, std::size_t axes, double octaves, double lacunarity, bool turns) {
  for (int i = 1; i < octaves; ++i) {
    if (!next_is_exact(q, axes, lacunarity, turns)) return false;
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

// Where an octave sum starts, by its position or its cell and fraction.
struct Start {
  Position position;
  bool exact;  // as a whole number: no fraction is cut
};

Start start_of(const Function& function, std::span<const std::uint32_t> inputs) {
  Start start{{}, true};
  for (int axis = 0; axis < function.axes; ++axis) {
    double& coordinate = start.position[static_cast<std::size_t>(axis)];
    if (!function.takes_cell()) {
      coordinate = float_input(inputs, axis);
      continue;
    }
    const double fraction = std::clamp(float_input(inputs, function.axes + axis), 0.0, 1.0);
    start.exact = start.exact && std::fmod(fraction, kWhole) == 0.0;
    coordinate = static_cast<double>(static_cast<std::int32_t>(inputs[static_cast<std::size_t>(axis)])) + fraction;
  }
  return start;
}

double octave_sum_tolerance(const Function& function, Gradient gradient, std::span<const std::uint32_t> inputs) {
  const Start start = start_of(function, inputs);
  const auto input = [&](std::string_view name) { return float_input(inputs, function.input(name)); };
  double lacunarity = input("lacunarity");
  const bool tiled = function.takes_period();
  if (function.takes_cell() || tiled) lacunarity = std::clamp(lacunarity, 0.0, 255.0);
  if (tiled) lacunarity = std::floor(lacunarity);  // a tile stays a tile
  const auto octaves = function.takes_detail()
                           ? input("detail")
                           : static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  // A whole number of whole lacunarity stays one. What a turn rounds down is counted, however little it is.
  const bool exact =
      function.takes_cell()
          ? start.exact && tiled
          : positions_are_exact(start.position, static_cast<std::size_t>(function.axes), octaves, lacunarity, !tiled);
  OctaveArguments arguments{0.0, octaves, lacunarity, input("gain"), exact};
  for (const double coordinate : start.position) {
    arguments.largest_coordinate = std::max(arguments.largest_coordinate, std::fabs(coordinate));
  }
  if (function.takes_strength()) arguments.strength = input("strength");
  if (function.takes_footprint()) arguments.footprint = input("footprint");
  arguments.turns = !tiled;
  arguments.from_cell = function.takes_cell();
  arguments.is_detail = function.takes_detail();
  return octave_tolerance(octave_sum_of(function), function.axes, arguments, gradient);
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
  using enum OctaveSum;
  constexpr std::array<std::pair<std::string_view, OctaveSum>, 7> kSums = {{{"fbm", fbm},
                                                                            {"turbulence", turbulence},
                                                                            {"clouds", clouds},
                                                                            {"billow", billow},
                                                                            {"ridged", ridged},
                                                                            {"ping_pong", ping_pong},
                                                                            {"weighted", weighted}}};
  for (const auto& [name, sum] : kSums) {
    if (function.bound == name) return sum;
  }
  throw std::logic_error(fmt::format("{}: '{}' is not an octave sum", function.id, function.bound));
}

// What follows is in tools/lib/bounds/sums.py, with the reasons.
namespace {

// A noise beyond [-1, 1] counts as the nearer end.
bool is_clamped(OctaveSum kind) {
  using enum OctaveSum;
  return kind == billow || kind == ridged || kind == ping_pong || kind == weighted;
}

int count_of(const OctaveArguments& arguments) {
  return arguments.octaves < 0x1p-32 ? 0 : static_cast<int>(std::ceil(arguments.octaves));
}

double strength_of(OctaveSum kind, const OctaveArguments& arguments) {
  return std::clamp(arguments.strength, 0.0, kind == OctaveSum::ping_pong ? 64.0 : 1.0);
}

// How far each octave's position may be off.
using Errors = std::vector<double>;

// Without turns each coordinate is bounded on its own.
Errors straight_position_errors(int axes, const OctaveArguments& arguments) {
  const double lacunarity = std::fabs(arguments.lacunarity);
  const double shift = kShift[static_cast<std::size_t>(axes) - 1];  // the largest
  double position = arguments.largest_coordinate;
  double error = 0.0;
  Errors errors;
  for (int i = 0; i < count_of(arguments); ++i) {
    errors.push_back(error);
    const double product_error = lacunarity * (error + kUnit * (position + error) + kTiny) + kTiny;
    position = lacunarity * position + shift;
    error = arguments.exact_positions ? 0.0 : product_error + kUnit * (position + product_error);
  }
  return errors;
}

// Of lengths, by the first turn. The second stretches none.
const double kStretch = std::hypot(kCosine, kSine);

// With turns lengths are bounded.
Errors turned_position_errors(int axes, const OctaveArguments& arguments) {
  const double shift = kShift[static_cast<std::size_t>(axes) - 1];
  const double diagonal = std::sqrt(axes);
  const double stretch = std::fabs(arguments.lacunarity) * kStretch;
  const double rounding = std::pow(1.0 + kUnit, 2 * axes) - 1.0;
  double position = diagonal * arguments.largest_coordinate;
  double error = 0.0;
  Errors errors;
  for (int i = 0; i < count_of(arguments); ++i) {
    errors.push_back(error);
    const double reach = position + error;
    const double of_coordinate = rounding * stretch * reach + kUnit * shift + kTiny * (4.0 * reach + 8.0);
    error = arguments.exact_positions ? 0.0 : stretch * error + diagonal * of_coordinate;
    position = stretch * position + diagonal * shift;
  }
  return errors;
}

Errors whole_position_errors(int axes, const OctaveArguments& arguments) {
  const double ratio = std::trunc(arguments.lacunarity * 0x1p23) / 0x1p23;
  const double shift = kShift[static_cast<std::size_t>(axes) - 1];
  const double diagonal = arguments.turns ? std::sqrt(axes) : 1.0;
  const int turns = arguments.turns ? axes - 1 : 0;
  double position = diagonal * arguments.largest_coordinate;
  double error = arguments.exact_positions ? 0.0 : diagonal * kWhole;
  Errors errors;
  for (int i = 0; i < count_of(arguments); ++i) {
    errors.push_back(error);
    error = ratio * error + (arguments.lacunarity - ratio) * position + diagonal * kWhole;
    for (int turn = 0; turn < turns; ++turn) error = (turn == 0 ? kStretch : 1.0) * error + std::sqrt(2.0) * kWhole;
    if (arguments.exact_positions) error = 0.0;
    position = arguments.lacunarity * (arguments.turns ? kStretch : 1.0) * position + diagonal * shift;
  }
  return errors;
}

Errors position_errors(int axes, const OctaveArguments& arguments) {
  if (arguments.from_cell) return whole_position_errors(axes, arguments);
  return arguments.turns ? turned_position_errors(axes, arguments) : straight_position_errors(axes, arguments);
}

// What an octave adds, before its weight: how far it may be off, and how large it can be.
struct Terms {
  Errors errors;
  double limit;
};

Terms terms_of(OctaveSum kind, const OctaveArguments& arguments, double limit, const Errors& noise_errors) {
  Terms terms{{}, limit};
  double root = 0.0;   // how far the root of a ridge is off
  double falls = 0.0;  // what is lost of it below the smallest float
  const double strength = strength_of(kind, arguments);
  for (std::size_t i = 0; i < noise_errors.size(); ++i) {
    const double noise_error = noise_errors[i];
    if (kind == OctaveSum::ridged) {
      const double products = i > 0 ? 2.0 : 1.0;
      root = noise_error + kUnit + std::sqrt(2.0) * root + products * kUnit * (1.0 + kUnit) / 2.0;
      falls = 2.0 * falls + products * 2.0 * kTiny;
      terms.errors.push_back(std::min(2.0 * root + falls, 1.0));
      terms.limit = 1.0;
    } else if (kind == OctaveSum::ping_pong) {
      const double before = strength * (noise_error + kUnit * (2.0 + noise_error));
      const double wave = before + 2.0 * (kUnit * (2.0 * strength + before) + kTiny);
      terms.errors.push_back(std::min(2.0 * wave + kUnit * (1.0 + 2.0 * wave), 2.001));
      terms.limit = 1.001;
    } else {
      terms.errors.push_back(noise_error);
    }
  }
  return terms;
}

// Of clamp(3/2 - footprint * max(lacunarity, 1)^i, 0, 1).
double fade_error(std::size_t i) {
  return 1.501 * (std::pow(1.0 + kUnit, static_cast<double>(i)) - 1.0) + 1.001 * kUnit + 2.0 * kTiny;
}

// The total of a detail's weights.
double detail_total(const OctaveArguments& arguments) {
  double total = 0.0;
  const int count = count_of(arguments);
  for (int i = 0; i < count; ++i) {
    const double part = i > 0 && i == count - 1 ? arguments.octaves - i : 1.0;
    total += std::pow(arguments.gain, i) * part;
  }
  return total;
}

// Of the mean of the octaves.
double mean_error(OctaveSum kind, const OctaveArguments& arguments, double noise_limit, const Errors& noise_errors) {
  const auto [term_errors, limit] = terms_of(kind, arguments, noise_limit, noise_errors);
  const double strength = strength_of(kind, arguments);
  const double gain = arguments.gain;
  double amplitude = 1.0;
  double amplitude_error = 0.0;
  double total = 0.0;
  double total_error = 0.0;
  double sum_error = 0.0;
  for (std::size_t i = 0; i < noise_errors.size(); ++i) {
    double used_error = amplitude_error;
    const double most_amplitude = amplitude + amplitude_error;
    if (arguments.footprint) used_error += most_amplitude * (fade_error(i) + kUnit) + kTiny;
    if (arguments.is_detail) used_error += kUnit * most_amplitude + kTiny;
    sum_error += (amplitude + used_error) * (term_errors[i] + kUnit * limit) + limit * used_error + kTiny;
    total_error = gain * (total_error + kUnit * (total + total_error)) + kTiny;
    total = 1.0 + gain * total;
    sum_error += kUnit * (limit * total + sum_error);
    total_error += kUnit * (total + total_error);
    amplitude_error = gain * (amplitude_error + kUnit * most_amplitude) + kTiny;
    amplitude *= gain;
    if (kind == OctaveSum::weighted) {
      const double factor_error = std::min(strength * (noise_errors[i] / 2.0 + 2.0 * kUnit) + kUnit, 1.0) + kTiny;
      const double most = amplitude + amplitude_error;
      amplitude_error =
          std::min(amplitude_error + amplitude * factor_error, most) + kUnit * most + (1.0 + gain) * kTiny;
    }
  }
  if (total > 0x1p126) return std::numeric_limits<double>::infinity();
  if (arguments.is_detail) {
    const double count = count_of(arguments);
    total = detail_total(arguments);
    total_error = total * (std::pow(1.0 + kUnit, 2.0 * count) - 1.0) + 2.0 * total * count * kTiny;
  }
  const double error = (sum_error + limit * total_error) / (total - total_error);
  return error + 2.5 * kUnit * (limit + error) + kTiny;
}

}  // namespace

double octave_tolerance(OctaveSum kind, int axes, const OctaveArguments& arguments, Gradient gradient) {
  const NoiseBounds& noise = noise_bounds("perlin", axes, gradient);
  const double limit = is_clamped(kind) ? std::min(noise.limit, 1.0) : noise.limit;
  Errors errors = position_errors(axes, arguments);
  for (double& error : errors) {
    error = std::min(noise.lipschitz * error + (arguments.from_cell ? noise.cell_error : noise.error), 2.0 * limit);
  }
  const double error = errors.empty() ? 0.0 : mean_error(kind, arguments, limit, errors);
  if (kind == OctaveSum::clouds) return 1.5 * (2.0 * error + kUnit) + 3.001 * kUnit;
  if (kind == OctaveSum::billow) return 2.0 * error + kUnit * (1.0 + 2.0 * error);
  return error;
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
