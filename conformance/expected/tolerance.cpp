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

constexpr double kUnit = 0x1p-23;     // the largest relative error of one operation, in any rounding mode
constexpr double kTiny = 0x1p-126;    // the largest error of flushing a subnormal to 0
constexpr double kSettled = 0x1p-96;  // below which HN_PRECISE makes a result 0
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
constexpr std::array kShift = {11.0 / 32.0, 19.0 / 32.0, 23.0 / 32.0, 27.0 / 32.0};
// The turns between octaves, in the plane of x and y, then in that of y and z, and then, by the numbers of the first,
// in that of z and w; they stretch, too. On the line nothing turns.
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

using Position = std::array<double, 4>;

// One coordinate of a turn, a*x + b*y + shift. Products of two floats are exact in a double. Whether the result is,
// too.
bool turn_is_exact(double a, double x, double b, double y, double shift, double& result) {
  const std::array terms = {a * x, b * y, shift};
  result = terms[0] + terms[1] + terms[2];
  return is_exact_sum(terms);
}

// The next octave's position, if every step to it is exact. But for the line it is turned: in the plane of x and y,
// then in that of y and z, and then in that of z and w.
bool next_is_exact(Position& q, std::size_t axes, double lacunarity) {
  if (axes == 1) return turn_is_exact(q[0], lacunarity, 0.0, 0.0, kShift[0], q[0]);
  const double c = lacunarity * kCosine;
  const double s = lacunarity * kSine;
  if (!is_float(c) || !is_float(s)) return false;
  const auto [x, y, z, w] = q;
  if (!turn_is_exact(c, x, -s, y, kShift[0], q[0])) return false;
  if (axes == 2) return turn_is_exact(s, x, c, y, kShift[1], q[1]);
  const double second_c = lacunarity * kSecondCosine;
  const double second_s = lacunarity * kSecondSine;
  if (!is_float(second_c) || !is_float(second_s)) return false;
  double v = 0.0;
  if (!turn_is_exact(s, x, c, y, 0.0, v) || !turn_is_exact(kSecondCosine, v, -second_s, z, kShift[1], q[1])) {
    return false;
  }
  if (axes == 3) return turn_is_exact(kSecondSine, v, second_c, z, kShift[2], q[2]);
  double u = 0.0;
  return turn_is_exact(kSecondSine, v, second_c, z, 0.0, u) && turn_is_exact(kCosine, u, -s, w, kShift[2], q[2]) &&
         turn_is_exact(kSine, u, c, w, kShift[3], q[3]);
}

bool positions_are_exact(Position q, std::size_t axes, double octaves, double lacunarity) {
  for (int i = 1; i < octaves; ++i) {
    if (!next_is_exact(q, axes, lacunarity)) return false;
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
      start.exact = start.exact && std::fmod(coordinate, kWhole) == 0.0;
      continue;
    }
    const double fraction = std::clamp(float_input(inputs, function.axes + axis), 0.0, 1.0);
    start.exact = start.exact && std::fmod(fraction, kWhole) == 0.0;
    coordinate = static_cast<double>(static_cast<std::int32_t>(inputs[static_cast<std::size_t>(axis)])) + fraction;
  }
  return start;
}

double octave_sum_tolerance(const Function& function, Gradient gradient, std::span<const std::uint32_t> inputs,
                            std::size_t output) {
  const Start start = start_of(function, inputs);
  const auto input = [&](std::string_view name) { return float_input(inputs, function.input(name)); };
  double lacunarity = input("lacunarity");
  const bool tiled = function.takes_period();
  const bool whole = function.takes_cell() || tiled;  // it starts from a place
  if (whole) lacunarity = std::clamp(lacunarity, 0.0, 255.0);
  if (tiled) lacunarity = std::floor(lacunarity);  // a tile stays a tile
  const auto octaves = function.takes_detail()
                           ? input("detail")
                           : static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  // A whole number of whole lacunarity stays one. What a turn rounds down is counted, however little it is.
  const bool exact =
      whole ? start.exact && tiled
            : positions_are_exact(start.position, static_cast<std::size_t>(function.axes), octaves, lacunarity);
  OctaveArguments arguments{0.0, octaves, lacunarity, input("gain"), exact};
  for (const double coordinate : start.position) {
    arguments.largest_coordinate = std::max(arguments.largest_coordinate, std::fabs(coordinate));
  }
  if (function.takes_strength()) arguments.strength = input("strength");
  if (function.takes_amplitude()) arguments.amplitude = input("amplitude");
  if (function.takes_footprint()) arguments.footprint = input("footprint");
  arguments.turns = !tiled;
  arguments.from_cell = whole;
  arguments.is_detail = function.takes_detail();
  return function.is_slope(output) ? octave_slope_tolerance(function.axes, arguments)
                                   : octave_tolerance(octave_sum_of(function), function.axes, arguments, gradient);
}

}  // namespace

const NoiseBounds& noise_bounds(std::string_view noise, int axes, Gradient gradient) {
  return bounds_in(kNoiseBounds, noise, axes, gradient);
}

const NoiseBounds& slope_bounds(std::string_view noise, int axes, Gradient gradient) {
  return bounds_in(kSlopeBounds, noise, axes, gradient);
}

const NoiseBounds& bounds_of(const Function& function, const Configuration& configuration, std::size_t output) {
  const auto& table = function.is_slope(output) ? kSlopeBounds : kNoiseBounds;
  if (function.is_octave_sum()) {
    return bounds_in(table, noise_of(octave_sum_of(function)), function.axes, configuration.gradient);
  }
  // A component of the vector to a point is as exact as the Manhattan distance, of which it is a part.
  const std::string_view bound = function.is_cellular() && function.is_offset(output) ? "cellular" : function.bound;
  return bounds_in(table, bound, function.axes, configuration.gradient);
}

double error_of(const Function& function, const Configuration& configuration, std::size_t output) {
  const NoiseBounds& bounds = bounds_of(function, configuration, output);
  if (configuration.arithmetic == Arithmetic::fixed) return bounds.fixed_error;
  return function.starts_from_integers() ? bounds.cell_error : bounds.error;
}

namespace {

constexpr OctaveSumFacts kOctaveSums[] = {
#define OCTAVE_SUM(name, noise, most, least, greatest, bounded) {#name, #noise, most, least, greatest, bounded},
#include "library/facts.inc"
};

}  // namespace

const OctaveSumFacts& facts_of(OctaveSum sum) { return kOctaveSums[static_cast<std::size_t>(sum)]; }

std::optional<OctaveSum> octave_sum_named(std::string_view name) {
  const auto* const found = std::ranges::find(kOctaveSums, name, &OctaveSumFacts::name);
  if (found == std::end(kOctaveSums)) return std::nullopt;
  return static_cast<OctaveSum>(found - kOctaveSums);
}

OctaveSum octave_sum_of(const Function& function) {
  if (const std::optional<OctaveSum> sum = octave_sum_named(function.bound)) return *sum;
  throw std::logic_error(fmt::format("{}: '{}' is not an octave sum", function.id, function.bound));
}

// What follows is in tools/lib/bounds/sums.py and frames.py, with the reasons.
namespace {

// A noise beyond [-1, 1] counts as the nearer end.
bool is_clamped(OctaveSum kind) {
  using enum OctaveSum;
  return kind == billow || kind == ridged || kind == hybrid || kind == ping_pong || kind == weighted || kind == warp ||
         kind == warp_progressive;
}

int count_of(const OctaveArguments& arguments) {
  return arguments.octaves < 0x1p-32 ? 0 : static_cast<int>(std::ceil(arguments.octaves));
}

double strength_of(OctaveSum kind, const OctaveArguments& arguments) {
  return std::clamp(arguments.strength, 0.0, facts_of(kind).most_strength);
}

double amplitude_of(const OctaveArguments& arguments) { return std::clamp(arguments.amplitude, 0.0, 64.0); }

bool turns(int axes, const OctaveArguments& arguments) { return arguments.turns && axes > 1; }

// How far each octave's position may be off.
using Errors = std::vector<double>;

// Where an octave is: how far from the origin at most, and by how much its position may be off. With turns these are
// lengths; without, each coordinate is bounded on its own.
struct Whereabouts {
  double position;
  double error;
};

// How much longer a vector can be than its largest coordinate, where lengths are bounded.
double diagonal_of(int axes, const OctaveArguments& arguments) {
  return turns(axes, arguments) ? std::sqrt(axes) : 1.0;
}

// What the turns between two octaves make of a length: the first and the third stretch it, the second does not.
const double kStretch = std::hypot(kCosine, kSine);
double stretch_of(int axes, const OctaveArguments& arguments) {
  if (!turns(axes, arguments)) return 1.0;
  return axes == 4 ? kStretch * kStretch : kStretch;
}

double largest_shift(int axes) { return kShift[static_cast<std::size_t>(axes) - 1]; }

// Relative, of so many operations.
double rounding_of(int operations) { return std::pow(1.0 + kUnit, operations) - 1.0; }

Whereabouts next_straight(int axes, const OctaveArguments& arguments, const Whereabouts& at) {
  const double lacunarity = std::fabs(arguments.lacunarity);
  const double product_error = lacunarity * (at.error + kUnit * (at.position + at.error) + kTiny) + kTiny;
  const double position = lacunarity * at.position + largest_shift(axes);
  return {position, product_error + kUnit * (position + product_error)};
}

Whereabouts next_turned(int axes, const OctaveArguments& arguments, const Whereabouts& at) {
  const double shift = largest_shift(axes);
  const double diagonal = std::sqrt(axes);
  const double stretch = std::fabs(arguments.lacunarity) * stretch_of(axes, arguments);
  const double reach = at.position + at.error;
  const double of_coordinate = rounding_of(2 * axes) * stretch * reach + kUnit * shift + kTiny * (4.0 * reach + 8.0);
  return {stretch * at.position + diagonal * shift, stretch * at.error + diagonal * of_coordinate};
}

Whereabouts next_whole(int axes, const OctaveArguments& arguments, const Whereabouts& at) {
  const double ratio = std::trunc(arguments.lacunarity * 0x1p23) / 0x1p23;
  const double diagonal = diagonal_of(axes, arguments);
  double error = ratio * at.error + (arguments.lacunarity - ratio) * at.position + diagonal * kWhole;
  for (int turn = 0; turns(axes, arguments) && turn < axes - 1; ++turn) {
    error = (turn % 2 == 0 ? kStretch : 1.0) * error + std::sqrt(2.0) * kWhole;
  }
  return {arguments.lacunarity * stretch_of(axes, arguments) * at.position + diagonal * largest_shift(axes), error};
}

Whereabouts first_octave(int axes, const OctaveArguments& arguments) {
  const double diagonal = diagonal_of(axes, arguments);
  return {diagonal * arguments.largest_coordinate,
          arguments.from_cell && !arguments.exact_positions ? diagonal * kWhole : 0.0};
}

Whereabouts next_octave(int axes, const OctaveArguments& arguments, const Whereabouts& at) {
  Whereabouts next = arguments.from_cell      ? next_whole(axes, arguments, at)
                     : turns(axes, arguments) ? next_turned(axes, arguments, at)
                                              : next_straight(axes, arguments, at);
  if (arguments.exact_positions) next.error = 0.0;
  return next;
}

Errors position_errors(int axes, const OctaveArguments& arguments) {
  Whereabouts at = first_octave(axes, arguments);
  Errors errors;
  for (int i = 0; i < count_of(arguments); ++i) {
    errors.push_back(at.error);
    at = next_octave(axes, arguments, at);
  }
  return errors;
}

// What an octave adds, before its weight: how far it may be off, and how large it can be.
struct Terms {
  Errors errors;
  double limit;
};

Terms terms_of(OctaveSum kind, const OctaveArguments& arguments, double limit, const Errors& noise_errors) {
  Terms terms{{}, limit};
  double root = 0.0;   // how far the root of a ridge is off, or a height
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
    } else if (kind == OctaveSum::hybrid) {
      const double of_product = i > 0 ? kUnit + kTiny : 0.0;
      root = noise_error / 2.0 + kUnit + 2.0 * root + of_product;
      terms.errors.push_back(std::min(root, 1.0));
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

// The total of the weights, octave by octave.
struct Total {
  double value = 0.0;
  double error = 0.0;

  void add_octave(double gain) {
    const double product_error = gain * (error + kUnit * (value + error)) + kTiny;
    value = 1.0 + gain * value;
    error = product_error + kUnit * (value + product_error);
  }
};

// Beyond, GLSL bounds no division.
constexpr double kLargestTotal = 0x1p126;

// Of the mean of the octaves. The weights of some sums have another factor up to 1, with errors of its own.
double mean_error(OctaveSum kind, const OctaveArguments& arguments, double noise_limit, const Errors& noise_errors,
                  const Errors& factor_errors = {}) {
  const auto [term_errors, limit] = terms_of(kind, arguments, noise_limit, noise_errors);
  const double strength = strength_of(kind, arguments);
  const double gain = arguments.gain;
  double amplitude = 1.0;
  double amplitude_error = 0.0;
  Total total;
  double sum_error = 0.0;
  for (std::size_t i = 0; i < noise_errors.size(); ++i) {
    double used_error = amplitude_error;
    const double most_amplitude = amplitude + amplitude_error;
    if (!factor_errors.empty()) used_error += most_amplitude * (factor_errors[i] + kUnit) + kTiny;
    if (arguments.is_detail) used_error += kUnit * most_amplitude + kTiny;
    sum_error += (amplitude + used_error) * (term_errors[i] + kUnit * limit) + limit * used_error + kTiny;
    total.add_octave(gain);
    sum_error += kUnit * (limit * total.value + sum_error);
    amplitude_error = gain * (amplitude_error + kUnit * most_amplitude) + kTiny;
    amplitude *= gain;
    if (kind == OctaveSum::weighted) {
      const double factor_error = std::min(strength * (noise_errors[i] / 2.0 + 2.0 * kUnit) + kUnit, 1.0) + kTiny;
      const double most = amplitude + amplitude_error;
      amplitude_error =
          std::min(amplitude_error + amplitude * factor_error, most) + kUnit * most + (1.0 + gain) * kTiny;
    }
  }
  if (total.value > kLargestTotal) return std::numeric_limits<double>::infinity();
  if (arguments.is_detail) {
    const int count = count_of(arguments);
    total.value = detail_total(arguments);
    total.error = total.value * rounding_of(2 * count) + 2.0 * total.value * count * kTiny;
  }
  const double error = (sum_error + limit * total.error) / (total.value - total.error);
  return error + 2.5 * kUnit * (limit + error) + kTiny;
}

// --- Slopes and shifts ---
//
// A frame takes a small step of the position to one of an octave's position, times the octave's weight. It is gain *
// lacunarity to the power of the octave, times turns. So its columns have that length, but for what turns stretch, and
// no vector becomes longer by more. Without turns each axis is on its own, and lengths are those of coordinates.

// GLSL bounds the error of a division only for divisors up to 2^126, and no number of a frame may overflow.
bool in_domain(const OctaveArguments& arguments) {
  Total total;
  for (int i = 0; i < count_of(arguments); ++i) total.add_octave(arguments.gain);
  const double growth = std::fabs(arguments.gain * arguments.lacunarity);
  return total.value <= kLargestTotal && std::pow(growth, std::max(count_of(arguments) - 1, 0)) <= 0x1p96;
}

struct Frame {
  double length = 1.0;  // of a column, and how much longer a vector becomes
  double error = 0.0;   // of a column, as a length
};

// A number goes through 2 n operations, as the coordinate of a position does, of terms whose magnitudes sum to no more
// than the stretched length: the growth, the product with it, and a product and a sum for each of the turns. From a
// cell the positions have the lacunarity that is cut to 2^-23.
Frame next_frame(int axes, const OctaveArguments& arguments, const Frame& frame) {
  const double growth = arguments.gain * std::fabs(arguments.lacunarity) * stretch_of(axes, arguments);
  const double reach = frame.length + frame.error;
  double of_number = rounding_of(2 * axes) * growth * reach + kTiny * (4.0 * reach + 8.0);
  if (arguments.from_cell) {
    const double ratio = std::trunc(arguments.lacunarity * 0x1p23) / 0x1p23;
    of_number += arguments.gain * (arguments.lacunarity - ratio) * stretch_of(axes, arguments) * reach;
  }
  return {growth * frame.length, growth * frame.error + diagonal_of(axes, arguments) * of_number};
}

// Components of at most m whose magnitudes have a sum of at most L have the largest length where as many as can be are
// m, and one is the rest.
double longest_gradient(const NoiseBounds& noise, const NoiseBounds& slope) {
  const double full = std::floor(noise.lipschitz / slope.limit);
  const double rest = noise.lipschitz - full * slope.limit;
  return std::min(std::hypot(std::sqrt(full) * slope.limit, rest), std::sqrt(noise.axes) * slope.limit);
}

// How fast a noise changes: with a length, or with the largest coordinate.
double steepest(const OctaveArguments& arguments, const NoiseBounds& noise, const NoiseBounds& slope) {
  return turns(noise.axes, arguments) ? longest_gradient(noise, slope) : noise.lipschitz;
}

// Of a noise, or a component of its derivative, at a position that is off.
double error_at(const OctaveArguments& arguments, const NoiseBounds& bounds, double lipschitz, double limit,
                double position_error) {
  // A noise that jumps is as good as any only where its position is exact.
  const double of_position = position_error > 0.0 ? lipschitz * position_error : 0.0;
  return std::min(of_position + (arguments.from_cell ? bounds.cell_error : bounds.error), 2.0 * limit);
}

Errors errors_at(const OctaveArguments& arguments, const NoiseBounds& bounds, double lipschitz, double limit) {
  Errors errors = position_errors(bounds.axes, arguments);
  for (double& error : errors) error = error_at(arguments, bounds, lipschitz, limit, error);
  return errors;
}

// The largest slope of 1 / (1 + strength r^2) for r up to `reach`: it is steepest where strength r^2 = 1/3.
double steepest_fall(double strength, double reach) {
  const double r = strength > 0.0 ? std::min(reach, 1.0 / std::sqrt(3.0 * strength)) : reach;
  const double divisor = 1.0 + strength * r * r;
  return 2.0 * strength * r / (divisor * divisor);
}

// Of the factors 1 / (1 + strength |e|^2), and of their products with the weights. A coordinate goes through 2 (n - 1)
// operations in the turns, and one more. A clamp brings no two vectors further apart. The divisor goes through n + 2
// operations of terms that are not negative.
Errors fall_errors(int axes, const OctaveArguments& arguments, const NoiseBounds& noise, const NoiseBounds& slope) {
  const double strength = strength_of(OctaveSum::eroded, arguments);
  const double diagonal = std::sqrt(axes);
  const double ends = 8.0 * diagonal;
  const double longest = longest_gradient(noise, slope);
  const double stretch = stretch_of(axes, arguments);
  const double rounding = turns(axes, arguments) ? rounding_of(2 * (axes - 1)) : 0.0;
  const double of_factor = rounding_of(axes + 2) + 3.5 * kUnit + 1000.0 * kTiny;
  double error = 0.0;
  double reach = 0.0;
  Errors errors;
  for (const double slope_error : errors_at(arguments, slope, slope.lipschitz, slope.limit)) {
    error = stretch * error + diagonal * (rounding * stretch * (reach + error) + 8.0 * kTiny);
    error += diagonal * slope_error;
    error = std::min(error + kUnit * (stretch * reach + longest + error) + diagonal * kTiny, 2.0 * ends);
    reach = std::min(stretch * reach + longest, ends);
    errors.push_back(std::min(steepest_fall(strength, ends) * error + of_factor, 1.001));
  }
  return errors;
}

// A mean of n / (1 + strength |e|^2).
double eroded_tolerance(int axes, const OctaveArguments& arguments) {
  const NoiseBounds& noise = noise_bounds("perlin_d", axes, Gradient::octahedral);
  const NoiseBounds& slope = slope_bounds("perlin_d", axes, Gradient::octahedral);
  Errors terms = errors_at(arguments, noise, steepest(arguments, noise, slope), noise.limit);
  const Errors falls = fall_errors(axes, arguments, noise, slope);
  for (std::size_t i = 0; i < terms.size(); ++i) terms[i] += noise.limit * falls[i];
  return mean_error(OctaveSum::eroded, arguments, noise.limit, terms);
}

// The errors of the noise of each octave of a progressive warp, of which no component is beyond 1. The position of an
// octave moves by amplitude / total times its frame times the vectors of noise. A coordinate of that goes through n
// operations; the error of the noise comes back through the position in this way. From a cell what a position moves by
// is cut to 2^-24, and so is its fraction. HN_PRECISE replaces a step below 2^-96 by 0.
Errors progressive_errors(int axes, const OctaveArguments& arguments, const NoiseBounds& noise,
                          const NoiseBounds& slope) {
  const int count = count_of(arguments);
  const double diagonal = diagonal_of(axes, arguments);
  const double lipschitz = steepest(arguments, noise, slope);
  Total total;
  for (int i = 0; i < count; ++i) total.add_octave(arguments.gain);
  const double rate = amplitude_of(arguments) / total.value;
  double rate_error = rate * total.error / (total.value - total.error);
  rate_error += 2.5 * kUnit * (rate + rate_error) + kTiny;
  Whereabouts at = first_octave(axes, arguments);
  Frame frame;
  Errors errors;
  for (int i = 0; i < count; ++i) {
    errors.push_back(error_at(arguments, noise, lipschitz, 1.0, at.error));
    const double of_matrix = diagonal * frame.error;
    const double step = frame.length * diagonal;
    const double step_error = frame.length * diagonal * errors.back() + of_matrix * diagonal +
                              diagonal * rounding_of(axes) * (frame.length + of_matrix) * diagonal + 4.0 * axes * kTiny;
    const double moved = rate * step;
    double moved_error = rate * step_error + rate_error * (step + step_error);
    moved_error += kUnit * (moved + moved_error) + diagonal * kSettled;
    at.error += moved_error;
    at.error += arguments.from_cell ? 2.0 * diagonal * kWhole : kUnit * (at.position + moved + at.error);
    at.position += moved;
    at = next_octave(axes, arguments, at);
    frame = next_frame(axes, arguments, frame);
  }
  return errors;
}

// A mean that is no larger than 1, times the amplitude.
double shift_tolerance(OctaveSum kind, int axes, OctaveArguments arguments) {
  const NoiseBounds& noise = noise_bounds("value", axes, Gradient::octahedral);
  const NoiseBounds& slope = slope_bounds("value_d", axes, Gradient::octahedral);
  Errors errors;
  if (kind == OctaveSum::warp) {
    errors = errors_at(arguments, noise, steepest(arguments, noise, slope), 1.0);
  } else {
    arguments.exact_positions = false;  // of what moves, none is
    errors = progressive_errors(axes, arguments, noise, slope);
  }
  const double error = std::min(mean_error(kind, arguments, 1.0, errors), 2.0);
  return amplitude_of(arguments) * (error + kUnit) + kSettled + kTiny;
}

}  // namespace

// The sum of transposed frames times derivatives, divided by the total. The products of a column with a gradient have
// magnitudes whose sum is at most the product of lengths.
double octave_slope_tolerance(int axes, const OctaveArguments& arguments) {
  const NoiseBounds& noise = noise_bounds("perlin_d", axes, Gradient::octahedral);
  const NoiseBounds& slope = slope_bounds("perlin_d", axes, Gradient::octahedral);
  if (count_of(arguments) == 0) return 0.0;
  if (!in_domain(arguments)) return std::numeric_limits<double>::infinity();
  const double diagonal = diagonal_of(axes, arguments);
  const double longest = turns(axes, arguments) ? longest_gradient(noise, slope) : slope.limit;
  Frame frame;
  Total total;
  double largest = 0.0;
  double sum_error = 0.0;
  for (const double error : errors_at(arguments, slope, slope.lipschitz, slope.limit)) {
    const double reach = frame.length + frame.error;
    sum_error += reach * diagonal * error + frame.error * longest;
    sum_error += rounding_of(axes) * reach * (longest + diagonal * error) + 2.0 * axes * kTiny;
    largest += frame.length * longest;
    sum_error += kUnit * (largest + sum_error);
    total.add_octave(arguments.gain);
    frame = next_frame(axes, arguments, frame);
  }
  const double mean = largest / total.value;
  const double error = (sum_error + mean * total.error) / (total.value - total.error);
  return error + 2.5 * kUnit * (mean + error) + kSettled + kTiny;
}

double octave_tolerance(OctaveSum kind, int axes, const OctaveArguments& arguments, Gradient gradient) {
  using enum OctaveSum;
  if (count_of(arguments) == 0) {
    return kind == clouds ? 1.5 * kUnit + 3.001 * kUnit : kind == billow ? kUnit : 0.0;
  }
  const bool framed = kind == eroded || kind == warp || kind == warp_progressive;
  if (framed && !in_domain(arguments)) return std::numeric_limits<double>::infinity();
  if (kind == eroded) return eroded_tolerance(axes, arguments);
  if (framed) return shift_tolerance(kind, axes, arguments);
  const std::string_view name = arguments.noise.empty() ? noise_of(kind) : arguments.noise;
  const NoiseBounds& noise = noise_bounds(name, axes, gradient);
  const double limit = is_clamped(kind) ? std::min(noise.limit, 1.0) : noise.limit;
  const Errors errors = errors_at(arguments, noise, noise.lipschitz, limit);
  Errors factor_errors;
  for (std::size_t i = 0; arguments.footprint && i < errors.size(); ++i) factor_errors.push_back(fade_error(i));
  const double error = mean_error(kind, arguments, limit, errors, factor_errors);
  if (kind == clouds) return 1.5 * (2.0 * error + kUnit) + 3.001 * kUnit;
  if (kind == billow) return 2.0 * error + kUnit * (1.0 + 2.0 * error);
  return error;
}

double tolerance(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs,
                 std::size_t output) {
  if (has_exact_values(function, configuration)) return 0.0;
  if (function.family == Family::sine_gradient) return kSineError;
  if (function.is_octave_sum()) {
    return octave_sum_tolerance(function, configuration.gradient, inputs, output);
  }
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
