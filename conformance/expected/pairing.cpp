#include "expected/pairing.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "expected/points.hpp"
#include "expected/tolerance.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

// A shader with the noise in it so often takes long to compile.
constexpr std::size_t kConstantPoints = 4;

// The same, evaluated as most cases do, so that its program need not be built for this.
Evaluation plain(const Evaluation& evaluation) {
  return {evaluation.function, evaluation.configuration, main_profile(evaluation.configuration, evaluation.profile.es)};
}

Words points_for(const Evaluation& evaluation, std::uint64_t seed, std::size_t count) {
  const Function& function = evaluation.function;
  Words inputs = random_points(function, count, Random(seed, "metamorphic"));
  if (evaluation.variant.seed_from != SeedFrom::point) {
    const auto word = static_cast<std::size_t>(function.seed_word());
    for (std::size_t i = word; i < inputs.size(); i += kInputWords) inputs[i] = kVariantSeed;
  }
  return inputs;
}

// The driver may be off on both ways.
std::vector<double> allowed_between(const Evaluation& evaluation, const Words& inputs, const Words& others) {
  const auto allowed_at = [&](const Words& words, std::size_t start) {
    return tolerance(evaluation.function, evaluation.configuration, std::span(words).subspan(start, kInputWords));
  };
  std::vector<double> allowed;
  for (std::size_t i = 0; i < inputs.size(); i += kInputWords) {
    allowed.push_back(allowed_at(inputs, i) + allowed_at(others, i));
  }
  return allowed;
}

Pairing pairing_on(const Evaluation& evaluation, Words inputs) {
  std::vector<double> allowed = allowed_between(evaluation, inputs, inputs);
  return {evaluation, plain(evaluation),  inputs,
          inputs,     std::move(allowed), has_same_bits(evaluation.function, evaluation.configuration)};
}

struct Pair {
  std::uint32_t here;
  std::uint32_t there;  // some periods on
};

// As many octaves as keep the cells of fixed arithmetic within an int, below 9 * 48 * 3^14 and a little more for the
// shift between octaves (docs/contract.md, section 8).
constexpr std::uint32_t kFixedOctaves = 15;

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

}  // namespace

Pairing variant_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  return pairing_on(evaluation, points_for(evaluation, seed, points));
}

Pairing folded_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  Pairing pairing = pairing_on(evaluation, points_for(evaluation, seed, std::min(points, kConstantPoints)));
  pairing.evaluation.variant.shape = Shape::constant;
  pairing.evaluation.variant.constants = pairing.inputs;
  return pairing;
}

// Opposite corners of the period are among the points. A noise has the same bits there: its cells and its fractions are
// the same. So does an octave sum, as none of its positions is rounded; but a compiler of fast arithmetic may round the
// steps to them in another way, so there it is held to its tolerance.
Pairing period_pairing(const Evaluation& evaluation, std::uint64_t seed, std::size_t points) {
  const Function& function = evaluation.function;
  const bool octave_sum = function.is_octave_sum();
  Random random(seed, "period");
  Words here = random_points(function, points, random);
  Words there = here;
  for (std::size_t i = 0; i < here.size(); i += kInputWords) {
    const std::size_t octaves = i + static_cast<std::size_t>(std::max(function.input("octaves"), 0));
    if (octave_sum && evaluation.configuration.arithmetic == Arithmetic::fixed) {
      here[octaves] = there[octaves] = random.below(kFixedOctaves + 1);
    }
    if (octave_sum) {
      const auto lacunarity = i + static_cast<std::size_t>(function.input("lacunarity"));
      here[lacunarity] = there[lacunarity] = std::bit_cast<std::uint32_t>(1.0f + static_cast<float>(random.below(3)));
    }
    // The columns of coordinates come first; those of a cell's fraction keep their values.
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(function.axes); ++axis) {
      const Pair pair = coordinates(function.inputs[axis].type, evaluation.configuration.period, random);
      here[i + axis] = pair.here;
      there[i + axis] = pair.there;
    }
  }
  std::vector<double> allowed = allowed_between(evaluation, there, here);
  return {evaluation,      evaluation,         std::move(there),
          std::move(here), std::move(allowed), !octave_sum || has_same_bits(function, evaluation.configuration)};
}

}  // namespace hn
