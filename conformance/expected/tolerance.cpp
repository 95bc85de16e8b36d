#include "expected/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "expected/cellular.hpp"
#include "roundings/sums.hpp"

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
};
const Bounds kBounds = [] {
  Bounds bounds{};
// INFINITY, the lipschitz of what jumps, is a float.
#define NOISE_BOUNDS(name, axes, gradient, cell_error, error, lipschitz, ...) \
  bounds.noise.push_back({name, axes, gradient, cell_error, error, static_cast<double>(lipschitz), __VA_ARGS__});
#define SLOPE_BOUNDS(...) bounds.slope.push_back({__VA_ARGS__});
#define SINE_BOUNDS(error, fixed_error) bounds.sine_error = error;
#define UNIFORM_BOUNDS(...) bounds.uniform = {__VA_ARGS__};
#include "expected/bounds.inc"
  return bounds;
}();

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

// --- Octave sums: the tolerance is twice as far as 16 roundings of the place are apart, and half of the bound of the
// noise (docs/measured/accuracy.md). The constants have a margin of 3 to what drivers do.
constexpr double kSpread = 2.0, kFloor = 0.5;

bool has_several_octaves(const Function& function, std::span<const std::uint32_t> inputs) {
  if (function.takes_detail()) return float_input(inputs, function.input("detail")) > 1.0;
  return static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]) > 1;
}

// Where several octaves are added up, the place of each lane is off by a unit, either way. Positions with few bits are
// exact in the order of the text, and drivers may compute in another; and the text cuts fractions to 2^-24, which no
// rounding shows.
void move_place(const Function& function, roundings::Words& words, std::uint32_t random) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(function.axes); ++axis) {
    const bool is_fraction = function.takes_cell();
    for (std::uint32_t& word : words[is_fraction ? axis + static_cast<std::size_t>(function.axes) : axis]) {
      random = random * 747796405u + 2891336453u;
      const bool up = random >> 31u != 0;
      const float x = std::bit_cast<float>(word);
      word = std::bit_cast<std::uint32_t>(is_fraction ? std::clamp(x + (up ? 0x1p-24f : -0x1p-24f), 0.0f, 1.0f)
                                                      : std::nextafter(x, up ? HUGE_VALF : -HUGE_VALF));
    }
  }
}

// How far the results of the lanes are apart.
double spread_of(const std::array<std::uint32_t, roundings::kLanes>& results) {
  float least = HUGE_VALF, greatest = -HUGE_VALF;
  for (const std::uint32_t word : results) {
    const float x = std::bit_cast<float>(word);
    least = std::min(least, x), greatest = std::max(greatest, x);
  }
  return static_cast<double>(greatest) - static_cast<double>(least);
}

std::array<double, kOutputWords> spreads_at(const Function& function, Gradient gradient,
                                            std::span<const std::uint32_t> inputs) {
  std::uint32_t seed = 0;
  for (const std::uint32_t word : inputs) seed = (seed ^ word) * 16777619u;
  roundings::Words words{};
  for (std::size_t i = 0; i < inputs.size(); ++i) words[i].fill(inputs[i]);
  if (has_several_octaves(function, inputs)) move_place(function, words, seed);
  const auto results = (gradient == Gradient::sine ? roundings::of_sine : roundings::of_octahedral)(function.id, words,
                                                                                                    seed ^ seed >> 15u);
  std::array<double, kOutputWords> spreads{};
  std::ranges::transform(results, spreads.begin(), spread_of);
  return spreads;
}

double octave_sum_tolerance(const Function& function, const Configuration& configuration,
                            std::span<const std::uint32_t> inputs, std::size_t output) {
  if (configuration.hash != default_configuration().hash) {
    throw std::logic_error(fmt::format("conformance/roundings has no sums with the hash of {}", configuration.name));
  }
  // Outputs of a point follow one another.
  struct Last {
    const Function* function = nullptr;
    Gradient gradient = {};
    std::vector<std::uint32_t> inputs;
    std::array<double, kOutputWords> spreads{};
  };
  thread_local Last last;
  if (last.function != &function || last.gradient != configuration.gradient ||
      !std::ranges::equal(last.inputs, inputs)) {
    last = {&function,
            configuration.gradient,
            {inputs.begin(), inputs.end()},
            spreads_at(function, configuration.gradient, inputs)};
  }
  double size = 1.0;
  for (const std::string_view factor : {"amplitude", "depth"}) {
    if (const int word = function.input(factor); word >= 0) size = std::fabs(float_input(inputs, word));
  }
  return kSpread * last.spreads[output] + kFloor * size * bounds_of(function, configuration, output).cell_error;
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
  if (function.is_octave_sum()) return octave_sum_tolerance(function, configuration, inputs, output);
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
