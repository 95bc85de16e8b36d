#include "expected/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "expected/cellular.hpp"
#include "sums/gullies.hpp"
#include "sums/sums.hpp"

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
// INFINITY, the lipschitz of what jumps, is a float.
#define NOISE_BOUNDS(name, axes, gradient, cell_error, error, lipschitz, ...) \
  bounds.noise.push_back({name, axes, gradient, cell_error, error, static_cast<double>(lipschitz), __VA_ARGS__});
#define SLOPE_BOUNDS(...) bounds.slope.push_back({__VA_ARGS__});
#define SINE_BOUNDS(error, fixed_error) bounds.sine_error = error;
#define UNIFORM_BOUNDS(...) bounds.uniform = {__VA_ARGS__};
#define GULLIES_BOUNDS(...) bounds.gullies = {__VA_ARGS__};
#include "expected/bounds.inc"
  return bounds;
}();

constexpr double kWhole = 0x1p-24;  // the unit of fixed-point positions

double float_input(std::span<const std::uint32_t> inputs, int word) {
  return static_cast<double>(std::bit_cast<float>(inputs[static_cast<std::size_t>(word)]));
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

GulliesTolerance gullies_tolerance(const Function& function, std::span<const std::uint32_t> inputs) {
  const auto input = [&](std::string_view name) { return float_input(inputs, function.input(name)); };
  const auto slope = [&](std::string_view name) { return std::clamp(input(name), -8.0, 8.0); };
  bool exact = true;
  for (int axis = 0; axis < function.axes; ++axis) {
    const double start = float_input(inputs, function.takes_cell() ? function.axes + axis : axis);
    exact = exact && std::fmod(function.takes_cell() ? std::clamp(start, 0.0, 1.0) : start, kWhole) == 0.0;
  }
  GulliesArguments arguments{};
  arguments.octaves = static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  arguments.lacunarity = std::floor(std::clamp(input("lacunarity"), 0.0, 255.0));
  arguments.gain = input("gain");
  arguments.exact_positions = exact;
  if (function.takes_footprint()) arguments.footprint = input("footprint");
  arguments.slope = std::hypot(slope("ex"), slope("ey"));
  arguments.depth = input("depth");
  return gullies_tolerance(arguments, kBounds.gullies);
}

sums::Summary summary_of(const NoiseBounds& bounds) { return {bounds.cell_error, bounds.lipschitz, bounds.limit}; }

sums::Noises noises_with(Gradient gradient) {
  const auto value = [&](std::string_view name, int axes) { return summary_of(noise_bounds(name, axes, gradient)); };
  const auto slope = [&](std::string_view name, int axes) { return summary_of(slope_bounds(name, axes, gradient)); };
  sums::Noises noises;
  const bool usual = gradient == Gradient::octahedral;
  for (std::size_t i = usual ? 1 : 2; i <= (usual ? 4 : 3); ++i) {
    const int axes = static_cast<int>(i);
    noises.perlin[i] = {axes, value("perlin", axes)};
  }
  for (std::size_t i = 2; i <= 3; ++i) {
    const int axes = static_cast<int>(i);
    if (usual) noises.perlin_d[i] = {axes, value("perlin", axes), slope("perlin_d", axes)};
    noises.value_vector[i] = {axes, value("value_vector", axes), slope("value_d", axes)};
    noises.curl[i] = {axes, value("curl", axes)};
    noises.curl_phase[i] = {axes, value("curl_phase", axes)};
  }
  noises.cellular_d[3] = {3, value("cellular_d", 3)};
  return noises;
}

double octave_sum_tolerance(const Function& function, Gradient gradient, std::span<const std::uint32_t> inputs,
                            std::size_t output) {
  static const sums::Noises kOctahedral = noises_with(Gradient::octahedral), kSine = noises_with(Gradient::sine);
  // Outputs of a point follow one another.
  struct Last {
    const Function* function = nullptr;
    Gradient gradient = {};
    std::vector<std::uint32_t> inputs;
    sums::Errors errors;
  };
  thread_local Last last;
  if (last.function != &function || last.gradient != gradient || !std::ranges::equal(last.inputs, inputs)) {
    last = {&function, gradient, {inputs.begin(), inputs.end()}, {}};
    last.errors = sums::errors_of(function.id, inputs, gradient == Gradient::sine ? kSine : kOctahedral);
  }
  return last.errors[output];
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
  if (function.is_sum_of_flows()) return function.takes_phase() ? "curl_phase" : "curl";
  return function.bound == "perlin_worley" ? "perlin" : noise_of(octave_sum_of(function));
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
#define OCTAVE_SUM(name, noise, most, least, greatest, bounded) {#name, #noise, most, least, greatest, bounded},
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

double tolerance(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs,
                 std::size_t output) {
  if (has_exact_values(function, configuration)) return 0.0;
  if (function.family == Family::sine_gradient) return kBounds.sine_error;
  if (function.is_gullies()) {
    const GulliesTolerance found = gullies_tolerance(function, inputs);
    return function.is_slope(output) ? found.slope : found.height;
  }
  if (function.is_octave_sum()) return octave_sum_tolerance(function, configuration.gradient, inputs, output);
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
