// Metamorphic checks: the driver must come to the same values on another way, within twice the tolerance, since it may
// be off on both. What the values are, other checks tell.
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "points.hpp"
#include "tolerance.hpp"
#include "value_checks.hpp"

namespace hn {
namespace {

constexpr std::size_t kPoints = std::size_t{1} << 12;
// A shader with the noise in it so often takes long to compile.
constexpr std::size_t kConstantPoints = 4;

double allowed_between_two(const Evaluation& evaluation, std::span<const std::uint32_t> inputs) {
  return 2.0 * tolerance(evaluation.function, evaluation.configuration, inputs);
}

// The same, evaluated as most cases do, so that its program need not be built for this.
Evaluation plain(const Evaluation& evaluation) {
  return {evaluation.function, evaluation.configuration, profile_named(evaluation.profile.es ? "es300" : "gl330")};
}

Words points_for(Session& session, const Evaluation& evaluation, std::size_t count) {
  const Function& function = evaluation.function;
  Words inputs = random_points(function, count, Random(session.seed, "metamorphic"));
  if (evaluation.variant.seed_from != SeedFrom::point) {
    const auto seed = static_cast<std::size_t>(function.seed_word());
    for (std::size_t i = seed; i < inputs.size(); i += kInputWords) inputs[i] = kVariantSeed;
  }
  return inputs;
}

Outcome compare_on(Session& session, const Evaluation& evaluation, const Words& inputs) {
  const auto expected = evaluate(session, plain(evaluation), inputs);
  if (!expected) return expected.error();
  const auto got = evaluate(session, evaluation, inputs);
  if (!got) return got.error();
  Comparison comparison(evaluation.function, inputs);
  for (std::size_t i = 0; i * kInputWords < inputs.size(); ++i) {
    const auto in = point(inputs, i);
    compare_with_twin(comparison, evaluation.function, in, result(*got, i), result(*expected, i),
                      allowed_between_two(evaluation, in));
  }
  return comparison.finish();
}

// A variant of the shader, or another stage, against the plain fragment shader.
Outcome check_variant(Session& session, const Evaluation& evaluation) {
  return compare_on(session, evaluation, points_for(session, evaluation, kPoints));
}

// Points that are constants in the shader's text, so that the compiler may evaluate the function itself.
Outcome check_folded(Session& session, const Evaluation& evaluation) {
  const Words inputs = points_for(session, evaluation, kConstantPoints);
  Evaluation folded = evaluation;
  folded.variant.shape = Shape::constant;
  folded.variant.constants = inputs;
  return compare_on(session, folded, inputs);
}

// Each trip of the loop leaves a word, of the point at hand and of its neighbours.
Outcome check_in_loop(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const Words inputs = points_for(session, evaluation, kPoints);
  const auto expected = evaluate(session, plain(evaluation), inputs);
  if (!expected) return expected.error();
  const auto got = evaluate(session, evaluation, inputs);
  if (!got) return got.error();
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < kPoints; ++i) {
    for (std::size_t trip = 0; trip < kLoopTrips; ++trip) {
      const auto in = point(inputs, i ^ trip);
      const auto words = result(*expected, i ^ trip);
      // As in the shader: exact functions may have several words, and those that a function has not are 0.
      const std::array<std::uint32_t, 1> word = {words[0] ^ words[1] ^ words[2] ^ words[3]};
      const std::uint32_t left = result(*got, i)[trip];
      if (function.exact()) {
        comparison.bits(in, left, word[0]);
      } else {
        comparison.number(in, std::bit_cast<float>(left), static_cast<double>(std::bit_cast<float>(word[0])),
                          allowed_between_two(evaluation, in));
      }
    }
  }
  return comparison.finish();
}

// --- Period ----------------------------------------------------------------------------------------------------------

// The columns of coordinates come first, as many as there are axes; those of a cell's fraction keep their values.
std::size_t axes_of(const Function& function) { return function.id.find('3') == std::string_view::npos ? 2 : 3; }

struct Pair {
  std::uint32_t here;
  std::uint32_t there;  // some periods on
};

Pair coordinates(WordType type, std::uint32_t period, Random& random) {
  const auto periods = static_cast<std::int32_t>(random.below(3)) - 1;
  if (type == WordType::i32) {
    const auto cell = static_cast<std::int32_t>(random.below(1u << 30)) - (1 << 29);
    // Far apart, since an int has room for it.
    const std::int32_t step = static_cast<std::int32_t>(period) * 64;
    return {static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(cell + periods * step)};
  }
  // Multiples of 1/8, so that both positions are floats, and with a whole lacunarity those of all octaves: below
  // 9 * 48 * 3^4 in units of 1/32.
  const auto cells = static_cast<float>(period);
  const float p = std::floor(random.uniform(-8.0f * cells, 8.0f * cells)) / 8.0f;
  return {std::bit_cast<std::uint32_t>(p), std::bit_cast<std::uint32_t>(p + static_cast<float>(periods) * cells)};
}

// Points a whole number of periods apart along each axis, opposite corners of it among them. A noise has the same bits
// there: its cells and its fractions are the same. So does an octave sum if no position is rounded; it is held to its
// tolerance.
Outcome check_period(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  const bool octave_sum = function.input("octaves") >= 0;
  Random random(session.seed, "period");
  Words inputs = random_points(function, kPoints, random);
  Words others = inputs;
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    if (octave_sum) {
      const auto lacunarity = i + static_cast<std::size_t>(function.input("lacunarity"));
      inputs[lacunarity] = others[lacunarity] =
          std::bit_cast<std::uint32_t>(1.0f + static_cast<float>(random.below(3)));
    }
    for (std::size_t axis = 0; axis < axes_of(function); ++axis) {
      const Pair pair = coordinates(function.inputs[axis].type, evaluation.configuration.period(), random);
      inputs[i + axis] = pair.here;
      others[i + axis] = pair.there;
    }
  }
  const auto here = evaluate(session, evaluation, inputs);
  if (!here) return here.error();
  const auto there = evaluate(session, evaluation, others);
  if (!there) return there.error();
  Comparison comparison(function, others);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double allowed = tolerance(function, evaluation.configuration, point(inputs, i)) +
                           tolerance(function, evaluation.configuration, point(others, i));
    for (std::size_t word = 0; word < function.outputs.size(); ++word) {
      const std::uint32_t got = result(*there, i)[word];
      const std::uint32_t expected = result(*here, i)[word];
      if (octave_sum) {
        comparison.number(point(others, i), std::bit_cast<float>(got),
                          static_cast<double>(std::bit_cast<float>(expected)), allowed);
      } else {
        comparison.bits(point(others, i), got, expected);
      }
    }
  }
  return comparison.finish();
}

// ---------------------------------------------------------------------------------------------------------------------

bool is_noise(const Function& function) { return !function.exact() && function.accuracy != Accuracy::sine; }

// Every noise, and of the exact functions a hash and a gradient. Each variant is a shader more to compile, and goes the
// same ways with every hash.
bool has_variants(const Function& function, const Configuration& configuration) {
  if (!configuration.is_default()) return false;
  return is_noise(function) || function.id == "hash.lattice3" || function.id == "gradient.lattice3";
}

// These, and perlin with every hash: the other stages have the shaders anyway, for the golden files.
bool has_stages(const Function& function, const Configuration& configuration) {
  return has_variants(function, configuration) || (function.id.ends_with(".perlin") && configuration.hash_only());
}

// Of octave sums, whose code does not depend on the period, with one that is no power of two. (Over 2^20 cells their
// positions would have no fraction left.)
bool has_period(const Function& function, const Configuration& configuration) {
  if (configuration.period() == 0) return false;
  if (function.input("octaves") >= 0) return configuration.name == "lattice+period48";
  return covers(configuration, function);
}

void add_variants(std::vector<Case>& cases, const Function& function, const Configuration& configuration,
                  const Profile& profile) {
  const auto add = [&](const ShaderVariant& variant, std::string_view name, Check* check) {
    add_case(cases, {function, configuration, profile, variant}, name, check);
  };
  add({.shape = Shape::inlined}, "inlined", check_variant);
  add({.shape = Shape::in_loop}, "in_loop", check_in_loop);
  add({.seed_from = SeedFrom::constant}, "constant_seed", check_variant);
  add({.seed_from = SeedFrom::uniform}, "uniform_seed", check_variant);
  add({}, "folded", check_folded);
}

}  // namespace

void add_metamorphic_cases(std::vector<Case>& cases, const Function& function, const Configuration& configuration) {
  for (const std::string_view name : {"gl330", "es300"}) {
    const Profile& profile = profile_named(name);
    if (has_variants(function, configuration)) add_variants(cases, function, configuration, profile);
    if (has_period(function, configuration)) {
      add_case(cases, {function, configuration, profile}, "period", check_period);
    }
  }
  if (!has_stages(function, configuration)) return;
  for (const auto& [stage, profile] : kOtherStages) {
    add_case(cases, {function, configuration, profile_named(profile), {}, stage}, "as_fragment", check_variant);
  }
}

}  // namespace hn
