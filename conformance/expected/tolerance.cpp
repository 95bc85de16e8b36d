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
#include "sums/gullies.hpp"

namespace hn {
namespace {

// The words of bounds.inc.
constexpr std::optional<Gradient> octahedral = Gradient::octahedral;
constexpr std::optional<Gradient> sine = Gradient::sine;
[[maybe_unused]] constexpr std::optional<Gradient> none = std::nullopt;
struct UniformBounds {
  double value, slope, reach, coefficient;
  double fixed_value, fixed_slope, fixed_reach, fixed_coefficient;
};
struct Bounds {
  std::vector<NoiseBounds> noise;
  std::vector<NoiseBounds> slope;
  double sine_error;
  UniformBounds uniform;
  GulliesBounds gullies;
};
const Bounds kBounds = [] {
  Bounds bounds{};
#define NOISE_BOUNDS(...) bounds.noise.push_back({__VA_ARGS__});
#define SLOPE_BOUNDS(...) bounds.slope.push_back({__VA_ARGS__});
#define SINE_BOUNDS(error, fixed_error) bounds.sine_error = error;
#define UNIFORM_BOUNDS(...) bounds.uniform = {__VA_ARGS__};
#define GULLIES_BOUNDS(...) bounds.gullies = {__VA_ARGS__};
#include "expected/bounds.inc"
  return bounds;
}();

// The components of the shift between octaves (docs/reference/contract.md); 2D uses the first two.
constexpr std::array kShift = {11.0 / 32.0, 19.0 / 32.0, 23.0 / 32.0, 27.0 / 32.0};
// The rotations between octaves, in the plane of x and y, then in that of y and z, and then, by the numbers of the
// first, in that of z and w; they stretch, too. On the line nothing rotates.
constexpr double kCosine = 25.0 / 32.0;
constexpr double kSine = 20.0 / 32.0;
constexpr double kSecondCosine = 29.0 / 32.0;
constexpr double kSecondSine = 13.0 / 32.0;
constexpr double kWhole = 0x1p-24;  // the unit of fixed-point positions

constexpr std::string_view kPerlinWorley = "perlin_worley";

double float_input(std::span<const std::uint32_t> inputs, int word) {
  return static_cast<double>(std::bit_cast<float>(inputs[static_cast<std::size_t>(word)]));
}

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

// Whether float terms have an exact sum in any order: all are multiples of a power of two, and a float holds as many of
// these as the magnitudes sum to.
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
bool rotation_is_exact(double a, double x, double b, double y, double shift, double& result) {
  const std::array terms = {a * x, b * y, shift};
  result = terms[0] + terms[1] + terms[2];
  return is_exact_sum(terms);
}

// The next octave's position, if every step to it is exact. But for the line it is rotated: in the plane of x and y,
// then in that of y and z, and then in that of z and w.
bool next_is_exact(Position& q, std::size_t axes, double lacunarity) {
  if (axes == 1) return rotation_is_exact(q[0], lacunarity, 0.0, 0.0, kShift[0], q[0]);
  const double c = lacunarity * kCosine;
  const double s = lacunarity * kSine;
  if (!is_float(c) || !is_float(s)) return false;
  const auto [x, y, z, w] = q;
  if (!rotation_is_exact(c, x, -s, y, kShift[0], q[0])) return false;
  if (axes == 2) return rotation_is_exact(s, x, c, y, kShift[1], q[1]);
  const double second_c = lacunarity * kSecondCosine;
  const double second_s = lacunarity * kSecondSine;
  if (!is_float(second_c) || !is_float(second_s)) return false;
  double v = 0.0;
  if (!rotation_is_exact(s, x, c, y, 0.0, v) || !rotation_is_exact(kSecondCosine, v, -second_s, z, kShift[1], q[1])) {
    return false;
  }
  if (axes == 3) return rotation_is_exact(kSecondSine, v, second_c, z, kShift[2], q[2]);
  double u = 0.0;
  return rotation_is_exact(kSecondSine, v, second_c, z, 0.0, u) &&
         rotation_is_exact(kCosine, u, -s, w, kShift[2], q[2]) && rotation_is_exact(kSine, u, c, w, kShift[3], q[3]);
}

bool positions_are_exact(Position q, std::size_t axes, double octaves, double lacunarity) {
  for (int i = 1; i < std::min(octaves, 32.0); ++i) {
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

// The arguments of an octave sum. Gullies are as in a tile wherever they are.
OctaveArguments octave_arguments(const Function& function, std::span<const std::uint32_t> inputs) {
  const Start start = start_of(function, inputs);
  const auto input = [&](std::string_view name) { return float_input(inputs, function.input(name)); };
  double lacunarity = input("lacunarity");
  const bool tiled = function.takes_period() || function.is_gullies();
  const bool whole = function.takes_cell() || tiled;  // it starts from a place
  if (whole) lacunarity = std::clamp(lacunarity, 0.0, 255.0);
  if (tiled) lacunarity = std::floor(lacunarity);  // a tile stays a tile
  const double asked = function.takes_detail()
                           ? input("detail")
                           : static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  const double octaves = std::min(asked, 32.0);
  // A whole number times a whole lacunarity stays whole. A rotation that rounds down is counted, however little it is.
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
  arguments.rotates = !tiled;
  arguments.from_cell = whole;
  arguments.is_detail = function.takes_detail();
  return arguments;
}

double gullies_output_tolerance(const Function& function, std::span<const std::uint32_t> inputs, std::size_t output) {
  const auto slope = [&](std::string_view name) {
    return std::clamp(float_input(inputs, function.input(name)), -8.0, 8.0);
  };
  const GulliesTolerance found =
      gullies_tolerance({octave_arguments(function, inputs), std::hypot(slope("ex"), slope("ey")),
                         float_input(inputs, function.input("depth"))},
                        kBounds.gullies);
  return function.is_slope(output) ? found.slope : found.height;
}

double octave_sum_tolerance(const Function& function, Gradient gradient, std::span<const std::uint32_t> inputs,
                            std::size_t output) {
  if (function.is_gullies()) return gullies_output_tolerance(function, inputs, output);
  const OctaveArguments arguments = octave_arguments(function, inputs);
  if (function.bound == kPerlinWorley) return perlin_worley_tolerance(arguments);
  const OctaveSum kind = octave_sum_of(function);
  return function.is_slope(output) ? octave_slope_tolerance(kind, function.axes, arguments)
                                   : octave_tolerance(kind, function.axes, arguments, gradient);
}

// The tolerances of uniform values and of distributions of sums.
double distribution_tolerance(const Function& function, std::span<const std::uint32_t> inputs, std::size_t output) {
  const std::string_view name = function.outputs[output].name;
  const double reach = std::clamp(float_input(inputs, function.input("reach")), 0.0625, 3.0);
  if (name == "value") return kBounds.uniform.value;
  if (name == "slope") return kBounds.uniform.slope / reach;
  if (name == "reach") return kBounds.uniform.reach * reach;
  if (name == "a" || name == "b" || name == "c") return kBounds.uniform.coefficient;
  throw std::logic_error(fmt::format("{}: nothing is proven of its {}", function.id, name));
}

}  // namespace

const NoiseBounds& noise_bounds(std::string_view noise, int axes, Gradient gradient) {
  return bounds_in(kBounds.noise, noise, axes, gradient);
}

const NoiseBounds& slope_bounds(std::string_view noise, int axes, Gradient gradient) {
  return bounds_in(kBounds.slope, noise, axes, gradient);
}

namespace {

// The noise that an octave sum adds up; the first, of two.
std::string_view summed_noise(const Function& function) {
  if (function.is_gullies()) return "phasor_d";
  return function.bound == kPerlinWorley ? "perlin" : noise_of(octave_sum_of(function));
}

}  // namespace

const NoiseBounds& bounds_of(const Function& function, const Configuration& configuration, std::size_t output) {
  const auto& table = function.is_slope(output) ? kBounds.slope : kBounds.noise;
  if (function.is_octave_sum()) {
    return bounds_in(table, summed_noise(function), function.axes, configuration.gradient);
  }
  // A component of the vector to a point is as exact as the Manhattan distance, which contains it. For points that go
  // round it has the bound of their own.
  const bool is_part = function.is_cellular() && function.is_offset && !function.takes_phase();
  const std::string_view bound = is_part ? "cellular" : function.bound;
  return bounds_in(table, bound, function.axes, configuration.gradient);
}

double error_of(const Function& function, const Configuration& configuration, std::size_t output) {
  const NoiseBounds& bounds = bounds_of(function, configuration, output);
  switch (configuration.arithmetic) {
    case Arithmetic::fixed:
      return bounds.fixed_error;
    case Arithmetic::fast:
    case Arithmetic::precise:
      return function.starts_from_integers() ? bounds.cell_error : bounds.error;
  }
  throw std::logic_error(fmt::format("nothing is proven of {}", configuration.name));
}

namespace {

constexpr OctaveSumFacts kOctaveSums[] = {
#define OCTAVE_SUM(name, noise, most, least, greatest, bounded, step, mean) \
  {#name, #noise, most, least, greatest, bounded, {SumStep::step, SumMean::mean, most}},
#include "library/sums.inc"
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

namespace {

FloatBounds float_bounds(const NoiseBounds& bounds) {
  return {bounds.axes, bounds.cell_error, bounds.error, bounds.lipschitz, bounds.limit};
}

// The bounds of the derivative of a noise, if it has one, or of a vector's components.
FloatBounds float_slope_bounds(std::string_view noise, int axes) {
  constexpr std::string_view kVector = "_vector";
  if (noise.ends_with(kVector)) noise.remove_suffix(kVector.size());
  const std::string name = noise.ends_with("_d") ? std::string(noise) : fmt::format("{}_d", noise);
  return float_bounds(slope_bounds(name, axes, Gradient::octahedral));
}

}  // namespace

double octave_tolerance(OctaveSum kind, int axes, const OctaveArguments& arguments, Gradient gradient,
                        std::string_view noise) {
  const OctaveSumFacts& facts = facts_of(kind);
  const FloatBounds bounds = float_bounds(noise_bounds(noise.empty() ? facts.noise : noise, axes, gradient));
  if (!has_jacobian(facts.rule.step)) return octave_tolerance(facts.rule, arguments, bounds, {});
  return octave_tolerance(facts.rule, arguments, bounds, float_slope_bounds(facts.noise, axes));
}

double octave_slope_tolerance(OctaveSum kind, int axes, const OctaveArguments& arguments) {
  const OctaveSumFacts& facts = facts_of(kind);
  return octave_slope_tolerance(facts.rule, arguments,
                                float_bounds(noise_bounds(facts.noise, axes, Gradient::octahedral)),
                                float_slope_bounds(facts.noise, axes));
}

//   billow = 1 - 2*distance;  P and B are means of octaves, at most 1;  value = 1 - (1 - P)*(1 - B)*0.25
//
// The distance is cellular_d's, at most 3/2. 1 - 2*distance rounds once, and so do 1 - P and 1 - B, which are at
// most 2, their product, and the difference from 1.
double perlin_worley_tolerance(OctaveArguments arguments) {
  constexpr double kUnit = 0x1p-23;
  const double wisps = std::min(octave_tolerance(OctaveSum::fbm, 3, arguments), 2.0);
  const NoiseBounds& distance = noise_bounds("cellular_d", 3, Gradient::octahedral);
  const FloatBounds billow{3, 2.0 * distance.cell_error + kUnit, 2.0 * distance.error + kUnit, 2.0 * distance.lipschitz,
                           2.0 * distance.limit - 1.0};
  arguments.octaves = std::min(arguments.octaves, 3.0);
  const double billows = std::min(octave_tolerance(facts_of(OctaveSum::fbm).rule, arguments, billow, {}), 2.0);
  return std::min(wisps / 2.0 + billows / 2.0 + wisps * billows / 4.0 + 3.001 * kUnit, 1.0);
}

double tolerance(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs,
                 std::size_t output) {
  if (has_exact_values(function, configuration)) return 0.0;
  if (function.family == Family::sine_gradient) return kBounds.sine_error;
  if (function.is_octave_sum()) {
    return octave_sum_tolerance(function, configuration.gradient, inputs, output);
  }
  if (function.is_cellular()) return cellular_tolerance(function, configuration, inputs, output);
  if (function.family == Family::distribution) return distribution_tolerance(function, inputs, output);
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
