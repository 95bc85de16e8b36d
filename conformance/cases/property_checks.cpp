// Checks for properties: of every right implementation, whatever its values.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

#include "cases/value_checks.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"

namespace hn {

// How many random points a property is checked at: fewer where the function is costly, or the driver can do no more.
std::size_t property_points(const Session& session, const Function& function) {
  constexpr std::size_t kPropertyPoints = std::size_t{1} << 16;
  return std::min(function.is_costly() ? kPropertyPoints / 4 : kPropertyPoints, session.most_points);
}

namespace {

constexpr std::size_t kCorrelationPoints = std::size_t{1} << 14;  // fewer: a check evaluates them many times

struct Range {
  float low;
  float high;
};

// The largest value of an output that there can be, but for clouds.
double largest_of(const Function& function, const Configuration& configuration, std::size_t output) {
  if (function.family == Family::sine_gradient) return 1.0;
  // Octave sums take over the range of the noise. Roundings may take unscaled values beyond
  // (docs/measured/accuracy.md).
  const NoiseBounds& bounds = bounds_of(function, configuration, output);
  return configuration.arithmetic == Arithmetic::fixed ? bounds.fixed_limit : bounds.limit;
}

// The largest derivative of an octave sum: that of the noise along any direction, times what octaves grow by. Integers
// of a Jacobian that has grown too large wrap, but no derivative has more of them.
double largest_slope_of(const Function& function, const Configuration& configuration,
                        std::span<const std::uint32_t> inputs) {
  const bool fixed = configuration.arithmetic == Arithmetic::fixed;
  const double most_gain = fixed ? 1.0 : std::numeric_limits<double>::infinity();
  const double gain = std::clamp(number_of(function, inputs, "gain"), 0.0, most_gain);
  const double lacunarity = std::fabs(number_of(function, inputs, "lacunarity"));
  const double growth = gain * (fixed ? std::min(lacunarity, 255.0) : lacunarity);
  constexpr double kStretch = 1.001;
  const auto octaves = static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  double sum = 0.0;
  double total = 0.0;
  for (int i = 0; i < std::min(octaves, 32); ++i) {
    sum += std::pow(growth * kStretch, i);
    total += std::pow(gain, i);
  }
  if (total == 0.0) return 0.0;
  const std::size_t last = function.outputs.size() - 1;
  const double gradient = std::sqrt(function.axes) * largest_of(function, configuration, last);
  const double largest = 1.00001 * gradient * sum / total;
  return fixed && sum > 64.0 ? 4096.0 : largest;
}

// How much larger than a component of an octave one of a sum of flows may be, as the octaves are rotated back. On the
// plane the rotation of the last octave has stretched by 1.00049^31.
double largest_rotated(int axes) { return std::sqrt(axes) * (axes == 2 ? 1.016 : 1.00001); }

// The largest height, or addition to a slope whose ends are both cut off. Integers round down with each octave.
double largest_of_gullies(const Function& function, const Configuration& configuration,
                          std::span<const std::uint32_t> inputs, std::size_t output) {
  if (function.is_slope(output)) return 16.0;
  const bool fixed = configuration.arithmetic == Arithmetic::fixed;
  const double gain = number_of(function, inputs, "gain");
  const auto octaves = static_cast<std::int32_t>(inputs[static_cast<std::size_t>(function.input("octaves"))]);
  double total = 0.0;
  for (int i = 0; i < std::min(octaves, 32); ++i) {
    total += std::pow(fixed ? std::clamp(gain, 0.0, 1.0) : gain, i);
  }
  return 1.00001 * std::clamp(number_of(function, inputs, "depth"), 0.0, 8.0) * total + (fixed ? 0x1p-12 : 0.0);
}

// The range of an output of the function; it may depend on the settings.
Range range_of(const Function& function, const Configuration& configuration, std::span<const std::uint32_t> inputs,
               std::size_t output) {
  if (function.family == Family::distribution) {
    const std::string_view name = function.outputs[output].name;
    // A slope is largest with the smallest reach, 1/16. The root of a ratio of variances is at most that of 8.
    return {0.0f, name == "slope" ? 64.01f : name == "reach" ? 8.5f : 1.0f};
  }
  if (function.is_gullies()) {
    const auto largest = static_cast<float>(largest_of_gullies(function, configuration, inputs, output));
    return {-largest, largest};
  }
  if (function.bound == "perlin_worley") return {0.0f, 1.0f};
  if (function.is_octave_sum() && function.is_slope(output)) {
    const auto slope = static_cast<float>(largest_slope_of(function, configuration, inputs));
    return {-slope, slope};
  }
  if (function.takes_amplitude()) {
    const auto amplitude = static_cast<float>(std::clamp(number_of(function, inputs, "amplitude"), 0.0, 64.0));
    return {-amplitude, amplitude};
  }
  const auto largest = static_cast<float>(largest_of(function, configuration, output) *
                                          (function.is_sum_of_flows() ? largest_rotated(function.axes) : 1.0));
  if (function.is_flow()) return {-largest, largest};
  const bool distance = function.is_cellular() && !function.is_slope(output) && function.bound != "cellular_smooth";
  if (distance) return {0.0f, largest};
  if (!function.is_octave_sum()) return {function.is_never_negative ? 0.0f : -largest, largest};
  const OctaveSumFacts& sum = facts_of(octave_sum_of(function));
  if (sum.bounded) return {static_cast<float>(sum.least), static_cast<float>(sum.greatest)};
  return {sum.least < 0.0 ? -largest : 0.0f, largest};
}

// Requires that a value is inside its range, and names the range otherwise.
void require_inside(Comparison& comparison, std::span<const std::uint32_t> inputs, float value, const Range& range) {
  const bool inside = value >= range.low && value <= range.high;  // no NaN is
  comparison.require(inside, inputs, value, inside ? "" : fmt::format("a value in [{}, {}]", range.low, range.high));
}

double mean_of(const Words& words) {
  double sum = 0.0;
  for (std::size_t i = 0; i < words.size(); i += kOutputWords) {
    sum += number_of(words[i]);
  }
  return sum * kOutputWords / static_cast<double>(words.size());
}

// The correlation of two columns of values.
double correlation(const Words& first, const Words& second) {
  const double mean_of_first = mean_of(first);
  const double mean_of_second = mean_of(second);
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < first.size(); i += kOutputWords) {
    const double a = number_of(first[i]) - mean_of_first;
    const double b = number_of(second[i]) - mean_of_second;
    products += a * b;
    squares += (a * a + b * b) / 2.0;
  }
  return squares > 0.0 ? products / squares : 1.0;
}

// For n pairs of independent noise values the correlation has a standard deviation of a little more than 1/sqrt(n),
// since the variance of the noise depends on the place in the cell: about 1.1/sqrt(n). By chance 6/sqrt(n) is exceeded
// once in ten million comparisons.
void require_uncorrelated(Comparison& comparison, const Words& inputs, const Words& first, const Words& second,
                          std::string_view what) {
  const double limit = 6.0 / std::sqrt(static_cast<double>(first.size() / kOutputWords));
  const double value = correlation(first, second);
  comparison.require(std::fabs(value) < limit, point(inputs, 0), static_cast<float>(value),
                     fmt::format("a correlation below {:.3g} between {}", limit, what));
}

// The values of a field at points for correlations. Distances are larger in the middle of a cell than elsewhere,
// whatever the seed: so what counts of them is the difference of two fields, whose seeds are those of the points and
// others.
tl::expected<Words, Outcome> balanced(Session& session, const Evaluation& evaluation, const Words& inputs) {
  auto values = evaluate(session, evaluation, inputs);
  if (!values || !evaluation.function.is_cellular()) return values;
  Words others = inputs;
  const auto seed = static_cast<std::size_t>(evaluation.function.seed_word());
  for (std::size_t i = seed; i < others.size(); i += kInputWords) others[i] = others[i] * 747796405u + 2891336453u;
  const auto subtracted = evaluate(session, evaluation, others);
  if (!subtracted) return subtracted;
  for (std::size_t i = 0; i < values->size(); i += kOutputWords) {
    (*values)[i] =
        std::bit_cast<std::uint32_t>(std::bit_cast<float>((*values)[i]) - std::bit_cast<float>((*subtracted)[i]));
  }
  return values;
}

// Points for correlations, anywhere within 512 cells of the origin in all quadrants: seldom on a lattice line, where
// the noise is 0 whatever the hash, and seldom two in one cell. Each has a seed of its own.
Words scattered_points(Session& session, const Function& function, std::string_view name) {
  Random random(session.seed, name);
  const std::size_t points = function.is_costly() ? kCorrelationPoints / 4 : kCorrelationPoints;
  Words inputs = random_points(function, std::min(points, session.most_points), random);
  const auto axes = static_cast<std::size_t>(function.axes);
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    for (std::size_t axis = i; axis < i + axes; ++axis) {
      inputs[axis] = std::bit_cast<std::uint32_t>(random.uniform(-512.0f, 512.0f));
    }
  }
  return inputs;
}

// Whether a point of a noise lies on no cell's inside along any axis, as its coordinates are too large for a fraction.
bool is_far_from_fractions(const Function& function, std::span<const std::uint32_t> inputs) {
  if (!function.is_gradient_noise() || function.starts_from_integers()) return false;
  const auto coordinates = inputs.first(static_cast<std::size_t>(function.axes));
  return std::all_of(coordinates.begin(), coordinates.end(),
                     [](std::uint32_t word) { return std::fabs(std::bit_cast<float>(word)) >= 8388608.0f; });
}

// At every fourth point half of the floats become a NaN, an infinity, or more than floats of many octaves can hold, and
// now and then an int of octaves is absurd. A phase stays: only it has no value for what is no number.
Words with_absurd_numbers(const Function& function, Words inputs, Random random) {
  constexpr std::uint32_t kNumbers[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x447A0000u, 0x7149F2CAu};  // 1000, 1e30
  constexpr std::uint32_t kOctaves[] = {33u, 128u, 0x7FFFFFFFu};
  for (std::size_t i = 0; i < inputs.size(); i += 4 * kInputWords) {
    for (std::size_t word = 0; word < function.inputs.size(); ++word) {
      const Column& column = function.inputs[word];
      const bool is_number = column.type == WordType::f32 && column.name != "phase";
      if (is_number && random.below(2) == 0) inputs[i + word] = kNumbers[random.below(std::size(kNumbers))];
      if (column.name == "octaves" && random.below(32) == 0) inputs[i + word] = kOctaves[random.below(3)];
    }
  }
  return inputs;
}

// Whether a point has one: GLSL leaves its result open.
bool has_nan(const Function& function, std::span<const std::uint32_t> inputs) {
  for (std::size_t word = 0; word < function.inputs.size(); ++word) {
    const bool is_float = function.inputs[word].type == WordType::f32;
    if (is_float && std::isnan(std::bit_cast<float>(inputs[word]))) return true;
  }
  return false;
}

// The inputs that count as equal with `fixed`: the least float for a NaN, and the nearest one for an infinity.
Words with_ends(const Function& function, Words inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::size_t word = i % kInputWords;
    if (word >= function.inputs.size() || function.inputs[word].type != WordType::f32) continue;
    const float number = std::bit_cast<float>(inputs[i]);
    if (!std::isfinite(number)) inputs[i] = number > 0.0f ? 0x7F7FFFFFu : 0xFF7FFFFFu;
  }
  return inputs;
}

}  // namespace

namespace {

// Moves whole coordinates to a lattice point of simplex noise that is no corner of a cell, if floats hold it: on the
// plane by halves, and by a quarter along x in odd rows; else to the centre of the cell.
void move_to_inner_point(const Function& function, std::span<std::uint32_t> coordinates, Random& random) {
  const bool plane = function.axes == 2;
  const bool odd_row = random.below(2) == 0;
  const float along_x = (random.below(2) == 0 ? 0.0f : 0.5f) + (odd_row ? 0.25f : 0.0f);
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
    const float inner = !plane ? 0.5f : axis == 0 ? along_x : odd_row ? 0.5f : 0.0f;
    const float whole = std::bit_cast<float>(coordinates[axis]);
    if (std::fabs(whole) >= 2097152.0f) return;  // its fractions are quarters at the best
    coordinates[axis] = std::bit_cast<std::uint32_t>(whole + inner);
  }
}

}  // namespace

// Noise is 0 at lattice points, near and far.
Judged check_zero(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  Random random(session.seed, "zero");
  Words inputs = random_points(function, property_points(session, function), random);
  const auto axes = static_cast<std::size_t>(function.axes);
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    for (std::size_t axis = i; axis < i + axes; ++axis) {
      inputs[axis] = std::bit_cast<std::uint32_t>(std::floor(std::bit_cast<float>(inputs[axis])));
    }
    const bool inner = function.is_simplex_noise() && random.below(2) == 0;
    if (inner) move_to_inner_point(function, std::span(inputs).subspan(i, axes), random);
  }
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
    comparison.number(point(inputs, i), std::bit_cast<float>(result(outputs, i)[0]), 0.0, 0.0);
  }
  return comparison.finish();
}

// A million distances reach little more than this: the nearest point is far only if all around are, so the ends
// of the range are rare.
float cellular_used_of(const Function& function) {
  const bool plane = function.axes == 2;
  if (function.bound == "cell_border") return 0.45f;
  return plane ? 0.7f : 0.8f;
}

// A good part of the range: with a gradient that had lost a third of its length, no value would be beyond 0.67, and of
// these few points none beyond 0.6. The more lattice points are joined, the rarer are values near the ends.
float used_of(const Function& function) {
  if (function.is_cellular()) return cellular_used_of(function);
  if (!function.is_noise() || function.is_slope(0)) return 0.0f;
  const bool many = function.axes == 4 || (function.bound == "value_cubic" && function.axes == 3);
  return many ? 0.4f : 0.6f;
}

// Values keep to their range; and, for noise, a good part of it is used.
Judged check_range(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const Words inputs = random_points(function, property_points(session, function), Random(session.seed, "range"));
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  Comparison comparison(function, inputs);
  for (std::size_t word = 0; word < function.outputs.size(); ++word) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
      const float value = std::bit_cast<float>(result(outputs, i)[word]);
      largest = std::max(largest, std::fabs(value));
      require_inside(comparison, point(inputs, i), value,
                     range_of(function, evaluation.configuration, point(inputs, i), word));
    }
    if (word != 0) continue;
    const float used = used_of(function);
    comparison.require(used == 0.0f || largest > used, point(inputs, 0), largest,
                       fmt::format("a largest value of more than {}", used));
  }
  return comparison.finish();
}

// Wherever a float can point, values are numbers, keep to their range, and are 0 where no axis has a fraction: from
// 2^23 on. So do those of fixed arithmetic, and those of octave sums, for NaN.
Judged check_finite(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const bool fixed = evaluation.configuration.arithmetic == Arithmetic::fixed;
  const Words inputs = random_points(function, property_points(session, function), Random(session.seed, "finite"),
                                     fixed ? Extremes::integers : Extremes::floats);
  HN_TRY(const auto outputs, evaluate(session, evaluation, inputs));
  Comparison comparison(function, inputs);
  for (std::size_t word = 0; word < function.outputs.size(); ++word) {
    for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
      const auto in = point(inputs, i);
      const bool zero = !function.is_slope(word) && is_far_from_fractions(function, in);
      const float value = std::bit_cast<float>(result(outputs, i)[word]);
      const Range range = range_of(function, evaluation.configuration, in, word);
      require_inside(comparison, in, value, zero ? Range{0.0f, 0.0f} : range);
    }
  }
  if (!fixed && !function.is_octave_sum()) return comparison.finish();
  const Words absurd = with_absurd_numbers(function, inputs, Random(session.seed, "absurd"));
  const Words ends = with_ends(function, absurd);
  HN_TRY(const auto values, evaluate(session, evaluation, absurd));
  HN_TRY(const auto expected, fixed ? evaluate(session, evaluation, ends) : values);
  comparison.next_grid(absurd);
  for (std::size_t i = 0; i < absurd.size() / kInputWords; ++i) {
    for (std::size_t word = 0; word < function.outputs.size(); ++word) {
      const auto in = point(absurd, i);
      const float value = std::bit_cast<float>(result(values, i)[word]);
      if (!has_nan(function, in)) comparison.bits(in, result(values, i)[word], result(expected, i)[word], word);
      if ((function.is_slope(word) || function.is_gullies()) && !fixed) {
        comparison.require(std::isfinite(value), in, value, "a number");
      } else {
        require_inside(comparison, in, value, range_of(function, evaluation.configuration, point(ends, i), word));
      }
    }
  }
  return comparison.finish();
}

// Fields of different seeds are uncorrelated: pairs of neighbouring seeds, of seeds that differ in the highest bit, and
// of the seed of the next octave.
Judged check_seeds(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  constexpr std::uint32_t kOffsets[] = {1u, 0x80000000u, 0x9E3779B9u};
  const auto seed = static_cast<std::size_t>(function.seed_word());
  const Words inputs = scattered_points(session, function, "seeds");
  HN_TRY(const auto first, balanced(session, evaluation, inputs));
  Comparison comparison(function, inputs);
  for (const std::uint32_t offset : kOffsets) {
    Words others = inputs;
    for (std::size_t i = seed; i < others.size(); i += kInputWords) others[i] += offset;
    HN_TRY(const auto second, balanced(session, evaluation, others));
    require_uncorrelated(comparison, inputs, first, second, fmt::format("seeds {:#x} apart", offset));
  }
  return comparison.finish();
}

// No quadrant mirrors another: points are compared with their reflections in every set of axes, and with their
// coordinates in another order.
Judged check_mirror(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const Words inputs = scattered_points(session, function, "mirror");
  HN_TRY(const auto first, balanced(session, evaluation, inputs));
  const auto axes = static_cast<std::size_t>(function.axes);
  Comparison comparison(function, inputs);
  for (std::size_t reflected = 0; reflected < (std::size_t{1} << axes); ++reflected) {
    for (std::size_t rotated = 0; rotated < axes; ++rotated) {
      if (reflected == 0 && rotated == 0) continue;
      Words others = inputs;
      for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
        for (std::size_t axis = 0; axis < axes; ++axis) {
          const std::uint32_t sign = (reflected >> axis) & 1 ? 0x80000000u : 0u;
          others[i + axis] = inputs[i + (axis + rotated) % axes] ^ sign;
        }
      }
      HN_TRY(const auto second, balanced(session, evaluation, others));
      require_uncorrelated(
          comparison, inputs, first, second,
          fmt::format("points and their images (reflected axes {:#b}, rotated by {})", reflected, rotated));
    }
  }
  return comparison.finish();
}

}  // namespace hn
