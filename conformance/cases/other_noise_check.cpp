// Octave sums over a noise that is constant: so the result follows from a few lines. Sums that cut off the noise
// of an octave at 1 and -1, or its slopes at 128 and -128, meet one beyond each of them, too.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <hashnoise/hashnoise.hpp>
#include <iterator>
#include <vector>

#include "cases/value_checks.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

using Vector = std::array<double, 3>;

// A noise that is constant, with slopes that do not follow from that.
struct Constant {
  double noise;
  Vector slopes;
};
constexpr Vector kConstantSlopes = {0.5, -0.25, 0.125};
// Slopes for a sum: all noises of the library that fit its loop are flatter. In HN_FIXED 64 times as much just fits.
constexpr Vector kSteepSlopes = {-50.5, 30.25, 16.125};
// HN_FIXED cuts these off, and then 18 times as much just fits.
constexpr Vector kCutSlopes = {-200.5, 150.25, 129.125};
constexpr double kGreatestSlope = 128.0;

struct ConstantSum {
  OctaveSum kind;
  int axes;
  bool rotates;
  int octaves;
  double lacunarity;
  double gain;
  double strength;
  double amplitude;
  Constant constant;
};

// The rotation between two octaves, of a column and, transposed, of a row.
Vector rotated(const ConstantSum& sum, Vector v) {
  if (!sum.rotates) return v;
  v = {(25 * v[0] - 20 * v[1]) / 32, (20 * v[0] + 25 * v[1]) / 32, v[2]};
  if (sum.axes == 3) v = {v[0], (29 * v[1] - 13 * v[2]) / 32, (13 * v[1] + 29 * v[2]) / 32};
  return v;
}
Vector rotated_back(const ConstantSum& sum, Vector v) {
  if (!sum.rotates) return v;
  if (sum.axes == 3) v = {v[0], (29 * v[1] + 13 * v[2]) / 32, (-13 * v[1] + 29 * v[2]) / 32};
  return {(25 * v[0] + 20 * v[1]) / 32, (-20 * v[0] + 25 * v[1]) / 32, v[2]};
}

// A mean of a constant noise that falls with the slopes of the octaves.
double eroded_constant_noise(const ConstantSum& sum) {
  double mean = 0.0;
  double total = 0.0;
  double weight = 1.0;
  Vector fall = {};
  for (int i = 0; i < sum.octaves; ++i) {
    fall = rotated(sum, fall);
    double square = 0.0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(std::min(sum.axes, 3)); ++axis) {
      fall[axis] = std::clamp(fall[axis] + sum.constant.slopes[axis], -8.0, 8.0);
      square += fall[axis] * fall[axis];
    }
    mean += weight * sum.constant.noise / (1.0 + std::clamp(sum.strength, 0.0, 16.0) * square);
    total += weight;
    weight *= sum.gain;
  }
  return total > 0.0 ? mean / total : 0.0;
}

// Adds octaves by the functions of the header. Golden files verify these: here each fractal has to do with any noise,
// on the driver, the same as with its own.
double sum_of_constant_noise(const ConstantSum& sum) {
  const auto strength = static_cast<float>(sum.strength);
  const auto n = static_cast<float>(sum.constant.noise);
  hashnoise::hn_i_octave_sum s = hashnoise::hn_i_empty_sum(sum.octaves, static_cast<float>(sum.gain));
  const auto of_steps = [&](const auto& step, const auto& end) {
    for (int i = 0; i < sum.octaves; ++i) {
      s = step();
      s.weight *= s.gain;
      ++s.at;
    }
    return static_cast<double>(end(hashnoise::hn_i_mean(s)));
  };
  switch (sum.kind) {
    using namespace hashnoise;  // NOLINT(google-build-using-namespace): the steps are written without it
#define OCTAVE_STEP(name, step, end) \
  case OctaveSum::name:              \
    return of_steps([&] { return step; }, [](float mean) { return end; });
#include "library/sums.inc"
    case OctaveSum::fbm_d:
      return sum.octaves > 0 ? sum.constant.noise : 0.0;
    case OctaveSum::eroded:
      return eroded_constant_noise(sum);
    case OctaveSum::warp:
    case OctaveSum::warp_progressive:
      return sum.octaves > 0 ? std::clamp(sum.amplitude, 0.0, 64.0) * sum.constant.noise : 0.0;
  }
  return 0.0;
}

// Whether cutting off the noise of an octave at 1 and -1 shows: at these the value of other sums is at its own ends, to
// which their mean is cut off as well.
bool cut_shows(OctaveSum kind, double noise) {
  const auto of_noise = [&](double constant) {
    constexpr double kSomeStrength = 0.75;
    return sum_of_constant_noise({kind, 1, true, 1, 2.0, 0.5, kSomeStrength, 1.0, {constant, kConstantSlopes}});
  };
  return of_noise(noise) == of_noise(std::copysign(1.0, noise)) && std::fabs(of_noise(noise)) != 1.0;
}

// The constants that the sum cuts off, and it shows.
std::vector<Constant> constants_cut_off(const Function& function, Arithmetic arithmetic) {
  if (function.has_slopes()) {
    if (arithmetic != Arithmetic::fixed) return {};
    return {{-0.5, kCutSlopes}};
  }
  const OctaveSum kind = octave_sum_of(function);
  if (!cut_shows(kind, 1.25) && !cut_shows(kind, -1.25)) return {};
  return {{1.25, kConstantSlopes}, {-1.25, kConstantSlopes}};
}

std::vector<Constant> constants_of(const Function& function, Arithmetic arithmetic) {
  std::vector<Constant> constants = {{-0.5, function.has_slopes() ? kSteepSlopes : kConstantSlopes}};
  std::ranges::copy(constants_cut_off(function, arithmetic), std::back_inserter(constants));
  return constants;
}

// The derivatives, and how far a result may be from them: an octave multiplies the slopes by numbers that are rounded
// to 2^-18. llvmpipe had less than half of that.
struct Slopes {
  Vector values;
  double allowed;
};
constexpr double kErrorOfGrowth = 4.3 * 0x1p-18;

Slopes slopes_of_constant_noise(const ConstantSum& sum) {
  Vector v = sum.constant.slopes;
  for (double& along : v) along = std::clamp(along, -kGreatestSlope, kGreatestSlope);
  if (sum.axes == 2) v[2] = 0.0;
  const double length = std::hypot(v[0], v[1], v[2]);
  Vector slopes = {};
  double total = 0.0;
  double growths = 0.0;
  for (int i = 0; i < sum.octaves; ++i) {
    const double growth = std::pow(sum.gain * sum.lacunarity, i);
    for (std::size_t axis = 0; axis < v.size(); ++axis) slopes[axis] += growth * v[axis];
    total += std::pow(sum.gain, i);
    growths += growth;
    v = rotated_back(sum, v);
  }
  for (double& slope : slopes) slope = total > 0.0 ? slope / total : 0.0;
  return {slopes, kErrorOfGrowth * length * (1.0 + growths)};
}

// A few roundings of sum and total. In integers the other terms of an octave are rounded to 2^-18, and the slopes of an
// erosion to 2^-12: rotations make up to 11 of that in space, where a factor changes by up to 2.6 of it. All of it
// counts as often as the amplitude in a displacement.
double tolerance_of_constant_noise(const ConstantSum& sum, const Configuration& configuration) {
  using enum OctaveSum;
  const bool plain = sum.kind == fbm || sum.kind == turbulence || sum.kind == clouds || sum.kind == fbm_d;
  if (sum.kind == eroded && configuration.arithmetic == Arithmetic::fixed) return 4e-3;
  if (sum.kind == warp || sum.kind == warp_progressive) return 2e-6 + 4e-6 * std::clamp(sum.amplitude, 0.0, 64.0);
  return plain ? 2e-6 : 2e-5;
}

// How far a coordinate of the place's position is outside of its cell: 0, or hn_position is wrong. Far out a float has
// no fraction.
constexpr std::string_view kOutside =
    "HN_FN hn_float outside(hn_float x, hn_int cell) {\n"
    "  return abs(float(cell)) < 1000000.0f ? max(abs(x - float(cell) - 0.5f) - 0.5f, 0.0f) : 0.0f;\n"
    "}\n";

// Gives the library's sum a constant noise in place of its own.
std::string with_constant_noise(const Function& function, const Constant& constant) {
  const int axes = function.axes;
  const std::string_view noise = noise_of(octave_sum_of(function));
  std::string value = fmt::format("{:.2f}f", constant.noise);
  for (const char axis : std::string_view("xyzw").substr(0, static_cast<std::size_t>(axes))) {
    const std::string component = axes == 1 ? "" : fmt::format(".{}", axis);
    value += fmt::format(" + outside(hn_position(place){0}, place.cell{0})", component);
  }
  std::string type = "hn_float";
  if (noise == "perlin_d") {
    type = fmt::format("hn_vec{}", axes + 1);
    value = fmt::format("vec{}({}", axes + 1, value);
    for (const double slope : std::span(constant.slopes).first(static_cast<std::size_t>(axes))) {
      value += fmt::format(", {:.3f}f", slope);
    }
    value += ")";
  } else if (noise.ends_with("_vector")) {
    type = fmt::format("hn_vec{}", axes);
    value = fmt::format("vec{}({})", axes, value);
  }
  return fmt::format(
      "#include \"{0}{1}d.glsl\"\n{2}"
      "HN_FN {3} constant_noise(hn_place{1} place, hn_uint seed) {{ return {4}; }}\n"
      "#define hn_{0} constant_noise\n"
      "#include \"{5}\"\n",
      noise, axes, kOutside, type, value, function.file);
}

// The octaves that count, the last of a detail only in part: over a constant noise that changes nothing. From a cell
// and with a period the library rounds the lacunarity.
ConstantSum settings_of(const Function& function, std::span<const std::uint32_t> inputs, const Constant& constant) {
  const auto word = [&](std::string_view name) { return inputs[static_cast<std::size_t>(function.input(name))]; };
  const auto number = [&](std::string_view name) { return number_of(word(name)); };
  const auto octaves_of = [](double detail) { return detail < 0x1p-32 ? 0 : static_cast<int>(std::ceil(detail)); };
  const int octaves =
      function.takes_detail() ? octaves_of(number("detail")) : static_cast<std::int32_t>(word("octaves"));
  double lacunarity = number("lacunarity");
  if (function.takes_cell() || function.takes_period()) lacunarity = std::clamp(lacunarity, 0.0, 255.0);
  if (function.takes_period()) lacunarity = std::floor(lacunarity);
  return {octave_sum_of(function),
          function.axes,
          !function.takes_period(),
          octaves,
          lacunarity,
          number("gain"),
          function.takes_strength() ? number("strength") : 0.0,
          function.takes_amplitude() ? number("amplitude") : 0.0,
          constant};
}

// Keeps octaves from getting steeper, so that steep slopes fit their sum.
void flatten(const Function& function, Words& inputs) {
  const auto gain = static_cast<std::size_t>(function.input("gain"));
  const auto lacunarity = static_cast<std::size_t>(function.input("lacunarity"));
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    const float steepest = 0.9f / std::max(std::bit_cast<float>(inputs[i + lacunarity]), 1.0f);
    const float weaker = std::min(std::bit_cast<float>(inputs[i + gain]), steepest);
    inputs[i + gain] = std::bit_cast<std::uint32_t>(weaker);
  }
}

void compare(Comparison& comparison, const Evaluation& evaluation, const Constant& constant,
             std::span<const std::uint32_t> inputs, std::span<const std::uint32_t> outputs) {
  const Function& function = evaluation.function;
  const ConstantSum sum = settings_of(function, inputs, constant);
  const Slopes slopes = function.has_slopes() ? slopes_of_constant_noise(sum) : Slopes{};
  for (std::size_t word = 0; word < function.outputs.size(); ++word) {
    const float got = std::bit_cast<float>(outputs[word]);
    if (function.is_slope(word)) {
      comparison.number(inputs, got, slopes.values[word - 1], slopes.allowed, word);  // the value comes first
    } else {
      comparison.number(inputs, got, sum_of_constant_noise(sum),
                        tolerance_of_constant_noise(sum, evaluation.configuration), word);
    }
  }
}

}  // namespace

bool cuts_noise_off(const Function& function, Arithmetic arithmetic) {
  return !constants_cut_off(function, arithmetic).empty();
}

// The sums of the library, over constant noises.
Judged check_other_noise(Session& session, const Evaluation& evaluation) {
  const auto& [function, configuration, profile, variant, stage] = evaluation;
  Words inputs = random_points(function, property_points(session, function), Random(session.seed, "other noise"));
  if (function.takes_footprint()) {  // that no octave fades
    const auto footprint = static_cast<std::size_t>(function.input("footprint"));
    for (std::size_t i = footprint; i < inputs.size(); i += kInputWords) inputs[i] = 0;
  }
  Comparison comparison(function, inputs);
  for (const Constant& constant : constants_of(function, configuration.arithmetic)) {
    if (constant.slopes == kCutSlopes) flatten(function, inputs);
    const std::string knobs = with_constant_noise(function, constant);
    HN_TRY(const auto outputs, evaluate(session, {function, configuration, profile, {.knobs = knobs}}, inputs));
    for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
      compare(comparison, evaluation, constant, point(inputs, i), result(outputs, i));
    }
  }
  return comparison.finish();
}

}  // namespace hn
